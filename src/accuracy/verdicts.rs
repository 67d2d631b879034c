//! Who is right: the forms of a subject against the referee, set by set.

use std::sync::atomic::{AtomicBool, Ordering};

use super::forms::{Form, Subject, Truth};
use super::random::Random;
use crate::numbers::{Precision, Real, Stage};

/// How many cases of a set are drawn, and which of them the referee sees.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Cases of each set.
    pub cases: usize,
    /// The referee decides every case that the filter leaves open, and one in this many of the rest.
    pub one_in: usize,
    /// At most so many values of `t` of a set are held against the referee's.
    pub values: usize,
    /// Where the random numbers start.
    pub seed: u64,
}

/// Everything that was counted on one set in one precision.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct SetCount {
    /// The subject.
    pub subject: &'static str,
    /// The set.
    pub set: &'static str,
    /// Of rays, shapes and plain arithmetic; certified arithmetic is f64 and more.
    pub precision: Precision,
    /// Cases drawn.
    pub cases: usize,
    /// Cases that the referee decided.
    pub refereed: usize,
    /// Cases that are hits.
    pub hits: usize,
    /// Cases that each [`Stage`] of the certified form decided, the filter first.
    pub stages: [usize; 4],
    /// One a form.
    pub forms: Vec<FormCount>,
}

/// What was counted for one form.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FormCount {
    /// The form.
    pub form: Form,
    /// Hits that are misses.
    pub false_hits: usize,
    /// Misses that are hits.
    pub false_misses: usize,
    /// The error of `t` where both it and the referee have one.
    pub t_errors: UlpHistogram,
}

impl FormCount {
    /// Wrong verdicts.
    pub fn wrong(&self) -> usize {
        self.false_hits + self.false_misses
    }
}

impl SetCount {
    /// Wrong verdicts in a million.
    pub fn wrong_per_million(&self, form: &FormCount) -> f64 {
        form.wrong() as f64 * 1e6 / self.cases as f64
    }
}

/// How often an error was how many units in the last place: bins up to 1/2, 1, 2, 4, ... 2^29, and beyond.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct UlpHistogram(pub [usize; UlpHistogram::BINS]);

impl UlpHistogram {
    /// The number of bins.
    pub const BINS: usize = 32;

    /// Counts one error.
    pub fn add(&mut self, ulps: f64) {
        let bin = (0..Self::BINS - 1).find(|&bin| ulps <= Self::end(bin)).unwrap_or(Self::BINS - 1);
        self.0[bin] += 1;
    }

    /// The largest error in a bin but the last.
    pub fn end(bin: usize) -> f64 {
        0.5 * (1_u64 << bin) as f64
    }

    /// How many errors were counted.
    pub fn total(&self) -> usize {
        self.0.iter().sum()
    }
}

/// Counts all sets of a subject in one precision; nothing if `stop` was set meanwhile. `done` is told how many cases
/// were decided since it was last told.
pub fn count<S: Subject, R: Real>(effort: Effort, stop: &AtomicBool, done: &dyn Fn(usize)) -> Option<Vec<SetCount>> {
    S::SETS.iter().map(|&set| count_set::<S, R>(set, effort, stop, done)).collect()
}

/// Counts one set.
pub fn count_set<S: Subject, R: Real>(
    set: S::Set,
    effort: Effort,
    stop: &AtomicBool,
    done: &dyn Fn(usize),
) -> Option<SetCount> {
    let mut random = Random::new(effort.seed);
    let form = |&form| FormCount { form, false_hits: 0, false_misses: 0, t_errors: UlpHistogram::default() };
    let mut count = SetCount {
        subject: S::NAME,
        set: S::set_name(set),
        precision: R::PRECISION,
        cases: effort.cases,
        refereed: 0,
        hits: 0,
        stages: [0; 4],
        forms: S::FORMS.iter().map(form).collect(),
    };
    let mut values_left = effort.values;
    for i in 0..effort.cases {
        if i % 1024 == 1023 {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            done(1024);
        }
        let case = S::next::<R>(set, &mut random);
        let stage = S::stage(&case);
        count.stages[stage as usize] += 1;
        let is_refereed = stage != Stage::Filter || i % effort.one_in == 0;
        let truth = is_refereed.then(|| S::truth(&case));
        count.refereed += usize::from(is_refereed);
        // Where the referee did not look, the filter is trusted: that is what the one in many is for.
        let is_hit = truth.as_ref().map_or_else(|| S::verdict(Form::Certified, &case).is_some(), Truth::is_hit);
        count.hits += usize::from(is_hit);
        let mut compared = false;
        for form in &mut count.forms {
            // Expansions alone are slow, and no other form is like them: the sample will do.
            if form.form == Form::Exact && !is_refereed {
                continue;
            }
            match (S::verdict(form.form, &case), is_hit) {
                (Some(_), false) => form.false_hits += 1,
                (None, true) => form.false_misses += 1,
                (Some(t), true) if values_left > 0 => {
                    if let Some(ulps) = truth.as_ref().and_then(|truth| truth.ulps::<R>(t)) {
                        form.t_errors.add(ulps);
                        compared = true;
                    }
                }
                _ => {}
            }
        }
        values_left -= usize::from(compared);
    }
    done(effort.cases % 1024);
    Some(count)
}
