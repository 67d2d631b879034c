//! The difference of two trees: one change planted at a time, and two scenes that differ in one number.

use raytree::scene::{Loaded, load_file};
use raytree::tree::diff::{Difference, Field, ForestDifference, Tolerance, Tolerances, Value, Which, diff};
use raytree::tree::{Keep, NodePath, Outcome, RayNode, RayTree};

use crate::support::{scenes, tracer, tree};

/// The tree of a named pixel of a committed scene.
pub(crate) fn named(file: &str, name: &str) -> RayTree {
    let loaded = load_file(&format!("scenes/{file}.json")).unwrap();
    let (_, pixel) = loaded.scene.pixels.iter().find(|(known, _)| known == name).unwrap();
    of_pixel(&loaded, *pixel)
}

fn of_pixel(loaded: &Loaded, pixel: [u32; 2]) -> RayTree {
    tree(&tracer::<f64>(&loaded.scene), loaded, pixel, Keep::Outcomes)
}

fn node_mut<'t>(tree: &'t mut RayTree, path: &str) -> &'t mut RayNode {
    let mut node = &mut tree.root;
    for word in path.split('.').skip(1) {
        node = match word {
            "reflected" => node.reflected.as_deref_mut().unwrap(),
            "refracted" => node.refracted.as_deref_mut().unwrap(),
            "shadows[0]" => &mut node.shadows[0],
            _ => panic!("{word}"),
        };
    }
    node
}

fn every_node(node: &mut RayNode, change: &dyn Fn(&mut RayNode)) {
    change(node);
    let children = node.shadows.iter_mut().chain(node.reflected.as_deref_mut()).chain(node.refracted.as_deref_mut());
    children.for_each(|child| every_node(child, change));
}

fn exactly() -> Tolerances {
    Tolerances::same(Tolerance::Ulps(0.0))
}

fn own(difference: &Difference) -> usize {
    difference.divergences.iter().filter(|divergence| !divergence.consequence).count()
}

#[test]
fn a_tree_agrees_with_itself_in_every_bit() {
    for (name, loaded) in scenes() {
        for (_, pixel) in &loaded.scene.pixels {
            let tree = of_pixel(&loaded, *pixel);
            let difference = diff(&tree, &tree, &exactly());
            assert!(difference.is_same() && difference.missing.is_empty() && difference.notes.is_empty(), "{name}");
            assert_eq!(difference.nearest_agreement, None, "{name}");
        }
    }
}

/// What is changed, where, and what has to be reported first.
type Plant = (&'static str, Field, fn(&mut RayNode));

const PLANTS: [Plant; 19] = [
    ("root", Field::Direction, |node| node.direction[0] += 1e-3),
    ("root.refracted", Field::Origin, |node| node.origin[1] += 1e-3),
    ("root.refracted", Field::Weight, |node| node.weight = Some([0.25; 3])),
    ("root.refracted", Field::Ior, |node| node.ior = Some(1.25)),
    ("root.reflected.shadows[0]", Field::TMax, |node| node.t_max = Some(1.0)),
    ("root.refracted.refracted", Field::Outcome, |node| node.outcome = Outcome::MaxDepth),
    ("root.refracted", Field::Shape, |node| node.hit.as_mut().unwrap().shape = 7),
    ("root.refracted", Field::Object, |node| node.hit.as_mut().unwrap().object = Some("moon".into())),
    ("root.refracted", Field::T, |node| node.hit.as_mut().unwrap().t *= 1.001),
    ("root.refracted", Field::Point, |node| node.hit.as_mut().unwrap().point[2] += 1e-3),
    ("root.refracted", Field::GeometricNormal, |node| node.hit.as_mut().unwrap().geometric_normal = [0.0, 1.0, 0.0]),
    ("root.refracted", Field::ShadingNormal, |node| node.hit.as_mut().unwrap().shading_normal = Some([0.0, 1.0, 0.0])),
    ("root.refracted", Field::HitIor, |node| node.hit.as_mut().unwrap().ior = Some([1.5, 1.25])),
    ("root.reflected", Field::Ambient, |node| node.local.as_mut().unwrap().ambient = [0.5; 3]),
    ("root.reflected", Field::Diffuse, |node| node.local.as_mut().unwrap().lights[0].diffuse = [0.5; 3]),
    ("root.reflected", Field::Specular, |node| node.local.as_mut().unwrap().lights[0].specular = [0.5; 3]),
    ("root", Field::Fresnel, |node| node.fresnel = Some(0.75)),
    ("root.reflected", Field::Shadows, |node| node.shadows.clear()),
    ("root.refracted", Field::Reflected, |node| node.reflected = None),
];

#[test]
fn the_first_divergence_is_where_it_was_planted() {
    let right = named("whitted", "glass edge");
    for (path, field, plant) in PLANTS {
        let mut wrong = right.clone();
        plant(node_mut(&mut wrong, path));
        let difference = diff(&right, &wrong, &Tolerances::default());
        let first = difference.first().unwrap_or_else(|| panic!("{path} {field} is not seen"));
        assert_eq!((first.path.to_string().as_str(), first.field), (path, field));
        assert!(!first.consequence);
        assert_eq!(own(&difference), 1, "{path} {field}: {}", difference.to_text());
        // From the other side it is the same place.
        let back = diff(&wrong, &right, &Tolerances::default());
        let first_back = back.first().unwrap();
        assert_eq!((&first_back.path, first_back.field), (&first.path, first.field));
        assert_eq!((&first_back.a, &first_back.b), (&first.b, &first.a));
    }
}

#[test]
fn faces_and_triangles_are_structure() {
    for (file, pixel, path) in [("whitted", "mirrored floor", "root.reflected"), ("triangle", "middle", "root")] {
        let right = named(file, pixel);
        let mut wrong = right.clone();
        let hit = node_mut(&mut wrong, path).hit.as_mut().unwrap();
        match &mut hit.barycentrics {
            Some(weights) => weights.rotate_left(1),
            None => hit.primitive = Some(2),
        }
        let first = diff(&right, &wrong, &Tolerances::default()).divergences.remove(0);
        let field = if file == "triangle" { Field::Barycentrics } else { Field::Primitive };
        assert_eq!((first.path.to_string().as_str(), first.field), (path, field));
    }
}

#[test]
fn two_changes_that_have_nothing_to_do_with_each_other_are_both_told() {
    let right = named("whitted", "glass edge");
    let mut wrong = right.clone();
    node_mut(&mut wrong, "root.reflected").origin[0] += 1.0;
    node_mut(&mut wrong, "root.refracted").hit.as_mut().unwrap().t *= 2.0;
    let difference = diff(&right, &wrong, &Tolerances::default());
    assert_eq!(own(&difference), 2, "{}", difference.to_text());
    assert!(difference.to_text().contains("by themselves part as well:\n  root.refracted, hit.t"));
}

#[test]
fn all_that_a_changed_scene_does_follows_from_one_place() {
    let text = std::fs::read_to_string("scenes/whitted.json").unwrap();
    for (from, to, pixel, path, field) in [
        (r#""ior": 1.5"#, r#""ior": 1.4"#, "glass edge", "root", Field::HitIor),
        (r#""reflection": 0.75"#, r#""reflection": 0.7"#, "mirrored floor", "root.reflected", Field::Weight),
        (r#""radius": 0.85"#, r#""radius": 0.86"#, "mirrored floor", "root", Field::T),
    ] {
        assert!(text.contains(from), "{from}");
        let load = |text: &str| raytree::scene::load("whitted.json", text, &mut |_| Err("none".into())).unwrap();
        let (a, b) = (load(&text), load(&text.replace(from, to)));
        let (_, pixel) = a.scene.pixels.iter().find(|(name, _)| name == pixel).unwrap();
        let difference = diff(&of_pixel(&a, *pixel), &of_pixel(&b, *pixel), &Tolerances::default());
        let first = difference.first().unwrap();
        assert_eq!((first.path.to_string().as_str(), first.field), (path, field), "{}", difference.to_text());
        assert_eq!(own(&difference), 1, "{}", difference.to_text());
        assert_eq!(difference.notes, ["the scenes of A and B have different hashes"]);
    }
}

#[test]
fn numbers_agree_within_what_is_allowed_and_no_further() {
    let right = named("whitted", "glass edge");
    let mut near = right.clone();
    let hit = node_mut(&mut near, "root.refracted").hit.as_mut().unwrap();
    let step = hit.t.next_up() - hit.t;
    hit.t += 2.0 * step;
    let at = |all: Tolerance| diff(&right, &near, &Tolerances::same(all));
    // t is shorter than the way to it, the eye's 6: one step of that is four of t.
    let distance = at(Tolerance::Ulps(2.0)).nearest_agreement.unwrap().distance.unwrap();
    assert_eq!((distance.absolute, distance.ulps, distance.scale), (2.0 * step, 2.0, 6.0));
    assert!(at(Tolerance::Ulps(0.5)).is_same() && !at(Tolerance::Ulps(0.49)).is_same());
    assert!(at(Tolerance::Relative(1e-15)).is_same() && !at(Tolerance::Relative(1e-18)).is_same());

    // One field by itself: what is wide there stays narrow elsewhere.
    let hit = node_mut(&mut near, "root.refracted").hit.as_mut().unwrap();
    hit.t *= 1.01;
    let mut tolerances = exactly();
    assert!(!diff(&right, &near, &tolerances).is_same());
    tolerances.set("hit.t=0.1").unwrap();
    assert!(diff(&right, &near, &tolerances).is_same());
    node_mut(&mut near, "root.refracted").hit.as_mut().unwrap().point[0] += 1e-9;
    assert_eq!(diff(&right, &near, &tolerances).first().unwrap().field, Field::Point);
    for (words, help) in [
        ("hit.t", "FIELD=TOLERANCE"),
        ("hit.tt=1", "did you mean `hit.t`"),
        ("outcome=1", "agrees exactly"),
        ("hit.t=-1", "a number of 0 or more"),
        ("hit.t=nan", "a number of 0 or more"),
    ] {
        let error = tolerances.set(words).unwrap_err();
        assert!(error.contains(help), "{words}: {error}");
    }
}

#[test]
fn small_coordinates_of_a_large_scene_are_not_measured_by_themselves() {
    let mut root =
        RayNode::new(raytree::tree::Kind::Camera, 0, [1e-17, 0.0, 10.0], [0.0, 0.0, -1.0], Outcome::Background);
    let a = RayTree::new([0.0; 3], root.clone());
    root.origin[0] = -1e-17;
    let b = RayTree::new([0.0; 3], root);
    assert!(diff(&a, &b, &Tolerances::same(Tolerance::Relative(1e-15))).is_same());
    assert!(!diff(&a, &b, &exactly()).is_same());
}

#[test]
fn what_a_tracer_never_writes_parts_nothing_and_is_named_once() {
    let right = named("whitted", "glass edge");
    let mut foreign = right.clone();
    every_node(&mut foreign.root, &|node| {
        (node.ior, node.radiance, node.t_max) = (None, None, None);
        if let Some(hit) = &mut node.hit {
            (hit.object, hit.side, hit.ior, hit.shading_normal) = (None, None, None, None);
        }
    });
    let difference = diff(&right, &foreign, &exactly());
    assert!(difference.is_same(), "{}", difference.to_text());
    let names: Vec<_> = difference.missing.iter().map(|missing| (missing.tree, missing.field.name())).collect();
    let fields = ["ior", "t_max", "hit.object", "hit.shading_normal", "hit.side", "hit.ior", "radiance"];
    assert_eq!(names, fields.map(|name| (Which::B, name)));
    assert!(difference.to_text().contains("not in B: ior, t_max, hit.object"));

    // A key that is somewhere is looked for everywhere.
    let mut partly = right.clone();
    node_mut(&mut partly, "root.refracted").hit.as_mut().unwrap().object = None;
    let difference = diff(&right, &partly, &exactly());
    let first = difference.first().unwrap();
    assert_eq!((first.field, first.b.clone()), (Field::Object, None));
    assert_eq!(first.a, Some(Value::Word("glass ball".into())));
}

#[test]
fn the_effect_is_what_the_pixel_loses_or_gains() {
    let right = named("whitted", "glass edge");
    let gone = NodePath::ROOT.child(raytree::tree::Branch::Refracted);
    let node = gone.find(&right).unwrap();
    let (weight, radiance) = (node.weight.unwrap(), node.radiance.unwrap());
    let mut wrong = right.clone();
    wrong.root.refracted = None;
    let effect = diff(&right, &wrong, &Tolerances::default()).first().unwrap().effect.unwrap();
    assert_eq!(effect, std::array::from_fn(|k| -weight[k] * radiance[k]));

    // Without radiances it is added up from what is below.
    let mut bare = right.clone();
    every_node(&mut bare.root, &|node| node.radiance = node.radiance.filter(|_| node.outcome == Outcome::Background));
    let mut wrong = bare.clone();
    wrong.root.refracted = None;
    let added = diff(&bare, &wrong, &Tolerances::default()).first().unwrap().effect.unwrap();
    assert!((0..3).all(|k| (added[k] - effect[k]).abs() < 1e-12), "{added:?} {effect:?}");
}

#[test]
fn shadow_rays_are_aligned_by_their_lights() {
    let loaded = load_file("scenes/shadows-of-several-lights.json").unwrap();
    let pixels = loaded.scene.pixels.iter().map(|(_, pixel)| of_pixel(&loaded, *pixel));
    let right = pixels.max_by_key(|tree| tree.root.shadows.len()).unwrap();
    assert!(right.root.shadows.len() >= 2);
    let mut turned = right.clone();
    turned.root.shadows.reverse();
    turned.root.local.as_mut().unwrap().lights.reverse();
    assert!(diff(&right, &turned, &exactly()).is_same());

    let mut renamed = right.clone();
    renamed.root.shadows[1].light = Some("lamp".into());
    let difference = diff(&right, &renamed, &exactly());
    let first = difference.first().unwrap();
    assert_eq!((first.field, first.light.clone()), (Field::Shadows, right.root.shadows[1].light.clone()));
}

#[test]
fn what_is_said_about_a_difference() {
    let right = named("whitted", "glass edge");
    let mut wrong = right.clone();
    let node = node_mut(&mut wrong, "root.refracted");
    node.hit.as_mut().unwrap().t *= 1.25;
    node.hit.as_mut().unwrap().point[0] += 0.25;
    let difference = diff(&right, &wrong, &Tolerances::default());
    insta::assert_snapshot!("diff-text", difference.to_text());
    insta::assert_snapshot!("diff-json", difference.to_json());
    let mut near = right.clone();
    let hit = node_mut(&mut near, "root.refracted").hit.as_mut().unwrap();
    hit.t = hit.t.next_up();
    insta::assert_snapshot!("diff-same", diff(&right, &near, &Tolerances::default()).to_text());
}

#[test]
fn forests_are_counted_by_where_their_pixels_part_first() {
    let loaded = load_file("scenes/whitted.json").unwrap();
    let mut forest = ForestDifference::default();
    for x in 0..10 {
        let right = of_pixel(&loaded, [360 + 4 * x, 190]);
        let mut wrong = right.clone();
        if x >= 7 {
            wrong.root.direction[0] += 0.125;
        } else if x >= 5 {
            wrong.color[1] += f64::from(x);
        }
        forest.add([360 + 4 * x, 190], &diff(&right, &wrong, &Tolerances::default()));
    }
    let forest = forest.sorted();
    assert_eq!((forest.pixels, forest.same, forest.is_same()), (10, 5, false));
    let bins: Vec<_> = forest.first_divergences.iter().map(|bin| (bin.field, bin.pixels, bin.example)).collect();
    assert_eq!(bins, [(Field::Direction, 3, [388, 190]), (Field::Color, 2, [384, 190])]);
    insta::assert_snapshot!("diff-forest", forest.to_text());
}
