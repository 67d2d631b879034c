//! Meshes: what the two parsers read and refuse, what a transform does to the bits, which surfaces are closed.

use proptest::prelude::*;
use raytree::scene::mesh::{
    MeshData, MeshError, Rotation, Solidity, Transform, is_closed, orient_outward, parse_mesh, parse_obj, parse_ply,
    signed_volume, smooth_normals, solidity,
};

#[path = "../../scenes/meshes/shapes.rs"]
mod shapes;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn obj(text: &str) -> MeshData {
    parse_obj(text.as_bytes()).unwrap_or_else(|error| panic!("{text:?}: {error}"))
}

/// A header for vertices with `x y z` and faces with a list, in text.
fn ply_text(vertices: &str, faces: &str, body: &str) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex {vertices}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {faces}\nproperty list uchar int vertex_indices\nend_header\n{body}"
    )
}

#[test]
fn obj_faces_are_read_in_all_their_forms() {
    let cases: [(&str, &[[u32; 3]]); 13] = [
        ("f 1 2 3", &[[0, 1, 2]]),
        ("f -3 -2 -1", &[[0, 1, 2]]),
        ("f 1 2 3\n\n  # a comment\n", &[[0, 1, 2]]),
        ("f 1 2 3 # after it", &[[0, 1, 2]]),
        ("f 1 2 3\r\n", &[[0, 1, 2]]),
        ("f 1 \\\n 2\\\r\n 3", &[[0, 1, 2]]),
        ("\tf\t1 2 3\t", &[[0, 1, 2]]),
        ("vt 0 0\nf 1/1 2/1 3/-1", &[[0, 1, 2]]),
        ("vn 0 0 1\nf 1//1 2//1 3//-1", &[[0, 1, 2]]),
        ("vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1", &[[0, 1, 2]]),
        ("v 1 1 0\nf 1 2 4 3", &[[0, 1, 3], [0, 3, 2]]),
        ("f 1 2 4\nv 1 1 0 1", &[[0, 1, 3]]),
        ("mtllib a.mtl\no a\ng b c\ns off\nusemtl x\nv 0 0 1 1 0 0\nv 0 0 1 1 1 0 0\nf 3 2 1", &[[2, 1, 0]]),
    ];
    for (rest, faces) in cases {
        assert_eq!(obj(&format!("{TRIANGLE}{rest}")).faces, faces, "{rest:?}");
    }
    assert_eq!(obj(&format!("\u{feff}{TRIANGLE}f 1 2 3")).positions.len(), 3, "a byte order mark");
}

#[test]
fn obj_normals_are_unit_and_belong_to_corners() {
    let mesh = obj(&format!("{TRIANGLE}vn 0 0 2\nvn 3 0 4\nf 1//1 2//2 3//1\nf 1 3 2"));
    let (up, tilted, down) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, 0.0, -1.0]);
    assert_eq!(mesh.corner_normals, Some(vec![[up, tilted, up], [down; 3]]), "a face without normals gets its own");
    assert_eq!(obj(&format!("{TRIANGLE}vn 0 0 0\nf 1 2 3")).corner_normals, None, "normals that no face uses");
    let forward = obj(&format!("{TRIANGLE}f 1//1 2//1 3//1\nvn 0 0 1e300"));
    assert_eq!(forward.corner_normals, Some(vec![[up; 3]]));
}

#[test]
fn obj_errors_say_where_and_what() {
    let cases = [
        ("", (0, 0), "no vertices"),
        ("# nothing\n", (0, 0), "no vertices"),
        ("f 1 2 3", (0, 0), "no vertices"),
        ("v 0 0 0\n", (0, 0), "no faces"),
        ("v 0 0 0\nf 1 1 2", (2, 7), "vertex index 2 is out of range: the file has 1 of them"),
        ("v 0 0 0\nf 1 1 -2", (2, 7), "vertex index -2 is out of range: 1 of them stand above"),
        ("v 0 0 0\nf 1 0 1", (2, 5), "vertex index 0"),
        ("v 0 0 0\nf 1 1 4294967296", (2, 7), "vertex index 4294967296 is out of range"),
        ("v 0 0 0\nf 1 1 -99999999999999999999", (2, 7), "out of range"),
        ("v 0 0 0\nf 1 1 x", (2, 7), "vertex index \"x\" is not a whole number"),
        ("v 0 0 0\nf 1 1 1.5", (2, 7), "not a whole number"),
        ("v 0 0 0\nf 1 1 1/", (2, 7), "texture index \"\" is not a whole number"),
        ("v 0 0 0\nf 1 1 1/1", (2, 7), "texture index 1 is out of range: the file has 0 of them"),
        ("v 0 0 0\nf 1//1 1 1", (2, 3), "normal index 1 is out of range: the file has 0 of them"),
        ("v 0 0 0\nvn 0 0 1\nf 1//1 1 1", (3, 8), "some corners"),
        ("v 0 0 0\nvn 0 0 0\nf 1//1 1//1 1//1", (3, 3), "length zero"),
        ("v 0 0 0\nvt 0\nvn 0 0 1\nf 1/1/1/1 1 1", (4, 3), "more than three parts"),
        ("v 0 0 0\n  f 1 1", (2, 3), "a face with 2 corners"),
        ("v 0 0 0\nf", (2, 1), "a face with 0 corners"),
        ("v 0 nan 0", (1, 5), "y is \"nan\", not a finite number"),
        ("v 0 0 -inf", (1, 7), "z is \"-inf\", not a finite number"),
        ("v 1e999 0 0", (1, 3), "x is \"1e999\", not a finite number"),
        ("v 0 0 3.5e38", (1, 7), "out of range"),
        ("v 0 0 1e-60", (1, 7), "out of range"),
        ("v 0 0 1,5", (1, 7), "z is \"1,5\", not a number"),
        ("v 0 0", (1, 1), "a vertex of 2 numbers"),
        ("v 0 0 0 0 0", (1, 1), "a vertex of 5 numbers"),
        ("v 0 0 0 x", (1, 9), "a weight or colour is \"x\""),
        ("vn 0 0", (1, 1), "a normal of 2 numbers"),
        ("vn 0 inf 0", (1, 6), "not a finite number"),
        ("v 0 0 0\nl 1 1", (2, 1), "the statement \"l\" is unknown"),
        ("v \\\n0 0 \\\n ä", (3, 2), "z is \"ä\""),
        ("# ä\n\u{feff}", (2, 1), "unknown"),
        ("\u{feff}w", (1, 1), "the statement \"w\" is unknown"),
    ];
    for (text, (line, column), message) in cases {
        expect_error(parse_obj(text.as_bytes()), text, (line, column), message);
    }
    let error = parse_obj(b"# \xc3\xa4\n# \xe4\n").unwrap_err();
    assert_eq!((error.line, error.column, error.byte_offset), (Some(2), Some(3), Some(7)));
    let long = format!("v 0 0 {}", "x".repeat(1000));
    assert!(parse_obj(long.as_bytes()).unwrap_err().message.len() < 100, "the offending word is cut");
    assert_eq!(
        parse_obj(b"v 0 0").unwrap_err().to_string(),
        "line 1, column 1: a vertex of 2 numbers\n\
         help: \"v x y z\", perhaps followed by a weight, a colour of three numbers, or both",
    );
}

/// Holds an error against its place, (0, 0) for none, and part of its message.
fn expect_error(result: Result<MeshData, MeshError>, input: &str, (line, column): (u32, u32), message: &str) {
    let error = result.expect_err(input);
    let place = (error.line.unwrap_or(0), error.column.unwrap_or(0));
    assert!(error.message.contains(message), "{input:?} gave {error}");
    assert_eq!(place, (line, column), "{input:?} gave {error}");
    assert!(!error.help.is_empty(), "{input:?}");
}

#[test]
fn ply_text_errors_say_where_and_what() {
    let header = |lines: &str| format!("ply\n{lines}\nend_header\n");
    let cases = [
        (String::new(), (1, 1), "not a PLY file"),
        ("plyx\n".into(), (1, 1), "not a PLY file"),
        ("v 0 0 0\n".into(), (1, 1), "not a PLY file"),
        ("ply\nformat ascii 1.0\n".into(), (0, 0), "the header has no end"),
        (header("comment x"), (0, 0), "no format"),
        (header("format ascii 2.0"), (2, 8), "the format \"ascii\" \"2.0\" is unknown"),
        (header("format binary_middle_endian 1.0"), (2, 8), "is unknown"),
        (header("format ascii 1.0\nformat ascii 1.0"), (3, 1), "a second \"format\""),
        (header("format ascii 1.0\nelements vertex 3"), (3, 1), "not understood"),
        (header("format ascii 1.0\nelement vertex -1"), (3, 16), "the count of \"vertex\" is \"-1\""),
        (header("format ascii 1.0\nelement vertex 1e3"), (3, 16), "the count of"),
        (header("format ascii 1.0\nproperty float x"), (3, 1), "a property before any element"),
        (header("format ascii 1.0\nelement vertex 1\nproperty half x"), (4, 10), "the type \"half\" is unknown"),
        (header("format ascii 1.0\nelement face 1\nproperty list float int vertex_index"), (4, 15), "no integer"),
        (header("format ascii 1.0\nelement face 1\nproperty list int float vertex_index"), (4, 1), "no integers"),
        (header("format ascii 1.0\nelement face 1\nproperty int vertex_index"), (4, 1), "a single number"),
        (header("format ascii 1.0\nelement face 1\nproperty int flags"), (3, 1), "no list of corners"),
        (header("format ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y"), (3, 1), "no \"z\""),
        (header("format ascii 1.0\nelement vertex 1\nproperty list int int x"), (4, 1), "\"x\" is a list"),
        (header("format ascii 1.0\nelement vertex 1\nproperty int x\nproperty int x"), (5, 1), "there twice"),
        (header("format ascii 1.0\nelement vertex 1\nelement vertex 1"), (4, 9), "a second element"),
        (header("format ascii 1.0"), (0, 0), "no vertices"),
        (ply_text("0", "0", ""), (0, 0), "no vertices"),
        (ply_text("1", "0", "0 0 0"), (0, 0), "no faces"),
        (ply_text("1", "1", "0 0 0\n3 0 0 1\n"), (11, 7), "vertex index 1 is out of range: the file has 1 of them"),
        (ply_text("1", "1", "0 0 0\n3 0 0 -1\n"), (11, 7), "vertex index -1 is out of range"),
        (ply_text("1", "1", "0 0 0\n3 0 0 4294967296\n"), (11, 7), "vertex index 4294967296 is out of range"),
        (ply_text("1", "1", "0 0 0\n3 0 0 0.5\n"), (11, 7), "\"0.5\" is not a whole number"),
        (ply_text("1", "1", "0 0 0\n2 0 0\n"), (11, 1), "has 2 corners"),
        (ply_text("1", "1", "0 0 0\n-1 0 0\n"), (11, 1), "a list of -1 numbers"),
        (ply_text("1", "1", "0 0 0\n4 0 0 0\n"), (11, 8), "the row ends too early"),
        (ply_text("1", "1", "0 0 0\n4000000000 0 0 0\n"), (11, 17), "the row ends too early"),
        (ply_text("1", "1", "0 0 0\n3 0 0 0 0\n"), (11, 9), "more than this row holds"),
        (ply_text("1", "1", "0 0 0\n3 0 0 0\n0\n"), (12, 1), "more after the last row"),
        (ply_text("1", "2", "0 0 0\n3 0 0 0\n"), (12, 1), "the file ends before row 1 of 2 rows of \"face\""),
        (ply_text("1", "1", "0 nan 0\n3 0 0 0\n"), (10, 3), "y of vertex 0, counted from 0, is not a finite number"),
        (ply_text("1", "1", "0 0 1e999\n3 0 0 0\n"), (10, 5), "z of vertex 0, counted from 0, is not a finite number"),
        (ply_text("1", "1", "1e39 0 0\n3 0 0 0\n"), (10, 1), "out of range"),
        (ply_text("1", "1", "a 0 0\n3 0 0 0\n"), (10, 1), "\"a\" is not a number"),
        (ply_text("1000000000000000000", "1", "0 0 0\n"), (10, 1), "promises 1000000000000000000 rows of \"vertex\""),
        (ply_text("1", "18446744073709551615", "0 0 0\n3 0 0 0\n"), (11, 1), "promises 18446744073709551615 rows"),
        (ply_text("18446744073709551616", "1", ""), (3, 16), "the count of"),
        (header("format ascii 1.0\nelement nothing 18446744073709551615"), (0, 0), "no vertices"),
    ];
    for (text, place, message) in cases {
        expect_error(parse_ply(text.as_bytes()), &text, place, message);
    }
    let normals = "property double z\nproperty float nx\nproperty float ny\nproperty float nz";
    let zero = ply_text("2", "1", "0 0 0 0 0 2\n0 0 0 0 0 0\n3 0 0 1\n").replace("property double z", normals);
    expect_error(parse_ply(zero.as_bytes()), &zero, (0, 0), "the normal of vertex 1, counted from 0, has length zero");
    let unused = parse_ply(zero.replace("3 0 0 1", "3 0 0 0").as_bytes()).expect("no face uses the zero normal");
    assert_eq!(unused.corner_normals, Some(vec![[[0.0, 0.0, 1.0]; 3]]));
    let mut latin = ply_text("1", "1", "0 0 0\n3 0 0 0\n").into_bytes();
    latin.push(0xe4);
    let error = parse_ply(&latin).unwrap_err();
    assert_eq!((error.line, error.column), (Some(12), Some(1)));
    assert!(error.message.contains("0xe4 is not UTF-8"), "{error}");
}

/// The same tetrahedron with normals, colours, an element to skip and faces before vertices, in binary.
fn ply_binary(big_endian: bool) -> Vec<u8> {
    let format = if big_endian { "binary_big_endian" } else { "binary_little_endian" };
    let mut out = format!(
        "ply\r\nformat {format} 1.0\r\ncomment x\r\nelement face 2\r\nproperty uchar flags\r\n\
         property list ushort uint vertex_index\r\nelement strip 1\r\nproperty list int short all\r\n\
         element vertex 4\r\nproperty short x\r\nproperty double y\r\nproperty uchar red\r\nproperty float z\r\n\
         property char nx\r\nproperty float ny\r\nproperty double nz\r\nend_header\r\n"
    )
    .into_bytes();
    let mut put = |le: &[u8]| if big_endian { out.extend(le.iter().rev()) } else { out.extend(le) };
    for polygon in [&[0_u32, 2, 1][..], &[0, 1, 3, 2]] {
        put(&[7]);
        put(&(polygon.len() as u16).to_le_bytes());
        polygon.iter().for_each(|index| put(&index.to_le_bytes()));
    }
    put(&2_i32.to_le_bytes());
    put(&(-5_i16).to_le_bytes());
    put(&6_i16.to_le_bytes());
    for (x, y, z) in [(0_i16, 0.1_f64, 0.1_f32), (-3, 0.0, 0.0), (0, 1.0, 0.0), (0, 0.0, 1.0)] {
        put(&x.to_le_bytes());
        put(&y.to_le_bytes());
        put(&[255]);
        put(&z.to_le_bytes());
        put(&(-2_i8).to_le_bytes());
        put(&0.0_f32.to_le_bytes());
        put(&0.0_f64.to_le_bytes());
    }
    out
}

#[test]
fn ply_binary_is_read_in_both_byte_orders() {
    for big_endian in [false, true] {
        let mesh = parse_ply(&ply_binary(big_endian)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(mesh.faces, [[0, 2, 1], [0, 1, 3], [0, 3, 2]]);
        assert_eq!(mesh.positions[..2], [[0.0, 0.1, f64::from(0.1_f32)], [-3.0, 0.0, 0.0]]);
        assert_eq!(mesh.corner_normals, Some(vec![[[-1.0, 0.0, 0.0]; 3]; 3]));
    }
}

#[test]
fn ply_binary_errors_say_at_which_byte() {
    let good = ply_binary(false);
    let body = good.windows(12).position(|window| window == b"end_header\r\n").expect("a header") + 12;
    for length in 0..good.len() {
        let error = parse_ply(&good[..length]).expect_err("a file cut short");
        assert!(length < body || error.byte_offset.is_some_and(|offset| offset <= length), "{length}: {error}");
    }
    // The count of the second polygon says 65535: 4 bytes each, and too few are left.
    let mut long = good.clone();
    let second = body + 3 + 12;
    long[second + 1..second + 3].fill(0xff);
    let error = parse_ply(&long).unwrap_err();
    assert!(error.byte_offset.is_some_and(|offset| offset > second), "{error}");
    let cut = parse_ply(&good[..good.len() - 1]).unwrap_err();
    assert!(cut.message.contains("at least 112 bytes, but 111 bytes are left"), "{cut}");
    // Cut in the list of the skipped element: two numbers of two bytes, one had.
    let strip = second + 3 + 16;
    let cut = parse_ply(&good[..strip + 4 + 1]).unwrap_err();
    assert_eq!(cut.byte_offset, Some(strip + 4));
    assert!(cut.message.contains("4 bytes wanted here, 1 had"), "{cut}");
    let mut more = good.clone();
    more.push(0);
    assert_eq!(parse_ply(&more).unwrap_err().byte_offset, Some(good.len()));
    let mut nan = good;
    let y = strip + 8 + 2;
    nan[y..y + 8].copy_from_slice(&f64::NAN.to_le_bytes());
    let error = parse_ply(&nan).unwrap_err();
    assert_eq!(error.byte_offset, Some(y));
    assert!(error.message.contains("y of vertex 0, counted from 0, is not a finite number"), "{error}");
}

#[test]
fn the_file_name_says_the_format() {
    assert!(parse_mesh("a/B.OBJ", TETRAHEDRON.as_bytes()).is_ok());
    assert!(parse_mesh("x.obj.ply", &ply_binary(true)).is_ok());
    for name in ["a.stl", "obj", ""] {
        let error = parse_mesh(name, TETRAHEDRON.as_bytes()).unwrap_err();
        assert!(error.message.contains("is unknown"), "{error}");
    }
}

#[test]
fn the_limits_of_coordinates_are_as_stated() {
    let at = |x: f64| parse_obj(format!("v {x:e} 0 0\nf 1 1 1").as_bytes()).is_ok();
    let two = 2.0_f64;
    for good in [two.powi(128), -two.powi(128), two.powi(-178), -3.0 * two.powi(-178), two.powi(-126), -0.0] {
        assert!(at(good), "{good:e}");
    }
    for bad in [two.powi(128) * (1.0 + f64::EPSILON), two.powi(-179), 1.5 * two.powi(-178), f64::MIN_POSITIVE, 5e-324] {
        assert!(!at(bad), "{bad:e}");
    }
    assert!(at(f64::from(f32::from_bits(1))) && at(f64::from(f32::MAX)), "every f32 is in range");
    assert!(at(two.powi(-126) * (1.0 + f64::EPSILON)), "every f64 from 2^-126 up is in range");
}

#[test]
fn committed_meshes_are_what_the_generator_makes() {
    for (name, bytes) in shapes::all() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/meshes").join(name);
        assert!(std::fs::read(&path).expect(name) == bytes, "run `cargo run --example generate-meshes`: {name}");
        assert!(bytes.len() < 200 * 1024, "{name}");
    }
}

fn generated(name: &str) -> MeshData {
    let (_, bytes) = shapes::all().into_iter().find(|(known, _)| *known == name).expect(name);
    parse_mesh(name, &bytes).unwrap_or_else(|error| panic!("{name}: {error}"))
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

#[test]
fn a_transform_that_is_absent_changes_no_bit() {
    let mesh = obj("v -0 0.1 1e-30\nv 1 -0 0\nv 0 3e38 0\nvn 1 2 3\nf 1//1 2//1 3//1");
    let placed = Transform::default().apply(&mesh).expect("in range");
    let bits = |mesh: &MeshData| -> Vec<u64> {
        let normals = mesh.corner_normals.iter().flatten().flatten();
        mesh.positions.iter().chain(normals).flatten().map(|x| x.to_bits()).collect()
    };
    assert_eq!(bits(&placed), bits(&mesh));
    assert_eq!(serde_json::from_str::<Transform>("{}").expect("valid"), Transform::default());
    assert!(serde_json::from_str::<Transform>(r#"{"rotation": 1}"#).is_err(), "unknown keys are refused");
}

#[test]
fn quarter_turns_about_coordinate_axes_are_exact() {
    for axis in 0..3 {
        for sign in [1.0, -1.0, 7.5, -1e-200] {
            for quarters in -9..=9 {
                let mut direction = [0.0; 3];
                direction[axis] = sign;
                let rotation = Rotation { axis: direction, degrees: 90.0 * f64::from(quarters) };
                let matrix = rotation.matrix().expect("a rotation");
                // Counted here: each quarter turn takes the next axis to the one after it.
                let turns: i32 = if sign < 0.0 { -quarters } else { quarters };
                let (s, c) = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][turns.rem_euclid(4) as usize];
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut expected = [[0.0; 3]; 3];
                expected[axis][axis] = 1.0;
                (expected[u][u], expected[u][v], expected[v][u], expected[v][v]) = (c, -s, s, c);
                assert_eq!(matrix, expected, "{rotation:?}");
                assert!(matrix.iter().flatten().all(|x| x.to_bits() != (-0.0_f64).to_bits()), "{rotation:?}");
            }
        }
    }
}

#[test]
fn transform_bits_are_pinned() {
    let rotate = Some(Rotation { axis: [1.0, 2.0, 3.0], degrees: 40.0 });
    let transform = Transform { scale: 0.3, rotate, translate: [1.0, 0.0, -2.0] };
    let placed = transform.apply(&obj(&format!("{TRIANGLE}vn 0 1 0\nf 1//1 2//1 3//1"))).expect("in range");
    let bits = [placed.positions[1], placed.corner_normals.expect("normals")[0][0]].map(|v| v.map(f64::to_bits));
    assert_eq!(bits, PINNED);
}

/// Within 2^-50 of what a computation in another language gave; here to see that no platform differs.
const PINNED: [[u64; 3]; 2] = [
    [0x3ff3_c1d9_9b3f_9e60, 0x3fc5_12e9_91da_8cad, 0xc000_b44b_ddd1_9375],
    [0xbfde_d857_5c50_6da4, 0x3fea_a706_98dd_394c, 0x3fd1_6969_a849_2d7a],
];

#[test]
fn a_transform_scales_then_rotates_then_moves() {
    let mesh = obj(&format!("{TRIANGLE}vn 1 0 0\nf 1//1 2//1 3//1"));
    let rotate = Some(Rotation { axis: [0.0, 2.0, 0.0], degrees: 90.0 });
    let placed = Transform { scale: 2.0, rotate, translate: [10.0, 0.0, 0.0] }.apply(&mesh).expect("in range");
    assert_eq!(placed.positions, [[10.0, 0.0, 0.0], [10.0, 0.0, -2.0], [10.0, 2.0, 0.0]]);
    assert_eq!(placed.corner_normals, Some(vec![[[0.0, 0.0, -1.0]; 3]]));
}

#[test]
fn a_transform_that_cannot_be_is_refused() {
    let turn =
        |axis: [f64; 3], degrees: f64| Transform { rotate: Some(Rotation { axis, degrees }), ..Transform::default() };
    let scale = |scale: f64| Transform { scale, ..Transform::default() };
    let cases = [
        (scale(0.0), "the scale of a mesh is 0"),
        (scale(-1.0), "the scale of a mesh is -1"),
        (scale(f64::NAN), "the scale of a mesh is NaN"),
        (scale(f64::INFINITY), "the scale of a mesh is inf"),
        (scale(1e39), "moves vertex 1, counted from 0, out of range"),
        (turn([0.0; 3], 1.0), "has no direction"),
        (turn([0.0, f64::NAN, 1.0], 1.0), "has no direction"),
        (turn([0.0, 1.0, 0.0], f64::INFINITY), "the angle of rotation is not finite"),
        (Transform { translate: [0.0, f64::NAN, 0.0], ..Transform::default() }, "the move of a mesh is not finite"),
        (Transform { translate: [0.0, 4e38, 0.0], ..Transform::default() }, "moves vertex 0"),
    ];
    for (transform, message) in cases {
        expect_error(transform.apply(&obj(&format!("{TRIANGLE}f 1 2 3"))), &format!("{transform:?}"), (0, 0), message);
    }
    let tiny = scale(1.2e-45).apply(&obj(&format!("{TRIANGLE}f 1 2 3"))).expect("rounded into range");
    assert_eq!((tiny.positions[1][0] * 2_f64.powi(178)).fract(), 0.0);
    assert!((tiny.positions[1][0] - 1.2e-45).abs() <= 2_f64.powi(-179));
}

#[test]
fn smooth_normals_are_weighted_by_angle_and_welded() {
    // At each corner of a cube three sides meet at right angles, however their diagonals run.
    let third = 1.0 / 3.0_f64.sqrt();
    let cube = generated("cube.obj");
    for (face, normals) in cube.faces.iter().zip(smooth_normals(&cube)) {
        for (corner, normal) in cube.corners(*face).into_iter().zip(normals) {
            for axis in 0..3 {
                assert!((normal[axis] - corner[axis] * third).abs() < 1e-15, "{corner:?}: {normal:?}");
            }
        }
    }
    // The torus comes with its true normals, and those from its geometry are close to them.
    let torus = generated("torus.obj");
    let stored = torus.corner_normals.clone().expect("normals");
    for (found, stored) in smooth_normals(&torus).iter().flatten().zip(stored.iter().flatten()) {
        assert!(glam::DVec3::from_array(*found).dot(glam::DVec3::from_array(*stored)) > 0.9999);
    }
    // Two faces back to back cancel: each keeps its own. A face without area gets +z.
    let leaf = smooth_normals(&obj(&format!("{TRIANGLE}f 1 2 3\nf 3 2 1\nf 1 1 1")));
    assert_eq!(leaf, [[[0.0, 0.0, 1.0]; 3], [[0.0, 0.0, -1.0]; 3], [[0.0, 0.0, 1.0]; 3]]);
    // The same vertex under two indices gets the same normal.
    let seam = smooth_normals(&obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nv -0 0 0\nv 1 -0 0\nf 1 2 3\nf 6 5 4"));
    assert_eq!(seam[0][0], seam[1][1]);
    assert_eq!(seam[0][1], seam[1][0]);
    assert_eq!(seam[0][2], [0.0, 0.0, 1.0]);
}

/// The mesh as a file; what the parser reads from it is the mesh again.
fn write_obj(mesh: &MeshData) -> String {
    let v = |v: &[f64; 3]| format!("v {} {} {}\n", v[0], v[1], v[2]);
    let f = |f: &[u32; 3]| format!("f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
    mesh.positions.iter().map(v).chain(mesh.faces.iter().map(f)).collect()
}

fn write_ply(mesh: &MeshData, format: &str) -> Vec<u8> {
    let (vertices, faces) = (mesh.positions.len().to_string(), mesh.faces.len().to_string());
    let mut out = ply_text(&vertices, &faces, "").replace("ascii", format).into_bytes();
    let big_endian = format == "binary_big_endian";
    for position in &mesh.positions {
        if format == "ascii" {
            out.extend(format!("{} {} {}\n", position[0], position[1], position[2]).bytes());
        } else {
            out.extend(position.iter().flat_map(|x| if big_endian { x.to_be_bytes() } else { x.to_le_bytes() }));
        }
    }
    for face in &mesh.faces {
        if format == "ascii" {
            out.extend(format!("3 {} {} {}\n", face[0], face[1], face[2]).bytes());
        } else {
            out.push(3);
            out.extend(face.iter().flat_map(|x| if big_endian { x.to_be_bytes() } else { x.to_le_bytes() }));
        }
    }
    out
}

#[test]
fn what_is_written_is_read_back() {
    for (name, _) in shapes::all() {
        let rotate = Some(Rotation { axis: [1.0, 1.0, 0.5], degrees: 33.0 });
        let transform = Transform { scale: 1.0 / 3.0, rotate, translate: [0.1, 0.2, 0.3] };
        let mut mesh = transform.apply(&generated(name)).expect("in range");
        assert_eq!(solidity(&mesh), Solidity::Solid, "{name} stays a solid where it is put");
        mesh.corner_normals = None;
        assert_eq!(obj(&write_obj(&mesh)), mesh, "{name}");
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            assert_eq!(parse_ply(&write_ply(&mesh, format)).as_ref(), Ok(&mesh), "{name} {format}");
        }
    }
}

#[derive(Clone, Debug)]
enum Mutation {
    Flip(usize, u8),
    Cut(usize),
    Delete(usize, usize),
    Repeat(usize, usize),
    Number(usize, &'static str),
}

fn mutate(bytes: &mut Vec<u8>, mutation: &Mutation) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    match *mutation {
        Mutation::Flip(at, bits) => bytes[at % length] ^= bits,
        Mutation::Cut(at) => bytes.truncate(at % length),
        Mutation::Delete(at, many) => drop(bytes.drain(at % length..(at % length + many).min(length))),
        Mutation::Repeat(at, many) => {
            let slice = bytes[at % length..(at % length + many).min(length)].to_vec();
            bytes.splice(at % length..at % length, slice);
        }
        Mutation::Number(at, number) => {
            let is_part = |&byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-');
            let Some(start) = (at % length..length).find(|&at| is_part(&bytes[at])) else { return };
            let end = (start..length).find(|&at| !is_part(&bytes[at])).unwrap_or(length);
            bytes.splice(start..end, number.bytes());
        }
    }
}

fn mutation() -> impl Strategy<Value = Mutation> {
    const NUMBERS: [&str; 8] = ["1e999", "NaN", "-1", "4294967296", "0", "255", "1000000000000000000", "1e-320"];
    prop_oneof![
        (any::<usize>(), 1..=u8::MAX).prop_map(|(at, bits)| Mutation::Flip(at, bits)),
        any::<usize>().prop_map(Mutation::Cut),
        (any::<usize>(), 1_usize..40).prop_map(|(at, many)| Mutation::Delete(at, many)),
        (any::<usize>(), 1_usize..40).prop_map(|(at, many)| Mutation::Repeat(at, many)),
        (any::<usize>(), prop::sample::select(&NUMBERS[..])).prop_map(|(at, number)| Mutation::Number(at, number)),
    ]
}

fn seeds() -> Vec<Vec<u8>> {
    let mesh = obj(TETRAHEDRON);
    vec![
        format!(
            "# x\nmtllib a\n{TRIANGLE}vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 \\\n 3/1/1\nf -1//-1 -2//1 1//1\ns 1\nf 1 2 3"
        )
        .into_bytes(),
        TETRAHEDRON.as_bytes().to_vec(),
        write_ply(&mesh, "ascii"),
        write_ply(&mesh, "binary_little_endian"),
        write_ply(&mesh, "binary_big_endian"),
        ply_binary(false),
        ply_binary(true),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 6000,
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(1980),
        ..ProptestConfig::default()
    })]

    #[test]
    fn damaged_files_are_read_or_refused(
        seed in prop::sample::select(seeds()),
        mutations in prop::collection::vec(mutation(), 1..5),
    ) {
        let mut bytes = seed;
        mutations.iter().for_each(|mutation| mutate(&mut bytes, mutation));
        for result in [parse_obj(&bytes), parse_ply(&bytes)] {
            match result {
                Ok(mesh) => {
                    prop_assert!(!mesh.faces.is_empty());
                    prop_assert!(mesh.faces.iter().flatten().all(|&index| (index as usize) < mesh.positions.len()));
                    prop_assert!(mesh.positions.iter().flatten().all(|x| x.abs() <= 2_f64.powi(128)));
                    let normals = smooth_normals(&mesh);
                    let stored = mesh.corner_normals.iter().flatten();
                    for normal in normals.iter().chain(stored).flatten() {
                        prop_assert!((glam::DVec3::from_array(*normal).length() - 1.0).abs() < 1e-12);
                    }
                    let volume = signed_volume(&mesh);
                    prop_assert_eq!(volume.is_some(), is_closed(&mesh));
                    prop_assert_eq!(Transform::default().apply(&mesh), Ok(mesh));
                }
                Err(error) => {
                    prop_assert!(!error.message.is_empty() && error.message.len() < 400, "{}", error);
                    prop_assert!(error.byte_offset.is_none_or(|offset| offset <= bytes.len()));
                }
            }
        }
    }
}
