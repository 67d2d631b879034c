//! The lecture's recursion: Trace and Shade.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::leaving::{LeavingPolicy, spawn};
use super::media::Inside;
use super::recorder::{Children, Kind, Off, Outcome, Recorder, Visit};
use super::surface::Surface;
use crate::hits::{Acceleration, Departure, Limit, World};
use crate::kernels::{InvalidRay, Ray};
use crate::numbers::{Real, Vector3};
use crate::scene::effects::{Effect, EffectSet};
use crate::scene::{Background, LightId, LightKind, Limits, Numerics, ObjectId, Rgb, Scene};

/// How to trace, where it is not the scene that says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The kernels.
    pub numerics: Numerics,
    /// What keeps a ray from hitting the surface it starts on; nothing where that goes by the kernels.
    pub leaving: Option<LeavingPolicy>,
    /// How candidates are found.
    pub acceleration: Acceleration,
    /// How the recursion ends.
    pub limits: Limits,
}

impl Options {
    /// What the scene asks for, and the usual for the rest.
    pub fn of(scene: &Scene) -> Self {
        Self {
            numerics: scene.numerics.unwrap_or_default(),
            leaving: None,
            acceleration: Acceleration::default(),
            limits: scene.limits,
        }
    }
}

/// What of a scene is too large for the precision asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// The camera's eye.
    Camera,
    /// A light's position.
    Light(LightId),
    /// An object's coordinates.
    Object(ObjectId),
}

impl Unfit {
    /// What it is, in words.
    pub fn name(self, scene: &Scene) -> String {
        match self {
            Self::Camera => "the camera's eye".to_owned(),
            Self::Light(id) => format!("the light `{}`", scene.light(id).name),
            Self::Object(id) => format!("the object `{}`", scene.object(id).name),
        }
    }
}

/// A scene ready to be traced in one precision.
#[derive(Debug)]
pub struct Tracer<'s, R: Real> {
    scene: &'s Scene,
    world: Arc<World<R>>,
    leaving: LeavingPolicy,
    limits: Limits,
    /// Index of refraction of each object's inside.
    iors: Vec<R>,
    has_media: bool,
    masked: EffectSet,
    stop: Option<&'s AtomicBool>,
}

/// A ray on its way to be traced.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path<'a, R: Real> {
    pub(super) kind: Kind,
    pub(super) level: u32,
    pub(super) weight: Rgb,
    pub(super) ray: &'a Ray<R>,
    pub(super) departure: Departure<'a>,
    pub(super) inside: &'a Inside,
}

/// The rays that a pixel may still take.
#[derive(Debug)]
pub(super) struct Budget<'a> {
    rest: u64,
    stop: Option<&'a AtomicBool>,
}

impl Budget<'_> {
    /// Takes one ray out, or says that none is left: also where nobody waits for the pixel any more.
    pub(super) fn take(&mut self) -> bool {
        match self.rest.checked_sub(1) {
            Some(rest) if !self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed)) => {
                self.rest = rest;
                true
            }
            _ => false,
        }
    }
}

impl<'s, R: Real> Tracer<'s, R> {
    /// Makes `scene` ready.
    ///
    /// # Errors
    /// [`Unfit`] for the first thing with a coordinate above
    /// [`Precision::largest_coordinate`](crate::numbers::Precision).
    pub fn new(scene: &'s Scene, options: Options) -> Result<Self, Unfit> {
        let largest = R::PRECISION.largest_coordinate();
        let fits = |v: glam::DVec3| v.abs().max_element() <= largest;
        if !fits(scene.camera.eye) {
            return Err(Unfit::Camera);
        }
        for id in scene.light_ids() {
            if let LightKind::Point { position } = scene.light(id).kind
                && !fits(position)
            {
                return Err(Unfit::Light(id));
            }
        }
        if let Some(id) = scene.object_ids().find(|&id| scene.object(id).shape.largest_coordinate() > largest) {
            return Err(Unfit::Object(id));
        }
        Ok(Self::with_world(scene, Arc::new(World::new(scene, options.numerics, options.acceleration)), options))
    }

    /// `scene` with the geometry of a tracer that was made of it before, which is most of the work for a large mesh. Of
    /// `options` only what is not about geometry counts.
    pub fn with_world(scene: &'s Scene, world: Arc<World<R>>, options: Options) -> Self {
        let ior = |id| scene.material_of(id).ior.map_or(R::ONE, R::from_f64);
        Self {
            scene,
            leaving: options.leaving.unwrap_or(LeavingPolicy::of(world.numerics())),
            world,
            limits: Limits { max_depth: options.limits.max_depth.min(Limits::DEEPEST), ..options.limits },
            iors: scene.object_ids().map(ior).collect(),
            has_media: scene.object_ids().any(|id| scene.is_medium(id)),
            masked: EffectSet::default(),
            stop: None,
        }
    }

    /// The same tracer with the code of some effects made to panic where it begins, in builds with debug assertions:
    /// that an effect which nobody called for did not run is then more than a counter's word.
    pub fn with_masked(mut self, effects: EffectSet) -> Self {
        self.masked = effects;
        self
    }

    /// The same tracer for work that may have to end in the middle of a pixel: once `stop` is set no more rays are traced, and
    /// what comes back means nothing.
    pub fn with_stop(mut self, stop: &'s AtomicBool) -> Self {
        self.stop = Some(stop);
        self
    }

    /// Where the code of an effect begins.
    #[inline(always)]
    pub(super) fn begin(&self, effect: Effect) {
        debug_assert!(!self.masked.contains(effect), "{effect} runs although it is masked");
    }

    /// The scene.
    pub fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// Its geometry.
    pub fn world(&self) -> &World<R> {
        &self.world
    }

    /// Its geometry, to be kept for [`Tracer::with_world`].
    pub fn shared_world(&self) -> Arc<World<R>> {
        Arc::clone(&self.world)
    }

    /// What keeps a ray from hitting the surface it starts on.
    #[inline(always)]
    pub fn leaving(&self) -> LeavingPolicy {
        self.leaving
    }

    /// How the recursion ends.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Whether there is any medium but the surroundings.
    #[inline(always)]
    pub fn has_media(&self) -> bool {
        self.has_media
    }

    /// Index of refraction where a ray is inside these media; 1 in none.
    pub fn ior(&self, inside: &Inside) -> R {
        inside.medium().map_or(R::ONE, |id| self.iors[id.0 as usize])
    }

    /// Index of refraction of the clear coat on an opaque object: it splits light, but no ray travels in it.
    pub(super) fn clear_coat(&self, id: ObjectId) -> Option<R> {
        let material = self.scene.material_of(id);
        (material.fresnel.is_some() && material.transmission.is_none()).then(|| self.iors[id.0 as usize])
    }

    /// The lecture's ComputeRay and Trace for pixel `(x, y)`: its linear RGB, and what the recorder makes of it.
    pub fn pixel<Rec: Recorder>(&self, x: u32, y: u32, recorder: &Rec) -> (Rgb, Rec::Node) {
        self.camera_ray(&self.ray_of_pixel(x, y), recorder)
    }

    /// The lecture's ComputeRay for pixel `(x, y)`.
    pub fn ray_of_pixel(&self, x: u32, y: u32) -> Ray<R> {
        let ray = self.scene.camera.ray(self.scene.image, x, y);
        let convert = |v: glam::DVec3| R::Vec3::from_f64(v.to_array());
        spawn(convert(ray.origin), convert(ray.direction))
    }

    /// The colour of pixel `(x, y)`, nothing recorded.
    pub fn pixel_color(&self, x: u32, y: u32) -> Rgb {
        self.pixel(x, y, &Off).0
    }

    /// Traces a ray as if it came from the eye: its linear RGB, and what the recorder makes of it.
    ///
    /// # Errors
    /// [`InvalidRay`] for what is no ray, or out of the range of exact arithmetic.
    pub fn ray<Rec: Recorder>(&self, ray: &Ray<R>, recorder: &Rec) -> Result<(Rgb, Rec::Node), InvalidRay> {
        ray.check()?;
        Ok(self.camera_ray(ray, recorder))
    }

    fn camera_ray<Rec: Recorder>(&self, ray: &Ray<R>, recorder: &Rec) -> (Rgb, Rec::Node) {
        let inside = if self.has_media { Inside::at_start(self.scene, &self.world, ray) } else { Inside::default() };
        let path = Path {
            kind: Kind::Camera,
            level: 0,
            weight: Rgb::ONE,
            ray,
            departure: Departure::default(),
            inside: &inside,
        };
        let mut budget = Budget { rest: self.limits.ray_budget, stop: self.stop };
        budget.take();
        self.trace(path, &mut budget, recorder)
    }

    /// The lecture's Trace: Intersect, then Shade or BackgroundColor.
    pub(super) fn trace<Rec: Recorder>(
        &self,
        path: Path<'_, R>,
        budget: &mut Budget<'_>,
        recorder: &Rec,
    ) -> (Rgb, Rec::Node) {
        let mut probe = Rec::Probe::default();
        match self.world.nearest_of_valid(path.ray, Limit::None, path.departure, &mut probe) {
            Some(hit) => {
                let surface = Surface::new(self, path.ray, hit, path.inside);
                self.shade(path, &surface, budget, recorder, probe)
            }
            None => {
                if matches!(self.scene.background, Background::Gradient { .. }) {
                    self.begin(Effect::Gradient);
                }
                let radiance = self.scene.background.color(glam::DVec3::from_array(path.ray.direction.to_f64()));
                let visit = Visit {
                    weight: Some(path.weight),
                    ior: Some(self.ior(path.inside).to_f64()),
                    radiance: Some(radiance),
                    ..Visit::new(self, path.kind, path.level, path.ray, Outcome::Background, probe)
                };
                (radiance, recorder.node(visit, Children::none()))
            }
        }
    }

    /// The lecture's Shade: direct light, plus what the reflected and the refracted ray bring back.
    pub(super) fn shade<Rec: Recorder>(
        &self,
        path: Path<'_, R>,
        surface: &Surface<R>,
        budget: &mut Budget<'_>,
        recorder: &Rec,
        probe: Rec::Probe,
    ) -> (Rgb, Rec::Node) {
        let (local, shadows) = self.direct_light(path, surface, budget, recorder);
        let split = self.split(path.ray, surface);
        let mut color = local.sum;
        let mut children = Children { shadows, reflected: None, refracted: None };
        if let Some(way) = &split.reflected {
            let (radiance, node) = self.secondary(path, surface, way, budget, recorder);
            color += way.weight * radiance;
            children.reflected = Some(node);
        }
        if let Some(way) = &split.refracted {
            let (radiance, node) = self.secondary(path, surface, way, budget, recorder);
            color += way.weight * radiance;
            children.refracted = Some(node);
        }
        let visit = Visit {
            weight: Some(path.weight),
            ior: Some(surface.ior[0].to_f64()),
            surface: Some(surface),
            local: Some(local),
            radiance: Some(color),
            fresnel: split.fresnel,
            total_reflection: split.total_reflection,
            ..Visit::new(self, path.kind, path.level, path.ray, Outcome::Hit, probe)
        };
        (color, recorder.node(visit, children))
    }
}
