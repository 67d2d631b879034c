//! Floor 4: light transport. Knows nothing of JSON, files, printing.
//!
//! `Tracer::trace` and `Tracer::shade`, in `trace.rs`, are the lecture's Trace and Shade; a [`Recorder`] folds every
//! finished ray and its finished children into a node, or vanishes.

mod bounce;
mod direct;
mod leaving;
mod media;
mod recorder;
mod secondary;
mod surface;
mod trace;

pub use bounce::{Bounce, Flight};
pub use direct::ShadowRay;
pub use leaving::{Leaving, LeavingPolicy, spawn};
pub use media::Inside;
pub use recorder::{Children, Kind, LightTerm, Local, Off, Outcome, Recorder, Secondary, Visit};
pub use secondary::{Split, Way};
pub use surface::{Side, Surface};
pub use trace::{Options, Tracer, Unfit};
