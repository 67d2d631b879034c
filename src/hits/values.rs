//! The intermediate values of a test, for showing: those of the kernel that decided, under the letters of its source.

use super::probe::{Quantity, Values};
use super::world::Geometry;
use crate::kernels::{
    Aabb, Plane, Ray, Sphere, Triangle, box_explicit_zero_values, box_lecture_values, plane_values,
    sphere_naive_values, sphere_values, triangle_lecture_values, triangle_moller_trumbore_values,
};
use crate::numbers::{Real, Vector3};
use crate::scene::Numerics;

/// Of a test of an object that is not a mesh. The certified kernels compute in f64.
pub(super) fn of_object<R: Real>(numerics: Numerics, ray: &Ray<R>, geometry: &Geometry<R>) -> Values {
    let vector = widen::<R>;
    match (geometry, numerics) {
        (Geometry::Sphere(sphere), Numerics::Certified) => {
            let wide = Sphere { center: vector(sphere.center), radius: sphere.radius.to_f64() };
            of_sphere::<f64>(numerics, &widened(ray), &wide)
        }
        (Geometry::Plane(plane), Numerics::Certified) => {
            let wide = Plane { normal: vector(plane.normal), distance: plane.distance.to_f64() };
            of_plane::<f64>(&widened(ray), &wide)
        }
        (Geometry::Box(aabb), Numerics::Certified) => {
            let wide = Aabb { min: vector(aabb.min), max: vector(aabb.max) };
            of_box::<f64>(numerics, &widened(ray), &wide)
        }
        (Geometry::Sphere(sphere), _) => of_sphere(numerics, ray, sphere),
        (Geometry::Plane(plane), _) => of_plane(ray, plane),
        (Geometry::Box(aabb), _) => of_box(numerics, ray, aabb),
        (Geometry::Triangle(triangle), _) => of_triangle(numerics, ray, triangle),
        (Geometry::Mesh(_), _) => Values::new(),
    }
}

/// Of a test of a triangle: `a`, `b` and `c = 1 - a - b` weigh v0, v1 and v2, whichever kernel it is. The certified kernel's
/// filter computes what Möller and Trumbore's form does in f64.
pub(super) fn of_triangle<R: Real>(numerics: Numerics, ray: &Ray<R>, triangle: &Triangle<R>) -> Values {
    match numerics {
        Numerics::Lecture => {
            let v = triangle_lecture_values(ray, triangle);
            let mut values = vec![("n", Quantity::Vector(v.n.to_f64())), ("n_dot_d", number(v.n_dot_d))];
            values.extend([("t", number(v.t)), ("p", Quantity::Vector(v.p.to_f64()))]);
            values.extend([("a", v.a), ("b", v.b), ("c", v.c)].map(|(name, x)| (name, number(x))));
            values
        }
        Numerics::Robust => determinants(ray, triangle),
        Numerics::Certified => {
            determinants(&widened(ray), &Triangle::<f64> { vertices: triangle.vertices.map(widen::<R>) })
        }
    }
}

fn determinants<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Values {
    let v = triangle_moller_trumbore_values(ray, triangle);
    [("det", v.det), ("a", v.w), ("b", v.u), ("c", v.v), ("t", v.t)].map(|(name, x)| (name, number(x))).to_vec()
}

fn of_plane<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Values {
    let v = plane_values(ray, plane);
    vec![("n_dot_d", number(v.n_dot_d)), ("n_dot_o", number(v.n_dot_o)), ("t", number(v.t))]
}

fn of_sphere<R: Real>(numerics: Numerics, ray: &Ray<R>, sphere: &Sphere<R>) -> Values {
    let named = |values: &[(&'static str, R)]| values.iter().map(|&(name, x)| (name, number(x))).collect();
    match numerics {
        Numerics::Lecture => {
            let v = sphere_naive_values(ray, sphere);
            named(&[("a", v.a), ("b", v.b), ("c", v.c), ("disc", v.disc), ("t_in", v.t_in), ("t_out", v.t_out)])
        }
        Numerics::Robust | Numerics::Certified => {
            let v = sphere_values(ray, sphere);
            named(&[
                ("a", v.a),
                ("b", v.b),
                ("c", v.c),
                ("l_dot_l", v.l_dot_l),
                ("disc", v.disc),
                ("t_in", v.t_in),
                ("t_out", v.t_out),
            ])
        }
    }
}

fn of_box<R: Real>(numerics: Numerics, ray: &Ray<R>, aabb: &Aabb<R>) -> Values {
    let v = match numerics {
        Numerics::Lecture => box_lecture_values(ray, aabb),
        Numerics::Robust | Numerics::Certified => box_explicit_zero_values(ray, aabb),
    };
    let names = ["t_-x", "t_+x", "t_-y", "t_+y", "t_-z", "t_+z"];
    let faces = names.into_iter().zip(v.t);
    faces.chain([("t_in", v.t_in), ("t_out", v.t_out)]).map(|(name, x)| (name, number(x))).collect()
}

fn number<R: Real>(x: R) -> Quantity {
    Quantity::Number(x.to_f64())
}

fn widen<R: Real>(v: R::Vec3) -> glam::DVec3 {
    glam::DVec3::from_array(v.to_f64())
}

fn widened<R: Real>(ray: &Ray<R>) -> Ray<f64> {
    Ray { origin: widen::<R>(ray.origin), direction: widen::<R>(ray.direction) }
}
