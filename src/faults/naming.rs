//! Which fault of the catalogue gives somebody's tree.

use serde::{Serialize, Serializer};

use super::{Fault, Textbook};
use crate::scene::{Limits, Loaded};
use crate::transport::{Options, Tracer};
use crate::tree::diff::{Field, Tolerances, diff};
use crate::tree::{Keep, NodePath, Origin, RayTree, record_pixel, record_ray};

/// The fault that reproduces a tree.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Named {
    /// The fault; several where this tree does not tell them apart.
    pub faults: Vec<Fault>,
    /// The first node in which the tree parts from the right one.
    #[serde(serialize_with = "as_text")]
    pub path: NodePath,
    /// And the field.
    pub field: Field,
}

fn as_text<S: Serializer>(path: &NodePath, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(path)
}

impl Named {
    /// What is wrong with the tree called `of`, and why it happens: a sentence or two a fault.
    pub fn to_text(&self, of: &str) -> String {
        let told = |fault: &Fault| format!("{} ({fault})\n  {}\n", fault.title(), fault.why());
        match self.faults.as_slice() {
            [fault] => format!("one fault gives the whole of {of}: {}", told(fault)),
            faults => {
                let all: String = faults.iter().map(|fault| format!("- {}", told(fault))).collect();
                format!("each of these faults alone gives the whole of {of}; other pixels tell them apart:\n{all}")
            }
        }
    }
}

/// The limits that a tree was traced with: the scene's, unless its settings say otherwise.
fn limits(loaded: &Loaded, tree: &RayTree) -> Limits {
    let mut limits = loaded.scene.limits;
    if let Some(settings) = tree.settings {
        limits.max_depth = settings.max_depth.unwrap_or(limits.max_depth).min(Limits::DEEPEST);
        limits.min_weight = settings.min_weight.or(limits.min_weight);
        limits.ray_budget = settings.ray_budget.unwrap_or(limits.ray_budget);
    }
    limits
}

/// The right tree for somebody's: that of the same pixel, or of the same camera ray where it names no pixel; certified, in f64,
/// with the limits that it says.
///
/// # None when
/// The pixel lies outside the scene's image, the ray is none, or the scene is beyond f64.
pub fn right_tree(loaded: &Loaded, tree: &RayTree) -> Option<RayTree> {
    let scene = &loaded.scene;
    let options = Options { limits: limits(loaded, tree), ..Options::of(scene) };
    let tracer = Tracer::<f64>::new(scene, options).ok()?;
    let origin = Origin { loaded, keep: Keep::Outcomes };
    match tree.pixel {
        Some([x, y]) if x < scene.image.width && y < scene.image.height => Some(record_pixel(&tracer, origin, x, y)),
        Some(_) => None,
        None => {
            let (from, towards) = (tree.root.origin.into(), tree.root.direction.into());
            record_ray(&tracer, origin, &crate::kernels::Ray { origin: from, direction: towards }).ok()
        }
    }
}

/// The fault that reproduces `tree` in this scene: planted alone in the textbook tracer it gives the same tree within
/// `tolerances`, which the right tracer does not.
///
/// # None when
/// The tree is right, or no single fault of the catalogue gives the whole of it, or there is nothing to compare it with
/// ([`right_tree`]).
///
/// # Example
/// ```
/// use raytree::faults::{Fault, Textbook, name_fault};
/// use raytree::tree::diff::Tolerances;
/// let loaded = raytree::scene::load_file("scenes/glass-ball.json").unwrap();
/// let [x, y] = loaded.scene.pixels[0].1;
/// let tree = Textbook::new(&loaded.scene).with(Fault::EtaInverted).pixel(x, y);
/// let named = name_fault(&loaded, &tree, &Tolerances::default()).unwrap();
/// assert_eq!(named.faults, [Fault::EtaInverted]);
/// ```
pub fn name_fault(loaded: &Loaded, tree: &RayTree, tolerances: &Tolerances) -> Option<Named> {
    let right = right_tree(loaded, tree)?;
    let difference = diff(&right, tree, tolerances);
    let first = difference.first()?;
    let mut limits = limits(loaded, tree);
    // A candidate with more rays than the tree is none: it need not be traced to its end.
    limits.ray_budget = limits.ray_budget.min(tree.root.walk().count() as u64 + 1);
    let reproduces = |fault: &Fault| {
        let textbook = Textbook::new(&loaded.scene).with_limits(limits).with(*fault).guided_by(tree);
        // After a fault it matters how a tracer knows which medium it is in.
        [textbook.clone(), textbook.with_media_by_side()].into_iter().any(|textbook| {
            let candidate = match tree.pixel {
                Some([x, y]) => textbook.pixel(x, y),
                None => textbook.ray(tree.root.origin, tree.root.direction),
            };
            diff(&candidate, tree, tolerances).is_same()
        })
    };
    let faults: Vec<Fault> = Fault::ALL.into_iter().filter(reproduces).collect();
    (!faults.is_empty()).then(|| Named { faults, path: first.path.clone(), field: first.field })
}
