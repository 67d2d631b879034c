//! The arithmetic of a step: each formula is one value, which is shown in symbols, shown with numbers, handed on as JSON,
//! and evaluated to the bits of the tree.
//!
//! A [`Form`] is a few [`Line`]s, each a name and an [`Expression`] of names before it. One file a shape or a subject. The
//! lines follow the kernel operation by operation, so that evaluating them in the form's precision gives the kernel's bits.
//!
//! In JSON an expression is a name (a string), a constant (a number), or an array of an operation and its operands:
//!
//! | operation | of | value |
//! |---|---|---|
//! | `+` `-` | two numbers or two vectors | sum, difference |
//! | `*` | numbers; vector and number; two colours | product, of vectors component by component |
//! | `/` | number or vector, number | quotient |
//! | `neg` `abs` | number or vector | `-a`, magnitude |
//! | `sqrt` | number | square root |
//! | `dot` `cross` | two vectors | `x x' + y y' + z z'` from the left; vector product |
//! | `x` `y` `z` | vector | a component |
//! | `max` `min` | numbers | the first of the largest, smallest; what is not a number never counts |
//! | `clamp` | x, least, most: numbers or vectors | `x` brought between the two |
//! | `pow` | two numbers | power, as `libm` computes it |
//! | `f32` | number or vector | rounded to single precision |
//! | `flush` | number or vector | 0 for what is below 2^-126 in magnitude, and for -0 |
//! | `if<` | a, b, x, y | `x` where `a < b`, else `y` |

mod aabb;
mod bounds;
mod camera;
mod color;
mod expression;
mod light;
mod optics;
mod plane;
mod point;
mod sphere;
mod triangle;

pub(super) use aabb::{Way, slab_names};
pub use expression::{Expression, Operation, decimal, decimals};

use super::book::Setting;
use crate::numbers::Precision;
use crate::tree::Value;

/// Values by their names.
pub type Values = Vec<(&'static str, Value)>;

/// The value of a name, the later one where it stands twice.
pub(super) fn value_of(values: &[(&'static str, Value)], name: &str) -> Option<Value> {
    values.iter().rev().find(|(key, _)| *key == name).map(|(_, value)| *value)
}

/// A formula: lines that are worked out one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// Its name, unique in a recording.
    pub name: String,
    /// What it works out, in a few words.
    pub title: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// The precision that each operation is rounded to.
    pub precision: Precision,
    /// The lines.
    pub lines: Vec<Line>,
}

/// A line of a formula: a name and what it stands for.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The name of the result.
    pub name: &'static str,
    /// What gives it.
    pub expression: Expression,
}

impl Line {
    /// What it stands for, in symbols: `radius * radius * a - l_dot_l`.
    pub fn symbols(&self) -> String {
        self.expression.text(Precision::F64, &|_| None)
    }
}

/// The arithmetic of one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Arithmetic {
    /// The form, by its place in [`Recording::forms`](super::Recording::forms).
    pub form: usize,
    /// What goes in and what comes out, in this order. A name that is not here is one of the node's
    /// [`values`](super::Node::values); a line without a value was not reached.
    pub values: Values,
    /// What the formula does not say: that the verdict was reached by other means, or a number refined.
    pub note: Option<String>,
}

/// A line of a formula, written out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Worked {
    /// The name of the result.
    pub name: &'static str,
    /// In symbols: `radius * radius * a - l . l`.
    pub symbols: String,
    /// The same with the numbers of this ray.
    pub numbers: String,
    /// The result, in the shortest decimals that read back to the same bits.
    pub result: String,
}

impl Form {
    /// The results of the lines, in order, as far as they can be worked out from `value_of`; not beyond the line `last`.
    pub fn evaluate(&self, last: Option<&str>, value_of: &impl Fn(&str) -> Option<Value>) -> Values {
        let mut results: Values = Vec::with_capacity(self.lines.len());
        for line in &self.lines {
            let value = line
                .expression
                .evaluate(self.precision, &|name| self::value_of(&results, name).or_else(|| value_of(name)));
            let Some(value) = value else { break };
            results.push((line.name, value));
            if last == Some(line.name) {
                break;
            }
        }
        results
    }

    /// The lines written out, as far as they have a value.
    pub fn worked(&self, value_of: &impl Fn(&str) -> Option<Value>) -> Vec<Worked> {
        let worked = |line: &Line| {
            let result = value_of(line.name)?;
            Some(Worked {
                name: line.name,
                symbols: line.symbols(),
                numbers: line.expression.text(self.precision, value_of),
                result: decimals(&result, self.precision),
            })
        };
        self.lines.iter().map_while(worked).collect()
    }
}

/// The formulas that there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Formula {
    /// The camera's ray through a pixel.
    Camera,
    /// A bounding box, the ray going this way along each axis.
    Bounds([Way; 3]),
    /// A plane in Hesse normal form.
    Plane,
    /// A triangle as the lecture has it: the plane first.
    TriangleByPlane,
    /// A triangle by determinants, after Möller and Trumbore.
    TriangleByDeterminants,
    /// A box by slabs, as the lecture has it.
    BoxLecture,
    /// A box by slabs, the ray going this way along each axis.
    Box([Way; 3]),
    /// A sphere by the textbook's quadratic.
    SphereNaive,
    /// A sphere by the stable quadratic.
    SphereStable,
    /// The hit point.
    Point(OnSurface),
    /// The unit normal of a sphere.
    SphereNormal,
    /// The direction and distance to a point light.
    ToPointLight(Tiny),
    /// The direction to a light infinitely far away.
    ToDirectionalLight(Tiny),
    /// The cosine between the normal and the direction to the light.
    Cosine,
    /// The ambient term.
    Ambient,
    /// Lambert's term.
    Diffuse,
    /// Phong's highlight.
    Specular,
    /// What a light sends: both terms.
    Direct,
    /// The mirrored direction.
    Reflect(Tiny),
    /// Snell's law as usually written.
    SnellUsual(Tiny),
    /// Snell's law without the cancellation, from the sign that was decided exactly.
    SnellStable(Tiny),
    /// The number whose sign decides total reflection, in double precision alone.
    SnellSign,
    /// Fresnel's equations.
    FresnelExact(Cosines),
    /// Schlick's approximation.
    FresnelSchlick {
        /// Where the cosines come from.
        given: Cosines,
        /// Whether the ray comes from the side of the smaller index: then the cosine of incidence counts.
        from_smaller: bool,
    },
    /// The share and the weight of a child.
    Share(Split),
    /// What a child brings back, times its share.
    Returned,
    /// The colour so far, and something more.
    Sum,
    /// The background's gradient.
    Gradient,
}

/// What becomes of the tiny components of a new ray's direction. They are flushed to 0 always; a formula says so where it
/// makes a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tiny {
    /// There are none.
    Kept,
    /// They become 0, and so does -0.
    Flushed,
}

impl Tiny {
    /// Both, the plain one first.
    pub(super) const ALL: [Self; 2] = [Self::Kept, Self::Flushed];

    /// A name that says so.
    fn name(self, name: &str) -> String {
        match self {
            Self::Kept => name.to_owned(),
            Self::Flushed => format!("{name}_flushed"),
        }
    }

    /// The direction without what is flushed.
    fn of(self, direction: Expression) -> Expression {
        match self {
            Self::Kept => direction,
            Self::Flushed => expression::of(Operation::Flush, direction),
        }
    }
}

/// Where the cosines of Fresnel's equations come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cosines {
    /// From Snell's law as usually written, which has been worked out before.
    Given,
    /// From the number whose sign decided total reflection.
    FromSign,
}

impl Cosines {
    /// A name that says so.
    fn name(self, name: &str) -> String {
        match self {
            Self::Given => name.to_owned(),
            Self::FromSign => format!("{name}_from_sign"),
        }
    }
}

/// Where a hit point is brought back to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OnSurface {
    /// Nowhere: it stays where `t` puts it.
    Stays,
    /// Onto a sphere, along its radius.
    Sphere,
    /// Onto a sphere that is small and far away: from the line's foot and half the chord.
    FarSphere {
        /// Whether it is the nearer of the two hits.
        near: bool,
    },
    /// Onto the face of a box.
    Face,
    /// Onto a triangle: the sum of its weighted vertices.
    Triangle,
    /// Onto a plane, down its normal.
    Plane,
}

/// How a child's share comes about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Split {
    /// It is the material's weight.
    Whole,
    /// The material's weight times what Fresnel's equations reflect.
    Reflected,
    /// The material's weight times what they let through.
    Transmitted,
    /// Total reflection: both of the material's weights.
    Both,
}

impl Formula {
    /// The form, for how the tree was traced. What is computed in double precision whatever the geometry's is so here.
    pub(super) fn form(self, setting: Setting) -> Form {
        let Setting { rays, kernels, .. } = setting;
        let is_rounded = rays == Precision::F32;
        match self {
            Self::Camera => camera::form(is_rounded),
            Self::Bounds(ways) => bounds::form(ways),
            Self::Plane => plane::form(kernels),
            Self::TriangleByPlane => triangle::by_plane(kernels),
            Self::TriangleByDeterminants => triangle::by_determinants(kernels),
            Self::BoxLecture => aabb::lecture(kernels),
            Self::Box(ways) => aabb::slabs(ways, kernels),
            Self::SphereNaive => sphere::naive(kernels),
            Self::SphereStable => sphere::stable(kernels),
            // With a bound on its error the point is worked out in the rays' own precision, whatever the kernels'.
            Self::Point(surface) if setting.by_error_bound => point::form(surface, rays, false),
            Self::Point(surface) => point::form(surface, kernels, rays != kernels),
            Self::SphereNormal => point::sphere_normal(is_rounded),
            Self::ToPointLight(tiny) => light::to_point(rays, tiny),
            Self::ToDirectionalLight(tiny) => light::to_directional(rays, tiny),
            Self::Cosine => light::cosine(),
            Self::Ambient => light::ambient(),
            Self::Diffuse => light::diffuse(),
            Self::Specular => light::specular(),
            Self::Direct => light::direct(),
            Self::Reflect(tiny) => optics::reflect(rays, tiny),
            Self::SnellUsual(tiny) => optics::snell_usual(rays, tiny),
            Self::SnellStable(tiny) => optics::snell_stable(is_rounded, tiny),
            Self::SnellSign => optics::snell_sign(),
            Self::FresnelExact(given) => optics::fresnel_exact(given),
            Self::FresnelSchlick { given, from_smaller } => optics::fresnel_schlick(given, from_smaller),
            Self::Share(split) => color::share(split),
            Self::Returned => color::returned(),
            Self::Sum => color::sum(),
            Self::Gradient => color::gradient(),
        }
    }
}

/// A form of these lines.
fn form(
    name: impl Into<String>,
    title: &'static str,
    source: &'static str,
    precision: Precision,
    lines: Vec<(&'static str, Expression)>,
) -> Form {
    let lines = lines.into_iter().map(|(name, expression)| Line { name, expression }).collect();
    Form { name: name.into(), title, source, precision, lines }
}

/// The expression, rounded to single precision where that is asked for.
fn rounded(is_rounded: bool, expression: Expression) -> Expression {
    if is_rounded { expression::of(Operation::Single, expression) } else { expression }
}
