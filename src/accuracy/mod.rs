//! Floor 7: what accuracy costs in time.
//!
//! [`sets`] draw rays and shapes, easy ones and ones on the edge of a verdict; [`forms`] puts every subject's kernels side
//! by side, [`referee`] knows the exact answers. [`verdicts`] counts who is right, [`timing`] how long it takes, [`maps`]
//! draws where the verdict changes. [`images`] holds a scene's picture against the reference, [`departures`] looks at how
//! its rays leave surfaces. [`leaks`] counts rays that get out of closed meshes, [`spawning`] rays that hit the surface
//! they left; [`surfaces`] runs both for all kernels. [`report`] measures everything, [`charts`], [`export`] and [`page`]
//! show it.

mod bare_scene;
pub mod charts;
pub mod departures;
pub mod export;
pub mod forms;
pub mod images;
pub mod leaks;
pub mod maps;
pub mod page;
pub mod random;
pub mod referee;
pub mod report;
pub mod sets;
pub mod spawning;
pub mod surfaces;
pub mod timing;
pub mod verdicts;
