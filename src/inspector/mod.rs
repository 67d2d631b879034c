//! Floor 7: the step-through page, served on the loopback address or written as one file. Prints nothing.
//!
//! [`Inspector`] holds a scene and the variants of it that a page tries out; [`serve`] answers for it, and
//! [`Inspector::export`] puts what it would answer for some pixels into the page itself. Everything that a request can reach is
//! in memory: the page's files, which are compiled in, the scene, and the meshes that it loaded.
//!
//! What a client may ask for, and what it gets, is in `routes.rs`; whom the server talks to at all in `guard.rs`; how much
//! work goes on at a time, and how it ends when the client goes, in `work.rs`; the data of an exported page in `export.rs`.

mod ahead;
mod answer;
mod assets;
mod bands;
mod bundle;
mod description;
mod diagram;
mod export;
mod geometry;
mod guard;
mod patience;
mod query;
mod recording;
mod routes;
mod scenes;
mod server;
mod tracing;
mod work;

pub use diagram::PANE;
pub use export::Kept;
pub use scenes::{Inspector, Settings};
pub use server::{Limits, serve};
