//! A vector at length 1.

/// `v` at length 1, however large or small it is.
///
/// # None when
/// `v` is zero or has a component that is not finite.
///
/// # Accuracy
/// Each component within `3 u` relatively.
///
/// # Example
/// ```
/// use raytree::numbers::unit;
/// assert_eq!(unit([3e-200, 0.0, -4e-200]), Some([0.6, 0.0, -0.8]));
/// assert_eq!(unit([0.0; 3]), None);
/// ```
pub fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let largest = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if largest == 0.0 || !v.iter().all(|x| x.is_finite()) {
        return None;
    }
    // A power of two scales without rounding, so that the squares neither over- nor underflow.
    let [x, y, z] = v.map(|c| libm::scalbn(c, -libm::ilogb(largest)));
    let length = (x * x + y * y + z * z).sqrt();
    Some([x / length, y / length, z / length])
}
