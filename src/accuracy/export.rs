//! The report's figures as CSV and JSON. The counts are the same bytes for the same seed and plan on every machine; the
//! times stand in files of their own.

use serde::Serialize;

use super::departures::Departures;
use super::images::{ImageError, Reference};
use super::maps::{Map, Place};
use super::report::{Plan, Report, SceneReport};
use super::surfaces::Surfaces;
use super::timing::{FormTime, Quartiles};
use super::verdicts::{SetCount, UlpHistogram};
use crate::numbers::{Precision, Stage};
use crate::transport::LeavingPolicy;

/// A table: its name, its columns, its rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// The file's name without ending.
    pub file: &'static str,
    /// What it shows.
    pub title: &'static str,
    /// The columns' names.
    pub columns: Vec<String>,
    /// The rows; numbers as the shortest decimals that read back to the same bits.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    fn new(file: &'static str, title: &'static str, columns: &[&str]) -> Self {
        Self { file, title, columns: columns.iter().map(|c| (*c).to_owned()).collect(), rows: Vec::new() }
    }

    /// As comma-separated values (RFC 4180).
    pub fn to_csv(&self) -> String {
        let field = |text: &String| match text.contains([',', '"', '\n']) {
            true => format!("\"{}\"", text.replace('"', "\"\"")),
            false => text.clone(),
        };
        let line = |row: &Vec<String>| row.iter().map(field).collect::<Vec<_>>().join(",");
        std::iter::once(&self.columns).chain(&self.rows).map(|row| line(row) + "\n").collect()
    }
}

/// The tables of a report.
pub fn tables(report: &Report) -> Vec<Table> {
    let mut tables = vec![verdicts(report), t_errors(report), times(report), maps(report)];
    tables.extend([leaks(report), self_hits(report), contacts(report), cubes(report)]);
    if let Some(scene) = &report.scene {
        tables.extend([images(scene), image_times(scene), departures(scene)]);
    }
    tables
}

fn verdicts(report: &Report) -> Table {
    let columns = [
        "subject",
        "set",
        "precision",
        "cases",
        "refereed",
        "hits",
        "filter",
        "integer",
        "double_double",
        "expansion",
        "form",
        "false_hits",
        "false_misses",
        "wrong_per_million",
    ];
    let mut table = Table::new("verdicts", "Wrong verdicts, and the stages of the certified form", &columns);
    for c in &report.counts {
        for f in &c.forms {
            let mut row = vec![c.subject.to_owned(), c.set.to_owned(), c.precision.to_string()];
            row.extend([c.cases, c.refereed, c.hits].map(|n| n.to_string()));
            row.extend(c.stages.map(|n| n.to_string()));
            row.extend([f.form.name().to_owned(), f.false_hits.to_string(), f.false_misses.to_string()]);
            row.push(number(c.wrong_per_million(f)));
            table.rows.push(row);
        }
    }
    table
}

fn t_errors(report: &Report) -> Table {
    let mut table =
        Table::new("t-errors", "The error of t in units in the last place", &["subject", "set", "precision", "form"]);
    table.columns.extend((0..UlpHistogram::BINS - 1).map(|bin| format!("up_to_{}", number(UlpHistogram::end(bin)))));
    table.columns.push("more".into());
    for c in report.counts.iter().filter(|c| c.subject != "total reflection") {
        for f in &c.forms {
            let mut row =
                vec![c.subject.to_owned(), c.set.to_owned(), c.precision.to_string(), f.form.name().to_owned()];
            row.extend(f.t_errors.0.map(|n| n.to_string()));
            table.rows.push(row);
        }
    }
    table
}

fn times(report: &Report) -> Table {
    let columns = ["subject", "set", "precision", "form", "ns_lower_quartile", "ns_median", "ns_upper_quartile"];
    let mut table = Table::new("times", "Nanoseconds a test, medians of interleaved rounds", &columns);
    for t in &report.times {
        let Quartiles { lower, median, upper } = t.nanoseconds;
        let mut row = vec![t.subject.to_owned(), t.set.to_owned(), t.precision.to_string(), t.form.name().to_owned()];
        row.extend([lower, median, upper].map(|ns| format!("{ns:.2}")));
        table.rows.push(row);
    }
    table
}

fn maps(report: &Report) -> Table {
    let mut table =
        Table::new("maps", "Wrong cells of the predicate maps", &["place", "form", "precision", "cells", "wrong"]);
    for (place, maps) in &report.maps {
        for map in maps {
            let counts = [map.cells.len(), map.wrong()].map(|n| n.to_string());
            let mut row = vec![place.name().to_owned(), map.form.name().to_owned(), map.precision.to_string()];
            row.extend(counts);
            table.rows.push(row);
        }
    }
    table
}

fn leaks(report: &Report) -> Table {
    let mut table = Table::new(
        "leaks",
        "Rays that find nothing where there is no way past",
        &["numerics", "precision", "what", "rays", "leaked"],
    );
    for l in &report.surfaces.leaks {
        let counts = [l.rays, l.leaked].map(|n| n.to_string());
        table
            .rows
            .push([[l.numerics.to_string(), l.precision.to_string(), l.what.clone()].as_slice(), &counts].concat());
    }
    table
}

/// The policy in a word, with its epsilon.
pub(super) fn policy(leaving: LeavingPolicy) -> String {
    match leaving {
        LeavingPolicy::FixedEpsilon(epsilon) => format!("epsilon {epsilon:e}"),
        LeavingPolicy::ErrorBound => "error bound".into(),
        LeavingPolicy::Provenance => "provenance".into(),
    }
}

fn self_hits(report: &Report) -> Table {
    let columns = ["numerics", "precision", "leaving", "ground", "scale", "rays", "self_hits"];
    let mut table = Table::new("self-hits", "Rays that hit the surface they left", &columns);
    for s in &report.surfaces.self_hits {
        let mut row = vec![s.numerics.to_string(), s.precision.to_string(), policy(s.leaving), s.ground.to_owned()];
        row.extend([number(s.scale), s.rays.to_string(), s.hits.to_string()]);
        table.rows.push(row);
    }
    table
}

fn contacts(report: &Report) -> Table {
    let columns = ["numerics", "precision", "leaving", "height", "gap", "rays", "lost"];
    let mut table = Table::new("contact-shadows", "Rays to the light that miss what is very near", &columns);
    for c in &report.surfaces.contacts {
        let mut row = vec![c.numerics.to_string(), c.precision.to_string(), policy(c.leaving)];
        row.extend([number(c.height), format!("{:e}", c.gap)]);
        row.extend([c.rays, c.lost].map(|n| n.to_string()));
        table.rows.push(row);
    }
    table
}

fn cubes(report: &Report) -> Table {
    let columns = ["numerics", "precision", "leaving", "rays", "bounces", "escaped"];
    let mut table = Table::new("mirrored-cube", "Rays that get out of a closed box of mirrors", &columns);
    for c in &report.surfaces.cubes {
        let mut row = vec![c.numerics.to_string(), c.precision.to_string(), policy(c.leaving)];
        row.extend([c.rays, c.bounces, c.escaped].map(|n| n.to_string()));
        table.rows.push(row);
    }
    table
}

fn images(scene: &SceneReport) -> Table {
    let columns = ["varied", "variant", "rmse", "rmse_at_centers", "worst_x", "worst_y", "worst", "other_tree_shape"];
    let mut table = Table::new("images", "The scene against the reference", &columns);
    for (e, _) in &scene.images {
        let [x, y] = e.worst_pixel;
        let mut row =
            vec![e.variant.varied.name().to_owned(), e.variant.name(), number(e.rmse), number(e.rmse_at_centers)];
        row.extend([x.to_string(), y.to_string(), number(e.worst), e.other_shape.map(number).unwrap_or_default()]);
        table.rows.push(row);
    }
    table
}

fn image_times(scene: &SceneReport) -> Table {
    let columns = ["varied", "variant", "lower_quartile", "median", "upper_quartile"];
    let mut table = Table::new("image-times", "Time over that of the reference with one sample a pixel", &columns);
    for (e, Quartiles { lower, median, upper }) in &scene.images {
        let mut row = vec![e.variant.varied.name().to_owned(), e.variant.name()];
        row.extend([lower, median, upper].map(|x| format!("{x:.3}")));
        table.rows.push(row);
    }
    table
}

fn departures(scene: &SceneReport) -> Table {
    let columns = ["leaving", "epsilon", "precision", "rays", "self_hits", "lost"];
    let mut table = Table::new("departures", "How rays leave the surfaces that are seen", &columns);
    for d in &scene.departures {
        let (name, epsilon) = match d.leaving {
            LeavingPolicy::FixedEpsilon(epsilon) => ("fixed_epsilon", format!("{epsilon:e}")),
            LeavingPolicy::ErrorBound => ("error_bound", String::new()),
            LeavingPolicy::Provenance => ("provenance", String::new()),
        };
        let mut row = vec![name.to_owned(), epsilon, d.precision.to_string()];
        row.extend([d.rays, d.self_hits, d.lost].map(|n| n.to_string()));
        table.rows.push(row);
    }
    table
}

/// The shortest decimals that read back to the same bits.
fn number(x: f64) -> String {
    format!("{x}")
}

/// All figures as one JSON document.
pub fn to_json(report: &Report, machine: &str) -> String {
    #[derive(Serialize)]
    struct All<'a> {
        format: &'a str,
        machine: &'a str,
        plan: &'a Plan,
        verdicts: &'a [SetCount],
        times: &'a [FormTime],
        maps: Vec<MapCount>,
        surfaces: &'a Surfaces,
        #[serde(skip_serializing_if = "Option::is_none")]
        scene: Option<SceneFigures<'a>>,
    }
    #[derive(Serialize)]
    struct MapCount {
        place: Place,
        form: super::forms::Form,
        precision: Precision,
        cells: usize,
        wrong: usize,
    }
    #[derive(Serialize)]
    struct SceneFigures<'a> {
        file: &'a str,
        size: [u32; 2],
        reference: Reference,
        images: Vec<ImageFigures<'a>>,
        pixels_by_dearest_stage: [usize; 4],
        departures: &'a [Departures],
    }
    #[derive(Serialize)]
    struct ImageFigures<'a> {
        #[serde(flatten)]
        error: &'a ImageError,
        time_over_reference: Quartiles,
    }
    let count = |place: &Place, map: &Map| MapCount {
        place: *place,
        form: map.form,
        precision: map.precision,
        cells: map.cells.len(),
        wrong: map.wrong(),
    };
    let scene = report.scene.as_ref().map(|scene| SceneFigures {
        file: &scene.file,
        size: [scene.size.width, scene.size.height],
        reference: scene.reference,
        images: scene.images.iter().map(|(error, time)| ImageFigures { error, time_over_reference: *time }).collect(),
        pixels_by_dearest_stage: Stage::ALL.map(|stage| scene.stages.iter().filter(|s| **s == stage).count()),
        departures: &scene.departures,
    });
    let all = All {
        format: "raytree-accuracy/1",
        machine,
        plan: &report.plan,
        verdicts: &report.counts,
        times: &report.times,
        maps: report.maps.iter().flat_map(|(place, maps)| maps.iter().map(move |map| count(place, map))).collect(),
        surfaces: &report.surfaces,
        scene,
    };
    // Plain structs of numbers and words: nothing in them fails to be JSON.
    serde_json::to_string_pretty(&all).unwrap_or_default() + "\n"
}
