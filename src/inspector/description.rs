//! A scene as the page gets it: SCENE in the words of `routes.rs`.

use glam::DVec3;
use serde::Serialize;

use super::scenes::Held;
use crate::numbers::Precision;
use crate::scene::effects::census;
use crate::scene::{Camera, LightKind, Numerics, Resolution, Scene, Shape};

/// A scene with what a page has to know of it. Lengths and places in world space.
#[derive(Debug, Serialize)]
pub(super) struct Description<'a> {
    id: &'a str,
    file: &'a str,
    text: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    about: Option<&'a str>,
    image: Size,
    pixels: Vec<Pixel<'a>>,
    settings: Effective,
    camera: View,
    lights: Vec<Light<'a>>,
    objects: Vec<Object<'a>>,
    effects: Vec<&'static str>,
}

#[derive(Debug, Serialize)]
struct Size {
    width: u32,
    height: u32,
}

#[derive(Debug, Serialize)]
struct Pixel<'a> {
    name: &'a str,
    x: u32,
    y: u32,
}

/// What it is traced with, whoever said so.
#[derive(Debug, Serialize)]
struct Effective {
    precision: Precision,
    numerics: Numerics,
    max_depth: u32,
}

#[derive(Debug, Serialize)]
struct View {
    eye: [f64; 3],
    right: [f64; 3],
    up: [f64; 3],
    forward: [f64; 3],
    /// Of the image plane at distance 1: top left, top right, bottom right, bottom left.
    corners: [[f64; 3]; 4],
}

#[derive(Debug, Serialize)]
struct Light<'a> {
    name: &'a str,
    color: [f64; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<[f64; 3]>,
    /// The way the light of a directional one travels.
    #[serde(skip_serializing_if = "Option::is_none")]
    direction: Option<[f64; 3]>,
}

#[derive(Debug, Serialize)]
struct Object<'a> {
    name: &'a str,
    material: &'a str,
    shape: ShapeOf,
}

#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum ShapeOf {
    Sphere { center: [f64; 3], radius: f64 },
    Plane { normal: [f64; 3], distance: f64 },
    Box { min: [f64; 3], max: [f64; 3] },
    Triangle { vertices: [[f64; 3]; 3] },
    Mesh { triangles: usize, min: [f64; 3], max: [f64; 3], closed: bool },
}

impl<'a> Description<'a> {
    /// Of a scene.
    pub(super) fn of(held: &'a Held) -> Self {
        let scene = &held.loaded.scene;
        let options = held.options;
        let pixels = scene.pixels.iter().map(|(name, [x, y])| Pixel { name, x: *x, y: *y });
        let lights = scene.lights.iter().map(|light| {
            let (position, direction) = match light.kind {
                LightKind::Point { position } => (Some(position.to_array()), None),
                LightKind::Directional { direction } => (None, Some(direction.to_array())),
            };
            Light { name: &light.name, color: light.color.to_array(), position, direction }
        });
        Self {
            id: &held.id,
            file: &held.loaded.file,
            text: &held.text,
            about: scene.about.as_deref(),
            image: Size { width: scene.image.width, height: scene.image.height },
            pixels: pixels.collect(),
            settings: Effective {
                precision: held.world.precision(),
                numerics: options.numerics,
                max_depth: options.limits.max_depth,
            },
            camera: view(&scene.camera, scene.image),
            lights: lights.collect(),
            objects: objects(scene),
            effects: census(scene).into_iter().map(|(effect, _)| effect.name()).collect(),
        }
    }
}

fn view(camera: &Camera, image: Resolution) -> View {
    let Camera { eye, right, up, forward, half_height } = *camera;
    let half_width = half_height * f64::from(image.width) / f64::from(image.height);
    let corner = |x: f64, y: f64| (eye + forward + right * (x * half_width) + up * (y * half_height)).to_array();
    View {
        eye: eye.to_array(),
        right: right.to_array(),
        up: up.to_array(),
        forward: forward.to_array(),
        corners: [corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)],
    }
}

fn objects(scene: &Scene) -> Vec<Object<'_>> {
    let shape = |shape: &Shape| match shape {
        Shape::Sphere { center, radius } => ShapeOf::Sphere { center: center.to_array(), radius: *radius },
        Shape::Plane { normal, distance } => ShapeOf::Plane { normal: normal.to_array(), distance: *distance },
        Shape::Box { min, max } => ShapeOf::Box { min: min.to_array(), max: max.to_array() },
        Shape::Triangle { vertices } => ShapeOf::Triangle { vertices: vertices.map(|v| v.to_array()) },
        Shape::Mesh(mesh) => {
            let corners = || mesh.triangles.iter().flatten().copied();
            let first = corners().next().unwrap_or(DVec3::ZERO);
            ShapeOf::Mesh {
                triangles: mesh.triangles.len(),
                min: corners().fold(first, DVec3::min).to_array(),
                max: corners().fold(first, DVec3::max).to_array(),
                closed: mesh.closed,
            }
        }
    };
    let objects = scene.object_ids().zip(&scene.objects).map(|(id, object)| Object {
        name: &object.name,
        material: &scene.material_of(id).name,
        shape: shape(&object.shape),
    });
    objects.collect()
}
