//! Lesson 06: the camera. Read README.md beside this file, write the four functions, and run
//!
//!     cargo run --example lesson-06
#![allow(unused_variables, reason = "until the functions are written")]

mod check;

use glam::{DVec2, DVec3};
use raytree::lessons::{Camera, Ray};

/// Half the height of the image plane at distance 1 from the eye, for a field of view from its lower to its upper edge.
pub fn half_height(fov_y_degrees: f64) -> f64 {
    todo!()
}

/// The middle of pixel (x, y) on the image: x from -1 at the left edge to 1 at the right edge, y from -1 at the lower edge to 1
/// at the upper edge. Pixel (0, 0) is at the top left.
pub fn on_image(x: u32, y: u32, width: u32, height: u32) -> DVec2 {
    todo!()
}

/// The same place in the world: on the image plane at distance 1 from the eye.
pub fn image_point(camera: &Camera, on_image: DVec2) -> DVec3 {
    todo!()
}

/// The ray from the eye through the middle of pixel (x, y); its direction has length 1.
pub fn compute_ray(camera: &Camera, x: u32, y: u32) -> Ray {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { half_height, on_image, image_point, compute_ray })
}
