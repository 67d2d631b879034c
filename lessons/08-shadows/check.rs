//! Lesson 08, shadows: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::lessons::{
    Answer, Case, Fault, Lesson, Light, LightKind, Pixel, Procedures, Program, Ray, Rgb, ShadowRay, Task, pictures,
    pixels, random_cases, shown,
};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) shadow_ray: fn(DVec3, &Light) -> ShadowRay,
    pub(crate) is_blocked: fn(&Program, &ShadowRay) -> bool,
}

const GIVEN: Procedures = Procedures::GIVEN;

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    let with_blocked = Procedures { is_blocked: student.is_blocked, ..GIVEN };
    let with_all = Procedures { shadow_ray: student.shadow_ray, is_blocked: student.is_blocked, ..GIVEN };
    Lesson {
        number: 8,
        title: "shadows",
        stages: vec![
            shadow_ray().stage(move |(point, light)| to_light((student.shadow_ray)(*point, light))),
            is_blocked().stage(move |pixel| pixel.answer(with_blocked)),
            program().stage(move |pixel| pixel.answer(with_all)),
        ],
        notice: "Now see three shadow rays at one point: raytree diagram scenes/shadows-of-several-lights.json \"only green\" \
                 --kind section -o lights.png",
    }
}

fn to_light(ShadowRay { ray, t_max }: ShadowRay) -> Answer {
    Answer::of("origin", ray.origin).and("direction", ray.direction).and("t_max", t_max)
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn lamp(position: DVec3) -> Light {
    Light { name: "lamp".to_owned(), kind: LightKind::Point { position }, color: Rgb::ONE }
}

fn sun(direction: DVec3) -> Light {
    Light { name: "sun".to_owned(), kind: LightKind::Directional { direction }, color: Rgb::ONE }
}

fn shadow_ray() -> Task<(DVec3, Light)> {
    fn of(origin: DVec3, direction: DVec3, t_max: f64) -> Answer {
        to_light(ShadowRay { ray: Ray { origin, direction }, t_max })
    }
    /// What a function answers that makes a ray out of the way to a point light, and is right about the others.
    fn at_lamps((point, light): &(DVec3, Light), make: fn(DVec3) -> (DVec3, f64)) -> Answer {
        match light.kind {
            LightKind::Point { position } => {
                let (direction, t_max) = make(position - *point);
                of(*point, direction, t_max)
            }
            LightKind::Directional { direction } => of(*point, -direction, f64::INFINITY),
        }
    }
    fn right(case: &(DVec3, Light)) -> Answer {
        at_lamps(case, |way| (way.normalize(), way.length()))
    }
    const FAULTS: &[Fault<(DVec3, Light)>] = &[
        Fault {
            id: "shadow-ray-past-light",
            name: "the direction is the whole way to the light, but t_max is the distance: the ray looks past the light",
            why: "Where the direction is the whole way, the light is at t = 1. Of length 1, it is at t = distance.",
            answer: |case| at_lamps(case, |way| (way, way.length())),
        },
        Fault {
            id: "shadow-ray-of-one",
            name: "the direction is the whole way to the light, with the light at t = 1",
            why: "That fits together, and would give the same shadows. Here directions to lights have length 1, so that t \
                  is a distance.",
            answer: |case| at_lamps(case, |way| (way, 1.0)),
        },
        Fault {
            id: "shadow-ray-too-short",
            name: "t_max is 1 for a direction of length 1: only what is very near throws a shadow",
            why: "t is the distance if the direction has length 1, and the light is at t = distance.",
            answer: |case| at_lamps(case, |way| (way.normalize(), 1.0)),
        },
        Fault {
            id: "shadow-ray-endless",
            name: "the ray to a point light does not end there",
            why: "What lies behind the light is not in its way: t_max is the distance.",
            answer: |case| at_lamps(case, |way| (way.normalize(), f64::INFINITY)),
        },
        Fault {
            id: "shadow-ray-squared",
            name: "t_max is the square of the distance",
            why: "v . v is the square of the length; v.length() is the length.",
            answer: |case| at_lamps(case, |way| (way.normalize(), way.length_squared())),
        },
        Fault {
            id: "shadow-ray-reversed",
            name: "the ray to a point light goes away from it",
            why: "From a to b is b - a: position - point.",
            answer: |case| at_lamps(case, |way| (-way.normalize(), way.length())),
        },
        Fault {
            id: "shadow-ray-from-light",
            name: "the ray starts at the light",
            why: "It starts at the point, so that the surface it starts on is known and does not shadow itself.",
            answer: |(point, light)| match light.kind {
                LightKind::Point { position } => {
                    let way = *point - position;
                    of(position, way.normalize(), way.length())
                }
                LightKind::Directional { .. } => right(&(*point, light.clone())),
            },
        },
        Fault {
            id: "shadow-ray-sun-reversed",
            name: "the ray to a directional light goes the way of the light",
            why: "`direction` says where the light goes. To the light is the opposite way: -direction.",
            answer: |(point, light)| match light.kind {
                LightKind::Point { .. } => right(&(*point, light.clone())),
                LightKind::Directional { direction } => of(*point, direction, f64::INFINITY),
            },
        },
    ];
    let mut cases = vec![
        Case::new("a lamp above", (DVec3::ZERO, lamp(dvec3(0.0, 4.0, 0.0)))),
        Case::new("a lamp aside", (dvec3(1.0, 0.0, 2.0), lamp(dvec3(4.0, 4.0, 2.0)))),
        Case::new("the sun", (dvec3(1.0, 2.0, 3.0), sun(dvec3(0.6, -0.8, 0.0)))),
    ];
    cases.extend(random_cases(801, 45, |random| {
        let point = random.vector(|random| random.below(9) as f64 - 4.0);
        let other = random.vector(|random| random.below(9) as f64 - 4.0);
        let light = if random.one_in(3) { sun(random.direction()) } else { lamp(other) };
        (other.distance(point) > 1.0).then_some((point, light))
    }));
    Task {
        name: "shadow: the ray to the light",
        function: "shadow_ray",
        points: 3,
        after: &[],
        cases,
        given: |(point, light)| {
            let light = match light.kind {
                LightKind::Point { position } => named("point light, position", position),
                LightKind::Directional { direction } => named("directional light, direction", direction),
            };
            vec![named("point", *point), light]
        },
        truth: right,
        faults: FAULTS,
        picture: |(point, light), what, _| pictures::towards_light(*point, light, what),
        hints: &[
            "match light.kind { LightKind::Point { position } => ..., LightKind::Directional { direction } => ... }, as in \
             lesson 07.",
            "The way to a point light is position - point; its length is the distance. Divide by it, and t counts distances.",
            "ShadowRay { ray: Ray { origin: point, direction: way / distance }, t_max: distance }",
        ],
    }
}

fn lamps() -> Vec<Case<Pixel>> {
    let mut cases = pixels("scenes/shadow.json", include_str!("../../scenes/shadow.json"));
    cases.extend(pixels("scenes/up-to-the-light.json", include_str!("../../scenes/up-to-the-light.json")));
    cases.extend(several());
    // Here one object lies beyond the lamp, and another one, later in the scene, is in the way.
    let water = include_str!("../../scenes/total-internal-reflection.json");
    cases.extend(pixels("scenes/total-internal-reflection.json", water));
    cases
}

fn several() -> Vec<Case<Pixel>> {
    let text = include_str!("../../scenes/shadows-of-several-lights.json");
    pixels("scenes/shadows-of-several-lights.json", text)
}

fn is_blocked() -> Task<Pixel> {
    /// The places on a shadow ray where objects are hit, in the order of the objects.
    fn met(program: &Program, shadow_ray: &ShadowRay) -> Vec<Option<f64>> {
        program.objects().map(|object| object.intersect(&shadow_ray.ray).map(|hit| hit.t)).collect()
    }
    const FAULTS: &[Fault<Pixel>] = &[
        Fault {
            id: "nothing-blocks",
            name: "nothing ever blocks a light",
            why: "A light reaches the point only if no object is hit at a t below t_max.",
            answer: |pixel| pixel.answer(Procedures { is_blocked: |_, _| false, ..GIVEN }),
        },
        Fault {
            id: "blocked-behind-the-light",
            name: "what lies behind the light blocks it",
            why: "A shadow ray ends at its light: a hit counts only where its t is smaller than t_max.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    is_blocked: |program, shadow_ray| met(program, shadow_ray).iter().flatten().next().is_some(),
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "blocked-only-behind-the-light",
            name: "only what lies behind the light blocks it: the comparison is turned round",
            why: "In the way is what comes before the light: t < t_max.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    is_blocked: |program, shadow| met(program, shadow).into_iter().flatten().any(|t| t > shadow.t_max),
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "blocked-by-the-first-only",
            name: "only the first object that is hit is looked at",
            why: "If the first object is beyond the light, the next one may still be before it: all have to be asked.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    is_blocked: |program, shadow| {
                        met(program, shadow).into_iter().flatten().next().is_some_and(|t| t < shadow.t_max)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "blocked-by-the-last-only",
            name: "only the last object that is hit counts",
            why: "What is found later must not undo what was found before: return true at the first object in the way.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    is_blocked: |program, shadow| {
                        met(program, shadow).into_iter().flatten().next_back().is_some_and(|t| t < shadow.t_max)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "blocked-turned-round",
            name: "the answer is turned round: what blocks a light lets it through",
            why: "is_blocked is true where something is in the way.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    is_blocked: |program, shadow| !met(program, shadow).into_iter().flatten().any(|t| t < shadow.t_max),
                    ..GIVEN
                })
            },
        },
    ];
    Task {
        name: "shadow: what is in the way",
        function: "is_blocked",
        points: 3,
        after: &[],
        cases: lamps(),
        given: Pixel::given,
        truth: Pixel::truth,
        faults: FAULTS,
        picture: pictures::renders,
        hints: &[
            "for object in program.objects() { ... }, and object.intersect(&shadow_ray.ray) is its hit, if any.",
            "You need not look for the nearest: any hit with hit.t < shadow_ray.t_max is enough to return true.",
        ],
    }
}

fn program() -> Task<Pixel> {
    let mut cases = several();
    cases.extend(lamps());
    Task {
        name: "shadow: the whole tree",
        function: "the program",
        points: 1,
        after: &["shadow_ray", "is_blocked"],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: &[],
        picture: pictures::renders,
        hints: &["Both functions run together here. Look at the first that is wrong above; this one follows from it."],
    }
}
