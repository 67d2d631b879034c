use raytree::kernels::*;
use raytree::numbers::{Real, Stage};

use super::referee::{self, is_within, sign};
use super::sets::{P, Random, rounded, stored};

fn check_set<R: Real>(set: &str, count: usize) -> usize {
    let mut random = Random::new(17);
    let g = &mut random;
    let (mut hits, mut lecture, mut parallel) = (0, 0, 0);
    for _ in 0..count {
        let (n, o): (P, P) = match set {
            "small integers" => (g.small_integers(), g.small_integers()),
            "exponents to 126" => (std::array::from_fn(|_| g.wild(126)), std::array::from_fn(|_| g.wild(126))),
            _ => (rounded::<R>(g.point(1.0)), rounded::<R>(g.point(100.0))),
        };
        let n_dot = |v: P| -> f64 { (0..3).map(|k| n[k] * v[k]).sum() };
        let d: P = match set {
            "small integers" => g.small_integers(),
            "exponents to 126" => std::array::from_fn(|_| g.wild(126)),
            // Across the normal but for rounding; (y, -x, 0) exactly so.
            "parallel" if g.below(4) == 0 => [n[1], -n[0], 0.0],
            "parallel" => {
                let v = g.point(1.0);
                [n[1] * v[2] - n[2] * v[1], n[2] * v[0] - n[0] * v[2], n[0] * v[1] - n[1] * v[0]]
            }
            _ => g.point(1.0),
        };
        let distance = match set {
            "small integers" => g.below(9) as f64 - 4.0,
            "exponents to 126" => g.wild(126),
            "origin on the plane" => n_dot(o),
            _ => g.signed(),
        };
        let ray = Ray::<R> { origin: stored::<R>(o), direction: stored::<R>(d) };
        let plane = Plane { normal: stored::<R>(n), distance: R::from_f64(distance) };
        let (n_dot_d, height) = referee::plane(&ray, &plane);
        let is_parallel = sign(&n_dot_d) == 0;
        let hit = !is_parallel && sign(&n_dot_d) * sign(&height) >= 0;
        match intersect_plane_certified(&ray, &plane) {
            Ok(Certified { hit: plane_hit, t, t_error }) => {
                assert!(hit, "false hit, {ray:?} {plane:?}");
                assert!(is_within(t, t_error, &height, &n_dot_d), "{t} +- {t_error}, {ray:?} {plane:?}");
                assert!(t_error <= 1.5e-11 * t && plane_hit.t == R::from_f64(t));
                let certificate = certify_plane(&ray, &plane);
                assert!((certificate.margin > 1.0) == (certificate.stage == Stage::Filter), "{certificate:?}");
                hits += 1;
            }
            Err(Miss::Parallel) => assert!(is_parallel, "{ray:?} {plane:?}"),
            Err(Miss::Behind) => assert!(!is_parallel && !hit, "{ray:?} {plane:?}"),
            Err(miss) => panic!("{miss:?}, {ray:?} {plane:?}"),
        }
        lecture += usize::from(intersect_plane_lecture(&ray, &plane).is_ok() != hit);
        parallel += usize::from(is_parallel);
    }
    println!(
        "{set:26} {:?} hits {hits:5} parallel {parallel} | wrong ppm: lecture {} certified 0",
        R::PRECISION,
        lecture * 1_000_000 / count
    );
    lecture
}

#[test]
fn certified_verdicts_are_those_of_rational_arithmetic() {
    for set in ["random", "small integers", "parallel", "origin on the plane", "exponents to 126"] {
        let wrong = [check_set::<f64>(set, 20_000), check_set::<f32>(set, 20_000)];
        if matches!(set, "parallel" | "origin on the plane") {
            assert!(wrong.iter().all(|count| *count > 100), "{set} is not hard");
        }
    }
}
