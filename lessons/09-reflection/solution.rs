//! Lesson 09: reflection and maxLevel. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{Hit, Program, Ray, Rgb};

/// The direction of a ray of direction d after a mirror with the unit normal n, as long as d.
pub fn reflected_direction(d: DVec3, n: DVec3) -> DVec3 {
    d - 2.0 * d.dot(n) * n
}

/// What the surface sends back: its own light, and, where it reflects and the level allows it, the weighted light of the
/// reflected ray.
pub fn shade(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let mut color = program.local_color(ray, hit);
    if let Some(reflection) = hit.material.reflection
        && level < program.max_level()
    {
        let direction = reflected_direction(ray.direction, hit.normal);
        let reflected = Ray { origin: hit.point, direction };
        color += reflection * program.trace_reflected(level + 1, &reflected);
    }
    color
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { reflected_direction, shade })
}
