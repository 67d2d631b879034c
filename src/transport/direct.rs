//! The lecture's ComputeDirectLight: Phong's local terms, with one shadow ray a light.

use glam::DVec3;

use super::leaving::{Leaving, spawn};
use super::recorder::{Children, Kind, LightTerm, Local, Outcome, Recorder, Secondary, Visit};
use super::surface::Surface;
use super::trace::{Budget, Path, Tracer};
use crate::hits::Limit;
use crate::kernels::Ray;
use crate::numbers::{Real, Vector3};
use crate::scene::effects::Effect;
use crate::scene::{LightId, LightKind, Material, Pigment, Rgb, Shape, Specular};

/// A ray to a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowRay<R: Real> {
    /// The light.
    pub light: LightId,
    /// The ray, of length 1.
    pub ray: Ray<R>,
    /// The distance to the light; nothing if it is infinitely far away.
    pub t_max: Option<f64>,
    /// The cosine between the ray and the shading normal, 0 or larger.
    pub cosine: f64,
}

impl<R: Real> Tracer<'_, R> {
    /// The local terms at `surface`, and the nodes of the shadow rays they took.
    pub(super) fn direct_light<Rec: Recorder>(
        &self,
        path: Path<'_, R>,
        surface: &Surface<R>,
        budget: &mut Budget<'_>,
        recorder: &Rec,
    ) -> (Local, Vec<Rec::Node>) {
        let material = self.scene().material_of(surface.hit.nearest.object);
        let color = self.color_at(surface);
        let ambient = self.ambient(material, color);
        let mut local = Local { ambient, lights: Vec::new(), sum: ambient };
        let mut nodes = Vec::new();
        if !material.takes_direct_light() {
            return (local, nodes);
        }
        for id in self.scene().light_ids() {
            let Some(shadow_ray) = self.shadow_ray(surface, id) else { continue };
            let (lit, node) = self.shadow(path, surface, &shadow_ray, budget, recorder);
            let term = match lit {
                true => self.light_term(path.ray, surface, color, &shadow_ray),
                false => LightTerm { light: id, diffuse: Rgb::ZERO, specular: Rgb::ZERO },
            };
            local.sum += term.diffuse + term.specular;
            if Rec::RECORDS {
                local.lights.push(term);
            }
            nodes.push(node);
        }
        (local, nodes)
    }

    /// The colour of the ambient and diffuse terms; black, and not looked up, where there are none.
    pub fn color_at(&self, surface: &Surface<R>) -> Rgb {
        let id = surface.hit.nearest.object;
        let material = self.scene().material_of(id);
        if material.ambient.is_none() && material.diffuse.is_none() {
            return Rgb::ZERO;
        }
        if let Pigment::Checker { .. } = material.pigment {
            self.begin(Effect::Checker);
        }
        let in_plane = match self.scene().object(id).shape {
            Shape::Plane { normal, .. } => Some(normal),
            _ => None,
        };
        material.pigment.color(vector::<R>(surface.point), in_plane)
    }

    /// The ambient term.
    pub fn ambient(&self, material: &Material, color: Rgb) -> Rgb {
        match material.ambient {
            Some(k) => {
                self.begin(Effect::Ambient);
                k * color
            }
            None => Rgb::ZERO,
        }
    }

    /// The terms of a light that reaches the surface.
    pub fn light_term(&self, incident: &Ray<R>, surface: &Surface<R>, color: Rgb, to: &ShadowRay<R>) -> LightTerm {
        let material = self.scene().material_of(surface.hit.nearest.object);
        let light = self.scene().light(to.light).color;
        let mut term = LightTerm { light: to.light, diffuse: Rgb::ZERO, specular: Rgb::ZERO };
        if let Some(k) = material.diffuse {
            self.begin(Effect::Diffuse);
            term.diffuse = k * color * to.cosine * light;
        }
        if let Some(specular) = material.specular {
            self.begin(Effect::Specular);
            term.specular = highlight(specular, incident, surface, &to.ray) * light;
        }
        term
    }

    /// The ray from a surface to a light.
    ///
    /// # None when
    /// The surface faces away, or the light lies on it: at distance 0, or so far that the distance is not finite.
    pub fn shadow_ray(&self, surface: &Surface<R>, light: LightId) -> Option<ShadowRay<R>> {
        let (direction, t_max) = match self.scene().light(light).kind {
            LightKind::Directional { direction } => (R::Vec3::from_f64((-direction).to_array()), None),
            LightKind::Point { position } => {
                let to_light = R::Vec3::from_f64(position.to_array()) - surface.point;
                let distance = to_light.dot(to_light).sqrt();
                if !(distance > R::ZERO && distance.is_finite()) {
                    return None;
                }
                let [x, y, z] = to_light.to_array();
                (R::Vec3::new(x / distance, y / distance, z / distance), Some(distance.to_f64()))
            }
        };
        let ray = spawn(surface.origin_towards(direction), direction);
        let cosine = vector::<R>(ray.direction).dot(vector::<R>(surface.shading_normal));
        (cosine >= 0.0).then_some(ShadowRay { light, ray, t_max, cosine })
    }

    /// Whether a light reaches the surface along `ray`.
    fn shadow<Rec: Recorder>(
        &self,
        path: Path<'_, R>,
        surface: &Surface<R>,
        shadow_ray: &ShadowRay<R>,
        budget: &mut Budget<'_>,
        recorder: &Rec,
    ) -> (bool, Rec::Node) {
        self.begin(Effect::Shadows);
        let ShadowRay { light, ray, t_max, .. } = shadow_ray;
        let kind = Kind::Shadow(*light);
        if !budget.take() {
            let visit = Visit::new(self, kind, path.level, ray, Outcome::RayBudget, Rec::Probe::default());
            return (false, recorder.node(Visit { t_max: *t_max, ..visit }, Children::none()));
        }
        let limit = t_max.map_or(Limit::None, Limit::Below);
        let leaving = Leaving::new(self, path.ray, path.departure, surface, ray.direction, Secondary::Reflected);
        let mut probe = Rec::Probe::default();
        // A tree tells the nearest blocker; a picture is content with any.
        let (lit, blocker) = if Rec::RECORDS {
            let hit = self.world().nearest_of_valid(ray, limit, leaving.departure(), &mut probe);
            (hit.is_none(), hit.map(|hit| Surface::new(self, ray, hit, path.inside)))
        } else {
            (!self.world().valid_is_hit(ray, limit, leaving.departure()), None)
        };
        let visit = Visit {
            ior: Some(surface.ior[0].to_f64()),
            t_max: *t_max,
            surface: blocker.as_ref(),
            ..Visit::new(self, kind, path.level, ray, if lit { Outcome::Lit } else { Outcome::Blocked }, probe)
        };
        (lit, recorder.node(visit, Children::none()))
    }
}

/// Phong's `strength * max(0, r.v)^shininess`, `r` the light's direction mirrored at the normal, `v` back along the ray.
fn highlight<R: Real>(specular: Specular, incident: &Ray<R>, surface: &Surface<R>, to_light: &Ray<R>) -> Rgb {
    // In f64, and all of length 1 there: a high exponent makes much of little.
    let unit = |v: R::Vec3| vector::<R>(v).normalize();
    let (n, l, d) = (unit(surface.shading_normal), unit(to_light.direction), unit(incident.direction));
    let r = n * (2.0 * n.dot(l)) - l;
    let cosine = (-r.dot(d)).clamp(0.0, 1.0);
    specular.strength * libm::pow(cosine, specular.shininess)
}

fn vector<R: Real>(v: R::Vec3) -> DVec3 {
    DVec3::from_array(v.to_f64())
}
