//! Pairs of `f64`: about 106 bits, at many times the cost of plain `f64`.

use std::ops::{Add, Mul, Neg, Sub};

use crate::numbers::Ring;
use crate::numbers::error_free::{fast_two_sum, two_diff, two_product, two_sum};

/// The unevaluated sum `hi + lo`, with `|lo| <= u |hi|`, `u = 2^-53`.
///
/// # Accuracy
///
/// A difference or product of two `f64` ([`Ring::difference`], [`Ring::product`]) is exact. A sum is within
/// `3 u^2 (|a| + |b|)`, a product within `8 u^2 |a b|` of the true one, up to factors `1 + O(u)` that every bound
/// built on these covers. The sum has no *relative* bound where it cancels, nor is one used.
///
/// - Sum: `hi + hi` is exact as `s + e`; `lo + lo` rounds once, by `u^2 (|a| + |b|)` at most; adding `e`, where `|e| <=
///   u |s|`, rounds once, by at most `u (u |s| + u (|a| + |b|)) <= 2 u^2 (|a| + |b|)`.
/// - Product, in units of `u^2 |a b|`: the dropped `lo lo` is 1; `hi lo` and `lo hi` round by 1 each, their sum (at
///   most `2 u |a b|`) by 2, the sum with the error of `hi hi` (at most `3 u |a b|`) by 3: 8 in all.
///
/// # Source
///
/// Dekker 1971; the bounds derived here. (Joldes, Muller and Popescu 2017 prove tighter ones.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    /// The nearest `f64`.
    pub hi: f64,
    /// The rest.
    pub lo: f64,
}

impl Ring for DoubleDouble {
    #[inline(always)]
    fn number(x: f64) -> Self {
        DoubleDouble { hi: x, lo: 0.0 }
    }
    #[inline(always)]
    fn difference(a: f64, b: f64) -> Self {
        let (hi, lo) = two_diff(a, b);
        DoubleDouble { hi, lo }
    }
    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_product(a, b);
        DoubleDouble { hi, lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (hi, lo) = two_sum(s, e + (self.lo + other.lo));
        DoubleDouble { hi, lo }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.hi, other.hi);
        let (hi, lo) = fast_two_sum(p, e + (self.hi * other.lo + self.lo * other.hi));
        DoubleDouble { hi, lo }
    }
}
