//! The tests of a ray as they stand in a tree.

use serde::{Deserialize, Serialize};

use crate::hits::{BoundsVerdict, Quantity, Reason, Test};
use crate::input::{Named, present};
use crate::kernels::Miss;
use crate::scene::ObjectId;

/// One test of a box or a shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum TestRecord {
    /// Of a bounding box.
    Bounds(BoundsRecord),
    /// Of a shape.
    Shape(ShapeRecord),
}

/// A test of a bounding box: does the ray enter it, and before the best hit so far?
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object")]
pub struct BoundsRecord {
    /// The node of the hierarchy, from 0, parents first; absent in a list.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub node: Option<u32>,
    /// There, and true, where that is the hierarchy of the object's triangles, not of the scene's objects.
    #[serde(default, skip_serializing_if = "super::is_false")]
    pub in_mesh: bool,
    /// The object's name, where the box is around one object or a part of it.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub object: Option<String>,
    /// The object's place in the scene.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub shape: Option<u32>,
    /// The triangle, where the box is around one.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub primitive: Option<u32>,
    /// The box's smallest coordinates.
    pub min: [f64; 3],
    /// The box's largest coordinates.
    pub max: [f64; 3],
    /// Where the ray enters, 0 or larger, a little too small; absent where it misses the slab of an axis it runs along.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub t_in: Option<f64>,
    /// Where the ray leaves, a little too large; absent where it never does, or misses.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub t_out: Option<f64>,
    /// Whether what is inside is looked at.
    pub verdict: Verdict,
    /// Why not.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// A test of a shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "an object")]
pub struct ShapeRecord {
    /// The object's name.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub object: Option<String>,
    /// The object's place in the scene.
    pub shape: u32,
    /// The triangle of a mesh.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub primitive: Option<u32>,
    /// The kernel's intermediate values, in the order in which they arise, under the letters of its source.
    #[serde(default)]
    pub values: Named<Value>,
    /// Ray parameter, where there is a hit.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub t: Option<f64>,
    /// Whether this is the best hit so far.
    pub verdict: Verdict,
    /// Why not.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// The outcome of a test.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The ray enters the box.
    Entered,
    /// The shape is the best hit so far.
    Best,
    /// Neither.
    Rejected,
}

/// A number, or the components of a vector. What is infinite or not a number is left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A vector.
    Vector([f64; 3]),
}

impl TestRecord {
    /// The record of a test; `name` gives the names of objects.
    pub(super) fn new(test: Test, name: impl Fn(ObjectId) -> String) -> Self {
        let finite = |t: f64| t.is_finite().then_some(t);
        match test {
            Test::Bounds(test) => {
                let (verdict, reason) = match test.verdict {
                    BoundsVerdict::Entered => (Verdict::Entered, None),
                    BoundsVerdict::Farther => (Verdict::Rejected, Some("farther than the best")),
                    BoundsVerdict::Missed if test.around_one => (Verdict::Rejected, Some("pruned by its box")),
                    BoundsVerdict::Missed => (Verdict::Rejected, Some("t_in > t_out")),
                };
                Self::Bounds(BoundsRecord {
                    node: test.node,
                    in_mesh: test.in_mesh,
                    object: test.object.map(&name),
                    shape: test.object.map(|id| id.0),
                    primitive: test.primitive,
                    min: test.bounds.min,
                    max: test.bounds.max,
                    t_in: finite(test.t_in),
                    t_out: finite(test.t_out),
                    verdict,
                    reason: reason.map(str::to_owned),
                })
            }
            Test::Shape(test) => {
                let (verdict, t, reason) = match test.verdict {
                    crate::hits::Verdict::Best { t } => (Verdict::Best, Some(t), None),
                    crate::hits::Verdict::Rejected { t, reason } => (Verdict::Rejected, t, Some(words(reason))),
                };
                let value = |(name, quantity): (&str, Quantity)| {
                    let value = match quantity {
                        Quantity::Number(x) => Value::Number(finite(x)?),
                        Quantity::Vector(v) => Value::Vector(v.iter().all(|x| x.is_finite()).then_some(v)?),
                    };
                    Some((name.to_owned(), value))
                };
                Self::Shape(ShapeRecord {
                    object: Some(name(test.object)),
                    shape: test.object.0,
                    primitive: test.primitive,
                    values: Named(test.values.into_iter().filter_map(value).collect()),
                    t,
                    verdict,
                    reason: reason.map(str::to_owned),
                })
            }
        }
    }
}

/// A reason in the words that trees use.
fn words(reason: Reason) -> &'static str {
    match reason {
        Reason::Miss(Miss::Parallel) => "parallel",
        Reason::Miss(Miss::Behind) => "behind",
        Reason::Miss(Miss::AIsNegative) => "a < 0",
        Reason::Miss(Miss::BIsNegative) => "b < 0",
        Reason::Miss(Miss::SumExceedsOne) => "a + b > 1",
        Reason::Miss(Miss::SlabsDisjoint) => "t_in > t_out",
        Reason::Miss(Miss::NegativeDiscriminant) => "discriminant negative",
        Reason::Farther => "farther than the best",
        Reason::BeyondLight => "not before the light",
        Reason::Left => "the ray starts on it",
        Reason::CoplanarWithLeft => "in the plane that the ray starts on",
        Reason::WithinEpsilon => "within the epsilon where the ray starts",
        Reason::NotFinite => "t is not finite",
        Reason::BeforeItsBox => "in front of its box",
    }
}
