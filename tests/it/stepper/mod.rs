//! The steps: complete, replayable to the same bits, with a stack that folds; the player's laws; the command `step`.

mod arithmetic;
mod events;
mod player;
mod reader;
mod session;

use raytree::hits::Acceleration;
use raytree::numbers::Precision;
use raytree::scene::{Loaded, Numerics};
use raytree::steps::Recording;
use raytree::tree::{Keep, RayTree};

use crate::support::{scenes, tracer_with, tree};

/// The recordings of every named pixel of every scene, traced in these ways.
fn for_each_recording_of(ways: &[(Numerics, Precision)], mut check: impl FnMut(&str, &Loaded, &Recording<'_>)) {
    for (name, loaded) in scenes() {
        for (numerics, precision) in ways {
            for (pixel, place) in &loaded.scene.pixels {
                let tree = tree_of(&loaded, *place, *numerics, *precision);
                let what = format!("{name}, {pixel}, {numerics}, {precision}");
                check(&what, &loaded, &Recording::of(&loaded.scene, &tree));
            }
        }
    }
}

/// The recordings of every named pixel of every scene, traced as the scene wants it.
fn for_each_recording(mut check: impl FnMut(&str, &Loaded, &Recording<'_>)) {
    for (name, loaded) in scenes() {
        let numerics = loaded.scene.numerics.unwrap_or_default();
        let precision = loaded.scene.precision.unwrap_or(Precision::F64);
        for (pixel, place) in &loaded.scene.pixels {
            let tree = tree_of(&loaded, *place, numerics, precision);
            check(&format!("{name}, {pixel}"), &loaded, &Recording::of(&loaded.scene, &tree));
        }
    }
}

fn tree_of(loaded: &Loaded, pixel: [u32; 2], numerics: Numerics, precision: Precision) -> RayTree {
    match precision {
        Precision::F32 => {
            tree(&tracer_with::<f32>(&loaded.scene, numerics, Acceleration::Bvh), loaded, pixel, Keep::Steps)
        }
        Precision::F64 => {
            tree(&tracer_with::<f64>(&loaded.scene, numerics, Acceleration::Bvh), loaded, pixel, Keep::Steps)
        }
    }
}
