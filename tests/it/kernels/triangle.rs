use raytree::kernels::*;
use raytree::numbers::{Real, Stage, Vector3};

use raytree::accuracy::random::{Random, rounded, stored};
use raytree::accuracy::referee::{self, TriangleTruth, is_within, sign};
use raytree::accuracy::sets::TriangleSet;

use super::PAIRS;

/// Whether the reason is a true one.
fn is_true<R: Real>(miss: Miss, ray: &Ray<R>, triangle: &Triangle<R>) -> bool {
    let truth = TriangleTruth::new(ray, triangle);
    match (miss, &truth) {
        (Miss::Parallel, None) => true,
        (Miss::Behind, Some(truth)) => truth.t_sign() < 0,
        (Miss::AIsNegative, Some(truth)) => truth.weight_signs[0] < 0,
        (Miss::BIsNegative, Some(truth)) => truth.weight_signs[1] < 0,
        (Miss::SumExceedsOne, Some(truth)) => truth.weight_signs[2] < 0,
        _ => false,
    }
}

#[derive(Default)]
struct Tally {
    hits: usize,
    stages: [usize; 4],
    lecture: usize,
    moller_trumbore: usize,
    watertight: usize,
}

fn check_set<R: Real>(set: TriangleSet, seed: u64) -> Tally {
    let mut tally = Tally::default();
    let mut random = Random::new(seed);
    for i in 0..PAIRS {
        let (ray, triangle) = set.next::<R>(&mut random);
        let truth = TriangleTruth::new(&ray, &triangle);
        let hit = truth.as_ref().is_some_and(TriangleTruth::is_hit);
        // Every other one with bounds as of a larger mesh.
        let filter = if i % 2 == 0 {
            TriangleFilter::of_triangle(&ray, &triangle)
        } else {
            let Aabb { min, max } = Aabb::<R>::of_points(&triangle.vertices);
            let (min, max) = (min.to_f64().map(|x| x - x.abs()), max.to_f64().map(|x| x + x.abs()));
            let bounds = Aabb { min: R::Vec3::from_f64(min), max: R::Vec3::from_f64(max) };
            TriangleFilter::new(&ray, &bounds, 3.0 * longest_edge(&triangle))
        };
        let context = || format!("{} {} {i}: {ray:?} {triangle:?}", set.name(), R::PRECISION as u8);
        match intersect_triangle_certified(&ray, &triangle, &filter) {
            Ok(certified) => {
                assert!(hit, "false hit, {}", context());
                let TriangleTruth { t_numerator, denominator, .. } = truth.as_ref().unwrap();
                let Certified { t, t_error, hit } = certified;
                assert!(is_within(t, t_error, t_numerator, denominator), "t {t} +- {t_error}, {}", context());
                assert!(t_error <= 1.5e-11 * t, "t_error {t_error} of {t}, {}", context());
                assert!(hit.t == R::from_f64(t));
                let [a, b, c] = hit.barycentrics.map(|x| x.to_f64());
                assert!(a >= 0.0 && b >= 0.0 && c >= 0.0, "{}", context());
                assert!((a + b + c - 1.0).abs() < 1e-5, "{a} {b} {c}, {}", context());
            }
            Err(miss) => {
                assert!(!hit, "false miss, {}", context());
                assert!(is_true(miss, &ray, &triangle), "{miss:?}, {}", context());
            }
        }
        assert_eq!(intersect_triangle_exact(&ray, &triangle).is_ok(), hit, "exact, {}", context());
        if hit {
            let certificate = certify_triangle(&ray, &triangle);
            assert!(
                certificate.margin.is_finite() && (certificate.margin > 1.0) == (certificate.stage == Stage::Filter)
            );
            let on_edge = truth.as_ref().unwrap().weight_signs.contains(&0) || truth.as_ref().unwrap().t_sign() == 0;
            assert_eq!(certificate.margin == 0.0, on_edge, "{certificate:?}, {}", context());
            tally.stages[certificate.stage as usize] += 1;
            tally.hits += 1;
        }
        tally.lecture += usize::from(intersect_triangle_lecture(&ray, &triangle).is_ok() != hit);
        tally.moller_trumbore += usize::from(intersect_triangle_moller_trumbore(&ray, &triangle).is_ok() != hit);
        tally.watertight += usize::from(intersect_triangle_watertight(&ray, &triangle).is_ok() != hit);
    }
    let ppm = |wrong: usize| wrong * 1_000_000 / PAIRS;
    println!(
        "{:26} {:?} hits {:5} stages of hits {:?} | wrong ppm: lecture {} Moller-Trumbore {} watertight {} certified 0",
        set.name(),
        R::PRECISION,
        tally.hits,
        tally.stages,
        ppm(tally.lecture),
        ppm(tally.moller_trumbore),
        ppm(tally.watertight)
    );
    tally
}

#[test]
fn certified_verdicts_are_those_of_rational_arithmetic_f64() {
    let mut stages = [0; 4];
    for set in TriangleSet::ALL {
        let tally = check_set::<f64>(set, 1);
        if matches!(set, TriangleSet::Edge | TriangleSet::Vertex) {
            assert!(tally.moller_trumbore > PAIRS / 10, "{set:?} is not hard");
        }
        stages = std::array::from_fn(|k| stages[k] + tally.stages[k]);
    }
    assert!(stages.iter().all(|count| *count > 100), "a stage was hardly tried: {stages:?}");
}

#[test]
fn certified_verdicts_are_those_of_rational_arithmetic_f32() {
    for set in TriangleSet::ALL {
        let tally = check_set::<f32>(set, 2);
        if matches!(set, TriangleSet::Edge | TriangleSet::Vertex | TriangleSet::Needles) {
            assert!(tally.moller_trumbore > PAIRS / 100 && tally.watertight > PAIRS / 100, "{set:?} is not hard");
        }
    }
}

#[test]
fn coplanar_is_decided_exactly() {
    let volume_is_zero = |a: &Triangle<f64>, b: &Triangle<f64>| {
        let v = a.vertices.map(referee::vector::<f64>);
        let n = referee::cross(&referee::subtract(&v[1], &v[0]), &referee::subtract(&v[2], &v[0]));
        b.vertices.iter().all(|p| sign(&referee::dot(&n, &referee::subtract(&referee::vector::<f64>(*p), &v[0]))) == 0)
    };
    let mut g = Random::new(3);
    let (mut coplanar, mut count) = (0, 0);
    for i in 0..20_000 {
        let integers = i % 2 == 0;
        let a: [_; 3] = std::array::from_fn(|_| if integers { g.small_integers() } else { g.point(1.0) });
        // In the plane of a: exactly with integers (if not by way of a rounded mix), nearly otherwise.
        let b: [_; 3] = std::array::from_fn(|_| {
            let (x, y) = if integers {
                (g.below(7) as f64 - 3.0, g.below(7) as f64 - 3.0)
            } else {
                (2.0 * g.signed(), 2.0 * g.signed())
            };
            let p = a[0] + (a[1] - a[0]) * x + (a[2] - a[0]) * y;
            if g.below(8) == 0 { g.point(1.0) } else { rounded::<f64>(p) }
        });
        let (a, b) = (Triangle { vertices: a.map(stored::<f64>) }, Triangle { vertices: b.map(stored::<f64>) });
        let truth = volume_is_zero(&a, &b) && volume_is_zero(&b, &a);
        assert_eq!(are_coplanar(&a, &b), truth, "{a:?} {b:?}");
        assert_eq!(are_coplanar(&b, &a), truth, "{a:?} {b:?}");
        coplanar += usize::from(truth);
        count += 1;
    }
    assert!(coplanar > 1000 && coplanar < count - 1000, "{coplanar} of {count}");
}
