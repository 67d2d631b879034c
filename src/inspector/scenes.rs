//! The scenes that a page works with: the one that was given, and those it made of it.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};

use sha2::{Digest, Sha256};

use super::ahead::Ahead;
use super::tracing::AnyWorld;
use super::work::Work;
use crate::hits::Acceleration;
use crate::input::{JsonPath, Located, Problem};
use crate::numbers::Precision;
use crate::scene::{self, Limits, Loaded, Numerics, Shape};
use crate::transport::{LeavingPolicy, Options};
use crate::tree::RayTree;

/// How to trace, where it is not the scene that says so.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// Of the geometry.
    pub precision: Option<Precision>,
    /// The kernels.
    pub numerics: Option<Numerics>,
    /// The depth of the recursion.
    pub max_depth: Option<u32>,
    /// What keeps a ray from hitting the surface it starts on.
    pub leaving: Option<LeavingPolicy>,
    /// How hits are found.
    pub acceleration: Acceleration,
}

/// Scenes that are held at a time, besides the one that was given.
const MOST_SCENES: usize = 32;
/// Triangles that they have together at most, unless one alone has more.
const MOST_TRIANGLES: usize = 1 << 20;
/// Trees that are held at a time.
const MOST_TREES: usize = 8;
/// Bytes of meshes that a scene may name beyond those of the scene that was given.
const MORE_MESHES: usize = 1 << 24;
/// Pixels of a picture at most, and of one side of it.
const MOST_PIXELS: u64 = 1 << 24;
const LONGEST_SIDE: u32 = 1 << 14;

/// A scene, the variants of it that a page tried out, and the work that goes on for them.
#[derive(Debug)]
pub struct Inspector {
    first: Arc<Held>,
    settings: Settings,
    /// The bytes of the meshes that the scene named, and no others.
    meshes: BTreeMap<String, Vec<u8>>,
    /// Bytes of meshes that the scene took, those it names twice counted twice.
    mesh_bytes: usize,
    /// The last used at the end.
    held: Mutex<Vec<Arc<Held>>>,
    trees: Mutex<Vec<Arc<HeldTree>>>,
    work: Work,
    ahead: Ahead,
}

/// A scene ready to be traced.
#[derive(Debug)]
pub(super) struct Held {
    /// Hash of all that it was made of.
    pub(super) id: String,
    pub(super) text: String,
    pub(super) loaded: Loaded,
    pub(super) world: AnyWorld,
    pub(super) options: Options,
}

/// A tree that may be asked for again.
#[derive(Debug)]
pub(super) struct HeldTree {
    pub(super) scene: String,
    pub(super) pixel: [u32; 2],
    pub(super) tree: RayTree,
}

impl Inspector {
    /// The inspector of the scene in `text`, called `file`. `read_mesh` gives the bytes of its meshes; later scenes have
    /// those alone.
    ///
    /// # Errors
    /// One [`Problem`]: what [`scene::load`] refuses, a scene that does not fit the precision, a picture too large to be
    /// shown: more than 2^24 pixels, or 2^14 along a side.
    pub fn new(
        file: &str,
        text: &str,
        settings: Settings,
        read_mesh: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Self, Problem> {
        let mut meshes = BTreeMap::new();
        let mut mesh_bytes = 0;
        let first = Held::new(file, text.to_owned(), settings, &mut |name| {
            let bytes = match meshes.get(name) {
                Some(bytes) => Vec::clone(bytes),
                None => meshes.entry(name.to_owned()).or_insert(read_mesh(name)?).clone(),
            };
            mesh_bytes += bytes.len();
            Ok(bytes)
        })?;
        Ok(Self {
            first: Arc::new(first),
            settings,
            meshes,
            mesh_bytes,
            held: Mutex::default(),
            trees: Mutex::default(),
            work: Work::default(),
            ahead: Ahead::default(),
        })
    }

    /// Traces the picture of the scene that was given, until it is done or `stop` is set; pages that ask for it meanwhile, or
    /// later, get what is there.
    pub fn paint(&self, stop: &AtomicBool) {
        self.ahead.paint(&self.first, stop);
    }

    /// What there is of a scene's picture, of the one that was given.
    pub(super) fn ahead_of(&self, held: &Arc<Held>) -> Option<&Ahead> {
        Arc::ptr_eq(held, &self.first).then_some(&self.ahead)
    }

    /// How many pieces of work go on for clients.
    pub fn running(&self) -> usize {
        self.work.running()
    }

    pub(super) fn work(&self) -> &Work {
        &self.work
    }

    /// The scene that was given.
    pub(super) fn first(&self) -> &Arc<Held> {
        &self.first
    }

    /// The settings that were given.
    pub(super) fn settings(&self) -> Settings {
        self.settings
    }

    /// The scene with that id, if it is still held.
    pub(super) fn find(&self, id: &str) -> Option<Arc<Held>> {
        if self.first.id == id {
            return Some(Arc::clone(&self.first));
        }
        let mut held = self.held.lock().unwrap_or_else(PoisonError::into_inner);
        let place = held.iter().position(|scene| scene.id == id)?;
        let scene = held.remove(place);
        held.push(Arc::clone(&scene));
        Some(scene)
    }

    /// The scene that a text holds, held from now on.
    ///
    /// # Errors
    /// As [`Inspector::new`] has them, and for meshes that the given scene did not name.
    pub(super) fn add(&self, text: String, settings: Settings) -> Result<Arc<Held>, Problem> {
        let id = id_of(&text, settings);
        if let Some(scene) = self.find(&id) {
            return Ok(scene);
        }
        let mut left = self.mesh_bytes + MORE_MESHES;
        let scene = Held::new(&self.first.loaded.file, text, settings, &mut |name| {
            let bytes = self.meshes.get(name).ok_or("the page has only the meshes that the scene named at first")?;
            left = left.checked_sub(bytes.len()).ok_or("the scene has more of meshes than the page takes")?;
            Ok(bytes.clone())
        })?;
        let scene = Arc::new(scene);
        let mut held = self.held.lock().unwrap_or_else(PoisonError::into_inner);
        held.retain(|other| other.id != scene.id);
        held.push(Arc::clone(&scene));
        let triangles = |held: &[Arc<Held>]| held.iter().map(|scene| scene.triangles()).sum::<usize>();
        while held.len() > MOST_SCENES || held.len() > 1 && triangles(&held) > MOST_TRIANGLES {
            held.remove(0);
        }
        Ok(scene)
    }

    /// The tree of a pixel, if it is still held.
    pub(super) fn find_tree(&self, scene: &str, pixel: [u32; 2]) -> Option<Arc<HeldTree>> {
        let mut trees = self.trees.lock().unwrap_or_else(PoisonError::into_inner);
        let place = trees.iter().position(|tree| tree.scene == scene && tree.pixel == pixel)?;
        let tree = trees.remove(place);
        trees.push(Arc::clone(&tree));
        Some(tree)
    }

    /// Holds a tree.
    pub(super) fn add_tree(&self, tree: &Arc<HeldTree>) {
        let mut trees = self.trees.lock().unwrap_or_else(PoisonError::into_inner);
        trees.push(Arc::clone(tree));
        if trees.len() > MOST_TREES {
            trees.remove(0);
        }
    }
}

impl Held {
    fn new(
        file: &str,
        text: String,
        settings: Settings,
        read_mesh: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Self, Problem> {
        let loaded = scene::load(file, &text, read_mesh)?;
        let image = loaded.scene.image;
        let pixels = u64::from(image.width) * u64::from(image.height);
        if pixels > MOST_PIXELS || image.width.max(image.height) > LONGEST_SIDE {
            let message = format!("a picture of {} x {} is too large to be inspected", image.width, image.height);
            let help = format!("at most {MOST_PIXELS} pixels, and {LONGEST_SIDE} along a side");
            return Err(Located { file, text: &text }.problem(&JsonPath::default().child("image"), message, help));
        }
        let mut options = Options::of(&loaded.scene);
        options.numerics = settings.numerics.unwrap_or(options.numerics);
        options.leaving = settings.leaving;
        options.acceleration = settings.acceleration;
        options.limits.max_depth = settings.max_depth.unwrap_or(options.limits.max_depth).min(Limits::DEEPEST);
        let precision = settings.precision.or(loaded.scene.precision).unwrap_or(Precision::F64);
        let world = AnyWorld::new(&loaded, precision, options)?;
        Ok(Self { id: id_of(&text, settings), text, loaded, world, options })
    }

    fn triangles(&self) -> usize {
        let of = |shape: &Shape| if let Shape::Mesh(mesh) = shape { mesh.triangles.len() } else { 1 };
        self.loaded.scene.objects.iter().map(|object| of(&object.shape)).sum()
    }
}

/// What a scene is known by: the hash of its text and of what can be set from outside.
fn id_of(text: &str, settings: Settings) -> String {
    let mut hash = Sha256::new();
    let Settings { precision, numerics, max_depth, .. } = settings;
    hash.update(format!("{precision:?} {numerics:?} {max_depth:?}\n"));
    hash.update(text);
    hash.finalize().iter().take(16).map(|byte| format!("{byte:02x}")).collect()
}
