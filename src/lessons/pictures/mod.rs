//! The pictures of lessons: the right answer and the student's in one diagram.
//!
//! Each function takes what the case is about and a [`Shown`], and draws on a canvas that is laid out in `page.rs`: the
//! diagram at the left, what is given and what was answered at the right. The true answer is green and solid, the
//! student's red and dashed.

mod camera;
mod choices;
mod hierarchy;
mod page;
mod plane;
mod render;
mod rounding;
mod slabs;
mod sphere;
mod surface;
mod triangle;
mod vectors;
mod view;

use super::answer::Answer;

use page::Page;

pub use camera::{field_of_view, image_plane, pixel_grid};
pub use choices::{bars, cost_and_error, crossing};
pub use hierarchy::{box_area, box_around, counted, nested_boxes, two_groups, two_halves, visited_boxes};
pub use plane::{plane_from, plane_hit, signed_distance};
pub use render::renders;
pub use rounding::{Meanings, Tile, map, small_root};
pub use slabs::{box_span, rectangle_span, slab};
pub use sphere::{parabola, sphere_hit, sphere_normal};
pub use surface::{at_surface, towards_light};
pub use triangle::{inside_tests, triangle_hit, triangle_plane, triangle_weights};
pub use vectors::{cross_product, length, normal_vector, projection};

/// What a picture shows beside its diagram.
#[derive(Clone, Debug)]
pub struct Shown {
    /// What the stage is about.
    pub title: String,
    /// The function.
    pub function: String,
    /// The name of the case.
    pub case: String,
    /// What is given, a line for each part.
    pub given: Vec<String>,
    /// The right answer.
    pub expected: Answer,
    /// The student's; nothing where there is none.
    pub got: Option<Answer>,
    /// The mistake, where it is a known one.
    pub mistake: Option<String>,
}

impl Shown {
    /// The student's answer, where it differs from the right one.
    fn wrong(&self) -> Option<&Answer> {
        self.got.as_ref().filter(|got| !got.agrees(&self.expected))
    }
}
