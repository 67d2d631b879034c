//! The probe: sees every box and shape test of one ray, and vanishes when nobody looks.

use super::slabs::Bounds;
use crate::kernels::Miss;
use crate::scene::ObjectId;

/// Sees every test of one ray. The test is made into a record only by a probe that keeps it.
pub trait Probe: Default {
    /// Called once a test, in order.
    fn saw(&mut self, test: impl FnOnce() -> Test);
}

/// Looks away.
impl Probe for () {
    #[inline(always)]
    fn saw(&mut self, _: impl FnOnce() -> Test) {}
}

/// Counts the tests, box tests and shape tests together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count(pub u64);

impl Probe for Count {
    #[inline(always)]
    fn saw(&mut self, _: impl FnOnce() -> Test) {
        self.0 += 1;
    }
}

/// Keeps the tests, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tests(pub Vec<Test>);

impl Probe for Tests {
    fn saw(&mut self, test: impl FnOnce() -> Test) {
        self.0.push(test());
    }
}

/// One test of a ray.
#[derive(Clone, Debug, PartialEq)]
pub enum Test {
    /// Of a bounding box.
    Bounds(BoundsTest),
    /// Of a shape.
    Shape(ShapeTest),
}

/// A test of a bounding box.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundsTest {
    /// The object, where the box is around one object or lies inside a mesh; nothing in the hierarchy of objects.
    pub object: Option<ObjectId>,
    /// The triangle, where the box is around one.
    pub primitive: Option<u32>,
    /// The node of the hierarchy; nothing in a list.
    pub node: Option<u32>,
    /// Whether that is the hierarchy of the object's triangles, not of the scene's objects.
    pub in_mesh: bool,
    /// Whether the box is around one shape or triangle alone.
    pub around_one: bool,
    /// The box.
    pub bounds: Bounds,
    /// Where the ray enters, a little too small; infinite where it runs beside a slab.
    pub t_in: f64,
    /// Where the ray leaves, a little too large; -infinite where it runs beside a slab.
    pub t_out: f64,
    /// What follows.
    pub verdict: BoundsVerdict,
}

/// What follows from a test of a bounding box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundsVerdict {
    /// What is inside is tested.
    Entered,
    /// The ray passes it: what is inside is pruned.
    Missed,
    /// It begins beyond the best hit so far: what is inside is pruned.
    Farther,
}

/// A test of a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeTest {
    /// The object.
    pub object: ObjectId,
    /// The triangle of a mesh.
    pub primitive: Option<u32>,
    /// The kernel's intermediate values under the letters of its source.
    pub values: Values,
    /// The outcome.
    pub verdict: Verdict,
}

/// The outcome of a shape's test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// The nearest so far.
    Best {
        /// Ray parameter.
        t: f64,
    },
    /// Not the nearest, and why.
    Rejected {
        /// Ray parameter, where there is a hit.
        t: Option<f64>,
        /// Why.
        reason: Reason,
    },
}

/// Why a shape is not the nearest hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The kernel found none.
    Miss(Miss),
    /// There is a nearer one, or one at equal `t` with a lower index.
    Farther,
    /// It lies at or beyond the light that the shadow ray goes to.
    BeyondLight,
    /// The ray starts on it.
    Left,
    /// It lies in the plane of the triangle that the ray starts on.
    CoplanarWithLeft,
    /// It lies within the epsilon that stands for the surface the ray starts on.
    WithinEpsilon,
    /// The computed `t` is infinite or no number.
    NotFinite,
    /// The computed hit lies in front of the shape's bounding box, so rounding made it up.
    BeforeItsBox,
}

/// Named intermediate values, in the order in which they arise.
pub type Values = Vec<(&'static str, Quantity)>;

/// A number or a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Number(f64),
    /// A vector.
    Vector([f64; 3]),
}
