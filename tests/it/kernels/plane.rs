use raytree::kernels::*;
use raytree::numbers::{Real, Stage};

use raytree::accuracy::random::Random;
use raytree::accuracy::referee::{self, is_within, sign};
use raytree::accuracy::sets::PlaneSet;

use super::PAIRS;

fn check_set<R: Real>(set: PlaneSet) -> usize {
    let mut random = Random::new(17);
    let (mut hits, mut lecture, mut parallel) = (0, 0, 0);
    for _ in 0..PAIRS {
        let (ray, plane) = set.next::<R>(&mut random);
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
        "{:26} {:?} hits {hits:5} parallel {parallel} | wrong ppm: lecture {} certified 0",
        set.name(),
        R::PRECISION,
        lecture * 1_000_000 / PAIRS
    );
    lecture
}

#[test]
fn certified_verdicts_are_those_of_rational_arithmetic() {
    for set in PlaneSet::ALL {
        let wrong = [check_set::<f64>(set), check_set::<f32>(set)];
        if matches!(set, PlaneSet::Parallel | PlaneSet::FromPlane) {
            assert!(wrong.iter().all(|count| *count > PAIRS / 200), "{set:?} is not hard");
        }
    }
}
