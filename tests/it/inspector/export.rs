//! The page as one file: the same every time, whole, and in need of nothing.

use std::collections::BTreeSet;
use std::io::Read;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use raytree::inspector::{Inspector, Kept, Settings};
use raytree::pictures::diagrams::{Kind, diagram};
use raytree::pictures::theme::Theme;
use raytree::pictures::{Format, render};
use raytree::scene::load_file;
use raytree::steps::Recording;
use raytree::tree::Keep;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::{Site, input};
use crate::commands::{bad, good};
use crate::support::{tracer, tree};

fn inspector(file: &str) -> Inspector {
    let text = std::fs::read_to_string(file).unwrap();
    Inspector::new(file, &text, Settings::default(), &mut raytree::scene::meshes_beside(file)).unwrap()
}

fn page(inspector: &Inspector, kept: &Kept) -> String {
    inspector.export(kept, &|| {}, &AtomicBool::new(false)).unwrap().unwrap()
}

/// What stands between two texts, the first time.
fn between<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    text.split_once(from).unwrap_or_else(|| panic!("no {from}")).1.split_once(to).unwrap().0
}

const DATA: &str = "<script type=\"application/json\" id=\"recordings\">";

fn data(page: &str) -> Value {
    serde_json::from_str(between(page, DATA, "</script>")).unwrap()
}

/// The bytes of a block.
fn unpacked(block: &Value) -> Vec<u8> {
    let packed = BASE64_STANDARD.decode(block.as_str().unwrap()).unwrap();
    let mut bytes = Vec::new();
    flate2::read::GzDecoder::new(packed.as_slice()).read_to_end(&mut bytes).unwrap();
    bytes
}

fn json_of(block: &Value) -> Value {
    serde_json::from_slice(&unpacked(block)).unwrap()
}

/// A drawing with the outlines of its letters put back.
fn with_glyphs(svg: &str, glyphs: &Value) -> String {
    let whole = svg.split_inclusive('\n').map(|line| {
        let name = line.strip_prefix("<path id=\"").and_then(|line| line.strip_suffix("\"/>\n"));
        name.map_or(line.to_owned(), |name| format!("<path id=\"{name}\" d=\"{}\"/>\n", glyphs[name].as_str().unwrap()))
    });
    whole.collect()
}

#[test]
fn what_a_page_keeps_is_what_the_library_gives() {
    let file = "scenes/first-tree.json";
    let inspector = inspector(file);
    let loaded = load_file(file).unwrap();
    let drawn: Vec<[u32; 2]> = loaded.scene.pixels.iter().map(|(_, pixel)| *pixel).collect();
    let kept = Kept { drawn, all: false };
    let counted = AtomicU64::new(0);
    let done = || {
        counted.fetch_add(1, Ordering::SeqCst);
    };
    let page = inspector.export(&kept, &done, &AtomicBool::new(false)).unwrap().unwrap();
    assert_eq!(counted.into_inner(), inspector.count(&kept));
    assert!(page == self::page(&inspector, &kept), "the same bytes every time");
    let data = data(&page);
    assert_eq!(data["format"], "raytree-export/1");
    let site = Site::of(file);
    let id = site.id();
    assert_eq!(data["scene"], site.good("/api/scene").json());
    assert_eq!(data["geometry"], site.good(&format!("/api/scenes/{id}/geometry")).json());
    let tracer = tracer::<f64>(&loaded.scene);
    let png = render(&tracer, &|| {}, &AtomicBool::new(false)).unwrap().encode(Format::Png).unwrap();
    assert_eq!(data["render"], format!("data:image/png;base64,{}", BASE64_STANDARD.encode(png)));
    let kinds: Vec<&String> = data["overlays"].as_object().unwrap().keys().collect();
    assert_eq!(kinds, ["depth", "rays", "stage", "tests"]);
    for kind in kinds {
        let answer = site.good(&format!("/api/scenes/{id}/overlay?kind={kind}"));
        let (mut rest, mut wanted, width) =
            (answer.body.as_slice(), Vec::<u8>::new(), loaded.scene.image.width as usize);
        while !rest.is_empty() {
            let rows = u32::from_le_bytes(rest[4..8].try_into().unwrap()) as usize;
            wanted.extend(&rest[8..8 + rows * width * 4]);
            rest = &rest[8 + rows * width * 4..];
        }
        assert!(unpacked(&data["overlays"][kind]) == wanted, "{kind}");
    }
    let glyphs = json_of(&data["glyphs"]);
    let pixels = data["pixels"].as_array().unwrap();
    assert_eq!(pixels.len(), loaded.scene.pixels.len());
    for pixel in pixels {
        let [x, y] = ["x", "y"].map(|key| pixel[key].as_u64().unwrap() as u32);
        let block = json_of(&pixel["block"]);
        let tree = tree(&tracer, &loaded, [x, y], Keep::Steps);
        let recording = Recording::of(&loaded.scene, &tree);
        assert_eq!(block["recording"], serde_json::to_value(&recording).unwrap());
        let diagrams = block["diagrams"].as_object().unwrap();
        // Every kind that applies to a node, and whatever a step names.
        let mut wanted = BTreeSet::new();
        for node in &recording.nodes {
            for kind in [Kind::Surface, Kind::Section, Kind::Tree, Kind::Ledger] {
                if kind.is_of_the_whole_tree() && node.parent.is_some() {
                    continue;
                }
                let input = input(&loaded.scene, &tree, node.path.clone(), kind);
                let path = node.path.to_string().replace('[', "%5B").replace(']', "%5D");
                for (name, theme) in [("light", &Theme::LIGHT), ("dark", &Theme::DARK)] {
                    let Ok(drawing) = diagram(kind, &input, theme) else { continue };
                    let key = format!("kind={kind}&node={path}&theme={name}");
                    let svg = diagrams[&key].as_str().unwrap_or_else(|| panic!("{key}"));
                    assert!(with_glyphs(svg, &glyphs) == drawing.to_svg().unwrap(), "{key}");
                    wanted.insert(key);
                }
            }
        }
        for step in &recording.steps {
            let Some(picture) = step.diagram else { continue };
            let node = &recording.nodes[picture.node.unwrap_or(step.node)];
            let path = node.path.to_string().replace('[', "%5B").replace(']', "%5D");
            let shape = picture.shape.map_or(String::new(), |shape| format!("&shape={shape}"));
            let primitive = picture.primitive.map_or(String::new(), |primitive| format!("&primitive={primitive}"));
            for theme in ["light", "dark"] {
                let key = format!("kind={}&node={path}{shape}{primitive}&theme={theme}", picture.kind);
                if diagrams.contains_key(&key) {
                    wanted.insert(key);
                } else {
                    // Only what does not apply is left out.
                    let answer = site.get(&format!("/api/scenes/{id}/diagram?x={x}&y={y}&{key}"));
                    assert_eq!(answer.status, 422, "{key}");
                }
            }
        }
        assert_eq!(diagrams.keys().cloned().collect::<BTreeSet<_>>(), wanted);
    }
    // The server gives the same.
    let answer = site.good(&format!("/api/scenes/{id}/export"));
    assert!(answer.text() == page);
    assert_eq!(answer.header("content-disposition"), Some("attachment; filename=\"first-tree.html\""));
    for query in ["pixel=1", "pixel=1,2,3", "pixel=a,b", "pixel=,", &"pixel=1,1&".repeat(65)] {
        assert_eq!(site.get(&format!("/api/scenes/{id}/export?{query}")).status, 400, "{query}");
    }
    assert_eq!(site.get(&format!("/api/scenes/{id}/export?pixel=9999,0")).status, 422);
}

#[test]
fn a_page_needs_nothing_and_runs_nothing_else() {
    let page = page(&inspector("scenes/first-hit.json"), &Kept { drawn: vec![[160, 120]], all: false });
    let policy = between(&page, "<meta http-equiv=\"Content-Security-Policy\" content=\"", "\">").to_owned();
    let (before, rest) = page.split_once(DATA).unwrap();
    let after = rest.split_once("</script>").unwrap().1;
    let style = between(before, "<style>", "</style>");
    let script = between(after, "<script type=\"module\">", "</script>");
    for text in [style, script] {
        let hash = BASE64_STANDARD.encode(Sha256::digest(text.as_bytes()));
        assert!(policy.contains(&format!("'sha256-{hash}'")), "{policy}");
    }
    assert!(policy.starts_with("default-src 'none';") && !policy.contains("unsafe") && !policy.contains("http"));
    assert!(before.find("Content-Security-Policy").unwrap() < before.find("<style>").unwrap());
    // Nothing is loaded from anywhere, and each of the three ends where it should.
    let html = [before.replace(style, ""), after.replace(script, "")].concat();
    for attribute in [" src=", " href=", " action=", " srcset=", "@import", "<iframe", "<object", "<base"] {
        for place in html.split(attribute).skip(1) {
            assert!(
                attribute == " href=" && place.starts_with("\"data:,\""),
                "{attribute}{}",
                &place[..40.min(place.len())]
            );
        }
    }
    assert!(style.split("url(").skip(1).all(|url| url.starts_with("data:font/")), "a font is missing");
    for word in ["import ", "import(", "export "] {
        assert!(!script.lines().any(|line| line.trim_start().starts_with(word)), "{word}");
    }
    assert_eq!(html.matches("<script").count(), 1, "besides the data");
    assert_eq!(page.matches("</script>").count(), page.matches("<script").count());
    assert!(page.ends_with("</html>\n"));
    let addresses = ["http://", "https://"].iter().flat_map(|scheme| script.match_indices(scheme));
    for (at, _) in addresses {
        assert!(script[at..].starts_with("http://www.w3.org/"), "{}", &script[at..at + 40]);
    }
}

#[test]
fn modules_can_become_one_script() {
    let mut names = BTreeSet::new();
    let mut modules = 0;
    for entry in std::fs::read_dir("src/inspector/page").unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "js") {
            continue;
        }
        modules += 1;
        for line in std::fs::read_to_string(&path).unwrap().lines() {
            if line.starts_with("import") {
                assert!(
                    line.starts_with("import { ") && line.contains(" } from './") && line.ends_with("';"),
                    "{path:?}: {line}"
                );
                assert!(!line.contains(" as "), "{path:?}: {line}");
            }
            let declaration = line.strip_prefix("export ").unwrap_or(line);
            assert!(!declaration.starts_with("default ") && !declaration.starts_with("{ "), "{path:?}: {line}");
            let declaration = declaration.strip_prefix("async ").unwrap_or(declaration);
            let words = ["const ", "let ", "var ", "class ", "function "];
            if let Some(rest) = words.iter().find_map(|word| declaration.strip_prefix(word)) {
                let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || matches!(c, '_' | '$')).collect();
                assert!(names.insert(name.clone()), "{path:?}: another module has {name} as well");
            }
        }
    }
    assert!(modules > 5 && names.len() > 20);
}

#[test]
fn all_pixels_of_a_small_picture() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("small.json").to_str().unwrap().to_owned();
    let mut scene: Value = serde_json::from_str(&std::fs::read_to_string("scenes/first-hit.json").unwrap()).unwrap();
    scene["image"] = json!({ "width": 8, "height": 6 });
    scene["pixels"] = json!({ "middle </script><!-- -->": [4, 3] });
    std::fs::write(&file, scene.to_string()).unwrap();
    let out = folder.path().join("page.html").to_str().unwrap().to_owned();
    assert_eq!(good(&format!("inspect {file} --export {out} --pixel all")), "");
    let page = std::fs::read_to_string(&out).unwrap();
    let data = data(&page);
    assert_eq!(data["scene"]["pixels"][0]["name"], "middle </script><!-- -->");
    let pixels = data["pixels"].as_array().unwrap();
    assert_eq!(pixels.len(), 48);
    for (i, pixel) in pixels.iter().enumerate() {
        assert_eq!((pixel["x"].as_u64(), pixel["y"].as_u64()), (Some(i as u64 % 8), Some(i as u64 / 8)));
        let is_drawn = !json_of(&pixel["block"])["diagrams"].as_object().unwrap().is_empty();
        assert_eq!(is_drawn, i == 3 * 8 + 4, "diagrams of the pixel with a name");
    }
    // A page that was there stays whole when the next one fails.
    scene["image"] = json!({ "width": 65, "height": 64 });
    std::fs::write(&file, scene.to_string()).unwrap();
    assert!(bad(2, &format!("inspect {file} --export {out} --pixel all")).contains("at most 4096"));
    assert_eq!(std::fs::read_to_string(&out).unwrap(), page);
    assert!(bad(2, &format!("inspect {file} --export {out} --pixel 65,0")).contains("outside the image"));
    assert!(bad(2, &format!("inspect {file} --export {out} --pixel nowhere")).contains("there is no pixel"));
    assert!(bad(2, &format!("inspect {file} --pixel all")).contains("--export"));
    assert!(bad(2, &format!("inspect {file} --export {out} --port 1")).contains("--port"));
    assert!(bad(2, &format!("inspect {file} --export {file}")).contains("overwrite"));
    scene.as_object_mut().unwrap().remove("pixels");
    std::fs::write(&file, scene.to_string()).unwrap();
    assert!(bad(2, &format!("inspect {file} --export {out}")).contains("no named pixels"));
    assert_eq!(good(&format!("inspect {file} --export {out} --pixel 1,1")), "");
    std::fs::write(&file, super::endless()).unwrap();
    assert!(bad(2, &format!("inspect {file} --export {out} --pixel 1,1")).contains("too many to step through"));
}

#[test]
fn a_stopped_export_gives_nothing() {
    let inspector = inspector("scenes/whitted.json");
    let stop = AtomicBool::new(true);
    let kept = Kept { drawn: vec![[1, 1]], all: false };
    assert_eq!(inspector.export(&kept, &|| panic!("nothing is done"), &stop), Ok(None));
}
