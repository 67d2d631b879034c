//! Numbers as a student reads them.

/// A number to six digits, without superfluous zeros.
///
/// # Example
/// ```
/// use raytree::lessons::shown;
/// assert_eq!([2.0, -0.5, 2.0 / 3.0, 1e-12, -0.0].map(shown), ["2", "-0.5", "0.666667", "1e-12", "0"]);
/// ```
pub fn shown(x: f64) -> String {
    match format!("{x:.5e}").parse::<f64>() {
        Ok(rounded) if x.is_finite() => full(rounded),
        _ => full(x),
    }
}

/// A number with all its digits: the shortest that reads back the same.
pub(super) fn full(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        size if x.is_finite() && !(1e-4..1e9).contains(&size) => format!("{x:e}"),
        _ => x.to_string(),
    }
}
