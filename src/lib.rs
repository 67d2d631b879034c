//! A step-through Whitted ray tracer that keeps the tree of every ray it shoots.
//!
//! Start with [`scene::load`], which reads a scene, and [`transport::Tracer`], which traces it; [`tree::record_pixel`] gives the
//! tree of a pixel, and [`tree::RayTree::new`] makes one of what another renderer did.
//!
//! ```
//! use raytree::transport::{Options, Tracer};
//! use raytree::tree::{Keep, Ledger, Origin, Show, record_pixel};
//!
//! let text = include_str!("../scenes/first-hit.json");
//! let loaded = raytree::scene::load("first-hit.json", text, &mut |_| Err("no mesh is needed".into()))?;
//! let tracer = Tracer::<f64>::new(&loaded.scene, Options::of(&loaded.scene)).expect("f64 holds every scene");
//! let tree = record_pixel(&tracer, Origin { loaded: &loaded, keep: Keep::Outcomes }, 160, 120);
//! println!("{}", tree.to_text(Show::default()));
//! assert!(Ledger::of(&tree).balances());
//! # Ok::<(), raytree::input::Problem>(())
//! ```
//!
//! The modules are floors: each imports from those before it in the order [`numbers`], [`kernels`], [`input`], [`scene`],
//! [`hits`], [`transport`], [`tree`], [`steps`], [`faults`], `pictures`, `accuracy`, `inspector`, `lessons`, `commands`.
//! `ARCHITECTURE.md` has the map.

pub mod numbers;

pub mod kernels;

pub mod input;
pub mod scene;

pub mod hits;

pub mod transport;

pub mod tree;

pub mod steps;

pub mod faults;

#[cfg(any(feature = "pictures", feature = "drawing"))]
pub mod pictures;

#[cfg(feature = "accuracy")]
pub mod accuracy;
#[cfg(feature = "cli")]
pub mod commands;
#[cfg(feature = "inspector")]
pub mod inspector;
#[cfg(feature = "lessons")]
pub mod lessons;
