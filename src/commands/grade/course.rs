//! The course that submissions are graded with: its lessons, its library built once, its compiler.

use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::{IsTerminal, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use serde_json::Value;

use super::process::{self, End, Limits};
use crate::commands::failure::Failure;
use crate::input::{Problem, one_of};
use crate::lessons::grading::NotBuilt;

/// What the compiler may use for one file.
const COMPILER: Limits = Limits { seconds: 120, memory: 4096, output: 4096, files: 1024 };

/// A lesson as the course has it.
#[derive(Debug)]
pub(super) struct Lesson {
    /// The folder's name: `02-plane`.
    pub(super) folder: String,
    /// `exercise.rs` as it is handed out.
    pub(super) exercise: String,
    /// `solution.rs`.
    pub(super) solution: String,
    /// `check.rs`, with the whole path of every scene that it includes.
    pub(super) check: String,
}

impl Lesson {
    /// The name of the example that is the worked solution.
    fn example(&self) -> String {
        format!("lesson-{}-solution", &self.folder[..2])
    }
}

/// The number that the name of a lesson's folder begins with: 2 of `02-plane`.
fn number(folder: &str) -> Option<u32> {
    let (number, name) = folder.split_once('-')?;
    let is_number = number.len() == 2 && number.bytes().all(|b| b.is_ascii_digit());
    number.parse().ok().filter(|_| is_number && !name.is_empty())
}

/// A check.rs that finds the scenes it includes wherever it stands.
fn with_scenes(check: &str, scenes: &Path) -> String {
    let literal = format!("{:?}", scenes.display().to_string());
    check.replace("\"../../scenes/", &format!("{}/", &literal[..literal.len() - 1]))
}

/// A checkout of the course.
#[derive(Debug)]
pub(super) struct Course {
    folder: PathBuf,
    /// The lessons to grade, in order.
    pub(super) lessons: Vec<Lesson>,
}

impl Course {
    /// The course in a folder, with these lessons or all.
    pub(super) fn open(folder: &Path, only: &[u32]) -> Result<Self, Failure> {
        let name = folder.display().to_string();
        let help = "--course with the folder of a checkout of raytree, the one with Cargo.toml and lessons/";
        let no_course = |why: &str| Problem::new(&name, format!("there is no course here: {why}"), help);
        if !folder.join("Cargo.toml").is_file() {
            return Err(no_course("it has no Cargo.toml").into());
        }
        let entries = fs::read_dir(folder.join("lessons")).map_err(|_| no_course("it has no folder lessons"))?;
        let mut found = BTreeMap::new();
        for entry in entries.flatten() {
            let lesson = entry.file_name().to_string_lossy().into_owned();
            if let Some(number) = number(&lesson).filter(|_| entry.path().join("check.rs").is_file()) {
                found.insert(number, lesson);
            }
        }
        if found.is_empty() {
            return Err(no_course("lessons/ has no lesson with a check.rs").into());
        }
        if let Some(number) = only.iter().find(|number| !found.contains_key(number)) {
            let known: Vec<String> = found.keys().map(u32::to_string).collect();
            let help = one_of(known.iter().map(String::as_str));
            return Err(Problem::new("--lessons", format!("the course has no lesson {number}"), help).into());
        }
        found.retain(|number, _| only.is_empty() || only.contains(number));
        let read = |lesson: &str, file: &str| {
            let path = folder.join("lessons").join(lesson).join(file);
            let cannot = |error| Problem::new(path.display().to_string(), format!("it cannot be read: {error}"), help);
            fs::read_to_string(&path).map_err(cannot)
        };
        let scenes = std::path::absolute(folder.join("scenes"))
            .map_err(|error| Problem::new(&name, format!("its path cannot be told: {error}"), help))?;
        let lessons = found.into_values().map(|lesson| {
            Ok(Lesson {
                exercise: read(&lesson, "exercise.rs")?,
                solution: read(&lesson, "solution.rs")?,
                check: with_scenes(&read(&lesson, "check.rs")?, &scenes),
                folder: lesson,
            })
        });
        Ok(Course { folder: folder.to_owned(), lessons: lessons.collect::<Result<_, Problem>>()? })
    }

    /// Builds the library and the worked solutions with cargo, which does nothing where that has been done. Nothing if
    /// stopped.
    pub(super) fn build(&self, stop: &AtomicBool) -> Option<Result<Built, Failure>> {
        let machine = |why: String| Some(Err(Failure::Machine(format!("the course cannot be built: {why}"))));
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["build", "--message-format=json-render-diagnostics"]).current_dir(&self.folder);
        if self.folder.join("Cargo.lock").is_file() {
            cargo.arg("--locked");
        }
        if !std::io::stderr().is_terminal() {
            cargo.arg("--quiet");
        }
        self.lessons.iter().for_each(|lesson| _ = cargo.args(["--example", &lesson.example()]));
        let mut child = match cargo.stdin(Stdio::null()).stdout(Stdio::piped()).spawn() {
            Ok(child) => child,
            Err(error) => return machine(format!("cargo: {error}")),
        };
        let mut pipe = child.stdout.take();
        let listener = thread::spawn(move || {
            let mut messages = Vec::new();
            pipe.as_mut().map(|pipe| pipe.read_to_end(&mut messages));
            messages
        });
        let status = loop {
            if stop.load(Ordering::SeqCst) {
                child.kill().ok();
                child.wait().ok();
                return None;
            }
            match child.try_wait() {
                Ok(Some(status)) => break status,
                Ok(None) => thread::sleep(Duration::from_millis(20)),
                Err(error) => return machine(error.to_string()),
            }
        };
        if !status.success() {
            return machine("cargo says why above".to_owned());
        }
        let messages = listener.join().unwrap_or_default();
        match Built::new(self, &String::from_utf8_lossy(&messages)) {
            Ok(built) => Some(Ok(built)),
            Err(why) => machine(why),
        }
    }
}

/// A course that is built.
#[derive(Debug)]
pub(super) struct Built {
    rustc: PathBuf,
    /// What every file is compiled with.
    flags: Vec<OsString>,
    /// The worked solutions as programs, in the order of the lessons.
    pub(super) solutions: Vec<PathBuf>,
    environment: Vec<(&'static str, OsString)>,
}

impl Built {
    /// What cargo says it has built, a line of JSON each.
    fn new(course: &Course, messages: &str) -> Result<Self, String> {
        let messages: Vec<Value> = messages.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
        let artifact = |name: &str, kind: &str| {
            let is_it = |m: &&Value| {
                let target = &m["target"];
                m["reason"] == "compiler-artifact" && target["name"] == name && target["kind"][0] == kind
            };
            messages.iter().find(is_it).ok_or(format!("cargo has built no {name}"))
        };
        let library = |name: &str| {
            let files = artifact(name, "lib")?["filenames"].as_array().cloned().unwrap_or_default();
            let mut paths = files.iter().filter_map(|file| file.as_str().map(PathBuf::from));
            paths.find(|path| path.extension() == Some(OsStr::new("rlib"))).ok_or(format!("{name} is no Rust library"))
        };
        let (raytree, glam) = (library("raytree")?, library("glam")?);
        let profile = &artifact("raytree", "lib")?["profile"];
        let level = profile["opt_level"].as_str().unwrap_or("1");
        let checks = if profile["debug_assertions"] == true { "on" } else { "off" };
        // Warnings are nothing to a grader; what the course refuses, and the compiler by itself, is refused here too.
        const FIXED: [&str; 5] =
            ["--edition=2024", "--crate-type=bin", "--error-format=json", "-Awarnings", "-Dunsafe_code"];
        let mut flags = FIXED.map(OsString::from).to_vec();
        let codegen = [
            format!("opt-level={level}"),
            format!("debug-assertions={checks}"),
            format!("overflow-checks={checks}"),
            "strip=debuginfo".to_owned(),
        ];
        flags.extend(codegen.into_iter().flat_map(|option| ["-C".into(), option.into()]));
        let with =
            |prefix: &str, path: &Path| -> OsString { [OsStr::new(prefix), path.as_os_str()].into_iter().collect() };
        flags.extend(["-L".into(), with("dependency=", raytree.parent().unwrap_or(Path::new(".")))]);
        for (name, path) in [("raytree=", &raytree), ("glam=", &glam)] {
            flags.extend(["--extern".into(), with(name, path)]);
        }
        let solutions = course.lessons.iter().map(|lesson| {
            let program = artifact(&lesson.example(), "example")?["executable"].as_str();
            program.map(PathBuf::from).ok_or(format!("cargo has built no program of {}", lesson.folder))
        });
        // What the compiler and the linker need to find themselves; a secret in the environment is none of it.
        const NEEDED: [&str; 12] = [
            "PATH",
            "HOME",
            "USERPROFILE",
            "RUSTUP_HOME",
            "RUSTUP_TOOLCHAIN",
            "CARGO_HOME",
            "TMPDIR",
            "TEMP",
            "SystemRoot",
            "SDKROOT",
            "DEVELOPER_DIR",
            "LD_LIBRARY_PATH",
        ];
        Ok(Built {
            rustc: rustc(&course.folder)?,
            flags,
            solutions: solutions.collect::<Result<_, String>>()?,
            environment: NEEDED.iter().filter_map(|name| Some((*name, std::env::var_os(name)?))).collect(),
        })
    }

    /// Compiles a file, named as it is seen from a folder, to a program there. Says why if that fails; nothing if stopped.
    ///
    /// # Errors
    /// The compiler cannot be started.
    pub(super) fn compile(
        &self,
        folder: &Path,
        file: &str,
        program: &str,
        stop: &AtomicBool,
    ) -> Result<Option<Option<NotBuilt>>, Failure> {
        let mut args: Vec<&OsStr> = self.flags.iter().map(OsString::as_os_str).collect();
        args.extend([file, "--crate-name=exercise", "-o", program].map(OsStr::new));
        let environment: Vec<(&str, &OsStr)> = self.environment.iter().map(|(name, value)| (*name, &**value)).collect();
        let ended = process::run(&self.rustc, &args, folder, &environment, COMPILER, stop)
            .map_err(|error| Failure::Machine(format!("the compiler cannot be started: {error}")))?;
        Ok(ended.map(|ended| {
            let is_good = matches!(&ended.end, End::Exited(status) if status.success());
            let words = String::from_utf8_lossy(&ended.error);
            (!is_good).then(|| first_error(&words).unwrap_or_else(|| no_error(&ended, &words)))
        }))
    }
}

/// The compiler that cargo uses in a folder.
fn rustc(folder: &Path) -> Result<PathBuf, String> {
    if let Some(rustc) = std::env::var_os("RUSTC") {
        return Ok(rustc.into());
    }
    let asked = Command::new("rustc").args(["--print", "sysroot"]).current_dir(folder).stdin(Stdio::null()).output();
    let sysroot = asked.map_err(|error| format!("rustc: {error}"))?.stdout;
    let path = Path::new(String::from_utf8_lossy(&sysroot).trim()).join("bin").join("rustc");
    // Where the compiler does not stand in its own folder, the path leads to it.
    Ok(if path.with_extension(std::env::consts::EXE_EXTENSION).is_file() { path } else { "rustc".into() })
}

/// The first error among the compiler's messages, a line of JSON each.
fn first_error(messages: &str) -> Option<NotBuilt> {
    let messages = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    // The last one says how many there were, and has no place.
    let is_error = |m: &Value| {
        m["level"] == "error" && !m["message"].as_str().is_some_and(|words| words.starts_with("aborting due to"))
    };
    let errors: Vec<Value> = messages.filter(is_error).collect();
    let first = errors.first()?;
    let spans = first["spans"].as_array();
    let place = spans.and_then(|spans| spans.iter().find(|span| span["is_primary"] == true)).map(|span| {
        let file = span["file_name"].as_str().unwrap_or_default();
        format!("{file}:{}:{}", span["line_start"], span["column_start"])
    });
    Some(NotBuilt {
        message: first["message"].as_str().unwrap_or_default().to_owned(),
        place,
        text: first["rendered"].as_str().unwrap_or_default().trim_end().to_owned(),
        errors: errors.len(),
    })
}

/// A compiler that ended without saying what is wrong.
fn no_error(ended: &process::Ended, words: &str) -> NotBuilt {
    let message = match &ended.end {
        _ if ended.is_out_of_memory() => format!("The compiler needed more than {} MiB of memory.", COMPILER.memory),
        End::TimedOut => format!("The compiler took longer than {} s.", COMPILER.seconds),
        End::TooMuchOutput => "The compiler had too much to say.".to_owned(),
        End::Exited(status) => format!("The compiler ended with {status}."),
    };
    let last = words.lines().filter(|line| !line.starts_with('{')).collect::<Vec<_>>();
    let text = [&[message.as_str()], &last[..last.len().min(20)]].concat().join("\n");
    NotBuilt { message, place: None, text, errors: 0 }
}
