//! The numbers that the pages work out by hand are those of the solutions.

use glam::{DVec3, dvec2, dvec3};
use raytree::kernels::triangle_lecture_values;
use raytree::lessons::{Light, LightKind, Material, Plane, Ray, Rgb, Span, Sphere, Triangle, shown};

use super::aabb::solution as boxes;
use super::plane::solution as planes;
use super::reflection::solution as reflections;
use super::refraction::solution as refractions;
use super::shadows::solution as shadows;
use super::sphere::solution as spheres;
use super::trace::solution as traces;
use super::triangle::solution as triangles;
use super::vectors::solution as vectors;

/// Requires that a page says each of these, blanks and line ends aside.
fn says(folder: &str, fragments: &[String]) {
    let page = std::fs::read_to_string(format!("lessons/{folder}/README.md")).unwrap();
    let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    for fragment in fragments {
        assert!(flat(&page).contains(&flat(fragment)), "{folder} does not say: {fragment}");
    }
}

fn vector(v: DVec3) -> String {
    format!("({})", v.to_array().map(shown).join(", "))
}

#[test]
fn lesson_01() {
    let (a, b) = (dvec3(2.0, 3.0, 0.0), dvec3(4.0, 0.0, 0.0));
    let (c, d) = (dvec3(1.0, 2.0, 3.0), dvec3(4.0, 5.0, 6.0));
    let p = vectors::project(a, b);
    let rest = a - p;
    let area = vectors::length(vectors::cross(b, dvec3(0.0, 3.0, 0.0)));
    assert_eq!(vectors::dot(dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)), 0.0);
    assert_eq!(vectors::cross(dvec3(1.0, 2.0, 2.0), dvec3(2.0, 4.0, 4.0)), DVec3::ZERO);
    says(
        "01-vectors",
        &[
            format!(r"$2 \cdot 4 + 3 \cdot 0 + 0 \cdot 0 = {}$", shown(vectors::dot(a, b))),
            format!(r"the shadow is $8 / 4 = {}$ long", shown(vectors::length(p))),
            format!(r"$(1, 2, 2)$ is $\sqrt{{1 + 4 + 4}} = {}$", shown(vectors::length(dvec3(1.0, 2.0, 2.0)))),
            format!(r"$\frac{{8}}{{{}}} \cdot (4, 0, 0) = {}$", shown(vectors::dot(b, b)), vector(p)),
            format!("= {}$.", vector(vectors::cross(c, d))),
            format!(r"$(4, 0, 0) \times (0, 3, 0) = {}$", vector(vectors::cross(b, dvec3(0.0, 3.0, 0.0)))),
            format!("its length is {}, so the area is {}.", shown(area), shown(area / 2.0)),
            format!(r"$(2, 3, 0) - (2, 0, 0) = {}$", vector(rest)),
            format!(r"$(0, 3, 0) \cdot (4, 0, 0) = {}$", shown(vectors::dot(rest, b))),
        ],
    );
}

#[test]
fn lesson_02() {
    let slope = planes::plane_from(dvec3(5.0, 0.0, 0.0), dvec3(3.0, 4.0, 0.0));
    let floor = |distance| Plane { normal: DVec3::Y, distance };
    let distance = |y: f64| shown(planes::signed_distance(dvec3(4.0, y, 1.0), &floor(2.0)));
    let ray = Ray { origin: dvec3(0.0, 3.0, 0.0), direction: dvec3(1.0, -2.0, 0.0) };
    let t = planes::intersect(&ray, &floor(1.0)).unwrap();
    let long = Plane { normal: 2.0 * DVec3::Y, distance: 4.0 };
    assert_eq!(planes::intersect(&ray, &long), planes::intersect(&ray, &floor(2.0)));
    says(
        "02-plane",
        &[
            format!(r"$\mathbf{{n}} = {}$", vector(slope.normal)),
            format!(r"$D = 5 \cdot 0.6 = {}$", shown(slope.distance)),
            format!("the distance $5 - 2 = {}$", distance(5.0)),
            format!("has $1 - 2 = {}$", distance(1.0)),
            format!("$t = (1 - 3) / (-2) = {}$, so it is hit at ${}$", shown(t), vector(ray.at(t))),
            format!(
                "$10 - 4 = {}$ instead of {}",
                shown(planes::signed_distance(dvec3(4.0, 5.0, 1.0), &long)),
                distance(5.0)
            ),
        ],
    );
}

#[test]
fn lesson_03() {
    let (v0, v1, v2) = (DVec3::ZERO, dvec3(4.0, 0.0, 0.0), dvec3(0.0, 4.0, 0.0));
    let triangle = Triangle { vertices: [v0, v1, v2] };
    let p = dvec3(2.0, 1.0, 0.0);
    let n = (v1 - v0).cross(v2 - v0);
    let small = (v2 - v1).cross(p - v1);
    let [a, b, c] = triangles::weights(p, &triangle);
    let middle = triangles::weights(dvec3(2.0, 0.0, 0.0), &triangle);
    let beyond = triangles::weights(dvec3(5.0, 0.0, 0.0), &triangle);
    let third = |pixel: &str| {
        let loaded = raytree::scene::load_file("scenes/triangle.json").unwrap();
        let (_, [x, y]) = loaded.scene.pixels.iter().find(|(name, _)| name == pixel).unwrap();
        let tracer = crate::support::tracer::<f64>(&loaded.scene);
        let tree = crate::support::tree(&tracer, &loaded, [*x, *y], raytree::tree::Keep::Steps);
        let raytree::scene::Shape::Triangle { vertices } = loaded.scene.objects[0].shape else { panic!() };
        let ray = Ray { origin: tree.root.origin.into(), direction: tree.root.direction.into() };
        triangle_lecture_values(&ray, &Triangle { vertices }).c
    };
    says(
        "03-triangle",
        &[
            format!("The normal is ${}$", vector(n)),
            format!(r"$\mathbf{{n}} \cdot \mathbf{{n}} = {}$", shown(n.dot(n))),
            format!(r"${} \times {} = {}$", vector(v2 - v1), vector(p - v1), vector(small)),
            format!(r"times $\mathbf{{n}}$ is {}, so $a = 64 / 256 = {}$", shown(small.dot(n)), shown(a)),
            format!("$b = {}$, and the third weight is $1 - 0.25 - 0.5 = {}$", shown(b), shown(c)),
            format!(r"\cdot (0, 4, 0) = {}$", vector(a * v0 + b * v1 + c * v2)),
            format!("$a = {}$, $b = {}$ and $1 - a - b = {}$", shown(middle[0]), shown(middle[1]), shown(middle[2])),
            format!("$a = {}$, $b = {}$", shown(beyond[0]), shown(beyond[1])),
            format!(
                "$1 - a - b$ is {:.4} for the one and ${:.4}$ for the other",
                third("just inside"),
                third("just outside")
            ),
        ],
    );
}

#[test]
fn lesson_04() {
    let told = |Span { t_in, t_out }: Span| (shown(t_in), shown(t_out));
    let (first, last) = told(boxes::slab(6.0, -1.0, 2.0, 5.0));
    let (min, max) = (dvec2(2.0, 1.0), dvec2(6.0, 3.0));
    let spans = |o: [f64; 2], d: [f64; 2]| [0, 1].map(|k| told(boxes::slab(o[k], d[k], min[k], max[k])));
    let [x, y] = spans([0.0, 1.0], [2.0, 0.5]);
    let (both_in, both_out) = told(boxes::rectangle(dvec2(0.0, 1.0), dvec2(2.0, 0.5), min, max).unwrap());
    let [u, v] = spans([0.0, 2.0], [1.0, 1.0]);
    assert_eq!(boxes::rectangle(dvec2(0.0, 2.0), dvec2(1.0, 1.0), min, max), None);
    says(
        "04-box",
        &[
            format!("$(2 - 6) / (-1) = {last}$ and $(5 - 6) / (-1) = {first}$"),
            format!("$t_{{in}} = {first}$ to $t_{{out}} = {last}$"),
            format!("x from {} to {}, y from {} to {}. Both from {both_in} to {both_out}", x.0, x.1, y.0, y.1),
            format!("x from {} to {}, y from ${}$ to {}.", u.0, u.1, v.0, v.1),
            format!("At $t = {}$ it leaves the y slab, at $t = {}$ it comes into the x slab", v.1, u.0),
        ],
    );
    // d_x = 0 does what the page says it does.
    assert_eq!(boxes::slab(6.0, 0.0, 2.0, 5.0), Span { t_in: f64::NEG_INFINITY, t_out: f64::NEG_INFINITY });
    assert_eq!(boxes::slab(3.0, 0.0, 2.0, 5.0), Span { t_in: f64::NEG_INFINITY, t_out: f64::INFINITY });
}

#[test]
fn lesson_05() {
    let ray = Ray { origin: dvec3(-5.0, 0.0, 0.0), direction: dvec3(2.0, 0.0, 0.0) };
    let sphere = Sphere { center: DVec3::ZERO, radius: 1.0 };
    let [a, b, c] = spheres::coefficients(&ray, &sphere);
    let Span { t_in, t_out } = spheres::roots(a, b, c).unwrap();
    let inner = Ray { origin: DVec3::ZERO, direction: dvec3(0.0, 4.0, 0.0) };
    let [p, q, r] = spheres::coefficients(&inner, &Sphere { radius: 2.0, ..sphere });
    let inside = spheres::roots(p, q, r).unwrap();
    says(
        "05-sphere",
        &[
            format!("$a = {}$, $b = {}$, $c = {}$.", shown(a), shown(b), shown(c)),
            format!("${} - {} = {}$", shown(b * b), shown(4.0 * a * c), shown(b * b - 4.0 * a * c)),
            format!("$t_{{in}} = (20 - 4) / 8 = {}$, $t_{{out}} = (20 + 4) / 8 = {}$", shown(t_in), shown(t_out)),
            format!("comes in at ${}$ and goes out at ${}$", vector(ray.at(t_in)), vector(ray.at(t_out))),
            format!("$a = {}$, $b = {}$, $c = {}$ and the roots", shown(p), shown(q), shown(r)),
            format!("are ${}$ and ${}$", shown(inside.t_in), shown(inside.t_out)),
        ],
    );
}

/// A red material under a white light.
fn material(shininess: f64, specular: f64) -> Material {
    Material {
        color: Rgb::new(0.8, 0.2, 0.1),
        ambient: Rgb::ZERO,
        diffuse: Rgb::splat(0.5),
        specular: Rgb::splat(specular),
        shininess,
        reflection: None,
        transmission: None,
    }
}

#[test]
fn lesson_07() {
    let (n, l, down) = (DVec3::Y, dvec3(0.6, 0.8, 0.0), DVec3::NEG_Y);
    let highlight = |s: f64, k: f64| shown(traces::specular(&material(s, k), n, l, down, Rgb::ONE).x);
    let r = 2.0 * n.dot(l) * n - l;
    let green_on_red = Material { color: Rgb::X, ..material(1.0, 0.0) };
    assert_eq!(traces::diffuse(&green_on_red, n, n, Rgb::Y), Rgb::ZERO);
    assert_eq!(shown(libm::cos(60f64.to_radians())), "0.5");
    says(
        "07-trace",
        &[
            format!("the diffuse term is ${}$", vector(traces::diffuse(&material(1.0, 0.0), n, l, Rgb::ONE))),
            format!(r"$\mathbf{{r}} = {}$", vector(r)),
            format!(r"$\mathbf{{r}} \cdot \mathbf{{v}} = {}$", shown(r.dot(-down))),
            format!(r"the highlight is $0.4 \cdot 0.64 = {}$", highlight(2.0, 0.4)),
            format!("${}$, ${}$ and ${}$", highlight(1.0, 1.0), highlight(2.0, 1.0), highlight(20.0, 1.0)),
        ],
    );
}

#[test]
fn lesson_08() {
    let (point, position) = (dvec3(1.0, 0.0, 2.0), dvec3(4.0, 4.0, 2.0));
    let light = Light { name: String::new(), kind: LightKind::Point { position }, color: Rgb::ONE };
    let shadow = shadows::shadow_ray(point, &light);
    let past = Ray { origin: point, direction: position - point }.at(shadow.t_max);
    says(
        "08-shadows",
        &[
            format!(
                "the way is ${}$, its length {}, the direction ${}$ and $t_{{max}} = {}$",
                vector(position - point),
                shown((position - point).length()),
                vector(shadow.ray.direction),
                shown(shadow.t_max)
            ),
            format!("the ray ends at ${}$, {} away", vector(past), shown(past.distance(point))),
        ],
    );
}

#[test]
fn lesson_09() {
    let reflected = |d: DVec3| vector(reflections::reflected_direction(d, DVec3::Y));
    says(
        "09-reflection",
        &[
            format!(r"$\mathbf{{r}} = (3, -4, 0) + 8 \cdot (0, 1, 0) = {}$", reflected(dvec3(3.0, -4.0, 0.0))),
            format!(r"$\mathbf{{r}} = (0, -2, 0) + 4 \cdot (0, 1, 0) = {}$", reflected(dvec3(0.0, -2.0, 0.0))),
            format!("$0.7^5 = {}$, the tenth ${}$", shown(libm::pow(0.7, 5.0)), shown(libm::pow(0.7, 10.0))),
        ],
    );
}

#[test]
fn lesson_10() {
    let refracted = |d: DVec3, n1: f64, n2: f64| refractions::refracted_direction(d, DVec3::Y, n1, n2);
    let slanted = dvec3(0.6, -0.8, 0.0);
    let [into, out] = [refracted(slanted, 1.0, 1.5), refracted(slanted, 1.5, 1.0)].map(Option::unwrap);
    assert_eq!(refracted(dvec3(0.8, -0.6, 0.0), 1.5, 1.0), None);
    assert!(refracted(DVec3::NEG_Y, 1.0, 1.5).unwrap().distance(DVec3::NEG_Y) < 1e-15);
    let below = |eta: f64, sine_sq: f64| shown(1.0 - eta * eta * sine_sq);
    let critical = libm::asin(1.0 / 1.5).to_degrees();
    says(
        "10-refraction",
        &[
            format!(r"$1 - 4/9 \cdot 0.36 = {}$", below(2.0 / 3.0, 0.36)),
            format!(r"$\cos\theta_2 = {}$. The direction is ${}$", shown(-into.y), vector(into)),
            format!(r"$1 - 2.25 \cdot 0.64 = {}$", below(1.5, 0.64)),
            format!("No angle has the sine ${}$", shown(1.5 * 0.8)),
            format!("for glass {}, at {} degrees", shown(1.0 / 1.5), shown(critical)),
            format!(r"$1 - 2.25 \cdot 0.36 = {}$", below(1.5, 0.36)),
            format!(r"$\cos\theta_2 = {}$, and the direction is ${}$", shown(-out.y), vector(out)),
            format!("$1 + 2 + 4 + 8 + 16 = {}$", (0..=4).map(|level| 1 << level).sum::<i32>()),
        ],
    );
}
