//! Where the light goes on: Snell's law, Fresnel's equations, the reflected and the refracted part.

use super::super::arithmetic::{Cosines, Formula, Split, Tiny, value_of};
use super::super::pseudocode::Line;
use super::super::tested::exact_words;
use super::super::{Arithmetic, Mark, Procedure, Question, Variable};
use super::shade::Spot;
use super::{Unroll, product, vector};
use crate::kernels::refraction_sign;
use crate::numbers::{Stage, is_in_range};
use crate::scene::{Fresnel, Material, Numerics};
use crate::tree::{Kind, Outcome, RayNode, Value, six_digits};

use Value::{Number, Vector};

impl<'a> Unroll<'a> {
    /// Snell's law and Fresnel's equations, where the material asks for them.
    pub(super) fn snell(&mut self, spot: &Spot<'_>) {
        let Spot { place, node, hit, material, .. } = *spot;
        let (fresnel, is_through) = (material.fresnel, material.transmission.is_some());
        let Some([n_i, n_t]) = hit.ior.filter(|_| is_through || (fresnel.is_some() && material.reflection.is_some()))
        else {
            return;
        };
        let is_total = node.total_reflection;
        let inputs = vec![("n", Vector(spot.normal)), ("n_i", Number(n_i)), ("n_t", Number(n_t))];
        let is_certified = self.book.setting.numerics == Numerics::Certified;
        let sign = if is_certified { self.transmission(spot) } else { None };
        let (mut arithmetic, mut words) = (None, String::new());
        let n_words = format!("from index {} into {}", six_digits(n_i), six_digits(n_t));
        if !is_certified {
            let last = if is_total { "k" } else { "cos_t" };
            arithmetic = self.work(place, Formula::SnellUsual(Tiny::Kept), inputs, Some(last), &[]);
            let verdict =
                if is_total { "k < 0: no light gets through, total reflection" } else { "k >= 0: light gets through" };
            words = format!("{n_words}, {verdict}");
        } else if n_i == n_t {
            words = format!("{n_words}: equal indices, the ray goes straight on");
        } else if let Some(s) = sign {
            let words_of =
                if is_total { "S < 0: no light gets through, total reflection" } else { "S >= 0: light gets through" };
            words = format!("{n_words}, {words_of}");
            arithmetic = self.work(place, Formula::SnellSign, inputs, None, &[]);
            if let Some(arithmetic) = &mut arithmetic {
                let note = format!(
                    "S = {s:?}: worked out with more digits, then rounded. Its sign decides, not that of S_64."
                );
                arithmetic.note = Some(note);
            }
        }
        let stage = node.refraction_certificate.map(|certificate| certificate.stage).filter(|s| *s != Stage::Filter);
        if let Some(stage) = stage {
            words = format!("{words}; decided exactly, {}", exact_words(stage));
        }
        let given = |arithmetic: &Arithmetic| {
            let value = |name| value_of(&arithmetic.values, name);
            Some((Cosines::Given, vec![("cos_i", value("cos_i")?), ("cos_t", value("cos_t")?)]))
        };
        let cosines = match sign {
            Some(s) => Some((Cosines::FromSign, vec![("n", Vector(spot.normal)), ("S", Number(s))])),
            None => arithmetic.as_ref().and_then(given),
        };
        let step = self.step(Line::ShadeSnell, place).works(arithmetic).finds(!is_total, words).shows(spot.picture);
        step.marks(Mark::TotalReflection, is_total).marks(Mark::Exact, stage.is_some());
        if is_through {
            step.asks(Question::yes_or_no("Is all light reflected?", is_total));
        }
        let (Some(fresnel), Some(r)) = (fresnel, node.fresnel) else { return };
        let mut arithmetic = None;
        let words = if n_i == n_t {
            "equal indices: nothing is reflected"
        } else if let (false, Some((given, cosines))) = (is_total, cosines) {
            let formula = match fresnel {
                Fresnel::Exact => Formula::FresnelExact(given),
                Fresnel::Schlick => Formula::FresnelSchlick { given, from_smaller: n_i <= n_t },
            };
            let inputs = [cosines, vec![("n_i", Number(n_i)), ("n_t", Number(n_t))]].concat();
            arithmetic = self.work(place, formula, inputs, None, &[("R", Number(r))]);
            "so much comes back; the rest goes through"
        } else {
            "total reflection: everything comes back"
        };
        let step = self.step(Line::ShadeFresnel, place).works(arithmetic).finds(true, words).shows(spot.picture);
        step.sets("R", Variable::Number(r));
    }

    /// The number whose sign decides total reflection under certified numerics, as the tracer rounds it.
    fn transmission(&self, spot: &Spot<'_>) -> Option<f64> {
        let [n_i, n_t] = spot.hit.ior?;
        let (d, n) = (spot.node.direction, spot.normal);
        let is_fine = d.iter().chain(&n).chain(&[n_i, n_t]).all(|x| is_in_range(*x));
        is_fine.then(|| refraction_sign::<f64>(d.into(), n.into(), n_i, n_t))
    }

    /// One of the two children: its direction, its share, and what it brings back.
    pub(super) fn child(&mut self, spot: &Spot<'a>, child: &'a RayNode) -> [f64; 3] {
        let at = self.place(child);
        let is_reflected = child.kind == Kind::Reflected;
        let lines = match is_reflected {
            true => [
                Line::Reflected,
                Line::ReflectedWay,
                Line::ReflectedShare,
                Line::ReflectedLevel,
                Line::ReflectedTrace,
                Line::ReflectedReturn,
            ],
            false => [
                Line::Refracted,
                Line::RefractedWay,
                Line::RefractedShare,
                Line::RefractedLevel,
                Line::RefractedTrace,
                Line::RefractedReturn,
            ],
        };
        let [header, way, share, level, trace, last] = lines;
        let procedure = if is_reflected { Procedure::Reflected } else { Procedure::Refracted };
        let step = self.step(header, at).calls(procedure).shows_of(spot.picture, spot.place);
        step.sets("level", Variable::Integer(u64::from(spot.node.depth)));

        let (arithmetic, words) = self.way_of_child(spot, child, at);
        let step = self.step(way, at).works(arithmetic).finds(true, words).shows_of(spot.picture, spot.place);
        step.sets(if is_reflected { "r" } else { "t" }, Variable::Vector(child.direction));

        let (arithmetic, value, words) = self.share_of_child(spot, child, at);
        let step = self.step(share, at).works(arithmetic).finds(true, words).shows_of(spot.picture, spot.place);
        step.sets("share", Variable::Vector(value));
        if let Some(weight) = child.weight {
            step.sets("weight", Variable::Vector(weight));
        }

        let max_depth = self.tree.settings.and_then(|settings| settings.max_depth);
        let of_max = max_depth.map_or(String::new(), |max| format!(" {max}"));
        let words = match child.outcome {
            Outcome::MaxDepth => format!("level {} = maxLevel: the ray is not traced", spot.node.depth),
            Outcome::BelowMinWeight => "its weight is below min_weight: the ray is not traced".to_owned(),
            Outcome::RayBudget => "the rays of this pixel are spent: the ray is not traced".to_owned(),
            _ => format!("level {} < maxLevel{of_max}: the ray is traced", spot.node.depth),
        };
        let is_traced = child.outcome.is_traced();
        let question = Question::yes_or_no("Is this ray traced?", is_traced);
        let step = self.step(level, at).finds(is_traced, words).asks(question).shows_of("tree", spot.place);
        if !is_traced {
            step.sets("returned", Variable::Vector([0.0; 3])).returning();
            return product(value, [0.0; 3]);
        }
        self.step(trace, at).shows("section");
        self.trace(child);
        let color = child.radiance.unwrap_or_default();
        let inputs = vec![("share", Vector(value)), ("color", Vector(color))];
        let arithmetic = self.work(at, Formula::Returned, inputs, None, &[]);
        let returned = product(value, color);
        let step = self.step(last, at).works(arithmetic).sets("color", Variable::Vector(color));
        step.sets("returned", Variable::Vector(returned)).returning().shows("section");
        returned
    }

    fn way_of_child(&mut self, spot: &Spot<'_>, child: &RayNode, at: usize) -> (Option<Arithmetic>, &'static str) {
        let mut inputs = vec![("d", Vector(spot.node.direction)), ("n", Vector(spot.normal))];
        let wanted = |name| [(name, Vector(child.direction))];
        if child.kind == Kind::Reflected {
            return (self.work_way(at, Formula::Reflect, &inputs, &wanted("r")), "mirrored at the normal");
        }
        let Some([n_i, n_t]) = spot.hit.ior else { return (None, "through the surface") };
        inputs.extend([("n_i", Number(n_i)), ("n_t", Number(n_t))]);
        if self.book.setting.numerics != Numerics::Certified {
            return (self.work_way(at, Formula::SnellUsual, &inputs, &wanted("t")), "bent by Snell's law");
        }
        if child.direction == spot.node.direction {
            let words = "straight on: the indices are equal, or the ray runs along the normal";
            return (None, words);
        }
        let Some(s) = self.transmission(spot) else { return (None, "bent by Snell's law") };
        inputs.push(("S", Number(s)));
        (self.work_way(at, Formula::SnellStable, &inputs, &wanted("t")), "bent by Snell's law")
    }

    /// The share of a child, and the arithmetic of it and of the weight.
    fn share_of_child(
        &mut self,
        spot: &Spot<'_>,
        child: &RayNode,
        at: usize,
    ) -> (Option<Arithmetic>, [f64; 3], &'static str) {
        let Material { reflection, transmission, fresnel, .. } = spot.material;
        let through = transmission.unwrap_or_default();
        let weight = spot.node.weight.unwrap_or([1.0; 3]);
        let r = spot.node.fresnel;
        let (split, mut inputs, words) = match (child.kind, spot.node.total_reflection, r) {
            (Kind::Reflected, true, _) if fresnel.is_some() => {
                let k = reflection.unwrap_or(through);
                (Split::Whole, vec![("k", vector(k))], "total reflection: the whole weight")
            }
            (Kind::Reflected, true, _) => {
                let inputs = vec![("k_r", vector(reflection.unwrap_or_default())), ("k_t", vector(through))];
                (Split::Both, inputs, "total reflection: both weights")
            }
            (Kind::Reflected, false, Some(r)) => {
                let inputs = vec![("k", vector(reflection.unwrap_or_default())), ("R", Number(r))];
                (Split::Reflected, inputs, "of the light that comes back")
            }
            (Kind::Reflected, false, None) => {
                (Split::Whole, vec![("k", vector(reflection.unwrap_or_default()))], "the material's weight")
            }
            (_, _, Some(r)) => {
                (Split::Transmitted, vec![("k", vector(through)), ("R", Number(r))], "of the light that goes through")
            }
            (_, _, None) => (Split::Whole, vec![("k", vector(through))], "the material's weight"),
        };
        inputs.push(("w", Vector(weight)));
        let wanted: Vec<(&str, Value)> = child.weight.iter().map(|weight| ("weight", Vector(*weight))).collect();
        let arithmetic = self.work(at, Formula::Share(split), inputs, None, &wanted);
        let share = arithmetic.as_ref().and_then(|arithmetic| value_of(&arithmetic.values, "share"));
        let value = match (share, child.weight) {
            (Some(Vector(share)), _) => share,
            // A tree that says otherwise than the scene: what its weights say.
            (_, Some(of_child)) => std::array::from_fn(|k| if weight[k] > 0.0 { of_child[k] / weight[k] } else { 0.0 }),
            _ => [0.0; 3],
        };
        (arithmetic, value, words)
    }
}
