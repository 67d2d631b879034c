//! Floor 6: pictures. Knows nothing of commands.

mod film;

pub use film::{Film, Format, render};
