//! The committed meshes as bytes. Built by `generate.rs`, which writes them, and by the tests, which compare them.
//!
//! Sine and cosine come from `libm`, so that every platform makes the same bytes. Faces wind counterclockwise seen from
//! outside; y is up.

use std::f64::consts::PI;
use std::fmt::Write as _;

/// Every committed file: its name and its bytes.
pub(crate) fn all() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("bumpy-sphere.ply", bumpy_sphere()),
        ("cube.obj", cube()),
        ("gem.obj", gem()),
        ("icosphere.ply", icosphere()),
        ("torus.obj", torus()),
    ]
}

/// The shortest decimal of `x` rounded to `places` decimal places; 0 instead of -0.
fn decimal(x: f64, places: i32) -> String {
    let scale = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6][places as usize];
    format!("{}", (x * scale).round() / scale + 0.0)
}

fn obj_line(out: &mut String, keyword: &str, v: [f64; 3]) {
    let [x, y, z] = v.map(|x| decimal(x, 6));
    writeln!(out, "{keyword} {x} {y} {z}").expect("a String takes everything");
}

/// The cube from -1 to 1, two triangles a side.
fn cube() -> Vec<u8> {
    let mut out = String::from("# The cube from -1 to 1: 8 vertices, 12 triangles.\n");
    for corner in 0..8 {
        obj_line(&mut out, "v", [0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 }));
    }
    // The corners of each side counterclockwise seen from outside, as bits z y x.
    for [a, b, c, d] in [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]] {
        writeln!(out, "f {} {} {}\nf {} {} {}", a + 1, b + 1, c + 1, a + 1, c + 1, d + 1).expect("a String");
    }
    out.into_bytes()
}

/// A torus about the y axis, of radii 1 and 0.4, with its true normals.
fn torus() -> Vec<u8> {
    let (around, across) = (48, 24);
    let mut out = String::from("# A torus about the y axis, radii 1 and 0.4: 48 x 24 vertices with normals.\n");
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    for i in 0..around {
        let (s, c) = libm::sincos(2.0 * PI * f64::from(i) / f64::from(around));
        for j in 0..across {
            let (sj, cj) = libm::sincos(2.0 * PI * f64::from(j) / f64::from(across));
            let r = 1.0 + 0.4 * cj;
            positions.push([r * s, 0.4 * sj, r * c]);
            normals.push([cj * s, sj, cj * c]);
        }
    }
    positions.iter().for_each(|&v| obj_line(&mut out, "v", v));
    normals.iter().for_each(|&v| obj_line(&mut out, "vn", v));
    for i in 0..around {
        for j in 0..across {
            let at = |i: i32, j: i32| i % around * across + j % across + 1;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            writeln!(out, "f {a}//{a} {b}//{b} {c}//{c}\nf {a}//{a} {c}//{c} {d}//{d}").expect("a String");
        }
    }
    out.into_bytes()
}

/// A convex stone after the round brilliant: table, 8 star and 16 girdle facets above, a girdle, 16 facets below.
fn gem() -> Vec<u8> {
    let mut out =
        String::from("# A faceted stone: table 0.55, crown 34.5 degrees, pavilion 40.75 degrees, girdle radius 1.\n");
    let degrees = |angle: f64| libm::sincos(angle * PI / 180.0);
    let slope = |angle: f64| degrees(angle).0 / degrees(angle).1;
    let girdle = 0.03;
    let mut ring = |count: i32, radius: f64, y: f64| {
        for i in 0..count {
            let (s, c) = degrees(360.0 * f64::from(i) / f64::from(count));
            obj_line(&mut out, "v", [radius * s, y, radius * c]);
        }
    };
    ring(8, 0.55, girdle + 0.45 * slope(34.5));
    ring(16, 1.0, girdle);
    ring(16, 1.0, -girdle);
    obj_line(&mut out, "v", [0.0, -girdle - slope(40.75), 0.0]);

    let table = |k: i32| k.rem_euclid(8) + 1;
    let upper = |k: i32| k.rem_euclid(16) + 9;
    let lower = |k: i32| k.rem_euclid(16) + 25;
    let culet = 41;
    let mut face = |corners: &[i32]| {
        let corners: Vec<String> = corners.iter().map(i32::to_string).collect();
        writeln!(out, "f {}", corners.join(" ")).expect("a String");
    };
    face(&[0, 1, 2, 3, 4, 5, 6, 7].map(table));
    for k in 0..8 {
        face(&[table(k), upper(2 * k + 1), table(k + 1)]);
        face(&[table(k), upper(2 * k - 1), upper(2 * k)]);
        face(&[table(k), upper(2 * k), upper(2 * k + 1)]);
    }
    for k in 0..16 {
        face(&[upper(k), lower(k), lower(k + 1), upper(k + 1)]);
        face(&[lower(k), culet, lower(k + 1)]);
    }
    out.into_bytes()
}

type Sphere = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// A convex solid with all corners on the unit sphere, its triangles cut in four `levels` times.
fn subdivided((mut points, mut faces): Sphere, levels: u32) -> Sphere {
    for _ in 0..levels {
        let mut middles = std::collections::BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let (p, q) = (points[a as usize], points[b as usize]);
                points.push(normalized([p[0] + q[0], p[1] + q[1], p[2] + q[2]]));
                points.len() as u32 - 1
            })
        };
        let cut = |[a, b, c]: [u32; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(cut).collect();
    }
    (points, faces)
}

fn normalized([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

fn octahedron() -> Sphere {
    let points =
        vec![[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let faces = vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    (points, faces)
}

fn icosahedron() -> Sphere {
    let g = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let points = [
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ];
    let faces = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    (points.map(normalized).to_vec(), faces)
}

fn ply_header(format: &str, comment: &str, vertices: usize, faces: usize) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment {comment}\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
         property float z\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    )
}

/// The unit sphere as 1280 triangles, in little-endian binary.
fn icosphere() -> Vec<u8> {
    let (points, faces) = subdivided(icosahedron(), 3);
    let comment = "The unit sphere, an icosahedron cut three times.";
    let mut out = ply_header("binary_little_endian", comment, points.len(), faces.len()).into_bytes();
    for x in points.into_iter().flatten() {
        out.extend((x as f32).to_le_bytes());
    }
    for face in faces {
        out.push(3);
        face.into_iter().for_each(|index| out.extend((index as i32).to_le_bytes()));
    }
    out
}

/// A sphere with waves on it as 2048 triangles, in text.
fn bumpy_sphere() -> Vec<u8> {
    let (points, faces) = subdivided(octahedron(), 4);
    let comment = "A unit sphere with waves on it, an octahedron cut four times.";
    let mut out = ply_header("ascii", comment, points.len(), faces.len());
    for p in points {
        let [sx, sy, sz] = p.map(|x| libm::sin(5.0 * x));
        let r = 1.0 + 0.06 * (sx + sy + sz);
        let [x, y, z] = p.map(|x| decimal(r * x, 6));
        writeln!(out, "{x} {y} {z}").expect("a String takes everything");
    }
    for [a, b, c] in faces {
        writeln!(out, "3 {a} {b} {c}").expect("a String takes everything");
    }
    out.into_bytes()
}
