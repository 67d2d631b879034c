//! The lecture's program in a real scene: the procedures that a lesson has its students write are theirs, the others are given.
//!
//! A [`Program`] hands out what a ray meets ([`Object::intersect`], proven verdicts) and calls one procedure from the other, so
//! that it sees every ray. Out of that it makes the tree of a pixel, in the format of all trees, which [`Pixel`] compares with
//! the right one. Nobody needs an epsilon here: a ray whose origin is a point that was hit before leaves that surface.

mod given;
mod pixel;
mod record;
mod starts;

use std::cell::RefCell;

use glam::DVec3;

use super::Ray;
use crate::hits::Hit as Met;
use crate::numbers::Real;
use crate::scene::{Light, LightKind, ObjectId, Rgb, Scene};
use crate::transport::{Surface, Tracer};
use crate::tree::{Kind, RayNode};

pub use pixel::{Pixel, pixels};
use starts::Starts;

/// Where the picture is seen from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye.
    pub eye: DVec3,
    /// Unit vector into the picture.
    pub forward: DVec3,
    /// Unit vector to the right of the picture.
    pub right: DVec3,
    /// Unit vector to the top of the picture.
    pub up: DVec3,
    /// The angle from the lower to the upper edge of the picture.
    pub fov_y_degrees: f64,
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// Where on the ray.
    pub t: f64,
    /// Where in the world.
    pub point: DVec3,
    /// Unit normal, on the side that the ray comes from.
    pub normal: DVec3,
    /// What the surface does with light.
    pub material: Material,
    /// Index of refraction on the side that the ray comes from.
    pub n1: f64,
    /// Index of refraction beyond the surface.
    pub n2: f64,
    /// Its place among what was met on the way to this pixel.
    place: usize,
}

/// What a surface does with light, at the point of a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// The colour of its ambient and diffuse light.
    pub color: Rgb,
    /// Weight of the ambient light; 0 where there is none.
    pub ambient: Rgb,
    /// Weight of the diffuse light; 0 where there is none.
    pub diffuse: Rgb,
    /// Weight of the highlight; 0 where there is none.
    pub specular: Rgb,
    /// How small the highlight is.
    pub shininess: f64,
    /// Weight of the reflected ray, where the surface reflects.
    pub reflection: Option<Rgb>,
    /// Weight of the refracted ray, where the surface lets light through.
    pub transmission: Option<Rgb>,
}

/// What one light does to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DirectLight {
    /// Lambert's term.
    pub diffuse: Rgb,
    /// Phong's highlight.
    pub specular: Rgb,
}

/// A ray to a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowRay {
    /// The ray.
    pub ray: Ray,
    /// Where the light is on it: what is hit at a smaller t is in the way. Infinite where the light is infinitely far away.
    pub t_max: f64,
}

/// The procedures of the lecture's program.
#[derive(Clone, Copy, Debug)]
pub struct Procedures {
    /// The ray through the middle of a pixel, from the left and from the top.
    pub compute_ray: fn(&Camera, u32, u32) -> Ray,
    /// What a ray brings back.
    pub trace: fn(&Program, u32, &Ray) -> Rgb,
    /// The nearest hit.
    pub intersect: fn(&Program, &Ray) -> Option<Hit>,
    /// What a surface sends back along the ray that has hit it.
    pub shade: fn(&Program, u32, &Ray, &Hit) -> Rgb,
    /// What a light does to a surface.
    pub direct_light: fn(&Program, &Ray, &Hit, &Light) -> DirectLight,
    /// The ray from a point to a light.
    pub shadow_ray: fn(DVec3, &Light) -> ShadowRay,
    /// Whether anything is in the way.
    pub is_blocked: fn(&Program, &ShadowRay) -> bool,
}

impl Procedures {
    /// All as the real tracer has them.
    pub const GIVEN: Procedures = Procedures {
        compute_ray: given::compute_ray,
        trace: given::trace,
        intersect: given::intersect,
        shade: given::shade,
        direct_light: given::direct_light,
        shadow_ray: given::shadow_ray,
        is_blocked: given::is_blocked,
    };
}

/// The lecture's program at work on a pixel.
#[derive(Debug)]
pub struct Program<'s> {
    tracer: &'s Tracer<'s, f64>,
    procedures: Procedures,
    starts: RefCell<Starts>,
    record: RefCell<record::Record>,
}

/// An object of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Object<'p> {
    program: &'p Program<'p>,
    id: ObjectId,
}

impl Object<'_> {
    /// Where a ray meets this object first: at the smallest `t >= 0`, but not at the surface that the ray leaves. `None` where
    /// it does not meet it.
    #[track_caller]
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.program.find(ray, |ray, departure| self.program.tracer.world().nearest_on(ray, self.id, departure))
    }
}

impl<'s> Program<'s> {
    fn new(tracer: &'s Tracer<'s, f64>, procedures: Procedures) -> Self {
        Program { tracer, procedures, starts: RefCell::default(), record: RefCell::default() }
    }

    /// The objects of the scene.
    pub fn objects(&self) -> impl Iterator<Item = Object<'_>> {
        self.scene().object_ids().map(|id| Object { program: self, id })
    }

    /// The lights of the scene.
    pub fn lights(&self) -> &[Light] {
        &self.scene().lights
    }

    /// The lecture's maxLevel: a ray of this level is traced, but none is sent on from where it hits.
    pub fn max_level(&self) -> u32 {
        self.tracer.limits().max_depth
    }

    /// What a ray brings back that hits nothing.
    pub fn background(&self, ray: &Ray) -> Rgb {
        self.scene().background.color(ray.direction)
    }

    /// The nearest hit of a ray.
    #[track_caller]
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.record.borrow_mut().work(self.enough());
        let hit = (self.procedures.intersect)(self, ray);
        if let Some(hit) = &hit {
            self.record.borrow_mut().found(self.tracer, &self.surface(hit));
        }
        hit
    }

    /// What the surface sends back along the ray that has hit it.
    #[track_caller]
    pub fn shade(&self, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
        let mut record = self.record.borrow_mut();
        record.work(self.enough());
        record.hit(self.tracer, &self.surface(hit));
        drop(record);
        self.starts.borrow_mut().begin_shading(hit.place);
        let color = (self.procedures.shade)(self, level, ray, hit);
        self.starts.borrow_mut().end_shading();
        color
    }

    /// What a reflected ray of this level brings back.
    #[track_caller]
    pub fn trace_reflected(&self, level: u32, ray: &Ray) -> Rgb {
        self.visit(Kind::Reflected, level, ray)
    }

    /// What a refracted ray of this level brings back.
    #[track_caller]
    pub fn trace_refracted(&self, level: u32, ray: &Ray) -> Rgb {
        self.visit(Kind::Refracted, level, ray)
    }

    /// What the surface itself sends back: the ambient light, and the direct light of each light of the scene.
    #[track_caller]
    pub fn local_color(&self, ray: &Ray, hit: &Hit) -> Rgb {
        let Material { color, ambient, diffuse, specular, .. } = hit.material;
        self.record.borrow_mut().ambient(ambient * color);
        let mut sum = ambient * color;
        if diffuse != Rgb::ZERO || specular != Rgb::ZERO {
            for light in self.lights() {
                let direct = (self.procedures.direct_light)(self, ray, hit, light);
                self.record.borrow_mut().light(&light.name, direct);
                sum += direct.diffuse + direct.specular;
            }
        }
        sum
    }

    /// Whether a light reaches the surface: sends a shadow ray.
    #[track_caller]
    pub fn is_lit(&self, hit: &Hit, light: &Light) -> bool {
        self.record.borrow_mut().work(self.enough());
        let shadow_ray = (self.procedures.shadow_ray)(hit.point, light);
        let is_blocked = (self.procedures.is_blocked)(self, &shadow_ray);
        let [ior, _] = self.surface(hit).ior;
        self.record.borrow_mut().shadow(&light.name, &shadow_ray, ior, is_blocked);
        !is_blocked
    }

    fn scene(&self) -> &'s Scene {
        self.tracer.scene()
    }

    /// The tree below a ray from the eye.
    fn run(self, ray: &Ray) -> RayNode {
        self.visit(Kind::Camera, 0, ray);
        self.record.into_inner().root(ray)
    }

    /// A ray with all that it brings forth.
    fn visit(&self, kind: Kind, level: u32, ray: &Ray) -> Rgb {
        let ior = self.tracer.ior(&self.starts.borrow().of(self.tracer, ray).inside);
        if !self.record.borrow_mut().begin(kind, ray, ior) {
            return Rgb::ZERO;
        }
        let radiance = (self.procedures.trace)(self, level, ray);
        self.record.borrow_mut().end(radiance);
        radiance
    }

    /// How much work on one ray is a sign that it does not end.
    fn enough(&self) -> usize {
        let scene = self.scene();
        100 * (1 + scene.objects.len()) * (1 + scene.lights.len())
    }

    /// What is hit, and kept so that later rays can leave from there.
    #[track_caller]
    fn find(
        &self,
        ray: &Ray,
        nearest: impl FnOnce(&Ray, crate::hits::Departure<'_>) -> Option<Met<f64>>,
    ) -> Option<Hit> {
        self.record.borrow_mut().work(self.enough());
        let place = self.starts.borrow_mut().meet(self.tracer, ray, nearest)?;
        let surface = self.starts.borrow().surface(place);
        let material = self.scene().material_of(surface.hit.nearest.object);
        let or_zero = |weight: Option<Rgb>| weight.unwrap_or(Rgb::ZERO);
        Some(Hit {
            t: surface.hit.nearest.t,
            point: surface.point,
            normal: surface.shading_normal,
            material: Material {
                color: self.tracer.color_at(&surface),
                ambient: or_zero(material.ambient),
                diffuse: or_zero(material.diffuse),
                specular: or_zero(material.specular.map(|specular| specular.strength)),
                shininess: material.specular.map_or(1.0, |specular| specular.shininess),
                reflection: material.reflection,
                transmission: material.transmission,
            },
            n1: surface.ior[0].to_f64(),
            n2: surface.ior[1].to_f64(),
            place,
        })
    }

    /// The surface of a hit.
    fn surface(&self, hit: &Hit) -> Surface<f64> {
        self.starts.borrow().surface(hit.place)
    }
}

/// The way from a point to a light: all of it to a point light, of length 1 to one that is infinitely far away.
fn way_to(light: &Light, point: DVec3) -> DVec3 {
    match light.kind {
        LightKind::Point { position } => position - point,
        LightKind::Directional { direction } => -direction,
    }
}
