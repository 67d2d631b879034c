//! Lesson 10, refraction and total internal reflection: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::kernels::optics::{reflect, refract};
use raytree::lessons::{
    Answer, Case, ClassicFault, Fault, Hit, Lesson, Pixel, Procedures, Program, Ray, Rgb, Task, pictures, pixels,
    random_cases, shown,
};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) refracted_direction: fn(DVec3, DVec3, f64, f64) -> Option<DVec3>,
    pub(crate) shade: fn(&Program, u32, &Ray, &Hit) -> Rgb,
}

const GIVEN: Procedures = Procedures::GIVEN;

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    let with_shade = Procedures { shade: student.shade, ..GIVEN };
    Lesson {
        number: 10,
        title: "refraction",
        stages: vec![
            refracted_direction().stage(move |b| direction((student.refracted_direction)(b.d, b.n, b.n1, b.n2))),
            shade().stage(move |pixel| pixel.answer(with_shade)),
        ],
        notice: "Now follow a ray through glass, water and air: raytree diagram scenes/nested-media.json \"through all of it\" \
                 --kind section -o media.png",
    }
}

fn direction(v: Option<DVec3>) -> Answer {
    Answer::maybe(v, "total reflection", |v| Answer::of("direction", v))
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

/// A ray at a boundary.
#[derive(Clone, Copy, Debug)]
struct Boundary {
    d: DVec3,
    n: DVec3,
    n1: f64,
    n2: f64,
}

fn refracted_direction() -> Task<Boundary> {
    /// Snell's law with these two numbers, and what to do with a negative k.
    fn snell(b: &Boundary, eta: f64, root: fn(f64) -> Option<f64>) -> Answer {
        let length = b.d.length();
        let cos1 = -b.d.dot(b.n) / length;
        let cos2 = root(1.0 - eta * eta * (1.0 - cos1 * cos1));
        direction(cos2.map(|cos2| eta * b.d + (eta * cos1 - cos2) * length * b.n))
    }
    fn checked(k: f64) -> Option<f64> {
        (k >= 0.0).then(|| k.sqrt())
    }
    const FAULTS: &[Fault<Boundary>] = &[
        Fault {
            id: "refracted-eta-inverted",
            name: "eta is the wrong way round",
            why: "n1 sin1 = n2 sin2, so sin2 = (n1 / n2) sin1: eta is n1 / n2. Into glass the ray bends towards the normal.",
            answer: |b| snell(b, b.n2 / b.n1, checked),
        },
        Fault {
            id: "refracted-unbent",
            name: "the ray is not bent",
            why: "Between different indices of refraction the sines differ by the factor n1 / n2.",
            answer: |b| direction(Some(b.d)),
        },
        Fault {
            id: "refracted-along-surface",
            name: "where nothing goes through, a ray along the surface is given",
            why: "The number below the root is negative there. It is no rounding error that could be cut off: answer None.",
            answer: |b| snell(b, b.n1 / b.n2, |k| Some(k.max(0.0).sqrt())),
        },
        Fault {
            id: "refracted-nan",
            name: "a negative number below the root is not turned down",
            why: "The root of a negative number is NaN, not a number, and so is everything made of it: answer None first.",
            answer: |b| snell(b, b.n1 / b.n2, |k| Some(k.sqrt())),
        },
        Fault {
            id: "refracted-root-forgotten",
            name: "the root is missing",
            why: "1 - eta^2 (1 - cos1^2) is the square of cos2.",
            answer: |b| snell(b, b.n1 / b.n2, |k| (k >= 0.0).then_some(k)),
        },
        Fault {
            id: "refracted-cosine-sign",
            name: "cos1 has the wrong sign",
            why: "d . n is negative, since d arrives and n leaves: cos1 = -(d . n).",
            answer: |b| {
                let (eta, length) = (b.n1 / b.n2, b.d.length());
                let cos1 = b.d.dot(b.n) / length;
                let cos2 = checked(1.0 - eta * eta * (1.0 - cos1 * cos1));
                direction(cos2.map(|cos2| eta * b.d + (eta * cos1 - cos2) * length * b.n))
            },
        },
        Fault {
            id: "refracted-out-again",
            name: "cos2 has the wrong sign: the ray comes out on the side that it came from",
            why: "The refracted ray goes against the normal by cos2: eta d + (eta cos1 - cos2) n.",
            answer: |b| {
                let (eta, length) = (b.n1 / b.n2, b.d.length());
                let cos1 = -b.d.dot(b.n) / length;
                let cos2 = checked(1.0 - eta * eta * (1.0 - cos1 * cos1));
                direction(cos2.map(|cos2| eta * b.d + (eta * cos1 + cos2) * length * b.n))
            },
        },
        Fault {
            id: "refracted-eta-not-squared",
            name: "eta is not squared below the root",
            why: "sin2 = eta sin1, and sin^2 + cos^2 = 1: cos2^2 = 1 - eta^2 sin1^2.",
            answer: |b| {
                let (eta, length) = (b.n1 / b.n2, b.d.length());
                let cos1 = -b.d.dot(b.n) / length;
                let cos2 = checked(1.0 - eta * (1.0 - cos1 * cos1));
                direction(cos2.map(|cos2| eta * b.d + (eta * cos1 - cos2) * length * b.n))
            },
        },
        Fault {
            id: "refracted-length-taken-for-1",
            name: "the direction is taken for one of length 1",
            why: "d . n is |d| cos1. Divide by the length first, and multiply by it in the end.",
            answer: |b| {
                let eta = b.n1 / b.n2;
                let cos1 = -b.d.dot(b.n);
                let cos2 = checked(1.0 - eta * eta * (1.0 - cos1 * cos1));
                direction(cos2.map(|cos2| eta * b.d + (eta * cos1 - cos2) * b.n))
            },
        },
        Fault {
            id: "refracted-length-lost",
            name: "the direction was made as long as 1",
            why: "It is to be as long as d, so that t stays in the same units.",
            answer: |b| direction(refract::<f64>(b.d, b.n, b.n1, b.n2).map(DVec3::normalize)),
        },
    ];
    let up = dvec3(0.0, 1.0, 0.0);
    let slanted = dvec3(0.6, -0.8, 0.0);
    let mut cases = vec![
        Case::new("into glass", Boundary { d: slanted, n: up, n1: 1.0, n2: 1.5 }),
        Case::new("out of glass, steeply", Boundary { d: slanted, n: up, n1: 1.5, n2: 1.0 }),
        Case::new("out of glass, too flat", Boundary { d: dvec3(0.8, -0.6, 0.0), n: up, n1: 1.5, n2: 1.0 }),
        Case::new("straight through", Boundary { d: dvec3(0.0, -1.0, 0.0), n: up, n1: 1.0, n2: 1.5 }),
        Case::new("a long direction", Boundary { d: 5.0 * slanted, n: up, n1: 1.0, n2: 1.5 }),
        Case::new("the same on both sides", Boundary { d: slanted, n: up, n1: 1.5, n2: 1.5 }),
    ];
    cases.extend(random_cases(1001, 50, |random| {
        let d = random.vector(|random| random.below(9) as f64 - 4.0);
        let n = random.direction();
        let n = if d.dot(n) > 0.0 { -n } else { n };
        let [n1, n2] = [(); 2].map(|()| [1.0, 1.33, 1.5, 2.4][random.below(4)]);
        let cosine = -d.dot(n) / d.length();
        let k = 1.0 - (n1 / n2) * (n1 / n2) * (1.0 - cosine * cosine);
        (cosine > 0.05 && k.abs() > 1e-3).then_some(Boundary { d, n, n1, n2 })
    }));
    Task {
        name: "refraction: the direction",
        function: "refracted_direction",
        points: 4,
        after: &[],
        cases,
        given: |b| vec![named("d", b.d), named("n", b.n), format!("n1 = {}, n2 = {}", shown(b.n1), shown(b.n2))],
        truth: |b| direction(refract::<f64>(b.d, b.n, b.n1, b.n2)),
        faults: FAULTS,
        picture: |b, what, _| pictures::at_surface(b.n, Some(b.d), &[], "direction", what),
        hints: &[
            "Work with d of length 1 (let unit = d / d.length();) and multiply by the length in the end. eta is n1 / n2, and \
             cos1 is -(unit . n).",
            "cos2 is the root of 1 - eta^2 (1 - cos1^2). Where that is negative nothing goes through: return None.",
            "(eta * unit + (eta * cos1 - cos2) * n) * d.length()",
        ],
    }
}

fn shade() -> Task<Pixel> {
    /// What goes wrong.
    #[derive(Clone, Copy, PartialEq)]
    enum Wrong {
        EtaInverted,
        EtaFixed,
        Dropped,
        WeightLost,
        WeightReplaced,
        OnlyMirrors,
        Either,
        Unweighted,
        Endless,
        CalledReflected,
        Through,
        NoReflection,
    }
    fn with(wrong: Wrong, program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
        let mut color = program.local_color(ray, hit);
        if level >= program.max_level() && wrong != Wrong::Endless {
            return color;
        }
        let next = if wrong == Wrong::Endless { level } else { level + 1 };
        let (d, n) = (ray.direction, hit.normal);
        let send = |direction| Ray { origin: hit.point, direction };
        let mut reflection = hit.material.reflection.unwrap_or(Rgb::ZERO);
        if let Some(transmission) = hit.material.transmission {
            let [n1, n2] = match wrong {
                Wrong::EtaInverted => [hit.n2, hit.n1],
                Wrong::EtaFixed => [1.0, 1.5],
                _ => [hit.n1, hit.n2],
            };
            let refracted = match refract::<f64>(d, n, n1, n2) {
                None if wrong == Wrong::Through => Some(d),
                refracted => refracted,
            };
            match refracted {
                Some(direction) => {
                    let weight = if wrong == Wrong::Unweighted { Rgb::ONE } else { transmission };
                    color += weight
                        * match wrong {
                            Wrong::CalledReflected => program.trace_reflected(next, &send(direction)),
                            _ => program.trace_refracted(next, &send(direction)),
                        };
                    if wrong == Wrong::Either || wrong == Wrong::NoReflection {
                        reflection = Rgb::ZERO;
                    }
                }
                None if wrong == Wrong::Dropped => reflection = Rgb::ZERO,
                None if wrong == Wrong::WeightLost => {}
                None if wrong == Wrong::WeightReplaced => reflection = transmission,
                None if wrong == Wrong::OnlyMirrors && hit.material.reflection.is_none() => {}
                None => reflection += transmission,
            }
        }
        if reflection != Rgb::ZERO && wrong != Wrong::NoReflection {
            color += reflection * program.trace_reflected(next, &send(reflect::<f64>(d, n)));
        }
        color
    }
    const FAULTS: &[Fault<Pixel>] = &[
        Fault {
            id: "refraction-indices-exchanged",
            name: "the indices of refraction are exchanged",
            why: "hit.n1 is on the side that the ray comes from, hit.n2 beyond the surface, whether it enters or leaves.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::EtaInverted, p, l, r, h), ..GIVEN })
            },
        },
        Fault {
            id: "refraction-indices-fixed",
            name: "the indices are always 1 and 1.5, whatever hit.n1 and hit.n2 are",
            why: "1 and 1.5 is the way into glass. Out of it, and between other media, they are others: hit.n1, hit.n2.",
            answer: |pixel| pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::EtaFixed, p, l, r, h), ..GIVEN }),
        },
        Fault {
            id: "refraction-dropped",
            name: "at total reflection nothing goes on",
            why: "Where nothing goes through, all of it is reflected: the reflected ray is traced, with both weights.",
            answer: |pixel| pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::Dropped, p, l, r, h), ..GIVEN }),
        },
        Fault {
            id: "refraction-weight-lost",
            name: "at total reflection the weight of the refracted ray is lost",
            why: "What cannot go through is reflected as well: the weight is reflection + transmission.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::WeightLost, p, l, r, h), ..GIVEN })
            },
        },
        Fault {
            id: "refraction-weight-replaced",
            name: "at total reflection the weight of the mirror is lost: it is that of the refracted ray alone",
            why: "What is reflected anyway stays, and what cannot go through is added: reflection + transmission.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::WeightReplaced, p, l, r, h), ..GIVEN })
            },
        },
        Fault {
            id: "refraction-only-mirrors",
            name: "at total reflection no ray is sent where `reflection` is None",
            why: "Glass that is no mirror reflects too where nothing goes through: the weight is then transmission alone.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::OnlyMirrors, p, l, r, h), ..GIVEN })
            },
        },
        Fault {
            id: "refraction-or-reflection",
            name: "where light goes through, no reflected ray is sent",
            why: "Glass does both: if a material has both weights, both rays are traced.",
            answer: |pixel| pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::Either, p, l, r, h), ..GIVEN }),
        },
        Fault {
            id: "refraction-weight-forgotten",
            name: "the refracted light is added without its weight",
            why: "transmission * program.trace_refracted(...): what goes through is tinted and made weaker.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::Unweighted, p, l, r, h), ..GIVEN })
            },
        },
        Fault {
            id: "refraction-endless",
            name: "the recursion does not end at maxLevel",
            why: "Both rays are sent only where level < maxLevel, and both have the level + 1. In glass light is sent on at \
                  every surface, and each time there are twice as many rays.",
            answer: |pixel| pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::Endless, p, l, r, h), ..GIVEN }),
        },
        Fault {
            id: "refraction-called-reflected",
            name: "the refracted ray is sent with trace_reflected",
            why: "The colour is right, but the tree calls the ray what it is not: program.trace_refracted.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::CalledReflected, p, l, r, h), ..GIVEN })
            },
        },
        Fault {
            id: "refraction-straight-on",
            name: "at total reflection the ray goes straight on",
            why: "refracted_direction says None: then there is no refracted ray.",
            answer: |pixel| pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::Through, p, l, r, h), ..GIVEN }),
        },
        Fault {
            id: "refraction-without-reflection",
            name: "no reflected ray is sent",
            why: "What lesson 09 added is still needed: glass reflects too, and at total reflection that is all it does.",
            answer: |pixel| {
                pixel.answer(Procedures { shade: |p, l, r, h| with(Wrong::NoReflection, p, l, r, h), ..GIVEN })
            },
        },
        Fault::classic(ClassicFault::TotalReflectionThrough, |pixel| {
            pixel.with_fault(ClassicFault::TotalReflectionThrough)
        }),
    ];
    let mut cases = pixels("scenes/two-weights.json", include_str!("../../scenes/two-weights.json"));
    cases.extend(pixels("scenes/nested-media.json", include_str!("../../scenes/nested-media.json")));
    Task {
        name: "colour: Shade",
        function: "shade",
        points: 4,
        after: &["refracted_direction"],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: FAULTS,
        picture: pictures::renders,
        hints: &[
            "Begin with your shade of lesson 09. A mirror whose weight is 0 needs no ray: \
             hit.material.reflection.unwrap_or(Rgb::ZERO).",
            "if let Some(transmission) = hit.material.transmission { match refracted_direction(ray.direction, hit.normal, \
             hit.n1, hit.n2) { Some(direction) => ..., None => ... } }",
            "In the first case add transmission * program.trace_refracted(level + 1, &refracted); in the second the weight \
             of the reflected ray grows by transmission.",
        ],
    }
}
