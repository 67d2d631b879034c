//! The recursion: its limits, its children, and the light it adds up. Its depth: rows G of the hard cases.

use raytree::tree::{Kind, Outcome, RayNode};

use crate::support::{FACING_MIRRORS, ray_tree, scene, small_scene, tracer};

#[test]
fn of_a_coloured_weight_the_largest_component_is_cut_off() {
    let more = r#", "max_depth": 20, "min_weight": 0.9"#;
    let loaded = small_scene(r#""m": { "reflection": [0, 0, 1] }"#, FACING_MIRRORS, more);
    assert_eq!(ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]).rays, 21);
}

#[test]
fn the_budget_counts_every_ray_of_the_pixel() {
    let light = r#", "lights": [{ "point": { "position": [0, 0, 0.5], "color": [1, 1, 1] } }], "max_depth": 64"#;
    let shadows = |tree: &RayNode| tree.walk().filter(|n| n.kind == Kind::Shadow && n.outcome.is_traced()).count();
    for budget in 1..12 {
        let more = format!(r#"{light}, "ray_budget": {budget}"#);
        let loaded = small_scene(r#""m": { "diffuse": 1, "reflection": 1 }"#, FACING_MIRRORS, &more);
        let tree = ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]);
        assert_eq!(tree.rays, budget);
        // Camera, shadow, reflected, shadow, ...
        assert_eq!(shadows(&tree.root) as u64, budget / 2);
        assert!(tree.root.walk().any(|node| node.outcome == Outcome::RayBudget));
        let scarce = tree.root.walk().filter(|node| node.outcome == Outcome::RayBudget);
        assert!(scarce.into_iter().all(|node| node.children().next().is_none()));
    }
}

#[test]
fn surfaces_that_face_away_and_mirrors_get_no_shadow_ray() {
    let light = r#", "lights": [{ "directional": { "direction": [0, 0, -1], "color": [1, 1, 1] } }]"#;
    for (material, rays) in [(r#""diffuse": 1"#, 1), (r#""reflection": 0.5"#, 7)] {
        // The ray meets the plane in front of it, which the light behind that plane does not reach.
        let objects = r#"{ "material": "m", "shape": { "plane": { "normal": [0, 0, -1], "distance": -1 } } },
                         { "material": "m", "shape": { "plane": { "normal": [0, 0, 1], "distance": -1 } } }"#;
        let loaded = small_scene(&format!(r#""m": {{ {material} }}"#), objects, &format!(r#"{light}, "max_depth": 6"#));
        let tree = ray_tree(&loaded, [0.0; 3], [0.0, 0.0, 1.0]);
        assert_eq!(tree.rays, rays, "{material}");
        assert!(tree.root.walk().all(|node| node.kind != Kind::Shadow));
    }
}

#[test]
fn total_reflection_carries_the_weight_of_both() {
    // From inside glass, 60 degrees to the normal: beyond the critical angle of 41.8.
    let direction = [3.0_f64.sqrt(), 0.0, 1.0];
    for (material, weight) in [
        (r#""reflection": 0.25, "transmission": 0.5"#, 0.75),
        (r#""transmission": 0.5"#, 0.5),
        (r#""reflection": 0.25, "transmission": 0.5, "fresnel": "exact""#, 0.25),
        (r#""transmission": 0.5, "fresnel": "schlick""#, 0.5),
    ] {
        let materials = format!(r#""m": {{ {material}, "ior": 1.5 }}"#);
        let glass = r#"{ "material": "m", "shape": { "plane": { "normal": [0, 0, 1], "distance": 1 } } }"#;
        let tree = ray_tree(&small_scene(&materials, glass, ""), [0.0; 3], direction);
        assert!(tree.root.total_reflection && tree.root.refracted.is_none(), "{material}");
        let reflected = tree.root.reflected.unwrap();
        assert_eq!((reflected.weight, reflected.ior), (Some([weight; 3]), Some(1.5)), "{material}");
    }
}

#[test]
fn a_solver_of_nothing_sees_the_background() {
    let loaded = scene(
        r#"{ "image": { "width": 3, "height": 3 }, "background": { "gradient": { "bottom": [0, 0, 0], "top": [1, 1, 1] } },
             "camera": { "eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov_y_degrees": 90 },
             "materials": {}, "objects": [] }"#,
    );
    let tracer = tracer::<f64>(&loaded.scene);
    assert_eq!(tracer.pixel_color(1, 1).to_array(), [0.5; 3]);
    // The upper pixel's direction is (0, 2/3, -1).
    let up = 0.5 + 0.5 * (2.0 / 3.0) / (13.0_f64 / 9.0).sqrt();
    assert!((tracer.pixel_color(1, 0).x - up).abs() < 1e-15);
}
