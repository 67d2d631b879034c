//! Floor 5: the recursion step by step. Knows nothing of drawing, printing, files.
//!
//! A finished tree, recorded with [`Keep::Steps`](crate::tree::Keep::Steps), unrolls into an ordered list of [`Step`]s: a
//! [`Recording`]. Each step belongs to a line of the lecture's pseudocode ([`PSEUDOCODE`]) and to a node of the tree, and
//! has, where something is computed, the arithmetic of it ([`arithmetic`]). Nothing is traced anew: a [`Player`] moves in the
//! list, and the call stack with its variables is a fold over it ([`Recording::stack`]). Terminal and browser play the same
//! list.
//!
//! A formula is shown only if working it out gives the tree's number to the same bits. Where another way led to the number,
//! words say so.
//!
//! # Example
//! ```
//! use raytree::steps::{Event, Player, Recording};
//! use raytree::transport::{Options, Tracer};
//! use raytree::tree::{Keep, Origin, record_pixel};
//! let text = include_str!("../../scenes/first-hit.json");
//! let loaded = raytree::scene::load("first-hit.json", text, &mut |_| Err("no mesh is needed".into()))?;
//! let tracer = Tracer::<f64>::new(&loaded.scene, Options::of(&loaded.scene)).expect("f64 holds every scene");
//! let tree = record_pixel(&tracer, Origin { loaded: &loaded, keep: Keep::Steps }, 160, 120);
//! let recording = Recording::of(&loaded.scene, &tree);
//! let mut player = Player::new(&recording);
//! assert!(player.until(&Event::Hit));
//! let stack: Vec<&str> = recording.stack(player.at()).iter().map(|frame| frame.procedure.name()).collect();
//! assert_eq!(stack, ["RayTrace", "Trace", "Intersect"]);
//! # Ok::<(), raytree::input::Problem>(())
//! ```

pub mod arithmetic;
mod book;
mod events;
mod json;
mod names;
mod player;
mod pseudocode;
mod question;
mod stack;
mod tested;
mod unroll;

use crate::scene::Scene;
use crate::tree::{NodePath, RayNode, RayTree, TestRecord, Value};

use arithmetic::value_of;
pub use arithmetic::{Arithmetic, Form, Values, Worked};
pub use events::{Event, NoSuchEvent};
pub use player::Player;
pub use pseudocode::{CodeLine, PSEUDOCODE, Procedure};
pub use question::Question;
pub use stack::{Frame, Variable};

/// The format's name and version, the value of the key `format`.
pub const FORMAT: &str = "raytree-recording/1";

/// A tree unrolled into steps.
#[derive(Clone, Debug)]
pub struct Recording<'a> {
    /// The tree.
    pub tree: &'a RayTree,
    /// Its nodes, in the order of [`RayTree::nodes`].
    pub nodes: Vec<Node<'a>>,
    /// The formulas that the steps use, each once.
    pub forms: Vec<Form>,
    /// The steps, in order.
    pub steps: Vec<Step>,
}

/// A node of the tree, as steps and front ends name it.
#[derive(Clone, Debug)]
pub struct Node<'a> {
    /// The way to it.
    pub path: NodePath,
    /// The ray.
    pub ray: &'a RayNode,
    /// Its parent's place in [`Recording::nodes`]; nothing for the root.
    pub parent: Option<usize>,
    /// What kind of ray it is and what became of it, in a few words.
    pub name: String,
    /// What its own light adds to the pixel: weight times local terms, or times the background. Linear RGB.
    pub contribution: [f64; 3],
    /// The values that the formulas of all its steps share: the ray itself and the reciprocals of its direction.
    pub values: Values,
}

/// A step: a line of the pseudocode that is carried out, and what comes of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Step {
    /// The line's place in [`PSEUDOCODE`].
    pub line: usize,
    /// The node's place in [`Recording::nodes`].
    pub node: usize,
    /// The procedure that this step enters: a frame is pushed.
    pub call: Option<Procedure>,
    /// Whether this step leaves the current frame: it is popped after the step.
    pub returns: bool,
    /// The variables of the top frame that the line assigns.
    pub set: Vec<(&'static str, Variable)>,
    /// The place of the test that the step is about among those of its node.
    pub test: Option<usize>,
    /// What is computed.
    pub arithmetic: Option<Arithmetic>,
    /// What it comes to.
    pub finding: Option<Finding>,
    /// The diagram that shows the step best.
    pub diagram: Option<Picture>,
    /// What becomes true here; other events are read off the node and the test.
    pub marks: Vec<Mark>,
    /// What may be asked before the step is shown.
    pub question: Option<Question>,
}

/// What a step comes to, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Whether what was asked for holds: the box is entered, the shape is hit, the light is seen.
    pub is_ok: bool,
    /// Why.
    pub words: String,
}

/// A diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The name of its kind.
    pub kind: &'static str,
    /// The node that it is of, where that is not the step's.
    pub node: Option<usize>,
    /// The shape that it is about; nothing for what the node hits.
    pub shape: Option<u32>,
    /// The triangle of that shape.
    pub primitive: Option<u32>,
}

/// What becomes true at a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A ray has hit something.
    Hit,
    /// A shadow ray has been blocked.
    Blocked,
    /// A surface reflects totally.
    TotalReflection,
    /// A verdict was left open by the filter and decided exactly.
    Exact,
    /// A value is not a number.
    NotANumber,
}

impl Mark {
    /// The word for it, which is that of its event.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hit => "hit",
            Self::Blocked => "blocked",
            Self::TotalReflection => "tir",
            Self::Exact => "exact",
            Self::NotANumber => "nan",
        }
    }
}

impl Finding {
    /// A finding.
    pub(crate) fn new(is_ok: bool, words: impl Into<String>) -> Self {
        Self { is_ok, words: words.into() }
    }
}

impl<'a> Recording<'a> {
    /// The steps of a tree that was traced in `scene`, of which the geometry and the materials are read.
    ///
    /// A tree without tests gives steps without tests. What does not fit the scene (a tree of another renderer, or of another
    /// scene) gives steps without arithmetic.
    pub fn of(scene: &'a Scene, tree: &'a RayTree) -> Self {
        unroll::unroll(scene, tree)
    }

    /// The test that a step is about.
    pub fn test_of(&self, step: &Step) -> Option<&'a TestRecord> {
        self.nodes[step.node].ray.tests.as_ref()?.get(step.test?)
    }

    /// The value that a name has in the arithmetic of a step.
    pub fn value(&self, step: &Step, name: &str) -> Option<Value> {
        let arithmetic = step.arithmetic.as_ref()?;
        value_of(&arithmetic.values, name).or_else(|| value_of(&self.nodes[step.node].values, name))
    }

    /// The arithmetic of a step, line by line.
    pub fn worked(&self, step: &Step) -> Vec<Worked> {
        match &step.arithmetic {
            None => Vec::new(),
            Some(arithmetic) => self.forms[arithmetic.form].worked(&|name| self.value(step, name)),
        }
    }
}
