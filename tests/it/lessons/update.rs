//! Starting over and updating, as `lessons/README.md` describes them.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Runs the lines of a shell block.
fn shell(folder: &Path, lines: &str) {
    let output = Command::new("sh").args(["-ec", lines]).current_dir(folder).output().unwrap();
    let (out, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{lines}\n{out}{error}");
}

/// The block of commands below a comment of the page, or those of the page that begin like this.
fn procedure(name: &str) -> String {
    let page = fs::read_to_string("lessons/README.md").unwrap();
    let (_, rest) = page.split_once(&format!("<!-- procedure: {name} -->\n```sh\n")).unwrap();
    rest.split_once("```").unwrap().0.to_owned()
}

#[test]
fn answers_survive_an_update_and_can_be_taken_back() {
    let folder = tempfile::tempdir().unwrap();
    let (course, own) = (folder.path().join("course"), folder.path().join("own"));
    let who = "git config user.name A && git config user.email a@example.org";
    for lesson in ["01-vectors", "02-plane"] {
        let to = course.join("lessons").join(lesson);
        fs::create_dir_all(&to).unwrap();
        for file in ["exercise.rs", "README.md"] {
            fs::copy(format!("lessons/{lesson}/{file}"), to.join(file)).unwrap();
        }
    }
    shell(
        &course,
        &format!("git init --quiet --initial-branch main && {who} && git add . && git commit --quiet -m course"),
    );
    shell(folder.path(), "git clone --quiet course own");
    shell(&own, who);

    // An answer to each lesson, and later a course that has changed its pages, one exercise elsewhere and one at the same lines.
    let (first, second) = ("lessons/01-vectors/exercise.rs", "lessons/02-plane/exercise.rs");
    let edit = |at: &Path, file: &str, from: &str, to: &str| {
        let text = fs::read_to_string(at.join(file)).unwrap();
        assert!(text.contains(from), "{from}");
        fs::write(at.join(file), text.replacen(from, to, 1)).unwrap();
    };
    edit(&own, first, "todo!()", "a.dot(b) // mine");
    edit(&own, second, "todo!()", "Plane { normal, distance: 1.0 } // mine");
    edit(&course, first, "The cross product", "The vector product");
    edit(&course, second, "    todo!()", "    todo!(\"read the page first\")");
    edit(&course, "lessons/01-vectors/README.md", "# Lesson 01", "# Lesson 1");
    shell(&course, "git commit --quiet --all -m 'a new version'");

    shell(&own, &procedure("update"));
    let read = |file: &str| fs::read_to_string(own.join(file)).unwrap();
    assert!(read(first).contains("a.dot(b) // mine") && read(first).contains("The vector product"));
    assert!(read(second).contains("distance: 1.0 } // mine") && !read(second).contains("read the page first"));
    assert!(read("lessons/01-vectors/README.md").starts_with("# Lesson 1:"));

    // Starting over, before and after committing.
    edit(&own, first, "// mine", "// mine, but worse");
    let page = fs::read_to_string("lessons/README.md").unwrap();
    let over = "git restore lessons/01-vectors/exercise.rs";
    let all_over = "git restore --source=origin/HEAD lessons/01-vectors/exercise.rs";
    assert!(page.contains(&format!("```sh\n{over}\n```")) && page.contains(&format!("`{all_over}`")));
    shell(&own, over);
    assert!(read(first).contains("a.dot(b) // mine\n"));
    shell(&own, all_over);
    assert!(!read(first).contains("mine") && read(first).contains("The vector product"));
}
