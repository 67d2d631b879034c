//! `raytree diff` and `raytree forest` as a shell sees them, and the picture of a parting.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use raytree::faults::{Fault, Textbook};
use raytree::pictures::diagrams::parting;
use raytree::pictures::theme::Theme;
use raytree::tree::RayTree;
use raytree::tree::check::read_tree;
use raytree::tree::diff::{Tolerances, diff};

use super::trees::named;
use crate::commands::{bad, good};
use crate::diagrams::check_labels;

fn run(folder: &Path, line: &str, input: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.current_dir(folder).args(line.split_whitespace());
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    // Who does not read its input closes it.
    child.stdin.take().unwrap().write_all(input.as_bytes()).ok();
    child.wait_with_output().unwrap()
}

/// Exit code, standard output, standard error.
fn said(folder: &Path, line: &str, input: &str) -> (i32, String, String) {
    let output = run(folder, line, input);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// A tree, and the same with another `t` two rays down.
fn two() -> (RayTree, RayTree) {
    let right = named("whitted", "glass edge");
    let mut wrong = right.clone();
    wrong.root.refracted.as_mut().unwrap().hit.as_mut().unwrap().t *= 1.0001;
    (right, wrong)
}

#[test]
fn two_files() {
    let folder = tempfile::tempdir().unwrap();
    let (right, wrong) = two();
    fs::write(folder.path().join("a.json"), right.to_json()).unwrap();
    fs::write(folder.path().join("b.json"), wrong.to_json_line()).unwrap();
    let say = |line: &str, input: &str| said(folder.path(), line, input);

    let (code, out, err) = say("diff a.json a.json", "");
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.starts_with("no parting: 17 rays agree"), "{out}");

    let (code, out, err) = say("diff a.json b.json", "");
    assert_eq!((code, err.as_str()), (1, ""));
    assert_eq!(out, diff(&right, &wrong, &Tolerances::default()).to_text());
    assert!(out.starts_with("they part at root.refracted, hit.t\n"), "{out}");
    assert_eq!(say("diff a.json -", &wrong.to_json()), (1, out.clone(), String::new()));
    assert_eq!(say("diff - b.json", &right.to_json()), (1, out, String::new()));

    for tolerance in ["--relative 1e-3", "--tolerance hit.t=1e-3", "--ulps 0 --tolerance hit.t=1e13ulp"] {
        assert_eq!(say(&format!("diff a.json b.json {tolerance}"), "").0, 0, "{tolerance}");
    }
    assert_eq!(say("diff a.json b.json --ulps 4", "").0, 1);
    let json: serde_json::Value = serde_json::from_str(&say("diff a.json b.json --json", "").1).unwrap();
    assert_eq!(json["divergences"][0]["path"], "root.refracted");
    assert_eq!(json["divergences"][0]["field"], "hit.t");

    for (line, words) in [
        ("diff - -", "both trees would come from standard input"),
        ("diff a.json none.json", "there is no such file"),
        ("diff a.json b.json --ulps -1", "a number of 0 or more"),
        ("diff a.json b.json --tolerance hit.tt=1", "did you mean `hit.t`"),
        ("diff a.json b.json --tolerance outcome=1", "agrees exactly"),
        ("diff a.json b.json -o parting.gif", "a path that ends in .png or .svg"),
        ("diff a.json b.json -o a.json", "a path that ends in .png or .svg"),
        ("diff a.json b.json -o -", "would go to the same place"),
    ] {
        let (code, out, err) = say(line, "");
        assert!(code == 2 && out.is_empty() && err.contains(words), "{line}: {code} {err}");
    }
    for text in ["", "{", "[1]", "{\"format\": \"raytree/2\"}", "not json"] {
        let (code, out, err) = say("diff a.json -", text);
        assert!(code == 2 && out.is_empty() && !err.contains("panicked"), "{text}: {code} {err}");
    }
}

/// A tree that `check` refuses is what a tracer with a fault writes.
#[test]
fn a_tree_that_contradicts_itself_is_compared_and_named() {
    let folder = tempfile::tempdir().unwrap();
    let (right, mut wrong) = two();
    wrong.root.hit.as_mut().unwrap().t = -1.0;
    assert!(read_tree("b.json", &wrong.to_json()).is_err());
    fs::write(folder.path().join("a.json"), right.to_json()).unwrap();
    let (code, out, err) = said(folder.path(), "diff a.json -", &wrong.to_json());
    assert_eq!((code, err.as_str()), (1, ""));
    assert!(out.starts_with("they part at root, hit.t\n  A  4.6065"), "{out}");
    assert!(out.contains("note: B is no valid tree at root.hit.t: a hit behind the ray's start"), "{out}");
}

/// The scene is the one that a tree names, if it is still that, or the one that is given; else no fault is looked for.
#[test]
fn the_fault_is_named_where_the_scene_is_known() {
    let folder = tempfile::tempdir().unwrap();
    let scene = fs::read_to_string("scenes/glass-ball.json").unwrap();
    fs::write(folder.path().join("scene.json"), &scene).unwrap();
    let loaded = raytree::scene::load("scene.json", &scene, &mut |_| Err("none".into())).unwrap();
    let [x, y] = loaded.scene.pixels[0].1;
    let wrong = Textbook::new(&loaded.scene).with(Fault::EtaInverted).pixel(x, y).to_json();
    let say = |line: &str, input: &str| said(folder.path(), line, input);
    assert_eq!(say(&format!("pixel scene.json {x},{y} --json -o right.json"), "").0, 0);
    let words = "\none fault gives the whole of B: eta is the wrong way round (eta-inverted)\n";
    for line in ["diff right.json -", "diff right.json - --scene scene.json"] {
        let (code, out, err) = say(line, &wrong);
        assert!(code == 1 && err.is_empty() && out.contains(words), "{line}: {out}");
    }
    assert!(say("diff - right.json", &wrong).1.contains("gives the whole of A: eta"));
    let json: serde_json::Value = serde_json::from_str(&say("diff right.json - --json", &wrong).1).unwrap();
    assert_eq!((&json["fault"]["tree"], &json["fault"]["field"]), (&"B".into(), &"direction".into()));
    assert_eq!(json["fault"]["faults"][0]["name"], "eta-inverted");
    assert_eq!(json["fault"]["path"], "root.refracted");
    assert_eq!(json["divergences"][0]["path"], "root.refracted");

    // What no single fault gives is said to be that; and where the scene has changed nothing is said.
    let strange = wrong.replacen("\"weight\": [1.0, 1.0, 1.0]", "\"weight\": [0.5, 0.5, 0.5]", 1);
    assert_ne!(strange, wrong);
    let (_, out, _) = say("diff right.json -", &strange);
    assert!(out.contains("note: none of the 33 classic faults alone gives that tree"), "{out}");
    fs::write(folder.path().join("scene.json"), scene.replace("0.75 }", "0.7 }")).unwrap();
    let (code, out, _) = say("diff right.json -", &wrong);
    assert!(code == 1 && !out.contains("fault"), "{out}");
    let (_, out, _) = say("diff right.json - --scene scene.json", &wrong);
    assert!(out.contains("note: A is of another scene than --scene"), "{out}");
    assert_eq!(say("diff right.json - --scene none.json", &wrong).0, 2);
}

#[test]
fn the_picture_of_a_parting() {
    let (right, mut wrong) = two();
    wrong.root.reflected = None;
    for (a, b) in [(&right, &wrong), (&wrong, &right), (&right, &right)] {
        let difference = diff(a, b, &Tolerances::default());
        for theme in [&Theme::LIGHT, &Theme::DARK] {
            let drawing = parting(a, b, &difference, theme);
            check_labels("parting", &drawing);
            assert_eq!(drawing.description(), difference.to_text());
            assert!(drawing.to_png(1.0).is_ok());
        }
    }
    let drawing = parting(&right, &wrong, &diff(&right, &wrong, &Tolerances::default()), &Theme::LIGHT);
    let labels: Vec<&str> = drawing.labels().iter().map(|label| label.text.as_str()).collect();
    for words in ["no such ray", "reflected not there", "hit.t 1.134", "reflected hit"] {
        assert!(labels.iter().any(|label| label.contains(words)), "{words}: {labels:?}");
    }

    // A large tree is cut down to what parts and where that is.
    let right = named("hall-of-mirrors", "end of the row");
    let mut wrong = right.clone();
    let deep = std::iter::successors(Some(&right.root), |node| node.reflected.as_deref()).count() - 1;
    assert!(deep >= 5, "{deep}");
    let mut node = &mut wrong.root;
    for _ in 0..deep {
        node = node.reflected.as_mut().unwrap();
    }
    node.direction[0] += 0.5;
    let drawing = parting(&right, &wrong, &diff(&right, &wrong, &Tolerances::default()), &Theme::LIGHT);
    check_labels("a deep parting", &drawing);
    assert!(drawing.labels().iter().any(|label| label.text.starts_with("direction ")), "{:?}", drawing.labels());
    assert!(drawing.canvas().size().y < 1400.0);

    let folder = tempfile::tempdir().unwrap();
    let (right, wrong) = two();
    fs::write(folder.path().join("a.json"), right.to_json()).unwrap();
    for (file, begins) in [("p.svg", &b"<svg"[..]), ("p.png", b"\x89PNG")] {
        assert_eq!(said(folder.path(), &format!("diff a.json - -o {file} --dark"), &wrong.to_json()).0, 1);
        assert!(fs::read(folder.path().join(file)).unwrap().starts_with(begins), "{file}");
    }
}

#[test]
fn forests_of_a_scene() {
    let folder = tempfile::tempdir().unwrap();
    let scene = fs::read_to_string("scenes/whitted.json").unwrap();
    let small = scene.replace(r#""width": 640, "height": 480"#, r#""width": 24, "height": 18"#);
    let small = &small[..small.find(r#""pixels""#).unwrap()].trim_end().trim_end_matches(',').to_owned();
    fs::write(folder.path().join("a.json"), format!("{small} }}")).unwrap();
    fs::write(folder.path().join("b.json"), format!("{small} }}").replace("0.75 }", "0.5 }")).unwrap();
    let say = |line: &str, input: &str| said(folder.path(), line, input);
    for (scene, threads) in [("a", 1), ("a", 3), ("b", 2)] {
        let line = format!("forest {scene}.json -o {scene}{threads}.ndjson --threads {threads}");
        assert_eq!(say(&line, ""), (0, String::new(), String::new()));
    }
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let lines = read("a1.ndjson");
    assert_eq!(lines, read("a3.ndjson"), "threads change nothing");
    assert_eq!(say("forest a.json -o -", "").1, lines);
    assert_eq!(lines.lines().count(), 24 * 18);
    // Rows from the top, and each the tree of its pixel.
    let tree = read_tree("line", lines.lines().nth(24 * 7 + 5).unwrap()).unwrap();
    assert_eq!(tree.pixel, Some([5, 7]));
    assert_eq!(tree, read_tree("pixel", &say("pixel a.json 5,7 --json", "").1).unwrap());

    assert_eq!(say("diff a1.ndjson a3.ndjson", "").0, 0);
    let (code, out, _) = say("diff a1.ndjson b2.ndjson", "");
    assert_eq!(code, 1);
    insta::assert_snapshot!("forests", out);
    // In any order, and as an array.
    let mut turned: Vec<&str> = lines.lines().rev().collect();
    assert_eq!(say("diff a1.ndjson -", &turned.join("\n\n")).0, 0);
    let array = format!("[{}]", turned.join(","));
    assert_eq!(say("diff a1.ndjson -", &array).0, 0);
    turned.truncate(24);
    let (code, out, _) = say("diff a1.ndjson - --json", &turned.join("\n"));
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &json["only_in_a"], &json["same"]), (1, &(24 * 17).into(), &24.into()));

    for (input, words) in [
        (format!("{0}{0}{0}", lines.lines().next().unwrap().to_owned() + "\n"), "pixel 0,0 is there twice"),
        (lines.replacen("\"pixel\":[1,0],", "", 1), "without `pixel`"),
        (lines.replacen("\"kind\":\"camera\"", "\"kind\":\"camel\"", 3), "camel"),
    ] {
        let (code, out, err) = say("diff a1.ndjson -", &input);
        assert!(code == 2 && out.is_empty() && err.contains(words), "{words}: {code} {err}");
    }
    // The line at fault is told.
    let (_, _, err) = say(
        "diff a1.ndjson -",
        &lines.replacen("\"format\":\"raytree/1\",\"generator\"", "\"format\":\"raytree/1\",\"gen\"", 5),
    );
    assert!(err.contains("<stdin>:1:"), "{err}");
    let fifth = lines.lines().nth(4).unwrap();
    let (_, _, err) = say("diff a1.ndjson -", &lines.replace(fifth, &fifth.replace("\"rays\"", "\"rayz\"")));
    assert!(err.contains("<stdin>:5:"), "{err}");
    assert!(bad(2, "diff README.md README.md").contains("README.md"));
    assert!(good("help diff").contains("FIELD=TOLERANCE"));
}
