//! Predicate maps: what each form says at 256 x 256 points one unit in the last place apart, around a place where the
//! verdict changes. After Kettner, Mehlhorn, Pion, Schirra and Yap, Classroom Examples of Robustness Problems in
//! Geometric Computations, 2004.

use glam::DVec3;

use super::forms::{Boxes, Form, Refractions, Spheres, Subject, TriangleCase, Triangles};
use super::random::rounded;
use super::sets::Crossing;
use crate::kernels::{Aabb, Ray, Sphere, Triangle, TriangleFilter};
use crate::numbers::{Precision, Real, Vector3};

/// Points along a side of a map.
pub const SIDE: usize = 256;

/// A place where a verdict changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// A ray at the edge of two triangles: it hits one of them, and only exactly on the edge both.
    SharedEdge,
    /// A ray at the vertex that six triangles share.
    Vertex,
    /// A ray that touches a sphere.
    Tangent,
    /// A ray at the corner of a box.
    SlabCorner,
    /// A direction at the critical angle.
    CriticalAngle,
}

/// What a form's answer at one point is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// Right: nothing is hit, or light is reflected totally.
    Miss,
    /// Right: the triangle of this number is hit, the only shape, or light passes; 255 where several are.
    Hit(u8),
    /// Something should be hit and nothing is: a leak.
    FalseMiss,
    /// More is hit than should be.
    FalseHit,
    /// Something else is hit than should be.
    Swapped,
}

impl Cell {
    /// Whether the answer is wrong.
    pub fn is_wrong(self) -> bool {
        matches!(self, Self::FalseMiss | Self::FalseHit | Self::Swapped)
    }
}

/// One form's answers around a place.
#[derive(Clone, Debug)]
pub struct Map {
    /// The form.
    pub form: Form,
    /// Of the ray, the shapes and plain arithmetic.
    pub precision: Precision,
    /// [`SIDE`] rows from the top, each of [`SIDE`] cells.
    pub cells: Vec<Cell>,
}

impl Map {
    /// How many cells are wrong.
    pub fn wrong(&self) -> usize {
        self.cells.iter().filter(|cell| cell.is_wrong()).count()
    }
}

impl Place {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::SharedEdge, Self::Vertex, Self::Tangent, Self::SlabCorner, Self::CriticalAngle];

    /// What it is called in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::SharedEdge => "shared edge",
            Self::Vertex => "vertex",
            Self::Tangent => "tangent",
            Self::SlabCorner => "slab corner",
            Self::CriticalAngle => "critical angle",
        }
    }

    /// What is seen there.
    pub fn about(self) -> &'static str {
        match self {
            Self::SharedEdge => "two triangles with a common edge, the ray's origin moved in x and y",
            Self::Vertex => "six triangles around a vertex, the ray's origin moved in x and y",
            Self::Tangent => "a sphere and a ray that touches it, the ray's origin moved in x and y",
            Self::SlabCorner => "a box and a ray at its corner, the ray's origin moved in x and y",
            Self::CriticalAngle => "glass to air at the critical angle, the direction moved in x and y",
        }
    }

    /// The forms that have an answer.
    pub fn forms(self) -> impl Iterator<Item = Form> {
        let forms = match self {
            Self::SharedEdge | Self::Vertex => Triangles::FORMS,
            Self::Tangent => Spheres::FORMS,
            Self::SlabCorner => Boxes::FORMS,
            Self::CriticalAngle => Refractions::FORMS,
        };
        forms.iter().copied().filter(|form| *form != Form::Exact)
    }

    /// The maps of these forms. What is right is what the certified form says.
    pub fn maps<R: Real>(self, forms: &[Form]) -> Vec<Map> {
        match self {
            Self::SharedEdge => {
                let [p, q, r, s] = [[-0.7, -0.43, 0.11], [0.81, 0.37, -0.23], [0.3, -0.9, 0.1], [-0.2, 0.8, 0.3]];
                let target = DVec3::from_array(p).lerp(DVec3::from_array(q), 0.37);
                let triangles = [[p, q, r], [q, p, s]].map(triangle::<R>);
                around_ray::<R>(forms, target, |form, ray| Answer::of(form, ray, &triangles))
            }
            Self::Vertex => {
                let center = [0.23, 0.31, -0.12];
                let spoke = |k: usize| {
                    let angle = k as f64 / 6.0 * std::f64::consts::TAU + 0.2;
                    let (x, y) = (libm::cos(angle), libm::sin(angle));
                    [
                        center[0] + x,
                        center[1] + 0.8 * y,
                        0.3 * x - 0.2 * y + if k.is_multiple_of(2) { 0.2 } else { -0.2 },
                    ]
                };
                let triangles = [0, 1, 2, 3, 4, 5].map(|k| triangle::<R>([center, spoke(k), spoke((k + 1) % 6)]));
                let target = DVec3::from_array(center);
                around_ray::<R>(forms, target, |form, ray| Answer::of(form, ray, &triangles))
            }
            Self::Tangent => {
                let sphere = Sphere::<R> { center: R::Vec3::from_f64([0.1, -0.2, 0.3]), radius: R::from_f64(0.9) };
                // Across the direction from the centre.
                let across = DIRECTION.cross(DVec3::new(0.4, 0.9, 0.1)).normalize();
                let target = DVec3::from_array(sphere.center.to_f64()) + across * sphere.radius.to_f64();
                around_ray::<R>(forms, target, |form, ray| {
                    Answer::from(Spheres::verdict(form, &(ray, sphere)).is_some())
                })
            }
            Self::SlabCorner => {
                let aabb = Aabb::<R> {
                    min: R::Vec3::from_f64([-0.6, -0.7, -0.3]),
                    max: R::Vec3::from_f64([0.41, 0.53, 0.62]),
                };
                // Where the line goes past, not in.
                let [x, y, _] = aabb.min.to_f64();
                let target = DVec3::new(x, y, 0.0) + DVec3::Z * aabb.max.to_f64()[2];
                around_ray::<R>(forms, target, |form, ray| Answer::from(Boxes::verdict(form, &(ray, aabb)).is_some()))
            }
            Self::CriticalAngle => {
                let (glass, air) = (R::from_f64(1.5), R::ONE);
                let sine: f64 = 1.0 / 1.5;
                let direction = rounded::<R>(DVec3::new(sine, -(1.0 - sine * sine).sqrt(), 0.0));
                let around = around::<R>(direction);
                maps(forms, R::PRECISION, |form, column, row| {
                    let crossing = Crossing {
                        direction: around(column, row),
                        normal: R::Vec3::from_f64([0.0, 1.0, 0.0]),
                        incident: glass,
                        transmitted: air,
                    };
                    Answer::from(Refractions::verdict::<R>(form, &crossing).is_some())
                })
            }
        }
    }
}

/// The direction of all rays in the maps.
const DIRECTION: DVec3 = DVec3::new(0.31, -0.27, -1.0);

fn triangle<R: Real>(vertices: [[f64; 3]; 3]) -> Triangle<R> {
    Triangle { vertices: vertices.map(R::Vec3::from_f64) }
}

/// A bit for each shape that is hit.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Answer(u8);

impl From<bool> for Answer {
    fn from(is_hit: bool) -> Self {
        Self(is_hit.into())
    }
}

impl Answer {
    fn of<R: Real>(form: Form, ray: Ray<R>, triangles: &[Triangle<R>]) -> Self {
        let bit = |(i, triangle): (usize, &Triangle<R>)| {
            let filter = TriangleFilter::of_triangle(&ray, triangle);
            let case = TriangleCase { ray, triangle: *triangle, filter };
            u8::from(Triangles::verdict(form, &case).is_some()) << i
        };
        Self(triangles.iter().enumerate().map(bit).sum())
    }

    /// What this answer is worth where `truth` is right.
    fn judged(self, truth: Self) -> Cell {
        match (self, truth) {
            (Self(0), Self(0)) => Cell::Miss,
            (Self(said), Self(is)) if said == is && is.count_ones() > 1 => Cell::Hit(u8::MAX),
            (Self(said), Self(is)) if said == is => Cell::Hit(is.trailing_zeros() as u8),
            (Self(0), _) => Cell::FalseMiss,
            (Self(said), Self(is)) if said & is == is => Cell::FalseHit,
            _ => Cell::Swapped,
        }
    }
}

/// Maps around the ray towards `target`, whose origin is moved.
fn around_ray<R: Real>(forms: &[Form], target: DVec3, answer: impl Fn(Form, Ray<R>) -> Answer) -> Vec<Map> {
    let direction = R::Vec3::from_f64(DIRECTION.to_array());
    let origin = rounded::<R>(target - 2.0 * DVec3::from_array(direction.to_f64()));
    let around = around::<R>(origin);
    maps(forms, R::PRECISION, |form, column, row| answer(form, Ray { origin: around(column, row), direction }))
}

fn maps(forms: &[Form], precision: Precision, answer: impl Fn(Form, usize, usize) -> Answer) -> Vec<Map> {
    let places = || (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (column, row)));
    let truths: Vec<Answer> = places().map(|(column, row)| answer(Form::Certified, column, row)).collect();
    let map = |&form: &Form| {
        let cells = places().zip(&truths).map(|((column, row), truth)| answer(form, column, row).judged(*truth));
        Map { form, precision, cells: cells.collect() }
    };
    forms.iter().map(map).collect()
}

/// The numbers around `x`, each the next after the one before, `x` in the middle.
fn steps<R: Real>(x: f64) -> [R; SIDE + 1] {
    let mut steps = [R::from_f64(x); SIDE + 1];
    for i in SIDE / 2 + 1..=SIDE {
        steps[i] = steps[i - 1].next_up();
    }
    for i in (0..SIDE / 2).rev() {
        steps[i] = steps[i + 1].next_down();
    }
    steps
}

/// `v` with x moved across the map and y upwards: `v` itself in the middle.
fn around<R: Real>(v: DVec3) -> impl Fn(usize, usize) -> R::Vec3 {
    let (xs, ys) = (steps::<R>(v.x), steps::<R>(v.y));
    move |column, row| R::Vec3::new(xs[column], ys[SIDE - row], R::from_f64(v.z))
}
