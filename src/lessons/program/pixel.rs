//! The cases of lessons that trace: pixels of scenes.

use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::{Camera, Procedures, Program};
use crate::faults::{Fault, Textbook};
use crate::hits::World;
use crate::lessons::{Answer, Case};
use crate::pictures::{Film, render};
use crate::scene::{self, Loaded, Resolution, Scene};
use crate::transport::{Options, Tracer, spawn};
use crate::tree::{Keep, Origin, RayNode, RayTree, record_ray};

/// A pixel of a scene.
#[derive(Clone, Debug)]
pub struct Pixel {
    place: Rc<Place>,
    x: u32,
    y: u32,
    name: Option<String>,
}

/// A scene with its geometry.
#[derive(Debug)]
struct Place {
    loaded: Loaded,
    world: Arc<World<f64>>,
}

/// The pixels of a scene that a lesson looks at: those with a name, then `8 x 6` in even steps. `text` is what the file holds,
/// without meshes.
///
/// # Panics
/// If it is no scene: lessons come with theirs.
pub fn pixels(file: &str, text: &str) -> Vec<Case<Pixel>> {
    let no_mesh = &mut |_: &str| Err("lessons have no meshes".to_owned());
    let loaded = scene::load(file, text, no_mesh).unwrap_or_else(|problem| panic!("{problem}"));
    let tracer = Tracer::new(&loaded.scene, Options::of(&loaded.scene)).unwrap_or_else(|unfit| panic!("{unfit:?}"));
    let world = tracer.shared_world();
    let (Resolution { width, height }, named) = (loaded.scene.image, loaded.scene.pixels.clone());
    let place = Rc::new(Place { loaded, world });
    let of = |[x, y]: [u32; 2], name: Option<String>| Pixel { place: Rc::clone(&place), x, y, name };
    let called = named.into_iter().map(|(name, at)| {
        let pixel = of(at, Some(name.clone()));
        Case::new(&format!("{file}, \"{name}\""), pixel)
    });
    let step = |i: u32, of: u32, size: u32| (2 * i + 1) * size / (2 * of);
    let even = (0..48).map(|i| {
        let at = [step(i % 8, 8, width), step(i / 8, 6, height)];
        Case::new(&format!("{file}, pixel {},{}", at[0], at[1]), of(at, None))
    });
    called.chain(even).collect()
}

impl Pixel {
    /// What is given: the scene, the pixel, and how to see it step by step.
    pub fn given(&self) -> Vec<String> {
        let (file, Pixel { x, y, .. }) = (&self.place.loaded.file, self);
        let step = |pixel: &str| format!("step by step: raytree step {file} {pixel}");
        match &self.name {
            Some(name) => vec![format!("scene {file}, pixel {x},{y}"), step(&format!("\"{name}\""))],
            // The case is called so.
            None => vec![step(&format!("{x},{y}"))],
        }
    }

    /// The tree that a program with these procedures makes.
    pub fn answer(&self, procedures: Procedures) -> Answer {
        let tracer = self.place.tracer();
        let ray = (procedures.compute_ray)(&self.place.camera(), self.x, self.y);
        self.tree(Program::new(&tracer, procedures).run(&ray))
    }

    /// The right tree: that of the real tracer.
    pub fn truth(&self) -> Answer {
        let tracer = self.place.tracer();
        let ray = self.scene().camera.ray(self.scene().image, self.x, self.y);
        let ray = spawn(ray.origin, ray.direction);
        let origin = Origin { loaded: &self.place.loaded, keep: Keep::Outcomes };
        match record_ray(&tracer, origin, &ray) {
            Ok(tree) => self.tree(tree.root),
            Err(_) => Answer::Nothing("no ray"),
        }
    }

    /// The tree of a textbook tracer with a classic fault.
    pub fn with_fault(&self, fault: Fault) -> Answer {
        self.tree(Textbook::new(self.scene()).with(fault).pixel(self.x, self.y).root)
    }

    /// The same scene in a picture of this width: the right picture, its pixels in rows from the top, and this pixel in it.
    pub(in crate::lessons) fn picture(&self, width: u32) -> (Film, Vec<Pixel>, [u32; 2]) {
        let image = self.scene().image;
        let height = (width * image.height / image.width).max(1);
        let mut loaded = self.place.loaded.clone();
        loaded.scene.image = Resolution { width, height };
        let place = Rc::new(Place { loaded, world: Arc::clone(&self.place.world) });
        let right = render(&place.tracer(), &|| (), &AtomicBool::new(false));
        let empty = || Film { size: place.loaded.scene.image, pixels: Vec::new() };
        let pixel = |i: u32| Pixel { place: Rc::clone(&place), x: i % width, y: i / width, name: None };
        let own = [self.x * width / image.width, self.y * height / image.height];
        (right.unwrap_or_else(empty), (0..width * height).map(pixel).collect(), own)
    }

    /// The tree of this pixel, as far as it was traced: what a ray would have been that the recursion does not send is not told
    /// in it, nor are weights.
    fn tree(&self, mut root: RayNode) -> Answer {
        fn keep(node: &mut RayNode) {
            node.weight = None;
            node.total_reflection = false;
            for child in [&mut node.reflected, &mut node.refracted] {
                child.take_if(|child| !child.outcome.is_traced());
                child.iter_mut().for_each(|child| keep(child));
            }
        }
        keep(&mut root);
        let color = root.radiance.unwrap_or_default();
        Answer::Tree(Box::new(RayTree { pixel: Some([self.x, self.y]), ..RayTree::new(color, root) }))
    }

    fn scene(&self) -> &Scene {
        &self.place.loaded.scene
    }
}

impl Place {
    fn tracer(&self) -> Tracer<'_, f64> {
        let scene = &self.loaded.scene;
        Tracer::with_world(scene, Arc::clone(&self.world), Options::of(scene))
    }

    fn camera(&self) -> Camera {
        let scene::Camera { eye, right, up, forward, half_height } = self.loaded.scene.camera;
        let Resolution { width, height } = self.loaded.scene.image;
        let fov_y_degrees = 2.0 * libm::atan(half_height).to_degrees();
        Camera { eye, forward, right, up, fov_y_degrees, width, height }
    }
}
