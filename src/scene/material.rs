//! Materials: what a surface does with light. A term that is not there is `None`, never zero.

use glam::DVec3;

use super::Rgb;

/// What a surface does with light.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its key in the scene file.
    pub name: String,
    /// The colour of ambient and diffuse light.
    pub pigment: Pigment,
    /// Weight of the colour itself, lit or not.
    pub ambient: Option<Rgb>,
    /// Weight of Lambert's term.
    pub diffuse: Option<Rgb>,
    /// Phong's highlight.
    pub specular: Option<Specular>,
    /// Weight of the reflected ray.
    pub reflection: Option<Rgb>,
    /// Weight of the refracted ray. A solid of such a material is a medium.
    pub transmission: Option<Rgb>,
    /// Index of refraction, larger than 0; there wherever `transmission` or `fresnel` is.
    pub ior: Option<f64>,
    /// How the angle splits the light between reflection and transmission.
    pub fresnel: Option<Fresnel>,
}

impl Material {
    /// Whether direct light makes a difference here: it has a diffuse or a specular term.
    pub fn takes_direct_light(&self) -> bool {
        self.diffuse.is_some() || self.specular.is_some()
    }
}

/// Phong's highlight `strength * max(0, r.v)^shininess * light`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Specular {
    /// Weight, not tinted by the colour of the surface.
    pub strength: Rgb,
    /// Exponent, 0 or larger.
    pub shininess: f64,
}

/// How the angle of incidence splits the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Fresnel {
    /// Fresnel's equations for unpolarised light.
    Exact,
    /// Schlick's approximation.
    Schlick,
}

/// The colour of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pigment {
    /// The same everywhere.
    Constant(Rgb),
    /// Two colours in turn.
    Checker {
        /// The colours of even and of odd cells.
        colors: [Rgb; 2],
        /// The edge of a cell, larger than 0.
        size: f64,
    },
}

impl Pigment {
    /// The colour at a point; `in_plane` is the normal where the surface is a plane, which is checkered in two
    /// coordinates.
    pub fn color(&self, point: DVec3, in_plane: Option<DVec3>) -> Rgb {
        match *self {
            Self::Constant(color) => color,
            Self::Checker { colors, size } => {
                let cells = match in_plane {
                    None => (point / size).floor().element_sum(),
                    Some(normal) => {
                        let (u, v) = plane_axes(normal);
                        (u.dot(point) / size).floor() + (v.dot(point) / size).floor()
                    }
                };
                colors[usize::from(cells.rem_euclid(2.0) == 1.0)]
            }
        }
    }
}

/// Two orthonormal in-plane axes: of the world's axes, the one that the normal is closest to is left out (the first of
/// equals); `u` is the next one, turned into the plane, and `v` is perpendicular to it on the side of the last one.
fn plane_axes(normal: DVec3) -> (DVec3, DVec3) {
    let n = normal.abs();
    let (first, second) = if n.x >= n.y && n.x >= n.z {
        (DVec3::Y, DVec3::Z)
    } else if n.y >= n.z {
        (DVec3::X, DVec3::Z)
    } else {
        (DVec3::X, DVec3::Y)
    };
    let u = (first - normal * normal.dot(first)).normalize();
    let v = normal.cross(u);
    (u, if v.dot(second) < 0.0 { -v } else { v })
}
