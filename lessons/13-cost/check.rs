//! Lesson 13, what accuracy costs: the cases, the known mistakes, the hints.

use std::process::ExitCode;
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use raytree::accuracy::forms::{Form, Subject, Triangles};
use raytree::accuracy::report::Plan;
use raytree::accuracy::sets::TriangleSet;
use raytree::accuracy::verdicts::{Effort, SetCount, count_set};
use raytree::lessons::{
    Answer, Case, Choice, Fault, Lesson, Random, Reading, Task, Value, depths_and_weights, pictures, random_cases,
    shown,
};
use raytree::numbers::Real;
use raytree::scene;

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) speedup: fn(f64, f64) -> f64,
    pub(crate) break_even: fn(f64, f64, f64) -> Option<f64>,
    pub(crate) beats: fn(&Choice, &Choice) -> bool,
    pub(crate) pareto: fn(&[Choice]) -> Vec<usize>,
    pub(crate) choose: fn(&[Choice], f64) -> Option<usize>,
    pub(crate) reading: fn() -> Reading,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    Lesson {
        number: 13,
        title: "what accuracy costs",
        stages: vec![
            speedup().stage(move |[before, after]| factor((student.speedup)(*before, *after))),
            break_even().stage(move |[build, slow, fast]| rays((student.break_even)(*build, *slow, *fast))),
            beats().stage(move |[a, b]| Answer::of("beats", (student.beats)(a, b))),
            pareto().stage(move |choices| front((student.pareto)(choices))),
            choose().stage(move |(choices, budget)| choice((student.choose)(choices, *budget))),
            reading().stage(move |()| read((student.reading)())),
        ],
        notice: "Now see what a filter has to decide: raytree diagram scenes/triangle.json \"just outside\" \
                 --kind triangle --shape triangle -o edge.png",
    }
}

fn factor(x: f64) -> Answer {
    Answer::of("speedup", x)
}

fn speedup() -> Task<[f64; 2]> {
    const FAULTS: &[Fault<[f64; 2]>] = &[
        Fault {
            id: "speedup-inverted",
            name: "the ratio is upside down",
            why: "What is faster takes less, so before / after is above 1.",
            answer: |[before, after]| factor(after / before),
        },
        Fault {
            id: "speedup-difference",
            name: "that is the difference, not the ratio",
            why: "A difference has a unit and depends on the machine. \"Twice as fast\" is a ratio.",
            answer: |[before, after]| factor(before - after),
        },
        Fault {
            id: "speedup-saved-share",
            name: "that is the share that is saved",
            why: "Half of it saved means twice as fast: before / after.",
            answer: |[before, after]| factor((before - after) / before),
        },
        Fault {
            id: "speedup-minus-one",
            name: "1 is taken away: that is how much faster, not how many times as fast",
            why: "Equally fast is once as fast: the speedup is 1.",
            answer: |[before, after]| factor(before / after - 1.0),
        },
        Fault {
            id: "speedup-percent",
            name: "that is in percent",
            why: "Twice as fast is 2, not 200.",
            answer: |[before, after]| factor(100.0 * before / after),
        },
    ];
    let mut cases = vec![
        Case::new("half the time", [10.0, 5.0]),
        Case::new("the same", [3.0, 3.0]),
        Case::new("slower", [4.0, 5.0]),
        Case::new("the hierarchy of lesson 12", [2048.0, 16.0]),
    ];
    cases.extend(random_cases(1301, 40, |random| Some([positive(random), positive(random)])));
    Task {
        name: "how many times as fast",
        function: "speedup",
        points: 1,
        after: &[],
        cases,
        given: |[before, after]| vec![format!("before = {}, after = {}", shown(*before), shown(*after))],
        truth: |[before, after]| factor(before / after),
        faults: FAULTS,
        picture: |[before, after], what, _| {
            let amounts = [("before".to_owned(), *before), ("after".to_owned(), *after)];
            pictures::bars(&amounts, "How many times does the lower bar fit into the upper?", what)
        },
        hints: &["What takes half as long is twice as fast. Which of the two has to stand below the line?"],
    }
}

fn positive(random: &mut Random) -> f64 {
    (1 + random.below(64)) as f64 / 4.0
}

fn rays(n: Option<f64>) -> Answer {
    Answer::maybe(n, "it never pays", |n| Answer::of("rays", n))
}

fn break_even() -> Task<[f64; 3]> {
    const FAULTS: &[Fault<[f64; 3]>] = &[
        Fault {
            id: "even-unchecked",
            name: "it is not asked whether a ray gets cheaper at all",
            why: "If fast is not below slow, no number of rays brings the building back: None.",
            answer: |[build, slow, fast]| rays(Some(build / (slow - fast))),
        },
        Fault {
            id: "even-without-fast",
            name: "what a ray still costs afterwards is forgotten",
            why: "A ray saves slow - fast, not all of slow.",
            answer: |[build, slow, fast]| rays((fast < slow).then_some(build / slow)),
        },
        Fault {
            id: "even-by-fast",
            name: "it is divided by what a ray costs afterwards",
            why: "n rays save n (slow - fast), and that has to be as much as build.",
            answer: |[build, slow, fast]| rays((fast < slow).then_some(build / fast)),
        },
        Fault {
            id: "even-sum",
            name: "both costs of a ray are added where one has to be taken from the other",
            why: "What a ray saves is the difference: slow - fast.",
            answer: |[build, slow, fast]| rays((fast < slow).then_some(build / (slow + fast))),
        },
        Fault {
            id: "even-multiplied",
            name: "it is multiplied by what a ray saves where it has to be divided",
            why: "n (slow - fast) = build. The more a ray saves, the fewer rays it takes.",
            answer: |[build, slow, fast]| rays((fast < slow).then_some(build * (slow - fast))),
        },
    ];
    let mut cases = vec![
        Case::new("ten rays", [80.0, 10.0, 2.0]),
        Case::new("nothing to build", [0.0, 10.0, 2.0]),
        Case::new("a ray gets dearer", [80.0, 2.0, 10.0]),
        Case::new("nothing is saved", [80.0, 3.0, 3.0]),
        Case::new("lesson 12", [200_000.0, 2048.0, 16.0]),
    ];
    cases.extend(random_cases(1302, 40, |random| Some([4.0 * positive(random), positive(random), positive(random)])));
    Task {
        name: "from when on it pays",
        function: "break_even",
        points: 2,
        after: &[],
        cases,
        given: |[build, slow, fast]| {
            vec![format!("build = {}, slow = {}, fast = {}", shown(*build), shown(*slow), shown(*fast))]
        },
        truth: |[build, slow, fast]| rays((fast < slow).then(|| build / (slow - fast))),
        faults: FAULTS,
        picture: |[build, slow, fast], what, _| pictures::crossing(*build, *slow, *fast, what),
        hints: &[
            "n rays cost n * slow without it, and build + n * fast with it. For which n are they equal?",
            "A ray saves slow - fast. How many of these make up for build? And what if that is not above 0?",
        ],
    }
}

fn of(name: &str, cost: f64, error: f64) -> Choice {
    Choice { name: name.to_owned(), cost, error }
}

fn told(choices: &[Choice]) -> Vec<String> {
    let one = |(i, choice): (usize, &Choice)| {
        format!("{i}: {}, cost {}, error {}", choice.name, shown(choice.cost), shown(choice.error))
    };
    choices.iter().enumerate().map(one).collect()
}

fn truly_beats(a: &Choice, b: &Choice) -> bool {
    a.cost <= b.cost && a.error <= b.error && (a.cost, a.error) != (b.cost, b.error)
}

/// A few choices with small numbers, so that equal ones come up.
fn few(random: &mut Random) -> Vec<Choice> {
    let count = 2 + random.below(7);
    (0..count)
        .map(|i| {
            let letter = char::from(b'a' + i as u8).to_string();
            of(&letter, (1 + random.below(8)) as f64, random.below(8) as f64 / 4.0)
        })
        .collect()
}

fn beats() -> Task<[Choice; 2]> {
    fn answer(yes: bool) -> Answer {
        Answer::of("beats", yes)
    }
    const FAULTS: &[Fault<[Choice; 2]>] = &[
        Fault {
            id: "beats-equals",
            name: "a choice beats its equal, and so itself",
            why: "Then nothing is left on the front. One of the two has to be smaller.",
            answer: |[a, b]| answer(a.cost <= b.cost && a.error <= b.error),
        },
        Fault {
            id: "beats-in-both",
            name: "both have to be smaller",
            why: "As cheap and more accurate is enough: equal in one and smaller in the other.",
            answer: |[a, b]| answer(a.cost < b.cost && a.error < b.error),
        },
        Fault {
            id: "beats-in-one",
            name: "it is enough to be smaller in one",
            why: "What is cheaper and less accurate is no better, it is another compromise.",
            answer: |[a, b]| answer(a.cost < b.cost || a.error < b.error),
        },
        Fault {
            id: "beats-by-cost",
            name: "only the cost counts",
            why: "What is cheap and wrong beats nothing.",
            answer: |[a, b]| answer(a.cost < b.cost),
        },
        Fault {
            id: "beats-by-error",
            name: "only the error counts",
            why: "What is accurate at any price beats nothing.",
            answer: |[a, b]| answer(a.error < b.error),
        },
        Fault {
            id: "beats-reversed",
            name: "a and b are exchanged, or larger is taken for better",
            why: "Of cost and of error less is better.",
            answer: |[a, b]| answer(truly_beats(b, a)),
        },
    ];
    let pair = |name: &str, a: [f64; 2], b: [f64; 2]| Case::new(name, [of("a", a[0], a[1]), of("b", b[0], b[1])]);
    let mut cases = vec![
        pair("cheaper and more accurate", [1.0, 0.5], [2.0, 1.0]),
        pair("cheaper and less accurate", [1.0, 1.0], [2.0, 0.5]),
        pair("as cheap, more accurate", [2.0, 0.5], [2.0, 1.0]),
        pair("cheaper, as accurate", [1.0, 0.5], [2.0, 0.5]),
        pair("the same", [2.0, 0.5], [2.0, 0.5]),
        pair("dearer and less accurate", [3.0, 1.0], [2.0, 0.5]),
    ];
    cases.extend(random_cases(1303, 40, |random| {
        let mut pair = few(random).into_iter();
        Some([pair.next()?, pair.next()?])
    }));
    Task {
        name: "better than another",
        function: "beats",
        points: 2,
        after: &[],
        cases,
        given: |[a, b]| {
            [a, b].map(|c| format!("{}: cost {}, error {}", c.name, shown(c.cost), shown(c.error))).to_vec()
        },
        truth: |[a, b]| answer(truly_beats(a, b)),
        faults: FAULTS,
        picture: |pair, what, _| pictures::cost_and_error(pair, "Does a (0) beat b (1)?", what),
        hints: &[
            "a.cost <= b.cost, and the same for the error: a is nowhere worse.",
            "Two equal choices are nowhere worse than one another, and neither beats the other. What has to be asked as well?",
        ],
    }
}

/// Pictures of scenes/whitted.json to different depths and with different least weights, traced now.
fn measured() -> Vec<Choice> {
    static MEASURED: OnceLock<Vec<Choice>> = OnceLock::new();
    let measure = || {
        let text = include_str!("../../scenes/whitted.json");
        let loaded = scene::load("scenes/whitted.json", text, &mut |_| Err("it has no meshes".into()));
        let choices = loaded.ok().and_then(|loaded| depths_and_weights(&loaded.scene, 48, 36));
        choices.expect("a committed scene can be traced")
    };
    MEASURED.get_or_init(measure).clone()
}

fn front(choices: impl IntoIterator<Item = usize>) -> Answer {
    Answer::of("front", Value::set(choices))
}

/// Those that no other beats, for some meaning of beating.
fn unbeaten(choices: &[Choice], beats: fn(&Choice, &Choice) -> bool) -> Vec<usize> {
    (0..choices.len()).filter(|i| !choices.iter().any(|other| beats(other, &choices[*i]))).collect()
}

fn pareto() -> Task<Vec<Choice>> {
    const FAULTS: &[Fault<Vec<Choice>>] = &[
        Fault {
            id: "pareto-empty",
            name: "every choice is beaten by itself",
            why: "An equal is not better: use beats, which asks for one of the two to be smaller.",
            answer: |choices| front(unbeaten(choices, |a, b| a.cost <= b.cost && a.error <= b.error)),
        },
        Fault {
            id: "pareto-beaten",
            name: "these are the ones that are beaten",
            why: "The front is what is left: !choices.iter().any(...).",
            answer: |choices| {
                let kept = unbeaten(choices, truly_beats);
                front((0..choices.len()).filter(|i| !kept.contains(i)))
            },
        },
        Fault {
            id: "pareto-strict",
            name: "what is as cheap and less accurate stays in",
            why: "A choice goes if another is nowhere worse and somewhere better; it need not be better in both.",
            answer: |choices| front(unbeaten(choices, |a, b| a.cost < b.cost && a.error < b.error)),
        },
        Fault {
            id: "pareto-best-only",
            name: "only the most accurate and the cheapest are there",
            why: "In between there are compromises that nothing beats either.",
            answer: |choices| {
                let least = |of: fn(&Choice) -> f64| choices.iter().map(of).fold(f64::INFINITY, f64::min);
                let (cost, error) = (least(|c| c.cost), least(|c| c.error));
                let is_best = |i: &usize| choices[*i].cost == cost || choices[*i].error == error;
                front(unbeaten(choices, truly_beats).into_iter().filter(is_best))
            },
        },
        Fault {
            id: "pareto-one-of-equals",
            name: "of equal choices only the first is there",
            why: "Equal choices do not beat each other: both stay.",
            answer: |choices| {
                let is_first = |i: &usize| {
                    let own = (choices[*i].cost, choices[*i].error);
                    !choices[..*i].iter().any(|other| (other.cost, other.error) == own)
                };
                front(unbeaten(choices, truly_beats).into_iter().filter(is_first))
            },
        },
        Fault {
            id: "pareto-neighbours",
            name: "each choice is compared with the next one only",
            why: "What beats it may stand anywhere in the list.",
            answer: |choices| {
                let next = |i: &usize| choices.get(i + 1).is_some_and(|other| truly_beats(other, &choices[*i]));
                front((0..choices.len()).filter(|i| !next(i)))
            },
        },
    ];
    let mut cases = vec![
        Case::new("depth and least weight in scenes/whitted.json", measured()),
        Case::new("three", vec![of("a", 1.0, 2.0), of("b", 2.0, 1.0), of("c", 3.0, 1.5)]),
        Case::new("two equal ones", vec![of("a", 1.0, 1.0), of("b", 1.0, 1.0), of("c", 2.0, 0.5)]),
        Case::new("as cheap, less accurate", vec![of("a", 1.0, 2.0), of("b", 1.0, 1.0)]),
        Case::new("a lone one", vec![of("a", 1.0, 1.0)]),
    ];
    cases.extend(random_cases(1304, 40, |random| Some(few(random))));
    Task {
        name: "what nothing beats",
        function: "pareto",
        points: 3,
        after: &["beats"],
        cases,
        given: |choices| told(choices),
        truth: |choices| front(unbeaten(choices, truly_beats)),
        faults: FAULTS,
        picture: |choices, what, _| {
            pictures::cost_and_error(choices, "Nothing beats what lies on the dashed line.", what)
        },
        hints: &[
            "Go through all choices with their numbers: for (i, choice) in choices.iter().enumerate().",
            "A choice stays if there is no other that beats it: choices.iter().any(|other| beats(other, choice)) is false.",
        ],
    }
}

fn choice(i: Option<usize>) -> Answer {
    Answer::maybe(i, "nothing is accurate enough", |i| Answer::of("choice", i as f64))
}

/// The first of the least, by some measure, of those that are allowed.
fn least(choices: &[Choice], is_allowed: impl Fn(&Choice) -> bool, by: fn(&Choice) -> f64) -> Option<usize> {
    let allowed = (0..choices.len()).filter(|i| is_allowed(&choices[*i]));
    allowed.min_by(|i, j| by(&choices[*i]).total_cmp(&by(&choices[*j])))
}

fn choose() -> Task<(Vec<Choice>, f64)> {
    const FAULTS: &[Fault<(Vec<Choice>, f64)>] = &[
        Fault {
            id: "choose-cheapest",
            name: "the cheapest of all is taken, however wrong it is",
            why: "First comes what is accurate enough: error <= budget. Of those the cheapest.",
            answer: |(choices, _)| choice(least(choices, |_| true, |c| c.cost)),
        },
        Fault {
            id: "choose-most-accurate",
            name: "the most accurate is taken, whatever it costs",
            why: "Within the budget more accuracy is not asked for: the cheapest that is accurate enough.",
            answer: |(choices, budget)| choice(least(choices, |c| c.error <= *budget, |c| c.error)),
        },
        Fault {
            id: "choose-first",
            name: "the first one that is accurate enough is taken",
            why: "A later one may be cheaper: go on to the end.",
            answer: |(choices, budget)| choice(choices.iter().position(|c| c.error <= *budget)),
        },
        Fault {
            id: "choose-below",
            name: "an error that is just the budget is turned down",
            why: "At most the budget: error <= budget.",
            answer: |(choices, budget)| choice(least(choices, |c| c.error < *budget, |c| c.cost)),
        },
        Fault {
            id: "choose-dearest",
            name: "the dearest that is accurate enough is taken",
            why: "The smallest cost counts.",
            answer: |(choices, budget)| choice(least(choices, |c| c.error <= *budget, |c| -c.cost)),
        },
        Fault {
            id: "choose-anyway",
            name: "where nothing is accurate enough, something is taken all the same",
            why: "Then the answer is None: whoever asked has to hear that the budget cannot be met.",
            answer: |(choices, budget)| {
                let enough = least(choices, |c| c.error <= *budget, |c| c.cost);
                choice(enough.or_else(|| least(choices, |_| true, |c| c.error)))
            },
        },
    ];
    let three = || vec![of("a", 3.0, 0.25), of("b", 2.0, 1.0), of("c", 4.0, 0.0)];
    let mut cases = vec![
        Case::new("scenes/whitted.json, an error of 0.01", (measured(), 0.01)),
        Case::new("scenes/whitted.json, an error of 0.001", (measured(), 0.001)),
        Case::new("some error is allowed", (three(), 0.5)),
        Case::new("just the budget", (three(), 0.25)),
        Case::new("no error is allowed", (three(), 0.0)),
        Case::new("nothing is accurate enough", (vec![of("a", 1.0, 2.0), of("b", 2.0, 1.0)], 0.5)),
    ];
    cases.extend(random_cases(1305, 40, |random| {
        let (choices, budget) = (few(random), random.below(5) as f64 / 4.0);
        // Of two that are as cheap either would do.
        let best = least(&choices, |c| c.error <= budget, |c| c.cost);
        let equals = |i: usize| choices.iter().filter(|c| c.error <= budget && c.cost == choices[i].cost).count();
        best.is_none_or(|i| equals(i) == 1).then_some((choices, budget))
    }));
    Task {
        name: "the cheapest that is accurate enough",
        function: "choose",
        points: 3,
        after: &[],
        cases,
        given: |(choices, budget)| [vec![format!("budget = {}", shown(*budget))], told(choices)].concat(),
        truth: |(choices, budget)| choice(least(choices, |c| c.error <= *budget, |c| c.cost)),
        faults: FAULTS,
        picture: |(choices, budget), what, _| {
            let about = format!("The error may be up to {}.", shown(*budget));
            pictures::cost_and_error(choices, &about, what)
        },
        hints: &[
            "Keep the number of the best so far: let mut best: Option<usize> = None;",
            "A choice takes its place if its error is at most the budget, and there is no best yet or one that costs more.",
        ],
    }
}

/// One set as `raytree accuracy --quick` counts it.
fn counted<R: Real>(set: TriangleSet) -> SetCount {
    let Plan { triangles, refereed_one_in, values, seed, .. } = Plan::QUICK;
    let effort = Effort { cases: triangles.div_ceil(Triangles::SETS.len()), one_in: refereed_one_in, values, seed };
    let count = count_set::<Triangles, R>(set, effort, &AtomicBool::new(false), &|_| ());
    count.expect("nobody stops it")
}

/// The sets that are asked about, in f32 and in f64.
struct Counts {
    random: SetCount,
    edges: SetCount,
    edges_f64: SetCount,
    vertices: SetCount,
}

fn counts() -> &'static Counts {
    static COUNTS: OnceLock<Counts> = OnceLock::new();
    COUNTS.get_or_init(|| Counts {
        random: counted::<f32>(TriangleSet::Random),
        edges: counted::<f32>(TriangleSet::Edge),
        edges_f64: counted::<f64>(TriangleSet::Edge),
        vertices: counted::<f32>(TriangleSet::Vertex),
    })
}

/// False hits and false misses of a form.
fn wrong(count: &SetCount, form: Form) -> [usize; 2] {
    count.forms.iter().find(|f| f.form == form).map_or([0, 0], |f| [f.false_hits, f.false_misses])
}

fn all_wrong(count: &SetCount, form: Form) -> usize {
    wrong(count, form).iter().sum()
}

fn read(reading: Reading) -> Answer {
    Answer::of("lecture_wrong", reading.lecture_wrong as f64)
        .and("lecture_over_watertight", reading.lecture_over_watertight)
        .and("watertight_random", reading.watertight_random as f64)
        .and("certified_wrong", reading.certified_wrong as f64)
        .and("filter_share", reading.filter_share)
}

fn true_reading() -> Reading {
    let Counts { random, edges, vertices, .. } = counts();
    let certified = [random, edges, vertices].map(|count| all_wrong(count, Form::Certified));
    Reading {
        lecture_wrong: all_wrong(edges, Form::Lecture),
        lecture_over_watertight: all_wrong(edges, Form::Lecture) as f64 / all_wrong(edges, Form::Watertight) as f64,
        watertight_random: all_wrong(random, Form::Watertight),
        certified_wrong: certified.iter().sum(),
        filter_share: vertices.stages[0] as f64 / vertices.cases as f64,
    }
}

fn reading() -> Task<()> {
    const FAULTS: &[Fault<()>] = &[
        Fault {
            id: "reading-false-hits",
            name: "only the false hits are counted",
            why: "A hit that is none and a miss that is none are both wrong: add the two columns.",
            answer: |()| {
                let [hits, _] = wrong(&counts().edges, Form::Lecture);
                let [other, _] = wrong(&counts().edges, Form::Watertight);
                let ratio = hits as f64 / other as f64;
                read(Reading { lecture_wrong: hits, lecture_over_watertight: ratio, ..true_reading() })
            },
        },
        Fault {
            id: "reading-f64",
            name: "these are the rows of f64",
            why: "The third column says the precision. In f64 the numbers are others.",
            answer: |()| {
                let edges = &counts().edges_f64;
                let ratio = all_wrong(edges, Form::Lecture) as f64 / all_wrong(edges, Form::Watertight) as f64;
                let lecture_wrong = all_wrong(edges, Form::Lecture);
                read(Reading { lecture_wrong, lecture_over_watertight: ratio, ..true_reading() })
            },
        },
        Fault {
            id: "reading-upside-down",
            name: "the ratio is upside down",
            why: "How many times as many the lecture's are: its number stands above.",
            answer: |()| {
                let right = true_reading();
                read(Reading { lecture_over_watertight: 1.0 / right.lecture_over_watertight, ..right })
            },
        },
        Fault {
            id: "reading-per-million",
            name: "that is the column of wrong verdicts in a million, not their number",
            why: "It makes sets of different size comparable. Here the number itself is asked for.",
            answer: |()| {
                let edges = &counts().edges;
                let lecture_wrong = 1_000_000 / edges.cases * all_wrong(edges, Form::Lecture);
                read(Reading { lecture_wrong, ..true_reading() })
            },
        },
        Fault {
            id: "reading-count-for-share",
            name: "the share is the number of verdicts that the filter decides",
            why: "A share is a number from 0 to 1: divide by the number of cases.",
            answer: |()| read(Reading { filter_share: counts().vertices.stages[0] as f64, ..true_reading() }),
        },
        Fault {
            id: "reading-percent",
            name: "the share is in percent",
            why: "A share is a number from 0 to 1.",
            answer: |()| {
                let right = true_reading();
                read(Reading { filter_share: 100.0 * right.filter_share, ..right })
            },
        },
    ];
    Task {
        name: "the table of wrong verdicts",
        function: "reading",
        points: 2,
        after: &[],
        cases: vec![Case::new("triangles in f32", ())],
        given: |()| vec!["verdicts.csv of raytree accuracy --quick -o report".to_owned()],
        truth: |()| read(true_reading()),
        faults: FAULTS,
        picture: |(), what, _| {
            let edges = &counts().edges;
            let form = |count: &raytree::accuracy::verdicts::FormCount| {
                (format!("{}, f32", count.form.name()), count.wrong() as f64)
            };
            let about = format!("Wrong verdicts of {} on rays that are aimed at edges.", edges.cases);
            pictures::bars(&edges.forms.iter().map(form).collect::<Vec<_>>(), &about, what)
        },
        hints: &[
            "cargo run -- accuracy --quick -o report writes report/verdicts.csv. The first line names the columns: subject, \
             set, precision, cases, ...",
            "The row that begins with `triangle,aimed at edges,f32` and has `lecture` as its form: false_hits plus false_misses.",
            "filter is the number of verdicts that the first stage of the certified form decides. Divide it by cases.",
        ],
    }
}
