//! The way from the root of a tree to one of its nodes, in words.

use std::fmt;
use std::str::FromStr;

use super::{RayNode, RayTree};
use crate::input::printable;

/// The way from the root to a node: `root`, `root.reflected.refracted`, `root.shadows[0]`. The first word may be left out.
///
/// # Example
/// ```
/// use raytree::tree::NodePath;
/// let path: NodePath = "reflected.shadows[1]".parse().unwrap();
/// assert_eq!(path.to_string(), "root.reflected.shadows[1]");
/// assert!("reflection".parse::<NodePath>().is_err());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct NodePath(Vec<Branch>);

/// A place below a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Branch {
    /// The shadow ray with this number, from 0.
    Shadow(usize),
    /// The ray back from the surface.
    Reflected,
    /// The ray through the surface.
    Refracted,
}

/// Why there is no node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoSuchNode {
    /// What is wrong.
    pub message: String,
    /// What there is instead.
    pub help: String,
}

impl fmt::Display for NoSuchNode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.message, self.help)
    }
}

impl std::error::Error for NoSuchNode {}

impl NodePath {
    /// The way to the camera ray.
    pub const ROOT: NodePath = NodePath(Vec::new());

    /// The way on to a child.
    pub fn child(&self, branch: Branch) -> Self {
        NodePath(self.0.iter().copied().chain([branch]).collect())
    }

    /// How many branches it takes: 0 for the root.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether it is the way to the root.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The way to the parent; nothing at the root.
    pub fn parent(&self) -> Option<Self> {
        let (_, before) = self.0.split_last()?;
        Some(NodePath(before.to_vec()))
    }

    /// The node at the end of the way.
    ///
    /// # Errors
    /// [`NoSuchNode`] where the tree has no such branch, with those that it has at that place.
    pub fn find<'t>(&self, tree: &'t RayTree) -> Result<&'t RayNode, NoSuchNode> {
        let mut node = &tree.root;
        for (i, &branch) in self.0.iter().enumerate() {
            let child = match branch {
                Branch::Shadow(place) => node.shadows.get(place),
                Branch::Reflected => node.reflected.as_deref(),
                Branch::Refracted => node.refracted.as_deref(),
            };
            node = child.ok_or_else(|| {
                let here = NodePath(self.0[..i].to_vec());
                NoSuchNode { message: format!("there is no {branch} at {here}"), help: offer(&here, node) }
            })?;
        }
        Ok(node)
    }
}

/// What there is below a node.
fn offer(here: &NodePath, node: &RayNode) -> String {
    let name = |branch: Branch, child: &RayNode| match &child.light {
        Some(light) => format!("{branch} to \"{}\"", printable(light)),
        None => branch.to_string(),
    };
    let mut names: Vec<String> = branches(node).map(|(branch, child)| name(branch, child)).collect();
    match names.pop() {
        None => format!("{here} has no children"),
        Some(only) if names.is_empty() => format!("at {here} there is only {only}"),
        Some(last) => format!("at {here} there are {} and {last}", names.join(", ")),
    }
}

/// The children of a node with their places, in the order in which they were traced.
fn branches(node: &RayNode) -> impl DoubleEndedIterator<Item = (Branch, &RayNode)> {
    let shadows = node.shadows.iter().enumerate().map(|(i, child)| (Branch::Shadow(i), child));
    let reflected = node.reflected.as_deref().map(|child| (Branch::Reflected, child));
    let refracted = node.refracted.as_deref().map(|child| (Branch::Refracted, child));
    shadows.chain(reflected).chain(refracted)
}

impl RayTree {
    /// All nodes with the ways to them, in the order in which they were traced, which is that of the lines of the text.
    pub fn nodes(&self) -> Vec<(NodePath, &RayNode)> {
        let mut nodes = Vec::new();
        let mut open = vec![(NodePath::ROOT, &self.root)];
        while let Some((path, node)) = open.pop() {
            open.extend(branches(node).rev().map(|(branch, child)| (path.child(branch), child)));
            nodes.push((path, node));
        }
        nodes
    }
}

impl fmt::Display for NodePath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("root")?;
        self.0.iter().try_for_each(|branch| write!(f, ".{branch}"))
    }
}

impl fmt::Display for Branch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shadow(i) => write!(f, "shadows[{i}]"),
            Self::Reflected => f.write_str("reflected"),
            Self::Refracted => f.write_str("refracted"),
        }
    }
}

impl FromStr for NodePath {
    type Err = NoSuchNode;
    fn from_str(text: &str) -> Result<Self, NoSuchNode> {
        let mut words = text.trim().split('.').peekable();
        words.next_if_eq(&"root");
        words.map(parse_branch).collect::<Result<_, _>>().map(NodePath)
    }
}

fn parse_branch(word: &str) -> Result<Branch, NoSuchNode> {
    let place = |word: &str| word.strip_prefix("shadows[")?.strip_suffix(']')?.parse().ok();
    match word {
        "reflected" => Ok(Branch::Reflected),
        "refracted" => Ok(Branch::Refracted),
        _ => place(word).map(Branch::Shadow).ok_or_else(|| NoSuchNode {
            message: format!("`{}` is no place in a ray tree", printable(word)),
            help: "`root`, or `reflected`, `refracted` and `shadows[0]` with points between: reflected.shadows[0]"
                .into(),
        }),
    }
}
