//! Reflection, refraction and Fresnel's equations: the functions of [`kernels::optics`](crate::kernels::optics).

use super::expression::{Expression, abs, dot, largest, number, smallest, sqrt, v};
use super::{Cosines, Form, Tiny, form, rounded};
use crate::numbers::Precision;

pub(super) fn reflect(precision: Precision, tiny: Tiny) -> Form {
    let lines = vec![("d_dot_n", dot(v("d"), v("n"))), ("r", tiny.of(v("d") - v("n") * (number(2.0) * v("d_dot_n"))))];
    let source = "the lecture: twice the projection of d on n, taken off";
    form(tiny.name("reflect"), "the mirrored direction", source, precision, lines)
}

pub(super) fn snell_usual(precision: Precision, tiny: Tiny) -> Form {
    let one = || number(1.0);
    let cos_i = smallest([one(), largest([number(0.0), -dot(v("d"), v("n")) / v("length")])]);
    let along = (v("eta") * v("cos_i") - v("cos_t")) * v("length");
    let lines = vec![
        ("eta", v("n_i") / v("n_t")),
        ("length", sqrt(dot(v("d"), v("d")))),
        ("cos_i", cos_i),
        ("k", one() - v("eta") * v("eta") * (one() - v("cos_i") * v("cos_i"))),
        ("cos_t", sqrt(v("k"))),
        ("t", tiny.of(v("d") * v("eta") + v("n") * along)),
    ];
    let source = "Snell's law as in the lecture: k < 0 is total reflection";
    form(tiny.name("snell_usual"), "the refracted direction", source, precision, lines)
}

pub(super) fn snell_stable(is_rounded: bool, tiny: Tiny) -> Form {
    let along = (v("n_i") - v("n_t")) * (v("n_i") + v("n_t")) * dot(v("d"), v("d")) / v("denominator");
    let lines = vec![
        ("d_dot_n", dot(v("d"), v("n"))),
        ("denominator", v("n_t") * (v("n_i") * abs(v("d_dot_n")) + sqrt(v("S")))),
        ("along", along),
        ("t", tiny.of(rounded(is_rounded, v("d") * (v("n_i") / v("n_t")) + v("n") * v("along")))),
    ];
    let source = "Snell's law, S = n_t^2 |d|^2 |n|^2 - n_i^2 (|d|^2 |n|^2 - (d.n)^2) decided exactly and rounded once";
    form(tiny.name("snell"), "the refracted direction", source, Precision::F64, lines)
}

pub(super) fn snell_sign() -> Form {
    let square = |a: &'static str| v(a) * v(a);
    let lines = vec![
        ("lengths", dot(v("d"), v("d")) * dot(v("n"), v("n"))),
        ("d_dot_n", dot(v("d"), v("n"))),
        ("S_64", square("n_t") * v("lengths") - square("n_i") * (v("lengths") - square("d_dot_n"))),
    ];
    let source = "Snell's law, squared so that nothing is divided and no root is taken: S < 0 is total reflection";
    form("snell_sign", "whether light gets through", source, Precision::F64, lines)
}

/// The cosines of incidence and transmission: as they stand, or from `S`.
fn cosines(given: Cosines) -> Vec<(&'static str, Expression)> {
    let one = || number(1.0);
    match given {
        Cosines::Given => Vec::new(),
        Cosines::FromSign => vec![
            ("lengths", sqrt(dot(v("d"), v("d")) * dot(v("n"), v("n")))),
            ("cos_i", smallest([one(), abs(dot(v("d"), v("n"))) / v("lengths")])),
            ("cos_t", smallest([one(), sqrt(v("S")) / v("n_t") / v("lengths")])),
        ],
    }
}

pub(super) fn fresnel_exact(given: Cosines) -> Form {
    let amplitude = |a: &'static str, b: &'static str| (v(a) - v(b)) / (v(a) + v(b));
    let mut lines = cosines(given);
    lines.extend([
        ("ni_ci", v("n_i") * v("cos_i")),
        ("nt_ct", v("n_t") * v("cos_t")),
        ("nt_ci", v("n_t") * v("cos_i")),
        ("ni_ct", v("n_i") * v("cos_t")),
        ("s", amplitude("ni_ci", "nt_ct")),
        ("p", amplitude("nt_ci", "ni_ct")),
        ("R", (v("s") * v("s") + v("p") * v("p")) / number(2.0)),
    ]);
    let source = "Fresnel's equations: the mean of the squared amplitudes of both polarisations";
    form(given.name("fresnel"), "how much is reflected", source, Precision::F64, lines)
}

pub(super) fn fresnel_schlick(given: Cosines, from_smaller: bool) -> Form {
    let (name, cosine) = if from_smaller { ("schlick_in", "cos_i") } else { ("schlick_out", "cos_t") };
    let mut lines = cosines(given);
    lines.extend([
        ("r", (v("n_i") - v("n_t")) / (v("n_i") + v("n_t"))),
        ("r0", v("r") * v("r")),
        ("x", largest([number(0.0), number(1.0) - v(cosine)])),
        ("x2", v("x") * v("x")),
        ("R", v("r0") + (number(1.0) - v("r0")) * (v("x2") * v("x2") * v("x"))),
    ]);
    form(given.name(name), "how much is reflected", "Schlick 1994", Precision::F64, lines)
}
