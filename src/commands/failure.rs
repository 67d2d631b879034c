//! Why a command ends otherwise than well, what it says, and the exit code.

use std::io::{ErrorKind, IsTerminal, Write};

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use crate::input::{Place, Problem, printable};

/// Why a command ends otherwise than well.
#[derive(Debug)]
pub(super) enum Failure {
    /// The answer is no, and has been given.
    No,
    /// The answer is no, for this reason.
    Invalid(Problem),
    /// The input is at fault.
    Input(Problem),
    /// The machine is at fault.
    Machine(String),
    /// The reader of a pipe has gone.
    ClosedPipe,
    /// Ctrl-C.
    Interrupted,
}

impl From<Problem> for Failure {
    fn from(problem: Problem) -> Self {
        Self::Input(problem)
    }
}

impl Failure {
    /// A failed write to `what`.
    pub(super) fn from_write(what: &str, error: &std::io::Error) -> Self {
        match error.kind() {
            ErrorKind::BrokenPipe => Self::ClosedPipe,
            // The message of a temporary file names that file, which nobody asked for.
            _ => {
                let why = error.raw_os_error().map_or_else(
                    || error.kind().to_string(),
                    |code| std::io::Error::from_raw_os_error(code).to_string(),
                );
                Self::Machine(format!("{what} cannot be written: {why}"))
            }
        }
    }

    /// Says what is wrong and ends the program, where there is no way back: in the handler of a signal.
    pub(super) fn exit(&self) -> ! {
        std::process::exit(self.report().into())
    }

    /// Says what is wrong on standard error; the exit code.
    pub(super) fn report(&self) -> u8 {
        let (code, text) = match self {
            Self::No => (1, None),
            Self::Invalid(problem) => (1, Some(draw(problem))),
            Self::Input(problem) => (2, Some(draw(problem))),
            Self::Machine(message) => (3, Some(format!("error: {}", printable(message)))),
            Self::ClosedPipe => (0, None),
            Self::Interrupted => (130, Some("interrupted".to_owned())),
        };
        if let Some(text) = text {
            // If standard error is gone too, the exit code has to do.
            writeln!(std::io::stderr(), "{text}").ok();
        }
        code
    }
}

/// The problem with nothing in it that would steer a terminal.
fn printable_problem(problem: &Problem) -> Problem {
    let clean = |text: &str| printable(text).into_owned();
    Problem {
        file: clean(&problem.file),
        message: clean(&problem.message),
        help: clean(&problem.help),
        path: problem.path.as_deref().map(clean),
        place: problem.place.as_ref().map(|place| {
            // A tab is drawn as it should be; what steers becomes one sign, piece by piece, so that the span stays
            // right.
            let seen = |piece: &str| -> String {
                piece
                    .chars()
                    .map(|c| if c != '\t' && printable(&c.to_string()) != c.to_string() { '\u{fffd}' } else { c })
                    .collect()
            };
            let (before, rest) = place.text.split_at(place.span.start);
            let (inside, after) = rest.split_at(place.span.len());
            let (before, inside, after) = (seen(before), seen(inside), seen(after));
            let span = before.len()..before.len() + inside.len();
            Box::new(Place { text: before + &inside + &after, span, ..**place })
        }),
    }
}

/// The problem with its line underlined, in colour where standard error is a terminal that wants it.
fn draw(problem: &Problem) -> String {
    let problem = &printable_problem(problem);
    let no_color = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let renderer = match std::io::stderr().is_terminal() && !no_color {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    let title = Level::ERROR.primary_title(problem.message.as_str());
    let help = Level::HELP.message(problem.help.as_str());
    let report = match &problem.place {
        None => {
            let at = match &problem.path {
                Some(path) => format!("{}: {path}", problem.file),
                None => problem.file.clone(),
            };
            Group::with_title(title).element(Level::NOTE.message(format!("in {at}"))).element(help)
        }
        Some(place) => {
            let path = problem.path.clone().unwrap_or_default();
            let annotation = AnnotationKind::Primary.span(place.span.clone()).label(path);
            let snippet = Snippet::source(place.text.as_str())
                .line_start(place.line)
                .path(problem.file.as_str())
                .annotation(annotation);
            Group::with_title(title).element(snippet).element(help)
        }
    };
    renderer.decor_style(DecorStyle::Ascii).render(&[report]).clone()
}
