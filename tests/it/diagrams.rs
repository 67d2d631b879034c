//! Diagrams of every named pixel: labels that stay on the canvas and off each other, numbers that are those of the tree, bytes;
//! trees made to be hard; the page, the gallery, and what the commands answer to bad input.

use std::collections::BTreeSet;
use std::fs;

use raytree::numbers::Precision;
use raytree::pictures::Film;
use raytree::pictures::diagrams::{Input, Kind, diagram, shown};
use raytree::pictures::drawing::Drawing;
use raytree::pictures::sheet::sheet;
use raytree::pictures::theme::Theme;
use raytree::scene::{Loaded, Rgb};
use raytree::tree::{HitRecord, Keep, Kind as Ray, Ledger, NodePath, Outcome, RayNode, RayTree};

use crate::commands::{bad, good};
use crate::drawing::difference_to_resvg;
use crate::support::{scenes, tracer, tree};

pub(crate) fn tree_of(loaded: &Loaded, pixel: [u32; 2]) -> RayTree {
    match loaded.scene.precision {
        Some(Precision::F32) => tree(&tracer::<f32>(&loaded.scene), loaded, pixel, Keep::Steps),
        _ => tree(&tracer::<f64>(&loaded.scene), loaded, pixel, Keep::Steps),
    }
}

/// Every named pixel of every scene, as `scene, pixel`, with its tree.
fn for_each_pixel(mut check: impl FnMut(&str, &Loaded, &RayTree)) {
    for (name, loaded) in scenes() {
        for (pixel, place) in &loaded.scene.pixels {
            check(&format!("{name}, {pixel}"), &loaded, &tree_of(&loaded, *place));
        }
    }
}

fn input<'a>(loaded: &'a Loaded, tree: &'a RayTree) -> Input<'a> {
    Input::new(&loaded.scene, tree, NodePath::ROOT).unwrap()
}

/// A drawing has a picture, its labels stay on the canvas and off each other.
pub(crate) fn check_labels(what: &str, drawing: &Drawing) {
    assert!(!drawing.labels().is_empty(), "{what}");
    for (i, label) in drawing.labels().iter().enumerate() {
        assert!(drawing.canvas().contains(label.rect), "{what}: {label:?} leaves the canvas");
        for other in &drawing.labels()[i + 1..] {
            assert!(!label.rect.overlaps(other.rect), "{what}: {label:?} and {other:?}");
        }
    }
}

/// Every number of a tree as diagrams write it, those of its ledger and of its pixel among them, and how many rays it has.
pub(crate) fn numbers_of(tree: &RayTree) -> BTreeSet<String> {
    fn collect(value: &serde_json::Value, into: &mut BTreeSet<String>) {
        match value {
            serde_json::Value::Number(x) => _ = into.insert(shown(x.as_f64().unwrap())),
            serde_json::Value::Array(values) => values.iter().for_each(|value| collect(value, into)),
            serde_json::Value::Object(values) => values.values().for_each(|value| collect(value, into)),
            _ => {}
        }
    }
    let mut numbers = BTreeSet::new();
    collect(&serde_json::to_value(tree).unwrap(), &mut numbers);
    collect(&serde_json::to_value(Ledger::of(tree)).unwrap(), &mut numbers);
    // Rays are counted and numbered.
    numbers.extend((0..=tree.root.walk().count()).map(|i| i.to_string()));
    numbers
}

/// The numbers in a text, as they stand there.
pub(crate) fn numbers_in(text: &str) -> Vec<String> {
    let mut numbers = vec![String::new()];
    let mut before = ' ';
    for c in text.chars() {
        let goes_on = c.is_ascii_digit() || (c == '.' && before.is_ascii_digit());
        let exponent = (c == 'e' && before.is_ascii_digit()) || (c == '−' && before == 'e');
        match numbers.last_mut() {
            Some(number) if goes_on || exponent => number.push(c),
            Some(number) if !number.is_empty() => numbers.push(if c == '−' { c.to_string() } else { String::new() }),
            Some(number) if c == '−' => *number = c.to_string(),
            _ => {}
        }
        before = c;
    }
    let trimmed = numbers.into_iter().map(|number| number.trim_end_matches(['e', '.', '−']).to_owned());
    trimmed.filter(|number| !number.is_empty()).collect()
}

/// What a diagram of this kind measures or chooses itself, taken out of a label: lengths to compare with, how far off the plane
/// something is, the ticks of an axis, a sum of small terms.
fn without_own_numbers(kind: Kind, labels: &[&str], i: usize) -> String {
    let label = labels[i];
    match kind {
        // Read back in `first_hit.rs`, formulas and all.
        Kind::Plane | Kind::Triangle | Kind::Box | Kind::Sphere | Kind::Surface => String::new(),
        Kind::Section if label.starts_with("length ") => String::new(),
        Kind::Section => label.split_once(", ").map_or(label, |(ray, _)| ray).to_owned(),
        Kind::Ledger => {
            let is_sum = labels[i.saturating_sub(3)..i].iter().any(|l| l.starts_with("the other") || *l == "one other");
            let digits = label.trim_start_matches(['0', '.']).chars().filter(char::is_ascii_digit).count();
            let is_tick = digits <= 2 && label.parse::<f64>().is_ok();
            if is_sum || is_tick { String::new() } else { label.to_owned() }
        }
        _ => label.to_owned(),
    }
}

#[test]
fn every_diagram_of_every_named_pixel() {
    let mut drawn = 0;
    for_each_pixel(|what, loaded, tree| {
        let numbers = numbers_of(tree);
        for (kind, size) in Kind::ALL.into_iter().flat_map(|kind| [(kind, None), (kind, Some((545.0, 400.0)))]) {
            let input = input(loaded, tree);
            let input = size.map_or(input.clone(), |(width, height)| input.on_page(width, height));
            let what = format!("{what}, {kind}, {size:?}");
            let drawing = match diagram(kind, &input, &Theme::LIGHT) {
                Ok(drawing) => drawing,
                Err(not) => {
                    assert!(!not.why.is_empty() && kind != Kind::Section && kind != Kind::Tree, "{what}: {not}");
                    continue;
                }
            };
            drawn += 1;
            assert!(drawing.canvas().size().cmple(input.size).all(), "{what}: larger than its room");
            check_labels(&what, &drawing);
            assert!(!drawing.description().is_empty(), "{what}");
            let labels: Vec<&str> = drawing.labels().iter().map(|label| label.text.as_str()).collect();
            for i in 0..labels.len() {
                let label = without_own_numbers(kind, &labels, i);
                for number in numbers_in(&label) {
                    assert!(numbers.contains(&number), "{what}: {number} in {:?} is not in the tree", labels[i]);
                }
            }
            let again = diagram(kind, &input, &Theme::LIGHT).unwrap();
            assert!(drawing == again && drawing.to_svg().unwrap() == again.to_svg().unwrap(), "{what}");
        }
    });
    assert!(drawn > 700, "{drawn}");
}

#[test]
fn the_numbers_of_a_label_are_read_back() {
    assert_eq!(numbers_in("5: t 1.134  R 0.3522"), ["5", "1.134", "0.3522"]);
    assert_eq!(numbers_in("−6.46e−19 2e6"), ["−6.46e−19", "2e6"]);
    assert_eq!(numbers_in("the lamp."), [""; 0]);
}

/// A tree that is as hard to draw as a tree can be: `depth` levels that all branch, long names, t from 1e-6 to 1e6.
fn hard_tree(depth: u32, pixel: [u32; 2]) -> RayTree {
    fn node(kind: Ray, level: u32, depth: u32, weight: f64, origin: [f64; 3], sign: f64) -> RayNode {
        let t = [1e-6, 3.5, 1e6, 0.02, 1.0][level as usize % 5];
        let direction = [0.6 * sign, 0.64 - 0.3 * f64::from(level), -0.48];
        let mut ray = RayNode::new(kind, level, origin, direction, Outcome::Hit);
        if level == depth {
            ray.outcome = Outcome::Background;
            ray.radiance = Some([0.3; 3]);
            return ray;
        }
        let point = std::array::from_fn(|k| origin[k] + t * direction[k]);
        let mut hit = HitRecord::new(t, point, 0, [0.0, 1.0, 0.0]);
        hit.object = Some("a chandelier of cut glass with very many pendants, third from the left".to_owned());
        ray.hit = Some(hit);
        ray.weight = Some([weight, 0.9 * weight, 0.8 * weight]);
        ray.radiance = Some([0.2 / f64::from(level + 1); 3]);
        let mut shadow = RayNode::new(Ray::Shadow, level, point, [0.0, 1.0, 0.0], Outcome::Lit);
        shadow.light = Some("the lamp in the corner of the ceiling".to_owned());
        shadow.t_max = Some(1e5);
        ray.shadows.push(shadow);
        ray.reflected = Some(Box::new(node(Ray::Reflected, level + 1, depth, 0.4 * weight, point, -sign)));
        ray.refracted = Some(Box::new(node(Ray::Refracted, level + 1, depth, 0.6 * weight, point, sign)));
        ray
    }
    let mut tree = RayTree::new([0.5; 3], node(Ray::Camera, 0, depth, 1.0, [0.0, 1.0, 5.0], 1.0));
    tree.pixel = Some(pixel);
    tree
}

#[test]
fn trees_that_are_hard_to_draw() {
    let loaded = raytree::scene::load_file("scenes/whitted.json").unwrap();
    for depth in [0, 1, 3, 4, 5, 9] {
        let tree = hard_tree(depth, [388, 190]);
        for kind in Kind::ALL {
            for size in [(880.0, 580.0), (545.0, 400.0), (545.0, 220.0)] {
                let input = input(&loaded, &tree).on_page(size.0, size.1);
                let Ok(drawing) = diagram(kind, &input, &Theme::DARK) else { continue };
                let what = format!("{kind}, {depth} levels, {size:?}");
                check_labels(&what, &drawing);
                assert!(drawing.to_svg().is_ok(), "{what}");
                if kind == Kind::Tree && depth == 9 {
                    let folded = drawing.labels().iter().any(|label| label.text.contains("+ "));
                    assert!(folded, "{what}: 1535 nodes cannot all be there");
                }
            }
        }
    }
}

#[test]
fn any_node_has_its_diagrams() {
    let loaded = raytree::scene::load_file("scenes/whitted.json").unwrap();
    let tree = tree_of(&loaded, loaded.scene.pixels[0].1);
    for (i, (path, node)) in tree.nodes().into_iter().enumerate() {
        let input = Input::new(&loaded.scene, &tree, path.clone()).unwrap();
        assert_eq!((input.number(), input.node), (i + 1, node));
        assert_eq!(path.to_string().parse(), Ok(path.clone()));
        for kind in Kind::ALL {
            if let Ok(drawing) = diagram(kind, &input, &Theme::LIGHT) {
                check_labels(&format!("{kind} of {path}"), &drawing);
                assert!(drawing.to_svg().is_ok(), "{kind} of {path}");
            }
        }
    }
}

#[test]
fn ways_that_lead_nowhere() {
    let loaded = raytree::scene::load_file("scenes/whitted.json").unwrap();
    let tree = tree_of(&loaded, loaded.scene.pixels[0].1);
    let told =
        |path: &str| path.parse::<NodePath>().and_then(|path| path.find(&tree).cloned()).unwrap_err().to_string();
    assert_eq!(
        told("reflected.refracted"),
        "there is no refracted at root.reflected: at root.reflected there are shadows[0] to \"lamp\" and reflected"
    );
    assert!(told("reflected.reflected.reflected").ends_with("root.reflected.reflected has no children"));
    assert!(told("shadows[0]").contains("there are reflected and refracted"));
    for nonsense in ["", "reflection", "shadows", "shadows[x]", "reflected..refracted", "root.root"] {
        assert!(told(nonsense).contains("is no place in a ray tree"), "{nonsense}");
    }
}

/// A picture of one colour, which takes no time.
fn plain_film(loaded: &Loaded) -> Film {
    let size = loaded.scene.image;
    Film { size, pixels: vec![Rgb::splat(0.4); size.width as usize * size.height as usize] }
}

#[test]
fn a_page_of_every_scene() {
    for (name, loaded) in scenes() {
        let film = plain_film(&loaded);
        for (theme, (pixel, place)) in
            [&Theme::LIGHT, &Theme::DARK].into_iter().cycle().zip(&loaded.scene.pixels).take(2)
        {
            let tree = tree_of(&loaded, *place);
            let page = sheet(&input(&loaded, &tree), &film, theme);
            check_labels(&format!("the page of {name}, {pixel}"), &page);
            assert!(page.to_svg().is_ok(), "{name}, {pixel}");
        }
    }
}

/// A dozen pixels whose diagrams are kept as they are.
const KEPT: [(&str, &str, Kind); 12] = [
    ("first-hit", "miss", Kind::Section),
    ("box", "top face", Kind::Section),
    ("mesh", "facet", Kind::Section),
    ("plane", "floor", Kind::Section),
    ("fresnel", "exact rim", Kind::Section),
    ("hard/giant-ground-sphere", "foot of the ball", Kind::Section),
    ("first-tree", "mirrored floor", Kind::Tree),
    ("hall-of-mirrors", "two reflections", Kind::Tree),
    ("glass-ball", "rim", Kind::Tree),
    ("shadows-of-several-lights", "no red", Kind::Tree),
    ("coloured-weights", "gold in blue", Kind::Ledger),
    ("shadows-of-several-lights", "all three lights", Kind::Ledger),
];

/// Draws what is kept.
fn kept() -> Vec<(String, Drawing)> {
    let draw = |(scene, pixel, kind): (&str, &str, Kind)| {
        let loaded = raytree::scene::load_file(&format!("scenes/{scene}.json")).unwrap();
        let place = loaded.scene.pixels.iter().find(|(name, _)| name == pixel).unwrap().1;
        let tree = tree_of(&loaded, place);
        let drawing = diagram(kind, &input(&loaded, &tree).on_page(545.0, 400.0), &Theme::LIGHT).unwrap();
        (format!("{scene}.{pixel}.{kind}").replace(['/', ' '], "-"), drawing)
    };
    KEPT.map(draw).to_vec()
}

#[test]
fn a_dozen_as_svg() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("snapshots/diagrams");
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| {
        for (name, drawing) in kept() {
            insta::assert_snapshot!(name, drawing.to_svg().unwrap());
        }
    });
}

#[test]
fn resvg_draws_diagrams_as_we_draw_the_png() {
    for (name, drawing) in kept() {
        let (mean, off) = difference_to_resvg(&drawing);
        assert!(mean < 0.25 && off < 0.0002, "{name}: mean {mean}, share {off}");
    }
}

#[test]
fn the_commands_draw() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let scene = "scenes/first-tree.json";
    assert_eq!(good(&format!("diagram {scene} 'mirrored floor' --kind tree -o {}", file("a.png"))), "");
    assert!(image::open(file("a.png")).is_ok());
    good(&format!("diagram {scene} 'mirrored floor' --kind section --node reflected --dark -o {}", file("a.svg")));
    assert!(fs::read_to_string(file("a.svg")).unwrap().contains("Section along ray "));
    let tree = good(&format!("sheet {scene} 'mirrored floor' --scale 1 -o {}", file("sheet.png")));
    assert_eq!(tree, good(&format!("pixel {scene} 'mirrored floor'")));
    let page = image::open(file("sheet.png")).unwrap();
    assert_eq!(page.width() * 9, page.height() * 16, "16 : 9");
    good(&format!("gallery {} {scene} --scale 0.5", file("gallery")));
    let index = fs::read_to_string(file("gallery/index.html")).unwrap();
    let linked: BTreeSet<&str> = index.split("=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let linked: Vec<&str> = linked.into_iter().filter(|link| link.ends_with(".png")).collect();
    assert!(linked.len() > 10, "{linked:?}");
    for link in linked {
        assert!(image::open(folder.path().join("gallery").join(link)).is_ok(), "{link}");
    }
    assert!(!index.contains("://"), "nothing from elsewhere");
}

#[test]
fn bad_input_is_answered_with_what_there_is() {
    let scene = "scenes/first-tree.json";
    let kinds = bad(2, &format!("diagram {scene} shadow --kind tre -o x.png"));
    assert!(kinds.contains("there is no kind of diagram `tre`") && kinds.contains("did you mean `tree`?"), "{kinds}");
    assert!(Kind::ALL.into_iter().all(|kind| kinds.contains(&format!("`{kind}`"))), "{kinds}");
    let node = bad(2, &format!("diagram {scene} 'mirrored floor' --kind tree --node refracted -o x.png"));
    assert!(node.contains("there is no refracted at root") && node.contains("and reflected"), "{node}");
    let node = bad(2, &format!("diagram {scene} 'mirrored floor' --kind tree --node left -o x.png"));
    assert!(node.contains("`left` is no place in a ray tree") && node.contains("shadows[0]"), "{node}");
    for command in ["diagram --kind tree", "sheet"] {
        let told = bad(2, &format!("{command} {scene} shadow -o x.gif"));
        assert!(told.contains(".png or .svg"), "{told}");
        assert!(bad(2, &format!("{command} {scene} nowhere -o x.png")).contains("there is no pixel `nowhere`"));
        assert!(bad(3, &format!("{command} {scene} shadow -o nowhere/x.png")).contains("cannot be written"));
        assert!(bad(2, &format!("{command} {scene} shadow -o x.png --scale 9")).contains("from 0.5 to 8"));
    }
    assert!(bad(2, &format!("sheet {scene} shadow -o -")).contains("the same place"));
    let nothing = bad(2, "diagram scenes/hall-of-mirrors.json 'end of the row' --kind ledger -o x.png");
    assert!(nothing.contains("no ray of this tree brought any light") && nothing.contains("`tree`"), "{nothing}");
    assert!(bad(2, "gallery x nowhere").contains("nowhere cannot be read"));
    assert!(bad(2, "gallery x .ci").contains("there are no scenes"));
}
