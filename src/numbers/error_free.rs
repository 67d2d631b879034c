//! Error-free transformations: a sum or product of two `f64` as the rounded result and its exact rounding error.
//!
//! # Ranges
//!
//! No overflow (magnitudes below 2^996 for products) and, for products, an exact result that is a multiple of 2^-1074.
//! Numbers that [`is_in_range`](crate::numbers::is_in_range) accepts, their differences, and products of up to six of
//! those are safe.
//!
//! # Source
//!
//! Knuth, The Art of Computer Programming, vol. 2, 4.2.2 (`two_sum`); Dekker, A floating-point technique for extending
//! the available precision, 1971 (`fast_two_sum`, `split`, `two_product`). No fused multiply-add: where the processor
//! has none it is a slow call, and asking for it at run time gained nothing.

/// `(s, e)` with `s = fl(a + b)` and `s + e = a + b` exactly.
///
/// # Example
///
/// ```
/// # use raytree::numbers::error_free::two_sum;
/// assert_eq!(two_sum(1e16, 1.0), (1e16, 1.0)); // 1e16 + 1 is no f64
/// ```
#[inline(always)]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let b_virtual = s - a;
    let a_virtual = s - b_virtual;
    (s, (a - a_virtual) + (b - b_virtual))
}

/// `(s, e)` with `s = fl(a - b)` and `s + e = a - b` exactly.
#[inline(always)]
pub fn two_diff(a: f64, b: f64) -> (f64, f64) {
    two_sum(a, -b)
}

/// [`two_sum`] for `|a| >= |b|` or `a = 0`, in three operations.
#[inline(always)]
pub fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// `x` as the sum of two numbers of at most 26 bits each.
#[inline(always)]
pub fn split(x: f64) -> (f64, f64) {
    let c = 134_217_729.0 * x; // 2^27 + 1
    let hi = c - (c - x);
    (hi, x - hi)
}

/// `(p, e)` with `p = fl(a b)` and `p + e = a b` exactly.
///
/// # Example
///
/// ```
/// # use raytree::numbers::error_free::two_product;
/// let x = 1.0 + f64::EPSILON; // x x = 1 + 2 EPSILON + EPSILON^2
/// assert_eq!(two_product(x, x), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
/// ```
#[inline(always)]
pub fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let (a_hi, a_lo) = split(a);
    let (b_hi, b_lo) = split(b);
    (p, a_lo * b_lo - (((p - a_hi * b_hi) - a_lo * b_hi) - a_hi * b_lo))
}
