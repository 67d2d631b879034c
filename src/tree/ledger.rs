//! The ledger: which node brought how much of a pixel's colour.

use std::fmt;

use super::{Kind, Outcome, RayNode, RayTree};
use crate::input::printable;

/// One term of one node, times the node's weight.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Entry {
    /// The way from the root: `root.reflected.refracted`.
    pub path: String,
    /// What the term is: `ambient`, `diffuse of sun`, `specular of sun`, `background`.
    pub term: String,
    /// The node's object, where it hit one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub object: Option<String>,
    /// Linear RGB that it adds to the pixel.
    pub share: [f64; 3],
}

/// All terms of a tree, in the order in which its rays were traced.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Ledger {
    /// The terms; those that are zero in all colours are left out.
    pub entries: Vec<Entry>,
    /// Their sum.
    pub sum: [f64; 3],
    /// The tree's colour.
    pub color: [f64; 3],
    /// How far the two may be apart: `1e-12 * max(1, sum of |share|)`, the sum over the largest components.
    ///
    /// Each share takes at most 64 products for its weight and a few for its term, each exact to 2^-53, and the
    /// recursion adds the shares up in another order: below 2^-45 of the sum of magnitudes for any tree of up to 2^20
    /// rays whose shares do not grow with depth. 1e-12 is above 2^-40.
    pub bound: f64,
}

impl Ledger {
    /// The ledger of a tree.
    pub fn of(tree: &RayTree) -> Self {
        let mut entries = Vec::new();
        let mut open = vec![("root".to_owned(), &tree.root)];
        while let Some((path, node)) = open.pop() {
            enter(&path, node, &mut entries);
            // Last in, first out: the refracted ray goes in first.
            for (name, child) in [("refracted", &node.refracted), ("reflected", &node.reflected)] {
                if let Some(child) = child {
                    open.push((format!("{path}.{name}"), child));
                }
            }
        }
        let (mut sum, mut magnitude) = ([0.0; 3], 0.0);
        for entry in &entries {
            for k in 0..3 {
                sum[k] += entry.share[k];
            }
            magnitude += entry.share.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        }
        Self { entries, sum, color: tree.color, bound: 1e-12 * magnitude.max(1.0) }
    }

    /// The ledger as JSON, indented.
    pub fn to_json(&self) -> String {
        super::layout::to_string(self)
    }

    /// The largest difference between the sum and the tree's colour.
    pub fn difference(&self) -> f64 {
        (0..3).map(|k| (self.sum[k] - self.color[k]).abs()).fold(0.0, f64::max)
    }

    /// Whether the tree adds up.
    pub fn balances(&self) -> bool {
        self.difference() <= self.bound
    }
}

fn enter(path: &str, node: &RayNode, entries: &mut Vec<Entry>) {
    let Some(weight) = node.weight else { return };
    let object = node.hit.as_ref().and_then(|hit| hit.object.clone());
    let mut add = |term: String, value: [f64; 3]| {
        let share: [f64; 3] = std::array::from_fn(|k| weight[k] * value[k]);
        if share == [0.0; 3] {
            return;
        }
        entries.push(Entry { path: path.to_owned(), term, object: object.clone(), share });
    };
    if let Some(local) = &node.local {
        add("ambient".to_owned(), local.ambient);
        for light in &local.lights {
            add(format!("diffuse of {}", light.light), light.diffuse);
            add(format!("specular of {}", light.light), light.specular);
        }
    }
    if let (Outcome::Background, Some(radiance)) = (node.outcome, node.radiance)
        && node.kind != Kind::Shadow
    {
        add("background".to_owned(), radiance);
    }
}

impl fmt::Display for Ledger {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows: Vec<[String; 3]> = self
            .entries
            .iter()
            .map(|e| {
                let object = e.object.as_deref().map_or("-".into(), printable);
                [e.path.clone(), object.into_owned(), printable(&e.term).into_owned()]
            })
            .collect();
        let width = |column: usize, least: usize| {
            rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0).max(least)
        };
        let (path, object, term) = (width(0, 4), width(1, 6), width(2, 4));
        writeln!(
            f,
            "{:path$}  {:object$}  {:term$}  {:>12} {:>12} {:>12}",
            "node", "object", "term", "red", "green", "blue"
        )?;
        for (row, entry) in rows.iter().zip(&self.entries) {
            write!(f, "{:path$}  {:object$}  {:term$} ", row[0], row[1], row[2])?;
            line(f, entry.share)?;
        }
        let wide = path + object + term + 4;
        write!(f, "{:wide$} ", "sum of the entries")?;
        line(f, self.sum)?;
        write!(f, "{:wide$} ", "color of the tree")?;
        line(f, self.color)?;
        let verdict = if self.balances() { "balances" } else { "DOES NOT BALANCE" };
        writeln!(f, "{verdict}: they differ by {:.1e}, at most {:.1e} is allowed", self.difference(), self.bound)
    }
}

fn line(f: &mut fmt::Formatter<'_>, rgb: [f64; 3]) -> fmt::Result {
    writeln!(f, " {:>12.8} {:>12.8} {:>12.8}", rgb[0], rgb[1], rgb[2])
}
