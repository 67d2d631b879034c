//! `cargo run --example lesson-NN`: what an exercise of the course and its solution run.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;

use super::failure::Failure;
use super::output::Target;
use super::picture::Format;
use crate::input::Problem;
use crate::lessons::{FailureKind, Lesson, Report};
use crate::pictures::drawing::Drawing;

/// Checks the functions of a lesson, and draws the first case that is wrong.
#[derive(Debug, Parser)]
#[command(
    after_help = "Exit codes: 0 all right, 1 something is wrong, 2 the command line is at fault, 3 a file cannot be written."
)]
struct Args {
    /// A hint for the first function that is not right: the next one each time, or the one with this number
    #[arg(long, value_name = "N", num_args = 0..=1)]
    hint: Option<Option<usize>>,
    /// The result for programs, to a file or to standard output; there is no picture then unless asked for
    #[arg(long, value_name = "FILE", num_args = 0..=1)]
    json: Option<Option<String>>,
    /// Where the picture goes: a path ending in .png or .svg [default: lesson-NN.png in the current folder]
    #[arg(long, value_name = "FILE")]
    picture: Option<String>,
    /// Checks the part with this number alone; a grader asks for it where the whole does not come to an end
    #[arg(long, value_name = "N", requires = "json", conflicts_with_all = ["hint", "picture"])]
    stage: Option<usize>,
}

/// Checks a lesson as the command line asks for, prints what came of it, and returns the exit code.
pub fn run(lesson: &Lesson) -> ExitCode {
    let args = match Args::try_parse() {
        Ok(args) => args,
        Err(error) => {
            error.print().ok();
            return if error.use_stderr() { ExitCode::from(2) } else { ExitCode::SUCCESS };
        }
    };
    match checked(lesson, &args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report().into(),
    }
}

fn checked(lesson: &Lesson, args: &Args) -> Result<(), Failure> {
    let (report, drawing) = match args.stage {
        None => lesson.check(),
        Some(number) => {
            let help = format!("1 to {}", lesson.stages.len());
            let none = || Problem::new("--stage", format!("the lesson has no part {number}"), help);
            (lesson.check_stage(number).ok_or_else(none)?, None)
        }
    };
    let command = format!("cargo run --example lesson-{:02}", lesson.number);
    let mut target = Target::Stdout;
    let text = match (args.hint, &args.json) {
        (Some(asked), _) => hint(lesson, &report, asked, &command)?,
        (None, Some(file)) => {
            // What the student's code prints is not in the way of a file.
            target = Target::new(file.as_deref(), &[])?;
            write_picture(args.picture.as_deref(), drawing.as_ref())?;
            let json = serde_json::to_string_pretty(&report).map_err(|error| Failure::Machine(error.to_string()))?;
            json + "\n"
        }
        (None, None) => {
            let file = args.picture.clone().unwrap_or_else(|| format!("lesson-{:02}.png", lesson.number));
            let mut text = report.to_text(&command);
            if report.passed {
                text += &format!("\nAll right. {}\n", lesson.notice);
            }
            // Of what is not written yet there is a picture only if it is asked for.
            if drawing.is_some() && (args.picture.is_some() || !is_unwritten(&report)) {
                write_picture(Some(&file), drawing.as_ref())?;
                text += &format!("a picture: {file}\n");
            }
            text
        }
    };
    target.write_all(text.as_bytes())?;
    if report.passed { Ok(()) } else { Err(Failure::No) }
}

/// Whether the lesson goes no further because a function is not written yet.
fn is_unwritten(report: &Report) -> bool {
    let failure = report.first_open().and_then(|(_, stage)| stage.failure.as_ref());
    failure.is_some_and(|failure| failure.kind == FailureKind::Unwritten)
}

fn write_picture(file: Option<&str>, drawing: Option<&Drawing>) -> Result<(), Failure> {
    let (Some(file), Some(drawing)) = (file, drawing) else { return Ok(()) };
    let format = Format::of(file)?;
    Target::new(Some(file), &[])?.write_all(&format.encode(drawing, 1.5)?)
}

/// The hint that is asked for, of the first function that is not right.
fn hint(lesson: &Lesson, report: &Report, asked: Option<usize>, command: &str) -> Result<String, Failure> {
    let Some((i, _)) = report.first_open() else {
        return Ok(format!("lesson {:02} is solved: there is nothing to hint at.\n", lesson.number));
    };
    let stage = &lesson.stages[i];
    let count = stage.hints.len();
    let number = match asked {
        Some(number) if (1..=count).contains(&number) => number,
        Some(number) => {
            let message = format!("there is no hint {number} for `{}`", stage.function);
            return Err(Problem::new("--hint", message, format!("1 to {count}")).into());
        }
        None => Counter::new(lesson.number).next(stage.function).min(count),
    };
    let mut text = format!("hint {number} of {count} for `{}`: {}\n", stage.function, stage.hints[number - 1]);
    if number == count {
        text += &format!(
            "That was the last one. The worked solution is in solution.rs beside your exercise.rs; {command}-solution runs it.\n"
        );
    }
    Ok(text)
}

/// How many hints were given for each function: a file beside the program, where cargo keeps what it builds.
struct Counter(Option<PathBuf>);

impl Counter {
    fn new(lesson: u32) -> Self {
        let folder = std::env::current_exe().ok().and_then(|program| Some(program.parent()?.to_owned()));
        Counter(folder.map(|folder| folder.join(format!("lesson-{lesson:02}.hints"))))
    }

    /// The number of the next hint for a function, from 1; always 1 where nothing can be kept.
    fn next(&self, function: &str) -> usize {
        let Some(file) = &self.0 else { return 1 };
        let mut given: Vec<String> =
            fs::read_to_string(file).map(|text| text.lines().map(str::to_owned).collect()).unwrap_or_default();
        given.push(function.to_owned());
        let number = given.iter().filter(|line| *line == function).count();
        let keep = || -> io::Result<()> { fs::File::create(file)?.write_all((given.join("\n") + "\n").as_bytes()) };
        keep().ok();
        number
    }
}
