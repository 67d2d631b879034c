//! Same bytes: for any recorder, thread count and way to find hits; in debug and release. For any order of objects: row
//! G10 of the hard cases.

use raytree::hits::Acceleration;
use raytree::numbers::Real;
use raytree::pictures::Format;
use raytree::scene::{Numerics, Scene};
use raytree::tree::{Cost, Keep};
use sha2::{Digest, Sha256};

use crate::support::{bits, grid, picture, scene, scenes, smaller, tracer, tracer_with, tree};

const SETS: [Numerics; 3] = [Numerics::Lecture, Numerics::Robust, Numerics::Certified];

#[test]
fn no_picture_depends_on_threads() {
    for (name, loaded) in scenes() {
        let loaded = smaller(loaded, 64);
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
        let loaded = smaller(loaded, 64);
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

/// The hash of every scene's picture in every format. A release build has to give the same: `.ci/run` runs this test in
/// both.
#[test]
fn hashes_of_pictures() {
    let mut lines = Vec::new();
    for (name, loaded) in scenes() {
        let loaded = smaller(loaded, 64);
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
