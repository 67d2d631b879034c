//! Which medium a ray is in: nested, touching and overlapping glass, and a camera inside.

use raytree::kernels::Ray;
use raytree::scene::{Loaded, Shape};
use raytree::tree::{Keep, Origin, RayNode, Side, record_ray};

use crate::support::{ray_tree, small_scene, tracer};

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

/// The indices at the first hit in f32 and in f64, and how many rays there are.
fn first_hit_in_both(loaded: &Loaded, origin: [f32; 3], direction: [f32; 3]) -> [([f64; 2], u64); 2] {
    let kept = Origin { loaded, keep: Keep::Outcomes };
    let vector = |v: [f32; 3]| v.map(f64::from);
    let narrow = Ray::<f32> { origin: origin.into(), direction: direction.into() };
    let wide = Ray::<f64> { origin: vector(origin).into(), direction: vector(direction).into() };
    let narrow = record_ray(&tracer::<f32>(&loaded.scene), kept, &narrow).unwrap();
    let wide = record_ray(&tracer::<f64>(&loaded.scene), kept, &wide).unwrap();
    [narrow, wide].map(|tree| (tree.root.hit.unwrap().ior.unwrap(), tree.rays))
}

#[test]
fn glass_thinner_than_an_ulp_of_t_is_entered_and_left() {
    let pane = |thick: &str| {
        let shape = format!(r#"{{ "box": {{ "min": [-1, -1, 0], "max": [1, 1, {thick}] }} }}"#);
        small_scene(MATERIALS, &format!(r#"{{ "material": "glass", "shape": {shape} }}"#), "")
    };
    for thick in ["1e-7", "1e-16", "1e-30"] {
        let seen = first_hit_in_both(&pane(thick), [0.25, 0.0, -5.0], [0.0, 0.125, 1.0]);
        for (ior, rays) in seen {
            assert_eq!(rays, 3, "{thick}: the ray enters, crosses and leaves");
            assert!((ior[1] - 1.5).abs() < 1e-15, "{thick}: {ior:?}");
        }
    }
    // No thickness at all: touched, not entered.
    for (ior, rays) in first_hit_in_both(&pane("0"), [0.25, 0.0, -5.0], [0.0, 0.125, 1.0]) {
        assert_eq!((ior, rays), ([1.0, 1.0], 2));
    }
    // A ball from far away: its two roots are one number in f64.
    let ball = world(&[ball("glass", 0.0, 1.0)]);
    let tree = ray_tree(&ball, [0.5, 0.0, 1e17], [0.0, 0.0, -1.0]);
    let hit = tree.root.hit.unwrap();
    assert_eq!(hit.ior, Some([1.0, 1.5]));
    assert!(
        (hit.geometric_normal[0] - 0.5).abs() < 1e-15 && hit.geometric_normal[2] > 0.0,
        "{:?}",
        hit.geometric_normal
    );
    assert!((hit.point[0] - 0.5).abs() < 1e-15, "{:?}", hit.point);
}

#[test]
fn whether_a_camera_is_under_water_is_exact() {
    let mut wrong_if_rounded = 0;
    for i in 0..2000 {
        // A slanted surface through a point that lies on it only up to rounding.
        let (a, b) = (f64::from(i) * 0.37, f64::from(i) * 0.91);
        let normal = [a.sin(), a.cos() * b.sin(), a.cos() * b.cos()];
        let point = [b.cos(), a.sin() * b.sin(), a.cos()];
        let distance: f64 = (0..3).map(|k| normal[k] * point[k]).sum();
        let plane = format!(r#"{{ "plane": {{ "normal": {normal:?}, "distance": {distance:?} }} }}"#);
        let loaded = small_scene(MATERIALS, &format!(r#"{{ "material": "water", "shape": {plane} }}"#), "");
        let Shape::Plane { normal, distance } = loaded.scene.objects[0].shape else { unreachable!() };
        let tree = ray_tree(&loaded, point, normal.to_array());
        // The true height over the plane, in rational arithmetic.
        let rational = |x: f64| dashu_ratio::RBig::try_from(x).unwrap();
        let products = (0..3).map(|k| rational(normal[k]) * rational(point[k]));
        let height = products.fold(-rational(distance), |sum, x| sum + x);
        // On the surface, a ray that goes up comes from below.
        let below = height <= dashu_ratio::RBig::ZERO;
        assert_eq!(tree.root.ior == Some(1.33), below, "{i}");
        wrong_if_rounded += i32::from((normal.dot(point.into()) - distance <= 0.0) != below);
    }
    assert!(wrong_if_rounded > 100, "the set is not hard: {wrong_if_rounded}");
}

#[test]
fn needles_can_be_seen_and_mirror() {
    // Hit in its middle; the cross product of its edges is zero in f64.
    let (x, y) = (2.0_f64.powi(-30), 2.0_f64.powi(-29));
    let needle = format!(
        r#"{{ "material": "mirror", "shape": {{ "triangle": {{ "vertices": [[0, 0, 0], [{:?}, 1, 0], [{:?}, {:?}, 0]] }} }} }}"#,
        1.0 + x,
        1.0 + y,
        1.0 + x
    );
    let loaded = small_scene(r#""mirror": { "reflection": 1 }"#, &needle, "");
    let origin = [(1.0 + x + 1.0 + y) / 4.0, (1.0 + 1.0 + x) / 4.0, 1.0];
    let tree = ray_tree(&loaded, origin, [0.0, 0.0, -1.0]);
    let hit = tree.root.hit.expect("the needle is hit");
    assert_eq!(hit.geometric_normal.map(f64::abs), [0.0, 0.0, 1.0]);
    assert_eq!(tree.root.reflected.unwrap().direction, [0.0, 0.0, 1.0]);
}
