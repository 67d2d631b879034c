//! What a proven verdict costs: the certified kernels against plain ones on the same rays and shapes, interleaved; medians of
//! ratios.
//!
//! `cargo bench --bench kernels`

use std::hint::black_box;
use std::time::Instant;

use glam::DVec3;
use raytree::kernels::{
    Aabb, Ray, Sphere, Start, Triangle, TriangleFilter, intersect_box_certified, intersect_box_explicit_zero,
    intersect_sphere_certified, intersect_sphere_stable, intersect_triangle_certified,
    intersect_triangle_moller_trumbore, longest_edge,
};
use raytree::numbers::{Real, Vector3};

const ROUNDS: usize = 61;
const RAYS: usize = 64;

/// SplitMix64 (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
    fn point(&mut self, scale: f64) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed()) * scale
    }
    fn below(&mut self, n: usize) -> usize {
        ((self.signed() + 1.0) * 0.5 * n as f64) as usize % n
    }
}

fn main() {
    println!("{:<34} {:>28}", "set", "certified / plain (quartiles)");
    for (aim, name) in
        [(Aim::Anywhere, "random rays"), (Aim::Edge, "aimed at edges"), (Aim::Vertex, "aimed at vertices")]
    {
        triangles::<f64>(&format!("triangles f64, {name}"), aim);
        triangles::<f32>(&format!("triangles f32, {name}"), aim);
    }
    spheres();
    boxes();
    println!("\none ray against many shapes; median of {ROUNDS} interleaved rounds");
    println!("plain: Möller-Trumbore, the stable quadratic, slabs with an explicit zero, in the same precision");
}

#[derive(Clone, Copy)]
enum Aim {
    Anywhere,
    Edge,
    Vertex,
}

/// A sphere of 720 triangles without slivers at its poles, and rays from outside.
fn triangles<R: Real>(name: &str, aim: Aim) {
    let mut random = Random(7);
    let corner = |i: usize, j: usize| {
        let (u, v) = (i as f64 / 20.0 * std::f64::consts::TAU, (j as f64 + 1.0) / 20.0 * std::f64::consts::PI);
        R::Vec3::from_f64([v.sin() * u.cos(), v.cos(), v.sin() * u.sin()])
    };
    let mut mesh: Vec<Triangle<R>> = Vec::new();
    for j in 0..18 {
        for i in 0..20 {
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            mesh.push(Triangle { vertices: [a, b, c] });
            mesh.push(Triangle { vertices: [a, c, d] });
        }
    }
    let rays: Vec<Ray<R>> = (0..RAYS)
        .map(|_| {
            let origin = R::Vec3::from_f64(random.point(3.0).to_array()).to_f64();
            let vertices = mesh[random.below(mesh.len())].vertices.map(|v| DVec3::from_array(v.to_f64()));
            let target = match aim {
                Aim::Anywhere => random.point(1.0),
                Aim::Edge => vertices[0].lerp(vertices[1], 0.5 + 0.5 * random.signed()),
                Aim::Vertex => vertices[random.below(3)],
            };
            let direction = (target - DVec3::from_array(origin)).to_array();
            Ray { origin: R::Vec3::from_f64(origin), direction: R::Vec3::from_f64(direction) }
        })
        .collect();
    let points: Vec<R::Vec3> = mesh.iter().flat_map(|t| t.vertices).collect();
    let bounds = Aabb::<R>::of_points(&points);
    let longest = mesh.iter().map(longest_edge).fold(0.0, f64::max);
    compare(
        name,
        || {
            rays.iter()
                .map(|ray| mesh.iter().filter(|t| intersect_triangle_moller_trumbore(ray, t).is_ok()).count())
                .sum()
        },
        || {
            let hits = |ray: &Ray<R>| {
                let filter = TriangleFilter::new(ray, &bounds, longest);
                mesh.iter().filter(|t| intersect_triangle_certified(ray, t, &filter).is_ok()).count()
            };
            rays.iter().map(hits).sum()
        },
    );
}

fn some_rays(random: &mut Random) -> Vec<Ray<f64>> {
    (0..RAYS).map(|_| Ray { origin: random.point(3.0), direction: random.point(1.0) }).collect()
}

fn spheres() {
    let mut random = Random(8);
    let rays = some_rays(&mut random);
    let spheres: Vec<Sphere<f64>> =
        (0..800).map(|_| Sphere { center: random.point(1.0), radius: 0.3 + 0.25 * random.signed() }).collect();
    let start = Start::Anywhere;
    compare(
        "spheres f64, random rays",
        || {
            rays.iter()
                .map(|ray| spheres.iter().filter(|s| intersect_sphere_stable(ray, s, start).is_ok()).count())
                .sum()
        },
        || {
            rays.iter()
                .map(|ray| spheres.iter().filter(|s| intersect_sphere_certified(ray, s, start).is_ok()).count())
                .sum()
        },
    );
}

fn boxes() {
    let mut random = Random(9);
    let rays = some_rays(&mut random);
    let boxes: Vec<Aabb<f64>> = (0..800)
        .map(|_| {
            let (center, half) = (random.point(1.0), random.point(0.3).abs());
            Aabb { min: center - half, max: center + half }
        })
        .collect();
    let start = Start::Anywhere;
    compare(
        "boxes f64, random rays",
        || {
            rays.iter()
                .map(|ray| boxes.iter().filter(|b| intersect_box_explicit_zero(ray, b, start).is_ok()).count())
                .sum()
        },
        || rays.iter().map(|ray| boxes.iter().filter(|b| intersect_box_certified(ray, b, start).is_ok()).count()).sum(),
    );
}

/// Times both, each round one after the other, and prints the ratio.
fn compare(name: &str, plain: impl Fn() -> usize, certified: impl Fn() -> usize) {
    let seconds = |work: &dyn Fn() -> usize| {
        let start = Instant::now();
        black_box(work());
        start.elapsed().as_secs_f64()
    };
    let mut ratios: Vec<f64> = (0..ROUNDS).map(|_| seconds(&certified) / seconds(&plain)).collect();
    ratios.sort_by(f64::total_cmp);
    let [low, middle, high] = [1, 2, 3].map(|quarter| ratios[quarter * ROUNDS / 4]);
    println!("{name:<34} {:>28}", format!("{middle:.2} ({low:.2} to {high:.2})"));
}
