//! Lesson 12: fast. A solution.

mod check;

use raytree::lessons::{Aabb, Builder, Inside, Item, Node, Walk};

/// A box with at most so many triangles is not divided any more.
pub const LEAF: usize = 2;

/// The smallest box around all triangles.
pub fn bounds(items: &[Item]) -> Aabb {
    let first = items[0].triangle.vertices[0];
    let (mut min, mut max) = (first, first);
    for item in items {
        for v in item.triangle.vertices {
            min = min.min(v);
            max = max.max(v);
        }
    }
    Aabb { min, max }
}

/// The area of all six faces.
pub fn surface_area(aabb: &Aabb) -> f64 {
    let size = aabb.max - aabb.min;
    2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
}

/// What two groups of triangles cost a ray: for each group the surface area of its box times the number of its triangles.
pub fn cost(left: &[Item], right: &[Item]) -> f64 {
    surface_area(&bounds(left)) * left.len() as f64 + surface_area(&bounds(right)) * right.len() as f64
}

/// The cheapest way to cut two or more triangles into two groups: sorted by their centers along x, y or z, at any place. The
/// group with the smaller centers comes first.
pub fn split(items: &[Item]) -> [Vec<Item>; 2] {
    let mut cheapest = f64::INFINITY;
    let mut best = [Vec::new(), Vec::new()];
    for axis in 0..3 {
        let mut sorted = items.to_vec();
        sorted.sort_by(|a, b| a.center()[axis].total_cmp(&b.center()[axis]));
        for cut in 1..sorted.len() {
            let (left, right) = sorted.split_at(cut);
            let cost = cost(left, right);
            if cost < cheapest {
                cheapest = cost;
                best = [left.to_vec(), right.to_vec()];
            }
        }
    }
    best
}

/// The node of some triangles. `builder.build(items)` calls this function again for the nodes below.
pub fn build(items: &[Item], builder: &Builder) -> Node {
    let bounds = bounds(items);
    if items.len() <= LEAF {
        return Node::leaf(bounds, items);
    }
    let [left, right] = split(items);
    Node::inner(bounds, builder.build(&left), builder.build(&right))
}

/// The t of the nearest hit: that of a triangle in `node`, or `best` where none is nearer. The ray enters the box of `node`.
/// `walk.nearest(child, best)` calls this function again.
pub fn nearest(node: &Node, walk: &Walk, mut best: f64) -> f64 {
    match &node.inside {
        Inside::Items(items) => {
            for item in items {
                if let Some(t) = walk.hit(item) {
                    best = best.min(t);
                }
            }
        }
        Inside::Children(children) => {
            let [left, right] = children.as_ref();
            let t_left = walk.enter(left).unwrap_or(f64::INFINITY);
            let t_right = walk.enter(right).unwrap_or(f64::INFINITY);
            let [near, far] =
                if t_left <= t_right { [(t_left, left), (t_right, right)] } else { [(t_right, right), (t_left, left)] };
            if near.0 < best {
                best = walk.nearest(near.1, best);
            }
            if far.0 < best {
                best = walk.nearest(far.1, best);
            }
        }
    }
    best
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { bounds, surface_area, cost, split, build, nearest })
}
