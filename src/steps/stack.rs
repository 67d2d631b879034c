//! The call stack with its variables: a fold over the steps.

use serde::Serialize;

use super::{Procedure, Recording};

/// A procedure that is being carried out.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Which.
    pub procedure: Procedure,
    /// The node that it was entered for, by its place in [`Recording::nodes`].
    pub node: usize,
    /// Its variables, in the order in which they were first assigned.
    pub variables: Vec<(&'static str, Variable)>,
}

/// The value of a variable.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Variable {
    /// A whole number.
    Integer(u64),
    /// A number.
    Number(f64),
    /// A point, a direction or a colour.
    Vector([f64; 3]),
    /// A name, or `none`.
    Text(String),
    /// A ray.
    Ray {
        /// Where it starts.
        origin: [f64; 3],
        /// Where it goes.
        direction: [f64; 3],
        /// Where it ends, if it does.
        #[serde(skip_serializing_if = "Option::is_none")]
        t_max: Option<f64>,
    },
    /// A hit.
    Hit {
        /// Ray parameter.
        t: f64,
        /// The object's name.
        #[serde(skip_serializing_if = "Option::is_none")]
        object: Option<String>,
        /// The object's place in the scene.
        shape: u32,
        /// The triangle of a mesh, the face of a box.
        #[serde(skip_serializing_if = "Option::is_none")]
        primitive: Option<u32>,
    },
}

impl Recording<'_> {
    /// The call stack at a step, the outermost frame first: what the steps up to and with this one have made of it.
    pub fn stack(&self, step: usize) -> Vec<Frame> {
        let mut stack: Vec<Frame> = Vec::new();
        let mut leaves = false;
        for step in self.steps.iter().take(step + 1) {
            // The frame that a step leaves is still there at that step.
            if leaves {
                stack.pop();
            }
            leaves = step.returns;
            if let Some(procedure) = step.call {
                stack.push(Frame { procedure, node: step.node, variables: Vec::new() });
            }
            if let Some(frame) = stack.last_mut() {
                for (name, value) in &step.set {
                    match frame.variables.iter_mut().find(|(known, _)| known == name) {
                        Some((_, old)) => *old = value.clone(),
                        None => frame.variables.push((name, value.clone())),
                    }
                }
            }
        }
        stack
    }

    /// How many frames there are at each step.
    pub fn depths(&self) -> Vec<usize> {
        let mut depth = 0;
        let at = |step: &super::Step| {
            depth += usize::from(step.call.is_some());
            let here = depth;
            depth -= usize::from(step.returns);
            here
        };
        self.steps.iter().map(at).collect()
    }
}
