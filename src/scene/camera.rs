//! The camera: from a pixel to a ray.

use glam::DVec3;

use crate::kernels::Ray;
use crate::numbers;

/// Size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    /// Pixels in a row, 1 or more.
    pub width: u32,
    /// Rows, 1 or more.
    pub height: u32,
}

impl Resolution {
    /// The most pixels of a picture, 2^26.
    pub const MOST_PIXELS: u64 = 1 << 26;
}

/// A pinhole camera: an eye and an orthonormal frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The pinhole, in world space.
    pub eye: DVec3,
    /// Unit vector to the right of the picture: forward x up.
    pub right: DVec3,
    /// Unit vector to the top of the picture.
    pub up: DVec3,
    /// Unit vector into the picture.
    pub forward: DVec3,
    /// Tangent of half the vertical field of view: half the height of the image plane at distance 1.
    pub half_height: f64,
}

impl Camera {
    /// A camera at `eye` that looks at `look_at`, with `up` upwards in the picture.
    ///
    /// # None when
    /// `eye` equals `look_at`, or `up` is zero or parallel to the view (sine below 1e-9).
    ///
    /// # Ranges
    /// `fov_y` in radians, between 0 and pi.
    pub fn look_at(eye: DVec3, look_at: DVec3, up: DVec3, fov_y: f64) -> Option<Self> {
        let forward = unit(look_at - eye)?;
        let across = forward.cross(unit(up)?);
        if !(across.length() > 1e-9) {
            return None;
        }
        let right = unit(across)?;
        Some(Self { eye, right, up: right.cross(forward), forward, half_height: libm::tan(0.5 * fov_y) })
    }

    /// The lecture's ComputeRay: the unit-length ray through the centre of pixel `(x, y)`, `(0, 0)` top left, y down.
    pub fn ray(&self, image: Resolution, x: u32, y: u32) -> Ray<f64> {
        let (width, height) = (f64::from(image.width), f64::from(image.height));
        let half_width = self.half_height * width / height;
        let across = (2.0 * (f64::from(x) + 0.5) / width - 1.0) * half_width;
        let upwards = (1.0 - 2.0 * (f64::from(y) + 0.5) / height) * self.half_height;
        let direction = self.forward + self.right * across + self.up * upwards;
        Ray { origin: self.eye, direction: direction / direction.length() }
    }
}

/// `v` at length 1.
///
/// # None when
/// `v` has a component that is not finite, or none of magnitude 2^-126 or more.
pub(super) fn unit(v: DVec3) -> Option<DVec3> {
    let long_enough = v.abs().max_element() >= f64::from(f32::MIN_POSITIVE);
    numbers::unit(v.to_array()).filter(|_| long_enough).map(DVec3::from_array)
}
