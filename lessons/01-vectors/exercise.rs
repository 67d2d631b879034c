//! Lesson 01: vectors. Read README.md beside this file, write the five functions, and run
//!
//!     cargo run --example lesson-01
#![allow(unused_variables, reason = "until the functions are written")]

mod check;

use glam::DVec3;

/// The scalar product a . b.
pub fn dot(a: DVec3, b: DVec3) -> f64 {
    todo!()
}

/// The length of a.
pub fn length(a: DVec3) -> f64 {
    todo!()
}

/// The vector of length 1 that points where a points. a is not the zero vector.
pub fn normalize(a: DVec3) -> DVec3 {
    todo!()
}

/// The part of a that lies along b: a's shadow on the line of b. b is not the zero vector.
pub fn project(a: DVec3, b: DVec3) -> DVec3 {
    todo!()
}

/// The cross product a x b, by the rule of Sarrus.
pub fn cross(a: DVec3, b: DVec3) -> DVec3 {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { dot, length, normalize, project, cross })
}
