//! Kernels against a referee that shares no code with them: rational arithmetic.
//!
//! Sets are random with fixed seeds. `cargo test kernels -- --nocapture` prints how often the floating-point forms are
//! wrong.

mod aabb;
mod facing;
mod hard_cases;
mod numbers;
mod optics;
mod order;
mod plane;
mod sphere;
mod triangle;
mod values;

/// How many of every set are held against the referee.
const PAIRS: usize = 100_000;
