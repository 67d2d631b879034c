//! Floor 1: kernels. Pure functions of a ray and a shape, one file a shape, generic over [`Real`](crate::numbers::Real).
//!
//! In every file the lecture's form stands first, its rivals after it, under one signature: `Ok` is a hit, `Err` says why
//! there is none. Nothing here knows of scenes or allocates.

pub mod aabb;
pub mod miss;
pub mod optics;
pub mod plane;
pub mod ray;
pub mod sphere;
pub mod triangle;

pub use aabb::{Aabb, BoxHit};
pub use miss::Miss;
pub use plane::{Plane, PlaneHit};
pub use ray::{Ray, Start};
pub use sphere::{Sphere, SphereHit};
pub use triangle::{Triangle, TriangleHit};
