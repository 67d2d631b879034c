//! Questions on reflection and refraction.

use glam::{DVec3, dvec3};

use super::{Kind, Part, Question, ROUNDING, one, tex, turned, vector};
use crate::accuracy::random::Random;
use crate::kernels::{fresnel_exact, reflect, refract, refraction_cosines};
use crate::lessons::words::shown;

/// Cosine and sine of angles, as short decimals.
const ANGLES: [[f64; 2]; 4] = [[0.8, 0.6], [0.6, 0.8], [0.96, 0.28], [0.28, 0.96]];
/// Indices of refraction: water, glass, heavy glass.
const INDICES: [f64; 5] = [1.25, 1.33, 1.5, 1.6, 2.0];

fn component((name, x): (&str, f64)) -> Part {
    Part::new(format!("the ${name}$ component of $r$"), x)
}

/// The reflected direction.
pub(super) fn reflection(random: &mut Random) -> Option<Question> {
    const NORMALS: [[f64; 3]; 3] = [[0.6, 0.8, 0.0], [0.28, 0.96, 0.0], [0.48, 0.64, 0.6]];
    let normal = one(random, &NORMALS);
    let [normal] = turned(random, [normal]);
    let direction = vector(random, 5);
    let reflected = reflect::<f64>(direction, normal);
    (direction.dot(normal) < -0.5).then(|| Question {
        kind: Kind::Reflection,
        given: format!(
            "A ray with direction $d = {}$ meets a mirror with the unit normal $n = {}$. It leaves with \
             direction $r$. {ROUNDING}",
            tex(direction),
            tex(normal)
        ),
        parts: [("x", reflected.x), ("y", reflected.y), ("z", reflected.z)].map(component).into(),
    })
}

/// Direction and normal, the indices on both sides, and that in words.
fn boundary(random: &mut Random) -> ([DVec3; 2], [f64; 2], String) {
    let [cosine, sine] = one(random, &ANGLES);
    let (side, index) = (if random.one_in(2) { 1.0 } else { -1.0 }, one(random, &INDICES));
    let indices = if random.one_in(3) { [index, 1.0] } else { [1.0, index] };
    let (direction, normal) = (dvec3(side * sine, -cosine, 0.0), dvec3(0.0, 1.0, 0.0));
    let given = format!(
        "A ray with the unit direction $d = {}$ meets a surface with the unit normal $n = {}$. It comes from a medium with \
         index of refraction $n_1 = {}$; behind the surface it is $n_2 = {}$.",
        tex(direction),
        tex(normal),
        shown(indices[0]),
        shown(indices[1])
    );
    ([direction, normal], indices, given)
}

/// The refracted direction.
pub(super) fn refraction(random: &mut Random) -> Option<Question> {
    let ([direction, normal], [incident, transmitted], given) = boundary(random);
    let refracted = refract::<f64>(direction, normal, incident, transmitted)?;
    let [_, cosine] = refraction_cosines::<f64>(direction, normal, incident, transmitted)?;
    Some(Question {
        kind: Kind::Refraction,
        given: format!("{given} {ROUNDING}"),
        parts: vec![
            Part::new("the cosine of the angle of refraction", cosine),
            Part::new("the $x$ component of the refracted unit direction", refracted.x),
            Part::new("its $y$ component", refracted.y),
        ],
    })
}

/// The Fresnel reflectance in percent.
pub(super) fn fresnel(random: &mut Random) -> Option<Question> {
    let ([direction, normal], [incident, transmitted], given) = boundary(random);
    let [cos_incident, cos_transmitted] = refraction_cosines::<f64>(direction, normal, incident, transmitted)?;
    let reflectance = fresnel_exact(cos_incident, cos_transmitted, incident, transmitted);
    Some(Question {
        kind: Kind::Fresnel,
        given: format!("{given} The light is not polarised. {ROUNDING}"),
        parts: vec![
            Part::new("the cosine of the angle of refraction", cos_transmitted),
            Part::new("the share of the light that is reflected, in percent", 100.0 * reflectance),
            Part::new("the share that is transmitted, in percent", 100.0 * (1.0 - reflectance)),
        ],
    })
}
