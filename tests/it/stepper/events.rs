//! Events where the tree says, questions with the tree's answers, diagrams that can be drawn.

use raytree::pictures::diagrams::{Chosen, Input, Kind, diagram};
use raytree::pictures::theme::Theme;
use raytree::steps::{Event, Player, Procedure, Recording};
use raytree::tree::{Outcome, RayNode, TestRecord, Verdict};

use super::{for_each_recording, for_each_recording_of};
use raytree::numbers::{Precision, Stage};
use raytree::scene::Numerics;

/// All steps at which an event holds, one `until` after the other.
fn all(recording: &Recording<'_>, event: &Event) -> Vec<usize> {
    let mut player = Player::new(recording);
    let mut found: Vec<usize> = event.holds(recording, 0).then_some(0).into_iter().collect();
    while player.until(event) {
        found.push(player.at());
    }
    found
}

#[test]
fn events_hold_where_the_tree_says() {
    let mut seen = [0; 8];
    for_each_recording(|what, loaded, recording| {
        let nodes = || recording.tree.root.walk();
        let count = |holds: &dyn Fn(&RayNode) -> bool| nodes().filter(|node| holds(node)).count();
        let found = |event: Event| all(recording, &event).len();
        let checks = [
            (found(Event::Hit), count(&|node| node.outcome == Outcome::Hit)),
            (found(Event::Blocked), count(&|node| node.outcome == Outcome::Blocked)),
            (found(Event::TotalReflection), count(&|node| node.total_reflection)),
            (
                found(Event::Depth(1)),
                count(&|node| node.depth == 1 && node.weight.is_some() && node.outcome.is_traced()),
            ),
            (
                found(Event::Weight(0.3)),
                count(&|node| {
                    node.depth > 0 && node.weight.is_some_and(|w| w.iter().fold(0.0_f64, |m, w| m.max(*w)) < 0.3)
                }),
            ),
            (
                found(Event::T(2.0)),
                nodes()
                    .flat_map(|node| node.tests.iter().flatten())
                    .filter(|test| match test {
                        TestRecord::Shape(test) => test.verdict == Verdict::Best && test.t.unwrap() < 2.0,
                        TestRecord::Bounds(_) => false,
                    })
                    .count(),
            ),
        ];
        for (i, (found, wanted)) in checks.into_iter().enumerate() {
            assert_eq!(found, wanted, "{what}, event {i}");
            seen[i] += found;
        }
        // Each at the ray that it is about.
        for step in all(recording, &Event::TotalReflection) {
            assert!(recording.nodes[recording.steps[step].node].ray.total_reflection, "{what}");
        }
        // Nodes whose certificates name an exact stage are run to.
        let exact = all(recording, &Event::Exact);
        for (i, node) in recording.nodes.iter().enumerate() {
            let is_exact = [node.ray.certificate, node.ray.refraction_certificate].into_iter().flatten();
            if is_exact.into_iter().any(|certificate| certificate.stage != Stage::Filter) {
                assert!(exact.iter().any(|&step| recording.steps[step].node == i), "{what}: {}", node.path);
                seen[6] += 1;
            }
        }
        for object in &loaded.scene.objects {
            let wanted = nodes().flat_map(|node| node.tests.iter().flatten()).filter(|test| {
                let name = match test {
                    TestRecord::Shape(test) => &test.object,
                    TestRecord::Bounds(test) => &test.object,
                };
                name.as_ref() == Some(&object.name)
            });
            assert_eq!(found(Event::Object(object.name.clone())), wanted.count(), "{what}: {}", object.name);
        }
        assert_eq!(found(Event::NotANumber), 0, "{what}");
        assert_eq!(found(Event::Object("no such thing".into())), 0, "{what}");
    });
    assert!(seen[..7].iter().all(|count| *count > 3), "{seen:?}");
}

#[test]
fn the_lectures_box_divides_nothing_by_nothing() {
    let mut found = 0;
    for_each_recording_of(&[(Numerics::Lecture, Precision::F64)], |_, _, recording| {
        found += all(recording, &Event::NotANumber).len();
    });
    assert!(found > 0, "a ray in the plane of a face");
}

#[test]
fn events_are_read_and_others_answered_with_the_list() {
    for (word, event) in [
        ("hit", Event::Hit),
        ("blocked", Event::Blocked),
        ("tir", Event::TotalReflection),
        ("depth 3", Event::Depth(3)),
        ("weight 0.25", Event::Weight(0.25)),
        ("t 1e-3", Event::T(1e-3)),
        ("exact", Event::Exact),
        ("nan", Event::NotANumber),
        ("object glass ball", Event::Object("glass ball".into())),
    ] {
        assert_eq!(word.parse::<Event>().as_ref(), Ok(&event));
        assert_eq!(format!("{event}").parse::<Event>(), Ok(event.clone()), "{word}");
    }
    for word in ["", "hits", "depth", "depth -1", "depth x", "weight nan", "t", "object", "hit 3", "total reflection"] {
        let no = word.parse::<Event>().unwrap_err();
        assert!(no.message.contains("no event") && !no.help.is_empty(), "{no}");
    }
    assert!("everything".parse::<Event>().unwrap_err().help.contains("`object NAME`"));
}

#[test]
fn answers_agree_with_the_tree() {
    let mut asked = std::collections::BTreeMap::<String, [usize; 4]>::new();
    for_each_recording(|what, _, recording| {
        for step in &recording.steps {
            let Some(question) = &step.question else { continue };
            let answer = question.choices.get(question.answer).unwrap_or_else(|| panic!("{what}: {question:?}"));
            let node = recording.nodes[step.node].ray;
            let is_yes = answer == "yes";
            let ask = question.ask.as_str();
            let named = ["the nearest hit so far", "Does the surface face", "Is this point lit by"];
            let first: String = match named.into_iter().find(|words| ask.contains(words)) {
                Some(words) => words.to_owned(),
                None => ask.split(' ').take(3).collect::<Vec<_>>().join(" "),
            };
            asked.entry(first).or_default()[question.answer.min(3)] += 1;
            match (ask, recording.test_of(step)) {
                ("Is the discriminant negative?", Some(TestRecord::Shape(test))) => {
                    assert_eq!(is_yes, test.t.is_none() && test.reason.as_deref() == Some("discriminant negative"));
                }
                (_, Some(TestRecord::Shape(test))) => assert_eq!(is_yes, test.verdict == Verdict::Best, "{what}"),
                (_, Some(TestRecord::Bounds(test))) => assert_eq!(is_yes, test.verdict == Verdict::Entered, "{what}"),
                ("What does the ray hit?", _) => {
                    let object = node.hit.as_ref().and_then(|hit| hit.object.as_deref()).unwrap_or("nothing");
                    assert_eq!(answer, object, "{what}");
                }
                ("Is all light reflected?", _) => assert_eq!(is_yes, node.total_reflection, "{what}"),
                ("Which ray comes next?", _) => {
                    let next = match (&node.reflected, &node.refracted) {
                        (Some(_), _) => "the reflected one",
                        (None, Some(_)) => "the refracted one",
                        (None, None) => "none",
                    };
                    assert_eq!(answer, next, "{what}");
                }
                ("Is this ray traced?", _) => assert_eq!(is_yes, node.outcome.is_traced(), "{what}"),
                _ if ask.starts_with("Is this point lit") => {
                    assert_eq!(answer == "lit", node.outcome == Outcome::Lit, "{what}");
                }
                _ if ask.starts_with("Does the surface face ") => {
                    let light = ask.trim_start_matches("Does the surface face ").trim_end_matches('?');
                    let is_faced = node.shadows.iter().any(|shadow| shadow.light.as_deref() == Some(light));
                    assert_eq!(is_yes, is_faced, "{what}: {ask}");
                }
                other => panic!("{what}: {other:?}"),
            }
        }
    });
    // Each is asked with each of its answers.
    assert!(asked.len() >= 8 && asked.values().all(|counts| counts[0] > 0 && counts[1] > 0), "{asked:?}");
}

#[test]
fn the_diagram_of_every_step_can_be_drawn() {
    let mut drawn = std::collections::HashSet::new();
    for_each_recording(|what, loaded, recording| {
        for step in &recording.steps {
            let picture = step.diagram.unwrap_or_else(|| panic!("{what}: {step:?}"));
            let node = picture.node.unwrap_or(step.node);
            // Once a kind, node and shape.
            if !drawn.insert((what.to_owned(), node, picture.kind, picture.shape, picture.primitive)) {
                continue;
            }
            let path = recording.nodes[node].path.clone();
            let input = Input::new(&loaded.scene, recording.tree, path).unwrap();
            let input = match picture.shape {
                Some(shape) => input.about(Chosen { shape, primitive: picture.primitive }),
                None => input,
            };
            let kind: Kind = picture.kind.parse().unwrap();
            diagram(kind, &input, &Theme::LIGHT).unwrap_or_else(|not| panic!("{what}: {not}: {step:?}"));
        }
        assert_eq!(recording.steps[0].call, Some(Procedure::RayTrace), "{what}");
    });
    assert!(drawn.len() > 500, "{}", drawn.len());
}
