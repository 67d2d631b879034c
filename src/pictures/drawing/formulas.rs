//! Formulas for a page of text.

use std::collections::BTreeMap;

use super::svg;

/// Formulas of one page as SVG elements that stand in its text: as large as the text, in its colour, on its baseline. They
/// share the outlines of their glyphs.
///
/// # Example
/// ```
/// use raytree::pictures::drawing::Formulas;
/// let mut page = Formulas::default();
/// let formula = page.inline(r"\frac{a}{b}").unwrap();
/// assert!(formula.starts_with("<svg ") && formula.contains("currentColor"));
/// assert!(page.inline(r"\nonsense").is_err());
/// assert!(page.definitions().contains("<path id="));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Formulas {
    glyphs: BTreeMap<String, String>,
}

impl Formulas {
    /// A formula for a line of text: fractions are small.
    ///
    /// # Errors
    /// What is wrong with the TeX, or what of it cannot be drawn.
    pub fn inline(&mut self, tex: &str) -> Result<String, String> {
        svg::formula(tex, false, &mut self.glyphs)
    }

    /// A formula for a line of its own: fractions are large.
    ///
    /// # Errors
    /// Those of [`Formulas::inline`].
    pub fn display(&mut self, tex: &str) -> Result<String, String> {
        svg::formula(tex, true, &mut self.glyphs)
    }

    /// The element with the outlines that the page needs once, anywhere.
    pub fn definitions(&self) -> String {
        svg::glyph_definitions(&self.glyphs)
    }
}
