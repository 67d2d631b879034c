//! A difference in words.

use std::fmt::{self, Write};

use super::{Difference, Distance, Divergence, Value, Which};
use crate::input::printable;
use crate::tree::text::six_digits;

/// The most lines for what does not follow from the first divergence, and for rays in which something follows.
const MOST: usize = 12;

impl Difference {
    /// The difference in words: where the trees part first, what else parts by itself, and what follows.
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        match self.first() {
            None => agreement(&mut out, self),
            Some(first) => parting(&mut out, self, first),
        }
        .ok();
        remarks(&mut out, self).ok();
        out
    }
}

fn agreement(out: &mut String, difference: &Difference) -> fmt::Result {
    let rays = difference.rays[0];
    let plural = if rays == 1 { "ray agrees" } else { "rays agree" };
    writeln!(out, "no parting: {rays} {plural}, numbers within {}", difference.tolerances)?;
    if let Some(Divergence { path, field, distance: Some(distance), .. }) = &difference.nearest_agreement {
        writeln!(out, "the largest difference is at {path}, {field}: {}", apart(*distance))?;
    }
    Ok(())
}

fn parting(out: &mut String, difference: &Difference, first: &Divergence) -> fmt::Result {
    writeln!(out, "they part at {}, {}", first.path, place(first))?;
    writeln!(out, "  A  {}", shown(first.a.as_ref()))?;
    writeln!(out, "  B  {}", shown(first.b.as_ref()))?;
    if let Some(distance) = first.distance {
        let tolerance = difference.tolerances.of_field(first.field);
        let allowed = tolerance.allowed(distance.scale);
        writeln!(
            out,
            "  apart by {}; allowed is {allowed:.1e}: {tolerance} to {}",
            apart(distance),
            six_digits(distance.scale)
        )?;
    }
    if let Some(effect) = first.effect {
        writeln!(out, "  what this {} ray brings to the pixel changes by rgb {}", first.kind.name(), vector(&effect))?;
    }
    let [a, b] = difference.colors;
    writeln!(out, "the pixel: rgb {} in A, {} in B", vector(&a), vector(&b))?;

    let rest = &difference.divergences[1..];
    let others: Vec<&Divergence> = rest.iter().filter(|divergence| !divergence.consequence).collect();
    if !others.is_empty() {
        writeln!(out, "\nby themselves part as well:")?;
        for divergence in others.iter().take(MOST) {
            let (a, b) = (shown(divergence.a.as_ref()), shown(divergence.b.as_ref()));
            writeln!(out, "  {}, {}: {a} in A, {b} in B", divergence.path, place(divergence))?;
        }
        more(out, others.len())?;
    }
    let mut rays: Vec<(String, Vec<String>)> = Vec::new();
    for divergence in rest.iter().filter(|divergence| divergence.consequence) {
        let path = divergence.path.to_string();
        match rays.iter_mut().find(|(known, _)| *known == path) {
            Some((_, fields)) => fields.push(place(divergence)),
            None => rays.push((path, vec![place(divergence)])),
        }
    }
    if !rays.is_empty() {
        writeln!(out, "\nwhat follows from that:")?;
        for (path, fields) in rays.iter().take(MOST) {
            writeln!(out, "  {path}: {}", fields.join(", "))?;
        }
        more(out, rays.len())?;
    }
    Ok(())
}

fn more(out: &mut String, count: usize) -> fmt::Result {
    if count > MOST { writeln!(out, "  ... and {} more", count - MOST) } else { Ok(()) }
}

/// What is not comparable, and what else is to be known.
fn remarks(out: &mut String, difference: &Difference) -> fmt::Result {
    for which in [Which::A, Which::B] {
        let of_tree = difference.missing.iter().filter(|missing| missing.tree == which);
        let names: Vec<&str> = of_tree.map(|missing| missing.field.name()).collect();
        if !names.is_empty() {
            writeln!(out, "not in {which:?}: {}", names.join(", "))?;
        }
    }
    difference.notes.iter().try_for_each(|note| writeln!(out, "note: {}", printable(note)))
}

/// The field, and the light that it is of.
fn place(divergence: &Divergence) -> String {
    match &divergence.light {
        Some(light) => format!("{} of \"{}\"", divergence.field, printable(light)),
        None => divergence.field.to_string(),
    }
}

fn shown(value: Option<&Value>) -> String {
    match value {
        None => "not there".to_owned(),
        Some(value) => value.to_string(),
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(x) => write!(f, "{x:?}"),
            Self::Numbers(numbers) => {
                let words: Vec<String> = numbers.iter().map(|x| format!("{x:?}")).collect();
                write!(f, "({})", words.join(", "))
            }
            Self::Place(place) => write!(f, "{place}"),
            Self::Word(word) => f.write_str(&printable(word)),
            Self::Flag(flag) => write!(f, "{flag}"),
        }
    }
}

/// `2.8e-1: 1.3e15 ulp, 2.5e-1 relative`.
fn apart(distance: Distance) -> String {
    let Distance { absolute, ulps, relative, .. } = distance;
    let ulps = if ulps < 1e6 { format!("{}", (10.0 * ulps).round() / 10.0) } else { format!("{ulps:.1e}") };
    format!("{absolute:.3e}: {ulps} ulp, {relative:.1e} relative")
}

fn vector(v: &[f64; 3]) -> String {
    v.map(six_digits).join(" ")
}
