//! The scalar every kernel is generic over: `f32` with [`glam::Vec3`], or `f64` with [`glam::DVec3`].

use std::fmt::{Debug, Display};
use std::ops::{Add, Div, Mul, Neg, Sub};

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// The two precisions a scene can be traced in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Precision {
    /// IEEE 754 binary32, unit roundoff 2^-24.
    F32,
    /// IEEE 754 binary64, unit roundoff 2^-53.
    F64,
}

impl Display for Precision {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        })
    }
}

impl Precision {
    /// Coordinates of a scene, and components of a ray, are at most this in magnitude, so that their squares and
    /// products stay finite: 2^60 for f32, and the 2^128 of [`is_in_range`](super::is_in_range) for f64.
    pub fn largest_coordinate(self) -> f64 {
        match self {
            Self::F32 => (1_u64 << 60) as f64,
            Self::F64 => 2.0 * (1_u128 << 127) as f64,
        }
    }

    /// The largest component of a direction is at least this, so that its square is not lost: 2^-60 for f32, 2^-126 for
    /// f64.
    pub fn smallest_direction(self) -> f64 {
        match self {
            Self::F32 => 1.0 / (1_u64 << 60) as f64,
            Self::F64 => f64::from(f32::MIN_POSITIVE),
        }
    }

    /// The number of this precision that is nearest to `x`, ties to even.
    pub fn round(self, x: f64) -> f64 {
        match self {
            Self::F32 => f64::from(x as f32),
            Self::F64 => x,
        }
    }

    /// The largest finite number.
    pub fn largest(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::MAX),
            Self::F64 => f64::MAX,
        }
    }
}

/// An IEEE 754 number, `f32` or `f64`, and the vector made of three of them.
///
/// Only operations that IEEE 754 rounds correctly are here, so that every platform computes the same bits.
pub trait Real:
    sealed::Sealed
    + Copy
    + PartialOrd
    + Debug
    + Display
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Three of these numbers.
    type Vec3: Vector3<Self>;
    /// Which of the two this is.
    const PRECISION: Precision;
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Two.
    const TWO: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// Unit roundoff `u`: a correctly rounded operation is exact to a factor `1 + e`, `|e| <= u`.
    const UNIT_ROUNDOFF: Self;
    /// The number nearest to `x`, ties to even.
    fn from_f64(x: f64) -> Self;
    /// This number as an `f64`, exactly.
    fn to_f64(self) -> f64;
    /// The correctly rounded square root; NaN below zero.
    fn sqrt(self) -> Self;
    /// The next larger number.
    fn next_up(self) -> Self;
    /// The next smaller number.
    fn next_down(self) -> Self;
    /// The magnitude.
    fn abs(self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// The smaller of two numbers, `other` where they are equal or one is NaN.
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    /// The larger of two numbers, `other` where they are equal or one is NaN.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}

/// What the kernels ask of a vector of three [`Real`]s.
pub trait Vector3<R>:
    Copy
    + PartialEq
    + Debug
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<R, Output = Self>
    + Neg<Output = Self>
{
    /// The vector (x, y, z).
    fn new(x: R, y: R, z: R) -> Self;
    /// The scalar product `x x' + y y' + z z'`, summed from the left.
    fn dot(self, other: Self) -> R;
    /// The vector product.
    fn cross(self, other: Self) -> Self;
    /// The components.
    fn to_array(self) -> [R; 3];
    /// The vector nearest to `v`, component by component.
    fn from_f64(v: [f64; 3]) -> Self;
    /// The components as `f64`, exactly.
    fn to_f64(self) -> [f64; 3];
}

impl Real for f32 {
    type Vec3 = glam::Vec3;
    const PRECISION: Precision = Precision::F32;
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const TWO: Self = 2.0;
    const INFINITY: Self = f32::INFINITY;
    const UNIT_ROUNDOFF: Self = f32::EPSILON / 2.0;
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        x as f32
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    #[inline(always)]
    fn next_up(self) -> Self {
        f32::next_up(self)
    }
    #[inline(always)]
    fn next_down(self) -> Self {
        f32::next_down(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.is_finite()
    }
}

impl Real for f64 {
    type Vec3 = glam::DVec3;
    const PRECISION: Precision = Precision::F64;
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const TWO: Self = 2.0;
    const INFINITY: Self = f64::INFINITY;
    const UNIT_ROUNDOFF: Self = f64::EPSILON / 2.0;
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    #[inline(always)]
    fn next_up(self) -> Self {
        f64::next_up(self)
    }
    #[inline(always)]
    fn next_down(self) -> Self {
        f64::next_down(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.is_finite()
    }
}

impl Vector3<f32> for glam::Vec3 {
    #[inline(always)]
    fn new(x: f32, y: f32, z: f32) -> Self {
        glam::Vec3::new(x, y, z)
    }
    #[inline(always)]
    fn dot(self, other: Self) -> f32 {
        glam::Vec3::dot(self, other)
    }
    #[inline(always)]
    fn cross(self, other: Self) -> Self {
        glam::Vec3::cross(self, other)
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 3] {
        glam::Vec3::to_array(&self)
    }
    #[inline(always)]
    fn from_f64(v: [f64; 3]) -> Self {
        glam::Vec3::new(v[0] as f32, v[1] as f32, v[2] as f32)
    }
    #[inline(always)]
    fn to_f64(self) -> [f64; 3] {
        [f64::from(self.x), f64::from(self.y), f64::from(self.z)]
    }
}

impl Vector3<f64> for glam::DVec3 {
    #[inline(always)]
    fn new(x: f64, y: f64, z: f64) -> Self {
        glam::DVec3::new(x, y, z)
    }
    #[inline(always)]
    fn dot(self, other: Self) -> f64 {
        glam::DVec3::dot(self, other)
    }
    #[inline(always)]
    fn cross(self, other: Self) -> Self {
        glam::DVec3::cross(self, other)
    }
    #[inline(always)]
    fn to_array(self) -> [f64; 3] {
        glam::DVec3::to_array(&self)
    }
    #[inline(always)]
    fn from_f64(v: [f64; 3]) -> Self {
        glam::DVec3::from_array(v)
    }
    #[inline(always)]
    fn to_f64(self) -> [f64; 3] {
        glam::DVec3::to_array(&self)
    }
}
