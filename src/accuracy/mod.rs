//! Floor 7: what accuracy costs in time.
//!
//! Sets of rays and shapes ([`sets`]), the referee that knows the exact answers ([`referee`]).

pub mod random;
pub mod referee;
pub mod sets;
