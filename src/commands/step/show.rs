//! What a session prints: the line at hand, the arithmetic, the stack, the tree.

use std::fmt::Write;

use crate::input::printable;
use crate::steps::arithmetic::decimals;
use crate::steps::{Frame, PSEUDOCODE, Recording, Step, Variable, Worked};
use crate::tree::{Kind, RayNode, Show, Value};

/// Whether there is colour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    pub(super) colored: bool,
}

/// What a piece of text is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ink {
    /// Where one is.
    Here,
    /// What holds.
    Yes,
    /// What does not.
    No,
    /// What may be passed over.
    Faint,
}

impl Look {
    /// A text in its colour.
    pub(super) fn ink(self, ink: Ink, text: &str) -> String {
        let code = match ink {
            Ink::Here => "1",
            Ink::Yes => "32",
            Ink::No => "33",
            Ink::Faint => "2",
        };
        if self.colored { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}

/// The step: where, the line among its neighbours, the arithmetic, the finding.
pub(super) fn step(recording: &Recording<'_>, look: Look, at: usize) -> String {
    let step = &recording.steps[at];
    let node = &recording.nodes[step.node];
    let mut out = String::new();
    let place = format!("step {} of {}", at + 1, recording.steps.len());
    // Not its name, which says what became of it before the steps do.
    let what = match (node.ray.kind, node.ray.weight) {
        (Kind::Shadow, _) | (_, None) => format!("{}: {}", node.path, kind(node.ray)),
        _ => format!("{}: {}, level {}", node.path, kind(node.ray), node.ray.depth),
    };
    writeln!(out, "{}  {}", look.ink(Ink::Here, &place), look.ink(Ink::Faint, &what)).ok();
    out.push_str(&code(look, step.line, 2));
    let worked = recording.worked(step);
    if !worked.is_empty() {
        out.push_str(&arithmetic(&worked));
    }
    if let Some(note) = step.arithmetic.as_ref().and_then(|arithmetic| arithmetic.note.as_ref()) {
        writeln!(out, "    {note}").ok();
    }
    if let Some(finding) = &step.finding {
        let ink = if finding.is_ok { Ink::Yes } else { Ink::No };
        writeln!(out, "  {}", look.ink(ink, &format!("=> {}", printable(&finding.words)))).ok();
    }
    for (name, value) in &step.set {
        writeln!(out, "  {name} := {}", variable(value)).ok();
    }
    out
}

/// What a ray is for.
fn kind(ray: &RayNode) -> String {
    let to = ray.light.as_ref().map_or(String::new(), |light| format!(" to {}", printable(light)));
    let word = match ray.kind {
        Kind::Camera => "camera ray",
        Kind::Shadow => "shadow ray",
        Kind::Reflected => "reflected ray",
        Kind::Refracted => "refracted ray",
    };
    format!("{word}{to}")
}

/// The pseudocode around a line: so many lines of its procedure before and after it.
pub(super) fn code(look: Look, line: usize, around: usize) -> String {
    let procedure = PSEUDOCODE[line].procedure;
    let near = line.saturating_sub(around)..=line.saturating_add(around);
    let mut out = String::new();
    for (i, code) in PSEUDOCODE.iter().enumerate() {
        if code.procedure != procedure || !near.contains(&i) {
            continue;
        }
        let text = format!("{}{}", "  ".repeat(code.indent.into()), code.text);
        match i == line {
            true => writeln!(out, "{}", look.ink(Ink::Here, &format!("> {text}"))).ok(),
            false => writeln!(out, "  {}", look.ink(Ink::Faint, &text)).ok(),
        };
    }
    out
}

/// All of the pseudocode, the line at hand marked.
pub(super) fn all_code(look: Look, line: usize) -> String {
    let mut out = String::new();
    let mut last = None;
    for (i, code) in PSEUDOCODE.iter().enumerate() {
        if last.replace(code.procedure).is_some_and(|last| last != code.procedure) {
            out.push('\n');
        }
        let text = format!("{}{}", "  ".repeat(code.indent.into()), code.text);
        match i == line {
            true => writeln!(out, "{}", look.ink(Ink::Here, &format!("> {text}"))).ok(),
            false => writeln!(out, "  {text}").ok(),
        };
    }
    out
}

/// Formulas: in symbols, with numbers, the result.
pub(super) fn arithmetic(lines: &[Worked]) -> String {
    let mut out = String::new();
    for Worked { name, symbols, numbers, result } in lines {
        let gap = " ".repeat(name.chars().count());
        writeln!(out, "    {name} = {symbols}").ok();
        writeln!(out, "    {gap} = {numbers} = {result}").ok();
    }
    out
}

/// The call stack, the innermost frame first, with its variables.
pub(super) fn stack(recording: &Recording<'_>, look: Look, frames: &[Frame]) -> String {
    let mut out = String::new();
    for (i, frame) in frames.iter().rev().enumerate() {
        let name = frame.procedure.name();
        let path = recording.nodes[frame.node].path.to_string();
        writeln!(out, "#{i} {}  {}", look.ink(Ink::Here, name), look.ink(Ink::Faint, &path)).ok();
        for (name, value) in &frame.variables {
            writeln!(out, "     {name} = {}", variable(value)).ok();
        }
    }
    out
}

/// The tree, the node at hand marked.
pub(super) fn tree(recording: &Recording<'_>, look: Look, name: Option<&str>, node: usize) -> String {
    let text = recording.tree.without_tests().to_text(Show { name, certificates: false });
    let mut out = String::new();
    // One line for the pixel, then one a node.
    for (i, line) in text.lines().enumerate() {
        match i == node + 1 {
            true => writeln!(out, "{}", look.ink(Ink::Here, &format!("> {line}"))).ok(),
            false => writeln!(out, "  {line}").ok(),
        };
    }
    out
}

/// A variable's value.
pub(super) fn variable(value: &Variable) -> String {
    let vector = |v: &[f64; 3]| value_text(&Value::Vector(*v));
    match value {
        Variable::Integer(x) => x.to_string(),
        Variable::Number(x) => value_text(&Value::Number(*x)),
        Variable::Vector(v) => vector(v),
        Variable::Text(text) => printable(text).into_owned(),
        Variable::Ray { origin, direction, t_max } => {
            let end = t_max.map_or(String::new(), |t| format!(", t < {}", value_text(&Value::Number(t))));
            format!("from {} along {}{end}", vector(origin), vector(direction))
        }
        Variable::Hit { t, object, shape, primitive } => {
            let object = object.as_ref().map_or_else(|| format!("shape {shape}"), |name| printable(name).into_owned());
            let primitive = primitive.map_or(String::new(), |primitive| format!(" #{primitive}"));
            format!("{object}{primitive} at t = {}", value_text(&Value::Number(*t)))
        }
    }
}

/// A number or vector with all its digits.
pub(super) fn value_text(value: &Value) -> String {
    decimals(value, crate::numbers::Precision::F64)
}

/// The diagram, the events and the question of a step have no place in [`step`]; this names what a step is about.
pub(super) fn title(recording: &Recording<'_>, step: &Step) -> String {
    let form = step.arithmetic.as_ref().map(|arithmetic| &recording.forms[arithmetic.form]);
    form.map_or_else(
        || "nothing is computed at this step".to_owned(),
        |form| format!("{}; {}", form.title, form.source),
    )
}
