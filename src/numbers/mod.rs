//! Floor 0: numbers. Knows nothing of geometry.

mod real;

pub use real::{Precision, Real, Vector3};
