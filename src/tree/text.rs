//! A tree as text, one line a ray.

use std::fmt::Write;

use super::steps::{TestRecord, Value, Verdict};
use crate::input::printable;
use crate::numbers::{Certificate, Stage};

use super::{Outcome, RayNode, RayTree};

/// What a text shows besides the rays.
#[derive(Clone, Copy, Debug, Default)]
pub struct Show<'a> {
    /// The pixel's name.
    pub name: Option<&'a str>,
    /// The stage that decided each verdict, and its margin.
    pub certificates: bool,
}

impl RayTree {
    /// The tree as text: a line for the pixel, then a line a ray, children below their parent, and below each ray the
    /// tests it took where the tree has them. Numbers are rounded to six significant digits.
    pub fn to_text(&self, show: Show<'_>) -> String {
        let mut out = String::new();
        let mut head = match self.pixel {
            Some([x, y]) => format!("pixel {x},{y}"),
            None => "ray".to_owned(),
        };
        if let Some(name) = show.name {
            write!(head, "  \"{}\"", printable(name)).ok();
        }
        let plural = if self.rays == 1 { "" } else { "s" };
        writeln!(out, "{head}   rgb {}   {} ray{plural}", vector(self.color), self.rays).ok();

        // The graphics of a ray's own line, and of the lines below it.
        let mut open = vec![(&self.root, String::new(), String::new())];
        while let Some((node, own, below)) = open.pop() {
            writeln!(out, "{}", line(node, &own, show).trim_end()).ok();
            let children: Vec<&RayNode> = node.children().collect();
            for test in node.tests.iter().flatten() {
                let bar = if children.is_empty() { "  " } else { "| " };
                writeln!(out, "{below}{bar}  {}", test_line(test)).ok();
            }
            for (i, child) in children.iter().enumerate().rev() {
                let last = i + 1 == children.len();
                let (own, rest) = if last { ("`- ", "   ") } else { ("|- ", "|  ") };
                open.push((child, format!("{below}{own}"), format!("{below}{rest}")));
            }
        }
        out
    }
}

fn line(node: &RayNode, graphics: &str, show: Show<'_>) -> String {
    let kind = node.kind.name();
    let what = match (&node.light, node.weight) {
        (Some(light), _) => format!("-> {}", printable(light)),
        (None, Some(w)) if w[0] == w[1] && w[1] == w[2] => format!("depth {}  w {}", node.depth, six_digits(w[0])),
        (None, Some(w)) => format!("depth {}  w ({})", node.depth, vector(w)),
        (None, None) => format!("depth {}", node.depth),
    };
    let mut line = format!("{graphics}{kind:<9} {what}");
    let gap = 36_usize.saturating_sub(line.chars().count()).max(2);
    line.extend(std::iter::repeat_n(' ', gap));
    match (&node.hit, node.outcome) {
        (Some(hit), outcome) => {
            let word = if outcome == Outcome::Blocked { "blocked by" } else { "hit" };
            write!(line, "{word}{}", place(hit.object.as_deref(), hit.shape)).ok();
            match (hit.primitive, hit.barycentrics) {
                (Some(face @ 0..6), None) => write!(line, " {}", FACES[face as usize]).ok(),
                (Some(primitive), _) => write!(line, " #{primitive}").ok(),
                (None, _) => None,
            };
            write!(line, " t {}", six_digits(hit.t)).ok();
            if let (Some(abc), Outcome::Hit) = (hit.barycentrics, outcome) {
                write!(line, "  abc ({})", vector(abc)).ok();
            }
            if outcome == Outcome::Hit {
                write!(line, "  n ({})", vector(hit.shading_normal.unwrap_or(hit.geometric_normal))).ok();
                if let Some([incident, transmitted]) = hit.ior
                    && (node.refracted.is_some() || node.total_reflection || node.fresnel.is_some())
                {
                    write!(line, "  {}|{}", six_digits(incident), six_digits(transmitted)).ok();
                }
            }
            if let Some(fresnel) = node.fresnel {
                write!(line, "  R {}", six_digits(fresnel)).ok();
            }
            if node.total_reflection {
                line.push_str("  total reflection");
            }
        }
        (None, Outcome::Hit) => line.push_str("hit"),
        (None, Outcome::Blocked) => line.push_str("blocked"),
        (None, Outcome::Lit) => line.push_str("lit"),
        (None, Outcome::Background) => {
            write!(line, "background {}", node.radiance.map(vector).unwrap_or_default()).ok();
        }
        (None, Outcome::MaxDepth) => line.push_str("not traced: max_depth"),
        (None, Outcome::BelowMinWeight) => line.push_str("not traced: below min_weight"),
        (None, Outcome::RayBudget) => line.push_str("not traced: ray budget spent"),
    }
    if show.certificates {
        for (what, certificate) in [("", &node.certificate), ("Snell: ", &node.refraction_certificate)] {
            if let Some(Certificate { stage, margin }) = certificate {
                write!(line, "  [{what}{}, margin {}]", stage_name(*stage), six_digits(*margin)).ok();
            }
        }
    }
    line
}

fn stage_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Filter => "filter",
        Stage::Integer => "integer",
        Stage::DoubleDouble => "double-double",
        Stage::Expansion => "expansion",
    }
}

/// The faces of a box, by primitive.
const FACES: [&str; 6] = ["-x", "+x", "-y", "+y", "-z", "+z"];

fn place(object: Option<&str>, shape: u32) -> String {
    match object {
        Some(object) => format!(" \"{}\"", printable(object)),
        None => format!(" shape {shape}"),
    }
}

fn test_line(test: &TestRecord) -> String {
    let mut line = String::new();
    let (verdict, reason) = match test {
        TestRecord::Bounds(test) => {
            line.push_str("box of");
            if let Some(node) = test.node {
                write!(line, " {}node {node}", if test.in_mesh { "mesh " } else { "" }).ok();
            }
            if let Some(shape) = test.shape {
                line.push_str(&place(test.object.as_deref(), shape));
            }
            if let Some(primitive) = test.primitive {
                write!(line, " #{primitive}").ok();
            }
            for (name, t) in [("t_in", test.t_in), ("t_out", test.t_out)] {
                if let Some(t) = t {
                    write!(line, "  {name} {}", six_digits(t)).ok();
                }
            }
            if test.reason.as_deref() == Some("pruned by its box") {
                return line + "  rejected: t_in > t_out, what is inside is pruned by its box";
            }
            (test.verdict, &test.reason)
        }
        TestRecord::Shape(test) => {
            line.push_str("test");
            line.push_str(&place(test.object.as_deref(), test.shape));
            if let Some(primitive) = test.primitive {
                write!(line, " #{primitive}").ok();
            }
            for (name, value) in &test.values.0 {
                match value {
                    Value::Number(x) => write!(line, "  {} {}", printable(name), six_digits(*x)).ok(),
                    Value::Vector(v) => write!(line, "  {} ({})", printable(name), vector(*v)).ok(),
                };
            }
            if let Some(t) = test.t {
                write!(line, "  => t {}", six_digits(t)).ok();
            }
            (test.verdict, &test.reason)
        }
    };
    let verdict = match verdict {
        Verdict::Entered => "entered",
        Verdict::Best => "best so far",
        Verdict::Rejected => "rejected",
    };
    write!(line, "  {verdict}").ok();
    if let Some(reason) = reason {
        write!(line, ": {}", printable(reason)).ok();
    }
    line
}

fn vector(v: [f64; 3]) -> String {
    v.map(six_digits).join(" ")
}

/// Six significant digits, without trailing zeros.
pub(crate) fn six_digits(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{x:.5e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or_default();
    let trim = |digits: &str| match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits.to_owned(),
    };
    if (-5..9).contains(&exponent) {
        return trim(&format!("{x:.*}", (5 - exponent).max(0) as usize));
    }
    format!("{}e{exponent}", trim(mantissa))
}
