//! Lesson 10: refraction and total internal reflection. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{Hit, Program, Ray, Rgb};

/// The direction of a ray of direction d after it went through a surface with the unit normal n, from index of refraction n1
/// to n2, as long as d. `n` is on the side of the ray: d . n <= 0. `None` where all light is reflected.
pub fn refracted_direction(d: DVec3, n: DVec3, n1: f64, n2: f64) -> Option<DVec3> {
    let eta = n1 / n2;
    let length = d.length();
    let unit = d / length;
    let cos1 = -unit.dot(n);
    let k = 1.0 - eta * eta * (1.0 - cos1 * cos1);
    if k < 0.0 {
        return None;
    }
    let cos2 = k.sqrt();
    Some((eta * unit + (eta * cos1 - cos2) * n) * length)
}

/// What the surface sends back: its own light, and, where the level allows it, the weighted light of the reflected and of the
/// refracted ray. At total reflection the reflected ray takes the weight of the refracted one as well.
pub fn shade(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let mut color = program.local_color(ray, hit);
    if level == program.max_level() {
        return color;
    }
    let (d, n) = (ray.direction, hit.normal);
    let mut reflection = hit.material.reflection.unwrap_or(Rgb::ZERO);
    if let Some(transmission) = hit.material.transmission {
        match refracted_direction(d, n, hit.n1, hit.n2) {
            Some(direction) => {
                let ray = Ray { origin: hit.point, direction };
                color += transmission * program.trace_refracted(level + 1, &ray);
            }
            None => reflection += transmission,
        }
    }
    if reflection != Rgb::ZERO {
        let direction = d - 2.0 * d.dot(n) * n;
        let ray = Ray { origin: hit.point, direction };
        color += reflection * program.trace_reflected(level + 1, &ray);
    }
    color
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { refracted_direction, shade })
}
