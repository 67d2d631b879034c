//! Floor 2: the scene, as plain data. Knows nothing of tracing.
//!
//! [`Scene`] and what hangs on it are what is traced; [`json`] reads and writes its JSON form; [`mesh`] brings in OBJ
//! and PLY; [`effects`] says which effects a scene calls for, and who asked.

mod camera;
pub mod effects;
#[cfg(feature = "files")]
mod files;
pub mod json;
mod light;
mod material;
pub mod mesh;
mod object;
mod validate;

use std::fmt;

use glam::DVec3;

pub use camera::{Camera, Resolution};
#[cfg(feature = "files")]
pub use files::{LARGEST_FILE, load_beside, load_file, meshes_beside, open, read_text, scene_files};
pub use json::{Loaded, load};
pub use light::{Light, LightKind};
pub use material::{Fresnel, Material, Pigment, Specular};
pub use object::{Mesh, Object, Shape};

use crate::numbers::Precision;

/// A colour, or a weight of each colour: linear RGB, components 0 or larger.
pub type Rgb = DVec3;

/// The place of an object in [`Scene::objects`]; the `shape` of a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ObjectId(pub u32);

/// The place of a material in [`Scene::materials`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(pub u32);

/// The place of a light in [`Scene::lights`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LightId(pub u32);

/// Everything that is traced: validated, in f64, independent of the file it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// One sentence on the idea of the scene.
    pub about: Option<String>,
    /// Size of the picture.
    pub image: Resolution,
    /// Where it is seen from.
    pub camera: Camera,
    /// What a ray that hits nothing brings back.
    pub background: Background,
    /// How the recursion ends.
    pub limits: Limits,
    /// The precision the scene asks for; the caller may overrule it.
    pub precision: Option<Precision>,
    /// The kernels the scene asks for; the caller may overrule it.
    pub numerics: Option<Numerics>,
    /// Lights, in the order of the file.
    pub lights: Vec<Light>,
    /// Materials, in the order of the file.
    pub materials: Vec<Material>,
    /// Objects, in the order of the file, which decides ties and which medium wins.
    pub objects: Vec<Object>,
    /// Named pixels `(x, y)`, `(0, 0)` top left.
    pub pixels: Vec<(String, [u32; 2])>,
}

impl Scene {
    /// The object with that id.
    pub fn object(&self, id: ObjectId) -> &Object {
        &self.objects[id.0 as usize]
    }

    /// The material of that object.
    pub fn material_of(&self, id: ObjectId) -> &Material {
        &self.materials[self.object(id).material.0 as usize]
    }

    /// The light with that id.
    pub fn light(&self, id: LightId) -> &Light {
        &self.lights[id.0 as usize]
    }

    /// Whether rays inside this object travel in its index of refraction: a solid whose material transmits.
    pub fn is_medium(&self, id: ObjectId) -> bool {
        self.object(id).shape.is_solid() && self.material_of(id).transmission.is_some()
    }

    /// The ids of all objects.
    pub fn object_ids(&self) -> impl Iterator<Item = ObjectId> + use<> {
        (0..self.objects.len() as u32).map(ObjectId)
    }

    /// The ids of all lights.
    pub fn light_ids(&self) -> impl Iterator<Item = LightId> + use<> {
        (0..self.lights.len() as u32).map(LightId)
    }
}

/// What a ray that hits nothing brings back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// The same everywhere.
    Constant(Rgb),
    /// From `bottom` straight down to `top` straight up, linear in the cosine to the camera's `up`.
    Gradient {
        /// Seen along `-up`.
        bottom: Rgb,
        /// Seen along `up`.
        top: Rgb,
        /// Unit vector.
        up: DVec3,
    },
}

impl Background {
    /// The colour seen in a direction of any length but zero.
    pub fn color(&self, direction: DVec3) -> Rgb {
        match *self {
            Self::Constant(color) => color,
            Self::Gradient { bottom, top, up } => {
                let s = (0.5 + 0.5 * up.dot(direction) / direction.length()).clamp(0.0, 1.0);
                bottom * (1.0 - s) + top * s
            }
        }
    }
}

/// How the recursion ends besides diffuse surfaces and the background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The lecture's maxLevel: children are traced where `depth < max_depth`; at most [`Limits::DEEPEST`].
    pub max_depth: u32,
    /// Children whose largest weight component is below this are not traced.
    pub min_weight: Option<f64>,
    /// The most rays of one pixel, shadow rays counted.
    pub ray_budget: u64,
}

impl Limits {
    /// The largest `max_depth`.
    pub const DEEPEST: u32 = 64;
    /// `max_depth` where the scene names none.
    pub const DEFAULT_DEPTH: u32 = 5;
    /// `ray_budget` where the scene names none.
    pub const DEFAULT_BUDGET: u64 = 1 << 20;
}

impl Default for Limits {
    fn default() -> Self {
        Self { max_depth: Self::DEFAULT_DEPTH, min_weight: None, ray_budget: Self::DEFAULT_BUDGET }
    }
}

/// A consistent set of kernels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Numerics {
    /// The lecture's formulas as they stand.
    Lecture,
    /// The usual remedies: Möller-Trumbore, slabs with an explicit zero, a stable quadratic.
    Robust,
    /// A filter with a proven bound, exact arithmetic where it cannot decide.
    #[default]
    Certified,
}

impl fmt::Display for Numerics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lecture => "lecture",
            Self::Robust => "robust",
            Self::Certified => "certified",
        })
    }
}
