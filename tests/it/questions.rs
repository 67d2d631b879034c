//! `raytree exercise`: the answers are recomputed from the text of the questions alone.

use std::collections::BTreeSet;
use std::process::Command;

use raytree::lessons::questions::{Kind, TOLERANCE, questions, to_latex, to_latex_answers, to_markdown, to_moodle};
use raytree::pictures::drawing::Formulas;
use resvg::usvg::roxmltree::{Document, Node};

use crate::commands::{bad, good};

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The numbers that a text gives a name: `o = (1, 2, 3)` or `r = 2`.
fn given(text: &str, name: &str) -> Vec<f64> {
    let (_, rest) = text.split_once(&format!("{name} = ")).unwrap_or_else(|| panic!("no {name} in {text}"));
    let end = rest.find(if rest.starts_with('(') { ')' } else { '\\' }).unwrap();
    rest[..end].trim_start_matches('(').split(", ").map(|number| number.parse().unwrap()).collect()
}

fn vector(text: &str, name: &str) -> Vector {
    given(text, name).try_into().unwrap()
}

/// The answers to a question of a kind, from its text.
fn answers(kind: &str, text: &str) -> Vec<f64> {
    let v = |name: &str| vector(text, name);
    let number = |name: &str| given(text, name)[0];
    match kind {
        "Scalar product and projection" => {
            let (a, b) = (v("a"), v("b"));
            let length = dot(b, b).sqrt();
            vec![dot(a, b), length, dot(a, b) / length]
        }
        "Cross product" => cross(v("a"), v("b")).to_vec(),
        "Ray and plane" => {
            let (q, n) = (v("q"), v("n"));
            vec![dot(q, n), dot(sub(q, v("o")), n) / dot(v("d"), n)]
        }
        // Cramer's rule on o + t d = v2 + a (v0 - v2) + b (v1 - v2).
        "Ray and triangle" => {
            let (o, d, v2) = (v("o"), v("d"), v("v_2"));
            let (e0, e1, s) = (sub(v("v_0"), v2), sub(v("v_1"), v2), sub(o, v2));
            let whole = dot(cross(e0, e1), d);
            let (t, a, b) =
                (-dot(cross(e0, e1), s) / whole, dot(cross(s, e1), d) / whole, dot(cross(e0, s), d) / whole);
            assert!(t > 0.0 && a > 0.0 && b > 0.0 && a + b < 1.0, "{text}");
            vec![t, a, b]
        }
        "Ray and box" => {
            let (o, d, low, high) = (v("o"), v("d"), v("p_{min}"), v("p_{max}"));
            let both = |k: usize| [(low[k] - o[k]) / d[k], (high[k] - o[k]) / d[k]];
            let t_in = (0..3).map(|k| both(k)[0].min(both(k)[1])).fold(f64::MIN, f64::max);
            let t_out = (0..3).map(|k| both(k)[0].max(both(k)[1])).fold(f64::MAX, f64::min);
            assert!(0.0 < t_in && t_in < t_out, "{text}");
            vec![t_in, t_out]
        }
        "Ray and sphere" => {
            let (f, d, r) = (sub(v("o"), v("c")), v("d"), number("r"));
            let (half, middle) = (dot(f, d), dot(d, d));
            let root = (half * half - middle * (dot(f, f) - r * r)).sqrt();
            let (near, far) = ((-half - root) / middle, (-half + root) / middle);
            vec![near, far, if near >= 0.0 { near } else { far }]
        }
        "Reflection" => {
            let (d, n) = (v("d"), v("n"));
            let along = dot(d, n);
            assert!((dot(n, n) - 1.0).abs() < 1e-12 && along < 0.0, "{text}");
            [0, 1, 2].map(|k| d[k] - 2.0 * along * n[k]).to_vec()
        }
        "Refraction" | "Fresnel reflectance" => {
            let (d, n1, n2) = (v("d"), number("n_1"), number("n_2"));
            assert!((dot(d, d) - 1.0).abs() < 1e-12 && v("n") == [0.0, 1.0, 0.0], "{text}");
            let sine = n1 / n2 * d[0];
            let (ci, ct) = (-d[1], (1.0 - sine * sine).sqrt());
            if kind == "Refraction" {
                return vec![ct, sine, -ct];
            }
            let s = (n1 * ci - n2 * ct) / (n1 * ci + n2 * ct);
            let p = (n1 * ct - n2 * ci) / (n1 * ct + n2 * ci);
            let share = 50.0 * (s * s + p * p);
            vec![ct, share, 100.0 - share]
        }
        other => panic!("nobody has looked at {other}"),
    }
}

fn inner<'a>(node: Node<'a, 'a>, path: &[&str]) -> &'a str {
    let mut node = node;
    for name in path {
        node = node.children().find(|child| child.has_tag_name(*name)).unwrap_or_else(|| panic!("no {name}"));
    }
    node.text().unwrap_or_default()
}

#[test]
fn answers_are_recomputed_from_the_text() {
    let mut texts = BTreeSet::new();
    for seed in [0, 1, 2, 17, u64::MAX] {
        let xml = good(&format!("exercise --seed {seed} --count 45 --format moodle"));
        let page = Document::parse(&xml).unwrap();
        let (mut category, mut numerical) = (0, Vec::new());
        for question in page.root_element().children().filter(|node| node.is_element()) {
            match question.attribute("type") {
                Some("category") => category += 1,
                Some("numerical") => numerical.push(question),
                other => panic!("{other:?}"),
            }
        }
        assert_eq!(category, 1);
        // Each question is asked a few times, once for each number.
        let mut before = (String::new(), 0);
        for question in numerical {
            let (number, kind) = inner(question, &["name", "text"]).split_once(' ').unwrap();
            let text = inner(question, &["questiontext", "text"]);
            let (number, letter) = number.split_at(number.len() - 1);
            let place = if before.0 == number { before.1 + 1 } else { 0 };
            before = (number.to_owned(), place);
            assert_eq!(letter, ["a", "b", "c"][place]);
            let answer = question.children().find(|node| node.has_tag_name("answer")).unwrap();
            assert_eq!(answer.attribute("fraction"), Some("100"));
            let told: f64 = inner(answer, &["text"]).parse().unwrap();
            let tolerance: f64 = inner(answer, &["tolerance"]).parse().unwrap();
            let right = answers(kind, text)[place];
            assert!(tolerance == TOLERANCE && (told - right).abs() < tolerance / 10.0, "{told} for {right}: {text}");
            assert!(right.abs() < 200.0, "{text}");
            texts.insert(text.to_owned());
        }
    }
    // Sheets differ: 25 of each kind, hardly one twice.
    assert!(texts.len() > 500, "{}", texts.len());
}

#[test]
fn numbers_are_short() {
    for question in questions(5, &Kind::ALL, 900) {
        for number in question.given.split(|c: char| !(c.is_ascii_digit() || c == '.')) {
            let decimals = number.trim_end_matches('.').split_once('.').map_or(0, |(_, decimals)| decimals.len());
            assert!(decimals <= 2, "{}", question.given);
            let size = number.trim_end_matches('.').parse().unwrap_or(0.0);
            assert!(size <= 40.0, "{}", question.given);
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let line = "exercise --seed 3 --kind sphere,plane --count 5";
    assert_eq!(good(line), good(line));
    // Other seeds give other ones, in every place.
    for (a, b) in questions(3, &Kind::ALL, 18).iter().zip(&questions(4, &Kind::ALL, 18)) {
        assert!(a.kind == b.kind && a.given != b.given, "{}", a.given);
    }
    assert_eq!(good(line), to_markdown(&questions(3, &[Kind::Sphere, Kind::Plane], 5), "Ray tracing, sheet 3"));
    assert_eq!(
        good("exercise --seed 3 --format moodle"),
        to_moodle(&questions(3, &Kind::ALL, 9), "Ray tracing, sheet 3")
    );
}

/// Every formula can be set, and nothing in a document is left open.
#[test]
fn formulas_and_documents_are_whole() {
    let drawn = questions(11, &Kind::ALL, 90);
    let mut set = Formulas::default();
    for question in &drawn {
        for text in std::iter::once(&question.given).chain(question.parts.iter().map(|part| &part.asked)) {
            assert_eq!(text.matches('$').count() % 2, 0, "{text}");
            for tex in text.split('$').skip(1).step_by(2) {
                set.inline(tex).unwrap_or_else(|why| panic!("{tex}: {why}"));
            }
        }
    }
    for page in [to_latex(&drawn, "sheet"), to_latex_answers(&drawn, "sheet")] {
        let mut depth = 0;
        for c in page.chars() {
            depth += i32::from(c == '{') - i32::from(c == '}');
            assert!(depth >= 0);
        }
        assert_eq!(depth, 0);
        for environment in ["document", "enumerate"] {
            let count = |word: &str| page.matches(&format!("\\{word}{{{environment}}}")).count();
            assert_eq!(count("begin"), count("end"));
        }
        let prose: String = page.split('$').step_by(2).collect();
        assert!(!prose.contains(['_', '^', '&', '#', '%']), "{prose}");
        // Where there is a TeX it has the last word.
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("sheet.tex"), &page).unwrap();
        let mut tex = Command::new("pdflatex");
        tex.args(["-interaction=nonstopmode", "-halt-on-error", "sheet.tex"]).current_dir(folder.path());
        if let Ok(output) = tex.output() {
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
        }
    }
}

#[test]
fn questions_and_answers_go_apart() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for (ending, marks) in [("md", ["# Ray", "answers"]), ("tex", ["\\documentclass", "answers"])] {
        let (sheet, key) = (file(&format!("sheet.{ending}")), file(&format!("key.{ending}")));
        assert_eq!(good(&format!("exercise --seed 8 -o {sheet} --answers {key}")), "");
        let [sheet, key] = [sheet, key].map(|file| std::fs::read_to_string(file).unwrap());
        assert!(sheet.starts_with(marks[0]) && !sheet.contains(marks[1]), "{sheet}");
        assert!(key.starts_with(marks[0]) && key.contains(marks[1]), "{key}");
        let parts: usize = questions(8, &Kind::ALL, 9).iter().map(|question| question.parts.len()).sum();
        assert_eq!(
            key.lines().filter(|line| line.contains("| ") || line.contains("  \\item ")).count()
                - usize::from(ending == "md"),
            parts
        );
    }
    assert_eq!(good(&format!("exercise --seed 8 -o {}", file("quiz.xml"))), "");
    assert!(std::fs::read_to_string(file("quiz.xml")).unwrap().starts_with("<?xml"));
    assert!(bad(2, &format!("exercise --seed 8 -o {} --answers {}", file("a.xml"), file("b"))).contains("Moodle"));
    assert!(bad(2, &format!("exercise --seed 8 -o {0} --answers {0}", file("a.md"))).contains("same place"));
    assert!(bad(2, "exercise --seed 8 --answers -").contains("same place"));
    assert!(bad(2, "exercise --seed 8 --kind spere").contains("did you mean `sphere`"));
    assert!(bad(2, "exercise").contains("--seed"));
    assert!(bad(3, &format!("exercise --seed 8 -o {}", file("nowhere/a.md"))).contains("cannot be written"));
    assert!(good("exercise --help").contains("refraction"));
}
