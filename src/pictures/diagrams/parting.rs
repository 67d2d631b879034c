//! Two ray trees side by side, a line a ray, and where they part.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;

use super::frame::{self, SMALL, elided};
use super::numbers::{shown, shown_vector};
use super::tree::{card_words, light_mark};
use crate::input::printable;
use crate::pictures::drawing::{Align, Color, Drawing, Face, Level, Path, Pen, Rect, Text};
use crate::pictures::theme::{Hue, Theme};
use crate::tree::diff::{Difference, Divergence, Pair, Value, pairs};
use crate::tree::{RayNode, RayTree};

const WIDTH: f64 = 1060.0;
/// Between the two trees, where the marks are.
const GUTTER: f64 = 30.0;
/// A line, and one that says below in what it parts.
const LINE: f64 = 25.0;
const TALL: f64 = 43.0;
/// The step of a child, and the most room that steps take.
const STEP: f64 = 17.0;
const DEEPEST: f64 = 170.0;
/// The most lines.
const MOST: usize = 26;

/// Two trees side by side, a line for each place that either of them has; marked is where they part first, and what follows.
/// Of large trees the lines around the parting are drawn, and the others counted.
pub fn parting(a: &RayTree, b: &RayTree, difference: &Difference, theme: &Theme) -> Drawing {
    let mut parted: BTreeMap<String, Vec<&Divergence>> = BTreeMap::new();
    for divergence in &difference.divergences {
        parted.entry(divergence.path.to_string()).or_default().push(divergence);
    }
    let rows = rows(pairs(a, b), &parted);
    let title = match (difference.first(), a.pixel.or(b.pixel)) {
        (Some(first), Some([x, y])) => format!("Two trees of pixel {x},{y} part at {}, {}", first.path, first.field),
        (Some(first), None) => format!("Two trees part at {}, {}", first.path, first.field),
        (None, Some([x, y])) => format!("Two trees of pixel {x},{y} agree"),
        (None, None) => "Two trees agree".to_owned(),
    };
    let heights: f64 = rows.iter().map(Row::height).sum();
    let (_, room) = frame::begin(DVec2::new(WIDTH, 200.0), &title, "", theme);
    let size = DVec2::new(WIDTH, room.min.y + HEAD + heights + KEY + frame::MARGIN);
    let (mut drawing, room) = frame::begin(size, &title, "", theme);
    drawing.describe(difference.to_text());
    let mut y = head(&mut drawing, room, [a, b], theme);
    for row in &rows {
        row.draw(&mut drawing, room, y, theme);
        y += row.height();
    }
    key(&mut drawing, room, theme);
    drawing
}

/// The room for the colours above, and for the key below.
const HEAD: f64 = 34.0;
const KEY: f64 = 26.0;

/// The side of a tree on the drawing.
fn side(room: Rect, is_b: bool) -> Rect {
    let middle = room.center().x;
    match is_b {
        false => Rect { min: room.min, max: DVec2::new(middle - GUTTER / 2.0, room.max.y) },
        true => Rect { min: DVec2::new(middle + GUTTER / 2.0, room.min.y), max: room.max },
    }
}

/// Whose trees they are, and their colours; returns where the lines begin.
fn head(drawing: &mut Drawing, room: Rect, trees: [&RayTree; 2], theme: &Theme) -> f64 {
    for (i, tree) in trees.into_iter().enumerate() {
        let side = side(room, i == 1);
        let bold = Text::new(SMALL + 1.0, theme.ink).face(Face::Bold).anchor(Align::Start, Level::Middle);
        let small = Text::new(SMALL, theme.muted).anchor(Align::Start, Level::Middle);
        let y = side.min.y + 10.0;
        let name = ["A", "B"][i];
        drawing.text((side.min.x, y), name, bold);
        let by = tree.generator.as_ref().map_or(String::new(), |by| format!("by {}   ", printable(&by.name)));
        let plural = if tree.rays == 1 { "" } else { "s" };
        let words = format!("{by}{} ray{plural}   rgb {}", tree.rays, shown_vector(tree.color));
        frame::swatch(drawing, Rect::new((side.min.x + 18.0, y - 8.0), (26.0, 16.0)), tree.color, theme);
        drawing.text((side.min.x + 52.0, y), elided(&words, &small, side.size().x - 52.0), small);
    }
    room.min.y + HEAD
}

/// A line: a ray of both trees, or rays that are only counted.
enum Row<'t> {
    Rays { pair: Pair<'t>, parted: Vec<&'t Divergence> },
    Hidden { count: usize, depth: usize },
}

/// The lines: all of them, or those on the way to the first parting, then those that part, then the rest from the top, until
/// there are enough.
fn rows<'t>(pairs: Vec<Pair<'t>>, parted: &BTreeMap<String, Vec<&'t Divergence>>) -> Vec<Row<'t>> {
    let paths: Vec<String> = pairs.iter().map(|pair| pair.path.to_string()).collect();
    let first = paths.iter().position(|path| {
        parted.get(path).is_some_and(|divergences| divergences.iter().any(|divergence| !divergence.consequence))
    });
    let mut shown: BTreeSet<usize> = BTreeSet::new();
    if let Some(first) = first {
        let is_above = |path: &String| paths[first] == *path || paths[first].starts_with(&format!("{path}."));
        shown.extend((0..pairs.len()).filter(|&i| is_above(&paths[i])));
    }
    let on_its_own = |i: &usize| parted.get(&paths[*i]).is_some_and(|d| d.iter().any(|d| !d.consequence));
    let wanted = (0..pairs.len()).filter(on_its_own);
    let following = (0..pairs.len()).filter(|i| parted.contains_key(&paths[*i]));
    for i in wanted.chain(following).chain(0..pairs.len()) {
        if shown.len() >= MOST {
            break;
        }
        shown.insert(i);
    }
    let mut rows: Vec<Row<'t>> = Vec::new();
    for (i, pair) in pairs.into_iter().enumerate() {
        if shown.contains(&i) {
            let parted = parted.get(&paths[i]).cloned().unwrap_or_default();
            rows.push(Row::Rays { pair, parted });
        } else if let Some(Row::Hidden { count, .. }) = rows.last_mut() {
            *count += 1;
        } else {
            rows.push(Row::Hidden { count: 1, depth: pair.depth });
        }
    }
    rows
}

impl Row<'_> {
    fn height(&self) -> f64 {
        match self {
            Self::Rays { parted, .. } if !parted.is_empty() => TALL,
            _ => LINE,
        }
    }

    fn draw(&self, drawing: &mut Drawing, room: Rect, y: f64, theme: &Theme) {
        match self {
            Self::Hidden { count, depth } => {
                let words = if *count == 1 { "… 1 more ray".to_owned() } else { format!("… {count} more rays") };
                let text = Text::new(SMALL, theme.muted).anchor(Align::Start, Level::Middle);
                for is_b in [false, true] {
                    drawing.text((side(room, is_b).min.x + indent(*depth), y + LINE / 2.0), words.as_str(), text);
                }
            }
            Self::Rays { pair, parted } => {
                let own = parted.iter().any(|divergence| !divergence.consequence);
                if own {
                    let rect = Rect::new((room.min.x - 6.0, y), (room.size().x + 12.0, self.height() - 1.0));
                    drawing.fill(Path::rounded(rect, 5.0), theme.panel);
                    drawing.stroke(Path::rounded(rect, 5.0), Pen::new(mark(theme), 1.6));
                }
                let middle = DVec2::new(room.center().x, y + self.height() / 2.0);
                match (parted.is_empty(), own) {
                    (true, _) => {}
                    (false, true) => drawing.disk(middle, 6.5, mark(theme)),
                    (false, false) => frame::ring(drawing, middle, 4.5, mark(theme), theme),
                }
                for (is_b, node) in [(false, pair.a), (true, pair.b)] {
                    let side = side(room, is_b);
                    let left = side.min.x + indent(pair.depth);
                    ray(drawing, Rect { min: DVec2::new(left, y), max: DVec2::new(side.max.x, y + LINE) }, node, theme);
                    let text = Text::new(SMALL, if own { mark(theme) } else { theme.muted })
                        .anchor(Align::Start, Level::Middle);
                    let words = values(parted, is_b);
                    drawing.text((left + 20.0, y + LINE + 6.0), elided(&words, &text, side.max.x - left - 20.0), text);
                }
            }
        }
    }
}

fn indent(depth: usize) -> f64 {
    (STEP * depth as f64).min(DEEPEST)
}

/// What marks a parting.
fn mark(theme: &Theme) -> Color {
    theme.hue(Hue::Vermilion)
}

/// A ray: what it brings back, and what it met.
fn ray(drawing: &mut Drawing, rect: Rect, node: Option<&RayNode>, theme: &Theme) {
    let middle = rect.center().y;
    let text = Text::new(SMALL, theme.ink).anchor(Align::Start, Level::Middle);
    let Some(node) = node else {
        drawing.text((rect.min.x + 20.0, middle), "no such ray", text.color(theme.muted));
        return;
    };
    let swatch = Rect::new((rect.min.x, middle - 7.0), (13.0, 14.0));
    match node.radiance {
        Some(radiance) => frame::swatch(drawing, swatch, radiance, theme),
        None => light_mark(drawing, swatch.center(), node.outcome, theme),
    }
    drawing.line((rect.min.x + 20.0, middle), (rect.min.x + 48.0, middle), theme.ray(node.kind, 2.0));
    let weight = node.weight.map(|w| if w[0] == w[1] && w[1] == w[2] { shown(w[0]) } else { shown_vector(w) });
    let weight = weight.map_or(String::new(), |weight| format!("   w {weight}"));
    let words = format!("{}{weight}", card_words(node).join("   "));
    drawing.text((rect.min.x + 55.0, middle), elided(&words, &text, rect.size().x - 55.0), text);
}

/// The values of one tree in which a ray parts: those that part by themselves, else the names of what follows.
fn values(parted: &[&Divergence], is_b: bool) -> String {
    let own: Vec<String> = parted
        .iter()
        .filter(|divergence| !divergence.consequence)
        .map(|divergence| {
            let value = if is_b { &divergence.b } else { &divergence.a };
            let value = value.as_ref().map_or("not there".to_owned(), written);
            match &divergence.light {
                Some(light) => format!("{} of {} {value}", divergence.field, printable(light)),
                None => format!("{} {value}", divergence.field),
            }
        })
        .collect();
    if !own.is_empty() {
        return own.join("   ");
    }
    let names: Vec<&str> = parted.iter().map(|divergence| divergence.field.name()).collect();
    if names.is_empty() { String::new() } else { format!("follows: {}", names.join(", ")) }
}

fn written(value: &Value) -> String {
    match value {
        Value::Number(x) => shown(*x),
        Value::Numbers(numbers) => numbers.iter().map(|x| shown(*x)).collect::<Vec<_>>().join(" "),
        other => other.to_string(),
    }
}

/// What the marks stand for.
fn key(drawing: &mut Drawing, room: Rect, theme: &Theme) {
    let text = Text::new(SMALL, theme.muted).anchor(Align::Start, Level::Middle);
    let y = room.max.y - 7.0;
    let mut x = room.min.x;
    for (own, words) in [(true, "here they part by themselves"), (false, "here something follows from that")] {
        match own {
            true => drawing.disk((x + 7.0, y), 6.5, mark(theme)),
            false => frame::ring(drawing, DVec2::new(x + 7.0, y), 4.5, mark(theme), theme),
        }
        drawing.text((x + 20.0, y), words, text);
        x += 20.0 + text.width(words) + 24.0;
    }
    drawing.text((x, y), "square: what a ray brings back    w: its weight", text);
}
