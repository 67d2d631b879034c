//! Lesson 07, Trace, Intersect and direct light: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::lessons::{
    Answer, Case, ClassicFault, DirectLight, Fault, Hit, Lesson, Light, LightKind, Material, Pixel, Procedures,
    Program, Ray, Rgb, Task, pictures, pixels, random_cases, shown,
};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) intersect: fn(&Program, &Ray) -> Option<Hit>,
    pub(crate) trace: fn(&Program, u32, &Ray) -> Rgb,
    pub(crate) to_light: fn(DVec3, &Light) -> DVec3,
    pub(crate) diffuse: fn(&Material, DVec3, DVec3, Rgb) -> Rgb,
    pub(crate) specular: fn(&Material, DVec3, DVec3, DVec3, Rgb) -> Rgb,
    pub(crate) direct_light: fn(&Program, &Ray, &Hit, &Light) -> DirectLight,
}

const GIVEN: Procedures = Procedures::GIVEN;

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    let Student { intersect: nearest, trace: tracing, direct_light: lighting, .. } = student;
    let with_intersect = Procedures { intersect: nearest, ..GIVEN };
    let with_trace = Procedures { trace: tracing, ..GIVEN };
    let with_light = Procedures { direct_light: lighting, ..GIVEN };
    let with_all = Procedures { intersect: nearest, trace: tracing, direct_light: lighting, ..GIVEN };
    Lesson {
        number: 7,
        title: "trace",
        stages: vec![
            intersect().stage(move |pixel| pixel.answer(with_intersect)),
            trace().stage(move |pixel| pixel.answer(with_trace)),
            to_light().stage(move |(point, light)| direction((student.to_light)(*point, light))),
            diffuse().stage(move |s| term((student.diffuse)(&s.material, s.n, s.l, s.light))),
            specular().stage(move |s| term((student.specular)(&s.material, s.n, s.l, s.d, s.light))),
            direct_light().stage(move |pixel| pixel.answer(with_light)),
            program().stage(move |pixel| pixel.answer(with_all)),
        ],
        notice: "Now see what the rays of one pixel bring back: raytree diagram scenes/mirror.json \"mirrored ball\" \
                 --kind tree -o tree.png",
    }
}

fn direction(v: DVec3) -> Answer {
    Answer::of("direction", v)
}

fn term(color: Rgb) -> Answer {
    Answer::of("colour", color)
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn first_hit() -> Vec<Case<Pixel>> {
    pixels("scenes/first-hit.json", include_str!("../../scenes/first-hit.json"))
}

fn mirrors() -> Vec<Case<Pixel>> {
    pixels("scenes/hall-of-mirrors.json", include_str!("../../scenes/hall-of-mirrors.json"))
}

fn mirror() -> Vec<Case<Pixel>> {
    pixels("scenes/mirror.json", include_str!("../../scenes/mirror.json"))
}

fn lights() -> Vec<Case<Pixel>> {
    let text = include_str!("../../scenes/shadows-of-several-lights.json");
    pixels("scenes/shadows-of-several-lights.json", text)
}

fn sphere() -> Vec<Case<Pixel>> {
    pixels("scenes/sphere.json", include_str!("../../scenes/sphere.json"))
}

fn intersect() -> Task<Pixel> {
    fn choose(program: &Program, ray: &Ray, is_better: fn(&Hit, &Hit) -> bool) -> Option<Hit> {
        let hits = program.objects().filter_map(|object| object.intersect(ray));
        hits.reduce(|before, hit| if is_better(&hit, &before) { hit } else { before })
    }
    const FAULTS: &[Fault<Pixel>] = &[
        Fault::classic(ClassicFault::LastHitWins, |pixel| {
            pixel.answer(Procedures { intersect: |program, ray| choose(program, ray, |_, _| true), ..GIVEN })
        }),
        Fault {
            id: "first-hit-wins",
            name: "the first object that is hit is taken, not the nearest",
            why: "The order of the objects says nothing about their distance: all of them have to be asked.",
            answer: |pixel| {
                pixel.answer(Procedures { intersect: |program, ray| choose(program, ray, |_, _| false), ..GIVEN })
            },
        },
        Fault {
            id: "farthest-hit-wins",
            name: "the farthest hit is taken, not the nearest",
            why: "The nearest hit is the one with the smallest t: what is farther away is hidden behind it.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    intersect: |program, ray| choose(program, ray, |hit, before| hit.t > before.t),
                    ..GIVEN
                })
            },
        },
    ];
    let mut cases = first_hit();
    cases.extend(mirrors());
    Task {
        name: "hit: the nearest",
        function: "intersect",
        points: 2,
        after: &[],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: FAULTS,
        picture: pictures::renders,
        hints: &[
            "for object in program.objects() { ... } goes through all of them; object.intersect(ray) is its hit, if any.",
            "Keep the best hit so far in a variable: let mut nearest: Option<Hit> = None; A new one replaces it if there was \
             none, or if its t is smaller.",
        ],
    }
}

fn trace() -> Task<Pixel> {
    fn shaded(program: &Program, level: u32, ray: &Ray) -> Option<Rgb> {
        program.intersect(ray).map(|hit| program.shade(level, ray, &hit))
    }
    const FAULTS: &[Fault<Pixel>] = &[
        Fault {
            id: "background-black",
            name: "a ray that hits nothing brings back black, not the background",
            why: "program.background(ray) is the colour of the sky.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    trace: |program, level, ray| shaded(program, level, ray).unwrap_or(Rgb::ZERO),
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "surface-colour-unshaded",
            name: "the colour of the material is returned, not what Shade makes of it",
            why: "Light, shadow and mirrors are the business of Shade: program.shade(level, ray, &hit).",
            answer: |pixel| {
                pixel.answer(Procedures {
                    trace: |program, _, ray| {
                        program.intersect(ray).map_or(program.background(ray), |hit| hit.material.color)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "trace-level-raised",
            name: "Trace hands Shade the level + 1",
            why: "Trace and Shade of one ray have the same level; it is Shade that adds 1 for the rays it sends on.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    trace: |program, level, ray| {
                        shaded(program, level + 1, ray).unwrap_or_else(|| program.background(ray))
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "trace-level-forgotten",
            name: "Trace hands Shade the level 0, whatever its own is",
            why: "The level counts how often the light was sent on, so that the recursion ends. Pass on the one you were given.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    trace: |program, _, ray| shaded(program, 0, ray).unwrap_or_else(|| program.background(ray)),
                    ..GIVEN
                })
            },
        },
    ];
    let mut cases = first_hit();
    cases.extend(mirrors());
    Task {
        name: "colour: Trace",
        function: "trace",
        points: 2,
        after: &[],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: FAULTS,
        picture: pictures::renders,
        hints: &[
            "Call program.intersect(ray), not your intersect: that goes to the same function, and the program sees it.",
            "match program.intersect(ray) { Some(hit) => ..., None => ... }",
            "Some(hit) => program.shade(level, ray, &hit), None => program.background(ray)",
        ],
    }
}

fn right_way(point: DVec3, light: &Light) -> DVec3 {
    match light.kind {
        LightKind::Point { position } => (position - point).normalize(),
        LightKind::Directional { direction } => -direction,
    }
}

fn lamp(position: DVec3) -> Light {
    Light { name: "lamp".to_owned(), kind: LightKind::Point { position }, color: Rgb::ONE }
}

fn sun(direction: DVec3) -> Light {
    Light { name: "sun".to_owned(), kind: LightKind::Directional { direction }, color: Rgb::ONE }
}

fn to_light() -> Task<(DVec3, Light)> {
    const FAULTS: &[Fault<(DVec3, Light)>] = &[
        Fault {
            id: "to-light-not-unit",
            name: "the direction to a point light is not of length 1",
            why: "n . l is a cosine only if both have length 1. (position - point) is as long as the way.",
            answer: |(point, light)| {
                direction(match light.kind {
                    LightKind::Point { position } => position - *point,
                    LightKind::Directional { direction } => -direction,
                })
            },
        },
        Fault {
            id: "to-light-reversed",
            name: "this is the way that the light travels: from the light to the point",
            why: "n . l is above 0 on the lit side only if l goes from the point to the light.",
            answer: |(point, light)| direction(-right_way(*point, light)),
        },
        Fault {
            id: "to-light-point-reversed",
            name: "for a point light this is the way from the light to the point",
            why: "From a to b is b - a: position - point.",
            answer: |(point, light)| {
                let way = right_way(*point, light);
                direction(if matches!(light.kind, LightKind::Point { .. }) { -way } else { way })
            },
        },
        Fault {
            id: "to-light-sun-reversed",
            name: "for a directional light this is the way that the light travels",
            why: "`direction` says where the light goes. To the light is the opposite way: -direction.",
            answer: |(point, light)| {
                let way = right_way(*point, light);
                direction(if matches!(light.kind, LightKind::Point { .. }) { way } else { -way })
            },
        },
        Fault {
            id: "to-light-from-origin",
            name: "the position of the light is taken for the direction",
            why: "The position alone is the way from the origin of the world to the light. The way from the point is \
                  position - point.",
            answer: |(_, light)| direction(right_way(DVec3::ZERO, light)),
        },
    ];
    let mut cases = vec![
        Case::new("straight up", (DVec3::ZERO, lamp(dvec3(0.0, 4.0, 0.0)))),
        Case::new("a lamp aside", (dvec3(1.0, 0.0, 2.0), lamp(dvec3(4.0, 4.0, 2.0)))),
        Case::new("the sun", (dvec3(1.0, 2.0, 3.0), sun(dvec3(0.6, -0.8, 0.0)))),
    ];
    cases.extend(random_cases(701, 45, |random| {
        let point = random.vector(|random| random.below(9) as f64 - 4.0);
        let other = random.vector(|random| random.below(9) as f64 - 4.0);
        let light = match random.one_in(3) {
            true => sun(random.direction()),
            false => lamp(other),
        };
        (other != point).then_some((point, light))
    }));
    Task {
        name: "colour: the way to the light",
        function: "to_light",
        points: 1,
        after: &[],
        cases,
        given: |(point, light)| {
            let light = match light.kind {
                LightKind::Point { position } => named("point light, position", position),
                LightKind::Directional { direction } => named("directional light, direction", direction),
            };
            vec![named("point", *point), light]
        },
        truth: |(point, light)| direction(right_way(*point, light)),
        faults: FAULTS,
        picture: |(point, light), what, _| pictures::towards_light(*point, light, what),
        hints: &[
            "match light.kind { LightKind::Point { position } => ..., LightKind::Directional { direction } => ... }",
            "From a to b is b - a, and v.normalize() has length 1. `direction` is where the light goes, and has length 1.",
        ],
    }
}

/// A surface with one light, and a ray that arrives.
#[derive(Clone, Copy, Debug)]
struct Lit {
    material: Material,
    n: DVec3,
    l: DVec3,
    d: DVec3,
    light: Rgb,
}

const RED: Material = Material {
    color: Rgb::new(0.8, 0.2, 0.1),
    ambient: Rgb::ZERO,
    diffuse: Rgb::splat(0.5),
    specular: Rgb::splat(0.4),
    shininess: 2.0,
    reflection: None,
    transmission: None,
};

fn lit_cases(seed: u64) -> Vec<Case<Lit>> {
    let (up, slanted) = (dvec3(0.0, 1.0, 0.0), dvec3(0.6, 0.8, 0.0));
    let of = |n, l, d, light| Lit { material: RED, n, l, d, light };
    let mut cases = vec![
        Case::new("light from the side", of(up, slanted, dvec3(0.0, -1.0, 0.0), Rgb::ONE)),
        Case::new("light from straight above", of(up, up, dvec3(0.6, -0.8, 0.0), Rgb::ONE)),
        Case::new("a coloured light", of(up, slanted, dvec3(0.8, -0.6, 0.0), Rgb::new(1.0, 0.5, 0.25))),
        Case::new("the eye where the mirror image is", of(up, slanted, dvec3(0.6, -0.8, 0.0), Rgb::ONE)),
        Case::new("the eye beside the light", of(up, slanted, dvec3(-0.6, -0.8, 0.0), Rgb::ONE)),
        Case::new("the light behind the surface", of(up, dvec3(0.6, -0.8, 0.0), dvec3(0.0, -1.0, 0.0), Rgb::ONE)),
    ];
    cases.extend(random_cases(seed, 42, |random| {
        let weight = |random: &mut raytree::lessons::Random| 0.1 * (1 + random.below(9)) as f64;
        let color = random.vector(weight);
        let material = Material {
            color,
            diffuse: Rgb::splat(weight(random)),
            specular: Rgb::splat(weight(random)),
            shininess: (1 + random.below(6)) as f64,
            ..RED
        };
        let (n, l, d, light) = (random.direction(), random.direction(), random.direction(), random.vector(weight));
        let d = if d.dot(n) > 0.0 { -d } else { d };
        let is_clear = n.dot(l).abs() > 1e-3 && (2.0 * n.dot(l) * n - l).dot(d).abs() > 1e-3;
        is_clear.then_some(Lit { material, n, l, d, light })
    }));
    cases
}

fn of_lit(s: &Lit) -> Vec<String> {
    let Material { color, diffuse, specular, shininess, .. } = s.material;
    vec![
        named("n", s.n),
        named("l", s.l),
        named("d", s.d),
        named("colour", color),
        format!("k_d = {}, k_s = {}, shininess = {}", shown(diffuse.x), shown(specular.x), shown(shininess)),
        named("light", s.light),
    ]
}

fn diffuse() -> Task<Lit> {
    fn right(s: &Lit) -> Rgb {
        s.material.diffuse * s.material.color * s.n.dot(s.l).max(0.0) * s.light
    }
    const FAULTS: &[Fault<Lit>] = &[
        Fault {
            id: "diffuse-negative",
            name: "a light behind the surface takes light away",
            why: "n . l is below 0 where the surface faces away from the light. There it gets nothing: max(0, n . l).",
            answer: |s| term(s.material.diffuse * s.material.color * s.n.dot(s.l) * s.light),
        },
        Fault {
            id: "diffuse-from-behind",
            name: "a light behind the surface lights it: the amount of n . l is taken",
            why: "Below 0 the surface faces away from the light: max(0, n . l), not |n . l|.",
            answer: |s| term(s.material.diffuse * s.material.color * s.n.dot(s.l).abs() * s.light),
        },
        Fault {
            id: "diffuse-light-white",
            name: "the colour of the light is left out",
            why: "A green lamp lights a red wall with nothing at all: both colours are multiplied.",
            answer: |s| term(s.material.diffuse * s.material.color * s.n.dot(s.l).max(0.0)),
        },
        Fault {
            id: "diffuse-surface-white",
            name: "the colour of the surface is left out",
            why: "material.color says what share of red, green and blue the surface sends back.",
            answer: |s| term(s.material.diffuse * s.n.dot(s.l).max(0.0) * s.light),
        },
        Fault {
            id: "diffuse-weight-forgotten",
            name: "the weight k_d is left out",
            why: "material.diffuse is the share of the light that is scattered.",
            answer: |s| term(s.material.color * s.n.dot(s.l).max(0.0) * s.light),
        },
        Fault {
            id: "diffuse-cosine-forgotten",
            name: "the cosine n . l is left out",
            why: "Light that falls in at a slant is spread over more surface: the term is largest where l is along n.",
            answer: |s| {
                let is_faced = s.n.dot(s.l) > 0.0;
                term(if is_faced { s.material.diffuse * s.material.color * s.light } else { Rgb::ZERO })
            },
        },
    ];
    Task {
        name: "colour: the diffuse term",
        function: "diffuse",
        points: 2,
        after: &[],
        cases: lit_cases(702),
        given: of_lit,
        truth: |s| term(right(s)),
        faults: FAULTS,
        picture: |s, what, _| pictures::at_surface(s.n, None, &[("l", s.l)], "none", what),
        hints: &[
            "Colours are vectors of three numbers; a * b multiplies them red by red, green by green, blue by blue.",
            "material.diffuse * material.color * n.dot(l).max(0.0) * light",
        ],
    }
}

fn specular() -> Task<Lit> {
    fn with(s: &Lit, cosine: f64) -> Answer {
        term(s.material.specular * cosine.max(0.0).powf(s.material.shininess) * s.light)
    }
    fn mirrored(s: &Lit) -> DVec3 {
        2.0 * s.n.dot(s.l) * s.n - s.l
    }
    const FAULTS: &[Fault<Lit>] = &[
        Fault {
            id: "specular-away",
            name: "the direction of the ray is taken for v, the way back to the eye",
            why: "r . v wants both to point away from the surface: v = -d.",
            answer: |s| with(s, mirrored(s).dot(s.d)),
        },
        Fault {
            id: "specular-light-not-mirrored",
            name: "l . v is taken, not r . v: the light is not mirrored",
            why: "A highlight is a blurred mirror image of the light: r is l mirrored at the normal, 2 (n . l) n - l.",
            answer: |s| with(s, s.l.dot(-s.d)),
        },
        Fault {
            id: "specular-mirror-without-2",
            name: "the 2 of the mirrored direction is missing",
            why: "(n . l) n is the part of l along the normal. Twice that, less l, is on the other side of n.",
            answer: |s| with(s, (s.n.dot(s.l) * s.n - s.l).dot(-s.d)),
        },
        Fault {
            id: "specular-exponent-forgotten",
            name: "the exponent is missing",
            why: "The larger the shininess, the smaller the highlight: r . v is raised to that power.",
            answer: |s| term(s.material.specular * mirrored(s).dot(-s.d).max(0.0) * s.light),
        },
        Fault {
            id: "specular-exponent-as-factor",
            name: "the shininess is multiplied, not raised to",
            why: "x.powf(s) is x to the power of s.",
            answer: |s| {
                let cosine = mirrored(s).dot(-s.d).max(0.0);
                term(s.material.specular * cosine * s.material.shininess * s.light)
            },
        },
        Fault {
            id: "specular-tinted",
            name: "the highlight is multiplied by the colour of the surface",
            why: "A highlight is light that bounces off the surface of the varnish: it keeps the colour of the light.",
            answer: |s| {
                let cosine = mirrored(s).dot(-s.d).max(0.0);
                term(s.material.specular * s.material.color * cosine.powf(s.material.shininess) * s.light)
            },
        },
        Fault {
            id: "specular-light-white",
            name: "the colour of the light is left out",
            why: "Both terms are multiplied by the colour of the light.",
            answer: |s| with(&Lit { light: Rgb::ONE, ..*s }, mirrored(s).dot(-s.d)),
        },
        Fault {
            id: "specular-negative",
            name: "a negative r . v is not cut off",
            why: "Raised to an even power it becomes positive, and shines on the wrong side: max(0, r . v) first.",
            answer: |s| {
                let cosine = mirrored(s).dot(-s.d);
                term(s.material.specular * cosine.powf(s.material.shininess) * s.light)
            },
        },
    ];
    Task {
        name: "colour: the highlight",
        function: "specular",
        points: 2,
        after: &[],
        cases: lit_cases(703),
        given: of_lit,
        truth: |s| with(s, mirrored(s).dot(-s.d)),
        faults: FAULTS,
        picture: |s, what, _| {
            let leaves = [("l", s.l), ("r", mirrored(s)), ("v", -s.d)];
            pictures::at_surface(s.n, None, &leaves, "none", what)
        },
        hints: &[
            "r is l mirrored at the normal: twice the part of l along n, less l. v is the way back to the eye.",
            "let r = 2.0 * n.dot(l) * n - l; let v = -d; and x.max(0.0).powf(s) is a power.",
            "material.specular * r.dot(v).max(0.0).powf(material.shininess) * light",
        ],
    }
}

fn direct_light() -> Task<Pixel> {
    /// What `lit` makes of a light that is asked for if `asked` says so.
    fn with(
        program: &Program,
        (ray, hit, light): (&Ray, &Hit, &Light),
        asks: fn(cosine: f64, is_lit: &dyn Fn() -> bool) -> bool,
        keep: fn(DirectLight) -> DirectLight,
    ) -> DirectLight {
        let (n, l) = (hit.normal, right_way(hit.point, light));
        if !asks(n.dot(l), &|| program.is_lit(hit, light)) {
            return DirectLight::default();
        }
        let Material { color, diffuse, specular, shininess, .. } = hit.material;
        let cosine = (2.0 * n.dot(l) * n - l).dot(-ray.direction.normalize()).max(0.0);
        keep(DirectLight {
            diffuse: diffuse * color * n.dot(l).max(0.0) * light.color,
            specular: specular * cosine.powf(shininess) * light.color,
        })
    }
    const FAULTS: &[Fault<Pixel>] = &[
        Fault::classic(ClassicFault::NoShadowRays, |pixel| pixel.with_fault(ClassicFault::NoShadowRays)),
        Fault {
            id: "direct-facing-unasked",
            name: "a ray is sent to a light that the surface faces away from",
            why: "Where n . l < 0 the answer is 0 whatever is in the way. Ask for that first: it saves a ray.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    direct_light: |program, ray, hit, light| {
                        with(program, (ray, hit, light), |cosine, is_lit| is_lit() && cosine >= 0.0, |both| both)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "direct-lit-turned-round",
            name: "the answer of is_lit is turned round",
            why: "The terms are 0 where the light does not reach the surface: !program.is_lit(hit, light).",
            answer: |pixel| {
                pixel.answer(Procedures {
                    direct_light: |program, ray, hit, light| {
                        with(program, (ray, hit, light), |cosine, is_lit| cosine >= 0.0 && !is_lit(), |both| both)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "direct-without-highlight",
            name: "the highlight is left out",
            why: "DirectLight has two terms: diffuse and specular.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    direct_light: |program, ray, hit, light| {
                        let keep = |both| DirectLight { specular: Rgb::ZERO, ..both };
                        with(program, (ray, hit, light), |cosine, is_lit| cosine >= 0.0 && is_lit(), keep)
                    },
                    ..GIVEN
                })
            },
        },
        Fault {
            id: "direct-terms-exchanged",
            name: "the two terms are exchanged",
            why: "DirectLight { diffuse: ..., specular: ... } wants each by its name.",
            answer: |pixel| {
                pixel.answer(Procedures {
                    direct_light: |program, ray, hit, light| {
                        let keep = |both: DirectLight| DirectLight { diffuse: both.specular, specular: both.diffuse };
                        with(program, (ray, hit, light), |cosine, is_lit| cosine >= 0.0 && is_lit(), keep)
                    },
                    ..GIVEN
                })
            },
        },
        Fault::classic(ClassicFault::LightColorIgnored, |pixel| pixel.with_fault(ClassicFault::LightColorIgnored)),
    ];
    let mut cases = lights();
    cases.extend(sphere());
    Task {
        name: "colour: direct light",
        function: "direct_light",
        points: 2,
        after: &["to_light", "diffuse", "specular"],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: FAULTS,
        picture: pictures::renders,
        hints: &[
            "let l = to_light(hit.point, light); and the normal is hit.normal. If n . l < 0, or not program.is_lit(hit, light), \
             both terms are Rgb::ZERO.",
            "DirectLight { diffuse: diffuse(&hit.material, ...), specular: specular(&hit.material, ...) }; d is ray.direction, \
             and the colour of the light is light.color.",
        ],
    }
}

fn program() -> Task<Pixel> {
    let mut cases = mirror();
    cases.extend(lights());
    // Highlights on colours, and recursion up to maxLevel.
    cases.extend(sphere());
    cases.extend(mirrors());
    Task {
        name: "colour: the whole tree",
        function: "the program",
        points: 1,
        after: &["intersect", "trace", "direct_light"],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: &[],
        picture: pictures::renders,
        hints: &[
            "All your functions run together here. Look at the first that is wrong above; this one follows from it.",
        ],
    }
}
