//! How cuts look: solids filled, media tinted, planes hatched below.

use glam::DVec2;

use super::cut::Cut;
use super::window::Window;
use crate::pictures::diagrams::labels::Taken;
use crate::pictures::drawing::{Color, Drawing, Path, Pen, Rect};
use crate::pictures::theme::{Hue, Theme};

/// What a shape is, as far as a section shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Matter {
    /// Light goes through.
    Medium,
    /// It does not.
    Opaque,
}

/// A circle larger than this on the canvas is drawn as the arc that is seen.
const LARGEST_CIRCLE: f64 = 3000.0;

/// Draws a cut, which the caller has to clip to the frame, and returns places on its outline and in its middle that are seen, for
/// its name.
pub(super) fn draw(
    drawing: &mut Drawing,
    window: &Window,
    cut: &Cut,
    matter: Matter,
    taken: &mut Taken,
    theme: &Theme,
) -> Vec<DVec2> {
    let (fill, line) = match matter {
        Matter::Medium => (theme.hue(Hue::Sky).fade(0.15), Pen::new(theme.hue(Hue::Sky), 1.5)),
        Matter::Opaque => (theme.axis.fade(0.22), Pen::new(theme.axis, 1.5)),
    };
    match cut {
        Cut::Circle { center, radius } => circle(drawing, window, *center, *radius, fill, line, taken),
        Cut::Polygon(corners) => area(drawing, window, std::slice::from_ref(corners), fill, line, taken),
        Cut::Chains { chains, closed: true } => area(drawing, window, chains, fill, line, taken),
        Cut::Chains { chains, closed: false } => {
            let line = Pen { width: 2.4, ..line };
            let mut seen = Vec::new();
            for ends in chains.iter().flat_map(|chain| chain.windows(2)) {
                let Some((a, b)) = window.frame.clip(window.at(ends[0]), window.at(ends[1])) else { continue };
                drawing.line(a, b, line);
                taken.take_line(a, b);
                seen.push(a.lerp(b, 0.5));
            }
            seen
        }
        Cut::Line { normal, distance } => ground(drawing, window, *normal, *distance, line, taken),
    }
}

fn circle(
    drawing: &mut Drawing,
    window: &Window,
    center: DVec2,
    radius: f64,
    fill: Color,
    line: Pen,
    taken: &mut Taken,
) -> Vec<DVec2> {
    // What is too small to see is a dot.
    let (at, r) = (window.at(center), (radius * window.scale).max(2.2));
    let middle = window.frame.center();
    let reach = window.frame.size().length();
    if !(at.distance(middle) <= r + reach) {
        return Vec::new();
    }
    let (outline, inside) = if r <= LARGEST_CIRCLE {
        let points: Vec<DVec2> = (0..=48).map(|i| at + r * unit(f64::from(i) * std::f64::consts::TAU / 48.0)).collect();
        (points, Path::circle(at, r))
    } else {
        // The arc around the point nearest to the middle of the frame, measured from that point: it stays exact however
        // large the circle is. A circle that bends too little to see is closed far inside.
        let outward = (middle - at).try_normalize().unwrap_or(DVec2::NEG_Y);
        let nearest = at + r * outward;
        let point = |i: i32| {
            let turn = 2.0 * reach * f64::from(i) / 40.0 / r;
            let half = libm::sin(turn / 2.0);
            nearest + r * (libm::sin(turn) * outward.perp() - 2.0 * half * half * outward)
        };
        let points: Vec<DVec2> = (-40..=40).map(point).collect();
        let (first, last) = (points[0], points[80]);
        let deep = 4.0 * reach * outward;
        (points.clone(), Path::polygon(points.into_iter().chain([last - deep, first - deep])))
    };
    let frame = window.frame;
    drawing.fill(inside.clone(), fill);
    drawing.stroke(if r <= LARGEST_CIRCLE { inside } else { Path::open(outline.iter().copied()) }, line);
    outline.windows(2).for_each(|ends| taken.take_line(ends[0], ends[1]));
    let shown = |p: &DVec2| frame.grown(-6.0).contains(Rect { min: *p, max: *p });
    // Of a large circle the name stands inside along the upper arc, where it is clear of circles within.
    let inner = (0..16).map(|i| {
        let turn = std::f64::consts::PI * (-0.5 + 0.125 * f64::from((i + 1) / 2) * if i % 2 == 0 { 1.0 } else { -1.0 });
        at + (r - 15.0) * unit(turn)
    });
    let inner: Vec<DVec2> = if (60.0..=LARGEST_CIRCLE).contains(&r) { inner.collect() } else { vec![at] };
    inner.into_iter().chain(outline).filter(shown).collect()
}

/// Closed outlines: what is wound the other way round is a hole.
fn area(
    drawing: &mut Drawing,
    window: &Window,
    rings: &[Vec<DVec2>],
    fill: Color,
    line: Pen,
    taken: &mut Taken,
) -> Vec<DVec2> {
    let bounds = window.frame.grown(8.0);
    let cut: Vec<Vec<DVec2>> = rings
        .iter()
        .map(|ring| cut_to(bounds, ring.iter().map(|p| window.at(*p)).collect()))
        .filter(|ring| ring.len() >= 3)
        .collect();
    let mut path = Path::default();
    let mut seen = Vec::new();
    for ring in &cut {
        path = path.and(Path::polygon(ring.iter().copied()));
        let around = ring.iter().zip(ring.iter().cycle().skip(1));
        around.for_each(|(a, b)| taken.take_line(*a, *b));
        seen.extend(Rect::around(ring.iter().copied()).map(|bounds| bounds.center()));
        seen.extend(ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.lerp(*b, 0.5)));
    }
    drawing.fill(path.clone(), fill);
    drawing.stroke(path, line);
    let frame = window.frame.grown(-4.0);
    seen.retain(|p| frame.contains(Rect { min: *p, max: *p }));
    seen
}

/// The line of a plane, hatched on the side of matter.
fn ground(
    drawing: &mut Drawing,
    window: &Window,
    normal: DVec2,
    distance: f64,
    line: Pen,
    taken: &mut Taken,
) -> Vec<DVec2> {
    let outward = Window::turned(normal);
    let on_it = window.at(normal * distance);
    let middle = window.frame.center();
    let along = outward.perp();
    // Matter lies on the right of the way from `a` to `b`.
    let foot = on_it + (middle - on_it).dot(along) * along;
    let reach = window.frame.size().length();
    if !(foot.distance(middle) <= reach) {
        return Vec::new();
    }
    let Some((a, b)) = window.frame.clip(foot - reach * along, foot + reach * along) else { return Vec::new() };
    drawing.ground(foot - reach * along, foot + reach * along, 13.0, Pen { width: 0.9, ..line });
    drawing.line(a, b, line);
    taken.take_line(a, b);
    let into = 6.0 * -outward;
    taken.take_line(a + into, b + into);
    [0.85, 0.15, 0.7, 0.3, 0.5].map(|share| a.lerp(b, share)).to_vec()
}

/// The part of a polygon inside a rectangle. Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974.
fn cut_to(rect: Rect, polygon: Vec<DVec2>) -> Vec<DVec2> {
    let sides =
        [(DVec2::X, rect.min.x), (DVec2::NEG_X, -rect.max.x), (DVec2::Y, rect.min.y), (DVec2::NEG_Y, -rect.max.y)];
    sides.into_iter().fold(polygon, |points, (inward, least)| {
        let depth = |p: &DVec2| p.dot(inward) - least;
        let mut kept = Vec::new();
        for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
            let (from, to) = (depth(a), depth(b));
            if from >= 0.0 {
                kept.push(*a);
            }
            if (from >= 0.0) != (to >= 0.0) {
                kept.push(a.lerp(*b, from / (from - to)));
            }
        }
        kept
    })
}

fn unit(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}
