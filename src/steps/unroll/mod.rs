//! A tree unrolled into steps: the lecture's recursion carried out once more, with every outcome read off the tree.

mod direct;
mod intersect;
mod onward;
mod shade;

use std::collections::HashMap;

use super::arithmetic::{Formula, Tiny, Values};
use super::book::{Book, Setting};
use super::pseudocode::Line;
use super::{Arithmetic, Finding, Mark, Node, Picture, Procedure, Question, Recording, Step, Variable, names};
use crate::scene::{Background, Scene};
use crate::tree::{HitRecord, NodePath, Outcome, RayNode, RayTree, Value, six_digits};

use Value::{Number, Vector};

/// The steps of a tree.
pub(super) fn unroll<'a>(scene: &'a Scene, tree: &'a RayTree) -> Recording<'a> {
    let nodes: Vec<Node<'a>> = nodes(tree);
    let places = nodes.iter().enumerate().map(|(i, node)| (std::ptr::from_ref(node.ray), i)).collect();
    let book = Book::new(scene, Setting::of(tree));
    let mut unroll = Unroll { tree, scene, nodes, places, book, steps: Vec::new() };
    unroll.ray_trace();
    Recording { tree, nodes: unroll.nodes, forms: unroll.book.forms, steps: unroll.steps }
}

/// The nodes of a tree, in the order in which they were traced.
fn nodes(tree: &RayTree) -> Vec<Node<'_>> {
    let mut places: HashMap<NodePath, usize> = HashMap::new();
    let all = tree.nodes().into_iter().enumerate();
    let node = |(place, (path, ray)): (usize, (NodePath, _))| {
        let parent = path.parent().and_then(|parent| places.get(&parent).copied());
        places.insert(path.clone(), place);
        Node { path, ray, parent, name: names::name(ray), contribution: names::contribution(ray), values: shared(ray) }
    };
    all.map(node).collect()
}

/// The values that all steps of a ray share.
fn shared(ray: &RayNode) -> Values {
    let mut values = vec![("o", Vector(ray.origin)), ("d", Vector(ray.direction))];
    if ray.outcome.is_traced() {
        let names = ["inv_x", "inv_y", "inv_z"].into_iter().zip(ray.direction);
        values.extend(names.filter(|(_, d)| *d != 0.0).map(|(name, d)| (name, Number(1.0 / d))));
    }
    values
}

struct Unroll<'a> {
    tree: &'a RayTree,
    scene: &'a Scene,
    nodes: Vec<Node<'a>>,
    places: HashMap<*const RayNode, usize>,
    book: Book<'a>,
    steps: Vec<Step>,
}

impl Step {
    fn calls(&mut self, procedure: Procedure) -> &mut Self {
        self.call = Some(procedure);
        self
    }
    fn returning(&mut self) -> &mut Self {
        self.returns = true;
        self
    }
    fn sets(&mut self, name: &'static str, value: Variable) -> &mut Self {
        self.set.push((name, value));
        self
    }
    fn works(&mut self, arithmetic: Option<Arithmetic>) -> &mut Self {
        self.arithmetic = arithmetic;
        self
    }
    fn finds(&mut self, is_ok: bool, words: impl Into<String>) -> &mut Self {
        self.finding = Some(Finding::new(is_ok, words));
        self
    }
    fn asks(&mut self, question: Question) -> &mut Self {
        self.question = Some(question);
        self
    }
    fn marks(&mut self, mark: Mark, is_so: bool) -> &mut Self {
        self.marks.extend(is_so.then_some(mark));
        self
    }
    fn shows(&mut self, kind: &'static str) -> &mut Self {
        self.diagram = Some(Picture { kind, node: None, shape: None, primitive: None });
        self
    }
    fn shows_of(&mut self, kind: &'static str, node: usize) -> &mut Self {
        self.diagram = Some(Picture { kind, node: (node != self.node).then_some(node), shape: None, primitive: None });
        self
    }
}

fn vector(v: glam::DVec3) -> Value {
    Vector(v.to_array())
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

fn product(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] * b[k])
}

fn none() -> Variable {
    Variable::Text("none".to_owned())
}

impl<'a> Unroll<'a> {
    fn place(&self, node: &RayNode) -> usize {
        self.places.get(&std::ptr::from_ref(node)).copied().unwrap_or_default()
    }

    /// A new step at a line, about a node.
    fn step(&mut self, line: Line, node: usize) -> &mut Step {
        let place = self.steps.len();
        self.steps.push(Step { line: line as usize, node, ..Step::default() });
        &mut self.steps[place]
    }

    /// Works a formula out with the values of a node.
    fn work(
        &mut self,
        node: usize,
        formula: Formula,
        inputs: Values,
        last: Option<&str>,
        wanted: &[(&str, Value)],
    ) -> Option<Arithmetic> {
        self.book.shared.clone_from(&self.nodes[node].values);
        self.book.work(formula, inputs, last, wanted.iter().copied())
    }

    /// Works out the formula of a new ray's direction.
    fn work_way(
        &mut self,
        node: usize,
        formula: fn(Tiny) -> Formula,
        inputs: &Values,
        wanted: &[(&str, Value)],
    ) -> Option<Arithmetic> {
        Tiny::ALL.into_iter().find_map(|tiny| self.work(node, formula(tiny), inputs.clone(), None, wanted))
    }

    fn ray_trace(&mut self) {
        let root = &self.tree.root;
        let Some([x, y]) = self.tree.pixel else {
            self.trace(root);
            return;
        };
        let ray = Variable::Ray { origin: root.origin, direction: root.direction, t_max: None };
        let coordinate = |x: u32| Variable::Integer(u64::from(x));
        let header = self.step(Line::RayTrace, 0).calls(Procedure::RayTrace).shows("section");
        header.sets("x", coordinate(x)).sets("y", coordinate(y));
        self.step(Line::RayTraceRay, 0).shows("section");
        let header = self.step(Line::ComputeRay, 0).calls(Procedure::ComputeRay).shows("section");
        header.sets("x", coordinate(x)).sets("y", coordinate(y));
        let camera = &self.scene.camera;
        let (width, height) = (self.scene.image.width, self.scene.image.height);
        let inputs = vec![
            ("x", Number(f64::from(x))),
            ("y", Number(f64::from(y))),
            ("width", Number(f64::from(width))),
            ("height", Number(f64::from(height))),
            ("half_height", Number(camera.half_height)),
            ("right", vector(camera.right)),
            ("up", vector(camera.up)),
            ("forward", vector(camera.forward)),
        ];
        let mut arithmetic = self.work(0, Formula::Camera, inputs, None, &[("d", Vector(root.direction))]);
        // The line `d` gives what the node has already.
        if let Some(arithmetic) = &mut arithmetic {
            arithmetic.values.push(("d", Vector(root.direction)));
        }
        self.step(Line::ComputeRayReturn, 0).works(arithmetic).sets("ray", ray.clone()).returning().shows("section");
        self.step(Line::RayTraceTrace, 0).sets("ray", ray).shows("section");
        self.trace(root);
        let color = Variable::Vector(self.tree.color);
        self.step(Line::RayTracePut, 0).sets("color", color).returning().shows("tree");
    }

    /// The lecture's Trace.
    fn trace(&mut self, node: &'a RayNode) {
        let place = self.place(node);
        let ray = Variable::Ray { origin: node.origin, direction: node.direction, t_max: None };
        let header = self.step(Line::Trace, place).calls(Procedure::Trace).shows("section");
        header.sets("level", Variable::Integer(u64::from(node.depth))).sets("ray", ray);
        if let Some(weight) = node.weight {
            header.sets("weight", Variable::Vector(weight));
        }
        self.step(Line::TraceIntersect, place).shows("section");
        self.intersect(node);
        let words = match &node.hit {
            Some(hit) => format!("the ray hits {} at t = {}", self.object(hit), six_digits(hit.t)),
            None => "the ray hits nothing".to_owned(),
        };
        let is_hit = node.outcome == Outcome::Hit;
        let hit = node.hit.as_ref().map_or_else(none, hit_variable);
        self.step(Line::TraceShade, place).sets("hit", hit).finds(is_hit, words).shows("section");
        let color = match &node.hit {
            Some(hit) if is_hit => self.shade(node, hit),
            _ => self.background(node),
        };
        self.step(Line::TraceReturn, place).sets("color", Variable::Vector(color)).returning().shows("section");
    }

    fn background(&mut self, node: &RayNode) -> [f64; 3] {
        let place = self.place(node);
        let color = node.radiance.unwrap_or_default();
        if node.outcome != Outcome::Background {
            return color;
        }
        let (arithmetic, words) = match self.scene.background {
            Background::Constant(_) => (None, "the background is the same everywhere"),
            Background::Gradient { bottom, top, up } => {
                let inputs = vec![("bottom", vector(bottom)), ("top", vector(top)), ("up", vector(up))];
                let wanted = [("color", Vector(color))];
                (
                    self.work(place, Formula::Gradient, inputs, None, &wanted),
                    "the background's gradient, by the direction",
                )
            }
        };
        let step = self.step(Line::TraceBackground, place).works(arithmetic).finds(true, words);
        step.sets("color", Variable::Vector(color)).shows("section");
        color
    }

    fn object(&self, hit: &HitRecord) -> String {
        hit.object.clone().unwrap_or_else(|| format!("shape {}", hit.shape))
    }
}

fn hit_variable(hit: &HitRecord) -> Variable {
    Variable::Hit { t: hit.t, object: hit.object.clone(), shape: hit.shape, primitive: hit.primitive }
}
