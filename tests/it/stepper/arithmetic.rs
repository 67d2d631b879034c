//! What the steps compute: to the bits of the tree, from the JSON and from the printed text.

use std::collections::BTreeMap;

use raytree::numbers::Precision;
use raytree::scene::{Numerics, Shape};
use raytree::steps::{PSEUDOCODE, Recording, Step};
use raytree::tree::{Outcome, TestRecord, Value};
use serde_json::Value as Json;

use super::reader::{Machine, Quantity, quantity};
use super::{for_each_recording, for_each_recording_of};

const WAYS: [(Numerics, Precision); 6] = [
    (Numerics::Lecture, Precision::F64),
    (Numerics::Robust, Precision::F64),
    (Numerics::Certified, Precision::F64),
    (Numerics::Lecture, Precision::F32),
    (Numerics::Robust, Precision::F32),
    (Numerics::Certified, Precision::F32),
];

/// Every line of every step, worked out anew from the JSON alone, and from the printed text alone.
fn replay(what: &str, recording: &Recording<'_>) -> usize {
    let json: Json = serde_json::from_str(&recording.to_json()).unwrap();
    let mut lines = 0;
    for (i, (step, written)) in recording.steps.iter().zip(json["steps"].as_array().unwrap()).enumerate() {
        let Some(arithmetic) = written.get("arithmetic") else {
            assert!(step.arithmetic.is_none());
            continue;
        };
        let form = &json["forms"][arithmetic["form"].as_str().unwrap()];
        let machine = Machine { single: form["precision"] == "f32" };
        let shared = &json["nodes"][step.node]["values"];
        let read = |name: &str| arithmetic["values"].get(name).or_else(|| shared.get(name));
        let mut worked = recording.worked(step).into_iter();
        for line in form["lines"].as_array().unwrap() {
            let name = line["name"].as_str().unwrap();
            let Some(value) = read(name) else { break };
            let value_of =
                |name: &str| quantity(read(name).unwrap_or_else(|| panic!("{what}, step {i}: no {name} in {written}")));
            let again = machine.json(&line["expression"], &value_of);
            assert!(quantity(value).is_same(again), "{what}, step {i}, {name}: {value} {again:?} {written}");

            let text = worked.next().unwrap();
            let (numbers, result) = (machine.text(&text.numbers), machine.text(&text.result));
            assert!(numbers.is_same(result), "{what}, step {i}: {text:?}: {numbers:?} {result:?}");
            assert!(result.is_same(again), "{what}, step {i}: {text:?} {again:?}");
            lines += 1;
        }
        assert!(worked.next().is_none(), "{what}, step {i}");
    }
    lines
}

#[test]
fn every_formula_replays_to_the_same_bits() {
    let mut lines = 0;
    for_each_recording(|what, _, recording| lines += replay(what, recording));
    assert!(lines > 20_000, "{lines}");
}

#[test]
fn in_every_precision_with_every_set_of_kernels() {
    let mut lines = 0;
    for_each_recording_of(&WAYS, |what, _, recording| lines += replay(what, recording));
    assert!(lines > 100_000, "{lines}");
}

/// The value that a step's arithmetic has for a name.
fn value(recording: &Recording<'_>, step: &Step, name: &str) -> Option<Quantity> {
    Some(match recording.value(step, name)? {
        Value::Number(x) => Quantity::Number(x),
        Value::Vector(v) => Quantity::Vector(v),
    })
}

#[test]
fn every_test_has_its_arithmetic_with_the_values_of_the_tree() {
    let (mut compared, mut bounds) = (0, 0);
    for_each_recording_of(&WAYS, |what, _, recording| {
        for step in &recording.steps {
            let at = || format!("{what}: {step:?}");
            let number = |x: f64| Quantity::Number(x);
            match recording.test_of(step) {
                Some(TestRecord::Bounds(test)) => {
                    let is_beside = test.t_in.is_none() && test.t_out.is_none();
                    assert_eq!(step.arithmetic.is_none(), is_beside, "{}", at());
                    for (name, t) in [("t_in", test.t_in), ("t_out", test.t_out)] {
                        if let (Some(t), Some(shown)) = (t, value(recording, step, name)) {
                            assert!(shown.is_same(number(t)), "{}", at());
                            bounds += 1;
                        }
                    }
                }
                Some(TestRecord::Shape(test)) => {
                    assert_eq!(step.arithmetic.is_none(), test.values.0.is_empty(), "{}", at());
                    for (name, recorded) in &test.values.0 {
                        let Some(shown) = value(recording, step, name) else { continue };
                        let recorded = match recorded {
                            Value::Number(x) => number(*x),
                            Value::Vector(v) => Quantity::Vector(*v),
                        };
                        assert!(shown.is_same(recorded), "{}: {name}", at());
                        compared += 1;
                    }
                    // What is shown as t is what the verdict is about, or words say that it is not.
                    if let (Some(t), Some(arithmetic)) = (test.t, &step.arithmetic) {
                        let shown = ["t", "t_in", "t_out"].map(|name| recording.value(step, name));
                        let is_shown = shown.into_iter().flatten().any(|shown| shown == Value::Number(t));
                        assert!(is_shown || arithmetic.note.is_some(), "{}", at());
                    }
                }
                None => {}
            }
        }
    });
    assert!(compared > 10_000 && bounds > 10_000, "{compared} {bounds}");
}

/// Which lines of the pseudocode have no formula although something is computed there, and how often.
fn without_formula(ways: &[(Numerics, Precision)]) -> (BTreeMap<String, usize>, BTreeMap<&'static str, usize>) {
    let (mut without, mut with) = (BTreeMap::new(), BTreeMap::new());
    for_each_recording_of(ways, |_, loaded, recording| {
        for step in &recording.steps {
            let text = PSEUDOCODE[step.line].text;
            if step.arithmetic.is_some() {
                *with.entry(text).or_default() += 1;
                continue;
            }
            let node = recording.nodes[step.node].ray;
            let parent = recording.nodes[step.node].parent.map(|parent| recording.nodes[parent].ray);
            let of = if text.starts_with("r = ") || text.starts_with("t = ") || text.starts_with("share") {
                parent.unwrap()
            } else {
                node
            };
            let hit = of.hit.as_ref();
            let object = hit.map(|hit| &loaded.scene.objects[hit.shape as usize]);
            let material = object.map(|object| &loaded.scene.materials[object.material.0 as usize]);
            let [n_i, n_t] = hit.and_then(|hit| hit.ior).unwrap_or([1.0; 2]);
            let is_computed = match text {
                "p = the hit point" => true,
                "n = the unit normal there, towards the ray" => {
                    matches!(object.unwrap().shape, Shape::Sphere { .. })
                }
                "color = ambient * the surface's color" => material.unwrap().ambient.is_some(),
                "l = the way from p to the light" | "if n . l < 0: return black" => true,
                "return diffuse + specular" | "color = color + direct" | "color = color + back" => true,
                "color = color + through" => true,
                "diffuse = k_d * the surface's color * (n . l) * light" => material.unwrap().diffuse.is_some(),
                "specular = k_s * max(0, r . v)^shininess * light" => material.unwrap().specular.is_some(),
                "if it transmits: Snell's law; total reflection?" => n_i != n_t,
                "R = Fresnel's share" => n_i != n_t && !of.total_reflection,
                "r = d - 2 (d . n) n" => true,
                "t = the direction of Snell's law" => node.direction != of.direction,
                "return share * color" | "return the ray from the eye through the middle of the pixel" => true,
                text if text.starts_with("share = ") => true,
                "else: color = BackgroundColor(ray)" => {
                    node.outcome == Outcome::Background
                        && matches!(loaded.scene.background, raytree::scene::Background::Gradient { .. })
                }
                _ => false,
            };
            if is_computed {
                *without.entry(format!("{text} ({})", object.map_or("", |object| object.shape.kind()))).or_default() +=
                    1;
            }
        }
    });
    (without, with)
}

#[test]
fn what_is_computed_has_its_formula() {
    let (without, with) = without_formula(&WAYS[2..3]);
    assert_eq!(without, BTreeMap::new());
    assert!(with.len() > 18, "{with:?}");
    let (without, with) = without_formula(&WAYS);
    // With other kernels a sphere's centre may be hit, where there is no normal.
    let (missing, count): (usize, usize) = (without.values().sum(), with.values().sum());
    assert!(missing < 4 && count > 50_000, "{without:?} of {with:?}");
}
