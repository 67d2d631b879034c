//! Lesson 08, shadows: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::{Lesson, LightKind, Ray, ShadowRay};

#[path = "../../../lessons/08-shadows/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/08-shadows/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/08-shadows/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(shadow_ray, is_blocked);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "shadow-ray-past-light": shadow_ray = |point, light| match light.kind {
            LightKind::Point { position } => ShadowRay {
                ray: Ray { origin: point, direction: position - point },
                t_max: (position - point).length(),
            },
            LightKind::Directional { direction } => {
                ShadowRay { ray: Ray { origin: point, direction: -direction }, t_max: f64::INFINITY }
            }
        },
        "shadow-ray-endless": shadow_ray = |point, light| {
            ShadowRay { t_max: f64::INFINITY, ..solution::shadow_ray(point, light) }
        },
        "shadow-ray-sun-reversed": shadow_ray = |point, light| match light.kind {
            LightKind::Point { .. } => solution::shadow_ray(point, light),
            LightKind::Directional { direction } => {
                ShadowRay { ray: Ray { origin: point, direction }, t_max: f64::INFINITY }
            }
        },
        "nothing-blocks": is_blocked = |program, shadow_ray| {
            program.intersect(&shadow_ray.ray).is_some_and(|hit| hit.t < 0.0)
        },
        "blocked-behind-the-light": is_blocked = |program, shadow_ray| program.intersect(&shadow_ray.ray).is_some(),
        "blocked-by-the-first-only": is_blocked = |program, shadow_ray| {
            for object in program.objects() {
                if let Some(hit) = object.intersect(&shadow_ray.ray) {
                    return hit.t < shadow_ray.t_max;
                }
            }
            false
        },
        "blocked-by-the-last-only": is_blocked = |program, shadow_ray| {
            let mut is_blocked = false;
            for object in program.objects() {
                if let Some(hit) = object.intersect(&shadow_ray.ray) {
                    is_blocked = hit.t < shadow_ray.t_max;
                }
            }
            is_blocked
        },
        "blocked-turned-round": is_blocked = |program, shadow_ray| !solution::is_blocked(program, shadow_ray),
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(v: DVec3, t_max: f64) -> Lesson {
    RAY.set(Some(ShadowRay { ray: Ray { origin: v, direction: v }, t_max }));
    check::lesson(check::Student { shadow_ray: |_, _| RAY.get().unwrap(), is_blocked: |_, _| true })
}

thread_local! {
    static RAY: Cell<Option<ShadowRay>> = const { Cell::new(None) };
}
