//! The report as a page that works without a network: the charts beside it, the tables in it.

use std::fmt::Write;

use super::export::{Table, tables};
use super::report::Report;
use crate::pictures::drawing::escape;

/// The page. It expects `charts/NAME.svg` and `charts/NAME-dark.svg` beside it for every name in `charts`, in order,
/// with a sentence on each for those who do not see it.
pub fn to_html(report: &Report, machine: &str, command: &str, charts: &[(String, String)]) -> String {
    let mut page = String::from(HEAD);
    let plan = &report.plan;
    let cases: usize = report.counts.iter().map(|c| c.cases).sum();
    let refereed: usize = report.counts.iter().map(|c| c.refereed).sum();
    let certified = report.counts.iter().flat_map(|c| &c.forms).filter(|f| f.form == super::forms::Form::Certified);
    let wrong: usize = certified.map(|f| f.wrong()).sum();
    writeln!(
        page,
        "<p>Made by <code>{}</code> on {}, seed {}. {cases} cases were drawn, {refereed} of them decided by rational \
         arithmetic: every one that the filter left open, and one in {} of the rest. The certified forms were wrong in \
         <strong>{wrong}</strong>. Times are medians of {} interleaved rounds with their quartiles; compare them, do not \
         quote them.</p>",
        escape(command),
        escape(machine),
        plan.seed,
        plan.refereed_one_in,
        plan.rounds
    )
    .ok();
    if report.scene.is_none() {
        page.push_str(
            "<p>No scene was given, so there is nothing here on images: <code>raytree accuracy SCENE -o DIR</code>.",
        );
        page.push_str("</p>\n");
    }
    let tables = tables(report);
    for (heading, about, files, table_files) in SECTIONS {
        let is_here = |name: &str| files.iter().any(|prefix| name.starts_with(prefix));
        let figures: Vec<_> = charts.iter().filter(|(name, _)| is_here(name)).collect();
        if figures.is_empty() {
            continue;
        }
        write!(page, "<section>\n<h2>{heading}</h2>\n<p>{about}</p>\n").ok();
        for (name, alt) in figures {
            writeln!(
                page,
                "<figure><picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"charts/{name}-dark.svg\">\
                 <img src=\"charts/{name}.svg\" alt=\"{}\"></picture><figcaption><a href=\"charts/{name}.svg\">SVG</a> \
                 <a href=\"charts/{name}.png\">PNG</a></figcaption></figure>",
                escape(alt)
            )
            .ok();
        }
        for table in tables.iter().filter(|t| table_files.contains(&t.file)) {
            write_table(&mut page, table);
        }
        page.push_str("</section>\n");
    }
    page.push_str("<p><a href=\"figures.json\">All figures as JSON</a></p>\n</main>\n</body>\n</html>\n");
    page
}

/// Heading, what to see, the charts whose names begin so, the tables.
const SECTIONS: [(&str, &str, &[&str], &[&str]); 6] = [
    (
        "Wrong verdicts against time",
        "Every way to decide whether a ray hits, by what it costs and by how often it is wrong, over sets from harmless to \
         malicious. The exact forms are right and slow. The certified ones are right too, and ask for exact arithmetic only \
         where rounding could matter: the first chart is about rays as pictures have them, the second about nothing but \
         edges, tangents and corners. Every test here has a ray of its own; in the loop of one ray against many shapes, which \
         <code>cargo bench --bench kernels</code> times, part of the work is done once a ray.",
        &["pareto"],
        &["verdicts", "times"],
    ),
    (
        "Predicate maps",
        "Each cell is the verdict on the same question with two numbers changed by a unit in the last place. A true map has \
         one clean boundary. Watertight tests close the gaps along an edge, and still do not give each triangle its own \
         verdict.",
        &["map"],
        &["maps"],
    ),
    (
        "Which stage decides",
        "Easy sets never leave the filter. Sets that aim at edges are beyond any filter, and integers decide most of them.",
        &["stages"],
        &[],
    ),
    (
        "The error of t",
        "Where a form and the referee agree on a hit, how far its t is off.",
        &["t-errors"],
        &["t-errors"],
    ),
    (
        "Leaving a surface",
        "A reflected ray or a ray to a light starts on a surface, at a point that rounding has moved off it. Three ways to keep \
         it from hitting that surface, and what each loses: shadows far from the origin, or contact shadows. And whether a \
         closed surface holds at all.",
        &["leaving"],
        &["self-hits", "contact-shadows", "leaks", "mirrored-cube"],
    ),
    (
        "The scene",
        "What each way of saving time does to the picture, where exact arithmetic was needed, and what an epsilon does to \
         the rays that leave a surface.",
        &["scene"],
        &["images", "image-times", "departures"],
    ),
];

fn write_table(page: &mut String, table: &Table) {
    write!(
        page,
        "<details><summary>{} ({} rows, <a href=\"{}.csv\">CSV</a>)</summary>\n<div class=\"scroll\"><table>\n<tr>",
        table.title,
        table.rows.len(),
        table.file
    )
    .ok();
    for column in &table.columns {
        write!(page, "<th>{}</th>", escape(&column.replace('_', " "))).ok();
    }
    page.push_str("</tr>\n");
    for row in &table.rows {
        page.push_str("<tr>");
        for cell in row {
            let class = if cell.parse::<f64>().is_ok() { " class=\"n\"" } else { "" };
            write!(page, "<td{class}>{}</td>", escape(cell)).ok();
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</table></div></details>\n");
}

const HEAD: &str = r#"<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>raytree: what accuracy costs in time</title>
<style>
:root { color-scheme: light dark; --ground: #ffffff; --ink: #1d2530; --muted: #5a6675; --rule: #d9dee5; --link: #0b62a8; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #14181e; --ink: #e4e9ef; --muted: #9aa6b4; --rule: #333c47; --link: #6cb6f2; }
}
body { margin: 0; background: var(--ground); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 1160px; margin: 0 auto; padding: 32px 24px 64px; }
h1 { font-size: 28px; margin: 0 0 8px; }
h2 { font-size: 20px; margin: 40px 0 4px; padding-top: 16px; border-top: 1px solid var(--rule); }
p { max-width: 78ch; }
a { color: var(--link); }
code { font-family: ui-monospace, monospace; font-size: 0.92em; }
figure { margin: 16px 0; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption { color: var(--muted); font-size: 13px; }
figcaption a { margin-right: 8px; }
details { margin: 12px 0; }
summary { cursor: pointer; }
.scroll { overflow: auto; max-height: 480px; border: 1px solid var(--rule); }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th { position: sticky; top: 0; background: var(--ground); text-align: left; }
th, td { padding: 3px 10px; border-bottom: 1px solid var(--rule); white-space: nowrap; }
td.n { text-align: right; }
</style>
</head>
<body>
<main>
<h1>What accuracy costs in time</h1>
"#;
