//! The two children of a hit: which of them the material asks for, with what weight, and whether they are traced.

use super::leaving::{Leaving, spawn};
use super::recorder::{Children, Kind, Outcome, Recorder, Secondary, Visit};
use super::surface::Surface;
use super::trace::{Budget, Path, Tracer};
use crate::kernels::Ray;
use crate::kernels::optics::{fresnel_exact, fresnel_schlick, reflect, refract, refract_usual, refract_with_cosines};
use crate::numbers::Real;
use crate::scene::effects::Effect;
use crate::scene::{Fresnel, Material, Numerics, Rgb};

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

/// Light that passes a boundary.
struct Refraction<R: Real> {
    /// As long as the incident direction.
    direction: R::Vec3,
    /// Of incidence and transmission, in [0, 1]; nothing where nobody asks.
    cosines: Option<[f64; 2]>,
}

impl<R: Real> Tracer<'_, R> {
    /// How the material at `surface` splits the light.
    pub fn split(&self, ray: &Ray<R>, surface: &Surface<R>) -> Split<R> {
        let material = self.scene().material_of(surface.hit.nearest.object);
        let (d, n) = (ray.direction, surface.shading_normal);
        let mut split = Split { reflected: None, refracted: None, fresnel: None, total_reflection: false };
        let mut reflection = material.reflection;
        if let Some(transmission) = material.transmission {
            self.begin(Effect::Refraction);
            let refraction = self.refraction(material.fresnel, d, n, surface.ior);
            split.fresnel = self.reflectance(material, &refraction, surface.ior);
            match refraction {
                Some(Refraction { direction, .. }) => {
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
            let refraction = self.refraction(material.fresnel, d, n, surface.ior);
            split.fresnel = self.reflectance(material, &refraction, surface.ior);
            reflection = Some(k * split.fresnel.unwrap_or(1.0));
        }
        if let Some(weight) = reflection {
            self.begin(Effect::Reflection);
            split.reflected = Some(Way { kind: Secondary::Reflected, direction: reflect::<R>(d, n), weight });
        }
        split
    }

    /// Where the light goes that passes a boundary, by the form that goes with the kernels.
    fn refraction(
        &self,
        fresnel: Option<Fresnel>,
        d: R::Vec3,
        n: R::Vec3,
        [incident, transmitted]: [R; 2],
    ) -> Option<Refraction<R>> {
        match self.world().numerics() {
            Numerics::Lecture | Numerics::Robust => {
                let (direction, cosines) = refract_usual(d, n, incident, transmitted)?;
                Some(Refraction { direction, cosines: Some(cosines.map(Real::to_f64)) })
            }
            Numerics::Certified if fresnel.is_none() => {
                refract(d, n, incident, transmitted).map(|direction| Refraction { direction, cosines: None })
            }
            Numerics::Certified => {
                let (direction, cosines) = refract_with_cosines(d, n, incident, transmitted)?;
                Some(Refraction { direction, cosines: Some(cosines) })
            }
        }
    }

    /// The Fresnel reflectance, if the material asks for it; 1 at total reflection.
    fn reflectance(&self, material: &Material, refraction: &Option<Refraction<R>>, ior: [R; 2]) -> Option<f64> {
        let fresnel = material.fresnel?;
        self.begin(Effect::Fresnel);
        let [incident, transmitted] = ior.map(Real::to_f64);
        if incident == transmitted {
            // Nothing parts the two sides; Schlick's formula alone would still reflect at grazing angles.
            return Some(0.0);
        }
        let Some([cos_incident, cos_transmitted]) = refraction.as_ref().and_then(|r| r.cosines) else {
            return Some(1.0);
        };
        Some(match fresnel {
            Fresnel::Exact => fresnel_exact(cos_incident, cos_transmitted, incident, transmitted),
            Fresnel::Schlick => fresnel_schlick(cos_incident, cos_transmitted, incident, transmitted),
        })
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
        budget: &mut Budget<'_>,
        recorder: &Rec,
    ) -> (Rgb, Rec::Node) {
        let ray = spawn(surface.origin_towards(way.direction), way.direction);
        let (kind, level, weight) = (Kind::Secondary(way.kind), path.level + 1, path.weight * way.weight);
        let limits = self.limits();
        let outcome = if path.level >= limits.max_depth {
            Outcome::MaxDepth
        } else if limits.min_weight.is_some_and(|least| self.is_too_faint(weight, least)) {
            Outcome::BelowMinWeight
        } else if !budget.take() {
            Outcome::RayBudget
        } else {
            let leaving = Leaving::new(self, path.ray, path.departure, surface, way.direction, way.kind);
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
