//! Arguments that several commands share.

use std::ffi::OsString;

use clap::ValueEnum;

use super::failure::Failure;
use crate::hits::Acceleration;
use crate::input::{Problem, nearest, one_of};
use crate::inspector::Settings;
use crate::kernels::Ray;
use crate::numbers::{Precision, Real, Vector3, flush_tiny, is_in_range};
use crate::scene::{Limits, Loaded, Numerics, Scene};
use crate::transport::{LeavingPolicy, Options, Tracer};

/// How to trace, where it is not the scene that says so.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "How to trace")]
pub(super) struct TraceArgs {
    /// Precision of the geometry [default: the scene's, else f64]
    #[arg(long, value_enum)]
    precision: Option<PrecisionArg>,
    /// Set of kernels [default: the scene's, else certified]
    #[arg(long, value_enum)]
    numerics: Option<NumericsArg>,
    /// What keeps a ray from hitting the surface it starts on: provenance, error-bound, or an epsilon [default: what goes
    /// with the kernels]
    #[arg(long, value_name = "POLICY", allow_negative_numbers = true, value_parser = leaving_policy)]
    leaving: Option<LeavingPolicy>,
    /// How hits are found; the results are the same
    #[arg(long, value_enum, default_value_t = AccelerationArg::Bvh)]
    acceleration: AccelerationArg,
    /// Depth of the recursion, 0 to 64 [default: the scene's]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = depths())]
    max_depth: Option<u32>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum PrecisionArg {
    F32,
    F64,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum NumericsArg {
    /// The lecture's formulas as they stand
    Lecture,
    /// The usual remedies
    Robust,
    /// Every verdict exact
    Certified,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum AccelerationArg {
    /// Every shape, in order
    List,
    /// A bounding volume hierarchy
    Bvh,
}

fn depths() -> clap::builder::RangedI64ValueParser<u32> {
    clap::value_parser!(u32).range(..=i64::from(Limits::DEEPEST))
}

fn leaving_policy(word: &str) -> Result<LeavingPolicy, String> {
    match word {
        "provenance" => Ok(LeavingPolicy::Provenance),
        "error-bound" => Ok(LeavingPolicy::ErrorBound),
        _ => match word.parse::<f64>() {
            Ok(epsilon) if epsilon >= 0.0 && epsilon.is_finite() => Ok(LeavingPolicy::FixedEpsilon(epsilon)),
            _ => Err("`provenance`, `error-bound`, or an epsilon of 0 or more".into()),
        },
    }
}

/// How many threads a command may be given.
pub(super) fn thread_counts() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(1..=1024)
}

impl TraceArgs {
    /// What they say.
    pub(super) fn settings(&self) -> Settings {
        let precision = self.precision.map(|precision| match precision {
            PrecisionArg::F32 => Precision::F32,
            PrecisionArg::F64 => Precision::F64,
        });
        let numerics = self.numerics.map(|numerics| match numerics {
            NumericsArg::Lecture => Numerics::Lecture,
            NumericsArg::Robust => Numerics::Robust,
            NumericsArg::Certified => Numerics::Certified,
        });
        let acceleration = match self.acceleration {
            AccelerationArg::List => Acceleration::List,
            AccelerationArg::Bvh => Acceleration::Bvh,
        };
        Settings { precision, numerics, max_depth: self.max_depth, leaving: self.leaving, acceleration }
    }

    /// The precision to trace this scene in.
    pub(super) fn precision(&self, scene: &Scene) -> Precision {
        self.settings().precision.or(scene.precision).unwrap_or(Precision::F64)
    }

    /// The scene made ready in precision `R`.
    pub(super) fn tracer<'s, R: Real>(&self, loaded: &'s Loaded) -> Result<Tracer<'s, R>, Failure> {
        let settings = self.settings();
        let mut options = Options::of(&loaded.scene);
        options.numerics = settings.numerics.unwrap_or(options.numerics);
        options.leaving = settings.leaving;
        options.acceleration = settings.acceleration;
        options.limits.max_depth = settings.max_depth.unwrap_or(options.limits.max_depth);
        Tracer::new(&loaded.scene, options).map_err(|unfit| {
            let message = format!("{} is too far out for {}", unfit.name(&loaded.scene), R::PRECISION);
            let help = format!("coordinates up to {:e} in magnitude, or `--precision f64`", largest::<R>());
            Problem::new(&loaded.file, message, help).into()
        })
    }
}

/// A pixel by its place or its name, and the name if it has one.
pub(super) fn find_pixel<'s>(scene: &'s Scene, word: &str) -> Result<([u32; 2], Option<&'s str>), Failure> {
    let named = |found: &(String, [u32; 2])| found.0 == word;
    if let Some((name, pixel)) = scene.pixels.iter().find(|p| named(p)) {
        return Ok((*pixel, Some(name)));
    }
    let names = || scene.pixels.iter().map(|(name, _)| name.as_str());
    let (width, height) = (scene.image.width, scene.image.height);
    let Some((x, y)) = word.split_once(',').and_then(|(x, y)| {
        let parse = |digits: &str| digits.trim().parse::<i64>().ok();
        Some((parse(x)?, parse(y)?))
    }) else {
        let near = nearest(word, names()).map_or(String::new(), |near| format!("did you mean `{near}`? "));
        let help = format!("{near}x,y (0 to {}, 0 to {}) or a name: {}", width - 1, height - 1, one_of(names()));
        return Err(Problem::new("PIXEL", format!("there is no pixel `{word}`"), help).into());
    };
    if !(0..i64::from(width)).contains(&x) || !(0..i64::from(height)).contains(&y) {
        let message = format!("pixel {x},{y} lies outside the image of {width} x {height}");
        let help = format!("x is 0 to {}, y is 0 to {}", width - 1, height - 1);
        return Err(Problem::new("PIXEL", message, help).into());
    }
    let pixel = [x as u32, y as u32];
    Ok((pixel, scene.pixels.iter().find(|(_, p)| *p == pixel).map(|(name, _)| name.as_str())))
}

/// A vector written as `x,y,z`; `what` names it in messages.
pub(super) fn parse_vector(what: &str, word: &str) -> Result<[f64; 3], Failure> {
    let wrong = |message: String| Problem::new(what, message, "three finite numbers with commas between: 0,1.5,-5");
    let parts: Vec<&str> = word.trim().split(',').collect();
    let [x, y, z] = parts.as_slice() else {
        return Err(wrong(format!("`{}` has {} components", word.trim(), parts.len())).into());
    };
    let mut vector = [0.0; 3];
    for (component, word) in vector.iter_mut().zip([x, y, z]) {
        let word = word.trim();
        *component = word.parse::<f64>().map_err(|_| wrong(format!("`{word}` is not a number")))?;
        if !component.is_finite() {
            return Err(wrong(format!("`{word}` is not finite")).into());
        }
        if !is_in_range(*component) {
            let help = "0 or a multiple of 2^-178, at most 2^128 in magnitude; every f32 is one";
            return Err(Problem::new(what, format!("`{word}` is out of the range of exact arithmetic"), help).into());
        }
    }
    Ok(vector)
}

/// The largest coordinate of a scene in precision `R`.
fn largest<R: Real>() -> f64 {
    R::PRECISION.largest_coordinate()
}

/// The ray from `origin` towards `direction` in precision `R`.
pub(super) fn make_ray<R: Real>(origin: &str, direction: &str) -> Result<Ray<R>, Failure> {
    let (origin, direction) = (parse_vector("ORIGIN", origin)?, parse_vector("DIRECTION", direction)?);
    for (what, vector) in [("ORIGIN", origin), ("DIRECTION", direction)] {
        if let Some(x) = vector.iter().find(|x| x.abs() > largest::<R>()) {
            let message = format!("{x:?} is too large for {}", R::PRECISION);
            let help = format!("up to {:e} in magnitude, or `--precision f64`", largest::<R>());
            return Err(Problem::new(what, message, help).into());
        }
    }
    let longest = direction.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if longest < R::PRECISION.smallest_direction() {
        let message =
            if longest == 0.0 { "a direction of length zero" } else { "a direction too short to compute with" };
        let help = format!("a component of {:e} or more in magnitude", R::PRECISION.smallest_direction());
        return Err(Problem::new("DIRECTION", message, help).into());
    }
    let direction = direction.map(flush_tiny);
    Ok(Ray { origin: R::Vec3::from_f64(origin), direction: R::Vec3::from_f64(direction) })
}

/// Keeps a vector that begins with a minus sign from being read as an option, by a space that [`parse_vector`] drops.
pub(super) fn shield_vector(word: OsString) -> OsString {
    let is_vector = |text: &str| {
        let mut chars = text.chars();
        chars.next() == Some('-')
            && chars.next().is_some_and(|c| c.is_ascii_digit() || matches!(c, '.' | 'i' | 'n' | 'I' | 'N'))
            && text.contains(',')
    };
    match word.to_str() {
        Some(text) if is_vector(text) => format!(" {text}").into(),
        _ => word,
    }
}
