//! Floor 7: the step-through page, served on the loopback address or written as one file. Prints nothing.
//!
//! [`Inspector`] holds a scene and the variants of it that a page tries out; [`serve`] answers for it. Everything a
//! request can reach is in memory: the page's files ([`assets`](mod@self) are compiled in), the scene and the meshes it loaded.
//!
//! What a client may ask for, and what it gets, is in `routes.rs`; whom the server talks to at all in `guard.rs`; how much
//! work goes on at a time, and how it ends when the client goes, in `work.rs`.

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

pub use export::Kept;
pub use scenes::{Inspector, Settings};
pub use server::{Limits, serve};
