//! Reading a tree that anybody wrote, and saying where it is not one.

use super::{FORMAT, Kind, LeavingPolicy, Ledger, Outcome, RayNode, RayTree};
use crate::input::{JsonPath, Located, Problem, read_json};
use crate::scene::Limits;

/// The tree that a JSON text holds.
///
/// # Errors
/// One [`Problem`], located, for the first thing that is not as the schema has it, or that contradicts itself: another
/// format, a child whose depth does not follow from its parent's, an outcome without what belongs to it, a vector that
/// cannot be a direction.
pub fn read_tree(file: &str, text: &str) -> Result<RayTree, Problem> {
    let tree = parse_tree(file, text)?;
    let (located, root) = (Located { file, text }, JsonPath::default());
    let path = root.child("root");
    if tree.root.kind != Kind::Camera {
        return Err(located.problem(&path.child("kind"), "the root is not a camera ray", "\"camera\""));
    }
    if tree.root.depth != 0 {
        return Err(located.problem(&path.child("depth"), "the root is not at depth 0", "0"));
    }
    // Where a point is brought back onto its surface, and t is far off, it lies far from the ray.
    let points_on_rays = tree.settings.as_ref().and_then(|s| s.leaving) != Some(LeavingPolicy::ErrorBound);
    check(located, &path, &tree.root, points_on_rays)?;
    let traced = tree.root.walk().filter(|node| node.outcome.is_traced()).count() as u64;
    if tree.rays != traced {
        let message = format!("{} rays are counted, and {traced} are there", tree.rays);
        return Err(located.problem(
            &root.child("rays"),
            message,
            "the number of nodes that were traced, shadow rays among them",
        ));
    }
    let apart = |a: [f64; 3], b: [f64; 3]| (0..3).any(|k| !((a[k] - b[k]).abs() <= FOREIGN * a[k].abs().max(1.0)));
    if tree.root.radiance.is_some_and(|radiance| apart(tree.color, radiance)) {
        let help = "the color of a tree is the radiance of its root";
        return Err(located.problem(&root.child("color"), "not what the root brings back", help));
    }
    if is_complete(&tree.root) {
        let ledger = Ledger::of(&tree);
        // The sum's own bound is for f64; other tracers may compute in f32.
        if ledger.difference() > FOREIGN * ledger.bound / 1e-12 {
            let message = format!("the nodes add up to {:?}", ledger.sum);
            let help = "the sum of weight x local over the nodes, and of weight x radiance over the background";
            return Err(located.problem(&root.child("color"), message, help));
        }
    }
    Ok(tree)
}

/// The tree that a JSON text holds, whether or not it contradicts itself: that of a tracer with a fault may well.
///
/// # Errors
/// One [`Problem`], located, for the first thing that is not as the schema has it, or for another format.
pub fn parse_tree(file: &str, text: &str) -> Result<RayTree, Problem> {
    let located = Located { file, text };
    let tree: RayTree = read_json(located)?;
    if tree.format != FORMAT {
        let message = format!("the format is {:?}", tree.format);
        let help = format!("this program reads {FORMAT:?}");
        return Err(located.problem(&JsonPath::default().child("format"), message, help));
    }
    Ok(tree)
}

/// How far the colour of somebody's tree may be from what its nodes add up to, in the units of a ledger's bound.
const FOREIGN: f64 = 1e-4;

/// Whether every node says what it brings, so that the tree has to add up.
fn is_complete(root: &RayNode) -> bool {
    root.walk().filter(|node| node.kind != Kind::Shadow).all(|node| match node.outcome {
        Outcome::Hit => node.local.is_some(),
        Outcome::Background => node.radiance.is_some(),
        _ => true,
    })
}

fn check(located: Located<'_>, path: &JsonPath, node: &RayNode, points_on_rays: bool) -> Result<(), Problem> {
    let wrong = |key: &str, message: &str, help: &str| Err(located.problem(&path.child(key), message, help));
    if node.direction == [0.0; 3] {
        return wrong("direction", "a direction of length zero", "any other vector");
    }
    if node.depth > Limits::DEEPEST + 1 {
        return wrong("depth", "deeper than any ray", "at most 65: one below the deepest that is traced");
    }
    let shadow = node.kind == Kind::Shadow;
    let fits = match node.outcome {
        Outcome::RayBudget => true,
        Outcome::Lit | Outcome::Blocked => shadow,
        Outcome::Hit | Outcome::Background | Outcome::MaxDepth | Outcome::BelowMinWeight => !shadow,
    };
    if !fits {
        let help = "of shadow rays lit, blocked or ray_budget, of others hit, background, max_depth, below_min_weight or \
                    ray_budget";
        return wrong("outcome", "this outcome does not go with this kind", help);
    }
    if shadow && node.light.is_none() {
        return wrong("kind", "a shadow ray to no light", "add `light`, the light's name, to this node");
    }
    if !shadow && node.weight.is_none() {
        return wrong("kind", "a ray without `weight`", "add `weight`, the share that reaches the pixel, to this node");
    }
    if !matches!(node.outcome, Outcome::Hit | Outcome::Blocked) && node.hit.is_some() {
        return wrong("hit", "a hit of a ray that hit nothing", "leave it out, or make the outcome `hit` or `blocked`");
    }
    if node.outcome == Outcome::Hit && node.hit.is_none() {
        return wrong("outcome", "a hit without `hit`", "add `hit` to this node");
    }
    if let Some(hit) = &node.hit
        && !(hit.t >= 0.0)
    {
        return Err(located.problem(&path.child("hit").child("t"), "a hit behind the ray's start", "0 or larger"));
    }
    if let Some(fresnel) = node.fresnel
        && !(0.0..=1.0).contains(&fresnel)
    {
        return wrong("fresnel", "a reflectance that is none", "0 to 1");
    }
    if node.t_max.is_some_and(|t_max| !(t_max > 0.0)) {
        return wrong("t_max", "a span without any t in it", "larger than 0");
    }
    if let Some(hit) = &node.hit {
        let path = path.child("hit");
        let length = |v: [f64; 3]| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        let normals = [("geometric_normal", Some(hit.geometric_normal)), ("shading_normal", hit.shading_normal)];
        for (key, normal) in normals {
            if normal.is_some_and(|n| !((length(n) - 1.0).abs() < 1e-5)) {
                return Err(located.problem(&path.child(key), "a normal that is not of length 1", "a unit vector"));
            }
        }
        let reach = node.origin.iter().chain(&node.direction).fold(1.0_f64, |m, x| m.max(x.abs())) * hit.t.max(1.0);
        let at = |k: usize| node.origin[k] + hit.t * node.direction[k];
        if points_on_rays && (0..3).any(|k| !((at(k) - hit.point[k]).abs() <= 1e-3 * reach)) {
            let help = format!("near origin + t * direction, {:?}", [at(0), at(1), at(2)]);
            return Err(located.problem(&path.child("point"), "a point that is not on the ray", help));
        }
        if hit.barycentrics.is_some_and(|[a, b, c]| !((a + b + c - 1.0).abs() < 1e-5)) {
            return Err(located.problem(&path.child("barycentrics"), "they do not add up to 1", "[a, b, 1-a-b]"));
        }
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
        check(located, &path, child, points_on_rays)?;
    }
    Ok(())
}
