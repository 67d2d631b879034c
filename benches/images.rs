//! What a proven picture costs: whole scenes under certified numerics against robust ones, interleaved; medians of
//! ratios.
//!
//! `--numerics robust` is the usual f64 tracer: Möller and Trumbore's triangles, the stable quadratic, slabs with an
//! explicit zero; scene, hierarchy and everything else are the same.
//!
//! `cargo bench --bench images` renders all scenes of the list, `cargo bench --bench images -- glass` those with that in
//! their names. One thread.

use std::hint::black_box;
use std::time::Instant;

use raytree::scene::Numerics;
use raytree::transport::{Options, Tracer};

const ROUNDS: usize = 31;

/// Meshes, then spheres and boxes, then glass.
const SCENES: [&str; 16] = [
    "mesh",
    "smooth-mesh",
    "gem",
    "triangle",
    "box",
    "checker",
    "plane",
    "sphere",
    "first-hit",
    "hall-of-mirrors",
    "whitted",
    "shadows-of-several-lights",
    "glass-ball",
    "nested-media",
    "camera-in-glass",
    "touching-glass",
];

fn main() {
    println!("{:<28} {:>8} {:>28}", "scene", "pixels", "certified / robust (quartiles)");
    for name in SCENES {
        if std::env::args().skip(1).any(|arg| !arg.starts_with('-') && !name.contains(&arg)) {
            continue;
        }
        let scene = raytree::scene::load_file(&format!("scenes/{name}.json")).expect("a committed scene").scene;
        let tracer = |numerics| {
            Tracer::<f64>::new(&scene, Options { numerics, ..Options::of(&scene) }).expect("a committed scene")
        };
        let (robust, certified) = (tracer(Numerics::Robust), tracer(Numerics::Certified));
        // A lattice of pixels over the whole picture.
        let pixels: Vec<[u32; 2]> = (0..scene.image.height)
            .step_by(4)
            .flat_map(|y| (0..scene.image.width).step_by(4).map(move |x| [x, y]))
            .collect();
        let seconds = |tracer: &Tracer<f64>| {
            let start = Instant::now();
            for &[x, y] in &pixels {
                black_box(tracer.pixel_color(x, y));
            }
            start.elapsed().as_secs_f64()
        };
        let mut ratios: Vec<f64> = (0..ROUNDS).map(|_| seconds(&certified) / seconds(&robust)).collect();
        ratios.sort_by(f64::total_cmp);
        let [low, middle, high] = [1, 2, 3].map(|quarter| ratios[quarter * ROUNDS / 4]);
        println!("{name:<28} {:>8} {:>28}", pixels.len(), format!("{middle:.2} ({low:.2} to {high:.2})"));
    }
    println!("\nmedian of {ROUNDS} interleaved rounds, one thread");
}
