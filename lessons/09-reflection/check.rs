//! Lesson 09, reflection and maxLevel: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::kernels::optics::reflect;
use raytree::lessons::{
    Answer, Case, ClassicFault, Fault, Hit, Lesson, Pixel, Procedures, Program, Ray, Rgb, Task, pictures, pixels,
    random_cases, shown,
};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) reflected_direction: fn(DVec3, DVec3) -> DVec3,
    pub(crate) shade: fn(&Program, u32, &Ray, &Hit) -> Rgb,
}

const GIVEN: Procedures = Procedures::GIVEN;

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    let with_shade = Procedures { shade: student.shade, ..GIVEN };
    Lesson {
        number: 9,
        title: "reflection",
        stages: vec![
            reflected_direction().stage(move |[d, n]| direction((student.reflected_direction)(*d, *n))),
            shade().stage(move |pixel| pixel.answer(with_shade)),
        ],
        notice: "Now look down the row of mirrors: raytree diagram scenes/hall-of-mirrors.json \"two reflections\" --kind tree \
                 -o mirrors.png",
    }
}

fn direction(v: DVec3) -> Answer {
    Answer::of("direction", v)
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn reflected_direction() -> Task<[DVec3; 2]> {
    const FAULTS: &[Fault<[DVec3; 2]>] = &[
        Fault {
            id: "reflected-sign",
            name: "a plus where there has to be a minus: the ray goes on into the surface",
            why: "d . n is negative, so -2 (d . n) n points along n, away from the surface: d - 2 (d . n) n.",
            answer: |[d, n]| direction(*d + 2.0 * d.dot(*n) * *n),
        },
        Fault {
            id: "reflected-without-2",
            name: "the 2 is missing: the ray goes along the surface",
            why: "d less its part along n is what runs along the surface. Taking that part off twice turns it round.",
            answer: |[d, n]| direction(*d - d.dot(*n) * *n),
        },
        Fault {
            id: "reflected-reversed",
            name: "the direction is turned round: this is the formula for an arrow that leaves the surface",
            why: "2 (n . l) n - l mirrors the way to a light. d arrives at the surface, and the formula is d - 2 (d . n) n.",
            answer: |[d, n]| direction(2.0 * d.dot(*n) * *n - *d),
        },
        Fault {
            id: "reflected-straight-back",
            name: "the ray goes back where it came from",
            why: "Only the part of d along the normal is turned round; what runs along the surface stays.",
            answer: |[d, _]| direction(-*d),
        },
        Fault {
            id: "reflected-length-lost",
            name: "the direction was made as long as 1",
            why: "A mirror keeps the length, so there is nothing to be normalised: t stays in the same units.",
            answer: |[d, n]| direction(reflect::<f64>(*d, *n).normalize()),
        },
        Fault {
            id: "reflected-along-normal",
            name: "the ray leaves along the normal",
            why: "The angle to the normal is the same on both sides: d - 2 (d . n) n.",
            answer: |[_, n]| direction(*n),
        },
    ];
    let up = dvec3(0.0, 1.0, 0.0);
    let mut cases = vec![
        Case::new("down onto a floor", [dvec3(3.0, -4.0, 0.0), up]),
        Case::new("straight down", [dvec3(0.0, -2.0, 0.0), up]),
        Case::new("against a wall", [dvec3(1.0, 2.0, -2.0), dvec3(0.0, 0.0, 1.0)]),
        Case::new("a slanted mirror", [dvec3(0.0, -5.0, 0.0), dvec3(0.6, 0.8, 0.0)]),
    ];
    cases.extend(random_cases(901, 44, |random| {
        let d = random.vector(|random| random.below(9) as f64 - 4.0);
        let n = random.direction();
        let n = if d.dot(n) > 0.0 { -n } else { n };
        (d.dot(n) < -0.1).then_some([d, n])
    }));
    Task {
        name: "reflection: the direction",
        function: "reflected_direction",
        points: 3,
        after: &[],
        cases,
        given: |[d, n]| vec![named("d", *d), named("n", *n)],
        truth: |[d, n]| direction(reflect::<f64>(*d, *n)),
        faults: FAULTS,
        picture: |[d, n], what, _| pictures::at_surface(*n, Some(*d), &[], "direction", what),
        hints: &[
            "d is a part along the normal, (d . n) n, and a part along the surface. Which of them does a mirror change?",
            "d - 2.0 * d.dot(n) * n",
        ],
    }
}

fn shade() -> Task<Pixel> {
    /// Shade with the level that it asks about, that which it passes on, and what it makes of both colours.
    fn with(
        program: &Program,
        (level, ray, hit): (u32, &Ray, &Hit),
        goes_on: fn(u32, u32) -> bool,
        onward: fn(u32) -> u32,
        sum: fn(local: Rgb, weight: Rgb, back: Rgb) -> Rgb,
    ) -> Rgb {
        let local = program.local_color(ray, hit);
        let Some(weight) = hit.material.reflection.filter(|_| goes_on(level, program.max_level())) else {
            return local;
        };
        let direction = reflect::<f64>(ray.direction, hit.normal);
        sum(local, weight, program.trace_reflected(onward(level), &Ray { origin: hit.point, direction }))
    }
    /// Shade with reflected rays that start so far above the surface.
    fn lift(epsilon: f64, program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
        let local = program.local_color(ray, hit);
        let Some(weight) = hit.material.reflection.filter(|_| level < program.max_level()) else { return local };
        let direction = reflect::<f64>(ray.direction, hit.normal);
        let origin = hit.point + epsilon * hit.normal;
        local + weight * program.trace_reflected(level + 1, &Ray { origin, direction })
    }
    const LIFTED: &str = "the reflected ray starts a little above the surface";
    const NO_LIFT: &str = "No epsilon is needed here: a ray that starts at hit.point is known to leave that surface. Lesson 11 \
                           is about programs that do not know it.";
    const FAULTS: &[Fault<Pixel>] = &[
        Fault {
            id: "recursion-endless",
            name: "the recursion does not end at maxLevel",
            why: "A reflected ray is sent only where level < maxLevel, and it has the level + 1. Without either the light goes \
                  to and fro between two mirrors for ever. (Here it is cut off at level 64.)",
            answer: |pixel| {
                pixel.answer(Procedures {
                    shade: |program, level, ray, hit| {
                        let sum = |local, weight, back| local + weight * back;
                        with(program, (level, ray, hit), |_, _| true, |level| level, sum)
                    },
                    ..GIVEN
                })
            },
        },
        Fault::classic(ClassicFault::LevelOneTooMany, |pixel| pixel.with_fault(ClassicFault::LevelOneTooMany)),
        Fault {
            id: "level-one-too-few",
            name: "the recursion ends one level too early",
            why: "The last level that sends a ray on is maxLevel - 1: level < maxLevel, not level + 1 < maxLevel.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    shade: |program, level, ray, hit| {
                        let sum = |local, weight, back| local + weight * back;
                        with(program, (level, ray, hit), |level, max| level + 1 < max, |level| level + 1, sum)
                    },
                    ..GIVEN
                })
            },
        },
        Fault::classic(ClassicFault::ColorBeforeWeight, |pixel| pixel.with_fault(ClassicFault::ColorBeforeWeight)),
        Fault {
            id: "reflection-weight-forgotten",
            name: "the reflected light is added without its weight",
            why: "A mirror swallows some of the light: reflection * program.trace_reflected(...).",
            answer: |pixel| {
                pixel.answer(Procedures {
                    shade: |program, level, ray, hit| {
                        let sum = |local, _, back| local + back;
                        with(program, (level, ray, hit), |level, max| level < max, |level| level + 1, sum)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "reflection-instead-of-local",
            name: "the surface's own light is lost where it reflects",
            why: "The colour is the sum of both: += adds, = throws away what was there.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    shade: |program, level, ray, hit| {
                        let sum = |_, weight, back| weight * back;
                        with(program, (level, ray, hit), |level, max| level < max, |level| level + 1, sum)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "reflection-forgotten",
            name: "no reflected ray is sent",
            why: "Where hit.material.reflection is Some(weight) and level < maxLevel, the reflected ray is traced.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |program, _, ray, hit| program.local_color(ray, hit), ..GIVEN })
            },
        },
        Fault {
            id: "reflection-lifted-1e-3",
            name: LIFTED,
            why: NO_LIFT,
            answer: |pixel| pixel.answer(Procedures { shade: |p, l, r, h| lift(1e-3, p, l, r, h), ..GIVEN }),
        },
        Fault {
            id: "reflection-lifted-1e-4",
            name: LIFTED,
            why: NO_LIFT,
            answer: |pixel| pixel.answer(Procedures { shade: |p, l, r, h| lift(1e-4, p, l, r, h), ..GIVEN }),
        },
        Fault::classic(ClassicFault::ReflectSign, |pixel| pixel.with_fault(ClassicFault::ReflectSign)),
    ];
    let mut cases = pixels("scenes/first-tree.json", include_str!("../../scenes/first-tree.json"));
    cases.extend(pixels("scenes/hall-of-mirrors.json", include_str!("../../scenes/hall-of-mirrors.json")));
    cases.extend(pixels("scenes/coloured-weights.json", include_str!("../../scenes/coloured-weights.json")));
    Task {
        name: "colour: Shade",
        function: "shade",
        points: 4,
        after: &["reflected_direction"],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: FAULTS,
        picture: pictures::renders,
        hints: &[
            "let mut color = program.local_color(ray, hit); is what the surface sends back by itself.",
            "if let Some(reflection) = hit.material.reflection { ... } and, inside, if level < program.max_level() { ... }",
            "The reflected ray starts at hit.point: Ray { origin: hit.point, direction: reflected_direction(ray.direction, \
             hit.normal) }. program.trace_reflected(level + 1, &reflected) is what it brings back.",
        ],
    }
}
