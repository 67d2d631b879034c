//! The formats: schemas as generated, files that follow them, and trees that read back to the same bits.

use raytree::scene::json::SceneFile;
use raytree::tree::check::read_tree;
use raytree::tree::{Keep, RayTree};
use serde_json::Value;

use crate::support::{scene_files, scenes, tracer, tree};

fn json(file: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap()
}

#[test]
fn the_committed_schemas_are_the_generated_ones() {
    for (file, generated, of) in [
        ("scenes/scene.schema.json", SceneFile::schema(), "scene"),
        ("src/tree/tree.schema.json", RayTree::schema(), "tree"),
    ] {
        let wanted = format!("{:#}\n", generated.as_value());
        let there = std::fs::read_to_string(file).unwrap_or_default();
        assert!(wanted == there, "{file} is out of date: cargo run -- schema {of} -o {file}");
    }
}

/// One tree with everything in it pins the format as programs read it.
#[test]
fn a_tree_as_json() {
    let (_, loaded) = scenes().into_iter().find(|(name, _)| name == "first-tree").unwrap();
    let (_, pixel) = loaded.scene.pixels.iter().find(|(name, _)| name == "shadow").unwrap_or(&loaded.scene.pixels[0]);
    insta::assert_snapshot!(tree(&tracer::<f64>(&loaded.scene), &loaded, *pixel, Keep::Steps).to_json());
}

#[test]
fn every_scene_follows_the_schema_and_names_it() {
    let schema = jsonschema::validator_for(SceneFile::schema().as_value()).unwrap();
    for file in scene_files() {
        let scene = json(&file);
        let errors: Vec<String> = schema.iter_errors(&scene).map(|e| format!("{}: {e}", e.instance_path)).collect();
        assert!(errors.is_empty(), "{file}: {errors:?}");
        let up = "../".repeat(file.matches('/').count() - 1);
        assert_eq!(scene["$schema"], format!("{up}scene.schema.json"), "{file}");
    }
}

#[test]
fn a_scene_written_again_is_the_same_scene() {
    for file in scene_files() {
        let scene: SceneFile = serde_json::from_value(json(&file)).unwrap();
        let again: SceneFile = serde_json::from_str(&serde_json::to_string(&scene).unwrap()).unwrap();
        assert_eq!(scene, again, "{file}");
    }
}

#[test]
fn every_tree_follows_the_schema_and_reads_back_to_the_same_bits() {
    let schema = jsonschema::validator_for(RayTree::schema().as_value()).unwrap();
    for (name, loaded) in scenes() {
        let tracer = tracer::<f64>(&loaded.scene);
        for (pixel, place) in &loaded.scene.pixels {
            for keep in [Keep::Outcomes, Keep::Steps] {
                let tree = tree(&tracer, &loaded, *place, keep);
                let written = tree.to_json();
                assert!(!written.contains("null"), "{name}, {pixel}: an absent key is absent, never null");
                let again = read_tree("tree.json", &written).unwrap_or_else(|p| panic!("{name}, {pixel}: {p}"));
                assert_eq!(written, again.to_json(), "{name}, {pixel}");
                assert_eq!(tree, again, "{name}, {pixel}");
                let value = serde_json::from_str(&written).unwrap();
                let error = schema.iter_errors(&value).next();
                assert!(error.is_none(), "{name}, {pixel}: {error:?}");
            }
        }
    }
}

#[test]
fn numbers_read_back_to_the_same_bits() {
    // Without `float_roundtrip` one in six comes back changed.
    let mut state = 1_u64;
    for _ in 0..20_000 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let x = f64::from_bits(state);
        if x.is_finite() {
            let written = serde_json::to_string(&x).unwrap();
            assert_eq!(serde_json::from_str::<f64>(&written).unwrap().to_bits(), x.to_bits());
        }
    }
}
