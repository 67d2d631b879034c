//! `raytree exercise`: numeric questions for paper and for learning platforms.

use super::failure::Failure;
use super::output::Target;
use crate::input::{Problem, nearest, one_of, printable};
use crate::lessons::questions::{
    Kind, questions, to_latex, to_latex_answers, to_markdown, to_markdown_answers, to_moodle,
};

/// Writes numeric questions with numbers of their own for each seed, and their answers
#[derive(Debug, clap::Args)]
#[command(after_help = kinds(), after_long_help = kinds())]
pub(super) struct Args {
    /// Which questions: another number gives other ones, the same the same on every machine
    #[arg(long, value_name = "N")]
    seed: u64,
    /// How many [default: one of each kind]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    count: Option<u16>,
    /// What about, taking turns: plane,sphere [default: every kind]; see below
    #[arg(long, value_name = "KIND", value_delimiter = ',')]
    kind: Vec<String>,
    /// The format [default: by the ending of the file, .md, .tex or .xml; else markdown]
    #[arg(long, value_enum)]
    format: Option<FormatArg>,
    /// Where the questions go: a path, or - for standard output [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<String>,
    /// Where the answers go, in the same format; Moodle XML holds them already
    #[arg(long, value_name = "FILE")]
    answers: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum FormatArg {
    /// Formulas between dollar signs
    Markdown,
    /// A document of its own
    Latex,
    /// A numerical question for each number, with answer and tolerance
    Moodle,
}

/// The list of kinds and examples, for the help.
fn kinds() -> String {
    let lines = Kind::ALL.map(|kind| format!("  {:<11} {}\n", kind.name(), kind.title())).concat();
    format!(
        "Kinds:\n{lines}\nExamples:
  raytree exercise --seed 17 -o sheet.tex --answers answers.tex
  raytree exercise --seed 17 --kind plane,sphere --count 20 -o quiz.xml

Hit or miss is decided by the certified kernels, and the answers are theirs. Students get a sheet of their own each if
the seed is their number."
    )
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let kinds = match args.kind.as_slice() {
        [] => Kind::ALL.to_vec(),
        names => names.iter().map(|name| find(name)).collect::<Result<_, _>>()?,
    };
    let ending = args.output.as_deref().and_then(|file| file.rsplit_once('.'));
    let format = args.format.unwrap_or(match ending {
        Some((_, "tex")) => FormatArg::Latex,
        Some((_, "xml")) => FormatArg::Moodle,
        _ => FormatArg::Markdown,
    });
    let target = Target::new(args.output.as_deref(), &[])?;
    let answers = args.answers.as_deref().map(|file| Target::new(Some(file), &[])).transpose()?;
    if answers.is_some() && format == FormatArg::Moodle {
        let help = "no --answers, or another --format";
        return Err(Problem::new("--answers", "the answers are in the Moodle file itself", help).into());
    }
    if answers.as_ref().is_some_and(|answers| answers.is_same(&target)) {
        let help = "another file for the answers";
        return Err(Problem::new("--answers", "questions and answers would go to the same place", help).into());
    }
    let drawn = questions(args.seed, &kinds, args.count.map_or(kinds.len(), usize::from));
    let title = format!("Ray tracing, sheet {}", args.seed);
    let (page, key) = match format {
        FormatArg::Markdown => (to_markdown(&drawn, &title), to_markdown_answers(&drawn, &title)),
        FormatArg::Latex => (to_latex(&drawn, &title), to_latex_answers(&drawn, &title)),
        FormatArg::Moodle => (to_moodle(&drawn, &title), String::new()),
    };
    if let Some(answers) = answers {
        answers.write_all(key.as_bytes())?;
    }
    target.write_all(page.as_bytes())
}

/// The kind with a name.
fn find(name: &str) -> Result<Kind, Failure> {
    Kind::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| {
        let names = || Kind::ALL.iter().map(|kind| kind.name());
        let near = nearest(name, names()).map_or(String::new(), |near| format!("did you mean `{near}`? "));
        let message = format!("there is no kind of question `{}`", printable(name));
        Problem::new("--kind", message, format!("{near}{}", one_of(names()))).into()
    })
}
