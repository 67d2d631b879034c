use raytree::kernels::optics::{fresnel_exact, fresnel_schlick, transmitted_cosine, transmitted_cosine_usual};
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

/// Rows F01 to F08 of the hard cases: eta, cosine, the exact transmitted cosine, and whether the usual f32 form gets
/// the verdict right.
#[test]
fn rows_f_at_the_critical_angle() {
    let up = |n: i32| 1.0f32 + 2f32.powi(-n);
    let rows = [
        ("F01", 1.5, 0x3f3e_cfa6, None, true),
        ("F02", 1.5, 0x3f3e_cfa7, Some(3.214740047e-4), true),
        ("F03", 1.33, 0x3f28_c7e8, None, true),
        ("F03", 1.33, 0x3f28_c7e9, Some(2.847338850e-4), true),
        ("F04", 2.42, 0x3f69_1f08, None, true),
        ("F05", 2.42, 0x3f69_1f09, Some(1.065081606e-4), false),
        ("F06", up(23), 0x39ff_fffe, None, false),
        ("F07", up(23), 0x39ff_ffff, Some(1.192092789e-7), true),
        ("F08", up(20), 0x3ab5_04ea, None, false),
        ("F08", up(20), 0x3ab5_04eb, Some(3.012581513e-7), true),
    ];
    for (id, eta, bits, expected, usual_is_right) in rows {
        let c = f32::from_bits(bits);
        let cosine = transmitted_cosine(eta, c);
        assert_eq!(cosine.is_some(), expected.is_some(), "{id}");
        if let (Some(cosine), Some(expected)) = (cosine, expected) {
            let error: f64 = (f64::from(cosine) - expected).abs();
            assert!(error <= 1.2e-7 * expected, "{id} {cosine}");
        }
        let usual = transmitted_cosine_usual(eta, c);
        assert_eq!(usual.is_some() == expected.is_some(), usual_is_right, "{id}: {usual:?}");
    }
}

/// Rows F09 to F19.
#[test]
fn rows_f_of_refraction_and_fresnel() {
    let mut g = Random::new(47);
    for _ in 0..10_000 {
        // F09: equal indices copy the direction, straight on it is kept (F10).
        let (d, n) = (g.point(1.0), g.direction());
        let index = 1.0 + g.unit();
        assert_eq!(refract::<f64>(d, n, index, index), Some(d));
        assert_eq!(refract::<f64>(-n, n, 1.0, index), Some(-n));
        let (d, n) = (d.as_vec3(), n.as_vec3());
        assert_eq!(refract::<f32>(d, n, 1.5, 1.5), Some(d));
        assert_eq!(refract::<f32>(-n, n, 1.0, 1.5), Some(-n));
    }
    let cosine = |eta: f64, c: f64| transmitted_cosine(eta, c).unwrap();
    let reflectance = |n: f64, c: f64| fresnel_exact(c, cosine(1.0 / n, c), 1.0, n);
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
    close(fresnel_exact(1.0, 1.0, 1.0, 1.5), 0.04);
    close(cosine(1.0 / 1.5, 0.5), 0.816_496_580_927_726);
    close(reflectance(1.5, 0.5), 0.089_186_712_802_213);
    close(cosine(1.0 / 1.5, 0.0), 0.745_355_992_499_930);
    assert_eq!(reflectance(1.5, 0.0), 1.0);
    let brewster = f64::from(0.554_700_2_f32);
    close(reflectance(1.5, brewster), 0.073_964_497_144_749);
    close(cosine(1.0 / f64::from(1.33f32), f64::from(0.01f32)), 0.659_343_223_703_218);
    close(reflectance(f64::from(1.33f32), f64::from(0.01f32)), 0.938_940_905_271_822);
    // F16: a cosine above 1.
    assert_eq!(transmitted_cosine(1.5f32, 1.000_000_1), Some(1.0));
    assert!(fresnel_schlick(1.000_000_1f32, 1.0, 1.0, 1.5) >= 0.0);
    // F17.
    for _ in 0..100_000 {
        let (eta, c) = (2f64.powf(6.0 * g.unit() - 3.0) as f32, g.unit() as f32);
        if let Some(transmitted) = transmitted_cosine(eta, c) {
            for r in [fresnel_exact(c, transmitted, eta, 1.0), fresnel_schlick(c, transmitted, eta, 1.0)] {
                assert!((0.0..=1.0).contains(&r), "{eta} {c}: {r}");
                assert!((r + (1.0 - r) - 1.0).abs() <= f32::EPSILON);
            }
        }
    }
    // F18: a parallel slab.
    for _ in 0..10_000 {
        let mut d = g.direction();
        d.y = -d.y.abs();
        let n = glam::DVec3::Y;
        let inside = refract::<f64>(d, n, 1.0, 1.5).unwrap();
        let after = refract::<f64>(inside, n, 1.5, 1.0).unwrap();
        // The direction inside is rounded by u; what that does to the cosine outside grows towards grazing.
        let error = (after - d).abs();
        assert!(error.x.max(error.z) <= 2.0 * f64::EPSILON, "{d} {after}");
        assert!(error.y <= 2.0 * f64::EPSILON / d.y.abs(), "{d} {after}");
    }
}
