//! Lesson 07, Trace, Intersect and direct light: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::{DirectLight, Hit, Lesson, Light, LightKind, Outcome, Program, Ray, Rgb};

#[path = "../../../lessons/07-trace/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/07-trace/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/07-trace/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(intersect, trace, to_light, diffuse, specular, direct_light);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "last-hit-wins": intersect = |program, ray| {
            let mut found = None;
            for object in program.objects() {
                if let Some(hit) = object.intersect(ray) {
                    found = Some(hit);
                }
            }
            found
        },
        "first-hit-wins": intersect = |program, ray| {
            for object in program.objects() {
                if let Some(hit) = object.intersect(ray) {
                    return Some(hit);
                }
            }
            None
        },
        "background-black": trace = |program, level, ray| match solution::intersect(program, ray) {
            Some(hit) => program.shade(level, ray, &hit),
            None => DVec3::ZERO,
        },
        "surface-colour-unshaded": trace = |program, _, ray| match program.intersect(ray) {
            Some(hit) => hit.material.color,
            None => program.background(ray),
        },
        "trace-level-raised": trace = |program, level, ray| match solution::intersect(program, ray) {
            Some(hit) => program.shade(level + 1, ray, &hit),
            None => program.background(ray),
        },
        "to-light-not-unit": to_light = |point, light| match light.kind {
            LightKind::Point { position } => position - point,
            LightKind::Directional { direction } => -direction,
        },
        "to-light-sun-reversed": to_light = |point, light| match light.kind {
            LightKind::Point { position } => (position - point).normalize(),
            LightKind::Directional { direction } => direction.normalize(),
        },
        "diffuse-negative": diffuse = |material, n, l, light| material.diffuse * material.color * light * n.dot(l),
        "diffuse-light-white": diffuse = |material, n, l, _| material.color * material.diffuse * n.dot(l).max(0.0),
        "specular-away": specular = |material, n, l, d, light| {
            let r = 2.0 * n.dot(l) * n - l;
            material.specular * light * r.dot(d).max(0.0).powf(material.shininess)
        },
        "specular-tinted": specular = |material, n, l, d, light| {
            let r = 2.0 * n.dot(l) * n - l;
            material.color * material.specular * light * r.dot(-d).max(0.0).powf(material.shininess)
        },
        "no-shadow-rays": direct_light = |_, ray, hit, light| {
            let l = solution::to_light(hit.point, light);
            DirectLight {
                diffuse: solution::diffuse(&hit.material, hit.normal, l, light.color),
                specular: match hit.normal.dot(l) > 0.0 {
                    true => solution::specular(&hit.material, hit.normal, l, ray.direction, light.color),
                    false => Rgb::ZERO,
                },
            }
        },
        "direct-facing-unasked": direct_light = |program, ray, hit, light| {
            let (n, l) = (hit.normal, solution::to_light(hit.point, light));
            match program.is_lit(hit, light) && n.dot(l) >= 0.0 {
                true => DirectLight {
                    diffuse: solution::diffuse(&hit.material, n, l, light.color),
                    specular: solution::specular(&hit.material, n, l, ray.direction, light.color),
                },
                false => DirectLight::default(),
            }
        },
        "direct-without-highlight": direct_light = |program, ray, hit, light| {
            DirectLight { specular: Rgb::ZERO, ..solution::direct_light(program, ray, hit, light) }
        },
    ]
}

/// What is wrong in a function is wrong in the whole tree as well.
#[test]
fn the_whole_tree_sees_what_its_functions_do() {
    type Lighting = fn(&Program, &Ray, &Hit, &Light) -> DirectLight;
    let direct: [Lighting; 3] = [
        |program, ray, hit, light| {
            let back = Ray { direction: -ray.direction, ..*ray };
            solution::direct_light(program, &back, hit, light)
        },
        |program, ray, hit, light| {
            let DirectLight { diffuse, specular } = solution::direct_light(program, ray, hit, light);
            DirectLight { diffuse, specular: specular * hit.material.color }
        },
        |program, ray, hit, light| DirectLight {
            specular: Rgb::ZERO,
            ..solution::direct_light(program, ray, hit, light)
        },
    ];
    let planted = direct.map(|direct_light| check::lesson(check::Student { direct_light, ..student() }));
    let mut lessons = Vec::from(planted);
    lessons.extend(wrong().into_iter().filter(|(id, _)| *id == "trace-level-raised").map(|(_, lesson)| lesson));
    assert_eq!(lessons.len(), 4);
    for lesson in lessons {
        let (report, _) = lesson.check();
        let whole = report.stages.last().unwrap();
        assert_eq!((whole.outcome, whole.points), (Outcome::NotReached, 0), "{}", report.to_text("run"));
    }
    let missing = |text: &str| text.contains("  -  ") && text.contains("waits for to_light, diffuse and specular");
    let (report, _) = unsolved().check();
    assert!(missing(&report.to_text("run")), "{}", report.to_text("run"));
}

#[test]
fn a_hit_that_is_not_shaded_is_told_as_such() {
    let (_, lesson) = wrong().into_iter().find(|(id, _)| *id == "surface-colour-unshaded").unwrap();
    let text = lesson.check().0.to_text("run");
    assert!(text.contains("expected  root outcome: hit; colour"), "{text}");
    assert!(text.contains("got       root outcome: hit, but not shaded; colour"), "{text}");
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(v: DVec3) -> Lesson {
    V.set(v);
    check::lesson(check::Student {
        intersect: |_, _| None,
        trace: |_, _, _| V.get(),
        to_light: |_, _| V.get(),
        diffuse: |_, _, _, _| V.get(),
        specular: |_, _, _, _, _| V.get(),
        direct_light: |_, _, _, _| DirectLight { diffuse: V.get(), specular: V.get() },
    })
}

thread_local! {
    static V: Cell<DVec3> = const { Cell::new(DVec3::ZERO) };
}
