//! Floor 1: kernels. Pure functions of a ray and a shape, one file (or folder) a shape, generic over
//! [`Real`](crate::numbers::Real).
//!
//! In every file the lecture's form stands first, its rivals after it, under one signature: `Ok` is a hit, `Err` says
//! why there is none. The certified forms decide exactly, and say how well they know `t` ([`Certified`]); `certify_*`
//! says how a hit was decided. `*_values` give a form's intermediate values for showing them. Nothing here knows of
//! scenes, and nothing allocates but the exact stages that hardly a ray calls for.
//!
//! The shares of wrong verdicts quoted here are printed by `cargo test kernels -- --nocapture`, the costs by `cargo bench
//! --bench kernels`.

pub mod aabb;
mod certified;
mod facing;
pub mod miss;
pub mod offset;
pub mod optics;
pub mod order;
pub mod plane;
pub mod ray;
pub mod sphere;
pub mod triangle;

pub use aabb::{
    Aabb, BoxHit, BoxValues, box_explicit_zero_values, box_lecture_values, box_stage, certify_box,
    intersect_box_certified, intersect_box_explicit_zero, intersect_box_lecture,
};
pub use certified::Certified;
pub use facing::{plane_facing, triangle_facing, triangle_normal};
pub use miss::Miss;
pub use offset::{gamma, offset_origin};
pub(crate) use optics::refraction_sign;
pub use optics::{
    certify_total_reflection, fresnel_exact, fresnel_schlick, is_total_reflection, reflect, refract, refract_usual,
    refract_with_cosines, refraction_cosines,
};
pub use order::{Root, compare_t, compare_t_with};
pub use plane::{
    Plane, PlaneHit, PlaneValues, certify_plane, intersect_plane_certified, intersect_plane_lecture, plane_stage,
    plane_values,
};
pub use ray::{InvalidRay, Ray, Start};
pub use sphere::{
    Sphere, SphereHit, SphereNaiveValues, SphereValues, certify_sphere, intersect_sphere_certified,
    intersect_sphere_exact, intersect_sphere_naive, intersect_sphere_stable, sphere_naive_values, sphere_stage,
    sphere_values,
};
pub use triangle::{
    Triangle, TriangleFilter, TriangleHit, TriangleLectureValues, TriangleValues, are_coplanar, certify_triangle,
    intersect_triangle_certified, intersect_triangle_exact, intersect_triangle_lecture,
    intersect_triangle_moller_trumbore, intersect_triangle_watertight, longest_edge, triangle_lecture_values,
    triangle_moller_trumbore_values, triangle_stage, triangle_watertight_values,
};
