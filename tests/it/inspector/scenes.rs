//! Scenes that a page makes of the one it was given.

use serde_json::{Value, json};

use super::{NO_SETTINGS, Site};

const WHITTED: &str = "scenes/whitted.json";

#[test]
fn the_same_text_is_the_same_scene() {
    let site = Site::of(WHITTED);
    let text = std::fs::read_to_string(WHITTED).unwrap();
    assert_eq!(site.posted(&text, &NO_SETTINGS), site.id());
    let other = site.posted(&text, &json!({ "max_depth": 1 }));
    assert_ne!(other, site.id());
    assert_eq!(other, site.posted(&text, &json!({ "max_depth": 1 })));
    assert_ne!(other, site.posted(&text, &json!({ "max_depth": 1, "precision": "f32" })));
    let settings = site.post(&text, &json!({ "max_depth": 70, "numerics": "lecture" })).json()["settings"].clone();
    assert_eq!(settings, json!({ "precision": "f64", "numerics": "lecture", "max_depth": 64 }));
}

#[test]
fn a_bad_text_is_told_where_it_is_bad_and_the_server_lives_on() {
    let site = Site::of(WHITTED);
    let good = std::fs::read_to_string(WHITTED).unwrap();
    let problem = |text: &str| {
        let answer = site.post(text, &NO_SETTINGS);
        assert_eq!(answer.status, 422, "{}", answer.text());
        answer.json()["problem"].clone()
    };
    let told = problem(&good.replacen("\"radius\"", "\"radus\"", 1));
    assert!(told["help"].as_str().unwrap().contains("did you mean `radius`"), "{told}");
    assert_eq!(told["path"], "objects[0].shape.sphere.radus");
    let (line, column) = (told["line"].as_u64().unwrap() as usize, told["column"].as_u64().unwrap() as usize);
    let text = good.replacen("\"radius\"", "\"radus\"", 1);
    let at: String = text
        .lines()
        .nth(line - 1)
        .unwrap()
        .chars()
        .skip(column - 1)
        .take(told["length"].as_u64().unwrap() as usize)
        .collect();
    assert_eq!(at, "\"radus\"");
    // Columns and lengths are in characters, whatever stands in front.
    let told = problem("{ \"about\": \"äöü€𝄞\", \"imäge\": 1 }");
    assert_eq!((told["column"].as_u64(), told["length"].as_u64()), (Some(21), Some(7)), "{told}");
    assert_eq!(problem("")["message"], "the file is empty");
    assert!(problem("{").get("line").is_some());
    assert!(problem(&"[".repeat(100_000)).get("message").is_some());
    assert!(problem("{\"image\": {\"width\": 1e999}}").get("message").is_some());
    let mut huge: Value = serde_json::from_str(&good).unwrap();
    huge["image"] = json!({ "width": 1 << 13, "height": 1 << 13 });
    huge.as_object_mut().unwrap().remove("pixels");
    let told = problem(&huge.to_string());
    assert!(
        told["message"].as_str().unwrap().contains("too large to be inspected") && told["path"] == "image",
        "{told}"
    );
    // What is no post of a scene at all is the client's own fault.
    for body in [
        "",
        "{}",
        "[]",
        "{\"text\": 1}",
        "{\"text\": \"\", \"settings\": {\"depth\": 1}}",
        "\u{0}",
        "{\"text\": \"\"} x",
    ] {
        let request = format!(
            "POST /api/scenes HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nX-Raytree: 1\r\nContent-Type: application/json\r\n\
             Content-Length: {}\r\nConnection: close\r\n\r\n{body}",
            site.port,
            body.len()
        );
        assert_eq!(super::client::ask(site.port, request).status, 400, "{body:?}");
    }
    assert_eq!(site.posted(&good, &NO_SETTINGS), site.id());
}

#[test]
fn meshes_come_from_memory_alone() {
    let site = Site::of("scenes/mesh.json");
    let text = std::fs::read_to_string("scenes/mesh.json").unwrap();
    let value: Value = serde_json::from_str(&text).unwrap();
    let places: Vec<usize> = (0..value["objects"].as_array().unwrap().len())
        .filter(|&i| !value["objects"][i]["shape"]["mesh"].is_null())
        .collect();
    let own = value["objects"][places[0]]["shape"]["mesh"]["file"].as_str().unwrap().to_owned();
    site.posted(&value.to_string(), &NO_SETTINGS);
    let absolute = std::fs::canonicalize(format!("scenes/{own}")).unwrap().to_str().unwrap().to_owned();
    let near = format!("./{own}");
    let dotted = format!("meshes/../{own}");
    for name in [
        "/etc/passwd",
        "/etc/passwd.obj",
        "../x",
        "../x.obj",
        "meshes/gem.obj",
        "",
        "\u{0}.obj",
        &absolute,
        &near,
        &dotted,
    ] {
        let mut other = value.clone();
        other["objects"][places[0]]["shape"]["mesh"]["file"] = json!(name);
        let answer = site.post(&other.to_string(), &NO_SETTINGS);
        assert_eq!(answer.status, 422, "{name:?}");
        let message = answer.json()["problem"]["message"].as_str().unwrap().to_owned();
        assert!(
            message.contains("the meshes that the scene named") || message.contains("neither an OBJ nor a PLY"),
            "{message}"
        );
        assert!(!answer.text().contains("root:"), "{name:?}");
    }
    // The same mesh again and again is memory too.
    let mut many = value.clone();
    let object = value["objects"][places[0]].clone();
    let bytes = std::fs::metadata(format!("scenes/{own}")).unwrap().len() as usize;
    let objects = many["objects"].as_array_mut().unwrap();
    objects.extend(std::iter::repeat_n(object, ((1 << 25) / bytes).min(3000)));
    let answer = site.post(&many.to_string(), &NO_SETTINGS);
    assert_eq!(answer.status, 422);
    assert!(answer.text().contains("more of meshes than the page takes"), "{}", answer.text());
}

#[test]
fn the_last_scenes_are_held_and_the_first_always() {
    let site = Site::of("scenes/first-hit.json");
    let text = std::fs::read_to_string("scenes/first-hit.json").unwrap();
    let post = |i: usize| site.posted(&format!("{text}{}", " ".repeat(i)), &NO_SETTINGS);
    let ids: Vec<String> = (1..=40).map(post).collect();
    let status = |id: &str| site.get(&format!("/api/scenes/{id}/geometry")).status;
    assert_eq!(status(&ids[0]), 404);
    assert_eq!(status(&ids[39]), 200);
    assert_eq!(status(&ids[20]), 200);
    assert_eq!(status(&site.id()), 200);
    // What is used stays.
    (41..=60).for_each(|i| drop(post(i)));
    assert_eq!((status(&ids[20]), status(&ids[21])), (200, 404));
}

#[test]
fn a_tree_that_is_too_large_is_refused_before_it_is_stored() {
    let site = Site::of("scenes/first-hit.json");
    let id = site.posted(&super::endless(), &NO_SETTINGS);
    let answer = site.get(&format!("/api/scenes/{id}/recording?x=0&y=0"));
    assert_eq!(answer.status, 422);
    assert!(answer.json()["why"].as_str().unwrap().contains("too many to step through"), "{}", answer.text());
}
