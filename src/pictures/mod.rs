//! Floor 6: pictures. Knows nothing of commands.

#[cfg(feature = "pictures")]
mod film;
#[cfg(any(feature = "drawing", feature = "pictures"))]
mod srgb;

#[cfg(feature = "drawing")]
pub mod charts;
#[cfg(feature = "drawing")]
pub mod diagrams;
#[cfg(feature = "drawing")]
pub mod drawing;
#[cfg(all(feature = "drawing", feature = "pictures"))]
pub mod sheet;
#[cfg(feature = "drawing")]
pub mod theme;

#[cfg(feature = "pictures")]
pub use film::{Film, Format, render};
#[cfg(feature = "pictures")]
pub use srgb::srgb8;
