//! Lesson 02, the plane: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec3, dvec3};
use raytree::kernels::intersect_plane_certified;
use raytree::lessons::{Answer, Case, Fault, Lesson, Plane, Random, Ray, Task, pictures, random_cases, shown};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) plane_from: fn(DVec3, DVec3) -> Plane,
    pub(crate) signed_distance: fn(DVec3, &Plane) -> f64,
    pub(crate) intersect: fn(&Ray, &Plane) -> Option<f64>,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    let intersect = move |(ray, plane): &(Ray, Plane)| hit((student.intersect)(ray, plane));
    Lesson {
        number: 2,
        title: "plane",
        stages: vec![
            plane_from().stage(move |[point, normal]| hesse((student.plane_from)(*point, *normal))),
            signed_distance()
                .stage(move |(point, plane)| Answer::of("distance", (student.signed_distance)(*point, plane))),
            hits().stage(intersect),
            misses().stage(intersect),
        ],
        notice: "Now step through a plane hit: raytree diagram scenes/plane.json floor --kind plane -o floor.png",
    }
}

fn hesse(plane: Plane) -> Answer {
    Answer::of("n", plane.normal).and("D", plane.distance)
}

fn hit(t: Option<f64>) -> Answer {
    Answer::maybe(t, "no hit", |t| Answer::of("t", t))
}

fn named(name: &str, v: DVec3) -> String {
    format!("{name} = ({})", v.to_array().map(shown).join(", "))
}

fn vector(random: &mut Random) -> DVec3 {
    random.vector(|random| random.below(17) as f64 / 2.0 - 4.0)
}

/// Unit normals whose components are short decimals, so that a case can be done by hand.
fn unit(random: &mut Random) -> DVec3 {
    let [x, y, z] =
        [[1.0, 0.0, 0.0], [0.6, 0.8, 0.0], [0.0, 0.6, 0.8], [0.48, 0.64, 0.6], [0.28, 0.96, 0.0]][random.below(5)];
    let turned = [[x, y, z], [y, z, x], [z, x, y]][random.below(3)];
    DVec3::from_array(turned.map(|x| if random.one_in(2) { -x } else { x }))
}

fn plane(random: &mut Random) -> Plane {
    Plane { normal: unit(random), distance: random.below(13) as f64 / 2.0 - 3.0 }
}

fn plane_from() -> Task<[DVec3; 2]> {
    const FAULTS: &[Fault<[DVec3; 2]>] = &[
        Fault {
            id: "normal-not-unit",
            name: "the normal does not have length 1",
            why: "The points are right, but p . n - D is then no distance: it is too large by the length of the \
                  normal.",
            answer: |[p, n]| hesse(Plane { normal: *n, distance: p.dot(*n) }),
        },
        Fault {
            id: "distance-of-long-normal",
            name: "D is worked out with the normal before it is made a unit vector",
            why: "Normal and D belong together: normalise first, then D = p . n with the new normal.",
            answer: |[p, n]| hesse(Plane { normal: n.normalize(), distance: p.dot(*n) }),
        },
        Fault {
            id: "plane-d-sign",
            name: "D has the wrong sign",
            why: "p . n - D = 0 gives D = p . n. Other books write p . n + D = 0; their D is minus ours.",
            answer: |[p, n]| hesse(Plane { normal: n.normalize(), distance: -p.dot(n.normalize()) }),
        },
        Fault {
            id: "distance-as-length",
            name: "D is the distance of the point from the origin",
            why: "The point is one of many in the plane. D is measured along the normal: p . n.",
            answer: |[p, n]| hesse(Plane { normal: n.normalize(), distance: p.length() }),
        },
        Fault {
            id: "normal-by-square",
            name: "the normal is divided by the square of its length",
            why: "n . n is the length times itself; its root is the length.",
            answer: |[p, n]| {
                let normal = *n / n.length_squared();
                hesse(Plane { normal, distance: p.dot(normal) })
            },
        },
    ];
    let mut cases = vec![
        Case::new("a floor at height 3", [dvec3(5.0, 3.0, 1.0), dvec3(0.0, 2.0, 0.0)]),
        Case::new("a unit normal already", [dvec3(1.0, 2.0, 0.0), dvec3(0.6, 0.8, 0.0)]),
        Case::new("a slope", [dvec3(5.0, 0.0, 0.0), dvec3(3.0, 4.0, 0.0)]),
        Case::new("behind the origin", [dvec3(0.0, -2.0, 1.0), dvec3(0.0, 3.0, 0.0)]),
        Case::new("through the origin", [dvec3(0.0, 0.0, 0.0), dvec3(0.0, 0.0, -5.0)]),
    ];
    cases.extend(random_cases(201, 40, |random| {
        let normal = [2.0, 5.0, 10.0][random.below(3)] * unit(random);
        Some([vector(random), normal])
    }));
    Task {
        name: "plane in Hesse form",
        function: "plane_from",
        points: 3,
        after: &[],
        cases,
        given: |[point, normal]| vec![named("point", *point), named("normal", *normal)],
        truth: |[point, normal]| {
            let normal = normal.normalize();
            hesse(Plane { normal, distance: point.dot(normal) })
        },
        faults: FAULTS,
        picture: |[point, normal], what, _| pictures::plane_from(*point, *normal, what),
        hints: &[
            "Two steps: first make the normal a unit vector (normal.normalize()), then find D.",
            "The point lies in the plane: put it into p . n - D = 0 and solve for D.",
        ],
    }
}

fn signed_distance() -> Task<(DVec3, Plane)> {
    const FAULTS: &[Fault<(DVec3, Plane)>] = &[
        Fault {
            id: "distance-plus-d",
            name: "D is added instead of taken away",
            why: "p . n is how high p is above the origin, along n; the plane is at height D, so D has to go off.",
            answer: |(p, plane)| Answer::of("distance", p.dot(plane.normal) + plane.distance),
        },
        Fault {
            id: "distance-unsigned",
            name: "the sign is lost",
            why: "It tells the two sides of the plane apart: positive where the normal points to.",
            answer: |(p, plane)| Answer::of("distance", (p.dot(plane.normal) - plane.distance).abs()),
        },
        Fault {
            id: "distance-reversed",
            name: "the sign is the wrong way round",
            why: "On the side to which the normal points the distance is positive: p . n - D, not D - p . n.",
            answer: |(p, plane)| Answer::of("distance", plane.distance - p.dot(plane.normal)),
        },
        Fault {
            id: "distance-without-d",
            name: "D is missing",
            why: "p . n is the height above the origin. That is the distance from the plane only where D is 0.",
            answer: |(p, plane)| Answer::of("distance", p.dot(plane.normal)),
        },
    ];
    let floor = |distance| Plane { normal: dvec3(0.0, 1.0, 0.0), distance };
    let mut cases = vec![
        Case::new("above a floor", (dvec3(4.0, 5.0, 1.0), floor(2.0))),
        Case::new("below a floor", (dvec3(4.0, 1.0, 1.0), floor(2.0))),
        Case::new("in the plane", (dvec3(7.0, 2.0, -3.0), floor(2.0))),
        Case::new("a slope", (dvec3(3.0, 4.0, 0.0), Plane { normal: dvec3(0.6, 0.8, 0.0), distance: -1.0 })),
    ];
    cases.extend(random_cases(202, 40, |random| Some((vector(random), plane(random)))));
    Task {
        name: "signed distance",
        function: "signed_distance",
        points: 2,
        after: &[],
        cases,
        given: |(point, plane)| vec![named("point", *point), of_plane(plane)],
        truth: |(point, plane)| Answer::of("distance", point.dot(plane.normal) - plane.distance),
        faults: FAULTS,
        picture: |(point, plane), what, _| pictures::signed_distance(*point, plane, what),
        hints: &[
            "Points of the plane satisfy p . n - D = 0. What does the left side say of other points?",
            "point.dot(plane.normal) is the height along the normal; the plane itself is at height plane.distance.",
        ],
    }
}

fn of_plane(plane: &Plane) -> String {
    format!("{}, D = {}", named("n", plane.normal), shown(plane.distance))
}

fn of_ray_and_plane((ray, plane): &(Ray, Plane)) -> Vec<String> {
    vec![named("o", ray.origin), named("d", ray.direction), of_plane(plane)]
}

fn truth((ray, plane): &(Ray, Plane)) -> Answer {
    hit(intersect_plane_certified(ray, plane).ok().map(|certified| certified.t))
}

/// Rays that are clear of every tie, with the truth that is asked for.
fn rays(seed: u64, is_hit: bool) -> Vec<Case<(Ray, Plane)>> {
    random_cases(seed, 40, |random| {
        let (ray, plane) = (Ray { origin: vector(random), direction: vector(random) }, plane(random));
        let is_clear = plane.normal.dot(ray.direction).abs() > 1e-3
            && (plane.normal.dot(ray.origin) - plane.distance).abs() > 1e-3;
        let case = (ray, plane);
        (is_clear && matches!(truth(&case), Answer::Values(_)) == is_hit).then_some(case)
    })
}

/// The t of the line, whatever its sign.
fn t_of((ray, plane): &(Ray, Plane)) -> f64 {
    (plane.distance - plane.normal.dot(ray.origin)) / plane.normal.dot(ray.direction)
}

fn not_behind(t: f64) -> Answer {
    hit((t >= 0.0).then_some(t))
}

fn hits() -> Task<(Ray, Plane)> {
    const FAULTS: &[Fault<(Ray, Plane)>] = &[
        Fault {
            id: "plane-t-sign",
            name: "t has the wrong sign",
            why: "o . n + t (d . n) = D: bring o . n to the other side, so t = (D - o . n) / (d . n).",
            answer: |case| not_behind(-t_of(case)),
        },
        Fault {
            id: "plane-t-sign-unchecked",
            name: "t has the wrong sign",
            why: "o . n + t (d . n) = D: bring o . n to the other side, so t = (D - o . n) / (d . n).",
            answer: |case| hit(Some(-t_of(case))),
        },
        Fault {
            id: "plane-hit-d-sign",
            name: "D has the wrong sign",
            why: "The plane is p . n - D = 0, so D stands with a plus on the other side: D - o . n.",
            answer: |(ray, plane)| {
                not_behind((-plane.distance - plane.normal.dot(ray.origin)) / plane.normal.dot(ray.direction))
            },
        },
        Fault {
            id: "plane-hit-without-d",
            name: "D is missing: this is the parallel plane through the origin",
            why: "Only planes through the origin have D = 0.",
            answer: |(ray, plane)| not_behind(-plane.normal.dot(ray.origin) / plane.normal.dot(ray.direction)),
        },
        Fault {
            id: "plane-undivided",
            name: "it is not divided by d . n",
            why: "D - o . n is how far the plane is away straight down the normal; the ray goes there at a \
                  slant, d . n a step.",
            answer: |(ray, plane)| not_behind(plane.distance - plane.normal.dot(ray.origin)),
        },
        Fault {
            id: "plane-t-in-lengths",
            name: "t is measured in lengths, not in steps of d",
            why: "The point is o + t d with the d that is given. Made a unit vector before, it needs another t \
                  for the same point.",
            answer: |case| not_behind(t_of(case) * case.0.direction.length()),
        },
        Fault {
            id: "plane-one-sided",
            name: "rays from behind the plane are turned down",
            why: "A plane can be seen from both sides: d . n may be positive as well as negative.",
            answer: |case| hit(Some(t_of(case)).filter(|t| *t >= 0.0 && case.1.normal.dot(case.0.direction) < 0.0)),
        },
        Fault {
            id: "ray-without-start",
            name: "t = 0 is turned down",
            why: "A ray begins at its origin: t = 0 belongs to it. (That a reflected ray must not meet the \
                  surface it has just left is another question, which comes with shadows.)",
            answer: |case| hit(Some(t_of(case)).filter(|t| *t > 0.0)),
        },
    ];
    let floor = |distance| Plane { normal: dvec3(0.0, 1.0, 0.0), distance };
    let ray = |origin, direction| Ray { origin, direction };
    let mut cases = vec![
        Case::new("straight down", (ray(dvec3(0.0, 3.0, 0.0), dvec3(0.0, -1.0, 0.0)), floor(1.0))),
        Case::new("at a slant", (ray(dvec3(0.0, 3.0, 0.0), dvec3(1.0, -2.0, 0.0)), floor(1.0))),
        Case::new("from below", (ray(dvec3(0.0, -1.0, 0.0), dvec3(0.5, 1.0, 0.0)), floor(1.0))),
        Case::new("D below 0", (ray(dvec3(1.0, 1.0, 0.0), dvec3(1.0, -1.0, 0.0)), floor(-2.0))),
        Case::new("the ray starts in the plane", (ray(dvec3(1.0, 1.0, 0.0), dvec3(1.0, -1.0, 0.0)), floor(1.0))),
    ];
    cases.extend(rays(203, true));
    Task {
        name: "rays that meet it",
        function: "intersect",
        points: 3,
        after: &[],
        cases,
        given: of_ray_and_plane,
        truth,
        faults: FAULTS,
        picture: |(ray, plane), what, _| pictures::plane_hit(ray, plane, what),
        hints: &[
            "Put p = o + t d into p . n - D = 0. The scalar product may be taken apart: (o + t d) . n = o . n + \
             t (d . n).",
            "Solve for t: what has no t goes to the other side, then divide by d . n.",
        ],
    }
}

fn misses() -> Task<(Ray, Plane)> {
    const FAULTS: &[Fault<(Ray, Plane)>] = &[
        Fault {
            id: "plane-negative-t",
            name: "a negative t is taken for a hit",
            why: "t < 0 lies behind the origin: the ray goes the other way. Only t >= 0 counts.",
            answer: |case| {
                let along = case.1.normal.dot(case.0.direction);
                hit((along != 0.0).then(|| t_of(case)))
            },
        },
        Fault {
            id: "plane-parallel-and-negative",
            name: "neither a parallel ray nor a negative t is turned down",
            why: "Two things can go wrong: d . n = 0 (nothing to divide by), and t < 0 (behind the origin).",
            answer: |case| hit(Some(t_of(case))),
        },
        Fault {
            id: "plane-parallel",
            name: "a parallel ray is not turned down",
            why: "Where d . n = 0 the division gives infinity, and infinity is not less than 0.",
            answer: |case| {
                let t = t_of(case);
                if t < 0.0 { hit(None) } else { hit(Some(t)) }
            },
        },
    ];
    let floor = |distance| Plane { normal: dvec3(0.0, 1.0, 0.0), distance };
    let ray = |origin, direction| Ray { origin, direction };
    let mut cases = vec![
        Case::new("away from the plane", (ray(dvec3(0.0, 3.0, 0.0), dvec3(1.0, 2.0, 0.0)), floor(1.0))),
        Case::new("parallel, above", (ray(dvec3(0.0, 3.0, 0.0), dvec3(1.0, 0.0, 0.0)), floor(1.0))),
        Case::new("parallel, below", (ray(dvec3(0.0, -3.0, 0.0), dvec3(1.0, 0.0, 2.0)), floor(1.0))),
    ];
    cases.extend(rays(204, false));
    // Whoever never finds a hit has not understood when there is none.
    cases.extend(rays(205, true).into_iter().take(10));
    Task {
        name: "rays that do not",
        function: "intersect",
        points: 2,
        after: &["intersect"],
        cases,
        given: of_ray_and_plane,
        truth,
        faults: FAULTS,
        picture: |(ray, plane), what, _| pictures::plane_hit(ray, plane, what),
        hints: &[
            "When does a ray not meet a plane? There are two reasons.",
            "It runs parallel to the plane (what is d . n then?), or the plane lies behind it (what is t then?).",
        ],
    }
}
