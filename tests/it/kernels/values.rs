//! Intermediate values replay to the bits of the kernels.

use raytree::kernels::*;
use raytree::numbers::Real;

use raytree::accuracy::random::{Random, stored};
use raytree::accuracy::sets::TriangleSet;

/// Equal, or both NaN.
fn same<R: Real>(a: R, b: R) {
    let (a, b) = (a.to_f64(), b.to_f64());
    assert!(a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()), "{a} {b}");
}

fn check_triangles<R: Real>() {
    let mut hits = [0; 3];
    for set in TriangleSet::ALL {
        let mut g = Random::new(61);
        for _ in 0..1000 {
            let (ray, triangle) = set.next::<R>(&mut g);
            let values = triangle_moller_trumbore_values(&ray, &triangle);
            let inside = values.u >= R::ZERO && values.v >= R::ZERO && values.w >= R::ZERO && values.t >= R::ZERO;
            let hit = intersect_triangle_moller_trumbore(&ray, &triangle);
            assert_eq!(hit.is_ok(), inside && values.det != R::ZERO);
            if let Ok(hit) = hit {
                same(hit.t, values.t);
                [values.w, values.u, values.v].into_iter().zip(hit.barycentrics).for_each(|(a, b)| same(a, b));
                hits[0] += 1;
            }
            let values = triangle_watertight_values(&ray, &triangle);
            if let Ok(hit) = intersect_triangle_watertight(&ray, &triangle) {
                same(hit.t, values.t);
                [values.w, values.u, values.v].into_iter().zip(hit.barycentrics).for_each(|(a, b)| same(a, b));
                hits[1] += 1;
            }
            let values = triangle_lecture_values(&ray, &triangle);
            let hit = intersect_triangle_lecture(&ray, &triangle);
            let inside = values.a >= R::ZERO && values.b >= R::ZERO && values.c >= R::ZERO && values.t >= R::ZERO;
            assert_eq!(hit.is_ok(), inside && values.n_dot_d != R::ZERO);
            if let Ok(hit) = hit {
                same(hit.t, values.t);
                [values.a, values.b, values.c].into_iter().zip(hit.barycentrics).for_each(|(a, b)| same(a, b));
                hits[2] += 1;
            }
        }
    }
    assert!(hits.iter().all(|count| *count > 1000), "{hits:?}");
}

fn check_the_others<R: Real>() {
    let mut g = Random::new(67);
    let mut hits = 0;
    for i in 0..20_000 {
        let integers = i % 4 == 0;
        let mut vector = || stored::<R>(if integers { g.small_integers() } else { g.point(2.0) });
        let ray = Ray::<R> { origin: vector(), direction: vector() };
        let plane = Plane::<R> { normal: vector(), distance: R::ONE };
        let values = plane_values(&ray, &plane);
        if let Ok(hit) = intersect_plane_lecture(&ray, &plane) {
            same(hit.t, values.t);
        }
        let aabb = Aabb::<R>::of_points(&[vector(), vector()]);
        for start in [Start::Anywhere, Start::OnSurfaceInward] {
            let (lecture, explicit) = (box_lecture_values(&ray, &aabb), box_explicit_zero_values(&ray, &aabb));
            for (values, hit) in [
                (lecture, intersect_box_lecture(&ray, &aabb, start)),
                (explicit, intersect_box_explicit_zero(&ray, &aabb, start)),
            ] {
                if let Ok(hit) = hit {
                    same(hit.t_in, values.t_in);
                    same(hit.t_out, values.t_out);
                    if hit.t.is_finite() {
                        same(hit.t, values.t[hit.face as usize]);
                    }
                    hits += 1;
                }
            }
        }
        let sphere = Sphere::<R> { center: vector(), radius: R::TWO };
        let (naive, stable) = (sphere_naive_values(&ray, &sphere), sphere_values(&ray, &sphere));
        let hit = intersect_sphere_naive(&ray, &sphere, Start::Anywhere);
        assert_eq!(hit.is_ok(), naive.disc >= R::ZERO && naive.t_out >= R::ZERO);
        if let Ok(hit) = hit {
            same(hit.t_in, naive.t_in);
            same(hit.t_out, naive.t_out);
        }
        let hit = intersect_sphere_stable(&ray, &sphere, Start::Anywhere);
        assert_eq!(hit.is_ok(), stable.disc >= R::ZERO && stable.t_out >= R::ZERO);
        if let Ok(hit) = hit {
            same(hit.t_in, stable.t_in);
            same(hit.t_out, stable.t_out);
            hits += 1;
        }
    }
    assert!(hits > 10_000, "{hits}");
}

#[test]
fn intermediate_values_replay_to_the_same_bits() {
    check_triangles::<f32>();
    check_triangles::<f64>();
    check_the_others::<f32>();
    check_the_others::<f64>();
}
