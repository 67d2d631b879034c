//! Which rays of a tree get a card of their own, and which are only counted.

use crate::tree::{Kind, NodePath, RayNode, RayTree};

/// The rays of a tree in the order in which they were traced, and which of them show their children.
pub(super) struct Folding<'t> {
    pub(super) items: Vec<Item<'t>>,
    /// Whether shadow rays have cards.
    pub(super) shadows: bool,
}

/// A ray.
pub(super) struct Item<'t> {
    pub(super) node: &'t RayNode,
    /// The way to it from the root.
    pub(super) path: NodePath,
    pub(super) children: Vec<usize>,
    /// How many nodes there are below it.
    pub(super) below: usize,
    /// Whether its children are shown.
    pub(super) open: bool,
}

/// The most cards that a diagram has.
const MOST: usize = 72;

impl<'t> Folding<'t> {
    /// The tree with the heaviest rays unfolded, up to [`MOST`] cards.
    pub(super) fn new(tree: &'t RayTree) -> Self {
        let mut items: Vec<Item<'t>> = Vec::new();
        // The nodes from the root to the last one.
        let mut open: Vec<usize> = Vec::new();
        for (place, (path, node)) in tree.nodes().into_iter().enumerate() {
            open.truncate(path.len());
            if let Some(&parent) = open.last() {
                items[parent].children.push(place);
            }
            open.push(place);
            items.push(Item { node, path, children: Vec::new(), below: 0, open: false });
        }
        for i in (0..items.len()).rev() {
            items[i].below = items[i].children.iter().map(|&child| 1 + items[child].below).sum();
        }
        let mut folding = Folding { items, shadows: true };
        let mut shown = 1;
        let mut edge = vec![0];
        while let Some(place) = heaviest(&folding.items, &edge) {
            let i = edge.swap_remove(place);
            shown += folding.items[i].children.len();
            if shown > MOST {
                break;
            }
            folding.items[i].open = true;
            edge.extend(folding.items[i].children.iter().copied());
        }
        folding
    }

    /// The children of a ray that have cards.
    pub(super) fn shown(&self, i: usize) -> Vec<usize> {
        let item = &self.items[i];
        let seen = |child: &usize| item.open && (self.shadows || self.items[*child].node.kind != Kind::Shadow);
        item.children.iter().copied().filter(seen).collect()
    }

    /// How many nodes below a ray have no card, those below its shown children aside: shadow rays, and the rest.
    pub(super) fn hidden(&self, i: usize) -> (usize, usize) {
        let item = &self.items[i];
        if !item.open {
            return (0, item.below);
        }
        let shadows = item.children.iter().filter(|c| self.items[**c].node.kind == Kind::Shadow).count();
        (if self.shadows { 0 } else { shadows }, 0)
    }

    /// Folds a little more: the shadow rays first, then the lightest ray none of whose children shows children. Whether there
    /// was anything to fold.
    pub(super) fn fold(&mut self) -> bool {
        if self.shadows && self.items.iter().any(|item| item.node.kind == Kind::Shadow) {
            self.shadows = false;
            return true;
        }
        let mut lightest: Option<(f64, usize)> = None;
        let mut open = vec![0];
        while let Some(i) = open.pop() {
            let shown = self.shown(i);
            let last = !shown.is_empty() && shown.iter().all(|&child| self.shown(child).is_empty());
            let weight = weight(self.items[i].node);
            if last && i != 0 && lightest.is_none_or(|(least, _)| weight < least) {
                lightest = Some((weight, i));
            }
            open.extend(shown);
        }
        let Some((_, i)) = lightest else { return false };
        self.items[i].open = false;
        true
    }
}

/// The place in `edge` of the ray with the most weight that has children.
fn heaviest(items: &[Item<'_>], edge: &[usize]) -> Option<usize> {
    let mut best: Option<(f64, usize)> = None;
    for (place, &i) in edge.iter().enumerate() {
        let weight = weight(items[i].node);
        if !items[i].children.is_empty() && best.is_none_or(|(most, _)| weight > most) {
            best = Some((weight, place));
        }
    }
    best.map(|(_, place)| place)
}

fn weight(node: &RayNode) -> f64 {
    node.weight.map_or(0.0, |w| w.into_iter().fold(0.0, f64::max))
}
