//! The files of the page, compiled in: `src/inspector/page/`. A new file there is a new line here.

/// Name, bytes, media type. `index.html` is served at `/`, every other file at `/page/NAME`.
pub(super) const ASSETS: &[(&str, &[u8], &str)] =
    &[("index.html", include_bytes!("page/index.html"), "text/html; charset=utf-8")];

/// The file of that name.
pub(super) fn asset(name: &str) -> Option<(&'static [u8], &'static str)> {
    ASSETS.iter().find(|(known, ..)| *known == name).map(|&(_, bytes, mime)| (bytes, mime))
}
