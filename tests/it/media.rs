//! Which medium a ray is in: nested, touching and overlapping glass, and a camera inside.

use raytree::scene::Loaded;
use raytree::tree::{RayNode, Side};

use crate::support::{ray_tree, small_scene};

const MATERIALS: &str = r#"
    "glass": { "transmission": 1, "ior": 1.5 }, "water": { "transmission": 1, "ior": 1.33 },
    "air": { "transmission": 1, "ior": 1 }, "stone": { "ambient": 1 }"#;

fn ball(material: &str, x: f64, radius: f64) -> String {
    format!(
        r#"{{ "material": "{material}", "shape": {{ "sphere": {{ "center": [{x}, 0, 0], "radius": {radius} }} }} }}"#
    )
}

fn slab(material: &str, from: f64, to: f64) -> String {
    format!(
        r#"{{ "material": "{material}", "shape": {{ "box": {{ "min": [{from}, -1, -1], "max": [{to}, 1, 1] }} }} }}"#
    )
}

fn world(objects: &[String]) -> Loaded {
    small_scene(MATERIALS, &objects.join(","), r#", "max_depth": 20"#)
}

/// The hits along the refracted rays: t of the origin, shape, and both indices.
fn along_x(loaded: &Loaded, from: f64) -> Vec<(f64, u32, [f64; 2])> {
    let tree = ray_tree(loaded, [from, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let rays = std::iter::successors(Some(&tree.root), |node| node.refracted.as_deref());
    let hits: Vec<_> =
        rays.clone().filter_map(|ray| ray.hit.clone()).map(|h| (h.point[0], h.shape, h.ior.unwrap())).collect();
    // Every ray travels in the medium that its hit says it comes from.
    for ray in rays {
        assert_eq!(ray.ior, ray.hit.as_ref().map_or(Some(1.0), |hit| Some(hit.ior.unwrap()[0])));
    }
    hits
}

#[test]
fn nested() {
    let loaded = world(&[ball("glass", 0.0, 3.0), ball("water", 0.0, 2.0), ball("air", 0.0, 1.0)]);
    let wanted = [
        (-3.0, 0, [1.0, 1.5]),
        (-2.0, 1, [1.5, 1.33]),
        (-1.0, 2, [1.33, 1.0]),
        (1.0, 2, [1.0, 1.33]),
        (2.0, 1, [1.33, 1.5]),
        (3.0, 0, [1.5, 1.0]),
    ];
    assert_eq!(along_x(&loaded, -5.0), wanted);
    // A camera inside knows where it is.
    assert_eq!(along_x(&loaded, -1.5), wanted[2..]);
    assert_eq!(along_x(&loaded, 0.0), wanted[3..]);
}

#[test]
fn the_last_of_overlapping_solids_wins() {
    let loaded = world(&[slab("glass", 0.0, 2.0), slab("water", 1.0, 3.0)]);
    let glass_first = [(0.0, 0, [1.0, 1.5]), (1.0, 1, [1.5, 1.33]), (2.0, 0, [1.33, 1.33]), (3.0, 1, [1.33, 1.0])];
    assert_eq!(along_x(&loaded, -1.0), glass_first);
    let loaded = world(&[slab("water", 1.0, 3.0), slab("glass", 0.0, 2.0)]);
    let water_first = [(0.0, 1, [1.0, 1.5]), (1.0, 0, [1.5, 1.5]), (2.0, 1, [1.5, 1.33]), (3.0, 0, [1.33, 1.0])];
    assert_eq!(along_x(&loaded, -1.0), water_first);
}

#[test]
fn surfaces_at_equal_t_are_crossed_together() {
    for order in [["glass", "water"], ["water", "glass"]] {
        let mut objects = vec![slab("glass", 0.0, 1.0), slab("water", 1.0, 2.0)];
        if order[0] == "water" {
            objects.reverse();
        }
        let hits: Vec<_> = along_x(&world(&objects), -1.0).into_iter().map(|(x, _, ior)| (x, ior)).collect();
        assert_eq!(hits, [(0.0, [1.0, 1.5]), (1.0, [1.5, 1.33]), (2.0, [1.33, 1.0])]);
    }
    // The two balls touch in one point.
    let loaded = world(&[ball("glass", 0.0, 1.0), ball("glass", 2.0, 1.0)]);
    let hits = along_x(&loaded, -3.0);
    assert_eq!(hits, [(-1.0, 0, [1.0, 1.5]), (1.0, 0, [1.5, 1.5]), (3.0, 1, [1.5, 1.0])]);
}

#[test]
fn what_is_opaque_stands_in_the_way() {
    // A glass box on a stone floor: the faces coincide, the box comes first, and the floor is seen through it.
    let floor = r#"{ "material": "stone", "shape": { "plane": { "normal": [-1, 0, 0], "distance": -1 } } }"#;
    let loaded = world(&[slab("glass", 0.0, 1.0), floor.to_owned()]);
    let tree = ray_tree(&loaded, [-1.0, 0.25, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(tree.color, [1.0; 3]);
    assert_eq!(along_x(&loaded, -1.0), [(0.0, 0, [1.0, 1.5]), (1.0, 0, [1.5, 1.0]), (1.0, 1, [1.0, 1.0])]);
}

#[test]
fn a_plane_is_the_surface_of_what_lies_below_it() {
    let water = r#"{ "material": "water", "shape": { "plane": { "normal": [-1, 0, 0], "distance": 0 } } }"#;
    let loaded = world(&[water.to_owned()]);
    let down = ray_tree(&loaded, [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let hit = down.root.hit.clone().unwrap();
    assert_eq!((hit.side, hit.ior), (Some(Side::Entering), Some([1.0, 1.33])));
    let below = down.root.refracted.unwrap();
    assert_eq!((below.ior, below.hit.is_none()), (Some(1.33), true));
    let up = ray_tree(&loaded, [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    let hit = up.root.hit.unwrap();
    assert_eq!((hit.side, hit.ior), (Some(Side::Leaving), Some([1.33, 1.0])));
}

#[test]
fn a_lone_triangle_bounds_nothing() {
    let pane =
        r#"{ "material": "glass", "shape": { "triangle": { "vertices": [[0, -1, -1], [0, 1, -1], [0, 0, 2]] } } }"#;
    let tree = ray_tree(&world(&[pane.to_owned()]), [-1.0, 0.0, 0.0], [0.5, 0.01, 0.0]);
    let hit = tree.root.hit.clone().unwrap();
    assert_eq!((hit.side, hit.ior), (None, Some([1.0, 1.0])));
    // Equal indices copy the direction, bit for bit.
    assert_eq!(tree.root.refracted.unwrap().direction, tree.root.direction);
}

#[test]
fn a_touched_solid_is_not_entered() {
    let loaded = world(&[ball("glass", 0.0, 1.0)]);
    let tree = ray_tree(&loaded, [-5.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
    let hit = tree.root.hit.clone().unwrap();
    assert_eq!((hit.t, hit.ior), (5.0, Some([1.0, 1.0])));
    let beyond = tree.root.refracted.unwrap();
    assert!(beyond.hit.is_none(), "the ray has left the ball for good");
    assert_eq!(beyond.direction, tree.root.direction);
}

#[test]
fn glass_bends_by_snell_and_back() {
    let loaded = world(&[slab("glass", 0.0, 1.0)]);
    let direction = [0.8, 0.6, 0.0];
    let tree = ray_tree(&loaded, [-0.1, -0.9, 0.0], direction);
    let inside: &RayNode = tree.root.refracted.as_deref().unwrap();
    assert!((inside.direction[1] - 0.6 / 1.5).abs() < 1e-15);
    let outside = inside.refracted.as_deref().unwrap();
    for (a, b) in outside.direction.iter().zip(direction) {
        assert!((a - b).abs() <= 2.0 * f64::EPSILON, "{:?}", outside.direction);
    }
}
