use raytree::kernels::*;
use raytree::numbers::{Real, Stage};

use raytree::accuracy::random::Random;
use raytree::accuracy::referee::{SphereTruth, q, sign};
use raytree::accuracy::sets::SphereSet;

use super::PAIRS;

fn check_set<R: Real>(set: SphereSet, seed: u64) -> [usize; 4] {
    let mut random = Random::new(seed);
    let (mut hits, mut naive, mut stable, mut stages) = (0, 0, 0, [0; 4]);
    for i in 0..PAIRS {
        let (ray, sphere) = set.next::<R>(&mut random);
        let truth = SphereTruth::new(&ray, &sphere);
        let context = || format!("{} {} {i}: {ray:?} {sphere:?}", set.name(), R::PRECISION as u8);
        let roots = sign(&truth.disc) >= 0;
        let (zero, less) = (q(0.0), std::cmp::Ordering::Less);
        let hit = roots && truth.compare(true, &zero) != less;
        let enters = roots && truth.compare(false, &zero) != less;
        for start in [Start::Anywhere, Start::OnSurfaceInward] {
            let far = start == Start::OnSurfaceInward || !enters;
            match intersect_sphere_certified(&ray, &sphere, start) {
                Ok(certified) => {
                    assert!(hit, "false hit, {}", context());
                    let Certified { t, t_error, hit } = certified;
                    assert!(truth.is_within(far, t, t_error), "t {t} +- {t_error} far {far}, {}", context());
                    assert!(t_error <= 1.5e-11 * t, "t_error {t_error} of {t}, {}", context());
                    assert!(hit.t == R::from_f64(t) && hit.t == if far { hit.t_out } else { hit.t_in });
                    let certificate = certify_sphere(&ray, &sphere, start);
                    assert!((certificate.margin > 1.0) == (certificate.stage == Stage::Filter), "{certificate:?}");
                    assert!(certificate.margin.is_finite(), "{certificate:?} {}", context());
                    if start == Start::Anywhere {
                        stages[certificate.stage as usize] += 1;
                    }
                }
                Err(Miss::NegativeDiscriminant) => assert!(!roots, "false miss, {}", context()),
                Err(Miss::Behind) => assert!(roots && !hit, "false miss, {}", context()),
                Err(miss) => panic!("{miss:?}, {}", context()),
            }
            let exact = intersect_sphere_exact(&ray, &sphere, start);
            assert_eq!(exact.is_ok(), hit, "exact, {}", context());
        }
        hits += usize::from(hit);
        naive += usize::from(intersect_sphere_naive(&ray, &sphere, Start::Anywhere).is_ok() != hit);
        stable += usize::from(intersect_sphere_stable(&ray, &sphere, Start::Anywhere).is_ok() != hit);
    }
    let ppm = |wrong: usize| wrong * 1_000_000 / PAIRS;
    println!(
        "{:26} {:?} hits {hits:5} stages of hits {stages:?} | wrong ppm: naive {} stable {} certified 0",
        set.name(),
        R::PRECISION,
        ppm(naive),
        ppm(stable)
    );
    [naive, stable, hits, stages[3]]
}

#[test]
fn certified_verdicts_are_those_of_rational_arithmetic() {
    for set in SphereSet::ALL {
        let [_, stable, ..] = check_set::<f64>(set, 5);
        let [naive_f32, ..] = check_set::<f32>(set, 6);
        match set {
            SphereSet::Grazing => assert!(stable > PAIRS / 100, "grazing is not hard"),
            SphereSet::Far => assert!(naive_f32 > PAIRS / 100, "far is not hard"),
            _ => {}
        }
    }
}
