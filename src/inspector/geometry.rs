//! The shapes of a scene for the view in three dimensions, in the order of its objects.

use std::collections::HashMap;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::DVec3;
use serde::Serialize;

use crate::scene::{Pigment, Scene, Shape};

/// All shapes.
#[derive(Debug, Serialize)]
pub(super) struct Geometry<'a> {
    objects: Vec<Part<'a>>,
}

#[derive(Debug, Serialize)]
struct Part<'a> {
    name: &'a str,
    /// Linear RGB, of a checker the first.
    color: [f64; 3],
    /// Whether light passes.
    transparent: bool,
    #[serde(flatten)]
    form: Form,
}

#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum Form {
    Sphere {
        center: [f64; 3],
        radius: f64,
    },
    Plane {
        normal: [f64; 3],
        distance: f64,
    },
    Box {
        min: [f64; 3],
        max: [f64; 3],
    },
    /// A lone triangle too. Little-endian in base64.
    Mesh {
        /// f32: x, y, z of each vertex.
        positions: String,
        /// u32: v0, v1, v2 of each triangle, in the order of the mesh.
        indices: String,
    },
}

impl<'a> Geometry<'a> {
    /// Of a scene.
    pub(super) fn of(scene: &'a Scene) -> Self {
        let part = |(id, object): (_, &'a crate::scene::Object)| {
            let material = scene.material_of(id);
            let color = match material.pigment {
                Pigment::Constant(color) => color,
                Pigment::Checker { colors, .. } => colors[0],
            };
            let form = match &object.shape {
                Shape::Sphere { center, radius } => Form::Sphere { center: center.to_array(), radius: *radius },
                Shape::Plane { normal, distance } => Form::Plane { normal: normal.to_array(), distance: *distance },
                Shape::Box { min, max } => Form::Box { min: min.to_array(), max: max.to_array() },
                Shape::Triangle { vertices } => mesh(&[*vertices]),
                Shape::Mesh(shape) => mesh(&shape.triangles),
            };
            Part { name: &object.name, color: color.to_array(), transparent: material.transmission.is_some(), form }
        };
        Self { objects: scene.object_ids().zip(&scene.objects).map(part).collect() }
    }
}

/// Triangles with the corners that they share stored once.
fn mesh(triangles: &[[DVec3; 3]]) -> Form {
    let mut places: HashMap<[u32; 3], u32> = HashMap::new();
    let (mut positions, mut indices) = (Vec::new(), Vec::new());
    for corner in triangles.iter().flatten() {
        let corner = corner.to_array().map(|x| (x as f32).clamp(f32::MIN, f32::MAX));
        let next = places.len() as u32;
        let place = *places.entry(corner.map(f32::to_bits)).or_insert_with(|| {
            positions.extend(corner.iter().flat_map(|x| x.to_le_bytes()));
            next
        });
        indices.extend(place.to_le_bytes());
    }
    Form::Mesh { positions: STANDARD.encode(positions), indices: STANDARD.encode(indices) }
}
