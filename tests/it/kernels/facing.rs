//! Which way a ray crosses a flat surface, and the normals of thin triangles, against rationals.

use glam::DVec3;
use raytree::kernels::{Plane, Ray, Triangle, plane_facing, triangle_facing, triangle_normal};

use raytree::accuracy::random::Random;
use raytree::accuracy::referee::{cross, dot, q, sign, subtract, vector};

fn any(rng: &mut Random) -> DVec3 {
    rng.point(1.0)
}

/// A direction as good as perpendicular to `n`, as far as rounding lets it.
fn across(rng: &mut Random, n: DVec3) -> DVec3 {
    n.cross(any(rng))
}

#[test]
fn the_side_of_a_plane_or_triangle_is_exact() {
    let mut rng = Random::new(11);
    let (mut rounded_wrong, mut along) = (0, 0);
    for _ in 0..20_000 {
        let normal = any(&mut rng).normalize();
        let ray = Ray::<f64> { origin: any(&mut rng), direction: across(&mut rng, normal) };
        let truth = sign(&dot(&vector::<f64>(ray.direction), &vector::<f64>(normal)));
        assert_eq!(plane_facing(&ray, &Plane { normal, distance: 0.5 }) as i32, truth);
        rounded_wrong += i32::from((ray.direction.dot(normal) < 0.0) != (truth < 0));

        let vertices = [any(&mut rng), any(&mut rng), any(&mut rng)];
        let (e1, e2) = (vertices[1] - vertices[0], vertices[2] - vertices[0]);
        // In the triangle's plane, up to rounding; one time in four exactly along an edge.
        let direction = if rng.below(4) == 0 { e1 } else { e1 * rng.signed() + e2 * rng.signed() };
        let ray = Ray::<f64> { origin: any(&mut rng), direction };
        let corners = vertices.map(vector::<f64>);
        let exact = cross(&subtract(&corners[1], &corners[0]), &subtract(&corners[2], &corners[0]));
        let truth = sign(&dot(&vector::<f64>(direction), &exact));
        assert_eq!(triangle_facing(&ray, &Triangle { vertices }) as i32, truth);
        along += i32::from(truth == 0);
    }
    assert!(rounded_wrong > 1000, "the set is not hard: {rounded_wrong}");
    assert!(along > 10, "{along}");
}

#[test]
fn needles_have_the_right_normal() {
    let mut rng = Random::new(12);
    for i in 0..5000 {
        let (v0, along) = (any(&mut rng), any(&mut rng));
        // From fat to as thin as 2^-60 of its length: far below what a cross product in f64 can tell.
        let thin = any(&mut rng) * 2.0_f64.powi(-(i % 61));
        let vertices = [v0, v0 + along, v0 + along * rng.signed() + thin];
        let triangle = Triangle::<f64> { vertices };
        let corners = vertices.map(vector::<f64>);
        let exact = cross(&subtract(&corners[1], &corners[0]), &subtract(&corners[2], &corners[0]));
        let normal = triangle_normal(&triangle);
        if exact.iter().all(|x| sign(x) == 0) {
            assert_eq!(normal, DVec3::ZERO);
            continue;
        }
        // Parallel: the cross product of both is small beside them; and not turned round.
        let computed = vector::<f64>(normal);
        let (off, length) = (cross(&computed, &exact), dot(&exact, &exact));
        assert!(dot(&off, &off) <= q(2.0_f64.powi(-50)) * length, "{triangle:?}");
        assert_eq!(sign(&dot(&computed, &exact)), 1);
        assert!((normal.length() - 1.0).abs() < 1e-15);
    }
}
