//! Ray trees: every scene x every named pixel is a text snapshot. A new scene file brings its own.

use std::collections::BTreeSet;
use std::path::Path;

use raytree::tree::{Keep, Show};

use crate::support::{scenes, tracer, tree};

const FOLDER: &str = "tests/it/snapshots/trees";

fn slug(name: &str) -> String {
    let dash = |c: char| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    name.chars().map(dash).collect()
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
        let tracer = tracer::<f64>(&loaded.scene);
        for (name, pixel) in &loaded.scene.pixels {
            let snapshot = format!("{}.{}", slug(&scene), slug(name));
            let text =
                tree(&tracer, &loaded, *pixel, Keep::Outcomes).to_text(Show { name: Some(name), certificates: true });
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
