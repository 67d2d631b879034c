//! Lesson 01, vectors: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::lessons::{Answer, Case, Fault, Lesson, Random, Task, pictures, random_cases, shown};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) dot: fn(DVec3, DVec3) -> f64,
    pub(crate) length: fn(DVec3) -> f64,
    pub(crate) normalize: fn(DVec3) -> DVec3,
    pub(crate) project: fn(DVec3, DVec3) -> DVec3,
    pub(crate) cross: fn(DVec3, DVec3) -> DVec3,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    Lesson {
        number: 1,
        title: "vectors",
        stages: vec![
            dot().stage(move |[a, b]| Answer::of("a . b", (student.dot)(*a, *b))),
            length().stage(move |a| Answer::of("length", (student.length)(*a))),
            normalize().stage(move |a| Answer::of("n", (student.normalize)(*a))),
            project().stage(move |[a, b]| Answer::of("p", (student.project)(*a, *b))),
            cross().stage(move |[a, b]| Answer::of("a x b", (student.cross)(*a, *b))),
        ],
        notice: "Now see where these products are used: raytree diagram scenes/plane.json floor --kind plane -o floor.png",
    }
}

type Pair = [DVec3; 2];

/// Halves from -4 to 4, so that a case can be done by hand; never the zero vector.
fn vector(random: &mut Random) -> DVec3 {
    let v = random.vector(|random| random.below(17) as f64 / 2.0 - 4.0);
    if v == DVec3::ZERO { DVec3::X } else { v }
}

fn pairs(seed: u64) -> Vec<Case<Pair>> {
    let mut cases = vec![
        Case::new("both in the x-y plane", [dvec3(2.0, 3.0, 0.0), dvec3(4.0, 0.0, 0.0)]),
        Case::new("two axes", [dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)]),
        Case::new("all three components", [dvec3(1.0, 2.0, 3.0), dvec3(4.0, 5.0, 6.0)]),
        Case::new("more than a right angle apart", [dvec3(-3.0, 1.0, 2.0), dvec3(2.0, 0.0, 1.0)]),
        Case::new("parallel", [dvec3(1.0, 2.0, 2.0), dvec3(2.0, 4.0, 4.0)]),
    ];
    cases.extend(random_cases(seed, 40, |random| Some([vector(random), vector(random)])));
    cases
}

fn singles(seed: u64) -> Vec<Case<DVec3>> {
    let mut cases = vec![
        Case::new("3, 4, 5", dvec3(3.0, 4.0, 0.0)),
        Case::new("along an axis", dvec3(0.0, 0.0, -2.0)),
        Case::new("all three components", dvec3(1.0, 2.0, 2.0)),
        Case::new("shorter than 1", dvec3(0.0, 0.25, 0.0)),
    ];
    cases.extend(random_cases(seed, 40, |random| Some(vector(random))));
    cases
}

fn two(pair: &Pair) -> Vec<String> {
    ["a", "b"].iter().zip(pair).map(|(name, v)| one_named(name, *v)).collect()
}

fn one_named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn dot() -> Task<Pair> {
    const FAULTS: &[Fault<Pair>] = &[
        Fault {
            id: "dot-without-z",
            name: "the third product is missing",
            why: "In the plane two products are enough; in space it is a_x b_x + a_y b_y + a_z b_z.",
            answer: |[a, b]| Answer::of("a . b", a.x * b.x + a.y * b.y),
        },
        Fault {
            id: "dot-of-lengths",
            name: "the lengths are multiplied, without the angle between the vectors",
            why: "|a| |b| is a . b only where both point the same way; otherwise the cosine of the angle belongs \
                  to it.",
            answer: |[a, b]| Answer::of("a . b", a.length() * b.length()),
        },
        Fault {
            id: "dot-sum-of-sums",
            name: "the components are added before they are multiplied",
            why: "Each component of a meets only the same component of b; the three products are added, nothing \
                  else.",
            answer: |[a, b]| Answer::of("a . b", a.element_sum() * b.element_sum()),
        },
        Fault {
            id: "dot-all-added",
            name: "the components are added where they have to be multiplied",
            why: "It is a sum of products: a_x * b_x, not a_x + b_x.",
            answer: |[a, b]| Answer::of("a . b", a.element_sum() + b.element_sum()),
        },
    ];
    Task {
        name: "scalar product",
        function: "dot",
        points: 2,
        after: &[],
        cases: pairs(101),
        given: two,
        truth: |[a, b]| Answer::of("a . b", a.dot(*b)),
        faults: FAULTS,
        picture: |[a, b], what, _| pictures::projection(*a, *b, what),
        hints: &[
            "The components are a.x, a.y, a.z. The result is one number, not a vector.",
            "Multiply x with x, y with y, z with z, and add the three products.",
        ],
    }
}

fn length() -> Task<DVec3> {
    const FAULTS: &[Fault<DVec3>] = &[
        Fault {
            id: "length-squared",
            name: "the root is missing: this is the square of the length",
            why: "a . a is |a| times |a|. (3, 4, 0) has length 5, and 25 is its square.",
            answer: |a| Answer::of("length", a.length_squared()),
        },
        Fault {
            id: "length-by-sum",
            name: "the components are added up without squares",
            why: "That is the way along the axes, around the corners; the straight way is the root of the sum of \
                  squares.",
            answer: |a| Answer::of("length", a.abs().element_sum()),
        },
        Fault {
            id: "length-without-z",
            name: "the third component is missing",
            why: "Pythagoras is used twice in space: sqrt(x x + y y + z z).",
            answer: |a| Answer::of("length", (a.x * a.x + a.y * a.y).sqrt()),
        },
    ];
    Task {
        name: "length",
        function: "length",
        points: 1,
        after: &["dot"],
        cases: singles(102),
        given: |a| vec![one_named("a", *a)],
        truth: |a| Answer::of("length", a.length()),
        faults: FAULTS,
        picture: |a, what, _| pictures::length(*a, what),
        hints: &[
            "Pythagoras: the square of the length is the sum of the squares.",
            "dot(a, a) is that sum; .sqrt() takes the root.",
        ],
    }
}

fn normalize() -> Task<DVec3> {
    const FAULTS: &[Fault<DVec3>] = &[
        Fault {
            id: "not-normalized",
            name: "the vector comes back as it was",
            why: "A unit vector has length 1: every component has to be divided by the length.",
            answer: |a| Answer::of("n", *a),
        },
        Fault {
            id: "normalized-by-square",
            name: "it is divided by the square of the length",
            why: "dot(a, a) is the length times itself. Divide by its root, or long vectors come out too short \
                  and short ones too long.",
            answer: |a| Answer::of("n", *a / a.length_squared()),
        },
        Fault {
            id: "normalized-by-largest",
            name: "it is divided by the largest component",
            why: "Then the largest component is 1, but the length is not.",
            answer: |a| Answer::of("n", *a / a.abs().max_element()),
        },
        Fault {
            id: "normalized-upside-down",
            name: "it is multiplied by the length",
            why: "A vector of length 5 has to become five times as short, not five times as long.",
            answer: |a| Answer::of("n", *a * a.length()),
        },
    ];
    Task {
        name: "unit vector",
        function: "normalize",
        points: 1,
        after: &["length"],
        cases: singles(103),
        given: |a| vec![one_named("a", *a)],
        truth: |a| Answer::of("n", a.normalize()),
        faults: FAULTS,
        picture: |a, what, _| pictures::normal_vector(*a, what),
        hints: &[
            "How long is a / 2? And a / 5?",
            "Divide the vector by its own length: a vector may be divided by a number, a / 5.0.",
        ],
    }
}

fn project() -> Task<Pair> {
    const FAULTS: &[Fault<Pair>] = &[
        Fault {
            id: "projection-undivided",
            name: "(a . b) b is not divided by b . b",
            why: "The formula (a . b) b holds for a b of length 1. For others b comes in twice, so its length \
                  has to go out twice.",
            answer: |[a, b]| Answer::of("p", a.dot(*b) * *b),
        },
        Fault {
            id: "projection-divided-once",
            name: "it is divided by the length of b once, not twice",
            why: "(a . b) / |b| is how long the shadow is; to point along b it has to be multiplied by b / |b|, \
                  not by b.",
            answer: |[a, b]| Answer::of("p", a.dot(*b) / b.length() * *b),
        },
        Fault {
            id: "projection-swapped",
            name: "b is projected onto a instead of a onto b",
            why: "The shadow falls on the line of b, so the result is a multiple of b.",
            answer: |[a, b]| Answer::of("p", a.dot(*b) / a.length_squared() * *a),
        },
        Fault {
            id: "projection-rest",
            name: "this is what is left of a, at a right angle to b",
            why: "a has two parts: the shadow along b, and the rest. The rest is a minus the shadow.",
            answer: |[a, b]| Answer::of("p", *a - a.dot(*b) / b.length_squared() * *b),
        },
        Fault {
            id: "projection-wrong-length",
            name: "it is divided by a . a instead of b . b",
            why: "How long a is has already been counted in a . b; it is the length of b that has to go out.",
            answer: |[a, b]| Answer::of("p", a.dot(*b) / a.length_squared() * *b),
        },
    ];
    Task {
        name: "projection",
        function: "project",
        points: 2,
        after: &["dot"],
        cases: pairs(104),
        given: two,
        truth: |[a, b]| Answer::of("p", a.project_onto(*b)),
        faults: FAULTS,
        picture: |[a, b], what, _| pictures::projection(*a, *b, what),
        hints: &[
            "The result is a multiple of b. Which one? Look at a = (2, 3, 0) and b = (4, 0, 0): the shadow is \
             (2, 0, 0), half of b.",
            "If b had length 1 it would be dot(a, b) * b. Put b / |b| for b, twice.",
            "dot(a, b) / dot(b, b) * b",
        ],
    }
}

fn cross() -> Task<Pair> {
    const FAULTS: &[Fault<Pair>] = &[
        Fault {
            id: "cross-reversed",
            name: "the sign is wrong: this is b x a",
            why: "The diagonals down count plus and those up minus. Turned around, the vector points to the \
                  other side.",
            answer: |[a, b]| Answer::of("a x b", b.cross(*a)),
        },
        Fault {
            id: "cross-middle-sign",
            name: "the sign of the y component is wrong",
            why: "In Sarrus's scheme the diagonal of e_y begins in the second column: a_z b_x comes first, a_x \
                  b_z is taken away.",
            answer: |[a, b]| Answer::of("a x b", a.cross(*b) * dvec3(1.0, -1.0, 1.0)),
        },
        Fault {
            id: "cross-all-plus",
            name: "the products are added where one has to be taken away",
            why: "Three diagonals count plus and three count minus.",
            answer: |[a, b]| {
                Answer::of("a x b", dvec3(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x))
            },
        },
        Fault {
            id: "cross-shifted",
            name: "the components stand in the wrong places",
            why: "The x component is made of the y and z of both vectors, never of an x.",
            answer: |[a, b]| {
                let v = a.cross(*b);
                Answer::of("a x b", dvec3(v.z, v.x, v.y))
            },
        },
        Fault {
            id: "cross-shifted-back",
            name: "the components stand in the wrong places",
            why: "The x component is made of the y and z of both vectors, never of an x.",
            answer: |[a, b]| {
                let v = a.cross(*b);
                Answer::of("a x b", dvec3(v.y, v.z, v.x))
            },
        },
        Fault {
            id: "cross-by-components",
            name: "the components are multiplied one by one",
            why: "That is what a * b means for two vectors in glam. The cross product mixes the components.",
            answer: |[a, b]| Answer::of("a x b", *a * *b),
        },
    ];
    Task {
        name: "cross product",
        function: "cross",
        points: 2,
        after: &[],
        cases: pairs(105),
        given: two,
        truth: |[a, b]| Answer::of("a x b", a.cross(*b)),
        faults: FAULTS,
        picture: |[a, b], what, _| pictures::cross_product(*a, *b, what),
        hints: &[
            "Write the scheme on paper: e_x e_y e_z in the first row, a below, b below that, and the first two \
             columns once more.",
            "The x component: the diagonal down from e_x is a_y b_z, the one up to e_x is a_z b_y. Plus the \
             first, minus the second.",
            "DVec3::new(a.y * b.z - a.z * b.y, ..., ...): the other two follow by moving x to y to z to x.",
        ],
    }
}
