//! The report's charts: from figures to drawings.

use super::departures::Departures;
use super::forms::Form;
use super::images::{ImageError, Reference, Varied};
use super::maps::{Cell, Map, Place, SIDE};
use super::report::{Report, SceneReport};
use super::surfaces::{ContactCount, GAPS, SCALES, SelfHitCount};
use super::timing::{FormTime, Quartiles};
use super::verdicts::{SetCount, UlpHistogram};
use crate::numbers::{Precision, Stage};
use crate::pictures::charts::{
    Axis, Heading, Histogram, Histograms, Key, Line, Lines, Panel, Panels, Part, Point, Scale, Scatter, ShareRow,
    Shares, histograms, lines, panels, scatter, shares, wrap,
};
use crate::pictures::drawing::{Color, Dash, Drawing, Face, Raster, Text, Words};
use crate::pictures::theme::{Hue, Mark, Method, Theme, Verdict};
use crate::scene::Numerics;
use crate::transport::LeavingPolicy;

/// The subjects, in the order of the report.
pub const SUBJECTS: [&str; 5] = ["triangle", "sphere", "box", "plane", "total reflection"];

/// A chart and the name of its files.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Without ending; words joined by `-`.
    pub file: String,
    /// The chart.
    pub drawing: Drawing,
}

impl Chart {
    fn new(file: impl Into<String>, drawing: Drawing) -> Self {
        Self { file: file.into().replace(' ', "-"), drawing }
    }
}

/// All charts of a report, on the ground of a theme. `machine` names where the times were taken.
pub fn all(report: &Report, machine: &str, theme: &Theme) -> Vec<Chart> {
    let mut charts = vec![
        Chart::new("pareto", pareto(report, Timed::Random, machine, theme)),
        Chart::new("pareto malicious", pareto(report, Timed::Malicious, machine, theme)),
    ];
    for subject in SUBJECTS {
        charts.push(Chart::new(format!("stages {subject}"), stages(report, subject, theme)));
        if subject != "total reflection" {
            charts.push(Chart::new(format!("t errors {subject}"), t_errors(report, subject, theme)));
        }
    }
    for (place, maps) in &report.maps {
        charts.push(Chart::new(format!("map {}", place.name()), map(*place, maps, theme)));
    }
    charts.push(Chart::new("leaving self hits", self_hits(report, theme)));
    charts.push(Chart::new("leaving contact shadows", contact_shadows(report, theme)));
    if let Some(scene) = &report.scene {
        charts.push(Chart::new("scene error", image_errors(scene, true, theme)));
        charts.push(Chart::new("scene error at centers", image_errors(scene, false, theme)));
        charts.push(Chart::new("scene stages", stage_heat(scene, theme)));
        charts.push(Chart::new("scene departures", departures(scene, theme)));
    }
    charts
}

fn method(form: Form) -> Method {
    match form {
        Form::Lecture => Method::Lecture,
        Form::MollerTrumbore => Method::MollerTrumbore,
        Form::Watertight => Method::Watertight,
        Form::Stable | Form::ExplicitZero => Method::Stable,
        Form::Certified => Method::Certified,
        Form::Exact => Method::Exact,
    }
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0), |(sum, count), x| (sum + x, count + 1));
    if count > 0 { sum / f64::from(count) } else { 0.0 }
}

/// Which sets a Pareto chart takes its times from.
#[derive(Clone, Copy)]
enum Timed {
    /// The first, which is what pictures are made of.
    Random,
    /// All the others.
    Malicious,
}

/// Wrong verdicts against time, one chart a subject, side by side.
fn pareto(report: &Report, timed: Timed, machine: &str, theme: &Theme) -> Drawing {
    let charts: Vec<Drawing> = SUBJECTS.iter().map(|subject| pareto_of(report, subject, timed, theme)).collect();
    let title = match timed {
        Timed::Random => "What accuracy costs in time",
        Timed::Malicious => "What accuracy costs where every ray is malicious",
    };
    let times = match timed {
        Timed::Random => "times: on random ones, which pictures are made of",
        Timed::Malicious => "times: likewise, over all sets but the random one",
    };
    let note = format!(
        "Wrong verdicts: mean over all sets, most of them aimed at edges, tangents and corners; {times}. Below and to the \
         left is better; nothing beats what lies on the dashed line. {machine}"
    );
    grid(title, &note, &charts, 2, theme)
}

fn pareto_of(report: &Report, subject: &str, timed: Timed, theme: &Theme) -> Drawing {
    let first_set = report.times.iter().find(|t| t.subject == subject).map(|t| t.set);
    let mut points = Vec::new();
    for precision in [Precision::F32, Precision::F64] {
        let Some(first) = report.counts_of(subject, precision).next() else { continue };
        for form in first.forms.iter().map(|f| f.form) {
            let of_form = |c: &SetCount| c.forms.iter().find(|f| f.form == form).map(|f| c.wrong_per_million(f));
            let is_it = |t: &&FormTime| {
                let is_first = Some(t.set) == first_set;
                let is_in = matches!(timed, Timed::Random) == is_first;
                is_in && t.subject == subject && t.precision == precision && t.form == form
            };
            let times =
                |pick: fn(&Quartiles) -> f64| mean(report.times.iter().filter(is_it).map(|t| pick(&t.nanoseconds)));
            let (color, mark) = theme.method(method(form));
            points.push(Point {
                name: format!("{} {precision}", form.name()),
                color: if precision == Precision::F32 { color.mix(theme.background, 0.3) } else { color },
                mark,
                x: times(|q| q.median),
                y: mean(report.counts_of(subject, precision).filter_map(of_form)),
                x_spread: Some((times(|q| q.lower), times(|q| q.upper))),
                y_spread: None,
            });
        }
    }
    let values = |pick: fn(&Point) -> f64| points.iter().map(pick).collect::<Vec<_>>();
    let chart = Scatter {
        heading: Heading { title: capitalised(subject), note: String::new() },
        x: Axis { title: "nanoseconds a test".into(), scale: Scale::log_around(values(|p| p.x)) },
        y: Axis { title: "wrong verdicts in a million".into(), scale: Scale::linear_from_zero(values(|p| p.y)) },
        front: Some(String::new()),
        points,
    };
    scatter(&chart, theme)
}

/// Drawings side by side under one heading.
fn grid(title: &str, note: &str, drawings: &[Drawing], columns: usize, theme: &Theme) -> Drawing {
    let (mut width, mut heights) = (0.0_f64, Vec::new());
    for row in drawings.chunks(columns) {
        width = width.max(row.iter().map(|d| d.canvas().max.x).sum());
        heights.push(row.iter().map(|d| d.canvas().max.y).fold(0.0, f64::max));
    }
    let small = Text::new(13.0, theme.muted);
    let note_lines = wrap(note, &small, width - 48.0);
    let top = 52.0 + 18.0 * note_lines.len() as f64;
    let mut whole = Drawing::new(width, top + heights.iter().sum::<f64>(), theme.background, title);
    whole.describe(format!("{note} {}", drawings.iter().map(|d| d.description()).collect::<Vec<_>>().join(" ")));
    whole.text((24.0, 32.0), title, Text::new(20.0, theme.ink).face(Face::Bold));
    for (i, line) in note_lines.iter().enumerate() {
        whole.text((24.0, 54.0 + 18.0 * i as f64), line.as_str(), small);
    }
    let mut y = top;
    for (row, height) in drawings.chunks(columns).zip(heights) {
        let mut x = 0.0;
        for drawing in row {
            whole.place(drawing, glam::DVec2::new(x, y), 1.0);
            x += drawing.canvas().max.x;
        }
        y += height;
    }
    whole
}

fn stage_parts(theme: &Theme) -> Vec<Part> {
    let stages = [
        (Stage::Filter, "filter"),
        (Stage::Integer, "integers"),
        (Stage::DoubleDouble, "double-double"),
        (Stage::Expansion, "expansions"),
    ];
    stages.map(|(stage, name)| Part { name: name.into(), color: theme.stage(stage) }).into()
}

fn stages(report: &Report, subject: &str, theme: &Theme) -> Drawing {
    let rows = [Precision::F64, Precision::F32].into_iter().flat_map(|precision| {
        report.counts_of(subject, precision).map(move |count| ShareRow {
            name: format!("{}, {precision}", count.set),
            shares: count.stages.map(|n| n as f64 / count.cases as f64).into(),
        })
    });
    let chart = Shares {
        heading: Heading {
            title: format!("{subject}: which stage decides"),
            note: "Share of the verdicts that each stage of the certified form decided, by set and by the precision of the \
                   numbers."
                .into(),
        },
        parts: stage_parts(theme),
        rows: rows.collect(),
    };
    shares(&chart, theme)
}

fn t_errors(report: &Report, subject: &str, theme: &Theme) -> Drawing {
    let mut series = Vec::new();
    for precision in [Precision::F32, Precision::F64] {
        let Some(first) = report.counts_of(subject, precision).next() else { continue };
        for form in first.forms.iter().map(|f| f.form).filter(|form| *form != Form::Exact) {
            let mut sum = UlpHistogram::default();
            for count in report.counts_of(subject, precision) {
                for one in count.forms.iter().filter(|f| f.form == form) {
                    sum.0.iter_mut().zip(one.t_errors.0).for_each(|(sum, n)| *sum += n);
                }
            }
            let exact_to_half = 100.0 * sum.0[0] as f64 / sum.total().max(1) as f64;
            series.push(Histogram {
                name: format!("{} {precision}", form.name()),
                note: format!("{exact_to_half:.0} % within half a unit"),
                color: theme.method(method(form)).0,
                counts: sum.0.iter().map(|&n| n as u64).collect(),
            });
        }
    }
    let bin = |bin: usize| match bin {
        0 => Words::from("\u{bd}"),
        b if b == UlpHistogram::BINS - 1 => Words::from("more"),
        b if b < 5 => Words::from(format!("{}", UlpHistogram::end(b)).as_str()),
        b => Words::from("2").raised(&format!("{}", b - 1)),
    };
    let chart = Histograms {
        heading: Heading {
            title: format!("{subject}: the error of t"),
            note: "Units in the last place of the precision, against rational arithmetic, over all sets. The certified form \
                   gives t in f64, and promises no more of it than its bound."
                .into(),
        },
        bins_title: "error up to, in ulp".into(),
        bins: (0..UlpHistogram::BINS).map(bin).collect(),
        counts_title: "hits".into(),
        columns: series.len().div_ceil(2).max(1),
        series,
    };
    histograms(&chart, theme)
}

/// One place's maps, a row a precision.
pub fn map(place: Place, maps: &[Map], theme: &Theme) -> Drawing {
    let columns = maps.iter().filter(|m| m.precision == Precision::F32).count();
    let columns = if columns == 0 { maps.len() } else { columns };
    map_panels(place, maps, columns, theme)
}

/// Some maps of one place, so many side by side.
pub fn map_panels(place: Place, maps: &[Map], columns: usize, theme: &Theme) -> Drawing {
    let color = |cell: Cell| cell_color(cell, theme);
    let panel = |map: &Map| Panel {
        caption: format!("{} {}", map.form.name(), map.precision),
        note: match map.wrong() {
            0 => "all right".into(),
            wrong => format!("{wrong} wrong"),
        },
        raster: Raster::from_fn(SIDE as u32, SIDE as u32, |x, y| color(map.cells[y as usize * SIDE + x as usize])),
    };
    let seen = |cell: Cell| maps.iter().any(|m| m.cells.contains(&cell));
    let (none, leak) = match place {
        Place::CriticalAngle => ("total reflection", "total reflection where light should pass"),
        Place::SharedEdge | Place::Vertex => ("nothing hit", "nothing hit: a leak"),
        Place::Tangent | Place::SlabCorner => ("miss", "miss where there is a hit"),
    };
    let other = if place == Place::Vertex { "its neighbour" } else { "the other one" };
    let (hit, double) = match place {
        Place::CriticalAngle => ("light passes", "light passes where it should not"),
        Place::SharedEdge => ("one triangle", "both hit, where one should be"),
        Place::Vertex => ("one of the six triangles", "one triangle too many"),
        Place::Tangent | Place::SlabCorner => ("hit", "hit where there is none"),
    };
    let meanings = [
        (Cell::Miss, none),
        (Cell::Hit(0), hit),
        (Cell::Hit(1), other),
        (Cell::Hit(u8::MAX), "several, as it should be"),
        (Cell::FalseMiss, leak),
        (Cell::FalseHit, double),
        (Cell::Swapped, "another triangle than it should be"),
    ];
    let key = meanings.into_iter().filter(|(cell, _)| seen(*cell));
    let chart = Panels {
        heading: Heading {
            title: format!("{}: {SIDE} x {SIDE} verdicts, one unit in the last place apart", capitalised(place.name())),
            note: format!("{}. What is right was decided exactly.", capitalised(place.about())),
        },
        panels: maps.iter().map(panel).collect(),
        columns,
        factor: 1,
        key: key.map(|(cell, meaning)| Key { color: color(cell), meaning: meaning.into() }).collect(),
        ramp: None,
    };
    panels(&chart, theme)
}

fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

fn cell_color(cell: Cell, theme: &Theme) -> Color {
    let quiet = |hue| theme.hue(hue).mix(theme.background, 0.72);
    match cell {
        Cell::Miss => theme.grid,
        Cell::Hit(u8::MAX) => theme.hue(Hue::Sky),
        Cell::Hit(i) => [quiet(Hue::Sky), quiet(Hue::Green)][usize::from(i % 2)],
        Cell::FalseMiss => theme.verdict(Verdict::FalseMiss),
        Cell::FalseHit => theme.verdict(Verdict::FalseHit),
        Cell::Swapped => theme.hue(Hue::Amber),
    }
}

/// Error against time; from the reference with many samples a pixel or, to see the smaller effects, with one.
fn image_errors(scene: &SceneReport, many_samples: bool, theme: &Theme) -> Drawing {
    let of = |varied: Varied| {
        let is_it = move |(error, _): &&(ImageError, Quartiles)| error.variant.varied == varied;
        scene.images.iter().filter(is_it)
    };
    let styles = [
        (Varied::Kernels, Hue::Blue, Dash::Dotted, Mark::Disk),
        (Varied::Depth, Hue::Vermilion, Dash::Solid, Mark::Square),
        (Varied::MinWeight, Hue::Green, Dash::Dashed, Mark::Triangle),
        (Varied::Samples, Hue::Purple, Dash::DashDot, Mark::Diamond),
    ];
    let line = |(varied, hue, dash, mark)| {
        let mut points: Vec<(f64, f64)> = {
            let error = |e: &ImageError| if many_samples { e.rmse } else { e.rmse_at_centers };
            of(varied).map(|(e, time)| (time.median, error(e))).collect()
        };
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Line { name: varied.name().to_owned(), color: theme.hue(hue), dash, mark, points }
    };
    let is_shown = |varied: Varied| many_samples || varied != Varied::Samples;
    let shown = styles.into_iter().filter(|style| is_shown(style.0)).map(line);
    let lines_of: Vec<Line> = shown.filter(|line| !line.points.is_empty()).collect();
    let all = || lines_of.iter().flat_map(|line| line.points.iter().copied());
    let Reference { samples, max_depth } = scene.reference;
    let (title, sampled) = match many_samples {
        true => ("Error of the image against time", format!("{samples} x {samples} samples a pixel")),
        false => ("The same without the error of sampling", "one sample a pixel".into()),
    };
    let chart = Lines {
        heading: Heading {
            title: title.into(),
            note: format!(
                "{} at {} x {}. Error: root mean square in linear RGB against certified f64 at depth {max_depth} with \
                 {sampled}. Time: over that of the same with one sample.",
                scene.file, scene.size.width, scene.size.height
            ),
        },
        x: Axis {
            title: "time over the reference's at one sample".into(),
            scale: Scale::log_around(all().map(|p| p.0)),
        },
        y: Axis { title: "root mean square error".into(), scale: Scale::log_around(all().map(|p| p.1)) },
        lines: lines_of,
    };
    lines(&chart, theme)
}

fn stage_heat(scene: &SceneReport, theme: &Theme) -> Drawing {
    let width = scene.size.width;
    let raster = Raster::from_fn(width, scene.size.height, |x, y| theme.stage(scene.stages[(y * width + x) as usize]));
    let beyond = scene.stages.iter().filter(|stage| **stage != Stage::Filter).count();
    let chart = Panels {
        heading: Heading {
            title: "The stage that decided".into(),
            note: format!(
                "{}: the dearest stage that any hit in a pixel's tree called for. The filter alone decided all but {beyond} of \
                 {} pixels.",
                scene.file,
                scene.stages.len()
            ),
        },
        panels: vec![Panel { caption: "certified f64".into(), note: String::new(), raster }],
        columns: 1,
        factor: (512 / width).max(1),
        key: stage_parts(theme).into_iter().map(|part| Key { color: part.color, meaning: part.name }).collect(),
        ramp: None,
    };
    panels(&chart, theme)
}

/// The lines of the policies: one a policy and precision, of points that `points` yields for it.
fn by_policy(theme: &Theme, points: impl Fn(Numerics, Precision) -> Vec<(f64, f64)>) -> Vec<Line> {
    let manners = [
        (Numerics::Lecture, "epsilon", Hue::Vermilion, Mark::Square),
        (Numerics::Robust, "error bound", Hue::Amber, Mark::Triangle),
        (Numerics::Certified, "provenance", Hue::Blue, Mark::Disk),
    ];
    let precisions = [(Precision::F32, Dash::Dashed), (Precision::F64, Dash::Solid)];
    let line = |(numerics, name, hue, mark), (precision, dash)| Line {
        name: format!("{name} {precision}"),
        color: theme.hue(hue),
        dash,
        mark,
        points: points(numerics, precision),
    };
    manners.into_iter().flat_map(|manner| precisions.map(|precision| line(manner, precision))).collect()
}

fn self_hits(report: &Report, theme: &Theme) -> Drawing {
    let share = |numerics, precision, scale| {
        let is_it = |s: &&SelfHitCount| s.numerics == numerics && s.precision == precision && s.scale == scale;
        let (hits, rays) =
            report.surfaces.self_hits.iter().filter(is_it).fold((0, 0), |(h, r), s| (h + s.hits, r + s.rays));
        100.0 * hits as f64 / rays.max(1) as f64
    };
    let lines_of = by_policy(theme, |numerics, precision| {
        SCALES.iter().map(|&scale| (scale, share(numerics, precision, scale))).collect()
    });
    let all = || lines_of.iter().flat_map(|line| line.points.iter().copied());
    let chart = Lines {
        heading: Heading {
            title: "Rays that hit the surface they left".into(),
            note: "Planes, spheres, triangles and boxes in any position, that far from the world's origin. The lecture's \
                   kernels with an epsilon of 1e-4, the robust ones with an offset by an error bound, the certified ones \
                   by provenance."
                .into(),
        },
        x: Axis { title: "distance from the world's origin".into(), scale: Scale::log_around(SCALES) },
        y: Axis { title: "per cent".into(), scale: Scale::log_around(all().map(|p| p.1)) },
        lines: lines_of,
    };
    lines(&chart, theme)
}

fn contact_shadows(report: &Report, theme: &Theme) -> Drawing {
    let lines_of = by_policy(theme, |numerics, precision| {
        let is_it = |c: &&ContactCount| c.numerics == numerics && c.precision == precision && c.height == 1.0;
        let counted = report.surfaces.contacts.iter().filter(is_it).filter(|c| c.rays > 0);
        counted.map(|c| (c.gap, 100.0 * c.lost as f64 / c.rays as f64)).collect()
    });
    let chart = Lines {
        heading: Heading {
            title: "Contact shadows that are lost".into(),
            note: "Rays from a floor at height 1 to a light, past a card that lies that far above the floor and covers it: all \
                   of them are in its shadow. f32 has no number for the smaller gaps."
                .into(),
        },
        x: Axis { title: "gap between floor and card".into(), scale: Scale::log_around(GAPS) },
        y: Axis { title: "per cent".into(), scale: Scale::Linear(0.0, 108.0) },
        lines: lines_of,
    };
    lines(&chart, theme)
}

fn departures(scene: &SceneReport, theme: &Theme) -> Drawing {
    let per_million = |count: usize, of: &Departures| count as f64 * 1e6 / of.rays.max(1) as f64;
    let mut lines_of = Vec::new();
    for (precision, dash) in [(Precision::F32, Dash::Dashed), (Precision::F64, Dash::Solid)] {
        let sweep = || scene.departures.iter().filter(move |d| d.precision == precision);
        let points = |count: fn(&Departures) -> usize| -> Vec<(f64, f64)> {
            let point = |d: &Departures| match d.leaving {
                LeavingPolicy::FixedEpsilon(epsilon) => Some((epsilon, per_million(count(d), d))),
                _ => None,
            };
            sweep().filter_map(point).collect()
        };
        if sweep().next().is_none() {
            continue;
        }
        let line = |name: &str, hue, mark, points| Line {
            name: format!("{name}, {precision}"),
            color: theme.hue(hue),
            dash,
            mark,
            points,
        };
        lines_of.push(line("hits its own surface", Hue::Vermilion, Mark::Square, points(|d| d.self_hits)));
        lines_of.push(line("misses what is near", Hue::Blue, Mark::Disk, points(|d| d.lost)));
    }
    let rest = scene.departures.iter().filter(|d| !matches!(d.leaving, LeavingPolicy::FixedEpsilon(_)));
    let rest: Vec<String> = rest
        .map(|d| {
            let name = if d.leaving == LeavingPolicy::ErrorBound { "error bound" } else { "provenance" };
            format!("{name} {}: {} and {}", d.precision, d.self_hits, d.lost)
        })
        .collect();
    let all = || lines_of.iter().flat_map(|line| line.points.iter().copied());
    let chart = Lines {
        heading: Heading {
            title: "What an epsilon does to the rays that leave a surface".into(),
            note: format!(
                "{}: shadow and secondary rays from the surfaces seen, beside the same rays by provenance. Without an \
                 epsilon, own surface hit and near things missed: {}.",
                scene.file,
                rest.join("; ")
            ),
        },
        x: Axis { title: "epsilon".into(), scale: Scale::log_around(all().map(|p| p.0)) },
        y: Axis { title: "rays in a million".into(), scale: Scale::log_around(all().map(|p| p.1)) },
        lines: lines_of,
    };
    lines(&chart, theme)
}
