//! Questions on vectors.

use super::{Kind, Part, Question, ROUNDING, one, tex, turned, vector};
use crate::accuracy::random::Random;

/// Vectors of integers whose length is one.
const INTEGER_LENGTH: [[f64; 3]; 6] =
    [[3.0, 4.0, 0.0], [1.0, 2.0, 2.0], [2.0, 3.0, 6.0], [4.0, 4.0, 7.0], [1.0, 4.0, 8.0], [5.0, 12.0, 0.0]];

/// The scalar product, and the projection of a on b.
pub(super) fn projection(random: &mut Random) -> Option<Question> {
    let a = vector(random, 6);
    let b = one(random, &INTEGER_LENGTH);
    let [b] = turned(random, [b]);
    let dot = a.dot(b);
    (dot != 0.0).then(|| Question {
        kind: Kind::Projection,
        given: format!("Let $a = {}$ and $b = {}$. {ROUNDING}", tex(a), tex(b)),
        parts: vec![
            Part::new("the scalar product $a \\cdot b$", dot),
            Part::new("the length of $b$", b.length()),
            Part::new(
                "the length of the projection of $a$ on $b$, negative where it points against $b$",
                dot / b.length(),
            ),
        ],
    })
}

/// The components of a cross product.
pub(super) fn cross(random: &mut Random) -> Option<Question> {
    let (a, b) = (vector(random, 5), vector(random, 5));
    let c = a.cross(b);
    let component = |(name, x)| Part::new(format!("the {name} component of $a \\times b$"), x);
    (c.to_array().iter().all(|x| *x != 0.0)).then(|| Question {
        kind: Kind::Cross,
        given: format!("Let $a = {}$ and $b = {}$.", tex(a), tex(b)),
        parts: [("$x$", c.x), ("$y$", c.y), ("$z$", c.z)].into_iter().map(component).collect(),
    })
}
