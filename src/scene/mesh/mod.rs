//! Triangle meshes: read from OBJ and PLY, placed in the world, and judged as surfaces.
//!
//! Everything here is a function of bytes or of plain data; files are opened by whoever calls. Nothing is repaired
//! in silence: what a file says is what is traced, and what cannot be traced is a [`MeshError`] that says where it
//! stands and what would be right.

mod error;
mod obj;
mod ply;
mod range;
mod surface;
mod text;
mod transform;

pub use error::MeshError;
pub use obj::parse_obj;
pub use ply::parse_ply;
pub use surface::{Solidity, is_closed, orient_outward, signed_volume, smooth_normals, solidity};
pub use transform::{Rotation, Transform};

use crate::kernels::{Triangle, triangle_normal};
use crate::numbers::unit;

/// A triangle mesh as it was stored: faces in file order, the corners of each in file order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshData {
    /// Vertex positions; every coordinate is a multiple of 2^-178 of magnitude at most 2^128.
    pub positions: Vec<[f64; 3]>,
    /// For each triangle the indices into `positions` of v0, v1, v2; all in range. Its normal is
    /// `(v1 - v0) x (v2 - v0)`.
    pub faces: Vec<[u32; 3]>,
    /// For each triangle the shading normals at v0, v1, v2, of unit length; absent where the file has none. They are
    /// stored by corner, not by vertex, because OBJ gives normals their own indices: one position may have several.
    pub corner_normals: Option<Vec<[[f64; 3]; 3]>>,
}

impl MeshData {
    /// The corners v0, v1, v2 of a face.
    ///
    /// # Example
    /// ```
    /// let mesh = raytree::scene::mesh::parse_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 1").unwrap();
    /// assert_eq!(mesh.corners(mesh.faces[0]), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]]);
    /// ```
    pub fn corners(&self, face: [u32; 3]) -> [[f64; 3]; 3] {
        face.map(|index| self.positions[index as usize])
    }
}

/// The mesh stored in `bytes`, in the format that the ending of its file name says: `.obj` or `.ply`, in either case.
///
/// # Errors
/// A name with another ending, and whatever [`parse_obj`] and [`parse_ply`] refuse.
pub fn parse_mesh(file_name: &str, bytes: &[u8]) -> Result<MeshData, MeshError> {
    match parser(file_name) {
        Some(parse) => parse(bytes),
        None => Err(MeshError::whole(
            format!("the format of a mesh file called {} is unknown", text::quoted(file_name)),
            "the name ends in .obj or .ply",
        )),
    }
}

/// Whether the ending of a file name says that [`parse_mesh`] reads it.
pub fn has_known_ending(file_name: &str) -> bool {
    parser(file_name).is_some()
}

type Parser = fn(&[u8]) -> Result<MeshData, MeshError>;

fn parser(file_name: &str) -> Option<Parser> {
    let ending = file_name.rsplit_once('.').map_or("", |(_, ending)| ending);
    let parsers: [(&str, Parser); 2] = [("obj", parse_obj), ("ply", parse_ply)];
    parsers.into_iter().find(|(known, _)| ending.eq_ignore_ascii_case(known)).map(|(_, parse)| parse)
}

/// The unit normal of the triangle v0 v1 v2, or +z where it has no area: such a triangle is never hit.
fn face_normal(corners: [[f64; 3]; 3]) -> [f64; 3] {
    let triangle = Triangle::<f64> { vertices: corners.map(glam::DVec3::from_array) };
    match triangle_normal(&triangle).to_array() {
        [0.0, 0.0, 0.0] => [0.0, 0.0, 1.0],
        normal => normal,
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
