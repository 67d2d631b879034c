//! Which numbers may be stored, so that no exact stage over- or underflows.

use crate::numbers::Real;

/// 2^n for `-1022 <= n <= 1023`.
#[inline(always)]
pub(crate) const fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}

/// Whether `x` may be stored: zero, or a multiple of 2^-178 of magnitude at most 2^128.
///
/// Every finite `f32` is in range, its denormals too (they are multiples of 2^-149), and every `f64` from 2^-126 to
/// 2^128 (it has 53 bits: `2^-126 * 2^-52`). A product of six such numbers, or of their differences, is below 2^774
/// and a multiple of 2^-1068: it neither overflows nor loses bits to underflow, nor do the error terms of
/// [`two_product`].
///
/// # Example
///
/// ```
/// use raytree::numbers::is_in_range;
/// assert!(is_in_range(0.1) && is_in_range(-0.0) && is_in_range(f64::from(f32::MAX)));
/// assert!(!is_in_range(1e-50) && !is_in_range(1e39) && !is_in_range(f64::NAN));
/// ```
///
/// [`two_product`]: crate::numbers::error_free::two_product
pub fn is_in_range(x: f64) -> bool {
    // The product is exact: a power of two, and far from overflow.
    x.abs() <= power_of_two(128) && (x * power_of_two(178)).fract() == 0.0
}

/// `x`, or 0 where its magnitude is below 2^-126: what is done to the components of a spawned ray to keep them in
/// range.
///
/// # Example
///
/// ```
/// use raytree::numbers::flush_tiny;
/// assert_eq!((flush_tiny(1e-40), flush_tiny(-0.25)), (0.0, -0.25));
/// ```
pub fn flush_tiny<R: Real>(x: R) -> R {
    if x.to_f64().abs() < power_of_two(-126) { R::ZERO } else { x }
}
