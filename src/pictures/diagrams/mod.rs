//! Diagrams: what a ray did, as geometry. Each reads a finished tree, and of the scene only where its shapes are; every number
//! that is printed is one of the tree.
//!
//! One file a kind. A new kind is a file with a function `draw`, a variant of [`Kind`] and its row in `Kind::row`.

mod contact;
mod formulas;
mod frame;
mod labels;
mod ledger;
mod numbers;
mod parting;
mod plane;
mod section;
mod side;
mod sketch;
mod slabs;
mod sphere;
mod subject;
mod surface;
mod tree;
mod triangle;

use std::fmt;
use std::str::FromStr;

use glam::DVec2;

use super::drawing::Drawing;
use super::theme::Theme;
use crate::input::{nearest, one_of};
use crate::scene::Scene;
use crate::tree::{NoSuchNode, NodePath, RayNode, RayTree};

pub use contact::contact_sheet;
#[cfg(feature = "lessons")]
pub(crate) use frame::begin;
#[cfg(any(feature = "lessons", feature = "pictures"))]
pub(crate) use frame::elided;
#[cfg(feature = "pictures")]
pub(super) use frame::light;
pub use numbers::{shown, shown_vector, tex};
pub use parting::parting;
#[cfg(feature = "lessons")]
pub(crate) use sketch::Sketch;
pub use subject::Chosen;

/// What a diagram shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The ray and a plane.
    Plane,
    /// The ray and a triangle.
    Triangle,
    /// The ray and a box.
    Box,
    /// The ray and a sphere.
    Sphere,
    /// What a surface does to the ray.
    Surface,
    /// The scene cut along the ray, and the tree in it.
    Section,
    /// All rays of the pixel, and what each handed back.
    Tree,
    /// Which ray brought how much of the pixel's colour.
    Ledger,
}

/// What there is to say about a kind.
struct Row {
    name: &'static str,
    about: &'static str,
    draw: fn(&Input<'_>, &Theme) -> Result<Drawing, NotApplicable>,
}

impl Kind {
    /// All of them, in the order in which a page shows them.
    pub const ALL: [Kind; 8] =
        [Kind::Plane, Kind::Triangle, Kind::Box, Kind::Sphere, Kind::Surface, Kind::Section, Kind::Tree, Kind::Ledger];

    fn row(self) -> Row {
        match self {
            Self::Plane => {
                Row { name: "plane", about: "where the ray meets a plane in Hesse normal form", draw: plane::draw }
            }
            Self::Triangle => Row {
                name: "triangle",
                about: "where the ray meets a triangle, with the three inside tests",
                draw: triangle::draw,
            },
            Self::Box => Row { name: "box", about: "when the ray is inside each slab of a box", draw: slabs::draw },
            Self::Sphere => {
                Row { name: "sphere", about: "where the ray enters and leaves a sphere", draw: sphere::draw }
            }
            Self::Surface => Row {
                name: "surface",
                about: "angles, Snell's law and Fresnel's split where the ray goes on",
                draw: surface::draw,
            },
            Self::Section => Row {
                name: "section",
                about: "the scene cut along the ray, with as much of the tree as lies in the cut",
                draw: section::draw,
            },
            Self::Tree => Row {
                name: "tree",
                about: "all rays of the pixel as a tree, with their weights and outcomes",
                draw: tree::draw,
            },
            Self::Ledger => {
                Row { name: "ledger", about: "which ray brought how much of the pixel's colour", draw: ledger::draw }
            }
        }
    }

    /// The word for it.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// What it shows, in a few words.
    pub fn about(self) -> &'static str {
        self.row().about
    }

    /// Whether it shows the whole tree, whatever the node.
    pub fn is_of_the_whole_tree(self) -> bool {
        matches!(self, Self::Tree | Self::Ledger)
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Kind {
    type Err = String;
    /// # Errors
    /// The names that there are.
    fn from_str(word: &str) -> Result<Self, String> {
        let names = || Self::ALL.into_iter().map(Self::name);
        Self::ALL.into_iter().find(|kind| kind.name() == word).ok_or_else(|| {
            let near = nearest(word, names()).map_or(String::new(), |near| format!("did you mean `{near}`? "));
            format!("{near}{}", one_of(names()))
        })
    }
}

/// What a diagram is made of.
#[derive(Clone, Debug)]
pub struct Input<'a> {
    /// The scene, for the geometry of its shapes.
    pub scene: &'a Scene,
    /// The finished tree, recorded with [`Keep::Steps`](crate::tree::Keep::Steps).
    pub tree: &'a RayTree,
    /// The node that the diagram is about, as a way from the root.
    pub path: NodePath,
    /// That node.
    pub node: &'a RayNode,
    /// The shape that a diagram of one test is about; nothing for what the node hits.
    pub chosen: Option<Chosen>,
    /// The canvas at most, in user units; text keeps its size, so that less room means less of it.
    pub size: DVec2,
    /// Where the diagram stands.
    pub setting: Setting,
}

/// Where a diagram stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// Alone: it has to say which pixel it is of.
    Alone,
    /// On a page that says so.
    OnPage,
}

impl<'a> Input<'a> {
    /// The canvas of a diagram that stands alone.
    pub const ALONE: DVec2 = DVec2::new(880.0, 580.0);

    /// A diagram about the node at `path`, on a canvas of its own.
    ///
    /// # Errors
    /// [`NoSuchNode`] where the tree has none there.
    pub fn new(scene: &'a Scene, tree: &'a RayTree, path: NodePath) -> Result<Self, NoSuchNode> {
        let node = path.find(tree)?;
        Ok(Input { scene, tree, path, node, chosen: None, size: Self::ALONE, setting: Setting::Alone })
    }

    /// The same about a shape that the ray was tested against, whether or not it is hit.
    pub fn about(self, chosen: Chosen) -> Self {
        Input { chosen: Some(chosen), ..self }
    }

    /// The same for a part of a page, of at most this size.
    pub fn on_page(self, width: f64, height: f64) -> Self {
        Input { size: DVec2::new(width, height), setting: Setting::OnPage, ..self }
    }

    /// The place of the node among those of the tree, from 1: the number of its line in the tree's text.
    pub fn number(&self) -> usize {
        self.tree.root.walk().position(|node| std::ptr::eq(node, self.node)).map_or(1, |i| i + 1)
    }

    /// The name that the scene has for the tree's pixel.
    pub fn pixel_name(&self) -> Option<&'a str> {
        let pixel = self.tree.pixel?;
        self.scene.pixels.iter().find(|(_, p)| *p == pixel).map(|(name, _)| name.as_str())
    }

    /// A title, which says what the tree is of where nothing else does.
    pub(crate) fn title(&self, words: &str) -> String {
        match self.setting {
            Setting::Alone => format!("{words} of {}", self.of_what()),
            Setting::OnPage => words.to_owned(),
        }
    }

    /// What the tree is of: `pixel 388,190 "glass edge"`.
    pub(crate) fn of_what(&self) -> String {
        match (self.tree.pixel, self.pixel_name()) {
            (Some([x, y]), Some(name)) => format!("pixel {x},{y} “{name}”"),
            (Some([x, y]), None) => format!("pixel {x},{y}"),
            (None, _) => "a ray".to_owned(),
        }
    }
}

/// Why a kind of diagram has nothing to show of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotApplicable {
    /// The kind.
    pub kind: Kind,
    /// What it would need, as a sentence that begins after "because".
    pub why: String,
}

impl fmt::Display for NotApplicable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no {} diagram: {}", self.kind, self.why)
    }
}

impl std::error::Error for NotApplicable {}

/// The diagram of a kind.
///
/// # Errors
/// [`NotApplicable`] where the node has nothing that this kind shows.
pub fn diagram(kind: Kind, input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    (kind.row().draw)(input, theme)
}
