//! `raytree diff`: where two trees part, or two forests.

use std::collections::BTreeMap;

use super::failure::Failure;
use super::files;
use super::output::Target;
use super::picture::{Format, LookArgs};
use super::trees::{Forest, Trees};
use crate::faults::{Fault, Named, name_fault, right_tree};
use crate::input::{Problem, printable};
use crate::pictures::diagrams::parting;
use crate::scene::{self, Loaded};
use crate::tree::check::read_tree;
use crate::tree::diff::{Difference, ForestDifference, Tolerance, Tolerances, diff};
use crate::tree::{self, RayTree};

/// Says where two ray trees part first, and what follows from it; or in what the pixels of two forests part
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  raytree diff ours.json theirs.json
  raytree diff ours.json theirs.json --relative 1e-9 --tolerance radiance=1e-3 -o parting.svg
  raytree diff ours.json theirs.json --scene scenes/whitted.json
  raytree diff before.ndjson after.ndjson

Where the scene is known, by --scene or because the file that a tree names is there and has its hash, the classic faults
are planted one by one in a small tracer, and the one that gives the tree is named.
A forest has one JSON tree a line (`raytree forest`), or trees in an array; its trees are aligned by `pixel`.
Exits with 1 where they part. Tolerances are of a field's scale: for lengths the largest coordinate on the way from the
eye, for other numbers 1, or the number itself where it is larger.")]
pub(super) struct Args {
    /// A tree or a forest: what is taken for right; - for standard input
    a: String,
    /// A tree or a forest to be compared with it
    b: String,
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Draw the two trees side by side as well: a path ending in .png or .svg
    #[arg(short, long, value_name = "FILE")]
    output: Option<String>,
    /// Numbers may be so many units in the last place apart; 0 asks for equal ones
    #[arg(long, value_name = "N", conflicts_with = "relative", allow_negative_numbers = true)]
    ulps: Option<String>,
    /// Numbers may be apart by this share [default: 1e-6; 1e-3 where a tree is of f32]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    relative: Option<String>,
    /// Tolerance of one field: hit.t=4ulp, radiance=1e-3; may be given several times
    #[arg(long, value_name = "FIELD=TOLERANCE")]
    tolerance: Vec<String>,
    /// The scene of both trees, to name the fault that gives one of them [default: the file that they name]
    #[arg(long, value_name = "FILE")]
    scene: Option<String>,
    #[command(flatten)]
    look: LookArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let format = args.output.as_deref().map(Format::of).transpose()?;
    let target = Target::new(args.output.as_deref(), &[&args.a, &args.b])?;
    if args.output.is_some() && target.is_same(&Target::Stdout) {
        let message = "the picture and the words would go to the same place";
        return Err(Problem::new("-", message, "a file for the picture").into());
    }
    if args.a == "-" && args.b == "-" {
        return Err(Problem::new("-", "both trees would come from standard input", "a file for one of them").into());
    }
    // What is wrong with a tolerance is said before anything is read.
    tolerances(args, Tolerances::default())?;
    match (Trees::open(&args.a)?, Trees::open(&args.b)?) {
        (Trees::One(a, text_a), Trees::One(b, text_b)) => {
            let mut difference = diff(&a, &b, &tolerances(args, Tolerances::of(&a, &b))?);
            for (name, file, text) in [("A", &args.a, text_a), ("B", &args.b, text_b)] {
                if let Err(problem) = read_tree(files::shown(file), &text) {
                    difference.notes.push(contradiction(name, &problem));
                }
            }
            let fault = name(args, &a, &b, &mut difference)?;
            if args.json {
                let report = Report { difference: &difference, fault };
                Target::Stdout.write(|out| tree::write_indented(out, &report))?;
            } else {
                let words = fault.map_or(String::new(), |fault| format!("\n{}", fault.named.to_text(fault.tree)));
                Target::Stdout.write_all((difference.to_text() + &words).as_bytes())?;
            }
            if let Some(format) = format {
                let drawing = parting(&a, &b, &difference, args.look.theme());
                target.write_all(&format.encode(&drawing, args.look.scale)?)?;
            }
            if difference.is_same() { Ok(()) } else { Err(Failure::No) }
        }
        (a, b) => {
            if let Some(file) = &args.output {
                let help = "a picture is of two trees: `raytree pixel SCENE PIXEL --json` writes one";
                return Err(Problem::new(file, "two forests are too large for a picture", help).into());
            }
            let difference = forests(args, a.into_forest(&args.a), b.into_forest(&args.b))?;
            let text = if args.json { difference.to_json() } else { difference.to_text() };
            Target::Stdout.write_all(text.as_bytes())?;
            if difference.is_same() { Ok(()) } else { Err(Failure::No) }
        }
    }
}

/// A difference, and the fault behind it.
#[derive(serde::Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    difference: &'a Difference,
    #[serde(skip_serializing_if = "Option::is_none")]
    fault: Option<Faulty>,
}

/// The tree that has a fault, and which.
#[derive(serde::Serialize)]
struct Faulty {
    tree: &'static str,
    #[serde(flatten)]
    named: Named,
}

/// The fault that gives one of two trees that part, where the scene is known. What keeps it from being looked for is noted.
fn name(args: &Args, a: &RayTree, b: &RayTree, difference: &mut Difference) -> Result<Option<Faulty>, Failure> {
    if difference.is_same() {
        return Ok(None);
    }
    let loaded = match &args.scene {
        Some(file) => Some(files::load_scene(file)?),
        // The file that a tree names may be gone, or be another one by now: then nobody asked for it.
        None => [b, a].into_iter().find_map(|tree| {
            let scene = tree.scene.as_ref().filter(|scene| scene.sha256.is_some())?;
            scene::load_file(&scene.file).ok().filter(|loaded| is_of(tree, loaded))
        }),
    };
    let Some(loaded) = loaded else { return Ok(None) };
    let says_otherwise = |tree: &RayTree| {
        let hash = tree.scene.as_ref().and_then(|scene| scene.sha256.as_ref());
        hash.is_some() && !is_of(tree, &loaded)
    };
    if args.scene.is_some() {
        for (which, _) in [("A", a), ("B", b)].into_iter().filter(|(_, tree)| says_otherwise(tree)) {
            difference.notes.push(format!("{which} is of another scene than --scene: no fault is looked for in it"));
        }
    }
    let mut checked = false;
    for (which, tree) in [("B", b), ("A", a)].into_iter().filter(|(_, tree)| !says_otherwise(tree)) {
        let Some(right) = right_tree(&loaded, tree) else {
            difference.notes.push(format!("{which} has no place in the scene {}", printable(&loaded.file)));
            continue;
        };
        let tolerances = tolerances(args, Tolerances::of(&right, tree))?;
        if diff(&right, tree, &tolerances).is_same() {
            continue;
        }
        checked = true;
        if let Some(named) = name_fault(&loaded, tree, &tolerances) {
            return Ok(Some(Faulty { tree: which, named }));
        }
    }
    if checked {
        difference.notes.push(format!("none of the {} classic faults alone gives that tree", Fault::ALL.len()));
    }
    Ok(None)
}

/// Whether a tree says that it was traced in this scene.
fn is_of(tree: &RayTree, loaded: &Loaded) -> bool {
    let hash = tree.scene.as_ref().and_then(|scene| scene.sha256.as_ref());
    hash.is_some_and(|hash| hash.eq_ignore_ascii_case(&loaded.sha256))
}

/// That a tree can be compared, but is not as trees are.
fn contradiction(name: &str, problem: &Problem) -> String {
    let path = problem.path.as_deref().map_or(String::new(), |path| format!(" at {}", printable(path)));
    format!("{name} is no valid tree{path}: {}", problem.message)
}

/// The tolerances that the command line asks for, on top of those that suit the trees.
fn tolerances(args: &Args, mut tolerances: Tolerances) -> Result<Tolerances, Failure> {
    let wrong = |option: &str, words: &str, help: String| {
        Failure::Input(Problem::new(option, format!("`{}` is no tolerance", printable(words)), help))
    };
    let number = |option: &str, words: &str| {
        let number = words.trim().parse::<f64>().ok().filter(|x| *x >= 0.0 && x.is_finite());
        number.ok_or_else(|| wrong(option, words, "a number of 0 or more".to_owned()))
    };
    if let Some(ulps) = &args.ulps {
        tolerances.all = Tolerance::Ulps(number("--ulps", ulps)?);
    }
    if let Some(relative) = &args.relative {
        tolerances.all = Tolerance::Relative(number("--relative", relative)?);
    }
    for words in &args.tolerance {
        tolerances.set(words).map_err(|help| wrong("--tolerance", words, help))?;
    }
    Ok(tolerances)
}

/// Compares two forests as they are read. Where both have their pixels in the same order, no more than a tree of each is kept.
fn forests(args: &Args, mut a: Forest, mut b: Forest) -> Result<ForestDifference, Failure> {
    let mut difference = ForestDifference::default();
    // Trees that wait for that of the same pixel.
    let (mut waiting_a, mut waiting_b): (BTreeMap<[u32; 2], RayTree>, BTreeMap<[u32; 2], RayTree>) = Default::default();
    let mut compare = |pixel: [u32; 2], a: &RayTree, b: &RayTree| {
        let tolerances = tolerances(args, Tolerances::of(a, b))?;
        difference.add(pixel, &diff(a, b, &tolerances));
        Ok::<(), Failure>(())
    };
    let twice = |file: &str, [x, y]: [u32; 2]| {
        Problem::new(files::shown(file), format!("pixel {x},{y} is there twice"), "one tree a pixel")
    };
    loop {
        let next = (a.next()?, b.next()?);
        if next.0.is_none() && next.1.is_none() {
            break;
        }
        if let (Some((p, tree_a)), Some((q, tree_b))) = &next
            && p == q
        {
            compare(*p, tree_a, tree_b)?;
            continue;
        }
        if let Some((pixel, tree)) = next.0 {
            match waiting_b.remove(&pixel) {
                Some(other) => compare(pixel, &tree, &other)?,
                None if waiting_a.insert(pixel, tree).is_some() => return Err(twice(&args.a, pixel).into()),
                None => {}
            }
        }
        if let Some((pixel, tree)) = next.1 {
            match waiting_a.remove(&pixel) {
                Some(other) => compare(pixel, &other, &tree)?,
                None if waiting_b.insert(pixel, tree).is_some() => return Err(twice(&args.b, pixel).into()),
                None => {}
            }
        }
    }
    difference.only_in_a = waiting_a.len() as u64;
    difference.only_in_b = waiting_b.len() as u64;
    Ok(difference.sorted())
}
