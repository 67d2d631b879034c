//! A tree unrolled into steps: the lecture's recursion carried out once more, with every outcome read off the tree.

use std::collections::HashMap;

use super::arithmetic::{Cosines, Formula, OnSurface, Split, Tiny, Values};
use super::book::{Book, Setting};
use super::pseudocode::Line;
use super::tested::{exact_words, look};
use super::{Arithmetic, Finding, Mark, Node, Picture, Procedure, Question, Recording, Step, Variable, names};
use crate::kernels::refraction_sign;
use crate::numbers::{Stage, is_in_range};
use crate::scene::{Background, Fresnel, Light, LightKind, Material, Numerics, Pigment, Scene, Shape};
use crate::tree::{HitRecord, Kind, NodePath, Outcome, RayNode, RayTree, TestRecord, Value, Verdict, six_digits};

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

/// What a hit is made of, for shading.
struct Spot<'a> {
    /// The node's place.
    place: usize,
    node: &'a RayNode,
    hit: &'a HitRecord,
    material: &'a Material,
    /// The colour of the ambient and diffuse terms.
    surface: [f64; 3],
    /// The shading normal.
    normal: [f64; 3],
    /// The kind of diagram that shows what happens here.
    picture: &'static str,
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

    /// The lecture's Intersect: every test that the ray took.
    fn intersect(&mut self, node: &'a RayNode) {
        let place = self.place(node);
        let ray = Variable::Ray { origin: node.origin, direction: node.direction, t_max: node.t_max };
        let header = self.step(Line::Intersect, place).calls(Procedure::Intersect).shows("section");
        header.sets("ray", ray).sets("best", none());
        self.book.shared.clone_from(&self.nodes[place].values);
        let parent = self.nodes[place].parent.map(|parent| self.nodes[parent].ray);
        for (i, test) in node.tests.iter().flatten().enumerate() {
            let tested = look(&mut self.book, node, parent, test);
            let values = tested.arithmetic.as_ref().map_or(&[][..], |arithmetic| &arithmetic.values);
            let is_nan = values.iter().any(|(_, value)| match value {
                Number(x) => x.is_nan(),
                Vector(x) => x.iter().any(|x| x.is_nan()),
            });
            let question = question(test);
            let (line, shape, primitive) = match test {
                TestRecord::Bounds(test) => (Line::IntersectBounds, test.shape, test.primitive),
                TestRecord::Shape(test) => (Line::IntersectShape, Some(test.shape), test.primitive),
            };
            let step = self.step(line, place);
            step.test = Some(i);
            step.arithmetic = tested.arithmetic;
            step.finding = Some(tested.finding);
            step.diagram = Some(match tested.diagram {
                Some(kind) => Picture { kind, node: None, shape, primitive },
                None => Picture { kind: "section", node: None, shape: None, primitive: None },
            });
            step.question = question;
            step.marks(Mark::Exact, tested.is_exact).marks(Mark::NotANumber, is_nan);
            if let TestRecord::Shape(test) = test
                && let (Verdict::Best, Some(t)) = (test.verdict, test.t)
            {
                let (object, shape, primitive) = (test.object.clone(), test.shape, test.primitive);
                step.sets("best", Variable::Hit { t, object, shape, primitive });
            }
        }
        let is_shadow = node.kind == Kind::Shadow;
        let words = match (&node.hit, is_shadow) {
            (Some(hit), false) => format!("{} is the nearest hit, at t = {}", self.object(hit), six_digits(hit.t)),
            (Some(hit), true) => format!("{} stands in the way, at t = {}", self.object(hit), six_digits(hit.t)),
            (None, false) => "nothing is hit".to_owned(),
            (None, true) => "nothing stands in the way".to_owned(),
        };
        let question = (!is_shadow).then(|| self.what_is_hit(node)).flatten();
        let step = self.step(Line::IntersectReturn, place).finds(node.hit.is_some(), words).returning();
        step.marks(Mark::Hit, node.outcome == Outcome::Hit).marks(Mark::Blocked, node.outcome == Outcome::Blocked);
        step.question = question;
        step.shows("section");
    }

    /// What does the ray hit? The objects that were tested, four at most, and nothing.
    fn what_is_hit(&self, node: &RayNode) -> Option<Question> {
        let mut names: Vec<String> = Vec::new();
        let hit = node.hit.as_ref().and_then(|hit| hit.object.clone());
        let tested = node.tests.iter().flatten().filter_map(|test| match test {
            TestRecord::Bounds(test) => test.object.clone(),
            TestRecord::Shape(test) => test.object.clone(),
        });
        for name in hit.iter().cloned().chain(tested) {
            if names.len() < 4 && !names.contains(&name) {
                names.push(name);
            }
        }
        if names.is_empty() {
            return None;
        }
        // In the order of the scene, so that the place says nothing.
        names.sort_by_key(|name| self.scene.objects.iter().position(|object| object.name == *name));
        let answer = hit.and_then(|hit| names.iter().position(|name| *name == hit)).unwrap_or(names.len());
        names.push("nothing".to_owned());
        Some(Question::between("What does the ray hit?", names, answer))
    }

    /// The lecture's Shade.
    fn shade(&mut self, node: &'a RayNode, hit: &'a HitRecord) -> [f64; 3] {
        let place = self.place(node);
        // Of a surface that sends no ray on there is a section alone.
        let goes_on = node.reflected.is_some() || node.refracted.is_some();
        let picture = if goes_on { "surface" } else { "section" };
        let header = self.step(Line::Shade, place).calls(Procedure::Shade).shows(picture);
        header.sets("level", Variable::Integer(u64::from(node.depth))).sets("hit", hit_variable(hit));
        let radiance = node.radiance.unwrap_or_default();
        let object = self.scene.objects.get(hit.shape as usize);
        let material = object.and_then(|object| self.scene.materials.get(object.material.0 as usize));
        let (Some(object), Some(material)) = (object, material) else {
            let step = self.step(Line::ShadeReturn, place);
            step.finds(false, "the scene has no such object").sets("color", Variable::Vector(radiance)).returning();
            return radiance;
        };
        let in_plane = match object.shape {
            Shape::Plane { normal, .. } => Some(normal),
            _ => None,
        };
        let surface = material.pigment.color(hit.point.into(), in_plane).to_array();
        let normal = hit.shading_normal.unwrap_or(hit.geometric_normal);
        let spot = Spot { place, node, hit, material, surface, normal, picture };
        self.point_and_normal(&spot, &object.shape);
        let mut color = self.ambient(&spot);
        color = self.lights(&spot, color);
        self.snell(&spot);
        let (reflected, refracted) = (node.reflected.as_deref(), node.refracted.as_deref());
        if reflected.is_none() && refracted.is_none() {
            let words = "the surface neither reflects nor lets light through: the recursion ends here";
            self.step(Line::ShadeReflected, place).finds(false, words).shows(picture).asks(next_ray(None));
        }
        for child in reflected.into_iter().chain(refracted) {
            let is_reflected = child.kind == Kind::Reflected;
            let line = if is_reflected { Line::ShadeReflected } else { Line::ShadeRefracted };
            let words =
                if is_reflected { "a ray goes back from the surface" } else { "a ray goes through the surface" };
            let step = self.step(line, place).finds(true, words).shows(picture);
            if is_reflected || reflected.is_none() {
                step.asks(next_ray(Some(child.kind)));
            }
            let returned = self.child(&spot, child);
            let inputs = vec![("color_so_far", Vector(color)), ("more", Vector(returned))];
            let arithmetic = self.work(place, Formula::Sum, inputs, None, &[]);
            color = sum(color, returned);
            let line = if is_reflected { Line::ShadeReflectedSum } else { Line::ShadeRefractedSum };
            self.step(line, place).works(arithmetic).sets("color", Variable::Vector(color)).shows(picture);
        }
        let is_sum = color.map(f64::to_bits) == radiance.map(f64::to_bits);
        let step = self.step(Line::ShadeReturn, place).sets("color", Variable::Vector(radiance)).returning();
        step.shows(picture);
        if !is_sum {
            step.finds(false, "the tree has another colour than the sum of its parts");
        }
        radiance
    }

    fn point_and_normal(&mut self, spot: &Spot<'_>, shape: &Shape) {
        let Spot { place, node, hit, .. } = *spot;
        let setting = self.book.setting;
        let vectors = |v: [glam::DVec3; 3]| v.map(|v| Vector(v.to_array().map(|x| setting.rays.round(x))));
        let rounded = |v: glam::DVec3| Vector(v.to_array().map(|x| setting.rays.round(x)));
        let is_certified = setting.numerics == Numerics::Certified;
        // A certified t is good to more digits than f32 holds; the point is worked out with them.
        let best = node.tests.iter().flatten().rev().find_map(|test| match test {
            TestRecord::Shape(test) if test.verdict == Verdict::Best => test.t,
            _ => None,
        });
        let t = if is_certified && !setting.by_error_bound { best.unwrap_or(hit.t) } else { hit.t };
        let mut inputs = vec![("t", Number(t))];
        let mut tries = vec![OnSurface::Stays];
        let returns = is_certified || setting.by_error_bound;
        let triangle = match (shape, hit.primitive) {
            (Shape::Triangle { vertices }, _) => Some(*vertices),
            (Shape::Mesh(mesh), Some(primitive)) => mesh.triangles.get(primitive as usize).copied(),
            _ => None,
        };
        match (shape, triangle) {
            (Shape::Sphere { center, radius }, _) if returns => {
                inputs.extend([("center", rounded(*center)), ("radius", Number(setting.rays.round(*radius)))]);
                tries =
                    vec![OnSurface::Sphere, OnSurface::FarSphere { near: true }, OnSurface::FarSphere { near: false }];
            }
            (Shape::Box { min, max }, _) if returns => {
                let (mut min, mut max) = (min.to_array(), max.to_array());
                let face = hit.primitive.unwrap_or_default().min(5) as usize;
                let at = if face.is_multiple_of(2) { min[face / 2] } else { max[face / 2] };
                (min[face / 2], max[face / 2]) = (at, at);
                inputs.extend([("face_min", rounded(min.into())), ("face_max", rounded(max.into()))]);
                tries = vec![OnSurface::Face];
            }
            (Shape::Plane { normal, distance }, _) if setting.by_error_bound => {
                inputs.extend([("n", rounded(*normal)), ("D", Number(setting.rays.round(*distance)))]);
                tries = vec![OnSurface::Plane];
            }
            (_, Some(vertices)) if setting.by_error_bound => {
                inputs = ["v0", "v1", "v2"].into_iter().zip(vectors(vertices)).collect();
                let weights = hit.barycentrics.unwrap_or_default();
                inputs.extend(["a", "b", "c"].into_iter().zip(weights.map(Number)));
                tries = vec![OnSurface::Triangle];
            }
            _ => {}
        }
        let wanted = [("p", Vector(hit.point))];
        let tries = tries.into_iter();
        let mut found = tries.map(|surface| self.work(place, Formula::Point(surface), inputs.clone(), None, &wanted));
        let arithmetic = found.find_map(|found| found);
        let step = self.step(Line::ShadePoint, place);
        if arithmetic.is_none() {
            step.finds(true, "o + t d, brought back onto the surface");
        }
        step.works(arithmetic).sets("p", Variable::Vector(hit.point)).shows("section");

        let arithmetic = match shape {
            Shape::Sphere { center, .. } => {
                let inputs = vec![("p", Vector(hit.point)), ("center", rounded(*center))];
                self.work(place, Formula::SphereNormal, inputs, None, &[("n", Vector(hit.geometric_normal))])
            }
            _ => None,
        };
        let is_turned = spot.normal == hit.geometric_normal.map(|x| -x);
        let words = match (is_turned, spot.normal == hit.geometric_normal) {
            (true, _) => "turned round, towards the ray: it comes from behind the outward normal",
            (false, true) => "the outward normal, which points towards the ray already",
            (false, false) => "interpolated between the normals at the corners",
        };
        let step = self.step(Line::ShadeNormal, place).works(arithmetic).finds(true, words);
        step.sets("n", Variable::Vector(spot.normal)).shows(spot.picture);
    }

    fn ambient(&mut self, spot: &Spot<'_>) -> [f64; 3] {
        let ambient = spot.node.local.as_ref().map_or([0.0; 3], |local| local.ambient);
        let (mut arithmetic, mut words) = (None, "the material has no ambient term: black".to_owned());
        if let Some(k) = spot.material.ambient {
            let inputs = vec![("k_a", vector(k)), ("surface", Vector(spot.surface))];
            arithmetic = self.work(spot.place, Formula::Ambient, inputs, None, &[("color", Vector(ambient))]);
            words = match spot.material.pigment {
                Pigment::Constant(_) => "the ambient term".to_owned(),
                Pigment::Checker { .. } => "the ambient term, with the colour of this field of the checker".to_owned(),
            };
        }
        let step = self.step(Line::ShadeAmbient, spot.place).works(arithmetic).finds(true, words);
        step.sets("color", Variable::Vector(ambient)).shows(spot.picture);
        ambient
    }

    fn lights(&mut self, spot: &Spot<'a>, mut color: [f64; 3]) -> [f64; 3] {
        let node = spot.node;
        let lights = &self.scene.lights;
        if !spot.material.takes_direct_light() {
            let words = "the material has no diffuse and no specular term: direct light could not change it";
            self.step(Line::ShadeLights, spot.place).finds(false, words).shows(spot.picture);
            return color;
        }
        let words = match lights.len() {
            0 => "the scene has no light".to_owned(),
            1 => "one light".to_owned(),
            n => format!("{n} lights"),
        };
        self.step(Line::ShadeLights, spot.place).finds(!lights.is_empty(), words).shows(spot.picture);
        let mut shadows = node.shadows.iter().enumerate().peekable();
        for light in lights {
            let light_name = Variable::Text(light.name.clone());
            self.step(Line::ShadeDirect, spot.place).sets("light", light_name).shows(spot.picture);
            let shadow = shadows.next_if(|(_, shadow)| shadow.light.as_ref() == Some(&light.name));
            let direct = self.direct_light(spot, light, shadow);
            let inputs = vec![("color_so_far", Vector(color)), ("more", Vector(direct))];
            let arithmetic = self.work(spot.place, Formula::Sum, inputs, None, &[]);
            color = sum(color, direct);
            let step = self.step(Line::ShadeDirectSum, spot.place).works(arithmetic);
            step.sets("color", Variable::Vector(color)).shows(spot.picture);
        }
        color
    }

    /// The lecture's ComputeDirectLight.
    fn direct_light(&mut self, spot: &Spot<'a>, light: &Light, shadow: Option<(usize, &'a RayNode)>) -> [f64; 3] {
        let place = spot.place;
        let black = Variable::Vector([0.0; 3]);
        let header = self.step(Line::Direct, place).calls(Procedure::ComputeDirectLight).shows(spot.picture);
        header.sets("light", Variable::Text(light.name.clone()));
        let way = self.way_to(spot, light, shadow.map(|(_, shadow)| shadow));
        let found = |name| {
            let arithmetic = way.as_ref()?;
            super::value_of(&arithmetic.values, name)
        };
        let l = match (shadow, found("l")) {
            (Some((_, shadow)), _) => Some(shadow.direction),
            (None, Some(Vector(l))) => Some(l),
            (None, _) => None,
        };
        let distance = found("distance");
        let step = self.step(Line::DirectWay, place).works(way).shows(spot.picture);
        if let Some(l) = l {
            step.sets("l", Variable::Vector(l));
        }
        if let Some(Number(distance)) = distance {
            step.sets("distance", Variable::Number(distance));
        }
        let is_faced = shadow.is_some();
        let mut cosine = None;
        if let Some(l) = l {
            let inputs = vec![("l", Vector(l)), ("n", Vector(spot.normal))];
            cosine = self.work(place, Formula::Cosine, inputs, None, &[]);
        }
        let n_dot_l = cosine.as_ref().and_then(|cosine| match super::value_of(&cosine.values, "n_dot_l")? {
            Number(x) => Some(x),
            Vector(_) => None,
        });
        let agrees = n_dot_l.is_some_and(|x| (x >= 0.0) == is_faced);
        let words = match (is_faced, agrees) {
            (true, _) => "the surface faces the light",
            (false, true) => "n . l < 0: the surface faces away from the light, no shadow ray is needed",
            (false, false) => "the light lies on the surface itself, or too far away for a distance: it adds nothing",
        };
        let question = Question::yes_or_no(format!("Does the surface face {}?", light.name), is_faced);
        let step = self.step(Line::DirectCosine, place).works(cosine.filter(|_| agrees)).finds(is_faced, words);
        step.asks(question).shows(spot.picture);
        if let Some(n_dot_l) = n_dot_l.filter(|_| agrees) {
            step.sets("n_dot_l", Variable::Number(n_dot_l));
        }
        let Some((number, shadow)) = shadow else {
            step.sets("direct", black).returning();
            return [0.0; 3];
        };
        let at = self.place(shadow);
        if !shadow.outcome.is_traced() {
            let words = "the rays of this pixel are spent: what is not known to be lit counts as blocked";
            self.step(Line::DirectIntersect, at)
                .finds(false, words)
                .sets("direct", black)
                .returning()
                .shows(spot.picture);
            return [0.0; 3];
        }
        self.step(Line::DirectIntersect, at).shows("section");
        self.intersect(shadow);
        let is_lit = shadow.outcome == Outcome::Lit;
        let words = match &shadow.hit {
            Some(hit) if !is_lit => format!("{} blocks the light: shadow", self.object(hit)),
            _ if is_lit => "nothing stands between: lit".to_owned(),
            _ => "blocked: shadow".to_owned(),
        };
        let question = Question::between(
            format!("Is this point lit by {}?", light.name),
            ["lit", "in shadow"],
            usize::from(!is_lit),
        );
        let step = self.step(Line::DirectBlocked, at).finds(is_lit, words).asks(question).shows("section");
        step.sets("hit", shadow.hit.as_ref().map_or_else(none, hit_variable));
        if !is_lit {
            step.sets("direct", black).returning();
            return [0.0; 3];
        }
        let local = spot.node.local.as_ref();
        let terms = local.and_then(|local| local.lights.get(number));
        let (diffuse, specular) = terms.map_or(([0.0; 3], [0.0; 3]), |terms| (terms.diffuse, terms.specular));
        let light_color = vector(light.color);
        let (mut arithmetic, mut words) = (None, "the material has no diffuse term");
        if let (Some(k), Some(n_dot_l)) = (spot.material.diffuse, n_dot_l) {
            let inputs = vec![
                ("k_d", vector(k)),
                ("surface", Vector(spot.surface)),
                ("n_dot_l", Number(n_dot_l)),
                ("light", light_color),
            ];
            arithmetic = self.work(place, Formula::Diffuse, inputs, None, &[("diffuse", Vector(diffuse))]);
            words = "Lambert's law";
        }
        let step = self.step(Line::DirectDiffuse, place).works(arithmetic).finds(true, words).shows(spot.picture);
        step.sets("diffuse", Variable::Vector(diffuse));
        let (mut arithmetic, mut words) = (None, "the material has no highlight");
        if let Some(k) = spot.material.specular {
            let inputs = vec![
                ("k_s", vector(k.strength)),
                ("shininess", Number(k.shininess)),
                ("n", Vector(spot.normal)),
                ("l", Vector(shadow.direction)),
                ("light", light_color),
            ];
            arithmetic = self.work(place, Formula::Specular, inputs, None, &[("specular", Vector(specular))]);
            words = "Phong's highlight";
        }
        let step = self.step(Line::DirectSpecular, place).works(arithmetic).finds(true, words).shows(spot.picture);
        step.sets("specular", Variable::Vector(specular));
        let inputs = vec![("diffuse", Vector(diffuse)), ("specular", Vector(specular))];
        let arithmetic = self.work(place, Formula::Direct, inputs, None, &[]);
        let direct = sum(diffuse, specular);
        let step = self.step(Line::DirectReturn, place).works(arithmetic).returning().shows(spot.picture);
        step.sets("direct", Variable::Vector(direct));
        direct
    }

    /// The way to a light.
    fn way_to(&mut self, spot: &Spot<'_>, light: &Light, shadow: Option<&RayNode>) -> Option<Arithmetic> {
        let rays = self.book.setting.rays;
        let rounded = |v: glam::DVec3| Vector(v.to_array().map(|x| rays.round(x)));
        let mut wanted: Vec<(&str, Value)> = shadow.iter().map(|shadow| ("l", Vector(shadow.direction))).collect();
        let (formula, inputs): (fn(Tiny) -> Formula, Values) = match light.kind {
            LightKind::Directional { direction } => {
                (Formula::ToDirectionalLight, vec![("travels", rounded(direction))])
            }
            LightKind::Point { position } => {
                wanted.extend(shadow.and_then(|shadow| shadow.t_max).map(|t_max| ("distance", Number(t_max))));
                (Formula::ToPointLight, vec![("position", rounded(position)), ("p", Vector(spot.hit.point))])
            }
        };
        self.work_way(spot.place, formula, &inputs, &wanted)
    }

    /// Snell's law and Fresnel's equations, where the material asks for them.
    fn snell(&mut self, spot: &Spot<'_>) {
        let Spot { place, node, hit, material, .. } = *spot;
        let (fresnel, is_through) = (material.fresnel, material.transmission.is_some());
        let Some([n_i, n_t]) = hit.ior.filter(|_| is_through || (fresnel.is_some() && material.reflection.is_some()))
        else {
            return;
        };
        let is_total = node.total_reflection;
        let inputs = vec![("n", Vector(spot.normal)), ("n_i", Number(n_i)), ("n_t", Number(n_t))];
        let is_certified = self.book.setting.numerics == Numerics::Certified;
        let sign = if is_certified { self.transmission(spot) } else { None };
        let (mut arithmetic, mut words) = (None, String::new());
        let n_words = format!("from index {} into {}", six_digits(n_i), six_digits(n_t));
        if !is_certified {
            let last = if is_total { "k" } else { "cos_t" };
            arithmetic = self.work(place, Formula::SnellUsual(Tiny::Kept), inputs, Some(last), &[]);
            let verdict =
                if is_total { "k < 0: no light gets through, total reflection" } else { "k >= 0: light gets through" };
            words = format!("{n_words}, {verdict}");
        } else if n_i == n_t {
            words = format!("{n_words}: equal indices, the ray goes straight on");
        } else if let Some(s) = sign {
            let words_of =
                if is_total { "S < 0: no light gets through, total reflection" } else { "S >= 0: light gets through" };
            words = format!("{n_words}, {words_of}");
            arithmetic = self.work(place, Formula::SnellSign, inputs, None, &[]);
            if let Some(arithmetic) = &mut arithmetic {
                let note = format!(
                    "S = {s:?}: worked out with more digits, then rounded. Its sign decides, not that of S_64."
                );
                arithmetic.note = Some(note);
            }
        }
        let stage = node.refraction_certificate.map(|certificate| certificate.stage).filter(|s| *s != Stage::Filter);
        if let Some(stage) = stage {
            words = format!("{words}; decided exactly, {}", exact_words(stage));
        }
        let given = |arithmetic: &Arithmetic| {
            let value = |name| super::value_of(&arithmetic.values, name);
            Some((Cosines::Given, vec![("cos_i", value("cos_i")?), ("cos_t", value("cos_t")?)]))
        };
        let cosines = match sign {
            Some(s) => Some((Cosines::FromSign, vec![("n", Vector(spot.normal)), ("S", Number(s))])),
            None => arithmetic.as_ref().and_then(given),
        };
        let step = self.step(Line::ShadeSnell, place).works(arithmetic).finds(!is_total, words).shows(spot.picture);
        step.marks(Mark::TotalReflection, is_total).marks(Mark::Exact, stage.is_some());
        if is_through {
            step.asks(Question::yes_or_no("Is all light reflected?", is_total));
        }
        let (Some(fresnel), Some(r)) = (fresnel, node.fresnel) else { return };
        let mut arithmetic = None;
        let words = if n_i == n_t {
            "equal indices: nothing is reflected"
        } else if let (false, Some((given, cosines))) = (is_total, cosines) {
            let formula = match fresnel {
                Fresnel::Exact => Formula::FresnelExact(given),
                Fresnel::Schlick => Formula::FresnelSchlick { given, from_smaller: n_i <= n_t },
            };
            let inputs = [cosines, vec![("n_i", Number(n_i)), ("n_t", Number(n_t))]].concat();
            arithmetic = self.work(place, formula, inputs, None, &[("R", Number(r))]);
            "so much comes back; the rest goes through"
        } else {
            "total reflection: everything comes back"
        };
        let step = self.step(Line::ShadeFresnel, place).works(arithmetic).finds(true, words).shows(spot.picture);
        step.sets("R", Variable::Number(r));
    }

    /// The number whose sign decides total reflection under certified numerics, as the tracer rounds it.
    fn transmission(&self, spot: &Spot<'_>) -> Option<f64> {
        let [n_i, n_t] = spot.hit.ior?;
        let (d, n) = (spot.node.direction, spot.normal);
        let is_fine = d.iter().chain(&n).chain(&[n_i, n_t]).all(|x| is_in_range(*x));
        is_fine.then(|| refraction_sign::<f64>(d.into(), n.into(), n_i, n_t))
    }

    /// One of the two children: its direction, its share, and what it brings back.
    fn child(&mut self, spot: &Spot<'a>, child: &'a RayNode) -> [f64; 3] {
        let at = self.place(child);
        let is_reflected = child.kind == Kind::Reflected;
        let lines = match is_reflected {
            true => [
                Line::Reflected,
                Line::ReflectedWay,
                Line::ReflectedShare,
                Line::ReflectedLevel,
                Line::ReflectedTrace,
                Line::ReflectedReturn,
            ],
            false => [
                Line::Refracted,
                Line::RefractedWay,
                Line::RefractedShare,
                Line::RefractedLevel,
                Line::RefractedTrace,
                Line::RefractedReturn,
            ],
        };
        let [header, way, share, level, trace, last] = lines;
        let procedure = if is_reflected { Procedure::Reflected } else { Procedure::Refracted };
        let step = self.step(header, at).calls(procedure).shows_of(spot.picture, spot.place);
        step.sets("level", Variable::Integer(u64::from(spot.node.depth)));

        let (arithmetic, words) = self.way_of_child(spot, child, at);
        let step = self.step(way, at).works(arithmetic).finds(true, words).shows_of(spot.picture, spot.place);
        step.sets(if is_reflected { "r" } else { "t" }, Variable::Vector(child.direction));

        let (arithmetic, value, words) = self.share_of_child(spot, child, at);
        let step = self.step(share, at).works(arithmetic).finds(true, words).shows_of(spot.picture, spot.place);
        step.sets("share", Variable::Vector(value));
        if let Some(weight) = child.weight {
            step.sets("weight", Variable::Vector(weight));
        }

        let max_depth = self.tree.settings.and_then(|settings| settings.max_depth);
        let of_max = max_depth.map_or(String::new(), |max| format!(" {max}"));
        let words = match child.outcome {
            Outcome::MaxDepth => format!("level {} = maxLevel: the ray is not traced", spot.node.depth),
            Outcome::BelowMinWeight => "its weight is below min_weight: the ray is not traced".to_owned(),
            Outcome::RayBudget => "the rays of this pixel are spent: the ray is not traced".to_owned(),
            _ => format!("level {} < maxLevel{of_max}: the ray is traced", spot.node.depth),
        };
        let is_traced = child.outcome.is_traced();
        let question = Question::yes_or_no("Is this ray traced?", is_traced);
        let step = self.step(level, at).finds(is_traced, words).asks(question).shows_of("tree", spot.place);
        if !is_traced {
            step.sets("returned", Variable::Vector([0.0; 3])).returning();
            return product(value, [0.0; 3]);
        }
        self.step(trace, at).shows("section");
        self.trace(child);
        let color = child.radiance.unwrap_or_default();
        let inputs = vec![("share", Vector(value)), ("color", Vector(color))];
        let arithmetic = self.work(at, Formula::Returned, inputs, None, &[]);
        let returned = product(value, color);
        let step = self.step(last, at).works(arithmetic).sets("color", Variable::Vector(color));
        step.sets("returned", Variable::Vector(returned)).returning().shows("section");
        returned
    }

    fn way_of_child(&mut self, spot: &Spot<'_>, child: &RayNode, at: usize) -> (Option<Arithmetic>, &'static str) {
        let mut inputs = vec![("d", Vector(spot.node.direction)), ("n", Vector(spot.normal))];
        let wanted = |name| [(name, Vector(child.direction))];
        if child.kind == Kind::Reflected {
            return (self.work_way(at, Formula::Reflect, &inputs, &wanted("r")), "mirrored at the normal");
        }
        let Some([n_i, n_t]) = spot.hit.ior else { return (None, "through the surface") };
        inputs.extend([("n_i", Number(n_i)), ("n_t", Number(n_t))]);
        if self.book.setting.numerics != Numerics::Certified {
            return (self.work_way(at, Formula::SnellUsual, &inputs, &wanted("t")), "bent by Snell's law");
        }
        if child.direction == spot.node.direction {
            let words = "straight on: the indices are equal, or the ray runs along the normal";
            return (None, words);
        }
        let Some(s) = self.transmission(spot) else { return (None, "bent by Snell's law") };
        inputs.push(("S", Number(s)));
        (self.work_way(at, Formula::SnellStable, &inputs, &wanted("t")), "bent by Snell's law")
    }

    /// The share of a child, and the arithmetic of it and of the weight.
    fn share_of_child(
        &mut self,
        spot: &Spot<'_>,
        child: &RayNode,
        at: usize,
    ) -> (Option<Arithmetic>, [f64; 3], &'static str) {
        let Material { reflection, transmission, fresnel, .. } = spot.material;
        let through = transmission.unwrap_or_default();
        let weight = spot.node.weight.unwrap_or([1.0; 3]);
        let r = spot.node.fresnel;
        let (split, mut inputs, words) = match (child.kind, spot.node.total_reflection, r) {
            (Kind::Reflected, true, _) if fresnel.is_some() => {
                let k = reflection.unwrap_or(through);
                (Split::Whole, vec![("k", vector(k))], "total reflection: the whole weight")
            }
            (Kind::Reflected, true, _) => {
                let inputs = vec![("k_r", vector(reflection.unwrap_or_default())), ("k_t", vector(through))];
                (Split::Both, inputs, "total reflection: both weights")
            }
            (Kind::Reflected, false, Some(r)) => {
                let inputs = vec![("k", vector(reflection.unwrap_or_default())), ("R", Number(r))];
                (Split::Reflected, inputs, "of the light that comes back")
            }
            (Kind::Reflected, false, None) => {
                (Split::Whole, vec![("k", vector(reflection.unwrap_or_default()))], "the material's weight")
            }
            (_, _, Some(r)) => {
                (Split::Transmitted, vec![("k", vector(through)), ("R", Number(r))], "of the light that goes through")
            }
            (_, _, None) => (Split::Whole, vec![("k", vector(through))], "the material's weight"),
        };
        inputs.push(("w", Vector(weight)));
        let wanted: Vec<(&str, Value)> = child.weight.iter().map(|weight| ("weight", Vector(*weight))).collect();
        let arithmetic = self.work(at, Formula::Share(split), inputs, None, &wanted);
        let share = arithmetic.as_ref().and_then(|arithmetic| super::value_of(&arithmetic.values, "share"));
        let value = match (share, child.weight) {
            (Some(Vector(share)), _) => share,
            // A tree that says otherwise than the scene: what its weights say.
            (_, Some(of_child)) => std::array::from_fn(|k| if weight[k] > 0.0 { of_child[k] / weight[k] } else { 0.0 }),
            _ => [0.0; 3],
        };
        (arithmetic, value, words)
    }
}

fn hit_variable(hit: &HitRecord) -> Variable {
    Variable::Hit { t: hit.t, object: hit.object.clone(), shape: hit.shape, primitive: hit.primitive }
}

/// Which ray comes next?
fn next_ray(kind: Option<Kind>) -> Question {
    let answer = match kind {
        Some(Kind::Reflected) => 0,
        Some(_) => 1,
        None => 2,
    };
    Question::between("Which ray comes next?", ["the reflected one", "the refracted one", "none"], answer)
}

/// What may be asked before a test is shown.
fn question(test: &TestRecord) -> Option<Question> {
    match test {
        // One question a box of the scene; those inside a mesh are too many.
        TestRecord::Bounds(test) => {
            let object = test.object.as_ref().filter(|_| !test.in_mesh)?;
            let is_entered = test.verdict != Verdict::Rejected;
            Some(Question::yes_or_no(format!("Does the ray enter the box around {object}?"), is_entered))
        }
        TestRecord::Shape(test) if test.values.0.is_empty() => None,
        TestRecord::Shape(test) => {
            let has = |name: &str| test.values.0.iter().any(|(key, _)| key == name);
            if has("disc") {
                let is_negative = test.reason.as_deref() == Some("discriminant negative");
                return Some(Question::yes_or_no("Is the discriminant negative?", is_negative));
            }
            let is_best = test.verdict == Verdict::Best;
            let object = test.object.as_deref().unwrap_or("it");
            Some(match test.primitive {
                Some(primitive) => {
                    Question::yes_or_no(format!("Is triangle {primitive} the nearest hit so far?"), is_best)
                }
                None => Question::yes_or_no(format!("Is {object} the nearest hit so far?"), is_best),
            })
        }
    }
}
