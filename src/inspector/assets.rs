//! The files of the page, compiled in: those of `src/inspector/page/`, and the fonts of the diagrams. A new file there is a
//! new line here, and nothing else.

/// A file of the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asset {
    /// `index.html` is served at `/`, every other name at `/page/NAME`.
    pub(super) name: &'static str,
    /// What is in it.
    pub(super) bytes: &'static [u8],
    /// Its media type.
    pub(super) mime: &'static str,
}

const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const JS: &str = "text/javascript; charset=utf-8";
const TTF: &str = "font/ttf";
const WOFF2: &str = "font/woff2";

const fn asset(name: &'static str, bytes: &'static [u8], mime: &'static str) -> Asset {
    Asset { name, bytes, mime }
}

/// All files.
pub(super) const ASSETS: &[Asset] = &[
    asset("index.html", include_bytes!("page/index.html"), HTML),
    asset("style.css", include_bytes!("page/style.css"), CSS),
    asset("api.js", include_bytes!("page/api.js"), JS),
    asset("app.js", include_bytes!("page/app.js"), JS),
    asset("code-pane.js", include_bytes!("page/code-pane.js"), JS),
    asset("controls.js", include_bytes!("page/controls.js"), JS),
    asset("diagram-pane.js", include_bytes!("page/diagram-pane.js"), JS),
    asset("difference.js", include_bytes!("page/difference.js"), JS),
    asset("dom.js", include_bytes!("page/dom.js"), JS),
    asset("format.js", include_bytes!("page/format.js"), JS),
    asset("formulas.js", include_bytes!("page/formulas.js"), JS),
    asset("heat.js", include_bytes!("page/heat.js"), JS),
    asset("help.js", include_bytes!("page/help.js"), JS),
    asset("json-edit.js", include_bytes!("page/json-edit.js"), JS),
    asset("letters.js", include_bytes!("page/letters.js"), JS),
    asset("numbers-pane.js", include_bytes!("page/numbers-pane.js"), JS),
    asset("palette.js", include_bytes!("page/palette.js"), JS),
    asset("player.js", include_bytes!("page/player.js"), JS),
    asset("predict.js", include_bytes!("page/predict.js"), JS),
    asset("render-pane.js", include_bytes!("page/render-pane.js"), JS),
    asset("scene-editor.js", include_bytes!("page/scene-editor.js"), JS),
    asset("shaders.js", include_bytes!("page/shaders.js"), JS),
    asset("solids.js", include_bytes!("page/solids.js"), JS),
    asset("tests-pane.js", include_bytes!("page/tests-pane.js"), JS),
    asset("tree-pane.js", include_bytes!("page/tree-pane.js"), JS),
    asset("view3d.js", include_bytes!("page/view3d.js"), JS),
    asset("whatif.js", include_bytes!("page/whatif.js"), JS),
    asset("NotoSansMath-Subset.woff2", include_bytes!("page/NotoSansMath-Subset.woff2"), WOFF2),
    asset("IBMPlexMono-Regular.ttf", include_bytes!("../pictures/fonts/IBMPlexMono-Regular.ttf"), TTF),
    asset("IBMPlexSans-Regular.ttf", include_bytes!("../pictures/fonts/IBMPlexSans-Regular.ttf"), TTF),
    asset("IBMPlexSans-SemiBold.ttf", include_bytes!("../pictures/fonts/IBMPlexSans-SemiBold.ttf"), TTF),
    asset("KaTeX_Main-Bold.ttf", include_bytes!("../pictures/fonts/KaTeX_Main-Bold.ttf"), TTF),
    asset("KaTeX_Main-Regular.ttf", include_bytes!("../pictures/fonts/KaTeX_Main-Regular.ttf"), TTF),
    asset("KaTeX_Math-Italic.ttf", include_bytes!("../pictures/fonts/KaTeX_Math-Italic.ttf"), TTF),
];

/// The file of that name.
pub(super) fn find(name: &str) -> Option<Asset> {
    ASSETS.iter().find(|asset| asset.name == name).copied()
}
