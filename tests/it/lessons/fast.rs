//! Lesson 12, fast: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::{Aabb, Hierarchy, Inside, Lesson, Node, Outcome};

#[path = "../../../lessons/12-fast/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/12-fast/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/12-fast/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(bounds, surface_area, cost, split, build, nearest);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "bounds-from-origin": bounds = |items| {
            let mut aabb = Aabb { min: DVec3::ZERO, max: DVec3::ZERO };
            for v in items.iter().flat_map(|item| item.triangle.vertices) {
                aabb = Aabb { min: aabb.min.min(v), max: aabb.max.max(v) };
            }
            aabb
        },
        "bounds-max-from-zero": bounds = |items| {
            let mut aabb = Aabb { min: DVec3::INFINITY, max: DVec3::splat(f64::MIN_POSITIVE) };
            for v in items.iter().flat_map(|item| item.triangle.vertices) {
                aabb = Aabb { min: aabb.min.min(v), max: aabb.max.max(v) };
            }
            aabb
        },
        "bounds-of-centers": bounds = |items| {
            let centers = || items.iter().map(|item| item.center());
            Aabb { min: centers().reduce(DVec3::min).unwrap(), max: centers().reduce(DVec3::max).unwrap() }
        },
        "area-is-volume": surface_area = |aabb| {
            let size = aabb.max - aabb.min;
            size.x * size.y * size.z
        },
        "area-of-three-faces": surface_area = |aabb| solution::surface_area(aabb) / 2.0,
        "cost-without-counts": cost = |left, right| {
            solution::surface_area(&solution::bounds(left)) + solution::surface_area(&solution::bounds(right))
        },
        "split-nothing": split = |items| [items.to_vec(), items.to_vec()],
        "split-last-axis": split = |items| {
            let mut best = [Vec::new(), Vec::new()];
            for axis in 0..3 {
                let mut cheapest = f64::INFINITY;
                let mut sorted = items.to_vec();
                sorted.sort_by(|a, b| a.center()[axis].total_cmp(&b.center()[axis]));
                for cut in 1..sorted.len() {
                    let (left, right) = sorted.split_at(cut);
                    let cost = solution::cost(left, right);
                    if cost < cheapest {
                        cheapest = cost;
                        best = [left.to_vec(), right.to_vec()];
                    }
                }
            }
            best
        },
        "split-in-the-middle": split = |items| {
            let size = { let aabb = solution::bounds(items); aabb.max - aabb.min };
            let axis = (0..3).reduce(|a, b| if size[b] > size[a] { b } else { a }).unwrap();
            let mut sorted = items.to_vec();
            sorted.sort_by(|a, b| a.center()[axis].total_cmp(&b.center()[axis]));
            let right = sorted.split_off(items.len() / 2);
            [sorted, right]
        },
        "build-without-end": build = |items, builder| {
            let bounds = solution::bounds(items);
            if items.len() <= 2 { Node::leaf(bounds, items) }
            else { Node::inner(bounds, builder.build(items), builder.build(items)) }
        },
        "build-left-twice": build = |items, builder| {
            let bounds = solution::bounds(items);
            if items.len() <= 2 {
                return Node::leaf(bounds, items);
            }
            let [left, _] = solution::split(items);
            Node::inner(bounds, builder.build(&left), builder.build(&left))
        },
        "build-divided-once": build = |items, _| {
            let bounds = solution::bounds(items);
            if items.len() <= 2 {
                return Node::leaf(bounds, items);
            }
            let [left, right] = solution::split(items).map(|half| Node::leaf(solution::bounds(&half), &half));
            Node::inner(bounds, left, right)
        },
        "nearest-far-skipped": nearest = |node, walk, best| match &node.inside {
            Inside::Items(_) => solution::nearest(node, walk, best),
            Inside::Children(children) => {
                let [left, right] = children.as_ref();
                match (walk.enter(left), walk.enter(right)) {
                    (Some(t), None) if t < best => walk.nearest(left, best),
                    (None, Some(t)) if t < best => walk.nearest(right, best),
                    (Some(t), Some(u)) if t.min(u) < best => walk.nearest(if t <= u { left } else { right }, best),
                    _ => best,
                }
            }
        },
        "nearest-best-not-passed": nearest = |node, walk, best| match &node.inside {
            Inside::Items(_) => solution::nearest(node, walk, best),
            Inside::Children(children) => {
                let mut entered: Vec<(f64, &Node)> =
                    children.iter().filter_map(|child| Some((walk.enter(child)?, child))).collect();
                entered.sort_by(|a, b| a.0.total_cmp(&b.0));
                let mut best = best;
                for (t, child) in entered {
                    if t < best {
                        best = best.min(walk.nearest(child, f64::INFINITY));
                    }
                }
                best
            }
        },
        "nearest-everything": nearest = |node, walk, best| match &node.inside {
            Inside::Items(_) => solution::nearest(node, walk, best),
            Inside::Children(children) => children.iter().fold(best, |best, child| walk.nearest(child, best)),
        },
        "nearest-itself": nearest = |node, walk, best| match &node.inside {
            Inside::Items(_) => solution::nearest(node, walk, best),
            Inside::Children(_) => walk.nearest(node, best),
        },
        // Right, but no faster: only the picture tells.
        "picture-as-they-come": build = |items, builder| {
            let bounds = solution::bounds(items);
            if items.len() <= 2 {
                return Node::leaf(bounds, items);
            }
            let (left, right) = items.split_at(items.len() / 2);
            Node::inner(bounds, builder.build(left), builder.build(right))
        },
    ]
}

/// Which of two equal cuts or equally near boxes comes first makes no difference.
#[test]
fn ties_may_be_broken_either_way() {
    let lesson = check::lesson(check::Student {
        split: |items| {
            let reversed: Vec<_> = items.iter().rev().copied().collect();
            solution::split(&reversed)
        },
        nearest: |node, walk, best| match &node.inside {
            Inside::Items(_) => solution::nearest(node, walk, best),
            Inside::Children(children) => {
                let [left, right] = children.as_ref();
                let [a, b] = [left, right].map(|child| walk.enter(child));
                let order = match (a, b) {
                    (Some(a), Some(b)) if b <= a => [(Some(b), right), (Some(a), left)],
                    _ => [(a, left), (b, right)],
                };
                order.into_iter().fold(best, |best, (t, child)| match t {
                    Some(t) if t <= best => walk.nearest(child, best),
                    _ => best,
                })
            }
        },
        ..student()
    });
    let (report, _) = lesson.check();
    assert!(report.passed, "{}", report.to_text("run"));
}

/// A cut that is dear costs its own stage, and not the picture that is slow because of it.
#[test]
fn a_dear_cut_costs_one_stage() {
    let dear = check::lesson(check::Student {
        split: |items| {
            let (left, right) = items.split_at(1);
            [left.to_vec(), right.to_vec()]
        },
        build: |items, builder| {
            let bounds = solution::bounds(items);
            if items.len() <= 2 {
                return Node::leaf(bounds, items);
            }
            let (left, right) = items.split_at(1);
            Node::inner(bounds, builder.build(left), builder.build(right))
        },
        ..student()
    });
    let (report, _) = dear.check();
    let lost: Vec<&str> = report.stages.iter().filter(|s| s.outcome == Outcome::Failed).map(|s| &*s.function).collect();
    assert_eq!(lost, ["split"]);
    assert_eq!(report.stages[6].outcome, Outcome::NotReached);
}

/// A recursion without end costs its own stage and those that build on it, and says so.
#[test]
fn recursions_without_end_are_told() {
    let all = wrong();
    for (id, stage) in [("build-without-end", 4), ("nearest-itself", 5)] {
        let (_, lesson) = all.iter().find(|(other, _)| *other == id).unwrap();
        let (report, _) = lesson.check();
        assert_eq!(report.stages[stage].outcome, Outcome::Failed, "{id}");
        assert_eq!(report.stages[stage].failure.as_ref().unwrap().got.as_deref(), Some("ends = false"), "{id}");
        assert_eq!(report.stages[6].outcome, Outcome::NotReached, "{id}");
    }
    // Growing without end is noticed as well: each child has one triangle less, and there are two of them.
    let items: Vec<_> = solution_items(40);
    let doubling = |items: &[_], builder: &raytree::lessons::Builder| match items.len() {
        0..=2 => Node::leaf(solution::bounds(items), items),
        _ => Node::inner(solution::bounds(items), builder.build(&items[1..]), builder.build(&items[1..])),
    };
    assert!(Hierarchy::of(doubling, &items).is_none() && Hierarchy::of(solution::build, &items).is_some());
}

fn solution_items(count: usize) -> Vec<raytree::lessons::Item> {
    let corner = |i: usize, k: usize| DVec3::new(i as f64, (i * k % 7) as f64, k as f64);
    let triangle = |i: usize| raytree::lessons::Triangle { vertices: [corner(i, 0), corner(i, 1), corner(i, 3)] };
    (0..count).map(|number| raytree::lessons::Item { number, triangle: triangle(number) }).collect()
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(aabb: Aabb, x: f64) -> Lesson {
    AABB.set(Some(aabb));
    X.set(x);
    check::lesson(check::Student {
        bounds: |_| AABB.get().unwrap(),
        surface_area: |_| X.get(),
        cost: |_, _| X.get(),
        split: |items| [items[..1].to_vec(), items.to_vec()],
        build: |items, _| Node::leaf(AABB.get().unwrap(), items),
        nearest: |_, _, _| X.get(),
    })
}

thread_local! {
    static AABB: Cell<Option<Aabb>> = const { Cell::new(None) };
    static X: Cell<f64> = const { Cell::new(0.0) };
}
