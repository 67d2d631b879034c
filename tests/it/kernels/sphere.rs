use raytree::kernels::*;
use raytree::numbers::{Real, Stage, Vector3};

use super::referee::{SphereTruth, sign};
use super::sets::{P, Random, rounded, stored, subtract};

const SETS: [&str; 9] = [
    "random",
    "far",
    "grazing",
    "on the surface",
    "small",
    "ground",
    "small integers",
    "exponents to 126",
    "tangent, planted",
];

fn spheres<R: Real>(set: &str, count: usize, seed: u64) -> Vec<(Ray<R>, Sphere<R>)> {
    let mut random = Random::new(seed);
    let g = &mut random;
    let mut pairs = Vec::new();
    let unit = |g: &mut Random| loop {
        let p = g.point(1.0);
        let length = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
        if length > 0.1 && length <= 1.0 {
            return p.map(|x| x / length);
        }
    };
    let on = |c: P, n: P, r: f64| -> P { std::array::from_fn(|k| c[k] + r * n[k]) };
    while pairs.len() < count {
        let (c, r): (P, f64) = match set {
            "small" => (g.point(10.0), 1e-3 * (0.5 + g.unit())),
            "ground" => ([0.0, -1e6, 0.0], 1e6),
            "small integers" => (g.small_integers(), g.below(5) as f64),
            "exponents to 126" => (std::array::from_fn(|_| g.wild(126)), g.wild(126).abs()),
            _ => (g.point(3.0), 0.1 + g.unit()),
        };
        let (c, r) = (rounded::<R>(c), R::from_f64(r).to_f64());
        let (o, d): (P, P) = match set {
            "far" => {
                let o = on(c, unit(g), 10f64.powi(g.below(7) as i32));
                (o, subtract(on(c, unit(g), 1.2 * r * g.unit()), o))
            }
            "grazing" => {
                // A point on the sphere and a direction across the normal there, from some way back.
                let (n, v) = (unit(g), unit(g));
                let along: f64 = (0..3).map(|k| n[k] * v[k]).sum();
                let d: P = std::array::from_fn(|k| v[k] - along * n[k]);
                let back = 4.0 * g.signed();
                let p = on(c, n, r);
                (std::array::from_fn(|k| p[k] - back * d[k]), d)
            }
            "on the surface" => {
                let o = on(c, unit(g), r);
                (
                    o,
                    if g.below(4) == 0 {
                        subtract(o, c).map(|x| if g.below(2) == 0 { x } else { -x })
                    } else {
                        unit(g)
                    },
                )
            }
            "ground" => ([10.0 * g.signed(), g.unit(), 10.0 * g.signed()], [g.signed(), -0.003 * g.unit(), g.signed()]),
            "small integers" => (g.small_integers(), g.small_integers()),
            "exponents to 126" => {
                let o: P = std::array::from_fn(|_| g.wild(126));
                (o, if g.below(2) == 0 { subtract(c, o) } else { std::array::from_fn(|_| g.wild(126)) })
            }
            "tangent, planted" => {
                // Along an axis, at the radius from the centre on another: a tangent where the sum is exact.
                let (i, j) = (g.below(3), 1 + g.below(2));
                let grid = |x: f64| (x * 4096.0).round() / 4096.0;
                let c = c.map(grid);
                let mut o = c;
                o[(i + j) % 3] += r;
                o[i] += grid(4.0 * g.signed());
                let mut d = [0.0; 3];
                d[i] = grid(g.signed());
                (o, d)
            }
            _ => {
                let o = g.point(5.0);
                (o, subtract(on(c, unit(g), 1.5 * r * g.unit()), o))
            }
        };
        let sphere = if set == "tangent, planted" {
            let grid = |x: f64| (x * 4096.0).round() / 4096.0;
            Sphere { center: stored::<R>(c.map(grid)), radius: R::from_f64(r) }
        } else {
            Sphere { center: stored::<R>(c), radius: R::from_f64(r) }
        };
        let ray = Ray::<R> { origin: stored::<R>(o), direction: stored::<R>(d) };
        if ray.direction.to_f64() != [0.0; 3] && ray.direction.to_f64().iter().all(|x| x.abs() < 2f64.powi(127)) {
            pairs.push((ray, sphere));
        }
    }
    pairs
}

fn check_set<R: Real>(set: &str, count: usize, seed: u64) -> [usize; 4] {
    let (mut hits, mut naive, mut stable, mut stages) = (0, 0, 0, [0; 4]);
    for (i, (ray, sphere)) in spheres::<R>(set, count, seed).into_iter().enumerate() {
        let truth = SphereTruth::new(&ray, &sphere);
        let context = || format!("{set} {} {i}: {ray:?} {sphere:?}", R::PRECISION as u8);
        let roots = sign(&truth.disc) >= 0;
        let (zero, less) = (super::referee::q(0.0), std::cmp::Ordering::Less);
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
    let ppm = |wrong: usize| wrong * 1_000_000 / count;
    println!(
        "{set:26} {:?} hits {hits:5} stages of hits {stages:?} | wrong ppm: naive {} stable {} certified 0",
        R::PRECISION,
        ppm(naive),
        ppm(stable)
    );
    [naive, stable, hits, stages[3]]
}

#[test]
fn certified_verdicts_are_those_of_rational_arithmetic() {
    for set in SETS {
        let [_, stable, ..] = check_set::<f64>(set, 10_000, 5);
        let [naive_f32, ..] = check_set::<f32>(set, 10_000, 6);
        match set {
            "grazing" => assert!(stable > 100, "grazing is not hard"),
            "far" => assert!(naive_f32 > 100, "far is not hard"),
            _ => {}
        }
    }
}
