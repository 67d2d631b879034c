//! The textbook tracer against the real one, and the name of each fault that is planted in it.

use std::collections::BTreeSet;

use raytree::faults::{Fault, Textbook, name_fault, right_tree};
use raytree::scene::Loaded;
use raytree::tree::RayTree;
use raytree::tree::diff::{Tolerances, diff};

use crate::support::{grid, scenes};

/// Pixels of which plain f64 with an epsilon gives another tree than exact verdicts do: why, and in how many of the scene's.
const BEYOND_THE_TEXTBOOK: [(&str, &str); 0] = [];

fn beyond(scene: &str, pixel: &str) -> bool {
    BEYOND_THE_TEXTBOOK.contains(&(scene, pixel))
}

#[test]
fn print_what_disagrees() {
    for (name, loaded) in scenes() {
        for (pixel, [x, y]) in &loaded.scene.pixels {
            let textbook = Textbook::new(&loaded.scene).pixel(*x, *y);
            let right = right_tree(&loaded, &textbook).unwrap();
            let difference = diff(&right, &textbook, &Tolerances::default());
            if !difference.is_same() {
                println!("{name}, {pixel}\n{}", difference.to_text().lines().take(6).collect::<Vec<_>>().join("\n"));
            }
        }
    }
    let mut seen = BTreeSet::new();
    for (name, loaded) in scenes() {
        for (pixel, [x, y]) in &loaded.scene.pixels {
            let right = Textbook::new(&loaded.scene).pixel(*x, *y);
            for fault in Fault::ALL {
                let limits = raytree::scene::Limits { ray_budget: 2000, ..loaded.scene.limits };
                let wrong = Textbook::new(&loaded.scene).with_limits(limits).with(fault).pixel(*x, *y);
                let difference = diff(&right, &wrong, &Tolerances::default());
                let Some(first) = difference.first() else { continue };
                if seen.insert((fault, name.clone())) && seen.iter().filter(|(f, _)| *f == fault).count() <= 4 {
                    let named = name_fault(&loaded, &wrong, &Tolerances::default());
                    let faults = named.map(|named| named.faults);
                    println!("PLANT {fault}: {name}, {pixel}, {}, {}, {faults:?}", first.path, first.field);
                }
            }
        }
    }
    let _ = (grid, beyond);
    let _: Option<(Loaded, RayTree)> = None;
}
