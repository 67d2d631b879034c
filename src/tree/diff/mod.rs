//! Where two ray trees part: the first node and field, and what follows from it.
//!
//! Structure has to agree exactly, numbers within [`Tolerances`]. Nodes are aligned by their place, shadow rays by the name of
//! their light. What is optional in the format, and one of the trees has nowhere, was not written by its tracer: it is named
//! once in [`Difference::missing`] and parts nothing. How a verdict was reached (certificates, tests) is not compared.

mod align;
mod field;
mod forest;
mod text;
mod tolerance;

use serde::{Serialize, Serializer};

pub use field::Field;
pub use forest::{Bin, ForestDifference};
pub use tolerance::{Distance, Tolerance, Tolerances};

use super::{Kind, NodePath, RayNode, RayTree};

/// Where two trees part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// All of it, in trace order: the first is where they part first. Empty where they agree.
    pub divergences: Vec<Divergence>,
    /// The colours of both.
    pub colors: [[f64; 3]; 2],
    /// The rays of both.
    pub rays: [u64; 2],
    /// What one of them has nowhere.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<Missing>,
    /// What else is to be known: trees of different pixels, scenes or settings.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The largest distance, by its share of what is allowed, of two numbers that agree.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nearest_agreement: Option<Divergence>,
    /// How far numbers may be apart.
    pub tolerances: Tolerances,
}

impl Difference {
    /// Where they part first.
    pub fn first(&self) -> Option<&Divergence> {
        self.divergences.first()
    }

    /// Whether they agree.
    pub fn is_same(&self) -> bool {
        self.divergences.is_empty()
    }

    /// The difference as JSON, indented.
    pub fn to_json(&self) -> String {
        super::layout::to_string(self)
    }
}

/// One value in which two trees part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Divergence {
    /// The node: its place in A, or in B where A has none.
    #[serde(serialize_with = "as_text")]
    pub path: NodePath,
    /// What the node's ray is for.
    pub kind: Kind,
    /// What parts.
    pub field: Field,
    /// The light, where the field is of one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<String>,
    /// Its value in A; nothing where A has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub a: Option<Value>,
    /// Its value in B; nothing where B has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub b: Option<Value>,
    /// How far apart they are, where both are numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance: Option<Distance>,
    /// What the node brings to the pixel in B less what it brings in A, linear RGB: weight times radiance, or, for a light's
    /// terms and its shadow ray, weight times the change of the terms.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub effect: Option<[f64; 3]>,
    /// Whether it follows from an earlier one: a point from its `t`, a child from its parent's hit, a radiance from what is
    /// below it.
    pub consequence: bool,
}

fn as_text<S: Serializer>(path: &NodePath, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(path)
}

/// A value of a field.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A number.
    Number(f64),
    /// Several.
    Numbers(Vec<f64>),
    /// The place of a shape or primitive.
    Place(u32),
    /// A word of the format, or a name.
    Word(String),
    /// Yes or no.
    Flag(bool),
}

/// A field that one tree has and the other one nowhere.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Missing {
    /// The field.
    pub field: Field,
    /// The tree that does not have it.
    pub tree: Which,
    /// Of how many rays.
    pub rays: u64,
}

/// One of the two trees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub enum Which {
    /// The first.
    A,
    /// The second.
    B,
}

/// Where `b` parts from `a`.
///
/// # Example
/// A surface that is hit a little later, and, as nothing else was changed, a hit point that no longer follows from it:
/// ```
/// use raytree::tree::diff::{Field, Tolerances, diff};
/// use raytree::tree::{HitRecord, Kind, Outcome, RayNode, RayTree};
/// let mut root = RayNode::new(Kind::Camera, 0, [0.0, 0.0, -5.0], [0.0, 0.0, 1.0], Outcome::Hit);
/// root.hit = Some(HitRecord::new(4.0, [0.0, 0.0, -1.0], 0, [0.0, 0.0, -1.0]));
/// let a = RayTree::new([0.5, 0.0, 0.0], root);
/// let mut b = a.clone();
/// b.root.hit.as_mut().unwrap().t = 4.5;
/// let difference = diff(&a, &b, &Tolerances::default());
/// let first = difference.first().unwrap();
/// assert_eq!((first.path.to_string().as_str(), first.field), ("root", Field::T));
/// assert!(diff(&a, &a, &Tolerances::default()).is_same());
/// ```
pub fn diff(a: &RayTree, b: &RayTree, tolerances: &Tolerances) -> Difference {
    align::compare(a, b, tolerances)
}

/// The same place of two trees.
#[derive(Clone, Debug)]
pub struct Pair<'t> {
    /// The place: that in A, or in B where A has no ray there.
    pub path: NodePath,
    /// How many rays above it there are.
    pub depth: usize,
    /// The ray in A.
    pub a: Option<&'t RayNode>,
    /// The ray in B.
    pub b: Option<&'t RayNode>,
}

/// Both trees as one: all places that either of them has, in trace order, shadow rays aligned by their lights.
pub fn pairs<'t>(a: &'t RayTree, b: &'t RayTree) -> Vec<Pair<'t>> {
    align::pairs(a, b)
}
