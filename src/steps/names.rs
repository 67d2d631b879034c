//! What a node is called, and what it adds to the pixel.

use std::fmt::Write;

use crate::tree::{Kind, Outcome, RayNode, Side, six_digits};

/// What kind of ray a node is and what became of it.
pub(super) fn name(node: &RayNode) -> String {
    let mut name = match (node.kind, &node.light) {
        (Kind::Camera, _) => "camera ray".to_owned(),
        (Kind::Shadow, Some(light)) => format!("shadow ray to {light}"),
        (Kind::Shadow, None) => "shadow ray".to_owned(),
        (Kind::Reflected, _) => "reflected ray".to_owned(),
        (Kind::Refracted, _) => "refracted ray".to_owned(),
    };
    match (node.outcome, &node.hit) {
        (Outcome::Hit | Outcome::Blocked, Some(hit)) => {
            let verb = if node.outcome == Outcome::Blocked { "blocked by" } else { "hits" };
            let object = hit.object.clone().unwrap_or_else(|| format!("shape {}", hit.shape));
            write!(name, ", {verb} {object} at t {}", six_digits(hit.t)).ok();
            if node.outcome == Outcome::Hit && hit.side == Some(Side::Leaving) {
                name.push_str(", leaving");
            }
        }
        (Outcome::Hit, None) => name.push_str(", hits"),
        (Outcome::Blocked, None) => name.push_str(", blocked"),
        (Outcome::Lit, _) => name.push_str(", lit"),
        (Outcome::Background, _) => name.push_str(", background"),
        (Outcome::MaxDepth, _) => name.push_str(", not traced: max_depth"),
        (Outcome::BelowMinWeight, _) => name.push_str(", not traced: below min_weight"),
        (Outcome::RayBudget, _) => name.push_str(", not traced: ray budget spent"),
    }
    if node.total_reflection {
        name.push_str(", total reflection");
    }
    name
}

/// What the node's own light adds to the pixel.
pub(super) fn contribution(node: &RayNode) -> [f64; 3] {
    let Some(weight) = node.weight else { return [0.0; 3] };
    let own = match (&node.local, node.outcome) {
        (Some(local), _) => local
            .lights
            .iter()
            .fold(local.ambient, |sum, light| std::array::from_fn(|k| sum[k] + (light.diffuse[k] + light.specular[k]))),
        (None, Outcome::Background) => node.radiance.unwrap_or_default(),
        (None, _) => [0.0; 3],
    };
    std::array::from_fn(|k| weight[k] * own[k])
}
