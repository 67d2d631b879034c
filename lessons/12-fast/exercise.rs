//! Lesson 12: fast. Read README.md beside this file, write the six functions, and run
//!
//!     cargo run --example lesson-12
#![allow(unused_variables, reason = "until the functions are written")]

mod check;

use raytree::lessons::{Aabb, Builder, Item, Node, Walk};

/// A box with at most so many triangles is not divided any more.
#[allow(dead_code, reason = "until `build` is written")]
pub const LEAF: usize = 2;

/// The smallest box around all triangles. There is at least one: `items[0].triangle.vertices` are its three corners.
pub fn bounds(items: &[Item]) -> Aabb {
    todo!()
}

/// The area of all six faces.
pub fn surface_area(aabb: &Aabb) -> f64 {
    todo!()
}

/// What two groups of triangles cost a ray: for each group the surface area of its box times the number of its triangles.
pub fn cost(left: &[Item], right: &[Item]) -> f64 {
    todo!()
}

/// The cheapest way to cut two or more triangles into two groups: sorted by their centers along x, y or z, at any place. The
/// group with the smaller centers comes first.
pub fn split(items: &[Item]) -> [Vec<Item>; 2] {
    todo!()
}

/// The node of some triangles. `builder.build(items)` calls this function again for the nodes below.
pub fn build(items: &[Item], builder: &Builder) -> Node {
    todo!()
}

/// The t of the nearest hit: that of a triangle in `node`, or `best` where none is nearer. The ray enters the box of `node`.
/// `walk.nearest(child, best)` calls this function again.
pub fn nearest(node: &Node, walk: &Walk, best: f64) -> f64 {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { bounds, surface_area, cost, split, build, nearest })
}
