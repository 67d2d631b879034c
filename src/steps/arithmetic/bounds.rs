//! The ray and a bounding box: [`SlabRay::span`](crate::hits::SlabRay::span), in double precision whatever the geometry's.

use super::Form;
use super::aabb::{FAR, NEAR, Way, along, corners, name_of};
use super::expression::{largest, number, smallest, v};
use crate::hits::SlabRay;
use crate::numbers::Precision;

/// The reciprocals of the direction, worked out once a ray.
const INVERSE: [&str; 3] = ["inv_x", "inv_y", "inv_z"];

pub(super) fn form(ways: [Way; 3]) -> Form {
    let (mut lines, mut nears, mut fars) = (Vec::new(), vec![number(0.0)], Vec::new());
    for k in 0..3 {
        if corners(ways[k]).is_some() {
            lines.push((INVERSE[k], number(1.0) / along(k, "d")));
        }
    }
    for k in 0..3 {
        let Some([first, last]) = corners(ways[k]) else { continue };
        let end = |corner| (along(k, corner) - along(k, "o")) * v(INVERSE[k]);
        lines.extend([(NEAR[k], end(first)), (FAR[k], end(last))]);
        nears.push(v(NEAR[k]));
        fars.push(v(FAR[k]));
    }
    lines.push(("t_in", largest(nears) * number(1.0 - SlabRay::SLACK)));
    lines.push(("t_out", smallest(fars) * number(1.0 + SlabRay::SLACK)));
    let source = "Kay and Kajiya 1986, moved out by as much as rounding can take: no hit is lost";
    super::form(
        name_of("bounds", ways),
        "where the ray enters and leaves a bounding box",
        source,
        Precision::F64,
        lines,
    )
}
