//! Comparing ray trees: where they part first, what follows, and how far apart is too far.

mod command;
mod languages;
mod page;
mod trees;
