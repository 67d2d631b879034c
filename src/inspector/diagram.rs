//! A diagram of a node, as the command draws it.

use glam::DVec2;

use super::answer::Refusal;
use crate::pictures::diagrams::{Chosen, Input, Kind, diagram};
use crate::pictures::theme::Theme;
use crate::scene::{Scene, Shape};
use crate::tree::{NodePath, RayTree, TestRecord};

/// Which diagram.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    pub(super) kind: Kind,
    pub(super) node: NodePath,
    pub(super) chosen: Option<Chosen>,
    pub(super) theme: &'static Theme,
}

/// The room of a diagram about one ray, in user units: that of its pane on a small screen, nearly, so that its text is
/// readable there. What shows the whole tree takes more, so as to fold less.
pub const PANE: DVec2 = DVec2::new(620.0, 390.0);

impl Wanted {
    /// What the diagram is of, as a query.
    pub(super) fn about(&self) -> String {
        let mut about = format!("kind={}", self.kind);
        if let Some(Chosen { shape, primitive }) = self.chosen {
            about += &format!("&shape={shape}");
            about += &primitive.map_or(String::new(), |primitive| format!("&primitive={primitive}"));
        }
        about
    }
}

/// The diagram of the test that a ray's hit was found by; of a ray that hits nothing that of its last test, or the section.
///
/// # Errors
/// [`Refusal`] where there is no such node.
pub(super) fn of_the_verdict(
    scene: &Scene,
    tree: &RayTree,
    node: NodePath,
    theme: &'static Theme,
) -> Result<Wanted, Refusal> {
    let ray = node.find(tree).map_err(|no| Refusal::Why(no.to_string()))?;
    let decisive = match (&ray.hit, ray.tests.iter().flatten().last()) {
        (Some(hit), _) => Some((hit.shape, hit.primitive)),
        (None, Some(TestRecord::Shape(test))) if !test.values.0.is_empty() => Some((test.shape, test.primitive)),
        (None, _) => None,
    };
    let shape = decisive.and_then(|(shape, _)| Some(&scene.objects.get(shape as usize)?.shape));
    let (kind, chosen) = match (decisive, shape) {
        (Some((shape, primitive)), Some(of)) => {
            let (kind, primitive) = match of {
                Shape::Plane { .. } => (Kind::Plane, None),
                Shape::Sphere { .. } => (Kind::Sphere, None),
                Shape::Box { .. } => (Kind::Box, None),
                Shape::Triangle { .. } => (Kind::Triangle, None),
                Shape::Mesh(_) => (Kind::Triangle, primitive),
            };
            (kind, Some(Chosen { shape, primitive }))
        }
        _ => (Kind::Section, None),
    };
    Ok(Wanted { kind, node, chosen, theme })
}

/// The diagram as SVG.
///
/// # Errors
/// [`Refusal`] with the reason why there is none.
pub(super) fn svg(scene: &Scene, tree: &RayTree, wanted: Wanted) -> Result<String, Refusal> {
    let input = Input::new(scene, tree, wanted.node).map_err(|no| Refusal::Why(no.to_string()))?;
    let input = match wanted.chosen {
        Some(chosen) => input.about(chosen),
        None => input,
    };
    let input = match wanted.kind.is_of_the_whole_tree() {
        true => input,
        false => input.on_page(PANE.x, PANE.y),
    };
    let drawing = diagram(wanted.kind, &input, wanted.theme).map_err(|not| Refusal::Why(not.why))?;
    drawing.to_svg().map_err(|unfit| Refusal::Why(unfit.to_string()))
}
