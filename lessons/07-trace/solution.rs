//! Lesson 07: Trace, Intersect and direct light. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{DirectLight, Hit, Light, LightKind, Material, Program, Ray, Rgb};

/// The nearest of the hits of all objects; `None` where the ray meets none.
pub fn intersect(program: &Program, ray: &Ray) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for object in program.objects() {
        if let Some(hit) = object.intersect(ray) {
            let is_nearer = match nearest {
                Some(before) => hit.t < before.t,
                None => true,
            };
            if is_nearer {
                nearest = Some(hit);
            }
        }
    }
    nearest
}

/// What the ray brings back: what `program.shade` makes of the nearest hit, or the background.
pub fn trace(program: &Program, level: u32, ray: &Ray) -> Rgb {
    match program.intersect(ray) {
        Some(hit) => program.shade(level, ray, &hit),
        None => program.background(ray),
    }
}

/// The direction from the point to the light, of length 1.
pub fn to_light(point: DVec3, light: &Light) -> DVec3 {
    match light.kind {
        LightKind::Point { position } => (position - point).normalize(),
        LightKind::Directional { direction } => -direction,
    }
}

/// Lambert's term: k_d times the colour of the surface times max(0, n . l) times the colour of the light.
pub fn diffuse(material: &Material, n: DVec3, l: DVec3, light: Rgb) -> Rgb {
    material.diffuse * material.color * n.dot(l).max(0.0) * light
}

/// Phong's highlight: k_s times max(0, r . v)^shininess times the colour of the light. `d` is the direction of the ray.
pub fn specular(material: &Material, n: DVec3, l: DVec3, d: DVec3, light: Rgb) -> Rgb {
    let r = 2.0 * n.dot(l) * n - l;
    let v = -d;
    material.specular * r.dot(v).max(0.0).powf(material.shininess) * light
}

/// Both terms of one light; both 0 where the surface faces away from the light, and where `program.is_lit` says no.
pub fn direct_light(program: &Program, ray: &Ray, hit: &Hit, light: &Light) -> DirectLight {
    let n = hit.normal;
    let l = to_light(hit.point, light);
    if n.dot(l) < 0.0 || !program.is_lit(hit, light) {
        return DirectLight { diffuse: Rgb::ZERO, specular: Rgb::ZERO };
    }
    DirectLight {
        diffuse: diffuse(&hit.material, n, l, light.color),
        specular: specular(&hit.material, n, l, ray.direction, light.color),
    }
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { intersect, trace, to_light, diffuse, specular, direct_light })
}
