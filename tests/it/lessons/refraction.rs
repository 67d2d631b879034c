//! Lesson 10, refraction: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::{Hit, Lesson, Program, Ray, Rgb};

#[path = "../../../lessons/10-refraction/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/10-refraction/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/10-refraction/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(refracted_direction, shade);

/// A ray that goes on from a hit.
fn onward(hit: &Hit, direction: DVec3) -> Ray {
    Ray { origin: hit.point, direction }
}

/// Shade of somebody who counts on glass that never reflects totally.
fn dropped(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let mut color = program.local_color(ray, hit);
    if level < program.max_level() {
        let (d, n) = (ray.direction, hit.normal);
        if let Some(transmission) = hit.material.transmission {
            let Some(direction) = solution::refracted_direction(d, n, hit.n1, hit.n2) else { return color };
            color += transmission * program.trace_refracted(level + 1, &onward(hit, direction));
        }
        if let Some(reflection) = hit.material.reflection {
            color += reflection * program.trace_reflected(level + 1, &onward(hit, d - 2.0 * d.dot(n) * n));
        }
    }
    color
}

/// Shade of somebody who leaves the weight of the mirror as it is.
fn weight_lost(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let mut color = program.local_color(ray, hit);
    if level < program.max_level() {
        let (d, n) = (ray.direction, hit.normal);
        if let Some(reflection) = hit.material.reflection {
            color += reflection * program.trace_reflected(level + 1, &onward(hit, d - 2.0 * d.dot(n) * n));
        }
        let refracted = solution::refracted_direction(d, n, hit.n1, hit.n2);
        if let (Some(transmission), Some(direction)) = (hit.material.transmission, refracted) {
            color += transmission * program.trace_refracted(level + 1, &onward(hit, direction));
        }
    }
    color
}

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "refracted-eta-inverted": refracted_direction = |d, n, n1, n2| solution::refracted_direction(d, n, n2, n1),
        "refracted-nan": refracted_direction = |d, n, n1, n2| {
            let (eta, cos1) = (n1 / n2, -d.normalize().dot(n));
            let cos2 = (1.0 - eta * eta * (1.0 - cos1 * cos1)).sqrt();
            Some((eta * d.normalize() + (eta * cos1 - cos2) * n) * d.length())
        },
        "refracted-cosine-sign": refracted_direction = |d, n, n1, n2| {
            let (eta, cos1) = (n1 / n2, d.normalize().dot(n));
            let k = 1.0 - eta * eta * (1.0 - cos1 * cos1);
            if k < 0.0 { None } else { Some((eta * d.normalize() + (eta * cos1 - k.sqrt()) * n) * d.length()) }
        },
        "refracted-length-lost": refracted_direction = |d, n, n1, n2| {
            solution::refracted_direction(d.normalize(), n, n1, n2)
        },
        "refraction-indices-exchanged": shade = |program, level, ray, hit| {
            let mut exchanged = *hit;
            (exchanged.n1, exchanged.n2) = (hit.n2, hit.n1);
            solution::shade(program, level, ray, &exchanged)
        },
        "refraction-indices-fixed": shade = |program, level, ray, hit| {
            let mut fixed = *hit;
            (fixed.n1, fixed.n2) = (1.0, 1.5);
            solution::shade(program, level, ray, &fixed)
        },
        "refraction-weight-replaced": shade = |program, level, ray, hit| {
            let mut other = *hit;
            if solution::refracted_direction(ray.direction, hit.normal, hit.n1, hit.n2).is_none() {
                other.material.reflection = other.material.reflection.filter(|_| other.material.transmission.is_none());
            }
            solution::shade(program, level, ray, &other)
        },
        "refraction-only-mirrors": shade = |program, level, ray, hit| {
            let mut other = *hit;
            if hit.material.reflection.is_none()
                && solution::refracted_direction(ray.direction, hit.normal, hit.n1, hit.n2).is_none()
            {
                other.material.transmission = None;
            }
            solution::shade(program, level, ray, &other)
        },
        "refraction-dropped": shade = dropped,
        "refraction-weight-lost": shade = weight_lost,
        "refraction-endless": shade = |program, level, ray, hit| solution::shade(program, level.min(1), ray, hit),
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(v: DVec3) -> Lesson {
    V.set(v);
    check::lesson(check::Student { refracted_direction: |_, _, _, _| Some(V.get()), shade: |_, _, _, _| V.get() })
}

thread_local! {
    static V: Cell<DVec3> = const { Cell::new(DVec3::ZERO) };
}
