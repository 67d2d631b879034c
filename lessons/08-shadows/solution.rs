//! Lesson 08: shadows. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{Light, LightKind, Program, Ray, ShadowRay};

/// The ray from the point to the light, its direction of length 1, and as `t_max` the distance to the light; that of a
/// directional light is `f64::INFINITY`.
pub fn shadow_ray(point: DVec3, light: &Light) -> ShadowRay {
    match light.kind {
        LightKind::Point { position } => {
            let way = position - point;
            let distance = way.length();
            ShadowRay { ray: Ray { origin: point, direction: way / distance }, t_max: distance }
        }
        LightKind::Directional { direction } => {
            ShadowRay { ray: Ray { origin: point, direction: -direction }, t_max: f64::INFINITY }
        }
    }
}

/// Whether any object is hit before the light, at a t below `t_max`.
pub fn is_blocked(program: &Program, shadow_ray: &ShadowRay) -> bool {
    for object in program.objects() {
        if let Some(hit) = object.intersect(&shadow_ray.ray)
            && hit.t < shadow_ray.t_max
        {
            return true;
        }
    }
    false
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { shadow_ray, is_blocked })
}
