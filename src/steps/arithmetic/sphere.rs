//! The ray and a sphere: [`sphere_naive_values`](crate::kernels::sphere_naive_values) and
//! [`sphere_values`](crate::kernels::sphere_values).

use super::expression::{cross, dot, if_less, number, smallest, sqrt, v};
use super::{Form, form};
use crate::numbers::Precision;

pub(super) fn naive(precision: Precision) -> Form {
    let two_a = || number(2.0) * v("a");
    let lines = vec![
        ("f", v("o") - v("center")),
        ("a", dot(v("d"), v("d"))),
        ("b", number(2.0) * dot(v("f"), v("d"))),
        ("c", dot(v("f"), v("f")) - v("radius") * v("radius")),
        ("disc", v("b") * v("b") - number(4.0) * v("a") * v("c")),
        ("root", sqrt(v("disc"))),
        ("t_in", (-v("b") - v("root")) / two_a()),
        ("t_out", (-v("b") + v("root")) / two_a()),
    ];
    let source = "the textbook's formula for a t^2 + b t + c = 0";
    form("sphere_naive", "where the ray's line enters and leaves the sphere", source, precision, lines)
}

pub(super) fn stable(precision: Precision) -> Form {
    let lines = vec![
        ("f", v("o") - v("center")),
        ("a", dot(v("d"), v("d"))),
        ("l", cross(v("f"), v("d"))),
        ("l_dot_l", dot(v("l"), v("l"))),
        ("disc", v("radius") * v("radius") * v("a") - v("l_dot_l")),
        ("b", dot(v("f"), v("d"))),
        ("c", dot(v("f"), v("f")) - v("radius") * v("radius")),
        ("root", sqrt(v("disc"))),
        ("q", if_less(v("b"), number(0.0), v("root") - v("b"), -v("b") - v("root"))),
        ("t0", v("q") / v("a")),
        ("t1", v("c") / v("q")),
        ("t_in", smallest([v("t1"), v("t0")])),
        ("t_out", if_less(v("t0"), v("t1"), v("t1"), v("t0"))),
    ];
    let source = "Haines, Günther and Akenine-Möller 2019: a t^2 + 2 b t + c = 0 without sums that cancel";
    form("sphere_stable", "where the ray's line enters and leaves the sphere", source, precision, lines)
}
