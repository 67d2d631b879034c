//! From linear light to what a file holds.

/// A linear component as an 8-bit sRGB sample, clamped to [0, 1] and rounded. Source: IEC 61966-2-1.
pub fn srgb8(linear: f64) -> u8 {
    let x = linear.clamp(0.0, 1.0);
    let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
}
