//! How long it takes: medians of interleaved rounds.

use std::hint::black_box;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::forms::{Form, Subject};
use super::random::Random;
use crate::numbers::{Precision, Real};

/// A quantity's quartiles over the rounds.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Quartiles {
    /// A quarter of the rounds took less.
    pub lower: f64,
    /// Half of them did.
    pub median: f64,
    /// Three quarters did.
    pub upper: f64,
}

impl Quartiles {
    /// Of at least one value.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let [lower, median, upper] = [1, 2, 3].map(|quarter| values[quarter * (values.len() - 1) / 4]);
        Self { lower, median, upper }
    }
}

/// How long one form took on one set.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FormTime {
    /// The subject.
    pub subject: &'static str,
    /// The set.
    pub set: &'static str,
    /// Of rays, shapes and plain arithmetic.
    pub precision: Precision,
    /// The form.
    pub form: Form,
    /// Nanoseconds a test.
    pub nanoseconds: Quartiles,
}

/// Runs each piece of work once a round, one after the other, so that whatever else the machine does meets all of them;
/// the seconds of each. Nothing if `stop` was set meanwhile.
pub fn interleaved(rounds: usize, work: &[Box<dyn Fn() + '_>], stop: &AtomicBool) -> Option<Vec<Quartiles>> {
    let mut seconds = vec![Vec::with_capacity(rounds); work.len()];
    for _ in 0..rounds {
        for (work, seconds) in work.iter().zip(&mut seconds) {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            let start = Instant::now();
            work();
            seconds.push(start.elapsed().as_secs_f64());
        }
    }
    Some(seconds.into_iter().map(Quartiles::of).collect())
}

/// Times all forms of a subject on one set, in both precisions side by side, over `cases` independent pairs; nothing
/// if `stop` was set meanwhile.
pub fn time_set<S: Subject>(
    set: S::Set,
    cases: usize,
    rounds: usize,
    seed: u64,
    stop: &AtomicBool,
) -> Option<Vec<FormTime>> {
    let single = draw::<S, f32>(set, cases, seed);
    let double = draw::<S, f64>(set, cases, seed);
    let mut work: Vec<Box<dyn Fn() + '_>> = Vec::new();
    let mut names = Vec::new();
    for &form in S::FORMS {
        // Exact arithmetic alone is a hundred times as slow as the rest: fewer cases do.
        let share = if form == Form::Exact { cases.div_ceil(20) } else { cases };
        let (single, double) = (&single[..share], &double[..share]);
        names.extend([(form, Precision::F32, share), (form, Precision::F64, share)]);
        work.push(Box::new(move || {
            black_box(S::nearest::<f32>(form, black_box(single)));
        }));
        work.push(Box::new(move || {
            black_box(S::nearest::<f64>(form, black_box(double)));
        }));
    }
    let seconds = interleaved(rounds, &work, stop)?;
    let per_test = |q: Quartiles, share: usize| {
        let scale = 1e9 / share as f64;
        Quartiles { lower: q.lower * scale, median: q.median * scale, upper: q.upper * scale }
    };
    let named = names.into_iter().zip(seconds);
    let times = named.map(|((form, precision, share), seconds)| FormTime {
        subject: S::NAME,
        set: S::set_name(set),
        precision,
        form,
        nanoseconds: per_test(seconds, share),
    });
    Some(times.collect())
}

fn draw<S: Subject, R: Real>(set: S::Set, cases: usize, seed: u64) -> Vec<S::Case<R>> {
    let mut random = Random::new(seed);
    (0..cases).map(|_| S::next::<R>(set, &mut random)).collect()
}
