//! Lessons 06 to 10: the picture that the student's procedures make, beside the right one.

use glam::DVec2;

use super::{Answer, Page, Shown};
use crate::lessons::program::Pixel;
use crate::pictures::drawing::{Align, Color, Drawing, Level, Path, Pen, Raster, Rect, Sampling, Text};
use crate::pictures::srgb8;
use crate::pictures::theme::Hue;
use crate::scene::Rgb;

/// Pixels in a row of both pictures.
const WIDTH: u32 = 160;
/// The most rays of the student's picture: one of a recursion without an end is left unfinished.
const MOST_RAYS: u64 = 400_000;
/// Between the pictures, and above each for its name.
const GAP: f64 = 14.0;
const NAME: f64 = 22.0;

/// The scene as it is, as the student's procedures see it, and where the two differ; the pixel of the case is marked.
pub fn renders(pixel: &Pixel, what: &Shown, student: &dyn Fn(&Pixel) -> Option<Answer>) -> Drawing {
    let (film, pixels, [x, y]) = pixel.picture(WIDTH);
    let right: Vec<Color> = film.pixels.iter().map(|color| light(*color)).collect();
    let own = rendered(&pixels, student);
    let differ: Vec<bool> = right.iter().zip(&own).map(|(right, own)| right != own).collect();
    let count = differ.iter().filter(|differs| **differs).count();
    let about = match (own.len(), count) {
        (0, _) => "The picture that there should be.".to_owned(),
        (of, 0) if what.wrong().is_some() && of == right.len() => "No colour differs; the rays do.".to_owned(),
        (_, 0) => "The picture that your functions make.".to_owned(),
        (of, _) => format!("Of {of} pixels {count} differ."),
    };
    let mut page = Page::new(what, &format!("{about} The ring is around the pixel of the case."));
    let theme = page.theme;
    let size = DVec2::new(f64::from(film.size.width), f64::from(film.size.height));
    // One picture where there is nothing to compare.
    let is_right = count == 0 && own.len() == right.len();
    let room = (page.room.size() - GAP) / if is_right { 1.0 } else { 2.0 } - DVec2::new(0.0, NAME);
    let scale = (room / size).min_element();
    let center = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
    let mut show = |column: f64, row: f64, name: &str, colors: &dyn Fn(usize) -> Color| {
        let corner =
            page.room.min + DVec2::new(column, row) * (size * scale + DVec2::new(GAP, GAP + NAME)) + DVec2::Y * NAME;
        let rect = Rect::new(corner, size * scale);
        let raster =
            Raster::from_fn(film.size.width, film.size.height, |x, y| colors((y * film.size.width + x) as usize));
        page.drawing.image(raster, rect, Sampling::Nearest);
        page.drawing.stroke(Path::rect(rect), Pen::new(theme.axis, 1.0));
        let text = Text::new(12.5, theme.muted).anchor(Align::Start, Level::Middle);
        page.drawing.text(corner - DVec2::Y * NAME / 2.0, name, text);
        for (color, width) in [(theme.background, 3.4), (theme.ink, 1.4)] {
            page.drawing.stroke(Path::circle(corner + scale * center, 6.0), Pen::new(color, width));
        }
    };
    let color = |colors: &[Color], i: usize| colors.get(i).copied().unwrap_or(theme.grid);
    show(0.0, 0.0, if is_right { "true, and yours" } else { "true" }, &|i| color(&right, i));
    if !own.is_empty() && !is_right {
        show(1.0, 0.0, "yours", &|i| color(&own, i));
    }
    if count > 0 {
        let [same, other] = [theme.grid, theme.hue(Hue::Vermilion)];
        show(1.0, 1.0, "where they differ", &|i| if differ.get(i) == Some(&true) { other } else { same });
    }
    page.drawing
}

/// The colours that the student's procedures give, up to the first pixel where they give none.
fn rendered(pixels: &[Pixel], student: &dyn Fn(&Pixel) -> Option<Answer>) -> Vec<Color> {
    let mut rays = 0;
    let mut color = |pixel: &Pixel| match student(pixel)? {
        Answer::Tree(tree) if rays < MOST_RAYS => {
            rays += tree.rays;
            Some(light(tree.color.into()))
        }
        _ => None,
    };
    pixels.iter().map_while(&mut color).collect()
}

/// Linear light as it is seen.
fn light(rgb: Rgb) -> Color {
    let [r, g, b] = rgb.to_array().map(srgb8);
    Color { r, g, b, a: 255 }
}
