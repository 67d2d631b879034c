//! Colours: what a child's share is, what it brings back, and the sum. In double precision whatever the geometry's.

use super::expression::{clamp, dot, number, sqrt, v};
use super::{Form, Split, form};
use crate::numbers::Precision;

pub(super) fn share(split: Split) -> Form {
    let (name, source, share) = match split {
        Split::Whole => ("share", "the material's weight", v("k")),
        Split::Reflected => ("share_reflected", "the material's weight, of what is reflected", v("k") * v("R")),
        Split::Transmitted => {
            ("share_transmitted", "the material's weight, of what is not reflected", v("k") * (number(1.0) - v("R")))
        }
        Split::Both => {
            ("share_total", "total reflection: what would have gone through comes back", v("k_r") + v("k_t"))
        }
    };
    let lines = vec![("share", share), ("weight", v("w") * v("share"))];
    form(name, "the child's share and its weight in the pixel", source, Precision::F64, lines)
}

pub(super) fn returned() -> Form {
    let lines = vec![("returned", v("share") * v("color"))];
    form("returned", "what the child brings back", "the lecture", Precision::F64, lines)
}

pub(super) fn sum() -> Form {
    let lines = vec![("color", v("color_so_far") + v("more"))];
    form("sum", "the colour so far", "the lecture: local light, and what the children bring", Precision::F64, lines)
}

pub(super) fn gradient() -> Form {
    let slope = number(0.5) + number(0.5) * dot(v("up"), v("d")) / sqrt(dot(v("d"), v("d")));
    let lines = vec![
        ("s", clamp(slope, number(0.0), number(1.0))),
        ("color", v("bottom") * (number(1.0) - v("s")) + v("top") * v("s")),
    ];
    form("gradient", "the background", "linear in the cosine between the ray and up", Precision::F64, lines)
}
