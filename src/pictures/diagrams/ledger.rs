//! The ledger as a waterfall: each term of each ray starts where the one before it ended, and the last ends at the pixel.

use glam::DVec2;

use super::frame::{self, SMALL, elided};
use super::numbers::shown;
use super::{Input, Kind, NotApplicable};
use crate::input::printable;
use crate::pictures::charts::{Axis, Scale};
use crate::pictures::drawing::{Align, Dash, Drawing, Face, Level, Path, Pen, Rect, Text};
use crate::pictures::theme::Theme;
use crate::tree::{Entry, Ledger};

/// The height of a row, and the widths of the columns beside the bars.
const ROW: f64 = 24.0;
const NAMES: f64 = 230.0;
const VALUES: f64 = 213.0;
/// The height of what stands above and below the rows.
const HEAD: f64 = 18.0;
const FOOT: f64 = 22.0;
/// Terms below this share of the pixel's luminance are summed, if there are several.
const SMALL_SHARE: f64 = 0.002;
/// Even a single term below this share says nothing.
const NO_SHARE: f64 = 1e-6;

/// A row of the waterfall.
struct Row {
    /// What the term is, and which ray has it.
    words: [String; 2],
    share: [f64; 3],
}

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let ledger = Ledger::of(input.tree);
    if ledger.entries.is_empty() {
        let why = "no ray of this tree brought any light".to_owned();
        return Err(NotApplicable { kind: Kind::Ledger, why });
    }
    let title = input.title("The parts of the colour");
    let note = "Each term of each ray times the weight of the ray, in linear light. Bars show luminance.";
    let head = frame::begin(input.size, &title, note, theme).1;
    let most = ((head.size().y - HEAD - FOOT) / ROW).floor().clamp(3.0, 40.0) as usize - 1;
    let rows = rows(input, &ledger, most);
    let height = head.min.y + HEAD + ROW * (rows.len() + 1) as f64 + FOOT + frame::MARGIN;
    let (mut drawing, room) = frame::begin(DVec2::new(input.size.x, height), &title, note, theme);
    let sum = |rgb: [f64; 3]| shown(luminance(rgb));
    drawing.describe(format!("{} terms add up to the pixel's luminance {}.", rows.len(), sum(ledger.color)));

    let room = Rect { min: room.min + DVec2::new(0.0, HEAD), ..room };
    let is_narrow = room.size().x < 640.0;
    let (names, values) = if is_narrow { (206.0, 183.0) } else { (NAMES, VALUES) };
    let area = Rect {
        min: DVec2::new(room.min.x + names, room.min.y),
        max: DVec2::new(room.max.x - values, room.min.y + ROW * (rows.len() + 1) as f64),
    };
    let total = luminance(ledger.color);
    axis(&mut drawing, area, total, theme);
    let x = |light: f64| area.min.x + area.size().x * (light / top(total)).clamp(0.0, 1.0);
    let digits = Text::new(if is_narrow { 10.5 } else { SMALL }, theme.muted);
    let digits = digits.face(Face::Mono).anchor(Align::End, Level::Middle);
    let column = values / 3.0;
    for (i, word) in ["red", "green", "blue"].into_iter().enumerate() {
        let right = room.max.x - column * (2 - i) as f64;
        drawing.text(
            (right, room.min.y - 6.0),
            word,
            Text::new(SMALL, theme.muted).anchor(Align::End, Level::Baseline),
        );
    }
    let head = Text::new(SMALL, theme.muted).anchor(Align::End, Level::Baseline);
    drawing.text((area.min.x - 9.0, room.min.y - 6.0), "ray", head);
    let name = Text::new(SMALL, theme.ink).anchor(Align::Start, Level::Middle);
    let mut before = 0.0;
    let last = Row { words: ["the pixel".to_owned(), String::new()], share: ledger.color };
    for (i, row) in rows.iter().chain([&last]).enumerate() {
        let y = area.min.y + ROW * (i as f64 + 0.5);
        let is_sum = i == rows.len();
        if is_sum {
            let line = Pen::new(theme.axis, 1.0);
            drawing.line((room.min.x, y - ROW / 2.0), (room.max.x, y - ROW / 2.0), line);
        }
        let square = Rect::new((room.min.x, y - 7.0), (14.0, 14.0));
        frame::swatch(&mut drawing, square, row.share, theme);
        let face = if is_sum { name.face(Face::Bold) } else { name };
        let (ray, room_left) = (name.color(theme.muted), names - 30.0);
        let aside = ray.width(&row.words[1]).min(0.5 * room_left);
        let term = elided(&row.words[0], &face, room_left - aside - 8.0);
        drawing.text((room.min.x + 21.0, y), term.as_str(), face);
        let aside = elided(&row.words[1], &ray, room_left - face.width(term.as_str()) - 8.0);
        drawing.text((area.min.x - 9.0, y), aside, ray.anchor(Align::End, Level::Middle));

        let (from, to) = if is_sum { (0.0, total) } else { (before, before + luminance(row.share)) };
        let bar = Rect { min: DVec2::new(x(from), y - 7.0), max: DVec2::new(x(to).max(x(from) + 1.0), y + 7.0) };
        frame::swatch(&mut drawing, bar, row.share, theme);
        if !is_sum {
            let link = Pen::new(theme.axis, 1.0).dashed(Dash::Short);
            drawing.line((x(to), y + 8.0), (x(to), y + ROW - 8.0), link);
        }
        before = to;
        for k in 0..3 {
            let right = room.max.x - column * (2 - k) as f64;
            let color = if is_sum { theme.ink } else { theme.muted };
            drawing.text((right, y), shown(row.share[k]), digits.color(color));
        }
    }
    Ok(drawing)
}

/// The luminance of linear light with the primaries of sRGB. Source: IEC 61966-2-1.
fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Where the axis ends.
fn top(total: f64) -> f64 {
    if total > 0.0 && total.is_finite() { 1.04 * total } else { 1.0 }
}

/// The terms in the order in which the rays were traced, at most `most` of them: of more the smallest are summed.
fn rows(input: &Input<'_>, ledger: &Ledger, most: usize) -> Vec<Row> {
    let mut order: Vec<usize> = (0..ledger.entries.len()).collect();
    order.sort_by(|&a, &b| {
        luminance(ledger.entries[b].share).total_cmp(&luminance(ledger.entries[a].share)).then(a.cmp(&b))
    });
    let above = |share: f64| {
        let least = share * luminance(ledger.color);
        order.iter().filter(|&&i| luminance(ledger.entries[i].share) >= least).count()
    };
    let kept = if order.len() - above(SMALL_SHARE) > 1 { above(SMALL_SHARE) } else { above(NO_SHARE) };
    let kept = if kept <= most { kept } else { most - 1 };
    let rest = order.split_off(kept);
    order.sort_unstable();
    let paths: Vec<String> = input.tree.nodes().iter().map(|(path, _)| path.to_string()).collect();
    let number = |entry: &Entry| paths.iter().position(|path| *path == entry.path).map_or(0, |i| i + 1);
    let row = |&i: &usize| {
        let entry = &ledger.entries[i];
        let object = entry.object.as_deref().map(printable);
        let term = match object {
            Some(object) => format!("{}, {object}", printable(&entry.term)),
            None => printable(&entry.term).into_owned(),
        };
        Row { words: [term, number(entry).to_string()], share: entry.share }
    };
    let mut rows: Vec<Row> = order.iter().map(row).collect();
    if !rest.is_empty() {
        let mut share = [0.0; 3];
        rest.iter().for_each(|&i| (0..3).for_each(|k| share[k] += ledger.entries[i].share[k]));
        let name = if rest.len() == 1 { "one other".to_owned() } else { format!("the other {}", rest.len()) };
        rows.push(Row { words: [name, String::new()], share });
    }
    rows
}

/// Draws the grid and the numbers of the axis of luminance.
fn axis(drawing: &mut Drawing, area: Rect, total: f64, theme: &Theme) {
    let axis = Axis { title: String::new(), scale: Scale::Linear(0.0, top(total)) };
    let ruler = axis.scale.between(area.min.x, area.max.x);
    let text = Text::new(SMALL, theme.muted).anchor(Align::Middle, Level::Top);
    for tick in ruler.ticks(64.0) {
        drawing.line((tick.at, area.min.y), (tick.at, area.max.y), Pen::new(theme.grid, 1.0));
        if let Some(words) = tick.label {
            drawing.text((tick.at, area.max.y + 8.0), words, text);
        }
    }
    drawing.stroke(Path::line(area.min, DVec2::new(area.min.x, area.max.y)), Pen::new(theme.axis, 1.0));
}
