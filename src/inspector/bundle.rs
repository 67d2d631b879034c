//! The page as it is served, and as one file: its style, its modules and its fonts inside `index.html`.
//!
//! Modules become one script in the order of their imports, without the lines that import and the words that export. So a
//! module imports by `import { a, b } from './x.js';` at the start of a line, exports by `export` in front of a declaration,
//! and has names at its top that no other module has. The policy names the script and the style by their hashes: nothing
//! else runs, and nothing is loaded.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};

use super::assets::{self, ASSETS};

/// Where `index.html` names what is put inside.
const STYLE: &str = "<link rel=\"stylesheet\" href=\"/page/style.css\">";
const SCRIPT: &str = "<script type=\"module\" src=\"/page/app.js\"></script>";
const HEAD: &str = "<meta charset=\"utf-8\">";

/// The page as it is served: what it will ask for is named at the top, so that all of it comes at once.
pub(super) fn served() -> String {
    let modules = ASSETS.iter().filter(|asset| asset.name.ends_with(".js"));
    let named = modules.map(|asset| format!("<link rel=\"modulepreload\" href=\"/page/{}\">\n", asset.name));
    let scene = "<link rel=\"preload\" href=\"/api/scene\" as=\"fetch\" crossorigin=\"anonymous\">\n";
    text("index.html").replacen(SCRIPT, &format!("{scene}{}{SCRIPT}", named.collect::<String>()), 1)
}

/// The page with `data`, a JSON text, in a script called `recordings`.
pub(super) fn page(data: &str) -> String {
    let (style, script) = (style(), script());
    let policy = format!(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src '{}'; style-src '{}'; \
         img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'\">",
        hash(&script),
        hash(&style)
    );
    // Inside a script, JSON has `<` in texts alone, where it can be written otherwise.
    let data = data.replace('<', "\\u003c");
    text("index.html")
        .replacen(HEAD, &format!("{HEAD}\n{policy}"), 1)
        .replacen(STYLE, &format!("<style>{style}</style>"), 1)
        .replacen(
            SCRIPT,
            &format!(
                "<script type=\"application/json\" id=\"recordings\">{data}</script>\n<script type=\"module\">{script}</script>"
            ),
            1,
        )
}

/// What a policy calls a text.
fn hash(text: &str) -> String {
    format!("sha256-{}", BASE64_STANDARD.encode(Sha256::digest(text.as_bytes())))
}

fn text(name: &str) -> &'static str {
    assets::find(name).and_then(|asset| std::str::from_utf8(asset.bytes).ok()).unwrap_or_default()
}

/// The style with its fonts inside.
fn style() -> String {
    let fonts = ASSETS.iter().filter(|asset| asset.mime.starts_with("font/"));
    fonts.fold(text("style.css").to_owned(), |style, font| {
        let place = format!("url(\"{}\")", font.name);
        match style.contains(&place) {
            true => {
                style.replace(&place, &format!("url(data:{};base64,{})", font.mime, BASE64_STANDARD.encode(font.bytes)))
            }
            false => style,
        }
    })
}

/// All modules that `app.js` needs, each after those that it imports.
fn script() -> String {
    let mut order = Vec::new();
    visit("app.js", &mut order);
    let modules = order.iter().map(|name| {
        let lines = text(name).lines().filter(|line| !line.starts_with("import "));
        let lines = lines.map(|line| line.strip_prefix("export ").unwrap_or(line));
        format!("// {name}\n{}\n", lines.collect::<Vec<_>>().join("\n"))
    });
    // What would end the script can only stand in a text or a comment, where this means the same.
    modules.collect::<String>().replace("</script", "<\\/script").replace("<!--", "<\\!--")
}

fn visit(name: &'static str, order: &mut Vec<&'static str>) {
    for line in text(name).lines().filter(|line| line.starts_with("import ")) {
        let other = line.split_once(" from './").and_then(|(_, rest)| rest.strip_suffix("';"));
        if let Some(other) = other.filter(|other| !order.contains(other)) {
            visit(other, order);
        }
    }
    if !order.contains(&name) {
        order.push(name);
    }
}
