//! `raytree typeset`: an mdBook from pages that were written for a code host: formulas become pictures in the text, and
//! links to a README.md lead to the page that mdBook makes of it.

use std::io::Read;

use serde_json::Value;

use super::failure::Failure;
use super::output::Target;
use crate::input::Problem;
use crate::pictures::drawing::{Formulas, escape};

/// Sets the formulas of an mdBook: mdbook runs it, see lessons/book.toml
#[derive(Debug, clap::Args)]
#[command(after_help = "Example, in a book.toml:
  [preprocessor.typeset]
  command = \"raytree typeset\"
It reads the book from standard input as mdbook hands it to preprocessors, and writes it to standard output with every
formula between dollar signs as SVG: the book needs no script and no network for them. Links to a README.md become
links to the index.html that mdbook makes of it.")]
pub(super) struct Args {
    /// What mdbook asks first: `supports html`
    #[arg(num_args = 0..=2, value_names = ["supports", "RENDERER"])]
    question: Vec<String>,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    match args.question.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        [] => {}
        ["supports", renderer] => return if *renderer == "html" { Ok(()) } else { Err(Failure::No) },
        _ => {
            let help = "`supports html`, or nothing and a book on standard input";
            return Err(Problem::new("supports", "mdbook asks otherwise", help).into());
        }
    }
    let wrong = |message: String| Problem::new("<stdin>", message, "the JSON that mdbook hands to a preprocessor");
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|error| wrong(format!("it cannot be read: {error}")))?;
    let input: Value = serde_json::from_str(&text).map_err(|error| wrong(format!("it is no JSON: {error}")))?;
    let Value::Array(parts) = input else { return Err(wrong("it is no book".to_owned()).into()) };
    let [_, mut book]: [Value; 2] = parts.try_into().map_err(|_| wrong("it is no book".to_owned()))?;
    chapters(&mut book)?;
    let json = serde_json::to_string(&book).map_err(|error| Failure::Machine(error.to_string()))?;
    Target::Stdout.write_all(json.as_bytes())
}

/// Sets the formulas of every chapter, wherever it is in the book.
fn chapters(value: &mut Value) -> Result<(), Problem> {
    match value {
        Value::Array(values) => values.iter_mut().try_for_each(chapters),
        Value::Object(keys) => {
            if let Some(Value::Object(chapter)) = keys.get_mut("Chapter") {
                let name = chapter.get("name").and_then(Value::as_str).unwrap_or_default().to_owned();
                if let Some(Value::String(content)) = chapter.get_mut("content") {
                    *content = typeset(content).map_err(|(tex, why)| {
                        Problem::new(
                            &name,
                            format!("the formula {tex} cannot be set: {why}"),
                            "TeX that raytree can set",
                        )
                    })?;
                }
            }
            keys.values_mut().try_for_each(chapters)
        }
        _ => Ok(()),
    }
}

/// A page of Markdown with its formulas as SVG; what stands in code stays.
///
/// # Errors
/// The first formula that cannot be set, and why.
fn typeset(page: &str) -> Result<String, (String, String)> {
    let mut formulas = Formulas::default();
    let (mut set, mut fence, mut count) = (String::new(), None, 0);
    for line in page.split_inclusive('\n') {
        let start = line.trim_start();
        let mark = ["```", "~~~"].into_iter().find(|mark| start.starts_with(mark));
        if fence.is_some() || mark.is_some() {
            fence = match (fence, mark) {
                (None, mark) => mark,
                (open, mark) if open == mark => None,
                (open, _) => open,
            };
            set.push_str(line);
            continue;
        }
        let line = line.replace("/README.md)", "/index.md)");
        let mut rest = line.as_str();
        while let Some(at) = rest.find(['$', '`']) {
            set.push_str(&rest[..at]);
            rest = &rest[at..];
            let mark = ["$$", "$", "`"].into_iter().find(|mark| rest.starts_with(mark)).unwrap_or("`");
            let Some(end) = rest[mark.len()..].find(mark) else { break };
            let inner = &rest[mark.len()..mark.len() + end];
            let made = match mark {
                "$$" => formulas.display(inner).map(|svg| format!("<span class=\"display\">{svg}</span>")),
                "$" => formulas.inline(inner),
                _ => Ok(format!("`{inner}`")),
            };
            count += usize::from(mark != "`");
            set.push_str(&made.map_err(|why| (escape(inner), why))?);
            rest = &rest[2 * mark.len() + end..];
        }
        set.push_str(rest);
    }
    if count > 0 {
        set.push_str(&format!("\n\n{}\n", formulas.definitions()));
    }
    Ok(set)
}
