//! The camera's ray through a pixel: [`Camera::ray`](crate::scene::Camera::ray), in double precision.

use super::expression::{dot, number, sqrt, v};
use super::{Form, rounded};
use crate::numbers::Precision;

pub(super) fn form(is_rounded: bool) -> Form {
    let half = || number(0.5);
    let lines = vec![
        ("half_width", v("half_height") * v("width") / v("height")),
        ("across", (number(2.0) * (v("x") + half()) / v("width") - number(1.0)) * v("half_width")),
        ("upwards", (number(1.0) - number(2.0) * (v("y") + half()) / v("height")) * v("half_height")),
        ("w", v("forward") + v("right") * v("across") + v("up") * v("upwards")),
        ("length", sqrt(dot(v("w"), v("w")))),
        ("d", rounded(is_rounded, v("w") / v("length"))),
    ];
    let source = "the lecture: a pinhole and an image plane at distance 1, half_height = tan(field of view / 2)";
    super::form("camera", "the ray through the middle of the pixel", source, Precision::F64, lines)
}
