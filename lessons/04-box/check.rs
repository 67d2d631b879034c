//! Lesson 04, the box: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec2, DVec3, dvec2, dvec3};
use raytree::kernels::{Start, intersect_box_certified};
use raytree::lessons::{Aabb, Answer, Case, Fault, Lesson, Random, Ray, Span, Task, pictures, random_cases, shown};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) slab: fn(f64, f64, f64, f64) -> Span,
    pub(crate) rectangle: fn(DVec2, DVec2, DVec2, DVec2) -> Option<Span>,
    pub(crate) box_span: fn(&Ray, &Aabb) -> Option<Span>,
    pub(crate) intersect: fn(&Ray, &Aabb) -> Option<f64>,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    Lesson {
        number: 4,
        title: "box",
        stages: vec![
            slab().stage(move |[o, d, low, high]| span(Some((student.slab)(*o, *d, *low, *high)))),
            rectangle().stage(move |[o, d, min, max]| span((student.rectangle)(*o, *d, *min, *max))),
            box_span().stage(move |(ray, aabb)| span((student.box_span)(ray, aabb))),
            intersect().stage(move |(ray, aabb)| hit((student.intersect)(ray, aabb))),
        ],
        notice: "Now see the three slabs of a real box: raytree diagram scenes/box.json \"top face\" --kind box -o box.png",
    }
}

type Flat = [DVec2; 4];
type RayAndBox = (Ray, Aabb);

fn span(span: Option<Span>) -> Answer {
    Answer::maybe(span, "no hit", |Span { t_in, t_out }| Answer::of("t_in", t_in).and("t_out", t_out))
}

fn hit(t: Option<f64>) -> Answer {
    Answer::maybe(t, "no hit", |t| Answer::of("t", t))
}

fn numbers(name: &str, v: &[f64]) -> String {
    format!("{name} = ({})", v.iter().map(|x| shown(*x)).collect::<Vec<_>>().join(", "))
}

fn small(random: &mut Random) -> f64 {
    random.below(17) as f64 / 2.0 - 4.0
}

/// A component of a direction: never 0.
fn step(random: &mut Random) -> f64 {
    let size = [0.25, 0.5, 1.0, 2.0][random.below(4)];
    if random.one_in(2) { -size } else { size }
}

/// t at both sides of a slab, in the order of the sides.
fn sides(origin: f64, direction: f64, low: f64, high: f64) -> [f64; 2] {
    [(low - origin) / direction, (high - origin) / direction]
}

fn sorted([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

fn slab() -> Task<[f64; 4]> {
    fn of([t_in, t_out]: [f64; 2]) -> Answer {
        span(Some(Span { t_in, t_out }))
    }
    const FAULTS: &[Fault<[f64; 4]>] = &[
        Fault {
            id: "slab-unsorted",
            name: "the two t are not put in order",
            why: "A ray that goes down (direction < 0) meets the high side first. Whichever t is smaller is t_in.",
            answer: |[o, d, low, high]| of(sides(*o, *d, *low, *high)),
        },
        Fault {
            id: "slab-swapped",
            name: "t_in and t_out are exchanged: min and max swapped",
            why: "The ray comes in at the smaller t.",
            answer: |[o, d, low, high]| {
                let [a, b] = sorted(sides(*o, *d, *low, *high));
                of([b, a])
            },
        },
        Fault {
            id: "slab-without-origin",
            name: "the origin is not taken away",
            why: "o + t d = low gives t = (low - o) / d.",
            answer: |[_, d, low, high]| of(sorted([low / d, high / d])),
        },
        Fault {
            id: "slab-multiplied",
            name: "it is multiplied by d where it has to be divided",
            why: "o + t d = low gives t = (low - o) / d: twice as fast is there in half the time.",
            answer: |[o, d, low, high]| of(sorted([(low - o) * d, (high - o) * d])),
        },
        Fault {
            id: "slab-sign",
            name: "the sign is wrong: o - low for low - o",
            why: "o + t d = low: bring o to the other side, so t = (low - o) / d.",
            answer: |[o, d, low, high]| of(sorted(sides(*o, *d, *low, *high).map(|t| -t))),
        },
    ];
    let mut cases = vec![
        Case::new("upwards", [0.0, 1.0, 2.0, 5.0]),
        Case::new("twice as fast", [0.0, 2.0, 2.0, 5.0]),
        Case::new("downwards", [6.0, -1.0, 2.0, 5.0]),
        Case::new("from inside", [3.0, 1.0, 2.0, 5.0]),
        Case::new("the slab lies behind", [7.0, 1.0, 2.0, 5.0]),
    ];
    cases.extend(random_cases(401, 40, |random| {
        let low = small(random);
        Some([small(random), step(random), low, low + 1.0 + random.below(6) as f64 / 2.0])
    }));
    Task {
        name: "one slab",
        function: "slab",
        points: 2,
        after: &[],
        cases,
        given: |[o, d, low, high]| {
            vec![
                format!("origin = {}, direction = {}", shown(*o), shown(*d)),
                format!("low = {}, high = {}", shown(*low), shown(*high)),
            ]
        },
        truth: |[o, d, low, high]| of(sorted(sides(*o, *d, *low, *high))),
        faults: FAULTS,
        picture: |[o, d, low, high], what, _| pictures::slab(*o, *d, *low, *high, what),
        hints: &[
            "When is the coordinate equal to low? Solve origin + t * direction = low for t. The same for high.",
            "The smaller of the two is t_in, the larger t_out: x.min(y) and x.max(y) are the smaller and the \
             larger of two numbers.",
        ],
    }
}

/// The spans of each axis, in order of the sides.
fn flat_sides([o, d, min, max]: &Flat) -> [[f64; 2]; 2] {
    [0, 1].map(|k| sides(o[k], d[k], min[k], max[k]))
}

fn box_sides((ray, aabb): &RayAndBox) -> [[f64; 2]; 3] {
    [0, 1, 2].map(|k| sides(ray.origin[k], ray.direction[k], aabb.min[k], aabb.max[k]))
}

fn largest(of: impl Iterator<Item = f64>) -> f64 {
    of.fold(f64::NEG_INFINITY, f64::max)
}

fn smallest(of: impl Iterator<Item = f64>) -> f64 {
    of.fold(f64::INFINITY, f64::min)
}

fn meet(spans: &[[f64; 2]]) -> [f64; 2] {
    [largest(spans.iter().map(|s| s[0])), smallest(spans.iter().map(|s| s[1]))]
}

fn ordered<const N: usize>(spans: [[f64; 2]; N]) -> [[f64; 2]; N] {
    spans.map(sorted)
}

fn kept([t_in, t_out]: [f64; 2], keep: bool) -> Answer {
    span(keep.then_some(Span { t_in, t_out }))
}

/// The mistakes that can be made with two slabs as with three: what the answer is for the spans of all axes.
mod mistaken {
    use super::*;

    pub(super) fn union(spans: &[[f64; 2]]) -> Answer {
        let [t_in, t_out] = [smallest(spans.iter().map(|s| s[0])), largest(spans.iter().map(|s| s[1]))];
        kept([t_in, t_out], t_in <= t_out && t_out >= 0.0)
    }

    pub(super) fn behind(spans: &[[f64; 2]]) -> Answer {
        let [t_in, t_out] = meet(spans);
        kept([t_in, t_out], t_in <= t_out)
    }

    pub(super) fn disjoint(spans: &[[f64; 2]]) -> Answer {
        let [t_in, t_out] = meet(spans);
        kept([t_in, t_out], t_out >= 0.0)
    }

    pub(super) fn unchecked(spans: &[[f64; 2]]) -> Answer {
        kept(meet(spans), true)
    }

    pub(super) fn inside(spans: &[[f64; 2]]) -> Answer {
        let [t_in, t_out] = meet(spans);
        kept([t_in, t_out], t_in <= t_out && t_in >= 0.0)
    }

    pub(super) fn usual(spans: &[[f64; 2]]) -> Answer {
        let [t_in, t_out] = meet(spans);
        kept([t_in, t_out], t_in <= t_out && t_out >= 0.0)
    }
}

/// The truth for a rectangle is that for a box which is so thick that the third axis never matters.
fn true_rectangle([o, d, min, max]: &Flat) -> Answer {
    let ray = Ray { origin: o.extend(0.0), direction: d.extend(0.0) };
    true_span(&(ray, Aabb { min: min.extend(-1.0), max: max.extend(1.0) }))
}

fn true_span((ray, aabb): &RayAndBox) -> Answer {
    let certified = intersect_box_certified(ray, aabb, Start::Anywhere).ok();
    span(certified.map(|certified| Span { t_in: certified.hit.t_in, t_out: certified.hit.t_out }))
}

/// Whether no rounding can turn the verdict.
fn is_clear([t_in, t_out]: [f64; 2]) -> bool {
    (t_in - t_out).abs() > 1e-3 && t_out.abs() > 1e-3 && t_in.abs() > 1e-3
}

const SWAPPED: [&str; 2] = [
    "the largest and the smallest are exchanged: t_in is the smallest t_in, t_out the largest t_out",
    "In all slabs at once the ray is only after it has come into the last, and until it leaves the first: the \
     largest t_in, the smallest t_out.",
];
const BEHIND: [&str; 2] =
    ["t_out < 0 is forgotten", "Then the whole span lies behind the origin: the ray goes the other way."];
const DISJOINT: [&str; 2] = [
    "t_in > t_out is forgotten",
    "If the ray leaves one slab before it comes into the other, it is never in both: it passes by a corner.",
];
const UNCHECKED: [&str; 2] = [
    "neither t_in > t_out nor t_out < 0 is tested",
    "There are two ways to miss: to pass by (t_in > t_out), and to go the other way (t_out < 0).",
];
const INSIDE: [&str; 2] = [
    "a ray that starts inside is turned down",
    "There t_in < 0 and t_out > 0. Only t_out < 0 means that all of it lies behind.",
];
const UNSORTED: [&str; 2] = [
    "the two t of an axis are not put in order",
    "A ray with a negative direction meets the high side first: slab has to say which t is the smaller.",
];

fn rectangle() -> Task<Flat> {
    const FAULTS: &[Fault<Flat>] = &[
        Fault {
            id: "rectangle-min-max-swapped",
            name: SWAPPED[0],
            why: SWAPPED[1],
            answer: |case| mistaken::union(&ordered(flat_sides(case))),
        },
        Fault {
            id: "rectangle-behind",
            name: BEHIND[0],
            why: BEHIND[1],
            answer: |case| mistaken::behind(&ordered(flat_sides(case))),
        },
        Fault {
            id: "rectangle-disjoint",
            name: DISJOINT[0],
            why: DISJOINT[1],
            answer: |case| mistaken::disjoint(&ordered(flat_sides(case))),
        },
        Fault {
            id: "rectangle-unchecked",
            name: UNCHECKED[0],
            why: UNCHECKED[1],
            answer: |case| mistaken::unchecked(&ordered(flat_sides(case))),
        },
        Fault {
            id: "rectangle-inside",
            name: INSIDE[0],
            why: INSIDE[1],
            answer: |case| mistaken::inside(&ordered(flat_sides(case))),
        },
        Fault {
            id: "rectangle-unsorted",
            name: UNSORTED[0],
            why: UNSORTED[1],
            answer: |case| mistaken::usual(&flat_sides(case)),
        },
    ];
    let (min, max) = (dvec2(2.0, 1.0), dvec2(6.0, 3.0));
    let mut cases = vec![
        Case::new("in through the left side", [dvec2(0.0, 1.0), dvec2(2.0, 0.5), min, max]),
        Case::new("in through the lower side", [dvec2(2.0, -1.0), dvec2(1.0, 1.0), min, max]),
        Case::new("past the corner", [dvec2(0.0, 2.0), dvec2(1.0, 1.0), min, max]),
        Case::new("from the other side", [dvec2(8.0, 3.0), dvec2(-2.0, -0.5), min, max]),
        Case::new("from inside", [dvec2(4.0, 2.0), dvec2(1.0, 0.25), min, max]),
        Case::new("it lies behind", [dvec2(8.0, 4.0), dvec2(2.0, 1.0), min, max]),
        Case::new("passed by, and behind", [dvec2(9.0, 1.0), dvec2(1.0, 1.0), min, max]),
    ];
    cases.extend(random_cases(402, 60, |random| {
        let min = dvec2(small(random), small(random));
        let max = min + dvec2(1.0 + random.below(6) as f64 / 2.0, 1.0 + random.below(6) as f64 / 2.0);
        let case = [dvec2(small(random), small(random)), dvec2(step(random), step(random)), min, max];
        is_clear(meet(&ordered(flat_sides(&case)))).then_some(case)
    }));
    Task {
        name: "a rectangle",
        function: "rectangle",
        points: 3,
        after: &["slab"],
        cases,
        given: |[o, d, min, max]| {
            vec![
                numbers("origin", &o.to_array()),
                numbers("direction", &d.to_array()),
                numbers("min", &min.to_array()),
                numbers("max", &max.to_array()),
            ]
        },
        truth: true_rectangle,
        faults: FAULTS,
        picture: |[o, d, min, max], what, _| pictures::rectangle_span(*o, *d, *min, *max, what),
        hints: &[
            "Call slab twice: once with all the x, once with all the y. The ray is in the rectangle when it is \
             in both slabs.",
            "It is in both only after it has come into the second of them: t_in is the larger of the two t_in. \
             And t_out?",
            "Two reasons for None: t_in > t_out (never in both at once), t_out < 0 (all of it behind).",
        ],
    }
}

fn box_span() -> Task<RayAndBox> {
    const FAULTS: &[Fault<RayAndBox>] = &[
        Fault {
            id: "box-without-z",
            name: "the third slab is missing",
            why: "x and y alone make a shaft without end, not a box.",
            answer: |case| mistaken::usual(&ordered(box_sides(case))[..2]),
        },
        Fault {
            id: "box-min-max-swapped",
            name: SWAPPED[0],
            why: SWAPPED[1],
            answer: |case| mistaken::union(&ordered(box_sides(case))),
        },
        Fault {
            id: "box-behind",
            name: BEHIND[0],
            why: BEHIND[1],
            answer: |case| mistaken::behind(&ordered(box_sides(case))),
        },
        Fault {
            id: "box-disjoint",
            name: DISJOINT[0],
            why: DISJOINT[1],
            answer: |case| mistaken::disjoint(&ordered(box_sides(case))),
        },
        Fault {
            id: "box-unchecked",
            name: UNCHECKED[0],
            why: UNCHECKED[1],
            answer: |case| mistaken::unchecked(&ordered(box_sides(case))),
        },
        Fault {
            id: "box-inside",
            name: INSIDE[0],
            why: INSIDE[1],
            answer: |case| mistaken::inside(&ordered(box_sides(case))),
        },
        Fault {
            id: "box-unsorted",
            name: UNSORTED[0],
            why: UNSORTED[1],
            answer: |case| mistaken::usual(&box_sides(case)),
        },
    ];
    Task {
        name: "a box",
        function: "box_span",
        points: 3,
        after: &["slab"],
        cases: boxes(403),
        given: of_ray_and_box,
        truth: true_span,
        faults: FAULTS,
        picture: |(ray, aabb), what, _| pictures::box_span(ray, aabb, what),
        hints: &[
            "The same as the rectangle, with a third slab: ray.origin.z, ray.direction.z, aabb.min.z, aabb.max.z.",
            "x.t_in.max(y.t_in).max(z.t_in) is the largest of three.",
        ],
    }
}

fn of_ray_and_box((ray, aabb): &RayAndBox) -> Vec<String> {
    let line = |name: &str, v: DVec3| numbers(name, &v.to_array());
    vec![line("o", ray.origin), line("d", ray.direction), line("min", aabb.min), line("max", aabb.max)]
}

fn boxes(seed: u64) -> Vec<Case<RayAndBox>> {
    let aabb = Aabb { min: dvec3(0.0, 0.0, 0.0), max: dvec3(4.0, 2.0, 2.0) };
    let case = |name: &str, origin: DVec3, direction: DVec3| Case::new(name, (Ray { origin, direction }, aabb));
    let mut cases = vec![
        case("in through the front", dvec3(1.0, 1.0, 5.0), dvec3(0.5, 0.25, -1.0)),
        case("past the corner", dvec3(-2.0, 1.0, 1.0), dvec3(1.0, 1.0, 0.25)),
        case("past it in z alone", dvec3(-1.0, 1.0, 5.0), dvec3(1.0, 0.125, -0.5)),
        case("from inside", dvec3(1.0, 1.0, 1.0), dvec3(1.0, 0.25, 0.5)),
        case("it lies behind", dvec3(6.0, 3.0, 3.0), dvec3(1.0, 0.5, 0.5)),
        case("along an axis", dvec3(-2.0, 1.0, 1.0), dvec3(2.0, 0.0, 0.0)),
        case("along an axis, beside the box", dvec3(-2.0, 3.0, 1.0), dvec3(2.0, 0.0, 0.0)),
    ];
    cases.extend(random_cases(seed, 60, |random| {
        let min = random.vector(small);
        let max = min + random.vector(|random| 1.0 + random.below(6) as f64 / 2.0);
        // Half of them aim at a point of the box.
        let origin = random.vector(small);
        let inner = random.vector(|random| (1 + random.below(7)) as f64 / 8.0);
        let direction = match random.one_in(2) {
            true => min + inner * (max - min) - origin,
            false => random.vector(step),
        };
        let case =
            (Ray { origin, direction: if random.one_in(5) { -direction } else { direction } }, Aabb { min, max });
        let is_slanted = direction.abs().min_element() > 1e-3;
        (is_slanted && is_clear(meet(&ordered(box_sides(&case))))).then_some(case)
    }));
    cases
}

fn intersect() -> Task<RayAndBox> {
    const FAULTS: &[Fault<RayAndBox>] = &[
        Fault {
            id: "box-entry-inside",
            name: "the entry is taken even where the ray starts inside",
            why: "Inside, t_in is negative: the entry lies behind. The first hit is the way out, t_out.",
            answer: |case| match true_span(case) {
                Answer::Nothing(_) => hit(None),
                span => hit(span.number("t_in")),
            },
        },
        Fault {
            id: "box-exit-always",
            name: "the exit is taken where the entry comes first",
            why: "t_out counts only where t_in is negative.",
            answer: |case| match true_span(case) {
                Answer::Nothing(_) => hit(None),
                span => hit(span.number("t_out")),
            },
        },
        Fault {
            id: "box-inside-none",
            name: "a ray that starts inside hits nothing",
            why: "It hits the box from within, where it goes out: t_out.",
            answer: |case| hit(true_span(case).number("t_in").filter(|t| *t >= 0.0)),
        },
        Fault {
            id: "box-inside-zero",
            name: "a ray that starts inside hits at once, at t = 0",
            why: "The box is its surface: at t = 0 there is nothing to be seen yet. The first hit is t_out.",
            answer: |case| match true_span(case) {
                Answer::Nothing(_) => hit(None),
                span => hit(span.number("t_in").map(|t| t.max(0.0))),
            },
        },
    ];
    Task {
        name: "the first hit",
        function: "intersect",
        points: 2,
        after: &["box_span"],
        cases: boxes(404),
        given: of_ray_and_box,
        truth: |(ray, aabb)| hit(intersect_box_certified(ray, aabb, Start::Anywhere).ok().map(|certified| certified.t)),
        faults: FAULTS,
        picture: |(ray, aabb), what, _| pictures::box_span(ray, aabb, what),
        hints: &[
            "box_span(ray, aabb)? gives the span, or ends the function with None.",
            "Where does the ray start if t_in is negative and t_out is not? Which of the two does it meet first?",
        ],
    }
}
