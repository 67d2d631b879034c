//! Questions on rays and shapes. Each is made backwards, from a hit with short numbers; the answers are the kernels'.

use glam::DVec3;

use super::{Kind, Part, Question, ROUNDING, integer, one, tex, turned, vector};
use crate::accuracy::random::Random;
use crate::kernels::{
    Start, TriangleFilter, intersect_box_certified, intersect_plane_certified, intersect_sphere_certified,
    intersect_triangle_certified,
};
use crate::lessons::words::shown;
use crate::lessons::{Aabb, Plane, Ray, Sphere, Triangle};

fn ray_words(ray: &Ray) -> String {
    format!("A ray starts at $o = {}$ with direction $d = {}$.", tex(ray.origin), tex(ray.direction))
}

/// Whether the numbers are ones to work with by hand.
fn is_short(values: impl IntoIterator<Item = f64>) -> bool {
    values.into_iter().all(|x| x.abs() <= 40.0 && (100.0 * x).fract() == 0.0)
}

/// D of the Hesse form, and t.
pub(super) fn plane(random: &mut Random) -> Option<Question> {
    const NORMALS: [[f64; 3]; 4] = [[0.6, 0.8, 0.0], [0.0, 1.0, 0.0], [0.48, 0.64, 0.6], [0.28, 0.96, 0.0]];
    // Two directions in the plane of each normal, in integers.
    const ALONG: [[[f64; 3]; 2]; 4] = [
        [[4.0, -3.0, 0.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        [[4.0, -3.0, 0.0], [5.0, 0.0, -4.0]],
        [[24.0, -7.0, 0.0], [0.0, 0.0, 1.0]],
    ];
    let i = random.below(NORMALS.len());
    let [normal, u, v] = turned(random, [NORMALS[i], ALONG[i][0], ALONG[i][1]]);
    let point = vector(random, 5);
    let hit = point + integer(random, -1, 1) * u + integer(random, -2, 2) * v;
    let direction = vector(random, 4);
    let ray = Ray { origin: hit - integer(random, 1, 4) * direction, direction };
    let plane = Plane { normal, distance: normal.dot(point) };
    let t = intersect_plane_certified(&ray, &plane).ok()?.t;
    is_short(ray.origin.to_array()).then(|| Question {
        kind: Kind::Plane,
        given: format!(
            "A plane goes through $q = {}$ and has the unit normal $n = {}$. {} {ROUNDING}",
            tex(point),
            tex(normal),
            ray_words(&ray)
        ),
        parts: vec![
            Part::new("$D$ in the plane's Hesse form $p \\cdot n - D = 0$", plane.distance),
            Part::new("the $t$ where the ray meets the plane", t),
        ],
    })
}

/// t and the barycentric coordinates.
pub(super) fn triangle(random: &mut Random) -> Option<Question> {
    const WEIGHTS: [[f64; 2]; 6] = [[0.25, 0.5], [0.5, 0.25], [0.25, 0.25], [0.2, 0.4], [0.4, 0.4], [0.6, 0.2]];
    let [a, b] = one(random, &WEIGHTS);
    let vertices = [0; 3].map(|_| random.vector(|random| integer(random, -5, 5)));
    let direction = vector(random, 3);
    let p = a * vertices[0] + b * vertices[1] + (1.0 - a - b) * vertices[2];
    // The decimals as they are read.
    let origin = (p - integer(random, 1, 4) * direction).to_array().map(|x| (x * 100.0).round() / 100.0);
    let (ray, triangle) = (Ray { origin: DVec3::from_array(origin), direction }, Triangle { vertices });
    let filter = TriangleFilter::of_triangle(&ray, &triangle);
    let hit = intersect_triangle_certified(&ray, &triangle, &filter).ok()?.hit;
    let [v0, v1, v2] = vertices.map(tex);
    is_short(origin).then(|| Question {
        kind: Kind::Triangle,
        given: format!(
            "A triangle has the corners $v_0 = {v0}$, $v_1 = {v1}$ and $v_2 = {v2}$. {} It meets the triangle at \
             $p = a v_0 + b v_1 + (1 - a - b) v_2$. {ROUNDING}",
            ray_words(&ray)
        ),
        parts: vec![
            Part::new("the $t$ where the ray meets the triangle", hit.t),
            Part::new("the weight $a$", hit.barycentrics[0]),
            Part::new("the weight $b$", hit.barycentrics[1]),
        ],
    })
}

/// The two t of a box.
pub(super) fn aabb(random: &mut Random) -> Option<Question> {
    const STEPS: [f64; 8] = [1.0, -1.0, 2.0, -2.0, 4.0, -4.0, 0.5, -0.5];
    let min = random.vector(|random| integer(random, -4, 3));
    let max = min + random.vector(|random| integer(random, 1, 5));
    let direction = random.vector(|random| one(random, &STEPS));
    let ray = Ray { origin: vector(random, 9), direction };
    let hit = intersect_box_certified(&ray, &Aabb { min, max }, Start::Anywhere).ok()?.hit;
    // A corner or an edge that is only touched is no question for a beginner.
    (0.0 < hit.t_in && hit.t_in < hit.t_out).then(|| Question {
        kind: Kind::Box,
        given: format!(
            "A box with faces along the axes has the opposite corners $p_{{min}} = {}$ and $p_{{max}} = {}$. {} {ROUNDING}",
            tex(min),
            tex(max),
            ray_words(&ray)
        ),
        parts: vec![
            Part::new("$t_{in}$, where the ray comes into the box", hit.t_in),
            Part::new("$t_{out}$, where it leaves it", hit.t_out),
        ],
    })
}

/// Both solutions of a sphere's equation, and the one that counts.
pub(super) fn sphere(random: &mut Random) -> Option<Question> {
    // Two directions of equal length at right angles, in integers, and that length.
    const FRAMES: [([[f64; 3]; 2], f64); 3] = [
        ([[1.0, 2.0, 2.0], [2.0, 1.0, -2.0]], 3.0),
        ([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], 1.0),
        ([[3.0, 4.0, 0.0], [4.0, -3.0, 0.0]], 5.0),
    ];
    // How far the centre is beside the ray, and the radius, in units of that length. Half the chord, the third side of a
    // right triangle, is then a short number too.
    const SIDES: [[f64; 2]; 4] = [[0.0, 1.0], [0.6, 1.0], [3.0, 5.0], [1.5, 2.5]];
    let (frame, length) = one(random, &FRAMES);
    let [direction, beside] = turned(random, frame);
    let [offset, radius] = one(random, &SIDES);
    let origin = vector(random, 5);
    let center = origin + integer(random, -2, 6) * direction + offset * beside;
    let (ray, sphere) = (Ray { origin, direction }, Sphere { center, radius: radius * length });
    let hit = intersect_sphere_certified(&ray, &sphere, Start::Anywhere).ok()?.hit;
    (is_short(center.to_array()) && hit.t > 0.0 && hit.t_in != 0.0).then(|| Question {
        kind: Kind::Sphere,
        given: format!(
            "A sphere has the centre $c = {}$ and the radius $r = {}$. {} {ROUNDING}",
            tex(center),
            shown(sphere.radius),
            ray_words(&ray)
        ),
        parts: vec![
            Part::new("the smaller solution of the quadratic equation for $t$", hit.t_in),
            Part::new("the larger solution", hit.t_out),
            Part::new("the $t$ of the first point of the ray, $t \\ge 0$, that is on the sphere", hit.t),
        ],
    })
}
