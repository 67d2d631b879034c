//! Lesson 06: the camera. A solution.

mod check;

use glam::{DVec2, DVec3, dvec2};
use raytree::lessons::{Camera, Ray};

/// Half the height of the image plane at distance 1 from the eye, for a field of view from its lower to its upper edge.
pub fn half_height(fov_y_degrees: f64) -> f64 {
    (fov_y_degrees.to_radians() / 2.0).tan()
}

/// The middle of pixel (x, y) on the image: x from -1 at the left edge to 1 at the right edge, y from -1 at the lower edge to 1
/// at the upper edge. Pixel (0, 0) is at the top left.
pub fn on_image(x: u32, y: u32, width: u32, height: u32) -> DVec2 {
    let across = (f64::from(x) + 0.5) / f64::from(width);
    let down = (f64::from(y) + 0.5) / f64::from(height);
    dvec2(2.0 * across - 1.0, 1.0 - 2.0 * down)
}

/// The same place in the world: on the image plane at distance 1 from the eye.
pub fn image_point(camera: &Camera, on_image: DVec2) -> DVec3 {
    let half_height = half_height(camera.fov_y_degrees);
    let half_width = half_height * f64::from(camera.width) / f64::from(camera.height);
    camera.eye + camera.forward + on_image.x * half_width * camera.right + on_image.y * half_height * camera.up
}

/// The ray from the eye through the middle of pixel (x, y); its direction has length 1.
pub fn compute_ray(camera: &Camera, x: u32, y: u32) -> Ray {
    let point = image_point(camera, on_image(x, y, camera.width, camera.height));
    Ray { origin: camera.eye, direction: (point - camera.eye).normalize() }
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { half_height, on_image, image_point, compute_ray })
}
