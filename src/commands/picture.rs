//! Drawings as files: what the commands `diagram`, `sheet` and `gallery` share.

use super::failure::Failure;
use super::options::TraceArgs;
use crate::input::Problem;
use crate::numbers::{Precision, Real};
use crate::pictures::drawing::Drawing;
use crate::pictures::theme::Theme;
use crate::scene::Loaded;
use crate::tree::{Keep, Origin, RayTree, record_pixel};

/// How a drawing looks, and how large its PNG is.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct LookArgs {
    /// Light on dark, for projectors
    #[arg(long)]
    dark: bool,
    /// Pixels of a PNG for each unit of the drawing, 0.5 to 8
    #[arg(long, value_name = "N", default_value = "1.5", allow_negative_numbers = true, value_parser = scales)]
    pub(super) scale: f64,
}

impl LookArgs {
    /// The colours.
    pub(super) fn theme(&self) -> &'static Theme {
        if self.dark { &Theme::DARK } else { &Theme::LIGHT }
    }
}

fn scales(word: &str) -> Result<f64, String> {
    let scale = word.parse::<f64>().ok().filter(|scale| (0.5..=8.0).contains(scale));
    scale.ok_or_else(|| "a number from 0.5 to 8".to_owned())
}

/// The file formats of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    /// Pixels.
    Png,
    /// Outlines.
    Svg,
}

impl Format {
    /// The format of a drawing's file name; standard output, a device and a pipe take PNG.
    pub(super) fn of(file: &str) -> Result<Self, Failure> {
        let is_special = || std::fs::metadata(file).is_ok_and(|data| !data.is_file() && !data.is_dir());
        let ending = file.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        match ending.as_deref() {
            Some("png") => Ok(Self::Png),
            Some("svg") => Ok(Self::Svg),
            _ if file == "-" || is_special() => Ok(Self::Png),
            _ => {
                let help = "a path that ends in .png or .svg, or - for a PNG on standard output";
                Err(Problem::new(file, "no format of drawings goes with this ending", help).into())
            }
        }
    }

    /// The bytes of a drawing.
    pub(super) fn encode(self, drawing: &Drawing, scale: f64) -> Result<Vec<u8>, Failure> {
        let bytes = match self {
            Self::Png => drawing.to_png(scale),
            Self::Svg => drawing.to_svg().map(String::into_bytes),
        };
        bytes.map_err(|unfit| Failure::Machine(unfit.to_string()))
    }
}

/// The tree of a pixel with every test.
pub(super) fn record(loaded: &Loaded, trace: &TraceArgs, pixel: [u32; 2]) -> Result<RayTree, Failure> {
    match trace.precision(&loaded.scene) {
        Precision::F32 => record_in::<f32>(loaded, trace, pixel),
        Precision::F64 => record_in::<f64>(loaded, trace, pixel),
    }
}

fn record_in<R: Real>(loaded: &Loaded, trace: &TraceArgs, [x, y]: [u32; 2]) -> Result<RayTree, Failure> {
    let tracer = trace.tracer::<R>(loaded)?;
    Ok(record_pixel(&tracer, Origin { loaded, keep: Keep::Steps }, x, y))
}
