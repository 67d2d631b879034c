//! The steps in a tree: in order, complete, with reasons, and replayable to the same bits.

use raytree::hits::{Bounds, SlabRay};
use raytree::kernels::{
    Aabb, Plane, Ray, Sphere, Triangle, box_explicit_zero_values, plane_values, sphere_values,
    triangle_moller_trumbore_values,
};
use raytree::scene::Shape;
use raytree::tree::{Keep, Outcome, ShapeRecord, TestRecord, Value, Verdict};

use crate::support::{scenes, small_scene, tracer, tree};

/// The intermediate values of a test, computed again from the scene and the ray that the tree prints.
fn replay(shape: &Shape, primitive: Option<u32>, ray: &Ray<f64>) -> Vec<(&'static str, f64)> {
    let of_triangle = |vertices| {
        let v = triangle_moller_trumbore_values(ray, &Triangle::<f64> { vertices });
        vec![("det", v.det), ("a", v.w), ("b", v.u), ("c", v.v), ("t", v.t)]
    };
    match shape {
        Shape::Sphere { center, radius } => {
            let v = sphere_values(ray, &Sphere { center: *center, radius: *radius });
            let roots = [("t_in", v.t_in), ("t_out", v.t_out)];
            [("a", v.a), ("b", v.b), ("c", v.c), ("l_dot_l", v.l_dot_l), ("disc", v.disc)]
                .into_iter()
                .chain(roots)
                .collect()
        }
        Shape::Plane { normal, distance } => {
            let v = plane_values(ray, &Plane { normal: *normal, distance: *distance });
            vec![("n_dot_d", v.n_dot_d), ("n_dot_o", v.n_dot_o), ("t", v.t)]
        }
        Shape::Box { min, max } => {
            let v = box_explicit_zero_values(ray, &Aabb { min: *min, max: *max });
            let faces = ["t_-x", "t_+x", "t_-y", "t_+y", "t_-z", "t_+z"].into_iter().zip(v.t);
            faces.chain([("t_in", v.t_in), ("t_out", v.t_out)]).collect()
        }
        Shape::Triangle { vertices } => of_triangle(*vertices),
        Shape::Mesh(mesh) => of_triangle(mesh.triangles[primitive.unwrap() as usize]),
    }
}

#[test]
fn every_step_replays_to_the_same_bits() {
    let mut replayed = 0;
    for (name, loaded) in scenes() {
        let tracer = tracer::<f64>(&loaded.scene);
        for (pixel, place) in &loaded.scene.pixels {
            // Through the JSON, as a reader of the tree would.
            let written = tree(&tracer, &loaded, *place, Keep::Steps).to_json();
            let tree = raytree::tree::check::read_tree("tree.json", &written).unwrap();
            for node in tree.root.walk().filter(|node| node.outcome.is_traced()) {
                let ray = Ray::<f64> { origin: node.origin.into(), direction: node.direction.into() };
                for test in node.tests.as_ref().unwrap() {
                    match test {
                        TestRecord::Bounds(test) => {
                            let (t_in, t_out) = SlabRay::new(&ray).span(&Bounds { min: test.min, max: test.max });
                            let finite = |t: f64| t.is_finite().then_some(t.to_bits());
                            let printed = [test.t_in, test.t_out].map(|t| t.map(f64::to_bits));
                            assert_eq!(printed, [finite(t_in), finite(t_out)], "{name}, {pixel}");
                            assert!(test.verdict != Verdict::Entered || t_in <= t_out);
                        }
                        TestRecord::Shape(test) if test.values.0.is_empty() => {
                            assert!(test.reason.is_some(), "{name}, {pixel}: a test without arithmetic says why");
                        }
                        TestRecord::Shape(test) => {
                            let shape = &loaded.scene.objects[test.shape as usize].shape;
                            let wanted = replay(shape, test.primitive, &ray).into_iter();
                            let wanted: Vec<_> =
                                wanted.filter(|(_, x)| x.is_finite()).map(|(n, x)| (n, x.to_bits())).collect();
                            let printed = test.values.0.iter().map(|(name, value)| match value {
                                Value::Number(x) => (name.as_str(), x.to_bits()),
                                Value::Vector(v) => panic!("{name}: {v:?}"),
                            });
                            assert_eq!(printed.collect::<Vec<_>>(), wanted, "{name}, {pixel}");
                            replayed += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(replayed > 500, "{replayed}");
}

#[test]
fn the_last_best_is_the_hit() {
    for (name, loaded) in scenes() {
        let tracer = tracer::<f64>(&loaded.scene);
        for (pixel, place) in &loaded.scene.pixels {
            for node in tree(&tracer, &loaded, *place, Keep::Steps).root.walk().filter(|n| n.outcome.is_traced()) {
                let best = node.tests.iter().flatten().rev().find_map(|test| match test {
                    TestRecord::Shape(test) if test.verdict == Verdict::Best => Some(test),
                    _ => None,
                });
                let hit = matches!(node.outcome, Outcome::Hit | Outcome::Blocked);
                assert_eq!(best.is_some(), hit, "{name}, {pixel}");
                if let (Some(best), Some(hit)) = (best, &node.hit) {
                    assert_eq!((best.shape, best.t), (hit.shape, Some(hit.t)), "{name}, {pixel}");
                }
            }
        }
    }
}

/// The shape test of a ray through an otherwise empty world.
fn only_test(shape: &str, origin: [f64; 3], direction: [f64; 3]) -> TestRecord {
    let loaded = small_scene(r#""m": {}"#, &format!(r#"{{ "material": "m", "shape": {shape} }}"#), "");
    let tracer = tracer::<f64>(&loaded.scene);
    let ray = Ray::<f64> { origin: origin.into(), direction: direction.into() };
    let origin = raytree::tree::Origin { loaded: &loaded, keep: Keep::Steps };
    let tree = raytree::tree::record_ray(&tracer, origin, &ray).unwrap();
    tree.root.tests.unwrap().last().unwrap().clone()
}

#[test]
fn every_reason_has_a_case() {
    let triangle = r#"{ "triangle": { "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]] } }"#;
    let tilted = r#"{ "triangle": { "vertices": [[0, 0, 0], [4, 0, 2], [0, 4, 2]] } }"#;
    let sphere = r#"{ "sphere": { "center": [0, 0, 0], "radius": 1 } }"#;
    let plane = r#"{ "plane": { "normal": [0, 0, 1], "distance": 0 } }"#;
    let aabb = r#"{ "box": { "min": [-1, -1, -1], "max": [1, 1, 1] } }"#;
    let up = [0.0, 0.0, 1.0];
    let reason = |shape: &str, origin, direction| match only_test(shape, origin, direction) {
        TestRecord::Bounds(test) => test.reason.unwrap_or_default(),
        TestRecord::Shape(test) => test.reason.unwrap_or_default(),
    };
    assert_eq!(reason(plane, [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]), "parallel");
    assert_eq!(reason(plane, [0.0, 0.0, 1.0], up), "behind");
    assert_eq!(reason(sphere, [0.9, 0.9, -5.0], up), "discriminant negative");
    assert_eq!(reason(sphere, [3.0, 0.0, -5.0], up), "pruned by its box");
    assert_eq!(reason(aabb, [3.0, 0.0, -5.0], up), "pruned by its box");
    assert_eq!(reason(tilted, [3.0, 3.0, -5.0], up), "a < 0");
    assert_eq!(reason(triangle, [1.0, 1.0, -5.0], up), "");
    // Against the letters of the tree: [a, b, 1-a-b] weigh v0, v1, v2.
    let slanted = r#"{ "triangle": { "vertices": [[0, 0, 0], [4, 1, 3], [1, 4, -3]] } }"#;
    assert_eq!(reason(slanted, [0.3, 3.5, -5.0], up), "b < 0");
    assert_eq!(reason(slanted, [3.5, 0.3, -5.0], up), "a + b > 1");
}

#[test]
fn a_record_knows_what_came_second() {
    let near = r#"{ "material": "m", "shape": { "plane": { "normal": [0, 0, 1], "distance": -1 } } }"#;
    let far = r#"{ "material": "m", "shape": { "plane": { "normal": [0, 0, 1], "distance": -2 } } }"#;
    let loaded = small_scene(r#""m": { "reflection": 1 }"#, &format!("{near}, {far}"), "");
    let tree = tree(&tracer::<f64>(&loaded.scene), &loaded, [1, 1], Keep::Steps);
    let reasons = |tests: &Option<Vec<TestRecord>>| -> Vec<(Verdict, Option<String>)> {
        let shape = |test: &TestRecord| match test {
            TestRecord::Shape(ShapeRecord { verdict, reason, .. }) => Some((*verdict, reason.clone())),
            TestRecord::Bounds(_) => None,
        };
        tests.iter().flatten().filter_map(shape).collect()
    };
    let rejected = |why: &str| (Verdict::Rejected, Some(why.to_owned()));
    assert_eq!(reasons(&tree.root.tests), [(Verdict::Best, None), rejected("farther than the best")]);
    let back = tree.root.reflected.unwrap();
    assert_eq!(reasons(&back.tests), [rejected("the ray starts on it"), rejected("behind")]);
}
