//! What a proven verdict costs: the certified kernels against plain ones on the same rays and shapes, interleaved; medians of
//! ratios.
//!
//! Each is timed in the loop it is made for: one ray against many shapes, keeping the nearest hit. The certified one keeps `t +
//! t_error`, the limit that a walk through a hierarchy would go on with.
//!
//! `cargo bench --bench kernels` runs all rows, `cargo bench --bench kernels -- spheres` those with that in their names.

use std::hint::black_box;
use std::time::Instant;

use glam::DVec3;
use raytree::accuracy::random::Random;
use raytree::kernels::{
    Aabb, Plane, Ray, Sphere, Start, Triangle, TriangleFilter, intersect_box_certified, intersect_box_explicit_zero,
    intersect_plane_certified, intersect_plane_lecture, intersect_sphere_certified, intersect_sphere_stable,
    intersect_triangle_certified, intersect_triangle_moller_trumbore, longest_edge,
};
use raytree::numbers::{Real, Vector3};

const ROUNDS: usize = 61;
const RAYS: usize = 64;
const START: Start = Start::Anywhere;

fn main() {
    println!("{:<52} {:>22}", "set", "ratio (quartiles)");
    println!("triangles: certified / Möller-Trumbore");
    for (aim, name) in [(Aim::Anywhere, "random"), (Aim::Edge, "edges"), (Aim::Vertex, "vertices")] {
        let (narrow, wide) = (Triangles::<f32>::new(aim), Triangles::<f64>::new(aim));
        let (widened, rounded) = (Triangles::<f64>::of(&narrow), Triangles::<f32>::of(&wide));
        compare(&format!("triangles, {name}: f32 / f32"), || narrow.plain(), || narrow.certified());
        compare(&format!("triangles, {name}: f64, the f32 numbers / f32"), || narrow.plain(), || widened.certified());
        compare(&format!("triangles, {name}: f64, its own numbers / f32"), || rounded.plain(), || wide.certified());
        compare(&format!("triangles, {name}: f64 / f64"), || wide.plain(), || wide.certified());
    }
    println!("spheres: certified / stable quadratic");
    for (aimed, name) in [(false, "random"), (true, "aimed")] {
        spheres::<f64>(&format!("spheres, {name}: f64 / f64"), aimed);
        spheres::<f32>(&format!("spheres, {name}: f32 / f32"), aimed);
    }
    println!("boxes: certified / slabs with an explicit zero");
    for (aimed, name) in [(false, "random"), (true, "aimed")] {
        boxes::<f64>(&format!("boxes, {name}: f64 / f64"), aimed);
        boxes::<f32>(&format!("boxes, {name}: f32 / f32"), aimed);
    }
    println!("planes: certified / lecture");
    planes::<f64>("planes, random: f64 / f64");
    planes::<f32>("planes, random: f32 / f32");
    println!("\none ray against many shapes; median of {ROUNDS} interleaved rounds");
}

#[derive(Clone, Copy)]
enum Aim {
    Anywhere,
    Edge,
    Vertex,
}

/// A sphere of 720 triangles without slivers at its poles, and rays from outside.
struct Triangles<R: Real> {
    mesh: Vec<Triangle<R>>,
    rays: Vec<Ray<R>>,
    bounds: Aabb<R>,
    longest: f64,
}

impl<R: Real> Triangles<R> {
    fn new(aim: Aim) -> Self {
        let mut random = Random::new(7);
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
        Self::from(mesh, rays)
    }

    /// The same numbers in another precision.
    fn of<S: Real>(other: &Triangles<S>) -> Self {
        let vector = |v: S::Vec3| R::Vec3::from_f64(v.to_f64());
        Self::from(
            other.mesh.iter().map(|t| Triangle { vertices: t.vertices.map(vector) }).collect(),
            other.rays.iter().map(|r| Ray { origin: vector(r.origin), direction: vector(r.direction) }).collect(),
        )
    }

    fn from(mesh: Vec<Triangle<R>>, rays: Vec<Ray<R>>) -> Self {
        let points: Vec<R::Vec3> = mesh.iter().flat_map(|t| t.vertices).collect();
        let longest = mesh.iter().map(longest_edge).fold(0.0, f64::max);
        Self { bounds: Aabb::of_points(&points), longest, mesh, rays }
    }

    fn plain(&self) -> f64 {
        let unprepared = |_: &Ray<R>| ();
        nearest(&self.rays, &self.mesh, unprepared, |ray, (), t| {
            intersect_triangle_moller_trumbore(ray, t).ok().map(|hit| hit.t)
        })
    }

    fn certified(&self) -> f64 {
        let filter = |ray: &Ray<R>| TriangleFilter::new(ray, &self.bounds, self.longest);
        nearest(&self.rays, &self.mesh, filter, |ray, filter, t| {
            intersect_triangle_certified(ray, t, filter).ok().map(|hit| hit.t + hit.t_error)
        })
    }
}

/// Rays in all directions, of which few meet anything, or rays aimed at a point among the shapes.
fn some_rays<R: Real>(random: &mut Random, aimed: bool) -> Vec<Ray<R>> {
    let vector = |v: DVec3| R::Vec3::from_f64(v.to_array());
    let mut ray = || {
        let (origin, point) = (random.point(3.0), random.point(1.0));
        Ray { origin: vector(origin), direction: vector(if aimed { point - origin } else { point }) }
    };
    (0..RAYS).map(|_| ray()).collect()
}

fn spheres<R: Real>(name: &str, aimed: bool) {
    let mut random = Random::new(8);
    let rays = some_rays::<R>(&mut random, aimed);
    let spheres: Vec<Sphere<R>> = (0..800)
        .map(|_| Sphere {
            center: R::Vec3::from_f64(random.point(1.0).to_array()),
            radius: R::from_f64(0.3 + 0.25 * random.signed()),
        })
        .collect();
    compare(
        name,
        || nearest(&rays, &spheres, |_| (), |ray, (), s| intersect_sphere_stable(ray, s, START).ok().map(|hit| hit.t)),
        || {
            nearest(
                &rays,
                &spheres,
                |_| (),
                |ray, (), s| intersect_sphere_certified(ray, s, START).ok().map(|hit| hit.t + hit.t_error),
            )
        },
    );
}

fn boxes<R: Real>(name: &str, aimed: bool) {
    let mut random = Random::new(9);
    let rays = some_rays::<R>(&mut random, aimed);
    let vector = |v: DVec3| R::Vec3::from_f64(v.to_array());
    let boxes: Vec<Aabb<R>> = (0..800)
        .map(|_| {
            let (center, half) = (random.point(1.0), random.point(0.3).abs());
            Aabb { min: vector(center - half), max: vector(center + half) }
        })
        .collect();
    compare(
        name,
        || {
            nearest(
                &rays,
                &boxes,
                |_| (),
                |ray, (), b| intersect_box_explicit_zero(ray, b, START).ok().map(|hit| hit.t),
            )
        },
        || {
            nearest(
                &rays,
                &boxes,
                |_| (),
                |ray, (), b| intersect_box_certified(ray, b, START).ok().map(|hit| hit.t + hit.t_error),
            )
        },
    );
}

fn planes<R: Real>(name: &str) {
    let mut random = Random::new(10);
    let rays = some_rays::<R>(&mut random, false);
    let planes: Vec<Plane<R>> = (0..800)
        .map(|_| Plane {
            normal: R::Vec3::from_f64(random.point(1.0).normalize().to_array()),
            distance: R::from_f64(random.signed()),
        })
        .collect();
    compare(
        name,
        || nearest(&rays, &planes, |_| (), |ray, (), p| intersect_plane_lecture(ray, p).ok().map(|hit| hit.t)),
        || {
            nearest(
                &rays,
                &planes,
                |_| (),
                |ray, (), p| intersect_plane_certified(ray, p).ok().map(|hit| hit.t + hit.t_error),
            )
        },
    );
}

/// The sum over all rays of the nearest `t` that `test` finds among the shapes.
fn nearest<R: Real, S, P, T: Real>(
    rays: &[Ray<R>],
    shapes: &[S],
    prepare: impl Fn(&Ray<R>) -> P,
    test: impl Fn(&Ray<R>, &P, &S) -> Option<T>,
) -> f64 {
    rays.iter().map(|ray| nearest_of(ray, &prepare(ray), shapes, &test).to_f64()).sum()
}

/// A function of its own for one ray, as a walk through a scene is.
#[inline(never)]
fn nearest_of<R: Real, S, P, T: Real>(
    ray: &Ray<R>,
    prepared: &P,
    shapes: &[S],
    test: &impl Fn(&Ray<R>, &P, &S) -> Option<T>,
) -> T {
    let mut limit = T::INFINITY;
    for shape in shapes {
        if let Some(t) = test(ray, prepared, shape)
            && t < limit
        {
            limit = t;
        }
    }
    limit
}

/// Times both, each round one after the other, and prints the ratio.
fn compare(name: &str, plain: impl Fn() -> f64, certified: impl Fn() -> f64) {
    if std::env::args().skip(1).any(|arg| !arg.starts_with('-') && !name.contains(&arg)) {
        return;
    }
    let seconds = |work: &dyn Fn() -> f64| {
        let start = Instant::now();
        black_box(work());
        start.elapsed().as_secs_f64()
    };
    let mut ratios: Vec<f64> = (0..ROUNDS).map(|_| seconds(&certified) / seconds(&plain)).collect();
    ratios.sort_by(f64::total_cmp);
    let [low, middle, high] = [1, 2, 3].map(|quarter| ratios[quarter * ROUNDS / 4]);
    println!("{name:<52} {:>22}", format!("{middle:.2} ({low:.2} to {high:.2})"));
}
