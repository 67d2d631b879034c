//! The medium a ray is in: the solids that contain it, and what crossing a surface does to them.

use std::cmp::Ordering;

use super::trace::Tracer;
use crate::hits::{Candidate, Detail, Geometry, Hit, World};
use crate::kernels::{Ray, Root, compare_t_with, plane_facing};
use crate::numbers::{Real, Vector3};
use crate::scene::{ObjectId, Scene};

/// The media that contain a point of a ray, in the order of the scene: solids whose material transmits. The last one
/// counts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inside(Vec<ObjectId>);

impl Inside {
    /// The media just before the start of a camera ray.
    pub fn at_start<R: Real>(scene: &Scene, world: &World<R>, ray: &Ray<R>) -> Self {
        let media = scene.object_ids().filter(|&id| scene.is_medium(id));
        Self(media.filter(|&id| contains_start(world, ray, id)).collect())
    }

    /// The medium whose index of refraction counts: of those that contain the point, the last in `objects`.
    pub fn medium(&self) -> Option<ObjectId> {
        self.0.last().copied()
    }

    /// The media just after a hit: all surfaces at equal `t` are crossed together.
    pub fn after<R: Real>(&self, tracer: &Tracer<'_, R>, ray: &Ray<R>, hit: &Hit<R>) -> Self {
        let mut after = self.clone();
        let all = || std::iter::once(&hit.nearest).chain(&hit.tied);
        for crossed in all().filter(|c| tracer.scene().is_medium(c.object)) {
            let id = crossed.object;
            let contains = match crossed.detail {
                Detail::Sphere { .. } | Detail::Box { .. } => !tracer.world().leaves_behind(ray, crossed),
                Detail::Plane => enters(tracer.world(), ray, crossed),
                // Of a mesh, several triangles may meet in an edge or a vertex. Where some face the ray and some do
                // not, it touches an outline and stays where it is; at a saddle of the surface that is a guess.
                Detail::Triangle { .. } => {
                    let of_mesh = || all().filter(|c| c.object == id);
                    let entered = of_mesh().filter(|c| enters(tracer.world(), ray, c)).count();
                    match (entered, of_mesh().count() - entered) {
                        (_, 0) => true,
                        (0, _) => false,
                        _ => continue,
                    }
                }
            };
            after.set(id, contains);
        }
        after
    }

    fn set(&mut self, id: ObjectId, contains: bool) {
        match (self.0.binary_search(&id), contains) {
            (Err(place), true) => self.0.insert(place, id),
            (Ok(place), false) => {
                self.0.remove(place);
            }
            _ => {}
        }
    }
}

/// Whether the ray goes in at a hit of a plane or triangle: against its outward normal.
fn enters<R: Real>(world: &World<R>, ray: &Ray<R>, hit: &Candidate<R>) -> bool {
    world.facing(ray, hit).is_lt()
}

/// Whether a solid contains the ray just before its start, `t_in < 0 <= t_out`.
fn contains_start<R: Real>(world: &World<R>, ray: &Ray<R>, id: ObjectId) -> bool {
    match world.geometry(id) {
        Geometry::Sphere(_) | Geometry::Box(_) => world.all_hits(ray, id).iter().any(|hit| match hit.detail {
            Detail::Sphere { near, .. } | Detail::Box { near, .. } => !near,
            Detail::Plane | Detail::Triangle { .. } => false,
        }),
        Geometry::Plane(plane) => {
            // Seen along the normal, the plane lies ahead of what is below it.
            let upwards = Ray { origin: ray.origin, direction: plane.normal };
            match compare_t_with(&upwards, Root::Plane(plane), 0.0) {
                Ordering::Greater => true,
                Ordering::Equal => plane_facing(ray, plane).is_gt(),
                Ordering::Less => false,
            }
        }
        Geometry::Triangle(_) => false,
        Geometry::Mesh(mesh) => {
            let (o, min, max) = (ray.origin.to_f64(), mesh.aabb.min.to_f64(), mesh.aabb.max.to_f64());
            if (0..3).any(|k| o[k] < min[k] || o[k] > max[k]) {
                return false;
            }
            // The first crossing that is not a mere touch tells: outward from inside, inward from outside.
            let mut hits = world.all_hits(ray, id);
            hits.sort_by(|a, b| world.compare(ray, a, b));
            let groups = hits.chunk_by(|a, b| world.compare(ray, a, b).is_eq());
            let mut entered = groups.map(|group| group.iter().map(|hit| enters(world, ray, hit)).collect::<Vec<_>>());
            let first = entered.find(|group| group.iter().all(|e| *e == group[0]));
            first.is_some_and(|group| !group[0])
        }
    }
}
