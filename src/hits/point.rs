//! The point of a hit, and how far from the true surface it may lie.

use super::nearest::{Candidate, Detail};
use super::world::{Geometry, World};
use crate::kernels::offset::gamma;
use crate::kernels::{Aabb, Ray, Sphere};
use crate::numbers::{Real, Vector3};
use crate::scene::Numerics;

impl<R: Real> World<R> {
    /// The point of a hit: `o + t d`; under certified numerics rounded only once, and brought back onto the surface of a
    /// sphere or box, where rounding has taken it off.
    pub fn point(&self, ray: &Ray<R>, hit: &Candidate<R>) -> R::Vec3 {
        if self.numerics() != Numerics::Certified {
            // Where the verdict itself may be wrong the point stays where its t has put it, so that one sees what that
            // does.
            return R::Vec3::from_f64(finite::<R>(ray.at(R::from_f64(hit.t)).to_f64()));
        }
        // A certified t is good to more than f32 holds, and so is the point until it is rounded.
        let wide = |v: R::Vec3| glam::DVec3::from_array(v.to_f64());
        let point = finite::<R>((wide(ray.origin) + wide(ray.direction) * hit.t).to_array());
        R::Vec3::from_f64(match self.geometry(hit.object) {
            Geometry::Sphere(sphere) => onto_sphere(ray, sphere, hit, point),
            Geometry::Box(aabb) => onto_face(aabb, hit, point),
            Geometry::Plane(_) | Geometry::Triangle(_) | Geometry::Mesh(_) => point,
        })
    }

    /// The point of a hit brought back onto its surface, and a bound on how far it still lies beside it, component by
    /// component. What [`offset_origin`](crate::kernels::offset::offset_origin) wants.
    ///
    /// # Accuracy
    ///
    /// With `gamma(n)` as there: a box's face is met exactly. A triangle's point is summed from its vertices: a product
    /// and two sums each, weights that are 1 in sum up to two roundings, `gamma(7)` of the sum of magnitudes. A
    /// sphere's point is the centre and a radius: scaling it 6 roundings, adding the centre one. A plane's point is
    /// taken down the normal by its distance from the plane: that distance is a sum of four terms with 5 roundings
    /// each, and what it is multiplied by is unit up to 2.
    ///
    /// # Source
    ///
    /// Pharr, Jakob and Humphreys, Physically Based Rendering, section 3.9.4; the bound of the plane is derived here.
    pub fn point_and_error(&self, ray: &Ray<R>, hit: &Candidate<R>) -> (R::Vec3, R::Vec3) {
        let point = R::Vec3::from_f64(finite::<R>(ray.at(R::from_f64(hit.t)).to_f64()));
        let scaled = |v: R::Vec3, factor: R| {
            let [x, y, z] = v.to_array();
            R::Vec3::new(x.abs() * factor, y.abs() * factor, z.abs() * factor)
        };
        let of_triangle = |vertices: [R::Vec3; 3]| {
            let Detail::Triangle { barycentrics } = hit.detail else { return (point, R::Vec3::default()) };
            let (mut sum, mut magnitudes) = (R::Vec3::default(), R::Vec3::default());
            for (vertex, weight) in vertices.into_iter().zip(barycentrics) {
                sum = sum + vertex * weight;
                magnitudes = magnitudes + scaled(vertex, weight.abs());
            }
            (sum, scaled(magnitudes, gamma(7)))
        };
        match self.geometry(hit.object) {
            Geometry::Box(aabb) => (R::Vec3::from_f64(onto_face(aabb, hit, point.to_f64())), R::Vec3::default()),
            Geometry::Triangle(triangle) => of_triangle(triangle.vertices),
            Geometry::Mesh(mesh) => of_triangle(mesh.triangle(hit.primitive).vertices),
            Geometry::Sphere(sphere) => {
                let out = point - sphere.center;
                let length = out.dot(out).sqrt();
                if !(length > R::ZERO) {
                    return (point, R::Vec3::default());
                }
                let out = out * (sphere.radius / length);
                let point = sphere.center + out;
                (point, scaled(out, gamma(6)) + scaled(point, gamma(1)))
            }
            Geometry::Plane(plane) => {
                let (n, p) = (plane.normal, point);
                let foot = p - n * (n.dot(p) - plane.distance);
                let magnitudes = scaled(n, R::ONE).dot(scaled(p, R::ONE)) + plane.distance.abs();
                (foot, scaled(n, gamma::<R>(8) * magnitudes) + scaled(p, gamma(2)))
            }
        }
    }
}

/// Where f32 overflows (a plane seen almost edge-on), the last finite coordinate.
fn finite<R: Real>(point: [f64; 3]) -> [f64; 3] {
    let largest = R::PRECISION.largest();
    point.map(|x| if x.is_nan() { 0.0 } else { x.clamp(-largest, largest) })
}

/// `point` moved onto the face of a box that was hit.
fn onto_face<R: Real>(aabb: &Aabb<R>, hit: &Candidate<R>, mut point: [f64; 3]) -> [f64; 3] {
    let (min, max) = (aabb.min.to_f64(), aabb.max.to_f64());
    for k in 0..3 {
        point[k] = point[k].clamp(min[k], max[k]);
    }
    let face = hit.primitive.unwrap_or_default();
    let axis = face as usize / 2;
    point[axis] = if face.is_multiple_of(2) { min[axis] } else { max[axis] };
    point
}

/// The point of a sphere's hit, from the rounded `o + t d`, which may lie beside the surface.
///
/// Near it, the point is moved along the radius (pbrt, 3rd edition, section 3.9.4). From very far away, where `t` is
/// known to no better than a radius, it is found from the line's foot `q` below the centre and half the chord: `c + q
/// -+ h d / |d|`.
fn onto_sphere<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, hit: &Candidate<R>, point: [f64; 3]) -> [f64; 3] {
    let wide = |v: R::Vec3| glam::DVec3::from_array(v.to_f64());
    let (center, radius) = (wide(sphere.center), sphere.radius.to_f64());
    let mut out = glam::DVec3::from_array(point) - center;
    let (f, d) = (wide(ray.origin) - center, wide(ray.direction));
    // What rounding may have moved the point by, against a part of the radius.
    if 8.0 * R::UNIT_ROUNDOFF.to_f64() * hit.t * d.length() > radius / 4096.0 {
        let along = d / d.length();
        let foot = along.cross(f.cross(along));
        let half_chord = (radius * radius - foot.length_squared()).max(0.0).sqrt();
        let near = matches!(hit.detail, Detail::Sphere { near: true, .. });
        out = foot + along * if near { -half_chord } else { half_chord };
    }
    let length = out.length();
    if length > 0.0 { (center + out * (radius / length)).to_array() } else { point }
}
