use raytree::kernels::optics::{transmitted_cosine, transmitted_cosine_usual};
use raytree::kernels::*;
use raytree::numbers::{Real, Stage, Vector3};

use raytree::accuracy::random::Random;
use raytree::accuracy::referee::{dot, q, sign, transmission, vector};
use raytree::accuracy::sets::{Crossing, OpticsSet};

use super::PAIRS;

fn check<R: Real>(seed: u64) {
    let g = &mut Random::new(seed);
    let (mut usual, mut total, mut stages) = (0, 0, [0; 4]);
    let mut worst = 0.0f64;
    for set in (0..PAIRS).map(|i| OpticsSet::ALL[i % 3]) {
        let Crossing { direction: d, normal: n, incident, transmitted } = set.next::<R>(g);
        let s = transmission::<R>(d, n, incident, transmitted);
        let is_total = sign(&s) < 0;
        let context = || format!("{d:?} {n:?} {incident} {transmitted}");
        assert_eq!(is_total_reflection(d, n, incident, transmitted), is_total, "{}", context());
        let certificate = certify_total_reflection(d, n, incident, transmitted);
        assert!((certificate.margin > 1.0) == (certificate.stage == Stage::Filter), "{certificate:?}");
        stages[certificate.stage as usize] += 1;
        total += usize::from(is_total);

        let refracted = refract(d, n, incident, transmitted);
        assert_eq!(refracted.is_none(), is_total && incident != transmitted, "{}", context());
        let cosines = raytree::kernels::refraction_cosines(d, n, incident, transmitted);
        assert_eq!(cosines.is_none(), refracted.is_none(), "{}", context());
        if let (Some([_, cos_transmitted]), true) = (cosines, incident != transmitted) {
            // cos_t^2 = S / (n_t^2 |d|^2 |n|^2).
            let (d, n, n_t) = (vector::<R>(d), vector::<R>(n), q(transmitted.to_f64()));
            let exact = (&s / (&n_t * &n_t * dot(&d, &d) * dot(&n, &n))).to_f64().value().sqrt();
            let u = R::UNIT_ROUNDOFF.to_f64() + 40.0 * f64::EPSILON;
            assert!(
                (cos_transmitted.to_f64() - exact).abs() <= 2.0 * u * exact,
                "{cos_transmitted} {exact} {}",
                context()
            );
        }
        if let Some(refracted) = refracted {
            // Compared with the stored normal scaled to unit length, in f64.
            let (d, n, r) = (vector_f64::<R>(d), vector_f64::<R>(n), vector_f64::<R>(refracted));
            let eta = incident.to_f64() / transmitted.to_f64();
            assert!(r.is_finite(), "{}", context());
            let bound = 16.0 * R::UNIT_ROUNDOFF.to_f64() * (1.0 + eta) * d.length();
            assert!((r.length() - d.length()).abs() <= 2.0 * bound, "{} {} {}", r.length(), d.length(), context());
            // Snell: the parts along the surface.
            let along = |v: glam::DVec3| v - n * (v.dot(n) / n.dot(n));
            assert!((along(r) - along(d) * eta).length() <= 2.0 * bound, "{}", context());
            if sign(&s) > 0 && n.x == 0.0 && n.z == 0.0 && d.dot(n) < 0.0 && incident != transmitted {
                // The transmitted cosine, which here is a component.
                let exact = s.to_f64().value().sqrt() / (transmitted.to_f64() * n.length());
                worst = worst.max((r.y.abs() - exact).abs() / (d.length() * R::UNIT_ROUNDOFF.to_f64()));
            }
        }

        // The usual form on a rounded cosine and eta.
        let (d, n) = (vector_f64::<R>(d), vector_f64::<R>(n));
        let c = R::from_f64(d.dot(n).abs() / (d.length() * n.length()));
        let eta = incident / transmitted;
        usual += usize::from(transmitted_cosine_usual(eta, c).is_none() != is_total);
    }
    println!(
        "total reflection {:?}: {total} of {PAIRS}, stages {stages:?}, usual form wrong {usual}, \
         component off by at most {worst:.1} u |d|",
        R::PRECISION
    );
    assert!(usual > PAIRS / 100, "not hard");
    assert!(stages[Stage::Expansion as usize] > 100 && total > PAIRS / 10);
}

fn vector_f64<R: Real>(v: R::Vec3) -> glam::DVec3 {
    glam::DVec3::from_array(v.to_f64())
}

#[test]
fn total_reflection_is_decided_exactly() {
    check::<f64>(41);
    check::<f32>(42);
}

fn check_cosine<R: Real>(count: usize, seed: u64) -> usize {
    let mut random = Random::new(seed);
    let g = &mut random;
    let mut usual = 0;
    for i in 0..count {
        let eta = if i % 2 == 0 { 1.0 + 2.0 * g.unit() } else { 1.0 + 2f64.powi(-(g.below(23) as i32)) };
        let eta = R::from_f64(eta);
        let critical = (1.0 - 1.0 / (eta.to_f64() * eta.to_f64())).sqrt();
        let c = g.nudge(R::from_f64(critical), 4).smaller(R::ONE);
        let (e, x) = (q(eta.to_f64()), q(c.to_f64()));
        let k = q(1.0) - &e * &e * (q(1.0) - &x * &x);
        let cosine = transmitted_cosine(eta, c);
        assert_eq!(cosine.is_none(), sign(&k) < 0, "{eta} {c}");
        if let Some(cosine) = cosine {
            let exact = k.to_f64().value().sqrt();
            assert!((cosine.to_f64() - exact).abs() <= 4.0 * R::UNIT_ROUNDOFF.to_f64() * exact, "{eta} {c}");
        }
        usual += usize::from(transmitted_cosine_usual(eta, c).is_none() != (sign(&k) < 0));
    }
    usual
}

#[test]
fn transmitted_cosine_is_exact_where_the_usual_form_is_not() {
    let wrong = [check_cosine::<f64>(20_000, 43), check_cosine::<f32>(20_000, 44)];
    println!("usual form wrong of 20000, f64 and f32: {wrong:?}");
    assert!(wrong.iter().all(|count| *count > 1000));
}
