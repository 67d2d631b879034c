//! Rows E18 to E20: seams and ties, where two shapes are met in one place.

use glam::DVec3;
use raytree::hits::{Acceleration, Departure, Limit};
use raytree::kernels::Ray;
use raytree::numbers::Real;
use raytree::scene::{self, Loaded, Numerics, ObjectId};
use raytree::tree::{Keep, Outcome};

use crate::support::{grid, small_scene, tracer, tracer_with, tree};

const MATTE: &str = r#""m": { "diffuse": 1 }"#;

/// Objects that are each the unit square over x and z in the plane y = x / 4 + z / 8: `one` cut along a diagonal, `other`
/// into four triangles. All numbers are exact.
fn quads(materials: &str, objects: &[(&str, &str)], more: &str) -> Loaded {
    let corners = "v 0 0 0\nv 1 0.25 0\nv 1 0.375 1\nv 0 0.125 1\n";
    let object = |(name, material): &(&str, &str)| {
        format!(r#"{{ "material": "{material}", "shape": {{ "mesh": {{ "file": "{name}.obj" }} }} }}"#)
    };
    let text = format!(
        r#"{{ "image": {{ "width": 120, "height": 90 }},
              "camera": {{ "eye": [0.3, 1.7, 0.9], "look_at": [0.5, 0.1875, 0.5], "up": [0, 0, -1], "fov_y_degrees": 50 }},
              "materials": {{ {materials} }}, "objects": [ {} ] {more} }}"#,
        objects.iter().map(object).collect::<Vec<_>>().join(",")
    );
    let mesh = |name: &str| {
        let faces = match name.starts_with("one") {
            true => "f 1 4 3\nf 1 3 2\n",
            // Around a point inside.
            false => "v 0.375 0.171875 0.625\nf 1 4 5\nf 4 3 5\nf 3 2 5\nf 2 1 5\n",
        };
        Ok(format!("{corners}{faces}").into_bytes())
    };
    scene::load("quads.json", &text, &mut { mesh }).unwrap_or_else(|problem| panic!("{problem}"))
}

fn shadow_rays_over_a_seam<R: Real>() {
    // Light that comes in along the surface, a hair above it.
    let light = r#", "lights": [{ "directional": { "direction": [-64, -16.07, -0.5], "color": [1, 1, 1] } }]"#;
    let loaded = quads(MATTE, &[("one", "m")], light);
    let tracer = tracer::<R>(&loaded.scene);
    let mut both = [0, 0];
    for [x, y] in grid(&loaded.scene, 10_000) {
        let tree = tree(&tracer, &loaded, [x, y], Keep::Outcomes);
        let Some(hit) = tree.root.hit else { continue };
        both[hit.primitive.unwrap() as usize] += 1;
        assert_eq!(tree.root.shadows[0].outcome, Outcome::Lit, "{:?} at {x},{y}", R::PRECISION);
    }
    assert!(both.iter().all(|count| *count > 500), "{both:?}");
}

#[test]
fn e18_coplanar_triangles_do_not_shadow_each_other() {
    shadow_rays_over_a_seam::<f64>();
    shadow_rays_over_a_seam::<f32>();
}

#[test]
fn e19_two_balls_that_touch_in_one_point() {
    let ball =
        |x: i32| format!(r#"{{ "material": "m", "shape": {{ "sphere": {{ "center": [{x}, 0, 0], "radius": 1 }} }} }}"#);
    for objects in [[ball(0), ball(2)], [ball(2), ball(0)]] {
        let loaded = small_scene(MATTE, &objects.join(","), "");
        let ray = Ray { origin: DVec3::new(1.0, 5.0, 0.0), direction: -DVec3::Y };
        for acceleration in [Acceleration::List, Acceleration::Bvh] {
            let tracer = tracer_with::<f64>(&loaded.scene, Numerics::Certified, acceleration);
            let hit = tracer.world().nearest(&ray, Limit::None, Departure::default(), &mut ()).unwrap().unwrap();
            assert_eq!((hit.nearest.object, hit.nearest.t), (ObjectId(0), 5.0));
            assert_eq!(hit.tied.iter().map(|tied| (tied.object, tied.t)).collect::<Vec<_>>(), [(ObjectId(1), 5.0)]);
        }
    }
}

#[test]
fn e20_of_coincident_quads_the_first_is_seen() {
    let materials = r#""red": { "color": [1, 0, 0], "ambient": 1 }, "blue": { "color": [0, 0, 1], "ambient": 1 }"#;
    let mut fought = 0;
    for [first, second] in [["red", "blue"], ["blue", "red"]] {
        for cuts in [["one", "other"], ["other", "one"], ["one", "one too"]] {
            let loaded = quads(materials, &[(cuts[0], first), (cuts[1], second)], "");
            // How many pixels show each colour.
            let seen = |numerics, acceleration| {
                let tracer = tracer_with::<f64>(&loaded.scene, numerics, acceleration);
                let mut seen = [0, 0];
                for [x, y] in grid(&loaded.scene, 120 * 90) {
                    let color = tracer.pixel_color(x, y);
                    seen[0] += u32::from(color.x == 1.0);
                    seen[1] += u32::from(color.z == 1.0);
                }
                if first == "blue" { [seen[1], seen[0]] } else { seen }
            };
            for acceleration in [Acceleration::List, Acceleration::Bvh] {
                let [wanted, unwanted] = seen(Numerics::Certified, acceleration);
                assert!(wanted > 1000 && unwanted == 0, "{wanted} {unwanted}");
            }
            fought += seen(Numerics::Lecture, Acceleration::Bvh)[1];
        }
    }
    println!("coincident quads: the lecture's arithmetic shows the second in {fought} pixels");
    assert!(fought > 100, "{fought}");
}
