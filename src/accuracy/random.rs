//! Random numbers, the same on every machine.

use glam::DVec3;

use crate::numbers::{Real, Vector3, flush_tiny, power_of_two};

/// SplitMix64 (Steele, Lea, Flood 2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In `0..n`, `n` not 0.
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Whether one of `n` equally likely things came about.
    pub fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In [-1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// In the cube [-scale, scale)^3.
    pub fn point(&mut self, scale: f64) -> DVec3 {
        self.vector(|g| scale * g.signed())
    }

    /// A unit vector, every direction equally likely.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let p = self.point(1.0);
            if (0.01..=1.0).contains(&p.length_squared()) {
                return p.normalize();
            }
        }
    }

    /// Integers in -4 ..= 4.
    pub fn small_integers(&mut self) -> DVec3 {
        self.vector(|g| g.below(9) as f64 - 4.0)
    }

    /// A number with an exponent in `-range ..= range`, now and then zero, a power of two or with few bits.
    pub fn wild(&mut self, range: i32) -> f64 {
        let exponent = self.below(2 * range as usize + 1) as i32 - range;
        let significand = match self.below(10) {
            0 => return 0.0,
            1..=3 => 1.0 + self.below(8) as f64 / 8.0,
            _ => 1.0 + self.unit(),
        };
        let sign = if self.one_in(2) { 1.0 } else { -1.0 };
        sign * significand * power_of_two(exponent)
    }

    /// Three of [`Random::wild`].
    pub fn wild_vector(&mut self, range: i32) -> DVec3 {
        self.vector(|g| g.wild(range))
    }

    /// A vector of three draws, x first.
    pub fn vector(&mut self, mut draw: impl FnMut(&mut Self) -> f64) -> DVec3 {
        let (x, y) = (draw(self), draw(self));
        DVec3::new(x, y, draw(self))
    }

    /// At most `n` units in the last place away from `x`.
    pub fn nudge<R: Real>(&mut self, x: R, n: usize) -> R {
        let ulps = self.below(2 * n + 1) as f64 - n as f64;
        R::from_f64(x.to_f64() + ulps * x.to_f64().abs() * 2.0 * R::UNIT_ROUNDOFF.to_f64())
    }
}

/// `v` as it is stored in the precision: rounded, components below 2^-126 as 0.
pub fn stored<R: Real>(v: DVec3) -> R::Vec3 {
    R::Vec3::from_f64(v.to_array().map(|x| flush_tiny(R::from_f64(x)).to_f64()))
}

/// `v` rounded to the precision, for going on with in f64.
pub fn rounded<R: Real>(v: DVec3) -> DVec3 {
    DVec3::from_array(stored::<R>(v).to_f64())
}
