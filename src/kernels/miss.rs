//! Why a ray does not hit a shape.

/// The reason a kernel gives for a miss.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Miss {
    /// The ray runs along the plane, in it or beside it; for triangles also: the triangle has no area.
    Parallel,
    /// The hit lies at `t < 0`.
    Behind,
    /// Barycentric `a < 0`: outside the edge opposite v0.
    AIsNegative,
    /// Barycentric `b < 0`: outside the edge opposite v1.
    BIsNegative,
    /// Barycentric `1 - a - b < 0`: outside the edge opposite v2.
    SumExceedsOne,
    /// The slabs' spans do not meet: `t_in > t_out`.
    SlabsDisjoint,
    /// The ray's line passes the sphere: the discriminant is negative.
    NegativeDiscriminant,
}
