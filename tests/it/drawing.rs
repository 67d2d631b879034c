//! Drawings: both outputs, labels that stay apart, numbers that cannot be drawn, and the charts.

use glam::DVec2;
use raytree::numbers::Stage;
use raytree::pictures::charts::{self, Axis, Heading, Scale};
use raytree::pictures::drawing::{
    Align, Color, Dash, Drawing, Face, Level, Path, Pen, Raster, Rect, Sampling, Text, Wanted, Words, around, cover,
};
use raytree::pictures::theme::{Hue, Mark, Method, Theme, Verdict};
use raytree::tree::Kind;
use resvg::{tiny_skia, usvg};

/// A bit of everything, small.
fn sampler(theme: &Theme) -> Drawing {
    let mut drawing = Drawing::new(200.0, 120.0, theme.background, "A <sampler>");
    drawing.describe("Paths, \"text\", a raster & a clip.");
    drawing.fill(Path::rounded(Rect::new((8.0, 8.0), (60.0, 40.0)), 6.0), theme.panel);
    drawing.stroke(Path::circle((38.0, 28.0), 14.0), Pen::new(theme.hue(Hue::Blue), 2.0).dashed(Dash::Dashed));
    drawing.line((8.0, 60.5), (90.0, 60.5), Pen::new(theme.hue(Hue::Amber), 3.0).dashed(Dash::Dotted));
    drawing.stroke(Path::arc((120.0, 50.0), 20.0, 0.0, -2.5), Pen::new(theme.ink, 1.5));
    drawing.disk((120.0, 50.0), 3.0, theme.hue(Hue::Vermilion).fade(0.5));
    let raster = Raster::from_fn(4, 2, |x, y| theme.heat(f64::from(x + 4 * y) / 7.0));
    drawing.image(raster, Rect::new((150.0, 8.0), (40.0, 20.0)), Sampling::Nearest);
    drawing.clipped(Path::polygon([(150.0, 70.0), (190.0, 40.0), (190.0, 70.0)].map(DVec2::from)), |drawing| {
        for i in 0..12 {
            let x = 140.0 + 5.0 * f64::from(i);
            drawing.line((x, 80.0), (x + 20.0, 36.0), Pen::new(theme.hue(Hue::Green), 1.0));
        }
    });
    drawing.text((8.0, 84.0), "AVA θ₁ ≤ 90°", Text::new(14.0, theme.ink));
    drawing.text(
        (190.0, 84.0),
        Words::from("10").raised("−3"),
        Text::new(14.0, theme.ink).anchor(Align::End, Level::Baseline),
    );
    drawing.text((8.0, 104.0), "└─ hit", Text::new(12.0, theme.muted).face(Face::Mono));
    let theta = drawing.angle((75.0, 112.0), DVec2::X, DVec2::new(0.6, -0.8), 12.0, Pen::new(theme.ink, 1.0));
    drawing.arrow((75.0, 112.0), (95.0, 88.0), Pen::new(theme.hue(Hue::Purple), 1.5));
    drawing.text(theta, Words::default().tex(r"\theta_1"), Text::new(11.0, theme.ink));
    drawing.hatch(Path::circle((180.0, 104.0), 10.0), DVec2::ONE, 4.0, Pen::new(theme.axis, 0.8));
    drawing.text((140.0, 112.0), "up", Text::new(12.0, theme.ink).face(Face::Bold).upwards());
    drawing
}

/// What diagrams are made of.
fn diagram(theme: &Theme) -> Drawing {
    let mut drawing = Drawing::new(420.0, 300.0, theme.background, "A surface");
    let (text, thin) = (Text::new(14.0, theme.ink), Pen::new(theme.ink, 1.0));
    let tex = |tex: &str| Words::default().tex(tex);
    let (hit, n) = (DVec2::new(130.0, 110.0), DVec2::NEG_Y);
    let (incident, reflected) = (DVec2::new(0.6, 0.8), DVec2::new(0.6, -0.8));
    drawing.ground((20.0, 110.0), (240.0, 110.0), 12.0, Pen::new(theme.axis, 1.0));
    drawing.line((20.0, 110.0), (240.0, 110.0), thin);
    drawing.arrow(hit, hit + 80.0 * n, thin);
    drawing.directed(hit - 100.0 * incident, hit, 0.5, theme.ray(Kind::Camera, 2.0));
    drawing.directed(hit, hit + 100.0 * reflected, 0.5, theme.ray(Kind::Reflected, 2.0));
    drawing.right_angle(hit, DVec2::NEG_X, n, 9.0, thin);
    for (from, to) in [(-incident, n), (n, reflected)] {
        let at = drawing.angle(hit, from, to, 36.0, thin);
        drawing.text(at, tex(r"\theta_1"), text.anchor(Align::Middle, Level::Middle));
    }
    let ends = drawing.dimension((30.0, 180.0), (200.0, 200.0), -16.0, thin);
    let middle = around(ends[0].midpoint(ends[1]), 8.0);
    drawing.label(tex(r"\sqrt{r^2 - h^2}"), text, &middle, drawing.canvas(), &cover(&ends));
    let root = r"t = \frac{-b \pm \sqrt{b^2 - 4ac}}{2a},\quad \hat{\mathbf n} \cdot \vec d";
    drawing.text((250.0, 40.0), Words::default().display_tex(root), Text::new(11.0, theme.ink));
    drawing.text((250.0, 75.0), Words::from("hit at ").tex(r"t_{\mathrm{in}} = 1.2\times 10^{-6}"), text);
    // More points than there is room for at first sight.
    let dots: Vec<DVec2> =
        (0..6).map(|i| DVec2::new(280.0 + 16.0 * f64::from(i), 150.0 + 5.0 * f64::from(i % 3))).collect();
    let obstacles: Vec<Rect> = dots.iter().map(|at| Rect { min: *at, max: *at }.grown(3.0)).collect();
    let name =
        |(i, dot): (usize, &DVec2)| Wanted { words: tex(&format!("t_{i} = 1.{i}07")), text, places: around(*dot, 7.0) };
    let names: Vec<Wanted> = dots.iter().enumerate().map(name).collect();
    let rects = drawing.label_all(&names, drawing.canvas().grown(-4.0), &obstacles);
    for (dot, rect) in dots.into_iter().zip(rects) {
        drawing.disk(dot, 2.5, theme.hue(Hue::Vermilion));
        drawing.leader(dot, rect.unwrap(), 10.0, Pen::new(theme.muted, 0.8));
    }
    let lines = ["camera  hit ball  t 3.75", "├─ shadow  lit", "└─ reflected  background, and more than fits"];
    drawing.listing((20.0, 235.0), &lines.map(str::to_owned), 220.0, 11.0, theme.ink);
    drawing
}

/// Drawings in a drawing.
fn sheet(theme: &Theme) -> Drawing {
    let mut sheet = Drawing::new(640.0, 320.0, theme.background, "A sheet");
    sheet.place(&diagram(theme), (10.0, 10.0), 1.0);
    sheet.place(&sampler(theme), (435.0, 10.0), 0.9);
    sheet.place(&sampler(theme), (435.0, 160.0), 0.5);
    sheet
}

fn heading() -> Heading {
    Heading { title: "A title".into(), note: "A note that says how this was made, and how to read it.".into() }
}

fn axis(title: &str, scale: Scale) -> Axis {
    Axis { title: title.into(), scale }
}

fn scatter(theme: &Theme) -> Drawing {
    // Crowded on purpose: half of the points are never wrong and about equally fast.
    let rows = [
        ("lecture f32", Method::Lecture, 3.1, 8210.0),
        ("lecture f64", Method::Lecture, 3.4, 310.0),
        ("Möller–Trumbore f32", Method::MollerTrumbore, 2.2, 4400.0),
        ("Möller–Trumbore f64", Method::MollerTrumbore, 2.5, 120.0),
        ("watertight f32", Method::Watertight, 3.9, 0.0),
        ("watertight f64", Method::Watertight, 4.1, 0.0),
        ("certified f32", Method::Certified, 2.6, 0.0),
        ("certified f64", Method::Certified, 2.85, 0.0),
        ("exact", Method::Exact, 410.0, 0.0),
    ];
    let points = rows.map(|(name, method, x, y)| {
        let (color, mark) = theme.method(method);
        let y_spread = (y > 0.0).then_some((0.8 * y, 1.3 * y));
        charts::Point { name: name.into(), color, mark, x, y, x_spread: Some((0.93 * x, 1.12 * x)), y_spread }
    });
    let chart = charts::Scatter {
        heading: heading(),
        x: axis("nanoseconds per test", Scale::log_around(points.iter().map(|p| p.x))),
        y: axis("wrong verdicts per million", Scale::log_around(points.iter().map(|p| p.y))),
        points: points.to_vec(),
        front: Some("nothing is both faster and more often right".into()),
    };
    charts::scatter(&chart, theme)
}

fn histograms(theme: &Theme) -> Drawing {
    let bins = ["0", "1", "2", "3–4", "5–8", "9–16", "17–32", "33–64", "65–128"].map(Words::from);
    let bins = [bins.as_slice(), &[Words::from("> 2").raised("7")]].concat();
    let series = ["lecture f32", "lecture f64", "certified f64", "a name as long as a name can sensibly be"];
    let series = series.map(|name| charts::Histogram {
        name: name.into(),
        note: String::new(),
        color: theme.hue(Hue::Vermilion),
        counts: vec![90_000, 12_000, 1300, 140, 17, 2, 1, 0, 0, 1],
    });
    let chart = charts::Histograms {
        heading: heading(),
        bins_title: "error of t in ulp".into(),
        bins,
        counts_title: "rays (logarithmic)".into(),
        series: series.to_vec(),
        columns: 3,
    };
    charts::histograms(&chart, theme)
}

fn shares(theme: &Theme) -> Drawing {
    let parts = [
        ("filter", Stage::Filter),
        ("integer", Stage::Integer),
        ("double-double", Stage::DoubleDouble),
        ("expansion", Stage::Expansion),
    ];
    let parts = parts.map(|(name, stage)| charts::Part { name: name.into(), color: theme.stage(stage) }).to_vec();
    let rows = [("random", [1.0, 0.0, 0.0, 0.0]), ("edge-aimed", [0.41, 0.33, 0.25999, 0.00001])];
    let rows = rows.map(|(name, shares)| charts::ShareRow { name: name.into(), shares: shares.into() }).to_vec();
    charts::shares(&charts::Shares { heading: heading(), parts, rows }, theme)
}

fn lines(theme: &Theme) -> Drawing {
    let line = |name: &str, hue, mark, y: [f64; 4]| charts::Line {
        name: name.into(),
        color: theme.hue(hue),
        dash: Dash::Solid,
        mark,
        points: [1e-9, 1e-6, 1e-3, 1.0].into_iter().zip(y).collect(),
    };
    let lines = vec![
        line("self-hits", Hue::Vermilion, Mark::Disk, [5e5, 1e3, 0.0, 0.0]),
        line("lost shadows", Hue::Blue, Mark::Square, [0.0, 0.2, 4e2, 3e5]),
        line("both, by provenance", Hue::Green, Mark::Diamond, [0.0; 4]),
    ];
    let chart = charts::Lines {
        heading: heading(),
        x: axis("epsilon", Scale::Log(1e-10, 10.0)),
        y: axis("wrong per million", Scale::log_around(lines.iter().flat_map(|l| l.points.iter().map(|p| p.1)))),
        lines,
    };
    charts::lines(&chart, theme)
}

fn panels(theme: &Theme) -> Drawing {
    let raster = Raster::from_fn(24, 16, |x, y| match x.cmp(&y) {
        std::cmp::Ordering::Less => theme.verdict(Verdict::Hit),
        std::cmp::Ordering::Equal => theme.verdict(Verdict::FalseMiss),
        std::cmp::Ordering::Greater => theme.verdict(Verdict::Miss),
    });
    let panel =
        |caption: &str| charts::Panel { caption: caption.into(), note: "1 wrong".into(), raster: raster.clone() };
    let chart = charts::Panels {
        heading: heading(),
        panels: vec![
            panel("lecture"),
            panel("a caption that is much too long for what is below it"),
            panel("certified"),
        ],
        columns: 2,
        factor: 6,
        key: vec![charts::Key { color: theme.verdict(Verdict::Hit), meaning: "hit".into() }],
        ramp: Some(charts::Ramp {
            title: "tests".into(),
            colors: (0..8).map(|i| theme.heat(f64::from(i) / 7.0)).collect(),
            low: "0".into(),
            high: "128".into(),
        }),
    };
    charts::panels(&chart, theme)
}

type Draw = fn(&Theme) -> Drawing;
const ALL: [(&str, Draw); 8] = [
    ("sampler", sampler),
    ("diagram", diagram),
    ("sheet", sheet),
    ("scatter", scatter),
    ("histograms", histograms),
    ("shares", shares),
    ("lines", lines),
    ("panels", panels),
];

#[test]
fn a_small_drawing_as_svg() {
    insta::assert_snapshot!(sampler(&Theme::LIGHT).to_svg().unwrap());
}

/// Debug and release builds are held to the same hashes.
#[test]
fn hashes_of_drawings() {
    use sha2::{Digest, Sha256};
    let mut lines = String::new();
    for (ground, theme) in [("light", &Theme::LIGHT), ("dark", &Theme::DARK)] {
        for (name, draw) in ALL {
            let drawing = draw(theme);
            let png = Sha256::digest(drawing.to_raster(1.5).unwrap().rgba);
            let svg = Sha256::digest(drawing.to_svg().unwrap());
            let hex = |bytes: &[u8]| bytes.iter().take(8).map(|b| format!("{b:02x}")).collect::<String>();
            lines += &format!("{name} {ground}: pixels {}, SVG {}\n", hex(&png), hex(&svg));
        }
    }
    insta::assert_snapshot!(lines);
}

#[test]
fn the_same_calls_give_the_same_bytes() {
    for (name, draw) in ALL {
        let (a, b) = (draw(&Theme::DARK), draw(&Theme::DARK));
        assert_eq!(a.to_svg(), b.to_svg(), "{name}");
        assert_eq!(a.to_png(1.0), b.to_png(1.0), "{name}");
    }
}

#[test]
fn labels_stay_on_the_canvas_and_off_each_other() {
    for theme in [&Theme::LIGHT, &Theme::DARK] {
        for (name, draw) in ALL {
            let drawing = draw(theme);
            assert!(!drawing.labels().is_empty(), "{name}");
            for (i, label) in drawing.labels().iter().enumerate() {
                assert!(drawing.canvas().contains(label.rect), "{name}: {label:?} leaves the canvas");
                for other in &drawing.labels()[i + 1..] {
                    assert!(!label.rect.overlaps(other.rect), "{name}: {label:?} and {other:?}");
                }
            }
        }
    }
}

/// The mean difference of a sample, of 255, and the share of samples that are off by more than 64.
fn difference(a: &[u8], b: &[u8]) -> (f64, f64) {
    assert_eq!(a.len(), b.len());
    let each = || a.iter().zip(b).map(|(a, b)| a.abs_diff(*b));
    let count = a.len() as f64;
    (each().map(f64::from).sum::<f64>() / count, each().filter(|d| *d > 64).count() as f64 / count)
}

/// How far our PNG and the picture that resvg makes of our SVG are apart: the mean difference of a sample, of 255, and the share of
/// samples that are off by more than 64.
pub(crate) fn difference_to_resvg(drawing: &Drawing) -> (f64, f64) {
    let png = drawing.to_raster(2.0).unwrap();
    let tree = usvg::Tree::from_str(&drawing.to_svg().unwrap(), &usvg::Options::default()).unwrap();
    let mut pixmap = tiny_skia::Pixmap::new(png.width, png.height).unwrap();
    resvg::render(&tree, tiny_skia::Transform::from_scale(2.0, 2.0), &mut pixmap.as_mut());
    difference(&png.rgba, &pixmap.take_demultiplied())
}

#[test]
fn resvg_draws_our_svg_as_we_draw_the_png() {
    for (name, draw) in ALL {
        let (mean, off) = difference_to_resvg(&draw(&Theme::LIGHT));
        // Coordinates in the SVG are rounded to a hundredth of a unit, which moves the grey of an edge by a few levels; the
        // smallest letter that is missing takes more than one sample in 5000.
        assert!(mean < 0.25 && off < 0.0002, "{name}: mean {mean}, share {off}");
    }
}

#[test]
fn numbers_that_cannot_be_drawn_are_refused() {
    let calls: [fn(&mut Drawing, f64); 7] = [
        |d, x| d.line((x, 0.0), (1.0, 1.0), Pen::new(Color::BLACK, 1.0)),
        |d, x| d.line((0.0, 0.0), (1.0, 1.0), Pen::new(Color::BLACK, x)),
        |d, x| d.disk((0.0, x), 1.0, Color::BLACK),
        |d, x| d.stroke(Path::arc((0.0, 0.0), x, 0.0, 1.0), Pen::new(Color::BLACK, 1.0)),
        |d, x| _ = d.text((x, 0.0), "x", Text::new(12.0, Color::BLACK)),
        |d, x| _ = d.text((0.0, 0.0), "x", Text::new(x, Color::BLACK)),
        |d, x| d.clipped(Path::circle((0.0, 0.0), x), |_| {}),
    ];
    for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e9] {
        for (i, call) in calls.into_iter().enumerate() {
            let mut drawing = Drawing::new(10.0, 10.0, Color::WHITE, "bad");
            assert!(drawing.to_svg().is_ok());
            call(&mut drawing, number);
            assert!(drawing.to_svg().is_err() && drawing.to_png(1.0).is_err(), "call {i} with {number}");
            assert!(drawing.labels().iter().all(|label| label.rect.min.is_finite()), "call {i} with {number}");
            // What contains it is refused as well.
            let mut outer = Drawing::new(10.0, 10.0, Color::WHITE, "outer");
            outer.place(&drawing, (0.0, 0.0), 1.0);
            assert!(outer.to_svg().unwrap_err().to_string().contains("\"bad\""));
        }
        assert!(Drawing::new(number, 10.0, Color::WHITE, "bad").to_svg().is_err());
        assert!(Drawing::new(10.0, 10.0, Color::WHITE, "good").to_png(number).is_err());
    }
}

#[test]
fn formulas_that_cannot_be_set_are_refused() {
    for tex in [r"\frac{1}{", r"\nosuchcommand", r"\boxed{x}", r"\mathbb R", "漢"] {
        let mut drawing = Drawing::new(100.0, 100.0, Color::WHITE, "bad");
        drawing.text((10.0, 50.0), Words::default().tex(tex), Text::new(12.0, Color::BLACK));
        let error = drawing.to_svg().unwrap_err().to_string();
        assert!(error.contains("formula") && drawing.labels().is_empty(), "{tex}: {error}");
    }
}

#[test]
fn what_a_placed_drawing_says_is_said_where_it_stands() {
    let theme = &Theme::LIGHT;
    let (inner, outer) = (sampler(theme), sheet(theme));
    let last = (inner.labels().last().unwrap(), outer.labels().last().unwrap());
    assert_eq!(last.0.text, last.1.text);
    assert_eq!(last.1.rect.min, DVec2::new(435.0, 160.0) + 0.5 * last.0.rect.min);
}

#[test]
fn degenerate_marks_draw_nothing_or_what_they_can() {
    let mut drawing = Drawing::new(100.0, 100.0, Color::WHITE, "degenerate");
    let pen = Pen::new(Color::BLACK, 1.0);
    drawing.arrow((50.0, 50.0), (50.0, 50.0), pen);
    drawing.directed((50.0, 50.0), (50.0, 50.0), 0.5, pen);
    drawing.angle((50.0, 50.0), DVec2::X, DVec2::X, 10.0, pen);
    drawing.angle((50.0, 50.0), DVec2::X, DVec2::NEG_X, 10.0, pen);
    drawing.right_angle((50.0, 50.0), DVec2::ZERO, DVec2::Y, 10.0, pen);
    drawing.dimension((50.0, 50.0), (50.0, 50.0), 10.0, pen);
    drawing.hatch(Path::rect(Rect::new((0.0, 0.0), (90.0, 90.0))), DVec2::Y, 1e-9, pen);
    drawing.hatch(Path::default(), DVec2::Y, 4.0, pen);
    drawing.listing((0.0, 0.0), &[], 0.0, 10.0, Color::BLACK);
    drawing.listing((0.0, 0.0), &["wide".into()], 0.0, 10.0, Color::BLACK);
    drawing.stroke(Path::default(), pen);
    drawing.text((0.0, 0.0), "", Text::new(10.0, Color::BLACK));
    assert!(drawing.to_svg().is_ok() && drawing.to_png(1.0).is_ok());
    assert!(!drawing.to_svg().unwrap().contains("NaN"));
}

#[test]
fn colors_can_be_told_from_their_ground() {
    for theme in [&Theme::LIGHT, &Theme::DARK] {
        for text in [theme.ink, theme.muted] {
            assert!(text.contrast(theme.background) >= 4.5 && text.contrast(theme.panel) >= 4.5, "{text:?}");
        }
        for hue in Hue::ALL {
            let contrast = theme.hue(hue).contrast(theme.background);
            assert!(contrast >= 3.0, "{hue:?}: {contrast}");
        }
        let heat: Vec<f64> = (0..=20).map(|i| theme.heat(f64::from(i) / 20.0).luminance()).collect();
        assert!(heat.is_sorted() || heat.iter().rev().is_sorted(), "{heat:?}");
    }
}

#[test]
fn ticks_are_where_one_would_put_them() {
    let labels = |scale: Scale| -> Vec<String> {
        let ticks = scale.between(0.0, 600.0).ticks(80.0);
        ticks.into_iter().filter_map(|tick| tick.label).map(|words| words.to_string()).collect()
    };
    assert_eq!(labels(Scale::Linear(0.0, 1.0)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    assert_eq!(labels(Scale::Linear(-30.0, 30.0)), ["−30", "−20", "−10", "0", "10", "20", "30"]);
    assert_eq!(labels(Scale::LogAndZero(1.0, 10_000.0)), ["0", "1", "10", "100", "1000", "10\u{2009}000"]);
    assert_eq!(labels(Scale::Log(1e-9, 1e3)).first().unwrap(), "10^−8");
    // A value of nothing but zeros still has a scale, and so has one value.
    assert_eq!(Scale::log_around([0.0, 0.0]), Scale::LogAndZero(0.5, 20.0));
    assert_eq!(Scale::log_around([3.0]), Scale::Log(2.0, 5.0));
    assert_eq!(Scale::log_around([1.0, 1000.0]), Scale::Log(0.5, 2000.0));
}

#[test]
fn a_label_takes_the_best_free_place() {
    let mut drawing = Drawing::new(200.0, 100.0, Color::WHITE, "places");
    let text = Text::new(12.0, Color::BLACK);
    let places = around((100.0, 50.0), 6.0);
    let first = drawing.label("one", text, &places, drawing.canvas(), &[]).unwrap();
    let second = drawing.label("two", text, &places, drawing.canvas(), &[]).unwrap();
    assert!(first.max.y < 50.0 && first.min.x > 100.0, "above, to the right: {first:?}");
    assert!(second.min.y > 50.0 && second.min.x > 100.0, "then below, to the right: {second:?}");
}
