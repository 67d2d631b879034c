//! How long diagrams and pages take beside the render: made, and written as PNG as the commands do; medians and the slowest.
//!
//! `cargo bench --bench diagrams`

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use raytree::numbers::Precision;
use raytree::pictures::diagrams::{Input, Kind, diagram};
use raytree::pictures::sheet::sheet;
use raytree::pictures::theme::Theme;
use raytree::pictures::{Film, render};
use raytree::scene::Loaded;
use raytree::transport::{Options, Tracer};
use raytree::tree::{Keep, NodePath, Origin, RayTree, record_pixel};

const SCENES: [&str; 8] = [
    "whitted",
    "hall-of-mirrors",
    "nested-media",
    "gem",
    "mesh",
    "glass-ball",
    "hard/mirrored-cube",
    "hard/giant-ground-sphere",
];
/// The pixels of a PNG for each unit: what the commands take unless told otherwise.
const SCALE: f64 = 1.5;

fn main() {
    println!("milliseconds: median (slowest)\n");
    println!("{:<26} {:>14} {:>14} {:>14}", "", "made", "as PNG", "as SVG");
    let mut drawings: Vec<(String, [Vec<f64>; 3])> = Vec::new();
    for name in SCENES {
        let loaded = raytree::scene::load_file(&format!("scenes/{name}.json")).expect("a committed scene");
        let (film, trees) = trace(&loaded);
        for tree in &trees {
            let input = Input::new(&loaded.scene, tree, NodePath::ROOT).expect("every tree has a root");
            for kind in Kind::ALL {
                if diagram(kind, &input, &Theme::LIGHT).is_ok() {
                    measure(&mut drawings, kind.name(), || {
                        diagram(kind, &input, &Theme::LIGHT).expect("it applied before")
                    });
                }
            }
            measure(&mut drawings, "sheet", || sheet(&input, &film, &Theme::LIGHT));
        }
    }
    for (name, times) in drawings {
        let shown = times.map(|mut times| {
            times.sort_by(f64::total_cmp);
            format!("{:.1} ({:.1})", times[times.len() / 2], times[times.len() - 1])
        });
        println!("{name:<26} {:>14} {:>14} {:>14}", shown[0], shown[1], shown[2]);
    }
}

/// The picture and the trees of the named pixels.
fn trace(loaded: &Loaded) -> (Film, Vec<RayTree>) {
    let options = Options::of(&loaded.scene);
    let pixels = loaded.scene.pixels.iter().map(|(_, [x, y])| (*x, *y));
    let origin = Origin { loaded, keep: Keep::Steps };
    let stop = AtomicBool::new(false);
    let (film, trees) = match loaded.scene.precision {
        Some(Precision::F32) => {
            let tracer = Tracer::<f32>::new(&loaded.scene, options).expect("a committed scene");
            (render(&tracer, &|| (), &stop), pixels.map(|(x, y)| record_pixel(&tracer, origin, x, y)).collect())
        }
        _ => {
            let tracer = Tracer::<f64>::new(&loaded.scene, options).expect("a committed scene");
            (render(&tracer, &|| (), &stop), pixels.map(|(x, y)| record_pixel(&tracer, origin, x, y)).collect())
        }
    };
    (film.expect("nobody stops it"), trees)
}

/// Adds the times of a drawing to those of its name.
fn measure(all: &mut Vec<(String, [Vec<f64>; 3])>, name: &str, make: impl Fn() -> raytree::pictures::drawing::Drawing) {
    let place = all.iter().position(|(known, _)| known == name).unwrap_or_else(|| {
        all.push((name.to_owned(), Default::default()));
        all.len() - 1
    });
    let milliseconds = |start: Instant| 1e3 * start.elapsed().as_secs_f64();
    let start = Instant::now();
    let drawing = make();
    all[place].1[0].push(milliseconds(start));
    let start = Instant::now();
    drawing.to_png(SCALE).expect("every diagram has a picture");
    all[place].1[1].push(milliseconds(start));
    let start = Instant::now();
    drawing.to_svg().expect("every diagram has a picture");
    all[place].1[2].push(milliseconds(start));
}
