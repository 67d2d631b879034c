//! How a ray starts: on the surfaces it left, by identity; or beyond the lecture's epsilon.

use super::nearest::{Candidate, Detail};
use crate::kernels::Start;
use crate::numbers::Real;
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

impl Left {
    /// The hit at the very start of the ray, as far as its place matters.
    pub(crate) fn at_start<R: Real>(&self) -> Candidate<R> {
        let Self { object, primitive, .. } = *self;
        Candidate { object, primitive, t: 0.0, t_error: 0.0, detail: Detail::Plane }
    }
}

/// How a ray starts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Departure<'a> {
    /// The surfaces it starts on, by identity: none for a camera ray, one for most others, more where several were met
    /// at equal `t`.
    pub left: &'a [Left],
    /// Hits at `t` up to this do not count; nothing where all at `0 <= t` do.
    pub epsilon: Option<f64>,
}

impl<'a> Departure<'a> {
    /// How a sphere or box is to be tested; nothing if not at all, since the ray left it outward and it is convex.
    #[inline(always)]
    pub fn from_convex(&self, object: ObjectId) -> Option<Start> {
        match self.left.iter().find(|left| left.object == object) {
            None => Some(Start::Anywhere),
            Some(left) if left.inward => Some(Start::OnSurfaceInward),
            Some(_) => None,
        }
    }

    /// Whether a hit is too near to count.
    #[inline(always)]
    pub fn is_too_near(&self, t: f64) -> bool {
        self.epsilon.is_some_and(|epsilon| t <= epsilon)
    }

    /// Whether the ray left this object, which is flat or a mesh.
    #[inline(always)]
    pub fn left(&self, object: ObjectId) -> bool {
        self.left.iter().any(|left| left.object == object)
    }

    /// The triangles of this mesh that the ray left.
    pub fn triangles_of(self, mesh: ObjectId) -> impl Iterator<Item = u32> + use<'a> {
        self.left.iter().filter(move |left| left.object == mesh).filter_map(|left| left.primitive)
    }
}
