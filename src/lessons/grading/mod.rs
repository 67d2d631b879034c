//! What came of grading a submission: one model, and the formats that are written from it.
//!
//! [`Grade::of`] puts together what was seen of each lesson ([`Attempt`]) and what the course's own solution gets (the key).
//! Nothing here runs anybody's code: `commands::grade` does.

mod cohort;
mod exercism;
mod gradescope;
mod junit;
mod markdown;

use serde::{Deserialize, Serialize};

pub use cohort::{Cohort, MistakeCount, StageCount, Standing};
pub use exercism::to_exercism;
pub use gradescope::to_gradescope;
pub use junit::to_junit;

use super::report::{Failure, FailureKind, Mistake, Outcome, Report, StageReport, listed};
use crate::input::printable;

/// What every result says of the grader.
pub const NO_SANDBOX: &str = "raytree grade runs the submitted code with limits on time, memory and output. It is no \
    sandbox: that code can read files, use the network, and write its own result. Run it in a container or with \
    bubblewrap, without a network.";

/// How many letters of what a program prints are kept.
const KEPT_OUTPUT: usize = 2000;

/// What came of a submission.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grade {
    /// `raytree-grade/1`.
    pub format: String,
    /// That this is no sandbox.
    pub notice: String,
    /// The submission's name.
    pub submission: String,
    /// Its points.
    pub points: u32,
    /// The points there are.
    pub of: u32,
    /// The lessons in order.
    pub lessons: Vec<LessonGrade>,
    /// What the grader wants to say of the submission as a whole.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// What came of a lesson.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LessonGrade {
    /// Its number.
    pub lesson: u32,
    /// Its title.
    pub title: String,
    /// Its folder's name: `03-triangle`.
    pub folder: String,
    /// Its points.
    pub points: u32,
    /// The points there are.
    pub of: u32,
    /// Its stages in order.
    pub stages: Vec<StageGrade>,
    /// Why the compiler refused it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub not_built: Option<NotBuilt>,
    /// What the program printed, cut short.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub output: String,
    /// What a tutor should look at.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// What came of a stage.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StageGrade {
    /// What it is about.
    pub name: String,
    /// The function.
    pub function: String,
    /// Its points if it is right, else 0.
    pub points: u32,
    /// What it is worth.
    pub of: u32,
    /// How many cases it has.
    pub cases: usize,
    /// What came of it.
    pub verdict: Verdict,
    /// The functions that have to be right first, of a stage that was not reached.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub waits_for: Vec<String>,
    /// The functions for which the course's own were put in, so that this stage could be checked all the same.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub checked_with: Vec<String>,
    /// For a reader, what went wrong; nothing where all is right.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// The first failing case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
}

/// What came of a stage, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Every case is right.
    Right,
    /// A case is wrong.
    Wrong,
    /// The function is still to be written.
    Unwritten,
    /// The code panicked.
    Panicked,
    /// A case is wrong, and so is a function that this one builds on.
    NotReached,
    /// It ran longer than it may.
    TimedOut,
    /// It wanted more memory than it may have.
    OutOfMemory,
    /// It printed more than it may.
    TooMuchOutput,
    /// The program ended otherwise without a result.
    Crashed,
    /// The compiler refused it.
    NotBuilt,
    /// There is no such file.
    Missing,
}

impl Verdict {
    /// All of them.
    pub const ALL: [Verdict; 11] = [
        Verdict::Right,
        Verdict::Wrong,
        Verdict::Unwritten,
        Verdict::Panicked,
        Verdict::NotReached,
        Verdict::TimedOut,
        Verdict::OutOfMemory,
        Verdict::TooMuchOutput,
        Verdict::Crashed,
        Verdict::NotBuilt,
        Verdict::Missing,
    ];

    /// As it stands in a table.
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Right => "right",
            Verdict::Wrong => "wrong",
            Verdict::Unwritten => "not written",
            Verdict::Panicked => "panicked",
            Verdict::NotReached => "not reached",
            Verdict::TimedOut => "out of time",
            Verdict::OutOfMemory => "out of memory",
            Verdict::TooMuchOutput => "too much output",
            Verdict::Crashed => "crashed",
            Verdict::NotBuilt => "not compiled",
            Verdict::Missing => "missing",
        }
    }

    /// As it stands in JSON.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Right => "right",
            Verdict::Wrong => "wrong",
            Verdict::Unwritten => "unwritten",
            Verdict::Panicked => "panicked",
            Verdict::NotReached => "not_reached",
            Verdict::TimedOut => "timed_out",
            Verdict::OutOfMemory => "out_of_memory",
            Verdict::TooMuchOutput => "too_much_output",
            Verdict::Crashed => "crashed",
            Verdict::NotBuilt => "not_built",
            Verdict::Missing => "missing",
        }
    }

    /// Whether the code did not get as far as an answer, rather than giving a wrong one.
    fn is_error(self) -> bool {
        use Verdict::{Crashed, NotBuilt, OutOfMemory, Panicked, TimedOut, TooMuchOutput};
        matches!(self, Panicked | TimedOut | OutOfMemory | TooMuchOutput | Crashed | NotBuilt)
    }
}

/// Why the compiler refused a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct NotBuilt {
    /// The first error, in a line.
    pub message: String,
    /// Where: `lessons/02-plane/exercise.rs:12:5`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
    /// The first error as the compiler prints it.
    pub text: String,
    /// How many errors there are.
    pub errors: usize,
}

/// A program that ended without a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stopped {
    /// [`Verdict::TimedOut`], [`Verdict::OutOfMemory`], [`Verdict::TooMuchOutput`] or [`Verdict::Crashed`].
    pub verdict: Verdict,
    /// How it ended, as a sentence.
    pub message: String,
}

/// What was seen of a lesson of a submission.
#[derive(Clone, Debug, PartialEq)]
pub enum Attempt {
    /// There is no file.
    Missing,
    /// The compiler refused it.
    NotBuilt(NotBuilt),
    /// It ran to the end.
    Ran {
        /// Its report.
        report: Report,
        /// What it printed.
        output: String,
    },
    /// It did not run to the end, so that each stage was run in a process of its own.
    ByStages {
        /// What came of each, in order; a report is that of [`super::Lesson::check_stage`].
        stages: Vec<Result<StageReport, Stopped>>,
        /// What they printed.
        output: String,
    },
}

impl Grade {
    /// The grade of a submission with these lessons.
    pub fn of(submission: &str, lessons: Vec<LessonGrade>, notes: Vec<String>) -> Self {
        Grade {
            format: "raytree-grade/1".to_owned(),
            notice: NO_SANDBOX.to_owned(),
            submission: submission.to_owned(),
            points: lessons.iter().map(|lesson| lesson.points).sum(),
            of: lessons.iter().map(|lesson| lesson.of).sum(),
            lessons,
            notes,
        }
    }
}

impl LessonGrade {
    /// The grade of a lesson. `key` is the report of the course's own solution, from which its stages are taken.
    pub fn of(key: &Report, folder: &str, attempt: &Attempt) -> Self {
        let mut notes = Vec::new();
        let untried = |verdict, message: &str| {
            key.stages.iter().map(|stage| StageGrade::stopped(stage, verdict, message.to_owned())).collect()
        };
        let (stages, output): (Vec<StageGrade>, &str) = match attempt {
            Attempt::Missing => (untried(Verdict::Missing, "There is no such file in the submission."), ""),
            Attempt::NotBuilt(not_built) => {
                let at = not_built.place.as_deref().map_or(String::new(), |place| format!("{place}: "));
                (untried(Verdict::NotBuilt, &format!("It does not compile. {at}{}", not_built.message)), "")
            }
            Attempt::Ran { report, output } => {
                if is_of(report, key) {
                    (report.stages.iter().map(StageGrade::reported).collect(), output)
                } else {
                    notes.push("the result has other stages than the lesson: something else wrote it".to_owned());
                    let message = "The program wrote a result that is not this lesson's.";
                    (untried(Verdict::Crashed, message), output)
                }
            }
            Attempt::ByStages { stages, output } => (by_stages(key, stages), output),
        };
        LessonGrade {
            lesson: key.lesson,
            title: key.title.clone(),
            folder: folder.to_owned(),
            points: stages.iter().map(|stage| stage.points).sum(),
            of: key.of,
            stages,
            not_built: match attempt {
                Attempt::NotBuilt(not_built) => Some(not_built.clone()),
                _ => None,
            },
            output: shortened(output, KEPT_OUTPUT),
            notes,
        }
    }

    /// The functions that are not right by themselves, if there are stages that wait for them alone: those could be checked
    /// with the right ones put in.
    pub fn holds_up(&self) -> Vec<String> {
        let is_own = |stage: &&StageGrade| {
            !matches!(stage.verdict, Verdict::Right | Verdict::NotReached | Verdict::NotBuilt | Verdict::Missing)
        };
        let mut functions: Vec<String> = Vec::new();
        for stage in self.stages.iter().filter(is_own) {
            if !functions.contains(&stage.function) {
                functions.push(stage.function.clone());
            }
        }
        let waits = |stage: &StageGrade| stage.can_follow(&functions);
        if self.stages.iter().any(waits) { functions } else { Vec::new() }
    }

    /// Takes over what came of the stages that were not reached, from an attempt with the right functions put in for
    /// `replaced`. Returns whether there was any.
    pub fn follow(&mut self, key: &Report, replaced: &[String], attempt: &Attempt) -> bool {
        let mut is_any = false;
        let again = LessonGrade::of(key, &self.folder, attempt);
        for (stage, again) in self.stages.iter_mut().zip(again.stages) {
            if stage.can_follow(replaced) && !matches!(again.verdict, Verdict::NotReached | Verdict::NotBuilt) {
                *stage = StageGrade { checked_with: replaced.to_vec(), ..again };
                is_any = true;
            }
        }
        self.points = self.stages.iter().map(|stage| stage.points).sum();
        is_any
    }

    /// The first stage that is not right.
    fn first_open(&self) -> Option<&StageGrade> {
        self.stages.iter().find(|stage| stage.verdict != Verdict::Right)
    }
}

/// Whether a report is about the lesson of the key: the same stages, worth the same.
fn is_of(report: &Report, key: &Report) -> bool {
    report.lesson == key.lesson
        && report.stages.len() == key.stages.len()
        && report.stages.iter().zip(&key.stages).all(|(stage, key)| is_stage_of(stage, key))
}

fn is_stage_of(stage: &StageReport, key: &StageReport) -> bool {
    let points = if stage.outcome == Outcome::Passed { key.points } else { 0 };
    (&stage.name, &stage.function, stage.of, stage.cases) == (&key.name, &key.function, key.of, key.cases)
        && stage.points == points
}

/// The stages of a lesson that were run one by one. One that is not right and builds on one that is not was not reached.
fn by_stages(key: &Report, stages: &[Result<StageReport, Stopped>]) -> Vec<StageGrade> {
    let mut grades: Vec<StageGrade> = Vec::new();
    for (key, came) in key.stages.iter().zip(stages) {
        let is_open = |name: &&String| grades.iter().any(|s| s.function == **name && s.verdict != Verdict::Right);
        let waits_for: Vec<String> = key.after.iter().filter(is_open).cloned().collect();
        let grade = match came {
            Ok(report) if !is_stage_of(report, key) => {
                let message = "The program wrote a result that is not this lesson's.";
                StageGrade::stopped(key, Verdict::Crashed, message.to_owned())
            }
            Ok(report) => StageGrade::reported(report),
            Err(stopped) => StageGrade::stopped(key, stopped.verdict, stopped.message.clone()),
        };
        grades.push(match grade.verdict {
            Verdict::Right => grade,
            _ if waits_for.is_empty() => grade,
            _ => {
                let message = format!("waits for {}", listed(&waits_for));
                StageGrade { waits_for, ..StageGrade::stopped(key, Verdict::NotReached, message) }
            }
        });
    }
    grades
}

impl StageGrade {
    /// Whether it can be checked with the right functions put in for `replaced`: not one of several functions together,
    /// `the program`, of which nothing of the student's might be left.
    fn can_follow(&self, replaced: &[String]) -> bool {
        let is_one = !self.function.contains(' ');
        self.verdict == Verdict::NotReached && is_one && !replaced.contains(&self.function)
    }

    /// The grade of a stage that has a report.
    fn reported(stage: &StageReport) -> Self {
        let kind = stage.failure.as_ref().map(|failure| failure.kind);
        let verdict = match (stage.outcome, kind) {
            (Outcome::Passed, _) => Verdict::Right,
            (Outcome::NotReached, _) => Verdict::NotReached,
            (Outcome::Failed, Some(FailureKind::Unwritten)) => Verdict::Unwritten,
            (Outcome::Failed, Some(FailureKind::Panicked)) => Verdict::Panicked,
            (Outcome::Failed, _) => Verdict::Wrong,
        };
        let message = match (&stage.failure, verdict) {
            (_, Verdict::Right) => None,
            (Some(failure), _) => Some(clean(&failure.to_text(&stage.function, stage.cases))),
            (None, _) => Some(format!("waits for {}", listed(&stage.waits_for))),
        };
        StageGrade {
            name: stage.name.clone(),
            function: stage.function.clone(),
            points: stage.points,
            of: stage.of,
            cases: stage.cases,
            verdict,
            waits_for: if verdict == Verdict::NotReached { stage.waits_for.clone() } else { Vec::new() },
            checked_with: Vec::new(),
            message,
            failure: stage.failure.clone().filter(|_| verdict != Verdict::Right),
        }
    }

    /// The grade of a stage that has none.
    fn stopped(key: &StageReport, verdict: Verdict, message: String) -> Self {
        StageGrade {
            name: key.name.clone(),
            function: key.function.clone(),
            points: 0,
            of: key.of,
            cases: key.cases,
            verdict,
            waits_for: Vec::new(),
            checked_with: Vec::new(),
            message: Some(clean(&message)),
            failure: None,
        }
    }

    /// The mistake, where it is a known one.
    pub fn mistake(&self) -> Option<&Mistake> {
        self.failure.as_ref()?.mistake.as_ref()
    }

    /// What came of it, for a table.
    fn verdict_words(&self) -> String {
        match self.checked_with.as_slice() {
            [] => self.verdict.words().to_owned(),
            with => format!("{}, with the course's {}", self.verdict.words(), with.join(" and ")),
        }
    }

    /// The stage in a few words.
    fn title(&self) -> String {
        format!("{}: {}", self.function, self.name)
    }
}

/// A text with nothing in it that would steer a terminal; its lines stay, blanks at its end go.
fn clean(text: &str) -> String {
    text.trim_end()
        .lines()
        .map(|line| printable(&line.replace('\t', "    ")).into_owned())
        .collect::<Vec<_>>()
        .join("\n")
}

/// The beginning of a text, and a note where that is not all.
fn shortened(text: &str, letters: usize) -> String {
    let text = clean(text);
    match text.char_indices().nth(letters) {
        None => text,
        Some((end, _)) => format!("{} [...]", &text[..end]),
    }
}

/// JSON with a line for each value.
fn indented(value: &impl Serialize) -> String {
    // Plain data with text keys has a JSON form.
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}

impl Grade {
    /// The whole model as JSON.
    pub fn to_json(&self) -> String {
        indented(self)
    }
}
