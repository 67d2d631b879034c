//! The committed meshes, and what makes a surface a solid.

use raytree::scene::mesh::{MeshData, Solidity, Transform, is_closed, orient_outward, signed_volume, solidity};

use super::{TETRAHEDRON, TRIANGLE, generated, obj, shapes};

#[test]
fn committed_meshes_are_what_the_generator_makes() {
    for (name, bytes) in shapes::all() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/meshes").join(name);
        assert!(std::fs::read(&path).expect(name) == bytes, "run `cargo run --example generate-meshes`: {name}");
        assert!(bytes.len() < 200 * 1024, "{name}");
    }
}

#[test]
fn committed_meshes_are_solids_of_the_right_volume() {
    // The exact volume of the smooth shape, and how far its mesh may fall short of it.
    let pi = std::f64::consts::PI;
    let cases = [
        ("cube.obj", 12, 8.0, 0.0),
        ("torus.obj", 2304, 2.0 * pi * pi * 0.16, 0.02),
        ("icosphere.ply", 1280, 4.0 / 3.0 * pi, 0.01),
        ("gem.obj", 78, 1.55, 0.1),
        ("bumpy-sphere.ply", 2048, 4.3, 0.1),
    ];
    for (name, count, volume, off) in cases {
        let mesh = generated(name);
        assert_eq!(mesh.faces.len(), count, "{name}");
        assert_eq!(solidity(&mesh), Solidity::Solid, "{name}");
        let found = signed_volume(&mesh).expect(name);
        assert!((found / volume - 1.0).abs() <= off, "{name}: {found}");
    }
}

#[test]
fn the_gem_is_convex() {
    let mesh = generated("gem.obj");
    for &face in &mesh.faces {
        let [a, b, c] = mesh.corners(face).map(glam::DVec3::from_array);
        let normal = (b - a).cross(c - a).normalize();
        for &p in &mesh.positions {
            let above = normal.dot(glam::DVec3::from_array(p) - a);
            assert!(above < 1e-5, "{face:?}: {above}");
        }
    }
}

#[test]
fn closedness_goes_by_position_and_winding() {
    let cases = [
        ("a tetrahedron", TETRAHEDRON.to_string(), true),
        ("a face missing", TETRAHEDRON.replace("f 2 3 4\n", ""), false),
        ("a face flipped", TETRAHEDRON.replace("f 2 3 4", "f 4 3 2"), false),
        ("a face twice", format!("{TETRAHEDRON}f 2 3 4\n"), false),
        ("all twice", format!("{TETRAHEDRON}{}", &TETRAHEDRON[TETRAHEDRON.find('f').expect("faces")..]), false),
        ("a repeated vertex", TETRAHEDRON.replace("f 2 3 4", "v 1 0 0\nf 5 3 4"), true),
        ("a repeated vertex with -0", TETRAHEDRON.replace("f 2 3 4", "v 1 -0 0\nf 5 3 4"), true),
        ("a vertex a hair off", TETRAHEDRON.replace("f 2 3 4", "v 1 1e-30 0\nf 5 3 4"), false),
        ("a collapsed face", format!("{TETRAHEDRON}f 2 2 4\nf 1 1 1\n"), true),
        ("an edge with a fin", format!("{TETRAHEDRON}v 5 5 5\nf 2 3 5\n"), false),
        ("two that share a vertex", format!("{TETRAHEDRON}{}", second_tetrahedron("-1 0 0", "0 -1 0")), true),
        ("two that share an edge", format!("{TETRAHEDRON}{}", second_tetrahedron("-1 0 0", "0 1 0")), false),
        ("one triangle", format!("{TRIANGLE}f 1 2 3"), false),
        ("both sides of one", format!("{TRIANGLE}f 1 2 3\nf 3 2 1"), true),
        ("only a collapsed face", format!("{TRIANGLE}f 1 2 2"), true),
    ];
    for (name, text, closed) in cases {
        assert_eq!(is_closed(&obj(&text)), closed, "{name}");
    }
    assert!(!is_closed(&MeshData::default()));
    let open = solidity(&obj(&TETRAHEDRON.replace("f 2 3 4\n", "")));
    assert_eq!(open, Solidity::Open { face: 0, edge: [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]] });
}

/// A tetrahedron at the origin, wound outward whatever its two corners beside (0, 0, -1).
fn second_tetrahedron(b: &str, c: &str) -> String {
    format!("v 0 0 0\nv {b}\nv {c}\nv 0 0 -1\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n")
}

#[test]
fn the_sign_of_the_volume_says_which_side_is_out() {
    let outward = obj(TETRAHEDRON);
    assert_eq!(signed_volume(&outward), Some(1.0 / 6.0));
    let mut inward = outward.clone();
    inward.faces.iter_mut().for_each(|face| face.swap(1, 2));
    inward.corner_normals = Some(vec![[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]; 4]);
    assert_eq!(solidity(&inward), Solidity::Inward);
    assert_eq!(signed_volume(&inward), Some(-1.0 / 6.0));
    orient_outward(&mut inward);
    assert_eq!(inward.faces, outward.faces);
    assert_eq!(inward.corner_normals.as_ref().map(|normals| normals[0][1]), Some([0.0, 0.0, 1.0]));
    let flat = obj(&format!("{TRIANGLE}f 1 2 3\nf 3 2 1"));
    assert_eq!((solidity(&flat), signed_volume(&flat)), (Solidity::Flat, Some(0.0)));
    assert_eq!(signed_volume(&obj(&format!("{TRIANGLE}f 1 2 3"))), None);
    // Far from the origin the volume is measured from the mesh itself.
    let far = Transform { translate: [1e15, -1e15, 1e15], ..Transform::default() }.apply(&outward).expect("in range");
    assert_eq!(signed_volume(&far), Some(1.0 / 6.0));
}
