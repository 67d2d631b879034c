//! `raytree grade`: all lessons of a submission, or of many.

mod course;
mod process;
mod submission;
mod worked;

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use rayon::prelude::{IntoParallelIterator, ParallelIterator};

use super::failure::Failure;
use super::options::thread_counts;
use super::output::{Folder, Target};
use super::progress;
use crate::input::{Problem, printable};
use crate::lessons::Report;
use crate::lessons::grading::{
    Attempt, Cohort, Grade, LessonGrade, NotBuilt, Stopped, Verdict, to_exercism, to_gradescope, to_junit,
};
use course::{Built, Course, Lesson};
use process::{End, Ended, Limits};
use submission::{LARGEST, Submission};

/// Grades a submission of the course, or many: as JSON, Markdown, JUnit XML, for Gradescope and for Exercism
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  raytree grade submission -o results
  raytree grade --cohort submissions -o results --lessons 1,2,3

A submission is a folder with files NN-name/exercise.rs, at the top or further down; nothing else in it is read. Each
is compiled with the course's own check.rs and run in a process of its own. One that does not come to an end is run
again stage by stage, so that it costs that stage alone.

This is no sandbox. The limits stop what is endless or greedy; code that means harm can read your files, use the
network and write its own result. Run it where that does not matter, in a container without a network or with
bubblewrap: docs/grading.md has the commands. The memory limit is kept on Linux only, time and output everywhere.

Results: grade.json, results.json (Gradescope), junit.xml, exercism/NN-name/results.json, grade.md; for a cohort that for
each submission in a folder of its name, and cohort.json and cohort.md. On standard output a line for each submission.
The exit code is 0 whatever the marks are.")]
pub(super) struct Args {
    /// The folder of the submission; with --cohort, of the submissions, a folder each
    folder: PathBuf,
    /// Grade every folder in it, and count what went wrong how often
    #[arg(long)]
    cohort: bool,
    /// Folder for the results; it is made if it is not there, and files of earlier results in it are replaced
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// The checkout of the course to grade with
    #[arg(long, value_name = "DIR", default_value = ".")]
    course: PathBuf,
    /// The lessons to grade: 1,2,3 [default: all]
    #[arg(long, value_name = "N", value_delimiter = ',')]
    lessons: Vec<u32>,
    /// Seconds on the clock that a program may run
    #[arg(long, value_name = "SECONDS", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=3600))]
    time_limit: u64,
    /// Memory that a program may ask for, in MiB
    #[arg(long, value_name = "MIB", default_value_t = 1024, value_parser = clap::value_parser!(u64).range(64..=1 << 20))]
    memory_limit: u64,
    /// What a program may print, in KiB
    #[arg(long, value_name = "KIB", default_value_t = 256, value_parser = clap::value_parser!(u64).range(1..=1 << 16))]
    output_limit: u64,
    /// Programs to compile and run at a time [default: one a core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = thread_counts())]
    threads: Option<u16>,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let course = Course::open(&args.course, &args.lessons)?;
    let submissions = submissions(args, &course)?;
    let limits =
        Limits { seconds: args.time_limit, memory: args.memory_limit, output: args.output_limit as usize, files: 16 };
    let pool = progress::pool(args.threads)?;
    let grades = progress::stoppable(|stop| {
        let built = match course.build(stop)? {
            Ok(built) => built,
            Err(failure) => return Some(Err(failure)),
        };
        let grader = Grader { course: &course, built: &built, limits, stop };
        pool.install(|| grader.grades(&submissions)).transpose()
    })??;
    write(args, &grades)?;
    let line = |grade: &Grade| format!("{}: {} of {} points\n", printable(&grade.submission), grade.points, grade.of);
    Target::Stdout.write_all(grades.iter().map(line).collect::<String>().as_bytes())
}

/// The submissions that the command line names.
fn submissions(args: &Args, course: &Course) -> Result<Vec<Submission>, Failure> {
    let name = args.folder.display().to_string();
    let wrong = |message: &str, help: &str| Err(Problem::new(&name, message, help).into());
    if !args.folder.is_dir() {
        let message = if args.folder.exists() { "it is no folder" } else { "there is no such folder" };
        return wrong(message, "a folder with the files NN-name/exercise.rs of a submission");
    }
    if !args.cohort {
        let submission = Submission::open(&args.folder, course)?;
        if submission.is_empty() {
            let help = "NN-name/exercise.rs below it, named as in the course; --cohort for a folder of submissions";
            return wrong("there is no lesson in it", help);
        }
        return Ok(vec![submission]);
    }
    let entries = fs::read_dir(&args.folder)
        .map_err(|error| Problem::new(&name, format!("it cannot be read: {error}"), "a folder of submissions"))?;
    let is_folder = |entry: &fs::DirEntry| {
        entry.file_type().is_ok_and(|kind| kind.is_dir()) && !entry.file_name().to_string_lossy().starts_with('.')
    };
    let mut folders: Vec<PathBuf> = entries.flatten().filter(is_folder).map(|entry| entry.path()).collect();
    folders.sort();
    let results = fs::canonicalize(&args.output).ok();
    if folders.iter().any(|folder| results.is_some() && fs::canonicalize(folder).ok() == results) {
        return wrong("the results are among the submissions", "-o with a folder elsewhere");
    }
    let submissions =
        folders.iter().map(|folder| Submission::open(folder, course)).collect::<Result<Vec<_>, Failure>>()?;
    match submissions.iter().all(Submission::is_empty) {
        true => wrong("there is no submission in it", "a folder for each submission, with NN-name/exercise.rs below"),
        false => Ok(submissions),
    }
}

/// Writes everything: what is whole first, so that a page that is there tells of results that are.
fn write(args: &Args, grades: &[Grade]) -> Result<(), Failure> {
    let folder = Folder::new(&args.output)?;
    for grade in grades {
        let folder = if args.cohort { &folder.folder(&grade.submission)? } else { &folder };
        let exercism = folder.folder("exercism")?;
        for lesson in &grade.lessons {
            exercism.folder(&lesson.folder)?.write("results.json", to_exercism(lesson).as_bytes())?;
        }
        folder.write("junit.xml", to_junit(grade).as_bytes())?;
        folder.write("results.json", to_gradescope(grade).as_bytes())?;
        folder.write("grade.json", grade.to_json().as_bytes())?;
        folder.write("grade.md", grade.to_markdown().as_bytes())?;
    }
    if args.cohort {
        let cohort = Cohort::of(grades);
        folder.write("cohort.json", cohort.to_json().as_bytes())?;
        folder.write("cohort.md", cohort.to_markdown().as_bytes())?;
    }
    Ok(())
}

struct Grader<'a> {
    course: &'a Course,
    built: &'a Built,
    limits: Limits,
    stop: &'a AtomicBool,
}

/// What a run of a lesson's program came to: the report, if there is one, and what was printed.
struct Outcome {
    report: Result<Report, Stopped>,
    output: String,
}

impl Grader<'_> {
    /// The grades; nothing if stopped. The same file is compiled and run once, whoever handed it in.
    fn grades(&self, submissions: &[Submission]) -> Result<Option<Vec<Grade>>, Failure> {
        let work =
            tempfile::tempdir().map_err(|error| Failure::from_write("the folder for temporary files", &error))?;
        let mut files: BTreeMap<(usize, &[u8]), usize> = BTreeMap::new();
        for submission in submissions {
            for (lesson, handed) in submission.files.iter().enumerate() {
                if let Some(source) = handed.as_ref().and_then(|handed| handed.source.as_deref()) {
                    let place = files.len();
                    files.entry((lesson, source)).or_insert(place);
                }
            }
        }
        let lessons = self.course.lessons.len();
        let bar = progress::bar("grading", (lessons + files.len()) as u64);
        let folder = |name: String| work.path().join(name);
        let keys = (0..lessons).into_par_iter().map(|lesson| {
            let key = self.key(lesson, &folder(format!("key-{lesson}")))?;
            bar.inc(1);
            Ok(key)
        });
        let keys: Option<Vec<Report>> = keys.collect::<Result<_, Failure>>()?;
        let Some(keys) = keys else { return Ok(None) };
        let graded = files.into_iter().collect::<Vec<_>>().into_par_iter().map(|((lesson, source), place)| {
            let grade = self.lesson(lesson, source, &keys[lesson], &folder(format!("file-{place}")))?;
            bar.inc(1);
            Ok(grade.map(|grade| ((lesson, source), grade)))
        });
        let graded: Option<BTreeMap<(usize, &[u8]), LessonGrade>> = graded.collect::<Result<_, Failure>>()?;
        bar.finish_and_clear();
        let Some(graded) = graded else { return Ok(None) };
        let grade = |submission: &Submission| {
            let lessons = submission.files.iter().enumerate().map(|(lesson, handed)| {
                let folder = &self.course.lessons[lesson].folder;
                let key = &keys[lesson];
                let Some(handed) = handed else { return LessonGrade::of(key, folder, &Attempt::Missing) };
                let mut grade = match &handed.source {
                    None => LessonGrade::of(key, folder, &Attempt::NotBuilt(too_large())),
                    Some(source) => graded[&(lesson, source.as_slice())].clone(),
                };
                grade.notes.extend(handed.notes.iter().cloned());
                grade
            });
            Grade::of(&submission.name, lessons.collect(), submission.notes.clone())
        };
        Ok(Some(submissions.iter().map(grade).collect()))
    }

    /// What the course's own solution gets: all points, or the grader is not fit to grade.
    fn key(&self, lesson: usize, folder: &Path) -> Result<Option<Report>, Failure> {
        create(folder)?;
        let Some(outcome) = self.check(&self.built.solutions[lesson], None, folder)? else { return Ok(None) };
        let name = &self.course.lessons[lesson].folder;
        let why = match outcome.report {
            Ok(report) if report.passed => return Ok(Some(report)),
            Ok(_) => "it is not right".to_owned(),
            Err(stopped) => stopped.message,
        };
        Err(Failure::Machine(format!("the course's own solution of {name} does not pass with these limits: {why}")))
    }

    /// The grade of a file. What builds on a function that is not right is checked again with the course's own put in.
    fn lesson(
        &self,
        lesson: usize,
        source: &[u8],
        key: &Report,
        folder: &Path,
    ) -> Result<Option<LessonGrade>, Failure> {
        let Lesson { folder: name, solution, .. } = &self.course.lessons[lesson];
        let Some(attempt) = self.attempt(lesson, source, None, key.stages.len(), &folder.join("own"))? else {
            return Ok(None);
        };
        let mut grade = LessonGrade::of(key, name, &attempt);
        for round in 0..key.stages.len() {
            let replaced = grade.holds_up();
            let Some(source) = worked::put_in(source, &replaced).filter(|_| !replaced.is_empty()) else { break };
            let (worked, folder) = (worked::module(solution), folder.join(format!("with-{round}")));
            let attempt = self.attempt(lesson, source.as_bytes(), Some(&worked), key.stages.len(), &folder)?;
            let Some(attempt) = attempt else { return Ok(None) };
            if !grade.follow(key, &replaced, &attempt) {
                break;
            }
        }
        Ok(Some(grade))
    }

    /// Compiles and runs a file, beside it a module with the course's functions if it needs one.
    fn attempt(
        &self,
        lesson: usize,
        source: &[u8],
        worked: Option<&str>,
        stages: usize,
        folder: &Path,
    ) -> Result<Option<Attempt>, Failure> {
        let lesson = &self.course.lessons[lesson];
        // Messages of the compiler and of panics name the file as its author knows it.
        let own = Path::new("lessons").join(&lesson.folder);
        let (run, code) = (folder.join("run"), folder.join(&own));
        create(&run)?;
        create(&code)?;
        let worked = worked.map(|text| (worked::FILE, text.as_bytes()));
        for (name, text) in [("exercise.rs", source), ("check.rs", lesson.check.as_bytes())].into_iter().chain(worked) {
            let path = code.join(name);
            fs::write(&path, text).map_err(|error| Failure::from_write(&path.display().to_string(), &error))?;
        }
        let file = own.join("exercise.rs").display().to_string();
        let program = format!("program{}", std::env::consts::EXE_SUFFIX);
        let Some(refused) = self.built.compile(folder, &file, &program, self.stop)? else { return Ok(None) };
        if let Some(not_built) = refused {
            return Ok(Some(Attempt::NotBuilt(not_built)));
        }
        let program = folder.join(program);
        let Some(Outcome { report, output }) = self.check(&program, None, &run)? else { return Ok(None) };
        if let Ok(report) = report {
            return Ok(Some(Attempt::Ran { report, output }));
        }
        let mut came = Vec::new();
        for stage in 1..=stages {
            let Some(outcome) = self.check(&program, Some(stage), &run)? else { return Ok(None) };
            came.push(outcome.report.and_then(|report| {
                let message = "The program wrote a result that is not this lesson's.".to_owned();
                report.stages.into_iter().next().ok_or(Stopped { verdict: Verdict::Crashed, message })
            }));
        }
        Ok(Some(Attempt::ByStages { stages: came, output }))
    }

    /// Runs a lesson's program, or one stage of it, in a folder of its own.
    fn check(&self, program: &Path, stage: Option<usize>, folder: &Path) -> Result<Option<Outcome>, Failure> {
        let result = folder.join("result.json");
        // One of an earlier run would be taken for this one's.
        fs::remove_file(&result).ok();
        let number = stage.map(|stage| stage.to_string());
        let mut args = vec![OsStr::new("--json"), OsStr::new("result.json")];
        args.extend(number.iter().flat_map(|number| [OsStr::new("--stage"), OsStr::new(number)]));
        let path = folder.as_os_str();
        // One thread and few arenas: address space is what the memory limit counts.
        let environment = [
            ("TMPDIR", path),
            ("RUST_BACKTRACE", OsStr::new("0")),
            ("RAYON_NUM_THREADS", OsStr::new("1")),
            ("MALLOC_ARENA_MAX", OsStr::new("1")),
        ];
        let ended = process::run(program, &args, folder, &environment, self.limits, self.stop)
            .map_err(|error| Failure::Machine(format!("a program cannot be started: {error}")))?;
        let Some(ended) = ended else { return Ok(None) };
        let output = String::from_utf8_lossy(&[ended.out.as_slice(), &ended.error].concat()).into_owned();
        Ok(Some(Outcome { report: self.report(&ended, &result), output }))
    }

    /// The report that a program has written, or how it ended.
    fn report(&self, ended: &Ended, result: &Path) -> Result<Report, Stopped> {
        let stopped = |verdict, message: String| Err(Stopped { verdict, message });
        let Limits { seconds, memory, output, .. } = self.limits;
        let status = match &ended.end {
            End::TimedOut => return stopped(Verdict::TimedOut, format!("It ran longer than {seconds} s.")),
            End::TooMuchOutput => {
                return stopped(Verdict::TooMuchOutput, format!("It printed more than {output} KiB."));
            }
            End::Exited(_) if ended.is_out_of_memory() => {
                return stopped(Verdict::OutOfMemory, format!("It asked for more than {memory} MiB of memory."));
            }
            End::Exited(status) => status,
        };
        let is_small = fs::symlink_metadata(result).is_ok_and(|data| data.is_file() && data.len() <= LARGEST);
        if let Some(text) = is_small.then(|| fs::read_to_string(result).ok()).flatten()
            && let Ok(report) = serde_json::from_str(&text)
        {
            return Ok(report);
        }
        if String::from_utf8_lossy(&ended.error).contains("has overflowed its stack") {
            let message = "The stack overflowed: a function calls itself without end.";
            return stopped(Verdict::Crashed, message.to_owned());
        }
        let status = printable(&status.to_string()).into_owned();
        stopped(Verdict::Crashed, format!("The program ended with {status} before it had a result."))
    }
}

/// A file that is not looked at.
fn too_large() -> NotBuilt {
    let message = format!("The file is larger than {} KiB.", LARGEST / 1024);
    NotBuilt { text: message.clone(), message, place: None, errors: 0 }
}

fn create(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| Failure::from_write(&folder.display().to_string(), &error))
}
