//! Rows H: bad input is refused with its place, and never becomes a wrong verdict.

use raytree::accuracy::leaks::bumpy_sphere;
use raytree::hits::{Acceleration, Count, Departure, Limit};
use raytree::input::Problem;
use raytree::kernels::{InvalidRay, Ray};
use raytree::numbers::{Real, Vector3};
use raytree::scene::{self, Loaded, Numerics};
use raytree::tree::Cost;

use crate::support::{tracer, tracer_with};

/// Every kind of object, light, material and background.
const EVERYTHING: &str = r#"{
  "image": { "width": 8, "height": 6 },
  "camera": { "eye": [0.5, 0.25, 5.5], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 40 },
  "background": { "gradient": { "bottom": [0.5, 0.25, 0.125], "top": [1, 1, 1] } },
  "max_depth": 3, "min_weight": 0.0625, "ray_budget": 500,
  "lights": [
    { "point": { "position": [0, 5, 5], "color": [1, 1, 1] } },
    { "directional": { "direction": [0, -1, 0.5], "color": [0.5, 1, 0.5] } }
  ],
  "materials": {
    "matte": { "color": [1, 0, 0], "ambient": 0.5, "diffuse": 0.75, "specular": [1, 0.5, 0.25], "shininess": 20 },
    "glass": { "transmission": 0.75, "reflection": 0.5, "ior": 1.5, "fresnel": "exact" },
    "board": { "checker": { "colors": [[0, 0, 0], [1, 1, 1]], "size": 0.5 }, "diffuse": 1 }
  },
  "objects": [
    { "material": "matte", "shape": { "sphere": { "center": [0, 0.25, 0], "radius": 0.75 } } },
    { "material": "board", "shape": { "plane": { "normal": [0, 1, 0.25], "distance": -2.5 } } },
    { "material": "glass", "shape": { "box": { "min": [-2, -1.5, -0.75], "max": [-1.25, 0.5, 1] } } },
    { "material": "matte", "shape": { "triangle": { "vertices": [[1, 0, 0], [2, 0.25, 0], [1, 2.5, -0.5]] } } },
    { "material": "glass", "shape": { "mesh": { "file": "mesh.obj", "transform":
        { "scale": 0.5, "rotate": { "axis": [0, 1, 0.5], "degrees": 30 }, "translate": [1.5, -1, 0.5] } } } }
  ],
  "pixels": { "middle": [4, 3] }
}"#;

const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn load_with(text: &str, mesh: &str) -> Result<Loaded, Problem> {
    scene::load("scene.json", text, &mut |_| Ok(mesh.as_bytes().to_vec()))
}

fn load(text: &str) -> Result<Loaded, Problem> {
    load_with(text, TETRAHEDRON)
}

/// Where a number stands in `text`: outside of quotes, as long as it goes.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut places: Vec<std::ops::Range<usize>> = Vec::new();
    let mut quoted = false;
    for (i, c) in text.char_indices() {
        quoted ^= c == '"';
        if !quoted && (c.is_ascii_digit() || c == '-' || c == '.') {
            match places.last_mut() {
                Some(place) if place.end == i => place.end = i + 1,
                _ => places.push(i..i + 1),
            }
        }
    }
    places
}

/// Refused, and the place that is named lies within this part of the text.
fn is_refused(text: &str) -> Problem {
    match load(text) {
        Ok(_) => panic!("this should be refused: {text}"),
        Err(problem) => {
            assert!(!problem.message.is_empty() && !problem.help.is_empty(), "{problem}");
            assert!(problem.place.is_some(), "{problem}");
            problem
        }
    }
}

/// Refused with exactly the value `bad` underlined, which stands in for `good`.
fn underlines(good: &str, to: &str, bad: &str) {
    assert!(EVERYTHING.contains(good), "{good}");
    let place = is_refused(&EVERYTHING.replacen(good, to, 1)).place.unwrap();
    assert_eq!(&place.text[place.span], bad, "{to}");
}

/// Accepted, and its pixels are finite.
fn is_fine<R: Real>(good: &str, to: &str) {
    assert!(EVERYTHING.contains(good), "{good}");
    let loaded = load(&EVERYTHING.replacen(good, to, 1)).unwrap_or_else(|problem| panic!("{to}: {problem}"));
    let tracer = tracer::<R>(&loaded.scene);
    for (x, y) in (0..6).flat_map(|y| (0..8).map(move |x| (x, y))) {
        assert!(tracer.pixel_color(x, y).is_finite(), "{to} at {x},{y}");
    }
}

#[test]
fn h01_nan_or_infinity_anywhere() {
    is_fine::<f64>("0.75", "0.75");
    is_fine::<f32>("0.75", "0.75");
    let places = numbers(EVERYTHING);
    assert!(places.len() > 80, "{}", places.len());
    for place in places {
        for bad in ["NaN", "Infinity", "-Infinity", "1e999", "-1e999", "null", "\"nan\""] {
            let mut text = EVERYTHING.to_owned();
            text.replace_range(place.clone(), bad);
            is_refused(&text);
        }
    }
    for (line, bad) in [("v 1 0 0", "v 1 nan 0"), ("v 1 0 0", "v inf 0 0"), ("v 1 0 0", "v 1 0 -1e999")] {
        assert!(load_with(EVERYTHING, &TETRAHEDRON.replacen(line, bad, 1)).is_err(), "{bad}");
    }
}

#[test]
fn h02_directions_of_no_length() {
    // The squares of the last two underflow; 2^-140 is a stored number, but too short for a direction.
    let tiny = 1.0 / (1_u128 << 70) as f64 / (1_u128 << 70) as f64;
    let bad = [
        "[0, 0, 0]".to_owned(),
        "[0, -0, 0]".to_owned(),
        format!("[0, {tiny:e}, 0]"),
        format!("[{tiny:e}, 0, {tiny:e}]"),
    ];
    for bad in bad {
        underlines("\"normal\": [0, 1, 0.25]", &format!("\"normal\": {bad}"), &bad);
        underlines("\"direction\": [0, -1, 0.5]", &format!("\"direction\": {bad}"), &bad);
        underlines("\"up\": [0, 1, 0]", &format!("\"up\": {bad}"), &bad);
    }
    is_refused(&EVERYTHING.replacen("\"axis\": [0, 1, 0.5]", "\"axis\": [0, 0, 0]", 1));
    underlines("\"look_at\": [0, 0, 0]", "\"look_at\": [0.5, 0.25, 5.5]", "[0.5, 0.25, 5.5]");
    // A denormal in f64, finer than exact arithmetic goes.
    underlines("\"normal\": [0, 1, 0.25]", "\"normal\": [0, 4.9e-324, 0]", "4.9e-324");
    // Short, but of a length: the squares of these do not underflow in f64, and the scene is stored with length 1.
    is_fine::<f32>("\"normal\": [0, 1, 0.25]", "\"normal\": [0, 1e-30, 0]");
    is_fine::<f64>("\"direction\": [0, -1, 0.5]", "\"direction\": [0, -1e-37, 0]");
}

#[test]
fn h03_radii_and_indices_of_refraction() {
    for bad in ["-1", "-0.75", "-1e-30"] {
        underlines("\"radius\": 0.75", &format!("\"radius\": {bad}"), bad);
    }
    for bad in ["0", "-0", "-1.5", "-1e-9", "1e-300"] {
        underlines("\"ior\": 1.5", &format!("\"ior\": {bad}"), bad);
    }
    // A point.
    is_fine::<f64>("\"radius\": 0.75", "\"radius\": 0");
    is_fine::<f32>("\"radius\": 0.75", "\"radius\": -0");
}

#[test]
fn h04_meshes_and_boxes_that_are_none() {
    let refused = |mesh: &str| load_with(EVERYTHING, mesh).unwrap_err();
    for face in ["f 1 2 7", "f 1 2 0", "f 1 2 -5", "f 1 2 99999999999999999999"] {
        let problem = refused(&TETRAHEDRON.replacen("f 1 3 2", face, 1));
        let place = problem.place.unwrap();
        assert_eq!((place.text.as_str(), &place.text[place.span]), (face, face.rsplit(' ').next().unwrap()));
    }
    for empty in ["", "# nothing\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"] {
        assert!(!refused(empty).help.is_empty());
    }
    for (axis, min) in [("x", "[2, -1.5, -0.75]"), ("y", "[-2, 0.75, -0.75]"), ("z", "[-2, -1.5, 1.5]")] {
        let problem = is_refused(&EVERYTHING.replacen("\"min\": [-2, -1.5, -0.75]", &format!("\"min\": {min}"), 1));
        assert!(problem.message.contains(&format!("along {axis}")), "{problem}");
    }
    // No thickness is no fault.
    is_fine::<f64>("\"min\": [-2, -1.5, -0.75]", "\"min\": [-1.25, -1.5, -0.75]");
}

/// A long way to walk: a room of 2352 triangles, with the eye inside.
fn big_room() -> scene::Scene {
    let mut loaded = load(EVERYTHING).unwrap();
    let triangles = bumpy_sphere(14);
    let room = scene::Mesh { triangles, corner_normals: None, closed: true };
    loaded.scene.objects[4].shape = scene::Shape::Mesh(room);
    loaded.scene
}

fn invalid_rays_are_told<R: Real>() {
    let scene = big_room();
    let good = [0.25, -0.5, 0.75];
    for acceleration in [Acceleration::List, Acceleration::Bvh] {
        for numerics in [Numerics::Lecture, Numerics::Robust, Numerics::Certified] {
            let tracer = tracer_with::<R>(&scene, numerics, acceleration);
            let asked = |origin: [f64; 3], direction: [f64; 3]| {
                let ray = Ray::<R> { origin: R::Vec3::from_f64(origin), direction: R::Vec3::from_f64(direction) };
                let mut walked = Count(0);
                let nearest = tracer.world().nearest(&ray, Limit::None, Departure::default(), &mut walked);
                let told = nearest.map(|_| ());
                assert_eq!(tracer.world().is_hit(&ray, Limit::None, Departure::default()).map(|_| ()), told);
                assert_eq!(tracer.flight(ray).map(|_| ()), told);
                assert_eq!(tracer.ray(&ray, &Cost).map(|_| ()), told);
                (told, walked.0)
            };
            let (told, walked) = asked([0.0; 3], good);
            assert!(told == Ok(()) && walked > 10, "{told:?}, {walked} tests");
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                for k in 0..3 {
                    let mut spoilt = good;
                    spoilt[k] = bad;
                    assert_eq!(asked(spoilt, good), (Err(InvalidRay::NotFinite), 0));
                    assert_eq!(asked(good, spoilt), (Err(InvalidRay::NotFinite), 0));
                }
            }
            for zero in [[0.0; 3], [-0.0, 0.0, -0.0]] {
                assert_eq!(asked(good, zero), (Err(InvalidRay::ZeroDirection), 0));
            }
        }
    }
}

#[test]
fn h05_rays_that_are_none_walk_nothing() {
    invalid_rays_are_told::<f64>();
    invalid_rays_are_told::<f32>();
}

/// The largest coordinate is 2^128, the finest a multiple of 2^-178.
#[test]
fn h06_coordinates_beyond_exact_arithmetic() {
    let power = |n: i32| if n < 0 { 1.0 / 2.0_f64.powi(-n) } else { 2.0_f64.powi(n) };
    let places = [
        "\"center\": [0, 0.25, 0]",
        "\"position\": [0, 5, 5]",
        "\"eye\": [0.5, 0.25, 5.5]",
        "\"vertices\": [[1, 0, 0]",
        "\"min\": [-2, -1.5, -0.75]",
    ];
    for good in places {
        let (key, vector) = good.split_once(": ").unwrap();
        let with = |x: f64| {
            let last = vector.rsplit(',').next().unwrap();
            format!("{key}: {}, {x:e}]", vector.strip_suffix(&format!(",{last}")).unwrap())
        };
        let next_up = f64::from_bits(power(128).to_bits() + 1);
        for bad in [
            next_up,
            -next_up,
            power(129),
            power(-179),
            3.0 * power(-179),
            -f64::from_bits(1),
            power(-130) + power(-180),
        ] {
            underlines(good, &with(bad), &format!("{bad:e}"));
        }
        for fine in [power(-178), power(-149), power(-130) + power(-178)] {
            is_fine::<f64>(good, &with(if key == "\"min\"" { -fine } else { fine }));
        }
    }
    for bad in [power(129), -power(128) * 1.5, power(-179)] {
        underlines("\"distance\": -2.5", &format!("\"distance\": {bad:e}"), &format!("{bad:e}"));
        let mesh = TETRAHEDRON.replacen("v 1 0 0", &format!("v {bad:e} 0 0"), 1);
        assert!(load_with(EVERYTHING, &mesh).is_err(), "{bad:e}");
    }
    underlines("\"radius\": 0.75", &format!("\"radius\": {:e}", power(129)), &format!("{:e}", power(129)));
    // At the bound itself every verdict still holds, and no pixel is NaN.
    is_fine::<f64>("\"center\": [0, 0.25, 0]", &format!("\"center\": [0, 0.25, {:e}]", power(128)));
    is_fine::<f64>("\"radius\": 0.75", &format!("\"radius\": {:e}", power(128)));
    is_fine::<f64>("\"distance\": -2.5", &format!("\"distance\": {:e}", -power(128)));
}
