//! One formula for several kinds of number, and a number known well enough to act on.

use std::ops::{Add, Mul, Sub};

use crate::numbers::{DoubleDouble, Expansion, Stage, U};

/// Numbers that add, subtract and multiply: `f64` and [`DoubleDouble`] to a bound, [`Expansion`] and
/// [`Wide`](crate::numbers::Wide) exactly.
pub trait Ring: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// `x`, exactly.
    fn number(x: f64) -> Self;
    /// `a - b`, exactly (but for `f64`, which rounds).
    fn difference(a: f64, b: f64) -> Self;
    /// `a b`, exactly (but for `f64`, which rounds).
    fn product(a: f64, b: f64) -> Self;
}

impl Ring for f64 {
    #[inline(always)]
    fn number(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn difference(a: f64, b: f64) -> Self {
        a - b
    }
    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        a * b
    }
}

/// The scalar product of two vectors.
#[inline(always)]
pub fn dot<T: Ring>(x: &[T; 3], y: &[T; 3]) -> T {
    let term = |k: usize| x[k].clone() * y[k].clone();
    term(0) + term(1) + term(2)
}

/// The determinant of three rows, `x . (y x z)`.
///
/// # Accuracy
///
/// With [`DoubleDouble`] and rows of components at most X, Y, Z: within `150 u^2 X Y Z`. Each of the six products
/// takes part in two multiplications (8 u^2 each), one difference and two sums (3 u^2 each): `6 * 25`.
#[inline(always)]
pub fn determinant<T: Ring>(x: &[T; 3], y: &[T; 3], z: &[T; 3]) -> T {
    let minor = |i: usize, j: usize| y[i].clone() * z[j].clone() - y[j].clone() * z[i].clone();
    x[0].clone() * minor(1, 2) + x[1].clone() * minor(2, 0) + x[2].clone() * minor(0, 1)
}

/// A number whose sign is exactly right and whose value is right to a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// The value; negative, zero or positive exactly as the true one is.
    pub value: f64,
    /// A bound on `|value - true value| / |true value|`; 0 for zero.
    pub relative_error: f64,
    /// What the sign took.
    pub stage: Stage,
}

impl Known {
    /// A relative error of 32 u = 2^-48 is good enough for a value; where it would be larger the exact stage gives the
    /// value.
    const ACCURATE: f64 = 32.0 * U;

    /// Whether the value is that good.
    #[inline(always)]
    pub fn is_accurate(&self) -> bool {
        self.relative_error <= Known::ACCURATE
    }

    /// The number, its value within a few ulp: from `rough`, which is within `bound` of the truth, or from `exact`.
    #[inline(always)]
    pub fn measured(rough: DoubleDouble, bound: f64, exact: impl FnOnce() -> Expansion) -> Self {
        let known = Known::from_double_double(rough, bound);
        match known {
            Some(known) if known.is_accurate() => known,
            _ => {
                let stage = known.map_or(Stage::Expansion, |known| known.stage);
                Known { stage, ..Known::exact(&exact()) }
            }
        }
    }

    /// The number, its sign exact and its value as good as it comes: from `rough`, which is within `bound` of the
    /// truth, or, where that leaves the sign open, from `exact`.
    #[inline(always)]
    pub fn decided(rough: DoubleDouble, bound: f64, exact: impl FnOnce() -> Expansion) -> Self {
        Known::from_double_double(rough, bound).unwrap_or_else(|| Known::exact(&exact()))
    }

    /// Nothing where the bound leaves the sign open. Every `bound` has room for the `u` between `hi` and `hi + lo`.
    #[inline(always)]
    fn from_double_double(x: DoubleDouble, bound: f64) -> Option<Self> {
        let ratio = bound / x.hi.abs();
        // Not for NaN either, which is 0 / 0.
        if !(ratio < 1.0) {
            return None;
        }
        Some(Known { value: x.hi, relative_error: (ratio + U) / (1.0 - ratio), stage: Stage::DoubleDouble })
    }

    /// The number that an expansion is.
    pub fn exact(x: &Expansion) -> Self {
        Known { value: x.estimate(), relative_error: 4.0 * U, stage: Stage::Expansion }
    }
}
