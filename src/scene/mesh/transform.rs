//! Where a mesh stands in the world.

use crate::numbers::is_in_range;
use crate::scene::mesh::range::{RANGE_HELP, to_range};
use crate::scene::mesh::{MeshData, MeshError, dot, unit};

/// A similarity: first scaled, then rotated, both about the mesh's origin, then moved. What is absent changes no bit.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Transform {
    /// The factor of all lengths, above zero; 1 where it is absent.
    #[serde(default = "one")]
    pub scale: f64,
    /// The rotation, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotate: Option<Rotation>,
    /// The move, in world space; none where it is absent.
    #[serde(default)]
    pub translate: [f64; 3],
}

/// A rotation about an axis through the origin, counterclockwise for someone whom the axis points at.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Rotation {
    /// The axis, of any length but zero.
    pub axis: [f64; 3],
    /// The angle in degrees.
    pub degrees: f64,
}

fn one() -> f64 {
    1.0
}

impl Default for Transform {
    fn default() -> Self {
        Self { scale: 1.0, rotate: None, translate: [0.0; 3] }
    }
}

impl Transform {
    /// The mesh with every position scaled, rotated and moved, and every normal rotated.
    ///
    /// The result is what is traced, so it is rounded to what a mesh may hold: coordinates below 2^-126 to the nearest
    /// multiple of 2^-178. Positions that were equal stay equal, so that a closed mesh stays closed.
    ///
    /// # Errors
    /// A scale that is not finite and above zero (a negative one would turn the mesh inside out); an axis of length
    /// zero; an angle, axis or move that is not finite; a position that leaves the range of 2^128. None has a line:
    /// the fault is the transform's.
    ///
    /// # Accuracy
    /// Each coordinate is off by at most 32 * 2^-53 of the scaled position's length, and half a unit in its own last
    /// place; without a rotation by the roundings of one product and one sum.
    ///
    /// # Example
    /// ```
    /// use raytree::scene::mesh::{Rotation, Transform, parse_obj};
    /// let mesh = parse_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").unwrap();
    /// let rotate = Some(Rotation { axis: [0.0, 0.0, 1.0], degrees: 90.0 });
    /// let placed = Transform { scale: 2.0, rotate, translate: [0.0, 0.0, 5.0] }.apply(&mesh).unwrap();
    /// assert_eq!(placed.positions, [[0.0, 0.0, 5.0], [0.0, 2.0, 5.0], [-2.0, 0.0, 5.0]]);
    /// ```
    pub fn apply(&self, mesh: &MeshData) -> Result<MeshData, MeshError> {
        if !(self.scale > 0.0 && self.scale.is_finite()) {
            let message = format!("the scale of a mesh is {}", self.scale);
            return Err(MeshError::whole(message, "a number above zero"));
        }
        if !self.translate.iter().all(|x| x.is_finite()) {
            return Err(MeshError::whole("the move of a mesh is not finite", "three numbers"));
        }
        let matrix = self.rotate.map(|rotation| rotation.matrix()).transpose()?;

        let mut placed = mesh.clone();
        for (index, position) in placed.positions.iter_mut().enumerate() {
            let scaled = position.map(|x| x * self.scale);
            let turned = matrix.map_or(scaled, |rows| rows.map(|row| dot(row, scaled)));
            for axis in 0..3 {
                let step = self.translate[axis];
                // Adding zero would turn -0 into 0.
                let moved = if step == 0.0 { turned[axis] } else { turned[axis] + step };
                position[axis] = to_range(moved);
            }
            if !position.iter().all(|&x| is_in_range(x)) {
                let message = format!("the transform moves vertex {index}, counted from 0, out of range");
                return Err(MeshError::whole(message, RANGE_HELP));
            }
        }
        if let (Some(rows), Some(normals)) = (matrix, &mut placed.corner_normals) {
            for normal in normals.iter_mut().flatten() {
                *normal = rows.map(|row| dot(row, *normal));
            }
        }
        Ok(placed)
    }
}

impl Rotation {
    /// The rows of the rotation's matrix; for a multiple of 90 degrees about a coordinate axis all are exactly 0, 1
    /// or -1.
    ///
    /// # Errors
    /// An axis of length zero; an axis or angle that is not finite.
    ///
    /// # Source
    /// Rodrigues' formula, with `k^2 + (1 - k^2) c` on the diagonal, which is exact for `k` = 0 and 1.
    pub fn matrix(&self) -> Result<[[f64; 3]; 3], MeshError> {
        let Some([x, y, z]) = unit(self.axis) else {
            let message = format!("the axis of rotation {:?} has no direction", self.axis);
            return Err(MeshError::whole(message, "three numbers, not all zero"));
        };
        if !self.degrees.is_finite() {
            return Err(MeshError::whole("the angle of rotation is not finite", "an angle in degrees"));
        }
        let (s, c) = sincos_degrees(self.degrees);
        let v = 1.0 - c;
        Ok([
            [x * x + (1.0 - x * x) * c, x * y * v - z * s, x * z * v + y * s],
            [y * x * v + z * s, y * y + (1.0 - y * y) * c, y * z * v - x * s],
            [z * x * v - y * s, z * y * v + x * s, z * z + (1.0 - z * z) * c],
        ]
        // No -0, which would only puzzle readers.
        .map(|row| row.map(|entry| entry + 0.0)))
    }
}

/// Sine and cosine of a finite angle in degrees; exact at multiples of 90.
fn sincos_degrees(degrees: f64) -> (f64, f64) {
    // Both the remainder and what is left of the quarter turn are exact.
    let within = degrees % 360.0;
    let quarters = (within / 90.0).round();
    let rest = within - 90.0 * quarters;
    let (s, c) = libm::sincos(rest * (std::f64::consts::PI / 180.0));
    match (quarters as i32).rem_euclid(4) {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}
