//! What is written is read back, and what is damaged is read or refused.

use proptest::prelude::*;
use raytree::scene::mesh::{
    MeshData, Rotation, Solidity, Transform, is_closed, parse_obj, parse_ply, signed_volume, smooth_normals, solidity,
};

use super::{TETRAHEDRON, TRIANGLE, generated, obj, ply_binary, ply_text, shapes};

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
