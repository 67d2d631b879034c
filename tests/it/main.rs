//! The one integration-test binary: a module a subject.
#![allow(clippy::duplicate_mod, reason = "an exercise and its solution each bring the check that they share")]

mod accuracy;
mod bad_input;
mod bits;
mod commands;
mod diagrams;
mod diff;
mod drawing;
mod effects;
mod faults;
mod first_hit;
mod fuzz;
mod grade;
mod hard_rows;
mod inspector;
mod kernels;
mod ledger;
mod lessons;
mod media;
mod mesh;
mod pages;
mod questions;
mod recursion;
mod schemas;
mod stepper;
mod steps;
mod support;
mod tidiness;
mod trees;
mod users_snapshot;
