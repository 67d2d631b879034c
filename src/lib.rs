//! A step-through Whitted ray tracer that keeps the tree of every ray it shoots.
//!
//! The modules are floors; each imports from the ones above it in this list only. `ARCHITECTURE.md` has the map.

pub mod numbers;

pub mod kernels;

pub mod input;
pub mod scene;

pub mod hits;

pub mod transport;

pub mod tree;

#[cfg(feature = "pictures")]
pub mod pictures;

#[cfg(feature = "cli")]
pub mod commands;
