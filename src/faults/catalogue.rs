//! The catalogue: what each fault is called, and why it happens.

use std::fmt;

/// A classic fault: one wrong place in a ray tracer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Fault {
    /// `y` counted from the bottom.
    RowsFlipped,
    /// The tangent of a quarter of the field of view.
    FovHalvedTwice,
    /// The tangent of degrees.
    DegreesAsRadians,
    /// The corner of the pixel, not its centre.
    PixelCorner,
    /// Pixels as wide as the picture is high.
    AspectIgnored,
    /// `/ 2 * a` for `/ (2 * a)`.
    QuadraticPrecedence,
    /// The nearer root also from inside.
    EntryWhenInside,
    /// `b > 1` tested, not `a + b > 1`.
    ParallelogramForTriangle,
    /// `[b, c, a]` for `[a, b, c]`.
    BarycentricsPermuted,
    /// `(v2 - v0) x (v1 - v0)`.
    WindingReversed,
    /// Slabs not sorted along negative directions.
    SlabsUnsorted,
    /// A box behind the ray counts.
    BoxBehind,
    /// The last hit in the list, not the nearest.
    LastHitWins,
    /// A hit at the origin counts.
    HitAtOrigin,
    /// A sphere's normal of the length of its radius.
    NormalNotUnit,
    /// The normal points outward also inside.
    NormalNotFlipped,
    /// No shadow rays.
    NoShadowRays,
    /// The direction of a shadow ray is not normalised, its span is.
    ShadowPastLight,
    /// The span of a shadow ray has no end.
    ShadowUnbounded,
    /// The direction to the light is not normalised in shading.
    LightVectorNotUnit,
    /// A cosine below zero is not cut off.
    LightFromBehind,
    /// The light's colour is left out.
    LightColorIgnored,
    /// The ambient term is added for each light.
    AmbientPerLight,
    /// The highlight is computed with the ray's direction, not the way back.
    HighlightAway,
    /// `d + 2 (d.n) n`.
    ReflectSign,
    /// `n_t / n_i`.
    EtaInverted,
    /// At total reflection nothing goes on.
    TotalReflectionDropped,
    /// At total reflection the ray goes through, with a root of 0.
    TotalReflectionThrough,
    /// Schlick's formula with the cosine of the wrong side.
    SchlickWrongSide,
    /// `R` through and `1 - R` back.
    FresnelSwapped,
    /// The level is passed on as it is.
    LevelNotPassed,
    /// `level <= maxLevel`.
    LevelOneTooMany,
    /// The weight is multiplied to what was already added as well.
    ColorBeforeWeight,
}

impl Fault {
    /// All of them, from the camera to the colour.
    pub const ALL: [Fault; 33] = [
        Fault::RowsFlipped,
        Fault::FovHalvedTwice,
        Fault::DegreesAsRadians,
        Fault::PixelCorner,
        Fault::AspectIgnored,
        Fault::QuadraticPrecedence,
        Fault::EntryWhenInside,
        Fault::ParallelogramForTriangle,
        Fault::BarycentricsPermuted,
        Fault::WindingReversed,
        Fault::SlabsUnsorted,
        Fault::BoxBehind,
        Fault::LastHitWins,
        Fault::HitAtOrigin,
        Fault::NormalNotUnit,
        Fault::NormalNotFlipped,
        Fault::NoShadowRays,
        Fault::ShadowPastLight,
        Fault::ShadowUnbounded,
        Fault::LightVectorNotUnit,
        Fault::LightFromBehind,
        Fault::LightColorIgnored,
        Fault::AmbientPerLight,
        Fault::HighlightAway,
        Fault::ReflectSign,
        Fault::EtaInverted,
        Fault::TotalReflectionDropped,
        Fault::TotalReflectionThrough,
        Fault::SchlickWrongSide,
        Fault::FresnelSwapped,
        Fault::LevelNotPassed,
        Fault::LevelOneTooMany,
        Fault::ColorBeforeWeight,
    ];

    /// A short name, small letters with hyphens.
    pub const fn name(self) -> &'static str {
        self.words().0
    }

    /// What is wrong, in a few words.
    pub const fn title(self) -> &'static str {
        self.words().1
    }

    /// Why it happens, and what it should be, in a sentence or two.
    pub const fn why(self) -> &'static str {
        self.words().2
    }

    const fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::RowsFlipped => (
                "rows-flipped",
                "the rows of the picture are counted from the bottom",
                "Pixel 0,0 is top left and y runs down, while the camera's up runs up: the term is 1 - 2 (y + 0.5) / height.",
            ),
            Self::FovHalvedTwice => (
                "fov-halved-twice",
                "the field of view is halved twice",
                "Half the height of the picture at distance 1 is the tangent of half the angle; here the angle was halved once \
                 when it was read and once more in the tangent.",
            ),
            Self::DegreesAsRadians => (
                "degrees-as-radians",
                "the field of view is taken for radians",
                "The tangent wants radians: multiply the degrees by pi / 180 first.",
            ),
            Self::PixelCorner => (
                "pixel-corner",
                "the ray goes through the corner of the pixel",
                "The sample is in the middle of the pixel, x + 0.5 and y + 0.5; without the halves the picture is moved by half \
                 a pixel.",
            ),
            Self::AspectIgnored => (
                "aspect-ignored",
                "the aspect ratio is left out",
                "The field of view is that of the height; half the width is half the height times width / height, else a round \
                 ball becomes an egg.",
            ),
            Self::QuadraticPrecedence => (
                "quadratic-precedence",
                "t = ... / 2 * a",
                "A division and a multiplication are worked out from left to right: / 2 * a multiplies by a. It has to be \
                 / (2 * a), which shows as soon as the direction is not of length 1.",
            ),
            Self::EntryWhenInside => (
                "entry-when-inside",
                "from inside, the entry is taken, and rejected as behind the ray",
                "From inside a sphere or box the nearer root lies behind the origin; the hit is then the farther one. Without \
                 it no ray finds the way out of glass.",
            ),
            Self::ParallelogramForTriangle => (
                "parallelogram-for-triangle",
                "b > 1 is tested instead of a + b > 1",
                "a and b between 0 and 1 is a parallelogram; the triangle is where 1 - a - b is not negative either.",
            ),
            Self::BarycentricsPermuted => (
                "barycentrics-permuted",
                "the barycentric coordinates are in another order than the vertices",
                "[a, b, 1-a-b] are the weights of v0, v1, v2 in this order: p = a v0 + b v1 + (1-a-b) v2. At a vertex its own \
                 weight is 1.",
            ),
            Self::WindingReversed => (
                "winding-reversed",
                "the normal of triangles points the other way",
                "The normal is (v1 - v0) x (v2 - v0); a cross product with its factors exchanged has the other sign.",
            ),
            Self::SlabsUnsorted => (
                "slabs-unsorted",
                "min and max of a slab are not exchanged where the ray runs backwards",
                "Along a negative direction the plane at max comes first: t_in is the larger of the smaller ones, so the two \
                 have to be sorted on each axis.",
            ),
            Self::BoxBehind => (
                "box-behind",
                "t_out < 0 is not tested",
                "A box behind the ray has t_in <= t_out like any other, but both below zero: it is a miss if t_out < 0.",
            ),
            Self::LastHitWins => (
                "last-hit-wins",
                "the last object that is hit is taken, not the nearest",
                "Every hit replaces the one before it; it should only where its t is smaller.",
            ),
            Self::HitAtOrigin => (
                "hit-at-origin",
                "a ray hits the surface that it starts on",
                "The origin of the new ray was rounded, so its own surface is met at a t of about 0, sometimes a little above. \
                 Leave that surface out, or start a little beside it.",
            ),
            Self::NormalNotUnit => (
                "normal-not-unit",
                "the normal of spheres is not of length 1",
                "The point less the centre is as long as the radius; divide by it, or every scalar product with the normal is \
                 off by that.",
            ),
            Self::NormalNotFlipped => (
                "normal-not-flipped",
                "the normal is not turned round inside",
                "Inside, the outward normal points along the ray; shading, reflection and refraction want it against the ray.",
            ),
            Self::NoShadowRays => (
                "no-shadow-rays",
                "there are no shadow rays",
                "A light counts only where nothing lies between the surface and it, which takes a ray to each light.",
            ),
            Self::ShadowPastLight => (
                "shadow-past-light",
                "the shadow ray looks past the light",
                "The direction is the whole way to the light, so the light is at t = 1, but hits count up to t = distance. \
                 Normalise the direction, or end at 1.",
            ),
            Self::ShadowUnbounded => (
                "shadow-unbounded",
                "what lies behind the light blocks it",
                "A shadow ray ends at its light: hits count where t is smaller than the distance to it.",
            ),
            Self::LightVectorNotUnit => (
                "light-vector-not-unit",
                "the direction to the light is not normalised in shading",
                "n.l is a cosine only if both are of length 1; else it grows with the distance to the light.",
            ),
            Self::LightFromBehind => (
                "light-from-behind",
                "a light behind the surface takes light away",
                "n.l is negative where the surface faces away from the light; that light adds nothing, max(0, n.l).",
            ),
            Self::LightColorIgnored => (
                "light-color-ignored",
                "the colour of the light is left out",
                "Both terms are multiplied by the colour of the light, which shows as soon as that is not white.",
            ),
            Self::AmbientPerLight => (
                "ambient-per-light",
                "the ambient term is added once for each light",
                "It belongs before the loop over the lights, not inside.",
            ),
            Self::HighlightAway => (
                "highlight-away",
                "the highlight is on the wrong side",
                "r.v wants the way back to the eye, the negative of the ray's direction; with the direction itself it is \
                 negative where it should shine.",
            ),
            Self::ReflectSign => (
                "reflect-sign",
                "a wrong sign in the reflected direction",
                "The direction is d - 2 (d.n) n; d.n is negative, so that with a plus the ray goes on into the surface.",
            ),
            Self::EtaInverted => (
                "eta-inverted",
                "eta is the wrong way round",
                "Snell's law wants n_i / n_t, the medium that the ray comes from above the one it goes into; it bends towards \
                 the normal where it enters glass.",
            ),
            Self::TotalReflectionDropped => (
                "total-reflection-dropped",
                "total reflection brings nothing back",
                "Where the root has no real value nothing goes through, and all of it is reflected: the reflected ray takes \
                 that share.",
            ),
            Self::TotalReflectionThrough => (
                "total-reflection-through",
                "at total reflection a ray goes through all the same",
                "The value below the root was cut off at 0, which sends a ray along the surface; below 0 there is no refracted \
                 ray.",
            ),
            Self::SchlickWrongSide => (
                "schlick-wrong-side",
                "Schlick's formula with the cosine of the denser side",
                "Its cosine is that on the side of the smaller index: leaving glass, the one of the transmitted ray.",
            ),
            Self::FresnelSwapped => (
                "fresnel-swapped",
                "R goes through and 1 - R comes back",
                "R is the share that is reflected; what is transmitted is 1 - R.",
            ),
            Self::LevelNotPassed => (
                "level-not-passed",
                "the level is not passed on",
                "Each child is called with level + 1; with level itself the recursion ends only where the rays leave the scene.",
            ),
            Self::LevelOneTooMany => (
                "level-one-too-many",
                "the recursion goes one level too deep",
                "Children are traced where level < maxLevel, not where level <= maxLevel.",
            ),
            Self::ColorBeforeWeight => (
                "color-before-weight",
                "the weight is multiplied to the direct light as well",
                "The colour is direct + k * child; here it is k * (direct + child).",
            ),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl serde::Serialize for Fault {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (name, title, why) = self.words();
        serializer.collect_map([("name", name), ("title", title), ("why", why)])
    }
}
