//! Direct light: the shadow ray and Phong's local terms. The terms are in double precision whatever the geometry's.

use super::expression::{Expression, Operation, clamp, dot, number, sqrt, v};
use super::{Form, Tiny, form};
use crate::numbers::Precision;

pub(super) fn to_point(precision: Precision, tiny: Tiny) -> Form {
    let lines = vec![
        ("to_light", v("position") - v("p")),
        ("distance", sqrt(dot(v("to_light"), v("to_light")))),
        ("l", tiny.of(v("to_light") / v("distance"))),
    ];
    form(tiny.name("to_point_light"), "the way to the light", "l at length 1", precision, lines)
}

pub(super) fn to_directional(precision: Precision, tiny: Tiny) -> Form {
    let source = "the light is infinitely far away: against the way it travels";
    let lines = vec![("l", tiny.of(-v("travels")))];
    form(tiny.name("to_directional_light"), "the way to the light", source, precision, lines)
}

pub(super) fn cosine() -> Form {
    let source = "the cosine of the angle between both";
    form("cosine", "normal and light", source, Precision::F64, vec![("n_dot_l", dot(v("l"), v("n")))])
}

pub(super) fn ambient() -> Form {
    let lines = vec![("color", v("k_a") * v("surface"))];
    form("ambient", "the ambient term", "Phong 1975", Precision::F64, lines)
}

pub(super) fn diffuse() -> Form {
    let lines = vec![("diffuse", v("k_d") * v("surface") * v("n_dot_l") * v("light"))];
    form("diffuse", "the diffuse term", "Lambert's law", Precision::F64, lines)
}

pub(super) fn specular() -> Form {
    let unit = |a: &'static str| v(a) * (number(1.0) / sqrt(dot(v(a), v(a))));
    let lines = vec![
        ("n1", unit("n")),
        ("l1", unit("l")),
        ("d1", unit("d")),
        ("r", v("n1") * (number(2.0) * dot(v("n1"), v("l1"))) - v("l1")),
        ("r_dot_v", clamp(-dot(v("r"), v("d1")), number(0.0), number(1.0))),
        ("power", Expression::Apply(Operation::Power, vec![v("r_dot_v"), v("shininess")])),
        ("specular", v("k_s") * v("power") * v("light")),
    ];
    let source = "Phong 1975: the light's way mirrored at the normal, against the ray; all at length 1";
    form("specular", "the highlight", source, Precision::F64, lines)
}

pub(super) fn direct() -> Form {
    let lines = vec![("direct", v("diffuse") + v("specular"))];
    form("direct", "what the light adds", "both terms", Precision::F64, lines)
}
