//! The ray and a triangle: [`triangle_lecture_values`](crate::kernels::triangle_lecture_values) and
//! [`triangle_moller_trumbore_values`](crate::kernels::triangle_moller_trumbore_values).

use super::expression::{cross, dot, number, v};
use super::{Form, form};
use crate::numbers::Precision;

pub(super) fn by_plane(precision: Precision) -> Form {
    let lines = vec![
        ("n", cross(v("v1") - v("v0"), v("v2") - v("v0"))),
        ("n_dot_d", dot(v("n"), v("d"))),
        ("t", (dot(v("n"), v("v0")) - dot(v("n"), v("o"))) / v("n_dot_d")),
        ("p", v("o") + v("d") * v("t")),
        ("n_dot_n", dot(v("n"), v("n"))),
        ("a", dot(v("n"), cross(v("v2") - v("v1"), v("p") - v("v1"))) / v("n_dot_n")),
        ("b", dot(v("n"), cross(v("v0") - v("v2"), v("p") - v("v2"))) / v("n_dot_n")),
        ("c", number(1.0) - v("a") - v("b")),
    ];
    let source = "the lecture: the plane's hit p, then p = a v0 + b v1 + c v2 by areas along the normal";
    form(
        "triangle_by_plane",
        "where the ray meets the triangle's plane, and whether that is inside",
        source,
        precision,
        lines,
    )
}

pub(super) fn by_determinants(precision: Precision) -> Form {
    let lines = vec![
        ("e1", v("v1") - v("v0")),
        ("e2", v("v2") - v("v0")),
        ("p", cross(v("d"), v("e2"))),
        ("det", dot(v("e1"), v("p"))),
        ("inv_det", number(1.0) / v("det")),
        ("s", v("o") - v("v0")),
        ("b", dot(v("s"), v("p")) * v("inv_det")),
        ("q", cross(v("s"), v("e1"))),
        ("c", dot(v("d"), v("q")) * v("inv_det")),
        ("a", number(1.0) - v("b") - v("c")),
        ("t", dot(v("e2"), v("q")) * v("inv_det")),
    ];
    let source = "Möller and Trumbore 1997: o - v0 = -t d + b e1 + c e2 by Cramer's rule";
    form("triangle_by_determinants", "where the ray meets the triangle", source, precision, lines)
}
