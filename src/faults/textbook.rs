//! A Whitted tracer as in a textbook: Trace and Shade in plain f64, an epsilon, every shape tested in turn.

use std::cell::Cell;

use glam::DVec3;

use super::Fault;
use super::shapes::{Meeting, Ray, meet};
use crate::scene::{Background, Fresnel, LightKind, Limits, Material, Rgb, Scene, Shape};
use crate::tree::{Generator, HitRecord, Kind, LightTerms, Local, Outcome, RayNode, RayTree, Side};

/// A tracer that is right as far as f64 goes, or wrong in one place.
///
/// # Accuracy
/// None is promised: near edges, tangents and critical angles its verdicts may be wrong, as those of any such tracer.
///
/// # Example
/// ```
/// use raytree::faults::{Fault, Textbook};
/// use raytree::tree::diff::{Tolerances, diff};
/// let loaded = raytree::scene::load_file("scenes/glass-ball.json").unwrap();
/// let [x, y] = loaded.scene.pixels[0].1;
/// let right = Textbook::new(&loaded.scene).pixel(x, y);
/// let wrong = Textbook::new(&loaded.scene).with(Fault::EtaInverted).pixel(x, y);
/// assert!(!diff(&right, &wrong, &Tolerances::default()).is_same());
/// ```
#[derive(Clone, Debug)]
pub struct Textbook<'s> {
    scene: &'s Scene,
    planted: Option<Fault>,
    limits: Limits,
    guide: Option<&'s RayNode>,
    media_by_side: bool,
}

/// A ray on its way to be traced.
#[derive(Clone, Copy)]
struct Path<'a> {
    kind: Kind,
    /// The level as the program counts it, and as it is.
    level: u32,
    depth: u32,
    weight: Rgb,
    ray: Ray,
    /// The media that the ray is in, in the order of the scene.
    inside: &'a [usize],
    /// The same ray in the tree that is to be reproduced.
    guide: Option<&'a RayNode>,
}

/// What a ray hit, made ready for shading.
struct Surface {
    record: HitRecord,
    object: usize,
    point: DVec3,
    normal: DVec3,
    ior: [f64; 2],
    beyond: Vec<usize>,
}

/// How a surface splits the light.
#[derive(Default)]
struct Split {
    reflected: Option<(DVec3, Rgb)>,
    refracted: Option<(DVec3, Rgb)>,
    fresnel: Option<f64>,
    total_reflection: bool,
}

/// Surfaces this near in `t`, as a share of it, are met together.
const TOGETHER: f64 = 1e-10;
/// What keeps a ray off the surface it starts on, as a share of the coordinates there.
const EPSILON: f64 = 1e-9;

impl<'s> Textbook<'s> {
    /// The tracer without a fault.
    pub fn new(scene: &'s Scene) -> Self {
        Self { scene, planted: None, limits: scene.limits, guide: None, media_by_side: false }
    }

    /// The same with a fault.
    pub fn with(self, fault: Fault) -> Self {
        Self { planted: Some(fault), ..self }
    }

    /// The same with other limits of the recursion.
    pub fn with_limits(self, limits: Limits) -> Self {
        Self { limits, ..self }
    }

    /// The same, told by a tree which rays hit the surface they start on: for [`Fault::HitAtOrigin`], where that goes by the
    /// rounding of a program that nobody knows.
    pub fn guided_by(self, tree: &'s RayTree) -> Self {
        Self { guide: Some(&tree.root), ..self }
    }

    /// The same, which tells the indices of refraction by the side from which it hits glass, as simple tracers do, and does not
    /// carry the media along. Without a fault both agree unless media touch or lie in each other.
    pub fn with_media_by_side(self) -> Self {
        Self { media_by_side: true, ..self }
    }

    fn has(&self, fault: Fault) -> bool {
        self.planted == Some(fault)
    }

    /// The tree of pixel `(x, y)`.
    pub fn pixel(&self, x: u32, y: u32) -> RayTree {
        RayTree { pixel: Some([x, y]), ..self.tree(self.compute_ray(x, y)) }
    }

    /// The tree of any ray, traced as if it came from the eye.
    pub fn ray(&self, origin: [f64; 3], direction: [f64; 3]) -> RayTree {
        self.tree(Ray { origin: origin.into(), direction: direction.into() })
    }

    fn tree(&self, ray: Ray) -> RayTree {
        let inside = self.media_at(&ray);
        let path =
            Path { kind: Kind::Camera, level: 0, depth: 0, weight: Rgb::ONE, ray, inside: &inside, guide: self.guide };
        let budget = Cell::new(self.limits.ray_budget.saturating_sub(1));
        let root = self.trace(path, &budget);
        let generator = Generator { name: "textbook".to_owned(), version: None };
        RayTree { generator: Some(generator), ..RayTree::new(root.radiance.unwrap_or_default(), root) }
    }

    /// The lecture's ComputeRay.
    fn compute_ray(&self, x: u32, y: u32) -> Ray {
        let camera = &self.scene.camera;
        let (width, height) = (f64::from(self.scene.image.width), f64::from(self.scene.image.height));
        let half = if self.has(Fault::PixelCorner) { 0.0 } else { 0.5 };
        let y = if self.has(Fault::RowsFlipped) { height - 1.0 - f64::from(y) } else { f64::from(y) };
        let half_height = match self.planted {
            // tan(x / 2) = tan x / (1 + sqrt(1 + tan^2 x)).
            Some(Fault::FovHalvedTwice) => {
                camera.half_height / (1.0 + (1.0 + camera.half_height * camera.half_height).sqrt())
            }
            Some(Fault::DegreesAsRadians) => libm::tan(libm::atan(camera.half_height).to_degrees()),
            _ => camera.half_height,
        };
        let half_width = if self.has(Fault::AspectIgnored) { half_height } else { half_height * width / height };
        let across = (2.0 * (f64::from(x) + half) / width - 1.0) * half_width;
        let upwards = (1.0 - 2.0 * (y + half) / height) * half_height;
        let direction = camera.forward + camera.right * across + camera.up * upwards;
        Ray { origin: camera.eye, direction: direction / direction.length() }
    }

    /// The lecture's Trace: Intersect, then Shade or BackgroundColor.
    fn trace(&self, path: Path<'_>, budget: &Cell<u64>) -> RayNode {
        let Path { kind, depth, ray, .. } = path;
        let mut node = match self.intersect(&ray, None, path.kind == Kind::Camera, path.guide, path.inside) {
            Some(surface) => return self.shade(path, surface, budget),
            None => RayNode::new(kind, depth, array(ray.origin), array(ray.direction), Outcome::Background),
        };
        node.weight = Some(array(path.weight));
        node.ior = Some(self.ior(path.inside));
        node.radiance = Some(array(match self.scene.background {
            Background::Constant(color) => color,
            background => background.color(ray.direction),
        }));
        node
    }

    /// The lecture's Intersect: the nearest hit of all objects.
    fn intersect(
        &self,
        ray: &Ray,
        t_max: Option<f64>,
        from_eye: bool,
        guide: Option<&RayNode>,
        inside: &[usize],
    ) -> Option<Surface> {
        let size = 1.0 + ray.origin.abs().max_element();
        let epsilon = EPSILON * size / ray.direction.length();
        let mut hits: Vec<(usize, Meeting)> = Vec::new();
        for (i, object) in self.scene.objects.iter().enumerate() {
            // Where the tree to be reproduced hits the surface that its ray starts on, so does this one.
            let hits_own = guide.map(|node| node.hit.as_ref().is_some_and(|h| h.t <= epsilon && h.shape as usize == i));
            let accepts = |t: f64| match (from_eye, self.planted, hits_own) {
                (true, ..) => t >= 0.0,
                (false, Some(Fault::HitAtOrigin), Some(hits_own)) => t > epsilon || t.abs() <= epsilon && hits_own,
                (false, Some(Fault::HitAtOrigin), None) => t >= 0.0,
                _ => t > epsilon,
            };
            hits.extend(meet(&object.shape, ray, self.planted, &accepts).map(|hit| (i, hit)));
        }
        if let Some(t_max) = t_max {
            hits.retain(|(_, hit)| hit.t < t_max);
        }
        let mut nearest = *hits.first()?;
        for hit in &hits[1..] {
            // At equal t the first object counts.
            let is_nearer = hit.1.t < nearest.1.t - TOGETHER * (1.0 + nearest.1.t.abs());
            if is_nearer || self.has(Fault::LastHitWins) {
                nearest = *hit;
            }
        }
        let is_met = |hit: &&(usize, Meeting)| (hit.1.t - nearest.1.t).abs() <= TOGETHER * (1.0 + nearest.1.t.abs());
        let mut beyond = inside.to_vec();
        for (i, hit) in hits.iter().filter(is_met).filter(|(i, _)| self.is_medium(*i)) {
            beyond.retain(|known| known != i);
            if hit.normal.dot(ray.direction) < 0.0 {
                beyond.push(*i);
            }
        }
        beyond.sort_unstable();
        Some(self.surface(ray, nearest.0, &nearest.1, inside, beyond))
    }

    /// A hit made ready for shading.
    fn surface(&self, ray: &Ray, object: usize, hit: &Meeting, inside: &[usize], beyond: Vec<usize>) -> Surface {
        let shape = &self.scene.objects[object].shape;
        let material = self.material(object);
        let point = ray.origin + ray.direction * hit.t;
        let along = hit.normal.dot(ray.direction);
        let turned = |n: DVec3| if along > 0.0 && !self.has(Fault::NormalNotFlipped) { -n } else { n };
        let mut normal = turned(hit.normal);
        if let Some(smooth) = smooth_normal(shape, hit) {
            normal = turned(smooth);
            let away = normal.dot(ray.direction);
            if away > 0.0 && !self.has(Fault::NormalNotFlipped) {
                normal = (normal - ray.direction * (away / ray.direction.length_squared())).normalize_or(normal);
            }
        }
        let side = if along < 0.0 { Side::Entering } else { Side::Leaving };
        let mut ior = [self.ior(inside), self.ior(&beyond)];
        if self.media_by_side {
            let own = if self.is_medium(object) { material.ior.unwrap_or(1.0) } else { 1.0 };
            ior = if along < 0.0 { [1.0, own] } else { [own, 1.0] };
        }
        if let (Some(_), None, Some(coat)) = (material.fresnel, material.transmission, material.ior) {
            ior[1] = coat;
        }
        let record = HitRecord {
            object: Some(self.scene.objects[object].name.clone()),
            primitive: hit.primitive,
            barycentrics: hit.barycentrics,
            shading_normal: Some(array(normal)),
            side: (!matches!(shape, Shape::Triangle { .. })).then_some(side),
            ior: Some(ior),
            ..HitRecord::new(hit.t, array(point), object as u32, array(hit.normal))
        };
        Surface { record, object, point, normal, ior, beyond }
    }

    /// The lecture's Shade: direct light, plus what the reflected and the refracted ray bring back.
    fn shade(&self, path: Path<'_>, surface: Surface, budget: &Cell<u64>) -> RayNode {
        let (origin, direction) = (array(path.ray.origin), array(path.ray.direction));
        let mut node = RayNode::new(path.kind, path.depth, origin, direction, Outcome::Hit);
        node.weight = Some(array(path.weight));
        node.ior = Some(surface.ior[0]);
        node.hit = Some(surface.record.clone());
        let mut color = self.direct_light(&path, &surface, &mut node, budget);
        let split = self.split(&path.ray, &surface);
        node.fresnel = split.fresnel;
        node.total_reflection = split.total_reflection;
        for (kind, way) in [(Kind::Reflected, split.reflected), (Kind::Refracted, split.refracted)] {
            let Some((direction, k)) = way else { continue };
            let guide = path.guide.and_then(|guide| match kind {
                Kind::Reflected => guide.reflected.as_deref(),
                _ => guide.refracted.as_deref(),
            });
            let inside = if kind == Kind::Reflected { path.inside } else { &surface.beyond };
            let child = Path {
                kind,
                level: if self.has(Fault::LevelNotPassed) { path.level } else { path.level + 1 },
                depth: path.depth + 1,
                weight: path.weight * k,
                ray: Ray { origin: surface.point, direction },
                inside,
                guide,
            };
            let child = self.secondary(path.level, child, budget);
            let brought = DVec3::from_array(child.radiance.unwrap_or_default());
            color = if self.has(Fault::ColorBeforeWeight) { k * (color + brought) } else { color + k * brought };
            match kind {
                Kind::Reflected => node.reflected = Some(Box::new(child)),
                _ => node.refracted = Some(Box::new(child)),
            }
        }
        node.radiance = Some(array(color));
        node
    }

    /// The lecture's ComputeDirectLight, with a shadow ray to each light.
    fn direct_light(&self, path: &Path<'_>, surface: &Surface, node: &mut RayNode, budget: &Cell<u64>) -> Rgb {
        let material = self.material(surface.object);
        let in_plane = match self.scene.objects[surface.object].shape {
            Shape::Plane { normal, .. } => Some(normal),
            _ => None,
        };
        let pigment = material.pigment.color(surface.point, in_plane);
        let mut ambient = material.ambient.map_or(Rgb::ZERO, |k| k * pigment);
        if self.has(Fault::AmbientPerLight) {
            ambient *= self.scene.lights.len() as f64;
        }
        let mut local = Local { ambient: array(ambient), lights: Vec::new() };
        let mut sum = ambient;
        let lit_at_all = material.diffuse.is_some() || material.specular.is_some();
        for light in self.scene.lights.iter().filter(|_| lit_at_all) {
            let (to_light, distance) = match light.kind {
                LightKind::Point { position } => {
                    let way = position - surface.point;
                    (way, Some(way.length()))
                }
                LightKind::Directional { direction } => (-direction, None),
            };
            if distance == Some(0.0) {
                continue;
            }
            let unit = to_light / distance.unwrap_or(1.0);
            let cosine = surface.normal.dot(if self.has(Fault::LightVectorNotUnit) { to_light } else { unit });
            if cosine < 0.0 && !self.has(Fault::LightFromBehind) {
                continue;
            }
            let direction = if self.has(Fault::ShadowPastLight) { to_light } else { unit };
            let lit = self.has(Fault::NoShadowRays)
                || self.shadow(path, surface, &light.name, direction, distance, node, budget);
            let mut terms = LightTerms { light: light.name.clone(), diffuse: [0.0; 3], specular: [0.0; 3] };
            if lit {
                let color = if self.has(Fault::LightColorIgnored) { Rgb::ONE } else { light.color };
                let diffuse = material.diffuse.map_or(Rgb::ZERO, |k| k * pigment * cosine * color);
                let specular = self.highlight(material, path.ray.direction, surface.normal, unit) * color;
                (terms.diffuse, terms.specular) = (array(diffuse), array(specular));
                sum += diffuse + specular;
            }
            local.lights.push(terms);
        }
        node.local = Some(local);
        sum
    }

    /// Phong's `strength * max(0, r.v)^shininess`.
    fn highlight(&self, material: &Material, direction: DVec3, normal: DVec3, to_light: DVec3) -> Rgb {
        let Some(specular) = material.specular else { return Rgb::ZERO };
        let (n, l) = (normal.normalize_or_zero(), to_light.normalize_or_zero());
        let view = -direction.normalize_or_zero();
        let view = if self.has(Fault::HighlightAway) { -view } else { view };
        let mirrored = n * (2.0 * n.dot(l)) - l;
        specular.strength * libm::pow(mirrored.dot(view).clamp(0.0, 1.0), specular.shininess)
    }

    /// Sends a shadow ray; says whether the light reaches the surface.
    #[expect(clippy::too_many_arguments, reason = "what the lecture passes along, spelled out")]
    fn shadow(
        &self,
        path: &Path<'_>,
        surface: &Surface,
        light: &str,
        direction: DVec3,
        distance: Option<f64>,
        node: &mut RayNode,
        budget: &Cell<u64>,
    ) -> bool {
        let (origin, t_max) = (array(surface.point), distance.filter(|_| !self.has(Fault::ShadowUnbounded)));
        let mut shadow = RayNode::new(Kind::Shadow, path.depth, origin, array(direction), Outcome::Lit);
        shadow.light = Some(light.to_owned());
        shadow.t_max = t_max;
        if !take(budget) {
            shadow.outcome = Outcome::RayBudget;
            node.shadows.push(shadow);
            return false;
        }
        let guide = path.guide.and_then(|node| node.shadows.iter().find(|node| node.light.as_deref() == Some(light)));
        let ray = Ray { origin: surface.point, direction };
        shadow.ior = Some(surface.ior[0]);
        let blocker = self.intersect(&ray, t_max, false, guide, path.inside);
        let lit = blocker.is_none();
        if let Some(blocker) = blocker {
            shadow.outcome = Outcome::Blocked;
            shadow.hit = Some(blocker.record);
        }
        node.shadows.push(shadow);
        lit
    }

    /// Which rays go on from a surface, and their shares.
    fn split(&self, ray: &Ray, surface: &Surface) -> Split {
        let material = self.material(surface.object);
        let (d, n) = (ray.direction, surface.normal);
        let mut split = Split::default();
        let mut reflection = material.reflection;
        if material.transmission.is_some() || reflection.is_some() && material.fresnel.is_some() {
            let refracted = self.refract(d, n, surface.ior);
            split.fresnel = material.fresnel.map(|form| self.reflectance(form, d, n, surface.ior));
            let back = split.fresnel.unwrap_or(1.0);
            let swapped = self.has(Fault::FresnelSwapped) && split.fresnel.is_some();
            match (material.transmission, refracted) {
                (None, _) => reflection = reflection.map(|k| k * back),
                (Some(transmission), Some(direction)) => {
                    let through = split.fresnel.map_or(1.0, |r| if swapped { r } else { 1.0 - r });
                    split.refracted = Some((direction, transmission * through));
                    reflection = reflection.map(|k| k * if swapped { 1.0 - back } else { back });
                }
                (Some(_), None) if self.has(Fault::TotalReflectionDropped) => reflection = None,
                (Some(transmission), None) => {
                    split.total_reflection = true;
                    reflection = Some(match material.fresnel {
                        Some(_) => reflection.unwrap_or(transmission),
                        None => reflection.unwrap_or(Rgb::ZERO) + transmission,
                    });
                }
            }
        }
        let sign = if self.has(Fault::ReflectSign) { 1.0 } else { -1.0 };
        split.reflected = reflection.map(|k| (d + sign * 2.0 * d.dot(n) * n, k));
        split
    }

    /// Snell's law: `eta d + (eta cos_i - cos_t) n`, or nothing at total reflection.
    fn refract(&self, d: DVec3, n: DVec3, [incident, transmitted]: [f64; 2]) -> Option<DVec3> {
        let eta = if self.has(Fault::EtaInverted) { transmitted / incident } else { incident / transmitted };
        let cosine = -d.dot(n) / d.length();
        let mut k = 1.0 - eta * eta * (1.0 - cosine * cosine);
        if k < 0.0 && !self.has(Fault::TotalReflectionThrough) {
            return None;
        }
        k = k.max(0.0);
        Some(d * eta + n * ((eta * cosine - k.sqrt()) * d.length()))
    }

    /// Fresnel's share of the reflected light.
    fn reflectance(&self, form: Fresnel, d: DVec3, n: DVec3, [incident, transmitted]: [f64; 2]) -> f64 {
        if incident == transmitted {
            return 0.0;
        }
        let eta = if self.has(Fault::EtaInverted) { transmitted / incident } else { incident / transmitted };
        let cos_incident = (d.dot(n).abs() / d.length()).min(1.0);
        let k = 1.0 - eta * eta * (1.0 - cos_incident * cos_incident);
        if k < 0.0 {
            return 1.0;
        }
        let cos_transmitted = k.sqrt();
        match form {
            Fresnel::Exact => {
                let (a, b) = (incident * cos_incident, transmitted * cos_transmitted);
                let (c, e) = (transmitted * cos_incident, incident * cos_transmitted);
                let (s, p) = ((a - b) / (a + b), (c - e) / (c + e));
                0.5 * (s * s + p * p)
            }
            Fresnel::Schlick => {
                let r0 = square((incident - transmitted) / (incident + transmitted));
                let is_rarer = (incident <= transmitted) != self.has(Fault::SchlickWrongSide);
                let x = 1.0 - if is_rarer { cos_incident } else { cos_transmitted };
                r0 + (1.0 - r0) * square(square(x)) * x
            }
        }
    }

    /// Traces one of the two children of a hit at `level`, unless the recursion ends here.
    fn secondary(&self, level: u32, child: Path<'_>, budget: &Cell<u64>) -> RayNode {
        let deepest = self.limits.max_depth + u32::from(self.has(Fault::LevelOneTooMany));
        let outcome = if level >= deepest || child.depth > Limits::DEEPEST {
            Outcome::MaxDepth
        } else if self.limits.min_weight.is_some_and(|least| child.weight.max_element() < least) {
            Outcome::BelowMinWeight
        } else if !take(budget) {
            Outcome::RayBudget
        } else {
            return self.trace(child, budget);
        };
        let (origin, direction) = (array(child.ray.origin), array(child.ray.direction));
        let mut node = RayNode::new(child.kind, child.depth, origin, direction, outcome);
        node.weight = Some(array(child.weight));
        node.radiance = Some([0.0; 3]);
        node
    }

    fn material(&self, object: usize) -> &Material {
        &self.scene.materials[self.scene.objects[object].material.0 as usize]
    }

    fn is_medium(&self, object: usize) -> bool {
        self.scene.objects[object].shape.is_solid() && self.material(object).transmission.is_some()
    }

    /// The index of refraction inside these media: that of the last.
    fn ior(&self, inside: &[usize]) -> f64 {
        inside.last().and_then(|&object| self.material(object).ior).unwrap_or(1.0)
    }

    /// The media that a camera ray starts in.
    fn media_at(&self, ray: &Ray) -> Vec<usize> {
        let o = ray.origin;
        let contains = |object: usize| match &self.scene.objects[object].shape {
            Shape::Sphere { center, radius } => (o - center).length() < *radius,
            Shape::Plane { normal, distance } => normal.dot(o) < *distance,
            Shape::Box { min, max } => (0..3).all(|k| min[k] < o[k] && o[k] < max[k]),
            Shape::Triangle { .. } => false,
            // From inside the first triangle is met from behind.
            shape => meet(shape, ray, None, &|t| t >= 0.0).is_some_and(|hit| hit.normal.dot(ray.direction) > 0.0),
        };
        (0..self.scene.objects.len()).filter(|&object| self.is_medium(object) && contains(object)).collect()
    }
}

/// The normal interpolated from those at the corners, on a smooth mesh.
fn smooth_normal(shape: &Shape, hit: &Meeting) -> Option<DVec3> {
    let Shape::Mesh(mesh) = shape else { return None };
    let [n0, n1, n2] = *mesh.corner_normals.as_ref()?.get(hit.primitive? as usize)?;
    let [a, b, c] = hit.barycentrics?;
    (n0 * a + n1 * b + n2 * c).try_normalize()
}

/// Takes a ray out of the budget, or says that none is left.
fn take(budget: &Cell<u64>) -> bool {
    match budget.get().checked_sub(1) {
        Some(rest) => {
            budget.set(rest);
            true
        }
        None => false,
    }
}

fn array(v: DVec3) -> [f64; 3] {
    v.to_array()
}

fn square(x: f64) -> f64 {
    x * x
}
