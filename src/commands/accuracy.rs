//! `raytree accuracy`: what accuracy costs in time.

use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use indicatif::ProgressBar;

use super::failure::Failure;
use super::output::Folder;
use super::picture::Format;
use super::{files, progress};
use crate::accuracy::report::{Plan, Progress, Report};
use crate::accuracy::{charts, export, page};
use crate::input::Problem;
use crate::pictures::theme::Theme;

/// Measures what accuracy costs in time, and writes a report: a page with charts, and the figures as CSV and JSON
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  raytree accuracy scenes/whitted.json -o report
  raytree accuracy --quick -o report

The counts are the same for the same seed on every machine; the times are not. Without a scene the report is on the
kernels alone.")]
pub(super) struct Args {
    /// Scene file, or - for standard input; its image is made smaller where it is large
    scene: Option<String>,
    /// Folder for the report; it is made if it is not there, and files of an earlier report in it are replaced
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// A run of a few seconds
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// Ten million pairs of triangles and of spheres, a million of boxes and of planes, in either precision
    #[arg(long)]
    full: bool,
    /// Where the random numbers start
    #[arg(long, value_name = "N", default_value_t = Plan::USUAL.seed)]
    seed: u64,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let loaded = args.scene.as_deref().map(files::load_scene).transpose()?;
    let folder = Folder::new(&args.output)?;
    folder.folder("charts")?;
    let plan = match (args.quick, args.full) {
        (true, _) => Plan::QUICK,
        (_, true) => Plan::FULL,
        _ => Plan::USUAL,
    };
    let plan = Plan { seed: args.seed, ..plan };
    let bars = Bars::default();
    // One thread: what is timed side by side must not take turns on two.
    let measured = progress::on_threads(Some(1), || {
        progress::stoppable(|stop| match Report::measure(plan, loaded.as_ref(), &bars, stop) {
            Ok(report) => report.map(Ok),
            Err(unfit) => Some(Err(unfit)),
        })
    })??;
    bars.replace(None);
    let report = measured.map_err(|_| {
        let file = args.scene.as_deref().unwrap_or_default();
        Problem::new(file, "the scene does not fit f64", "coordinates up to 2^128 in magnitude")
    })?;
    write(&report, &folder, args)
}

fn write(report: &Report, folder: &Folder, args: &Args) -> Result<(), Failure> {
    let machine = machine();
    let mut names = Vec::new();
    let light = charts::all(report, &machine, &Theme::LIGHT);
    let dark = charts::all(report, &machine, &Theme::DARK);
    let bar = progress::bar("charts", light.len() as u64);
    for (light, dark) in light.into_iter().zip(dark) {
        let (file, picture) = (&light.file, &light.drawing);
        folder.write(&format!("charts/{file}.svg"), &Format::Svg.encode(picture, 1.0)?)?;
        folder.write(&format!("charts/{file}-dark.svg"), &Format::Svg.encode(&dark.drawing, 1.0)?)?;
        folder.write(&format!("charts/{file}.png"), &Format::Png.encode(picture, 2.0)?)?;
        names.push((light.file, format!("{}. {}", light.drawing.title(), light.drawing.description())));
        bar.inc(1);
    }
    bar.finish_and_clear();
    for table in export::tables(report) {
        folder.write(&format!("{}.csv", table.file), table.to_csv().as_bytes())?;
    }
    folder.write("figures.json", export::to_json(report, &machine).as_bytes())?;
    // The page comes last: it is there when all it shows is.
    folder.write("index.html", page::to_html(report, &machine, &command(args), &names).as_bytes())
}

/// How to come by this report.
fn command(args: &Args) -> String {
    let mut words = vec!["raytree accuracy".to_owned()];
    words.extend(args.scene.clone());
    words.extend(args.quick.then(|| "--quick".to_owned()));
    words.extend(args.full.then(|| "--full".to_owned()));
    if args.seed != Plan::USUAL.seed {
        words.push(format!("--seed {}", args.seed));
    }
    words.push("-o DIR".to_owned());
    words.join(" ")
}

/// The processor, as far as the system tells, and what the program was built for.
fn machine() -> String {
    let cpuinfo = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model =
        cpuinfo.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':').map(|(_, m)| m.trim()));
    let build = if cfg!(debug_assertions) { ", debug build" } else { "" };
    format!("{} ({}, {}{build})", model.unwrap_or("a processor"), std::env::consts::ARCH, std::env::consts::OS)
}

/// A bar for each thing that is done, one after the other.
#[derive(Default)]
struct Bars(Mutex<Option<ProgressBar>>);

impl Bars {
    /// Puts another bar, or none, in the place of the present one.
    fn replace(&self, bar: Option<ProgressBar>) {
        if let Some(old) = std::mem::replace(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner), bar) {
            old.finish_and_clear();
        }
    }
}

impl Progress for Bars {
    fn begin(&self, what: &str, steps: u64) {
        self.replace(Some(progress::bar(what, steps)));
    }
    fn step(&self, steps: u64) {
        if let Some(bar) = &*self.0.lock().unwrap_or_else(PoisonError::into_inner) {
            bar.inc(steps);
        }
    }
}
