//! What recording costs: the same pixels traced with each recorder, interleaved; medians, as ratios to no recorder at
//! all.
//!
//! `cargo bench --bench recording`

mod twin;

use std::hint::black_box;
use std::time::Instant;

use raytree::transport::{Options, Tracer};
use raytree::tree::{Cost, Keep, Origin, record_pixel};

const ROUNDS: usize = 31;

fn main() {
    println!("{:<18} {:>6} {:>22} {:>22} {:>22} {:>22}", "scene", "twin", "off", "counting", "tree", "tree and steps");
    for name in ["first-hit", "whitted", "hall-of-mirrors", "nested-media", "mesh"] {
        let loaded = raytree::scene::load_file(&format!("scenes/{name}.json")).expect("a committed scene");
        let tracer = Tracer::<f64>::new(&loaded.scene, Options::of(&loaded.scene)).expect("a committed scene");
        let image = loaded.scene.image;
        // A lattice of pixels over the whole image.
        let pixels: Vec<[u32; 2]> =
            (0..image.height).step_by(12).flat_map(|y| (0..image.width).step_by(12).map(move |x| [x, y])).collect();
        let keep = |keep, x, y| {
            black_box(record_pixel(&tracer, Origin { loaded: &loaded, keep }, x, y));
        };
        let ways: [&dyn Fn(u32, u32); 5] = [
            &|x, y| _ = black_box(twin::pixel(&tracer, x, y)),
            &|x, y| _ = black_box(tracer.pixel_color(x, y)),
            &|x, y| _ = black_box(tracer.pixel(x, y, &Cost)),
            &|x, y| keep(Keep::Outcomes, x, y),
            &|x, y| keep(Keep::Steps, x, y),
        ];
        let mut ratios: [Vec<f64>; 5] = Default::default();
        for _ in 0..ROUNDS {
            let seconds = ways.map(|way| {
                let start = Instant::now();
                pixels.iter().for_each(|&[x, y]| way(x, y));
                start.elapsed().as_secs_f64()
            });
            for (ratios, time) in ratios.iter_mut().zip(seconds) {
                ratios.push(time / seconds[0]);
            }
        }
        let shown = ratios.map(|mut r| {
            r.sort_by(f64::total_cmp);
            format!("{:.2} ({:.2} to {:.2})", r[ROUNDS / 2], r[ROUNDS / 4], r[3 * ROUNDS / 4])
        });
        let [_, off, count, tree, steps] = shown;
        println!("{name:<18} {:>6} {off:>22} {count:>22} {tree:>22} {steps:>22}", "1");
    }
    println!("\ntime as a multiple of the twin's, median of {ROUNDS} interleaved rounds (quartiles)");
}
