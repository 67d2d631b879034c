//! One test: a box or a shape against the best so far.

use super::nearest::{Candidate, Detail, Sink};
use super::probe::{BoundsTest, BoundsVerdict, Probe, Reason, ShapeTest, Test, Values, Verdict};
use super::slabs::{Bounds, SlabRay};
use super::start::Departure;
use super::values;
use super::world::{Geometry, MeshGeometry, World};
use crate::kernels::aabb::{intersect_box_certified, intersect_box_explicit_zero, intersect_box_lecture};
use crate::kernels::plane::{intersect_plane_certified, intersect_plane_lecture};
use crate::kernels::sphere::{intersect_sphere_certified, intersect_sphere_naive, intersect_sphere_stable};
use crate::kernels::triangle::{
    intersect_triangle_certified, intersect_triangle_lecture, intersect_triangle_moller_trumbore,
};
use crate::kernels::{
    Aabb, BoxHit, Miss, Plane, Ray, Sphere, SphereHit, Start, Triangle, TriangleFilter, TriangleHit, are_coplanar,
};
use crate::numbers::Real;
use crate::scene::{Numerics, ObjectId};

/// What a kernel finds, in the terms of a [`Candidate`].
struct Found<R> {
    t: f64,
    t_error: f64,
    primitive: Option<u32>,
    detail: Detail<R>,
}

/// What a bounding box is around.
#[derive(Clone, Copy, Debug)]
pub(super) struct Owner {
    pub(super) object: Option<ObjectId>,
    pub(super) primitive: Option<u32>,
    pub(super) node: Option<u32>,
    pub(super) in_mesh: bool,
    pub(super) around_one: bool,
}

/// Where the ray enters a box, if what is inside can still matter.
#[inline(always)]
pub(super) fn enters<P: Probe>(
    limit: f64,
    probe: &mut P,
    slabs: &SlabRay,
    bounds: &Bounds,
    owner: Owner,
) -> Option<f64> {
    let (t_in, t_out) = slabs.span(bounds);
    let verdict = if !(t_in <= t_out) {
        BoundsVerdict::Missed
    } else if t_in > limit {
        BoundsVerdict::Farther
    } else {
        BoundsVerdict::Entered
    };
    probe.saw(|| {
        let Owner { object, primitive, node, in_mesh, around_one } = owner;
        Test::Bounds(BoundsTest { object, primitive, node, in_mesh, around_one, bounds: *bounds, t_in, t_out, verdict })
    });
    (verdict == BoundsVerdict::Entered).then_some(t_in)
}

/// Tests an object that is not a mesh.
#[inline(always)]
pub(super) fn object<R: Real, S: Sink<R>, P: Probe>(
    world: &World<R>,
    ray: &Ray<R>,
    id: ObjectId,
    t_in: f64,
    departure: Departure<'_>,
    sink: &mut S,
    probe: &mut P,
) {
    let numerics = world.numerics();
    let geometry = world.geometry(id);
    // A convex solid that the ray left outward, and a flat shape that it left at all, cannot be hit again.
    let start = match geometry {
        Geometry::Sphere(_) | Geometry::Box(_) => departure.from_convex(id),
        Geometry::Plane(_) | Geometry::Triangle(_) | Geometry::Mesh(_) => {
            (!departure.left(id)).then_some(Start::Anywhere)
        }
    };
    let Some(start) = start else {
        let verdict = Verdict::Rejected { t: None, reason: Reason::Left };
        probe.saw(|| Test::Shape(ShapeTest { object: id, primitive: None, values: Values::new(), verdict }));
        return;
    };
    let test = |start| {
        Some(match geometry {
            Geometry::Sphere(sphere) => test_sphere(numerics, ray, sphere, start),
            Geometry::Plane(plane) => test_plane(numerics, ray, plane),
            Geometry::Box(aabb) => test_box(numerics, ray, aabb, start),
            Geometry::Triangle(triangle) => {
                let filter = (numerics == Numerics::Certified).then(|| TriangleFilter::of_triangle(ray, triangle));
                test_triangle(numerics, ray, triangle, filter.as_ref(), None)
            }
            // Tested triangle by triangle, by a `MeshTest`.
            Geometry::Mesh(_) => return None,
        })
    };
    let Some(mut found) = test(start) else { return };
    if let Ok(Found { t, detail: Detail::Sphere { near: true, .. } | Detail::Box { near: true, .. }, .. }) = found
        && departure.is_too_near(t)
    {
        // The near root lies within the epsilon: the far one may count.
        found = test(Start::OnSurfaceInward).unwrap_or(found);
    }
    let offered = offer(world, ray, departure, id, None, t_in, found, sink);
    probe.saw(|| {
        let values = values::of_object(numerics, ray, geometry);
        Test::Shape(ShapeTest { object: id, primitive: None, values, verdict: offered })
    });
}

/// The tests of a mesh's triangles by one ray.
pub(super) struct MeshTest<'a, R: Real> {
    world: &'a World<R>,
    mesh: &'a MeshGeometry<R>,
    ray: &'a Ray<R>,
    id: ObjectId,
    departure: Departure<'a>,
    /// Whether the ray left triangles of this mesh.
    left: bool,
    filter: Option<TriangleFilter>,
}

impl<'a, R: Real> MeshTest<'a, R> {
    #[inline(always)]
    pub(super) fn new(
        world: &'a World<R>,
        mesh: &'a MeshGeometry<R>,
        ray: &'a Ray<R>,
        id: ObjectId,
        departure: Departure<'a>,
    ) -> Self {
        let filter =
            (world.numerics() == Numerics::Certified).then(|| TriangleFilter::new(ray, &mesh.aabb, mesh.longest_edge));
        Self { world, mesh, ray, id, departure, left: departure.left(id), filter }
    }

    /// Tests one triangle.
    #[inline(always)]
    pub(super) fn triangle<S: Sink<R>, P: Probe>(&mut self, primitive: u32, t_in: f64, sink: &mut S, probe: &mut P) {
        if self.left && self.departure.triangles_of(self.id).any(|left| left == primitive) {
            let verdict = Verdict::Rejected { t: None, reason: Reason::Left };
            let (object, primitive) = (self.id, Some(primitive));
            probe.saw(|| Test::Shape(ShapeTest { object, primitive, values: Values::new(), verdict }));
            return;
        }
        let numerics = self.world.numerics();
        let triangle = &self.mesh.triangles[primitive as usize];
        let found = test_triangle(numerics, self.ray, triangle, self.filter.as_ref(), Some(primitive));
        let mut verdict = None;
        if self.left && found.is_ok() {
            verdict = self.in_plane_left(triangle);
        }
        let verdict = match verdict {
            Some(reason) => Verdict::Rejected { t: None, reason },
            None => offer(self.world, self.ray, self.departure, self.id, Some(primitive), t_in, found, sink),
        };
        probe.saw(|| {
            let values = values::of_triangle(numerics, self.ray, triangle);
            Test::Shape(ShapeTest { object: self.id, primitive: Some(primitive), values, verdict })
        });
    }

    /// Whether the ray starts in the plane of this triangle, on another one.
    #[cold]
    fn in_plane_left(&self, triangle: &Triangle<R>) -> Option<Reason> {
        let mut left = self.departure.triangles_of(self.id);
        let is_coplanar = left.any(|left| are_coplanar(&self.mesh.triangles[left as usize], triangle));
        is_coplanar.then_some(Reason::CoplanarWithLeft)
    }
}

/// Offers `sink` what a kernel found.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "everything that is known of one test")]
fn offer<R: Real, S: Sink<R>>(
    world: &World<R>,
    ray: &Ray<R>,
    departure: Departure<'_>,
    object: ObjectId,
    primitive: Option<u32>,
    t_in: f64,
    found: Result<Found<R>, Miss>,
    sink: &mut S,
) -> Verdict {
    let found = match found {
        Ok(found) => found,
        Err(miss) => return Verdict::Rejected { t: None, reason: Reason::Miss(miss) },
    };
    let Found { t, t_error, detail, .. } = found;
    if !t.is_finite() {
        return Verdict::Rejected { t: None, reason: Reason::NotFinite };
    }
    if departure.is_too_near(t) {
        return Verdict::Rejected { t: Some(t), reason: Reason::WithinEpsilon };
    }
    // Without this, a hit that rounding put in front of its box would be found or pruned depending on the order of
    // visits.
    if t + t_error < t_in {
        return Verdict::Rejected { t: Some(t), reason: Reason::BeforeItsBox };
    }
    let candidate = Candidate { object, primitive: primitive.or(found.primitive), t, t_error, detail };
    match sink.offer(world, ray, candidate) {
        Ok(()) => Verdict::Best { t },
        Err(reason) => Verdict::Rejected { t: Some(t), reason },
    }
}

#[inline(always)]
fn test_plane<R: Real>(numerics: Numerics, ray: &Ray<R>, plane: &Plane<R>) -> Result<Found<R>, Miss> {
    let (t, t_error) = match numerics {
        Numerics::Lecture | Numerics::Robust => (intersect_plane_lecture(ray, plane)?.t.to_f64(), 0.0),
        Numerics::Certified => {
            let found = intersect_plane_certified(ray, plane)?;
            (found.t, found.t_error)
        }
    };
    Ok(Found { t, t_error, primitive: None, detail: Detail::Plane })
}

#[inline(always)]
fn test_sphere<R: Real>(numerics: Numerics, ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Result<Found<R>, Miss> {
    let plain = |hit: SphereHit<R>| (hit, hit.t.to_f64(), 0.0);
    let (hit, t, t_error) = match numerics {
        Numerics::Lecture => plain(intersect_sphere_naive(ray, sphere, start)?),
        Numerics::Robust => plain(intersect_sphere_stable(ray, sphere, start)?),
        Numerics::Certified => {
            let found = intersect_sphere_certified(ray, sphere, start)?;
            (found.hit, found.t, found.t_error)
        }
    };
    let SphereHit { t_in, t_out, .. } = hit;
    let near = start == Start::Anywhere && hit.t == t_in;
    Ok(Found { t, t_error, primitive: None, detail: Detail::Sphere { t_in, t_out, near, start } })
}

#[inline(always)]
fn test_box<R: Real>(numerics: Numerics, ray: &Ray<R>, aabb: &Aabb<R>, start: Start) -> Result<Found<R>, Miss> {
    let plain = |hit: BoxHit<R>| (hit, hit.t.to_f64(), 0.0);
    let (hit, t, t_error) = match numerics {
        Numerics::Lecture => plain(intersect_box_lecture(ray, aabb, start)?),
        Numerics::Robust => plain(intersect_box_explicit_zero(ray, aabb, start)?),
        Numerics::Certified => {
            let found = intersect_box_certified(ray, aabb, start)?;
            (found.hit, found.t, found.t_error)
        }
    };
    let BoxHit { t_in, t_out, face, .. } = hit;
    let near = start == Start::Anywhere && hit.t == t_in;
    Ok(Found { t, t_error, primitive: Some(face), detail: Detail::Box { t_in, t_out, near, start } })
}

#[inline(always)]
fn test_triangle<R: Real>(
    numerics: Numerics,
    ray: &Ray<R>,
    triangle: &Triangle<R>,
    filter: Option<&TriangleFilter>,
    primitive: Option<u32>,
) -> Result<Found<R>, Miss> {
    let plain = |hit: TriangleHit<R>| (hit, hit.t.to_f64(), 0.0);
    let (hit, t, t_error) = match (numerics, filter) {
        (Numerics::Lecture, _) => plain(intersect_triangle_lecture(ray, triangle)?),
        (Numerics::Certified, Some(filter)) => {
            let found = intersect_triangle_certified(ray, triangle, filter)?;
            (found.hit, found.t, found.t_error)
        }
        (Numerics::Robust | Numerics::Certified, _) => plain(intersect_triangle_moller_trumbore(ray, triangle)?),
    };
    Ok(Found { t, t_error, primitive, detail: Detail::Triangle { barycentrics: hit.barycentrics } })
}
