//! Floor 2: reading text that a person wrote, with errors that say where, what, and what would be right.

mod json;
mod nearest;
mod printable;
mod problem;
#[cfg(feature = "schema")]
mod schema;

pub use json::{JsonPath, Located, Named, Segment, name, present, read_json, refuse_arrays_for_objects};
pub use nearest::{nearest, one_of};
pub use printable::printable;
pub use problem::{Place, Problem};
#[cfg(feature = "schema")]
pub use schema::schema_of;
