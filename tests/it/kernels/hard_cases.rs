//! The 82 geometric hard cases: the certified forms are right, the naive ones wrong exactly as recorded.
//!
//! `tests/data/hard-cases.json` holds f32 bit patterns, the exact answer, and what the textbook formula gives in f32.

use raytree::kernels::*;
use serde_json::Value;

use raytree::accuracy::referee::{SphereTruth, TriangleTruth, box_span, is_within, plane as plane_truth, q};

type Row<'a> = &'a Value;

fn vector(row: Row, key: &str) -> glam::Vec3 {
    let bits = row[format!("{key}_bits")].as_array().unwrap();
    let component = |k: usize| {
        let text = bits[k].as_str().unwrap();
        f32::from_bits(u32::from_str_radix(text.trim_start_matches("0x"), 16).unwrap())
    };
    glam::vec3(component(0), component(1), component(2))
}

fn number(row: Row, key: &str) -> f32 {
    row[key].as_f64().unwrap() as f32
}

/// `"65/2 (=32.5)"`, `"7"` or `"-"`.
fn decimal(text: &str) -> Option<f64> {
    let text = match text.split_once("(=") {
        Some((_, rest)) => rest.trim_end_matches(')'),
        None => text,
    };
    text.parse().ok()
}

/// The formulas of the hard cases, word for word in f32; the answer as it is written in the file.
mod naive {
    use raytree::kernels::*;

    /// As Python prints a float.
    fn print(x: f32) -> String {
        let text = format!("{:?}", f64::from(x));
        match text.split_once('e') {
            Some((digits, exponent)) if !exponent.starts_with('-') => format!("{digits}e+{exponent:0>2}"),
            _ => text.replace("NaN", "nan"),
        }
    }

    pub(super) fn aabb(ray: &Ray<f32>, aabb: &Aabb<f32>) -> String {
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let (lo, hi) = (aabb.min.to_array(), aabb.max.to_array());
        // f32::min and max ignore NaN.
        let (mut t_in, mut t_out) = (f32::NEG_INFINITY, f32::INFINITY);
        for k in 0..3 {
            let i = 1.0 / d[k];
            let (a, b) = ((lo[k] - o[k]) * i, (hi[k] - o[k]) * i);
            t_in = t_in.max(a.min(b));
            t_out = t_out.min(a.max(b));
        }
        let verdict = if t_in <= t_out && t_out >= 0.0 { "hit" } else { "miss" };
        format!("{verdict} (t_in {}, t_out {})", print(t_in), print(t_out))
    }

    pub(super) fn plane(ray: &Ray<f32>, plane: &Plane<f32>) -> String {
        let t = (plane.distance - plane.normal.dot(ray.origin)) / plane.normal.dot(ray.direction);
        if t >= 0.0 { format!("hit t={}", print(t)) } else { format!("miss (t={})", print(t)) }
    }

    pub(super) fn triangle(ray: &Ray<f32>, triangle: &Triangle<f32>) -> String {
        let [a, b, c] = triangle.vertices;
        let (e1, e2) = (b - a, c - a);
        let p = ray.direction.cross(e2);
        let det = e1.dot(p);
        if det == 0.0 {
            return "miss".into();
        }
        let inv = 1.0 / det;
        let s = ray.origin - a;
        let u = s.dot(p) * inv;
        let q = s.cross(e1);
        let v = ray.direction.dot(q) * inv;
        let t = e2.dot(q) * inv;
        if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 { format!("hit t={}", print(t)) } else { "miss".into() }
    }

    pub(super) fn sphere(ray: &Ray<f32>, sphere: &Sphere<f32>) -> String {
        let f = ray.origin - sphere.center;
        let d = ray.direction;
        let (a, b, c) = (d.dot(d), 2.0 * f.dot(d), f.dot(f) - sphere.radius * sphere.radius);
        let disc = b * b - 4.0 * a * c;
        if disc.is_nan() {
            return "NaN".into();
        }
        if disc < 0.0 {
            return format!("miss (disc {})", print(disc));
        }
        let (t0, t1) = ((-b - disc.sqrt()) / (2.0 * a), (-b + disc.sqrt()) / (2.0 * a));
        let t = if t0 >= 0.0 { t0 } else { t1 };
        if t >= 0.0 { format!("hit t={}", print(t)) } else { format!("miss (t0={} t1={})", print(t0), print(t1)) }
    }
}

/// The certified answer, its `t` within its bound of `exact`, and what the naive formula says.
fn check(row: Row, certified: Option<(f64, f64)>, exact: Option<&str>, naive: String) {
    let id = row["id"].as_str().unwrap();
    let verdict = if certified.is_some() { "hit" } else { "miss" };
    assert_eq!(verdict, row["verdict"], "{id}");
    // The file's t of A20 is that of a box from -3e38 to 3e38 in f64; the stored f32 next to 3e38 is larger by 5e29.
    let exact = if id == "A20" { Some("300000000549775575777803994281145270272") } else { exact };
    if let (Some((t, t_error)), Some(exact)) = (certified, exact.and_then(decimal)) {
        // The file's decimals are rounded to f64 themselves.
        assert!((t - exact).abs() <= t_error + f64::EPSILON * exact.abs(), "{id}: {t} +- {t_error}, {exact}");
    }
    assert_eq!(naive, row["naive_f32"], "{id}");
    let naive_is_wrong = naive == "NaN" || naive.starts_with("hit") != certified.is_some();
    assert_eq!(naive_is_wrong, row["naive_verdict_wrong"].as_bool().unwrap(), "{id}");
}

#[test]
fn hard_cases() {
    let file: Value = serde_json::from_str(include_str!("../../data/hard-cases.json")).unwrap();
    let rows = file["cases"].as_array().unwrap();
    assert_eq!(rows.len(), 82);
    let mut wrong = 0;
    for row in rows {
        let id = row["id"].as_str().unwrap();
        let ray = Ray::<f32> { origin: vector(row, "o"), direction: vector(row, "d") };
        let text = |key: &str| row[key].as_str();
        wrong += usize::from(row["naive_verdict_wrong"].as_bool().unwrap());
        match row["kind"].as_str().unwrap() {
            "box" => {
                let aabb = Aabb { min: vector(row, "lo"), max: vector(row, "hi") };
                let hit = intersect_box_certified(&ray, &aabb, Start::Anywhere).ok();
                let (t_in, t_out) = (text("t_in").unwrap(), text("t_out").unwrap());
                let exact = if decimal(t_in).is_some_and(|t| t >= 0.0) { t_in } else { t_out };
                check(row, hit.map(|hit| (hit.t, hit.t_error)), Some(exact), naive::aabb(&ray, &aabb));
                if let Some(Certified { hit, t, t_error }) = hit {
                    assert_eq!([hit.t_in, hit.t_out], [t_in, t_out].map(|t| decimal(t).unwrap() as f32), "{id}");
                    let (enter, leave) = box_span(&ray, &aabb).unwrap();
                    let exact = if enter.1 >= q(0.0) { enter.1 } else { leave.1 };
                    assert!(is_within(t, t_error, &exact, &q(1.0)), "{id}");
                }
            }
            "plane" => {
                let plane = Plane { normal: vector(row, "n"), distance: number(row, "dist") };
                let hit = intersect_plane_certified(&ray, &plane).ok();
                check(row, hit.map(|hit| (hit.t, hit.t_error)), text("t"), naive::plane(&ray, &plane));
                if let Some(Certified { t, t_error, .. }) = hit {
                    let (n_dot_d, height) = plane_truth(&ray, &plane);
                    assert!(is_within(t, t_error, &height, &n_dot_d), "{id}");
                }
            }
            "triangle" => {
                let triangle = Triangle { vertices: [vector(row, "a"), vector(row, "b"), vector(row, "c")] };
                let filter = TriangleFilter::of_triangle(&ray, &triangle);
                let hit = intersect_triangle_certified(&ray, &triangle, &filter).ok();
                check(row, hit.map(|hit| (hit.t, hit.t_error)), text("t"), naive::triangle(&ray, &triangle));
                if let Some(Certified { t, t_error, hit }) = hit {
                    let truth = TriangleTruth::new(&ray, &triangle).unwrap();
                    assert!(is_within(t, t_error, &truth.t_numerator, &truth.denominator), "{id}");
                    let weights = row["bary"].as_array().unwrap();
                    for (weight, exact) in hit.barycentrics.into_iter().zip(weights) {
                        if let Some(exact) = decimal(exact.as_str().unwrap()) {
                            assert!((f64::from(weight) - exact).abs() < 1e-7, "{id}: {weight} {exact}");
                        }
                    }
                }
            }
            "sphere" => {
                let sphere = Sphere { center: vector(row, "c"), radius: number(row, "r") };
                let hit = intersect_sphere_certified(&ray, &sphere, Start::Anywhere).ok();
                let (t_in, t_out) = (text("t0").unwrap(), text("t1").unwrap());
                let near = decimal(t_in).is_some_and(|t| t >= 0.0);
                let exact = if near { t_in } else { t_out };
                check(row, hit.map(|hit| (hit.t, hit.t_error)), Some(exact), naive::sphere(&ray, &sphere));
                if let Some(Certified { t, t_error, .. }) = hit {
                    assert!(SphereTruth::new(&ray, &sphere).is_within(!near, t, t_error), "{id}");
                    // Going in from the surface: the far root.
                    let inward = intersect_sphere_certified(&ray, &sphere, Start::OnSurfaceInward).unwrap();
                    let far = decimal(t_out).unwrap();
                    assert!((inward.t - far).abs() <= inward.t_error + f64::EPSILON * far.abs(), "{id}");
                }
            }
            kind => panic!("{id}: a {kind}"),
        }
    }
    assert_eq!(wrong, 20);
}
