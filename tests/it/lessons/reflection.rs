//! Lesson 09, reflection: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::{Hit, Lesson, Program, Ray, Rgb};

#[path = "../../../lessons/09-reflection/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/09-reflection/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/09-reflection/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(reflected_direction, shade);

fn reflected(ray: &Ray, hit: &Hit) -> Ray {
    Ray { origin: hit.point, direction: solution::reflected_direction(ray.direction, hit.normal) }
}

/// Shade of somebody who does not ask for the level.
fn endless(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let mut color = program.local_color(ray, hit);
    if let Some(reflection) = hit.material.reflection {
        color += reflection * program.trace_reflected(level + 1, &reflected(ray, hit));
    }
    color
}

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "reflected-sign": reflected_direction = |d, n| d + 2.0 * n.dot(d) * n,
        "reflected-without-2": reflected_direction = |d, n| d - n * n.dot(d),
        "reflected-reversed": reflected_direction = |d, n| 2.0 * n.dot(d) * n - d,
        "recursion-endless": shade = endless,
        "recursion-endless": shade = |program, level, ray, hit| {
            let mut color = program.local_color(ray, hit);
            if let (Some(reflection), true) = (hit.material.reflection, level < program.max_level()) {
                color += reflection * program.trace_reflected(level, &reflected(ray, hit));
            }
            color
        },
        "level-one-too-many": shade = |program, level, ray, hit| {
            let mut color = program.local_color(ray, hit);
            if let (Some(reflection), true) = (hit.material.reflection, level <= program.max_level()) {
                color += reflection * program.trace_reflected(level + 1, &reflected(ray, hit));
            }
            color
        },
        "color-before-weight": shade = |program, level, ray, hit| {
            let mut color = program.local_color(ray, hit);
            if let (Some(reflection), true) = (hit.material.reflection, level < program.max_level()) {
                color += program.trace_reflected(level + 1, &reflected(ray, hit));
                color *= reflection;
            }
            color
        },
        "reflection-instead-of-local": shade = |program, level, ray, hit| {
            let color = program.local_color(ray, hit);
            match hit.material.reflection {
                Some(k) if level < program.max_level() => k * program.trace_reflected(level + 1, &reflected(ray, hit)),
                _ => color,
            }
        },
        "reflection-lifted-1e-4": shade = |program, level, ray, hit| {
            let mut color = program.local_color(ray, hit);
            if let (Some(reflection), true) = (hit.material.reflection, level < program.max_level()) {
                let Ray { origin, direction } = reflected(ray, hit);
                let lifted = Ray { origin: origin + 1e-4 * hit.normal, direction };
                color += reflection * program.trace_reflected(level + 1, &lifted);
            }
            color
        },
        "reflect-sign": shade = |program, level, ray, hit| {
            let mut color = program.local_color(ray, hit);
            if let (Some(reflection), true) = (hit.material.reflection, level < program.max_level()) {
                let direction = ray.direction + 2.0 * ray.direction.dot(hit.normal) * hit.normal;
                color += reflection * program.trace_reflected(level + 1, &Ray { origin: hit.point, direction });
            }
            color
        },
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(v: DVec3) -> Lesson {
    V.set(v);
    check::lesson(check::Student { reflected_direction: |_, _| V.get(), shade: |_, _, _, _| V.get() })
}

thread_local! {
    static V: Cell<DVec3> = const { Cell::new(DVec3::ZERO) };
}
