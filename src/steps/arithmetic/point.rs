//! The point of a hit: [`World::point`](crate::hits::World::point) and
//! [`World::point_and_error`](crate::hits::World::point_and_error).

use super::expression::{Expression, clamp, cross, dot, largest, number, sqrt, v};
use super::{Form, OnSurface, rounded};
use crate::numbers::Precision;

/// `o + t d`.
fn at() -> Expression {
    v("o") + v("d") * v("t")
}

pub(super) fn form(surface: OnSurface, precision: Precision, is_rounded: bool) -> Form {
    let onto_sphere = |is_rounded| {
        [
            ("length", sqrt(dot(v("f"), v("f")))),
            ("p", rounded(is_rounded, v("center") + v("f") * (v("radius") / v("length")))),
        ]
    };
    let (name, source, lines) = match surface {
        OnSurface::Stays => ("point", "p = o + t d", vec![("p", rounded(is_rounded, at()))]),
        OnSurface::Sphere => {
            let mut lines = vec![("q", at()), ("f", v("q") - v("center"))];
            lines.extend(onto_sphere(is_rounded));
            ("point_on_sphere", "o + t d, brought back onto the sphere along its radius", lines)
        }
        OnSurface::FarSphere { near } => {
            let half = || if near { -v("half_chord") } else { v("half_chord") };
            let mut lines = vec![
                ("g", v("o") - v("center")),
                ("along", v("d") / sqrt(dot(v("d"), v("d")))),
                ("foot", cross(v("along"), cross(v("g"), v("along")))),
                ("half_chord", sqrt(largest([number(0.0), v("radius") * v("radius") - dot(v("foot"), v("foot"))]))),
                ("f", v("foot") + v("along") * half()),
            ];
            lines.extend(onto_sphere(is_rounded));
            let name = if near { "point_on_far_sphere" } else { "point_behind_far_sphere" };
            (name, "from so far away t is too rough: the line's foot below the centre and half the chord", lines)
        }
        OnSurface::Face => {
            let onto = clamp(v("q"), v("face_min"), v("face_max"));
            let lines = vec![("q", at()), ("p", rounded(is_rounded, onto))];
            ("point_on_face", "o + t d, brought back onto the face of the box", lines)
        }
        OnSurface::Triangle => {
            let sum = v("v0") * v("a") + v("v1") * v("b") + v("v2") * v("c");
            ("point_on_triangle", "the vertices, weighted", vec![("p", rounded(is_rounded, sum))])
        }
        OnSurface::Plane => {
            let foot = v("q") - v("n") * (dot(v("n"), v("q")) - v("D"));
            let lines = vec![("q", at()), ("p", rounded(is_rounded, foot))];
            ("point_on_plane", "o + t d, brought back onto the plane down its normal", lines)
        }
    };
    super::form(name, "the hit point", source, precision, lines)
}

pub(super) fn sphere_normal(is_rounded: bool) -> Form {
    let lines = vec![
        ("f", rounded(is_rounded, v("p") - v("center"))),
        ("length", sqrt(dot(v("f"), v("f")))),
        ("n", rounded(is_rounded, v("f") / v("length"))),
    ];
    super::form("sphere_normal", "the sphere's normal", "outward, at length 1", Precision::F64, lines)
}
