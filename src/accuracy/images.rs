//! A whole scene: how far its picture is from the reference, and how long it took.

use std::sync::atomic::{AtomicBool, Ordering};

use super::timing::{Quartiles, interleaved};
use crate::hits::Acceleration;
use crate::numbers::{Precision, Real, Stage};
use crate::pictures::{Film, render};
use crate::scene::{Limits, Numerics, Resolution, Rgb, Scene};
use crate::transport::{Children, Kind, Options, Recorder, Secondary, Tracer, Unfit, Visit};

/// A way to render the scene.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Variant {
    /// What is varied, the rest being as in the reference.
    pub varied: Varied,
    /// The kernels.
    pub numerics: Numerics,
    /// Of the geometry.
    pub precision: Precision,
    /// How deep the recursion goes.
    pub max_depth: u32,
    /// Children of less weight are not traced.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min_weight: Option<f64>,
    /// Samples along a pixel's side.
    pub samples: u32,
}

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Varied {
    /// Kernels and precision.
    Kernels,
    /// The depth of the recursion.
    Depth,
    /// The weight below which children are not traced.
    MinWeight,
    /// Samples a pixel.
    Samples,
}

impl Varied {
    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kernels => "kernels and precision",
            Self::Depth => "depth",
            Self::MinWeight => "min_weight",
            Self::Samples => "samples a pixel",
        }
    }
}

impl Variant {
    /// What sets it apart.
    pub fn name(&self) -> String {
        match self.varied {
            Varied::Kernels => format!("{} {}", self.numerics, self.precision),
            Varied::Depth => format!("depth {}", self.max_depth),
            Varied::MinWeight => format!("min_weight {}", self.min_weight.unwrap_or_default()),
            Varied::Samples => format!("{0} x {0} samples", self.samples),
        }
    }
}

/// How a variant came out.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct ImageError {
    /// The variant.
    pub variant: Variant,
    /// Root mean square of the distance in linear RGB from the reference, over all pixels and channels.
    pub rmse: f64,
    /// The same from the reference with one sample a pixel, so that only what is varied counts.
    pub rmse_at_centers: f64,
    /// The pixel with the largest distance from the reference with one sample, x and y.
    pub worst_pixel: [u32; 2],
    /// That distance, in the channel where it is largest.
    pub worst: f64,
    /// Pixels of another tree's shape than in the reference with one sample, in [0, 1]: another kind, object,
    /// triangle, side or outcome anywhere. Nothing where there are several samples a pixel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_shape: Option<f64>,
}

/// The reference: certified, f64, as deep as this, with so many samples along a pixel's side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Reference {
    /// Deeper than the scene asks for.
    pub max_depth: u32,
    /// Samples along a pixel's side.
    pub samples: u32,
}

impl Reference {
    /// Of a scene: two levels deeper, `samples` times `samples` samples a pixel.
    pub fn of(scene: &Scene, samples: u32) -> Self {
        Self { max_depth: (scene.limits.max_depth + 2).min(Limits::DEEPEST), samples }
    }

    fn variant(self, varied: Varied) -> Variant {
        let (numerics, precision) = (Numerics::Certified, Precision::F64);
        Variant { varied, numerics, precision, max_depth: self.max_depth, min_weight: None, samples: 1 }
    }

    /// What is compared with it. Only what the scene calls for is varied.
    pub fn variants(self, scene: &Scene) -> Vec<Variant> {
        let mut variants = Vec::new();
        let base = self.variant(Varied::Kernels);
        for numerics in [Numerics::Lecture, Numerics::Robust, Numerics::Certified] {
            for precision in [Precision::F32, Precision::F64] {
                variants.push(Variant { numerics, precision, ..base });
            }
        }
        if scene.materials.iter().any(|m| m.reflection.is_some() || m.transmission.is_some()) {
            let base = self.variant(Varied::Depth);
            variants.extend((0..=self.max_depth).map(|max_depth| Variant { max_depth, ..base }));
            let base = self.variant(Varied::MinWeight);
            let weights = [0.25, 0.1, 0.03, 0.01, 0.003, 0.001];
            variants.extend(weights.map(|weight| Variant { min_weight: Some(weight), ..base }));
        }
        let base = self.variant(Varied::Samples);
        variants.extend([1, 2, self.samples.div_ceil(2)].map(|samples| Variant { samples, ..base }));
        variants
    }
}

/// A variant's picture, and the shape of each pixel's tree where there is one sample a pixel.
struct Picture {
    film: Film,
    shapes: Option<Vec<u64>>,
}

/// Renders a variant; nothing if `stop` was set meanwhile.
///
/// # Errors
/// [`Unfit`] where the scene does not fit the precision.
fn picture(scene: &Scene, variant: Variant, stop: &AtomicBool) -> Result<Option<Picture>, Unfit> {
    match variant.precision {
        Precision::F32 => picture_in::<f32>(scene, variant, stop),
        Precision::F64 => picture_in::<f64>(scene, variant, stop),
    }
}

fn picture_in<R: Real>(scene: &Scene, variant: Variant, stop: &AtomicBool) -> Result<Option<Picture>, Unfit> {
    let scene = &with_samples(scene, variant.samples);
    let tracer = Tracer::<R>::new(scene, options(variant))?;
    if variant.samples > 1 {
        let film = render(&tracer, &|| (), stop);
        return Ok(film.map(|film| Picture { film: averaged(&film, variant.samples), shapes: None }));
    }
    Ok(each_pixel(&tracer, &TreeShape, stop).map(|pixels| {
        let (pixels, shapes) = pixels.into_iter().unzip();
        Picture { film: Film { size: scene.image, pixels }, shapes: Some(shapes) }
    }))
}

fn options(variant: Variant) -> Options {
    let limits = Limits { max_depth: variant.max_depth, min_weight: variant.min_weight, ..Limits::default() };
    Options { numerics: variant.numerics, leaving: None, acceleration: Acceleration::Bvh, limits }
}

/// The scene with an image of at most so many pixels, of about the same shape.
pub fn reduced(scene: &Scene, most_pixels: u32) -> Scene {
    let Resolution { width, height } = scene.image;
    let shrink = (f64::from(width) * f64::from(height) / f64::from(most_pixels)).sqrt().max(1.0);
    let side = |pixels: u32| ((f64::from(pixels) / shrink) as u32).max(1);
    Scene { image: Resolution { width: side(width), height: side(height) }, ..scene.clone() }
}

/// The scene with an image that many times as large either way.
fn with_samples(scene: &Scene, samples: u32) -> Scene {
    let image = Resolution { width: scene.image.width * samples, height: scene.image.height * samples };
    Scene { image, ..scene.clone() }
}

/// The mean of each block of samples.
fn averaged(film: &Film, samples: u32) -> Film {
    let size = Resolution { width: film.size.width / samples, height: film.size.height / samples };
    let pixel = |i: u32| {
        let (x, y) = (i % size.width * samples, i / size.width * samples);
        let block =
            (0..samples).flat_map(|dy| (0..samples).map(move |dx| ((y + dy) * film.size.width + x + dx) as usize));
        block.map(|place| film.pixels[place]).sum::<Rgb>() / f64::from(samples * samples)
    };
    Film { size, pixels: (0..size.width * size.height).map(pixel).collect() }
}

/// The colour of every pixel and what a recorder makes of it, row by row from the top; nothing if `stop` was set meanwhile.
pub(super) fn each_pixel<R: Real, Rec: Recorder>(
    tracer: &Tracer<'_, R>,
    recorder: &Rec,
    stop: &AtomicBool,
) -> Option<Vec<(Rgb, Rec::Node)>> {
    let size = tracer.scene().image;
    let mut pixels = Vec::with_capacity((size.width * size.height) as usize);
    for y in 0..size.height {
        if stop.load(Ordering::Relaxed) {
            return None;
        }
        pixels.extend((0..size.width).map(|x| tracer.pixel(x, y, recorder)));
    }
    Some(pixels)
}

/// Renders all variants and compares them with the reference; nothing if `stop` was set meanwhile. `done` is called
/// after each.
///
/// # Errors
/// [`Unfit`] where the scene does not fit f64. A variant in f32 that does not fit is left out.
pub fn errors(
    scene: &Scene,
    reference: Reference,
    stop: &AtomicBool,
    done: &dyn Fn(),
) -> Result<Option<Vec<ImageError>>, Unfit> {
    let base = reference.variant(Varied::Kernels);
    let sampled = Variant { samples: reference.samples, ..base };
    let Some(Picture { film: truth, .. }) = picture(scene, sampled, stop)? else { return Ok(None) };
    done();
    let Some(Picture { film: at_centers, shapes: Some(shapes) }) = picture(scene, base, stop)? else {
        return Ok(None);
    };
    done();
    let mut errors = Vec::new();
    for variant in reference.variants(scene) {
        let Picture { film, shapes: its_shapes } = match picture(scene, variant, stop) {
            Ok(Some(picture)) => picture,
            Ok(None) => return Ok(None),
            Err(_) if variant.precision == Precision::F32 => continue,
            Err(unfit) => return Err(unfit),
        };
        let other_shape = its_shapes.map(|its| {
            let other = its.iter().zip(&shapes).filter(|(a, b)| a != b).count();
            other as f64 / shapes.len() as f64
        });
        let (worst_pixel, worst) = worst(&film, &at_centers);
        errors.push(ImageError {
            variant,
            rmse: rmse(&film, &truth),
            rmse_at_centers: rmse(&film, &at_centers),
            worst_pixel,
            worst,
            other_shape,
        });
        done();
    }
    Ok(Some(errors))
}

/// Times all variants in interleaved rounds: the time of each over that of the reference with one sample a pixel.
/// Nothing if `stop` was set meanwhile.
pub fn times(
    scene: &Scene,
    reference: Reference,
    variants: &[Variant],
    rounds: usize,
    stop: &AtomicBool,
) -> Option<Vec<Quartiles>> {
    let base = reference.variant(Varied::Kernels);
    let all: Vec<Variant> = std::iter::once(base).chain(variants.iter().copied()).collect();
    let scenes: Vec<Scene> = all.iter().map(|variant| with_samples(scene, variant.samples)).collect();
    let work: Vec<Box<dyn Fn() + '_>> = all
        .iter()
        .zip(&scenes)
        .map(|(&variant, scene)| -> Box<dyn Fn() + '_> {
            match variant.precision {
                Precision::F32 => renders::<f32>(scene, variant),
                Precision::F64 => renders::<f64>(scene, variant),
            }
        })
        .collect();
    let seconds = interleaved(rounds, &work, stop)?;
    let base = seconds[0].median;
    let over = |q: &Quartiles| Quartiles { lower: q.lower / base, median: q.median / base, upper: q.upper / base };
    Some(seconds[1..].iter().map(over).collect())
}

fn renders<'s, R: Real>(scene: &'s Scene, variant: Variant) -> Box<dyn Fn() + 's> {
    let tracer = Tracer::<R>::new(scene, options(variant)).ok();
    Box::new(move || {
        if let Some(tracer) = &tracer {
            std::hint::black_box(render(tracer, &|| (), &AtomicBool::new(false)));
        }
    })
}

fn rmse(film: &Film, truth: &Film) -> f64 {
    let squares = film.pixels.iter().zip(&truth.pixels).map(|(a, b)| (*a - *b).length_squared());
    (squares.sum::<f64>() / (3 * film.pixels.len()) as f64).sqrt()
}

fn worst(film: &Film, truth: &Film) -> ([u32; 2], f64) {
    let distances = film.pixels.iter().zip(&truth.pixels).map(|(a, b)| (*a - *b).abs().max_element());
    let (place, distance) = distances
        .enumerate()
        .fold((0, 0.0), |best, (i, distance)| if distance > best.1 { (i, distance) } else { best });
    ([place as u32 % film.size.width, place as u32 / film.size.width], distance)
}

/// Folds a tree into a number that two trees of one shape share: kinds, outcomes, objects, triangles and sides.
struct TreeShape;

impl Recorder for TreeShape {
    type Probe = ();
    type Node = u64;
    const RECORDS: bool = true;
    fn node<R: Real>(&self, visit: Visit<'_, R, ()>, children: Children<u64>) -> u64 {
        let kind = match visit.kind {
            Kind::Camera => 0,
            Kind::Shadow(light) => 1 + u64::from(light.0) * 4,
            Kind::Secondary(Secondary::Reflected) => 2,
            Kind::Secondary(Secondary::Refracted) => 3,
        };
        let mut hash = mixed(kind, visit.outcome as u64);
        if let Some(surface) = visit.surface {
            let hit = &surface.hit.nearest;
            hash = mixed(hash, u64::from(hit.object.0));
            hash = mixed(hash, hit.primitive.map_or(0, |p| u64::from(p) + 1));
            hash = mixed(hash, surface.side.map_or(0, |side| side as u64 + 1));
        }
        let children = children.shadows.into_iter().chain(children.reflected).chain(children.refracted);
        children.fold(hash, mixed)
    }
}

fn mixed(hash: u64, with: u64) -> u64 {
    super::random::Random::new(hash ^ with.rotate_left(32)).bits()
}

/// The dearest stage that a hit of a pixel's tree called for, row by row from the top; nothing if `stop` was set
/// meanwhile.
pub fn stages(scene: &Scene, stop: &AtomicBool) -> Result<Option<Vec<Stage>>, Unfit> {
    let options = Options { numerics: Numerics::Certified, ..Options::of(scene) };
    let tracer = Tracer::<f64>::new(scene, options)?;
    let pixels = each_pixel(&tracer, &DearestStage, stop);
    Ok(pixels.map(|pixels| pixels.into_iter().map(|(_, stage)| stage).collect()))
}

struct DearestStage;

impl Recorder for DearestStage {
    type Probe = ();
    type Node = Stage;
    const RECORDS: bool = true;
    fn node<R: Real>(&self, visit: Visit<'_, R, ()>, children: Children<Stage>) -> Stage {
        let own =
            visit.surface.map_or(Stage::Filter, |s| visit.tracer.world().certificate(visit.ray, &s.hit.nearest).stage);
        let children = children.shadows.into_iter().chain(children.reflected).chain(children.refracted);
        children.fold(own, Stage::max)
    }
}
