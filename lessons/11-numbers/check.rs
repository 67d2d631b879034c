//! Lesson 11, numbers that lie: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::kernels::{
    Miss, Plane, Start, TriangleFilter, intersect_box_certified, intersect_box_lecture, intersect_plane_certified,
    intersect_sphere_certified, intersect_triangle_certified, intersect_triangle_lecture,
    intersect_triangle_moller_trumbore,
};
use raytree::lessons::pictures::{self, Meanings, Tile};
use raytree::lessons::{
    Aabb, Answer, Case, Fault, Lesson, Random, Ray, Span, Sphere, Task, Triangle, random_cases, shown,
};
use raytree::numbers::{Expansion, Ring, determinant};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) slab: fn(f64, f64, f64, f64) -> Option<Span>,
    pub(crate) box_span: fn(&Ray, &Aabb) -> Option<Span>,
    pub(crate) roots: fn(f64, f64, f64) -> Option<Span>,
    pub(crate) meets_sphere: fn(&Ray, &Sphere) -> bool,
    pub(crate) leave: fn(&Ray, f64, DVec3, DVec3) -> DVec3,
    pub(crate) side: fn(&Ray, DVec3, DVec3) -> i32,
    pub(crate) is_hit: fn(&Ray, &Triangle) -> bool,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    Lesson {
        number: 11,
        title: "numbers that lie",
        stages: vec![
            slab().stage(move |[o, d, low, high]| within((student.slab)(*o, *d, *low, *high))),
            box_span().stage(move |(ray, aabb)| span((student.box_span)(ray, aabb))),
            roots().stage(move |case| no_roots((student.roots)(case.a, case.b, case.c))),
            meets_sphere().stage(move |(ray, sphere)| met((student.meets_sphere)(ray, sphere))),
            leave()
                .stage(move |case| case.judge((student.leave)(&case.ray, case.t, case.ground.normal, case.direction))),
            side().stage(move |(ray, p, q)| on_side((student.side)(ray, *p, *q))),
            is_hit().stage(move |(ray, triangle)| hit((student.is_hit)(ray, triangle))),
        ],
        notice: "Now see the ray that slips through a shared edge: raytree diagram scenes/hard/shared-edge.json leak \
                 --kind triangle --shape \"upper half\" --numerics lecture -o leak.png",
    }
}

fn within(span: Option<Span>) -> Answer {
    Answer::maybe(span, "never", |Span { t_in, t_out }| Answer::of("t_in", t_in).and("t_out", t_out))
}

fn span(span: Option<Span>) -> Answer {
    Answer::maybe(span, "no hit", |Span { t_in, t_out }| Answer::of("t_in", t_in).and("t_out", t_out))
}

fn no_roots(span: Option<Span>) -> Answer {
    Answer::maybe(span, "no roots", |Span { t_in, t_out }| Answer::of("t_in", t_in).and("t_out", t_out))
}

fn met(is_met: bool) -> Answer {
    Answer::of("meets", is_met)
}

fn on_side(sign: i32) -> Answer {
    Answer::of("side", f64::from(sign))
}

fn hit(is_hit: bool) -> Answer {
    Answer::of("hit", is_hit)
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn ray(origin: DVec3, direction: DVec3) -> Ray {
    Ray { origin, direction }
}

const ALWAYS: Span = Span { t_in: f64::NEG_INFINITY, t_out: f64::INFINITY };

/// Both ends of a slab, as division gives them.
fn ends([o, d, low, high]: &[f64; 4]) -> [f64; 2] {
    [(low - o) / d, (high - o) / d]
}

fn sorted([a, b]: [f64; 2]) -> Option<Span> {
    Some(Span { t_in: a.min(b), t_out: a.max(b) })
}

/// The same by comparing, which leaves NaN where it is.
fn exchanged([a, b]: [f64; 2]) -> Option<Span> {
    let [t_in, t_out] = if a > b { [b, a] } else { [a, b] };
    Some(Span { t_in, t_out })
}

fn slab() -> Task<[f64; 4]> {
    /// What a function answers that treats a direction of 0 in this way and is right else.
    fn with_zero(case: &[f64; 4], zero: impl Fn(&[f64; 4]) -> Option<Span>) -> Answer {
        within(if case[1] == 0.0 { zero(case) } else { sorted(ends(case)) })
    }
    const FAULTS: &[Fault<[f64; 4]>] = &[
        Fault {
            id: "zero-divided",
            name: "it is divided by 0: on a side of the slab 0 / 0 is NaN, and beyond it the span is no span",
            why: "Ask for direction == 0.0 before you divide. Then the coordinate never changes: it is in the slab \
                  always or never.",
            answer: |case| within(exchanged(ends(case))),
        },
        Fault {
            id: "zero-divided-min-max",
            name: "it is divided by 0: min and max drop the NaN of 0 / 0 and keep an infinity of the wrong sign",
            why: "Ask for direction == 0.0 before you divide. Then the coordinate never changes: it is in the slab \
                  always or never.",
            answer: |case| within(sorted(ends(case))),
        },
        Fault {
            id: "zero-nan-is-a-miss",
            name: "NaN is taken for a miss",
            why: "NaN says that nothing is known. The ray runs along the side of the slab, and the sides belong to it.",
            answer: |case| match exchanged(ends(case)) {
                Some(Span { t_in, t_out }) if t_in.is_nan() || t_out.is_nan() => within(None),
                span => within(span.filter(|span| span.t_in < span.t_out)),
            },
        },
        Fault {
            id: "zero-open",
            name: "the sides do not count: < where it has to be <=",
            why: "A slab is closed: low <= origin <= high.",
            answer: |case| with_zero(case, |[o, _, low, high]| (low < o && o < high).then_some(ALWAYS)),
        },
        Fault {
            id: "zero-always",
            name: "a direction of 0 is always in the slab",
            why: "The coordinate stays what it is at the origin: compare that with low and high.",
            answer: |case| with_zero(case, |_| Some(ALWAYS)),
        },
        Fault {
            id: "zero-never",
            name: "a direction of 0 is never in the slab",
            why: "The coordinate stays what it is at the origin. If that is between low and high it is so for ever.",
            answer: |case| with_zero(case, |_| None),
        },
        Fault {
            id: "zero-nearly",
            name: "a small direction is taken for 0",
            why: "Division by a small number is right. Only 0 has to be asked for: direction == 0.0 holds for -0 too.",
            answer: |case| match case[1].abs() < 1e-6 {
                true => {
                    let [o, _, low, high] = case;
                    within((low <= o && o <= high).then_some(ALWAYS))
                }
                false => within(sorted(ends(case))),
            },
        },
        Fault {
            id: "zero-unsorted",
            name: "the two t are not put in order",
            why: "A ray that goes down (direction < 0) meets the high side first.",
            answer: |case| match case {
                [o, 0.0, low, high] => within((low <= o && o <= high).then_some(ALWAYS)),
                case => within(Some(ends(case)).map(|[t_in, t_out]| Span { t_in, t_out })),
            },
        },
    ];
    let mut cases = vec![
        Case::new("along the lower side", [2.0, 0.0, 2.0, 5.0]),
        Case::new("along the upper side", [5.0, 0.0, 2.0, 5.0]),
        Case::new("level, inside", [3.0, 0.0, 2.0, 5.0]),
        Case::new("level, below", [1.0, 0.0, 2.0, 5.0]),
        Case::new("level, above", [6.0, 0.0, 2.0, 5.0]),
        Case::new("-0 along the lower side", [2.0, -0.0, 2.0, 5.0]),
        Case::new("-0, above", [6.0, -0.0, 2.0, 5.0]),
        Case::new("upwards", [0.0, 1.0, 2.0, 5.0]),
        Case::new("downwards", [6.0, -1.0, 2.0, 5.0]),
        Case::new("almost level", [1.0, 1e-9, 2.0, 5.0]),
        Case::new("a slab without thickness", [2.0, 0.0, 2.0, 2.0]),
    ];
    cases.extend(random_cases(1101, 60, |random| {
        let low = random.below(5) as f64 - 2.0;
        let high = low + random.below(3) as f64;
        let direction = [0.0, -0.0, 1.0, -1.0, 0.5, -2.0][random.below(6)];
        let origin = random.below(7) as f64 - 3.0;
        // Which of two equal ends is which does not matter.
        Some([origin, direction, low, high])
    }));
    Task {
        name: "a slab, and 0 / 0",
        function: "slab",
        points: 2,
        after: &[],
        cases,
        given: |[o, d, low, high]| {
            vec![
                format!(
                    "origin = {}, direction = {}",
                    shown(*o),
                    if d.to_bits() == (-0.0_f64).to_bits() { "-0".to_owned() } else { shown(*d) }
                ),
                format!("low = {}, high = {}", shown(*low), shown(*high)),
            ]
        },
        truth: |case| with_zero(case, |[o, _, low, high]| (low <= o && o <= high).then_some(ALWAYS)),
        faults: FAULTS,
        picture: |[o, d, low, high], what, _| pictures::slab(*o, *d, *low, *high, what),
        hints: &[
            "What does the coordinate do along the ray if direction is 0? It stays origin. So the answer is always \
             or never, and which, you can tell without a division.",
            "if direction == 0.0, compare: low <= origin && origin <= high. Always is Span { t_in: f64::NEG_INFINITY, \
             t_out: f64::INFINITY }, never is None. Everything else as in lesson 04.",
        ],
    }
}

type RayAndBox = (Ray, Aabb);

fn true_span((ray, aabb): &RayAndBox) -> Answer {
    let certified = intersect_box_certified(ray, aabb, Start::Anywhere).ok();
    span(certified.map(|certified| Span { t_in: certified.hit.t_in, t_out: certified.hit.t_out }))
}

fn box_span() -> Task<RayAndBox> {
    /// The spans of the axes as somebody has them, put together as in lesson 04.
    fn meet(case: &RayAndBox, slab: impl Fn(&[f64; 4]) -> Option<Span>) -> Answer {
        let (o, d) = (case.0.origin, case.0.direction);
        let spans = [0, 1, 2].map(|k| slab(&[o[k], d[k], case.1.min[k], case.1.max[k]]));
        let (mut t_in, mut t_out) = (f64::NEG_INFINITY, f64::INFINITY);
        for Span { t_in: a, t_out: b } in spans.into_iter().flatten() {
            (t_in, t_out) = (t_in.max(a), t_out.min(b));
        }
        span((!(t_in > t_out) && !(t_out < 0.0)).then_some(Span { t_in, t_out }))
    }
    const FAULTS: &[Fault<RayAndBox>] = &[
        Fault {
            id: "flat-lecture",
            name: "the box is that of lesson 04, which divides 0 by 0",
            why: "Take the new slab for each axis, and give up where one of them says never.",
            answer: |case| {
                let found = intersect_box_lecture(&case.0, &case.1, Start::Anywhere).ok();
                span(found.map(|found| Span { t_in: found.t_in, t_out: found.t_out }))
            },
        },
        Fault {
            id: "flat-min-max",
            name: "the box divides by 0, and min and max drop the NaN",
            why: "Take the new slab for each axis, and give up where one of them says never.",
            answer: |case| meet(case, |slab| sorted(ends(slab))),
        },
        Fault {
            id: "flat-never-ignored",
            name: "a slab that the ray is never in is left out",
            why: "The box is where the ray is in all three slabs. Never in one of them means never in the box.",
            answer: |case| {
                meet(case, |slab| match slab {
                    [o, 0.0, low, high] => (low <= o && o <= high).then_some(ALWAYS),
                    slab => sorted(ends(slab)),
                })
            },
        },
    ];
    let unit = Aabb { min: DVec3::ZERO, max: dvec3(4.0, 2.0, 2.0) };
    let case = |name: &str, origin: DVec3, direction: DVec3| Case::new(name, (ray(origin, direction), unit));
    let mut cases = vec![
        case("through the middle", dvec3(-2.0, 1.0, 1.0), dvec3(1.0, 0.0, 0.0)),
        case("in the plane of the floor", dvec3(-2.0, 0.0, 1.0), dvec3(1.0, 0.0, 0.0)),
        case("in the plane of the top", dvec3(-2.0, 2.0, 1.0), dvec3(1.0, 0.0, 0.0)),
        case("along an edge", dvec3(-2.0, 2.0, 0.0), dvec3(1.0, 0.0, -0.0)),
        case("level, but above", dvec3(-2.0, 3.0, 1.0), dvec3(1.0, 0.0, 0.0)),
        case("in the plane of a side, slanted", dvec3(-2.0, 0.0, 0.0), dvec3(1.0, 0.5, 0.0)),
        case("at a corner", dvec3(-1.0, 1.0, 1.0), dvec3(1.0, -1.0, -1.0)),
        case("from a corner, away", dvec3(4.0, 2.0, 2.0), dvec3(1.0, 0.0, 0.0)),
    ];
    // Small integers: rays along faces and edges, from corners, at sheets and at points.
    cases.extend(random_cases(1102, 120, |random| {
        let origin = random.vector(|random| random.below(5) as f64 - 2.0);
        let direction = random.vector(|random| [-1.0, -0.0, 0.0, 1.0][random.below(4)]);
        let half = [DVec3::ONE, dvec3(1.0, 1.0, 0.0)][random.below(2)];
        (direction != DVec3::ZERO).then_some((ray(origin, direction), Aabb { min: -half, max: half }))
    }));
    Task {
        name: "a box seen edge-on",
        function: "box_span",
        points: 1,
        after: &["slab"],
        cases,
        given: |(ray, aabb)| {
            vec![named("o", ray.origin), named("d", ray.direction), named("min", aabb.min), named("max", aabb.max)]
        },
        truth: true_span,
        faults: FAULTS,
        picture: |(ray, aabb), what, _| pictures::box_span(ray, aabb, what),
        hints: &[
            "As in lesson 04, but your new slab gives an Option: with a ? behind it the function ends with None as \
             soon as one slab says never.",
            "slab(ray.origin.x, ray.direction.x, aabb.min.x, aabb.max.x)?, the same for y and z; the largest t_in, \
             the smallest t_out; None if t_in > t_out or t_out < 0.0. An infinity is larger than any number: \
             nothing else has to be done.",
        ],
    }
}

/// A quadratic with its roots.
#[derive(Clone, Copy, Debug)]
struct Quadratic {
    a: f64,
    b: f64,
    c: f64,
    solved: Option<[f64; 2]>,
}

/// `a (t - first) (t - second)`; exact for numbers of few bits, which no formula gets wrong.
fn planted(a: f64, first: f64, second: f64) -> Quadratic {
    let solved = Some([first.min(second), first.max(second)]);
    Quadratic { a, b: -a * (first + second), c: a * first * second, solved }
}

/// With one root much smaller than the other, 4 a c being at most a 32nd of b^2: the smaller root is `-c / b` times a series
/// in `x = a c / b^2`, 1 + x + 2 x^2 + 5 x^3 and so on with the Catalan numbers, and the other one is what is left to `-b / a`.
fn parted(a: f64, b: f64, c: f64) -> Quadratic {
    let x = a * c / (b * b);
    let (mut sum, mut term) = (0.0, 1.0);
    for n in 0..24 {
        sum += term;
        term *= x * f64::from(4 * n + 2) / f64::from(n + 2);
    }
    let small = -c / b * sum;
    let large = -b / a - small;
    Quadratic { a, b, c, solved: Some([small.min(large), small.max(large)]) }
}

fn roots() -> Task<Quadratic> {
    fn pair(t_in: f64, t_out: f64) -> Answer {
        no_roots(Some(Span { t_in, t_out }))
    }
    /// Both solutions made of the root of the discriminant, where that is not negative.
    fn with(q: &Quadratic, make: impl Fn(f64) -> [f64; 2]) -> Answer {
        let discriminant = q.b * q.b - 4.0 * q.a * q.c;
        if discriminant < 0.0 { no_roots(None) } else { no_roots(exchanged(make(discriminant.sqrt()))) }
    }
    /// The sum that does not cancel, halved.
    fn sum(q: &Quadratic, root: f64) -> f64 {
        -(q.b + if q.b < 0.0 { -root } else { root }) / 2.0
    }
    /// c / q, where 0 / 0 is the double root 0.
    fn other(q: &Quadratic, sum: f64) -> f64 {
        if sum == 0.0 { 0.0 } else { q.c / sum }
    }
    const FAULTS: &[Fault<Quadratic>] = &[
        Fault {
            id: "stable-textbook",
            name: "the smaller root is the difference of two numbers that are nearly the same: -b and the square root",
            why: "The digits that both have in common cancel, and what is left is rounding. Take the sign before the \
                  square root with which nothing cancels, and the other root from the product: c / q.",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| (-q.b + side * root) / (2.0 * q.a))),
        },
        Fault {
            id: "stable-sum-of-roots",
            name: "the other root is taken from the sum of both, -b / a, which cancels as well",
            why: "A difference of nearly equal numbers again. The product of the roots is c / a, so the other one is \
                  c / q: no difference at all.",
            answer: |q| {
                with(q, |root| {
                    let first = sum(q, root) / q.a;
                    [first, -q.b / q.a - first]
                })
            },
        },
        Fault {
            id: "stable-without-sign",
            name: "q is -(b + root) / 2 for every b: the sign of b is not looked at",
            why: "For b < 0 that is the difference which cancels. Then it is q = -(b - root) / 2.",
            answer: |q| {
                with(q, |root| {
                    let sum = -(q.b + root) / 2.0;
                    [sum / q.a, other(q, sum)]
                })
            },
        },
        Fault {
            id: "stable-sign-exchanged",
            name: "the sign of b is taken the wrong way round: q is the difference, not the sum",
            why: "b and what is added to it must have the same sign, or they cancel: b + root for b > 0, b - root for \
                  b < 0.",
            answer: |q| {
                with(q, |root| {
                    let sum = -(q.b + if q.b < 0.0 { root } else { -root }) / 2.0;
                    [sum / q.a, other(q, sum)]
                })
            },
        },
        Fault {
            id: "stable-both-by-product",
            name: "both roots are c / q: of the larger one the digits cancel now",
            why: "q / a for the one, c / q for the other, with one and the same q.",
            answer: |q| with(q, |root| [-1.0, 1.0].map(|side| 2.0 * q.c / (-q.b + side * root))),
        },
        Fault {
            id: "stable-not-halved",
            name: "q is twice too large: the / 2 is missing",
            why: "q = -(b + sign(b) root) / 2. Then q / a is what the usual formula gives.",
            answer: |q| {
                with(q, |root| {
                    let sum = 2.0 * sum(q, root);
                    [sum / q.a, other(q, sum)]
                })
            },
        },
        Fault {
            id: "stable-sign-zero",
            name: "for b = 0 the sign is taken for 0",
            why: "Then q is 0 although there is a root. For b = 0 either sign will do, but it has to be one.",
            answer: |q| {
                with(q, |root| {
                    let sum = if q.b == 0.0 { 0.0 } else { sum(q, root) };
                    [sum / q.a, q.c / sum]
                })
            },
        },
        Fault {
            id: "stable-zero-over-zero",
            name: "c / q is 0 / 0 where both roots are 0",
            why: "b = c = 0: q is 0, and so are both roots.",
            answer: |q| {
                with(q, |root| {
                    let sum = sum(q, root);
                    [sum / q.a, q.c / sum]
                })
            },
        },
        Fault {
            id: "stable-order",
            name: "the roots come in the wrong order where b is negative",
            why: "q / a is the smaller root for b > 0 and the larger one for b < 0: compare them.",
            answer: |q| {
                let discriminant = q.b * q.b - 4.0 * q.a * q.c;
                if discriminant < 0.0 {
                    return no_roots(None);
                }
                let sum = sum(q, discriminant.sqrt());
                pair(sum / q.a, other(q, sum))
            },
        },
        Fault {
            id: "stable-unchecked",
            name: "a negative discriminant is not turned down",
            why: "The square root of a negative number is NaN, and so is everything made of it.",
            answer: |q| {
                let sum = sum(q, (q.b * q.b - 4.0 * q.a * q.c).sqrt());
                no_roots(exchanged([sum / q.a, other(q, sum)]))
            },
        },
    ];
    let mut cases = vec![
        Case::new("roots 2 and 3, a = 4", planted(4.0, 2.0, 3.0)),
        Case::new("roots near 0.3 and 10^12", parted(1.0, -1e12, 3e11)),
        Case::new("roots near -0.3 and -10^12", parted(1.0, 1e12, 3e11)),
        Case::new("roots near -0.3 and 10^12", parted(1.0, -1e12, -3e11)),
        Case::new("b = 0", planted(1.0, -2.0, 2.0)),
        Case::new("a double root at 0", Quadratic { a: 1.0, b: 0.0, c: 0.0, solved: Some([0.0; 2]) }),
        Case::new("a double root", planted(1.0, 3.0, 3.0)),
        Case::new("no root", Quadratic { a: 1.0, b: -2.0, c: 5.0, solved: None }),
    ];
    cases.extend(random_cases(1103, 60, |random| {
        let a = [0.25, 0.5, 1.0, 2.0, 4.0][random.below(5)];
        let sign = |random: &mut Random| if random.one_in(2) { -1.0 } else { 1.0 };
        let b = sign(random) * (1.0 + random.unit()) * (1u64 << (9 + random.below(38))) as f64;
        Some(parted(a, b, sign(random) * (0.5 + 2.5 * random.unit()) * b))
    }));
    Task {
        name: "a root that does not cancel",
        function: "roots",
        points: 2,
        after: &[],
        cases,
        given: |q| vec![format!("a = {}, b = {}, c = {}", shown(q.a), shown(q.b), shown(q.c))],
        truth: |q| no_roots(q.solved.map(|[t_in, t_out]| Span { t_in, t_out })),
        faults: FAULTS,
        picture: |_, what, ask| {
            let error = |large: f64| {
                let q = parted(1.0, -large, 0.3 * large);
                Some((ask(&q)?.number("t_in")? - q.solved?[0]).abs())
            };
            pictures::small_root(&error, what)
        },
        hints: &[
            "With root = discriminant.sqrt(): of -b - root and -b + root one adds two numbers of the same sign and is \
             harmless. Which one depends on the sign of b.",
            "q = -(b + root) / 2.0 for b >= 0.0, q = -(b - root) / 2.0 for b < 0.0. One root is q / a.",
            "The product of both roots is c / a, so the other one is c / q. Put them in order; and if q is 0, both \
             are 0.",
        ],
    }
}

type RayAndSphere = (Ray, Sphere);

/// Whether the line meets the sphere: that it lies behind is no reason against it.
fn truly_meets((ray, sphere): &RayAndSphere) -> bool {
    !matches!(intersect_sphere_certified(ray, sphere, Start::Anywhere), Err(Miss::NegativeDiscriminant))
}

fn meets_sphere() -> Task<RayAndSphere> {
    fn across((ray, sphere): &RayAndSphere) -> f64 {
        (ray.origin - sphere.center).cross(ray.direction).length_squared()
    }
    const FAULTS: &[Fault<RayAndSphere>] = &[
        Fault {
            id: "far-textbook",
            name: "b^2 - 4 a c is the difference of two huge numbers",
            why: "From far away b^2 and 4 a c are both about 4 times the square of the distance, and what makes the \
                  difference is smaller than the last digit of either. r^2 |d|^2 - |f x d|^2 has no large numbers \
                  to subtract.",
            answer: |(ray, sphere)| {
                let (f, d) = (ray.origin - sphere.center, ray.direction);
                let (a, b, c) = (d.dot(d), 2.0 * f.dot(d), f.dot(f) - sphere.radius * sphere.radius);
                met(b * b - 4.0 * a * c >= 0.0)
            },
        },
        Fault {
            id: "far-unit-direction",
            name: "the direction is taken for a unit vector: |d|^2 is missing beside r^2",
            why: "|f x d| is the distance of the line from the centre times the length of d.",
            answer: |case| met(case.1.radius * case.1.radius >= across(case)),
        },
        Fault {
            id: "far-radius-not-squared",
            name: "the radius is not squared",
            why: "Squares of lengths are compared: r^2 |d|^2 with |f x d|^2.",
            answer: |case| met(case.1.radius * case.0.direction.length_squared() >= across(case)),
        },
        Fault {
            id: "far-center-forgotten",
            name: "the centre is missing",
            why: "f goes from the centre to the origin of the ray: o - c.",
            answer: |(ray, sphere)| {
                let l = ray.origin.cross(ray.direction);
                met(sphere.radius * sphere.radius * ray.direction.length_squared() >= l.dot(l))
            },
        },
        Fault {
            id: "far-tangent",
            name: "a line that only touches does not count",
            why: "Where the discriminant is 0 there is one common point, and one is enough: >= 0.0.",
            answer: |case| met(case.1.radius.powi(2) * case.0.direction.length_squared() > across(case)),
        },
        Fault {
            id: "far-reversed",
            name: "hit and miss are exchanged",
            why: "The line meets the sphere where its distance from the centre is at most the radius.",
            answer: |case| met(!truly_meets(case)),
        },
    ];
    let moon = Sphere { center: DVec3::ZERO, radius: 1.0 };
    let along = dvec3(1.0, 0.0, 0.0);
    let case = |name: &str, origin: DVec3, direction: DVec3| Case::new(name, (ray(origin, direction), moon));
    let mut cases = vec![
        case("near, through it", dvec3(-5.0, 0.5, 0.0), along),
        case("near, past it", dvec3(-5.0, 1.5, 0.0), along),
        case("10^8 away, 1.25 beside the centre", dvec3(-1e8, 1.25, 0.0), along),
        case("10^8 away, 0.75 beside the centre", dvec3(-1e8, 0.75, 0.0), along),
        case("10^9 away, twice as fast, 3 beside the centre", dvec3(-1e9, 3.0, 0.0), 2.0 * along),
        case("the line touches it", dvec3(-5.0, 1.0, 0.0), along),
        case("it lies behind, but on the line", dvec3(5.0, 0.5, 0.0), along),
    ];
    cases.extend(random_cases(1104, 80, |random| {
        let center = random.vector(|random| random.below(9) as f64 - 4.0);
        let sphere = Sphere { center, radius: [0.5, 1.0, 2.0][random.below(3)] };
        if random.one_in(3) {
            let near = ray(random.small_integers(), random.small_integers());
            let beside = near.origin - center;
            let gap = beside.cross(near.direction).length() - sphere.radius * near.direction.length();
            return (near.direction != DVec3::ZERO && gap.abs() > 1e-3).then_some((near, sphere));
        }
        let (k, speed) = (random.below(3), [0.5, 1.0, 2.0][random.below(3)]);
        let way = if random.one_in(2) { DVec3::AXES[k] } else { -DVec3::AXES[k] };
        let beside = random.below(13) as f64 / 4.0 * DVec3::AXES[(k + 1 + random.below(2)) % 3];
        let distance = [1e8, 3e8, 1e9, 1e10][random.below(4)];
        let case = (ray(center + beside - distance * way, speed * way), sphere);
        (beside.length() != sphere.radius).then_some(case)
    }));
    Task {
        name: "a small sphere far away",
        function: "meets_sphere",
        points: 2,
        after: &[],
        cases,
        given: |(ray, sphere)| {
            vec![
                named("o", ray.origin),
                named("d", ray.direction),
                format!("{}, radius = {}", named("center", sphere.center), shown(sphere.radius)),
            ]
        },
        truth: |case| met(truly_meets(case)),
        faults: FAULTS,
        picture: |(seen, sphere), what, ask| {
            let way = seen.direction.normalize();
            let (right, up) = way.any_orthonormal_pair();
            let back = (seen.origin - sphere.center).dot(way);
            let tile = |u: f64, v: f64| {
                let origin = sphere.center + back * way + 2.0 * sphere.radius * (u * right + v * up);
                let case = (ray(origin, seen.direction), *sphere);
                let is_met = truly_meets(&case);
                let own = ask(&case).and_then(|answer| answer.truth("meets"));
                [if is_met { Tile::Full } else { Tile::Empty }, Tile::beside(is_met, own)]
            };
            let meanings = Meanings {
                about: "The sphere as parallel rays find it that start as far away as this one, next to each other.",
                full: "met",
                empty: "missed",
                extra: "met, wrongly",
                hole: "missed, wrongly",
            };
            pictures::map(&tile, &meanings, what)
        },
        hints: &[
            "The line meets the sphere where its distance from the centre is at most the radius. How long is f x d, \
             for f = o - c? (Lesson 01: the area of a parallelogram.)",
            "|f x d| is the distance times |d|. Square both sides of distance <= r, and no root is needed.",
            "discriminant = r^2 (d . d) - (f x d) . (f x d); it is met where that is >= 0.0.",
        ],
    }
}

/// A ray that has hit the ground, and where a new one is to go.
#[derive(Clone, Copy, Debug)]
struct Departure {
    ray: Ray,
    ground: Plane<f64>,
    t: f64,
    direction: DVec3,
    /// How far off the ground a card lies, on the side to which the new ray goes.
    gap: f64,
}

/// The gap under the card, as a share of the length that the numbers have.
const GAP: f64 = 1e-6;

impl Departure {
    /// A ray from `eye` to `target`, which the ground goes through, and a new one: nothing if there is no such hit.
    fn new(eye: DVec3, target: DVec3, normal: DVec3, direction: DVec3) -> Option<Self> {
        let normal = normal.normalize();
        let ground = Plane { normal, distance: normal.dot(target) };
        let ray = ray(eye, (target - eye).normalize());
        let t = intersect_plane_certified(&ray, &ground).ok()?.t;
        Some(Departure { ray, ground, t, direction: direction.normalize(), gap: GAP * (eye.length() + t) })
    }

    /// What becomes of the new ray if it starts here.
    fn judge(&self, origin: DVec3) -> Answer {
        let new = ray(origin, self.direction);
        if new.check().is_err() {
            return Answer::Nothing("no point");
        }
        let aside = if self.ground.normal.dot(self.direction) < 0.0 { -self.gap } else { self.gap };
        let card = Plane { distance: self.ground.distance + aside, ..self.ground };
        Answer::of("hits the surface it leaves", intersect_plane_certified(&new, &self.ground).is_ok())
            .and("sees a card close to it", intersect_plane_certified(&new, &card).is_ok())
    }

    /// The normal on the side to which the new ray goes.
    fn outward(&self) -> DVec3 {
        if self.ground.normal.dot(self.direction) < 0.0 { -self.ground.normal } else { self.ground.normal }
    }

    fn point(&self) -> DVec3 {
        self.ray.at(self.t)
    }

    /// As far as rounding may have put the point off the ground, and a little further.
    fn enough(&self) -> f64 {
        16.0 * f64::EPSILON * (self.ray.origin.length() + self.t)
    }

    fn right() -> Answer {
        Answer::of("hits the surface it leaves", false).and("sees a card close to it", true)
    }
}

/// Rays that leave the ground, most of them from points which rounding has put on its wrong side.
fn departures() -> Vec<Case<Departure>> {
    let make = |eye: DVec3, target: DVec3, normal: DVec3, direction: DVec3| {
        let case = Departure::new(eye, target, normal, direction)?;
        (case.judge(case.point()) != Departure::right()).then_some(case)
    };
    // The place is moved until rounding is against it.
    let first = |name: &str, scale: f64, make: &dyn Fn(DVec3) -> Option<Departure>| {
        random_cases(1105, 1, |random| make(scale * random.point(1.0)))
            .into_iter()
            .map(|case| Case::new(name, case.input))
            .collect::<Vec<_>>()
    };
    let (up, light) = (dvec3(0.3, 1.0, -0.2), dvec3(0.4, 1.0, 0.3));
    let eye = dvec3(1.0, 3.0, 2.0);
    let mut cases = first("to a light", 1.0, &|p| make(eye, p, up, light));
    cases.extend(first("in a scene of the size of a galaxy, in metres", 1e20, &|p| make(1e20 * eye, p, up, light)));
    cases.extend(first("in a scene a millimetre wide", 1e-3, &|p| make(1e-3 * eye, p, up, light)));
    cases.extend(first("through the surface, to its other side", 1.0, &|p| make(eye, p, up, -light)));
    cases.extend(first("skimming the surface", 1.0, &|p| make(eye, p, up, dvec3(1.0, -0.3, 0.0) + 1e-5 * up)));
    cases.extend(first("at the middle of the world, seen from far away", 1e-9, &|p| make(1e6 * eye, p, up, light)));
    cases.extend(random_cases(1106, 60, |random| {
        let scale = [1e-3, 1.0, 1e3, 1e20][random.below(4)];
        let normal = random.direction();
        let eye = 4.0 * random.direction();
        let light = random.direction();
        // Neither the eye nor the light in the plane of the ground, where no offset along the normal helps the eye.
        let is_clear = |v: DVec3| v.normalize().dot(normal).abs() > 0.1;
        let target = random.point(1.0);
        if !is_clear(eye - target) || !is_clear(light) {
            return None;
        }
        let skim = light - light.dot(normal) * (1.0 - 1e-6) * normal;
        let direction = if random.one_in(4) { skim } else { light };
        match random.one_in(4) {
            true => Departure::new(scale * eye, scale * target, normal, direction),
            false => make(scale * eye, scale * target, normal, direction),
        }
    }));
    cases
}

fn leave() -> Task<Departure> {
    const FAULTS: &[Fault<Departure>] = &[
        Fault {
            id: "leave-unmoved",
            name: "the new ray starts at the rounded point itself",
            why: "Rounding has put it a little below the surface as often as above it. From below, the ray hits the \
                  surface that it leaves: dark spots all over, shadow acne.",
            answer: |case| case.judge(case.point()),
        },
        Fault {
            id: "leave-fixed",
            name: "the distance is a fixed number, too large here and too small there",
            why: "Rounding is a share of the numbers themselves. In a small scene 10^-4 jumps over what lies close to \
                  the surface, in a large one it is lost in the last digit. Make it a share of the sizes of \
                  ray.origin and of t d.",
            answer: |case| case.judge(case.point() + 1e-4 * case.outward()),
        },
        Fault {
            id: "leave-fixed-one-side",
            name: "the distance is a fixed number, and it goes along the normal even where the new ray goes to the other side",
            why: "Two things: look at the sign of normal . direction, and make the distance a share of the sizes of \
                  ray.origin and of t d, for rounding is a share of them.",
            answer: |case| case.judge(case.point() + 1e-4 * case.ground.normal),
        },
        Fault {
            id: "leave-fixed-along-direction",
            name: "the distance is a fixed number, and the point is moved along the new ray",
            why: "Two things: a ray that skims the surface hardly leaves it that way, the normal is the shortest way off; \
                  and rounding is a share of the sizes of ray.origin and of t d, so let the distance be one.",
            answer: |case| case.judge(case.point() + 1e-4 * case.direction),
        },
        Fault {
            id: "leave-fixed-small",
            name: "the distance is a fixed number, too large for small scenes and lost in large ones",
            why: "Rounding is a share of the numbers themselves: make the distance a share of the sizes of ray.origin \
                  and of t d.",
            answer: |case| case.judge(case.point() + 1e-7 * case.outward()),
        },
        Fault {
            id: "leave-fixed-tiny",
            name: "the distance is a fixed number, and lost where the scene is large",
            why: "p + 10^-12 is p where the last digit of p is worth more than that. Make the distance a share of the \
                  sizes of ray.origin and of t d.",
            answer: |case| case.judge(case.point() + 1e-12 * case.outward()),
        },
        Fault {
            id: "leave-coarse",
            name: "the distance is a share of the right numbers, but far too large a share",
            why: "Whatever is closer to the surface is jumped over: contact shadows are lost. A few times \
                  f64::EPSILON is enough.",
            answer: |case| case.judge(case.point() + 1e-4 * (case.ray.origin.length() + case.t) * case.outward()),
        },
        Fault {
            id: "leave-one-side",
            name: "it goes along the normal even where the new ray goes to the other side",
            why: "A refracted ray, or one whose normal points away, starts in front of the surface then, and hits it. \
                  Look at the sign of normal . direction.",
            answer: |case| case.judge(case.point() + case.enough() * case.ground.normal),
        },
        Fault {
            id: "leave-wrong-side",
            name: "it goes to the wrong side of the surface",
            why: "The new ray has to start on the side to which it goes: along the normal if normal . direction > 0, \
                  else against it.",
            answer: |case| case.judge(case.point() - case.enough() * case.outward()),
        },
        Fault {
            id: "leave-along-direction",
            name: "the point is moved along the new ray",
            why: "A ray that skims the surface hardly leaves it that way. The normal is the shortest way off.",
            answer: |case| case.judge(case.point() + case.enough() * case.direction),
        },
        Fault {
            id: "leave-back-along-ray",
            name: "the point is moved back along the old ray",
            why: "That is always the side where the old ray came from. A refracted ray goes to the other one.",
            answer: |case| {
                let off = case.enough() * case.ray.direction;
                case.judge(case.point() - 16.0 * off)
            },
        },
        Fault {
            id: "leave-size-of-point",
            name: "the distance goes by the size of the point alone",
            why: "The point is o + t d. Where both are large and cancel, the point is small and its rounding is not: \
                  |o| and |t d| count.",
            answer: |case| case.judge(case.point() + 16.0 * f64::EPSILON * case.point().length() * case.outward()),
        },
    ];
    Task {
        name: "leaving a surface",
        function: "leave",
        points: 2,
        after: &[],
        cases: departures(),
        given: |case| {
            vec![
                named("o", case.ray.origin),
                named("d", case.ray.direction),
                format!("t = {}", shown(case.t)),
                named("normal", case.ground.normal),
                named("direction", case.direction),
                format!("a card at a distance of {}", shown(case.gap)),
            ]
        },
        truth: |_| Departure::right(),
        faults: FAULTS,
        picture: |case, what, ask| {
            let (right, up) = case.ground.normal.any_orthonormal_pair();
            let reach = 0.1 * (case.ray.origin.length() + case.t);
            let tile = |u: f64, v: f64| {
                let target = case.point() + reach * (u * right + v * up);
                let seen = ray(case.ray.origin, (target - case.ray.origin).normalize());
                let Ok(met) = intersect_plane_certified(&seen, &case.ground) else { return [Tile::Full; 2] };
                let near = Departure { ray: seen, t: met.t, ..*case };
                let answer = ask(&near);
                let says = |name: &str| answer.as_ref().and_then(|answer| answer.truth(name));
                let own = match (says("hits the surface it leaves"), says("sees a card close to it")) {
                    (Some(false), Some(true)) => Tile::Full,
                    (Some(true), _) => Tile::Hole,
                    _ => Tile::Extra,
                };
                [Tile::Full, own]
            };
            let meanings = Meanings {
                about: "A piece of the ground around the point, as the same eye sees it: what becomes of the new rays.",
                full: "as it should be",
                empty: "",
                extra: "jumps over the card",
                hole: "hits the surface it leaves",
            };
            pictures::map(&tile, &meanings, what)
        },
        hints: &[
            "The point is p = o + t d, rounded. A sum is rounded to its last digit, which is a share of about 10^-16, \
             f64::EPSILON, of the numbers that were added. So the error is a few times f64::EPSILON times the size of o \
             and of t d.",
            "Go along the normal, so far that p is surely off: 16.0 * f64::EPSILON * (ray.origin.length() + t * \
             ray.direction.length()) is enough here, and still tiny.",
            "Which way? To the side of the new ray: normal if normal.dot(direction) > 0.0, else -normal.",
        ],
    }
}

type RayAndLine = (Ray, DVec3, DVec3);

fn exact_side((ray, p, q): &RayAndLine) -> i32 {
    let to = |v: &DVec3| [0, 1, 2].map(|k| Expansion::difference(v[k], ray.origin[k]));
    determinant(&ray.direction.to_array().map(Expansion::number), &to(p), &to(q)).sign()
}

fn sign(x: f64) -> i32 {
    i32::from(x > 0.0) - i32::from(x < 0.0)
}

/// A ray from anywhere at a point of the line from `p` to `q`, as near as rounding lets it.
fn aimed(random: &mut Random, p: DVec3, q: DVec3) -> Ray {
    let target = p + (q - p) * random.unit();
    let origin = target + 4.0 * random.direction();
    ray(origin, target - origin)
}

fn side() -> Task<RayAndLine> {
    const FAULTS: &[Fault<RayAndLine>] = &[
        Fault {
            id: "side-rounded",
            name: "the determinant is rounded: next to the line its sign is that of the rounding errors",
            why: "A ray that is aimed at the line has a determinant near 0, where every digit counts. Work with \
                  Expansion, which rounds nothing.",
            answer: |(ray, p, q)| on_side(sign(ray.direction.dot((p - ray.origin).cross(q - ray.origin)))),
        },
        Fault {
            id: "side-rounded-otherwise",
            name: "the determinant is rounded: close to the line its sign is that of the rounding errors",
            why: "A ray that is aimed at the line has a determinant near 0, where every digit counts. Work with \
                  Expansion, which rounds nothing.",
            answer: |(ray, p, q)| on_side(sign(ray.direction.cross(p - ray.origin).dot(q - ray.origin))),
        },
        Fault {
            id: "side-difference-rounded",
            name: "p - o is rounded before the exact part begins",
            why: "An exact determinant of rounded numbers is not exact. Expansion::difference(p.x, ray.origin.x) \
                  keeps all digits.",
            answer: |(ray, p, q)| {
                let row = |v: DVec3| v.to_array().map(Expansion::number);
                on_side(determinant(&row(ray.direction), &row(p - ray.origin), &row(q - ray.origin)).sign())
            },
        },
        Fault {
            id: "side-exchanged",
            name: "the sides are exchanged: two rows stand in the wrong order",
            why: "The rows are d, p - o, q - o. Exchanging two of them turns the sign round.",
            answer: |case| on_side(-exact_side(case)),
        },
        Fault {
            id: "side-without-zero",
            name: "0 is taken for one of the sides",
            why: "A ray that meets the line passes it on neither side: the sign is 0.",
            answer: |case| on_side(if exact_side(case) < 0 { -1 } else { 1 }),
        },
        Fault {
            id: "side-tolerance",
            name: "what is nearly 0 is taken for 0",
            why: "Then a ray beside the line counts as one that meets it, and two triangles overlap. With exact \
                  numbers there is no need for a tolerance.",
            answer: |case| {
                let (ray, p, q) = case;
                let rough = ray.direction.dot((p - ray.origin).cross(q - ray.origin));
                on_side(if rough.abs() < 1e-9 { 0 } else { exact_side(case) })
            },
        },
    ];
    let down = dvec3(0.0, 0.0, -1.0);
    let (p, q) = (dvec3(0.0, 0.0, 0.0), dvec3(4.0, 0.0, 0.0));
    let case = |name: &str, x: f64, y: f64| Case::new(name, (ray(dvec3(x, y, 3.0), down), p, q));
    let mut cases = vec![
        case("clearly beside it", 1.0, 2.0),
        case("clearly beside it, on the other side", 1.0, -2.0),
        case("it meets the line", 1.0, 0.0),
        case("beside it by next to nothing", 1.0, 1e-30),
    ];
    cases.extend(random_cases(1107, 80, |random| {
        let (p, q) = (random.point(4.0), random.point(4.0));
        Some((aimed(random, p, q), p, q))
    }));
    Task {
        name: "the side of an edge",
        function: "side",
        points: 2,
        after: &[],
        cases,
        given: |(ray, p, q)| vec![named("o", ray.origin), named("d", ray.direction), named("p", *p), named("q", *q)],
        truth: |case| on_side(exact_side(case)),
        faults: FAULTS,
        picture: |case, what, ask| {
            let tile = |u: f64, v: f64| {
                let near = (moved(&case.0, u, v), case.1, case.2);
                let right = exact_side(&near);
                let own = ask(&near).and_then(|answer| answer.number("side"));
                let of = |sign: f64| if sign > 0.0 { Tile::Full } else { Tile::Empty };
                let yours = match own {
                    Some(own) if own == f64::from(right) => of(own),
                    Some(own) if own > f64::from(right) => Tile::Extra,
                    _ => Tile::Hole,
                };
                [of(f64::from(right)), yours]
            };
            let meanings = Meanings {
                about: "Rays next to this one: from point to point they start one or two units in the last place further.",
                full: "side 1",
                empty: "side -1 or 0",
                extra: "yours is too large",
                hole: "yours is too small",
            };
            pictures::map(&tile, &meanings, what)
        },
        hints: &[
            "Expansion::number(x) is the exact number x, Expansion::difference(a, b) is exactly a - b. A row is an \
             array of three of them.",
            "determinant(&d, &to_p, &to_q).sign() is what is asked for, with d made of Expansion::number, to_p and \
             to_q of Expansion::difference.",
            "let to_p = [0, 1, 2].map(|k| Expansion::difference(p[k], ray.origin[k]));",
        ],
    }
}

/// A ray that starts up to 48 units in the last place further, in the two coordinates in which it moves least.
fn moved(from: &Ray, u: f64, v: f64) -> Ray {
    let d = from.direction.abs();
    let k = (0..3).max_by(|i, j| d[*i].total_cmp(&d[*j])).unwrap_or(2);
    let mut origin = from.origin;
    for (axis, share) in [((k + 1) % 3, u), ((k + 2) % 3, v)] {
        origin[axis] += (48.0 * share).round() * f64::EPSILON * origin[axis].abs().max(1.0);
    }
    ray(origin, from.direction)
}

type RayAndTriangle = (Ray, Triangle);

fn truly_hits((ray, triangle): &RayAndTriangle) -> bool {
    intersect_triangle_certified(ray, triangle, &TriangleFilter::of_triangle(ray, triangle)).is_ok()
}

fn is_hit() -> Task<RayAndTriangle> {
    fn sides((ray, triangle): &RayAndTriangle) -> [i32; 3] {
        let [v0, v1, v2] = triangle.vertices;
        [(v0, v1), (v1, v2), (v2, v0)].map(|(p, q)| exact_side(&(*ray, p, q)))
    }
    /// As in lesson 03, with a t for the plane.
    fn by_weights((ray, triangle): &RayAndTriangle, t: fn(&Ray, DVec3, DVec3) -> f64) -> bool {
        let [v0, v1, v2] = triangle.vertices;
        let n = (v1 - v0).cross(v2 - v0);
        let t = t(ray, n, v0);
        let p = ray.at(t);
        let weight = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(n) / n.dot(n);
        let (a, b) = (weight(v1, v2), weight(v2, v0));
        t >= 0.0 && a >= 0.0 && b >= 0.0 && a + b <= 1.0
    }
    const FAULTS: &[Fault<RayAndTriangle>] = &[
        Fault {
            id: "watertight-lecture",
            name: "the triangle is that of lesson 03, whose weights are rounded",
            why: "On an edge a weight is 0 but for rounding, and where both neighbours round to the negative the ray \
                  slips through between them. Ask your side for the signs.",
            answer: |(ray, triangle)| hit(intersect_triangle_lecture(ray, triangle).is_ok()),
        },
        Fault {
            id: "watertight-lesson-03",
            name: "the triangle is that of lesson 03, whose weights are rounded",
            why: "On an edge a weight is 0 but for rounding, and where both neighbours round to the negative the ray \
                  slips through between them. Ask your side for the signs.",
            answer: |case| hit(by_weights(case, |ray, n, v0| (n.dot(v0) - n.dot(ray.origin)) / n.dot(ray.direction))),
        },
        Fault {
            id: "watertight-lesson-03-difference",
            name: "the triangle is that of lesson 03, whose weights are rounded",
            why: "On an edge a weight is 0 but for rounding, and where both neighbours round to the negative the ray \
                  slips through between them. Ask your side for the signs.",
            answer: |case| hit(by_weights(case, |ray, n, v0| n.dot(v0 - ray.origin) / n.dot(ray.direction))),
        },
        Fault {
            id: "watertight-moller-trumbore",
            name: "the triangle is that of Moller and Trumbore, whose weights are rounded",
            why: "On an edge a weight is 0 but for rounding, and where both neighbours round to the negative the ray \
                  slips through between them. Ask your side for the signs.",
            answer: |(ray, triangle)| hit(intersect_triangle_moller_trumbore(ray, triangle).is_ok()),
        },
        Fault {
            id: "watertight-open",
            name: "a ray that meets an edge or a corner misses",
            why: "A side of 0 lies on the edge, and edges belong to the triangle. If neither of two neighbours wants \
                  the edge between them there is a gap.",
            answer: |case| {
                let sides = sides(case);
                hit(sides == [1; 3] || sides == [-1; 3])
            },
        },
        Fault {
            id: "watertight-one-winding",
            name: "only one side of the triangle can be hit",
            why: "Seen from behind all signs are turned round. What counts is that no two of them differ.",
            answer: |case| {
                let sides = sides(case);
                hit(sides.iter().all(|side| *side >= 0) && sides != [0; 3])
            },
        },
        Fault {
            id: "watertight-other-winding",
            name: "only the back of the triangle can be hit",
            why: "Seen from the front all signs are turned round. What counts is that no two of them differ.",
            answer: |case| {
                let sides = sides(case);
                hit(sides.iter().all(|side| *side <= 0) && sides != [0; 3])
            },
        },
        Fault {
            id: "watertight-in-plane",
            name: "a ray in the plane of the triangle hits it",
            why: "All three sides are 0 there. What is seen edge-on has no area.",
            answer: |case| {
                let sides = sides(case);
                hit(!(sides.contains(&1) && sides.contains(&-1)))
            },
        },
        Fault {
            id: "watertight-not-around",
            name: "one edge is walked the wrong way",
            why: "v0 to v1, v1 to v2, v2 to v0: the three edges go round the triangle.",
            answer: |case| {
                let [a, b, c] = sides(case);
                hit([a, b, -c].contains(&1) != [a, b, -c].contains(&-1))
            },
        },
        Fault {
            id: "watertight-two-edges",
            name: "only two edges are looked at",
            why: "Two edges make a wedge without end.",
            answer: |case| {
                let [a, b, _] = sides(case);
                hit([a, b].contains(&1) != [a, b].contains(&-1))
            },
        },
    ];
    let triangle = Triangle { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(4.0, 0.0, 1.0), dvec3(0.0, 4.0, -1.5)] };
    let case = |name: &str, origin: DVec3, direction: DVec3| Case::new(name, (ray(origin, direction), triangle));
    let down = dvec3(0.0, 0.0, -1.0);
    let mut cases = vec![
        case("inside", dvec3(1.0, 1.0, 5.0), down),
        case("outside", dvec3(3.0, 3.0, 5.0), down),
        case("from behind", dvec3(1.0, 1.0, -5.0), -down),
        case("on an edge", dvec3(2.0, 2.0, 5.0), down),
        case("at a corner", dvec3(4.0, 0.0, 5.0), down),
        case("in its plane", dvec3(-2.0, 0.0, -0.5), dvec3(4.0, 0.0, 1.0)),
        case("beyond an edge", dvec3(2.0, -1.0, 5.0), down),
    ];
    cases.extend(random_cases(1108, 120, |random| {
        if random.one_in(3) {
            // Numbers of few bits, which meet the edges of a square exactly.
            let square =
                [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.25), dvec3(1.0, 1.0, -0.125), dvec3(0.0, 1.0, -0.375)];
            let [a, b, c, d] = square.map(|corner| corner - 0.0 * corner);
            let vertices = if random.one_in(2) { [a, b, c] } else { [a, c, d] };
            let s = random.below(9) as f64 / 8.0;
            let target = [a.lerp(c, s), a.lerp(b, s), c.lerp(d, s)][random.below(3)];
            let back = dvec3(-0.25, 0.5, 2.0);
            return Some((ray(target + back, dvec3(0.375, -0.75, -3.0)), Triangle { vertices }));
        }
        let vertices = [random.point(4.0), random.point(4.0), random.point(4.0)];
        let k = random.below(3);
        let ray = aimed(random, vertices[k], vertices[(k + 1) % 3]);
        let normal = (vertices[1] - vertices[0]).cross(vertices[2] - vertices[0]).normalize_or_zero();
        let is_clear = ray.direction.normalize().dot(normal).abs() > 0.1;
        is_clear.then_some((ray, Triangle { vertices }))
    }));
    Task {
        name: "a triangle without leaks",
        function: "is_hit",
        points: 2,
        after: &["side"],
        cases,
        given: |(ray, triangle)| {
            let [v0, v1, v2] = triangle.vertices;
            vec![named("o", ray.origin), named("d", ray.direction), named("v0", v0), named("v1", v1), named("v2", v2)]
        },
        truth: |case| hit(truly_hits(case)),
        faults: FAULTS,
        picture: |case, what, ask| {
            let neighbour = (case.0, across_nearest_edge(case));
            let count = |hits: [bool; 2]| hits.into_iter().filter(|is_hit| *is_hit).count();
            let tile = |u: f64, v: f64| {
                let near = moved(&case.0, u, v);
                let both = [(near, case.1), (near, neighbour.1)];
                let right = count([truly_hits(&both[0]), truly_hits(&both[1])]);
                let own = [0, 1].map(|i| ask(&both[i]).and_then(|answer| answer.truth("hit")).unwrap_or_default());
                let own = count(own);
                let truly = if right > 0 { Tile::Full } else { Tile::Empty };
                let yours = match own {
                    own if own == right => truly,
                    own if own > right => Tile::Extra,
                    _ => Tile::Hole,
                };
                [truly, yours]
            };
            let meanings = Meanings {
                about: "This triangle and its neighbour at the nearest edge; from point to point a ray starts by units in the \
                        last place further.",
                full: "one of them is hit, or both",
                empty: "none is hit",
                extra: "more is hit than should be",
                hole: "too little is hit: a leak",
            };
            pictures::map(&tile, &meanings, what)
        },
        hints: &[
            "Walk around the triangle: side(ray, v0, v1), side(ray, v1, v2), side(ray, v2, v0). A ray through the \
             inside has all three edges on the same side.",
            "No two of the signs may differ: not a 1 and a -1 among them. A 0 goes with either.",
            "sides.contains(&1) != sides.contains(&-1): one kind of sign is there, and the other is not. That leaves \
             out 0, 0, 0, too, a ray in the plane.",
        ],
    }
}

/// The triangle at the other side of the edge that the ray passes closest to.
fn across_nearest_edge((ray, triangle): &RayAndTriangle) -> Triangle {
    let v = triangle.vertices;
    let volume = |k: usize| {
        let (p, q) = (v[k], v[(k + 1) % 3]);
        ray.direction.dot((p - ray.origin).cross(q - ray.origin)).abs()
    };
    let k = (0..3).min_by(|i, j| volume(*i).total_cmp(&volume(*j))).unwrap_or_default();
    let (p, q, r) = (v[k], v[(k + 1) % 3], v[(k + 2) % 3]);
    Triangle { vertices: [q, p, p + q - r] }
}
