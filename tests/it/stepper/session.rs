//! The command `step`: sessions as a script plays them.

use std::fs;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::commands::{bad, good};

const SCENE: &str = "scenes/first-tree.json";
const PIXEL: &str = "mirrored floor";

/// A session in a folder of its own, if it needs one.
fn run(folder: Option<&Path>, args: &[&str], script: &[u8]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.arg("step").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    if let Some(folder) = folder {
        command.current_dir(folder);
    }
    let mut child = command.args(args).spawn().unwrap();
    // A session that has left does not read the rest.
    child.stdin.take().unwrap().write_all(script).ok();
    child.wait_with_output().unwrap()
}

/// What a session says that goes well.
fn session(scene: &str, pixel: &str, script: &str) -> String {
    let output = run(None, &[scene, pixel], script.as_bytes());
    let (told, said) = (String::from_utf8(output.stderr).unwrap(), String::from_utf8(output.stdout).unwrap());
    assert_eq!((output.status.code(), told.as_str()), (Some(0), ""), "{said}");
    assert!(!said.contains('\u{1b}') && !said.contains("(raytree)"), "no colour and no prompt but on a terminal");
    said
}

#[test]
fn a_walk_through_a_small_tree() {
    insta::assert_snapshot!(session(
        SCENE,
        PIXEL,
        "s\nn\nuntil hit\n\nwhere\nprint hit\nout\nlist\ntree\nend\nb\nq\nnot read\n"
    ));
}

#[test]
fn a_run_to_total_reflection() {
    let scene = "scenes/total-internal-reflection.json";
    insta::assert_snapshot!(session(
        scene,
        "critical angle",
        "until tir\nprint arithmetic\np level\np weight\nuntil weight 2\nuntil tir\n"
    ));
}

#[test]
fn a_sphere_and_its_arithmetic() {
    let scene = "scenes/sphere.json";
    insta::assert_snapshot!(session(
        scene,
        "highlight",
        "until t 100\np disc\np test\nuntil object nothing\nevents\nhelp\n"
    ));
}

#[test]
fn bad_commands_are_answered_and_the_session_goes_on() {
    let script = [
        "frobnicate",
        "bak",
        "until",
        "until dept 3",
        "to 0",
        "to 10000",
        "s x",
        "print",
        "print hti",
        "list everything",
        "draw tre",
        "b",
        "o",
        "where",
    ];
    let script = script.join("\n");
    insta::assert_snapshot!(session(SCENE, PIXEL, &script));
}

#[test]
fn the_end_of_the_input_and_bytes_that_are_no_text() {
    assert!(session(SCENE, PIXEL, "").starts_with("pixel "));
    let output = run(None, &[SCENE, PIXEL], b"\xff\xfe\x1b[31m\n\0\ns");
    assert_eq!(output.status.code(), Some(0));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("is no command") && !said.contains('\u{1b}') && said.contains("step 2 of "), "{said}");
}

#[test]
fn every_step_can_be_walked_to_and_back() {
    let steps = session(SCENE, PIXEL, &"s\n".repeat(2000));
    let last = steps.matches("this is the last step").count();
    assert!(last > 0);
    let total = 2000 - last + 1;
    assert!(steps.contains(&format!("step {total} of {total}")), "{total}");
    let back = session(SCENE, PIXEL, &format!("end\nb {}\nb\ns 5\nb 5\n", total - 1));
    assert!(back.contains("this is the first step"));
    assert!(back.trim_end().lines().any(|line| line.contains("step 6 of")), "{back}");
}

#[test]
fn drawings_are_written_and_nothing_else_is_touched() {
    let folder = tempfile::tempdir().unwrap();
    let scene = fs::canonicalize(SCENE).unwrap();
    let scene = scene.to_str().unwrap();
    fs::write(folder.path().join("mine.svg"), "mine").unwrap();
    let script = [
        "until t 100",
        "draw",
        "draw",
        "draw tree",
        "draw tree.png",
        "draw tree tree.png",
        "draw mine.svg",
        "draw sphere",
        "draw notes.txt",
        "draw nowhere/a.svg",
    ];
    let script = script.join("\n");
    let output = run(Some(folder.path()), &[scene, PIXEL], script.as_bytes());
    let said = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert_eq!(fs::read_to_string(folder.path().join("mine.svg")).unwrap(), "mine");
    assert!(said.contains("mine.svg is there already"), "{said}");
    assert!(said.contains("has to end in .svg or .png") && said.contains("there is no folder"), "{said}");
    let mut there: Vec<String> =
        fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    there.sort();
    assert_eq!(there.len(), 6, "{there:?}: {said}");
    for name in &there {
        assert!(said.contains(name.as_str()), "{name}: {said}");
    }
    assert!(image::open(folder.path().join("tree.png")).is_ok());
}

#[test]
fn the_recording_as_json() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("steps.json");
    let json = good(&format!("step {SCENE} '{PIXEL}' --json"));
    assert_eq!(good(&format!("step {SCENE} '{PIXEL}' --json -o {}", file.display())), "");
    assert_eq!(fs::read_to_string(&file).unwrap(), json);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["format"], "raytree-recording/1");
    let tree = raytree::tree::check::read_tree("tree.json", &json["tree"].to_string()).unwrap();
    let said = session(SCENE, PIXEL, "end\n");
    let steps = json["steps"].as_array().unwrap();
    assert!(said.contains(&format!("step {0} of {0}", steps.len())), "the same list: {said}");
    assert_eq!(json["nodes"].as_array().unwrap().len(), tree.nodes().len());
    // Numerics and precision are those asked for.
    let f32 = good(&format!("step {SCENE} '{PIXEL}' --json --precision f32 --numerics lecture"));
    let f32: serde_json::Value = serde_json::from_str(&f32).unwrap();
    assert_eq!(f32["tree"]["settings"]["precision"], "f32");
    let forms = f32["forms"].as_object().unwrap();
    assert!(forms.values().any(|form| form["precision"] == "f32"));
}

#[test]
fn bad_command_lines() {
    assert!(bad(2, &format!("step - '{PIXEL}'")).contains("cannot both come from standard input"));
    assert!(bad(2, &format!("step {SCENE} nowhere")).contains("there is no pixel `nowhere`"));
    assert!(bad(2, "step nowhere.json 0,0").contains("there is no such file"));
    bad(2, &format!("step {SCENE} '{PIXEL}' -o x.json"));
    assert!(bad(2, &format!("step {SCENE} '{PIXEL}' --json -o {SCENE}")).contains("would overwrite"));
    assert!(good("step --help").contains("raytree step "));
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_error_and_ctrl_c_is_130() {
    let start = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
        command.args(["step", SCENE, PIXEL]).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command.spawn().unwrap()
    };
    let mut child = start();
    let mut out = child.stdout.take().unwrap();
    out.read_exact(&mut [0]).unwrap();
    drop(out);
    child.stdin.take().unwrap().write_all("where\n".repeat(10_000).as_bytes()).ok();
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));

    let mut child = start();
    // It waits for a command once it has said where it is.
    child.stdout.as_mut().unwrap().read_exact(&mut [0]).unwrap();
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let stdin = child.stdin.take();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    drop(stdin);
}
