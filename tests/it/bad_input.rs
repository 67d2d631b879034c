//! Bad input: one message with where, what, and what would be right.

use raytree::input::Problem;
use raytree::scene;
use raytree::tree::check::read_tree;

/// A good scene; each case spoils one thing in it.
const GOOD: &str = r#"{
  "image": { "width": 8, "height": 6 },
  "camera": { "eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 40 },
  "background": [0.5, 0.5, 0.5],
  "max_depth": 3,
  "lights": [ { "name": "sun", "point": { "position": [0, 5, 5], "color": [1, 1, 1] } } ],
  "materials": { "red": { "color": [1, 0, 0], "diffuse": 1 } },
  "objects": [
    { "name": "ball", "material": "red", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } }
  ],
  "pixels": { "middle": [4, 3] }
}"#;

fn load(text: &str) -> Result<raytree::scene::Loaded, Problem> {
    let meshes = |name: &str| {
        match name {
        "out-of-range.obj" => Ok(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n".to_vec()),
        "empty.obj" => Ok(b"v 0 0 0\n".to_vec()),
        "nan.ply" => Ok(b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n".to_vec()),
        "short.ply" => Ok(b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\0\0\0\0\0\0".to_vec()),
        _ => Err("there is no such file".to_owned()),
    }
    };
    scene::load("bad.json", text, &mut { meshes })
}

/// The message, the line it stands in, and what of it is underlined.
fn told(problem: &Problem) -> String {
    let mut lines = vec![problem.to_string()];
    if let Some(place) = &problem.place {
        lines.push(format!("    {}", place.text));
        let before = place.text[..place.span.start].chars().count();
        let under = place.text[place.span.clone()].chars().count();
        lines.push(format!("    {}{}", " ".repeat(before), "^".repeat(under)));
    }
    lines.join("\n")
}

#[test]
fn scenes() {
    assert!(load(GOOD).is_ok());
    let shape = r#"{ "sphere": { "center": [0, 0, 0], "radius": 1 } }"#;
    let mesh = |file: &str| (shape, format!(r#"{{ "mesh": {{ "file": "{file}" }} }}"#));
    let to = |from: &'static str, to: &str| (from, to.to_owned());
    let cases = [
        to(GOOD, "not json"),
        to(GOOD, ""),
        to(GOOD, "[]"),
        to("  \"max_depth\": 3,\n", "  \"max_depth\": 3\n"),
        to("\"max_depth\": 3,", "\"max_depth\": 3, // deep"),
        to("\"pixels\": { \"middle\": [4, 3] }\n}", "\"pixels\": { \"middle\": [4, 3] }\n} {}"),
        to("\"radius\"", "\"radus\""),
        to("\"max_depth\"", "\"maxdepth\""),
        to("\"sphere\"", "\"spere\""),
        to("\"look_at\": [0, 0, 0], ", ""),
        to("\"materials\": { \"red\": { \"color\": [1, 0, 0], \"diffuse\": 1 } },\n", ""),
        to("\"radius\": 1", "\"radius\": 1, \"radius\": 2"),
        to("\"red\": {", "\"red\": {}, \"red\": {"),
        to("\"radius\": 1", "\"radius\": \"one\""),
        to("\"radius\": 1", "\"radius\": null"),
        to("\"max_depth\": 3", "\"max_depth\": null"),
        to("\"max_depth\": 3", "\"max_depth\": 4294967296"),
        to("\"diffuse\": 1", "\"reflection\": 1, \"ior\": 1.5, \"fresnel\": false"),
        to("\"eye\": [0, 0, 5]", "\"eye\": [0, 0, 5, 1]"),
        to("[4, 3]", "[4, 3, 2]"),
        to("\"middle\"", "\"1,2\""),
        to("{ \"sphere\": { \"center\": [0, 0, 0], \"radius\": 1 } }", "{}"),
        to("{ \"sphere\": { \"center\": [0, 0, 0], \"radius\": 1 } }", "\"sphere\""),
        to("\"radius\": 1 }", "\"radius\": 1 }, \"box\": { \"min\": [0, 0, 0], \"max\": [1, 1, 1] }"),
        to("\"radius\": 1", "\"radius\": 1."),
        to("{ \"width\": 8, \"height\": 6 }", "[8, 6]"),
        to("{ \"center\": [0, 0, 0], \"radius\": 1 }", "[[0, 0, 0], 1]"),
        to("\"center\": [0, 0, 0]", "\"center\": [0, 0]"),
        to("\"diffuse\": 1", "\"diffuse\": [1, 0.5]"),
        to("\"diffuse\": 1", "\"diffuse\": false"),
        to("\"width\": 8", "\"width\": 8.5"),
        to("\"radius\": 1", "\"radius\": NaN"),
        to("\"radius\": 1", "\"radius\": Infinity"),
        to("\"radius\": 1", "\"radius\": 1e999"),
        to("\"radius\": 1", "\"radius\": 1e39"),
        to("\"radius\": 1", "\"radius\": -1"),
        to("\"center\": [0, 0, 0]", "\"center\": [0, 3.1e-45, 0]"),
        to("\"look_at\": [0, 0, 0]", "\"look_at\": [0, 0, 5]"),
        to("\"up\": [0, 1, 0]", "\"up\": [0, 0, -2]"),
        to("\"up\": [0, 1, 0]", "\"up\": [0, 0, 0]"),
        to("\"fov_y_degrees\": 40", "\"fov_y_degrees\": 180"),
        to("\"width\": 8", "\"width\": 0"),
        to("\"width\": 8, \"height\": 6", "\"width\": 1000000, \"height\": 1000000"),
        to("\"max_depth\": 3", "\"max_depth\": 65"),
        to("\"max_depth\": 3", "\"ray_budget\": 0"),
        to("\"max_depth\": 3", "\"min_weight\": -0.5"),
        to("[4, 3]", "[8, 3]"),
        to("\"material\": \"red\"", "\"material\": \"rad\""),
        to("[0.5, 0.5, 0.5]", "{ \"gradient\": { \"bottom\": [0, 0, 0] } }"),
        to("[0.5, 0.5, 0.5]", "[0.5, -0.5, 0.5]"),
        to("\"point\": {", "\"directional\": { \"direction\": [0, -1, 0], \"color\": [1, 1, 1] }, \"point\": {"),
        to(", \"point\": { \"position\": [0, 5, 5], \"color\": [1, 1, 1] }", ""),
        to("\"point\": { \"position\": [0, 5, 5]", "\"directional\": { \"direction\": [0, 0, 0]"),
        to("\"diffuse\": 1", "\"specular\": 1"),
        to("\"diffuse\": 1", "\"transmission\": 1"),
        to("\"diffuse\": 1", "\"reflection\": 1, \"fresnel\": \"exact\""),
        to("\"diffuse\": 1", "\"transmission\": 1, \"ior\": 0"),
        to("\"diffuse\": 1", "\"transmission\": 1, \"ior\": 1.5, \"fresnel\": \"shlick\""),
        to("\"diffuse\": 1", "\"checker\": { \"colors\": [[0, 0, 0], [1, 1, 1]], \"size\": 1 }"),
        to("\"color\": [1, 0, 0]", "\"checker\": { \"colors\": [[0, 0, 0], [1, 1, 1]], \"size\": 0 }"),
        (shape, r#"{ "plane": { "normal": [0, 0, 0], "distance": 1 } }"#.to_owned()),
        (shape, r#"{ "plane": { "normal": [0, 1e-40, 0], "distance": 1 } }"#.to_owned()),
        (shape, r#"{ "box": { "min": [0, 2, 0], "max": [1, 1, 1] } }"#.to_owned()),
        (shape, r#"{ "mesh": { "file": "a.stl" } }"#.to_owned()),
        (shape, r#"{ "mesh": { "file": "empty.obj", "transform": { "scale": 0 } } }"#.to_owned()),
        mesh("nowhere.obj"),
        mesh("out-of-range.obj"),
        mesh("empty.obj"),
        mesh("nan.ply"),
        mesh("short.ply"),
    ];
    let mut told_all = Vec::new();
    for (from, to) in cases {
        assert!(GOOD.contains(from), "{from}");
        let text = GOOD.replacen(from, &to, 1);
        match load(&text) {
            Ok(_) => panic!("this should be refused: {to}"),
            Err(problem) => {
                assert!(!problem.message.is_empty() && !problem.help.is_empty());
                told_all.push(told(&problem));
            }
        }
    }
    insta::assert_snapshot!(told_all.join("\n\n"));
}

#[test]
fn trees() {
    let good = r#"{
  "format": "raytree/1", "color": [0, 0, 0], "rays": 2,
  "root": {
    "kind": "camera", "depth": 0, "weight": [1, 1, 1], "origin": [0, 0, 0], "direction": [0, 0, 1],
    "outcome": "hit", "hit": { "t": 1, "point": [0, 0, 1], "shape": 0, "geometric_normal": [0, 0, -1] },
    "reflected": { "kind": "reflected", "depth": 1, "weight": [1, 1, 1], "origin": [0, 0, 1], "direction": [0, 0, -1], "outcome": "background" }
  }
}"#;
    read_tree("good.json", good).unwrap();
    let cases = [
        ("raytree/1", "raytree/2"),
        ("\"kind\": \"camera\"", "\"kind\": \"shadow\""),
        ("\"depth\": 0", "\"depth\": 1"),
        ("\"kind\": \"reflected\"", "\"kind\": \"refracted\""),
        ("\"depth\": 1", "\"depth\": 2"),
        ("\"outcome\": \"background\"", "\"outcome\": \"lit\""),
        ("\"outcome\": \"hit\"", "\"outcome\": \"background\""),
        ("\"outcome\": \"hit\", \"hit\": {", "\"outcome\": \"hit\", \"hitt\": {"),
        ("\"t\": 1", "\"t\": -1"),
        ("\"direction\": [0, 0, -1]", "\"direction\": [0, 0, 0]"),
        ("\"weight\": [1, 1, 1], \"origin\": [0, 0, 1]", "\"origin\": [0, 0, 1]"),
        ("\"rays\": 2", "\"rays\": -2"),
        ("\"rays\": 2", "\"rays\": 3"),
        ("\"point\": [0, 0, 1]", "\"point\": [0, 1, 1]"),
        ("\"outcome\": \"hit\"", "\"outcome\": \"hit\", \"radiance\": [0, 0, 0.5]"),
        ("\"outcome\": \"background\"", "\"outcome\": \"background\", \"radiance\": null"),
        ("\"color\": [0, 0, 0]", "\"color\": [0, 0, 0, 1]"),
        ("[0, 0, -1] },", "[0, 0, -2] },"),
        ("\"outcome\": \"hit\"", "\"outcome\": \"hit\", \"fresnel\": 1.5"),
        ("\"outcome\": \"hit\"", "\"outcome\": \"hit\", \"t_max\": 0"),
    ];
    let mut told_all = Vec::new();
    for (from, to) in cases {
        assert!(good.contains(from), "{from}");
        let problem = read_tree("bad.json", &good.replacen(from, to, 1)).expect_err(to);
        told_all.push(told(&problem));
    }
    insta::assert_snapshot!(told_all.join("\n\n"));
}

#[test]
fn nesting_without_end_is_refused() {
    let deep = "[".repeat(200_000);
    assert!(load(&deep).unwrap_err().message.contains("EOF"));
    let closed = format!("{deep}{}", "]".repeat(200_000));
    for key in ["about", "objects", "pixels"] {
        let problem = load(&GOOD.replacen('{', &format!("{{ \"{key}\": {closed},"), 1)).unwrap_err();
        assert!(problem.place.is_some(), "{problem}");
    }
    assert!(read_tree("deep.json", &format!("{{ \"format\": \"raytree/1\", \"root\": {closed} }}")).is_err());
}
