//! Moves in a recording: into, over, out, back, to the start, to the end, until an event.

use super::{Event, Recording};

/// A place in a recording, and the moves from there.
///
/// A move that leads nowhere stays, and says so.
#[derive(Clone, Debug)]
pub struct Player<'r> {
    recording: &'r Recording<'r>,
    depths: Vec<usize>,
    at: usize,
}

impl<'r> Player<'r> {
    /// At the first step.
    pub fn new(recording: &'r Recording<'r>) -> Self {
        Self { recording, depths: recording.depths(), at: 0 }
    }

    /// The step's place in [`Recording::steps`].
    pub fn at(&self) -> usize {
        self.at
    }

    /// How many frames there are at the step.
    pub fn depth(&self) -> usize {
        self.depths[self.at]
    }

    /// To a step, or to the last one if there are fewer.
    pub fn to(&mut self, step: usize) -> bool {
        let to = step.min(self.last());
        let moves = to != self.at;
        self.at = to;
        moves
    }

    /// The next step.
    pub fn step_into(&mut self) -> bool {
        self.to(self.at + 1)
    }

    /// The step before.
    pub fn step_back(&mut self) -> bool {
        self.to(self.at.saturating_sub(1))
    }

    /// The next step that is no deeper: what is called here is carried out.
    pub fn step_over(&mut self) -> bool {
        let depth = self.depth();
        self.forward(|depths, i| depths[i] <= depth)
    }

    /// The first step after the current frame has been left.
    pub fn step_out(&mut self) -> bool {
        let depth = self.depth();
        self.forward(|depths, i| depths[i] < depth)
    }

    /// The first step.
    pub fn start(&mut self) -> bool {
        self.to(0)
    }

    /// The last step.
    pub fn end(&mut self) -> bool {
        self.to(self.last())
    }

    /// The next step at which the event holds.
    pub fn until(&mut self, event: &Event) -> bool {
        let recording = self.recording;
        self.forward(|_, i| event.holds(recording, i))
    }

    fn last(&self) -> usize {
        self.depths.len().saturating_sub(1)
    }

    fn forward(&mut self, is_there: impl Fn(&[usize], usize) -> bool) -> bool {
        let found = (self.at + 1..self.depths.len()).find(|&i| is_there(&self.depths, i));
        found.is_some_and(|step| self.to(step))
    }
}
