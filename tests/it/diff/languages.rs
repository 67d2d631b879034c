//! The small tracers in other languages: their trees are valid and agree with ours, and name a fault that is typed into them.

use std::path::Path;
use std::process::Command;

use raytree::faults::{Fault, name_fault};
use raytree::scene::load_file;
use raytree::tree::check::{parse_tree, read_tree};
use raytree::tree::diff::{Tolerances, diff};
use raytree::tree::{Keep, RayTree};

use crate::support::{grid, tracer, tree};

const FOLDER: &str = "lessons/other-languages";

/// What a program prints, or nothing where there is no such program.
fn output(program: &str, words: &[String]) -> Option<String> {
    let output = Command::new(program).args(words).output().ok()?;
    assert!(output.status.success(), "{program} {words:?}: {}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).unwrap())
}

fn there(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// What the tracer of a language prints for these pixels, or nothing where the language is not on this machine.
fn trees_of(language: &str, places: &[[u32; 2]]) -> Option<String> {
    let words = places.iter().flatten().map(u32::to_string);
    let run = |program: &str, file: &str| {
        there(program).then(|| {
            output(program, &[format!("{FOLDER}/{file}")].into_iter().chain(words.clone()).collect::<Vec<_>>())
        })?
    };
    match language {
        "Python" => run("python3", "tracer.py"),
        "JavaScript" => run("node", "tracer.js"),
        "Java" => run("java", "Tracer.java"),
        _ => {
            let compiler = ["g++", "clang++"].into_iter().find(|compiler| there(compiler))?;
            let folder = tempfile::tempdir().unwrap();
            let program = folder.path().join("tracer").to_string_lossy().into_owned();
            let line = ["-O1", "-std=c++17", "-Wall", "-Werror", "lessons/other-languages/tracer.cpp", "-o", &program];
            output(compiler, &line.map(str::to_owned))?;
            output(&program, &words.collect::<Vec<_>>())
        }
    }
}

#[test]
fn tracers_in_other_languages_agree_with_ours() {
    let loaded = load_file(&format!("{FOLDER}/scene.json")).unwrap();
    let ours = tracer::<f64>(&loaded.scene);
    let named = loaded.scene.pixels.iter().map(|(_, place)| *place);
    let places: Vec<[u32; 2]> = named.chain(grid(&loaded.scene, 60)).collect();
    let mut missing = Vec::new();
    for language in ["C++", "Python", "JavaScript", "Java"] {
        let Some(lines) = trees_of(language, &places) else {
            missing.push(language);
            continue;
        };
        assert_eq!(lines.lines().count(), places.len(), "{language}");
        for (line, place) in lines.lines().zip(&places) {
            let theirs = read_tree(language, line).unwrap_or_else(|problem| panic!("{problem}"));
            assert_eq!(theirs.pixel, Some(*place));
            let difference = diff(&tree(&ours, &loaded, *place, Keep::Outcomes), &theirs, &Tolerances::default());
            assert!(difference.is_same(), "{language}, {place:?}: {}", difference.to_text());
            assert!(difference.missing.iter().all(|missing| ["ior", "hit.ior"].contains(&missing.field.name())));
        }
    }
    if !missing.is_empty() {
        eprintln!("not on this machine, and not tried: {}", missing.join(", "));
    }
}

/// Faults as one types them, in a program that shares nothing with ours.
#[test]
fn a_fault_in_a_foreign_tracer_gets_its_name() {
    if !there("python3") {
        eprintln!("not on this machine, and not tried: Python");
        return;
    }
    let loaded = load_file(&format!("{FOLDER}/scene.json")).unwrap();
    let source = std::fs::read_to_string(format!("{FOLDER}/tracer.py")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for (from, to, pixel, fault) in [
        (
            "1 / material[\"ior\"] if entering else material[\"ior\"]",
            "material[\"ior\"] if entering else 1 / material[\"ior\"]",
            "glass",
            Fault::EtaInverted,
        ),
        ("reflected = sub(direction", "reflected = add(direction", "mirror", Fault::ReflectSign),
        (
            "\"shading_normal\": outward if entering else scale(outward, -1)",
            "\"shading_normal\": outward",
            "glass",
            Fault::NormalNotFlipped,
        ),
        ("mul(material[\"color\"], LIGHT_COLOR)", "material[\"color\"]", "floor", Fault::LightColorIgnored),
        (
            "(-b - math.sqrt(d)) / (2 * a), (-b + math.sqrt(d)) / (2 * a)",
            "(-b - math.sqrt(d)) / (2 * a)",
            "glass",
            Fault::EntryWhenInside,
        ),
        ("level > MAX_DEPTH", "level > MAX_DEPTH + 1", "glass", Fault::LevelOneTooMany),
        ("(x + 0.5)", "x", "mirror", Fault::PixelCorner),
        ("(best[0] if best else t_max)", "t_max", "glass", Fault::LastHitWins),
    ] {
        assert!(source.contains(from), "{from}");
        let place = loaded.scene.pixels.iter().find(|(name, _)| name == pixel).map_or([160, 225], |(_, place)| *place);
        let mut text = source.replace(from, to);
        if fault == Fault::PixelCorner {
            text = text.replace("(y + 0.5)", "y");
        }
        let file = folder.path().join("tracer.py");
        std::fs::write(&file, text).unwrap();
        let theirs = traced(&file, place);
        let named = name_fault(&loaded, &theirs, &Tolerances::default());
        let faults = named.map(|named| named.faults).unwrap_or_default();
        assert_eq!(faults, [fault], "{to}");
    }
}

fn traced(file: &Path, [x, y]: [u32; 2]) -> RayTree {
    let words = [file.to_string_lossy().into_owned(), x.to_string(), y.to_string()];
    parse_tree("tracer.py", &output("python3", &words).unwrap()).unwrap()
}
