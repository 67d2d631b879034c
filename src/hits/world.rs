//! The geometry of a scene in one precision, ready to be hit.

use std::cmp::Ordering;

use super::bvh::Bvh;
use super::nearest::{All, Any, Candidate, Detail, Hit, Limit, Nearest, Sink, TiedWith, compare};
use super::probe::Probe;
use super::slabs::{Bounds, SlabRay};
use super::start::Departure;
use super::{list, walk};
use crate::kernels::{
    Aabb, InvalidRay, Plane, Ray, Root, Sphere, Triangle, certify_box, certify_plane, certify_sphere, certify_triangle,
    compare_t, longest_edge, plane_facing, triangle_facing, triangle_normal,
};
use crate::numbers::{Certificate, Precision, Real, Vector3, unit};
use crate::scene::{Numerics, ObjectId, Scene, Shape};

/// How candidates are found. Both give the same bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Acceleration {
    /// Every shape is tested, in order: the oracle.
    List,
    /// A bounding volume hierarchy over the objects, and one over the triangles of each mesh.
    #[default]
    Bvh,
}

/// One object's geometry.
#[derive(Clone, Debug)]
pub enum Geometry<R: Real> {
    /// A sphere.
    Sphere(Sphere<R>),
    /// A plane.
    Plane(Plane<R>),
    /// A box.
    Box(Aabb<R>),
    /// A lone triangle.
    Triangle(Triangle<R>),
    /// A mesh.
    Mesh(MeshGeometry<R>),
}

/// A mesh's triangles, and what is known of all of them.
#[derive(Clone, Debug)]
pub struct MeshGeometry<R: Real> {
    /// In the order of the file.
    pub triangles: Vec<Triangle<R>>,
    /// The corners of the box around them.
    pub aabb: Aabb<R>,
    /// The largest component of an edge.
    pub longest_edge: f64,
    /// Each triangle's box.
    pub bounds: Vec<Bounds>,
    /// Over `bounds`.
    pub bvh: Bvh,
}

impl<R: Real> MeshGeometry<R> {
    fn new(triangles: Vec<Triangle<R>>, growth: f64) -> Self {
        let bounds: Vec<Bounds> = triangles.iter().map(|t| Bounds::of::<R>(t.vertices).grown(growth)).collect();
        let around = Bounds::of::<R>(triangles.iter().flat_map(|t| t.vertices));
        Self {
            aabb: Aabb { min: R::Vec3::from_f64(around.min), max: R::Vec3::from_f64(around.max) },
            longest_edge: triangles.iter().map(longest_edge).fold(0.0, f64::max),
            bvh: Bvh::new(&bounds),
            bounds,
            triangles,
        }
    }

    /// The triangle that a hit names; a hit of a mesh always names one.
    #[inline(always)]
    pub fn triangle(&self, primitive: Option<u32>) -> &Triangle<R> {
        &self.triangles[primitive.unwrap_or_default() as usize]
    }
}

/// The geometry of a scene in one precision.
#[derive(Clone, Debug)]
pub struct World<R: Real> {
    geometry: Vec<Geometry<R>>,
    /// Each object's box; nothing around a plane.
    bounds: Vec<Option<Bounds>>,
    /// Over the objects that have one.
    bvh: Bvh,
    bounded: Vec<ObjectId>,
    unbounded: Vec<ObjectId>,
    numerics: Numerics,
    acceleration: Acceleration,
}

impl<R: Real> World<R> {
    /// The geometry of `scene`, rounded to `R`.
    ///
    /// The coordinates have to be in the range of `R`: see [`Precision::largest_coordinate`].
    pub fn new(scene: &Scene, numerics: Numerics, acceleration: Acceleration) -> Self {
        // Certified hits lie in their boxes; the hits of other kernels are rounded, and so may lie a little beside
        // them.
        let growth = match numerics {
            Numerics::Certified => 2.0 * f64::EPSILON,
            Numerics::Lecture | Numerics::Robust => 512.0 * R::UNIT_ROUNDOFF.to_f64(),
        };
        let mut world = Self {
            geometry: Vec::with_capacity(scene.objects.len()),
            bounds: Vec::with_capacity(scene.objects.len()),
            bvh: Bvh::default(),
            bounded: Vec::new(),
            unbounded: Vec::new(),
            numerics,
            acceleration,
        };
        for id in scene.object_ids() {
            let geometry = geometry::<R>(&scene.object(id).shape, growth);
            let around = bounds(&geometry);
            match &around {
                Some(_) => world.bounded.push(id),
                None => world.unbounded.push(id),
            }
            world.bounds.push(around.map(|b| b.grown(growth)));
            world.geometry.push(geometry);
        }
        let boxes: Vec<Bounds> = world.bounds.iter().copied().flatten().collect();
        world.bvh = Bvh::new(&boxes);
        world
    }

    /// The kernels in use.
    #[inline(always)]
    pub fn numerics(&self) -> Numerics {
        self.numerics
    }

    /// The precision in use.
    pub fn precision(&self) -> Precision {
        R::PRECISION
    }

    /// An object's geometry.
    #[inline(always)]
    pub fn geometry(&self, id: ObjectId) -> &Geometry<R> {
        &self.geometry[id.0 as usize]
    }

    /// An object's box, a little larger than the object; nothing around a plane.
    pub(super) fn bounds(&self, id: ObjectId) -> Option<&Bounds> {
        self.bounds[id.0 as usize].as_ref()
    }

    /// The ids of all objects, in order.
    pub(super) fn object_ids(&self) -> impl Iterator<Item = ObjectId> + use<R> {
        (0..self.geometry.len() as u32).map(ObjectId)
    }

    /// The objects without a box.
    pub(super) fn unbounded(&self) -> &[ObjectId] {
        &self.unbounded
    }

    /// The hierarchy over the objects that have a box.
    pub(super) fn bvh(&self) -> &Bvh {
        &self.bvh
    }

    /// The object that an item of [`World::bvh`] stands for.
    pub(super) fn item(&self, item: u32) -> ObjectId {
        self.bounded[item as usize]
    }

    /// The nearest hit of a ray, at `0 <= t` and `t < t_max`.
    ///
    /// # Errors
    /// [`InvalidRay`] for what is no ray; nothing is walked then.
    pub fn nearest<P: Probe>(
        &self,
        ray: &Ray<R>,
        t_max: Limit,
        departure: Departure<'_>,
        probe: &mut P,
    ) -> Result<Option<Hit<R>>, InvalidRay> {
        ray.check()?;
        Ok(self.nearest_of_valid(ray, t_max, departure, probe))
    }

    /// Whether anything is hit at all, as [`World::nearest`] has it.
    ///
    /// # Errors
    /// [`InvalidRay`] for what is no ray; nothing is walked then.
    pub fn is_hit(&self, ray: &Ray<R>, t_max: Limit, departure: Departure<'_>) -> Result<bool, InvalidRay> {
        ray.check()?;
        Ok(self.valid_is_hit(ray, t_max, departure))
    }

    /// [`World::nearest`] of a ray that was made here, and so is one.
    pub(crate) fn nearest_of_valid<P: Probe>(
        &self,
        ray: &Ray<R>,
        t_max: Limit,
        departure: Departure<'_>,
        probe: &mut P,
    ) -> Option<Hit<R>> {
        let mut sink = Nearest::new(t_max);
        self.walk(ray, departure, &mut sink, probe);
        let nearest = sink.best?;
        let mut tied = Vec::new();
        if sink.tied {
            let mut sink = TiedWith::new(nearest);
            self.walk(ray, departure, &mut sink, &mut ());
            tied = sink.others;
            tied.sort_by_key(|c| (c.object, c.primitive));
        }
        Some(Hit { nearest, tied })
    }

    /// [`World::is_hit`] of a ray that was made here, and so is one.
    pub(crate) fn valid_is_hit(&self, ray: &Ray<R>, t_max: Limit, departure: Departure<'_>) -> bool {
        let mut sink = Any::new(t_max);
        self.walk(ray, departure, &mut sink, &mut ());
        sink.found
    }

    /// The nearest hit of one object, as [`World::nearest`] has it.
    #[cfg(feature = "lessons")]
    pub(crate) fn nearest_on(&self, ray: &Ray<R>, id: ObjectId, departure: Departure<'_>) -> Option<Hit<R>> {
        let mut sink = Nearest::new(Limit::None);
        self.walk_object(ray, id, departure, &mut sink);
        let nearest = sink.best?;
        let mut tied = Vec::new();
        if sink.tied {
            let mut sink = TiedWith::new(nearest);
            self.walk_object(ray, id, departure, &mut sink);
            tied = sink.others;
            tied.sort_by_key(|c| (c.object, c.primitive));
        }
        Some(Hit { nearest, tied })
    }

    /// All hits of one object at `0 <= t`, in no particular order.
    pub(crate) fn all_hits(&self, ray: &Ray<R>, id: ObjectId) -> Vec<Candidate<R>> {
        let mut sink = All(Vec::new());
        self.walk_object(ray, id, Departure::default(), &mut sink);
        sink.0
    }

    fn walk_object<S: Sink<R>>(&self, ray: &Ray<R>, id: ObjectId, departure: Departure<'_>, sink: &mut S) {
        debug_assert_eq!(ray.check(), Ok(()), "{ray:?}");
        match self.geometry(id) {
            Geometry::Mesh(mesh) => walk::mesh(self, mesh, ray, &SlabRay::new(ray), id, departure, sink, &mut ()),
            _ => list::object(self, ray, id, departure, sink, &mut ()),
        }
    }

    #[inline(always)]
    fn walk<S: Sink<R>, P: Probe>(&self, ray: &Ray<R>, departure: Departure<'_>, sink: &mut S, probe: &mut P) {
        debug_assert_eq!(ray.check(), Ok(()), "{ray:?}");
        match self.acceleration {
            Acceleration::List => list::all(self, ray, departure, sink, probe),
            Acceleration::Bvh => walk::all(self, ray, departure, sink, probe),
        }
    }

    /// The unit geometric normal at a hit, outward; of a triangle `(v1 - v0) x (v2 - v0)`. At the centre of a sphere, where only
    /// a radius of zero or a naive kernel leads, it is +x for want of a better one.
    pub fn geometric_normal(&self, point: R::Vec3, hit: &Candidate<R>) -> R::Vec3 {
        match self.geometry(hit.object) {
            Geometry::Plane(plane) => plane.normal,
            Geometry::Sphere(sphere) => {
                R::Vec3::from_f64(unit((point - sphere.center).to_f64()).unwrap_or([1.0, 0.0, 0.0]))
            }
            Geometry::Box(_) => {
                let face = hit.primitive.unwrap_or_default();
                let mut normal = [0.0; 3];
                normal[face as usize / 2] = if face.is_multiple_of(2) { -1.0 } else { 1.0 };
                R::Vec3::from_f64(normal)
            }
            Geometry::Triangle(triangle) => triangle_normal(triangle),
            Geometry::Mesh(mesh) => triangle_normal(mesh.triangle(hit.primitive)),
        }
    }

    /// How the verdict on a hit was reached: a function of the ray and the primitive alone.
    pub fn certificate(&self, ray: &Ray<R>, hit: &Candidate<R>) -> Certificate {
        match self.geometry(hit.object) {
            Geometry::Plane(plane) => certify_plane(ray, plane),
            Geometry::Sphere(sphere) => certify_sphere(ray, sphere, hit.detail.start()),
            Geometry::Box(aabb) => certify_box(ray, aabb, hit.detail.start()),
            Geometry::Triangle(triangle) => certify_triangle(ray, triangle),
            Geometry::Mesh(mesh) => certify_triangle(ray, mesh.triangle(hit.primitive)),
        }
    }

    /// The order of two hits along a ray: exact under certified numerics.
    pub fn compare(&self, ray: &Ray<R>, a: &Candidate<R>, b: &Candidate<R>) -> Ordering {
        compare(self, ray, a, b)
    }

    /// Which way the ray crosses the surface at a hit: less against the outward geometric normal (entering), greater along
    /// it (leaving), equal where it only touches. Exact under certified numerics.
    pub fn facing(&self, ray: &Ray<R>, hit: &Candidate<R>) -> Ordering {
        match (self.geometry(hit.object), hit.detail) {
            (Geometry::Plane(plane), _) => plane_facing(ray, plane),
            (Geometry::Triangle(triangle), _) => triangle_facing(ray, triangle),
            (Geometry::Mesh(mesh), _) => triangle_facing(ray, mesh.triangle(hit.primitive)),
            (_, Detail::Box { near: true, .. }) => Ordering::Less,
            (_, Detail::Sphere { near: true, .. }) if !self.leaves_behind(ray, hit) => Ordering::Less,
            (_, Detail::Sphere { near: true, .. }) => Ordering::Equal,
            _ => Ordering::Greater,
        }
    }

    /// Which way another ray that starts at a hit crosses its surface; of a sphere by the normal at the start.
    pub fn facing_of(&self, ray: &Ray<R>, hit: &Candidate<R>) -> Ordering {
        match self.geometry(hit.object) {
            Geometry::Plane(_) | Geometry::Triangle(_) | Geometry::Mesh(_) => self.facing(ray, hit),
            Geometry::Sphere(_) | Geometry::Box(_) => {
                let along = ray.direction.dot(self.geometric_normal(ray.origin, hit));
                along.partial_cmp(&R::ZERO).unwrap_or(Ordering::Equal)
            }
        }
    }

    /// Whether the ray's line is in no part of a convex solid beyond this hit: where it leaves, or only touches. Exact under
    /// certified numerics.
    pub fn leaves_behind(&self, ray: &Ray<R>, hit: &Candidate<R>) -> bool {
        match hit.detail {
            Detail::Sphere { t_in, t_out, near, .. } | Detail::Box { t_in, t_out, near, .. } => {
                !near || (!(t_in < t_out) && self.touches(ray, hit.object))
            }
            Detail::Plane | Detail::Triangle { .. } => false,
        }
    }

    /// Whether a line that meets a convex solid has no stretch inside, where rounding cannot tell its ends apart.
    #[cold]
    fn touches(&self, ray: &Ray<R>, id: ObjectId) -> bool {
        if self.numerics != Numerics::Certified {
            return true;
        }
        match self.geometry(id) {
            Geometry::Sphere(sphere) => compare_t(ray, Root::SphereNear(sphere), Root::SphereFar(sphere)).is_eq(),
            Geometry::Box(aabb) => {
                // It has one if it enters every slab before it leaves any.
                let d = ray.direction.to_f64();
                let crossed = || (0..3_u32).filter(|&axis| d[axis as usize] != 0.0);
                let faces = |axis: u32| {
                    if d[axis as usize] > 0.0 { [2 * axis, 2 * axis + 1] } else { [2 * axis + 1, 2 * axis] }
                };
                let face = |face| Root::BoxFace(aabb, face);
                crossed().any(|i| crossed().any(|j| !compare_t(ray, face(faces(i)[0]), face(faces(j)[1])).is_lt()))
            }
            _ => false,
        }
    }
}

fn geometry<R: Real>(shape: &Shape, growth: f64) -> Geometry<R> {
    let point = |p: glam::DVec3| R::Vec3::from_f64(p.to_array());
    match shape {
        Shape::Sphere { center, radius } => {
            Geometry::Sphere(Sphere { center: point(*center), radius: R::from_f64(*radius) })
        }
        Shape::Plane { normal, distance } => {
            Geometry::Plane(Plane { normal: point(*normal), distance: R::from_f64(*distance) })
        }
        Shape::Box { min, max } => Geometry::Box(Aabb { min: point(*min), max: point(*max) }),
        Shape::Triangle { vertices } => Geometry::Triangle(Triangle { vertices: vertices.map(point) }),
        Shape::Mesh(mesh) => {
            let triangles = mesh.triangles.iter().map(|vertices| Triangle { vertices: vertices.map(point) }).collect();
            Geometry::Mesh(MeshGeometry::new(triangles, growth))
        }
    }
}

fn bounds<R: Real>(geometry: &Geometry<R>) -> Option<Bounds> {
    match geometry {
        Geometry::Sphere(sphere) => {
            let (c, r) = (sphere.center.to_f64(), sphere.radius.to_f64());
            Some(Bounds { min: c.map(|x| x - r), max: c.map(|x| x + r) })
        }
        Geometry::Plane(_) => None,
        Geometry::Box(aabb) => Some(Bounds { min: aabb.min.to_f64(), max: aabb.max.to_f64() }),
        Geometry::Triangle(triangle) => Some(Bounds::of::<R>(triangle.vertices)),
        Geometry::Mesh(mesh) => Some(Bounds { min: mesh.aabb.min.to_f64(), max: mesh.aabb.max.to_f64() }),
    }
}
