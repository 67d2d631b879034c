//! How a verdict was reached, and by what margin.

/// The arithmetic that settled a verdict, from the cheapest to the dearest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Stage {
    /// Plain `f64`: the value was larger than the bound on its error.
    Filter,
    /// Exact integers of up to 192 bits.
    Integer,
    /// Pairs of `f64`: the value was larger than the (much smaller) bound on its error.
    DoubleDouble,
    /// Exact sums of `f64`.
    Expansion,
}

impl Stage {
    /// All of them, the cheapest first.
    pub const ALL: [Self; 4] = [Self::Filter, Self::Integer, Self::DoubleDouble, Self::Expansion];
}

/// The stage that settled a verdict and the margin it had.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub struct Certificate {
    /// The dearest stage that any sign in the verdict called for.
    pub stage: Stage,
    /// The smallest of the values whose signs make the verdict, as a multiple of the filter's bound on its error:
    /// above 1 the filter decides, 0 is an exact tie.
    pub margin: f64,
}

impl Certificate {
    /// The certificate of a verdict that the filter left open. `margin` may come out a little above 1 where the value
    /// is known better than the filter knew it; it is then 1.
    pub(crate) fn after_filter(stage: Stage, margin: f64) -> Self {
        Certificate { stage, margin: margin.min(1.0) }
    }
}
