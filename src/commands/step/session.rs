//! A session: commands from a terminal or a script, one a line.

use std::io::{BufRead, Write};
use std::path::PathBuf;

use super::super::failure::Failure;
use super::draw::draw;
use super::show::{self, Ink, Look};
use crate::input::{nearest, one_of, printable};
use crate::scene::Loaded;
use crate::steps::{Event, Player, Recording};
use crate::tree::{TestRecord, Value};

/// What a command may be called, and what it does.
struct Command {
    names: &'static [&'static str],
    form: &'static str,
    about: &'static str,
    does: Does,
}

#[derive(Clone, Copy)]
enum Does {
    Into,
    Over,
    Out,
    Back,
    Start,
    End,
    To,
    Until,
    Tree,
    Where,
    Print,
    List,
    Draw,
    Events,
    Help,
    Quit,
}

const COMMANDS: [Command; 16] = [
    Command { names: &["s", "into", "step"], form: "s, into [N]", about: "the next step", does: Does::Into },
    Command {
        names: &["n", "over", "next"],
        form: "n, over [N]",
        about: "the next step of this procedure: what is called here is carried out",
        does: Does::Over,
    },
    Command { names: &["o", "out"], form: "o, out [N]", about: "out of this procedure", does: Does::Out },
    Command { names: &["b", "back"], form: "b, back [N]", about: "the step before", does: Does::Back },
    Command { names: &["start"], form: "start", about: "the first step", does: Does::Start },
    Command { names: &["end"], form: "end", about: "the last step", does: Does::End },
    Command { names: &["to"], form: "to N", about: "step N", does: Does::To },
    Command {
        names: &["u", "until"],
        form: "u, until EVENT",
        about: "the next step where something happens; `events` lists what",
        does: Does::Until,
    },
    Command { names: &["tree"], form: "tree", about: "all rays, the one at hand marked", does: Does::Tree },
    Command {
        names: &["w", "where"],
        form: "w, where",
        about: "the call stack with its variables, the innermost first",
        does: Does::Where,
    },
    Command {
        names: &["p", "print"],
        form: "p, print NAME",
        about: "hit, ray, color, level, weight, test, arithmetic, or any variable",
        does: Does::Print,
    },
    Command {
        names: &["l", "list"],
        form: "l, list [all]",
        about: "the pseudocode of this procedure, or all of it",
        does: Does::List,
    },
    Command {
        names: &["d", "draw"],
        form: "d, draw [KIND] [FILE]",
        about: "writes the diagram of this step, SVG or PNG",
        does: Does::Draw,
    },
    Command { names: &["events"], form: "events", about: "what `until` can wait for", does: Does::Events },
    Command { names: &["?", "h", "help"], form: "?, help", about: "this list", does: Does::Help },
    Command {
        names: &["q", "quit", "exit"],
        form: "q, quit",
        about: "leaves; the end of the input does too",
        does: Does::Quit,
    },
];

/// A session.
pub(super) struct Session<'r> {
    loaded: &'r Loaded,
    recording: &'r Recording<'r>,
    player: Player<'r>,
    name: Option<&'r str>,
    look: Look,
    last: String,
    /// The files that this session has drawn.
    written: Vec<PathBuf>,
}

impl<'r> Session<'r> {
    pub(super) fn new(loaded: &'r Loaded, recording: &'r Recording<'r>, name: Option<&'r str>, look: Look) -> Self {
        let player = Player::new(recording);
        Self { loaded, recording, player, name, look, last: String::new(), written: Vec::new() }
    }

    /// Plays commands until one says to leave, or there are no more.
    ///
    /// # Errors
    /// A failed write or read.
    pub(super) fn play(
        &mut self,
        input: &mut dyn BufRead,
        output: &mut dyn Write,
        prompts: bool,
    ) -> Result<(), Failure> {
        let pixel = self.recording.tree.pixel.map_or(String::new(), |[x, y]| format!("pixel {x},{y}"));
        let name = self.name.map_or(String::new(), |name| format!(" \"{}\"", printable(name)));
        let (steps, rays) = (self.recording.steps.len(), self.recording.tree.rays);
        let file = printable(&self.loaded.file);
        let plural = if rays == 1 { "" } else { "s" };
        let head = format!("{pixel}{name} of {file}: {rays} ray{plural}, {steps} steps; ? for help\n");
        let say = |output: &mut dyn Write, text: &str| {
            let said = output.write_all(text.as_bytes()).and_then(|()| output.flush());
            said.map_err(|error| Failure::from_write("standard output", &error))
        };
        say(output, &(head + &self.here()))?;
        loop {
            if prompts {
                say(output, "(raytree) ")?;
            }
            let mut line = Vec::new();
            let read = input.read_until(b'\n', &mut line);
            let read = read.map_err(|error| Failure::Machine(format!("standard input cannot be read: {error}")))?;
            if read == 0 {
                // The shell's prompt begins a line of its own.
                return if prompts { say(output, "\n") } else { Ok(()) };
            }
            let line = String::from_utf8_lossy(&line).trim().to_owned();
            if !line.is_empty() {
                self.last = line;
            }
            let line = self.last.clone();
            match self.obey(&line) {
                Some(text) => say(output, &text)?,
                None => return Ok(()),
            }
        }
    }

    fn here(&self) -> String {
        show::step(self.recording, self.look, self.player.at())
    }

    /// What a command answers; nothing if it says to leave.
    fn obey(&mut self, line: &str) -> Option<String> {
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        if word.is_empty() {
            return Some(self.here());
        }
        let Some(command) = COMMANDS.iter().find(|command| command.names.contains(&word)) else {
            return Some(self.no(&unknown(word)));
        };
        let at = self.player.at();
        let step = &self.recording.steps[at];
        Some(match command.does {
            Does::Quit => return None,
            Does::Into => self.moved(rest, Player::step_into),
            Does::Over => self.moved(rest, Player::step_over),
            Does::Out => self.moved(rest, Player::step_out),
            Does::Back => self.moved(rest, Player::step_back),
            Does::Start => {
                self.player.start();
                self.here()
            }
            Does::End => {
                self.player.end();
                self.here()
            }
            Does::To => match rest.parse::<usize>() {
                Ok(n) if (1..=self.recording.steps.len()).contains(&n) => {
                    self.player.to(n - 1);
                    self.here()
                }
                _ => self.no(&format!("`to` wants the number of a step, 1 to {}", self.recording.steps.len())),
            },
            Does::Until => self.until(rest),
            Does::Tree => show::tree(self.recording, self.look, self.name, step.node),
            Does::Where => show::stack(self.recording, self.look, &self.recording.stack(at)),
            Does::Print => self.print(rest),
            Does::List => match rest {
                "" => show::code(self.look, step.line, usize::MAX),
                "all" => show::all_code(self.look, step.line),
                _ => self.no("`list` wants nothing, or `all`"),
            },
            Does::Draw => match draw(self.loaded, self.recording, at, rest, &mut self.written) {
                Ok(text) => text + "\n",
                Err(why) => self.no(&why),
            },
            Does::Events => list(Event::LIST.iter().map(|(form, about)| (*form, *about))),
            Does::Help => {
                let mut help = list(COMMANDS.iter().map(|command| (command.form, command.about)));
                help.push_str("  An empty line repeats the last command.\n");
                help
            }
        })
    }

    /// A message that something cannot be done.
    fn no(&self, why: &str) -> String {
        let why = printable(why);
        format!("{}\n", self.look.ink(Ink::No, &why))
    }

    /// A move, made so many times.
    fn moved(&mut self, count: &str, step: fn(&mut Player<'r>) -> bool) -> String {
        let count = if count.is_empty() { Ok(1) } else { count.parse::<usize>() };
        let Ok(count) = count else { return self.no("how often? a whole number") };
        let mut is_moved = false;
        for _ in 0..count {
            if !step(&mut self.player) {
                break;
            }
            is_moved = true;
        }
        if is_moved || count == 0 {
            return self.here();
        }
        let (at, steps) = (self.player.at(), self.recording.steps.len());
        self.no(match at {
            0 if steps > 1 => "this is the first step",
            _ if at + 1 == steps => "this is the last step",
            _ => "there is nothing further out",
        })
    }

    fn until(&mut self, words: &str) -> String {
        let event: Event = match words.parse() {
            Ok(event) => event,
            Err(no) => {
                let no: crate::steps::NoSuchEvent = no;
                return self.no(&no.to_string());
            }
        };
        if let Event::Object(name) = &event {
            let names = || self.loaded.scene.objects.iter().map(|object| object.name.as_str());
            if !names().any(|known| known == name) {
                let near = nearest(name, names()).map_or(String::new(), |near| format!("did you mean `{near}`? "));
                return self.no(&format!("the scene has no object `{name}`: {near}{}", one_of(names())));
            }
        }
        if self.player.until(&event) {
            return self.here();
        }
        self.no(&format!("`{event}` does not come after step {}: staying there", self.player.at() + 1))
    }

    fn print(&self, name: &str) -> String {
        let at = self.player.at();
        let step = &self.recording.steps[at];
        let node = self.recording.nodes[step.node].ray;
        let stack = self.recording.stack(at);
        // The innermost variable of that name.
        let variable = |name: &str| {
            let mut variables = stack.iter().rev().flat_map(|frame| frame.variables.iter());
            variables.find(|(known, _)| *known == name).map(|(_, value)| show::variable(value))
        };
        let vector = |v: [f64; 3]| show::value_text(&Value::Vector(v));
        let json = |value: serde_json::Result<String>| value.unwrap_or_default();
        let value = match name {
            "" => None,
            "arithmetic" => {
                let worked = show::arithmetic(&self.recording.worked(step));
                return format!("{}\n{worked}", show::title(self.recording, step));
            }
            "test" => Some(match self.recording.test_of(step) {
                None => "no test at this step".to_owned(),
                Some(TestRecord::Bounds(test)) => json(serde_json::to_string(test)),
                Some(TestRecord::Shape(test)) => json(serde_json::to_string(test)),
            }),
            "ray" => Some(format!("from {} along {}", vector(node.origin), vector(node.direction))),
            "level" => Some(node.depth.to_string()),
            "weight" => Some(node.weight.map_or_else(|| "none: a shadow ray".to_owned(), vector)),
            "node" => {
                Some(format!("{}: {}", self.recording.nodes[step.node].path, self.recording.nodes[step.node].name))
            }
            "hit" => variable(name).or_else(|| Some("not known yet".to_owned())),
            "color" => variable(name).or_else(|| Some("not known yet".to_owned())),
            _ => variable(name).or_else(|| self.recording.value(step, name).map(|value| show::value_text(&value))),
        };
        match value {
            Some(value) => format!("{name} = {}\n", printable(&value)),
            None => {
                let mut names = vec!["arithmetic", "color", "hit", "level", "node", "ray", "test", "weight"];
                names.extend(stack.iter().flat_map(|frame| frame.variables.iter().map(|(name, _)| *name)));
                names.extend(
                    step.arithmetic.iter().flat_map(|arithmetic| arithmetic.values.iter().map(|(name, _)| *name)),
                );
                names.sort_unstable();
                names.dedup();
                let names_here = names.join(", ");
                if name.is_empty() {
                    return self.no(&format!("print what? {names_here}"));
                }
                let near = nearest(name, names.iter().copied());
                let near = near.map_or(String::new(), |near| format!("did you mean `{near}`? "));
                self.no(&format!("there is no `{name}` here: {near}{names_here}"))
            }
        }
    }
}

/// The answer to a word that is no command.
fn unknown(word: &str) -> String {
    let names = || COMMANDS.iter().flat_map(|command| command.names.iter().copied());
    let near = nearest(word, names()).map_or(String::new(), |near| format!("did you mean `{near}`? "));
    let forms = COMMANDS.iter().filter_map(|command| command.names.last());
    let forms: Vec<&str> = forms.copied().collect();
    format!("`{word}` is no command: {near}{}", forms.join(", "))
}

/// A list of two columns.
fn list<'a>(rows: impl Iterator<Item = (&'a str, &'a str)>) -> String {
    rows.map(|(left, right)| format!("  {left:<24} {right}\n")).collect()
}
