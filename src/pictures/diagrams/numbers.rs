//! How diagrams write the numbers of a tree.

/// Four significant digits, three with an exponent of three, without trailing zeros, a true minus sign, and a power of ten where
/// the number is very large or small.
///
/// # Example
/// ```
/// use raytree::pictures::diagrams::shown;
/// assert_eq!([0.0, 3.43812, -0.5, 1234567.0, 1e-7].map(shown), ["0", "3.438", "−0.5", "1.235e6", "1e−7"]);
/// ```
pub fn shown(x: f64) -> String {
    written(x, 3)
}

fn written(x: f64, decimals: usize) -> String {
    let (mantissa, exponent) = parts(x, decimals);
    match exponent {
        Some(exponent) => format!("{mantissa}e{}", with_minus(&exponent.to_string())),
        None => mantissa,
    }
}

/// Two significant digits: for what a diagram measures, and the tree does not say.
pub(super) fn rough(x: f64) -> String {
    written(x, 1)
}

/// Three numbers, a blank between two.
pub fn shown_vector(v: [f64; 3]) -> String {
    v.map(shown).join(" ")
}

/// The same number in TeX.
///
/// # Example
/// ```
/// use raytree::pictures::diagrams::tex;
/// assert_eq!([-0.5, 1234567.0].map(tex), ["-0.5", r"1.235 \cdot 10^{6}"]);
/// ```
pub fn tex(x: f64) -> String {
    let (mantissa, exponent) = parts(x, 3);
    let mantissa = mantissa.replace('−', "-");
    match exponent {
        Some(exponent) => format!(r"{mantissa} \cdot 10^{{{exponent}}}"),
        None => mantissa,
    }
}

/// The digits with their sign, one and so many more, and the power of ten if there is one.
fn parts(x: f64, decimals: usize) -> (String, Option<i32>) {
    if x == 0.0 || !x.is_finite() {
        return (if x == 0.0 { "0".to_owned() } else { with_minus(&x.to_string()) }, None);
    }
    let scientific = format!("{x:.decimals$e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or_default();
    if exponent.abs() >= 100 && decimals > 2 {
        return parts(x, 2);
    }
    let trim = |digits: &str| match digits.contains('.') {
        true => with_minus(digits.trim_end_matches('0').trim_end_matches('.')),
        false => with_minus(digits),
    };
    match exponent {
        -4..=5 => (trim(&format!("{x:.*}", (decimals as i32 - exponent).max(0) as usize)), None),
        _ => (trim(mantissa), Some(exponent)),
    }
}

fn with_minus(digits: &str) -> String {
    digits.replace('-', "−")
}
