//! Expansions: exact sums of as many `f64` as it takes.

use std::ops::{Add, Mul, Neg, Sub};

use crate::numbers::Ring;
use crate::numbers::error_free::{fast_two_sum, two_diff, two_product, two_sum};

/// An exact real number as a sum of `f64` whose bits do not overlap, the smallest first, without zeros.
///
/// # Ranges
///
/// Exact for sums of products of up to six numbers (or differences of numbers) that
/// [`is_in_range`](crate::numbers::is_in_range) accepts.
///
/// # Source
///
/// Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997: `add` is
/// FAST-EXPANSION-SUM, `scale` is SCALE-EXPANSION, both with zero elimination (with ties to even both keep the
/// components strongly non-overlapping, his theorems 13 and 19), `estimate` the first half of COMPRESS.
///
/// # Example
///
/// ```
/// use raytree::numbers::{Expansion, Ring};
/// let sum = Expansion::number(1e30) + Expansion::number(1.0) - Expansion::number(1e30);
/// assert_eq!((sum.sign(), sum.estimate()), (1, 1.0));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Expansion {
    components: Vec<f64>,
}

impl Expansion {
    fn pair((hi, lo): (f64, f64)) -> Self {
        Expansion { components: [lo, hi].into_iter().filter(|x| *x != 0.0).collect() }
    }

    /// -1, 0 or 1: the sign of the largest component, since the smaller ones cannot outweigh it.
    pub fn sign(&self) -> i32 {
        self.components.last().map_or(0, |x| if *x < 0.0 { -1 } else { 1 })
    }

    /// The value, rounded: relative error at most `4 u`, zero exactly for zero.
    pub fn estimate(&self) -> f64 {
        // From the largest down: `sum` takes in the next component exactly as long as it can. As soon as a remainder is
        // left over, `sum` is that close (one ulp, 2 u) to the whole, and the components not seen are smaller than an
        // ulp of the remainder.
        let mut from_largest = self.components.iter().rev();
        let Some(&(mut sum)) = from_largest.next() else { return 0.0 };
        for &x in from_largest {
            let (s, rest) = fast_two_sum(sum, x);
            sum = s;
            if rest != 0.0 {
                break;
            }
        }
        sum
    }

    fn scale(&self, b: f64) -> Self {
        let mut components = Vec::with_capacity(2 * self.components.len());
        let mut push = |x: f64| {
            if x != 0.0 {
                components.push(x);
            }
        };
        let mut sum = 0.0;
        for &x in &self.components {
            let (product_hi, product_lo) = two_product(x, b);
            let (s, rest) = two_sum(sum, product_lo);
            push(rest);
            let (s, rest) = fast_two_sum(product_hi, s);
            push(rest);
            sum = s;
        }
        push(sum);
        Expansion { components }
    }
}

impl Ring for Expansion {
    fn number(x: f64) -> Self {
        Expansion::pair((x, 0.0))
    }
    fn difference(a: f64, b: f64) -> Self {
        Expansion::pair(two_diff(a, b))
    }
    fn product(a: f64, b: f64) -> Self {
        Expansion::pair(two_product(a, b))
    }
}

impl Add for Expansion {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (a, b) = (&self.components, &other.components);
        let mut components = Vec::with_capacity(a.len() + b.len());
        let (mut i, mut j) = (0, 0);
        let mut next = || {
            // Merge by magnitude.
            if j == b.len() || (i < a.len() && a[i].abs() <= b[j].abs()) {
                i += 1;
                a[i - 1]
            } else {
                j += 1;
                b[j - 1]
            }
        };
        let count = a.len() + b.len();
        if count == 0 {
            return Expansion::default();
        }
        let mut sum = next();
        for _ in 1..count {
            let (s, rest) = two_sum(sum, next());
            if rest != 0.0 {
                components.push(rest);
            }
            sum = s;
        }
        if sum != 0.0 {
            components.push(sum);
        }
        Expansion { components }
    }
}

impl Neg for Expansion {
    type Output = Self;
    fn neg(mut self) -> Self {
        for x in &mut self.components {
            *x = -*x;
        }
        self
    }
}

impl Sub for Expansion {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Expansion {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (long, short) = if self.components.len() < other.components.len() { (other, self) } else { (self, other) };
        // Summed in pairs of equal length.
        fn sum(long: &Expansion, factors: &[f64]) -> Expansion {
            match factors {
                [] => Expansion::default(),
                [x] => long.scale(*x),
                _ => {
                    let (left, right) = factors.split_at(factors.len() / 2);
                    sum(long, left) + sum(long, right)
                }
            }
        }
        sum(&long, &short.components)
    }
}
