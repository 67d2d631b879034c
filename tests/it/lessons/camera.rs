//! Lesson 06, the camera: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::{DVec2, DVec3, dvec2};
use raytree::lessons::{Lesson, Ray};

#[path = "../../../lessons/06-camera/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/06-camera/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/06-camera/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

pub(super) fn unsolved() -> Lesson {
    check::lesson(check::Student {
        half_height: exercise::half_height,
        on_image: exercise::on_image,
        image_point: exercise::image_point,
        compute_ray: exercise::compute_ray,
    })
}

fn student() -> check::Student {
    check::Student {
        half_height: solution::half_height,
        on_image: solution::on_image,
        image_point: solution::image_point,
        compute_ray: solution::compute_ray,
    }
}

pub(super) fn solved() -> Lesson {
    check::lesson(student())
}

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    let right = student();
    let with = |id, student| (id, check::lesson(student));
    vec![
        with("half-degrees-as-radians", check::Student { half_height: |fov| (0.5 * fov).tan(), ..right }),
        with("half-of-tangent", check::Student { half_height: |fov| fov.to_radians().tan() / 2.0, ..right }),
        with(
            "image-rows-flipped",
            check::Student {
                on_image: |x, y, width, height| {
                    let share = |x: u32, of: u32| (2.0 * f64::from(x) + 1.0) / f64::from(of) - 1.0;
                    dvec2(share(x, width), share(y, height))
                },
                ..right
            },
        ),
        with(
            "plane-aspect-inverted",
            check::Student {
                image_point: |camera, at| {
                    let h = solution::half_height(camera.fov_y_degrees);
                    let w = h / f64::from(camera.width) * f64::from(camera.height);
                    camera.eye + camera.forward + at.x * w * camera.right + at.y * h * camera.up
                },
                ..right
            },
        ),
        with(
            "camera-rows-flipped",
            check::Student {
                compute_ray: |camera, x, y| solution::compute_ray(camera, x, camera.height - 1 - y),
                ..right
            },
        ),
        with(
            "camera-aspect-ignored",
            check::Student {
                compute_ray: |camera, x, y| {
                    let at = solution::on_image(x, y, camera.width, camera.height);
                    let h = solution::half_height(camera.fov_y_degrees);
                    let way = camera.forward + at.x * h * camera.right + at.y * h * camera.up;
                    Ray { origin: camera.eye, direction: way / way.length() }
                },
                ..right
            },
        ),
        with(
            "camera-fov-halved-twice",
            check::Student {
                compute_ray: |camera, x, y| {
                    let narrow = raytree::lessons::Camera { fov_y_degrees: camera.fov_y_degrees / 2.0, ..*camera };
                    solution::compute_ray(&narrow, x, y)
                },
                ..right
            },
        ),
        with(
            "camera-degrees-as-radians",
            check::Student {
                compute_ray: |camera, x, y| {
                    let fov_y_degrees = camera.fov_y_degrees.to_degrees();
                    solution::compute_ray(&raytree::lessons::Camera { fov_y_degrees, ..*camera }, x, y)
                },
                ..right
            },
        ),
        with(
            "camera-pixel-corner",
            check::Student {
                compute_ray: |camera, x, y| {
                    let at = dvec2(
                        2.0 * f64::from(x) / f64::from(camera.width) - 1.0,
                        1.0 - 2.0 * f64::from(y) / f64::from(camera.height),
                    );
                    let way = solution::image_point(camera, at) - camera.eye;
                    Ray { origin: camera.eye, direction: way.normalize() }
                },
                ..right
            },
        ),
        with(
            "camera-direction-not-unit",
            check::Student {
                compute_ray: |camera, x, y| {
                    let at = solution::on_image(x, y, camera.width, camera.height);
                    Ray { origin: camera.eye, direction: solution::image_point(camera, at) - camera.eye }
                },
                ..right
            },
        ),
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
