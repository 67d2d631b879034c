//! A drawing as an SVG file: compact numbers, each glyph once, the same bytes everywhere.

use std::collections::BTreeMap;
use std::fmt::Write;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use glam::DVec2;

use super::fonts::GlyphRef;
use super::item::{Item, Raster, Sampling};
use super::path::{Path, Segment};
use super::pen::Color;
use super::text::{Placed, Text, Words};
use super::{Drawing, canvas};

/// The SVG file.
pub(super) fn write(drawing: &Drawing) -> String {
    let mut body = Body::default();
    body.items(&drawing.items, 1);
    let (width, height) = (number(drawing.size.x), number(drawing.size.y));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\">\n<title>{}</title>\n",
        escape(&drawing.title)
    );
    if !drawing.description.is_empty() {
        let _ = writeln!(svg, "<desc>{}</desc>", escape(&drawing.description));
    }
    if !body.definitions.is_empty() {
        svg.push_str("<defs>\n");
        body.definitions.iter().for_each(|(id, what)| svg.push_str(&what.replacen("ID", id, 1)));
        svg.push_str("</defs>\n");
    }
    let _ = writeln!(svg, "<rect width=\"{width}\" height=\"{height}\"{}/>", fill(drawing.background));
    svg.push_str(&body.text);
    svg.push_str("</svg>\n");
    svg
}

#[derive(Default)]
struct Body {
    text: String,
    /// Glyphs and clips by their names, with `ID` where the name belongs.
    definitions: BTreeMap<String, String>,
}

impl Body {
    fn items(&mut self, items: &[Item], depth: usize) {
        for item in items {
            self.text.push_str(&" ".repeat(depth - 1));
            match item {
                Item::Fill { path, color } => {
                    let _ = writeln!(self.text, "<path d=\"{}\"{}/>", data(path), fill(*color));
                }
                Item::Stroke { path, pen } => {
                    let dash = pen.dash.pattern().iter().map(|length| number(length * pen.width)).collect::<Vec<_>>();
                    let dash = match dash.as_slice() {
                        [] => String::new(),
                        lengths => format!(" stroke-dasharray=\"{}\"", lengths.join(" ")),
                    };
                    let _ = writeln!(
                        self.text,
                        "<path d=\"{}\" fill=\"none\"{} stroke-width=\"{}\" stroke-linecap=\"round\" \
                         stroke-linejoin=\"round\"{dash}/>",
                        data(path),
                        color_of("stroke", pen.color),
                        number(pen.width)
                    );
                }
                Item::Glyphs { glyphs, pieces, origin, along, color, text } => {
                    let _ = write!(self.text, "<g aria-label=\"{}\"{}>", escape(text), fill(*color));
                    for same in glyphs.chunk_by(|a, b| a.size == b.size && a.glyph.face == b.glyph.face) {
                        self.glyphs(same, *origin, *along);
                    }
                    for piece in pieces {
                        let piece = piece.map(|p| *origin + p.x * *along + p.y * along.perp());
                        let _ = write!(self.text, "<path d=\"{}\"/>", data(&piece));
                    }
                    self.text.push_str("</g>\n");
                }
                Item::Image { raster, rect, sampling } => self.image(raster, rect.min, rect.size(), *sampling),
                Item::Group { clip, offset, scale, items } => {
                    if let Some(clip) = clip {
                        let id = self.define_clip(&data(clip));
                        let _ = write!(self.text, "<g clip-path=\"url(#{id})\">");
                    }
                    let moves = *offset != DVec2::ZERO || *scale != 1.0;
                    if moves {
                        let (x, y, k) = (number(offset.x), number(offset.y), precise(*scale));
                        let _ = write!(self.text, "<g transform=\"translate({x} {y})scale({k})\">");
                    }
                    self.text.push('\n');
                    self.items(items, depth + 1);
                    self.text.push_str(&" ".repeat(depth - 1));
                    self.text.push_str(if moves { "</g>" } else { "" });
                    self.text.push_str(if clip.is_some() { "</g>\n" } else { "\n" });
                }
                Item::About { node, items } => {
                    let _ = writeln!(self.text, "<g data-node=\"{}\">", escape(node));
                    self.items(items, depth + 1);
                    let _ = writeln!(self.text, "{}</g>", " ".repeat(depth - 1));
                }
            }
        }
    }

    /// Glyphs of one face and size: a group in their design units, each at its place along the line.
    fn glyphs(&mut self, glyphs: &[Placed], origin: DVec2, along: DVec2) {
        let k = glyphs[0].size / glyphs[0].glyph.face.units_per_em();
        let (x, y) = (along * k, along.perp() * -k);
        let transform = if along == DVec2::X {
            format!("translate({} {})scale({} {})", number(origin.x), number(origin.y), precise(k), precise(-k))
        } else {
            let [a, b, c, d] = [x.x, x.y, y.x, y.y].map(precise);
            format!("matrix({a} {b} {c} {d} {} {})", number(origin.x), number(origin.y))
        };
        let _ = write!(self.text, "<g transform=\"{transform}\">");
        for Placed { glyph, at, .. } in glyphs {
            let id = self.define_glyph(*glyph);
            let at = *at / k;
            let attribute = |name: &str, x: f64| match number(x).as_str() {
                "0" => String::new(),
                x => format!(" {name}=\"{x}\""),
            };
            let _ = write!(self.text, "<use href=\"#{id}\"{}{}/>", attribute("x", at.x), attribute("y", -at.y));
        }
        self.text.push_str("</g>");
    }

    fn define_glyph(&mut self, glyph: GlyphRef) -> String {
        let id = format!("{}{}", glyph.face.prefix(), glyph.id);
        let outline = || format!("<path id=\"ID\" d=\"{}\"/>\n", data(&glyph.outline()));
        self.definitions.entry(id.clone()).or_insert_with(outline);
        id
    }

    /// A clip is named for what it is, so that two drawings in one page cannot mean different things by one name.
    fn define_clip(&mut self, data: &str) -> String {
        let id = format!("clip-{:016x}", fnv1a(data.as_bytes()));
        let clip = || format!("<clipPath id=\"ID\"><path d=\"{data}\"/></clipPath>\n");
        self.definitions.entry(id.clone()).or_insert_with(clip);
        id
    }

    fn image(&mut self, raster: &Raster, at: DVec2, size: DVec2, sampling: Sampling) {
        let Some(png) = canvas::png_of(raster) else { return };
        let rendering = match sampling {
            Sampling::Nearest => " style=\"image-rendering:pixelated\"",
            Sampling::Smooth => "",
        };
        let [x, y, width, height] = [at.x, at.y, size.x, size.y].map(number);
        let _ = writeln!(
            self.text,
            "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\"{rendering} \
             href=\"data:image/png;base64,{}\"/>",
            BASE64_STANDARD.encode(&png)
        );
    }
}

/// A number to a hundredth, without superfluous characters.
fn number(x: f64) -> String {
    decimal((x * 100.0).round() as i64, 2)
}

/// A number to a millionth: for factors.
fn precise(x: f64) -> String {
    decimal((x * 1e6).round() as i64, 6)
}

/// `units` of the given decimal place.
fn decimal(units: i64, places: usize) -> String {
    let digits = format!("{:0>width$}", units.unsigned_abs(), width = places + 1);
    let (whole, rest) = digits.split_at(digits.len() - places);
    let (sign, rest) = (if units < 0 { "-" } else { "" }, rest.trim_end_matches('0'));
    match (whole, rest) {
        (whole, "") => format!("{sign}{whole}"),
        ("0", rest) => format!("{sign}.{rest}"),
        (whole, rest) => format!("{sign}{whole}.{rest}"),
    }
}

/// The `d` of a path.
fn data(path: &Path) -> String {
    let mut d = String::new();
    for segment in &path.segments {
        d.push(match segment {
            Segment::Move(_) => 'M',
            Segment::Line(_) => 'L',
            Segment::Quad(..) => 'Q',
            Segment::Cubic(..) => 'C',
            Segment::Close => 'Z',
        });
        let numbers = segment.points().flat_map(|p| [number(p.x), number(p.y)]);
        for (i, number) in numbers.enumerate() {
            // A sign separates as well as a blank does.
            d.push_str(if i > 0 && !number.starts_with('-') { " " } else { "" });
            d.push_str(&number);
        }
    }
    d
}

fn fill(color: Color) -> String {
    color_of("fill", color)
}

fn color_of(attribute: &str, Color { r, g, b, a }: Color) -> String {
    let opacity = match a {
        255 => String::new(),
        a => format!(" {attribute}-opacity=\"{}\"", decimal((f64::from(a) / 255.0 * 1000.0).round() as i64, 3)),
    };
    format!(" {attribute}=\"#{r:02x}{g:02x}{b:02x}\"{opacity}")
}

/// `text` as it stands in XML and HTML, attributes included.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Source: Fowler, Noll, Vo; 64 bits.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

/// A formula in TeX as an SVG element for a line of text: in ems of that text, in its colour, standing on its baseline. The
/// outlines of its glyphs go to `glyphs`, each once; [`glyph_definitions`] writes them into the page.
pub(super) fn formula(tex: &str, is_display: bool, glyphs: &mut BTreeMap<String, String>) -> Result<String, String> {
    let words = if is_display { Words::default().display_tex(tex) } else { Words::default().tex(tex) };
    let run = Text::new(EM, Color::BLACK).set(&words);
    if let Some(reason) = run.refused {
        return Err(reason);
    }
    let ink = run.ink.ok_or_else(|| format!("the formula {tex}: there is nothing in it"))?.grown(2.0);
    let mut body = Body { text: String::new(), definitions: std::mem::take(glyphs) };
    for same in run.glyphs.chunk_by(|a, b| a.size == b.size && a.glyph.face == b.glyph.face) {
        body.glyphs(same, DVec2::ZERO, DVec2::X);
    }
    for piece in &run.pieces {
        let _ = write!(body.text, "<path d=\"{}\"/>", data(piece));
    }
    *glyphs = body.definitions;
    // As wide as its advance at least, so that what follows keeps its distance.
    let (left, right) = (ink.min.x.min(0.0), ink.max.x.max(run.advance));
    let (width, height) = (right - left, ink.size().y);
    Ok(format!(
        "<svg class=\"formula\" role=\"img\" aria-label=\"{}\" \
         style=\"width:{}em;height:{}em;vertical-align:{}em;overflow:visible\" \
         viewBox=\"{} {} {} {}\" fill=\"currentColor\">{}</svg>",
        escape(tex),
        precise(width / EM),
        precise(height / EM),
        precise(-ink.max.y / EM),
        number(left),
        number(ink.min.y),
        number(width),
        number(height),
        body.text
    ))
}

/// An SVG element that shows nothing and defines glyphs for formulas on the same page.
pub(super) fn glyph_definitions(glyphs: &BTreeMap<String, String>) -> String {
    let all: String = glyphs.iter().map(|(id, what)| what.replacen("ID", id, 1).trim_end().to_owned()).collect();
    format!("<svg style=\"position:absolute;width:0;height:0\" aria-hidden=\"true\"><defs>{all}</defs></svg>")
}

/// The em of a formula's own units.
const EM: f64 = 100.0;
