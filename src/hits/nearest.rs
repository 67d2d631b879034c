//! What a walk through the geometry is after: the nearest hit, any hit, or all hits at one place.

use std::cmp::Ordering;

use super::probe::Reason;
use super::world::{Geometry, World};
use crate::kernels::order::{Root, compare_t, compare_t_with};
use crate::kernels::{Ray, Start};
use crate::numbers::Real;
use crate::scene::{Numerics, ObjectId};

/// A hit of one shape, before it is known whether it is the nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<R> {
    /// The object.
    pub object: ObjectId,
    /// The triangle of a mesh, the face of a box.
    pub primitive: Option<u32>,
    /// Ray parameter.
    pub t: f64,
    /// The true ray parameter is within this of `t`. 0 for kernels that know no bound: then `t` is taken as it is.
    pub t_error: f64,
    /// What the kernel knows beyond `t`.
    pub detail: Detail<R>,
}

/// What a kernel knows of a hit beyond its `t`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Detail<R> {
    /// Nothing.
    Plane,
    /// The span that the ray's line has inside.
    Sphere {
        /// The smaller root.
        t_in: R,
        /// The larger root.
        t_out: R,
        /// Whether the hit is the smaller one.
        near: bool,
        /// Which roots counted.
        start: Start,
    },
    /// The span that the ray's line has inside.
    Box {
        /// Where it enters.
        t_in: R,
        /// Where it leaves.
        t_out: R,
        /// Whether the hit is where it enters.
        near: bool,
        /// Which roots counted.
        start: Start,
    },
    /// Of a lone triangle or one of a mesh.
    Triangle {
        /// `[a, b, 1-a-b]` for v0, v1, v2.
        barycentrics: [R; 3],
    },
}

impl<R> Detail<R> {
    /// Which roots of a convex solid counted.
    pub fn start(&self) -> Start {
        match self {
            Self::Sphere { start, .. } | Self::Box { start, .. } => *start,
            Self::Plane | Self::Triangle { .. } => Start::Anywhere,
        }
    }
}

/// The nearest hit, and whatever else lies at exactly its `t`.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit<R> {
    /// The nearest: of several at equal `t`, that with the lowest object, then primitive.
    pub nearest: Candidate<R>,
    /// The others at exactly equal `t`, in that order.
    pub tied: Vec<Candidate<R>>,
}

/// Where a ray's span ends before infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Nowhere.
    None,
    /// A hit counts where `t < t_max`.
    Below(f64),
}

impl Limit {
    /// Boxes that begin beyond this hold no hit that counts.
    fn end(self) -> f64 {
        match self {
            Self::None => f64::INFINITY,
            Self::Below(t_max) => t_max,
        }
    }

    /// Whether a hit counts; exact under certified numerics.
    fn admits<R: Real>(self, world: &World<R>, ray: &Ray<R>, candidate: &Candidate<R>) -> bool {
        match self {
            Self::None => true,
            Self::Below(t_max) => is_below(world, ray, candidate, t_max),
        }
    }
}

/// The order of two hits along a ray: exact under certified numerics.
pub(super) fn compare<R: Real>(world: &World<R>, ray: &Ray<R>, a: &Candidate<R>, b: &Candidate<R>) -> Ordering {
    if a.t + a.t_error < b.t - b.t_error {
        return Ordering::Less;
    }
    if b.t + b.t_error < a.t - a.t_error {
        return Ordering::Greater;
    }
    match world.numerics() {
        Numerics::Certified => compare_roots(ray, root(world, a), root(world, b)),
        // Finite numbers; -0 and 0 are a tie.
        Numerics::Lecture | Numerics::Robust => a.t.partial_cmp(&b.t).unwrap_or(Ordering::Equal),
    }
}

/// The exact order of two roots; that of equal shapes needs no arithmetic.
fn compare_roots<R: Real>(ray: &Ray<R>, a: Root<'_, R>, b: Root<'_, R>) -> Ordering {
    let equal = match (a, b) {
        (Root::Plane(a), Root::Plane(b)) => a == b,
        (Root::Triangle(a), Root::Triangle(b)) => a == b,
        (Root::BoxFace(a, i), Root::BoxFace(b, j)) => i == j && a == b,
        (Root::SphereNear(a), Root::SphereNear(b)) | (Root::SphereFar(a), Root::SphereFar(b)) => a == b,
        _ => false,
    };
    if equal { Ordering::Equal } else { compare_t(ray, a, b) }
}

/// Whether a hit lies in front of `t_max`: exact under certified numerics.
fn is_below<R: Real>(world: &World<R>, ray: &Ray<R>, candidate: &Candidate<R>, t_max: f64) -> bool {
    if candidate.t + candidate.t_error < t_max {
        return true;
    }
    if candidate.t - candidate.t_error > t_max || world.numerics() != Numerics::Certified {
        return candidate.t < t_max;
    }
    compare_t_with(ray, root(world, candidate), t_max) == Ordering::Less
}

/// The exact root that a candidate stands for.
fn root<'a, R: Real>(world: &'a World<R>, candidate: &Candidate<R>) -> Root<'a, R> {
    match (world.geometry(candidate.object), candidate.detail, candidate.primitive) {
        (Geometry::Plane(plane), ..) => Root::Plane(plane),
        (Geometry::Triangle(triangle), ..) => Root::Triangle(triangle),
        (Geometry::Mesh(mesh), _, primitive) => Root::Triangle(mesh.triangle(primitive)),
        (Geometry::Box(aabb), _, face) => Root::BoxFace(aabb, face.unwrap_or_default()),
        (Geometry::Sphere(sphere), Detail::Sphere { near: true, .. }, _) => Root::SphereNear(sphere),
        (Geometry::Sphere(sphere), ..) => Root::SphereFar(sphere),
    }
}

/// What a walk is after. It is offered every hit whose box the ray enters before [`Sink::limit`].
pub(super) trait Sink<R: Real> {
    /// Boxes that begin beyond this need not be entered.
    fn limit(&self) -> f64;
    /// Takes a hit, or says why not.
    fn offer(&mut self, world: &World<R>, ray: &Ray<R>, candidate: Candidate<R>) -> Result<(), Reason>;
}

/// Keeps the nearest hit.
pub(super) struct Nearest<R> {
    pub(super) best: Option<Candidate<R>>,
    pub(super) tied: bool,
    t_max: Limit,
    limit: f64,
}

impl<R: Real> Nearest<R> {
    pub(super) fn new(t_max: Limit) -> Self {
        Self { best: None, tied: false, t_max, limit: t_max.end() }
    }
}

impl<R: Real> Sink<R> for Nearest<R> {
    #[inline(always)]
    fn limit(&self) -> f64 {
        self.limit
    }
    fn offer(&mut self, world: &World<R>, ray: &Ray<R>, candidate: Candidate<R>) -> Result<(), Reason> {
        if !self.t_max.admits(world, ray, &candidate) {
            return Err(Reason::BeyondLight);
        }
        if let Some(best) = &self.best {
            let by_t = compare(world, ray, &candidate, best);
            let by_index = (candidate.object, candidate.primitive).cmp(&(best.object, best.primitive));
            self.tied = match by_t {
                Ordering::Less => false,
                Ordering::Equal => true,
                Ordering::Greater => self.tied,
            };
            if by_t.then(by_index).is_ge() {
                return Err(Reason::Farther);
            }
        }
        // The limit never grows, even where a nearer hit has the wider error: so no order of visits prunes the nearest.
        self.limit = self.limit.min(candidate.t + candidate.t_error);
        self.best = Some(candidate);
        Ok(())
    }
}

/// Stops at any hit.
pub(super) struct Any {
    pub(super) found: bool,
    t_max: Limit,
    limit: f64,
}

impl Any {
    pub(super) fn new(t_max: Limit) -> Self {
        Self { found: false, t_max, limit: t_max.end() }
    }
}

impl<R: Real> Sink<R> for Any {
    #[inline(always)]
    fn limit(&self) -> f64 {
        self.limit
    }
    fn offer(&mut self, world: &World<R>, ray: &Ray<R>, candidate: Candidate<R>) -> Result<(), Reason> {
        if !self.t_max.admits(world, ray, &candidate) {
            return Err(Reason::BeyondLight);
        }
        self.found = true;
        // No box begins before this: the walk runs dry.
        self.limit = -1.0;
        Ok(())
    }
}

/// Gathers the hits at exactly the `t` of another.
pub(super) struct TiedWith<R> {
    target: Candidate<R>,
    pub(super) others: Vec<Candidate<R>>,
}

impl<R: Real> TiedWith<R> {
    pub(super) fn new(target: Candidate<R>) -> Self {
        Self { target, others: Vec::new() }
    }
}

impl<R: Real> Sink<R> for TiedWith<R> {
    fn limit(&self) -> f64 {
        self.target.t + self.target.t_error
    }
    fn offer(&mut self, world: &World<R>, ray: &Ray<R>, candidate: Candidate<R>) -> Result<(), Reason> {
        let same = (candidate.object, candidate.primitive) == (self.target.object, self.target.primitive);
        if same || compare(world, ray, &candidate, &self.target) != Ordering::Equal {
            return Err(Reason::Farther);
        }
        self.others.push(candidate);
        Ok(())
    }
}

/// Gathers all hits.
pub(super) struct All<R>(pub(super) Vec<Candidate<R>>);

impl<R: Real> Sink<R> for All<R> {
    fn limit(&self) -> f64 {
        f64::INFINITY
    }
    fn offer(&mut self, _: &World<R>, _: &Ray<R>, candidate: Candidate<R>) -> Result<(), Reason> {
        self.0.push(candidate);
        Ok(())
    }
}
