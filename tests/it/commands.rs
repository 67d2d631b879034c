//! The commands as a shell sees them: exit codes, what goes where, files that are whole or not there.

use std::fs::{self, File};
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Command, Output, Stdio};

const SCENE: &str = "scenes/whitted.json";

fn raytree() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.stdin(Stdio::null());
    command
}

/// Runs the words of a command line, single quotes kept together.
fn run(line: &str) -> Output {
    let mut words = Vec::new();
    for (i, part) in line.split('\'').enumerate() {
        match i % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    raytree().args(words).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Standard output of a command that goes well and says nothing on standard error.
pub(crate) fn good(line: &str) -> String {
    let output = run(line);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""), "{line}");
    text(&output.stdout)
}

/// Standard error of a command that goes wrong and says nothing on standard output.
pub(crate) fn bad(code: i32, line: &str) -> String {
    let output = run(line);
    assert_eq!((output.status.code(), text(&output.stdout).as_str()), (Some(code), ""), "{line}");
    let told = text(&output.stderr);
    assert!(!told.trim().is_empty() && !told.contains("panicked"), "{line}: {told}");
    told
}

#[test]
fn a_pixel_by_name_and_by_place() {
    let loaded = raytree::scene::load_file(SCENE).unwrap();
    let (name, [x, y]) = &loaded.scene.pixels[0];
    let by_name = good(&format!("pixel {SCENE} '{name}'"));
    assert!(by_name.starts_with(&format!("pixel {x},{y}  \"{name}\"   rgb ")), "{by_name}");
    assert_eq!(by_name, good(&format!("pixel {SCENE} {x},{y}")));
    assert_eq!(by_name, good(&format!("pixel {SCENE} {x},{y} --acceleration list")));
    let json: serde_json::Value = serde_json::from_str(&good(&format!("pixel {SCENE} '{name}' --json"))).unwrap();
    assert_eq!(json["format"], "raytree/1");
    assert_eq!(json["scene"]["file"], SCENE);
    assert!(json["root"]["tests"].is_null());
    assert!(good(&format!("pixel {SCENE} '{name}' --json --steps")).contains("\"tests\""));
    assert!(good(&format!("pixel {SCENE} '{name}' --steps")).contains("discriminant negative"));
    assert!(good(&format!("pixel {SCENE} '{name}' --ledger")).contains("balances"));
    assert!(good(&format!("pixel {SCENE} '{name}' --certificates")).contains("[filter, margin "));
    let shallow = good(&format!("pixel {SCENE} '{name}' --max-depth 0 --precision f32 --numerics robust --json"));
    let shallow: serde_json::Value = serde_json::from_str(&shallow).unwrap();
    assert_eq!(shallow["settings"]["max_depth"], 0);
    assert_eq!(shallow["settings"]["precision"], "f32");
    assert_eq!(shallow["settings"]["numerics"], "robust");
}

#[test]
fn vectors_that_begin_with_a_minus_sign() {
    let tree = good(&format!("ray {SCENE} -1,2,5 -0.1,-.2,-1 --json"));
    let json: serde_json::Value = serde_json::from_str(&tree).unwrap();
    assert_eq!(json["root"]["origin"], serde_json::json!([-1.0, 2.0, 5.0]));
    assert_eq!(json["root"]["direction"], serde_json::json!([-0.1, -0.2, -1.0]));
    assert!(json["pixel"].is_null());
    assert_eq!(tree, good(&format!("ray --json {SCENE} -- -1,2,5 -0.1,-.2,-1")));
}

#[test]
fn bad_command_lines() {
    assert!(bad(2, &format!("pixel {SCENE} nowhere")).contains("there is no pixel `nowhere`"));
    let known = &raytree::scene::load_file(SCENE).unwrap().scene.pixels[0].0;
    assert!(bad(2, &format!("pixel {SCENE} nowhere")).contains(known.as_str()), "the known names are listed");
    assert!(bad(2, &format!("pixel {SCENE} 100000,0")).contains("lies outside the image"));
    assert!(bad(2, &format!("pixel {SCENE} 1,-1")).contains("lies outside the image"));
    assert!(bad(2, &format!("ray {SCENE} 0,0,0 0,0,0")).contains("length zero"));
    assert!(bad(2, &format!("ray {SCENE} 0,0,0 -inf,0,0")).contains("`-inf` is not finite"));
    assert!(bad(2, &format!("ray {SCENE} nan,0,0 0,0,1")).contains("`nan` is not finite"));
    assert!(bad(2, &format!("ray {SCENE} 0,0 0,0,1")).contains("has 2 components"));
    assert!(bad(2, &format!("ray {SCENE} 0,0,x 0,0,1")).contains("`x` is not a number"));
    assert!(bad(2, &format!("pixel {SCENE} 0,0 --max-depth 65")).contains("64"));
    assert!(bad(2, &format!("render {SCENE} -o picture.gif")).contains(".png, .exr or .pfm"));
    assert!(bad(2, &format!("render {SCENE} -o x.png --threads 0")).contains("1..=1024"));
    assert!(bad(2, "pixel nowhere.json 0,0").contains("there is no such file"));
    assert!(bad(2, "pixel scenes 0,0").contains("it is a directory"));
    assert!(bad(2, "check scenes").contains("it is a directory"));
    assert!(bad(2, "nonsense").contains("nonsense"));
}

#[test]
fn check_says_yes_or_no() {
    assert!(good(&format!("check {SCENE}")).contains("a valid scene of "));
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    good(&format!("pixel {SCENE} 100,100 --json -o {}", file("tree.json")));
    assert!(good(&format!("check {}", file("tree.json"))).contains("a valid tree of"));
    let tree = fs::read_to_string(file("tree.json")).unwrap().replace("raytree/1", "raytree/9");
    fs::write(file("tree.json"), tree).unwrap();
    assert!(bad(1, &format!("check {}", file("tree.json"))).contains("raytree/9"));
    fs::write(file("scene.json"), fs::read_to_string(SCENE).unwrap().replace("\"radius\"", "\"radus\"")).unwrap();
    let told = bad(1, &format!("check {}", file("scene.json")));
    assert!(told.contains("did you mean `radius`") && told.contains("^^^^^^^"), "{told}");
    assert!(told.contains("scene.json:") && told.contains("objects[0].shape.sphere.radus"), "{told}");
    fs::write(file("latin.json"), b"{ \"about\": \"caf\xe9\" }").unwrap();
    assert!(bad(1, &format!("check {}", file("latin.json"))).contains("is not UTF-8"));
}

#[test]
fn pictures_are_whole_or_not_there() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let scene = "scenes/first-hit.json";
    for name in ["a.png", "a.exr", "a.pfm"] {
        assert_eq!(good(&format!("render {scene} -o {}", file(name))), "");
    }
    assert!(image::open(file("a.png")).is_ok());
    let piped = run(&format!("render {scene} -o -"));
    assert_eq!(piped.stdout, fs::read(file("a.png")).unwrap());
    let told = bad(3, &format!("render {scene} -o {}", file("nowhere/a.png")));
    assert!(told.contains("cannot be written"), "{told}");
    fs::create_dir(file("folder.png")).unwrap();
    assert!(bad(3, &format!("render {scene} -o {}", file("folder.png"))).contains("it is a directory"));
    // Nor is anything traced, printed or written before that is known.
    bad(3, &format!("pixel {scene} 0,0 --render {}", file("nowhere/a.png")));
    bad(3, &format!("pixel {scene} 0,0 -o {} --render {}", file("tree.txt"), file("nowhere/a.png")));
    bad(2, &format!("pixel {scene} 0,0 -o {0} --render {0}", file("both.png")));
    bad(2, &format!("pixel {scene} 0,0 --render -"));
    bad(2, &format!("pixel {scene} 0,0 -o {scene}"));
    // Nothing else was left behind.
    let mut there: Vec<_> = fs::read_dir(&folder).unwrap().map(|e| e.unwrap().file_name()).collect();
    there.sort();
    assert_eq!(there, ["a.exr", "a.pfm", "a.png", "folder.png"]);
    // The main job: the tree and the picture in one.
    let tree = good(&format!("pixel {scene} 0,0 --render {}", file("b.png")));
    assert!(tree.starts_with("pixel 0,0") && fs::read(file("a.png")).unwrap() == fs::read(file("b.png")).unwrap());
}

#[test]
fn standard_input_and_output() {
    let mut child = raytree()
        .args(["pixel", "-", "10,10", "-o", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let scene = fs::read("scenes/first-hit.json").unwrap();
    child.stdin.take().unwrap().write_all(&scene).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(text(&output.stdout), good("pixel scenes/first-hit.json 10,10"));
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_error() {
    // Far more than a pipe holds, read for one byte.
    let mut child = raytree()
        .args(["pixel", SCENE, "100,100", "--json", "--steps", "--acceleration", "list"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut out = child.stdout.take().unwrap();
    out.read_exact(&mut [0]).unwrap();
    drop(out);
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_the_machines_fault() {
    let full = || File::options().write(true).open("/dev/full").unwrap();
    let output = raytree().args(["schema", "scene"]).stdout(full()).output().unwrap();
    assert_eq!(output.status.code(), Some(3));
    assert!(text(&output.stderr).contains("No space left"));
    assert!(bad(3, "schema tree -o /dev/full").contains("No space left"));
    assert!(bad(3, "render scenes/first-hit.json -o /dev/full").contains("No space left"));
    assert!(bad(3, &format!("pixel {SCENE} 0,0 --json -o /dev/full")).contains("No space left"));
    assert!(Path::new("/dev/full").exists());
    let output = raytree().args(["--help"]).stdout(full()).output().unwrap();
    assert_eq!(output.status.code(), Some(3));
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let scene = fs::read_to_string(SCENE).unwrap();
    let width = raytree::scene::load_file(SCENE).unwrap().scene.image.width;
    let huge =
        scene.replace(&format!("\"width\": {width}"), "\"width\": 8000").replace("\"height\": ", "\"height\": 4");
    let (scene_file, picture) = (folder.path().join("huge.json"), folder.path().join("huge.png"));
    fs::write(&scene_file, huge).unwrap();
    let child = raytree()
        .args(["render".as_ref(), scene_file.as_os_str(), "-o".as_ref(), picture.as_os_str()])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    let there: Vec<_> = fs::read_dir(&folder).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(there, ["huge.json"]);
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_what_waits() {
    let mut child = raytree().args(["pixel", "-", "0,0"]).stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let stdin = child.stdin.take().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    drop(stdin);
}

#[test]
fn effects_name_who_asked() {
    insta::assert_snapshot!(good(&format!("effects {SCENE}")));
    let json: serde_json::Value = serde_json::from_str(&good(&format!("effects {SCENE} --json"))).unwrap();
    assert!(json["on"].as_array().unwrap().iter().any(|on| on["effect"] == "fresnel"));
}

#[test]
fn every_command_has_help_with_an_example() {
    for command in ["render", "pixel", "ray", "effects", "check", "schema", "completions"] {
        let help = good(&format!("{command} --help"));
        assert!(help.contains("Example") && help.contains(&format!("raytree {command} ")), "{help}");
    }
    assert!(good("--help").contains("Exit codes:"));
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(good(&format!("completions {shell}")).contains("raytree"));
    }
}
