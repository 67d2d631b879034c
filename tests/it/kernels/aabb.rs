use raytree::kernels::*;
use raytree::numbers::{Real, Stage};

use raytree::accuracy::random::Random;
use raytree::accuracy::referee::{box_hit, box_span, is_within, q};
use raytree::accuracy::sets::{BoxSet, box_lattice};

use super::PAIRS;

fn check<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> bool {
    let truth = box_hit(ray, aabb);
    match (intersect_box_certified(ray, aabb, Start::Anywhere), &truth) {
        (Ok(Certified { hit, t, t_error }), Some((face, exact))) => {
            assert!(is_within(t, t_error, exact, &q(1.0)), "{t} +- {t_error}: {ray:?} {aabb:?}");
            assert!(t_error <= 1e-15 * t && hit.t == R::from_f64(t));
            assert_eq!(hit.face, *face, "{ray:?} {aabb:?}");
            let certificate = certify_box(ray, aabb, Start::Anywhere);
            assert!((certificate.margin > 1.0) == (certificate.stage == Stage::Filter), "{certificate:?}");
        }
        (Err(Miss::SlabsDisjoint), None) => {
            assert!(box_span(ray, aabb).is_none_or(|(enter, leave)| enter.1 > leave.1), "{ray:?} {aabb:?}");
        }
        (Err(Miss::Behind), None) => assert!(box_span(ray, aabb).unwrap().1.1 < q(0.0), "{ray:?} {aabb:?}"),
        (certified, _) => panic!("{certified:?}: {ray:?} {aabb:?}"),
    }
    // From the surface inward: where the line leaves, whatever else.
    let inward = intersect_box_certified(ray, aabb, Start::OnSurfaceInward);
    if let Some((_, (face, exact))) = box_span(ray, aabb) {
        assert_eq!(inward.is_ok(), exact >= q(0.0), "{ray:?} {aabb:?}");
        if let Ok(Certified { hit, t, t_error }) = inward {
            assert!(is_within(t, t_error, &exact, &q(1.0)) && hit.face == face, "{ray:?} {aabb:?}");
        }
    }
    truth.is_some()
}

#[test]
fn small_integer_lattice() {
    let cases: Vec<(Ray<f64>, Aabb<f64>)> = box_lattice().collect();
    assert_eq!(cases.len(), 21_000);
    let (mut lecture, mut explicit_zero) = (0, 0);
    for (ray, aabb) in &cases {
        let hit = check(ray, aabb);
        lecture += usize::from(intersect_box_lecture(ray, aabb, Start::Anywhere).is_ok() != hit);
        explicit_zero += usize::from(intersect_box_explicit_zero(ray, aabb, Start::Anywhere).is_ok() != hit);
    }
    // The lecture's text divides 0 by 0.
    assert_eq!((lecture, explicit_zero), (1128, 0));
}

fn check_set<R: Real>(set: BoxSet) {
    let mut random = Random::new(11);
    let (mut hits, mut plain) = (0, 0);
    for _ in 0..PAIRS {
        let (ray, aabb) = set.next::<R>(&mut random);
        let hit = check(&ray, &aabb);
        hits += usize::from(hit);
        plain += usize::from(intersect_box_explicit_zero(&ray, &aabb, Start::Anywhere).is_ok() != hit);
    }
    let ppm = plain * 1_000_000 / PAIRS;
    println!("{:26} {:?} hits {hits:5} | wrong ppm: plain {ppm} certified 0", set.name(), R::PRECISION);
    if matches!(set, BoxSet::Edge | BoxSet::Corner) {
        assert!(plain > PAIRS / 100, "{set:?} is not hard");
    }
}

#[test]
fn certified_verdicts_are_those_of_rational_arithmetic() {
    for set in BoxSet::ALL {
        check_set::<f64>(set);
        check_set::<f32>(set);
    }
}
