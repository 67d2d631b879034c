//! Objects: a shape with a material and a name.

use glam::DVec3;

use super::MaterialId;

/// A shape with a material and a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// What the tree calls it.
    pub name: String,
    /// What it is made of.
    pub material: MaterialId,
    /// Where it is.
    pub shape: Shape,
}

/// The closed set of shapes, in world space.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A sphere.
    Sphere {
        /// Its centre.
        center: DVec3,
        /// 0 or larger.
        radius: f64,
    },
    /// A plane in Hesse normal form: all `p` with `p . normal = distance`.
    Plane {
        /// Unit vector.
        normal: DVec3,
        /// Distance from the origin along the normal.
        distance: f64,
    },
    /// An axis-aligned box.
    Box {
        /// The corner with the smallest coordinates.
        min: DVec3,
        /// The corner with the largest.
        max: DVec3,
    },
    /// A lone triangle; bounds no solid.
    Triangle {
        /// v0, v1, v2.
        vertices: [DVec3; 3],
    },
    /// Many triangles.
    Mesh(Mesh),
}

impl Shape {
    /// Whether the shape bounds a solid: a sphere, a box, a closed mesh; a plane bounds what lies below it.
    pub fn is_solid(&self) -> bool {
        match self {
            Self::Sphere { .. } | Self::Plane { .. } | Self::Box { .. } => true,
            Self::Triangle { .. } => false,
            Self::Mesh(mesh) => mesh.closed,
        }
    }

    /// The largest magnitude among its coordinates and lengths.
    pub fn largest_coordinate(&self) -> f64 {
        let of = |v: &DVec3| v.abs().max_element();
        match self {
            Self::Sphere { center, radius } => of(center) + radius,
            Self::Plane { distance, .. } => distance.abs(),
            Self::Box { min, max } => of(min).max(of(max)),
            Self::Triangle { vertices } => vertices.iter().map(of).fold(0.0, f64::max),
            Self::Mesh(mesh) => mesh.triangles.iter().flatten().map(of).fold(0.0, f64::max),
        }
    }

    /// The word for it in the scene file.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Plane { .. } => "plane",
            Self::Box { .. } => "box",
            Self::Triangle { .. } => "triangle",
            Self::Mesh(_) => "mesh",
        }
    }
}

/// Triangles with the transform of the scene file already applied.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// v0, v1, v2 of each triangle.
    pub triangles: Vec<[DVec3; 3]>,
    /// Unit normals at v0, v1, v2 of each triangle, where the mesh is to look smooth.
    pub corner_normals: Option<Vec<[DVec3; 3]>>,
    /// Whether the triangles bound a solid with all normals outward.
    pub closed: bool,
}
