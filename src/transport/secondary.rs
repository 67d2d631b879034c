//! The two children of a hit: which of them the material asks for, with what weight, and whether they are traced.

use super::leaving::{Leaving, spawn};
use super::recorder::{Children, Kind, Outcome, Recorder, Secondary, Visit};
use super::surface::Surface;
use super::trace::{Budget, Path, Tracer};
use crate::kernels::Ray;
use crate::kernels::optics::{fresnel_exact, fresnel_schlick, reflect, refract, refraction_cosines};
use crate::numbers::{Real, Vector3};
use crate::scene::effects::Effect;
use crate::scene::{Fresnel, Material, Rgb};

/// How a surface splits the light that comes along a ray.
#[derive(Clone, Debug)]
pub struct Split<R: Real> {
    /// Back from the surface, where the material asks for it or total reflection forces it.
    pub reflected: Option<Way<R>>,
    /// Through the surface, where the material asks for it and no total reflection forbids it.
    pub refracted: Option<Way<R>>,
    /// Fresnel reflectance, in [0, 1], where the material asks for it.
    pub fresnel: Option<f64>,
    /// Whether the surface reflects what it should let through.
    pub total_reflection: bool,
}

/// A direction that light takes, and its share.
#[derive(Clone, Debug)]
pub struct Way<R: Real> {
    /// Which of the two.
    pub kind: Secondary,
    /// As long as the incident ray's.
    pub direction: R::Vec3,
    /// The share of what comes along it that goes on along the incident ray.
    pub weight: Rgb,
}

impl<R: Real> Tracer<'_, R> {
    /// How the material at `surface` splits the light.
    pub fn split(&self, ray: &Ray<R>, surface: &Surface<R>) -> Split<R> {
        let material = self.scene().material_of(surface.hit.nearest.object);
        let (d, n) = (ray.direction, surface.shading_normal);
        let [incident, transmitted] = surface.ior;
        let mut split = Split { reflected: None, refracted: None, fresnel: None, total_reflection: false };
        let mut reflection = material.reflection;
        if let Some(transmission) = material.transmission {
            self.begin(Effect::Refraction);
            let direction = refract(d, n, incident, transmitted);
            split.fresnel = reflectance(material, d, n, incident, transmitted);
            if split.fresnel.is_some() {
                self.begin(Effect::Fresnel);
            }
            match direction {
                Some(direction) => {
                    let through = split.fresnel.map_or(1.0, |r| 1.0 - r);
                    let weight = transmission * through;
                    split.refracted = Some(Way { kind: Secondary::Refracted, direction, weight });
                    reflection = reflection.map(|k| k * split.fresnel.unwrap_or(1.0));
                }
                None => {
                    split.total_reflection = true;
                    reflection = Some(match material.fresnel {
                        Some(_) => reflection.unwrap_or(transmission),
                        None => reflection.unwrap_or(Rgb::ZERO) + transmission,
                    });
                }
            }
        } else if let Some(k) = reflection
            && material.fresnel.is_some()
        {
            // An opaque body under a clear coat: no medium begins here, but the coat's index (in `surface.ior`) splits
            // the light.
            self.begin(Effect::Fresnel);
            split.fresnel = reflectance(material, d, n, incident, transmitted);
            reflection = Some(k * split.fresnel.unwrap_or(1.0));
        }
        if let Some(weight) = reflection {
            self.begin(Effect::Reflection);
            split.reflected = Some(Way { kind: Secondary::Reflected, direction: reflect::<R>(d, n), weight });
        }
        split
    }

    /// Whether a ray of this weight is too faint to be traced.
    fn is_too_faint(&self, weight: Rgb, least: f64) -> bool {
        self.begin(Effect::MinWeight);
        weight.max_element() < least
    }

    /// Traces one of the two children, unless the recursion ends here.
    pub(super) fn secondary<Rec: Recorder>(
        &self,
        path: Path<'_, R>,
        surface: &Surface<R>,
        way: &Way<R>,
        budget: &mut Budget,
        recorder: &Rec,
    ) -> (Rgb, Rec::Node) {
        let ray = spawn(surface.point, way.direction);
        let (kind, level, weight) = (Kind::Secondary(way.kind), path.level + 1, path.weight * way.weight);
        let limits = self.limits();
        let outcome = if path.level >= limits.max_depth {
            Outcome::MaxDepth
        } else if limits.min_weight.is_some_and(|least| self.is_too_faint(weight, least)) {
            Outcome::BelowMinWeight
        } else if !budget.take() {
            Outcome::RayBudget
        } else {
            let leaving = Leaving::new(self, path.ray, surface, way.direction, way.kind);
            let inside = match way.kind {
                Secondary::Reflected => path.inside,
                Secondary::Refracted => &surface.beyond,
            };
            let child = Path { kind, level, weight, ray: &ray, departure: leaving.departure(), inside };
            return self.trace(child, budget, recorder);
        };
        let visit = Visit {
            weight: Some(weight),
            radiance: Some(Rgb::ZERO),
            ..Visit::new(self, kind, level, &ray, outcome, Rec::Probe::default())
        };
        (Rgb::ZERO, recorder.node(visit, Children::none()))
    }
}

/// The Fresnel reflectance that the material asks for; 1 at total reflection.
fn reflectance<R: Real>(material: &Material, d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Option<f64> {
    let formula = match material.fresnel? {
        Fresnel::Exact => fresnel_exact::<f64>,
        Fresnel::Schlick => fresnel_schlick::<f64>,
    };
    if incident == transmitted {
        // Nothing parts the two sides; Schlick's formula alone would still reflect at grazing angles.
        return Some(0.0);
    }
    // In f64 whatever the geometry's precision, as all that makes colours.
    let vector = |v: R::Vec3| glam::DVec3::from_array(v.to_f64());
    let (n_i, n_t) = (incident.to_f64(), transmitted.to_f64());
    Some(match refraction_cosines::<f64>(vector(d), vector(n), n_i, n_t) {
        Some([cos_incident, cos_transmitted]) => formula(cos_incident, cos_transmitted, n_i, n_t),
        None => 1.0,
    })
}
