//! Which plane a section lies in, and its two axes.
//!
//! The plane always contains the ray that the diagram is about. That leaves a turn about the ray, and it is turned so that as
//! much as possible of the rest of the tree lies in it: every other ray counts with its weight, a shadow ray with a third of
//! it, if both of its ends are in the plane to within [`NEAR`] as seen from the hit; how near the others come only decides
//! between equals. Candidates are the plane of incidence, the upright plane, and those through the ends of the other rays. The
//! first of the best is taken.

use glam::{DVec2, DVec3};

use crate::pictures::diagrams::Input;
use crate::scene::Shape;
use crate::tree::{Kind, NodePath, Outcome, RayNode};

/// The sine of the angle up to which a point counts as in the plane: a tenth of a degree.
const NEAR: f64 = 2e-3;

/// A plane with two axes. Everything is measured from the hit, which keeps it exact far from the origin.
pub(super) struct Plane {
    /// The point that the diagram is about.
    pub(super) origin: DVec3,
    /// The axis to the right.
    pub(super) right: DVec3,
    /// The axis upwards.
    pub(super) up: DVec3,
    /// Towards the reader.
    pub(super) normal: DVec3,
    /// Whether it is the plane of incidence of the ray.
    pub(super) is_of_incidence: bool,
}

/// A ray as the section sees it.
pub(super) struct Ray<'t> {
    pub(super) node: &'t RayNode,
    /// Its line in the tree's text, from 1.
    pub(super) number: usize,
    /// The way to it from the root.
    pub(super) path: String,
    pub(super) start: DVec3,
    pub(super) direction: DVec3,
    /// Where it ends; nothing if it goes on for ever.
    pub(super) end: Option<DVec3>,
    /// How much it matters.
    pub(super) importance: f64,
}

impl<'t> Ray<'t> {
    pub(super) fn new(number: usize, path: &NodePath, node: &'t RayNode) -> Self {
        let (start, direction) = (DVec3::from(node.origin), DVec3::from(node.direction));
        let end = match (&node.hit, node.outcome, node.t_max) {
            (Some(hit), _, _) => Some(DVec3::from(hit.point)),
            (None, Outcome::Lit, Some(t)) => Some(start + t * direction),
            _ => None,
        };
        let weight = node.weight.map_or(0.6, |w| w.into_iter().fold(0.0, f64::max).min(1.0));
        let share = match node.kind {
            Kind::Shadow => 0.33,
            _ if !node.outcome.is_traced() => 0.1,
            _ => 1.0,
        };
        Ray { node, number, path: path.to_string(), start, direction, end, importance: share * (0.2 + 0.8 * weight) }
    }

    /// A point that it goes to: its end, or one on its way.
    fn target(&self) -> DVec3 {
        self.end.unwrap_or(self.start + self.direction)
    }
}

impl Plane {
    /// The plane for a node of a tree with these rays.
    pub(super) fn choose(input: &Input<'_>, rays: &[Ray<'_>]) -> Self {
        let node = input.node;
        let start = DVec3::from(node.origin);
        let along = DVec3::from(node.direction).normalize_or(DVec3::NEG_Z);
        let hit = node.hit.as_ref();
        let origin = hit.map_or(start, |hit| DVec3::from(hit.point));
        let up = axis_nearest(input.scene.camera.up);
        let through = |v: DVec3| along.cross(v.normalize_or_zero()).try_normalize().filter(|_| is_wide(along, v));
        let normal = hit.and_then(|hit| through(DVec3::from(hit.shading_normal.unwrap_or(hit.geometric_normal))));
        let others = rays.iter().filter(|ray| !std::ptr::eq(ray.node, node));
        let points = others.flat_map(|ray| [ray.start, ray.target()]).filter_map(|point| through(point - origin));
        // A ray that meets nothing is shown with the shape that it passes at the smallest angle.
        let passed = input.scene.objects.iter().filter_map(|object| Some(middle(&object.shape)? - start));
        let angle = |v: &DVec3| along.cross(v.normalize_or_zero()).length();
        let passed = passed.filter(|v| v.dot(along) > 0.0).min_by(|a, b| angle(a).total_cmp(&angle(b)));
        let passed = passed.filter(|_| hit.is_none()).and_then(through);
        let any = || along.any_orthonormal_vector();
        let candidates = normal.into_iter().chain(passed).chain(through(up)).chain(points).chain([any()]);
        let mut best: Option<(f64, DVec3)> = None;
        for candidate in candidates {
            let score = rays.iter().map(|ray| ray.importance * contained(ray, origin, candidate)).sum();
            if best.is_none_or(|(most, _)| score > most + 1e-9) {
                best = Some((score, candidate));
            }
        }
        let chosen = best.map_or(any(), |(_, candidate)| candidate);
        let is_of_incidence = normal.is_some_and(|normal| chosen.cross(normal).length() < NEAR);
        Self::seen(origin, along, chosen, up, is_of_incidence)
    }

    /// The plane seen so that `up` is upwards and the ray goes to the right; from above where it lies level.
    fn seen(origin: DVec3, along: DVec3, normal: DVec3, up: DVec3, is_of_incidence: bool) -> Self {
        let upright = up - up.dot(normal) * normal;
        if upright.length() < 0.2 {
            let normal = if normal.dot(up) < 0.0 { -normal } else { normal };
            return Plane { origin, right: along, up: normal.cross(along), normal, is_of_incidence };
        }
        let upright = upright.normalize();
        let right = upright.cross(normal);
        let turn = if right.dot(along) < 0.0 { -1.0 } else { 1.0 };
        Plane { origin, right: turn * right, up: upright, normal: turn * normal, is_of_incidence }
    }

    /// The coordinates of a point's foot in the plane.
    pub(super) fn at(&self, point: DVec3) -> DVec2 {
        self.along(point - self.origin)
    }

    /// The components of a vector along the axes.
    pub(super) fn along(&self, v: DVec3) -> DVec2 {
        DVec2::new(v.dot(self.right), v.dot(self.up))
    }

    /// How far a point lies in front of the plane.
    pub(super) fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal)
    }

    /// Whether a point counts as in the plane.
    pub(super) fn contains(&self, point: DVec3) -> bool {
        self.height(point).abs() <= NEAR * point.distance(self.origin)
    }

    /// Whether the ray lies in the plane.
    pub(super) fn contains_ray(&self, ray: &Ray<'_>) -> bool {
        contained(ray, self.origin, self.normal) >= 1.0
    }
}

/// A point in the middle of a shape that has one.
fn middle(shape: &Shape) -> Option<DVec3> {
    match shape {
        Shape::Sphere { center, .. } => Some(*center),
        Shape::Plane { .. } => None,
        Shape::Box { min, max } => Some((min + max) / 2.0),
        Shape::Triangle { vertices } => Some(vertices.iter().sum::<DVec3>() / 3.0),
        Shape::Mesh(mesh) => {
            let corners = || mesh.triangles.iter().flatten().copied();
            Some((corners().reduce(DVec3::min)? + corners().reduce(DVec3::max)?) / 2.0)
        }
    }
}

/// The axis of the world nearest to the camera's upwards: a camera looks down more often than a floor is tilted.
fn axis_nearest(up: DVec3) -> DVec3 {
    let axis = up.abs().max_position();
    DVec3::AXES[axis] * up[axis].signum()
}

/// 1 for a ray in the plane; less for others, the farther they leave it.
fn contained(ray: &Ray<'_>, origin: DVec3, normal: DVec3) -> f64 {
    let sine = |v: DVec3| v.normalize_or_zero().dot(normal).abs();
    let off = sine(ray.start - origin).max(match ray.end {
        Some(end) => sine(end - origin),
        None => sine(ray.direction),
    });
    if off <= NEAR { 1.0 } else { 0.1 * (1.0 - off).max(0.0) }
}

/// Whether two directions are far enough apart to span a plane.
fn is_wide(along: DVec3, v: DVec3) -> bool {
    along.cross(v.normalize_or_zero()).length() > 1e-4
}
