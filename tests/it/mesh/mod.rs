//! Meshes: what the two parsers read and refuse, what a transform does to the bits, which surfaces are closed.

mod damage;
mod reading;
mod solids;
mod transform;

use raytree::scene::mesh::{MeshData, MeshError, parse_mesh, parse_obj};

#[path = "../../../scenes/meshes/shapes.rs"]
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

fn generated(name: &str) -> MeshData {
    let (_, bytes) = shapes::all().into_iter().find(|(known, _)| *known == name).expect(name);
    parse_mesh(name, &bytes).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Holds an error against its place, (0, 0) for none, and part of its message.
fn expect_error(result: Result<MeshData, MeshError>, input: &str, (line, column): (u32, u32), message: &str) {
    let error = result.expect_err(input);
    let place = (error.line.unwrap_or(0), error.column.unwrap_or(0));
    assert!(error.message.contains(message), "{input:?} gave {error}");
    assert_eq!(place, (line, column), "{input:?} gave {error}");
    assert!(!error.help.is_empty(), "{input:?}");
}
