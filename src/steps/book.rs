//! The formulas that a recording uses, each once, and how the ray was traced that they belong to.

use super::arithmetic::{Arithmetic, Form, Formula, Values, value_of};
use super::tested::is_same;
use crate::numbers::Precision;
use crate::scene::{Numerics, Scene};
use crate::tree::{LeavingPolicy, RayTree, Value};

/// How a tree was traced, as far as formulas depend on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting {
    /// The precision in which rays and shapes are stored.
    pub(super) rays: Precision,
    /// The precision in which the kernels' values are worked out.
    pub(super) kernels: Precision,
    pub(super) numerics: Numerics,
    /// Whether a ray knows the surface that it left.
    pub(super) by_identity: bool,
    /// Whether the hit point is moved onto its surface with a bound on its error.
    pub(super) by_error_bound: bool,
}

impl Setting {
    pub(super) fn of(tree: &RayTree) -> Self {
        let settings = tree.settings.as_ref();
        let numerics = settings.and_then(|s| s.numerics).unwrap_or_default();
        let rays = settings.and_then(|s| s.precision).unwrap_or(Precision::F64);
        let leaving = settings.and_then(|s| s.leaving).unwrap_or(LeavingPolicy::of(numerics));
        Self {
            rays,
            kernels: if numerics == Numerics::Certified { Precision::F64 } else { rays },
            numerics,
            by_identity: leaving == LeavingPolicy::Provenance,
            by_error_bound: leaving == LeavingPolicy::ErrorBound,
        }
    }
}

/// The formulas used so far.
pub(super) struct Book<'a> {
    pub(super) scene: &'a Scene,
    pub(super) setting: Setting,
    pub(super) forms: Vec<Form>,
    formulas: Vec<Formula>,
    /// The values of the node at hand.
    pub(super) shared: Values,
}

impl<'a> Book<'a> {
    pub(super) fn new(scene: &'a Scene, setting: Setting) -> Self {
        Self { scene, setting, forms: Vec::new(), formulas: Vec::new(), shared: Values::new() }
    }

    /// Works a formula out, not beyond the line `last`. Nothing where it does not give what is `wanted` to the same bits:
    /// then it is not how the number came about.
    pub(super) fn work<'w>(
        &mut self,
        formula: Formula,
        inputs: Values,
        last: Option<&str>,
        wanted: impl IntoIterator<Item = (&'w str, Value)>,
    ) -> Option<Arithmetic> {
        let place = self.formulas.iter().position(|known| *known == formula);
        let new = if place.is_none() { Some(formula.form(self.setting)) } else { None };
        let form = match (&new, place) {
            (Some(form), _) => form,
            (None, place) => self.forms.get(place?)?,
        };
        let shared = &self.shared;
        let results = form.evaluate(last, &|name| value_of(&inputs, name).or_else(|| value_of(shared, name)));
        let is_wanted =
            |(name, value): (&str, Value)| value_of(&results, name).is_none_or(|result| is_same(result, value));
        if results.is_empty() || !wanted.into_iter().all(is_wanted) {
            return None;
        }
        let mut values = inputs;
        values.extend(results.into_iter().filter(|(name, _)| value_of(shared, name).is_none()));
        let form = place.unwrap_or(self.forms.len());
        if let Some(new) = new {
            self.forms.push(new);
            self.formulas.push(formula);
        }
        Some(Arithmetic { form, values, note: None })
    }
}
