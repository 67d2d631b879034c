//! Floor 0: numbers. Knows nothing of geometry.
//!
//! Besides the scalar [`Real`] here is what turns a rounded computation into a certain one, in the order of its cost:
//! error-free transformations ([`error_free`]), exact integers where the coordinates fit ([`integers`]), pairs of `f64`
//! ([`double_double`]), sums of any number of `f64` ([`expansion`]), and integers of any length ([`wide`]). The last
//! four share the trait [`Ring`], so that a formula is written once for all of them.

pub mod certificate;
pub mod double_double;
pub mod error_free;
pub mod expansion;
pub mod integers;
mod range;
mod real;
mod ring;
mod unit;
pub mod wide;

pub use certificate::{Certificate, Stage};
pub use double_double::DoubleDouble;
pub use expansion::Expansion;
pub(crate) use range::power_of_two;
pub use range::{flush_tiny, is_in_range};
pub use real::{Precision, Real, Vector3};
pub use ring::{Known, Ring, determinant, dot};
pub use unit::unit;
pub use wide::Wide;

/// Unit roundoff of `f64`, 2^-53: the `u` of every bound in the kernels.
pub const U: f64 = f64::EPSILON / 2.0;
