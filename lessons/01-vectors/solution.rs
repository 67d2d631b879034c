//! Lesson 01: vectors. A solution.

mod check;

use glam::DVec3;

/// The scalar product a . b.
pub fn dot(a: DVec3, b: DVec3) -> f64 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// The length of a.
pub fn length(a: DVec3) -> f64 {
    dot(a, a).sqrt()
}

/// The vector of length 1 that points where a points. a is not the zero vector.
pub fn normalize(a: DVec3) -> DVec3 {
    a / length(a)
}

/// The part of a that lies along b: a's shadow on the line of b. b is not the zero vector.
pub fn project(a: DVec3, b: DVec3) -> DVec3 {
    dot(a, b) / dot(b, b) * b
}

/// The cross product a x b, by the rule of Sarrus.
pub fn cross(a: DVec3, b: DVec3) -> DVec3 {
    DVec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { dot, length, normalize, project, cross })
}
