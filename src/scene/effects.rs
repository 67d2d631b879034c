//! The census of effects: what a scene calls for, and which object asked. What nobody asked for does not run.

use std::fmt;

use super::{Background, ObjectId, Pigment, Scene, Shape};

/// Something beyond the first hit that a scene can call for. Each is a key in the scene file that may be absent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// A material's own colour, lit or not.
    Ambient,
    /// Lambert's term.
    Diffuse,
    /// Phong's highlight.
    Specular,
    /// A ray to each light.
    Shadows,
    /// A ray back from the surface; total internal reflection sends one too.
    Reflection,
    /// A ray through the surface, and the media it travels in.
    Refraction,
    /// The angle splits the light.
    Fresnel,
    /// Two colours in turn.
    Checker,
    /// Normals interpolated over a mesh.
    SmoothNormals,
    /// A background that changes with direction.
    Gradient,
    /// Rays of little weight are not traced.
    MinWeight,
}

impl Effect {
    /// All of them, in the order in which they are listed.
    pub const ALL: [Self; 11] = [
        Self::Ambient,
        Self::Diffuse,
        Self::Specular,
        Self::Shadows,
        Self::Reflection,
        Self::Refraction,
        Self::Fresnel,
        Self::Checker,
        Self::SmoothNormals,
        Self::Gradient,
        Self::MinWeight,
    ];

    /// Its name, in snake case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ambient => "ambient",
            Self::Diffuse => "diffuse",
            Self::Specular => "specular",
            Self::Shadows => "shadows",
            Self::Reflection => "reflection",
            Self::Refraction => "refraction",
            Self::Fresnel => "fresnel",
            Self::Checker => "checker",
            Self::SmoothNormals => "smooth_normals",
            Self::Gradient => "gradient",
            Self::MinWeight => "min_weight",
        }
    }
}

impl fmt::Display for Effect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Some of the effects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EffectSet(u16);

impl EffectSet {
    /// Whether the effect is one of them.
    #[inline(always)]
    pub fn contains(self, effect: Effect) -> bool {
        self.0 & (1 << effect as u16) != 0
    }

    /// All effects that are not among these.
    pub fn complement(self) -> Self {
        Effect::ALL.into_iter().filter(|&effect| !self.contains(effect)).collect()
    }
}

impl FromIterator<Effect> for EffectSet {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        Self(effects.into_iter().fold(0, |set, effect| set | 1 << effect as u16))
    }
}

/// Who asked for an effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asker {
    /// An object, through its material or its shape.
    Object(ObjectId),
    /// The scene as a whole.
    Scene,
}

/// What `scene` calls for, in the order of [`Effect::ALL`], each with everyone who asked, in the order of the scene.
///
/// # Example
/// A mirror asks for reflection, and for no shadow rays: it has no term that direct light would change.
pub fn census(scene: &Scene) -> Vec<(Effect, Vec<Asker>)> {
    let askers = |effect| {
        let objects = scene.object_ids().filter(|&id| object_asks(scene, id, effect)).map(Asker::Object);
        let scene_asks = match effect {
            Effect::Gradient => matches!(scene.background, Background::Gradient { .. }),
            Effect::MinWeight => scene.limits.min_weight.is_some(),
            _ => false,
        };
        objects.chain(scene_asks.then_some(Asker::Scene)).collect::<Vec<_>>()
    };
    Effect::ALL.into_iter().map(|effect| (effect, askers(effect))).filter(|(_, askers)| !askers.is_empty()).collect()
}

fn object_asks(scene: &Scene, id: ObjectId, effect: Effect) -> bool {
    let material = scene.material_of(id);
    match effect {
        Effect::Ambient => material.ambient.is_some(),
        Effect::Diffuse => material.diffuse.is_some() && !scene.lights.is_empty(),
        Effect::Specular => material.specular.is_some() && !scene.lights.is_empty(),
        Effect::Shadows => material.takes_direct_light() && !scene.lights.is_empty(),
        // What is transparent reflects totally where it must.
        Effect::Reflection => material.reflection.is_some() || material.transmission.is_some(),
        Effect::Refraction => material.transmission.is_some(),
        Effect::Fresnel => {
            material.fresnel.is_some() && (material.reflection.is_some() || material.transmission.is_some())
        }
        Effect::Checker => {
            let seen = material.ambient.is_some() || material.diffuse.is_some();
            seen && matches!(material.pigment, Pigment::Checker { .. })
        }
        Effect::SmoothNormals => {
            matches!(&scene.object(id).shape, Shape::Mesh(mesh) if mesh.corner_normals.is_some())
        }
        Effect::Gradient | Effect::MinWeight => false,
    }
}
