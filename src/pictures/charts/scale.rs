//! From values to positions, and the ticks in between.

use crate::pictures::drawing::Words;

/// How values are laid out along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Evenly, from a value to a larger one.
    Linear(f64, f64),
    /// By their logarithm, from a positive value to a larger one.
    Log(f64, f64),
    /// By their logarithm, with a band of its own for zero before the first value.
    LogAndZero(f64, f64),
}

/// What an axis is called and how its values are laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Its name with the unit.
    pub title: String,
    /// Its scale.
    pub scale: Scale,
}

impl Scale {
    /// A linear scale from zero to a little above the largest value.
    pub fn linear_from_zero(values: impl IntoIterator<Item = f64>) -> Self {
        let largest = values.into_iter().fold(0.0, f64::max);
        Scale::Linear(0.0, if largest > 0.0 { largest * 1.08 } else { 1.0 })
    }

    /// A logarithmic scale around the positive values, out to the next 1, 2 or 5 times a power of ten, with a band for zero
    /// if there is one among them.
    pub fn log_around(values: impl IntoIterator<Item = f64>) -> Self {
        let (mut low, mut high, mut zero) = (f64::INFINITY, 0.0_f64, false);
        for value in values {
            if value > 0.0 {
                (low, high) = (low.min(value), high.max(value));
            } else {
                zero = true;
            }
        }
        if !(low <= high) {
            (low, high) = (1.0, 10.0);
        }
        let (low, high) = (round_down(low * 0.8), round_up(high * 1.25));
        if zero { Scale::LogAndZero(low, high) } else { Scale::Log(low, high) }
    }

    /// The scale between two positions along an axis.
    pub fn between(self, start: f64, end: f64) -> Ruler {
        Ruler { scale: self, start, end }
    }

    /// The first and the last value.
    pub fn ends(self) -> (f64, f64) {
        let (Scale::Linear(low, high) | Scale::Log(low, high) | Scale::LogAndZero(low, high)) = self;
        (low, high)
    }
}

/// The largest of 1, 2 and 5 times a power of ten that is at most `x`, which has to be positive.
fn round_down(x: f64) -> f64 {
    let power = libm::pow(10.0, libm::log10(x * (1.0 + SLACK)).floor());
    let fits = |times: &f64| times * power <= x * (1.0 + SLACK);
    [5.0, 2.0, 1.0].into_iter().find(fits).unwrap_or(1.0) * power
}

/// The smallest of 1, 2 and 5 times a power of ten that is at least `x`, which has to be positive.
fn round_up(x: f64) -> f64 {
    let power = libm::pow(10.0, libm::log10(x * (1.0 - SLACK)).floor());
    let fits = |times: &f64| times * power >= x * (1.0 - SLACK);
    [1.0, 2.0, 5.0].into_iter().find(fits).unwrap_or(10.0) * power
}

/// What counts as equal: logarithms and powers of ten are rounded.
const SLACK: f64 = 1e-9;

/// A scale laid along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ruler {
    scale: Scale,
    start: f64,
    end: f64,
}

/// A value that an axis marks.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where.
    pub at: f64,
    /// What stands there; nothing at a minor tick.
    pub label: Option<Words>,
}

/// The room that zero takes on a logarithmic scale.
const ZERO_BAND: f64 = 40.0;

impl Ruler {
    /// Where a value lies. On a logarithmic scale, zero and less lie in the middle of the band for zero, or at the start where
    /// there is none.
    pub fn at(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear(low, high) => self.start + (self.end - self.start) * (value - low) / (high - low),
            Scale::Log(low, high) | Scale::LogAndZero(low, high) => {
                let first = self.first();
                if value > 0.0 {
                    let share = (libm::log10(value) - libm::log10(low)) / (libm::log10(high) - libm::log10(low));
                    first + (self.end - first) * share
                } else {
                    (self.start + first) / 2.0
                }
            }
        }
    }

    /// Where the smallest value of the scale lies: behind the band for zero, if there is one.
    pub fn first(&self) -> f64 {
        match self.scale {
            Scale::LogAndZero(..) => self.start + ZERO_BAND * (self.end - self.start).signum(),
            _ => self.start,
        }
    }

    /// The band for zero, if there is one.
    pub fn zero_band(&self) -> Option<(f64, f64)> {
        (self.first() != self.start).then(|| (self.start, self.first()))
    }

    /// The ticks, about `spacing` apart where they have labels.
    pub fn ticks(&self, spacing: f64) -> Vec<Tick> {
        match self.scale {
            Scale::Linear(low, high) => self.linear_ticks(low, high, spacing),
            Scale::Log(low, high) | Scale::LogAndZero(low, high) => self.log_ticks(low, high, spacing),
        }
    }

    fn linear_ticks(&self, low: f64, high: f64, spacing: f64) -> Vec<Tick> {
        let wanted = ((self.end - self.start).abs() / spacing).max(1.0);
        let step = round_up((high - low) / wanted);
        let (first, last) = ((low / step - 1e-9).ceil() as i64, (high / step + 1e-9).floor() as i64);
        let decimals = (-libm::log10(step) - 1e-9).ceil().max(0.0) as usize;
        let label = |value: f64| Words::from(plain(value, decimals));
        let tick = |i: i64| Tick { at: self.at(i as f64 * step), label: Some(label(i as f64 * step)) };
        (first..=last).map(tick).collect()
    }

    fn log_ticks(&self, low: f64, high: f64, spacing: f64) -> Vec<Tick> {
        let decade = |x: f64, round: fn(f64) -> f64| round(libm::log10(x)) as i32;
        let (first, last) = (decade(low * 1.000_001, f64::floor), decade(high * 1.000_001, f64::floor));
        let width = (self.end - self.first()).abs() / (libm::log10(high) - libm::log10(low));
        let every = (spacing * 0.7 / width).ceil().max(1.0) as i32;
        let powers = first < -2 || last > 4;
        let mut ticks = Vec::new();
        if self.zero_band().is_some() {
            ticks.push(Tick { at: self.at(0.0), label: Some(Words::from("0")) });
        }
        for exponent in first..=last {
            for digit in 1..=9 {
                let value = f64::from(digit) * libm::pow(10.0, exponent.into());
                if !(low * 0.999_999 <= value && value <= high * 1.000_001) {
                    continue;
                }
                let labelled = match digit {
                    1 => exponent.rem_euclid(every) == 0,
                    2 | 5 => !powers && width > 3.0 * spacing,
                    _ => false,
                };
                let label =
                    || if powers { power_of_ten(exponent) } else { plain(value, (-exponent).max(0) as usize).into() };
                if labelled || width > 0.6 * spacing && every == 1 || digit == 1 {
                    ticks.push(Tick { at: self.at(value), label: labelled.then(label) });
                }
            }
        }
        ticks
    }
}

/// A number with so many decimals, a real minus sign, and thin spaces between thousands from 10,000 on.
pub fn plain(value: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", value.abs());
    let (whole, rest) = text.split_at(text.find('.').unwrap_or(text.len()));
    let mut grouped = String::new();
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && whole.len() > 4 && (whole.len() - i) % 3 == 0 {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    let zero = text.chars().all(|c| matches!(c, '0' | '.'));
    format!("{}{grouped}{rest}", if value < 0.0 && !zero { "−" } else { "" })
}

/// Ten to a power, as one writes it.
pub fn power_of_ten(exponent: i32) -> Words {
    let sign = if exponent < 0 { "−" } else { "" };
    Words::from("10").raised(&format!("{sign}{}", exponent.unsigned_abs()))
}
