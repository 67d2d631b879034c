//! The shape that a diagram of one test is about, and what the tree says of the test.

use super::frame::kind_name;
use super::{Input, Kind, NotApplicable};
use crate::input::printable;
use crate::pictures::drawing::Words;
use crate::scene::Shape;
use crate::tree::{BoundsRecord, HitRecord, RayNode, ShapeRecord, TestRecord, Value, Verdict};

/// A shape that a ray may have been tested against: an object of the scene, and of a mesh one of its triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chosen {
    /// The object's place in the scene's `objects`, from 0.
    pub shape: u32,
    /// The triangle's place in its mesh.
    pub primitive: Option<u32>,
}

/// A shape and its test by one ray.
#[derive(Clone, Debug)]
pub(super) struct Subject<'a> {
    /// The ray.
    pub(super) node: &'a RayNode,
    /// The shape.
    pub(super) shape: &'a Shape,
    /// The triangle, where the shape is a mesh.
    pub(super) primitive: Option<u32>,
    /// The kernel's values; nothing where the shape was pruned by its box.
    pub(super) record: Option<&'a ShapeRecord>,
    /// The test of the shape's own box.
    pub(super) bounds: Option<&'a BoundsRecord>,
    /// There where the shape is what the ray hits.
    pub(super) hit: Option<&'a HitRecord>,
    /// The heading of its diagram.
    pub(super) title: String,
}

/// The subject of a diagram of `kind`: the chosen shape, or what the ray hits.
///
/// # Errors
/// [`NotApplicable`] where there is no such shape, `wants` does not want it, or the ray was not tested against it.
pub(super) fn subject<'a>(
    input: &Input<'a>,
    kind: Kind,
    wants: fn(&Shape) -> bool,
) -> Result<Subject<'a>, NotApplicable> {
    let refuse = |why: String| NotApplicable { kind, why };
    let node = input.node;
    let chosen = match (input.chosen, &node.hit) {
        (Some(chosen), _) => chosen,
        (None, Some(hit)) => Chosen { shape: hit.shape, primitive: hit.primitive },
        (None, None) => return Err(refuse("the ray hits nothing, and no shape is chosen".into())),
    };
    let object = input.scene.objects.get(chosen.shape as usize);
    let object = object.ok_or_else(|| refuse(format!("the scene has no object {}", chosen.shape)))?;
    let name = printable(&object.name).into_owned();
    if !wants(&object.shape) {
        let verb = if input.chosen.is_some() { "what is chosen" } else { "what it hits" };
        return Err(refuse(format!("{verb}, “{name}”, is a {}", object.shape.kind())));
    }
    // Only of a mesh does the test name a triangle; the hit of a box names a face.
    let primitive = chosen.primitive.filter(|_| matches!(object.shape, Shape::Mesh(_)));
    let is_hit = |hit: &&HitRecord| {
        hit.shape == chosen.shape && (!matches!(object.shape, Shape::Mesh(_)) || hit.primitive == primitive)
    };
    let hit = node.hit.as_ref().filter(is_hit);
    let tests = node.tests.as_ref().ok_or_else(|| refuse("the tree was recorded without steps".into()))?;
    let of_shape = |test: &'a TestRecord| match test {
        TestRecord::Shape(r) if r.shape == chosen.shape && r.primitive == primitive => Some(r),
        _ => None,
    };
    let of_box = |test: &'a TestRecord| match test {
        TestRecord::Bounds(r) if r.shape == Some(chosen.shape) && r.primitive == primitive && !r.in_mesh => Some(r),
        _ => None,
    };
    let records = || tests.iter().filter_map(of_shape).filter(|r| !r.values.0.is_empty());
    let record = records().find(|r| r.verdict == Verdict::Best).or_else(|| records().next());
    let bounds = tests.iter().filter_map(of_box).next();
    if record.is_none() {
        let why = match tests.iter().filter_map(of_shape).next() {
            Some(ShapeRecord { reason: Some(reason), .. }) => format!("“{name}” was not tested: {reason}"),
            _ if bounds.is_some() => format!("“{name}” was not tested: the ray passes the box around it"),
            _ => format!("the ray was not tested against “{name}”"),
        };
        // The box around a box is the box.
        if bounds.is_none() || !matches!(object.shape, Shape::Box { .. }) {
            return Err(refuse(why));
        }
    }
    let verb = match (hit, record) {
        (Some(_), _) => "hits",
        (None, Some(ShapeRecord { t: Some(_), .. })) => "is tested against",
        _ => "misses",
    };
    let of_mesh = primitive.map_or(String::new(), |i| format!(", triangle {i}"));
    let title = format!("{} {verb} “{}”{of_mesh}", ray_name(input), short(&name));
    Ok(Subject { node, shape: &object.shape, primitive, record, bounds, hit, title })
}

/// What a ray is called: `Ray 3 (reflected)`, and of which pixel where nothing else says so.
pub(super) fn ray_name(input: &Input<'_>) -> String {
    let name = format!("Ray {} ({})", input.number(), kind_name(input.node.kind));
    if input.tree.pixel.is_some() { input.title(&name) } else { name }
}

/// A name with an ellipsis for its middle where it is long.
pub(super) fn short(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    match letters.len() {
        0..=40 => name.to_owned(),
        n => letters[..20].iter().chain(&['…']).chain(&letters[n - 19..]).collect(),
    }
}

impl Subject<'_> {
    /// A number that the kernel computed.
    pub(super) fn number(&self, name: &str) -> Option<f64> {
        self.record?.values.0.iter().find_map(|(key, value)| match value {
            Value::Number(x) if key == name => Some(*x),
            _ => None,
        })
    }

    /// Where the ray meets the shape, whether or not that counts.
    pub(super) fn t(&self) -> Option<f64> {
        self.hit.map(|hit| hit.t).or(self.record.and_then(|r| r.t)).or_else(|| self.number("t"))
    }

    /// What came of the test, in words, and whether the shape is hit.
    pub(super) fn verdict(&self) -> (bool, Words) {
        let says = |text: &str| Words::from(text);
        if self.hit.is_some() {
            return (true, says("the nearest hit"));
        }
        let reason = self.record.map_or_else(|| self.bounds.and_then(|b| b.reason.as_deref()), |r| r.reason.as_deref());
        match reason {
            None => (false, says("the best until a nearer one was found")),
            Some("behind") => (false, says("no hit: behind the origin of the ray")),
            Some("parallel") => (false, says("no hit: the ray is parallel")),
            Some("a < 0") => (false, says("no hit: ").tex("a < 0")),
            Some("b < 0") => (false, says("no hit: ").tex("b < 0")),
            Some("a + b > 1") => (false, says("no hit: ").tex("a + b > 1")),
            Some("discriminant negative") => (false, says("no hit: ").tex(r"\Delta < 0")),
            Some("t_in > t_out") => (false, says("no hit: ").tex(r"t_{\mathrm{in}} > t_{\mathrm{out}}")),
            Some("pruned by its box") => (false, says("no hit: no common stretch from 0 on")),
            Some(other) => (false, says(&format!("not taken: {other}"))),
        }
    }
}
