//! Recording is a fold: a recorder makes a node out of a finished ray and its finished children, and sees nothing else.

use super::surface::Surface;
use super::trace::Tracer;
use crate::hits::Probe;
use crate::kernels::Ray;
use crate::numbers::Real;
use crate::scene::{LightId, Rgb};

/// Makes a node out of a finished ray and its finished children. It cannot change what is traced.
pub trait Recorder: Sync {
    /// Sees every test of one ray.
    type Probe: Probe;
    /// What becomes of a ray.
    type Node;
    /// Whether anything is kept. Where not, shadow rays may stop at any blocker.
    const RECORDS: bool;
    /// The node of a ray.
    fn node<R: Real>(&self, visit: Visit<'_, R, Self::Probe>, children: Children<Self::Node>) -> Self::Node;
}

/// Keeps nothing, and costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Off;

impl Recorder for Off {
    type Probe = ();
    type Node = ();
    const RECORDS: bool = false;
    #[inline(always)]
    fn node<R: Real>(&self, _: Visit<'_, R, ()>, _: Children<()>) {}
}

/// What a ray is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// From the eye.
    Camera,
    /// To a light.
    Shadow(LightId),
    /// One of the two children.
    Secondary(Secondary),
}

/// The two children of a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Secondary {
    /// Back from the surface.
    Reflected,
    /// Through the surface.
    Refracted,
}

/// How a ray ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// On a surface.
    Hit,
    /// Nowhere: it brings back the background.
    Background,
    /// A shadow ray that reached its light.
    Lit,
    /// A shadow ray that did not.
    Blocked,
    /// Not traced: deeper than `max_depth`.
    MaxDepth,
    /// Not traced: its weight is below `min_weight`.
    BelowMinWeight,
    /// Not traced: the pixel's rays are spent.
    RayBudget,
}

impl Outcome {
    /// Whether the ray was traced at all.
    pub fn is_traced(self) -> bool {
        !matches!(self, Self::MaxDepth | Self::BelowMinWeight | Self::RayBudget)
    }
}

/// A finished ray. Radiance and local terms are linear RGB before the ray's weight.
#[derive(Debug)]
pub struct Visit<'a, R: Real, P> {
    /// Where the scene and its names are.
    pub tracer: &'a Tracer<'a, R>,
    /// What it was for.
    pub kind: Kind,
    /// The lecture's level: 0 for the camera ray; a shadow ray has that of the hit it starts from.
    pub depth: u32,
    /// The share of its radiance that reaches the pixel; nothing for shadow rays.
    pub weight: Option<Rgb>,
    /// Index of refraction of the medium it travels in; nothing for untraced rays.
    pub ior: Option<f64>,
    /// The ray.
    pub ray: &'a Ray<R>,
    /// Where it ends at the latest, for a ray to a point light.
    pub t_max: Option<f64>,
    /// How it ended.
    pub outcome: Outcome,
    /// What it hit.
    pub surface: Option<&'a Surface<R>>,
    /// What the surface itself sends back along it; nothing unless shaded.
    pub local: Option<Local>,
    /// What it brings back; nothing for shadow rays.
    pub radiance: Option<Rgb>,
    /// Fresnel reflectance at the hit, where the material asks for it.
    pub fresnel: Option<f64>,
    /// Whether the surface reflected what it should have let through.
    pub total_reflection: bool,
    /// The tests it took.
    pub probe: P,
}

impl<'a, R: Real, P> Visit<'a, R, P> {
    /// A ray that ended in this way, and of which nothing more is known.
    pub(super) fn new(
        tracer: &'a Tracer<'a, R>,
        kind: Kind,
        depth: u32,
        ray: &'a Ray<R>,
        outcome: Outcome,
        probe: P,
    ) -> Self {
        Self {
            tracer,
            kind,
            depth,
            weight: None,
            ior: None,
            ray,
            t_max: None,
            outcome,
            surface: None,
            local: None,
            radiance: None,
            fresnel: None,
            total_reflection: false,
            probe,
        }
    }
}

/// What a surface itself sends back, after the shadow verdicts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Local {
    /// The ambient term.
    pub ambient: Rgb,
    /// The terms of each light that a shadow ray was sent to, in the order of the scene. Empty where nothing is
    /// recorded.
    pub lights: Vec<LightTerm>,
    /// The sum of all terms.
    pub sum: Rgb,
}

/// The terms of one light; zero where it is blocked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightTerm {
    /// The light.
    pub light: LightId,
    /// Lambert's term.
    pub diffuse: Rgb,
    /// Phong's highlight.
    pub specular: Rgb,
}

/// The nodes of a hit's children.
#[derive(Debug)]
pub struct Children<N> {
    /// One a shadow ray, in the order of the lights.
    pub shadows: Vec<N>,
    /// The reflected ray, traced or not.
    pub reflected: Option<N>,
    /// The refracted ray, traced or not.
    pub refracted: Option<N>,
}

impl<N> Children<N> {
    /// No children.
    pub fn none() -> Self {
        Self { shadows: Vec::new(), reflected: None, refracted: None }
    }
}
