//! The lecture's Trace and Shade, written a second time without any recorder: what recording that is off is held
//! against.

use raytree::hits::{Departure, Limit};
use raytree::kernels::Ray;
use raytree::numbers::Vector3;
use raytree::scene::Rgb;
use raytree::transport::{Inside, Leaving, Secondary, Surface, Tracer, Way, spawn};

/// The colour of pixel `(x, y)`.
pub(crate) fn pixel(tracer: &Tracer<'_, f64>, x: u32, y: u32) -> Rgb {
    let ray = tracer.scene().camera.ray(tracer.scene().image, x, y);
    let ray = spawn(ray.origin, ray.direction);
    let inside =
        if tracer.has_media() { Inside::at_start(tracer.scene(), tracer.world(), &ray) } else { Inside::default() };
    let mut rays_left = tracer.limits().ray_budget - 1;
    let camera = Path { level: 0, weight: Rgb::ONE, ray: &ray, departure: Departure::default(), inside: &inside };
    trace(tracer, camera, &mut rays_left)
}

#[derive(Clone, Copy)]
struct Path<'a> {
    level: u32,
    weight: Rgb,
    ray: &'a Ray<f64>,
    departure: Departure<'a>,
    inside: &'a Inside,
}

fn take(rays_left: &mut u64) -> bool {
    match rays_left.checked_sub(1) {
        Some(rest) => {
            *rays_left = rest;
            true
        }
        None => false,
    }
}

fn trace(tracer: &Tracer<'_, f64>, path: Path<'_>, rays_left: &mut u64) -> Rgb {
    match tracer.world().nearest(path.ray, Limit::None, path.departure, &mut ()).expect("a ray") {
        Some(hit) => shade(tracer, path, &Surface::new(tracer, path.ray, hit, path.inside), rays_left),
        None => tracer.scene().background.color(glam::DVec3::from_array(path.ray.direction.to_f64())),
    }
}

fn shade(tracer: &Tracer<'_, f64>, path: Path<'_>, surface: &Surface<f64>, rays_left: &mut u64) -> Rgb {
    let mut color = direct_light(tracer, path, surface, rays_left);
    let split = tracer.split(path.ray, surface);
    for way in split.reflected.iter().chain(&split.refracted) {
        color += way.weight * secondary(tracer, path, surface, way, rays_left);
    }
    color
}

fn direct_light(tracer: &Tracer<'_, f64>, path: Path<'_>, surface: &Surface<f64>, rays_left: &mut u64) -> Rgb {
    let material = tracer.scene().material_of(surface.hit.nearest.object);
    let color = tracer.color_at(surface);
    let mut sum = tracer.ambient(material, color);
    if !material.takes_direct_light() {
        return sum;
    }
    for light in tracer.scene().light_ids() {
        let Some(to) = tracer.shadow_ray(surface, light) else { continue };
        if !take(rays_left) {
            continue;
        }
        let limit = to.t_max.map_or(Limit::None, Limit::Below);
        let leaving = Leaving::new(tracer, path.ray, path.departure, surface, to.ray.direction, Secondary::Reflected);
        if !tracer.world().is_hit(&to.ray, limit, leaving.departure()).expect("a ray") {
            let term = tracer.light_term(path.ray, surface, color, &to);
            sum += term.diffuse + term.specular;
        }
    }
    sum
}

fn secondary(
    tracer: &Tracer<'_, f64>,
    path: Path<'_>,
    surface: &Surface<f64>,
    way: &Way<f64>,
    rays_left: &mut u64,
) -> Rgb {
    let ray = spawn(surface.origin_towards(way.direction), way.direction);
    let weight = path.weight * way.weight;
    let limits = tracer.limits();
    let too_deep = path.level >= limits.max_depth;
    if too_deep || limits.min_weight.is_some_and(|least| weight.max_element() < least) || !take(rays_left) {
        return Rgb::ZERO;
    }
    let leaving = Leaving::new(tracer, path.ray, path.departure, surface, way.direction, way.kind);
    let inside = match way.kind {
        Secondary::Reflected => path.inside,
        Secondary::Refracted => &surface.beyond,
    };
    let child = Path { level: path.level + 1, weight, ray: &ray, departure: leaving.departure(), inside };
    trace(tracer, child, rays_left)
}
