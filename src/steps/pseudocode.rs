//! The lecture's recursion in pseudocode: what every step is bound to.

use serde::Serialize;

/// A procedure of the recursion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Procedure {
    /// A picture, of which one pixel is looked at.
    RayTrace,
    /// From a pixel to a ray.
    ComputeRay,
    /// From a ray to a colour.
    Trace,
    /// From a ray to its nearest hit.
    Intersect,
    /// From a hit to a colour.
    Shade,
    /// What one light adds.
    ComputeDirectLight,
    /// What the ray back from the surface adds.
    Reflected,
    /// What the ray through the surface adds.
    Refracted,
}

impl Procedure {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::RayTrace => "RayTrace",
            Self::ComputeRay => "ComputeRay",
            Self::Trace => "Trace",
            Self::Intersect => "Intersect",
            Self::Shade => "Shade",
            Self::ComputeDirectLight => "ComputeDirectLight",
            Self::Reflected => "Reflected",
            Self::Refracted => "Refracted",
        }
    }
}

/// A line of the pseudocode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct CodeLine {
    /// The procedure that it stands in.
    pub procedure: Procedure,
    /// How deeply it is indented.
    pub indent: u8,
    /// What it says.
    pub text: &'static str,
}

macro_rules! pseudocode {
    ($($line:ident: $procedure:ident $indent:literal $text:literal;)*) => {
        /// The lines by name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum Line { $($line),* }
        /// All lines, in order.
        pub const PSEUDOCODE: &[CodeLine] = &[$(
            CodeLine { procedure: Procedure::$procedure, indent: $indent, text: $text }
        ),*];
    };
}

pseudocode! {
    RayTrace: RayTrace 0 "RayTrace(view), at pixel (x, y)";
    RayTraceRay: RayTrace 1 "ray = ComputeRay(x, y, view)";
    RayTraceTrace: RayTrace 1 "color = Trace(0, ray)";
    RayTracePut: RayTrace 1 "PutPixel(x, y, color)";
    ComputeRay: ComputeRay 0 "ComputeRay(x, y, view)";
    ComputeRayReturn: ComputeRay 1 "return the ray from the eye through the middle of the pixel";
    Trace: Trace 0 "Trace(level, ray)";
    TraceIntersect: Trace 1 "hit = Intersect(ray)";
    TraceShade: Trace 1 "if there is a hit: color = Shade(level, ray, hit)";
    TraceBackground: Trace 1 "else: color = BackgroundColor(ray)";
    TraceReturn: Trace 1 "return color";
    Intersect: Intersect 0 "Intersect(ray)";
    IntersectBounds: Intersect 1 "for each box ahead: look inside if the ray enters it before best";
    IntersectShape: Intersect 2 "for each shape inside: if the ray hits it before best, best = this hit";
    IntersectReturn: Intersect 1 "return best";
    Shade: Shade 0 "Shade(level, ray, hit)";
    ShadePoint: Shade 1 "p = the hit point";
    ShadeNormal: Shade 1 "n = the unit normal there, towards the ray";
    ShadeAmbient: Shade 1 "color = ambient * the surface's color";
    ShadeLights: Shade 1 "for each light:";
    ShadeDirect: Shade 2 "direct = ComputeDirectLight(light, ray, p, n)";
    ShadeDirectSum: Shade 2 "color = color + direct";
    ShadeSnell: Shade 1 "if it transmits: Snell's law; total reflection?";
    ShadeFresnel: Shade 1 "R = Fresnel's share";
    ShadeReflected: Shade 1 "if it reflects: back = Reflected(level, ray, p, n)";
    ShadeReflectedSum: Shade 2 "color = color + back";
    ShadeRefracted: Shade 1 "if light goes through: through = Refracted(level, ray, p, n)";
    ShadeRefractedSum: Shade 2 "color = color + through";
    ShadeReturn: Shade 1 "return color";
    Direct: ComputeDirectLight 0 "ComputeDirectLight(light, ray, p, n)";
    DirectWay: ComputeDirectLight 1 "l = the way from p to the light";
    DirectCosine: ComputeDirectLight 1 "if n . l < 0: return black";
    DirectIntersect: ComputeDirectLight 1 "hit = Intersect(ray from p along l)";
    DirectBlocked: ComputeDirectLight 1 "if there is a hit before the light: return black";
    DirectDiffuse: ComputeDirectLight 1 "diffuse = k_d * the surface's color * (n . l) * light";
    DirectSpecular: ComputeDirectLight 1 "specular = k_s * max(0, r . v)^shininess * light";
    DirectReturn: ComputeDirectLight 1 "return diffuse + specular";
    Reflected: Reflected 0 "Reflected(level, ray, p, n)";
    ReflectedWay: Reflected 1 "r = d - 2 (d . n) n";
    ReflectedShare: Reflected 1 "share = k_r, with Fresnel k_r * R";
    ReflectedLevel: Reflected 1 "if level = maxLevel: return black";
    ReflectedTrace: Reflected 1 "color = Trace(level + 1, ray from p along r)";
    ReflectedReturn: Reflected 1 "return share * color";
    Refracted: Refracted 0 "Refracted(level, ray, p, n)";
    RefractedWay: Refracted 1 "t = the direction of Snell's law";
    RefractedShare: Refracted 1 "share = k_t, with Fresnel k_t * (1 - R)";
    RefractedLevel: Refracted 1 "if level = maxLevel: return black";
    RefractedTrace: Refracted 1 "color = Trace(level + 1, ray from p along t)";
    RefractedReturn: Refracted 1 "return share * color";
}
