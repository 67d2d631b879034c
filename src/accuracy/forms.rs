//! The contestants: for each subject its forms side by side, its sets, and its referee.

use std::cmp::Ordering;

use super::random::Random;
use super::referee::{self, Q, SphereTruth, TriangleTruth, q, sign};
use super::sets::{BoxSet, Crossing, OpticsSet, PlaneSet, SphereSet, TriangleSet};
use crate::kernels::optics::transmitted_cosine_usual;
use crate::kernels::{
    Aabb, Plane, Ray, Sphere, Start, Triangle, TriangleFilter, box_stage, certify_total_reflection,
    intersect_box_certified, intersect_box_explicit_zero, intersect_box_lecture, intersect_plane_certified,
    intersect_plane_lecture, intersect_sphere_certified, intersect_sphere_exact, intersect_sphere_naive,
    intersect_sphere_stable, intersect_triangle_certified, intersect_triangle_exact, intersect_triangle_lecture,
    intersect_triangle_moller_trumbore, intersect_triangle_watertight, is_total_reflection, plane_stage, refract,
    refract_usual, sphere_stage, triangle_stage,
};
use crate::numbers::{Real, Stage, Vector3};

/// A way to come to a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// The lecture's formula as it stands.
    Lecture,
    /// Möller and Trumbore 1997.
    MollerTrumbore,
    /// Woop, Benthin and Wald 2013.
    Watertight,
    /// Haines, Günther and Akenine-Möller 2019.
    Stable,
    /// Slabs with a case of their own for a direction of 0.
    ExplicitZero,
    /// A filter with exact stages behind it.
    Certified,
    /// Exact arithmetic alone.
    Exact,
}

impl Form {
    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lecture => "lecture",
            Self::MollerTrumbore => "Möller-Trumbore",
            Self::Watertight => "watertight",
            Self::Stable => "stable quadratic",
            Self::ExplicitZero => "explicit zero",
            Self::Certified => "certified",
            Self::Exact => "exact",
        }
    }
}

/// What a form says: `t` of the hit, or that there is none. For total reflection, 0 where light passes.
pub type Verdict = Option<f64>;

/// The exact answer.
#[derive(Clone, Debug)]
pub enum Truth {
    /// No hit.
    Miss,
    /// A hit, `t` a fraction: numerator and denominator.
    Fraction(Q, Q),
    /// A hit, `t` a root of a quadratic: the larger one where it says so.
    Root(Box<SphereTruth>, bool),
    /// A verdict without a `t`.
    Yes,
}

impl Truth {
    /// Whether it is a hit.
    pub fn is_hit(&self) -> bool {
        !matches!(self, Self::Miss)
    }

    /// How far `t` is from the exact one, in units in the last place of the exact one in `R`; nothing for a miss.
    pub fn ulps<R: Real>(&self, t: f64) -> Option<f64> {
        if !t.is_finite() {
            return self.is_hit().then_some(f64::INFINITY);
        }
        let (numerator, denominator) = match self {
            Self::Miss | Self::Yes => return None,
            Self::Fraction(numerator, denominator) => (numerator.clone(), denominator.clone()),
            Self::Root(truth, far) => {
                // Narrow beside any f64 that a set yields.
                let (low, high) = truth.interval(*far, 800);
                ((low + high) / q(2.0), q(1.0))
            }
        };
        let exact = (&numerator / &denominator).to_f64().value();
        let distance = ((q(t) * &denominator - numerator) / denominator).to_f64().value();
        // Between two powers of two the last place is worth the same.
        let exponent = (exact.abs().to_bits() >> 52).max(1023 - 126) << 52;
        Some(distance.abs() / (f64::from_bits(exponent) * 2.0 * R::UNIT_ROUNDOFF.to_f64()))
    }
}

/// Something that several forms decide.
pub trait Subject {
    /// What it is called.
    const NAME: &'static str;
    /// Its forms; [`Form::Certified`] is one of them.
    const FORMS: &'static [Form];
    /// A kind of random cases.
    type Set: Copy + Send + Sync + 'static;
    /// The kinds that there are, the easy ones first.
    const SETS: &'static [Self::Set];
    /// One question, as stored in the precision.
    type Case<R: Real>: Clone + std::fmt::Debug;

    /// What a set is called.
    fn set_name(set: Self::Set) -> &'static str;
    /// The next case of a set.
    fn next<R: Real>(set: Self::Set, random: &mut Random) -> Self::Case<R>;
    /// What a form says.
    fn verdict<R: Real>(form: Form, case: &Self::Case<R>) -> Verdict;
    /// The nearest hit of all cases (or the refracted direction closest to the surface), as a tracer wants it: the loop
    /// that is timed.
    fn nearest<R: Real>(form: Form, cases: &[Self::Case<R>]) -> f64;
    /// Which stage of the certified form decides.
    fn stage<R: Real>(case: &Self::Case<R>) -> Stage;
    /// The exact answer.
    fn truth<R: Real>(case: &Self::Case<R>) -> Truth;
}

/// The least `t`. Counting hits instead would let the compiler drop half of what a tracer has to do.
fn least<C, R: Real>(cases: &[C], t: impl Fn(&C) -> Option<R>) -> f64 {
    cases.iter().filter_map(t).fold(f64::INFINITY, |least, t| if t.to_f64() < least { t.to_f64() } else { least })
}

/// Rays and triangles.
#[derive(Clone, Copy, Debug)]
pub struct Triangles;

/// A ray and a triangle, with the filter that a ray has ready for a mesh.
#[derive(Clone, Debug)]
pub struct TriangleCase<R: Real> {
    /// The ray.
    pub ray: Ray<R>,
    /// The triangle.
    pub triangle: Triangle<R>,
    /// The filter for both.
    pub filter: TriangleFilter,
}

impl Subject for Triangles {
    const NAME: &'static str = "triangle";
    const FORMS: &'static [Form] =
        &[Form::Lecture, Form::MollerTrumbore, Form::Watertight, Form::Certified, Form::Exact];
    type Set = TriangleSet;
    const SETS: &'static [TriangleSet] = &TriangleSet::ALL;
    type Case<R: Real> = TriangleCase<R>;

    fn set_name(set: TriangleSet) -> &'static str {
        set.name()
    }

    fn next<R: Real>(set: TriangleSet, random: &mut Random) -> TriangleCase<R> {
        let (ray, triangle) = set.next::<R>(random);
        TriangleCase { filter: TriangleFilter::of_triangle(&ray, &triangle), ray, triangle }
    }

    fn verdict<R: Real>(form: Form, case: &TriangleCase<R>) -> Verdict {
        let TriangleCase { ray, triangle, filter } = case;
        let t = match form {
            Form::Lecture => intersect_triangle_lecture(ray, triangle).ok()?.t,
            Form::Watertight => intersect_triangle_watertight(ray, triangle).ok()?.t,
            Form::Certified => return Some(intersect_triangle_certified(ray, triangle, filter).ok()?.t),
            Form::Exact => intersect_triangle_exact(ray, triangle).ok()?.t,
            _ => intersect_triangle_moller_trumbore(ray, triangle).ok()?.t,
        };
        Some(t.to_f64())
    }

    fn nearest<R: Real>(form: Form, cases: &[TriangleCase<R>]) -> f64 {
        match form {
            Form::Lecture => least(cases, |c| intersect_triangle_lecture(&c.ray, &c.triangle).ok().map(|hit| hit.t)),
            Form::Watertight => {
                least(cases, |c| intersect_triangle_watertight(&c.ray, &c.triangle).ok().map(|hit| hit.t))
            }
            Form::Certified => {
                least(cases, |c| intersect_triangle_certified(&c.ray, &c.triangle, &c.filter).ok().map(|hit| hit.t))
            }
            Form::Exact => least(cases, |c| intersect_triangle_exact(&c.ray, &c.triangle).ok().map(|hit| hit.t)),
            _ => least(cases, |c| intersect_triangle_moller_trumbore(&c.ray, &c.triangle).ok().map(|hit| hit.t)),
        }
    }

    fn stage<R: Real>(case: &TriangleCase<R>) -> Stage {
        triangle_stage(&case.ray, &case.triangle, &case.filter)
    }

    fn truth<R: Real>(case: &TriangleCase<R>) -> Truth {
        match TriangleTruth::new(&case.ray, &case.triangle) {
            Some(truth) if truth.is_hit() => Truth::Fraction(truth.t_numerator, truth.denominator),
            _ => Truth::Miss,
        }
    }
}

/// Rays and spheres.
#[derive(Clone, Copy, Debug)]
pub struct Spheres;

impl Subject for Spheres {
    const NAME: &'static str = "sphere";
    const FORMS: &'static [Form] = &[Form::Lecture, Form::Stable, Form::Certified, Form::Exact];
    type Set = SphereSet;
    const SETS: &'static [SphereSet] = &SphereSet::ALL;
    type Case<R: Real> = (Ray<R>, Sphere<R>);

    fn set_name(set: SphereSet) -> &'static str {
        set.name()
    }

    fn next<R: Real>(set: SphereSet, random: &mut Random) -> (Ray<R>, Sphere<R>) {
        set.next(random)
    }

    fn verdict<R: Real>(form: Form, (ray, sphere): &(Ray<R>, Sphere<R>)) -> Verdict {
        let start = Start::Anywhere;
        let t = match form {
            Form::Lecture => intersect_sphere_naive(ray, sphere, start).ok()?.t,
            Form::Certified => return Some(intersect_sphere_certified(ray, sphere, start).ok()?.t),
            Form::Exact => intersect_sphere_exact(ray, sphere, start).ok()?.t,
            _ => intersect_sphere_stable(ray, sphere, start).ok()?.t,
        };
        Some(t.to_f64())
    }

    fn nearest<R: Real>(form: Form, cases: &[(Ray<R>, Sphere<R>)]) -> f64 {
        let start = Start::Anywhere;
        match form {
            Form::Lecture => {
                least(cases, |(ray, sphere)| intersect_sphere_naive(ray, sphere, start).ok().map(|hit| hit.t))
            }
            Form::Certified => {
                least(cases, |(ray, sphere)| intersect_sphere_certified(ray, sphere, start).ok().map(|hit| hit.t))
            }
            Form::Exact => {
                least(cases, |(ray, sphere)| intersect_sphere_exact(ray, sphere, start).ok().map(|hit| hit.t))
            }
            _ => least(cases, |(ray, sphere)| intersect_sphere_stable(ray, sphere, start).ok().map(|hit| hit.t)),
        }
    }

    fn stage<R: Real>((ray, sphere): &(Ray<R>, Sphere<R>)) -> Stage {
        sphere_stage(ray, sphere, Start::Anywhere)
    }

    fn truth<R: Real>((ray, sphere): &(Ray<R>, Sphere<R>)) -> Truth {
        let truth = SphereTruth::new(ray, sphere);
        let is_behind = |far| truth.compare(far, &Q::ZERO) == Ordering::Less;
        if sign(&truth.disc) < 0 || is_behind(true) {
            return Truth::Miss;
        }
        let far = is_behind(false);
        Truth::Root(Box::new(truth), far)
    }
}

/// Rays and boxes.
#[derive(Clone, Copy, Debug)]
pub struct Boxes;

impl Subject for Boxes {
    const NAME: &'static str = "box";
    const FORMS: &'static [Form] = &[Form::Lecture, Form::ExplicitZero, Form::Certified];
    type Set = BoxSet;
    const SETS: &'static [BoxSet] = &BoxSet::ALL;
    type Case<R: Real> = (Ray<R>, Aabb<R>);

    fn set_name(set: BoxSet) -> &'static str {
        set.name()
    }

    fn next<R: Real>(set: BoxSet, random: &mut Random) -> (Ray<R>, Aabb<R>) {
        set.next(random)
    }

    fn verdict<R: Real>(form: Form, (ray, aabb): &(Ray<R>, Aabb<R>)) -> Verdict {
        let start = Start::Anywhere;
        let t = match form {
            Form::Lecture => intersect_box_lecture(ray, aabb, start).ok()?.t,
            Form::Certified => return Some(intersect_box_certified(ray, aabb, start).ok()?.t),
            _ => intersect_box_explicit_zero(ray, aabb, start).ok()?.t,
        };
        Some(t.to_f64())
    }

    fn nearest<R: Real>(form: Form, cases: &[(Ray<R>, Aabb<R>)]) -> f64 {
        let start = Start::Anywhere;
        match form {
            Form::Lecture => least(cases, |(ray, aabb)| intersect_box_lecture(ray, aabb, start).ok().map(|hit| hit.t)),
            Form::Certified => {
                least(cases, |(ray, aabb)| intersect_box_certified(ray, aabb, start).ok().map(|hit| hit.t))
            }
            _ => least(cases, |(ray, aabb)| intersect_box_explicit_zero(ray, aabb, start).ok().map(|hit| hit.t)),
        }
    }

    fn stage<R: Real>((ray, aabb): &(Ray<R>, Aabb<R>)) -> Stage {
        box_stage(ray, aabb, Start::Anywhere)
    }

    fn truth<R: Real>((ray, aabb): &(Ray<R>, Aabb<R>)) -> Truth {
        referee::box_hit(ray, aabb).map_or(Truth::Miss, |(_, t)| Truth::Fraction(t, q(1.0)))
    }
}

/// Rays and planes.
#[derive(Clone, Copy, Debug)]
pub struct Planes;

impl Subject for Planes {
    const NAME: &'static str = "plane";
    const FORMS: &'static [Form] = &[Form::Lecture, Form::Certified];
    type Set = PlaneSet;
    const SETS: &'static [PlaneSet] = &PlaneSet::ALL;
    type Case<R: Real> = (Ray<R>, Plane<R>);

    fn set_name(set: PlaneSet) -> &'static str {
        set.name()
    }

    fn next<R: Real>(set: PlaneSet, random: &mut Random) -> (Ray<R>, Plane<R>) {
        set.next(random)
    }

    fn verdict<R: Real>(form: Form, (ray, plane): &(Ray<R>, Plane<R>)) -> Verdict {
        match form {
            Form::Certified => Some(intersect_plane_certified(ray, plane).ok()?.t),
            _ => Some(intersect_plane_lecture(ray, plane).ok()?.t.to_f64()),
        }
    }

    fn nearest<R: Real>(form: Form, cases: &[(Ray<R>, Plane<R>)]) -> f64 {
        match form {
            Form::Certified => least(cases, |(ray, plane)| intersect_plane_certified(ray, plane).ok().map(|hit| hit.t)),
            _ => least(cases, |(ray, plane)| intersect_plane_lecture(ray, plane).ok().map(|hit| hit.t)),
        }
    }

    fn stage<R: Real>((ray, plane): &(Ray<R>, Plane<R>)) -> Stage {
        plane_stage(ray, plane)
    }

    fn truth<R: Real>((ray, plane): &(Ray<R>, Plane<R>)) -> Truth {
        let (n_dot_d, height) = referee::plane(ray, plane);
        if sign(&n_dot_d) == 0 || sign(&n_dot_d) * sign(&height) < 0 {
            return Truth::Miss;
        }
        Truth::Fraction(height, n_dot_d)
    }
}

/// Light at a boundary: whether it passes.
#[derive(Clone, Copy, Debug)]
pub struct Refractions;

impl Subject for Refractions {
    const NAME: &'static str = "total reflection";
    const FORMS: &'static [Form] = &[Form::Lecture, Form::Certified];
    type Set = OpticsSet;
    const SETS: &'static [OpticsSet] = &OpticsSet::ALL;
    type Case<R: Real> = Crossing<R>;

    fn set_name(set: OpticsSet) -> &'static str {
        set.name()
    }

    fn next<R: Real>(set: OpticsSet, random: &mut Random) -> Crossing<R> {
        set.next(random)
    }

    fn verdict<R: Real>(form: Form, c: &Crossing<R>) -> Verdict {
        let passes = match form {
            Form::Certified => !is_total_reflection(c.direction, c.normal, c.incident, c.transmitted),
            _ => passes_as_usual(c),
        };
        passes.then_some(0.0)
    }

    fn nearest<R: Real>(form: Form, cases: &[Crossing<R>]) -> f64 {
        match form {
            Form::Certified => least(cases, |c| {
                refract(c.direction, c.normal, c.incident, c.transmitted).map(|refracted| refracted.dot(c.normal))
            }),
            _ => least(cases, |c| {
                refract_usual(c.direction, c.normal, c.incident, c.transmitted)
                    .map(|(refracted, _)| refracted.dot(c.normal))
            }),
        }
    }

    fn stage<R: Real>(c: &Crossing<R>) -> Stage {
        certify_total_reflection(c.direction, c.normal, c.incident, c.transmitted).stage
    }

    fn truth<R: Real>(c: &Crossing<R>) -> Truth {
        let passes = sign(&referee::transmission::<R>(c.direction, c.normal, c.incident, c.transmitted)) >= 0;
        if passes { Truth::Yes } else { Truth::Miss }
    }
}

/// The usual form on the rounded cosine and the rounded quotient of the indices.
fn passes_as_usual<R: Real>(c: &Crossing<R>) -> bool {
    let (d, n) = (c.direction, c.normal);
    let cosine = d.dot(n).abs() / (d.dot(d) * n.dot(n)).sqrt();
    transmitted_cosine_usual(c.incident / c.transmitted, cosine.smaller(R::ONE)).is_some()
}
