//! The ray and a box by slabs: [`box_lecture_values`](crate::kernels::box_lecture_values) and
//! [`box_explicit_zero_values`](crate::kernels::box_explicit_zero_values).

use super::expression::{Operation, if_less, largest, of, smallest, v};
use super::{Expression, Form, form};
use crate::numbers::Precision;

/// Which way a ray goes along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::steps) enum Way {
    /// Towards larger coordinates.
    Up,
    /// Towards smaller ones.
    Down,
    /// Neither: it stays where it is.
    Not,
}

impl Way {
    /// The ways of a direction.
    pub(in crate::steps) fn of(direction: [f64; 3]) -> [Self; 3] {
        direction.map(|d| match d {
            d if d > 0.0 => Self::Up,
            d if d < 0.0 => Self::Down,
            _ => Self::Not,
        })
    }
}

pub(super) const NEAR: [&str; 3] = ["near_x", "near_y", "near_z"];
pub(super) const FAR: [&str; 3] = ["far_x", "far_y", "far_z"];
/// `t` at the smaller and at the larger end of each slab, as the lecture swaps them.
pub(super) const LOW: [&str; 3] = ["t_x_min", "t_y_min", "t_z_min"];
pub(super) const HIGH: [&str; 3] = ["t_x_max", "t_y_max", "t_z_max"];

const AXES: [Operation; 3] = [Operation::X, Operation::Y, Operation::Z];

/// The component of a vector along an axis.
pub(super) fn along(axis: usize, vector: &'static str) -> Expression {
    of(AXES[axis], v(vector))
}

/// The corners through which the ray enters and leaves the slab of an axis.
pub(super) fn corners(way: Way) -> Option<[&'static str; 2]> {
    match way {
        Way::Up => Some(["min", "max"]),
        Way::Down => Some(["max", "min"]),
        Way::Not => None,
    }
}

/// A name that says which way the ray goes.
pub(super) fn name_of(what: &str, ways: [Way; 3]) -> String {
    let letter = |way| match way {
        Way::Up => 'u',
        Way::Down => 'd',
        Way::Not => 'n',
    };
    format!("{what}_{}", ways.map(letter).iter().collect::<String>())
}

pub(super) fn lecture(precision: Precision) -> Form {
    let mut lines = Vec::new();
    for k in 0..3 {
        let end = |corner| (along(k, corner) - along(k, "o")) / along(k, "d");
        lines.extend([(LOW[k], end("min")), (HIGH[k], end("max"))]);
        lines.push((NEAR[k], if_less(v(HIGH[k]), v(LOW[k]), v(HIGH[k]), v(LOW[k]))));
        lines.push((FAR[k], if_less(v(HIGH[k]), v(LOW[k]), v(LOW[k]), v(HIGH[k]))));
    }
    lines.push(("t_in", largest(NEAR.map(v))));
    lines.push(("t_out", smallest(FAR.map(v))));
    let source = "the lecture: t_in is the largest of the slabs' smaller ends, t_out the smallest of their larger ends";
    form("box_lecture", "where the ray's line enters and leaves the box", source, precision, lines)
}

pub(super) fn slabs(ways: [Way; 3], precision: Precision) -> Form {
    let (mut lines, mut nears, mut fars) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..3 {
        let Some([first, last]) = corners(ways[k]) else { continue };
        let end = |corner| (along(k, corner) - along(k, "o")) / along(k, "d");
        lines.extend([(NEAR[k], end(first)), (FAR[k], end(last))]);
        nears.push(v(NEAR[k]));
        fars.push(v(FAR[k]));
    }
    lines.extend([("t_in", largest(nears)), ("t_out", smallest(fars))]);
    let source = "Kay and Kajiya 1986; an axis that the ray does not go along is left out";
    form(name_of("box", ways), "where the ray's line enters and leaves the box", source, precision, lines)
}

/// The names of the lines of one slab.
#[derive(Clone, Copy, Debug)]
pub(in crate::steps) struct SlabNames {
    /// Where the ray enters.
    pub(in crate::steps) near: &'static str,
    /// Where it leaves.
    pub(in crate::steps) far: &'static str,
    /// At the smaller and at the larger end, where the lecture works out both before it swaps them.
    pub(in crate::steps) ends: [&'static str; 2],
}

/// The names of the lines of the slab of an axis.
pub(in crate::steps) fn slab_names(axis: usize) -> SlabNames {
    SlabNames { near: NEAR[axis], far: FAR[axis], ends: [LOW[axis], HIGH[axis]] }
}
