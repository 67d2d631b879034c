//! The integer stage: coordinates scaled to integers, and determinants of them without any rounding.

use crate::numbers::range::power_of_two;

/// Three integers.
pub type Row = [i64; 3];

/// The power of two that scales numbers of magnitude at most `largest` to below 2^bits.
///
/// # Ranges
///
/// `largest` is finite and zero (where 1 will do) or at least 2^-178, `bits < 64`.
#[inline(always)]
pub fn scale_to(largest: f64, bits: i32) -> f64 {
    if largest == 0.0 {
        return 1.0;
    }
    // largest < 2^(e - 1022), e its biased exponent.
    let biased = ((largest.to_bits() >> 52) & 0x7ff) as i32;
    power_of_two(bits - (biased - 1022))
}

/// `v` times `scale`, a power of two, as integers, or nothing if one of them is none.
///
/// # Example
///
/// ```
/// # use raytree::numbers::integers::to_integers;
/// assert_eq!(to_integers([0.5, -3.0, 0.0], 4.0), Some([2, -12, 0]));
/// assert_eq!(to_integers([0.1, 0.0, 0.0], 4.0), None);
/// ```
#[inline(always)]
pub fn to_integers(v: [f64; 3], scale: f64) -> Option<Row> {
    let row = v.map(|x| (x * scale) as i64);
    let exact = (0..3).all(|k| row[k] as f64 == v[k] * scale);
    exact.then_some(row)
}

/// The difference of two rows. Both below 2^62 in magnitude.
#[inline(always)]
pub fn difference(a: &Row, b: &Row) -> Row {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The determinant of three rows, its sign exact, its value to a relative error of 4 u.
///
/// # Ranges
///
/// Magnitudes of at most 2^61.
///
/// # Example
///
/// ```
/// # use raytree::numbers::integers::determinant;
/// let big = 1 << 60;
/// assert_eq!(determinant(&[big, 0, 0], &[0, big, 0], &[0, 0, 1]), (big as f64) * (big as f64));
/// assert_eq!(determinant(&[big, 1, 0], &[big, 1, 0], &[0, 0, big]), 0.0);
/// ```
#[inline(always)]
pub fn determinant(x: &Row, y: &Row, z: &Row) -> f64 {
    let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
    let minor = |i: usize, j: usize| product(y[i], z[j]) - product(y[j], z[i]);
    // Each minor is at most 2^123. Cut at bit 64 into an upper part of at most 2^59 and a lower one below 2^64, times x
    // of at most 2^61: three such products stay below 2^122 and 2^127.
    let (mut upper, mut lower) = (0i128, 0i128);
    for (k, minor) in [minor(1, 2), minor(2, 0), minor(0, 1)].into_iter().enumerate() {
        upper += (minor >> 64) * i128::from(x[k]);
        lower += i128::from(minor as u64) * i128::from(x[k]);
    }
    // The determinant is 2^64 upper + lower: carry, so that 0 <= lower < 2^64.
    upper += lower >> 64;
    let mut lower = lower as u64;
    let negative = upper < 0;
    if negative {
        // Minus: the complement of all 192 bits, plus one.
        let (complement, carry) = (!lower).overflowing_add(1);
        lower = complement;
        upper = !upper + i128::from(carry);
    }
    // Two rounded conversions and a sum of numbers of one sign.
    let magnitude = upper as f64 * power_of_two(64) + lower as f64;
    if negative { -magnitude } else { magnitude }
}

/// The sign of `a b - c d` as -1, 0 or 1. Magnitudes of at most 2^62.
#[inline(always)]
pub fn sign_of_products(a: i64, b: i64, c: i64, d: i64) -> i32 {
    let (left, right) = (i128::from(a) * i128::from(b), i128::from(c) * i128::from(d));
    i32::from(left > right) - i32::from(left < right)
}
