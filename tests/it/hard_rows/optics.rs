//! Rows F: total reflection, refraction and Fresnel reflectance, on f32 numbers.
//!
//! `eta = n_i / n_t`, `c` the cosine of incidence, `k = 1 - eta^2 (1 - c^2)`: negative is total reflection, its root the
//! transmitted cosine.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};
use raytree::accuracy::random::Random;
use raytree::accuracy::referee::q;
use raytree::accuracy::sets::{Crossing, OpticsSet};
use raytree::kernels::optics::{
    fresnel_exact, fresnel_schlick, reflect, refract, transmitted_cosine, transmitted_cosine_usual,
};
use raytree::numbers::Real;
use raytree::tree::RayNode;

use crate::support::{ray_tree, small_scene};

/// The usual form in f32.
fn usual_k(eta: f32, c: f32) -> f32 {
    1.0 - eta * eta * (1.0 - c * c)
}

/// The true `k`, from rationals.
fn true_k(eta: f32, c: f32) -> f64 {
    let [eta, c] = [eta, c].map(|x| q(f64::from(x)));
    (q(1.0) - &eta * &eta * (q(1.0) - &c * &c)).to_f64().value()
}

fn is_near(x: f64, y: f64, relative: f64) {
    assert!((x - y).abs() <= relative * y.abs(), "{x} is not {y}");
}

/// Both kernels say total reflection.
fn is_total(eta: f32, bits: u32) {
    let c = f32::from_bits(bits);
    assert_eq!(transmitted_cosine(eta, c), None);
    assert_eq!(transmitted_cosine(f64::from(eta), f64::from(c)), None);
    assert!(true_k(eta, c) < 0.0);
}

/// Both kernels transmit, with this cosine and reflectance.
fn transmits(eta: f32, bits: u32, cosine: f64, reflectance: f64) {
    let c = f32::from_bits(bits);
    let narrow = transmitted_cosine(eta, c).unwrap();
    is_near(f64::from(narrow), cosine, 1.2e-7);
    is_near(f64::from(fresnel_exact(c, narrow, eta, 1.0)), reflectance, 1.2e-7);
    let (eta, c) = (f64::from(eta), f64::from(c));
    let wide = transmitted_cosine(eta, c).unwrap();
    is_near(wide, cosine, 1e-9);
    is_near(fresnel_exact(c, wide, eta, 1.0), reflectance, 1e-9);
}

/// `1 + 2^-n`.
fn just_above_one(n: u32) -> f32 {
    1.0 + 1.0 / (1_u32 << n) as f32
}

#[test]
fn f01_glass_just_beyond_the_critical_angle() {
    is_total(1.5, 0x3f3e_cfa6);
    is_near(true_k(1.5, f32::from_bits(0x3f3e_cfa6)), -9.657452e-8, 1e-6);
}

#[test]
fn f02_glass_just_before_the_critical_angle() {
    transmits(1.5, 0x3f3e_cfa7, 3.214740047e-4, 0.998133025);
    is_near(true_k(1.5, f32::from_bits(0x3f3e_cfa7)), 1.033455e-7, 1e-6);
}

#[test]
fn f03_water_on_both_sides_of_the_critical_angle() {
    assert_eq!(1.33_f32.to_bits(), 0x3faa_3d71);
    is_total(1.33, 0x3f28_c7e8);
    transmits(1.33, 0x3f28_c7e9, 2.847338850e-4, 0.998203526);
}

#[test]
fn f04_diamond_just_beyond_the_critical_angle() {
    assert_eq!(2.42_f32.to_bits(), 0x401a_e148);
    is_total(2.42, 0x3f69_1f08);
    is_near(true_k(2.42, f32::from_bits(0x3f69_1f08)), -6.244e-7, 1e-3);
}

#[test]
fn f05_diamond_just_before_the_critical_angle() {
    transmits(2.42, 0x3f69_1f09, 1.065081606e-4, 0.999337577);
    let c = f32::from_bits(0x3f69_1f09);
    is_near(true_k(2.42, c), 1.134399e-8, 1e-6);
    // The usual form in f32 says total reflection.
    assert_eq!(usual_k(2.42, c), -f32::EPSILON);
    assert_eq!(transmitted_cosine_usual(2.42_f32, c), None);
}

#[test]
fn f06_nearly_equal_indices_beyond_the_critical_angle() {
    let eta = just_above_one(23);
    is_total(eta, 0x39ff_fffe);
    let c = f32::from_bits(0x39ff_fffe);
    is_near(true_k(eta, c), -1.421e-14, 1e-3);
    // The usual form in f32 transmits, straight along the surface.
    assert_eq!(usual_k(eta, c), 0.0);
    assert_eq!(transmitted_cosine_usual(eta, c), Some(0.0));
}

#[test]
fn f07_nearly_equal_indices_before_the_critical_angle() {
    transmits(just_above_one(23), 0x39ff_ffff, 1.192092789e-7, 0.999023914);
}

#[test]
fn f08_indices_an_eighth_of_a_millionth_apart() {
    let eta = just_above_one(20);
    is_total(eta, 0x3ab5_04ea);
    transmits(eta, 0x3ab5_04eb, 3.012581513e-7, 0.999127843);
    // The usual form in f32 transmits where it should not.
    let c = f32::from_bits(0x3ab5_04ea);
    assert_eq!(usual_k(eta, c), 0.0);
    assert_eq!(transmitted_cosine_usual(eta, c), Some(0.0));
}

/// GLSL's refract between equal indices, in f32.
fn glsl(d: Vec3, n: Vec3, k: impl Fn(f32) -> f32) -> Vec3 {
    let c = n.dot(d);
    d - n * (c + k(c).sqrt())
}

#[test]
fn f09_equal_indices_pass_the_direction_bit_for_bit() {
    let g = &mut Random::new(47);
    let (mut glsl_changes, mut product_changes) = (0, 0);
    for _ in 0..100_000 {
        let (d, n, index) = (g.direction(), g.direction(), 1.0 + g.unit());
        let n = if d.dot(n) > 0.0 { -n } else { n };
        let bits = |v: DVec3| v.to_array().map(f64::to_bits);
        assert_eq!(refract::<f64>(d, n, index, index).map(bits), Some(bits(d)));

        let (d, n) = (d.as_vec3(), n.as_vec3());
        let bits = |v: Vec3| v.to_array().map(f32::to_bits);
        assert_eq!(refract::<f32>(d, n, 1.5, 1.5).map(bits), Some(bits(d)));
        glsl_changes += u32::from(glsl(d, n, |c| 1.0 - (1.0 - c * c)) != d);
        // (eta c)^2 - (eta - 1) (eta + 1) at eta = 1.
        product_changes += u32::from(glsl(d, n, |c| c * c - 0.0 * 2.0) != d);
    }
    println!("equal indices: GLSL's form changes {glsl_changes} of 100000 directions");
    assert!((36_000..41_000).contains(&glsl_changes), "{glsl_changes}");
    assert_eq!(product_changes, 0);
    assert_eq!(fresnel_exact(0.3, 0.3, 1.5, 1.5), 0.0);
    assert_eq!(transmitted_cosine(1.0_f32, 0.3), Some(0.3));
}

#[test]
fn f10_straight_into_glass() {
    let g = &mut Random::new(48);
    for _ in 0..10_000 {
        let n = g.direction();
        assert_eq!(refract::<f64>(-n, n, 1.0, 1.5), Some(-n));
        assert_eq!(refract::<f32>(-n.as_vec3(), n.as_vec3(), 1.0, 1.5), Some(-n.as_vec3()));
    }
    is_near(fresnel_exact(1.0, 1.0, 1.0, 1.5), 0.04, 1e-15);
    is_near(f64::from(fresnel_exact(1.0_f32, 1.0, 1.0, 1.5)), 0.04, 1.2e-7);
}

/// From air into a medium of index `n`.
fn into(n: f64, c: f64) -> [f64; 2] {
    let cosine = transmitted_cosine(1.0 / n, c).unwrap();
    [cosine, fresnel_exact(c, cosine, 1.0, n)]
}

#[test]
fn f11_glass_at_60_degrees() {
    let [cosine, reflectance] = into(1.5, 0.5);
    is_near(cosine, 0.816496580927726, 1e-14);
    is_near(reflectance, 0.089186712802213, 1e-13);
}

#[test]
fn f12_glass_at_90_degrees() {
    let [cosine, reflectance] = into(1.5, 0.0);
    is_near(cosine, 0.745355992499930, 1e-14);
    assert_eq!(reflectance, 1.0);
}

#[test]
fn f13_straight_out_of_glass() {
    let n = f64::from(2.0_f32 / 3.0);
    is_near(fresnel_exact(1.0, 1.0, 1.0, n), 0.0399999943, 1e-8);
}

#[test]
fn f14_brewsters_angle() {
    let c = f64::from(0.554_700_2_f32);
    let [cosine, reflectance] = into(1.5, c);
    let amplitude = |a: f64, b: f64| (a - b) / (a + b);
    let (perpendicular, parallel) = (amplitude(c, 1.5 * cosine), amplitude(1.5 * c, cosine));
    assert!(parallel.abs() < 1e-7, "{parallel}");
    is_near(reflectance, 0.073964497144749, 1e-12);
    is_near(reflectance, 0.5 * perpendicular * perpendicular, 1e-12);
}

#[test]
fn f15_water_near_grazing() {
    let [cosine, reflectance] = into(f64::from(1.33_f32), f64::from(0.01_f32));
    is_near(cosine, 0.659343223703218, 1e-14);
    is_near(reflectance, 0.938940905271822, 1e-14);
}

#[test]
fn f16_a_cosine_above_one_counts_as_one() {
    let c = 1.000_000_1_f32;
    assert!(c > 1.0);
    for eta in [0.5_f32, 1.0 / 1.5, 1.0, just_above_one(23), 1.5] {
        let cosine = transmitted_cosine(eta, c).unwrap();
        assert!((1.0 - f32::EPSILON..=1.0).contains(&cosine), "{eta}: {cosine}");
        for r in [fresnel_exact(c, cosine, eta, 1.0), fresnel_schlick(c, cosine, eta, 1.0)] {
            assert!((0.0..=1.0).contains(&r), "{eta}: {r}");
        }
    }
    // The same out of a direction that is a little too long.
    let (d, n) = (DVec3::new(0.0, -f64::from(c), 0.0), DVec3::Y);
    assert_eq!(refract::<f64>(d, n, 1.0, 1.5), Some(d));
}

#[test]
fn f17_reflectance_is_a_share() {
    let g = &mut Random::new(49);
    let mut transmitting = 0;
    for _ in 0..1_000_000 {
        let eta = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0][g.below(6)] * (1.0 + g.unit() as f32);
        let c = g.unit() as f32;
        let Some(cosine) = transmitted_cosine(eta, c) else { continue };
        transmitting += 1;
        let [r, schlick] = [fresnel_exact(c, cosine, eta, 1.0), fresnel_schlick(c, cosine, eta, 1.0)];
        for r in [r, schlick] {
            assert!((0.0..=1.0).contains(&r), "{eta} {c}: {r}");
            assert!((r + (1.0 - r) - 1.0).abs() <= f32::EPSILON);
        }
        // What is let through by Fresnel's equations of transmission, an equation of its own.
        let [eta, c] = [eta, c].map(f64::from);
        let cosine = transmitted_cosine(eta, c).unwrap();
        let (s, p) = (2.0 * eta * c / (eta * c + cosine), 2.0 * eta * c / (c + eta * cosine));
        let through = if c > 0.0 { cosine / (eta * c) * 0.5 * (s * s + p * p) } else { 0.0 };
        let sum = fresnel_exact(c, cosine, eta, 1.0) + through;
        assert!((sum - 1.0).abs() <= 8.0 * f64::EPSILON, "{eta} {c}: {sum}");
    }
    assert!(transmitting > 400_000);
}

/// The weights that a tracer gives the children of a glass surface add up to what came in.
#[test]
fn f17_the_children_of_a_ray_share_its_light() {
    let g = &mut Random::new(50);
    for fresnel in ["exact", "schlick"] {
        let glass = format!(r#""m": {{ "reflection": 1, "transmission": 1, "ior": 1.5, "fresnel": "{fresnel}" }}"#);
        let ball = r#"{ "material": "m", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } }"#;
        let loaded = small_scene(&glass, ball, r#", "max_depth": 4"#);
        let mut shared = 0;
        for _ in 0..400 {
            let origin = g.direction() * 3.0;
            let tree = ray_tree(&loaded, origin.to_array(), (g.direction() * 0.9 - origin).to_array());
            for node in tree.root.walk() {
                let (Some(reflected), Some(refracted)) = (&node.reflected, &node.refracted) else { continue };
                let weight = |node: &RayNode| node.weight.unwrap()[0];
                let sum = weight(reflected) + weight(refracted);
                assert!((sum / weight(node) - 1.0).abs() <= 2.0 * f64::EPSILON, "{sum} of {}", weight(node));
                shared += 1;
            }
        }
        assert!(shared > 1000, "{shared}");
    }
}

/// Through a parallel slab of thickness 1 the components along its faces come back to 2 ulp of the direction's length.
/// The component along the normal comes back to 2 ulp over itself: the stored direction inside does not tell it better.
#[test]
fn f18_a_slab_shifts_a_ray_and_keeps_its_direction() {
    let slab = r#"{ "material": "m", "shape": { "box": { "min": [-100, -1, -100], "max": [100, 0, 100] } } }"#;
    let loaded = small_scene(r#""m": { "transmission": 1, "ior": 1.5 }"#, slab, "");
    let g = &mut Random::new(51);
    let mut worst = 0.0_f64;
    for _ in 0..5000 {
        let mut d = g.direction();
        d.y = -d.y.abs().max(1.0 / 64.0);
        let tree = ray_tree(&loaded, (-d).to_array(), d.to_array());
        let inside = tree.root.refracted.as_deref().unwrap();
        let outside = inside.refracted.as_deref().unwrap();
        assert_eq!(outside.hit, None);
        let after = DVec3::from_array(outside.direction);
        let error = (after - d).abs();
        assert!(error.x.max(error.z) <= 2.0 * f64::EPSILON, "{d} {after}");
        assert!(error.y <= 2.0 * f64::EPSILON / d.y.abs(), "{d} {after}");
        worst = worst.max(error.y / f64::EPSILON);

        let cos_i = -d.y / d.length();
        let sin_i = (d.x * d.x + d.z * d.z).sqrt() / d.length();
        let cos_t = (1.0 - (sin_i / 1.5) * (sin_i / 1.5)).sqrt();
        let way = DVec3::from_array(outside.origin) - DVec3::from_array(inside.origin);
        let shift = way.cross(d).length() / d.length();
        let expected = sin_i * (1.0 - cos_i / (1.5 * cos_t));
        assert!((shift - expected).abs() <= 1e-13, "{shift} {expected}");
    }
    println!("a slab: the component along the normal comes back to {worst:.1} ulp");
    // No rule for the way out can do better: of directions so near grazing many are one and the same inside.
    let grazing = |k: i32| DVec3::new(1.0, -f64::from(k) / (1_u64 << 40) as f64, 0.0);
    let inside = |k: i32| refract::<f64>(grazing(k), DVec3::Y, 1.0, 1.5).unwrap().to_array().map(f64::to_bits);
    let mut outside_of = BTreeMap::<[u64; 3], Vec<i32>>::new();
    (1..=1024).for_each(|k| outside_of.entry(inside(k)).or_default().push(k));
    let spread = outside_of.values().map(|all| all[all.len() - 1] - all[0]).max().unwrap();
    assert!(f64::from(spread) / (1_u64 << 40) as f64 > 1000.0 * f64::EPSILON, "{spread}");
}

fn nothing_is_nan<R: Real>(set: OpticsSet) -> usize {
    let g = &mut Random::new(52);
    let mut naive_nan = 0;
    for _ in 0..50_000 {
        let Crossing { direction, normal, incident, transmitted } = set.next::<R>(g);
        let finite = |v: R::Vec3| raytree::numbers::Vector3::to_f64(v).iter().all(|x| x.is_finite());
        assert!(refract(direction, normal, incident, transmitted).is_none_or(finite));
        assert!(finite(reflect::<R>(direction, normal)));
        let (eta, c) = (incident / transmitted, R::from_f64(g.unit()));
        assert!(transmitted_cosine(eta, c).is_none_or(|cosine| cosine >= R::ZERO && cosine <= R::ONE));
        // Without the question before the root.
        let k = R::ONE - eta * eta * (R::ONE - c * c);
        naive_nan += usize::from(!(k.sqrt() >= R::ZERO));
    }
    naive_nan
}

#[test]
fn f19_total_reflection_is_no_nan() {
    for set in OpticsSet::ALL {
        assert!(nothing_is_nan::<f32>(set) > 1000);
        assert!(nothing_is_nan::<f64>(set) > 1000);
    }
}
