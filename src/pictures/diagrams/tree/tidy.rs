//! Where the nodes of a tree go: level below level, siblings side by side, parents in the middle above their children.
//!
//! Source: Reingold and Tilford, "Tidier Drawings of Trees", 1981: subtrees are laid out on their own, then moved as close
//! together as their contours allow. Contours are kept as one span a level, which takes O(nodes x depth), not the linear time
//! of their threads, and is far shorter; nodes may be of any breadth, as in van der Ploeg, "Drawing Non-layered Tidy Trees in
//! Linear Time", 2014. Small subtrees between large ones are not spread out (Buchheim, Jünger, Leipert 2002): a ray has at
//! most two large children.

/// A node as the layout sees it.
#[derive(Clone, Debug, Default)]
pub(super) struct Node {
    /// How much room it takes across the levels.
    pub(super) breadth: f64,
    /// Its children, in order; each node is the child of one, but the first, which is the root.
    pub(super) children: Vec<usize>,
}

/// The middle of each node across the levels, the smallest edge at 0, neighbours `gap` apart; and the room that all take.
pub(super) fn place(nodes: &[Node], gap: f64) -> (Vec<f64>, f64) {
    let mut offsets = vec![0.0; nodes.len()];
    let contour = contour(nodes, 0, gap, &mut offsets);
    let least = contour.iter().map(|span| span[0]).fold(f64::INFINITY, f64::min);
    let most = contour.iter().map(|span| span[1]).fold(f64::NEG_INFINITY, f64::max);
    let mut middles = vec![0.0; nodes.len()];
    middles[0] = -least;
    let mut open = vec![0];
    while let Some(i) = open.pop() {
        for &child in &nodes[i].children {
            middles[child] = middles[i] + offsets[child];
            open.push(child);
        }
    }
    (middles, most - least)
}

/// What the subtree at `i` covers on each level, measured from the middle of `i`; sets how far children are from their parents.
fn contour(nodes: &[Node], i: usize, gap: f64, offsets: &mut [f64]) -> Vec<[f64; 2]> {
    let children = &nodes[i].children;
    let mut covered: Vec<[f64; 2]> = Vec::new();
    for &child in children {
        let own = contour(nodes, child, gap, offsets);
        let apart = covered.iter().zip(&own).map(|(before, after)| before[1] + gap - after[0]);
        let at = apart.fold(f64::NEG_INFINITY, f64::max);
        let at = if at.is_finite() { at } else { 0.0 };
        offsets[child] = at;
        for (level, span) in own.iter().enumerate() {
            let moved = [span[0] + at, span[1] + at];
            match covered.get_mut(level) {
                Some(before) => *before = [before[0].min(moved[0]), before[1].max(moved[1])],
                None => covered.push(moved),
            }
        }
    }
    let middle = match (children.first(), children.last()) {
        (Some(&first), Some(&last)) => (offsets[first] + offsets[last]) / 2.0,
        _ => 0.0,
    };
    children.iter().for_each(|&child| offsets[child] -= middle);
    let half = nodes[i].breadth / 2.0;
    let below = covered.into_iter().map(|span| span.map(|x| x - middle));
    [[-half, half]].into_iter().chain(below).collect()
}
