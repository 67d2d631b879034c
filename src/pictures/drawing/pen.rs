//! Colours and strokes.

/// An 8-bit sRGB colour with opacity, not premultiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Color {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
    /// Opacity.
    pub a: u8,
}

impl Color {
    /// Black.
    pub const BLACK: Color = Color::hex(0x000000);
    /// White.
    pub const WHITE: Color = Color::hex(0xffffff);

    /// The opaque colour `0xrrggbb`.
    pub const fn hex(rgb: u32) -> Self {
        Color { r: (rgb >> 16) as u8, g: (rgb >> 8) as u8, b: rgb as u8, a: 255 }
    }

    /// The colour at an opacity from 0 to 1.
    pub fn fade(self, opacity: f64) -> Self {
        Color { a: (f64::from(self.a) * opacity.clamp(0.0, 1.0)).round() as u8, ..self }
    }

    /// The opaque mixture with `other`: 0 gives this colour, 1 the other. The mean is taken of the sRGB samples, which
    /// is even enough for tints of one hue.
    pub fn mix(self, other: Color, share: f64) -> Self {
        let t = share.clamp(0.0, 1.0);
        let mean = |x: u8, y: u8| (f64::from(x) * (1.0 - t) + f64::from(y) * t).round() as u8;
        Color { r: mean(self.r, other.r), g: mean(self.g, other.g), b: mean(self.b, other.b), a: 255 }
    }

    /// Relative luminance from 0 (black) to 1 (white), opacity aside. Source: WCAG 2.2.
    pub fn luminance(self) -> f64 {
        let linear = |x: u8| {
            let x = f64::from(x) / 255.0;
            if x <= 0.040_45 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) }
        };
        0.2126 * linear(self.r) + 0.7152 * linear(self.g) + 0.0722 * linear(self.b)
    }

    /// How well the two can be told apart, from 1 to 21; text asks for 4.5, marks for 3. Source: WCAG 2.2.
    pub fn contrast(self, other: Color) -> f64 {
        let (a, b) = (self.luminance(), other.luminance());
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }
}

/// The dash patterns, which repeat what the colour of a line says. Lengths are in widths of the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dash {
    /// An unbroken line.
    #[default]
    Solid,
    /// Long dashes.
    Dashed,
    /// Round dots.
    Dotted,
    /// A dash, a dot.
    DashDot,
    /// Short dashes, close together.
    Short,
}

impl Dash {
    /// Lengths of pen down and pen up, in widths of the line; nothing for an unbroken line. Round caps add one width to
    /// each mark and take it from each gap.
    pub fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[5.0, 4.0],
            Self::Dotted => &[0.01, 2.6],
            Self::DashDot => &[5.5, 3.2, 0.01, 3.2],
            Self::Short => &[2.2, 2.8],
        }
    }
}

/// How a line is drawn: with round joins and caps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Its colour.
    pub color: Color,
    /// Its width.
    pub width: f64,
    /// Its dash pattern.
    pub dash: Dash,
}

impl Pen {
    /// An unbroken line.
    pub fn new(color: Color, width: f64) -> Self {
        Pen { color, width, dash: Dash::Solid }
    }

    /// The same pen with a dash pattern.
    pub fn dashed(self, dash: Dash) -> Self {
        Pen { dash, ..self }
    }
}
