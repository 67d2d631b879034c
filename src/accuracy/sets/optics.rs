use glam::DVec3;

use super::until;
use crate::accuracy::random::{Random, stored};
use crate::numbers::Real;

/// A ray's direction at a boundary of two media.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<R: Real> {
    /// Of any length.
    pub direction: R::Vec3,
    /// The surface's normal, of any length.
    pub normal: R::Vec3,
    /// The index of refraction on the ray's side.
    pub incident: R,
    /// The index of refraction beyond.
    pub transmitted: R,
}

/// A kind of crossings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpticsSet {
    /// Any directions, any indices.
    Random,
    /// Within three ulp of the critical angle.
    Critical,
    /// Sides of Pythagorean triangles: the critical angle is met exactly, or missed by an ulp of the index.
    Pythagorean,
}

impl OpticsSet {
    /// All of them, the easy one first.
    pub const ALL: [Self; 3] = [Self::Random, Self::Critical, Self::Pythagorean];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Critical => "at the critical angle",
            Self::Pythagorean => "exactly at the critical angle",
        }
    }

    /// The next crossing, as stored in the precision.
    pub fn next<R: Real>(self, g: &mut Random) -> Crossing<R> {
        until(|| self.draw(g))
    }

    fn draw<R: Real>(self, g: &mut Random) -> Option<Crossing<R>> {
        let (mut incident, mut transmitted) = (R::from_f64(1.0 + 1.5 * g.unit()), R::from_f64(1.0 + 0.2 * g.unit()));
        let (d, n) = match self {
            Self::Random => (g.point(1.0), g.point(1.0)),
            Self::Critical => {
                let sine = (transmitted.to_f64() / incident.to_f64()).min(1.0);
                let cosine = (1.0 - sine * sine).max(0.0).sqrt();
                let [x, y] = [sine, cosine].map(|c| g.nudge(R::from_f64(c), 3).to_f64());
                (DVec3::new(x, -y, 0.0), DVec3::Y)
            }
            Self::Pythagorean => {
                let [x, y, hypotenuse] =
                    [[3.0, 4.0, 5.0], [5.0, 12.0, 13.0], [8.0, 15.0, 17.0], [7.0, 24.0, 25.0]][g.below(4)];
                incident = g.nudge(R::from_f64(hypotenuse), 1);
                transmitted = R::from_f64(x);
                (DVec3::new(x, -y, 0.0), DVec3::Y * [0.5, 1.0, 3.0][g.below(3)])
            }
        };
        let (direction, normal) = (stored::<R>(d), stored::<R>(n));
        let zero = R::Vec3::default();
        (direction != zero && normal != zero).then_some(Crossing { direction, normal, incident, transmitted })
    }
}
