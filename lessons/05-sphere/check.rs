//! Lesson 05, the sphere: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::kernels::{Start, intersect_sphere_certified};
use raytree::lessons::{Answer, Case, Fault, Lesson, Random, Ray, Span, Sphere, Task, pictures, random_cases, shown};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) coefficients: fn(&Ray, &Sphere) -> [f64; 3],
    pub(crate) roots: fn(f64, f64, f64) -> Option<Span>,
    pub(crate) intersect: fn(&Ray, &Sphere) -> Option<f64>,
    pub(crate) normal: fn(&Ray, &Sphere, f64) -> DVec3,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    Lesson {
        number: 5,
        title: "sphere",
        stages: vec![
            coefficients().stage(move |(ray, sphere)| of_coefficients((student.coefficients)(ray, sphere))),
            roots().stage(move |case| span((student.roots)(case.a, case.b, case.c))),
            intersect().stage(move |(ray, sphere)| hit((student.intersect)(ray, sphere))),
            normal().stage(move |(ray, sphere, t)| Answer::of("n", (student.normal)(ray, sphere, *t))),
        ],
        notice: "Now see both roots of a real ray: raytree diagram scenes/sphere.json highlight --kind sphere -o sphere.png",
    }
}

type RayAndSphere = (Ray, Sphere);

fn of_coefficients([a, b, c]: [f64; 3]) -> Answer {
    Answer::of("a", a).and("b", b).and("c", c)
}

fn span(span: Option<Span>) -> Answer {
    Answer::maybe(span, "no roots", |Span { t_in, t_out }| Answer::of("t_in", t_in).and("t_out", t_out))
}

fn hit(t: Option<f64>) -> Answer {
    Answer::maybe(t, "no hit", |t| Answer::of("t", t))
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn of_ray_and_sphere(ray: &Ray, sphere: &Sphere) -> Vec<String> {
    vec![
        named("o", ray.origin),
        named("d", ray.direction),
        format!("{}, radius = {}", named("center", sphere.center), shown(sphere.radius)),
    ]
}

fn vector(random: &mut Random) -> DVec3 {
    random.vector(|random| random.below(17) as f64 / 2.0 - 4.0)
}

fn ball(radius: f64) -> Sphere {
    Sphere { center: dvec3(0.0, 0.0, 0.0), radius }
}

fn ray(origin: DVec3, direction: DVec3) -> Ray {
    Ray { origin, direction }
}

fn coefficients_of(ray: &Ray, sphere: &Sphere) -> [f64; 3] {
    let (f, d) = (ray.origin - sphere.center, ray.direction);
    [d.dot(d), 2.0 * f.dot(d), f.dot(f) - sphere.radius * sphere.radius]
}

fn coefficients() -> Task<RayAndSphere> {
    const FAULTS: &[Fault<RayAndSphere>] = &[
        Fault {
            id: "sphere-b-without-2",
            name: "b is not doubled",
            why: "(f + t d)^2 = f.f + 2 t (f.d) + t^2 (d.d): the 2 belongs to b. (Some books leave it out, and \
                  take another formula for the roots.)",
            answer: |(ray, sphere)| {
                let [a, b, c] = coefficients_of(ray, sphere);
                of_coefficients([a, b / 2.0, c])
            },
        },
        Fault {
            id: "sphere-b-sign",
            name: "b has the wrong sign",
            why: "f goes from the centre to the origin of the ray: o - c. The other way round b changes its \
                  sign, a and c do not.",
            answer: |(ray, sphere)| {
                let [a, b, c] = coefficients_of(ray, sphere);
                of_coefficients([a, -b, c])
            },
        },
        Fault {
            id: "sphere-center-forgotten",
            name: "the centre is missing: this is a sphere around the origin",
            why: "What counts is where the ray starts as seen from the centre: f = o - c.",
            answer: |(ray, sphere)| of_coefficients(coefficients_of(ray, &Sphere { center: DVec3::ZERO, ..*sphere })),
        },
        Fault {
            id: "sphere-radius-not-squared",
            name: "the radius is not squared",
            why: "|p - c|^2 = r^2: both sides are squares of lengths.",
            answer: |(ray, sphere)| {
                let [a, b, c] = coefficients_of(ray, sphere);
                of_coefficients([a, b, c + sphere.radius * sphere.radius - sphere.radius])
            },
        },
        Fault {
            id: "sphere-radius-forgotten",
            name: "the radius is missing",
            why: "c = f.f - r^2: below 0 where the ray starts inside.",
            answer: |(ray, sphere)| of_coefficients(coefficients_of(ray, &Sphere { radius: 0.0, ..*sphere })),
        },
        Fault {
            id: "sphere-direction-unit",
            name: "the direction is taken for a unit vector: a is always 1",
            why: "a = d . d is the square of its length, which need not be 1.",
            answer: |(ray, sphere)| {
                let [_, b, c] = coefficients_of(ray, sphere);
                of_coefficients([1.0, b, c])
            },
        },
        Fault {
            id: "sphere-a-as-length",
            name: "a is the length of d, not its square",
            why: "a = d . d.",
            answer: |(ray, sphere)| {
                let [a, b, c] = coefficients_of(ray, sphere);
                of_coefficients([a.sqrt(), b, c])
            },
        },
    ];
    let mut cases = vec![
        Case::new("a sphere around the origin", (ray(dvec3(-5.0, 0.0, 0.0), dvec3(2.0, 0.0, 0.0)), ball(1.0))),
        Case::new(
            "a sphere elsewhere",
            (ray(dvec3(1.0, 2.0, 0.0), dvec3(0.0, 1.0, 1.0)), Sphere { center: dvec3(1.0, 5.0, 1.0), radius: 2.0 }),
        ),
        Case::new("the ray starts inside", (ray(dvec3(1.0, 0.0, 0.0), dvec3(0.0, 3.0, 0.0)), ball(2.0))),
    ];
    cases.extend(random_cases(501, 40, |random| {
        let case = (
            ray(vector(random), vector(random)),
            Sphere { center: vector(random), radius: 0.5 + random.below(6) as f64 / 2.0 },
        );
        (case.0.direction != DVec3::ZERO).then_some(case)
    }));
    Task {
        name: "the quadratic",
        function: "coefficients",
        points: 3,
        after: &[],
        cases,
        given: |(ray, sphere)| of_ray_and_sphere(ray, sphere),
        truth: |(ray, sphere)| of_coefficients(coefficients_of(ray, sphere)),
        faults: FAULTS,
        picture: |(ray, sphere), what, _| pictures::parabola(coefficients_of(ray, sphere), what),
        hints: &[
            "A point p lies on the sphere when |p - c|^2 = r^2. Put p = o + t d into it, and write f for o - c.",
            "(f + t d) . (f + t d) = r^2. Multiply out: what stands with t^2, what with t, what alone?",
            "a = d . d, b = 2 f . d, c = f . f - r^2",
        ],
    }
}

/// A quadratic with the roots that it was made of.
#[derive(Clone, Copy, Debug)]
struct Quadratic {
    a: f64,
    b: f64,
    c: f64,
    planted: Option<[f64; 2]>,
}

/// `a (t - first) (t - second)`.
fn planted(a: f64, first: f64, second: f64) -> Quadratic {
    Quadratic {
        a,
        b: -a * (first + second),
        c: a * first * second,
        planted: Some([first.min(second), first.max(second)]),
    }
}

/// `a (t - middle)^2 + above`, which is never 0.
fn rootless(a: f64, middle: f64, above: f64) -> Quadratic {
    Quadratic { a, b: -2.0 * a * middle, c: a * middle * middle + above, planted: None }
}

fn roots() -> Task<Quadratic> {
    fn of(t_in: f64, t_out: f64) -> Answer {
        span(Some(Span { t_in, t_out }))
    }
    fn disc(q: &Quadratic) -> f64 {
        q.b * q.b - 4.0 * q.a * q.c
    }
    /// Both roots made of the root of the discriminant, where that is not negative.
    fn with(q: &Quadratic, make: impl Fn(f64) -> [f64; 2]) -> Answer {
        if disc(q) < 0.0 {
            return span(None);
        }
        let [t_in, t_out] = make(disc(q).sqrt());
        of(t_in, t_out)
    }
    const FAULTS: &[Fault<Quadratic>] = &[
        Fault {
            id: "quadratic-times-a",
            name: "/ 2.0 * a divides by 2 and then multiplies by a",
            why: "Programs go from left to right: x / 2.0 * a is (x / 2.0) * a. Brackets are needed: x / (2.0 * a).",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| (-q.b + side * root) / 2.0 * q.a)),
        },
        Fault {
            id: "quadratic-first-times-a",
            name: "/ 2.0 * a in t_in divides by 2 and then multiplies by a; t_out has the brackets",
            why: "Programs go from left to right: x / 2.0 * a is (x / 2.0) * a. Both roots need x / (2.0 * a).",
            answer: |q| with(q, |root| [(-q.b - root) / 2.0 * q.a, (-q.b + root) / (2.0 * q.a)]),
        },
        Fault {
            id: "quadratic-second-times-a",
            name: "/ 2.0 * a in t_out divides by 2 and then multiplies by a; t_in has the brackets",
            why: "Programs go from left to right: x / 2.0 * a is (x / 2.0) * a. Both roots need x / (2.0 * a).",
            answer: |q| with(q, |root| [(-q.b - root) / (2.0 * q.a), (-q.b + root) / 2.0 * q.a]),
        },
        Fault {
            id: "quadratic-no-brackets",
            name: "-b + root / 2.0 * a divides only the root, by 2, and multiplies it by a",
            why: "Two pairs of brackets are needed: (-b + root) / (2.0 * a).",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| -q.b + side * root / 2.0 * q.a)),
        },
        Fault {
            id: "quadratic-b-sign",
            name: "it is +b where it has to be -b",
            why: "The middle of both roots is -b / (2 a).",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| (q.b + side * root) / (2.0 * q.a))),
        },
        Fault {
            id: "quadratic-only-root-divided",
            name: "-b is not divided by 2 a, only the root is",
            why: "Brackets are needed around the whole of -b + root before it is divided.",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| -q.b + side * root / (2.0 * q.a))),
        },
        Fault {
            id: "quadratic-no-root",
            name: "the square root of the discriminant is missing",
            why: "t = (-b +- sqrt(b^2 - 4 a c)) / (2 a).",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| (-q.b + side * root * root) / (2.0 * q.a))),
        },
        Fault {
            id: "quadratic-order",
            name: "the roots come in the wrong order",
            why: "For a > 0 the one with the minus before the square root is the smaller.",
            answer: |q| with(q, |root| [1.0, -1.0].map(|side| (-q.b + side * root) / (2.0 * q.a))),
        },
        Fault {
            id: "quadratic-a-forgotten",
            name: "it is divided by 2, not by 2 a",
            why: "That is right for a = 1 only: for rays whose direction has length 1.",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| (-q.b + side * root) / 2.0)),
        },
        Fault {
            id: "quadratic-double-root",
            name: "a double root is turned down",
            why: "discriminant = 0 means that the ray touches the sphere in one point. Only below 0 there is none.",
            answer: |q| {
                if disc(q) <= 0.0 {
                    span(None)
                } else {
                    with(q, |root| [-1.0, 1.0].map(|s| (-q.b + s * root) / (2.0 * q.a)))
                }
            },
        },
        Fault {
            id: "quadratic-unchecked",
            name: "a negative discriminant is not turned down",
            why: "The square root of a negative number is NaN, not a number, and so is everything made of it.",
            answer: |q| {
                let root = disc(q).sqrt();
                of((-q.b - root) / (2.0 * q.a), (-q.b + root) / (2.0 * q.a))
            },
        },
        Fault {
            id: "quadratic-without-4",
            name: "the discriminant is b^2 - a c: the 4 is missing",
            why: "b^2 - a c goes with the other formula, where b is not doubled and nothing is divided by 2.",
            answer: |q| {
                let disc = q.b * q.b - q.a * q.c;
                if disc < 0.0 {
                    span(None)
                } else {
                    of((-q.b - disc.sqrt()) / (2.0 * q.a), (-q.b + disc.sqrt()) / (2.0 * q.a))
                }
            },
        },
        Fault {
            id: "quadratic-plus",
            name: "the discriminant is b^2 + 4 a c: the sign is wrong",
            why: "b^2 - 4 a c.",
            answer: |q| {
                let disc = q.b * q.b + 4.0 * q.a * q.c;
                if disc < 0.0 {
                    span(None)
                } else {
                    of((-q.b - disc.sqrt()) / (2.0 * q.a), (-q.b + disc.sqrt()) / (2.0 * q.a))
                }
            },
        },
    ];
    let mut cases = vec![
        Case::new("roots 2 and 3, a = 4", planted(4.0, 2.0, 3.0)),
        Case::new("a = 1", planted(1.0, 1.0, 4.0)),
        Case::new("one root on each side of 0", planted(2.0, -1.0, 3.0)),
        Case::new("a double root", planted(1.0, 2.0, 2.0)),
        Case::new("no root", rootless(1.0, 1.0, 4.0)),
    ];
    cases.extend(random_cases(502, 40, |random| {
        let a = [0.25, 0.5, 1.0, 2.0, 4.0, 5.0][random.below(6)];
        let t = |random: &mut Random| random.below(33) as f64 / 4.0 - 4.0;
        let (first, second) = (t(random), t(random));
        Some(match random.one_in(4) {
            true => rootless(a, first, 0.5 + random.below(8) as f64 / 2.0),
            // A random double root may be lost to rounding.
            false => planted(a, first, if first == second { second + 1.0 } else { second }),
        })
    }));
    Task {
        name: "its roots",
        function: "roots",
        points: 3,
        after: &[],
        cases,
        given: |q| vec![format!("a = {}, b = {}, c = {}", shown(q.a), shown(q.b), shown(q.c))],
        truth: |q| span(q.planted.map(|[t_in, t_out]| Span { t_in, t_out })),
        faults: FAULTS,
        picture: |q, what, _| pictures::parabola([q.a, q.b, q.c], what),
        hints: &[
            "Begin with the discriminant b * b - 4.0 * a * c. What does it mean if it is negative?",
            "t = (-b - root) / (2.0 * a) and (-b + root) / (2.0 * a) with root = discriminant.sqrt(). Mind the \
             brackets.",
        ],
    }
}

fn true_span((ray, sphere): &RayAndSphere) -> Option<Span> {
    let certified = intersect_sphere_certified(ray, sphere, Start::Anywhere).ok()?;
    Some(Span { t_in: certified.hit.t_in, t_out: certified.hit.t_out })
}

fn intersect() -> Task<RayAndSphere> {
    /// Both roots of the line, wherever they lie.
    fn line((ray, sphere): &RayAndSphere) -> Option<Span> {
        let [a, b, c] = coefficients_of(ray, sphere);
        let disc = b * b - 4.0 * a * c;
        (disc >= 0.0).then(|| Span { t_in: (-b - disc.sqrt()) / (2.0 * a), t_out: (-b + disc.sqrt()) / (2.0 * a) })
    }
    const FAULTS: &[Fault<RayAndSphere>] = &[
        Fault {
            id: "sphere-negative-t",
            name: "a negative t is taken for a hit",
            why: "t < 0 lies behind the origin. If t_in is negative, t_out may still count; if that is negative \
                  too, nothing does.",
            answer: |case| hit(line(case).map(|span| span.t_in)),
        },
        Fault {
            id: "sphere-behind",
            name: "a sphere behind the origin is hit",
            why: "If both roots are negative the whole sphere lies behind.",
            answer: |case| hit(line(case).map(|span| if span.t_in >= 0.0 { span.t_in } else { span.t_out })),
        },
        Fault {
            id: "sphere-entry-inside",
            name: "the entry is taken where the ray starts inside",
            why: "Inside, t_in is negative and t_out is not: the first hit is the way out.",
            answer: |case| hit(line(case).filter(|span| span.t_out >= 0.0).map(|span| span.t_in)),
        },
        Fault {
            id: "sphere-inside-none",
            name: "a ray that starts inside hits nothing",
            why: "It hits the sphere from within, at t_out.",
            answer: |case| hit(line(case).map(|span| span.t_in).filter(|t| *t >= 0.0)),
        },
        Fault {
            id: "sphere-far-root",
            name: "the far root is taken where the near one counts",
            why: "From outside the ray comes in first: the smaller root that is not negative.",
            answer: |case| hit(line(case).map(|span| span.t_out).filter(|t| *t >= 0.0)),
        },
        Fault {
            id: "sphere-nearest-root",
            name: "the root nearest to 0 is taken, whatever its sign",
            why: "Of the two roots the smaller one that is not negative counts.",
            answer: |case| {
                let near = |span: Span| if span.t_in.abs() < span.t_out.abs() { span.t_in } else { span.t_out };
                hit(line(case).map(near))
            },
        },
    ];
    Task {
        name: "the root that counts",
        function: "intersect",
        points: 2,
        after: &["coefficients", "roots"],
        cases: spheres(503),
        given: |(ray, sphere)| of_ray_and_sphere(ray, sphere),
        truth: |case| {
            let certified = intersect_sphere_certified(&case.0, &case.1, Start::Anywhere).ok();
            hit(certified.map(|certified| certified.t))
        },
        faults: FAULTS,
        picture: |(ray, sphere), what, _| pictures::sphere_hit(ray, sphere, what),
        hints: &[
            "The ray is only the part of the line with t >= 0. Three cases: both roots negative, one, none.",
            "If t_in >= 0 it is t_in. If not, but t_out >= 0, it is t_out. If neither, None.",
        ],
    }
}

fn spheres(seed: u64) -> Vec<Case<RayAndSphere>> {
    let along = dvec3(2.0, 0.0, 0.0);
    let mut cases = vec![
        Case::new("from outside", (ray(dvec3(-5.0, 0.0, 0.0), along), ball(1.0))),
        Case::new("from inside", (ray(dvec3(0.5, 0.0, 0.0), along), ball(1.0))),
        Case::new("the sphere is behind", (ray(dvec3(5.0, 0.0, 0.0), along), ball(1.0))),
        Case::new("past it", (ray(dvec3(-5.0, 2.0, 0.0), along), ball(1.0))),
        Case::new("from inside, the way back is shorter", (ray(dvec3(-0.5, 0.0, 0.0), along), ball(1.0))),
    ];
    cases.extend(random_cases(seed, 60, |random| {
        let sphere = Sphere { center: vector(random), radius: 1.0 + random.below(6) as f64 / 2.0 };
        let origin = vector(random);
        let direction = match random.one_in(3) {
            true => vector(random),
            false => sphere.center + 0.5 * random.vector(|random| random.below(5) as f64 - 2.0) - origin,
        };
        let case = (ray(origin, if random.one_in(5) { -direction } else { direction }), sphere);
        let [a, b, c] = coefficients_of(&case.0, &case.1);
        let is_clear = a > 0.0 && c.abs() > 1e-3 && (b * b - 4.0 * a * c).abs() > 1e-3;
        is_clear.then_some(case)
    }));
    cases
}

fn normal() -> Task<(Ray, Sphere, f64)> {
    fn outward((ray, sphere, t): &(Ray, Sphere, f64)) -> DVec3 {
        (ray.at(*t) - sphere.center) / sphere.radius
    }
    const FAULTS: &[Fault<(Ray, Sphere, f64)>] = &[
        Fault {
            id: "normal-not-flipped",
            name: "the normal is not flipped where the ray comes from inside",
            why: "A ray that hits from within sees the inner side. If n . d > 0 the normal points away from the \
                  ray: turn it round.",
            answer: |case| Answer::of("n", outward(case)),
        },
        Fault {
            id: "normal-inward",
            name: "the normal points the wrong way everywhere",
            why: "It goes from the centre to the point: p - c, and is turned round only where n . d > 0.",
            answer: |case| {
                let n = outward(case);
                Answer::of("n", if n.dot(case.0.direction) > 0.0 { n } else { -n })
            },
        },
        Fault {
            id: "normal-always-inward",
            name: "the normal goes from the point to the centre",
            why: "It goes from the centre to the point: p - c.",
            answer: |case| Answer::of("n", -outward(case)),
        },
        Fault {
            id: "normal-length-of-radius",
            name: "the normal does not have length 1",
            why: "p - c is as long as the radius: divide by it.",
            answer: |case| {
                let n = outward(case) * case.1.radius;
                Answer::of("n", if n.dot(case.0.direction) > 0.0 { -n } else { n })
            },
        },
        Fault {
            id: "normal-length-of-radius-not-flipped",
            name: "the normal does not have length 1, and is not turned to the ray",
            why: "p - c is as long as the radius: divide by it. And where n . d > 0 it has to be turned round.",
            answer: |case| Answer::of("n", outward(case) * case.1.radius),
        },
        Fault {
            id: "normal-of-point",
            name: "the centre is missing",
            why: "The point alone is the way from the origin of the world. The normal is the way from the \
                  centre: p - c.",
            answer: |case| {
                let n = case.0.at(case.2).normalize_or_zero();
                Answer::of("n", if n.dot(case.0.direction) > 0.0 { -n } else { n })
            },
        },
        Fault {
            id: "normal-against-ray",
            name: "the direction of the ray is taken for the normal",
            why: "The normal depends on where the sphere is hit, not on where the ray comes from.",
            answer: |case| Answer::of("n", -case.0.direction.normalize()),
        },
    ];
    let mut cases = vec![
        Case::new("from outside", (ray(dvec3(-5.0, 0.0, 0.0), dvec3(2.0, 0.0, 0.0)), ball(2.0), 1.5)),
        Case::new(
            "a sphere elsewhere",
            (
                ray(dvec3(3.0, 9.0, 0.0), dvec3(0.0, -2.0, 0.0)),
                Sphere { center: dvec3(0.0, 1.0, 0.0), radius: 5.0 },
                2.0,
            ),
        ),
        Case::new("from inside", (ray(dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0)), ball(2.0), 2.0)),
    ];
    let hits = spheres(504).into_iter().filter_map(|case| {
        let span = true_span(&case.input)?;
        let t = if span.t_in >= 0.0 { span.t_in } else { span.t_out };
        let (ray, sphere) = case.input;
        let slant = (ray.at(t) - sphere.center).dot(ray.direction);
        (slant.abs() > 1e-3).then_some(Case { name: case.name, input: (ray, sphere, t) })
    });
    cases.extend(hits);
    Task {
        name: "the normal",
        function: "normal",
        points: 2,
        after: &[],
        cases,
        given: |(ray, sphere, t)| {
            let mut lines = of_ray_and_sphere(ray, sphere);
            lines.push(format!("t = {}", shown(*t)));
            lines
        },
        truth: |case| {
            let n = outward(case);
            Answer::of("n", if n.dot(case.0.direction) > 0.0 { -n } else { n })
        },
        faults: FAULTS,
        picture: |(ray, sphere, t), what, _| pictures::sphere_normal(ray, sphere, *t, what),
        hints: &[
            "ray.at(t) is the point. From the centre to the point the normal points outwards; how long is that \
             vector?",
            "If the normal and the direction point to the same side (n . d > 0) the ray comes from inside: \
             return -n.",
        ],
    }
}
