//! Same bytes: for any recorder, thread count, way to find hits, and order of objects; in debug and release.

use std::sync::atomic::AtomicBool;

use raytree::hits::Acceleration;
use raytree::numbers::Real;
use raytree::pictures::{Film, Format, render};
use raytree::scene::{Loaded, Numerics, Scene};
use raytree::transport::Tracer;
use raytree::tree::{Cost, Keep, RayNode};
use sha2::{Digest, Sha256};

use crate::support::{grid, scene, scenes, tracer, tracer_with, tree};

const SETS: [Numerics; 3] = [Numerics::Lecture, Numerics::Robust, Numerics::Certified];

/// The scene with an image of at most about 64 x 64 pixels.
fn small(mut loaded: Loaded) -> Loaded {
    let image = &mut loaded.scene.image;
    let factor = image.width.max(image.height).div_ceil(64);
    (image.width, image.height) = (image.width.div_ceil(factor), image.height.div_ceil(factor));
    loaded
}

fn picture<R: Real>(tracer: &Tracer<'_, R>, threads: usize) -> Film {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| render(tracer, &|| {}, &AtomicBool::new(false)).unwrap())
}

fn bits(film: &Film) -> Vec<[u64; 3]> {
    film.pixels.iter().map(|rgb| rgb.to_array().map(f64::to_bits)).collect()
}

#[test]
fn no_picture_depends_on_threads() {
    for (name, loaded) in scenes() {
        let loaded = small(loaded);
        let tracer = tracer::<f64>(&loaded.scene);
        let one = bits(&picture(&tracer, 1));
        for threads in [2, 3, 8] {
            assert!(one == bits(&picture(&tracer, threads)), "{name} on {threads} threads");
        }
    }
}

#[test]
fn no_picture_depends_on_how_hits_are_found() {
    for (name, loaded) in scenes() {
        let loaded = small(loaded);
        for numerics in SETS {
            same_picture::<f32>(&name, &loaded.scene, numerics);
            same_picture::<f64>(&name, &loaded.scene, numerics);
        }
    }
}

fn same_picture<R: Real>(name: &str, scene: &Scene, numerics: Numerics) {
    let triangles: usize = scene
        .objects
        .iter()
        .map(|object| match &object.shape {
            raytree::scene::Shape::Mesh(mesh) => mesh.triangles.len(),
            _ => 1,
        })
        .sum();
    let (list, bvh) = (Acceleration::List, Acceleration::Bvh);
    let (list, bvh) = (tracer_with::<R>(scene, numerics, list), tracer_with::<R>(scene, numerics, bvh));
    // The list is the oracle, and slow where there are many triangles.
    for [x, y] in grid(scene, if triangles > 100 { 60 } else { 4096 }) {
        let (a, b) = (list.pixel_color(x, y).to_array(), bvh.pixel_color(x, y).to_array());
        assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits), "{name} at {x},{y} with {numerics} {:?}", R::PRECISION);
    }
}

#[test]
fn no_tree_depends_on_how_hits_are_found() {
    for (name, loaded) in scenes() {
        for numerics in SETS {
            let list = tracer_with::<f64>(&loaded.scene, numerics, Acceleration::List);
            let bvh = tracer_with::<f64>(&loaded.scene, numerics, Acceleration::Bvh);
            for (pixel, place) in &loaded.scene.pixels {
                let [a, b] = [&list, &bvh].map(|t| tree(t, &loaded, *place, Keep::Outcomes).to_json());
                assert_eq!(a, b, "{name}, {pixel}, {numerics}");
            }
        }
    }
}

#[test]
fn no_colour_depends_on_the_recorder() {
    for (name, loaded) in scenes() {
        let tracer = tracer::<f64>(&loaded.scene);
        let named = loaded.scene.pixels.iter().map(|(_, pixel)| *pixel);
        for [x, y] in named.chain(grid(&loaded.scene, 30)) {
            let off = tracer.pixel_color(x, y).to_array().map(f64::to_bits);
            let cost = tracer.pixel(x, y, &Cost).0.to_array().map(f64::to_bits);
            assert_eq!(off, cost, "{name} at {x},{y}");
            for keep in [Keep::Outcomes, Keep::Steps] {
                let kept = tree(&tracer, &loaded, [x, y], keep).color.map(f64::to_bits);
                assert_eq!(off, kept, "{name} at {x},{y} with {keep:?}");
            }
        }
    }
}

/// What `shape` is once the objects have been turned round.
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
fn the_order_of_objects_does_not_matter() {
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
        seen += 1;
    }
    assert_eq!(seen, apart.len());
}

#[test]
fn of_coincident_surfaces_the_first_is_seen() {
    let quad = |z: &str, material: &str| {
        format!(
            r#"{{ "material": "{material}", "shape": {{ "triangle": {{ "vertices": [[-9, -9, {z}], [9, -9, {z}], [0, 12, {z}]] }} }} }}"#
        )
    };
    let materials = r#""red": { "color": [1, 0, 0], "ambient": 1 }, "blue": { "color": [0, 0, 1], "ambient": 1 }"#;
    for (first, second, wanted) in [("red", "blue", [1.0, 0.0, 0.0]), ("blue", "red", [0.0, 0.0, 1.0])] {
        let objects = [quad("-0.3", first), quad("-0.3", second)].join(",");
        let loaded = crate::support::small_scene(materials, &objects, "");
        for acceleration in [Acceleration::List, Acceleration::Bvh] {
            let tracer = tracer_with::<f64>(&loaded.scene, Numerics::Certified, acceleration);
            for [x, y] in grid(&loaded.scene, 12) {
                assert_eq!(tracer.pixel_color(x, y).to_array(), wanted);
            }
        }
    }
}

/// The hash of every scene's picture in every format. A release build has to give the same: `.ci/run` runs this test in
/// both.
#[test]
fn hashes_of_pictures() {
    let mut lines = Vec::new();
    for (name, loaded) in scenes() {
        let loaded = small(loaded);
        let f64s = picture(&tracer::<f64>(&loaded.scene), 2);
        let f32s = picture(&tracer::<f32>(&loaded.scene), 2);
        assert!(
            f64s.pixels.iter().chain(&f32s.pixels).all(|rgb| rgb.is_finite()),
            "{name}: not a number in the picture"
        );
        for (precision, film) in [("f64", f64s), ("f32", f32s)] {
            let hash = |bytes: Vec<u8>| {
                Sha256::digest(bytes).iter().take(8).map(|byte| format!("{byte:02x}")).collect::<String>()
            };
            let [png, exr, pfm] = [Format::Png, Format::Exr, Format::Pfm].map(|f| hash(film.encode(f).unwrap()));
            lines.push(format!("{name} {precision}: png {png} exr {exr} pfm {pfm}"));
        }
    }
    insta::assert_snapshot!(lines.join("\n"));
}

#[test]
fn pictures_read_back() {
    let loaded = scene(
        r#"{ "image": { "width": 2, "height": 1 }, "background": [0.5, 2, 0],
             "camera": { "eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov_y_degrees": 60 },
             "materials": {}, "objects": [] }"#,
    );
    let film = picture(&tracer::<f64>(&loaded.scene), 1);
    let png = image::load_from_memory(&film.encode(Format::Png).unwrap()).unwrap().into_rgb8();
    // 0.5 linear is 188 in sRGB; what is too bright is clamped.
    assert_eq!(png.into_raw(), [188, 255, 0, 188, 255, 0]);
    let exr = image::load_from_memory(&film.encode(Format::Exr).unwrap()).unwrap().into_rgb32f();
    assert_eq!(exr.into_raw(), [0.5, 2.0, 0.0, 0.5, 2.0, 0.0]);
    let pfm = film.encode(Format::Pfm).unwrap();
    assert_eq!(&pfm[..12], b"PF\n2 1\n-1.0\n");
    assert_eq!(pfm[12..16], 0.5_f32.to_le_bytes());
}
