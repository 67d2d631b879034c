//! Charts: functions from plain data to a [`Drawing`](crate::pictures::drawing::Drawing). They do not know what the data are
//! about.

mod frame;
mod histograms;
mod lines;
mod panels;
mod scale;
mod scatter;
mod shares;

pub use crate::pictures::drawing::Color;
pub use frame::{Heading, wrap};
pub use histograms::{Histogram, Histograms, histograms};
pub use lines::{Line, Lines, lines};
pub use panels::{Key, Panel, Panels, Ramp, panels};
pub use scale::{Axis, Ruler, Scale, Tick, plain, power_of_ten};
pub use scatter::{Point, Scatter, scatter};
pub use shares::{Part, ShareRow, Shares, shares};
