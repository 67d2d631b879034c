//! Lesson 12: a scene with a mesh in a small picture, whose rays go through a student's hierarchy.

use super::hierarchy::{Build, Hierarchy, Item, Nearest};
use super::{Random, Ray, Triangle};
use crate::hits::{Acceleration, Departure, Geometry, Limit, World};
use crate::pictures::drawing::{Color, Raster};
use crate::pictures::srgb8;
use crate::scene::{Numerics, Resolution, Scene};
use crate::transport::{Options, Tracer};

/// The mesh of a scene as its camera sees it, and what the real tracer makes of it.
#[derive(Clone, Debug)]
pub struct MeshView {
    /// Columns and rows.
    pub size: [u32; 2],
    /// The mesh, mixed: their order says nothing about where the triangles are.
    pub items: Vec<Item>,
    /// The tracer's picture of the whole scene.
    pub picture: Raster,
    rays: Vec<Ray>,
    /// The t of the nearest hit of the mesh for each ray; infinite where there is none.
    truth: Vec<f64>,
}

/// What came of sending the rays of a [`MeshView`] through a hierarchy, pixel by pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// Whether the hit is the right one.
    pub right: Vec<bool>,
    /// Tests of boxes and of triangles.
    pub tests: Vec<usize>,
}

impl Rendered {
    /// Pixels with the wrong hit.
    pub fn wrong(&self) -> usize {
        self.right.iter().filter(|right| !**right).count()
    }

    /// All tests.
    pub fn total(&self) -> usize {
        self.tests.iter().sum()
    }
}

impl MeshView {
    /// The first mesh of a scene in a picture of so many pixels. `None` where it has no mesh or does not fit f64.
    pub fn new(scene: &Scene, width: u32, height: u32) -> Option<Self> {
        let scene = Scene { image: Resolution { width, height }, ..scene.clone() };
        let tracer = Tracer::<f64>::new(&scene, Options::of(&scene)).ok()?;
        let id = scene.object_ids().find(|id| matches!(tracer.world().geometry(*id), Geometry::Mesh(_)))?;
        let alone = Scene { objects: vec![scene.object(id).clone()], ..scene.clone() };
        let world = World::<f64>::new(&alone, Numerics::Certified, Acceleration::Bvh);
        let Geometry::Mesh(mesh) = tracer.world().geometry(id) else { return None };
        let pixels = || (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)));
        let rays: Vec<Ray> = pixels().map(|(x, y)| tracer.ray_of_pixel(x, y)).collect();
        let nearest = |ray: &Ray| {
            let hit = world.nearest(ray, Limit::None, Departure::default(), &mut ()).ok()?;
            Some(hit.map_or(f64::INFINITY, |hit| hit.nearest.t))
        };
        let color = |x, y| {
            let [r, g, b] = tracer.pixel_color(x, y).to_array().map(srgb8);
            Color { r, g, b, a: 255 }
        };
        Some(MeshView {
            size: [width, height],
            items: mixed(&mesh.triangles),
            picture: Raster::from_fn(width, height, color),
            truth: rays.iter().map(nearest).collect::<Option<_>>()?,
            rays,
        })
    }

    /// How many rays there are.
    pub fn rays(&self) -> usize {
        self.rays.len()
    }

    /// Sends all rays through the hierarchy that `build` makes. `None` where a recursion would never end.
    pub fn render(&self, build: Build, nearest: Nearest) -> Option<Rendered> {
        let hierarchy = Hierarchy::of(build, &self.items)?;
        let mut rendered = Rendered { right: Vec::new(), tests: Vec::new() };
        for (ray, truth) in self.rays.iter().zip(&self.truth) {
            let walked = hierarchy.walked(nearest, ray);
            if !walked.ends {
                return None;
            }
            let is_right = walked.t == *truth || (walked.t - truth).abs() <= 1e-9 * truth.abs().max(1.0);
            rendered.right.push(is_right);
            rendered.tests.push(walked.asked.len() + walked.tested.len());
        }
        Some(rendered)
    }
}

/// Triangles with their numbers in an order of chance, the same every time.
fn mixed(triangles: &[Triangle]) -> Vec<Item> {
    let numbered = triangles.iter().enumerate().map(|(number, triangle)| Item { number, triangle: *triangle });
    let mut items: Vec<Item> = numbered.collect();
    let mut random = Random::new(12);
    for i in (1..items.len()).rev() {
        items.swap(i, random.below(i + 1));
    }
    items
}
