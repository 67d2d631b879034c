//! Lesson 12: what a student's hierarchy of boxes is made of, and what watches its recursions and counts its tests.

use std::cell::{Cell, RefCell};

use glam::DVec3;

use super::{Aabb, Ray, Triangle};
use crate::hits::{Bounds, SlabRay};
use crate::kernels::{TriangleFilter, intersect_triangle_certified};

/// A triangle of a mesh, and its number there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Item {
    /// Its number.
    pub number: usize,
    /// The triangle.
    pub triangle: Triangle,
}

impl Item {
    /// The middle of the triangle: the mean of its corners.
    pub fn center(&self) -> DVec3 {
        let [v0, v1, v2] = self.triangle.vertices;
        (v0 + v1 + v2) / 3.0
    }
}

/// A box of a hierarchy with what is inside.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The box.
    pub bounds: Aabb,
    /// What is inside.
    pub inside: Inside,
    /// Its place in a [`Hierarchy`]: parents before children, left before right.
    number: usize,
}

/// What is inside a box.
#[derive(Clone, Debug, PartialEq)]
pub enum Inside {
    /// Triangles.
    Items(Vec<Item>),
    /// Two smaller boxes.
    Children(Box<[Node; 2]>),
}

impl Node {
    /// A box around triangles.
    pub fn leaf(bounds: Aabb, items: &[Item]) -> Self {
        Node { bounds, inside: Inside::Items(items.to_vec()), number: 0 }
    }

    /// A box around two boxes.
    pub fn inner(bounds: Aabb, left: Node, right: Node) -> Self {
        Node { bounds, inside: Inside::Children(Box::new([left, right])), number: 0 }
    }

    /// Its place in its hierarchy, from 0.
    pub fn number(&self) -> usize {
        self.number
    }

    /// This node and all below, with how deep each lies.
    pub fn walk(&self) -> Vec<(&Node, usize)> {
        let mut found = Vec::new();
        let mut open = vec![(self, 0)];
        while let Some((node, depth)) = open.pop() {
            found.push((node, depth));
            if let Inside::Children(children) = &node.inside {
                let [left, right] = children.as_ref();
                open.extend([(right, depth + 1), (left, depth + 1)]);
            }
        }
        found
    }

    /// All triangles inside, those of the left child first.
    pub fn items(&self) -> impl Iterator<Item = &Item> {
        self.walk().into_iter().flat_map(|(node, _)| match &node.inside {
            Inside::Items(items) => items.as_slice(),
            Inside::Children(_) => &[],
        })
    }

    /// Numbers this node and those below, from `next` on; the number after the last.
    fn count_from(&mut self, next: usize) -> usize {
        self.number = next;
        match &mut self.inside {
            Inside::Items(_) => next + 1,
            Inside::Children(children) => children.iter_mut().fold(next + 1, |next, child| child.count_from(next)),
        }
    }
}

/// A finished hierarchy, its nodes numbered.
#[derive(Clone, Debug, PartialEq)]
pub struct Hierarchy {
    root: Node,
    nodes: usize,
}

/// A function that makes a node of some triangles, and asks the [`Builder`] for the nodes below.
pub type Build = fn(&[Item], &Builder) -> Node;

/// Calls a student's `build` again for the children, and notices a recursion that would never end.
#[derive(Debug)]
pub struct Builder {
    build: Build,
    /// How many triangles the calls have that are not over yet.
    open: RefCell<Vec<usize>>,
    calls_left: Cell<usize>,
    is_endless: Cell<bool>,
}

impl Builder {
    /// The node that `build` makes of fewer triangles than those it was called with.
    pub fn build(&self, items: &[Item]) -> Node {
        let is_smaller = self.open.borrow().last().is_none_or(|parent| items.len() < *parent);
        if !is_smaller || self.calls_left.get() == 0 {
            self.is_endless.set(true);
        }
        if self.is_endless.get() {
            return Node::leaf(Aabb { min: DVec3::ZERO, max: DVec3::ZERO }, &[]);
        }
        self.calls_left.set(self.calls_left.get() - 1);
        self.open.borrow_mut().push(items.len());
        let node = (self.build)(items, self);
        self.open.borrow_mut().pop();
        node
    }
}

impl Hierarchy {
    /// The hierarchy that `build` makes. `None` where its recursion would never end: a child has no fewer triangles than its
    /// parent, or there are many more nodes than triangles.
    pub fn of(build: Build, items: &[Item]) -> Option<Self> {
        let builder = Builder {
            build,
            open: RefCell::default(),
            calls_left: Cell::new(8 * items.len() + 8),
            is_endless: Cell::new(false),
        };
        let mut root = builder.build(items);
        let nodes = root.count_from(0);
        (!builder.is_endless.get()).then_some(Hierarchy { root, nodes })
    }

    /// The box around everything.
    pub fn root(&self) -> &Node {
        &self.root
    }

    /// How many boxes there are.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// Sends a ray through: `nearest` is called on the root if the ray enters its box.
    pub fn walked(&self, nearest: Nearest, ray: &Ray) -> Walked {
        let walk = Walk {
            ray,
            slabs: SlabRay::new(ray),
            nearest,
            asked: RefCell::default(),
            tested: RefCell::default(),
            visited: RefCell::default(),
            depth: Cell::new(0),
            deepest: self.nodes,
            is_endless: Cell::new(false),
        };
        let t = match walk.enter(&self.root) {
            Some(_) => walk.nearest(&self.root, f64::INFINITY),
            None => f64::INFINITY,
        };
        Walked {
            t,
            ends: !walk.is_endless.get(),
            asked: walk.asked.into_inner(),
            tested: walk.tested.into_inner(),
            visited: walk.visited.into_inner(),
        }
    }
}

/// A function that returns the t of the nearest hit: the one it is given, or that of a triangle inside the node where that is
/// smaller. Infinite where there is none.
pub type Nearest = fn(&Node, &Walk<'_>, f64) -> f64;

/// A ray on its way through a hierarchy: the tests, which are exact and counted, and the recursion.
#[derive(Debug)]
pub struct Walk<'r> {
    ray: &'r Ray,
    slabs: SlabRay,
    nearest: Nearest,
    asked: RefCell<Vec<usize>>,
    tested: RefCell<Vec<usize>>,
    visited: RefCell<Vec<usize>>,
    depth: Cell<usize>,
    deepest: usize,
    is_endless: Cell<bool>,
}

/// What came of sending a ray through a hierarchy.
#[derive(Clone, Debug, PartialEq)]
pub struct Walked {
    /// The t of the nearest hit; infinite where there is none.
    pub t: f64,
    /// Whether the recursion ended by itself.
    pub ends: bool,
    /// The nodes whose boxes were tested, in order.
    pub asked: Vec<usize>,
    /// The triangles that were tested, in order.
    pub tested: Vec<usize>,
    /// The nodes that the recursion went into, in order.
    pub visited: Vec<usize>,
}

impl Walk<'_> {
    /// Where the ray enters the box of a node, 0 where it starts inside; `None` where it passes it or has it behind.
    pub fn enter(&self, node: &Node) -> Option<f64> {
        self.asked.borrow_mut().push(node.number);
        let Aabb { min, max } = node.bounds;
        let (t_in, t_out) = self.slabs.span(&Bounds { min: min.to_array(), max: max.to_array() });
        (t_in <= t_out).then_some(t_in)
    }

    /// The t at which the ray hits a triangle; `None` where it misses it.
    pub fn hit(&self, item: &Item) -> Option<f64> {
        self.tested.borrow_mut().push(item.number);
        hit(self.ray, &item.triangle)
    }

    /// What the function that was sent through returns for a node, usually a child of the present one.
    pub fn nearest(&self, node: &Node, best: f64) -> f64 {
        if self.depth.get() > self.deepest {
            self.is_endless.set(true);
        }
        if self.is_endless.get() {
            return best;
        }
        self.visited.borrow_mut().push(node.number);
        self.depth.set(self.depth.get() + 1);
        let t = (self.nearest)(node, self, best);
        self.depth.set(self.depth.get() - 1);
        t
    }
}

/// The t at which a ray hits a triangle, decided exactly; `None` where it misses it.
pub fn hit(ray: &Ray, triangle: &Triangle) -> Option<f64> {
    let filter = TriangleFilter::of_triangle(ray, triangle);
    intersect_triangle_certified(ray, triangle, &filter).ok().map(|certified| certified.t)
}
