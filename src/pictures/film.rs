//! The film: the picture as linear colours, and the files it can be written to. The only file that names `image`.

use std::sync::atomic::{AtomicBool, Ordering};

use image::{ExtendedColorType, ImageEncoder, codecs};

use super::srgb::srgb8;
use crate::numbers::Real;
use crate::scene::{Resolution, Rgb};
use crate::transport::Tracer;

/// A picture in linear RGB, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Its size.
    pub size: Resolution,
    /// `width * height` colours, row by row.
    pub pixels: Vec<Rgb>,
}

/// The picture that `tracer` sees, or nothing if `stop` was set meanwhile. `row_done` is called after each row, on any
/// thread.
///
/// With the feature `threads` the rows are spread over the threads of the current `rayon` pool. The colours do not
/// depend on it.
pub fn render<R: Real>(tracer: &Tracer<'_, R>, row_done: &(dyn Fn() + Sync), stop: &AtomicBool) -> Option<Film> {
    let size = tracer.scene().image;
    let mut pixels = vec![Rgb::ZERO; size.width as usize * size.height as usize];
    let row = |(y, row): (usize, &mut [Rgb])| {
        for (x, pixel) in row.iter_mut().enumerate() {
            if stop.load(Ordering::Relaxed) {
                return;
            }
            *pixel = tracer.pixel_color(x as u32, y as u32);
        }
        row_done();
    };
    #[cfg(feature = "threads")]
    {
        use rayon::prelude::{IndexedParallelIterator, ParallelIterator, ParallelSliceMut};
        pixels.par_chunks_mut(size.width as usize).enumerate().for_each(row);
    }
    #[cfg(not(feature = "threads"))]
    pixels.chunks_mut(size.width as usize).enumerate().for_each(row);
    (!stop.load(Ordering::Relaxed)).then_some(Film { size, pixels })
}

/// The file formats of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8-bit sRGB, clamped and rounded.
    Png,
    /// OpenEXR, linear 32-bit floats.
    Exr,
    /// Portable float map, linear 32-bit floats.
    Pfm,
}

impl Format {
    /// The format that a file name's ending asks for, in either case.
    pub fn of(file_name: &str) -> Option<Self> {
        let ending = file_name.rsplit_once('.')?.1.to_ascii_lowercase();
        match ending.as_str() {
            "png" => Some(Self::Png),
            "exr" => Some(Self::Exr),
            "pfm" => Some(Self::Pfm),
            _ => None,
        }
    }
}

impl Film {
    /// The bytes of the picture in a file format. The same film gives the same bytes everywhere.
    ///
    /// # Errors
    /// What the encoder says; none is known for a film of [`render`].
    pub fn encode(&self, format: Format) -> Result<Vec<u8>, String> {
        let (width, height) = (self.size.width, self.size.height);
        let mut bytes = std::io::Cursor::new(Vec::new());
        let encoded = match format {
            Format::Png => {
                let samples: Vec<u8> = self.pixels.iter().flat_map(|rgb| rgb.to_array().map(srgb8)).collect();
                codecs::png::PngEncoder::new(&mut bytes).write_image(&samples, width, height, ExtendedColorType::Rgb8)
            }
            Format::Exr => {
                let samples: Vec<u8> = self.floats().flat_map(f32::to_ne_bytes).collect();
                let encoder = codecs::openexr::OpenExrEncoder::new(&mut bytes);
                encoder.write_image(&samples, width, height, ExtendedColorType::Rgb32F)
            }
            Format::Pfm => return Ok(self.pfm()),
        };
        encoded.map_err(|error| error.to_string())?;
        Ok(bytes.into_inner())
    }

    /// Portable float map: a text header, then little-endian floats, rows from the bottom.
    fn pfm(&self) -> Vec<u8> {
        let mut bytes = format!("PF\n{} {}\n-1.0\n", self.size.width, self.size.height).into_bytes();
        for row in self.pixels.chunks(self.size.width as usize).rev() {
            bytes.extend(row.iter().flat_map(|rgb| rgb.to_array().map(float)).flat_map(f32::to_le_bytes));
        }
        bytes
    }

    fn floats(&self) -> impl Iterator<Item = f32> {
        self.pixels.iter().flat_map(|rgb| rgb.to_array().map(float))
    }
}

/// The nearest finite f32.
fn float(x: f64) -> f32 {
    (x as f32).clamp(f32::MIN, f32::MAX)
}
