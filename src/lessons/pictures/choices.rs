//! Lesson 13: cost against error, where two lines cross, bars of different length.

use glam::DVec2;

use super::{Answer, Page, Shown};
use crate::lessons::{Choice, shown};
use crate::pictures::charts::{Axis, Heading, Line, Lines, Point, Scale, Scatter, lines, scatter};
use crate::pictures::drawing::{Align, Dash, Drawing, Face, Level, Path, Rect, Text};
use crate::pictures::theme::{Hue, Mark, Theme};

/// What is given and what was answered, for the line below a chart's title and for those who do not see it.
fn in_words(what: &Shown) -> (String, String) {
    let mut told = format!("True: {}.", what.expected);
    let mut described = format!("{}: {}", what.given.join(", "), what.expected);
    if let Some(wrong) = what.wrong() {
        let [expected, got] = what.expected.told_beside(wrong);
        told = format!("True (green): {expected}. Yours (red): {got}.");
        described = format!("{}: {expected}, yours: {got}", what.given.join(", "));
        if let Some(mistake) = &what.mistake {
            told += &format!(" The mistake: {mistake}.");
        }
    }
    (told, described)
}

/// The choices that an answer names.
fn named(answer: Option<&Answer>) -> Vec<usize> {
    let one = |answer: &Answer| answer.number("choice").filter(|x| *x >= 0.0).map(|x| vec![x as usize]);
    answer.and_then(|answer| answer.set("front").or_else(|| one(answer))).unwrap_or_default()
}

/// Choices by cost and error: those that the right answer names, and the student's. `about` says what is asked.
pub fn cost_and_error(choices: &[Choice], about: &str, what: &Shown) -> Drawing {
    let theme = &Theme::LIGHT;
    let (right, yours) = (named(Some(&what.expected)), named(what.wrong()));
    let is_wrong = what.wrong().is_some();
    let point = |(i, choice): (usize, &Choice)| {
        let (color, mark) = match (right.contains(&i), yours.contains(&i)) {
            (true, false) if is_wrong => (theme.hue(Hue::Green), Mark::Ring),
            (true, _) => (theme.hue(Hue::Green), Mark::Disk),
            (false, true) => (theme.hue(Hue::Vermilion), Mark::Cross),
            (false, false) => (theme.hue(Hue::Grey), Mark::Diamond),
        };
        let name = format!("{i}: {}", choice.name);
        Point { name, color, mark, x: choice.cost, y: choice.error, x_spread: None, y_spread: None }
    };
    let points: Vec<Point> = choices.iter().enumerate().map(point).collect();
    let (told, described) = in_words(what);
    let axis = |title: &str, of: fn(&Choice) -> f64| Axis {
        title: title.to_owned(),
        scale: Scale::log_around(choices.iter().map(of)),
    };
    let chart = Scatter {
        heading: Heading { title: format!("{}: {}", what.title, what.case), note: format!("{about} {told}") },
        x: axis("cost", |choice| choice.cost),
        y: axis("error", |choice| choice.error),
        points,
        front: Some(String::new()),
    };
    let mut drawing = scatter(&chart, theme);
    drawing.describe(described + ".");
    drawing
}

/// The cost of more and more rays without and with something that is built first, and where the two are equal.
pub fn crossing(build: f64, slow: f64, fast: f64, what: &Shown) -> Drawing {
    let theme = &Theme::LIGHT;
    let at = |answer: Option<&Answer>| answer.and_then(|answer| answer.number("rays")).filter(|n| *n > 0.0);
    let (right, wrong) = (at(Some(&what.expected)), at(what.wrong()));
    let end = match right {
        Some(n) => 2.0 * n.max(wrong.filter(|wrong| *wrong < 4.0 * n).unwrap_or(0.0)),
        None => 2.0 * build / slow.max(1e-6),
    };
    let top = (slow * end).max(build + fast * end);
    let line = |name: &str, hue, dash, points: Vec<(f64, f64)>| Line {
        name: name.to_owned(),
        color: theme.hue(hue),
        dash,
        mark: Mark::Disk,
        points,
    };
    let mut all = vec![
        line("without", Hue::Amber, Dash::Solid, vec![(0.0, 0.0), (end, slow * end)]),
        line("built first", Hue::Blue, Dash::Solid, vec![(0.0, build), (end, build + fast * end)]),
    ];
    for (n, name, hue, dash) in
        [(right, "true", Hue::Green, Dash::Solid), (wrong, "yours", Hue::Vermilion, Dash::Dashed)]
    {
        all.extend(n.filter(|n| *n <= end).map(|n| line(name, hue, dash, vec![(n, 0.0), (n, top)])));
    }
    let (told, described) = in_words(what);
    let chart = Lines {
        heading: Heading { title: format!("{}: {}", what.title, what.case), note: told },
        x: Axis { title: "rays".to_owned(), scale: Scale::linear_from_zero([end]) },
        y: Axis {
            title: "tests, those that building is worth included".to_owned(),
            scale: Scale::linear_from_zero([top]),
        },
        lines: all,
    };
    let mut drawing = lines(&chart, theme);
    drawing.describe(described + ".");
    drawing
}

/// Named amounts as bars.
pub fn bars(amounts: &[(String, f64)], about: &str, what: &Shown) -> Drawing {
    let mut page = Page::new(what, about);
    let most = amounts.iter().map(|(_, x)| *x).fold(0.0, f64::max).max(1e-300);
    let step = (page.room.size().y / amounts.len().max(1) as f64).min(64.0);
    let width = page.room.size().x - 90.0;
    let name = Text::new(13.0, page.theme.ink).anchor(Align::Start, Level::Middle);
    let amount = name.face(Face::Bold);
    for (i, (words, x)) in amounts.iter().enumerate() {
        let corner = page.room.min + DVec2::new(0.0, step * i as f64 + 12.0);
        page.drawing.text(corner, words.as_str(), name);
        let bar = Rect::new(corner + DVec2::new(0.0, 12.0), DVec2::new(width * x / most, 16.0));
        page.drawing.fill(Path::rect(bar), page.theme.hue(Hue::Sky).fade(0.7));
        page.drawing.text((bar.max.x + 8.0, bar.center().y), shown(*x), amount);
    }
    page.drawing
}
