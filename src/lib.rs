//! A step-through Whitted ray tracer that keeps the tree of every ray it shoots.

pub mod kernels;
pub mod numbers;
