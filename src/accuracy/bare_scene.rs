//! Scenes of nothing but shapes, for experiments with them.

use glam::DVec3;

use crate::scene::{Background, Camera, Limits, Material, MaterialId, Object, Pigment, Resolution, Rgb, Scene, Shape};

/// A scene of these shapes, all of them mirrors.
pub(super) fn bare_scene(shapes: Vec<Shape>) -> Scene {
    let mirror = Material {
        name: "mirror".to_owned(),
        pigment: Pigment::Constant(Rgb::ONE),
        ambient: None,
        diffuse: None,
        specular: None,
        reflection: Some(Rgb::ONE),
        transmission: None,
        ior: None,
        fresnel: None,
    };
    let object =
        |(i, shape): (usize, Shape)| Object { name: format!("{} {i}", shape.kind()), material: MaterialId(0), shape };
    Scene {
        about: None,
        image: Resolution { width: 1, height: 1 },
        camera: Camera { eye: DVec3::ZERO, right: DVec3::X, up: DVec3::Y, forward: -DVec3::Z, half_height: 1.0 },
        background: Background::Constant(Rgb::ZERO),
        limits: Limits::default(),
        precision: None,
        numerics: None,
        lights: Vec::new(),
        materials: vec![mirror],
        objects: shapes.into_iter().enumerate().map(object).collect(),
        pixels: Vec::new(),
    }
}
