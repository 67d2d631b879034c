//! What a mesh is as a surface: closed or open, wound outward or inward, smooth.
//!
//! Everything here goes by position: corners at equal coordinates (0 and -0 are equal) are one point, whatever their
//! indices, because files repeat vertices along seams of texture and normals.
//!
//! A closed mesh whose faces wind inward is kept as it is stored, and is no solid. Flipping it would reorder v0, v1,
//! v2 against the file, so that barycentrics and normals would no longer compare with those of other programs that
//! read the same file; and a room seen from inside is a fair thing to model. Whoever means a solid calls
//! [`orient_outward`].

use crate::scene::mesh::{MeshData, cross, dot, face_normal, minus, unit};

/// Whether a mesh bounds a solid, and if not, why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solidity {
    /// Closed, with normals that point outward.
    Solid,
    /// Closed, but its normals point inward.
    Inward,
    /// Closed, but the volume is too small for its sign to be certain, or zero.
    Flat,
    /// Not closed: an edge is not met by exactly one face that runs along it the other way.
    Open {
        /// The first face with such an edge.
        face: usize,
        /// The ends of the edge, in the order in which that face runs along it.
        edge: [[f64; 3]; 2],
    },
}

/// Whether a mesh bounds a solid, and if not, why.
///
/// # Accuracy
/// Closedness is exact, and the sign of the volume is certain. Several closed parts are judged by the sum of their
/// volumes, so that a hollow ball is solid; parts that cut through one another are not noticed. Takes O(n log n).
///
/// # Example
/// ```
/// use raytree::scene::mesh::{Solidity, parse_obj, solidity};
/// let tetrahedron = parse_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4").unwrap();
/// assert_eq!(solidity(&tetrahedron), Solidity::Solid);
/// ```
pub fn solidity(mesh: &MeshData) -> Solidity {
    if let Some((face, edge)) = first_open_edge(mesh) {
        return Solidity::Open { face, edge };
    }
    let (volume, bound) = volume_and_bound(mesh);
    if volume > bound {
        Solidity::Solid
    } else if volume < -bound {
        Solidity::Inward
    } else {
        Solidity::Flat
    }
}

/// Whether the mesh is closed and consistently wound: each directed edge belongs to one face only, and its opposite to
/// exactly one other.
///
/// Faces with two corners at one position are passed over, as their edges cancel (the poles of a sphere made of
/// quads). Parts may touch in a point. A mesh without faces is not closed.
pub fn is_closed(mesh: &MeshData) -> bool {
    !mesh.faces.is_empty() && first_open_edge(mesh).is_none()
}

fn first_open_edge(mesh: &MeshData) -> Option<(usize, [[f64; 3]; 2])> {
    let points = weld(mesh);
    let welded = |face: [u32; 3]| face.map(|index| points[index as usize]);
    let edges_of = |[a, b, c]: [u32; 3]| {
        let collapsed = a == b || b == c || c == a;
        [(a, b), (b, c), (c, a)].into_iter().filter(move |_| !collapsed)
    };
    let mut edges: Vec<(u32, u32)> = mesh.faces.iter().flat_map(|&face| edges_of(welded(face))).collect();
    edges.sort_unstable();
    // It is enough to look for the opposites: the opposite of a doubled edge finds the pair.
    let is_single = |edge: (u32, u32)| {
        let first = edges.partition_point(|&other| other < edge);
        edges.get(first) == Some(&edge) && edges.get(first + 1) != Some(&edge)
    };
    for (face, &corners) in mesh.faces.iter().enumerate() {
        if let Some((a, b)) = edges_of(welded(corners)).find(|&(a, b)| !is_single((b, a))) {
            return Some((face, [a, b].map(|point| mesh.positions[point as usize])));
        }
    }
    None
}

/// For each vertex the first vertex at the same position.
fn weld(mesh: &MeshData) -> Vec<u32> {
    // Adding 0 turns -0 into 0; then equal positions have equal bits.
    let key = |index: u32| mesh.positions[index as usize].map(|x| (x + 0.0).to_bits());
    let mut order: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    order.sort_unstable_by_key(|&index| (key(index), index));
    let mut first = vec![0; order.len()];
    for (place, &index) in order.iter().enumerate() {
        let before = place.checked_sub(1).map(|place| order[place]).filter(|&before| key(before) == key(index));
        first[index as usize] = before.map_or(index, |before| first[before as usize]);
    }
    first
}

/// The enclosed volume; negative where the faces wind inward.
///
/// # None when
/// The mesh is not closed.
///
/// # Accuracy
/// Off by at most `(n + 16) 2^-53` times the sum of the magnitudes of the tetrahedra's terms, for n faces.
///
/// # Source
/// The divergence theorem: the sum of the signed tetrahedra over all faces, here from the first face's v0.
pub fn signed_volume(mesh: &MeshData) -> Option<f64> {
    is_closed(mesh).then(|| volume_and_bound(mesh).0)
}

fn volume_and_bound(mesh: &MeshData) -> (f64, f64) {
    let Some(&[first, ..]) = mesh.faces.first() else { return (0.0, 0.0) };
    let apex = mesh.positions[first as usize];
    let (mut sum, mut magnitude) = (0.0, 0.0);
    for &face in &mesh.faces {
        let [a, b, c] = mesh.corners(face).map(|corner| minus(corner, apex));
        sum += dot(a, cross(b, c));
        let [a, b, c] = [a, b, c].map(|v| v.map(f64::abs));
        magnitude += a[0] * (b[1] * c[2] + b[2] * c[1])
            + a[1] * (b[2] * c[0] + b[0] * c[2])
            + a[2] * (b[0] * c[1] + b[1] * c[0]);
    }
    // Three rounded differences, two products, a difference and two sums in each term, then n sums; twice for safety.
    let bound = 2.0 * (mesh.faces.len() as f64 + 16.0) * (f64::EPSILON / 2.0) * magnitude;
    (sum / 6.0, bound / 6.0)
}

/// The mesh with v1 and v2 of every face exchanged if it is closed and winds inward, otherwise as it is.
///
/// Shading normals go along with their corners and keep their direction.
pub fn orient_outward(mesh: &mut MeshData) {
    if solidity(mesh) != Solidity::Inward {
        return;
    }
    for face in &mut mesh.faces {
        face.swap(1, 2);
    }
    for corners in mesh.corner_normals.iter_mut().flatten() {
        corners.swap(1, 2);
    }
}

/// For each face the unit shading normals at v0, v1, v2, from the geometry alone: at each position the mean of the
/// normals of the faces that meet there, weighted by their angles at it, so that it does not depend on how a polygon
/// was cut.
///
/// Edges stay sharp only where a position is shared by one face alone: for faceted shapes leave normals out instead.
/// Faces without area count nothing; where the mean is zero, a face's own normal stands in, and for one without area
/// +z.
///
/// # Source
/// Thürmer and Wüthrich, Computing vertex normals from polygonal facets, 1998. The angle is `atan2(|a x b|, a . b)`,
/// which unlike the arc cosine stays accurate near 0 and 180 degrees.
pub fn smooth_normals(mesh: &MeshData) -> Vec<[[f64; 3]; 3]> {
    let points = weld(mesh);
    let mut sums = vec![[0.0; 3]; mesh.positions.len()];
    for &face in &mesh.faces {
        let corners = mesh.corners(face);
        let Some(normal) = unit(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))) else { continue };
        for corner in 0..3 {
            let a = minus(corners[(corner + 1) % 3], corners[corner]);
            let b = minus(corners[(corner + 2) % 3], corners[corner]);
            let area = cross(a, b);
            let angle = libm::atan2(dot(area, area).sqrt(), dot(a, b));
            let sum = &mut sums[points[face[corner] as usize] as usize];
            for axis in 0..3 {
                sum[axis] += angle * normal[axis];
            }
        }
    }
    let at_corners = |&face: &[u32; 3]| {
        let own = face_normal(mesh.corners(face));
        face.map(|index| unit(sums[points[index as usize] as usize]).unwrap_or(own))
    };
    mesh.faces.iter().map(at_corners).collect()
}
