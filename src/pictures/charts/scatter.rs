//! Points with a name, a spread and a front of the best.

use glam::DVec2;

use super::frame::{self, Heading, MARGIN, Plot};
use super::scale::{Axis, Ruler};
use crate::pictures::drawing::{Color, Dash, Drawing, Path, Pen, Placement, Rect, Text, Wanted, around, cover};
use crate::pictures::theme::{Mark, Theme};

/// A chart of points, each of which names itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// What stands above.
    pub heading: Heading,
    /// The axis across.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
    /// The points.
    pub points: Vec<Point>,
    /// What to call the front of the points that no other point beats in both coordinates, less being better; the front is
    /// drawn if it has a name.
    pub front: Option<String>,
}

/// A point of a [`Scatter`].
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Its name, written beside it.
    pub name: String,
    /// Its colour.
    pub color: Color,
    /// Its mark.
    pub mark: Mark,
    /// Its place across.
    pub x: f64,
    /// Its place upwards.
    pub y: f64,
    /// The spread across, from less to more, if it is known.
    pub x_spread: Option<(f64, f64)>,
    /// The spread upwards.
    pub y_spread: Option<(f64, f64)>,
}

const RADIUS: f64 = 5.5;

/// Draws a [`Scatter`], 860 by 540.
pub fn scatter(chart: &Scatter, theme: &Theme) -> Drawing {
    let (width, height) = (860.0, 540.0);
    let (mut drawing, top) = frame::begin(width, height, &chart.heading, theme);
    let room = Rect { min: DVec2::new(MARGIN, top + 8.0), max: DVec2::new(width - MARGIN, height - 10.0) };
    let plot = Plot::draw(&mut drawing, room, &chart.x, &chart.y, theme);

    let places: Vec<DVec2> = chart.points.iter().map(|p| plot.at(p.x, p.y)).collect();
    let mut obstacles: Vec<Rect> = places.iter().map(|at| frame::mark_room(*at, RADIUS)).collect();
    if let Some(name) = &chart.front {
        obstacles.extend(draw_front(&mut drawing, &plot, &chart.points, name, theme, &obstacles));
    }
    if let Some((_, edge)) = plot.y.zero_band() {
        obstacles.extend(cover(&[DVec2::new(plot.area.min.x, edge), DVec2::new(plot.area.max.x, edge)]));
    }
    for (point, at) in chart.points.iter().zip(&places) {
        let pen = Pen::new(point.color, 1.4);
        obstacles.extend(draw_spread(&mut drawing, &plot.x, point.x_spread, pen, |x| DVec2::new(x, at.y)));
        obstacles.extend(draw_spread(&mut drawing, &plot.y, point.y_spread, pen, |y| DVec2::new(at.x, y)));
    }
    for (point, at) in chart.points.iter().zip(&places) {
        frame::draw_mark(&mut drawing, point.mark, *at, RADIUS, point.color, theme);
    }
    let wanted: Vec<Wanted> = chart.points.iter().zip(&places).map(|(point, at)| name_of(point, *at)).collect();
    let rects = drawing.label_all(&wanted, plot.area.grown(-2.0), &obstacles);
    for ((point, at), rect) in chart.points.iter().zip(&places).zip(rects) {
        if let Some(rect) = rect {
            drawing.leader(*at, rect, 2.4 * RADIUS, Pen::new(point.color, 0.9));
        }
    }
    drawing
}

/// The label of a point, which may stand around it.
fn name_of(point: &Point, at: DVec2) -> Wanted {
    let text = Text::new(frame::TEXT, point.color);
    Wanted { words: point.name.as_str().into(), text, places: around(at, RADIUS + 4.0) }
}

/// Draws a bar with end strokes, and returns what it covers.
fn draw_spread(
    drawing: &mut Drawing,
    ruler: &Ruler,
    spread: Option<(f64, f64)>,
    pen: Pen,
    at: impl Fn(f64) -> DVec2,
) -> Vec<Rect> {
    let Some((low, high)) = spread else { return Vec::new() };
    let (a, b) = (at(ruler.at(low)), at(ruler.at(high)));
    drawing.line(a, b, pen);
    let across = (b - a).perp().normalize_or_zero() * 3.5;
    drawing.line(a - across, a + across, pen);
    drawing.line(b - across, b + across, pen);
    cover(&[a, b])
}

/// The points that no other beats: none is less in one coordinate and at most as much in the other.
fn front(points: &[Point]) -> Vec<&Point> {
    let beats = |a: &Point, b: &Point| a.x <= b.x && a.y <= b.y && (a.x < b.x || a.y < b.y);
    let mut best: Vec<&Point> = points.iter().filter(|p| !points.iter().any(|other| beats(other, p))).collect();
    best.sort_by(|a, b| a.x.total_cmp(&b.x));
    best
}

/// Draws the front as the steps between what can be had and what cannot, and returns what it covers.
fn draw_front(
    drawing: &mut Drawing,
    plot: &Plot,
    points: &[Point],
    name: &str,
    theme: &Theme,
    marks: &[Rect],
) -> Vec<Rect> {
    let best = front(points);
    let (Some(first), Some(last)) = (best.first(), best.last()) else { return Vec::new() };
    let mut steps = vec![DVec2::new(plot.x.at(first.x), plot.area.min.y)];
    for point in &best {
        let at = plot.at(point.x, point.y);
        steps.push(DVec2::new(at.x, steps[steps.len() - 1].y));
        steps.push(at);
    }
    steps.push(DVec2::new(plot.area.max.x, plot.y.at(last.y)));
    // Below and left of the steps lies what no point reaches.
    let Rect { min, max } = plot.area;
    let mut beyond = steps.clone();
    beyond.extend([max, DVec2::new(min.x, max.y), min]);
    drawing.fill(Path::polygon(beyond), theme.axis.fade(0.10));
    drawing.stroke(Path::open(steps.iter().copied()), Pen::new(theme.axis, 1.5).dashed(Dash::Dashed));
    let covered = cover(&steps);
    let mut places = Vec::new();
    for corner in steps.windows(2).flat_map(|ends| [ends[0].lerp(ends[1], 0.5), ends[0].lerp(ends[1], 0.85)]) {
        places.extend(around(corner, 7.0).into_iter().take(8).map(|place| Placement { of: None, ..place }));
    }
    let left_of = |place: &Placement| steps.iter().any(|s| place.at.x < s.x && place.at.y > s.y);
    places.retain(|place| left_of(place));
    let text = Text::new(frame::SMALL, theme.muted);
    if !name.is_empty() {
        drawing.label(name, text, &places, plot.area.grown(-3.0), &[marks, &covered].concat());
    }
    covered
}
