//! A hit made ready for shading.

use super::leaving::LeavingPolicy;
use super::media::Inside;
use super::trace::Tracer;
use crate::hits::{Detail, Hit};
use crate::kernels::Ray;
use crate::numbers::{Real, Vector3};
use crate::scene::Shape;
use crate::scene::effects::Effect;

/// Which way a ray crosses a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Against the outward geometric normal: `d . n < 0`.
    Entering,
    /// Along it, or in the surface.
    Leaving,
}

/// A hit made ready for shading.
#[derive(Clone, Debug)]
pub struct Surface<R: Real> {
    /// The hit.
    pub hit: Hit<R>,
    /// Where, in world space.
    pub point: R::Vec3,
    /// How far `point` may lie beside the true surface, component by component; nothing but where a ray leaves by
    /// that.
    pub point_error: Option<R::Vec3>,
    /// Unit, outward, never flipped.
    pub geometric_normal: R::Vec3,
    /// Unit, turned towards the ray; interpolated on smooth meshes.
    pub shading_normal: R::Vec3,
    /// Nothing for lone triangles.
    pub side: Option<Side>,
    /// Index of refraction of the incident and of the transmitted side.
    pub ior: [R; 2],
    /// The media beyond.
    pub beyond: Inside,
}

impl<R: Real> Surface<R> {
    /// What `hit` is to a ray that comes from `inside`.
    pub fn new(tracer: &Tracer<'_, R>, ray: &Ray<R>, hit: Hit<R>, inside: &Inside) -> Self {
        let world = tracer.world();
        let (point, point_error) = match tracer.leaving() {
            LeavingPolicy::ErrorBound => {
                let (point, error) = world.point_and_error(ray, &hit.nearest);
                (point, Some(error))
            }
            LeavingPolicy::FixedEpsilon(_) | LeavingPolicy::Provenance => (world.point(ray, &hit.nearest), None),
        };
        let geometric_normal = world.geometric_normal(point, &hit.nearest);
        let shape = &tracer.scene().object(hit.nearest.object).shape;
        let smooth = smooth_normal::<R>(shape, &hit);
        if smooth.is_some() {
            tracer.begin(Effect::SmoothNormals);
        }
        let facing = world.facing(ray, &hit.nearest);
        let side = match shape {
            Shape::Triangle { .. } => None,
            _ if facing.is_lt() => Some(Side::Entering),
            _ => Some(Side::Leaving),
        };
        let (beyond, mut ior) = if tracer.has_media() {
            tracer.begin(Effect::Refraction);
            let beyond = inside.after(tracer, ray, &hit);
            let ior = [tracer.ior(inside), tracer.ior(&beyond)];
            (beyond, ior)
        } else {
            (Inside::default(), [R::ONE; 2])
        };
        if let Some(coat) = tracer.clear_coat(hit.nearest.object) {
            ior[1] = coat;
        }
        let turned = |n: R::Vec3| if facing.is_gt() { -n } else { n };
        let shading_normal = match smooth {
            None => turned(geometric_normal),
            Some(normal) => to_horizon::<R>(turned(normal), ray.direction),
        };
        Self { hit, point, point_error, geometric_normal, shading_normal, side, ior, beyond }
    }
}

/// The unit normal interpolated from those at the corners, on a smooth mesh.
fn smooth_normal<R: Real>(shape: &Shape, hit: &Hit<R>) -> Option<R::Vec3> {
    let (Shape::Mesh(mesh), Detail::Triangle { barycentrics }) = (shape, hit.nearest.detail) else { return None };
    let [n0, n1, n2] = mesh.corner_normals.as_ref()?[hit.nearest.primitive? as usize];
    let [a, b, c] = barycentrics.map(Real::to_f64);
    let normal = (n0 * a + n1 * b + n2 * c).try_normalize()?;
    Some(R::Vec3::from_f64(normal.to_array()))
}

/// An interpolated normal that points away from a ray, as it may near an outline, bent until it is perpendicular to it.
///
/// Turning it round instead would make it point into the body, and the outline dark.
fn to_horizon<R: Real>(normal: R::Vec3, direction: R::Vec3) -> R::Vec3 {
    let (n, d) = (glam::DVec3::from_array(normal.to_f64()), glam::DVec3::from_array(direction.to_f64()));
    let away = n.dot(d);
    if away <= 0.0 {
        return normal;
    }
    let bent = n - d * (away / d.length_squared());
    bent.try_normalize().map_or(normal, |n| R::Vec3::from_f64(n.to_array()))
}
