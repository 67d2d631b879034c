//! The lecture's ComputeDirectLight, light by light.

use super::super::arithmetic::{Formula, Tiny, Values, value_of};
use super::super::pseudocode::Line;
use super::super::{Arithmetic, Procedure, Question, Variable};
use super::shade::Spot;
use super::{Unroll, hit_variable, none, sum, vector};
use crate::scene::{Light, LightKind};
use crate::tree::{Outcome, RayNode, Value};

use Value::{Number, Vector};

impl<'a> Unroll<'a> {
    pub(super) fn lights(&mut self, spot: &Spot<'a>, mut color: [f64; 3]) -> [f64; 3] {
        let node = spot.node;
        let lights = &self.scene.lights;
        if !spot.material.takes_direct_light() {
            let words = "the material has no diffuse and no specular term: direct light could not change it";
            self.step(Line::ShadeLights, spot.place).finds(false, words).shows(spot.picture);
            return color;
        }
        let words = match lights.len() {
            0 => "the scene has no light".to_owned(),
            1 => "one light".to_owned(),
            n => format!("{n} lights"),
        };
        self.step(Line::ShadeLights, spot.place).finds(!lights.is_empty(), words).shows(spot.picture);
        let mut shadows = node.shadows.iter().enumerate().peekable();
        for light in lights {
            let light_name = Variable::Text(light.name.clone());
            self.step(Line::ShadeDirect, spot.place).sets("light", light_name).shows(spot.picture);
            let shadow = shadows.next_if(|(_, shadow)| shadow.light.as_ref() == Some(&light.name));
            let direct = self.direct_light(spot, light, shadow);
            let inputs = vec![("color_so_far", Vector(color)), ("more", Vector(direct))];
            let arithmetic = self.work(spot.place, Formula::Sum, inputs, None, &[]);
            color = sum(color, direct);
            let step = self.step(Line::ShadeDirectSum, spot.place).works(arithmetic);
            step.sets("color", Variable::Vector(color)).shows(spot.picture);
        }
        color
    }

    /// The lecture's ComputeDirectLight.
    fn direct_light(&mut self, spot: &Spot<'a>, light: &Light, shadow: Option<(usize, &'a RayNode)>) -> [f64; 3] {
        let place = spot.place;
        let black = Variable::Vector([0.0; 3]);
        let header = self.step(Line::Direct, place).calls(Procedure::ComputeDirectLight).shows(spot.picture);
        header.sets("light", Variable::Text(light.name.clone()));
        let way = self.way_to(spot, light, shadow.map(|(_, shadow)| shadow));
        let found = |name| {
            let arithmetic = way.as_ref()?;
            value_of(&arithmetic.values, name)
        };
        let l = match (shadow, found("l")) {
            (Some((_, shadow)), _) => Some(shadow.direction),
            (None, Some(Vector(l))) => Some(l),
            (None, _) => None,
        };
        let distance = found("distance");
        let step = self.step(Line::DirectWay, place).works(way).shows(spot.picture);
        if let Some(l) = l {
            step.sets("l", Variable::Vector(l));
        }
        if let Some(Number(distance)) = distance {
            step.sets("distance", Variable::Number(distance));
        }
        let is_faced = shadow.is_some();
        let mut cosine = None;
        if let Some(l) = l {
            let inputs = vec![("l", Vector(l)), ("n", Vector(spot.normal))];
            cosine = self.work(place, Formula::Cosine, inputs, None, &[]);
        }
        let n_dot_l = cosine.as_ref().and_then(|cosine| match value_of(&cosine.values, "n_dot_l")? {
            Number(x) => Some(x),
            Vector(_) => None,
        });
        let agrees = n_dot_l.is_some_and(|x| (x >= 0.0) == is_faced);
        let words = match (is_faced, agrees) {
            (true, _) => "the surface faces the light",
            (false, true) => "n . l < 0: the surface faces away from the light, no shadow ray is needed",
            (false, false) => "the light lies on the surface itself, or too far away for a distance: it adds nothing",
        };
        let question = Question::yes_or_no(format!("Does the surface face {}?", light.name), is_faced);
        let step = self.step(Line::DirectCosine, place).works(cosine.filter(|_| agrees)).finds(is_faced, words);
        step.asks(question).shows(spot.picture);
        if let Some(n_dot_l) = n_dot_l.filter(|_| agrees) {
            step.sets("n_dot_l", Variable::Number(n_dot_l));
        }
        let Some((number, shadow)) = shadow else {
            step.sets("direct", black).returning();
            return [0.0; 3];
        };
        let at = self.place(shadow);
        if !shadow.outcome.is_traced() {
            let words = "the rays of this pixel are spent: what is not known to be lit counts as blocked";
            self.step(Line::DirectIntersect, at)
                .finds(false, words)
                .sets("direct", black)
                .returning()
                .shows(spot.picture);
            return [0.0; 3];
        }
        self.step(Line::DirectIntersect, at).shows("section");
        self.intersect(shadow);
        let is_lit = shadow.outcome == Outcome::Lit;
        let words = match &shadow.hit {
            Some(hit) if !is_lit => format!("{} blocks the light: shadow", self.object(hit)),
            _ if is_lit => "nothing stands between: lit".to_owned(),
            _ => "blocked: shadow".to_owned(),
        };
        let question = Question::between(
            format!("Is this point lit by {}?", light.name),
            ["lit", "in shadow"],
            usize::from(!is_lit),
        );
        let step = self.step(Line::DirectBlocked, at).finds(is_lit, words).asks(question).shows("section");
        step.sets("hit", shadow.hit.as_ref().map_or_else(none, hit_variable));
        if !is_lit {
            step.sets("direct", black).returning();
            return [0.0; 3];
        }
        let local = spot.node.local.as_ref();
        let terms = local.and_then(|local| local.lights.get(number));
        let (diffuse, specular) = terms.map_or(([0.0; 3], [0.0; 3]), |terms| (terms.diffuse, terms.specular));
        let light_color = vector(light.color);
        let (mut arithmetic, mut words) = (None, "the material has no diffuse term");
        if let (Some(k), Some(n_dot_l)) = (spot.material.diffuse, n_dot_l) {
            let inputs = vec![
                ("k_d", vector(k)),
                ("surface", Vector(spot.surface)),
                ("n_dot_l", Number(n_dot_l)),
                ("light", light_color),
            ];
            arithmetic = self.work(place, Formula::Diffuse, inputs, None, &[("diffuse", Vector(diffuse))]);
            words = "Lambert's law";
        }
        let step = self.step(Line::DirectDiffuse, place).works(arithmetic).finds(true, words).shows(spot.picture);
        step.sets("diffuse", Variable::Vector(diffuse));
        let (mut arithmetic, mut words) = (None, "the material has no highlight");
        if let Some(k) = spot.material.specular {
            let inputs = vec![
                ("k_s", vector(k.strength)),
                ("shininess", Number(k.shininess)),
                ("n", Vector(spot.normal)),
                ("l", Vector(shadow.direction)),
                ("light", light_color),
            ];
            arithmetic = self.work(place, Formula::Specular, inputs, None, &[("specular", Vector(specular))]);
            words = "Phong's highlight";
        }
        let step = self.step(Line::DirectSpecular, place).works(arithmetic).finds(true, words).shows(spot.picture);
        step.sets("specular", Variable::Vector(specular));
        let inputs = vec![("diffuse", Vector(diffuse)), ("specular", Vector(specular))];
        let arithmetic = self.work(place, Formula::Direct, inputs, None, &[]);
        let direct = sum(diffuse, specular);
        let step = self.step(Line::DirectReturn, place).works(arithmetic).returning().shows(spot.picture);
        step.sets("direct", Variable::Vector(direct));
        direct
    }

    /// The way to a light.
    fn way_to(&mut self, spot: &Spot<'_>, light: &Light, shadow: Option<&RayNode>) -> Option<Arithmetic> {
        let rays = self.book.setting.rays;
        let rounded = |v: glam::DVec3| Vector(v.to_array().map(|x| rays.round(x)));
        let mut wanted: Vec<(&str, Value)> = shadow.iter().map(|shadow| ("l", Vector(shadow.direction))).collect();
        let (formula, inputs): (fn(Tiny) -> Formula, Values) = match light.kind {
            LightKind::Directional { direction } => {
                (Formula::ToDirectionalLight, vec![("travels", rounded(direction))])
            }
            LightKind::Point { position } => {
                wanted.extend(shadow.and_then(|shadow| shadow.t_max).map(|t_max| ("distance", Number(t_max))));
                (Formula::ToPointLight, vec![("position", rounded(position)), ("p", Vector(spot.hit.point))])
            }
        };
        self.work_way(spot.place, formula, &inputs, &wanted)
    }
}
