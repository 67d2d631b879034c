//! The walk through the hierarchies: over the objects, and over the triangles of each mesh that the ray enters.

use super::bvh::Visit;
use super::nearest::Sink;
use super::probe::Probe;
use super::slabs::SlabRay;
use super::start::Departure;
use super::test::{MeshTest, Owner, enters, object};
use super::world::{Geometry, MeshGeometry, World};
use crate::kernels::Ray;
use crate::numbers::Real;
use crate::scene::ObjectId;

/// Offers `sink` the hits of all objects, through the hierarchies.
#[inline(always)]
pub(super) fn all<R: Real, S: Sink<R>, P: Probe>(
    world: &World<R>,
    ray: &Ray<R>,
    departure: Departure<'_>,
    sink: &mut S,
    probe: &mut P,
) {
    for &id in world.unbounded() {
        object(world, ray, id, 0.0, departure, sink, probe);
    }
    let slabs = SlabRay::new(ray);
    world.bvh().walk(&slabs, |node, visit, bounds| {
        let object_of = match visit {
            Visit::Inner => None,
            Visit::Leaf(item) => Some(world.item(item)),
        };
        let triangles = object_of.and_then(|id| match world.geometry(id) {
            Geometry::Mesh(mesh) => Some(mesh),
            _ => None,
        });
        let around_one = object_of.is_some() && triangles.is_none();
        let owner = Owner { object: object_of, primitive: None, node: Some(node), in_mesh: false, around_one };
        let entered = enters(sink.limit(), probe, &slabs, bounds, owner);
        if let (Some(t_in), Some(id)) = (entered, object_of) {
            match triangles {
                Some(geometry) => mesh(world, geometry, ray, &slabs, id, departure, sink, probe),
                None => object(world, ray, id, t_in, departure, sink, probe),
            }
        }
        entered.is_some()
    });
}

/// Offers `sink` the hits of one mesh, through its own hierarchy.
#[allow(clippy::too_many_arguments, reason = "the state of the walk through the objects, which this one goes on with")]
pub(super) fn mesh<R: Real, S: Sink<R>, P: Probe>(
    world: &World<R>,
    mesh: &MeshGeometry<R>,
    ray: &Ray<R>,
    slabs: &SlabRay,
    id: ObjectId,
    departure: Departure<'_>,
    sink: &mut S,
    probe: &mut P,
) {
    let mut test = MeshTest::new(world, mesh, ray, id, departure);
    mesh.bvh.walk(slabs, |node, visit, bounds| {
        let primitive = match visit {
            Visit::Inner => None,
            Visit::Leaf(primitive) => Some(primitive),
        };
        let owner =
            Owner { object: Some(id), primitive, node: Some(node), in_mesh: true, around_one: primitive.is_some() };
        let entered = enters(sink.limit(), probe, slabs, bounds, owner);
        if let (Some(t_in), Some(primitive)) = (entered, primitive) {
            test.triangle(primitive, t_in, sink, probe);
        }
        entered.is_some()
    });
}
