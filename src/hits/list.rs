//! The list: every object, every triangle, in order. Slow, plain, and what the hierarchy is held against.

use super::nearest::Sink;
use super::probe::Probe;
use super::slabs::SlabRay;
use super::start::Departure;
use super::test::{self, Owner};
use super::world::{Geometry, World};
use crate::kernels::Ray;
use crate::numbers::Real;
use crate::scene::ObjectId;

/// Offers `sink` the hits of all objects.
pub(super) fn all<R: Real, S: Sink<R>, P: Probe>(
    world: &World<R>,
    ray: &Ray<R>,
    departure: Departure<'_>,
    sink: &mut S,
    probe: &mut P,
) {
    for id in world.object_ids() {
        object(world, ray, id, departure, sink, probe);
    }
}

/// Offers `sink` the hits of one object.
pub(super) fn object<R: Real, S: Sink<R>, P: Probe>(
    world: &World<R>,
    ray: &Ray<R>,
    id: ObjectId,
    departure: Departure<'_>,
    sink: &mut S,
    probe: &mut P,
) {
    let slabs = SlabRay::new(ray);
    if let Geometry::Mesh(mesh) = world.geometry(id) {
        let mut test = test::MeshTest::new(world, mesh, ray, id, departure);
        for (primitive, bounds) in (0..).zip(&mesh.bounds) {
            let owner =
                Owner { object: Some(id), primitive: Some(primitive), node: None, in_mesh: false, around_one: true };
            if let Some(t_in) = test::enters(sink.limit(), probe, &slabs, bounds, owner) {
                test.triangle(primitive, t_in, sink, probe);
            }
        }
        return;
    }
    let t_in = match world.bounds(id) {
        None => Some(0.0),
        Some(bounds) => {
            let owner = Owner { object: Some(id), primitive: None, node: None, in_mesh: false, around_one: true };
            test::enters(sink.limit(), probe, &slabs, bounds, owner)
        }
    };
    if let Some(t_in) = t_in {
        test::object(world, ray, id, t_in, departure, sink, probe);
    }
}
