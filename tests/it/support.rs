//! What several subjects need: the committed scenes, and scenes made of text.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use raytree::hits::Acceleration;
use raytree::numbers::Real;
use raytree::pictures::{Film, render};
use raytree::scene::{self, Loaded, Numerics, Scene};
use raytree::transport::{Options, Tracer};
use raytree::tree::{Keep, Origin, RayTree, record_pixel};

/// The paths of all committed scenes, sorted; relative to the package, where tests run.
pub(crate) fn scene_files() -> Vec<String> {
    let mut files = Vec::new();
    let mut open = vec![PathBuf::from("scenes")];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "json") && !path.to_string_lossy().ends_with(".schema.json")
            {
                files.push(path.to_string_lossy().into_owned());
            }
        }
    }
    files.sort();
    assert!(files.len() >= 12, "too few scenes: {files:?}");
    files
}

/// All committed scenes with a short name each, such as `hard/shared-edge`.
pub(crate) fn scenes() -> Vec<(String, Loaded)> {
    let name = |file: &str| Path::new(file).strip_prefix("scenes").unwrap().with_extension("").display().to_string();
    scene_files().iter().map(|file| (name(file), scene::load_file(file).unwrap())).collect()
}

/// A scene from its text, without meshes.
pub(crate) fn scene(text: &str) -> Loaded {
    scene::load("test.json", text, &mut |_| Err("no meshes here".into())).unwrap_or_else(|problem| panic!("{problem}"))
}

/// A scene of 4 x 3 pixels from its objects, materials and further keys.
pub(crate) fn small_scene(materials: &str, objects: &str, more: &str) -> Loaded {
    scene(&format!(
        r#"{{
            "image": {{ "width": 4, "height": 3 }},
            "camera": {{ "eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov_y_degrees": 60 }},
            "materials": {{ {materials} }},
            "objects": [ {objects} ]
            {more}
        }}"#
    ))
}

/// Two mirrors of material `m`, z = 1 and z = -1, that face each other.
pub(crate) const FACING_MIRRORS: &str = r#"
    { "material": "m", "shape": { "plane": { "normal": [0, 0, 1], "distance": -1 } } },
    { "material": "m", "shape": { "plane": { "normal": [0, 0, -1], "distance": -1 } } }"#;

/// The scene with an image of at most about `n` x `n` pixels.
pub(crate) fn smaller(mut loaded: Loaded, n: u32) -> Loaded {
    let image = &mut loaded.scene.image;
    let factor = image.width.max(image.height).div_ceil(n);
    (image.width, image.height) = (image.width.div_ceil(factor), image.height.div_ceil(factor));
    loaded
}

/// A picture traced on that many threads.
pub(crate) fn picture<R: Real>(tracer: &Tracer<'_, R>, threads: usize) -> Film {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| render(tracer, &|| {}, &AtomicBool::new(false)).unwrap())
}

/// The bits of its pixels.
pub(crate) fn bits(film: &Film) -> Vec<[u64; 3]> {
    film.pixels.iter().map(|rgb| rgb.to_array().map(f64::to_bits)).collect()
}

/// A tracer as the scene wants it.
pub(crate) fn tracer<R: Real>(scene: &Scene) -> Tracer<'_, R> {
    Tracer::new(scene, Options::of(scene)).unwrap()
}

/// A tracer with other kernels or another way to find hits.
pub(crate) fn tracer_with<R: Real>(scene: &Scene, numerics: Numerics, acceleration: Acceleration) -> Tracer<'_, R> {
    Tracer::new(scene, Options { numerics, acceleration, ..Options::of(scene) }).unwrap()
}

/// The tree of a pixel.
pub(crate) fn tree<R: Real>(tracer: &Tracer<'_, R>, loaded: &Loaded, [x, y]: [u32; 2], keep: Keep) -> RayTree {
    record_pixel(tracer, Origin { loaded, keep }, x, y)
}

/// The tree of a ray in f64.
pub(crate) fn ray_tree(loaded: &Loaded, origin: [f64; 3], direction: [f64; 3]) -> RayTree {
    let ray = raytree::kernels::Ray { origin: origin.into(), direction: direction.into() };
    let origin = Origin { loaded, keep: Keep::Outcomes };
    raytree::tree::record_ray(&tracer::<f64>(&loaded.scene), origin, &ray).unwrap()
}

/// A grid of about `n` pixels over a scene's image.
pub(crate) fn grid(scene: &Scene, n: u32) -> Vec<[u32; 2]> {
    let (width, height) = (scene.image.width, scene.image.height);
    let step = f64::from(width * height / n.min(width * height)).sqrt().max(1.0) as usize;
    let rows = (step as u32 / 2..height).step_by(step);
    rows.flat_map(|y| (step as u32 / 2..width).step_by(step).map(move |x| [x, y])).collect()
}
