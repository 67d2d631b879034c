//! Lesson 03, the triangle: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::kernels::{
    TriangleFilter, intersect_plane_certified, intersect_triangle_certified, triangle_lecture_values,
};
use raytree::lessons::{
    Answer, Case, Fault, Lesson, Plane, Random, Ray, Task, Triangle, TriangleHit, pictures, random_cases, shown,
};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) plane_t: fn(&Ray, &Triangle) -> Option<f64>,
    pub(crate) weights: fn(DVec3, &Triangle) -> [f64; 3],
    pub(crate) is_inside: fn(f64, f64) -> bool,
    pub(crate) intersect: fn(&Ray, &Triangle) -> Option<TriangleHit>,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    Lesson {
        number: 3,
        title: "triangle",
        stages: vec![
            plane_t().stage(move |(ray, triangle)| at_plane((student.plane_t)(ray, triangle), ray)),
            weights().stage(move |(p, triangle)| of_weights((student.weights)(*p, triangle))),
            is_inside().stage(move |[a, b]| inside((student.is_inside)(*a, *b))),
            intersect().stage(move |(ray, triangle)| hit((student.intersect)(ray, triangle))),
        ],
        notice: "Now see a real ray do it: raytree diagram scenes/triangle.json \"just inside\" --kind triangle -o inside.png",
    }
}

type RayAndTriangle = (Ray, Triangle);

fn at_plane(t: Option<f64>, ray: &Ray) -> Answer {
    Answer::maybe(t, "no point", |t| Answer::of("t", t).and("p", ray.at(t)))
}

fn of_weights([a, b, c]: [f64; 3]) -> Answer {
    Answer::of("a", a).and("b", b).and("c", c)
}

fn inside(yes: bool) -> Answer {
    Answer::of("inside", yes)
}

fn hit(hit: Option<TriangleHit>) -> Answer {
    Answer::maybe(hit, "no hit", |hit| {
        let [a, b, c] = hit.barycentrics;
        Answer::of("t", hit.t).and("a", a).and("b", b).and("c", c)
    })
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn of_triangle(triangle: &Triangle) -> Vec<String> {
    ["v0", "v1", "v2"].into_iter().zip(triangle.vertices).map(|(name, v)| named(name, v)).collect()
}

fn of_ray_and_triangle((ray, triangle): &RayAndTriangle) -> Vec<String> {
    let mut lines = of_triangle(triangle);
    lines.extend([named("o", ray.origin), named("d", ray.direction)]);
    lines
}

fn normal(triangle: &Triangle) -> DVec3 {
    let [v0, v1, v2] = triangle.vertices;
    (v1 - v0).cross(v2 - v0)
}

fn vector(random: &mut Random) -> DVec3 {
    random.vector(|random| random.below(9) as f64 - 4.0)
}

/// Corners with small integers, and no needle.
fn triangle(random: &mut Random) -> Option<Triangle> {
    let triangle = Triangle { vertices: [vector(random), vector(random), vector(random)] };
    (normal(&triangle).length() > 4.0).then_some(triangle)
}

/// The plane z = 0 with corners that make the arithmetic easy.
fn flat() -> Triangle {
    Triangle { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(4.0, 0.0, 0.0), dvec3(0.0, 4.0, 0.0)] }
}

/// A slanted one: the corners on the three axes.
fn slanted() -> Triangle {
    Triangle { vertices: [dvec3(2.0, 0.0, 0.0), dvec3(0.0, 2.0, 0.0), dvec3(0.0, 0.0, 2.0)] }
}

/// A triangle whose plane does not go through the origin.
fn lifted() -> Triangle {
    Triangle { vertices: [dvec3(0.0, 0.0, 2.0), dvec3(4.0, 0.0, 2.0), dvec3(0.0, 4.0, 2.0)] }
}

fn down(x: f64, y: f64) -> Ray {
    Ray { origin: dvec3(x, y, 6.0), direction: dvec3(0.0, 0.0, -2.0) }
}

/// t of the line and the plane with a normal through a point, whatever its sign.
fn line_t(ray: &Ray, normal: DVec3, point: DVec3) -> f64 {
    (normal.dot(point) - normal.dot(ray.origin)) / normal.dot(ray.direction)
}

fn plane_t() -> Task<RayAndTriangle> {
    fn checked(t: f64, ray: &Ray) -> Answer {
        at_plane((t >= 0.0).then_some(t), ray)
    }
    const FAULTS: &[Fault<RayAndTriangle>] = &[
        Fault {
            id: "normal-of-corners",
            name: "the normal is made of corners, not of edges",
            why: "v1 x v2 stands at a right angle to the ways from the origin to the corners. The edges v1 - v0 \
                  and v2 - v0 lie in the plane.",
            answer: |(ray, triangle)| {
                let [v0, v1, v2] = triangle.vertices;
                checked(line_t(ray, v1.cross(v2), v0), ray)
            },
        },
        Fault {
            id: "triangle-plane-d-sign",
            name: "D has the wrong sign",
            why: "The plane is p . n - D = 0 with D = v0 . n, so t = (D - o . n) / (d . n).",
            answer: |(ray, triangle)| {
                let n = normal(triangle);
                checked((-n.dot(triangle.vertices[0]) - n.dot(ray.origin)) / n.dot(ray.direction), ray)
            },
        },
        Fault {
            id: "triangle-plane-without-d",
            name: "D is missing: this is the parallel plane through the origin",
            why: "v0 lies in the plane, so D = v0 . n. It is 0 only by accident.",
            answer: |(ray, triangle)| {
                let n = normal(triangle);
                checked(-n.dot(ray.origin) / n.dot(ray.direction), ray)
            },
        },
        Fault {
            id: "triangle-plane-negative-t",
            name: "a negative t is taken for a point of the ray",
            why: "t < 0 lies behind the origin. Only t >= 0 counts.",
            answer: |(ray, triangle)| {
                let n = normal(triangle);
                let t = line_t(ray, n, triangle.vertices[0]);
                at_plane((n.dot(ray.direction) != 0.0).then_some(t), ray)
            },
        },
        Fault {
            id: "triangle-plane-parallel",
            name: "a parallel ray is not turned down",
            why: "Where d . n = 0 the division gives infinity, or nothing that is a number at all.",
            answer: |(ray, triangle)| {
                let t = line_t(ray, normal(triangle), triangle.vertices[0]);
                if t < 0.0 { at_plane(None, ray) } else { at_plane(Some(t), ray) }
            },
        },
        Fault {
            id: "triangle-one-sided",
            name: "rays from behind the triangle are turned down",
            why: "A triangle can be seen from both sides: d . n may be positive as well as negative.",
            answer: |(ray, triangle)| {
                let n = normal(triangle);
                let t = line_t(ray, n, triangle.vertices[0]);
                at_plane((t >= 0.0 && n.dot(ray.direction) < 0.0).then_some(t), ray)
            },
        },
    ];
    let ray = |origin, direction| Ray { origin, direction };
    let mut cases = vec![
        Case::new("straight down", (down(1.0, 1.0), lifted())),
        Case::new("a slanted plane", (ray(dvec3(2.0, 2.0, 2.0), dvec3(-1.0, -1.0, -1.0)), slanted())),
        Case::new("from below", (ray(dvec3(1.0, 1.0, 0.0), dvec3(0.0, 0.0, 1.0)), lifted())),
        Case::new("away from the plane", (ray(dvec3(1.0, 1.0, 6.0), dvec3(0.0, 1.0, 1.0)), lifted())),
        Case::new("parallel, above", (ray(dvec3(1.0, 1.0, 6.0), dvec3(1.0, 0.0, 0.0)), lifted())),
        Case::new("parallel, below", (ray(dvec3(1.0, 1.0, -6.0), dvec3(1.0, 0.0, 0.0)), lifted())),
        Case::new("beside the triangle, but in its plane", (down(9.0, 9.0), lifted())),
    ];
    cases.extend(random_cases(301, 40, |random| {
        let (ray, triangle) = (Ray { origin: vector(random), direction: vector(random) }, triangle(random)?);
        let n = normal(&triangle);
        let is_clear = n.dot(ray.direction).abs() > 1e-3 && line_t(&ray, n, triangle.vertices[0]).abs() > 1e-3;
        is_clear.then_some((ray, triangle))
    }));
    Task {
        name: "the plane hit",
        function: "plane_t",
        points: 2,
        after: &[],
        cases,
        given: of_ray_and_triangle,
        truth: |(ray, triangle)| {
            // The plane as the lecture has it; its normal need not be unit for t.
            let n = normal(triangle);
            let plane = Plane { normal: n, distance: n.dot(triangle.vertices[0]) };
            at_plane(intersect_plane_certified(ray, &plane).ok().map(|certified| certified.t), ray)
        },
        faults: FAULTS,
        picture: |(ray, triangle), what, _| pictures::triangle_plane(ray, triangle, what),
        hints: &[
            "This is lesson 02 once more, with a plane that you have to find: what is its normal, and what is its D?",
            "Two edges lie in the plane: (v1 - v0) and (v2 - v0). Their cross product is a normal. It need not \
             have length 1: its length cancels in t.",
            "D = n . v0, because v0 lies in the plane. Then t = (D - n . o) / (n . d), unless n . d = 0 or t < 0.",
        ],
    }
}

fn true_weights(p: DVec3, triangle: &Triangle) -> [f64; 3] {
    let [v0, v1, v2] = triangle.vertices;
    let n = normal(triangle);
    let of = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(n) / n.length_squared();
    [of(v1, v2), of(v2, v0), of(v0, v1)]
}

fn weights() -> Task<(DVec3, Triangle)> {
    fn areas(p: DVec3, triangle: &Triangle) -> [f64; 3] {
        let [v0, v1, v2] = triangle.vertices;
        let of = |from: DVec3, to: DVec3| (to - from).cross(p - from).length() / normal(triangle).length();
        [of(v1, v2), of(v2, v0), of(v0, v1)]
    }
    const FAULTS: &[Fault<(DVec3, Triangle)>] = &[
        Fault {
            id: "barycentrics-a-b-exchanged",
            name: "a and b are exchanged",
            why: "a is the weight of v0: it is 1 in v0, and 0 on the edge opposite, from v1 to v2. So a is made \
                  of v1, v2 and p.",
            answer: |(p, triangle)| {
                let [a, b, c] = true_weights(*p, triangle);
                of_weights([b, a, c])
            },
        },
        Fault {
            id: "barycentrics-permuted",
            name: "the weights belong to the wrong corners: this is the order of v2, v0, v1",
            why: "The edge from v0 to v1 gives the weight of v2, the corner that is not on it. The first weight \
                  has to be that of v0.",
            answer: |(p, triangle)| {
                let [a, b, c] = true_weights(*p, triangle);
                of_weights([c, a, b])
            },
        },
        Fault {
            id: "barycentrics-permuted-back",
            name: "the weights belong to the wrong corners: this is the order of v1, v2, v0",
            why: "In Moller and Trumbore's letters u and v are the weights of v1 and v2; here a is that of v0 \
                  and comes first.",
            answer: |(p, triangle)| {
                let [a, b, c] = true_weights(*p, triangle);
                of_weights([b, c, a])
            },
        },
        Fault {
            id: "barycentrics-reversed",
            name: "the weights of v0 and v2 are exchanged",
            why: "a is the weight of v0, b that of v1, and 1 - a - b that of v2.",
            answer: |(p, triangle)| {
                let [a, b, c] = true_weights(*p, triangle);
                of_weights([c, b, a])
            },
        },
        Fault {
            id: "barycentrics-unsigned",
            name: "the areas have no sign: a weight that should be negative comes out positive",
            why: "A length is never negative. Take the scalar product with the normal instead: it is negative \
                  beyond the edge.",
            answer: |(p, triangle)| of_weights(areas(*p, triangle)),
        },
        Fault {
            id: "barycentrics-unsigned-rest",
            name: "the areas have no sign: a weight that should be negative comes out positive",
            why: "A length is never negative. Take the scalar product with the normal instead: it is negative \
                  beyond the edge.",
            answer: |(p, triangle)| {
                let [a, b, _] = areas(*p, triangle);
                of_weights([a, b, 1.0 - a - b])
            },
        },
        Fault {
            id: "barycentrics-sign",
            name: "a and b have the wrong sign",
            why: "Go around the triangle one way: v1 to v2, v2 to v0, v0 to v1. The other way around every area \
                  is negative.",
            answer: |(p, triangle)| {
                let [a, b, _] = true_weights(*p, triangle);
                of_weights([-a, -b, 1.0 + a + b])
            },
        },
        Fault {
            id: "barycentrics-b-sign",
            name: "b has the wrong sign",
            why: "For b the way around goes from v2 to v0. From v0 to v2 the area comes out negative.",
            answer: |(p, triangle)| {
                let [a, b, _] = true_weights(*p, triangle);
                of_weights([a, -b, 1.0 - a + b])
            },
        },
        Fault {
            id: "barycentrics-a-sign",
            name: "a has the wrong sign",
            why: "For a the way around goes from v1 to v2. From v2 to v1 the area comes out negative.",
            answer: |(p, triangle)| {
                let [a, b, _] = true_weights(*p, triangle);
                of_weights([-a, b, 1.0 + a - b])
            },
        },
        Fault {
            id: "barycentrics-halved",
            name: "a and b are half of what they should be",
            why: "A triangle is half of a parallelogram. Above and below the fraction line both are halves or \
                  both are not: the halves cancel.",
            answer: |(p, triangle)| {
                let [a, b, _] = true_weights(*p, triangle);
                of_weights([a / 2.0, b / 2.0, 1.0 - a / 2.0 - b / 2.0])
            },
        },
        Fault {
            id: "barycentrics-undivided",
            name: "the areas are not divided by that of the whole triangle",
            why: "Weights are shares: in a corner one of them is 1, whatever the size of the triangle.",
            answer: |(p, triangle)| {
                let whole = normal(triangle).length_squared();
                let [a, b, _] = true_weights(*p, triangle).map(|w| w * whole);
                of_weights([a, b, 1.0 - a - b])
            },
        },
    ];
    let mut cases = vec![
        Case::new("a = 1/4, b = 1/2", (dvec3(2.0, 1.0, 0.0), flat())),
        Case::new("the corner v0", (dvec3(0.0, 0.0, 0.0), flat())),
        Case::new("the corner v1", (dvec3(4.0, 0.0, 0.0), flat())),
        Case::new("outside, beyond v1", (dvec3(5.0, 0.0, 0.0), flat())),
        Case::new("outside, beyond the edge from v0 to v1", (dvec3(1.0, -1.0, 0.0), flat())),
        Case::new("a slanted triangle", (dvec3(1.0, 0.5, 0.5), slanted())),
    ];
    cases.extend(random_cases(302, 40, |random| {
        let triangle = triangle(random)?;
        // Eighths from -1/2 to 9/8.
        let share = |random: &mut Random| random.below(14) as f64 / 8.0 - 0.5;
        let (a, b) = (share(random), share(random));
        let [v0, v1, v2] = triangle.vertices;
        Some((a * v0 + b * v1 + (1.0 - a - b) * v2, triangle))
    }));
    Task {
        name: "the weights a, b, 1-a-b",
        function: "weights",
        points: 3,
        after: &[],
        cases,
        given: |(p, triangle)| {
            let mut lines = of_triangle(triangle);
            lines.push(named("p", *p));
            lines
        },
        truth: |(p, triangle)| of_weights(true_weights(*p, triangle)),
        faults: FAULTS,
        picture: |(p, triangle), what, _| pictures::triangle_weights(triangle, *p, what),
        hints: &[
            "a is the area of the small triangle p, v1, v2 over the area of the whole one. b is that of p, v2, \
             v0. You need not compute c.",
            "The length of a cross product is an area, but it has no sign. The cross products of the small \
             triangle and of the whole one point the same way inside and opposite ways outside: take the scalar \
             product with n = (v1 - v0) x (v2 - v0).",
            "a = ((v2 - v1) x (p - v1)) . n / (n . n). For b move every index on by one: v2 - v1 becomes v0 - \
             v2, p - v1 becomes p - v2.",
        ],
    }
}

fn is_inside() -> Task<[f64; 2]> {
    const FAULTS: &[Fault<[f64; 2]>] = &[
        Fault {
            id: "b-above-one",
            name: "b > 1 is tested instead of a + b > 1",
            why: "The third weight is 1 - a - b; it is negative as soon as a + b > 1, long before b > 1. The \
                  picture shows which points come too many: half of a parallelogram.",
            answer: |[a, b]| inside(*a >= 0.0 && *b >= 0.0 && *b <= 1.0),
        },
        Fault {
            id: "each-at-most-one",
            name: "a and b are each tested against 1, their sum is not",
            why: "That is a parallelogram. The third weight is 1 - a - b, so the third test is a + b <= 1.",
            answer: |[a, b]| inside((0.0..=1.0).contains(a) && (0.0..=1.0).contains(b)),
        },
        Fault {
            id: "sum-forgotten",
            name: "only a and b are tested, not the third weight",
            why: "The third weight 1 - a - b must not be negative either: a + b <= 1.",
            answer: |[a, b]| inside(*a >= 0.0 && *b >= 0.0),
        },
        Fault {
            id: "negative-weights",
            name: "negative weights are let through",
            why: "a < 0 lies beyond the edge from v1 to v2, b < 0 beyond the edge from v2 to v0.",
            answer: |[a, b]| inside(*a + *b <= 1.0),
        },
        Fault {
            id: "border-left-out",
            name: "the border does not count",
            why: "With < for <= a ray through the edge that two triangles share falls between them: a hole in \
                  the surface.",
            answer: |[a, b]| inside(*a > 0.0 && *b > 0.0 && *a + *b < 1.0),
        },
        Fault {
            id: "inside-upside-down",
            name: "yes and no are exchanged",
            why: "The tests a < 0, b < 0 and a + b > 1 say outside.",
            answer: |[a, b]| inside(!(*a >= 0.0 && *b >= 0.0 && *a + *b <= 1.0)),
        },
    ];
    let mut cases = vec![
        Case::new("in the middle", [0.25, 0.5]),
        Case::new("a is negative", [-0.25, 0.5]),
        Case::new("b is negative", [0.5, -0.25]),
        Case::new("the third weight is negative", [0.75, 0.75]),
        Case::new("on an edge", [0.5, 0.5]),
        Case::new("in the corner v0", [1.0, 0.0]),
        Case::new("far beyond v1", [-0.5, 1.25]),
        Case::new("a large, b negative", [1.5, -0.25]),
    ];
    cases.extend(random_cases(303, 40, |random| {
        let share = |random: &mut Random| random.below(20) as f64 / 8.0 - 0.6875;
        Some([share(random), share(random)])
    }));
    Task {
        name: "the three inside tests",
        function: "is_inside",
        points: 2,
        after: &[],
        cases,
        given: |[a, b]| vec![format!("a = {}, b = {}", shown(*a), shown(*b))],
        truth: |[a, b]| inside(*a >= 0.0 && *b >= 0.0 && *a + *b <= 1.0),
        faults: FAULTS,
        picture: |[a, b], what, ask| {
            pictures::inside_tests(*a, *b, what, &|a, b| ask(&[a, b]).and_then(|answer| answer.truth("inside")))
        },
        hints: &[
            "A point is inside when none of its three weights is negative. Two of them are a and b. What is the \
             third?",
            "1 - a - b >= 0 is the same as a + b <= 1.",
        ],
    }
}

fn true_hit((ray, triangle): &RayAndTriangle) -> Option<TriangleHit> {
    let filter = TriangleFilter::of_triangle(ray, triangle);
    intersect_triangle_certified(ray, triangle, &filter).ok().map(|certified| certified.hit)
}

fn intersect() -> Task<RayAndTriangle> {
    /// The plane's t and weights, and whether that is a point of the ray.
    fn parts((ray, triangle): &RayAndTriangle) -> (f64, [f64; 3]) {
        let values = triangle_lecture_values(ray, triangle);
        (values.t, [values.a, values.b, values.c])
    }
    fn kept(case: &RayAndTriangle, keep: impl Fn(f64, [f64; 3]) -> bool) -> Answer {
        let (t, barycentrics) = parts(case);
        hit((t.is_finite() && keep(t, barycentrics)).then_some(TriangleHit { t, barycentrics }))
    }
    const FAULTS: &[Fault<RayAndTriangle>] = &[
        Fault {
            id: "triangle-no-inside-test",
            name: "every point of the plane is taken for a hit",
            why: "The ray meets the plane, but perhaps beside the triangle: ask is_inside.",
            answer: |case| kept(case, |t, _| t >= 0.0),
        },
        Fault {
            id: "triangle-negative-t",
            name: "a triangle behind the origin is hit",
            why: "t < 0 lies behind the origin, however well the point lies inside.",
            answer: |case| kept(case, |_, w| w.iter().all(|x| *x >= 0.0)),
        },
        Fault {
            id: "triangle-hit-without-third-test",
            name: "the third weight is not tested",
            why: "1 - a - b must not be negative either.",
            answer: |case| kept(case, |t, [a, b, _]| t >= 0.0 && a >= 0.0 && b >= 0.0),
        },
        Fault {
            id: "triangle-weights-of-origin",
            name: "the weights are those of the ray's origin, not of the hit point",
            why: "First go to the plane: p = o + t d, ray.at(t). Then the weights of p.",
            answer: |(ray, triangle)| {
                let (t, _) = parts(&(*ray, *triangle));
                let w = true_weights(ray.origin, triangle);
                let is_hit = t.is_finite() && t >= 0.0 && w.iter().all(|x| *x >= 0.0);
                hit(is_hit.then_some(TriangleHit { t, barycentrics: w }))
            },
        },
        Fault {
            id: "triangle-hit-permuted",
            name: "the weights come in the wrong order",
            why: "barycentrics is [a, b, c]: the weights of v0, v1, v2.",
            answer: |case| {
                hit(true_hit(case).map(|h| {
                    let [a, b, c] = h.barycentrics;
                    TriangleHit { t: h.t, barycentrics: [b, c, a] }
                }))
            },
        },
        Fault {
            id: "triangle-culled",
            name: "triangles seen from behind are not hit",
            why: "A triangle has two sides; the sign of d . n says which one is seen, not whether.",
            answer: |case| {
                let front = normal(&case.1).dot(case.0.direction) < 0.0;
                hit(true_hit(case).filter(|_| front))
            },
        },
    ];
    let ray = |origin, direction| Ray { origin, direction };
    let mut cases = vec![
        Case::new("inside", (down(1.0, 1.0), lifted())),
        Case::new("beside it", (down(3.0, 3.0), lifted())),
        Case::new("from behind", (ray(dvec3(1.0, 2.0, 0.0), dvec3(0.0, 0.0, 1.0)), lifted())),
        Case::new("the triangle is behind the origin", (ray(dvec3(1.0, 1.0, 6.0), dvec3(0.0, 0.0, 1.0)), lifted())),
        Case::new("a slanted triangle", (ray(dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.5, 0.5)), slanted())),
        Case::new("parallel", (ray(dvec3(1.0, 1.0, 6.0), dvec3(1.0, 0.0, 0.0)), lifted())),
    ];
    cases.extend(random_cases(304, 60, |random| {
        let triangle = triangle(random)?;
        let share = |random: &mut Random| random.below(12) as f64 / 8.0 - 0.1875;
        let (a, b) = (share(random), share(random));
        let [v0, v1, v2] = triangle.vertices;
        let origin = vector(random);
        let direction = a * v0 + b * v1 + (1.0 - a - b) * v2 - origin;
        let case = (Ray { origin, direction: if random.one_in(8) { -direction } else { direction } }, triangle);
        let (t, w) = parts(&case);
        let is_clear = t.abs() > 1e-3 && t.is_finite() && w.iter().all(|x| x.abs() > 1e-3);
        is_clear.then_some(case)
    }));
    Task {
        name: "ray and triangle",
        function: "intersect",
        points: 3,
        after: &["plane_t", "weights", "is_inside"],
        cases,
        given: of_ray_and_triangle,
        truth: |case| hit(true_hit(case)),
        faults: FAULTS,
        picture: |(ray, triangle), what, _| pictures::triangle_hit(ray, triangle, what),
        hints: &[
            "You have everything: plane_t, then the point, then weights, then is_inside.",
            "let t = plane_t(ray, triangle)?; ends the function with None where there is no t. ray.at(t) is the \
             point.",
        ],
    }
}
