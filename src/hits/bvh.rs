//! A plain binary bounding volume hierarchy, split by the surface area heuristic, one item a leaf.
//!
//! Source: MacDonald and Booth 1990 (the heuristic); Wald 2007 (binning).

use super::slabs::{Bounds, SlabRay};

/// A hierarchy of boxes around items `0..n`.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    nodes: Vec<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    /// One item.
    Leaf(u32),
    /// The left child follows its parent; this is the right one.
    Inner { right: u32 },
}

/// What a visitor of the hierarchy is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visit {
    /// A node with children, by its place in the hierarchy.
    Inner,
    /// A leaf with this item.
    Leaf(u32),
}

/// Centres are sorted into this many bins an axis.
const BINS: usize = 16;

/// Nodes of at most this many items are split at the best of all places, larger ones between bins.
const SWEEP: usize = 32;

impl Bvh {
    /// The hierarchy over boxes; item `i` is the `i`th.
    ///
    /// Deterministic: the same boxes give the same hierarchy. Takes O(n log n) steps; depth at most `n`.
    pub fn new(bounds: &[Bounds]) -> Self {
        let mut items: Vec<u32> = (0..bounds.len() as u32).collect();
        let mut nodes = Vec::with_capacity((2 * bounds.len()).saturating_sub(1));
        // Parents come before children, left before right: a stack of ranges and of the parent whose right child it is.
        let mut open: Vec<(std::ops::Range<usize>, Option<usize>)> = Vec::new();
        if !items.is_empty() {
            open.push((0..items.len(), None));
        }
        while let Some((range, right_of)) = open.pop() {
            let place = nodes.len();
            if let Some(parent) = right_of {
                let parent: &mut Node = &mut nodes[parent];
                parent.kind = Kind::Inner { right: place as u32 };
            }
            let items = &mut items[range.clone()];
            let around = items.iter().map(|&i| bounds[i as usize]).fold(Bounds::EMPTY, |a, b| a.union(&b));
            if let [only] = items {
                nodes.push(Node { bounds: around, kind: Kind::Leaf(*only) });
                continue;
            }
            nodes.push(Node { bounds: around, kind: Kind::Inner { right: 0 } });
            let middle = range.start + split(items, bounds);
            open.push((middle..range.end, Some(place)));
            open.push((range.start..middle, None));
        }
        Self { nodes }
    }

    /// How many nodes there are: one less than twice the items.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The box of a node, and the item where it is a leaf.
    pub fn node(&self, place: u32) -> (&Bounds, Visit) {
        let node = &self.nodes[place as usize];
        let visit = match node.kind {
            Kind::Leaf(item) => Visit::Leaf(item),
            Kind::Inner { .. } => Visit::Inner,
        };
        (&node.bounds, visit)
    }

    /// Walks the nodes whose box the ray enters, the nearer child first.
    ///
    /// `enter(place, visit, bounds)` is shown every box whose turn comes, so that it judges it by the best hit so far,
    /// and says whether to go on inside; for a leaf it does what is to be done with the item.
    #[inline(always)]
    pub fn walk(&self, ray: &SlabRay, mut enter: impl FnMut(u32, Visit, &Bounds) -> bool) {
        if self.nodes.is_empty() {
            return;
        }
        let mut stack = Stack::new();
        stack.push(0);
        while let Some(place) = stack.pop() {
            let node = &self.nodes[place as usize];
            match node.kind {
                Kind::Leaf(item) => {
                    enter(place, Visit::Leaf(item), &node.bounds);
                }
                Kind::Inner { right } => {
                    if enter(place, Visit::Inner, &node.bounds) {
                        let left = place + 1;
                        let (first, second) =
                            if self.is_nearer(ray, right, left) { (right, left) } else { (left, right) };
                        stack.push(second);
                        stack.push(first);
                    }
                }
            }
        }
    }

    /// Whether the middle of node `a` comes before that of node `b` along the ray. Only the order of visits hangs on
    /// it.
    #[inline(always)]
    fn is_nearer(&self, ray: &SlabRay, a: u32, b: u32) -> bool {
        let (a, b) = (self.nodes[a as usize].bounds.twice_center(), self.nodes[b as usize].bounds.twice_center());
        let d = ray.direction();
        (a[0] - b[0]) * d[0] + (a[1] - b[1]) * d[1] + (a[2] - b[2]) * d[2] < 0.0
    }
}

/// A stack that lives in place while it is small, as it is in every hierarchy but a degenerate one.
struct Stack {
    near: [u32; 64],
    len: usize,
    far: Vec<u32>,
}

impl Stack {
    #[inline(always)]
    fn new() -> Self {
        Self { near: [0; 64], len: 0, far: Vec::new() }
    }
    #[inline(always)]
    fn push(&mut self, place: u32) {
        if self.len < self.near.len() {
            self.near[self.len] = place;
            self.len += 1;
        } else {
            self.far.push(place);
        }
    }
    #[inline(always)]
    fn pop(&mut self) -> Option<u32> {
        if let Some(place) = self.far.pop() {
            return Some(place);
        }
        self.len = self.len.checked_sub(1)?;
        Some(self.near[self.len])
    }
}

/// Orders `items` and says where the right half begins, such that half area times count, summed over both halves, is
/// least.
fn split(items: &mut [u32], bounds: &[Bounds]) -> usize {
    let center = |i: u32, axis: usize| bounds[i as usize].twice_center()[axis];
    if items.len() <= SWEEP {
        let mut best = (f64::INFINITY, 0, items.len() / 2);
        for axis in 0..3 {
            items.sort_by(|&a, &b| center(a, axis).total_cmp(&center(b, axis)).then(a.cmp(&b)));
            let right = areas_from_the_right(items, |&i| bounds[i as usize]);
            let mut left = Bounds::EMPTY;
            for at in 1..items.len() {
                left = left.union(&bounds[items[at - 1] as usize]);
                let cost = left.half_area() * at as f64 + right[at] * (items.len() - at) as f64;
                if cost < best.0 {
                    best = (cost, axis, at);
                }
            }
        }
        let (_, axis, at) = best;
        items.sort_by(|&a, &b| center(a, axis).total_cmp(&center(b, axis)).then(a.cmp(&b)));
        return at;
    }
    let mut least = [f64::INFINITY; 3];
    let mut most = [f64::NEG_INFINITY; 3];
    for &i in items.iter() {
        for axis in 0..3 {
            least[axis] = least[axis].min(center(i, axis));
            most[axis] = most[axis].max(center(i, axis));
        }
    }
    let bin = |i: u32, axis: usize| {
        let share = (center(i, axis) - least[axis]) / (most[axis] - least[axis]);
        ((share * BINS as f64) as usize).min(BINS - 1)
    };
    let mut best = (f64::INFINITY, 0, 0);
    for axis in (0..3).filter(|&axis| least[axis] < most[axis]) {
        let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
        for &i in items.iter() {
            let (around, count) = &mut bins[bin(i, axis)];
            *around = around.union(&bounds[i as usize]);
            *count += 1;
        }
        let right = areas_from_the_right(&bins, |b| b.0);
        let (mut left, mut left_count) = (Bounds::EMPTY, 0);
        for at in 1..BINS {
            left = left.union(&bins[at - 1].0);
            left_count += bins[at - 1].1;
            let right_count = items.len() - left_count;
            let cost = left.half_area() * left_count as f64 + right[at] * right_count as f64;
            if left_count > 0 && right_count > 0 && cost < best.0 {
                best = (cost, axis, at);
            }
        }
    }
    let (cost, axis, at) = best;
    if cost == f64::INFINITY {
        // All centres coincide: any two halves do.
        return items.len() / 2;
    }
    items.sort_by_key(|&i| (bin(i, axis) >= at, i));
    items.iter().filter(|&&i| bin(i, axis) < at).count()
}

/// For each place, half the area of the box around everything from there on.
fn areas_from_the_right<T>(things: &[T], bounds: impl Fn(&T) -> Bounds) -> Vec<f64> {
    let mut areas = vec![0.0; things.len()];
    let mut around = Bounds::EMPTY;
    for (at, thing) in things.iter().enumerate().rev() {
        around = around.union(&bounds(thing));
        areas[at] = around.half_area();
    }
    areas
}
