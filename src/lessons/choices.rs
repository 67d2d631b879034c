//! Lesson 13: ways to do the same thing, with what each costs and how wrong it is.

use crate::scene::{Limits, Resolution, Rgb, Scene};
use crate::transport::{Options, Tracer};
use crate::tree::{Cost, Costs};

/// A way to do something.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What it is called.
    pub name: String,
    /// What it costs, less being better.
    pub cost: f64,
    /// How wrong it is, 0 being right.
    pub error: f64,
}

/// What is read off `verdicts.csv`: rows of the subject `triangle` with the precision `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// How many of the verdicts of the form `lecture` on the set `aimed at edges` are wrong: false hits and false misses.
    pub lecture_wrong: usize,
    /// How many times as many that is as those of the form `watertight` on the same set.
    pub lecture_over_watertight: f64,
    /// How many verdicts of `watertight` on the set `random` are wrong.
    pub watertight_random: usize,
    /// How many verdicts of `certified` are wrong on the sets `random`, `aimed at edges` and `aimed at vertices` together.
    pub certified_wrong: usize,
    /// On the set `aimed at vertices`: which share, from 0 to 1, of the verdicts of `certified` the filter alone decides.
    pub filter_share: f64,
}

/// The depths of recursion and the least weights of children that [`depths_and_weights`] tries.
const DEPTHS: std::ops::RangeInclusive<u32> = 0..=6;
const WEIGHTS: [f64; 5] = [0.3, 0.1, 0.03, 0.01, 0.003];

/// A scene in a picture of so many pixels, traced to different depths and with different least weights. The cost is how many
/// rays a pixel took, the error the root mean square distance in linear RGB from the picture at the largest depth with every
/// child traced. `None` where the scene does not fit f64.
pub fn depths_and_weights(scene: &Scene, width: u32, height: u32) -> Option<Vec<Choice>> {
    let scene = Scene { image: Resolution { width, height }, ..scene.clone() };
    let deepest = *DEPTHS.end();
    let traced = |max_depth: u32, min_weight: Option<f64>| -> Option<(Vec<Rgb>, f64)> {
        let limits = Limits { max_depth, min_weight, ..Limits::default() };
        let tracer = Tracer::<f64>::new(&scene, Options { limits, ..Options::of(&scene) }).ok()?;
        let (mut pixels, mut costs) = (Vec::new(), Costs::default());
        for y in 0..height {
            for x in 0..width {
                let (color, cost) = tracer.pixel(x, y, &Cost);
                pixels.push(color);
                costs += cost;
            }
        }
        Some((pixels, costs.rays() as f64 / f64::from(width * height)))
    };
    let (reference, most) = traced(deepest, None)?;
    let error = |pixels: &[Rgb]| {
        let squares: f64 = pixels.iter().zip(&reference).map(|(p, q)| (*p - *q).length_squared()).sum();
        (squares / (3 * reference.len()) as f64).sqrt()
    };
    let mut choices = Vec::new();
    for depth in DEPTHS.filter(|depth| *depth < deepest) {
        let (pixels, cost) = traced(depth, None)?;
        choices.push(Choice { name: format!("depth {depth}"), cost, error: error(&pixels) });
    }
    choices.push(Choice { name: format!("depth {deepest}"), cost: most, error: 0.0 });
    for weight in WEIGHTS {
        let (pixels, cost) = traced(deepest, Some(weight))?;
        choices.push(Choice { name: format!("min_weight {weight}"), cost, error: error(&pixels) });
    }
    Some(choices)
}
