//! Floor 7: what checks an exercise of the course in `lessons/`.
//!
//! A lesson is data and plain functions: a [`Lesson`] has [`Stage`]s, a stage is a [`Task`] with a student's function, a task has
//! [`Case`]s, the true [`Answer`] and the [`Fault`]s that students are known to make. [`Lesson::check`] runs the function on the
//! cases and returns a [`Report`], which is what a grader reads, and the picture of the first failing case.
//!
//! The lessons themselves stand in `lessons/NN-name/check.rs`, outside the library, so that a change to an exercise compiles two
//! small files. `commands::lesson` is what they run.

mod answer;
mod attempt;
mod choices;
pub mod grading;
mod hierarchy;
mod mesh_view;
pub mod pictures;
mod program;
pub mod questions;
mod report;
mod task;
mod words;

pub use answer::{Answer, TOLERANCE, Value};
pub use choices::{Choice, Reading, depths_and_weights};
pub use hierarchy::{Build, Builder, Hierarchy, Inside, Item, Nearest, Node, Walk, Walked, hit};
pub use mesh_view::{MeshView, Rendered};
pub use program::{Camera, DirectLight, Hit, Material, Object, Pixel, Procedures, Program, ShadowRay, pixels};
pub use report::{Broken, Failure, FailureKind, Lesson, Mistake, Outcome, Report, StageReport};
pub use task::{Case, Checked, Fault, Picture, Stage, Task, random_cases};
pub use words::shown;

/// A ray in f64: `origin + t direction`, `t >= 0`.
pub type Ray = crate::kernels::Ray<f64>;
/// A plane in Hesse form: `p . normal - distance = 0`.
pub type Plane = crate::kernels::Plane<f64>;
/// A triangle: `vertices` are v0, v1, v2.
pub type Triangle = crate::kernels::Triangle<f64>;
/// Where a ray meets a triangle: `t`, and `barycentrics` a, b, 1-a-b.
pub type TriangleHit = crate::kernels::TriangleHit<f64>;
/// A box with faces along the axes: `min` and `max` are two opposite corners.
pub type Aabb = crate::kernels::Aabb<f64>;
/// A sphere: `center` and `radius`.
pub type Sphere = crate::kernels::Sphere<f64>;
pub use crate::accuracy::random::Random;
pub use crate::faults::Fault as ClassicFault;
pub use crate::scene::{Light, LightKind, Rgb};

/// The part of a ray's line that lies in something, as the values of t at its two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Where the line comes in.
    pub t_in: f64,
    /// Where it goes out; never smaller than `t_in` in a span that is not empty.
    pub t_out: f64,
}
