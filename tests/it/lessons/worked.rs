//! The numbers that the pages work out by hand are those of the solutions.

use glam::{DVec2, DVec3, dvec2, dvec3};
use raytree::kernels::{
    Start, TriangleFilter, intersect_box_certified, intersect_plane_certified, intersect_sphere_certified,
    intersect_triangle_certified, triangle_lecture_values,
};
use raytree::lessons::{
    Aabb, Build, Camera, Choice, Hierarchy, Item, Light, LightKind, Material, MeshView, Node, Plane, Random, Ray, Rgb,
    Span, Sphere, Triangle, depths_and_weights, shown,
};

use super::aabb::solution as boxes;
use super::camera::solution as cameras;
use super::cost::solution as costs;
use super::fast::solution as fast;
use super::plane::solution as planes;
use super::reflection::solution as reflections;
use super::refraction::solution as refractions;
use super::rounding::solution as rounding;
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
fn lesson_06() {
    let camera = Camera {
        eye: DVec3::ZERO,
        forward: -DVec3::Z,
        right: DVec3::X,
        up: DVec3::Y,
        fov_y_degrees: 90.0,
        width: 4,
        height: 2,
    };
    let h = |degrees: f64| shown(cameras::half_height(degrees));
    let corner = cameras::on_image(0, 0, 4, 2);
    let middle = cameras::on_image(2, 1, 5, 3);
    let p = cameras::image_point(&camera, corner);
    let ray = cameras::compute_ray(&camera, 0, 0);
    let edge = |width: u32| cameras::image_point(&Camera { width, ..camera }, DVec2::ONE);
    assert_eq!((shown(edge(4).x), shown(edge(8).x), shown(edge(8).y)), ("2".into(), "4".into(), "1".into()));
    assert!((ray.direction * p.length() - p).length() < 1e-12);
    says(
        "06-camera",
        &[
            format!(r"For $90^\circ$ that is $\tan 45^\circ = {}$, for $60^\circ$ it is {}.", h(90.0), h(60.0)),
            format!(r"$u = 2 \cdot 0.5 / 4 - 1 = {}$", shown(corner.x)),
            format!(r"$v = 1 - 2 \cdot 0.5 / 2 = {}$", shown(corner.y)),
            format!("is at ${}$", vector(p)),
            format!(r"$\sqrt{{2.25 + 0.25 + 1}} = {}$", shown(p.length())),
            format!(r"$\tan 60^\circ = {}$. The longest side", h(120.0)),
            format!(r"$\sqrt{{1 + 3}} = {}$", shown(cameras::half_height(120.0).hypot(1.0))),
            format!(r"$u = 2 \cdot 2.5 / 5 - 1 = {}$", shown(middle.x)),
            format!(r"$v = 1 - 2 \cdot 1.5 / 3 = {}$", shown(middle.y)),
        ],
    );
}

/// Of rays that are aimed at the weak spot of a formula: how many are wrong by the lessons before, and by lesson 11.
#[derive(Default)]
struct Wrong {
    aimed: usize,
    before: usize,
    after: usize,
}

impl Wrong {
    fn add(&mut self, truth: bool, before: bool, after: bool) {
        self.aimed += 1;
        self.before += usize::from(before != truth);
        self.after += usize::from(after != truth);
    }
}

fn boxes_edge_on() -> Wrong {
    let mut wrong = Wrong::default();
    let grid = |count: i32, at: &dyn Fn(i32) -> f64| {
        let all = (0..count.pow(3)).map(|i| dvec3(at(i % count), at(i / count % count), at(i / count / count)));
        all.collect::<Vec<DVec3>>()
    };
    let directions = grid(4, &|i| [-1.0, -0.0, 0.0, 1.0][i as usize]);
    for half in [DVec3::ONE, dvec3(1.0, 1.0, 0.0), DVec3::ZERO] {
        let aabb = Aabb { min: -half, max: half };
        for origin in grid(5, &|i| f64::from(i) - 2.0) {
            for direction in directions.iter().copied().filter(|d| *d != DVec3::ZERO) {
                let ray = Ray { origin, direction };
                let truth = intersect_box_certified(&ray, &aabb, Start::Anywhere).is_ok();
                let before = boxes::box_span(&ray, &aabb).is_some();
                wrong.add(truth, before, rounding::box_span(&ray, &aabb).is_some());
            }
        }
    }
    wrong
}

fn moons_far_away(random: &mut Random) -> Wrong {
    let mut wrong = Wrong::default();
    let moon = Sphere { center: DVec3::ZERO, radius: 1.0 };
    for _ in 0..10_000 {
        let ray = Ray { origin: dvec3(-1e8, 3.0 * random.signed(), 0.0), direction: DVec3::X };
        let truth = intersect_sphere_certified(&ray, &moon, Start::Anywhere).is_ok();
        let [a, b, c] = spheres::coefficients(&ray, &moon);
        wrong.add(truth, spheres::roots(a, b, c).is_some(), rounding::meets_sphere(&ray, &moon));
    }
    wrong
}

fn shadow_acne(random: &mut Random) -> Wrong {
    let mut wrong = Wrong::default();
    while wrong.aimed < 10_000 {
        let (normal, target) = (random.direction(), random.point(1.0));
        let ground = Plane { normal, distance: normal.dot(target) };
        let eye = target + 4.0 * random.direction();
        let ray = Ray { origin: eye, direction: (target - eye).normalize() };
        let Ok(met) = intersect_plane_certified(&ray, &ground) else { continue };
        let direction = random.direction();
        let hits = |origin| intersect_plane_certified(&Ray { origin, direction }, &ground).is_ok();
        wrong.add(false, hits(ray.at(met.t)), hits(rounding::leave(&ray, met.t, normal, direction)));
    }
    wrong
}

fn leaks(random: &mut Random) -> Wrong {
    let mut wrong = Wrong::default();
    while wrong.aimed < 10_000 {
        let [p, q, r] = [random.point(4.0), random.point(4.0), random.point(4.0)];
        let both = [Triangle { vertices: [p, q, r] }, Triangle { vertices: [q, p, p + q - r] }];
        let target = p.lerp(q, random.unit());
        let origin = target + 4.0 * random.direction();
        let ray = Ray { origin, direction: target - origin };
        let certified = |t: &Triangle| intersect_triangle_certified(&ray, t, &TriangleFilter::of_triangle(&ray, t));
        if !both.iter().any(|t| certified(t).is_ok()) {
            continue;
        }
        let before = both.iter().any(|t| triangles::intersect(&ray, t).is_some());
        wrong.add(true, before, both.iter().any(|t| rounding::is_hit(&ray, t)));
    }
    wrong
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

#[test]
fn lesson_11() {
    let random = &mut Random::new(11);
    let moon = Sphere { center: DVec3::ZERO, radius: 1.0 };
    let past = Ray { origin: dvec3(-1e8, 1.25, 0.0), direction: DVec3::X };
    let [a, b, c] = spheres::coefficients(&past, &moon);
    assert_eq!((a, b * b - 4.0 * a * c), (1.0, 0.0));
    assert_eq!((past.origin.dot(past.origin), c), (1e16 + 2.0, 1e16));
    assert!(!rounding::meets_sphere(&past, &moon));
    let across = past.origin.cross(past.direction).length_squared();
    let (small, large) = (boxes::slab(2.0, 0.0, 2.0, 5.0), rounding::roots(1.0, -1_000_001.0, 1_000_000.0).unwrap());
    assert_eq!((small.t_in, small.t_out), (f64::INFINITY, f64::INFINITY));
    let step = |x: f64| shown(x.next_up() - x);
    assert_eq!((step(1e16), step(1e12)), ("2".to_owned(), "0.00012207".to_owned()));
    let far = Ray { origin: dvec3(0.0, 500.0, 0.0), direction: -DVec3::Y };
    let moved = rounding::leave(&far, 500.0, DVec3::Y, DVec3::Y).y;
    assert!((moved - 3.6e-12).abs() < 0.05e-12, "{moved}");
    assert_eq!(format!("{:.4}", 16.0 * f64::from(f32::EPSILON) * 1000.0), "0.0019");
    let row = |words: &str, wrong: Wrong| format!("| {words} | {} | {} | {} |", wrong.aimed, wrong.before, wrong.after);
    says(
        "11-numbers",
        &[
            format!("In the example that is $1 - {} = {}$", shown(across), shown(1.0 - across)),
            format!("The roots are $q / a = {}$ and $c / q = {}$", large.t_out, large.t_in),
            row("a box, rays along its faces and edges", boxes_edge_on()),
            row("a unit sphere $10^8$ away, lines up to 3 beside its centre", moons_far_away(random)),
            row("points of a ground that shadow themselves, unmoved", shadow_acne(random)),
            row("rays that slip through between two triangles", leaks(random)),
        ],
    );
}

/// How many tests of boxes and triangles a ray of the lesson's picture takes.
fn tests_a_ray(file: &str, build: Build) -> f64 {
    let loaded = raytree::scene::load_file(file).unwrap();
    let view = MeshView::new(&loaded.scene, 96, 72).unwrap();
    let rendered = view.render(build, fast::nearest).unwrap();
    assert_eq!(rendered.wrong(), 0);
    rendered.total() as f64 / view.rays() as f64
}

#[test]
fn lesson_12() {
    let aabb = |x: f64, y: f64, z: f64| Aabb { min: DVec3::ZERO, max: dvec3(x, y, z) };
    let area = fast::surface_area(&aabb(2.0, 3.0, 4.0));
    assert_eq!(fast::surface_area(&aabb(1.0, 1.0, 2.0)), 10.0);
    let solved = tests_a_ray("scenes/mesh.json", fast::build);
    let unsorted = tests_a_ray("scenes/mesh.json", |items, builder| {
        let bounds = fast::bounds(items);
        if items.len() <= fast::LEAF {
            return Node::leaf(bounds, items);
        }
        let (left, right) = items.split_at(items.len() / 2);
        Node::inner(bounds, builder.build(left), builder.build(right))
    });
    // A row of walls as wide as they are apart halves evenly.
    let walls = (0..1024).map(|number| {
        let at = dvec3(number as f64, 0.0, 0.0);
        Item { number, triangle: Triangle { vertices: [at, at + DVec3::Y, at + DVec3::Z] } }
    });
    let halves = Hierarchy::of(
        |items, builder| {
            let (left, right) = items.split_at(items.len() / 2);
            match items.len() {
                0..=2 => Node::leaf(fast::bounds(items), items),
                _ => Node::inner(fast::bounds(items), builder.build(left), builder.build(right)),
            }
        },
        &walls.collect::<Vec<_>>(),
    );
    let halves = halves.unwrap();
    let depth = halves.root().walk().iter().map(|(_, depth)| *depth).max().unwrap();
    assert_eq!(depth, 9);
    says(
        "12-fast",
        &[
            format!(r"$2 \cdot (6 + 12 + 8) = {}$", shown(area)),
            format!(r"$52 \cdot 3 + 10 \cdot 1 = {}$", shown(area * 3.0 + 10.0)),
            format!("the solution makes {solved:.1} tests a ray"),
            format!("That is {} times fewer", shown((2048.0 / solved).round())),
            format!("gets the right picture with {unsorted:.1} tests a ray"),
            format!("$512 + 511 = {}$ in all. Halved nine times", halves.nodes()),
        ],
    );
}

#[test]
fn lesson_13() {
    let of = |cost, error| Choice { name: String::new(), cost, error };
    assert_eq!(costs::pareto(&[of(1.0, 2.0), of(2.0, 1.0), of(3.0, 1.5)]), [0, 1]);
    assert_eq!(costs::break_even(80.0, 2.0, 10.0), None);
    let loaded = raytree::scene::load_file("scenes/whitted.json").unwrap();
    let measured = depths_and_weights(&loaded.scene, 48, 36).unwrap();
    assert_eq!(measured.len(), 12);
    let chosen = &measured[costs::choose(&measured, 0.01).unwrap()].name;
    // Of the depths only the two cheapest and the deepest are left.
    let front = costs::pareto(&measured).into_iter().map(|i| measured[i].name.as_str());
    let depths: Vec<&str> = front.filter(|name| name.starts_with("depth")).collect();
    assert_eq!(depths, ["depth 0", "depth 1", "depth 6"]);
    let read = costs::reading();
    let even = costs::break_even(200_000.0, 2048.0, 16.0).unwrap();
    says(
        "13-cost",
        &[
            format!("From 10 to 5 is $10 / 5 = {}$", shown(costs::speedup(10.0, 5.0))),
            format!("From 4 to 5 is {}: slower", shown(costs::speedup(4.0, 5.0))),
            format!("$80 / (10 - 2) = {}$ rays", shown(costs::break_even(80.0, 10.0, 2.0).unwrap())),
            format!("$2048 / 16 = {}$.", shown(costs::speedup(2048.0, 16.0))),
            format!("which is {even:.1}: from {} rays on", even.ceil()),
            format!("`{chosen}`: of all whose error is at most 0.01"),
            format!("wrong in {} of 2000", read.lecture_wrong),
            format!("{:.0} of 2000 are wrong", read.lecture_wrong as f64 / read.lecture_over_watertight),
        ],
    );
}
