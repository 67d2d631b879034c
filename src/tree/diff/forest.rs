//! Whole pictures of trees: in how many pixels they part, and in what first.

use std::fmt::{self, Write};

use serde::Serialize;

use super::{Difference, Field, Which};
use crate::tree::Kind;

/// How many pixels part first in the same field of the same kind of ray.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bin {
    /// What the ray is for.
    pub kind: Kind,
    /// What parts.
    pub field: Field,
    /// In how many pixels.
    pub pixels: u64,
    /// Of these the one whose colours are furthest apart, the first of several.
    pub example: [u32; 2],
    /// How far apart they are there, in the component that is furthest.
    pub change: f64,
}

/// Where two forests part: each pixel counts by where its two trees part first.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ForestDifference {
    /// Pixels that both have.
    pub pixels: u64,
    /// Those of them whose trees agree.
    pub same: u64,
    /// Pixels that only A has.
    pub only_in_a: u64,
    /// Pixels that only B has.
    pub only_in_b: u64,
    /// The rest, the most frequent first.
    pub first_divergences: Vec<Bin>,
    /// What one of the trees of a pixel has nowhere, with the number of such pixels.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<super::Missing>,
}

impl ForestDifference {
    /// Counts the difference of the two trees of a pixel.
    pub fn add(&mut self, pixel: [u32; 2], difference: &Difference) {
        self.pixels += 1;
        for missing in &difference.missing {
            match self.missing.iter_mut().find(|known| (known.tree, known.field) == (missing.tree, missing.field)) {
                Some(known) => known.rays += missing.rays,
                None => self.missing.push(missing.clone()),
            }
        }
        let Some(first) = difference.first() else {
            self.same += 1;
            return;
        };
        let [a, b] = difference.colors;
        let change = (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
        let is_same = |bin: &&mut Bin| (bin.kind, bin.field) == (first.kind, first.field);
        match self.first_divergences.iter_mut().find(is_same) {
            Some(bin) => {
                bin.pixels += 1;
                // Whatever the order in which the pixels come.
                let is_earlier = [pixel[1], pixel[0]] < [bin.example[1], bin.example[0]];
                if change > bin.change || change == bin.change && is_earlier {
                    (bin.example, bin.change) = (pixel, change);
                }
            }
            None => self.first_divergences.push(Bin {
                kind: first.kind,
                field: first.field,
                pixels: 1,
                example: pixel,
                change,
            }),
        }
    }

    /// The same with the most frequent bins first, ties by name.
    pub fn sorted(mut self) -> Self {
        self.first_divergences.sort_by_key(|bin| (std::cmp::Reverse(bin.pixels), bin.kind.name(), bin.field));
        self.missing.sort_by_key(|missing| (missing.tree, missing.field));
        self
    }

    /// Whether all pixels agree, and both forests have the same ones.
    pub fn is_same(&self) -> bool {
        self.same == self.pixels && self.only_in_a == 0 && self.only_in_b == 0
    }

    /// The difference as JSON, indented.
    pub fn to_json(&self) -> String {
        crate::tree::layout::to_string(self)
    }

    /// The difference in words, with a bar for each bin.
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        self.write(&mut out).ok();
        out
    }

    fn write(&self, out: &mut String) -> fmt::Result {
        let plural = if self.pixels == 1 { "pixel" } else { "pixels" };
        writeln!(out, "{} {plural}: {} agree, {} part", self.pixels, self.same, self.pixels - self.same)?;
        for (count, which) in [(self.only_in_a, "A"), (self.only_in_b, "B")] {
            if count > 0 {
                writeln!(out, "{count} only in {which}")?;
            }
        }
        if !self.first_divergences.is_empty() {
            writeln!(out, "where they part first:")?;
        }
        let most = self.first_divergences.iter().map(|bin| bin.pixels).max().unwrap_or(1);
        let rows: Vec<(String, &Bin)> =
            self.first_divergences.iter().map(|bin| (format!("{} {}", bin.kind.name(), bin.field), bin)).collect();
        let wide = rows.iter().map(|(words, _)| words.chars().count()).max().unwrap_or(0);
        let digits = most.to_string().len();
        for (words, bin) in rows {
            let bar = "#".repeat((24 * bin.pixels).div_ceil(most) as usize);
            let [x, y] = bin.example;
            let change = format!("{:.2e}", bin.change);
            writeln!(out, "  {words:wide$}  {:>digits$}  {bar:24}  most at {x},{y}: rgb by {change}", bin.pixels)?;
        }
        for which in [Which::A, Which::B] {
            let of_tree = self.missing.iter().filter(|missing| missing.tree == which);
            let names: Vec<&str> = of_tree.map(|missing| missing.field.name()).collect();
            if !names.is_empty() {
                writeln!(out, "not in {which:?}: {}", names.join(", "))?;
            }
        }
        Ok(())
    }
}
