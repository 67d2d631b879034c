//! Lesson 06, the camera: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::{DVec2, DVec3, dvec2};
use raytree::lessons::{Camera, Lesson, Ray};

#[path = "../../../lessons/06-camera/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/06-camera/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/06-camera/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(half_height, on_image, image_point, compute_ray);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "half-degrees-as-radians": half_height = |fov| (0.5 * fov).tan(),
        "half-of-tangent": half_height = |fov| fov.to_radians().tan() / 2.0,
        "image-rows-flipped": on_image = |x, y, width, height| {
            let share = |x: u32, of: u32| (2.0 * f64::from(x) + 1.0) / f64::from(of) - 1.0;
            dvec2(share(x, width), share(y, height))
        },
        "image-corner-across": on_image = |x, y, width, height| {
            let (u, v) = (f64::from(x) / f64::from(width), (f64::from(y) + 0.5) / f64::from(height));
            dvec2(2.0 * u - 1.0, 1.0 - 2.0 * v)
        },
        "image-corner-down": on_image = |x, y, width, height| {
            let (u, v) = ((f64::from(x) + 0.5) / f64::from(width), f64::from(y) / f64::from(height));
            dvec2(2.0 * u - 1.0, 1.0 - 2.0 * v)
        },
        "plane-aspect-whole": image_point = |camera, at| {
            let h = solution::half_height(camera.fov_y_degrees);
            let w = h * f64::from(camera.width / camera.height);
            camera.eye + camera.forward + at.x * w * camera.right + at.y * h * camera.up
        },
        "plane-aspect-inverted": image_point = |camera, at| {
            let h = solution::half_height(camera.fov_y_degrees);
            let w = h / f64::from(camera.width) * f64::from(camera.height);
            camera.eye + camera.forward + at.x * w * camera.right + at.y * h * camera.up
        },
        "camera-rows-flipped": compute_ray = |camera, x, y| {
            solution::compute_ray(camera, x, camera.height - 1 - y)
        },
        "camera-aspect-ignored": compute_ray = |camera, x, y| {
            let at = solution::on_image(x, y, camera.width, camera.height);
            let h = solution::half_height(camera.fov_y_degrees);
            let way = camera.forward + at.x * h * camera.right + at.y * h * camera.up;
            Ray { origin: camera.eye, direction: way / way.length() }
        },
        "camera-fov-halved-twice": compute_ray = |camera, x, y| {
            let fov_y_degrees = camera.fov_y_degrees / 2.0;
            solution::compute_ray(&Camera { fov_y_degrees, ..*camera }, x, y)
        },
        "camera-degrees-as-radians": compute_ray = |camera, x, y| {
            let fov_y_degrees = camera.fov_y_degrees.to_degrees();
            solution::compute_ray(&Camera { fov_y_degrees, ..*camera }, x, y)
        },
        "camera-pixel-corner": compute_ray = |camera, x, y| {
            let share = |x: u32, of: u32| f64::from(x) / f64::from(of);
            let at = dvec2(2.0 * share(x, camera.width) - 1.0, 1.0 - 2.0 * share(y, camera.height));
            let way = solution::image_point(camera, at) - camera.eye;
            Ray { origin: camera.eye, direction: way.normalize() }
        },
        "camera-direction-not-unit": compute_ray = |camera, x, y| {
            let at = solution::on_image(x, y, camera.width, camera.height);
            Ray { origin: camera.eye, direction: solution::image_point(camera, at) - camera.eye }
        },
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(number: f64, vector: DVec3) -> Lesson {
    NUMBER.set(number);
    VECTOR.set(vector);
    check::lesson(check::Student {
        half_height: |_| NUMBER.get(),
        on_image: |_, _, _, _| DVec2::splat(NUMBER.get()),
        image_point: |_, _| VECTOR.get(),
        compute_ray: |_, _, _| Ray { origin: VECTOR.get(), direction: VECTOR.get() },
    })
}

thread_local! {
    static NUMBER: Cell<f64> = const { Cell::new(0.0) };
    static VECTOR: Cell<DVec3> = const { Cell::new(DVec3::ZERO) };
}
