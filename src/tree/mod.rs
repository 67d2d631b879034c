//! Floor 5: what was seen. The ray tree, its forms and what can be read off it. Knows nothing of drawing.
//!
//! A [`RayTree`] is plain data with the keys of the JSON format `raytree/1`; a key that is absent means "not there".
//! [`record_pixel`] makes one, [`text`](RayTree::to_text) prints one, [`Ledger`] adds one up, [`check`] reads
//! anybody's.

pub mod check;
mod costs;
pub mod diff;
mod layout;
mod ledger;
mod path;
mod record;
mod steps;
mod text;

use serde::{Deserialize, Serialize};

pub use costs::{Cost, Costs, Deepest};
pub use ledger::{Entry, Ledger};
pub use path::{Branch, NoSuchNode, NodePath};
#[cfg(feature = "lessons")]
pub(crate) use record::hit_record;
pub use record::{Keep, Origin, record_pixel, record_ray};
pub use steps::{BoundsRecord, ShapeRecord, TestRecord, Value, Verdict};
pub use text::Show;
pub(crate) use text::six_digits;

use crate::input::{name, present};
use crate::numbers::{Certificate, Precision};
use crate::scene::Numerics;
pub use crate::transport::{LeavingPolicy, Outcome, Side};

/// The format's name and version, the value of the key `format`.
pub const FORMAT: &str = "raytree/1";

/// Every ray that one camera ray brought forth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a ray tree (an object)")]
pub struct RayTree {
    /// `raytree/1`.
    #[cfg_attr(feature = "schema", schemars(extend("const" = "raytree/1")))]
    pub format: String,
    /// The program that wrote it.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub generator: Option<Generator>,
    /// The scene it was traced in.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneRef>,
    /// How it was traced.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub settings: Option<Settings>,
    /// The pixel `[x, y]`, `[0, 0]` top left; absent for a ray that belongs to none.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub pixel: Option<[u32; 2]>,
    /// Linear RGB of the sample.
    pub color: [f64; 3],
    /// How many rays were traced, shadow rays counted, untraced nodes not.
    pub rays: u64,
    /// The camera ray.
    pub root: RayNode,
}

/// The program that wrote a tree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `name`")]
pub struct Generator {
    /// Its name.
    pub name: String,
    /// Its version.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
}

/// The scene that a tree was traced in.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `file`")]
pub struct SceneRef {
    /// The file as it was named.
    pub file: String,
    /// SHA-256 of the file's bytes followed by those of its meshes in the order of `objects`, in hexadecimal.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
}

/// How a tree was traced: whatever can change it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object")]
pub struct Settings {
    /// Of the geometry; colours are always f64.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    pub precision: Option<Precision>,
    /// The set of kernels.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    pub numerics: Option<Numerics>,
    /// What keeps a ray from hitting the surface it starts on.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub leaving: Option<LeavingPolicy>,
    /// The depth up to which children are traced.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub max_depth: Option<u32>,
    /// Children whose largest weight component is below this are not traced.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub min_weight: Option<f64>,
    /// The most rays that are traced, shadow rays counted.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub ray_budget: Option<u64>,
}

/// One ray and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a ray (an object)")]
pub struct RayNode {
    /// What the ray is for.
    pub kind: Kind,
    /// The light that a shadow ray goes to.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub light: Option<String>,
    /// The recursion's level: 0 for the camera ray; a shadow ray has that of the hit it starts from.
    pub depth: u32,
    /// The share of its radiance that reaches the pixel, linear RGB. Shadow rays have none.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub weight: Option<[f64; 3]>,
    /// Index of refraction of the medium that the ray travels in; absent for untraced rays.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub ior: Option<f64>,
    /// Where the ray starts.
    pub origin: [f64; 3],
    /// Where it goes; `t` is in units of its length.
    pub direction: [f64; 3],
    /// A hit counts where `t < t_max`; only where the span is bounded, as for a ray to a point light.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub t_max: Option<f64>,
    /// How it ended.
    pub outcome: Outcome,
    /// What it hit.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub hit: Option<HitRecord>,
    /// How the verdict on the hit was reached: a function of the ray and the reported primitive alone.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Certificate>,
    /// How it was decided whether the surface reflects totally; where there are two indices of refraction to decide by.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub refraction_certificate: Option<Certificate>,
    /// What the surface itself sends back, after the shadow verdicts, before the weight.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub local: Option<Local>,
    /// What the ray brings back, before its weight, linear RGB. Shadow rays bring none.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub radiance: Option<[f64; 3]>,
    /// Fresnel reflectance at the hit, in [0, 1], where the material asks for it.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub fresnel: Option<f64>,
    /// There, and true, where the surface reflected totally what it should have let through.
    #[serde(default, skip_serializing_if = "is_false")]
    pub total_reflection: bool,
    /// A ray to each light that the surface faces, in the order of the scene.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shadows: Vec<RayNode>,
    /// The ray back from the surface.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub reflected: Option<Box<RayNode>>,
    /// The ray through the surface.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub refracted: Option<Box<RayNode>>,
    /// Every test of a box or shape, in order; only where steps were asked for.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub tests: Option<Vec<TestRecord>>,
}

fn is_false(b: &bool) -> bool {
    !b
}

/// Writes `value` as JSON in the layout of trees: indented, an array of numbers on one line.
///
/// # Errors
/// What `out` says, and what cannot be JSON.
pub fn write_indented(out: &mut dyn std::io::Write, value: &impl Serialize) -> std::io::Result<()> {
    layout::write(out, value)
}

/// What a ray is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// From the eye.
    Camera,
    /// To a light.
    Shadow,
    /// Back from a surface.
    Reflected,
    /// Through a surface.
    Refracted,
}

/// What a ray hit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a hit (an object)")]
pub struct HitRecord {
    /// Ray parameter, 0 or larger, in units of the direction's length.
    pub t: f64,
    /// Where, in world space.
    pub point: [f64; 3],
    /// The object's name.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub object: Option<String>,
    /// The object's place in the scene's `objects`, from 0.
    pub shape: u32,
    /// The triangle's place in its mesh, or the box's face: 0 to 5 for -x, +x, -y, +y, -z, +z.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub primitive: Option<u32>,
    /// `[a, b, 1-a-b]`, the weights of a triangle's v0, v1, v2.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub barycentrics: Option<[f64; 3]>,
    /// Unit and outward, never flipped; of a triangle (v1 - v0) x (v2 - v0).
    pub geometric_normal: [f64; 3],
    /// Unit, turned towards the ray.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub shading_normal: Option<[f64; 3]>,
    /// `entering` exactly when the ray goes against the geometric normal; absent for lone triangles.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    pub side: Option<Side>,
    /// Index of refraction on the incident and on the transmitted side.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub ior: Option<[f64; 2]>,
}

/// What a surface itself sends back along a ray, after the shadow verdicts, before the ray's weight.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `ambient` and `lights`")]
pub struct Local {
    /// The ambient term, linear RGB.
    #[serde(default)]
    pub ambient: [f64; 3],
    /// The terms of each light that a shadow ray was sent to.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lights: Vec<LightTerms>,
}

/// The terms of one light; zero where it is blocked.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object with `light`, `diffuse` and `specular`")]
pub struct LightTerms {
    /// The light's name.
    pub light: String,
    /// Lambert's term, linear RGB.
    #[serde(default)]
    pub diffuse: [f64; 3],
    /// Phong's highlight, linear RGB.
    #[serde(default)]
    pub specular: [f64; 3],
}

impl Kind {
    /// Its word in the format.
    pub fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Shadow => "shadow",
            Self::Reflected => "reflected",
            Self::Refracted => "refracted",
        }
    }
}

impl RayNode {
    /// A ray with its outcome and nothing else; whoever emits a tree fills in what there is. Weight 1, but none for
    /// shadow rays.
    pub fn new(kind: Kind, depth: u32, origin: [f64; 3], direction: [f64; 3], outcome: Outcome) -> Self {
        Self {
            kind,
            light: None,
            depth,
            weight: (kind != Kind::Shadow).then_some([1.0; 3]),
            ior: None,
            origin,
            direction,
            t_max: None,
            outcome,
            hit: None,
            certificate: None,
            refraction_certificate: None,
            local: None,
            radiance: None,
            fresnel: None,
            total_reflection: false,
            shadows: Vec::new(),
            reflected: None,
            refracted: None,
            tests: None,
        }
    }

    /// The children in the order in which they were traced: shadow rays, reflected, refracted.
    pub fn children(&self) -> impl Iterator<Item = &RayNode> {
        self.shadows.iter().chain(self.reflected.as_deref()).chain(self.refracted.as_deref())
    }

    /// This node and all below it, depth first, in the order in which they were traced.
    pub fn walk(&self) -> impl Iterator<Item = &RayNode> {
        let mut open = vec![self];
        std::iter::from_fn(move || {
            let node = open.pop()?;
            let from = open.len();
            open.extend(node.children());
            open[from..].reverse();
            Some(node)
        })
    }
}

impl HitRecord {
    /// A hit with what every hit has; whoever emits a tree fills in the rest.
    pub fn new(t: f64, point: [f64; 3], shape: u32, geometric_normal: [f64; 3]) -> Self {
        Self {
            t,
            point,
            object: None,
            shape,
            primitive: None,
            barycentrics: None,
            geometric_normal,
            shading_normal: None,
            side: None,
            ior: None,
        }
    }
}

impl RayTree {
    /// The tree below `root`, of the linear RGB `color`, with its rays counted.
    ///
    /// # Example
    /// Any renderer can put what it did into a tree, and keep the text as a snapshot:
    /// ```
    /// use raytree::tree::{HitRecord, Kind, Outcome, RayNode, RayTree, Show};
    /// let mut root = RayNode::new(Kind::Camera, 0, [0.0, 0.0, -5.0], [0.0, 0.0, 1.0], Outcome::Hit);
    /// root.hit = Some(HitRecord::new(4.0, [0.0, 0.0, -1.0], 0, [0.0, 0.0, -1.0]));
    /// let tree = RayTree::new([0.5, 0.0, 0.0], root);
    /// assert_eq!(tree.to_text(Show::default()).lines().next(), Some("ray   rgb 0.5 0 0   1 ray"));
    /// ```
    pub fn new(color: [f64; 3], root: RayNode) -> Self {
        let rays = root.walk().filter(|node| node.outcome.is_traced()).count() as u64;
        Self { format: FORMAT.to_owned(), generator: None, scene: None, settings: None, pixel: None, color, rays, root }
    }

    /// The same tree without the tests that its rays took: as recorded with [`Keep::Outcomes`].
    pub fn without_tests(&self) -> Self {
        fn forget(node: &mut RayNode) {
            node.tests = None;
            let children = node.shadows.iter_mut().chain(node.reflected.as_deref_mut());
            children.chain(node.refracted.as_deref_mut()).for_each(forget);
        }
        let mut tree = self.clone();
        forget(&mut tree.root);
        tree
    }

    /// The tree as JSON, indented; numbers are the shortest decimals that read back to the same bits.
    pub fn to_json(&self) -> String {
        layout::to_string(self)
    }

    /// Writes what [`RayTree::to_json`] gives, piece by piece.
    ///
    /// # Errors
    /// What `out` says.
    pub fn write_json(&self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        layout::write(out, self)
    }

    /// The tree as JSON on one line, with a line feed at its end: an entry of a forest.
    pub fn to_json_line(&self) -> String {
        // Finite numbers and text under text keys cannot fail.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    /// The JSON Schema of the format.
    #[cfg(feature = "schema")]
    pub fn schema() -> schemars::Schema {
        crate::input::schema_of::<Self>()
    }
}
