//! The fields of a tree in the order in which tracing fills them.

use std::fmt;
use std::str::FromStr;

use crate::input::{nearest, one_of};

/// What two trees may part in, in trace order: the ray, what it meets, direct light, the split, the children, what comes back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// What the ray is for.
    Kind,
    /// The light that a shadow ray goes to.
    Light,
    /// The share that reaches the pixel.
    Weight,
    /// Index of refraction that the ray travels in.
    Ior,
    /// Where the ray starts.
    Origin,
    /// Where it goes.
    Direction,
    /// Where its span ends.
    TMax,
    /// How it ended.
    Outcome,
    /// Whether there is a hit at all; of a shadow ray, whether its blocker is told.
    Hit,
    /// Which object of the scene was hit.
    Shape,
    /// The object's name.
    Object,
    /// The triangle or the face.
    Primitive,
    /// Ray parameter of the hit.
    T,
    /// Where the hit is.
    Point,
    /// Where in the triangle.
    Barycentrics,
    /// The outward normal.
    GeometricNormal,
    /// The normal turned towards the ray.
    ShadingNormal,
    /// Entering or leaving.
    Side,
    /// Indices of refraction on both sides.
    HitIor,
    /// Whether the local terms are told.
    Local,
    /// The ambient term.
    Ambient,
    /// Whether there is a ray to a light.
    Shadows,
    /// Lambert's term of a light.
    Diffuse,
    /// The highlight of a light.
    Specular,
    /// Fresnel reflectance.
    Fresnel,
    /// Whether the surface reflects totally.
    TotalReflection,
    /// Whether there is a reflected ray.
    Reflected,
    /// Whether there is a refracted ray.
    Refracted,
    /// What the ray brings back.
    Radiance,
    /// The tree's colour.
    Color,
}

/// What a number is measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// A length: against the largest coordinate on the way to it.
    Length,
    /// A ray parameter: likewise, in units of the direction.
    Parameter,
    /// Something that is about 1: against 1, or itself where it is larger.
    Unit,
}

impl Field {
    /// All of them, in trace order.
    pub const ALL: [Field; 30] = [
        Field::Kind,
        Field::Light,
        Field::Weight,
        Field::Ior,
        Field::Origin,
        Field::Direction,
        Field::TMax,
        Field::Outcome,
        Field::Hit,
        Field::Shape,
        Field::Object,
        Field::Primitive,
        Field::T,
        Field::Point,
        Field::Barycentrics,
        Field::GeometricNormal,
        Field::ShadingNormal,
        Field::Side,
        Field::HitIor,
        Field::Local,
        Field::Ambient,
        Field::Shadows,
        Field::Diffuse,
        Field::Specular,
        Field::Fresnel,
        Field::TotalReflection,
        Field::Reflected,
        Field::Refracted,
        Field::Radiance,
        Field::Color,
    ];

    /// The keys in the tree's JSON, below the node, with points between.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kind => "kind",
            Self::Light => "light",
            Self::Weight => "weight",
            Self::Ior => "ior",
            Self::Origin => "origin",
            Self::Direction => "direction",
            Self::TMax => "t_max",
            Self::Outcome => "outcome",
            Self::Hit => "hit",
            Self::Shape => "hit.shape",
            Self::Object => "hit.object",
            Self::Primitive => "hit.primitive",
            Self::T => "hit.t",
            Self::Point => "hit.point",
            Self::Barycentrics => "hit.barycentrics",
            Self::GeometricNormal => "hit.geometric_normal",
            Self::ShadingNormal => "hit.shading_normal",
            Self::Side => "hit.side",
            Self::HitIor => "hit.ior",
            Self::Local => "local",
            Self::Ambient => "local.ambient",
            Self::Shadows => "shadows",
            Self::Diffuse => "local.lights.diffuse",
            Self::Specular => "local.lights.specular",
            Self::Fresnel => "fresnel",
            Self::TotalReflection => "total_reflection",
            Self::Reflected => "reflected",
            Self::Refracted => "refracted",
            Self::Radiance => "radiance",
            Self::Color => "color",
        }
    }

    /// Whether it is a number or several, which a tolerance may be given for; the others agree exactly or not at all.
    pub fn is_number(self) -> bool {
        self.measure().is_some()
    }

    pub(super) fn measure(self) -> Option<Measure> {
        match self {
            Self::Origin | Self::Point => Some(Measure::Length),
            Self::T | Self::TMax => Some(Measure::Parameter),
            Self::Weight
            | Self::Ior
            | Self::Direction
            | Self::Barycentrics
            | Self::GeometricNormal
            | Self::ShadingNormal
            | Self::HitIor
            | Self::Ambient
            | Self::Diffuse
            | Self::Specular
            | Self::Fresnel
            | Self::Radiance
            | Self::Color => Some(Measure::Unit),
            Self::Kind
            | Self::Light
            | Self::Outcome
            | Self::Hit
            | Self::Shape
            | Self::Object
            | Self::Primitive
            | Self::Side
            | Self::Local
            | Self::Shadows
            | Self::TotalReflection
            | Self::Reflected
            | Self::Refracted => None,
        }
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Field {
    type Err = String;
    /// # Errors
    /// The names that there are.
    fn from_str(word: &str) -> Result<Self, String> {
        let names = || Self::ALL.into_iter().map(Self::name);
        Self::ALL.into_iter().find(|field| field.name() == word).ok_or_else(|| {
            let near = nearest(word, names()).map_or(String::new(), |near| format!("did you mean `{near}`? "));
            format!("{near}{}", one_of(names()))
        })
    }
}

impl serde::Serialize for Field {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
