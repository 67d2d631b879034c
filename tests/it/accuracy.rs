//! What accuracy costs in time: the counts are right and repeat, and the report is whole.

use std::path::Path;
use std::process::Command;
use std::sync::atomic::AtomicBool;

use raytree::accuracy::forms::{Boxes, Form, Planes, Refractions, Spheres, Subject, Triangles};
use raytree::accuracy::images::{self, Reference, Varied};
use raytree::accuracy::maps::{Place, SIDE};
use raytree::accuracy::report::{Plan, Progress, Report};
use raytree::accuracy::verdicts::{Effort, count};
use raytree::accuracy::{charts, export};
use raytree::numbers::Real;
use raytree::pictures::theme::Theme;
use raytree::scene::load_beside;

struct Quiet;

impl Progress for Quiet {
    fn begin(&self, _: &str, _: u64) {}
    fn step(&self, _: u64) {}
}

const EFFORT: Effort = Effort { cases: 400, one_in: 10, values: 100, seed: 3 };

fn go_on() -> AtomicBool {
    AtomicBool::new(false)
}

/// Every form on every set: how many wrong verdicts the certified form has, and all the plain forms together.
fn wrong<S: Subject, R: Real>() -> (usize, usize) {
    let counts = count::<S, R>(EFFORT, &go_on(), &|_| ()).unwrap();
    let sum = |is_counted: fn(Form) -> bool| {
        let forms = counts.iter().flat_map(|c| &c.forms).filter(|f| is_counted(f.form));
        forms.map(|f| f.wrong()).sum()
    };
    for c in &counts {
        assert_eq!(c.stages.iter().sum::<usize>(), c.cases, "{c:?}");
        assert!(c.refereed >= c.cases - c.stages[0] && c.hits <= c.cases, "{c:?}");
        let largest =
            c.forms.iter().filter(|f| f.form == Form::Certified).map(|f| f.t_errors.0[8..].iter().sum::<usize>());
        // A filter's t is good to 2^-36; where exact stages gave it, to a few ulp.
        assert!(R::PRECISION == raytree::numbers::Precision::F64 || largest.sum::<usize>() == 0, "{c:?}");
    }
    (
        sum(|form| matches!(form, Form::Certified | Form::Exact)),
        sum(|form| !matches!(form, Form::Certified | Form::Exact)),
    )
}

#[test]
fn exact_forms_are_never_wrong_and_plain_ones_are() {
    for (certified, plain) in [
        wrong::<Triangles, f32>(),
        wrong::<Triangles, f64>(),
        wrong::<Spheres, f32>(),
        wrong::<Spheres, f64>(),
        wrong::<Boxes, f32>(),
        wrong::<Boxes, f64>(),
        wrong::<Planes, f32>(),
        wrong::<Planes, f64>(),
        wrong::<Refractions, f32>(),
        wrong::<Refractions, f64>(),
    ] {
        assert_eq!(certified, 0);
        assert!(plain > 50, "{plain}");
    }
}

#[test]
fn a_seed_gives_the_same_counts() {
    let counts = |seed| count::<Spheres, f64>(Effort { seed, ..EFFORT }, &go_on(), &|_| ()).unwrap();
    assert_eq!(counts(3), counts(3));
    assert_ne!(counts(3), counts(4));
    assert!(count::<Spheres, f64>(Effort { cases: 5000, ..EFFORT }, &AtomicBool::new(true), &|_| ()).is_none());
}

/// The certified form's map has no wrong cell by definition; here its cells stand against the exact form's, and every
/// other map has some.
#[test]
fn maps_show_what_is_wrong() {
    for place in Place::ALL {
        let forms: Vec<Form> = place.forms().collect();
        for map in place.maps::<f32>(&forms).into_iter().chain(place.maps::<f64>(&forms)) {
            assert_eq!(map.cells.len(), SIDE * SIDE);
            assert_eq!(map.wrong() == 0, map.form == Form::Certified, "{place:?} {:?} {}", map.form, map.precision);
        }
    }
    for place in [Place::SharedEdge, Place::Vertex, Place::Tangent] {
        assert!(place.maps::<f64>(&[Form::Exact]).iter().all(|map| map.wrong() == 0), "{place:?}");
    }
}

/// `UPDATE_PAGES=1 cargo test accuracy` writes them anew.
#[test]
fn the_maps_on_the_first_page_are_made_by_the_program() {
    for (place, file) in [(Place::SharedEdge, "map-shared-edge"), (Place::Tangent, "map-tangent")] {
        let forms: Vec<Form> = place.forms().collect();
        let maps: Vec<_> = place.maps::<f32>(&forms).into_iter().chain(place.maps::<f64>(&forms)).collect();
        let png = charts::map(place, &maps, &Theme::LIGHT).to_png(2.0).unwrap();
        let path = format!("docs/accuracy/{file}.png");
        if std::env::var_os("UPDATE_PAGES").is_some() {
            std::fs::write(&path, &png).unwrap();
        }
        assert!(std::fs::read(&path).unwrap() == png, "{path}: UPDATE_PAGES=1 cargo test accuracy");
    }
}

#[test]
fn images_differ_by_what_is_varied() {
    let text = std::fs::read_to_string("scenes/whitted.json").unwrap();
    let scene = images::reduced(&load_beside("scenes/whitted.json", &text).unwrap().scene, 600);
    assert!(scene.image.width * scene.image.height <= 600);
    let reference = Reference::of(&scene, 3);
    let errors = images::errors(&scene, reference, &go_on(), &|| ()).unwrap().unwrap();
    let of = |varied: Varied| errors.iter().filter(move |e| e.variant.varied == varied);
    let itself = errors.iter().find(|e| e.variant.name() == "certified f64").unwrap();
    assert_eq!((itself.rmse_at_centers, itself.worst, itself.other_shape), (0.0, 0.0, Some(0.0)));
    let by_depth: Vec<f64> = of(Varied::Depth).map(|e| e.rmse_at_centers).collect();
    assert!(by_depth.is_sorted_by(|a, b| a >= b) && by_depth[0] > 0.01 && by_depth.ends_with(&[0.0]), "{by_depth:?}");
    let by_weight: Vec<f64> = of(Varied::MinWeight).map(|e| e.rmse_at_centers).collect();
    assert!(by_weight.is_sorted_by(|a, b| a >= b) && by_weight[0] > 0.0, "{by_weight:?}");
    let by_samples: Vec<f64> = of(Varied::Samples).map(|e| e.rmse).collect();
    assert!(by_samples.first() > by_samples.last(), "{by_samples:?}");
    let lecture = errors.iter().find(|e| e.variant.name() == "lecture f32").unwrap();
    assert!(lecture.rmse_at_centers > 0.0);
}

fn raytree(args: &[&str]) -> (i32, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_raytree")).args(args).output().unwrap();
    assert!(output.stdout.is_empty());
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn the_report_is_whole() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("report");
    let (code, said) =
        raytree(&["accuracy", "--quick", "scenes/hard/shared-edge.json", "-o", report.to_str().unwrap()]);
    assert_eq!((code, said.as_str()), (0, ""));
    let page = std::fs::read_to_string(report.join("index.html")).unwrap();
    let mut links = 0;
    for attribute in ["href=\"", "src=\"", "srcset=\""] {
        for link in page.split(attribute).skip(1).map(|rest| rest.split('"').next().unwrap()) {
            assert!(!link.contains("//") && report.join(link).is_file(), "{link}");
            links += 1;
        }
    }
    assert!(links > 60, "{links}");
    let json: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(report.join("figures.json")).unwrap()).unwrap();
    assert_eq!(json["plan"]["seed"], 1);
    assert!(json["scene"]["pixels_by_dearest_stage"][0].as_u64() > Some(100));
    let verdicts = std::fs::read_to_string(report.join("verdicts.csv")).unwrap();
    let certified: Vec<&str> = verdicts.lines().filter(|line| line.contains(",certified,")).collect();
    assert!(certified.len() > 60 && certified.iter().all(|line| line.ends_with(",0,0,0")), "{certified:?}");
    // Counts, maps and image errors are those that the library finds.
    let again = Report::measure(Plan { rounds: 1, ..Plan::QUICK }, None, &Quiet, &go_on()).unwrap().unwrap();
    for table in export::tables(&again).iter().filter(|t| ["verdicts", "t-errors", "maps"].contains(&t.file)) {
        let written = std::fs::read_to_string(report.join(table.file).with_extension("csv")).unwrap();
        assert!(written == table.to_csv(), "{}", table.file);
    }
}

#[test]
fn what_cannot_be_reported_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("report");
    let (code, said) = raytree(&["accuracy", "--quick", "no-scene.json", "-o", report.to_str().unwrap()]);
    assert!(code == 2 && said.contains("no-scene.json") && !report.exists(), "{code} {said}");
    std::fs::write(&report, "a file").unwrap();
    let (code, said) = raytree(&["accuracy", "--quick", "-o", report.to_str().unwrap()]);
    assert!(code == 3 && said.contains("cannot be written"), "{code} {said}");
    assert_eq!(std::fs::read_to_string(&report).unwrap(), "a file");
    assert_eq!(raytree(&["accuracy", "--quick", "--full", "-o", "x"]).0, 2);
    assert!(!Path::new("x").exists());
}
