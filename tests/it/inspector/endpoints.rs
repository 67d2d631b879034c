//! Every answer against what the library gives.

use std::sync::atomic::{AtomicBool, Ordering};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use raytree::numbers::Stage;
use raytree::pictures::diagrams::{Chosen, Kind, diagram};
use raytree::pictures::theme::Theme;
use raytree::pictures::{render, srgb8};
use raytree::scene::{Loaded, Shape, load_file};
use raytree::steps::Recording;
use raytree::transport::{Options, Tracer};
use raytree::tree::diff::{Tolerances, diff};
use raytree::tree::{Cost, Keep, NodePath, Outcome, TestRecord, Verdict};
use serde_json::{Value, json};

use super::client::Answer;
use super::{NO_SETTINGS, Site, input};
use crate::support::{grid, tracer, tree};

/// The four bytes of each pixel in an answer of bands.
fn pixels(answer: &Answer, loaded: &Loaded) -> Vec<[u8; 4]> {
    let (width, height) = (loaded.scene.image.width as usize, loaded.scene.image.height);
    let mut pixels = Vec::new();
    let (mut rest, mut next) = (answer.body.as_slice(), 0);
    let number = |bytes: &[u8]| u32::from_le_bytes(bytes.try_into().unwrap());
    while !rest.is_empty() {
        let (y, rows) = (number(&rest[..4]), number(&rest[4..8]));
        assert_eq!(y, next, "bands come in order");
        let (band, more) = rest[8..].split_at(rows as usize * width * 4);
        pixels.extend(band.chunks_exact(4).map(|four| <[u8; 4]>::try_from(four).unwrap()));
        (rest, next) = (more, y + rows);
    }
    assert_eq!(next, height, "all rows are there");
    pixels
}

/// A scene with few pixels: the text and what it loads to.
fn small(file: &str, width: u32, height: u32) -> (String, Loaded) {
    let mut value: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    value["image"] = json!({ "width": width, "height": height });
    value.as_object_mut().unwrap().remove("pixels");
    let text = value.to_string();
    let loaded = raytree::scene::load_beside(file, &text).unwrap();
    (text, loaded)
}

#[test]
fn the_page_and_its_files() {
    let site = Site::of("scenes/first-hit.json");
    let page = site.good("/");
    assert_eq!(page.header("content-type"), Some("text/html; charset=utf-8"));
    // As it is in its file, and what it will ask for named at its top.
    let text = page.text();
    let (ahead, own): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.contains("preload"));
    assert_eq!(own.join("\n") + "\n", std::fs::read_to_string("src/inspector/page/index.html").unwrap());
    // Every file of the page but its papers is served, byte by byte; so is whatever the page names.
    for entry in std::fs::read_dir("src/inspector/page").unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if !name.ends_with(".md") && !name.ends_with(".txt") {
            assert_eq!(site.good(&format!("/page/{name}")).body, std::fs::read(&path).unwrap(), "{name}");
            assert_eq!(
                ahead.iter().any(|line| line.contains(&format!("/page/{name}\""))),
                name.ends_with(".js"),
                "{name}"
            );
        }
    }
    assert_eq!(site.good("/page/style.css").header("content-type"), Some("text/css; charset=utf-8"));
    for name in page.text().split("/page/").skip(1).filter_map(|rest| rest.split('"').next()) {
        site.good(&format!("/page/{name}"));
    }
    for name in site.good("/page/style.css").text().split("url(\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        site.good(&format!("/page/{name}"));
    }
}

#[test]
fn the_scene_as_it_is() {
    let file = "scenes/whitted.json";
    let site = Site::of(file);
    let loaded = load_file(file).unwrap();
    let scene = site.good("/api/scene").json();
    assert_eq!(scene["file"], file);
    assert_eq!(scene["text"], std::fs::read_to_string(file).unwrap());
    assert_eq!(scene["about"], loaded.scene.about.clone().unwrap());
    assert_eq!(scene["settings"], json!({ "precision": "f64", "numerics": "certified", "max_depth": 5 }));
    assert_eq!(scene["image"], json!({ "width": loaded.scene.image.width, "height": loaded.scene.image.height }));
    let (name, [x, y]) = &loaded.scene.pixels[0];
    assert_eq!(scene["pixels"][0], json!({ "name": name, "x": x, "y": y }));
    assert_eq!(scene["objects"][0]["name"], loaded.scene.objects[0].name);
    assert_eq!(scene["objects"][0]["shape"]["kind"], "sphere");
    assert!(scene["effects"].as_array().unwrap().iter().any(|effect| effect == "refraction"));
    assert_eq!(scene["lights"][0]["name"], loaded.scene.lights[0].name);
    assert_eq!(scene["lights"][0]["position"].as_array().unwrap().len(), 3);
    // The middle of the image plane lies straight ahead; its corners are as far apart as the picture is wide and high.
    let corner =
        |i: usize| glam::DVec3::from_array(serde_json::from_value(scene["camera"]["corners"][i].clone()).unwrap());
    let camera = loaded.scene.camera;
    let middle = (corner(0) + corner(2)) / 2.0;
    assert!((middle - camera.eye - camera.forward).length() < 1e-12);
    let (width, height) = ((corner(1) - corner(0)).length(), (corner(3) - corner(0)).length());
    assert!((width / height - 640.0 / 480.0).abs() < 1e-12 && (height - 2.0 * camera.half_height).abs() < 1e-12);
    assert!((corner(1) - corner(0)).normalize().dot(camera.right) > 1.0 - 1e-12);
}

#[test]
fn pictures_are_those_of_the_library() {
    let site = Site::of("scenes/mesh.json");
    for (file, settings) in [
        ("scenes/mesh.json", NO_SETTINGS),
        ("scenes/whitted.json", json!({ "precision": "f32", "numerics": "robust", "max_depth": 2 })),
    ] {
        let (text, loaded) = small(file, 57, 43);
        let id = site.posted(&text, &settings);
        let film = if settings == NO_SETTINGS {
            render(&tracer::<f64>(&loaded.scene), &|| {}, &AtomicBool::new(false)).unwrap()
        } else {
            let mut options = Options::of(&loaded.scene);
            options.numerics = raytree::scene::Numerics::Robust;
            options.limits.max_depth = 2;
            render(&Tracer::<f32>::new(&loaded.scene, options).unwrap(), &|| {}, &AtomicBool::new(false)).unwrap()
        };
        let shown = film.pixels.iter().map(|rgb| {
            let [r, g, b] = rgb.to_array().map(srgb8);
            [r, g, b, 255]
        });
        let answer = site.good(&format!("/api/scenes/{id}/render"));
        assert_eq!(pixels(&answer, &loaded), shown.collect::<Vec<_>>(), "{file}");
    }
}

#[test]
fn overlays_are_what_it_took() {
    let site = Site::of("scenes/whitted.json");
    let (text, loaded) = small("scenes/whitted.json", 40, 30);
    let id = site.posted(&text, &NO_SETTINGS);
    let overlay = |kind: &str| -> Vec<f32> {
        let answer = site.good(&format!("/api/scenes/{id}/overlay?kind={kind}"));
        pixels(&answer, &loaded).into_iter().map(f32::from_le_bytes).collect()
    };
    let (rays, depth, tests, stage) = (overlay("rays"), overlay("depth"), overlay("tests"), overlay("stage"));
    let tracer = tracer::<f64>(&loaded.scene);
    for y in 0..30 {
        for x in 0..40 {
            let at = (y * 40 + x) as usize;
            let tree = tree(&tracer, &loaded, [x, y], Keep::Steps);
            let tested: usize = tree.root.walk().filter_map(|node| node.tests.as_ref()).map(Vec::len).sum();
            let traced = tree.root.walk().filter(|node| node.outcome.is_traced());
            assert_eq!(rays[at], tree.rays as f32, "{x},{y}");
            assert_eq!(tests[at], tested as f32, "{x},{y}");
            assert_eq!(tests[at], tracer.pixel(x, y, &Cost).1.tests as f32, "{x},{y}");
            assert_eq!(depth[at], traced.map(|node| node.depth).max().unwrap() as f32, "{x},{y}");
            let decided = match tree.root.outcome {
                Outcome::Hit => {
                    Stage::ALL.iter().position(|s| *s == tree.root.certificate.unwrap().stage).unwrap() as f32
                }
                _ => -1.0,
            };
            assert_eq!(stage[at], decided, "{x},{y}");
        }
    }
    assert!(
        rays.iter().any(|x| *x > 10.0)
            && depth.iter().any(|x| *x > 2.0)
            && stage.contains(&0.0)
            && stage.contains(&-1.0)
    );
    assert!(overlay("time").iter().all(|x| *x > 0.0));
    let plain = site.posted(&text, &json!({ "numerics": "lecture" }));
    assert!(site.get(&format!("/api/scenes/{plain}/overlay?kind=stage")).json()["why"].is_string());
    assert_eq!(site.get(&format!("/api/scenes/{id}/overlay?kind=heat")).status, 400);
    assert_eq!(site.get(&format!("/api/scenes/{id}/overlay")).status, 400);
}

#[test]
fn a_picture_that_was_begun_before_is_the_same() {
    let site = Site::of("scenes/first-tree.json");
    let loaded = load_file("scenes/first-tree.json").unwrap();
    let path = format!("/api/scenes/{}/render", site.id());
    let plain = pixels(&site.good(&path), &loaded);
    let stop = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| site.inspector.paint(&stop));
        // Asked for while it grows, and by two at once.
        let other = scope.spawn(|| pixels(&site.good(&path), &loaded));
        assert!(plain == pixels(&site.good(&path), &loaded) && plain == other.join().unwrap());
    });
    assert!(plain == pixels(&site.good(&path), &loaded), "when it is done");
    // A picture that was stopped is made to its end by those who ask.
    let site = Site::of("scenes/first-tree.json");
    let stopped = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| site.inspector.paint(&stopped));
        scope.spawn(|| stopped.store(true, Ordering::SeqCst));
        assert!(plain == pixels(&site.good(&path), &loaded), "while it is stopped");
    });
    assert!(plain == pixels(&site.good(&path), &loaded), "after it was stopped");
}

/// What the page shows of a pixel that was clicked, by a recording: the step of the camera ray's best hit, or its last test.
fn decisive(recording: &Recording<'_>) -> String {
    let of_tests = || recording.steps.iter().filter(|step| step.node == 0).filter_map(|step| Some((step, step.test?)));
    let is_best = |test: usize| match &recording.nodes[0].ray.tests.as_ref().unwrap()[test] {
        TestRecord::Shape(test) => test.verdict == Verdict::Best,
        TestRecord::Bounds(_) => false,
    };
    let best = of_tests().rfind(|(step, test)| is_best(*test) && step.arithmetic.is_some());
    let Some(picture) = best.or(of_tests().next_back()).and_then(|(step, _)| step.diagram) else {
        return "kind=section".into();
    };
    let shape = picture.shape.map_or(String::new(), |shape| format!("&shape={shape}"));
    format!("kind={}{shape}{}", picture.kind, picture.primitive.map_or(String::new(), |p| format!("&primitive={p}")))
}

#[test]
fn recordings_and_diagrams_are_those_of_the_library() {
    for file in ["scenes/whitted.json", "scenes/smooth-mesh.json"] {
        let site = Site::of(file);
        let id = site.id();
        let loaded = load_file(file).unwrap();
        let tracer = tracer::<f64>(&loaded.scene);
        for (_, [x, y]) in &loaded.scene.pixels {
            let tree = tree(&tracer, &loaded, [*x, *y], Keep::Steps);
            let recording = site.good(&format!("/api/scenes/{id}/recording?x={x}&y={y}"));
            assert_eq!(recording.text(), Recording::of(&loaded.scene, &tree).to_json());
            // What decides about the camera ray, by that name and by that of the shape: what the step shows that its
            // recording says decides.
            let of_the_verdict = site.good(&format!("/api/scenes/{id}/diagram?x={x}&y={y}&kind=verdict&theme=dark"));
            let about = of_the_verdict.header("x-raytree-diagram").unwrap().to_owned();
            let same = site.good(&format!("/api/scenes/{id}/diagram?x={x}&y={y}&{about}&theme=dark"));
            assert_eq!(of_the_verdict.text(), same.text(), "{about}");
            assert_eq!(about, decisive(&Recording::of(&loaded.scene, &tree)), "{file} {x},{y}");
            for (path, node) in tree.nodes().into_iter().take(4) {
                let chosen = node.hit.as_ref().map(|hit| Chosen { shape: hit.shape, primitive: hit.primitive });
                for kind in Kind::ALL {
                    for (theme, colors) in [("light", &Theme::LIGHT), ("dark", &Theme::DARK)] {
                        for chosen in [None, chosen] {
                            let input = input(&loaded.scene, &tree, path.clone(), kind);
                            let input = chosen.map_or(input.clone(), |chosen| input.about(chosen));
                            let place = path.to_string().replace('[', "%5B").replace(']', "%5D");
                            let about = chosen.map_or(String::new(), |Chosen { shape, primitive }| {
                                let primitive = primitive.map_or(String::new(), |p| format!("&primitive={p}"));
                                format!("&shape={shape}{primitive}")
                            });
                            let query = format!("x={x}&y={y}&kind={kind}&node={place}&theme={theme}{about}");
                            let answer = site.get(&format!("/api/scenes/{id}/diagram?{query}"));
                            match diagram(kind, &input, colors) {
                                Ok(drawing) => {
                                    assert_eq!(
                                        (answer.status, answer.text()),
                                        (200, drawing.to_svg().unwrap()),
                                        "{query}"
                                    );
                                    assert_eq!(answer.header("content-type"), Some("image/svg+xml"));
                                }
                                Err(not) => {
                                    assert_eq!(
                                        (answer.status, &answer.json()["why"]),
                                        (422, &json!(not.why)),
                                        "{query}"
                                    );
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_asked_for_wrongly() {
    let site = Site::of("scenes/whitted.json");
    let id = site.id();
    for (query, status) in [
        ("recording", 400),
        ("recording?x=1", 400),
        ("recording?x=1&y=", 400),
        ("recording?x=1&y=-1", 400),
        ("recording?x=1&y=%2B1", 400),
        ("recording?x=1&y=1.0", 400),
        ("recording?x=640&y=0", 400),
        ("recording?x=0&y=480", 400),
        ("recording?x=99999999999999999999&y=0", 400),
        ("recording?x=1&y=1&x=1", 400),
        ("recording?x=1&y=1&z=1", 400),
        ("diagram?x=1&y=1", 400),
        ("diagram?x=1&y=1&kind=nonsense", 400),
        ("diagram?x=1&y=1&kind=tree&node=up", 400),
        ("diagram?x=1&y=1&kind=tree&node=root.shadows%5B18446744073709551616%5D", 400),
        ("diagram?x=1&y=1&kind=tree&node=root.refracted.refracted", 422),
        ("diagram?x=1&y=1&kind=tree&theme=pink", 400),
        ("diagram?x=1&y=1&kind=sphere&primitive=1", 400),
        ("diagram?x=1&y=1&kind=sphere&shape=4294967295", 422),
        ("diagram?x=1&y=1&kind=sphere&shape=4294967296", 400),
        ("nonsense", 404),
    ] {
        let answer = site.get(&format!("/api/scenes/{id}/{query}"));
        assert_eq!(answer.status, status, "{query}: {}", answer.text());
        let told = answer.json();
        assert!(told["problem"]["message"].is_string() || told["why"].is_string(), "{query}");
    }
    let unknown = site.get("/api/scenes/0123456789abcdef/recording?x=1&y=1");
    assert_eq!(unknown.status, 404);
    assert!(unknown.json()["problem"]["help"].as_str().unwrap().contains("again"));
}

#[test]
fn shapes_for_the_view_in_three_dimensions() {
    let site = Site::of("scenes/mesh.json");
    let loaded = load_file("scenes/mesh.json").unwrap();
    let geometry = site.good(&format!("/api/scenes/{}/geometry", site.id())).json();
    let mut meshes = 0;
    for (object, part) in loaded.scene.objects.iter().zip(geometry["objects"].as_array().unwrap()) {
        assert_eq!(part["name"], object.name);
        let Shape::Mesh(mesh) = &object.shape else { continue };
        meshes += 1;
        let words = |key: &str| -> Vec<[u8; 4]> {
            let bytes = BASE64_STANDARD.decode(part[key].as_str().unwrap()).unwrap();
            bytes.chunks_exact(4).map(|four| four.try_into().unwrap()).collect()
        };
        let positions: Vec<f32> = words("positions").into_iter().map(f32::from_le_bytes).collect();
        let indices: Vec<u32> = words("indices").into_iter().map(u32::from_le_bytes).collect();
        let corners = indices.iter().flat_map(|&i| positions[3 * i as usize..3 * i as usize + 3].to_vec());
        let wanted = mesh.triangles.iter().flatten().flat_map(|corner| corner.to_array().map(|x| x as f32));
        assert!(corners.eq(wanted), "{}", object.name);
        assert!(positions.len() / 3 < mesh.triangles.len() * 3 / 2, "corners are shared");
    }
    assert!(meshes > 0);
    let site = Site::of("scenes/whitted.json");
    let geometry = site.good(&format!("/api/scenes/{}/geometry", site.id())).json();
    assert_eq!(geometry["objects"][0]["kind"], "sphere");
    assert!(geometry["objects"][0]["transparent"].as_bool().unwrap());
}

#[test]
fn a_path_that_is_the_root_may_be_left_out() {
    let site = Site::of("scenes/first-hit.json");
    let (id, loaded) = (site.id(), load_file("scenes/first-hit.json").unwrap());
    let [x, y] = grid(&loaded.scene, 1)[0];
    let ask = |more: &str| site.good(&format!("/api/scenes/{id}/diagram?x={x}&y={y}&kind=tree{more}")).text();
    assert_eq!(ask(""), ask(&format!("&node={}&theme=light", NodePath::ROOT)));
}

#[test]
fn the_difference_that_a_change_makes() {
    let file = "scenes/whitted.json";
    let site = Site::of(file);
    let (before, loaded) = (site.id(), load_file(file).unwrap());
    let text = std::fs::read_to_string(file).unwrap();
    let [x, y] = loaded.scene.pixels.iter().find(|(name, _)| name == "glass edge").unwrap().1;
    let ask = |id: &str| site.good(&format!("/api/scenes/{id}/difference?x={x}&y={y}&from={before}")).json();
    assert_eq!(ask(&before)["divergences"], json!([]));
    let changed = text.replacen("\"ior\": 1.5", "\"ior\": 1.3", 1);
    assert_ne!(changed, text);
    let after = site.posted(&changed, &NO_SETTINGS);
    let other = raytree::scene::load_beside(file, &changed).unwrap();
    let [a, b] = [&loaded, &other].map(|loaded| tree(&tracer::<f64>(&loaded.scene), loaded, [x, y], Keep::Steps));
    let wanted = diff(&a, &b, &Tolerances::of(&a, &b));
    assert!(!wanted.divergences.is_empty());
    let told = ask(&after);
    assert_eq!(told, serde_json::to_value(&wanted).unwrap());
    assert_eq!(told["colors"], json!([a.color, b.color]));
    assert_eq!(site.get(&format!("/api/scenes/{after}/difference?x={x}&y={y}")).status, 400);
    assert_eq!(site.get(&format!("/api/scenes/{after}/difference?x={x}&y={y}&from=x")).status, 404);
}
