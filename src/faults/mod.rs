//! Floor 6: the classic faults of ray tracers, each as a variant of a small textbook tracer, and the name of the one that
//! reproduces somebody's tree. Knows nothing of commands.
//!
//! [`Textbook`] is the lecture's recursion in plain f64, written to be read beside a student's program, not beside
//! [`transport`](crate::transport): no exact verdicts, no hierarchy, an epsilon. Without a fault its trees agree with those of
//! the real tracer; with a [`Fault`] one place of it is wrong. [`name_fault`] plants one after the other and looks which gives
//! the tree in question.

mod catalogue;
mod naming;
mod shapes;
mod textbook;

pub use catalogue::Fault;
pub use naming::{Named, name_fault, right_tree};
pub use textbook::Textbook;
