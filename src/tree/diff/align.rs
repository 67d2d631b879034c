//! Two trees side by side, node by node, in trace order.

use std::collections::{BTreeMap, BTreeSet};

use super::field::Measure;
use super::{Difference, Distance, Divergence, Field, Missing, Pair, Tolerances, Value, Which};
use crate::tree::path::Branch;
use crate::tree::{HitRecord, Kind, Ledger, LightTerms, NodePath, Outcome, RayNode, RayTree};

pub(super) fn compare(a: &RayTree, b: &RayTree, tolerances: &Tolerances) -> Difference {
    let mut walk = Walk {
        keys: [keys(&a.root), keys(&b.root)],
        tolerances,
        found: Vec::new(),
        missing: BTreeMap::new(),
        nearest: None,
    };
    let start = Parted::default();
    let parted = walk.node(&NodePath::ROOT, &a.root, &b.root, start, largest(&[a.root.origin, b.root.origin]));
    let change: [f64; 3] = std::array::from_fn(|k| b.color[k] - a.color[k]);
    let place = Place { path: &NodePath::ROOT, kind: Kind::Camera, reach: 0.0, light: None, effect: Some(change) };
    walk.numbers(&place, Field::Color, Some(&a.color), Some(&b.color), parted.brings);
    Difference {
        divergences: walk.found,
        colors: [a.color, b.color],
        rays: [a.rays, b.rays],
        missing: walk.missing.into_iter().map(|((which, field), rays)| Missing { field, tree: which, rays }).collect(),
        notes: notes(a, b),
        nearest_agreement: walk.nearest.map(|(_, divergence)| divergence),
        tolerances: tolerances.clone(),
    }
}

/// What makes two trees hard to compare.
fn notes(a: &RayTree, b: &RayTree) -> Vec<String> {
    let mut notes = Vec::new();
    if let (Some(p), Some(q)) = (a.pixel, b.pixel)
        && p != q
    {
        notes.push(format!("A is of pixel {},{}, B of pixel {},{}", p[0], p[1], q[0], q[1]));
    }
    let hash = |tree: &RayTree| tree.scene.as_ref().and_then(|scene| scene.sha256.clone());
    if let (Some(p), Some(q)) = (hash(a), hash(b))
        && !p.eq_ignore_ascii_case(&q)
    {
        notes.push("the scenes of A and B have different hashes".to_owned());
    }
    let depth = |tree: &RayTree| tree.settings.and_then(|settings| settings.max_depth);
    if let (Some(p), Some(q)) = (depth(a), depth(b))
        && p != q
    {
        notes.push(format!("A was traced with max_depth {p}, B with {q}"));
    }
    notes
}

/// The optional fields that a tree has somewhere, of shadow rays and of others.
fn keys(root: &RayNode) -> BTreeSet<(bool, Field)> {
    let mut keys = BTreeSet::new();
    for node in root.walk() {
        let shadow = node.kind == Kind::Shadow;
        let hit = node.hit.as_ref();
        let is_there = [
            (Field::Light, node.light.is_some()),
            (Field::Weight, node.weight.is_some()),
            (Field::Ior, node.ior.is_some()),
            (Field::TMax, node.t_max.is_some()),
            (Field::Hit, hit.is_some()),
            (Field::Object, hit.is_some_and(|hit| hit.object.is_some())),
            (Field::Primitive, hit.is_some_and(|hit| hit.primitive.is_some())),
            (Field::Barycentrics, hit.is_some_and(|hit| hit.barycentrics.is_some())),
            (Field::ShadingNormal, hit.is_some_and(|hit| hit.shading_normal.is_some())),
            (Field::Side, hit.is_some_and(|hit| hit.side.is_some())),
            (Field::HitIor, hit.is_some_and(|hit| hit.ior.is_some())),
            (Field::Local, node.local.is_some()),
            (Field::Fresnel, node.fresnel.is_some()),
            (Field::Radiance, node.radiance.is_some()),
        ];
        keys.extend(is_there.into_iter().filter(|(_, there)| *there).map(|(field, _)| (shadow, field)));
    }
    keys
}

fn largest(vectors: &[[f64; 3]]) -> f64 {
    vectors.iter().flatten().fold(0.0, |m, x| m.max(x.abs()))
}

fn length(v: [f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

/// In what two nodes have parted, as far as it makes what comes later part as well.
#[derive(Clone, Copy, Debug, Default)]
struct Parted {
    /// The ray, or what it meets, or where.
    geometry: bool,
    /// The medium, or how the light is split.
    optics: bool,
    /// The weight.
    weight: bool,
    /// What the ray brings back.
    brings: bool,
}

/// Which value is looked at.
struct Place<'a> {
    path: &'a NodePath,
    kind: Kind,
    /// The largest coordinate on the way here; of a ray parameter in units of the direction.
    reach: f64,
    light: Option<&'a str>,
    effect: Option<[f64; 3]>,
}

struct Walk<'a> {
    keys: [BTreeSet<(bool, Field)>; 2],
    tolerances: &'a Tolerances,
    found: Vec<Divergence>,
    missing: BTreeMap<(Which, Field), u64>,
    nearest: Option<(f64, Divergence)>,
}

impl Walk<'_> {
    /// Compares two nodes and all below them; says in what they have parted.
    fn node(&mut self, path: &NodePath, a: &RayNode, b: &RayNode, from: Parted, reach: f64) -> Parted {
        let points = [a, b].map(|node| node.hit.as_ref().map_or(node.origin, |hit| hit.point));
        let reach = reach.max(largest(&[a.origin, b.origin])).max(largest(&points));
        let effect = change(Some(a), Some(b));
        let place = Place { path, kind: a.kind, reach, light: None, effect };
        let along = Place { reach: reach / length(a.direction).max(f64::MIN_POSITIVE), ..place };

        // The ray.
        let of_structure = from.geometry || from.optics;
        let mut geometry = from.geometry;
        geometry |= self.words(&place, Field::Kind, Some(word(a.kind)), Some(word(b.kind)), of_structure);
        let lights = [a, b].map(|node| node.light.clone().map(Value::Word));
        let [light_a, light_b] = lights;
        geometry |= self.words(&place, Field::Light, light_a, light_b, of_structure);
        let follows = from.weight || of_structure;
        let weight = self.numbers(&place, Field::Weight, slice(&a.weight), slice(&b.weight), follows) || from.weight;
        let iors = [a.ior, b.ior].map(|ior| ior.map(|x| [x]));
        // An untraced ray is in no medium; that it is not traced is what parts.
        let both_traced = a.outcome.is_traced() == b.outcome.is_traced();
        let medium = from.optics
            | (both_traced && self.numbers(&place, Field::Ior, slice(&iors[0]), slice(&iors[1]), of_structure));
        geometry |= self.numbers(&place, Field::Origin, Some(&a.origin), Some(&b.origin), geometry);
        let bends = geometry || from.optics;
        geometry |= self.numbers(&place, Field::Direction, Some(&a.direction), Some(&b.direction), bends);
        let ends = [a.t_max, b.t_max].map(|t_max| t_max.map(|x| [x]));
        geometry |= self.numbers(&along, Field::TMax, slice(&ends[0]), slice(&ends[1]), geometry);

        // What it meets.
        let ends_by_weight = [a.outcome, b.outcome].contains(&Outcome::BelowMinWeight);
        let follows = geometry || weight && ends_by_weight;
        geometry |= self.words(&place, Field::Outcome, Some(word(a.outcome)), Some(word(b.outcome)), follows);
        let mut optics = medium;
        match (&a.hit, &b.hit) {
            (Some(p), Some(q)) => {
                (geometry, optics) = self.hit(&place, &along, p, q, geometry, medium);
            }
            (None, None) => {}
            (p, q) => {
                let told = |hit: &Option<HitRecord>| hit.as_ref().map(|hit| Value::Place(hit.shape));
                let parted = self.words(&place, Field::Hit, told(p), told(q), geometry);
                // A blocker that one tree does not tell changes nothing.
                geometry |= parted && a.kind != Kind::Shadow;
            }
        }

        // Direct light.
        let mut brings = geometry;
        match (&a.local, &b.local) {
            (Some(p), Some(q)) => {
                let effect = Some(scaled_change(a.weight, b.weight, p.ambient, q.ambient));
                let place = Place { effect, ..place };
                brings |= self.numbers(&place, Field::Ambient, Some(&p.ambient), Some(&q.ambient), geometry);
            }
            (None, None) => {}
            (p, q) => {
                let told = |local: bool| local.then_some(Value::Flag(true));
                brings |= self.words(&place, Field::Local, told(p.is_some()), told(q.is_some()), geometry);
            }
        }
        brings |= self.shadows(&place, a, b, geometry);

        // The split and the children.
        let fresnels = [a.fresnel, b.fresnel].map(|fresnel| fresnel.map(|x| [x]));
        let follows = geometry || optics;
        optics |= self.numbers(&place, Field::Fresnel, slice(&fresnels[0]), slice(&fresnels[1]), follows);
        let totals = [a, b].map(|node| Some(Value::Flag(node.total_reflection)));
        let [total_a, total_b] = totals;
        let follows = geometry || optics;
        optics |= self.words(&place, Field::TotalReflection, total_a, total_b, follows);
        let from = Parted { geometry, optics, weight, brings: false };
        let children = [
            (Branch::Reflected, Field::Reflected, &a.reflected, &b.reflected),
            (Branch::Refracted, Field::Refracted, &a.refracted, &b.refracted),
        ];
        for (branch, field, p, q) in children {
            match (p.as_deref(), q.as_deref()) {
                (Some(p), Some(q)) => {
                    let below = self.node(&path.child(branch), p, q, from, reach);
                    brings |= below.brings || below.weight && !weight;
                }
                (None, None) => {}
                (p, q) => {
                    let place = Place { effect: change(p, q), ..place };
                    let told = |child: Option<&RayNode>| child.map(|child| word(child.outcome));
                    self.structure(&place, field, told(p), told(q), geometry || optics);
                    brings = true;
                }
            }
        }
        if a.kind != Kind::Shadow {
            brings |= self.numbers(&place, Field::Radiance, slice(&a.radiance), slice(&b.radiance), brings);
        }
        Parted { geometry, optics, weight, brings }
    }

    /// Compares two hits; says whether they part in geometry, and whether in optics.
    fn hit(
        &mut self,
        place: &Place<'_>,
        along: &Place<'_>,
        a: &HitRecord,
        b: &HitRecord,
        geometry: bool,
        medium: bool,
    ) -> (bool, bool) {
        let mut parted = geometry;
        parted |= self.structure(place, Field::Shape, Some(Value::Place(a.shape)), Some(Value::Place(b.shape)), parted);
        let [name_a, name_b] = [a, b].map(|hit| hit.object.clone().map(Value::Word));
        parted |= self.words(place, Field::Object, name_a, name_b, parted);
        let [part_a, part_b] = [a, b].map(|hit| hit.primitive.map(Value::Place));
        parted |= self.words(place, Field::Primitive, part_a, part_b, parted);
        parted |= self.numbers(along, Field::T, Some(&[a.t]), Some(&[b.t]), parted);
        parted |= self.numbers(place, Field::Point, Some(&a.point), Some(&b.point), parted);
        let follows = parted;
        let (p, q) = (slice(&a.barycentrics), slice(&b.barycentrics));
        parted |= self.numbers(place, Field::Barycentrics, p, q, follows);
        let (p, q) = (Some(&a.geometric_normal[..]), Some(&b.geometric_normal[..]));
        parted |= self.numbers(place, Field::GeometricNormal, p, q, parted);
        let (p, q) = (slice(&a.shading_normal), slice(&b.shading_normal));
        parted |= self.numbers(place, Field::ShadingNormal, p, q, parted);
        let [side_a, side_b] = [a, b].map(|hit| hit.side.map(word));
        parted |= self.words(place, Field::Side, side_a, side_b, parted);
        let optics = self.numbers(place, Field::HitIor, slice(&a.ior), slice(&b.ior), parted || medium) || medium;
        (parted, optics)
    }

    /// Compares the shadow rays of two nodes, aligned by their lights, and after each the terms of its light; says whether the
    /// terms part.
    fn shadows(&mut self, place: &Place<'_>, a: &RayNode, b: &RayNode, geometry: bool) -> bool {
        let (terms_a, terms_b) = (terms(a), terms(b));
        let mut lights: BTreeSet<&str> = terms_a.keys().chain(terms_b.keys()).copied().collect();
        let mut parted = false;
        for (branch, p, q) in shadow_pairs(&a.shadows, &b.shadows) {
            let light = p.or(q).and_then(|node| node.light.as_deref());
            let key = light.unwrap_or_default();
            let [before, after] = [&terms_a, &terms_b].map(|terms| terms.get(key).copied());
            let sum = |terms: Option<&LightTerms>| {
                terms.map_or([0.0; 3], |t| std::array::from_fn(|k| t.diffuse[k] + t.specular[k]))
            };
            let effect = Some(scaled_change(a.weight, b.weight, sum(before), sum(after)));
            let here = Place { light, effect, ..*place };
            let parts = match (p, q) {
                (Some(p), Some(q)) => {
                    let count = self.found.len();
                    let from = Parted { geometry, ..Parted::default() };
                    let below = self.node(&place.path.child(branch), p, q, from, place.reach);
                    // What a shadow ray does to the pixel is what its light does.
                    self.found[count..].iter_mut().for_each(|divergence| divergence.effect = effect);
                    below.geometry
                }
                (p, q) => {
                    let told = |node: Option<&RayNode>| node.map(|node| word(node.outcome));
                    self.structure(&here, Field::Shadows, told(p), told(q), geometry)
                }
            };
            lights.remove(key);
            let both = a.local.is_some() && b.local.is_some();
            parted |= parts;
            if both {
                parted |= self.light_terms(&here, a, b, before, after, geometry || parts);
            }
        }
        // Lights that have terms but no shadow ray.
        if a.local.is_some() && b.local.is_some() {
            for light in lights {
                let [before, after] = [&terms_a, &terms_b].map(|terms| terms.get(light).copied());
                let here = Place { light: Some(light), ..*place };
                parted |= self.light_terms(&here, a, b, before, after, geometry);
            }
        }
        parted
    }

    /// Compares the terms of one light; those that are not there are zero.
    fn light_terms(
        &mut self,
        place: &Place<'_>,
        a: &RayNode,
        b: &RayNode,
        p: Option<&LightTerms>,
        q: Option<&LightTerms>,
        follows: bool,
    ) -> bool {
        let mut parted = false;
        let terms = |of: fn(&LightTerms) -> [f64; 3]| [p, q].map(|terms| terms.map_or([0.0; 3], of));
        for (field, [p, q]) in [(Field::Diffuse, terms(|t| t.diffuse)), (Field::Specular, terms(|t| t.specular))] {
            let place = Place { effect: Some(scaled_change(a.weight, b.weight, p, q)), ..*place };
            parted |= self.numbers(&place, field, Some(&p), Some(&q), follows);
        }
        parted
    }

    /// Compares optional values that agree exactly or not at all; says whether they part.
    fn words(&mut self, place: &Place<'_>, field: Field, a: Option<Value>, b: Option<Value>, follows: bool) -> bool {
        if a.is_some() != b.is_some() && self.is_unwritten(place, field, a.is_none(), follows) {
            return false;
        }
        self.structure(place, field, a, b, follows)
    }

    /// Compares values that are part of the structure; says whether they part.
    fn structure(
        &mut self,
        place: &Place<'_>,
        field: Field,
        a: Option<Value>,
        b: Option<Value>,
        follows: bool,
    ) -> bool {
        let parts = a != b;
        if parts {
            self.found.push(divergence(place, field, a, b, None, follows));
        }
        parts
    }

    /// Compares numbers; says whether they part.
    fn numbers(
        &mut self,
        place: &Place<'_>,
        field: Field,
        a: Option<&[f64]>,
        b: Option<&[f64]>,
        follows: bool,
    ) -> bool {
        let (Some(p), Some(q)) = (a, b) else {
            if a.is_none() && b.is_none() || self.is_unwritten(place, field, a.is_none(), follows) {
                return false;
            }
            self.found.push(divergence(place, field, a.map(value), b.map(value), None, follows));
            return true;
        };
        let least = match field.measure() {
            Some(Measure::Length | Measure::Parameter) => place.reach,
            Some(Measure::Unit) | None => 1.0,
        };
        let distance = Distance::between(p, q, least);
        let tolerance = self.tolerances.of_field(field);
        let allowed = tolerance.allowed(distance.scale);
        if distance.absolute > allowed {
            self.found.push(divergence(place, field, Some(value(p)), Some(value(q)), Some(distance), follows));
            return true;
        }
        let share = distance.absolute / allowed;
        if distance.absolute > 0.0 && self.nearest.as_ref().is_none_or(|(most, _)| share > *most) {
            let agreed = divergence(place, field, Some(value(p)), Some(value(q)), Some(distance), false);
            self.nearest = Some((share, agreed));
        }
        false
    }

    /// Whether a field is not there because that tree has it nowhere; then it is noted.
    fn is_unwritten(&mut self, place: &Place<'_>, field: Field, not_in_a: bool, follows: bool) -> bool {
        let (which, keys) = if not_in_a { (Which::A, &self.keys[0]) } else { (Which::B, &self.keys[1]) };
        let unwritten = !keys.contains(&(place.kind == Kind::Shadow, field));
        if unwritten && !follows {
            *self.missing.entry((which, field)).or_default() += 1;
        }
        unwritten
    }
}

fn divergence(
    place: &Place<'_>,
    field: Field,
    a: Option<Value>,
    b: Option<Value>,
    distance: Option<Distance>,
    consequence: bool,
) -> Divergence {
    let light = place.light.map(str::to_owned);
    let (path, kind, effect) = (place.path.clone(), place.kind, place.effect);
    Divergence { path, kind, field, light, a, b, distance, effect, consequence }
}

/// A branch of a node with its ray in A and in B.
type BranchPair<'t> = (Branch, Option<&'t RayNode>, Option<&'t RayNode>);

/// Shadow rays in pairs, by their lights; what only B has comes last, with its place there.
fn shadow_pairs<'t>(a: &'t [RayNode], b: &'t [RayNode]) -> Vec<BranchPair<'t>> {
    let mut rest: Vec<(usize, &RayNode)> = b.iter().enumerate().collect();
    let mut pairs: Vec<BranchPair<'t>> = Vec::new();
    for (i, p) in a.iter().enumerate() {
        let same = rest.iter().position(|(_, q)| q.light == p.light);
        pairs.push((Branch::Shadow(i), Some(p), same.map(|j| rest.remove(j).1)));
    }
    pairs.extend(rest.into_iter().map(|(j, q)| (Branch::Shadow(j), None, Some(q))));
    pairs
}

/// Both trees as one: the rays of all places that either of them has, in trace order.
pub(super) fn pairs<'t>(a: &'t RayTree, b: &'t RayTree) -> Vec<Pair<'t>> {
    let mut pairs = Vec::new();
    let mut open = vec![Pair { path: NodePath::ROOT, depth: 0, a: Some(&a.root), b: Some(&b.root) }];
    while let Some(pair) = open.pop() {
        let shadows = |node: Option<&'t RayNode>| node.map_or(&[][..], |node| &node.shadows);
        let mut below = shadow_pairs(shadows(pair.a), shadows(pair.b));
        let both = |of: fn(&RayNode) -> Option<&RayNode>| (pair.a.and_then(of), pair.b.and_then(of));
        let (p, q) = both(|node| node.reflected.as_deref());
        below.push((Branch::Reflected, p, q));
        let (p, q) = both(|node| node.refracted.as_deref());
        below.push((Branch::Refracted, p, q));
        let there = below.into_iter().rev().filter(|(_, a, b)| a.is_some() || b.is_some());
        let depth = pair.depth + 1;
        open.extend(there.map(|(branch, a, b)| Pair { path: pair.path.child(branch), depth, a, b }));
        pairs.push(pair);
    }
    pairs
}

/// The terms of a node's lights by name.
fn terms(node: &RayNode) -> BTreeMap<&str, &LightTerms> {
    node.local.iter().flat_map(|local| &local.lights).map(|terms| (terms.light.as_str(), terms)).collect()
}

/// A word of the format.
fn word(value: impl serde::Serialize) -> Value {
    let word = serde_json::to_value(value).ok().and_then(|value| value.as_str().map(str::to_owned));
    Value::Word(word.unwrap_or_default())
}

fn value(numbers: &[f64]) -> Value {
    match numbers {
        [number] => Value::Number(*number),
        _ => Value::Numbers(numbers.to_vec()),
    }
}

fn slice<const N: usize>(numbers: &Option<[f64; N]>) -> Option<&[f64]> {
    numbers.as_ref().map(|numbers| &numbers[..])
}

/// What a node brings to the pixel: its radiance times its weight; without a radiance the sum of what is below it.
fn share(node: &RayNode) -> Option<[f64; 3]> {
    let weight = node.weight?;
    match node.radiance {
        Some(radiance) => Some(std::array::from_fn(|k| weight[k] * radiance[k])),
        None => {
            let all = node.walk().filter(|node| node.outcome == Outcome::Hit).all(|node| node.local.is_some());
            all.then(|| Ledger::of(&RayTree::new([0.0; 3], node.clone())).sum)
        }
    }
}

/// What two nodes bring to the pixel, the second less the first; one that is not there brings nothing.
fn change(a: Option<&RayNode>, b: Option<&RayNode>) -> Option<[f64; 3]> {
    let of = |node: Option<&RayNode>| node.map_or(Some([0.0; 3]), share);
    let (a, b) = (of(a)?, of(b)?);
    Some(std::array::from_fn(|k| b[k] - a[k]))
}

fn scaled_change(weight_a: Option<[f64; 3]>, weight_b: Option<[f64; 3]>, a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let (p, q) = (weight_a.unwrap_or([1.0; 3]), weight_b.unwrap_or([1.0; 3]));
    std::array::from_fn(|k| q[k] * b[k] - p[k] * a[k])
}
