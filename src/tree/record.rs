//! The recorder that keeps everything, and the tree it makes.

use super::steps::TestRecord;
use super::{Generator, HitRecord, Kind, LightTerms, Local, RayNode, RayTree, SceneRef, Settings};
use crate::hits::{Detail, Probe, Tests};
use crate::kernels::{InvalidRay, Ray, certify_total_reflection};
use crate::numbers::{Certificate, Real, Vector3};
use crate::scene::{Loaded, Numerics};
use crate::transport::{self, Children, Outcome, Recorder, Secondary, Surface, Tracer, Visit};

/// What is kept of a ray besides the ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keep {
    /// Its outcome.
    #[default]
    Outcomes,
    /// Every test it took as well.
    Steps,
}

/// Where a tree comes from.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'a> {
    /// The scene, its file and its hash.
    pub loaded: &'a Loaded,
    /// What to keep.
    pub keep: Keep,
}

/// The tree of pixel `(x, y)`, which has to lie inside the image to mean anything.
pub fn record_pixel<R: Real>(tracer: &Tracer<'_, R>, origin: Origin<'_>, x: u32, y: u32) -> RayTree {
    let (color, root) = match origin.keep {
        Keep::Outcomes => tracer.pixel(x, y, &Outcomes),
        Keep::Steps => tracer.pixel(x, y, &Steps),
    };
    tree(tracer, origin, Some([x, y]), color, *root)
}

/// The tree of any ray, traced as if it came from the eye.
///
/// # Errors
/// [`InvalidRay`] for what is no ray, or out of the range of exact arithmetic.
pub fn record_ray<R: Real>(tracer: &Tracer<'_, R>, origin: Origin<'_>, ray: &Ray<R>) -> Result<RayTree, InvalidRay> {
    let (color, root) = match origin.keep {
        Keep::Outcomes => tracer.ray(ray, &Outcomes),
        Keep::Steps => tracer.ray(ray, &Steps),
    }?;
    Ok(tree(tracer, origin, None, color, *root))
}

fn tree<R: Real>(
    tracer: &Tracer<'_, R>,
    origin: Origin<'_>,
    pixel: Option<[u32; 2]>,
    color: glam::DVec3,
    root: RayNode,
) -> RayTree {
    let limits = tracer.limits();
    let generator =
        Generator { name: env!("CARGO_PKG_NAME").to_owned(), version: Some(env!("CARGO_PKG_VERSION").to_owned()) };
    let settings = Settings {
        precision: Some(R::PRECISION),
        numerics: Some(tracer.world().numerics()),
        leaving: Some(tracer.leaving()),
        max_depth: Some(limits.max_depth),
        min_weight: limits.min_weight,
        ray_budget: Some(limits.ray_budget),
    };
    let scene = SceneRef { file: origin.loaded.file.clone(), sha256: Some(origin.loaded.sha256.clone()) };
    RayTree {
        generator: Some(generator),
        scene: Some(scene),
        settings: Some(settings),
        pixel,
        ..RayTree::new(color.to_array(), root)
    }
}

/// Keeps every ray.
struct Outcomes;

impl Recorder for Outcomes {
    type Probe = ();
    type Node = Box<RayNode>;
    const RECORDS: bool = true;
    fn node<R: Real>(&self, visit: Visit<'_, R, ()>, children: Children<Box<RayNode>>) -> Box<RayNode> {
        node(visit, children)
    }
}

/// Keeps every ray and every test.
struct Steps;

impl Recorder for Steps {
    type Probe = Tests;
    type Node = Box<RayNode>;
    const RECORDS: bool = true;
    fn node<R: Real>(&self, mut visit: Visit<'_, R, Tests>, children: Children<Box<RayNode>>) -> Box<RayNode> {
        let names = |id| visit.tracer.scene().object(id).name.clone();
        let tests = std::mem::take(&mut visit.probe.0);
        let tests = tests.into_iter().map(|test| TestRecord::new(test, names)).collect();
        let traced = visit.outcome.is_traced();
        let mut node = node(visit, children);
        node.tests = traced.then_some(tests);
        node
    }
}

fn node<R: Real, P: Probe>(visit: Visit<'_, R, P>, children: Children<Box<RayNode>>) -> Box<RayNode> {
    let scene = visit.tracer.scene();
    let (kind, light) = match visit.kind {
        transport::Kind::Camera => (Kind::Camera, None),
        transport::Kind::Shadow(light) => (Kind::Shadow, Some(scene.light(light).name.clone())),
        transport::Kind::Secondary(Secondary::Reflected) => (Kind::Reflected, None),
        transport::Kind::Secondary(Secondary::Refracted) => (Kind::Refracted, None),
    };
    let refraction_certificate = refraction_certificate(&visit);
    let local = visit.local.map(|local| Local {
        ambient: local.ambient.to_array(),
        lights: local
            .lights
            .iter()
            .map(|term| LightTerms {
                light: scene.light(term.light).name.clone(),
                diffuse: term.diffuse.to_array(),
                specular: term.specular.to_array(),
            })
            .collect(),
    });
    let certificate = match (visit.surface, visit.tracer.world().numerics()) {
        (Some(surface), Numerics::Certified) => Some(visit.tracer.world().certificate(visit.ray, &surface.hit.nearest)),
        _ => None,
    };
    Box::new(RayNode {
        kind,
        light,
        depth: visit.depth,
        weight: visit.weight.map(|w| w.to_array()),
        ior: visit.ior,
        origin: visit.ray.origin.to_f64(),
        direction: visit.ray.direction.to_f64(),
        t_max: visit.t_max,
        outcome: visit.outcome,
        hit: visit.surface.map(|surface| hit_record(visit.tracer, surface)),
        certificate,
        refraction_certificate,
        local,
        radiance: visit.radiance.map(|r| r.to_array()),
        fresnel: visit.fresnel,
        total_reflection: visit.total_reflection,
        shadows: children.shadows.into_iter().map(|node| *node).collect(),
        reflected: children.reflected,
        refracted: children.refracted,
        tests: None,
    })
}

/// How total reflection was decided, where it was: at a shaded hit with two indices of refraction.
fn refraction_certificate<R: Real, P: Probe>(visit: &Visit<'_, R, P>) -> Option<Certificate> {
    let surface = visit.surface.filter(|_| visit.outcome == Outcome::Hit)?;
    let material = visit.tracer.scene().material_of(surface.hit.nearest.object);
    let [incident, transmitted] = surface.ior;
    let is_asked = (material.transmission.is_some() || material.fresnel.is_some()) && incident != transmitted;
    let is_certified = visit.tracer.world().numerics() == Numerics::Certified;
    (is_asked && is_certified)
        .then(|| certify_total_reflection::<R>(visit.ray.direction, surface.shading_normal, incident, transmitted))
}

/// What a tree tells of a hit.
pub(crate) fn hit_record<R: Real>(tracer: &Tracer<'_, R>, surface: &Surface<R>) -> HitRecord {
    let nearest = &surface.hit.nearest;
    HitRecord {
        // The number that the point was computed with, unless it is too large for f32.
        t: Some(R::from_f64(nearest.t).to_f64()).filter(|t| t.is_finite()).unwrap_or(nearest.t),
        point: surface.point.to_f64(),
        object: Some(tracer.scene().object(nearest.object).name.clone()),
        shape: nearest.object.0,
        primitive: nearest.primitive,
        barycentrics: match nearest.detail {
            Detail::Triangle { barycentrics } => Some(barycentrics.map(Real::to_f64)),
            _ => None,
        },
        geometric_normal: surface.geometric_normal.to_f64(),
        shading_normal: Some(surface.shading_normal.to_f64()),
        side: surface.side,
        ior: Some(surface.ior.map(Real::to_f64)),
    }
}
