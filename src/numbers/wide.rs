//! Integers of any length times a power of two: exact, whatever the degree of the formula.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use crate::numbers::Ring;
use crate::numbers::error_free::two_diff;

/// An exact number `+- limbs * 2^exponent`.
///
/// Comparing the hits of two spheres takes polynomials of degree 8 and more in the coordinates, and those leave the
/// range of `f64` exponents that [`Expansion`](crate::numbers::Expansion) lives in. Every finite `f64` is fine here.
///
/// # Source
///
/// Schoolbook arithmetic in base 2^64 (Knuth, vol. 2, 4.3.1). Rays that meet two surfaces at nearly one `t` are rare
/// enough.
///
/// # Example
///
/// ```
/// use raytree::numbers::{Ring, Wide};
/// let x = Wide::number(1e300) * Wide::number(1e300); // 1e600 is no f64
/// assert_eq!((x.clone() + Wide::number(-1.0) - x).sign(), -1);
/// ```
#[derive(Clone, Debug)]
pub struct Wide {
    negative: bool,
    /// Least significant first, the last one not zero; none for zero.
    limbs: Vec<u64>,
    exponent: i32,
}

impl Wide {
    fn new(negative: bool, mut limbs: Vec<u64>, mut exponent: i32) -> Self {
        while limbs.last() == Some(&0) {
            limbs.pop();
        }
        let zeros = limbs.iter().take_while(|limb| **limb == 0).count();
        limbs.drain(..zeros);
        exponent += 64 * zeros as i32;
        Wide { negative, limbs, exponent }
    }

    /// -1, 0 or 1.
    pub fn sign(&self) -> i32 {
        match (self.limbs.is_empty(), self.negative) {
            (true, _) => 0,
            (false, true) => -1,
            (false, false) => 1,
        }
    }

    /// The limbs of this number's magnitude over a smaller exponent.
    fn limbs_at(&self, exponent: i32) -> Vec<u64> {
        let shift = (self.exponent - exponent) as usize;
        let (words, bits) = (shift / 64, shift % 64);
        let mut limbs = vec![0; words];
        let mut carry = 0;
        for &limb in &self.limbs {
            limbs.push((limb << bits) | carry);
            carry = if bits == 0 { 0 } else { limb >> (64 - bits) };
        }
        limbs.push(carry);
        limbs
    }
}

impl Ring for Wide {
    fn number(x: f64) -> Self {
        let bits = x.to_bits();
        let biased = ((bits >> 52) & 0x7ff) as i32;
        let fraction = bits & ((1 << 52) - 1);
        debug_assert!(biased != 0x7ff, "{x} is not finite");
        let (significand, biased) = if biased == 0 { (fraction, 1) } else { (fraction | (1 << 52), biased) };
        let zeros = if significand == 0 { 0 } else { significand.trailing_zeros() as i32 };
        Wide::new(x < 0.0, vec![significand >> zeros], biased - 1075 + zeros)
    }
    fn difference(a: f64, b: f64) -> Self {
        let (hi, lo) = two_diff(a, b);
        Wide::number(hi) + Wide::number(lo)
    }
    fn product(a: f64, b: f64) -> Self {
        Wide::number(a) * Wide::number(b)
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.limbs.is_empty() {
            return other;
        }
        if other.limbs.is_empty() {
            return self;
        }
        let exponent = self.exponent.min(other.exponent);
        let (mut a, mut b) = (self.limbs_at(exponent), other.limbs_at(exponent));
        let length = a.len().max(b.len()) + 1;
        a.resize(length, 0);
        b.resize(length, 0);
        if self.negative == other.negative {
            let mut carry = false;
            for (x, y) in a.iter_mut().zip(b) {
                let (sum, carry_1) = x.overflowing_add(y);
                let (sum, carry_2) = sum.overflowing_add(u64::from(carry));
                *x = sum;
                carry = carry_1 | carry_2;
            }
            return Wide::new(self.negative, a, exponent);
        }
        let self_is_larger = a.iter().rev().cmp(b.iter().rev()) != Ordering::Less;
        let (mut larger, smaller) = if self_is_larger { (a, b) } else { (b, a) };
        let mut borrow = false;
        for (x, y) in larger.iter_mut().zip(smaller) {
            let (rest, borrow_1) = x.overflowing_sub(y);
            let (rest, borrow_2) = rest.overflowing_sub(u64::from(borrow));
            *x = rest;
            borrow = borrow_1 | borrow_2;
        }
        Wide::new(if self_is_larger { self.negative } else { other.negative }, larger, exponent)
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.negative = !self.negative;
        self
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let mut limbs = vec![0; self.limbs.len() + other.limbs.len()];
        for (i, &x) in self.limbs.iter().enumerate() {
            let mut carry = 0;
            for (j, &y) in other.limbs.iter().enumerate() {
                let sum = u128::from(x) * u128::from(y) + u128::from(limbs[i + j]) + u128::from(carry);
                limbs[i + j] = sum as u64;
                carry = (sum >> 64) as u64;
            }
            limbs[i + other.limbs.len()] = carry;
        }
        Wide::new(self.negative != other.negative, limbs, self.exponent + other.exponent)
    }
}
