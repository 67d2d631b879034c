//! What a certified kernel gives back.

/// A hit whose verdict is exactly right for the ray and the shape as stored, with `t` and a proven bound on its error.
///
/// # Ranges
///
/// The claim holds where every stored number is one that [`is_in_range`](crate::numbers::is_in_range) accepts and the
/// direction is not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certified<H> {
    /// The hit in the precision of the ray; its `t` is [`Certified::t`], rounded.
    pub hit: H,
    /// Ray parameter in f64, whatever the precision of the ray; `t >= 0`, finite.
    pub t: f64,
    /// `|t - exact t| <= t_error`, finite.
    pub t_error: f64,
}

/// The largest relative error of `t`, 2^-36, that a filter's `t` is taken with; where the bound on it is worse the
/// stages after the filter give a `t` that is good to a few ulp. The bound itself where no tighter one is worth its price.
pub(crate) const FILTER_ACCURACY: f64 = 1.0 / (1u64 << 36) as f64;
