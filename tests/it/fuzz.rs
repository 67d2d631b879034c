//! Damaged scenes and trees by the thousand: a result or an error, never a panic, never a hang, never a colour that is
//! none.

use std::cell::Cell;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use raytree::numbers::Real;
use raytree::scene::{self, Loaded, Numerics};
use raytree::transport::{Options, Tracer};
use raytree::tree::check::read_tree;
use raytree::tree::{Keep, Ledger};

use crate::support::{scene_files, scenes, tracer, tree};

/// One way to damage a text.
#[derive(Clone, Debug)]
enum Damage {
    Cut { at: usize },
    Delete { at: usize, length: usize },
    Repeat { at: usize, length: usize },
    Byte { at: usize, byte: u8 },
    Number { which: usize, by: &'static str },
    Word { which: usize, by: usize },
}

const NUMBERS: [&str; 18] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e-30",
    "1e-45",
    "1e30",
    "3e38",
    "-3e38",
    "1e300",
    "1e999",
    "NaN",
    "65",
    "4294967296",
    "1e-160",
    "0.30000000000000004",
];

fn damage() -> impl Strategy<Value = Damage> {
    let at = || 0..100_000_usize;
    prop_oneof![
        1 => at().prop_map(|at| Damage::Cut { at }),
        1 => (at(), 1..40_usize).prop_map(|(at, length)| Damage::Delete { at, length }),
        1 => (at(), 1..200_usize).prop_map(|(at, length)| Damage::Repeat { at, length }),
        1 => (at(), any::<u8>()).prop_map(|(at, byte)| Damage::Byte { at, byte }),
        // Damage that stays JSON goes deeper.
        12 => (at(), proptest::sample::select(&NUMBERS[..])).prop_map(|(which, by)| Damage::Number { which, by }),
        3 => (at(), at()).prop_map(|(which, by)| Damage::Word { which, by }),
    ]
}

/// The places of numbers, or of words in quotes.
fn tokens(text: &str, is_number: bool) -> Vec<std::ops::Range<usize>> {
    if !is_number {
        let quotes: Vec<usize> = text.match_indices('"').map(|(i, _)| i).collect();
        return quotes.chunks_exact(2).map(|pair| pair[0]..pair[1] + 1).collect();
    }
    let part = |c: char| c.is_ascii_digit() || matches!(c, '-' | '.' | 'e' | '+');
    let mut found = Vec::new();
    let mut from = None;
    for (i, c) in text.char_indices() {
        match (part(c), from) {
            (true, None) if c != 'e' => from = Some(i),
            (false, Some(start)) => {
                found.push(start..i);
                from = None;
            }
            _ => {}
        }
    }
    found
}

fn apply(text: &str, damage: &Damage) -> String {
    let mut bytes = text.as_bytes().to_vec();
    let place = |at: usize| at % bytes.len().max(1);
    match *damage {
        Damage::Cut { at } => bytes.truncate(place(at)),
        Damage::Delete { at, length } => {
            let from = place(at);
            bytes.drain(from..(from + length).min(bytes.len()));
        }
        Damage::Repeat { at, length } => {
            let from = place(at);
            let piece = bytes[from..(from + length).min(bytes.len())].to_vec();
            bytes.splice(from..from, piece);
        }
        Damage::Byte { at, byte } => {
            let at = place(at);
            if let Some(b) = bytes.get_mut(at) {
                *b = byte;
            }
        }
        Damage::Number { which, by } => {
            let found = tokens(text, true);
            if !found.is_empty() {
                bytes.splice(found[which % found.len()].clone(), by.bytes());
            }
        }
        Damage::Word { which, by } => {
            let found = tokens(text, false);
            if !found.is_empty() {
                let by = text[found[by % found.len()].clone()].to_owned();
                bytes.splice(found[which % found.len()].clone(), by.bytes());
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn runner(cases: u32) -> TestRunner {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]))
}

/// Traces a few pixels every way there is.
fn trace(loaded: &mut Loaded) -> Result<(), TestCaseError> {
    // A damaged scene may ask for a million rays a pixel.
    loaded.scene.limits.ray_budget = loaded.scene.limits.ray_budget.min(200);
    for numerics in [Numerics::Lecture, Numerics::Robust, Numerics::Certified] {
        trace_in::<f32>(loaded, numerics)?;
        trace_in::<f64>(loaded, numerics)?;
    }
    Ok(())
}

fn trace_in<R: Real>(loaded: &Loaded, numerics: Numerics) -> Result<(), TestCaseError> {
    let options = Options { numerics, ..Options::of(&loaded.scene) };
    let Ok(tracer) = Tracer::<R>::new(&loaded.scene, options) else { return Ok(()) };
    let (width, height) = (loaded.scene.image.width, loaded.scene.image.height);
    let named = loaded.scene.pixels.iter().map(|(_, pixel)| *pixel).take(1);
    for [x, y] in named.chain([[0, 0], [width / 2, height / 2], [width - 1, height / 3]]) {
        let tree = tree(&tracer, loaded, [x, y], Keep::Steps);
        prop_assert!(
            tree.color.iter().all(|c| c.is_finite()),
            "{numerics} {:?} {x},{y}: {:?}",
            R::PRECISION,
            tree.color
        );
        let written = tree.to_json();
        let again = read_tree("tree.json", &written).map_err(|p| TestCaseError::fail(p.to_string()))?;
        prop_assert_eq!(written, again.to_json());
        let ledger = Ledger::of(&tree);
        prop_assert!(ledger.balances(), "{}", ledger);
    }
    Ok(())
}

#[test]
fn damaged_scenes() {
    let texts: Vec<(String, String)> =
        scene_files().into_iter().map(|file| (file.clone(), std::fs::read_to_string(file).unwrap())).collect();
    let texts: Vec<_> = texts.into_iter().filter(|(_, text)| !text.contains("\"mesh\"")).collect();
    let damages = proptest::collection::vec(damage(), 1..4);
    let (refused, traced) = (Cell::new(0), Cell::new(0));
    let result = runner(4000).run(&(0..texts.len(), damages), |(which, damages)| {
        let (file, text) = &texts[which];
        let text = damages.iter().fold(text.clone(), |text, damage| apply(&text, damage));
        match scene::load_beside(file, &text) {
            Ok(mut loaded) => {
                traced.set(traced.get() + 1);
                trace(&mut loaded)
            }
            Err(problem) => {
                refused.set(refused.get() + 1);
                prop_assert!(!problem.message.is_empty() && !problem.help.is_empty());
                prop_assert!(problem.to_string().lines().count() == 1, "{}", problem);
                Ok(())
            }
        }
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    assert!(refused.get() > 500 && traced.get() > 500, "refused {refused:?}, traced {traced:?}");
}

#[test]
fn damaged_trees() {
    let (_, loaded) = scenes().into_iter().find(|(name, _)| name == "whitted").unwrap();
    let tracer = tracer::<f64>(&loaded.scene);
    let text = tree(&tracer, &loaded, loaded.scene.pixels[0].1, Keep::Steps).to_json();
    let damages = proptest::collection::vec(damage(), 1..4);
    let valid = Cell::new(0);
    let result = runner(1000).run(&damages, |damages| {
        let text = damages.iter().fold(text.clone(), |text, damage| apply(&text, damage));
        if let Ok(tree) = read_tree("tree.json", &text) {
            valid.set(valid.get() + 1);
            // Whatever is a tree can be printed and added up.
            prop_assert!(!tree.to_text(Default::default()).is_empty());
            Ledger::of(&tree).to_string();
        }
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    assert!(valid.get() > 100, "{valid:?}");
}
