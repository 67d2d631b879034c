//! OBJ and PLY: what is read, and what is refused where.

use raytree::scene::mesh::{parse_mesh, parse_obj, parse_ply};

use super::{TETRAHEDRON, TRIANGLE, expect_error, obj, ply_binary, ply_text};

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
