//! Numeric questions, each with numbers of its own, for paper and for learning platforms.
//!
//! The same seed gives the same questions on every machine. Hits are decided by the certified kernels; what is asked for
//! comes out of them and of the kernels of the tracer, never out of the numbers that a question was made from.

mod latex;
mod markdown;
mod moodle;
mod optics;
mod shapes;
mod vectors;

pub use latex::{to_latex, to_latex_answers};
pub use markdown::{to_markdown, to_markdown_answers};
pub use moodle::to_moodle;

use glam::DVec3;

use super::words::shown;
use crate::accuracy::random::Random;

/// An answer counts if it is within this of the right one: a unit of the last of the three decimals asked for.
pub const TOLERANCE: f64 = 0.001;

/// What a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The scalar product as a projection.
    Projection,
    /// The cross product by Sarrus.
    Cross,
    /// The plane in Hesse form, and a ray that meets it.
    Plane,
    /// A ray that meets a triangle, and the barycentric coordinates.
    Triangle,
    /// The slabs of a box.
    Box,
    /// Both roots of a sphere.
    Sphere,
    /// The reflected direction.
    Reflection,
    /// The refracted direction by Snell.
    Refraction,
    /// The Fresnel reflectance.
    Fresnel,
}

impl Kind {
    /// All of them, in the order of the course.
    pub const ALL: [Kind; 9] = [
        Kind::Projection,
        Kind::Cross,
        Kind::Plane,
        Kind::Triangle,
        Kind::Box,
        Kind::Sphere,
        Kind::Reflection,
        Kind::Refraction,
        Kind::Fresnel,
    ];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Projection => "projection",
            Kind::Cross => "cross",
            Kind::Plane => "plane",
            Kind::Triangle => "triangle",
            Kind::Box => "box",
            Kind::Sphere => "sphere",
            Kind::Reflection => "reflection",
            Kind::Refraction => "refraction",
            Kind::Fresnel => "fresnel",
        }
    }

    /// What it is about, in a few words.
    pub fn title(self) -> &'static str {
        match self {
            Kind::Projection => "Scalar product and projection",
            Kind::Cross => "Cross product",
            Kind::Plane => "Ray and plane",
            Kind::Triangle => "Ray and triangle",
            Kind::Box => "Ray and box",
            Kind::Sphere => "Ray and sphere",
            Kind::Reflection => "Reflection",
            Kind::Refraction => "Refraction",
            Kind::Fresnel => "Fresnel reflectance",
        }
    }

    /// A question of this kind; nothing where the random numbers do not suit.
    fn draw(self, random: &mut Random) -> Option<Question> {
        match self {
            Kind::Projection => vectors::projection(random),
            Kind::Cross => vectors::cross(random),
            Kind::Plane => shapes::plane(random),
            Kind::Triangle => shapes::triangle(random),
            Kind::Box => shapes::aabb(random),
            Kind::Sphere => shapes::sphere(random),
            Kind::Reflection => optics::reflection(random),
            Kind::Refraction => optics::refraction(random),
            Kind::Fresnel => optics::fresnel(random),
        }
    }
}

/// A question: what is given, and what is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// What it is about.
    pub kind: Kind,
    /// What is given, in sentences with formulas in TeX between dollar signs.
    pub given: String,
    /// What is asked for, each a number.
    pub parts: Vec<Part>,
}

/// A number that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What it is, with formulas in TeX between dollar signs: no sentence, and without the number.
    pub asked: String,
    /// The right answer.
    pub answer: f64,
}

impl Part {
    fn new(asked: impl Into<String>, answer: f64) -> Self {
        Part { asked: asked.into(), answer }
    }

    /// The right answer as it is printed: to six digits.
    pub fn answer_text(&self) -> String {
        shown(self.answer)
    }
}

/// So many questions of a seed, the kinds taking turns. `kinds` is not empty.
///
/// # Example
/// ```
/// use raytree::lessons::questions::{Kind, questions};
/// let three = questions(7, &[Kind::Plane, Kind::Sphere], 3);
/// assert_eq!(three.iter().map(|q| q.kind).collect::<Vec<_>>(), [Kind::Plane, Kind::Sphere, Kind::Plane]);
/// assert_eq!(three, questions(7, &[Kind::Plane, Kind::Sphere], 3));
/// ```
pub fn questions(seed: u64, kinds: &[Kind], count: usize) -> Vec<Question> {
    let question = |(i, kind): (usize, &Kind)| {
        // Neighbouring seeds and places begin far apart: what they begin with goes through the generator once.
        let mut random = Random::new(Random::new(seed).bits() ^ Random::new(i as u64).bits().rotate_left(32));
        std::iter::repeat_with(|| kind.draw(&mut random)).flatten().next()
    };
    kinds.iter().cycle().take(count).enumerate().filter_map(question).collect()
}

/// Words that a question's numbers are rounded in.
const ROUNDING: &str = "Give numbers to three decimals.";

/// A vector in TeX: `(1, -2, 0.5)`.
fn tex(v: DVec3) -> String {
    format!("({})", v.to_array().map(shown).join(", "))
}

/// An integer from `low` to `high`.
fn integer(random: &mut Random, low: i32, high: i32) -> f64 {
    f64::from(low) + random.below((high - low + 1) as usize) as f64
}

/// A vector of integers in -n to n that is not 0.
fn vector(random: &mut Random, n: i32) -> DVec3 {
    loop {
        let v = random.vector(|random| integer(random, -n, n));
        if v != DVec3::ZERO {
            return v;
        }
    }
}

/// One of the given.
fn one<T: Copy>(random: &mut Random, of: &[T]) -> T {
    of[random.below(of.len())]
}

/// The vector with its axes exchanged and turned round at random; two given together keep their angle.
fn turned<const N: usize>(random: &mut Random, vectors: [[f64; 3]; N]) -> [DVec3; N] {
    let order = one(random, &[[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]]);
    let signs = [0; 3].map(|_| if random.one_in(2) { -1.0 } else { 1.0 });
    vectors.map(|v| DVec3::from_array([0, 1, 2].map(|k| signs[k] * v[order[k]])) + DVec3::ZERO)
}
