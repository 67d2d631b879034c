use std::cmp::Ordering;

use glam::DVec3;
use raytree::kernels::*;
use raytree::numbers::Vector3;

use raytree::accuracy::random::{Random, rounded, stored};
use raytree::accuracy::referee::{Q, SphereTruth, TriangleTruth, plane, q, sign};

/// Enough for the roots below: two that are not equal differ long before.
const BITS: usize = 3000;

enum Truth {
    Number(Q),
    Sphere(SphereTruth, bool),
}

fn truth(ray: &Ray<f64>, root: Root<f64>) -> Option<Truth> {
    let quotient = |a: Q, b: Q| (sign(&b) != 0).then(|| Truth::Number(a / b));
    match root {
        Root::Plane(shape) => {
            let (n_dot_d, height) = plane(ray, shape);
            quotient(height, n_dot_d)
        }
        Root::Triangle(shape) => {
            let truth = TriangleTruth::new(ray, shape)?;
            quotient(truth.t_numerator, truth.denominator)
        }
        Root::BoxFace(shape, face) => {
            let (k, corner) = (face as usize / 2, if face % 2 == 0 { shape.min } else { shape.max });
            quotient(q(corner.to_array()[k]) - q(ray.origin.to_array()[k]), q(ray.direction.to_array()[k]))
        }
        Root::SphereNear(shape) | Root::SphereFar(shape) => {
            let truth = SphereTruth::new(ray, shape);
            (sign(&truth.disc) >= 0).then(|| Truth::Sphere(truth, matches!(root, Root::SphereFar(_))))
        }
    }
}

/// By intervals so narrow that two which still overlap are one number.
fn compare(a: &Truth, b: &Truth) -> Ordering {
    let interval = |truth: &Truth| match truth {
        Truth::Number(t) => (t.clone(), t.clone()),
        Truth::Sphere(sphere, far) => sphere.interval(*far, BITS),
    };
    match (a, b) {
        (Truth::Number(a), Truth::Number(b)) => a.cmp(b),
        (Truth::Sphere(sphere, far), Truth::Number(t)) => sphere.compare(*far, t),
        (Truth::Number(t), Truth::Sphere(sphere, far)) => sphere.compare(*far, t).reverse(),
        _ => {
            let ((a_lo, a_hi), (b_lo, b_hi)) = (interval(a), interval(b));
            if a_hi < b_lo {
                Ordering::Less
            } else if b_hi < a_lo {
                Ordering::Greater
            } else {
                Ordering::Equal
            }
        }
    }
}

/// A surface that the ray meets at about `p`, or exactly there if `p` is a point with few bits.
struct Shapes {
    plane: Plane<f64>,
    triangle: Triangle<f64>,
    aabb: Aabb<f64>,
    face: u32,
    sphere: Sphere<f64>,
}

impl Shapes {
    fn at(g: &mut Random, p: DVec3, integers: bool) -> Shapes {
        let vector = |g: &mut Random| if integers { g.small_integers() } else { g.point(1.0) };
        let n = vector(g);
        let (u, v) = (vector(g), vector(g));
        let face = g.below(6) as u32;
        let (k, corner) = (face as usize / 2, vector(g).abs());
        let (mut min, mut max) = (p - corner, p + corner);
        (if face.is_multiple_of(2) { &mut min } else { &mut max })[k] = p[k];
        // With integers: an offset of integer length, so that the radius is exact.
        let (offset, radius) = if integers {
            let triples =
                [([1.0, 2.0, 2.0], 3.0), ([0.0, 3.0, 4.0], 5.0), ([1.0, 0.0, 0.0], 1.0), ([2.0, 3.0, 6.0], 7.0)];
            let (offset, radius) = triples[g.below(4)];
            let scale = 1.0 + g.below(3) as f64;
            let turn = g.below(3);
            let flip = g.vector(|g| if g.one_in(2) { scale } else { -scale });
            (flip * DVec3::from_array([0, 1, 2].map(|k| offset[(k + turn) % 3])), scale * radius)
        } else {
            let v = g.point(2.0);
            (v, v.length())
        };
        Shapes {
            plane: Plane { normal: stored::<f64>(n), distance: n.dot(p) },
            triangle: Triangle { vertices: [p, p + u, p + v].map(stored::<f64>) },
            aabb: Aabb { min: stored::<f64>(min), max: stored::<f64>(max) },
            face,
            sphere: Sphere { center: stored::<f64>(p + offset), radius },
        }
    }

    fn roots(&self) -> [Root<'_, f64>; 5] {
        [
            Root::Plane(&self.plane),
            Root::Triangle(&self.triangle),
            Root::BoxFace(&self.aabb, self.face),
            Root::SphereNear(&self.sphere),
            Root::SphereFar(&self.sphere),
        ]
    }
}

#[test]
fn order_is_that_of_rational_arithmetic() {
    let mut random = Random::new(23);
    let g = &mut random;
    let (mut seen, mut ties, mut sphere_ties) = (0, 0, 0);
    for i in 0..1500 {
        let integers = i % 3 != 0;
        let vector = |g: &mut Random| if integers { g.small_integers() } else { rounded::<f64>(g.point(1.0)) };
        let (o, d) = (vector(g), vector(g));
        if d == DVec3::ZERO {
            continue;
        }
        let ray = Ray::<f64> { origin: stored::<f64>(o), direction: stored::<f64>(d) };
        let t = if integers { g.below(5) as f64 } else { 3.0 * g.unit() };
        let p = o + d * t;
        let (a, b) = (Shapes::at(g, p, integers), Shapes::at(g, p, integers));
        for x in a.roots() {
            let Some(truth_x) = truth(&ray, x) else { continue };
            for number in [0.0, t, t + 1e-16] {
                let expected = compare(&truth_x, &Truth::Number(q(number)));
                assert_eq!(compare_t_with(&ray, x, number), expected, "{ray:?} {x:?} {number}");
            }
            assert_eq!(compare_t_with(&ray, x, f64::NEG_INFINITY), Ordering::Greater);
            for y in b.roots().into_iter().chain(a.roots()) {
                let Some(truth_y) = truth(&ray, y) else { continue };
                let expected = compare(&truth_x, &truth_y);
                assert_eq!(compare_t(&ray, x, y), expected, "{ray:?} {x:?} {y:?}");
                seen += 1;
                if expected == Ordering::Equal {
                    ties += 1;
                    let spheres = matches!(x, Root::SphereNear(_) | Root::SphereFar(_))
                        && matches!(y, Root::SphereNear(_) | Root::SphereFar(_));
                    sphere_ties += usize::from(spheres);
                }
            }
        }
    }
    println!("{seen} comparisons, {ties} ties, {sphere_ties} of them between spheres");
    assert!(ties > 5000 && sphere_ties > 1000);
}

/// Spheres that share a circle: every ray through the circle meets both at one irrational `t`.
#[test]
fn irrational_ties_between_spheres() {
    let mut random = Random::new(29);
    let g = &mut random;
    let mut ties = 0;
    for _ in 0..800 {
        // Unit circle in z = 0: centres on the z axis, radius^2 = 1 + z^2 with z = 3/4, 4/3 (not exact), 0, -3/4.
        let sphere = |z: f64, r: f64| Sphere { center: glam::dvec3(0.0, 0.0, z), radius: r };
        let spheres =
            [sphere(0.75, 1.25), sphere(-0.75, 1.25), sphere(0.0, 1.0), sphere(2.4, 2.6), sphere(1.875, 2.125)];
        // A ray within z = 0 meets all of them on the circle, if 2.4 and 2.6 were exact, which they are not.
        let (o, d) = (g.point(3.0), g.point(1.0));
        let ray = Ray::<f64> { origin: glam::dvec3(o[0], o[1], 0.0), direction: glam::dvec3(d[0], d[1], 0.0) };
        for a in &spheres {
            for b in &spheres {
                for (x, y) in [
                    (Root::SphereNear(a), Root::SphereNear(b)),
                    (Root::SphereFar(a), Root::SphereFar(b)),
                    (Root::SphereNear(a), Root::SphereFar(b)),
                ] {
                    let (Some(truth_x), Some(truth_y)) = (truth(&ray, x), truth(&ray, y)) else { continue };
                    let expected = compare(&truth_x, &truth_y);
                    assert_eq!(compare_t(&ray, x, y), expected, "{ray:?} {x:?} {y:?}");
                    ties += usize::from(expected == Ordering::Equal && a != b);
                }
            }
        }
    }
    assert!(ties > 1000, "{ties}");
}

/// Coordinates of all sizes, where the squares leave the range of f64.
#[test]
fn order_at_the_ends_of_the_range() {
    let mut random = Random::new(31);
    let g = &mut random;
    let mut seen = 0;
    for i in 0..2000 {
        let wild = |g: &mut Random| g.wild_vector(126);
        let (o, d) = (wild(g), wild(g));
        if d == DVec3::ZERO {
            continue;
        }
        let ray = Ray::<f64> { origin: stored::<f64>(o), direction: stored::<f64>(d) };
        let sphere = |g: &mut Random| {
            // The origin on or near it, or anything.
            let c = if i % 2 == 0 { wild(g) } else { o.lerp(wild(g), 0.5) };
            let largest = (o - c).abs().max_element();
            Sphere::<f64> {
                center: stored::<f64>(c),
                radius: if largest > 0.0 { largest * (1.0 + g.unit()) } else { 1.0 },
            }
        };
        let (a, b) = (sphere(g), sphere(g));
        if a.radius > 2f64.powi(128) || b.radius > 2f64.powi(128) {
            continue;
        }
        let aabb = Aabb { min: stored::<f64>(wild(g)), max: stored::<f64>(wild(g)) };
        let face = g.below(6) as u32;
        let roots = [
            Root::SphereNear(&a),
            Root::SphereFar(&a),
            Root::SphereNear(&b),
            Root::SphereFar(&b),
            Root::BoxFace(&aabb, face),
        ];
        for x in roots {
            for y in roots {
                let (Some(truth_x), Some(truth_y)) = (truth(&ray, x), truth(&ray, y)) else { continue };
                assert_eq!(compare_t(&ray, x, y), compare(&truth_x, &truth_y), "{ray:?} {x:?} {y:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 10_000, "{seen}");
}
