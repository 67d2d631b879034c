//! How far apart two numbers may be and still be the same answer.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use super::Field;
use crate::input::one_of;
use crate::numbers::Precision;
use crate::tree::RayTree;

/// How far apart two numbers may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// So many units in the last place of the field's scale, in `f64`; 0 asks for equal numbers.
    Ulps(f64),
    /// So much of the field's scale.
    Relative(f64),
}

impl Tolerance {
    /// How far apart numbers may be that are measured against this scale.
    pub fn allowed(self, scale: f64) -> f64 {
        match self {
            Self::Ulps(ulps) => ulps * ulp(scale),
            Self::Relative(relative) => relative * scale,
        }
    }
}

impl fmt::Display for Tolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ulps(ulps) => write!(f, "{ulps} ulp"),
            Self::Relative(relative) => write!(f, "{relative:e} relative"),
        }
    }
}

impl serde::Serialize for Tolerance {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Ulps(ulps) => serializer.collect_map([("ulps", ulps)]),
            Self::Relative(relative) => serializer.collect_map([("relative", relative)]),
        }
    }
}

impl FromStr for Tolerance {
    type Err = String;
    /// `4ulp`, or a number for a relative one.
    ///
    /// # Errors
    /// What would be right.
    ///
    /// # Example
    /// ```
    /// use raytree::tree::diff::Tolerance;
    /// assert_eq!("4ulp".parse(), Ok(Tolerance::Ulps(4.0)));
    /// assert_eq!("1e-6".parse(), Ok(Tolerance::Relative(1e-6)));
    /// assert!("-1".parse::<Tolerance>().is_err());
    /// ```
    fn from_str(word: &str) -> Result<Self, String> {
        let number = |word: &str| word.trim().parse::<f64>().ok().filter(|x| *x >= 0.0 && x.is_finite());
        let tolerance = match word.trim().strip_suffix("ulps").or(word.trim().strip_suffix("ulp")) {
            Some(ulps) => number(ulps).map(Self::Ulps),
            None => number(word).map(Self::Relative),
        };
        tolerance
            .ok_or_else(|| "a number of 0 or more for a relative tolerance, or one with ulp: 1e-6, 4ulp".to_owned())
    }
}

/// How far apart two values are: of a vector, in its component that is furthest apart.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Distance {
    /// The difference.
    pub absolute: f64,
    /// In units in the last place of the larger value, of a vector of its largest component.
    pub ulps: f64,
    /// As a share of the larger value, of a vector of its largest component.
    pub relative: f64,
    /// What tolerances measure it against; see [`Tolerances`].
    pub scale: f64,
}

impl Distance {
    /// Between two values of equally many components. The scale is the largest magnitude among all components of both, and
    /// `least` where that is larger.
    pub(super) fn between(a: &[f64], b: &[f64], least: f64) -> Self {
        let largest = a.iter().chain(b).fold(0.0_f64, |m, x| m.max(x.abs()));
        let absolute = a.iter().zip(b).map(|(a, b)| finite((a - b).abs())).fold(0.0, f64::max);
        let (ulps, relative) = match absolute > 0.0 {
            true => (finite(absolute / ulp(largest)), finite(absolute / largest)),
            false => (0.0, 0.0),
        };
        Self { absolute, ulps, relative, scale: largest.max(least) }
    }
}

/// The distance from a number above zero to the next smaller one.
fn ulp(x: f64) -> f64 {
    x - x.next_down()
}

/// The largest number for what is no number: JSON has none for it.
fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::MAX }
}

/// The tolerances of all fields that are numbers.
///
/// What a field is measured against, its scale: lengths (`origin`, `hit.point`) by the largest coordinate on the way from the
/// eye to them, ray parameters by the same in units of the direction, all others by 1; and by themselves where they are larger.
/// So a coordinate that is nearly 0 in a scene of size 10 may differ as much as one that is nearly 10.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Tolerances {
    /// Of all fields without one of their own.
    pub all: Tolerance,
    /// Of single fields.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub fields: BTreeMap<Field, Tolerance>,
}

impl Tolerances {
    /// Of two tracers in f64: forms of one formula differ by a few 1e-16, and each bounce off a curved surface multiplies that.
    pub const F64: Tolerance = Tolerance::Relative(1e-6);
    /// Where either tracer computes in f32.
    pub const F32: Tolerance = Tolerance::Relative(1e-3);

    /// The same for all fields.
    pub fn same(all: Tolerance) -> Self {
        Self { all, fields: BTreeMap::new() }
    }

    /// What suits two trees: [`Tolerances::F32`] where the settings of either say f32, else [`Tolerances::F64`].
    pub fn of(a: &RayTree, b: &RayTree) -> Self {
        let is_f32 = |tree: &RayTree| tree.settings.and_then(|s| s.precision) == Some(Precision::F32);
        Self::same(if is_f32(a) || is_f32(b) { Self::F32 } else { Self::F64 })
    }

    /// That of a field.
    pub fn of_field(&self, field: Field) -> Tolerance {
        self.fields.get(&field).copied().unwrap_or(self.all)
    }

    /// Sets that of one field, from `FIELD=TOLERANCE`: `hit.t=4ulp`, `radiance=1e-3`.
    ///
    /// # Errors
    /// What would be right.
    pub fn set(&mut self, words: &str) -> Result<(), String> {
        let (field, tolerance) = words.split_once('=').ok_or("FIELD=TOLERANCE: hit.t=4ulp, radiance=1e-3")?;
        let field: Field = field.trim().parse()?;
        if !field.is_number() {
            let numbers = Field::ALL.into_iter().filter(|field| field.is_number()).map(Field::name);
            return Err(format!("`{field}` agrees exactly or not at all; of numbers: {}", one_of(numbers)));
        }
        self.fields.insert(field, tolerance.parse()?);
        Ok(())
    }
}

impl Default for Tolerances {
    fn default() -> Self {
        Self::same(Self::F64)
    }
}

impl fmt::Display for Tolerances {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.all)?;
        self.fields.iter().try_for_each(|(field, tolerance)| write!(f, ", {field} {tolerance}"))
    }
}
