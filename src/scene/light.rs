//! Lights.

use glam::DVec3;

use super::Rgb;

/// A light and its colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// What the tree calls it.
    pub name: String,
    /// Where it shines from.
    pub kind: LightKind,
    /// Linear RGB; it does not fall off with distance.
    pub color: Rgb,
}

/// Where a light shines from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// From one point.
    Point {
        /// In world space.
        position: DVec3,
    },
    /// From infinitely far away.
    Directional {
        /// Unit vector, the way the light travels.
        direction: DVec3,
    },
}
