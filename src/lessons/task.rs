//! A task: a function to write, the cases it is run on, the truth, and the faults that are known.

use super::answer::Answer;
use super::attempt::{Panicked, attempt};
use super::pictures::Shown;
use super::program::Pixel;
use super::report::{Broken, Failure, FailureKind, Mistake};
use crate::accuracy::random::Random;
use crate::faults::Fault as ClassicFault;
use crate::pictures::drawing::Drawing;

/// An input of a function, with a name to find it by.
#[derive(Clone, Debug, PartialEq)]
pub struct Case<C> {
    /// What is special about it.
    pub name: String,
    /// The input.
    pub input: C,
}

impl<C> Case<C> {
    /// A case made by hand.
    pub fn new(name: &str, input: C) -> Self {
        Case { name: name.to_owned(), input }
    }
}

/// So many random cases of a seed: those that `draw` does not turn down.
pub fn random_cases<C>(seed: u64, count: usize, mut draw: impl FnMut(&mut Random) -> Option<C>) -> Vec<Case<C>> {
    let mut random = Random::new(seed);
    let drawn = std::iter::repeat_with(|| draw(&mut random)).flatten().take(count);
    drawn.enumerate().map(|(i, input)| Case { name: format!("random case {}", i + 1), input }).collect()
}

/// A mistake that students make, as a function that makes it.
#[derive(Clone, Copy, Debug)]
pub struct Fault<C> {
    /// A name for programs.
    pub id: &'static str,
    /// What is wrong, as a clause.
    pub name: &'static str,
    /// Why it happens, or what it does: a sentence.
    pub why: &'static str,
    /// What a function with this mistake answers.
    pub answer: fn(&C) -> Answer,
}

impl Fault<Pixel> {
    /// A classic fault, planted in a textbook tracer.
    pub const fn classic(fault: ClassicFault, answer: fn(&Pixel) -> Answer) -> Self {
        Fault { id: fault.name(), name: fault.title(), why: fault.why(), answer }
    }
}

/// A function that draws a case. The last argument asks the student's function for more.
pub type Picture<C> = fn(&C, &Shown, &dyn Fn(&C) -> Option<Answer>) -> Drawing;

/// What may be drawn, or run, by name.
type Named<T> = Box<dyn Fn(&str) -> Option<T>>;

/// A function to write, and all that is needed to check it.
#[derive(Debug)]
pub struct Task<C: 'static> {
    /// What it is about, in a few words.
    pub name: &'static str,
    /// The function's name in `exercise.rs`.
    pub function: &'static str,
    /// Its points.
    pub points: u32,
    /// The functions of the same lesson that it builds on.
    pub after: &'static [&'static str],
    /// The cases: those made by hand first, then random ones.
    pub cases: Vec<Case<C>>,
    /// The input in words, a line for each part.
    pub given: fn(&C) -> Vec<String>,
    /// The right answer.
    pub truth: fn(&C) -> Answer,
    /// The mistakes that can be named; of two that answer alike the first is.
    pub faults: &'static [Fault<C>],
    /// The right answer and the student's in one diagram.
    pub picture: Picture<C>,
    /// Hints, each saying more than the one before.
    pub hints: &'static [&'static str],
}

/// A task with a student's function: what there is to run.
pub struct Stage {
    /// What it is about, in a few words.
    pub name: &'static str,
    /// The function's name in `exercise.rs`.
    pub function: &'static str,
    /// Its points.
    pub points: u32,
    /// The functions of the same lesson that it builds on.
    pub after: &'static [&'static str],
    /// Hints, each saying more than the one before.
    pub hints: &'static [&'static str],
    /// How many cases there are.
    pub cases: usize,
    /// The mistakes that can be named.
    pub mistakes: Vec<Mistake>,
    run: Box<dyn Fn() -> Checked>,
    show: Named<Drawing>,
    plant: Named<Checked>,
}

impl std::fmt::Debug for Stage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stage").field("function", &self.function).finish_non_exhaustive()
    }
}

impl Stage {
    /// Runs the student's function on the cases, up to the first that fails.
    pub fn run(&self) -> Checked {
        (self.run)()
    }

    /// What a student sees whose function makes the known mistake with this name; nothing where there is none.
    pub fn with_mistake(&self, id: &str) -> Option<Checked> {
        (self.plant)(id)
    }

    /// The picture of a case with the right answer alone; nothing where no case has this name.
    pub fn picture(&self, case: &str) -> Option<Drawing> {
        (self.show)(case)
    }
}

/// What came of running a stage.
#[derive(Debug)]
pub struct Checked {
    /// The first failing case.
    pub failure: Option<Failure>,
    /// The picture of that case; of the first one where all pass.
    pub picture: Drawing,
}

impl<C: 'static> Task<C> {
    /// The task with a student's function.
    pub fn stage(self, student: impl Fn(&C) -> Answer + 'static) -> Stage {
        let task = std::rc::Rc::new(self);
        let (shown, planted) = (task.clone(), task.clone());
        Stage {
            name: task.name,
            function: task.function,
            points: task.points,
            after: task.after,
            hints: task.hints,
            cases: task.cases.len(),
            mistakes: task.faults.iter().map(Mistake::of).collect(),
            run: Box::new(move || task.check(&student)),
            show: Box::new(move |name| {
                let case = shown.cases.iter().find(|case| case.name == name)?;
                let truth = |input: &C| Some((shown.truth)(input));
                Some((shown.picture)(&case.input, &shown.shown(case, None, None), &truth))
            }),
            plant: Box::new(move |id| {
                let fault = planted.faults.iter().find(|fault| fault.id == id)?;
                Some(planted.check(&fault.answer))
            }),
        }
    }

    fn shown(&self, case: &Case<C>, got: Option<Answer>, mistake: Option<&str>) -> Shown {
        Shown {
            title: self.name.to_owned(),
            function: self.function.to_owned(),
            case: case.name.clone(),
            given: (self.given)(&case.input),
            expected: (self.truth)(&case.input),
            got,
            mistake: mistake.map(str::to_owned),
        }
    }

    /// Runs the student's function.
    fn check(&self, student: &dyn Fn(&C) -> Answer) -> Checked {
        let ask = |input: &C| attempt(|| student(input));
        let again = |input: &C| ask(input).ok();
        for (i, case) in self.cases.iter().enumerate() {
            let expected = (self.truth)(&case.input);
            let got = ask(&case.input);
            if got.as_ref().is_ok_and(|got| got.agrees(&expected)) {
                continue;
            }
            let fault = got.is_ok().then(|| self.named(&again)).flatten();
            let failure = self.failure(i, case, &expected, &got, fault);
            let shown = self.shown(case, got.ok(), fault.map(|fault| fault.name));
            return Checked { failure: Some(failure), picture: (self.picture)(&case.input, &shown, &again) };
        }
        let first = &self.cases[0];
        let shown = self.shown(first, again(&first.input), None);
        Checked { failure: None, picture: (self.picture)(&first.input, &shown, &again) }
    }

    /// The first fault that answers every case as the student does.
    fn named(&self, student: &dyn Fn(&C) -> Option<Answer>) -> Option<&Fault<C>> {
        let answers: Vec<Option<Answer>> = self.cases.iter().map(|case| student(&case.input)).collect();
        self.faults.iter().find(|fault| {
            let same = |(case, own): (&Case<C>, &Option<Answer>)| {
                own.as_ref().is_some_and(|own| own.agrees(&(fault.answer)(&case.input)))
            };
            self.cases.iter().zip(&answers).all(same)
        })
    }

    fn failure(
        &self,
        i: usize,
        case: &Case<C>,
        expected: &Answer,
        got: &Result<Answer, Panicked>,
        fault: Option<&Fault<C>>,
    ) -> Failure {
        let (told, kind, broken) = match got {
            Ok(got) => {
                let [expected, got] = expected.told_beside(got);
                ([expected, got], FailureKind::Wrong, None)
            }
            Err(panicked) => {
                let kind = if panicked.is_unwritten() { FailureKind::Unwritten } else { FailureKind::Panicked };
                let broken = Broken { message: panicked.message.clone(), place: panicked.place.clone() };
                ([expected.to_string(), String::new()], kind, Some(broken))
            }
        };
        let [expected, got] = told;
        Failure {
            kind,
            case: i + 1,
            case_name: case.name.clone(),
            given: (self.given)(&case.input),
            expected,
            got: (kind == FailureKind::Wrong).then_some(got),
            broken,
            mistake: fault.map(Mistake::of),
        }
    }
}
