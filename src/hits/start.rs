//! Where a ray starts: the surfaces it left, by identity. No epsilon, no moved origin.

use crate::kernels::Start;
use crate::scene::ObjectId;

/// A surface that a ray starts on, and the side it means to be on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Left {
    /// The object.
    pub object: ObjectId,
    /// The triangle of a mesh, the face of a box.
    pub primitive: Option<u32>,
    /// Whether the ray goes into the solid; means nothing for flat shapes.
    pub inward: bool,
}

/// The surfaces a ray starts on: none for a camera ray, one for most others, more where several were met at equal `t`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Departure<'a>(pub &'a [Left]);

impl<'a> Departure<'a> {
    /// How a sphere or box is to be tested; nothing if not at all, since the ray left it outward and it is convex.
    #[inline(always)]
    pub fn from_convex(&self, object: ObjectId) -> Option<Start> {
        match self.0.iter().find(|left| left.object == object) {
            None => Some(Start::Anywhere),
            Some(left) if left.inward => Some(Start::OnSurfaceInward),
            Some(_) => None,
        }
    }

    /// Whether the ray left this object, which is flat or a mesh.
    #[inline(always)]
    pub fn left(&self, object: ObjectId) -> bool {
        self.0.iter().any(|left| left.object == object)
    }

    /// The triangles of this mesh that the ray left.
    pub fn triangles_of(self, mesh: ObjectId) -> impl Iterator<Item = u32> + use<'a> {
        self.0.iter().filter(move |left| left.object == mesh).filter_map(|left| left.primitive)
    }
}
