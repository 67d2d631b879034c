//! The lecture's intersections in f64, with the places where they go wrong.

use glam::DVec3;

use super::Fault;
use crate::scene::{Mesh, Shape};

/// A ray as the textbook has it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub(super) origin: DVec3,
    pub(super) direction: DVec3,
}

/// Where a shape is hit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    pub(super) t: f64,
    pub(super) primitive: Option<u32>,
    pub(super) barycentrics: Option<[f64; 3]>,
    /// Outward.
    pub(super) normal: DVec3,
}

/// The nearest hit of a shape among those that `accepts` takes; `planted` is the fault.
pub(super) fn meet(shape: &Shape, ray: &Ray, planted: Option<Fault>, accepts: &dyn Fn(f64) -> bool) -> Option<Meeting> {
    match shape {
        Shape::Sphere { center, radius } => sphere(*center, *radius, ray, planted, accepts),
        Shape::Plane { normal, distance } => {
            let along = normal.dot(ray.direction);
            if along == 0.0 {
                return None;
            }
            let t = (distance - normal.dot(ray.origin)) / along;
            accepts(t).then_some(Meeting { t, primitive: None, barycentrics: None, normal: *normal })
        }
        Shape::Box { min, max } => slabs(*min, *max, ray, planted, accepts),
        Shape::Triangle { vertices } => triangle(vertices, ray, planted, accepts),
        Shape::Mesh(mesh) => nearest_triangle(mesh, ray, planted, accepts),
    }
}

/// `|o + t d - c|^2 = r^2`, solved for `t`.
fn sphere(
    center: DVec3,
    radius: f64,
    ray: &Ray,
    planted: Option<Fault>,
    accepts: &dyn Fn(f64) -> bool,
) -> Option<Meeting> {
    let from_center = ray.origin - center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * from_center.dot(ray.direction);
    let c = from_center.dot(from_center) - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let solve = |root: f64| match planted {
        Some(Fault::QuadraticPrecedence) => (-b + root) / 2.0 * a,
        _ => (-b + root) / (2.0 * a),
    };
    let root = discriminant.sqrt();
    let (near, far) = (solve(-root), solve(root));
    let t = match planted {
        Some(Fault::EntryWhenInside) => accepts(near).then_some(near),
        _ => [near, far].into_iter().find(|t| accepts(*t)),
    }?;
    let out = ray.origin + ray.direction * t - center;
    let normal = if planted == Some(Fault::NormalNotUnit) { out } else { out / out.length() };
    Some(Meeting { t, primitive: None, barycentrics: None, normal })
}

/// The largest of the smaller ones, the smallest of the larger ones.
fn slabs(min: DVec3, max: DVec3, ray: &Ray, planted: Option<Fault>, accepts: &dyn Fn(f64) -> bool) -> Option<Meeting> {
    let (mut t_in, mut t_out) = (f64::NEG_INFINITY, f64::INFINITY);
    let (mut face_in, mut face_out) = (0, 0);
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        if d == 0.0 {
            if o < min[axis] || o > max[axis] {
                return None;
            }
            continue;
        }
        let (mut smaller, mut larger) = ((min[axis] - o) / d, (max[axis] - o) / d);
        let (mut first, mut second) = (2 * axis as u32, 2 * axis as u32 + 1);
        if smaller > larger && planted != Some(Fault::SlabsUnsorted) {
            (smaller, larger) = (larger, smaller);
            (first, second) = (second, first);
        }
        if smaller > t_in {
            (t_in, face_in) = (smaller, first);
        }
        if larger < t_out {
            (t_out, face_out) = (larger, second);
        }
    }
    if t_in > t_out {
        return None;
    }
    let accepted_behind = planted == Some(Fault::BoxBehind) && t_out < 0.0 && accepts(-t_out);
    let (t, face) = match planted {
        _ if accepted_behind || accepts(t_in) => (t_in, face_in),
        Some(Fault::EntryWhenInside) => return None,
        _ => (t_out, face_out),
    };
    if !(accepted_behind || accepts(t)) {
        return None;
    }
    let mut normal = DVec3::ZERO;
    normal[face as usize / 2] = if face % 2 == 0 { -1.0 } else { 1.0 };
    Some(Meeting { t, primitive: Some(face), barycentrics: None, normal })
}

/// The plane of the triangle, then the weights `[a, b, 1-a-b]` of its vertices.
fn triangle(
    vertices: &[DVec3; 3],
    ray: &Ray,
    planted: Option<Fault>,
    accepts: &dyn Fn(f64) -> bool,
) -> Option<Meeting> {
    let [v0, v1, v2] = *vertices;
    let normal = match planted {
        Some(Fault::WindingReversed) => (v2 - v0).cross(v1 - v0),
        _ => (v1 - v0).cross(v2 - v0),
    };
    let along = normal.dot(ray.direction);
    if along == 0.0 {
        return None;
    }
    let t = normal.dot(v0 - ray.origin) / along;
    if !accepts(t) {
        return None;
    }
    // The areas of the parts, with the sign of the whole.
    let p = ray.origin + ray.direction * t;
    let whole = normal.dot(normal);
    let sign = if planted == Some(Fault::WindingReversed) { -1.0 } else { 1.0 };
    let a = sign * (v2 - v1).cross(p - v1).dot(normal) / whole;
    let b = sign * (v0 - v2).cross(p - v2).dot(normal) / whole;
    let c = 1.0 - a - b;
    let inside = match planted {
        Some(Fault::ParallelogramForTriangle) => a >= 0.0 && b >= 0.0 && a <= 1.0 && b <= 1.0,
        _ => a >= 0.0 && b >= 0.0 && c >= 0.0,
    };
    let weights = if planted == Some(Fault::BarycentricsPermuted) { [b, c, a] } else { [a, b, c] };
    inside.then_some(Meeting { t, primitive: None, barycentrics: Some(weights), normal: normal / normal.length() })
}

fn nearest_triangle(mesh: &Mesh, ray: &Ray, planted: Option<Fault>, accepts: &dyn Fn(f64) -> bool) -> Option<Meeting> {
    let mut nearest: Option<Meeting> = None;
    for (i, vertices) in mesh.triangles.iter().enumerate() {
        if let Some(hit) = triangle(vertices, ray, planted, accepts)
            && nearest.is_none_or(|nearest| hit.t < nearest.t)
        {
            nearest = Some(Meeting { primitive: Some(i as u32), ..hit });
        }
    }
    nearest
}
