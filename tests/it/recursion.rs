//! The recursion: its depth, its limits, its children, and the light it adds up.

use raytree::scene::Limits;
use raytree::transport::{Options, Tracer};
use raytree::tree::{Cost, Kind, Outcome, RayNode};

use crate::support::{ray_tree, scene, small_scene, tracer};

const MIRRORS: &str = r#"
    { "material": "m", "shape": { "plane": { "normal": [0, 0, 1], "distance": -1 } } },
    { "material": "m", "shape": { "plane": { "normal": [0, 0, -1], "distance": -1 } } }"#;

fn chain(root: &RayNode) -> Vec<&RayNode> {
    std::iter::successors(Some(root), |node| node.reflected.as_deref()).collect()
}

#[test]
fn level_zero_is_one_ray() {
    let loaded = small_scene(r#""m": { "ambient": 1, "reflection": 0.5 }"#, MIRRORS, r#", "max_depth": 0"#);
    let tree = ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]);
    assert_eq!(tree.rays, 1);
    assert_eq!(tree.color, [1.0; 3]);
    let child = tree.root.reflected.unwrap();
    assert_eq!((child.outcome, child.depth, child.radiance), (Outcome::MaxDepth, 1, Some([0.0; 3])));
    assert!(child.ior.is_none() && child.hit.is_none() && child.reflected.is_none());
}

#[test]
fn facing_mirrors_at_depth_64() {
    let loaded = small_scene(r#""m": { "ambient": 0.5, "reflection": 1 }"#, MIRRORS, r#", "max_depth": 64"#);
    // A small stack, as a thread has it, and in a debug build: no overflow.
    let small = std::thread::Builder::new().stack_size(2 << 20);
    let tree = small.spawn(move || ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0])).unwrap().join().unwrap();
    let rays = chain(&tree.root);
    assert_eq!(tree.rays, 65);
    assert_eq!(rays.len(), 66);
    assert_eq!(rays[65].outcome, Outcome::MaxDepth);
    assert!(rays.iter().all(|ray| ray.weight == Some([1.0; 3])));
    assert_eq!(tree.color, [32.5; 3]);
}

#[test]
fn ideal_glass_doubles_at_every_level() {
    let objects: Vec<String> = (1..=20)
        .map(|z| {
            format!(r#"{{ "material": "m", "shape": {{ "plane": {{ "normal": [0, 0, 1], "distance": {z} }} }} }}"#)
        })
        .chain((1..=20).map(|z| {
            format!(r#"{{ "material": "m", "shape": {{ "plane": {{ "normal": [0, 0, 1], "distance": -{z} }} }} }}"#)
        }))
        .collect();
    let loaded = small_scene(
        r#""m": { "reflection": 1, "transmission": 1, "ior": 1 }"#,
        &objects.join(","),
        r#", "max_depth": 16, "background": [1, 1, 1]"#,
    );
    for (depth, rays) in [(0, 1), (1, 3), (5, 63), (8, 511), (10, 2047)] {
        let limits = Limits { max_depth: depth, ..loaded.scene.limits };
        let tracer = Tracer::<f64>::new(&loaded.scene, Options { limits, ..Options::of(&loaded.scene) }).unwrap();
        let ray = raytree::kernels::Ray { origin: [0.0, 0.0, 0.5].into(), direction: [0.0, 0.0, -1.0].into() };
        assert_eq!(tracer.ray(&ray, &Cost).unwrap().1.rays(), rays, "depth {depth}");
    }
    // 2^17 - 1 rays and 2^17 untraced children, on a small stack: made, printed, read back, dropped.
    let small = std::thread::Builder::new().stack_size(2 << 20);
    let work = move || {
        let tree = ray_tree(&loaded, [0.0, 0.0, 0.5], [0.0, 0.0, -1.0]);
        assert_eq!(tree.rays, (1 << 17) - 1);
        assert_eq!(tree.root.walk().count(), (1 << 18) - 1);
        assert_eq!(tree.to_text(Default::default()).lines().count(), 1 << 18);
        let again = raytree::tree::check::read_tree("tree.json", &tree.to_json()).unwrap();
        assert!(again == tree);
    };
    small.spawn(work).unwrap().join().unwrap();
}

#[test]
fn a_weight_at_the_cut_off_is_traced_and_one_below_is_not() {
    let more = format!(r#", "max_depth": 64, "min_weight": {}"#, 1.0 / 256.0);
    let loaded = small_scene(r#""m": { "reflection": 0.5 }"#, MIRRORS, &more);
    let tree = ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]);
    assert_eq!(tree.rays, 9);
    let last = chain(&tree.root)[9];
    assert_eq!((last.outcome, last.weight), (Outcome::BelowMinWeight, Some([1.0 / 512.0; 3])));
    // A weight that stays 1 is never cut off.
    let loaded = small_scene(r#""m": { "reflection": 1 }"#, MIRRORS, r#", "max_depth": 20, "min_weight": 1"#);
    assert_eq!(ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]).rays, 21);
    // Of a coloured weight the largest component counts.
    let loaded = small_scene(r#""m": { "reflection": [0, 0, 1] }"#, MIRRORS, r#", "max_depth": 20, "min_weight": 0.9"#);
    assert_eq!(ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]).rays, 21);
}

#[test]
fn the_light_cut_off_by_depth_is_bounded() {
    // Reflectivity r: what lies below level L brings at most r^(L+1) / (1 - r) of the brightest light.
    let color = |depth: u32| {
        let more = format!(r#", "max_depth": {depth}"#);
        let loaded = small_scene(r#""m": { "ambient": 1, "reflection": 0.5 }"#, MIRRORS, &more);
        ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]).color[0]
    };
    let (short, long) = (color(8), color(64));
    assert!(long > short && long - short <= 0.003_906_25, "{}", long - short);
}

#[test]
fn the_budget_counts_every_ray_of_the_pixel() {
    let light = r#", "lights": [{ "point": { "position": [0, 0, 0.5], "color": [1, 1, 1] } }], "max_depth": 64"#;
    let shadows = |tree: &RayNode| tree.walk().filter(|n| n.kind == Kind::Shadow && n.outcome.is_traced()).count();
    for budget in 1..12 {
        let more = format!(r#"{light}, "ray_budget": {budget}"#);
        let loaded = small_scene(r#""m": { "diffuse": 1, "reflection": 1 }"#, MIRRORS, &more);
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
fn shadow_rays_end_at_their_light() {
    let lit = |blocker: &str| {
        let objects = format!(
            r#"{{ "material": "m", "shape": {{ "plane": {{ "normal": [0, 1, 0], "distance": -1 }} }} }},
               {{ "material": "m", "shape": {{ "triangle": {{ "vertices": [{blocker}] }} }} }}"#
        );
        let light = r#", "lights": [{ "name": "lamp", "point": { "position": [0, 1, -1], "color": [1, 1, 1] } }]"#;
        let loaded = small_scene(r#""m": { "diffuse": 1 }"#, &objects, light);
        let tree = ray_tree(&loaded, [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]);
        let shadow = tree.root.shadows[0].clone();
        assert_eq!((shadow.t_max, shadow.origin), (Some(2.0), [0.0, -1.0, -1.0]));
        assert_eq!(tree.root.local.unwrap().lights[0].diffuse != [0.0; 3], shadow.outcome == Outcome::Lit);
        shadow.outcome
    };
    let at = |y: &str| format!("[-5, {y}, -5], [5, {y}, -5], [0, {y}, 5]");
    assert_eq!(lit(&at("0.5")), Outcome::Blocked);
    assert_eq!(lit(&at("1")), Outcome::Lit, "an occluder exactly at the light");
    assert_eq!(lit(&at("1.5")), Outcome::Lit, "an occluder beyond the light");
}

#[test]
fn a_light_on_the_surface_brings_nothing() {
    let light = r#", "lights": [{ "point": { "position": [0, 0, -1], "color": [1, 1, 1] } }]"#;
    let loaded = small_scene(r#""m": { "diffuse": 1, "specular": 1, "shininess": 5 }"#, MIRRORS, light);
    let tree = ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0]);
    assert_eq!((tree.color, tree.rays), ([0.0; 3], 1));
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
