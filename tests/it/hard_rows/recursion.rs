//! Rows G: the recursion and its tree.

use raytree::hits::Acceleration;
use raytree::kernels::Ray;
use raytree::scene::{Limits, Loaded, Numerics, load};
use raytree::transport::{Options, Tracer};
use raytree::tree::{Cost, Costs, Keep, Kind, Outcome, RayNode, RayTree};

use crate::support::{
    FACING_MIRRORS, bits, grid, picture, ray_tree, scenes, small_scene, smaller, tracer, tracer_with, tree,
};

/// The tree of a ray from between the mirrors to one of them.
fn between_mirrors(material: &str, more: &str) -> RayTree {
    let loaded = small_scene(&format!(r#""m": {{ {material} }}"#), FACING_MIRRORS, more);
    ray_tree(&loaded, [0.0; 3], [0.0, 0.0, -1.0])
}

/// A ray and what was reflected of it, again and again.
fn chain(root: &RayNode) -> Vec<&RayNode> {
    std::iter::successors(Some(root), |node| node.reflected.as_deref()).collect()
}

/// Runs `work` on a stack as small as a thread's.
fn on_a_small_stack<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> T {
    std::thread::Builder::new().stack_size(2 << 20).spawn(work).unwrap().join().unwrap()
}

#[test]
fn g01_level_zero_is_one_ray() {
    let tree = between_mirrors(r#""ambient": 1, "reflection": 0.5"#, r#", "max_depth": 0"#);
    assert_eq!((tree.rays, tree.color), (1, [1.0; 3]));
    let child = tree.root.reflected.unwrap();
    assert_eq!((child.outcome, child.depth, child.radiance), (Outcome::MaxDepth, 1, Some([0.0; 3])));
    assert!(child.ior.is_none() && child.hit.is_none() && child.reflected.is_none());
    // Lights are still asked.
    let lights = r#", "max_depth": 0, "lights": [
        { "point": { "position": [0, 0, 0.5], "color": [1, 1, 1] } },
        { "directional": { "direction": [0, 0, -1], "color": [1, 1, 1] } }]"#;
    let tree = between_mirrors(r#""diffuse": 1, "reflection": 0.5, "transmission": 0.5, "ior": 1.5"#, lights);
    let traced = tree.root.walk().filter(|node| node.outcome.is_traced());
    assert_eq!(traced.map(|node| node.kind).collect::<Vec<_>>(), [Kind::Camera, Kind::Shadow, Kind::Shadow]);
    assert_eq!(tree.rays, 3);
}

#[test]
fn g02_ideal_glass_doubles_at_every_level() {
    let pane = |z: i32| {
        format!(r#"{{ "material": "m", "shape": {{ "plane": {{ "normal": [0, 0, 1], "distance": {z} }} }} }}"#)
    };
    let panes: Vec<String> = (1..=20).flat_map(|z| [pane(z), pane(-z)]).collect();
    let loaded = small_scene(
        r#""m": { "reflection": 1, "transmission": 1, "ior": 1 }"#,
        &panes.join(","),
        r#", "max_depth": 16, "background": [1, 1, 1]"#,
    );
    for (depth, rays) in [(0, 1), (1, 3), (5, 63), (8, 511), (10, 2047), (16, 131_071)] {
        let limits = Limits { max_depth: depth, ..loaded.scene.limits };
        let tracer = Tracer::<f64>::new(&loaded.scene, Options { limits, ..Options::of(&loaded.scene) }).unwrap();
        let ray = Ray { origin: [0.0, 0.0, 0.5].into(), direction: [0.0, 0.0, -1.0].into() };
        assert_eq!(tracer.ray(&ray, &Cost).unwrap().1.rays(), rays, "depth {depth}");
    }
    // 2^17 - 1 rays and 2^17 untraced children: made, printed, read back, dropped.
    on_a_small_stack(move || {
        let tree = ray_tree(&loaded, [0.0, 0.0, 0.5], [0.0, 0.0, -1.0]);
        assert_eq!(tree.rays, (1 << 17) - 1);
        assert_eq!(tree.root.walk().count(), (1 << 18) - 1);
        assert_eq!(tree.to_text(Default::default()).lines().count(), 1 << 18);
        let again = raytree::tree::check::read_tree("tree.json", &tree.to_json()).unwrap();
        assert!(again == tree);
    });
}

#[test]
fn g03_facing_mirrors_at_depth_64() {
    let mirrors = |depth: u32| (r#""ambient": 0.5, "reflection": 1"#, format!(r#", "max_depth": {depth}"#));
    let tree = on_a_small_stack(move || {
        let (material, more) = mirrors(64);
        between_mirrors(material, &more)
    });
    let rays = chain(&tree.root);
    assert_eq!((tree.rays, rays.len()), (65, 66));
    assert_eq!(rays[65].outcome, Outcome::MaxDepth);
    assert_eq!(tree.color, [32.5; 3]);
    // One level more is refused, by name.
    let text = r#"{ "image": { "width": 1, "height": 1 }, "max_depth": 65,
        "camera": { "eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov_y_degrees": 60 },
        "materials": {}, "objects": [] }"#;
    let problem = load("deep.json", text, &mut |_| Err(String::new())).unwrap_err();
    assert_eq!(problem.message, "a depth of 65 is too deep");
    assert!(problem.help.contains("0 to 64"), "{}", problem.help);
}

#[test]
fn g04_a_weight_at_the_cut_off_is_traced_and_one_below_is_not() {
    let more = format!(r#", "max_depth": 64, "min_weight": {}"#, 1.0 / 256.0);
    let tree = between_mirrors(r#""reflection": 0.5"#, &more);
    assert_eq!(tree.rays, 9);
    let rays = chain(&tree.root);
    assert_eq!((rays[8].outcome, rays[8].weight), (Outcome::Hit, Some([1.0 / 256.0; 3])));
    assert_eq!((rays[9].outcome, rays[9].weight), (Outcome::BelowMinWeight, Some([1.0 / 512.0; 3])));
}

#[test]
fn g05_a_weight_that_stays_one_is_never_cut_off() {
    for least in ["0", "0.00390625", "0.5", "1"] {
        let more = format!(r#", "max_depth": 20, "min_weight": {least}"#);
        let tree = between_mirrors(r#""reflection": 1"#, &more);
        assert_eq!(tree.rays, 21, "min_weight {least}");
        assert!(chain(&tree.root).iter().all(|ray| ray.weight == Some([1.0; 3])), "min_weight {least}");
    }
}

/// Reflectivity r: what lies below level L brings at most `r^(L+1) / (1 - r)` of the brightest light, here 1.
#[test]
fn g06_the_light_cut_off_by_depth_is_bounded() {
    let room = r#"
        { "material": "m", "shape": { "box": { "min": [-3, -2, -5], "max": [2, 4, 3] } } },
        { "material": "m", "shape": { "sphere": { "center": [0.5, -0.5, -3], "radius": 1 } } },
        { "material": "m", "shape": { "sphere": { "center": [-1.5, 0.5, -2], "radius": 0.75 } } }"#;
    let at_depth = |depth: u32| {
        let loaded = small_scene(
            r#""m": { "ambient": 1, "reflection": 0.5, "color": [1, 0.5, 0] }"#,
            room,
            &format!(r#", "max_depth": {depth}"#),
        );
        let mut scene = loaded.scene;
        (scene.image.width, scene.image.height) = (32, 24);
        picture(&tracer::<f64>(&scene), 2).pixels
    };
    let (short, long) = (at_depth(8), at_depth(64));
    for (short, long) in short.into_iter().zip(long) {
        let lost = long - short;
        assert!(lost.x > 0.0 && lost.max_element() <= 0.003_906_25, "{lost}");
    }
    let color = |depth: u32| {
        between_mirrors(r#""ambient": 1, "reflection": 0.5"#, &format!(r#", "max_depth": {depth}"#)).color[0]
    };
    assert_eq!((color(8), color(64)), (2.0 - 1.0 / 256.0, 2.0));
}

#[test]
fn g07_shadow_rays_end_at_their_light() {
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
    assert_eq!(lit(&at("0.9999999999999999")), Outcome::Blocked, "an ulp before the light");
    assert_eq!(lit(&at("1")), Outcome::Lit, "an occluder exactly at the light");
    assert_eq!(lit(&at("1.5")), Outcome::Lit, "an occluder beyond the light");
    assert_eq!(lit(&at("-1")), Outcome::Lit, "at distance 0 it is the surface itself");
}

#[test]
fn g08_a_light_on_the_surface_brings_nothing() {
    let light = r#", "lights": [{ "point": { "position": [0, 0, -1], "color": [1, 1, 1] } }]"#;
    let tree = between_mirrors(r#""diffuse": 1, "specular": 1, "shininess": 5"#, light);
    assert_eq!((tree.color, tree.rays), ([0.0; 3], 1));
    // Where the hit is only as good as on the light, nothing is NaN either.
    let ball = r#"{ "material": "m", "shape": { "sphere": { "center": [0, 0, -3], "radius": 1 } } }"#;
    let light = r#", "lights": [{ "point": { "position": [0.6, 0, -2.2], "color": [1, 1, 1] } }]"#;
    let loaded = small_scene(r#""m": { "diffuse": 1, "specular": 1, "shininess": 5 }"#, ball, light);
    for aim in [0.6, 0.600_000_000_000_000_1, 0.599_999_999_999_999_9] {
        assert!(ray_tree(&loaded, [0.0; 3], [aim, 0.0, -2.2]).color.iter().all(|x| x.is_finite() && *x >= 0.0));
    }
}

/// What rays of each kind a scene takes, over all its pixels.
fn costs(loaded: &Loaded) -> Costs {
    let tracer = tracer::<f64>(&loaded.scene);
    let mut costs = Costs::default();
    for [x, y] in grid(&loaded.scene, 1000) {
        costs += tracer.pixel(x, y, &Cost).1;
    }
    costs
}

#[test]
fn g09_what_is_not_in_the_scene_costs_no_ray() {
    let ball = r#"{ "material": "m", "shape": { "sphere": { "center": [0, 0, -3], "radius": 1.5 } } }"#;
    let lamp = r#", "lights": [{ "point": { "position": [0, 5, 5], "color": [1, 1, 1] } }]"#;
    let rays = |material: &str, more: &str| {
        let costs = costs(&small_scene(&format!(r#""m": {{ {material} }}"#), ball, more));
        assert_eq!(costs.camera, 12);
        [costs.shadow, costs.reflected, costs.refracted].map(|count| count > 0)
    };
    let matte = r#""ambient": 1, "diffuse": 1, "specular": 1, "shininess": 9"#;
    assert_eq!(rays(matte, ""), [false, false, false], "no light, no mirror, no glass");
    assert_eq!(rays(matte, lamp), [true, false, false], "a light alone");
    assert_eq!(rays(r#""reflection": 1"#, lamp), [false, true, false], "a mirror, and a light that it does not show");
    assert_eq!(rays(r#""transmission": 1, "ior": 1"#, lamp), [false, false, true], "glass without reflection");
    assert_eq!(
        rays(r#""reflection": 0, "transmission": 0, "ior": 1.5"#, lamp),
        [false, false, false],
        "weights of zero"
    );
}

/// Takes the shapes of a tree back to the order that the objects had before they were reversed.
fn turn(node: &mut RayNode, objects: u32) {
    if let Some(hit) = &mut node.hit {
        hit.shape = objects - 1 - hit.shape;
    }
    let children = node.shadows.iter_mut().chain(node.reflected.as_deref_mut()).chain(node.refracted.as_deref_mut());
    for child in children {
        turn(child, objects);
    }
}

#[test]
fn g10_order_of_objects_threads_and_hierarchy_leave_every_bit() {
    // Scenes without exact ties and without overlapping solids.
    let apart =
        ["first-hit", "sphere", "shadow", "mirror", "whitted", "mesh", "glass-ball", "shadows-of-several-lights"];
    let mut seen = 0;
    for (name, loaded) in scenes().into_iter().filter(|(name, _)| apart.contains(&name.as_str())) {
        let mut turned = loaded.clone();
        turned.scene.objects.reverse();
        let (a, b) = (tracer::<f64>(&loaded.scene), tracer::<f64>(&turned.scene));
        let named = loaded.scene.pixels.iter().map(|(_, pixel)| *pixel);
        for pixel in named.chain(grid(&loaded.scene, 200)) {
            let before = tree(&a, &loaded, pixel, Keep::Outcomes);
            let mut after = tree(&b, &turned, pixel, Keep::Outcomes);
            turn(&mut after.root, loaded.scene.objects.len() as u32);
            assert_eq!(before, after, "{name} at {pixel:?}");
        }
        let (loaded, turned) = (smaller(loaded, 20), smaller(turned, 20));
        let plain = bits(&picture(&tracer::<f64>(&loaded.scene), 1));
        for threads in 1..=8 {
            for scene in [&loaded.scene, &turned.scene] {
                assert!(plain == bits(&picture(&tracer::<f64>(scene), threads)), "{name} on {threads} threads");
            }
        }
        for scene in [&loaded.scene, &turned.scene] {
            let list = tracer_with::<f64>(scene, Numerics::Certified, Acceleration::List);
            assert!(plain == bits(&picture(&list, 2)), "{name} without a hierarchy");
        }
        seen += 1;
    }
    assert_eq!(seen, apart.len());
}
