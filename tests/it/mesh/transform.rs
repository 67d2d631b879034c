//! Transforms, and normals across facets.

use raytree::scene::mesh::{MeshData, Rotation, Transform, smooth_normals};

use super::{TRIANGLE, expect_error, generated, obj};

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
