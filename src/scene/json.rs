//! The JSON form of a scene: types that mirror the file key by key, and the way from a text to a [`Scene`].

use std::fmt;

use serde::de::{Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::{Fresnel, Numerics, Scene, validate};
use crate::input::{Located, Named, Problem, name, present, read_json, refuse_arrays_for_objects};
use crate::numbers::Precision;

pub use super::mesh::Transform;

/// A scene: what is seen, by what light, from where.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a scene (an object)")]
pub struct SceneFile {
    /// Where the JSON Schema of this format is, for editors.
    #[serde(rename = "$schema", default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// One sentence on the idea of the scene.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// Size of the picture.
    pub image: ImageFile,
    /// Where the scene is seen from.
    pub camera: CameraFile,
    /// What a ray that hits nothing brings back; black if absent.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub background: Option<BackgroundFile>,
    /// How deep the recursion goes: reflected and refracted rays are traced up to this depth. 5 if absent, 64 at most.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(max = 64)))]
    pub max_depth: Option<u32>,
    /// Rays whose largest weight component is below this are not traced; no such limit if absent.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub min_weight: Option<f64>,
    /// The most rays of one pixel, shadow rays counted; 2^20 if absent.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub ray_budget: Option<u64>,
    /// The precision to trace in; `f64` if absent.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    pub precision: Option<Precision>,
    /// The set of kernels to trace with; `certified` if absent.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    pub numerics: Option<Numerics>,
    /// Lights; none if absent.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lights: Vec<LightFile>,
    /// Materials by name.
    pub materials: Named<MaterialFile>,
    /// Objects. Their order decides ties, and which of overlapping media wins (the last).
    pub objects: Vec<ObjectFile>,
    /// Pixels `[x, y]` worth a look, by name; `[0, 0]` is top left.
    #[serde(default, skip_serializing_if = "no_names")]
    pub pixels: Named<[u32; 2]>,
}

impl SceneFile {
    /// The JSON Schema of the format.
    #[cfg(feature = "schema")]
    pub fn schema() -> schemars::Schema {
        crate::input::schema_of::<Self>()
    }
}

fn no_names<T>(named: &Named<T>) -> bool {
    named.0.is_empty()
}

/// Size of the picture in pixels; at most 2^26 of them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `width` and `height`")]
pub struct ImageFile {
    /// Pixels in a row.
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub width: u32,
    /// Rows.
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub height: u32,
}

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `eye`, `look_at`, `up` and `fov_y_degrees`")]
pub struct CameraFile {
    /// The pinhole.
    pub eye: [f64; 3],
    /// A point in the middle of the picture.
    pub look_at: [f64; 3],
    /// Upwards in the picture; not parallel to the view.
    pub up: [f64; 3],
    /// Vertical field of view in degrees, between 0 and 180.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180)))]
    pub fov_y_degrees: f64,
}

/// What a ray that hits nothing brings back: `[r, g, b]` or a gradient.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum BackgroundFile {
    /// The same everywhere, linear RGB.
    Constant([f64; 3]),
    /// A gradient along the camera's `up`.
    Gradient {
        /// The two ends.
        gradient: GradientFile,
    },
}

/// The ends of a gradient, linear in the cosine between the ray and the camera's `up`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `bottom` and `top`")]
pub struct GradientFile {
    /// Linear RGB seen straight down.
    pub bottom: [f64; 3],
    /// Linear RGB seen straight up.
    pub top: [f64; 3],
}

/// A light: a name and either `point` or `directional`, not both.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a light (an object with `name` and `point` or `directional`)")]
pub struct LightFile {
    /// What the tree calls it; `light 0` and so on if absent.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Light from a point; it does not fall off with distance.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub point: Option<PointLightFile>,
    /// Light from infinitely far away.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub directional: Option<DirectionalLightFile>,
}

/// Light from a point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `position` and `color`")]
pub struct PointLightFile {
    /// Where it is.
    pub position: [f64; 3],
    /// Linear RGB.
    pub color: [f64; 3],
}

/// Light from infinitely far away.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `direction` and `color`")]
pub struct DirectionalLightFile {
    /// The way the light travels, of any length but zero.
    pub direction: [f64; 3],
    /// Linear RGB.
    pub color: [f64; 3],
}

/// What a surface does with light. Every key is optional, and a key that is absent is an effect that is not there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a material (an object)")]
pub struct MaterialFile {
    /// Linear RGB of the ambient and diffuse terms; white if absent. Not together with `checker`.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub color: Option<[f64; 3]>,
    /// Two colours in turn. Not together with `color`.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub checker: Option<CheckerFile>,
    /// Weight of the colour itself, lit or not.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub ambient: Option<Weight>,
    /// Weight of Lambert's term.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub diffuse: Option<Weight>,
    /// Weight of Phong's highlight; asks for `shininess`.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub specular: Option<Weight>,
    /// Exponent of Phong's highlight.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub shininess: Option<f64>,
    /// Weight of the reflected ray.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub reflection: Option<Weight>,
    /// Weight of the refracted ray; asks for `ior`.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub transmission: Option<Weight>,
    /// Index of refraction, larger than 0.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub ior: Option<f64>,
    /// How the angle splits the light between reflection and transmission; asks for `ior`.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    pub fresnel: Option<Fresnel>,
}

/// Two colours in turn: on a plane in two coordinates, elsewhere in three. A face that lies exactly between two layers
/// of cells, such as the top of a box at a multiple of `size`, has the colour of either by chance: move it, or use a
/// plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `colors` and `size`")]
pub struct CheckerFile {
    /// Linear RGB of even and of odd cells.
    pub colors: [[f64; 3]; 2],
    /// The edge of a cell, larger than 0.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub size: f64,
}

/// An object: a shape with a material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `name`, `material` and `shape`")]
pub struct ObjectFile {
    /// What the tree calls it; `sphere 0` and so on if absent.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// A key of `materials`.
    pub material: String,
    /// Where it is.
    pub shape: ShapeFile,
}

/// One shape: an object with exactly one of these keys.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(extend("minProperties" = 1, "maxProperties" = 1)))]
#[serde(deny_unknown_fields, expecting = "a shape such as {\"sphere\": {..}}")]
pub struct ShapeFile {
    /// All points at `radius` from `center`.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub sphere: Option<SphereFile>,
    /// All points `p` with `p . n = distance`, `n` the normal at unit length. The solid lies below it.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub plane: Option<PlaneFile>,
    /// All points between `min` and `max`.
    #[serde(rename = "box", default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub aabb: Option<BoxFile>,
    /// A lone triangle. Its normal is (v1 - v0) x (v2 - v0).
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub triangle: Option<TriangleFile>,
    /// Triangles from a file.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub mesh: Option<MeshFile>,
}

/// All points at `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `center` and `radius`")]
pub struct SphereFile {
    /// The centre.
    pub center: [f64; 3],
    /// 0 or larger.
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub radius: f64,
}

/// A plane in Hesse normal form.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `normal` and `distance`")]
pub struct PlaneFile {
    /// Of any length but zero; it is brought to unit length.
    pub normal: [f64; 3],
    /// Distance from the origin along the unit normal.
    pub distance: f64,
}

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `min` and `max`")]
pub struct BoxFile {
    /// The corner with the smallest coordinates.
    pub min: [f64; 3],
    /// The corner with the largest, nowhere below `min`.
    pub max: [f64; 3],
}

/// A lone triangle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `vertices`")]
pub struct TriangleFile {
    /// v0, v1, v2.
    pub vertices: [[f64; 3]; 3],
}

/// Triangles from an OBJ or PLY file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `file`")]
pub struct MeshFile {
    /// Path of an `.obj` or `.ply` file, relative to the scene.
    pub file: String,
    /// Flat, or smooth by interpolated vertex normals; flat if absent.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    pub normals: Option<MeshNormals>,
    /// Applied to the vertices when the mesh is loaded; the identity if absent.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub transform: Option<Transform>,
}

/// The shading normals of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum MeshNormals {
    /// That of each triangle's plane.
    Flat,
    /// Interpolated from the file's vertex normals, or from angle-weighted ones where it has none.
    Smooth,
}

/// A number for all three colours, or `[r, g, b]`; 0 or larger.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Weight {
    /// For all three colours.
    Gray(#[cfg_attr(feature = "schema", schemars(range(min = 0)))] f64),
    /// For each colour.
    Rgb([f64; 3]),
}

impl<'de> Deserialize<'de> for Weight {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = Weight;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number or [r, g, b]")
            }
            fn visit_f64<E>(self, x: f64) -> Result<Weight, E> {
                Ok(Weight::Gray(x))
            }
            fn visit_u64<E>(self, x: u64) -> Result<Weight, E> {
                Ok(Weight::Gray(x as f64))
            }
            fn visit_i64<E>(self, x: i64) -> Result<Weight, E> {
                Ok(Weight::Gray(x as f64))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Weight, A::Error> {
                <[f64; 3]>::deserialize(serde::de::value::SeqAccessDeserializer::new(seq)).map(Weight::Rgb)
            }
        }
        deserializer.deserialize_any(Either)
    }
}

impl<'de> Deserialize<'de> for BackgroundFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields, expecting = "[r, g, b] or {\"gradient\": {..}}")]
        struct Keys {
            gradient: GradientFile,
        }
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = BackgroundFile;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("[r, g, b] or {\"gradient\": {..}}")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<BackgroundFile, A::Error> {
                let color = serde::de::value::SeqAccessDeserializer::new(seq);
                <[f64; 3]>::deserialize(color).map(BackgroundFile::Constant)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<BackgroundFile, A::Error> {
                let Keys { gradient } = Keys::deserialize(serde::de::value::MapAccessDeserializer::new(map))?;
                Ok(BackgroundFile::Gradient { gradient })
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// A scene, and where it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// The file as the caller named it.
    pub file: String,
    /// SHA-256 of the scene's bytes followed by those of each mesh file in the order of `objects`, in hexadecimal.
    pub sha256: String,
}

/// The scene that the JSON text of `file` holds.
///
/// `read_mesh` gives the bytes of a mesh file, named as in the scene; its error is a sentence on why it cannot.
///
/// # Errors
/// One [`Problem`] for the first thing that is wrong with the text, with a value, or with a mesh.
///
/// # Example
/// ```
/// let text = r#"{
///     "image": { "width": 4, "height": 3 },
///     "camera": { "eye": [0, 0, -5], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 40 },
///     "materials": { "red": { "color": [1, 0, 0], "ambient": 1 } },
///     "objects": [ { "material": "red", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } } ]
/// }"#;
/// let loaded = raytree::scene::load("ball.json", text, &mut |_| Err("no meshes here".into())).unwrap();
/// assert_eq!(loaded.scene.objects[0].name, "sphere 0");
///
/// let wrong = text.replace("radius", "radus");
/// let problem = raytree::scene::load("ball.json", &wrong, &mut |_| Err("no meshes here".into())).unwrap_err();
/// assert!(problem.help.starts_with("did you mean `radius`?"));
/// ```
pub fn load(
    file: &str,
    text: &str,
    read_mesh: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Loaded, Problem> {
    let located = Located { file, text };
    let scene_file: SceneFile = read_json(located)?;
    refuse_arrays_for_objects(located, &scene_file)?;
    let mut hash = Sha256::new();
    hash.update(text.as_bytes());
    let scene = validate::scene(located, &scene_file, &mut |name| {
        let bytes = read_mesh(name)?;
        hash.update(&bytes);
        Ok(bytes)
    })?;
    let sha256 = hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    Ok(Loaded { scene, file: file.to_owned(), sha256 })
}
