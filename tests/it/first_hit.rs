//! Diagrams of one hit or miss: of every node of every tree, of what was hit and of what was rejected, of geometry made to be
//! hard to draw; the numbers in their formulas.

use std::collections::BTreeSet;

use raytree::kernels::Ray;
use raytree::pictures::diagrams::{Chosen, Input, Kind, diagram, shown, tex};
use raytree::pictures::drawing::Drawing;
use raytree::pictures::theme::Theme;
use raytree::scene::{Loaded, Numerics, Scene, Shape, load_file};
use raytree::transport::{Options, Tracer};
use raytree::tree::{Keep, Kind as Way, Origin, RayNode, RayTree, TestRecord, record_ray};

use crate::commands::{bad, good};
use crate::diagrams::{check_labels, numbers_in, numbers_of, tree_of};
use crate::support::{scenes, small_scene};

const KINDS: [Kind; 5] = [Kind::Plane, Kind::Triangle, Kind::Box, Kind::Sphere, Kind::Surface];

/// A label without TeX: numbers as they stand in other labels, letters without their indices.
fn plain(label: &str) -> String {
    let mut text = label.replace(r" \cdot 10^{", "e");
    for power in ["^2", "^\\circ", "4ac", "4a", "2a", "1-a-b", "(1{-}a{-}b)", "d} - 2", r"b = 2\,"] {
        text = text.replace(power, " ");
    }
    for letter in ["v}_", "e}_", "theta_", "n_", "frac{n_"] {
        for i in 0..3 {
            text = text.replace(&format!("{letter}{i}"), " ");
        }
    }
    // A minus after an operand is an operator, one after a sign is not.
    let mut out = String::new();
    for c in text.replace(r"\;", " ").chars() {
        let before = out.trim_end().chars().next_back();
        let is_sign = c == '-' && !before.is_some_and(|b| b.is_ascii_digit() || b.is_alphabetic() || b == ')');
        let in_power = c == '-' && out.ends_with('e');
        out.push(if is_sign || in_power { '−' } else { c });
    }
    out
}

/// The numbers that a diagram may print: those of the tree, those of the scene's shapes, angles between the tree's vectors, what
/// is left of 1, and the small integers of formulas.
fn allowed(scene: &Scene, tree: &RayTree, node: &RayNode, shape: Option<Chosen>) -> BTreeSet<String> {
    let mut numbers = numbers_of(tree);
    let mut add = |x: f64| _ = numbers.insert(shown(x));
    [0.0, 1.0, 2.0, 4.0].into_iter().for_each(&mut add);
    let chosen = shape.or(node.hit.as_ref().map(|hit| Chosen { shape: hit.shape, primitive: hit.primitive }));
    if let Some(Chosen { shape, primitive }) = chosen {
        match &scene.objects[shape as usize].shape {
            Shape::Sphere { center, radius } => center.to_array().into_iter().chain([*radius]).for_each(&mut add),
            Shape::Plane { normal, distance } => normal.to_array().into_iter().chain([*distance]).for_each(&mut add),
            Shape::Box { min, max } => min.to_array().into_iter().chain(max.to_array()).for_each(&mut add),
            Shape::Triangle { vertices } => vertices.iter().flat_map(|v| v.to_array()).for_each(&mut add),
            Shape::Mesh(mesh) => {
                let vertices = mesh.triangles[primitive.unwrap() as usize];
                vertices.iter().flat_map(|v| v.to_array()).for_each(&mut add);
                add(primitive.unwrap().into());
            }
        }
    }
    if let Some(hit) = &node.hit {
        let n = glam::DVec3::from(hit.shading_normal.unwrap());
        let mut angle = |v: [f64; 3], n: glam::DVec3| {
            let v = glam::DVec3::from(v);
            add(libm::atan2(v.cross(n).length(), v.dot(n)).to_degrees());
        };
        angle(node.direction, -n);
        node.reflected.iter().for_each(|child| angle(child.direction, n));
        node.refracted.iter().for_each(|child| angle(child.direction, -n));
        if let Some([incident, transmitted]) = hit.ior {
            add(libm::asin(transmitted / incident).to_degrees());
            let d = glam::DVec3::from(node.direction);
            let sine = incident / transmitted * libm::sin(libm::atan2(d.cross(n).length(), -d.dot(n)));
            add(sine);
            add(sine - 1.0);
        }
    }
    node.fresnel.into_iter().for_each(|r| add(1.0 - r));
    numbers
}

/// Holds a diagram to what is asked of all of them.
fn check(what: &str, drawing: &Drawing, numbers: &BTreeSet<String>) {
    check_labels(what, drawing);
    assert!(drawing.to_svg().is_ok() && !drawing.description().is_empty(), "{what}");
    // The title has the names and places that the others do not have.
    for label in drawing.labels().iter().filter(|label| label.text.contains('$')) {
        for number in numbers_in(&plain(&label.text)) {
            let number = number.replace("e−", "e-").replace("e-", "e−");
            assert!(numbers.contains(&number), "{what}: {number} in {:?}", label.text);
        }
    }
}

/// The shapes that a ray was tested against, boxes whose bounds it passes among them.
fn tested(scene: &Scene, node: &RayNode) -> Vec<(Chosen, String)> {
    let of = |test: &TestRecord| match test {
        TestRecord::Shape(r) if !r.values.0.is_empty() => {
            let chosen = Chosen { shape: r.shape, primitive: r.primitive };
            Some((chosen, r.reason.clone().unwrap_or_default()))
        }
        TestRecord::Bounds(r) if !r.in_mesh => {
            let shape = r.shape.filter(|i| matches!(scene.objects[*i as usize].shape, Shape::Box { .. }))?;
            Some((Chosen { shape, primitive: None }, r.reason.clone().unwrap_or_default()))
        }
        _ => None,
    };
    node.tests.iter().flatten().filter_map(of).collect()
}

#[test]
fn every_ray_of_every_named_pixel() {
    let mut drawn = [0; 5];
    for (name, loaded) in scenes() {
        for (pixel, place) in &loaded.scene.pixels {
            let tree = tree_of(&loaded, *place);
            for (path, node) in tree.nodes().into_iter().take(24) {
                for (k, kind) in KINDS.into_iter().enumerate() {
                    let alone = Input::new(&loaded.scene, &tree, path.clone()).unwrap();
                    let what = format!("{name}, {pixel}, {kind} of {path}");
                    let Ok(drawing) = diagram(kind, &alone, &Theme::LIGHT) else { continue };
                    let numbers = allowed(&loaded.scene, &tree, node, None);
                    check(&what, &drawing, &numbers);
                    let small = diagram(kind, &alone.on_page(545.0, 400.0), &Theme::DARK).unwrap();
                    check(&format!("{what}, small"), &small, &numbers);
                    drawn[k] += 1;
                }
            }
        }
    }
    assert!(drawn.iter().all(|count| *count > 20), "{drawn:?}");
}

#[test]
fn what_was_rejected() {
    let mut reasons = BTreeSet::new();
    for (name, loaded) in scenes() {
        for (pixel, place) in &loaded.scene.pixels {
            let tree = tree_of(&loaded, *place);
            for (path, node) in tree.nodes().into_iter().take(8) {
                let mut seen = BTreeSet::new();
                for (chosen, reason) in tested(&loaded.scene, node) {
                    if !seen.insert((chosen.shape, reason.clone())) {
                        continue;
                    }
                    let input = Input::new(&loaded.scene, &tree, path.clone()).unwrap().about(chosen);
                    for kind in &KINDS[..4] {
                        let what = format!("{name}, {pixel}, {kind} of {path} with {chosen:?}: {reason}");
                        let Ok(drawing) = diagram(*kind, &input, &Theme::LIGHT) else { continue };
                        check(&what, &drawing, &allowed(&loaded.scene, &tree, node, Some(chosen)));
                        reasons.insert(format!("{kind}: {reason}"));
                    }
                }
            }
        }
    }
    for wanted in [
        "plane: behind",
        "plane: farther than the best",
        "triangle: a < 0",
        "triangle: b < 0",
        "triangle: a + b > 1",
        "box: pruned by its box",
        "box: t_in > t_out",
        "sphere: discriminant negative",
    ] {
        assert!(reasons.contains(wanted), "{wanted}: {reasons:?}");
    }
}

/// The tree of a ray with every test.
fn steps(loaded: &Loaded, numerics: Numerics, origin: [f64; 3], direction: [f64; 3]) -> RayTree {
    let options = Options { numerics, ..Options::of(&loaded.scene) };
    let tracer = Tracer::<f64>::new(&loaded.scene, options).unwrap();
    let ray = Ray { origin: origin.into(), direction: direction.into() };
    record_ray(&tracer, Origin { loaded, keep: Keep::Steps }, &ray).unwrap()
}

#[test]
fn geometry_that_is_hard_to_draw() {
    let sizes = [1e-6, 1e-3, 1.0, 1e6];
    let mut drawn = 0;
    for size in sizes {
        for distance in sizes {
            for slope in [0.0, 1e-7, 0.7] {
                let (a, b) = (size, 1e-3 * size);
                let objects = format!(
                    r#"{{ "name": "sphere", "material": "m", "shape": {{ "sphere": {{ "center": [0, 0, 0], "radius": {a} }} }} }},
                       {{ "name": "plane", "material": "m", "shape": {{ "plane": {{ "normal": [0, 1, 0], "distance": {a} }} }} }},
                       {{ "name": "box", "material": "m", "shape": {{ "box": {{ "min": [-{a}, -{b}, 0], "max": [{a}, {b}, {a}] }} }} }},
                       {{ "name": "triangle", "material": "m", "shape": {{ "triangle": {{ "vertices":
                           [[-{a}, -{b}, 0], [{a}, {b}, 0], [{a}, -{b}, {b}]] }} }} }}"#
                );
                let materials =
                    r#""m": { "ambient": 1, "reflection": 0.5, "transmission": 0.5, "ior": 1.5, "fresnel": "exact" }"#;
                let loaded = small_scene(materials, &objects, r#", "max_depth": 2"#);
                for height in [0.0, 0.5 * b, a * (1.0 + 1e-9), 1.2 * a] {
                    let numerics = if slope > 0.1 { Numerics::Lecture } else { Numerics::Certified };
                    let tree = steps(&loaded, numerics, [0.1 * a, height, distance], [slope, -0.5 * slope, -1.0]);
                    for (path, node) in tree.nodes().into_iter().take(2) {
                        for (shape, kind) in (0..4).zip([Kind::Sphere, Kind::Plane, Kind::Box, Kind::Triangle]) {
                            let chosen = Chosen { shape, primitive: None };
                            let input = Input::new(&loaded.scene, &tree, path.clone()).unwrap();
                            for (kind, chosen) in [(kind, Some(chosen)), (Kind::Surface, None)] {
                                let input = chosen.map_or(input.clone(), |chosen| input.clone().about(chosen));
                                let Ok(drawing) = diagram(kind, &input, &Theme::LIGHT) else { continue };
                                let what = format!("{kind} of {path}: {size}, {distance}, {slope}, {height}");
                                check(&what, &drawing, &allowed(&loaded.scene, &tree, node, chosen));
                                drawn += 1;
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(drawn > 400, "{drawn}");
}

#[test]
fn formulas_are_read_back() {
    assert_eq!(tex(-1234567.0), r"-1.235 \cdot 10^{6}");
    let read = |label: &str| numbers_in(&plain(label));
    assert_eq!(read(r"$t = \frac{2 - (-1.5)}{-0.4306} = 3 \cdot 10^{-7}$"), ["2", "−1.5", "−0.4306", "3e−7"]);
    assert_eq!(read(r"$\mathbf{v}_0 = (1,\; -2,\; 3)$"), ["1", "−2", "3"]);
    assert_eq!(read(r"$\phantom{t} = \frac{0 - 2.2}{-1}$"), ["0", "2.2", "−1"]);
}

/// One of each kind, and a miss.
const KEPT: [(&str, &str, Kind, Option<u32>); 6] = [
    ("plane", "floor", Kind::Plane, None),
    ("triangle", "middle", Kind::Triangle, None),
    ("triangle", "just outside", Kind::Triangle, Some(0)),
    ("box", "top face", Kind::Box, None),
    ("sphere", "highlight", Kind::Sphere, None),
    ("total-internal-reflection", "critical angle", Kind::Surface, None),
];

#[test]
fn one_of_each_as_svg() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("snapshots/diagrams");
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| {
        for (scene, pixel, kind, shape) in KEPT {
            let loaded = load_file(&format!("scenes/{scene}.json")).unwrap();
            let place = loaded.scene.pixels.iter().find(|(name, _)| name == pixel).unwrap().1;
            let tree = tree_of(&loaded, place);
            let input = Input::new(&loaded.scene, &tree, "root".parse().unwrap()).unwrap();
            let input = shape.map_or(input.clone(), |shape| input.about(Chosen { shape, primitive: None }));
            let drawing = diagram(kind, &input, &Theme::LIGHT).unwrap();
            let name = format!("{scene}.{pixel}.{kind}").replace(['/', ' '], "-");
            insta::assert_snapshot!(name, drawing.to_svg().unwrap());
        }
    });
}

#[test]
fn shapes_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("miss.svg").to_str().unwrap().to_owned();
    let command = "diagram scenes/triangle.json 'just outside' --kind triangle";
    good(&format!("{command} --shape triangle -o {file}"));
    assert!(std::fs::read_to_string(&file).unwrap().contains("misses “triangle”"));
    let told = bad(2, &format!("{command} -o {file}"));
    assert!(told.contains("the ray hits nothing, and no shape is chosen"), "{told}");
    let told = bad(2, &format!("{command} --shape triangel -o {file}"));
    assert!(told.contains("no shape `triangel`") && told.contains("did you mean `triangle`?"), "{told}");
    let told = bad(2, &format!("diagram scenes/mesh.json facet --kind triangle --shape waves:999999 -o {file}"));
    assert!(told.contains("was not tested against"), "{told}");
}

#[test]
fn trees_of_others_are_no_reason_to_panic() {
    let loaded = load_file("scenes/sphere.json").unwrap();
    let other = load_file("scenes/whitted.json").unwrap();
    let mut tree = tree_of(&other, other.scene.pixels[0].1);
    let draw = |tree: &RayTree| {
        for (path, _) in tree.nodes() {
            for kind in KINDS {
                let input = Input::new(&loaded.scene, tree, path.clone()).unwrap();
                if let Ok(drawing) = diagram(kind, &input, &Theme::LIGHT) {
                    check_labels(&format!("{kind} of {path}"), &drawing);
                }
            }
        }
    };
    draw(&tree);
    tree.root.tests = None;
    tree.root.hit.iter_mut().for_each(|hit| hit.shading_normal = None);
    draw(&tree);
    assert_eq!(tree.root.kind, Way::Camera);
}
