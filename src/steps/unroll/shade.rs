//! The lecture's Shade: the hit made ready, the ambient term, and what adds up to the colour.

use super::super::arithmetic::{Formula, OnSurface};
use super::super::pseudocode::Line;
use super::super::{Procedure, Question, Variable};
use super::{Unroll, hit_variable, sum, vector};
use crate::scene::{Material, Numerics, Pigment, Shape};
use crate::tree::{HitRecord, Kind, RayNode, TestRecord, Value, Verdict};

use Value::{Number, Vector};

/// What a hit is made of, for shading.
pub(super) struct Spot<'a> {
    /// The node's place.
    pub(super) place: usize,
    pub(super) node: &'a RayNode,
    pub(super) hit: &'a HitRecord,
    pub(super) material: &'a Material,
    /// The colour of the ambient and diffuse terms.
    pub(super) surface: [f64; 3],
    /// The shading normal.
    pub(super) normal: [f64; 3],
    /// The kind of diagram that shows what happens here.
    pub(super) picture: &'static str,
}

impl<'a> Unroll<'a> {
    /// The lecture's Shade.
    pub(super) fn shade(&mut self, node: &'a RayNode, hit: &'a HitRecord) -> [f64; 3] {
        let place = self.place(node);
        // Of a surface that sends no ray on there is a section alone.
        let goes_on = node.reflected.is_some() || node.refracted.is_some();
        let picture = if goes_on { "surface" } else { "section" };
        let header = self.step(Line::Shade, place).calls(Procedure::Shade).shows(picture);
        header.sets("level", Variable::Integer(u64::from(node.depth))).sets("hit", hit_variable(hit));
        let radiance = node.radiance.unwrap_or_default();
        let object = self.scene.objects.get(hit.shape as usize);
        let material = object.and_then(|object| self.scene.materials.get(object.material.0 as usize));
        let (Some(object), Some(material)) = (object, material) else {
            let step = self.step(Line::ShadeReturn, place);
            step.finds(false, "the scene has no such object").sets("color", Variable::Vector(radiance)).returning();
            return radiance;
        };
        let in_plane = match object.shape {
            Shape::Plane { normal, .. } => Some(normal),
            _ => None,
        };
        let surface = material.pigment.color(hit.point.into(), in_plane).to_array();
        let normal = hit.shading_normal.unwrap_or(hit.geometric_normal);
        let spot = Spot { place, node, hit, material, surface, normal, picture };
        self.point_and_normal(&spot, &object.shape);
        let mut color = self.ambient(&spot);
        color = self.lights(&spot, color);
        self.snell(&spot);
        let (reflected, refracted) = (node.reflected.as_deref(), node.refracted.as_deref());
        if reflected.is_none() && refracted.is_none() {
            let words = "the surface neither reflects nor lets light through: the recursion ends here";
            self.step(Line::ShadeReflected, place).finds(false, words).shows(picture).asks(Question::next_ray(None));
        }
        for child in reflected.into_iter().chain(refracted) {
            let is_reflected = child.kind == Kind::Reflected;
            let line = if is_reflected { Line::ShadeReflected } else { Line::ShadeRefracted };
            let words =
                if is_reflected { "a ray goes back from the surface" } else { "a ray goes through the surface" };
            let step = self.step(line, place).finds(true, words).shows(picture);
            if is_reflected || reflected.is_none() {
                step.asks(Question::next_ray(Some(child.kind)));
            }
            let returned = self.child(&spot, child);
            let inputs = vec![("color_so_far", Vector(color)), ("more", Vector(returned))];
            let arithmetic = self.work(place, Formula::Sum, inputs, None, &[]);
            color = sum(color, returned);
            let line = if is_reflected { Line::ShadeReflectedSum } else { Line::ShadeRefractedSum };
            self.step(line, place).works(arithmetic).sets("color", Variable::Vector(color)).shows(picture);
        }
        let is_sum = color.map(f64::to_bits) == radiance.map(f64::to_bits);
        let step = self.step(Line::ShadeReturn, place).sets("color", Variable::Vector(radiance)).returning();
        step.shows(picture);
        if !is_sum {
            step.finds(false, "the tree has another colour than the sum of its parts");
        }
        radiance
    }

    fn point_and_normal(&mut self, spot: &Spot<'_>, shape: &Shape) {
        let Spot { place, node, hit, .. } = *spot;
        let setting = self.book.setting;
        let vectors = |v: [glam::DVec3; 3]| v.map(|v| Vector(v.to_array().map(|x| setting.rays.round(x))));
        let rounded = |v: glam::DVec3| Vector(v.to_array().map(|x| setting.rays.round(x)));
        let is_certified = setting.numerics == Numerics::Certified;
        // A certified t is good to more digits than f32 holds; the point is worked out with them.
        let best = node.tests.iter().flatten().rev().find_map(|test| match test {
            TestRecord::Shape(test) if test.verdict == Verdict::Best => test.t,
            _ => None,
        });
        let t = if is_certified && !setting.by_error_bound { best.unwrap_or(hit.t) } else { hit.t };
        let mut inputs = vec![("t", Number(t))];
        let mut tries = vec![OnSurface::Stays];
        let returns = is_certified || setting.by_error_bound;
        let triangle = match (shape, hit.primitive) {
            (Shape::Triangle { vertices }, _) => Some(*vertices),
            (Shape::Mesh(mesh), Some(primitive)) => mesh.triangles.get(primitive as usize).copied(),
            _ => None,
        };
        match (shape, triangle) {
            (Shape::Sphere { center, radius }, _) if returns => {
                inputs.extend([("center", rounded(*center)), ("radius", Number(setting.rays.round(*radius)))]);
                tries =
                    vec![OnSurface::Sphere, OnSurface::FarSphere { near: true }, OnSurface::FarSphere { near: false }];
            }
            (Shape::Box { min, max }, _) if returns => {
                let (mut min, mut max) = (min.to_array(), max.to_array());
                let face = hit.primitive.unwrap_or_default().min(5) as usize;
                let at = if face.is_multiple_of(2) { min[face / 2] } else { max[face / 2] };
                (min[face / 2], max[face / 2]) = (at, at);
                inputs.extend([("face_min", rounded(min.into())), ("face_max", rounded(max.into()))]);
                tries = vec![OnSurface::Face];
            }
            (Shape::Plane { normal, distance }, _) if setting.by_error_bound => {
                inputs.extend([("n", rounded(*normal)), ("D", Number(setting.rays.round(*distance)))]);
                tries = vec![OnSurface::Plane];
            }
            (_, Some(vertices)) if setting.by_error_bound => {
                inputs = ["v0", "v1", "v2"].into_iter().zip(vectors(vertices)).collect();
                let weights = hit.barycentrics.unwrap_or_default();
                inputs.extend(["a", "b", "c"].into_iter().zip(weights.map(Number)));
                tries = vec![OnSurface::Triangle];
            }
            _ => {}
        }
        let wanted = [("p", Vector(hit.point))];
        let tries = tries.into_iter();
        let mut found = tries.map(|surface| self.work(place, Formula::Point(surface), inputs.clone(), None, &wanted));
        let arithmetic = found.find_map(|found| found);
        let step = self.step(Line::ShadePoint, place);
        if arithmetic.is_none() {
            step.finds(true, "o + t d, brought back onto the surface");
        }
        step.works(arithmetic).sets("p", Variable::Vector(hit.point)).shows("section");

        let arithmetic = match shape {
            Shape::Sphere { center, .. } => {
                let inputs = vec![("p", Vector(hit.point)), ("center", rounded(*center))];
                self.work(place, Formula::SphereNormal, inputs, None, &[("n", Vector(hit.geometric_normal))])
            }
            _ => None,
        };
        let is_turned = spot.normal == hit.geometric_normal.map(|x| -x);
        let words = match (is_turned, spot.normal == hit.geometric_normal) {
            (true, _) => "turned round, towards the ray: it comes from behind the outward normal",
            (false, true) => "the outward normal, which points towards the ray already",
            (false, false) => "interpolated between the normals at the corners",
        };
        let step = self.step(Line::ShadeNormal, place).works(arithmetic).finds(true, words);
        step.sets("n", Variable::Vector(spot.normal)).shows(spot.picture);
    }

    fn ambient(&mut self, spot: &Spot<'_>) -> [f64; 3] {
        let ambient = spot.node.local.as_ref().map_or([0.0; 3], |local| local.ambient);
        let (mut arithmetic, mut words) = (None, "the material has no ambient term: black".to_owned());
        if let Some(k) = spot.material.ambient {
            let inputs = vec![("k_a", vector(k)), ("surface", Vector(spot.surface))];
            arithmetic = self.work(spot.place, Formula::Ambient, inputs, None, &[("color", Vector(ambient))]);
            words = match spot.material.pigment {
                Pigment::Constant(_) => "the ambient term".to_owned(),
                Pigment::Checker { .. } => "the ambient term, with the colour of this field of the checker".to_owned(),
            };
        }
        let step = self.step(Line::ShadeAmbient, spot.place).works(arithmetic).finds(true, words);
        step.sets("color", Variable::Vector(ambient)).shows(spot.picture);
        ambient
    }
}
