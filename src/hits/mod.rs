//! Floor 3: finding hits. Knows nothing of light.
//!
//! A [`World`] is the geometry of a scene in one precision. [`World::nearest`] finds the nearest hit of a ray, by brute
//! force ([`list`]) or through a bounding volume hierarchy ([`bvh`]); a [`Probe`] sees every test on the way.

pub mod bvh;
pub mod list;
mod nearest;
mod point;
mod probe;
mod slabs;
mod start;
mod test;
mod values;
mod walk;
mod world;

pub use nearest::{Candidate, Detail, Hit, Limit};
pub use probe::{BoundsTest, BoundsVerdict, Count, Probe, Quantity, Reason, ShapeTest, Test, Tests, Values, Verdict};
pub use slabs::{Bounds, SlabRay};
pub use start::{Departure, Left};
pub use world::{Acceleration, Geometry, MeshGeometry, World};
