//! The lecture's program out of the parts of the real tracer.

use glam::DVec3;

use super::super::Ray;
use super::{Camera, DirectLight, Hit, Program, ShadowRay, way_to};
use crate::scene::{Light, LightId, LightKind, Rgb};
use crate::transport::Secondary;

/// The ray through the middle of pixel `(x, y)`, `(0, 0)` top left.
pub(super) fn compute_ray(camera: &Camera, x: u32, y: u32) -> Ray {
    let (width, height) = (f64::from(camera.width), f64::from(camera.height));
    let half_height = libm::tan(0.5 * camera.fov_y_degrees.to_radians());
    let across = (2.0 * (f64::from(x) + 0.5) / width - 1.0) * half_height * width / height;
    let upwards = (1.0 - 2.0 * (f64::from(y) + 0.5) / height) * half_height;
    let direction = camera.forward + camera.right * across + camera.up * upwards;
    Ray { origin: camera.eye, direction: direction.normalize() }
}

/// Intersect, then Shade or the background.
pub(super) fn trace(program: &Program, level: u32, ray: &Ray) -> Rgb {
    match program.intersect(ray) {
        Some(hit) => program.shade(level, ray, &hit),
        None => program.background(ray),
    }
}

/// The nearest hit, through the hierarchy.
pub(super) fn intersect(program: &Program, ray: &Ray) -> Option<Hit> {
    let world = program.tracer.world();
    program.find(ray, |ray, departure| world.nearest_of_valid(ray, crate::hits::Limit::None, departure, &mut ()))
}

/// What the surface itself sends back, and what the rays bring back that its material asks for.
pub(super) fn shade(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let mut color = program.local_color(ray, hit);
    let split = program.tracer.split(ray, &program.surface(hit));
    for way in split.reflected.iter().chain(&split.refracted).filter(|_| level < program.max_level()) {
        let onward = Ray { origin: hit.point, direction: way.direction };
        color += way.weight
            * match way.kind {
                Secondary::Reflected => program.trace_reflected(level + 1, &onward),
                Secondary::Refracted => program.trace_refracted(level + 1, &onward),
            };
    }
    color
}

/// Phong's terms, where the surface faces the light and the light reaches it.
pub(super) fn direct_light(program: &Program, ray: &Ray, hit: &Hit, light: &Light) -> DirectLight {
    let (tracer, surface) = (program.tracer, program.surface(hit));
    let Some(id) = program.lights().iter().position(|other| other == light) else { return DirectLight::default() };
    let Some(shadow_ray) = tracer.shadow_ray(&surface, LightId(id as u32)) else { return DirectLight::default() };
    if !program.is_lit(hit, light) {
        return DirectLight::default();
    }
    let term = tracer.light_term(ray, &surface, hit.material.color, &shadow_ray);
    DirectLight { diffuse: term.diffuse, specular: term.specular }
}

/// A ray of length 1, up to the light.
pub(super) fn shadow_ray(point: DVec3, light: &Light) -> ShadowRay {
    let way = way_to(light, point);
    let t_max = match light.kind {
        LightKind::Point { .. } => way.length(),
        LightKind::Directional { .. } => f64::INFINITY,
    };
    ShadowRay { ray: Ray { origin: point, direction: way / way.length() }, t_max }
}

/// Whether the nearest hit comes before the light.
pub(super) fn is_blocked(program: &Program, shadow_ray: &ShadowRay) -> bool {
    intersect(program, &shadow_ray.ray).is_some_and(|hit| hit.t < shadow_ray.t_max)
}
