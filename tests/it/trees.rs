//! Ray trees: every scene x every named pixel is a text snapshot. A new scene file brings its own.

use std::collections::BTreeSet;
use std::path::Path;

use raytree::hits::Acceleration;
use raytree::numbers::Precision;
use raytree::scene::{Loaded, Numerics};
use raytree::tree::{Keep, Show};

use crate::support::{scenes, tracer_with, tree};

const FOLDER: &str = "tests/it/snapshots/trees";

fn slug(name: &str) -> String {
    let dash = |c: char| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    name.chars().map(dash).collect()
}

/// The text of a pixel's tree in the precision that its scene asks for.
fn shown(loaded: &Loaded, numerics: Numerics, name: &str, pixel: [u32; 2]) -> String {
    let show = Show { name: Some(name), certificates: true };
    let tree = match loaded.scene.precision {
        Some(Precision::F32) => {
            tree(&tracer_with::<f32>(&loaded.scene, numerics, Acceleration::Bvh), loaded, pixel, Keep::Outcomes)
        }
        _ => tree(&tracer_with::<f64>(&loaded.scene, numerics, Acceleration::Bvh), loaded, pixel, Keep::Outcomes),
    };
    tree.to_text(show)
}

/// A scene that breaks naive arithmetic shows it: in most of them a named pixel has another tree under the lecture's kernels.
#[test]
fn hard_scenes_are_hard() {
    let differs = |loaded: &Loaded| {
        let both = |(name, pixel): &(String, [u32; 2])| {
            let [certified, lecture] = [Numerics::Certified, Numerics::Lecture].map(|n| shown(loaded, n, name, *pixel));
            let rays =
                |text: &str| text.lines().map(|l| l.split("  [").next().unwrap_or(l).to_owned()).collect::<Vec<_>>();
            rays(&certified) != rays(&lecture)
        };
        loaded.scene.pixels.iter().any(both)
    };
    let hard: Vec<_> = scenes().into_iter().filter(|(name, _)| name.starts_with("hard/")).collect();
    let broken = hard.iter().filter(|(_, loaded)| differs(loaded)).count();
    assert!(hard.len() >= 12 && broken >= 8, "{broken} of {}", hard.len());
}

#[test]
fn every_named_pixel_of_every_scene() {
    let mut wanted = BTreeSet::new();
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new(env!("CARGO_MANIFEST_DIR")).join(FOLDER));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for (scene, loaded) in scenes() {
        assert!(loaded.scene.about.is_some(), "{scene} has no `about`");
        assert!(!loaded.scene.pixels.is_empty(), "{scene} has no named pixels");
        for (name, pixel) in &loaded.scene.pixels {
            let snapshot = format!("{}.{}", slug(&scene), slug(name));
            let mut text = shown(&loaded, Numerics::Certified, name, *pixel);
            if scene.starts_with("hard/") {
                text = format!("certified: {text}\nlecture: {}", shown(&loaded, Numerics::Lecture, name, *pixel));
            }
            settings.bind(|| insta::assert_snapshot!(snapshot.as_str(), text));
            assert!(wanted.insert(format!("{snapshot}.snap")), "two pixels of {scene} are called {name}");
        }
    }
    let there: BTreeSet<String> = std::fs::read_dir(FOLDER)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".snap"))
        .collect();
    let stale: Vec<_> = there.difference(&wanted).collect();
    assert!(stale.is_empty(), "these snapshots belong to no pixel any more: {stale:?}");
}
