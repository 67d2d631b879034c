use raytree::numbers::error_free::{fast_two_sum, two_diff, two_product, two_sum};
use raytree::numbers::{
    Certificate, DoubleDouble, Expansion, Ring, Stage, Wide, determinant, flush_tiny, integers, is_in_range,
};

use raytree::accuracy::random::Random;
use raytree::accuracy::referee::{Q, q, sign};

#[test]
fn error_free_transformations_are_exact() {
    let mut g = Random::new(51);
    for _ in 0..20_000 {
        let (a, b) = (g.wild(126), g.wild(126));
        let pair = |(hi, lo): (f64, f64)| q(hi) + q(lo);
        assert_eq!(pair(two_sum(a, b)), q(a) + q(b));
        assert_eq!(pair(two_diff(a, b)), q(a) - q(b));
        assert_eq!(pair(two_product(a, b)), q(a) * q(b));
        assert_eq!(two_sum(a, b).0, a + b);
        assert_eq!(two_product(a, b).0, a * b);
        let (large, small) = if a.abs() >= b.abs() { (a, b) } else { (b, a) };
        assert_eq!(pair(fast_two_sum(large, small)), q(a) + q(b));
    }
}

/// A random formula of differences, products and sums, of degree up to six, with cancellation.
fn formula<T: Ring>(x: &[f64; 12]) -> T {
    let difference = |i: usize, j: usize| T::difference(x[i], x[j]);
    let cubic = determinant(
        &[difference(0, 1), difference(2, 3), difference(4, 5)],
        &[difference(6, 7), difference(8, 9), difference(10, 11)],
        &[T::number(x[0]), T::number(x[5]), T::number(x[7])],
    );
    let other = T::product(x[1], x[2]) * T::number(x[3]);
    (cubic.clone() + other.clone()) * (cubic.clone() - other.clone()) - cubic.clone() * cubic + other.clone() * other
        - T::product(x[8], x[9])
}

fn rational(x: &[f64; 12]) -> Q {
    // The squares cancel: what is left is the last term.
    Q::ZERO - q(x[8]) * q(x[9])
}

#[test]
fn expansions_and_wide_integers_are_exact() {
    let mut g = Random::new(53);
    for i in 0..3000 {
        let range = [2, 20, 126][i % 3];
        let x: [f64; 12] = std::array::from_fn(|_| g.wild(range));
        let (exact, expansion) = (rational(&x), formula::<Expansion>(&x));
        assert_eq!(expansion.sign(), sign(&exact), "{x:?}");
        let error = q(expansion.estimate()) - &exact;
        assert!(&error * &error <= q(2f64.powi(-102)) * &exact * &exact, "{x:?}");
        assert_eq!(formula::<Wide>(&x).sign(), sign(&exact), "{x:?}");
    }
}

#[test]
fn double_double_keeps_its_bound() {
    let mut g = Random::new(57);
    for _ in 0..20_000 {
        let mut dd = || DoubleDouble::difference(g.signed(), g.signed() * 1e-3);
        let (a, b) = (dd(), dd());
        let value = |x: DoubleDouble| q(x.hi) + q(x.lo);
        let magnitude = |x: Q| if sign(&x) < 0 { Q::ZERO - x } else { x };
        let u_sq = q(2f64.powi(-106));
        let (size_a, size_b) = (magnitude(value(a)), magnitude(value(b)));
        assert!(magnitude(value(a + b) - value(a) - value(b)) <= q(3.0) * &u_sq * (&size_a + &size_b));
        assert!(magnitude(value(a * b) - value(a) * value(b)) <= q(8.0) * &u_sq * size_a * size_b);
    }
}

#[test]
fn integer_determinants_are_exact() {
    let mut g = Random::new(59);
    for i in 0..20_000 {
        let mut row = || -> integers::Row { std::array::from_fn(|_| (g.bits() as i64) >> (2 + g.below(61))) };
        let (x, y) = (row(), row());
        // Now and then a sum of the others, or one off.
        let mut z = row();
        if i % 2 == 0 {
            z = std::array::from_fn(|k| (x[k] >> 1) + (y[k] >> 1));
        }
        let x = x.map(|a| a & !1);
        let y = y.map(|a| a & !1);
        let wide = |r: &integers::Row| r.map(Q::from);
        let [a, b, c] = [wide(&x), wide(&y), wide(&z)];
        let exact = raytree::accuracy::referee::dot(&a, &raytree::accuracy::referee::cross(&b, &c));
        let value = integers::determinant(&x, &y, &z);
        let error = q(value) - &exact;
        assert!(
            sign(&q(value)) == sign(&exact) && &error * &error <= q(2f64.powi(-102)) * &exact * &exact,
            "{x:?} {y:?} {z:?}"
        );
    }
}

#[test]
fn range_of_stored_numbers() {
    for x in
        [0.0, -0.0, 1.0, f64::from(f32::MAX), f64::from(f32::from_bits(1)), 2f64.powi(128), 2f64.powi(-178), 1.2e-38]
    {
        assert!(is_in_range(x) && is_in_range(-x), "{x}");
    }
    for x in [
        f64::NAN,
        f64::INFINITY,
        2f64.powi(128) * 1.5,
        2f64.powi(-179),
        1.1e-50,
        f64::MIN_POSITIVE,
        1.5 * 2f64.powi(-178),
    ] {
        assert!(!is_in_range(x) && !is_in_range(-x), "{x}");
    }
    assert_eq!(flush_tiny(2f64.powi(-126)), 2f64.powi(-126));
    assert_eq!(flush_tiny(-2f64.powi(-127)), 0.0);
    assert_eq!(flush_tiny(f32::from_bits(5)), 0.0f32);
}

#[test]
fn certificates_in_json() {
    let certificate = Certificate { stage: Stage::DoubleDouble, margin: 0.25 };
    let text = serde_json::to_string(&certificate).unwrap();
    assert_eq!(text, r#"{"stage":"double_double","margin":0.25}"#);
    assert_eq!(serde_json::from_str::<Certificate>(&text).unwrap(), certificate);
}
