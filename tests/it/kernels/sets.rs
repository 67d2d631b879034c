//! Random rays and shapes, easy ones and ones that sit on the edge of a verdict.

use raytree::kernels::{Ray, Triangle};
use raytree::numbers::{Real, Vector3, flush_tiny};

pub(super) type P = [f64; 3];

/// SplitMix64 (Steele, Lea, Flood 2014).
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Random(seed)
    }
    pub(super) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    pub(super) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }
    /// In [0, 1).
    pub(super) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    /// In [-1, 1).
    pub(super) fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }
    pub(super) fn point(&mut self, scale: f64) -> P {
        std::array::from_fn(|_| scale * self.signed())
    }
    pub(super) fn small_integers(&mut self) -> P {
        std::array::from_fn(|_| self.below(9) as f64 - 4.0)
    }
    /// A number with an exponent in `-range ..= range`, now and then zero, a power of two or with few bits.
    pub(super) fn wild(&mut self, range: i32) -> f64 {
        let exponent = self.below(2 * range as usize + 1) as i32 - range;
        let significand = match self.below(10) {
            0 => return 0.0,
            1..=3 => 1.0 + self.below(8) as f64 / 8.0,
            _ => 1.0 + self.unit(),
        };
        let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
        sign * significand * 2f64.powi(exponent)
    }
    /// The number `below(2 n + 1) - n` units in the last place away from `x`.
    pub(super) fn nudge<R: Real>(&mut self, x: R, n: usize) -> R {
        let ulps = self.below(2 * n + 1) as f64 - n as f64;
        R::from_f64(x.to_f64() + ulps * x.to_f64().abs() * 2.0 * R::UNIT_ROUNDOFF.to_f64())
    }
}

pub(super) fn subtract(a: P, b: P) -> P {
    std::array::from_fn(|k| a[k] - b[k])
}

pub(super) fn mix(a: P, b: P, z: f64) -> P {
    std::array::from_fn(|k| a[k] + z * (b[k] - a[k]))
}

pub(super) fn stored<R: Real>(v: P) -> R::Vec3 {
    R::Vec3::from_f64(v.map(|x| flush_tiny(R::from_f64(x)).to_f64()))
}

/// `v` rounded to the precision.
pub(super) fn rounded<R: Real>(v: P) -> P {
    stored::<R>(v).to_f64()
}

pub(super) const TRIANGLE_SETS: [&str; 13] = [
    "random",
    "sphere mesh",
    "tiny",
    "needles",
    "far away",
    "edge",
    "vertex",
    "vertex, exact difference",
    "small integers",
    "secondary",
    "nearly coplanar",
    "exponents to 20",
    "exponents to 126",
];

/// Pairs of a set, the ray and the triangle as stored in the precision.
pub(super) fn triangles<R: Real>(set: &str, count: usize, seed: u64) -> Vec<(Ray<R>, Triangle<R>)> {
    let mut random = Random::new(seed);
    let g = &mut random;
    let mut pairs = Vec::with_capacity(count);
    while pairs.len() < count {
        let base: [P; 3] = match set {
            "sphere mesh" => mesh_triangle(g, 2000),
            "tiny" => {
                let at = g.point(1.0);
                std::array::from_fn(|_| mix(at, g.point(1.0), 1e-6))
            }
            "needles" => {
                let (a, b) = (g.point(1.0), g.point(1.0));
                [a, b, mix(b, g.point(1.0), 1e-5)]
            }
            "small integers" => std::array::from_fn(|_| g.small_integers()),
            "exponents to 20" | "exponents to 126" => {
                let range = if set == "exponents to 20" { 20 } else { 126 };
                std::array::from_fn(|_| std::array::from_fn(|_| g.wild(range)))
            }
            _ => std::array::from_fn(|_| g.point(1.0)),
        };
        let shift = if set == "far away" { [148_376.0, 1234.0, -223_423.0] } else { [0.0; 3] };
        let v = base.map(|p| rounded::<R>(std::array::from_fn(|k| p[k] + shift[k])));
        let inside = |g: &mut Random| {
            let (x, y) = (g.unit(), g.unit());
            mix(mix(v[0], v[1], x), v[2], y)
        };
        let mut o = rounded::<R>(std::array::from_fn(|k| 3.0 * g.signed() + shift[k]));
        let edge_point = |g: &mut Random| {
            let i = g.below(3);
            mix(v[i], v[(i + 1) % 3], g.unit())
        };
        let d = match set {
            "edge" => subtract(edge_point(g), o),
            "vertex" => subtract(v[g.below(3)], o),
            "vertex, exact difference" => {
                // Multiples of 2^-20 below 4: differences are exact in either precision.
                let on_grid = |x: f64| (x * 2f64.powi(20)).trunc() / 2f64.powi(20);
                o = o.map(on_grid);
                let v = v.map(|p| p.map(on_grid));
                let d = subtract(v[g.below(3)], o);
                pairs.push((
                    Ray::<R> { origin: stored::<R>(o), direction: stored::<R>(d) },
                    Triangle { vertices: v.map(stored::<R>) },
                ));
                continue;
            }
            "small integers" => {
                o = g.small_integers();
                match g.below(3) {
                    0 => g.small_integers(),
                    1 => subtract(v[g.below(3)], o),
                    _ => {
                        let (a, b) = (v[g.below(3)], v[g.below(3)]);
                        std::array::from_fn(|k| a[k] + b[k] - 2.0 * o[k])
                    }
                }
            }
            "secondary" => {
                o = rounded::<R>(inside(g));
                if g.below(2) == 0 { g.point(1.0) } else { subtract(inside(g), o) }
            }
            "nearly coplanar" => {
                let (x, y) = (3.0 * g.signed(), 3.0 * g.signed());
                o = rounded::<R>(mix(mix(v[0], v[1], x), v[2], y));
                subtract(inside(g), o)
            }
            "exponents to 20" | "exponents to 126" => {
                let range = if set == "exponents to 20" { 20 } else { 126 };
                o = rounded::<R>(std::array::from_fn(|_| g.wild(range)));
                match g.below(4) {
                    0 => std::array::from_fn(|_| g.wild(range)),
                    1 => subtract(v[g.below(3)], o),
                    2 => subtract(edge_point(g), o),
                    _ => subtract(inside(g), o),
                }
            }
            // Half at the triangle, half past it.
            _ if g.below(2) == 0 => subtract(inside(g), o),
            _ => {
                let (a, b) = (inside(g), edge_point(g));
                subtract(mix(a, b, 1.5 * g.unit()), o)
            }
        };
        let (origin, direction) = (stored::<R>(o), stored::<R>(d));
        let usable = direction.to_f64() != [0.0; 3] && direction.to_f64().iter().all(|x| x.abs() <= 2f64.powi(127));
        if usable {
            pairs.push((Ray { origin, direction }, Triangle { vertices: v.map(stored::<R>) }));
        }
    }
    pairs
}

fn mesh_triangle(g: &mut Random, segments: usize) -> [P; 3] {
    let point = |i: usize, j: usize| {
        let theta = std::f64::consts::PI * i as f64 / segments as f64;
        let phi = std::f64::consts::TAU * j as f64 / segments as f64;
        [libm::sin(theta) * libm::cos(phi), libm::cos(theta), libm::sin(theta) * libm::sin(phi)]
    };
    let (i, j) = (g.below(segments), g.below(segments));
    if g.below(2) == 0 {
        [point(i, j), point(i, j + 1), point(i + 1, j)]
    } else {
        [point(i + 1, j), point(i, j + 1), point(i + 1, j + 1)]
    }
}
