//! The numbers that the pages work out by hand are those of the solutions.

use glam::{DVec3, dvec2, dvec3};
use raytree::kernels::triangle_lecture_values;
use raytree::lessons::{
    Aabb, Build, Choice, Hierarchy, Item, MeshView, Node, Plane, Ray, Span, Sphere, Triangle, depths_and_weights, shown,
};

use super::aabb::solution as boxes;
use super::cost::solution as costs;
use super::fast::solution as fast;
use super::plane::solution as planes;
use super::sphere::solution as spheres;
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
