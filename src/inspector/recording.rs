//! The tree of a pixel, within bounds.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::answer::Refusal;
use super::scenes::{Held, HeldTree, Inspector};
use super::tracing::at_most;
use crate::tree::RayTree;

/// Rays of a tree that can be stepped through.
const MOST_RAYS: u64 = 1 << 12;
/// Tests of boxes and shapes in such a tree.
const MOST_TESTS: u64 = 1 << 15;

/// The tree of a pixel with every test.
///
/// # Errors
/// [`Refusal`] where it has more rays or tests than can be stepped through; what it has is counted first, and what is too
/// much never stored.
pub(super) fn tree(
    inspector: &Inspector,
    held: &Held,
    pixel: [u32; 2],
    stop: &AtomicBool,
) -> Result<Arc<HeldTree>, Refusal> {
    if let Some(tree) = inspector.find_tree(&held.id, pixel) {
        return Ok(tree);
    }
    let tree = Arc::new(HeldTree { scene: held.id.clone(), pixel, tree: record(held, pixel, stop)? });
    // A tree that nobody waited for may be cut off.
    if !stop.load(Ordering::Relaxed) {
        inspector.add_tree(&tree);
    }
    Ok(tree)
}

/// The tree of a pixel with every test.
///
/// # Errors
/// As [`tree`] has them.
pub(super) fn record(held: &Held, [x, y]: [u32; 2], stop: &AtomicBool) -> Result<RayTree, Refusal> {
    let scene = &held.loaded.scene;
    let mut options = held.options;
    options.limits = at_most(options.limits, MOST_RAYS + 1);
    let costs = held.world.tracer(scene, options, stop).costs(x, y);
    for (what, count, most) in [("rays", costs.rays(), MOST_RAYS), ("tests", costs.tests, MOST_TESTS)] {
        if count > most {
            let why = format!(
                "pixel {x},{y} takes more than {most} {what}: too many to step through; a smaller max_depth helps"
            );
            return Err(Refusal::Why(why));
        }
    }
    Ok(held.world.tracer(scene, held.options, stop).record(&held.loaded, x, y))
}
