//! Which numbers a mesh may hold.

/// The multiple of 2^-178 nearest to `x`, ties to even; `x` itself from 2^-126 up.
pub(super) fn to_range(x: f64) -> f64 {
    let step = power_of_two(-126);
    // In [2^-126, 2^-125) doubles are 2^-178 apart, so that the sum rounds as wanted and the difference is exact.
    if x.abs() < step { ((x.abs() + step) - step).copysign(x) } else { x }
}

/// What would be right, for messages about a number out of range.
pub(super) const RANGE_HELP: &str =
    "coordinates are multiples of 2^-178 between -2^128 and 2^128 (about 3.4e38); write 0 for tiny ones";

const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}
