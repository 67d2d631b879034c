//! What tracing took: rays by kind, and tests.

use std::ops::AddAssign;

use crate::hits::Count;
use crate::numbers::Real;
use crate::transport::{Children, Kind, Recorder, Secondary, Visit};

/// Counts of one ray and all that it brought forth; they add up over pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Costs {
    /// Camera rays.
    pub camera: u64,
    /// Shadow rays.
    pub shadow: u64,
    /// Reflected rays.
    pub reflected: u64,
    /// Refracted rays.
    pub refracted: u64,
    /// Children that the recursion did not trace.
    pub untraced: u64,
    /// Hits that reflected totally.
    pub total_reflections: u64,
    /// Box tests and shape tests. Unlike the rest they depend on the acceleration.
    pub tests: u64,
}

impl Costs {
    /// All rays that were traced.
    pub fn rays(&self) -> u64 {
        self.camera + self.shadow + self.reflected + self.refracted
    }
}

impl AddAssign for Costs {
    fn add_assign(&mut self, other: Self) {
        self.camera += other.camera;
        self.shadow += other.shadow;
        self.reflected += other.reflected;
        self.refracted += other.refracted;
        self.untraced += other.untraced;
        self.total_reflections += other.total_reflections;
        self.tests += other.tests;
    }
}

/// The recorder that counts.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cost;

impl Recorder for Cost {
    type Probe = Count;
    type Node = Costs;
    const RECORDS: bool = true;
    fn node<R: Real>(&self, visit: Visit<'_, R, Count>, children: Children<Costs>) -> Costs {
        let mut costs =
            Costs { total_reflections: u64::from(visit.total_reflection), tests: visit.probe.0, ..Costs::default() };
        let counter = match visit.kind {
            _ if !visit.outcome.is_traced() => &mut costs.untraced,
            Kind::Camera => &mut costs.camera,
            Kind::Shadow(_) => &mut costs.shadow,
            Kind::Secondary(Secondary::Reflected) => &mut costs.reflected,
            Kind::Secondary(Secondary::Refracted) => &mut costs.refracted,
        };
        *counter = 1;
        for child in children.shadows.into_iter().chain(children.reflected).chain(children.refracted) {
            costs += child;
        }
        costs
    }
}

/// The recorder that finds how deep the recursion went: the largest level of a ray that was traced.
#[derive(Clone, Copy, Debug, Default)]
pub struct Deepest;

impl Recorder for Deepest {
    type Probe = ();
    type Node = u32;
    const RECORDS: bool = true;
    fn node<R: Real>(&self, visit: Visit<'_, R, ()>, children: Children<u32>) -> u32 {
        let own = if visit.outcome.is_traced() { visit.depth } else { 0 };
        children.shadows.into_iter().chain(children.reflected).chain(children.refracted).fold(own, u32::max)
    }
}
