//! The lecture's Intersect: every test that a ray took.

use super::super::pseudocode::Line;
use super::super::tested::look;
use super::super::{Mark, Picture, Procedure, Question, Variable};
use super::{Unroll, none};
use crate::tree::{Kind, Outcome, RayNode, TestRecord, Value, Verdict, six_digits};

use Value::{Number, Vector};

impl<'a> Unroll<'a> {
    /// The lecture's Intersect: every test that the ray took.
    pub(super) fn intersect(&mut self, node: &'a RayNode) {
        let place = self.place(node);
        let ray = Variable::Ray { origin: node.origin, direction: node.direction, t_max: node.t_max };
        let header = self.step(Line::Intersect, place).calls(Procedure::Intersect).shows("section");
        header.sets("ray", ray).sets("best", none());
        self.book.shared.clone_from(&self.nodes[place].values);
        let parent = self.nodes[place].parent.map(|parent| self.nodes[parent].ray);
        for (i, test) in node.tests.iter().flatten().enumerate() {
            let tested = look(&mut self.book, node, parent, test);
            let values = tested.arithmetic.as_ref().map_or(&[][..], |arithmetic| &arithmetic.values);
            let is_nan = values.iter().any(|(_, value)| match value {
                Number(x) => x.is_nan(),
                Vector(x) => x.iter().any(|x| x.is_nan()),
            });
            let question = Question::of_test(test);
            let (line, shape, primitive) = match test {
                TestRecord::Bounds(test) => (Line::IntersectBounds, test.shape, test.primitive),
                TestRecord::Shape(test) => (Line::IntersectShape, Some(test.shape), test.primitive),
            };
            let step = self.step(line, place);
            step.test = Some(i);
            step.arithmetic = tested.arithmetic;
            step.finding = Some(tested.finding);
            step.diagram = Some(match tested.diagram {
                Some(kind) => Picture { kind, node: None, shape, primitive },
                None => Picture { kind: "section", node: None, shape: None, primitive: None },
            });
            step.question = question;
            step.marks(Mark::Exact, tested.is_exact).marks(Mark::NotANumber, is_nan);
            if let TestRecord::Shape(test) = test
                && let (Verdict::Best, Some(t)) = (test.verdict, test.t)
            {
                let (object, shape, primitive) = (test.object.clone(), test.shape, test.primitive);
                step.sets("best", Variable::Hit { t, object, shape, primitive });
            }
        }
        let is_shadow = node.kind == Kind::Shadow;
        let words = match (&node.hit, is_shadow) {
            (Some(hit), false) => format!("{} is the nearest hit, at t = {}", self.object(hit), six_digits(hit.t)),
            (Some(hit), true) => format!("{} stands in the way, at t = {}", self.object(hit), six_digits(hit.t)),
            (None, false) => "nothing is hit".to_owned(),
            (None, true) => "nothing stands in the way".to_owned(),
        };
        let question = (!is_shadow).then(|| self.what_is_hit(node)).flatten();
        let step = self.step(Line::IntersectReturn, place).finds(node.hit.is_some(), words).returning();
        step.marks(Mark::Hit, node.outcome == Outcome::Hit).marks(Mark::Blocked, node.outcome == Outcome::Blocked);
        step.question = question;
        step.shows("section");
    }

    /// What does the ray hit? The objects that were tested, four at most, and nothing.
    fn what_is_hit(&self, node: &RayNode) -> Option<Question> {
        let mut names: Vec<String> = Vec::new();
        let hit = node.hit.as_ref().and_then(|hit| hit.object.clone());
        let tested = node.tests.iter().flatten().filter_map(|test| match test {
            TestRecord::Bounds(test) => test.object.clone(),
            TestRecord::Shape(test) => test.object.clone(),
        });
        for name in hit.iter().cloned().chain(tested) {
            if names.len() < 4 && !names.contains(&name) {
                names.push(name);
            }
        }
        if names.is_empty() {
            return None;
        }
        // In the order of the scene, so that the place says nothing.
        names.sort_by_key(|name| self.scene.objects.iter().position(|object| object.name == *name));
        let answer = hit.and_then(|hit| names.iter().position(|name| *name == hit)).unwrap_or(names.len());
        names.push("nothing".to_owned());
        Some(Question::between("What does the ray hit?", names, answer))
    }
}
