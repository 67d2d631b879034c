//! Reading a tree that anybody wrote, and saying where it is not one.

use super::{FORMAT, Kind, Outcome, RayNode, RayTree};
use crate::input::{JsonPath, Located, Problem, read_json};
use crate::scene::Limits;

/// The tree that a JSON text holds.
///
/// # Errors
/// One [`Problem`], located, for the first thing that is not as the schema has it, or that contradicts itself: another format,
/// a child whose depth does not follow from its parent's, an outcome without what belongs to it, a vector that cannot be a
/// direction.
pub fn read_tree(file: &str, text: &str) -> Result<RayTree, Problem> {
    let located = Located { file, text };
    let tree: RayTree = read_json(located)?;
    let root = JsonPath::default();
    if tree.format != FORMAT {
        let message = format!("the format is {:?}", tree.format);
        return Err(located.problem(&root.child("format"), message, format!("this program reads {FORMAT:?}")));
    }
    let path = root.child("root");
    if tree.root.kind != Kind::Camera {
        return Err(located.problem(&path.child("kind"), "the root is not a camera ray", "\"camera\""));
    }
    if tree.root.depth != 0 {
        return Err(located.problem(&path.child("depth"), "the root is not at depth 0", "0"));
    }
    check(located, &path, &tree.root)?;
    Ok(tree)
}

fn check(located: Located<'_>, path: &JsonPath, node: &RayNode) -> Result<(), Problem> {
    let wrong = |key: &str, message: &str, help: &str| Err(located.problem(&path.child(key), message, help));
    if node.direction == [0.0; 3] {
        return wrong("direction", "a direction of length zero", "any other vector");
    }
    if node.depth > Limits::DEEPEST + 1 {
        return wrong("depth", "deeper than any ray", "at most 65: one below the deepest that is traced");
    }
    let shadow = node.kind == Kind::Shadow;
    if shadow != matches!(node.outcome, Outcome::Lit | Outcome::Blocked | Outcome::RayBudget)
        && node.outcome != Outcome::RayBudget
    {
        let help = "shadow rays are lit, blocked or ray_budget; others hit, background, max_depth, below_min_weight or ray_budget";
        return wrong("outcome", "this outcome does not go with this kind", help);
    }
    if shadow && node.light.is_none() {
        return wrong("kind", "a shadow ray to no light", "add `light`, the light's name, to this node");
    }
    if !shadow && node.weight.is_none() {
        return wrong("kind", "a ray without `weight`", "add `weight`, the share that reaches the pixel, to this node");
    }
    if node.outcome == Outcome::Hit && node.hit.is_none() {
        return wrong("outcome", "a hit without `hit`", "add `hit` to this node");
    }
    if let Some(hit) = &node.hit
        && !(hit.t >= 0.0)
    {
        return Err(located.problem(&path.child("hit").child("t"), "a hit behind the ray's start", "0 or larger"));
    }
    if node.outcome != Outcome::Hit && node.children().next().is_some() {
        return wrong("outcome", "a ray with children that did not hit", "children belong to hits");
    }
    let shadows = node.shadows.iter().enumerate();
    let shadows = shadows.map(|(i, child)| (path.child("shadows").child(i), child, Kind::Shadow, node.depth));
    let reflected =
        node.reflected.as_deref().map(|child| (path.child("reflected"), child, Kind::Reflected, node.depth + 1));
    let refracted =
        node.refracted.as_deref().map(|child| (path.child("refracted"), child, Kind::Refracted, node.depth + 1));
    for (path, child, kind, depth) in shadows.chain(reflected).chain(refracted) {
        if child.kind != kind {
            return Err(located.problem(
                &path.child("kind"),
                "this kind does not go with this place",
                "the place's name",
            ));
        }
        if child.depth != depth {
            let help = format!("{depth}: a shadow ray has its parent's depth, other children one more");
            return Err(located.problem(&path.child("depth"), "this depth does not follow from the parent's", help));
        }
        check(located, &path, child)?;
    }
    Ok(())
}
