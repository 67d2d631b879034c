//! `raytree effects`: what a scene calls for, and who asked.

use std::fmt::Write;

use super::failure::Failure;
use super::files;
use super::output::Target;
use crate::input::printable;
use crate::scene::effects::{Asker, Effect, census};

/// Lists the effects that a scene calls for, and which object asked for each
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  raytree effects scenes/whitted.json")]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<String>,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let target = Target::new(args.output.as_deref(), &[&args.scene])?;
    let loaded = files::load_scene(&args.scene)?;
    let census = census(&loaded.scene);
    let askers = |askers: &[Asker]| -> Vec<String> {
        let name = |asker: &Asker| match asker {
            Asker::Object(id) => loaded.scene.object(*id).name.clone(),
            Asker::Scene => "the scene".to_owned(),
        };
        askers.iter().map(name).collect()
    };
    let off = Effect::ALL.iter().filter(|effect| !census.iter().any(|(on, _)| on == *effect)).map(|e| e.name());
    let text = if args.json {
        let on: Vec<_> = census
            .iter()
            .map(|(effect, who)| serde_json::json!({ "effect": effect.name(), "asked_by": askers(who) }))
            .collect();
        format!("{:#}\n", serde_json::json!({ "on": on, "off": off.collect::<Vec<_>>() }))
    } else {
        let mut text = String::new();
        for (effect, who) in &census {
            let names = askers(who).iter().map(|name| format!("\"{}\"", printable(name))).collect::<Vec<_>>();
            writeln!(text, "{effect:<15} asked by {}", names.join(", ")).ok();
        }
        let off: Vec<_> = off.collect();
        let off = if off.is_empty() { "nothing".to_owned() } else { off.join(", ") };
        writeln!(text, "{:<15} {off}", "not called for").ok();
        text
    };
    target.write_all(text.as_bytes())
}
