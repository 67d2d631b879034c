//! Closed surfaces hold: no ray from inside gets out, none passes through a square of many triangles.

use glam::DVec3;
use raytree::accuracy::leaks::{Aim, FAR_AWAY, Leaks, Square, bumpy_sphere, from_inside, through_square};
use raytree::numbers::Real;
use raytree::scene::Numerics;
use raytree::scene::mesh::{MeshData, Solidity, solidity};

#[test]
fn the_bumpy_sphere_is_closed() {
    let triangles = bumpy_sphere(14);
    assert_eq!(triangles.len(), 2352);
    let positions = triangles.iter().flatten().map(DVec3::to_array).collect();
    let faces = (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    assert_eq!(solidity(&MeshData { positions, faces, corner_normals: None }), Solidity::Solid);
}

fn inside<R: Real>(numerics: Numerics, center: DVec3, count: usize) -> [Leaks; 3] {
    let leaks = from_inside::<R>(numerics, center, count, 61);
    let place = if center == DVec3::ZERO { "here" } else { "far away" };
    for (aim, Leaks { rays, leaked }) in Aim::ALL.into_iter().zip(leaks) {
        println!("{numerics} {} {place}, {}: {leaked} of {rays} leak", R::PRECISION, aim.name());
    }
    leaks
}

fn nothing_gets_out<R: Real>() {
    for center in [DVec3::ZERO, FAR_AWAY] {
        for leaks in inside::<R>(Numerics::Certified, center, 100_000) {
            assert_eq!(leaks, Leaks { rays: 50_000, leaked: 0 });
        }
    }
}

#[test]
fn no_ray_gets_out_of_a_closed_mesh_f64() {
    nothing_gets_out::<f64>();
}

#[test]
fn no_ray_gets_out_of_a_closed_mesh_f32() {
    nothing_gets_out::<f32>();
}

/// That these rays are hard: the plain kernels let some through as soon as one is aimed, and far away the lecture's even
/// one that is not.
#[test]
fn naive_rays_get_out_of_a_closed_mesh() {
    for center in [DVec3::ZERO, FAR_AWAY] {
        let [_, vertices, edges] = inside::<f32>(Numerics::Robust, center, 20_000);
        assert!(vertices.leaked + edges.leaked > 200, "{vertices:?} {edges:?}");
        for lecture in [inside::<f32>, inside::<f64>] {
            let [anywhere, vertices, edges] = lecture(Numerics::Lecture, center, 20_000);
            assert!(vertices.leaked > 400 && edges.leaked > 400, "{vertices:?} {edges:?}");
            assert!(anywhere.leaked < vertices.leaked, "{anywhere:?} {vertices:?}");
        }
    }
}

fn square<R: Real>(numerics: Numerics, square: Square) -> Leaks {
    let leaks = through_square::<R>(numerics, square);
    println!("{numerics} {} {} square: {} of {} leak", R::PRECISION, square.name(), leaks.leaked, leaks.rays);
    leaks
}

#[test]
fn every_ray_at_a_square_of_many_triangles_hits() {
    for (each, rays) in [(Square::Upright, 3 << 16), (Square::Leaning, 3 << 16), (Square::Turned, 195_330)] {
        for certified in [square::<f32>, square::<f64>] {
            assert_eq!(certified(Numerics::Certified, each), Leaks { rays, leaked: 0 });
        }
    }
}

#[test]
fn naive_rays_pass_through_a_square_of_many_triangles() {
    for numerics in [Numerics::Lecture, Numerics::Robust] {
        for each in [square::<f32>, square::<f64>] {
            let leaks = each(numerics, Square::Turned);
            assert!(leaks.leaked > leaks.rays / 100, "{numerics} {leaks:?}");
        }
    }
}
