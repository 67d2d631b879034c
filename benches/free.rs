//! Recording is free when it is off: instructions of `trace` and `shade` under the recorder `Off`, against their twin
//! without any.
//!
//! `cargo bench --bench free` runs this program under `valgrind --tool=callgrind` three times a scene: setting up
//! alone, with the recorder, with the twin. Counts are exact and the same on every run of the same binary.

mod twin;

use std::hint::black_box;
use std::process::{Command, ExitCode};

use raytree::transport::{Options, Tracer};

const SCENES: [&str; 5] = ["first-hit", "whitted", "hall-of-mirrors", "nested-media", "mesh"];

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().collect();
    if let [_, what, scene] = args.as_slice() {
        inner(what, scene);
        return ExitCode::SUCCESS;
    }
    println!("{:<18} {:>16} {:>16} {:>9}", "scene", "twin", "recorder off", "ratio");
    let mut worst = 0.0_f64;
    for scene in SCENES {
        let counts: Option<Vec<u64>> = ["setup", "twin", "off"].iter().map(|what| instructions(what, scene)).collect();
        let Some([setup, twin, off]) = counts.as_deref() else {
            eprintln!("valgrind could not be run; it counts the instructions");
            return ExitCode::FAILURE;
        };
        let (twin, off) = (twin - setup, off - setup);
        let ratio = off as f64 / twin as f64;
        worst = worst.max(ratio);
        println!("{scene:<18} {twin:>16} {off:>16} {ratio:>9.4}");
    }
    println!("\nworst {worst:.4}; at most 1.01 is allowed");
    if worst <= 1.01 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// What is counted.
fn inner(what: &str, scene: &str) {
    let loaded = raytree::scene::load_file(&format!("scenes/{scene}.json")).expect("a committed scene");
    let tracer = Tracer::<f64>::new(&loaded.scene, Options::of(&loaded.scene)).expect("a committed scene");
    let image = loaded.scene.image;
    for y in (0..image.height).step_by(16) {
        for x in (0..image.width).step_by(16) {
            match what {
                "twin" => _ = black_box(twin::pixel(&tracer, x, y)),
                "off" => _ = black_box(tracer.pixel_color(x, y)),
                _ => {}
            }
        }
    }
}

/// The instructions that one run takes.
fn instructions(what: &str, scene: &str) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args([what, scene])
        .output()
        .ok()?;
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    let count = told.lines().find_map(|line| line.split_once("Collected :"))?.1.trim();
    count.parse().ok()
}
