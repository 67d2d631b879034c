//! The ray tree as cards and lines: every card a ray with what it brought back, every line a branch with its weight.

mod fold;
mod tidy;

use glam::DVec2;

use super::frame::{self, Key, SMALL, Sign, elided};
use super::numbers::{shown, shown_vector};
use super::{Input, NotApplicable};
use crate::input::printable;
use crate::pictures::drawing::{Align, Drawing, Level, Path, Pen, Rect, Text};
use crate::pictures::theme::Theme;
use crate::tree::{Kind, Outcome, RayNode};
use fold::Folding;

/// Below this share of its size text is hard to read: rather fewer cards.
const SMALLEST: f64 = 0.82;
/// The widest card, and the room between cards side by side.
const WIDEST: f64 = 150.0;
const GAP: f64 = 9.0;
/// The part of a line that fans out.
const FAN: f64 = 17.0;

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let rays = if input.tree.rays == 1 { "1 ray".to_owned() } else { format!("{} rays", input.tree.rays) };
    let title = format!("{}: {rays}", input.title("Ray tree"));
    let mut folding = Folding::new(input.tree);
    let (_, room) = frame::begin(input.size, &title, "", theme);
    let room = room.size() - DVec2::new(0.0, 22.0);
    let (plan, scale) = loop {
        // Cards of one line take less room down, those of several less across.
        let ways = [(Way::Right, Lines::Several), (Way::Down, Lines::Several), (Way::Down, Lines::One)];
        let mut best: Option<(Plan, f64)> = None;
        for (way, lines) in ways {
            let plan = Plan::new(&folding, way, lines, theme);
            let scale = (room / plan.size).min_element().min(1.0);
            if best.as_ref().is_none_or(|(_, most)| scale > *most) {
                best = Some((plan, scale));
            }
            if scale >= 1.0 {
                break;
            }
        }
        match best {
            Some(best) if best.1 >= SMALLEST || !folding.fold() => break best,
            _ => {}
        }
    };

    // The canvas shrinks to what there is.
    let least = DVec2::new(640.0, 0.0).min(input.size);
    let taken = plan.size * scale;
    let width = (taken.x + 2.0 * frame::MARGIN).max(least.x).min(input.size.x);
    let head = frame::begin(DVec2::new(width, input.size.y), &title, "", theme).1.min.y;
    let size = DVec2::new(width, (head + taken.y + 22.0 + frame::MARGIN).min(input.size.y));
    let (mut drawing, room) = frame::begin(size, &title, "", theme);
    drawing.describe(describe(&folding));
    let kinds = [Kind::Camera, Kind::Reflected, Kind::Refracted, Kind::Shadow];
    let present: Vec<Kind> =
        kinds.into_iter().filter(|kind| plan.cards.iter().any(|c| folding.items[c.item].node.kind == *kind)).collect();
    let keys = [
        Key { words: "what it brings back", sign: Sign::Swatch },
        Key { words: "on the line: its weight", sign: Sign::None },
    ];
    frame::key(&mut drawing, room, &present, &keys, theme);
    let mut inner = Drawing::new(plan.size.x.max(1.0), plan.size.y.max(1.0), theme.background, "cards");
    plan.draw(&mut inner, &folding, input.node, theme);
    // A narrow tree stands in the middle of its canvas.
    let aside = (0.5 * (room.size().x - taken.x)).max(0.0);
    drawing.place(&inner, room.min + DVec2::new(aside, 0.0), scale);
    Ok(drawing)
}

/// The tree in one sentence.
fn describe(folding: &Folding<'_>) -> String {
    let count = |kind| folding.items.iter().filter(|item| item.node.kind == kind).count();
    let [reflected, refracted, shadow] = [Kind::Reflected, Kind::Refracted, Kind::Shadow].map(count);
    let root = card_words(folding.items[0].node).join(", ");
    format!("The camera ray ({root}), {reflected} reflected, {refracted} refracted and {shadow} shadow rays.")
}

/// Where the tree grows.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Right,
    Down,
}

/// How much a card says on a line.
#[derive(Clone, Copy, PartialEq)]
enum Lines {
    Several,
    One,
}

/// A ray's card.
struct Card {
    item: usize,
    parent: Option<usize>,
    lines: Vec<String>,
    rect: Rect,
}

/// Where everything goes at full size.
struct Plan {
    way: Way,
    cards: Vec<Card>,
    size: DVec2,
}

impl Plan {
    fn new(folding: &Folding<'_>, way: Way, lines_of: Lines, theme: &Theme) -> Self {
        let text = Text::new(SMALL, theme.ink);
        let mut cards: Vec<Card> = Vec::new();
        let mut levels: Vec<usize> = Vec::new();
        let mut nodes: Vec<tidy::Node> = Vec::new();
        let mut open = vec![(0, None::<usize>)];
        while let Some((item, parent)) = open.pop() {
            let place = cards.len();
            let mut lines = card_words(folding.items[item].node);
            let (shadows, rest) = folding.hidden(item);
            match (shadows, rest) {
                (0, 0) => {}
                (1, _) => lines.push("+ 1 shadow ray".to_owned()),
                (n, 0) => lines.push(format!("+ {n} shadow rays")),
                (_, 1) => lines.push("+ 1 ray".to_owned()),
                (_, n) => lines.push(format!("+ {n} rays")),
            }
            let mut lines: Vec<String> = lines.iter().map(|line| elided(line, &text, WIDEST)).collect();
            if lines_of == Lines::One {
                lines = vec![lines.join("   ")];
            }
            let number = number_width(item, theme);
            let indent = |i: usize| if i == 0 { number } else { 0.0 };
            let width = lines.iter().enumerate().map(|(i, line)| indent(i) + text.width(line)).fold(0.0, f64::max);
            let size = DVec2::new(width + 30.0, 8.0 + 15.0 * lines.len() as f64);
            let rect = Rect { min: DVec2::ZERO, max: size };
            levels.push(parent.map_or(0, |parent| levels[parent] + 1));
            nodes.push(tidy::Node { breadth: if way == Way::Right { size.y } else { size.x }, children: Vec::new() });
            if let Some(parent) = parent {
                nodes[parent].children.push(place);
            }
            cards.push(Card { item, parent, lines, rect });
            open.extend(folding.shown(item).into_iter().rev().map(|child| (child, Some(place))));
        }
        if way == Way::Down {
            // A weight stands to the right of its line: it must not reach that of the next card, which may be a narrow one.
            let narrowest = nodes.iter().map(|node| node.breadth).fold(f64::INFINITY, f64::min);
            for (card, node) in cards.iter().zip(&mut nodes) {
                let words = weight_words(folding.items[card.item].node);
                let label = words.map_or(0.0, |words| weight_text(theme).width(words) + 8.0);
                node.breadth = node.breadth.max(2.0 * (label - GAP) - narrowest);
            }
        }
        let (middles, across) = tidy::place(&nodes, GAP);

        // Each level is as long as its longest card; in front of it is room for the lines and the weights on them.
        let length = |card: &Card| if way == Way::Right { card.rect.size().x } else { card.rect.size().y };
        let depth = levels.iter().copied().max().unwrap_or(0) + 1;
        let (mut longest, mut before) = (vec![0.0_f64; depth], vec![0.0_f64; depth]);
        for (card, &level) in cards.iter().zip(&levels) {
            longest[level] = longest[level].max(length(card));
            let label =
                weight_words(folding.items[card.item].node).map_or(0.0, |words| weight_text(theme).width(words));
            let is_alone = card.parent.is_none_or(|parent| nodes[parent].children.len() == 1);
            let room = match way {
                Way::Right => FAN + label + 12.0,
                Way::Down if is_alone => 17.0,
                Way::Down => FAN + 16.0,
            };
            before[level] = if level == 0 { 0.0 } else { before[level].max(room) };
        }
        let mut starts = vec![0.0; depth];
        for level in 1..depth {
            starts[level] = starts[level - 1] + longest[level - 1] + before[level];
        }
        let along = starts[depth - 1] + longest[depth - 1];
        for (i, card) in cards.iter_mut().enumerate() {
            let size = card.rect.size();
            let corner = match way {
                Way::Right => DVec2::new(starts[levels[i]], middles[i] - size.y / 2.0),
                Way::Down => DVec2::new(middles[i] - size.x / 2.0, starts[levels[i]]),
            };
            card.rect = Rect::new(corner + 1.0, size);
        }
        // The last weight below may stick out beside its line.
        let spare = if way == Way::Down { weight_spare(&cards, folding, across, theme) } else { 0.0 };
        let size = if way == Way::Right { DVec2::new(along, across) } else { DVec2::new(across + spare, along) };
        Plan { way, cards, size: size + 2.0 }
    }

    fn draw(&self, drawing: &mut Drawing, folding: &Folding<'_>, chosen: &RayNode, theme: &Theme) {
        for card in &self.cards {
            let Some(parent) = card.parent.map(|parent| self.cards[parent].rect) else { continue };
            let way = self.way_to(parent, card.rect);
            let item = &folding.items[card.item];
            drawing.about(&item.path.to_string(), |drawing| self.draw_line(drawing, way, item.node, theme));
        }
        for card in &self.cards {
            let item = &folding.items[card.item];
            let is_chosen = std::ptr::eq(item.node, chosen) && item.node.depth > 0;
            drawing.about(&item.path.to_string(), |drawing| draw_card(drawing, card, item.node, is_chosen, theme));
        }
    }

    /// The line to a card, with its weight.
    fn draw_line(&self, drawing: &mut Drawing, [from, bend, to]: [DVec2; 3], node: &RayNode, theme: &Theme) {
        drawing.stroke(Path::open([from, bend, to]), theme.ray(node.kind, 1.8));
        if let Some(words) = weight_words(node) {
            let text = weight_text(theme);
            match self.way {
                Way::Right => drawing.text(to - DVec2::new(5.0, 4.0), words, text.anchor(Align::End, Level::Baseline)),
                Way::Down => drawing.text(to + DVec2::new(6.0, -6.0), words, text),
            };
        }
    }

    /// The line from a card to that of a child: first across, then straight on.
    fn way_to(&self, parent: Rect, child: Rect) -> [DVec2; 3] {
        match self.way {
            Way::Right => {
                let y = child.center().y;
                let start = DVec2::new(parent.max.x, parent.center().y);
                [start, DVec2::new(start.x.max(child.min.x - 400.0) + FAN, y), DVec2::new(child.min.x, y)]
            }
            Way::Down => {
                let x = child.center().x;
                let start = DVec2::new(parent.center().x, parent.max.y);
                [start, DVec2::new(x, (start.y + FAN).min(child.min.y)), DVec2::new(x, child.min.y)]
            }
        }
    }
}

/// A ray's card.
fn draw_card(drawing: &mut Drawing, card: &Card, node: &RayNode, is_chosen: bool, theme: &Theme) {
    let (rect, pen) = (card.rect, theme.ray(node.kind, 1.3));
    drawing.fill(Path::rounded(rect, 5.0), theme.panel);
    let width = if is_chosen { 3.0 } else { 1.3 };
    drawing.stroke(Path::rounded(rect, 5.0), Pen { width, ..Pen::new(pen.color, width) });
    let swatch = Rect::new(rect.min + DVec2::new(6.0, 6.0), (12.0, rect.size().y - 12.0));
    match node.radiance {
        Some(radiance) => frame::swatch(drawing, swatch, radiance, theme),
        None => light_mark(drawing, swatch.center(), node.outcome, theme),
    }
    for (i, line) in card.lines.iter().enumerate() {
        let color = if i == 0 { theme.ink } else { theme.muted };
        let at = rect.min + DVec2::new(24.0, 4.0 + 15.0 * (i as f64 + 0.5));
        let text = Text::new(SMALL, color).anchor(Align::Start, Level::Middle);
        let indent = if i == 0 { number_width(card.item, theme) } else { 0.0 };
        drawing.text(at + DVec2::new(indent, 0.0), line, text);
        if i == 0 {
            drawing.text(at, (card.item + 1).to_string(), text.color(theme.muted));
        }
    }
}

/// How far weights stick out on the right where the tree grows down.
fn weight_spare(cards: &[Card], folding: &Folding<'_>, across: f64, theme: &Theme) -> f64 {
    let end = |card: &Card| {
        let words = card.parent.and_then(|_| weight_words(folding.items[card.item].node));
        card.rect.center().x + words.map_or(0.0, |words| 8.0 + weight_text(theme).width(words))
    };
    cards.iter().map(|card| end(card) - across).fold(0.0, f64::max)
}

/// The room of a ray's number in front of its name.
fn number_width(item: usize, theme: &Theme) -> f64 {
    Text::new(SMALL, theme.muted).width((item + 1).to_string()) + 7.0
}

fn weight_text(theme: &Theme) -> Text {
    Text::new(SMALL - 1.0, theme.muted)
}

fn weight_words(node: &RayNode) -> Option<String> {
    let w = node.weight?;
    Some(if w[0] == w[1] && w[1] == w[2] { shown(w[0]) } else { shown_vector(w) })
}

/// What a card says: what was hit, and how.
pub(super) fn card_words(node: &RayNode) -> Vec<String> {
    let object = node.hit.as_ref().map(|hit| match &hit.object {
        Some(name) => printable(name).into_owned(),
        None => format!("shape {}", hit.shape),
    });
    let t = node.hit.as_ref().map_or(String::new(), |hit| format!("t {}", shown(hit.t)));
    let light = node.light.as_deref().map(printable).unwrap_or_default();
    match node.outcome {
        Outcome::Lit => vec![format!("→ {light}: lit")],
        Outcome::Blocked => match object {
            Some(object) => vec![format!("→ {light}: blocked"), format!("{object}, {t}")],
            None => vec![format!("→ {light}: blocked")],
        },
        Outcome::Hit => {
            let mut second = t;
            if let Some(fresnel) = node.fresnel.filter(|_| !node.total_reflection) {
                second += &format!("  R {}", shown(fresnel));
            }
            let mut words = vec![object.unwrap_or_default(), second];
            if node.total_reflection {
                words.push("total reflection".to_owned());
            }
            words
        }
        Outcome::Background => vec!["background".to_owned()],
        Outcome::MaxDepth => vec!["not traced:".to_owned(), "max_depth".to_owned()],
        Outcome::BelowMinWeight => vec!["not traced:".to_owned(), "min_weight".to_owned()],
        Outcome::RayBudget => vec!["not traced:".to_owned(), "ray_budget".to_owned()],
    }
}

/// A shadow ray brings back no light, but a verdict: an open circle for light, a full one for none.
pub(super) fn light_mark(drawing: &mut Drawing, at: DVec2, outcome: Outcome, theme: &Theme) {
    let color = theme.ray(Kind::Shadow, 1.0).color;
    match outcome {
        Outcome::Lit => frame::ring(drawing, at, 4.5, color, theme),
        _ => drawing.disk(at, 5.0, theme.muted),
    }
}
