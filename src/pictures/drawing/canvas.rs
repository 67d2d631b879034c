//! A drawing as pixels. The only file that names `tiny_skia`.

use std::collections::BTreeMap;

use glam::DVec2;
use tiny_skia::{
    FillRule, FilterQuality, IntSize, LineCap, LineJoin, Mask, Paint, PathBuilder, Pixmap, PixmapPaint, Shader, Stroke,
    StrokeDash, Transform,
};

use super::Drawing;
use super::fonts::GlyphRef;
use super::item::{Item, Raster, Sampling};
use super::path::{Path, Segment};
use super::pen::{Color, Pen};

/// The picture at `scale`, or nothing where it would be empty or too large.
pub(super) fn raster(drawing: &Drawing, scale: f64) -> Option<Raster> {
    let pixmap = paint(drawing, scale)?;
    let (width, height) = (pixmap.width(), pixmap.height());
    Some(Raster { width, height, rgba: pixmap.take_demultiplied() })
}

/// The PNG file of the picture at `scale`, or nothing where it would be empty or too large.
pub(super) fn png(drawing: &Drawing, scale: f64) -> Option<Vec<u8>> {
    paint(drawing, scale)?.encode_png().ok()
}

/// The PNG file of a raster, or nothing if it is empty.
pub(super) fn png_of(raster: &Raster) -> Option<Vec<u8>> {
    pixmap_of(raster)?.encode_png().ok()
}

fn paint(drawing: &Drawing, scale: f64) -> Option<Pixmap> {
    let size = (drawing.size * scale).round();
    let sound = DVec2::ONE.cmple(size).all() && size.cmple(DVec2::splat(16384.0)).all();
    let mut pixmap = sound.then(|| Pixmap::new(size.x as u32, size.y as u32))??;
    pixmap.fill(color_of(drawing.background));
    let mut canvas = Canvas { pixmap, glyphs: BTreeMap::new() };
    let scale = scale as f32;
    canvas.items(&drawing.items, Transform::from_row(scale, 0.0, 0.0, scale, 0.0, 0.0), None);
    Some(canvas.pixmap)
}

struct Canvas {
    pixmap: Pixmap,
    glyphs: BTreeMap<GlyphRef, Option<tiny_skia::Path>>,
}

impl Canvas {
    fn items(&mut self, items: &[Item], frame: Transform, mask: Option<&Mask>) {
        for item in items {
            match item {
                Item::Fill { path, color } => {
                    if let Some(path) = convert(path) {
                        self.pixmap.fill_path(&path, &paint_of(*color), FillRule::Winding, frame, mask);
                    }
                }
                Item::Stroke { path, pen } => self.stroke(path, *pen, frame, mask),
                Item::Glyphs { glyphs, pieces, origin, along, color, .. } => {
                    let (x, y, o) = (along.as_vec2(), along.perp().as_vec2(), origin.as_vec2());
                    let line = frame.pre_concat(Transform::from_row(x.x, x.y, y.x, y.y, o.x, o.y));
                    for piece in pieces.iter().filter_map(convert) {
                        self.pixmap.fill_path(&piece, &paint_of(*color), FillRule::Winding, line, mask);
                    }
                    for placed in glyphs {
                        let outline =
                            self.glyphs.entry(placed.glyph).or_insert_with(|| convert(&placed.glyph.outline()));
                        let Some(outline) = outline else { continue };
                        let k = (placed.size / placed.glyph.face.units_per_em()) as f32;
                        let at = placed.at.as_vec2();
                        let to = line.pre_concat(Transform::from_row(k, 0.0, 0.0, -k, at.x, at.y));
                        self.pixmap.fill_path(outline, &paint_of(*color), FillRule::Winding, to, mask);
                    }
                }
                Item::Image { raster, rect, sampling } => {
                    let Some(source) = pixmap_of(raster) else { continue };
                    let size = rect.size() / DVec2::new(raster.width.into(), raster.height.into());
                    let (size, at) = (size.as_vec2(), rect.min.as_vec2());
                    let to = frame.pre_concat(Transform::from_row(size.x, 0.0, 0.0, size.y, at.x, at.y));
                    let quality = match sampling {
                        Sampling::Nearest => FilterQuality::Nearest,
                        Sampling::Smooth => FilterQuality::Bilinear,
                    };
                    let paint = PixmapPaint { quality, ..PixmapPaint::default() };
                    self.pixmap.draw_pixmap(0, 0, source.as_ref(), &paint, to, mask);
                }
                Item::Group { clip, offset, scale, items } => {
                    let (o, k) = (offset.as_vec2(), *scale as f32);
                    let inner = frame.pre_concat(Transform::from_row(k, 0.0, 0.0, k, o.x, o.y));
                    match clip.as_ref().map(|clip| self.mask(clip, frame, mask)) {
                        None => self.items(items, inner, mask),
                        Some(Some(mask)) => self.items(items, inner, Some(&mask)),
                        Some(None) => {}
                    }
                }
                Item::About { items, .. } => self.items(items, frame, mask),
            }
        }
    }

    fn stroke(&mut self, path: &Path, pen: Pen, frame: Transform, mask: Option<&Mask>) {
        let Some(path) = convert(&without_cubics(path)) else { return };
        let width = pen.width as f32;
        let dash = pen.dash.pattern().iter().map(|length| *length as f32 * width).collect::<Vec<f32>>();
        let stroke = Stroke {
            width,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(dash, 0.0),
            ..Stroke::default()
        };
        self.pixmap.stroke_path(&path, &paint_of(pen.color), &stroke, frame, mask);
    }

    /// Where `clip` lets through, within what `outer` does; nothing where the clip has no inside.
    fn mask(&self, clip: &Path, frame: Transform, outer: Option<&Mask>) -> Option<Mask> {
        let clip = convert(clip)?;
        match outer {
            Some(outer) => {
                let mut mask = outer.clone();
                mask.intersect_path(&clip, FillRule::Winding, true, frame);
                Some(mask)
            }
            None => {
                let mut mask = Mask::new(self.pixmap.width(), self.pixmap.height())?;
                mask.fill_path(&clip, FillRule::Winding, true, frame);
                Some(mask)
            }
        }
    }
}

fn color_of(color: Color) -> tiny_skia::Color {
    tiny_skia::Color::from_rgba8(color.r, color.g, color.b, color.a)
}

fn paint_of(color: Color) -> Paint<'static> {
    Paint { shader: Shader::SolidColor(color_of(color)), anti_alias: true, ..Paint::default() }
}

fn pixmap_of(raster: &Raster) -> Option<Pixmap> {
    let premultiplied = raster.rgba.chunks_exact(4).flat_map(|p| {
        let color = tiny_skia::ColorU8::from_rgba(p[0], p[1], p[2], p[3]).premultiply();
        [color.red(), color.green(), color.blue(), color.alpha()]
    });
    Pixmap::from_vec(premultiplied.collect(), IntSize::from_wh(raster.width, raster.height)?)
}

/// The path in the terms of the rasteriser, or nothing where there is nothing to draw.
fn convert(path: &Path) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    let f = |p: DVec2| p.as_vec2();
    for segment in &path.segments {
        match *segment {
            Segment::Move(p) => builder.move_to(f(p).x, f(p).y),
            Segment::Line(p) => builder.line_to(f(p).x, f(p).y),
            Segment::Quad(c, p) => builder.quad_to(f(c).x, f(c).y, f(p).x, f(p).y),
            Segment::Cubic(c, d, p) => builder.cubic_to(f(c).x, f(c).y, f(d).x, f(d).y, f(p).x, f(p).y),
            Segment::Close => builder.close(),
        }
    }
    builder.finish()
}

/// The path with each cubic as four quadratic curves, for strokes: the rasteriser finds the sharpest bend of a cubic by the
/// platform's `acos` and `cos`, which do not give the same bytes everywhere. An eighth of a circle is then off by less than
/// 1e-5 of the radius.
fn without_cubics(path: &Path) -> Path {
    let (mut at, mut start) = (DVec2::ZERO, DVec2::ZERO);
    let mut segments = Vec::new();
    for segment in &path.segments {
        match *segment {
            Segment::Cubic(c, d, end) => {
                let (mut p, mut c, mut d) = (at, c, d);
                for pieces in (1..=4).rev() {
                    // The first of the pieces that are left, split off by de Casteljau.
                    let t = 1.0 / f64::from(pieces);
                    let (pc, cd, de) = (p.lerp(c, t), c.lerp(d, t), d.lerp(end, t));
                    let (first, second) = (pc.lerp(cd, t), cd.lerp(de, t));
                    let split = if pieces == 1 { end } else { first.lerp(second, t) };
                    segments.push(Segment::Quad((3.0 * (pc + first) - p - split) / 4.0, split));
                    (p, c, d) = (split, second, de);
                }
            }
            other => segments.push(other),
        }
        match *segment {
            Segment::Move(p) => (at, start) = (p, p),
            Segment::Line(p) | Segment::Quad(_, p) | Segment::Cubic(_, _, p) => at = p,
            Segment::Close => at = start,
        }
    }
    Path { segments }
}
