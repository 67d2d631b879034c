//! What a program does, written down as a ray tree while it runs.

use super::super::Ray;
use super::{DirectLight, ShadowRay};
use crate::scene::{Limits, Rgb};
use crate::transport::{Surface, Tracer};
use crate::tree::{Kind, LightTerms, Local, Outcome, RayNode, hit_record};

/// The most rays of a pixel, shadow rays not counted: more than any lesson needs.
const MOST_RAYS: usize = 4096;

/// The rays that were begun.
#[derive(Debug, Default)]
pub(super) struct Record {
    /// Those that are not finished, each called by the one before it.
    open: Vec<Open>,
    /// The ray from the eye, once it is finished.
    root: Option<RayNode>,
    rays: usize,
}

/// A ray that is not finished.
#[derive(Debug)]
struct Open {
    node: RayNode,
    /// How often it has asked for something.
    work: usize,
}

impl Record {
    /// Begins a ray. Says no, and writes nothing down, where there are too many, or too many of them call each other.
    pub(super) fn begin(&mut self, kind: Kind, ray: &Ray, ior: f64) -> bool {
        let depth = self.open.len() as u32;
        if depth > Limits::DEEPEST || self.rays >= MOST_RAYS {
            return false;
        }
        self.rays += 1;
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let node = RayNode { ior: Some(ior), ..RayNode::new(kind, depth, origin, direction, Outcome::Background) };
        self.open.push(Open { node: RayNode { weight: None, ..node }, work: 0 });
        true
    }

    /// Ends the ray that was begun last.
    pub(super) fn end(&mut self, radiance: Rgb) {
        let Some(Open { node, .. }) = self.open.pop() else { return };
        let node = RayNode { radiance: Some(radiance.to_array()), ..node };
        match (self.open.last_mut(), node.kind) {
            (None, _) => self.root = Some(node),
            (Some(parent), Kind::Refracted) => parent.node.refracted = Some(Box::new(node)),
            (Some(parent), _) => parent.node.reflected = Some(Box::new(node)),
        }
    }

    /// Counts a piece of work on the ray that was begun last.
    ///
    /// # Panics
    /// Where that is more than `enough`: procedures call each other without an end, and the panic is what tells it.
    #[track_caller]
    pub(super) fn work(&mut self, enough: usize) {
        if let Some(open) = self.open.last_mut() {
            open.work += 1;
            assert!(
                open.work <= enough,
                "this does not end; the rays that go on are sent with trace_reflected and trace_refracted, of level + 1"
            );
        }
    }

    /// Something was found on the ray that was begun last. Until it is shaded the ray has hit nothing.
    pub(super) fn found(&mut self, tracer: &Tracer<'_, f64>, surface: &Surface<f64>) {
        if let Some(Open { node, .. }) = self.open.last_mut() {
            node.hit.get_or_insert_with(|| hit_record(tracer, surface));
        }
    }

    /// The ray that was begun last is at a surface.
    pub(super) fn hit(&mut self, tracer: &Tracer<'_, f64>, surface: &Surface<f64>) {
        if let Some(Open { node, .. }) = self.open.last_mut() {
            node.outcome = Outcome::Hit;
            node.hit = Some(hit_record(tracer, surface));
            node.ior = Some(surface.ior[0]);
        }
    }

    /// The surface's own light.
    pub(super) fn ambient(&mut self, ambient: Rgb) {
        if let Some(Open { node, .. }) = self.open.last_mut() {
            node.local = Some(Local { ambient: ambient.to_array(), lights: Vec::new() });
        }
    }

    /// What a light does to the surface; not told of one that nobody has asked for and that does nothing.
    pub(super) fn light(&mut self, light: &str, direct: DirectLight) {
        let Some(Open { node, .. }) = self.open.last_mut() else { return };
        let was_asked = node.shadows.iter().any(|shadow| shadow.light.as_deref() == Some(light));
        if let Some(local) = &mut node.local
            && (was_asked || direct != DirectLight::default())
        {
            let (diffuse, specular) = (direct.diffuse.to_array(), direct.specular.to_array());
            local.lights.push(LightTerms { light: light.to_owned(), diffuse, specular });
        }
    }

    /// A ray to a light.
    pub(super) fn shadow(&mut self, light: &str, ShadowRay { ray, t_max }: &ShadowRay, ior: f64, is_blocked: bool) {
        let depth = self.open.len().saturating_sub(1) as u32;
        let Some(Open { node, .. }) = self.open.last_mut() else { return };
        let outcome = if is_blocked { Outcome::Blocked } else { Outcome::Lit };
        node.shadows.push(RayNode {
            light: Some(light.to_owned()),
            t_max: t_max.is_finite().then_some(*t_max),
            ior: Some(ior),
            ..RayNode::new(Kind::Shadow, depth, ray.origin.to_array(), ray.direction.to_array(), outcome)
        });
    }

    /// The ray from the eye with all below it.
    pub(super) fn root(self, ray: &Ray) -> RayNode {
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        self.root.unwrap_or_else(|| RayNode::new(Kind::Camera, 0, origin, direction, Outcome::Background))
    }
}
