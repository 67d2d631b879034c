//! The arithmetic and the verdict of one test of a box or shape.

use super::arithmetic::{Formula, Values, Way, slab_names, value_of};
use super::book::{Book, Setting};
use super::{Arithmetic, Finding};
use crate::kernels::{
    Aabb, Plane, Ray, Sphere, Start, Triangle, TriangleFilter, box_stage, plane_stage, sphere_stage, triangle_stage,
};
use crate::numbers::{Precision, Stage};
use crate::scene::{Numerics, Shape};
use crate::tree::{BoundsRecord, RayNode, ShapeRecord, TestRecord, Value, Verdict, six_digits};

/// What there is to say of a test.
pub(super) struct Tested {
    pub(super) arithmetic: Option<Arithmetic>,
    pub(super) finding: Finding,
    /// Whether the filter left the verdict open.
    pub(super) is_exact: bool,
    /// The diagram that shows it, where there is one of the test alone.
    pub(super) diagram: Option<&'static str>,
}

/// A shape as the tracer rounded it.
enum Rounded {
    Sphere { center: [f64; 3], radius: f64 },
    Plane { normal: [f64; 3], distance: f64 },
    Box { min: [f64; 3], max: [f64; 3] },
    Triangle { vertices: [[f64; 3]; 3] },
}

impl Rounded {
    fn new(shape: &Shape, primitive: Option<u32>, precision: Precision) -> Option<Self> {
        let number = |x: f64| precision.round(x);
        let vector = |v: glam::DVec3| v.to_array().map(number);
        Some(match shape {
            Shape::Sphere { center, radius } => Self::Sphere { center: vector(*center), radius: number(*radius) },
            Shape::Plane { normal, distance } => Self::Plane { normal: vector(*normal), distance: number(*distance) },
            Shape::Box { min, max } => Self::Box { min: vector(*min), max: vector(*max) },
            Shape::Triangle { vertices } => Self::Triangle { vertices: vertices.map(vector) },
            Shape::Mesh(mesh) => Self::Triangle { vertices: mesh.triangles.get(primitive? as usize)?.map(vector) },
        })
    }
}

/// Looks at a test of `node`, which left a surface of `parent`.
pub(super) fn look(book: &mut Book<'_>, node: &RayNode, parent: Option<&RayNode>, test: &TestRecord) -> Tested {
    match test {
        TestRecord::Bounds(test) => of_bounds(book, node, test),
        TestRecord::Shape(test) => of_shape(book, node, parent, test),
    }
}

fn of_bounds(book: &mut Book<'_>, node: &RayNode, test: &BoundsRecord) -> Tested {
    let ways = Way::of(node.direction);
    let beside =
        (0..3).find(|&k| ways[k] == Way::Not && !(test.min[k] <= node.origin[k] && node.origin[k] <= test.max[k]));
    let mut arithmetic = None;
    if beside.is_none() {
        let inputs = vec![("min", Value::Vector(test.min)), ("max", Value::Vector(test.max))];
        let wanted = [("t_in", test.t_in), ("t_out", test.t_out)];
        let wanted = wanted.iter().filter_map(|(name, t)| Some((*name, Value::Number((*t)?))));
        arithmetic = book.work(Formula::Bounds(ways), inputs, None, wanted);
    }
    let of = match (&test.object, test.primitive) {
        (Some(_), Some(primitive)) => format!("triangle {primitive}"),
        (Some(object), None) => object.clone(),
        (None, _) => "all that is inside".to_owned(),
    };
    let words = match (test.verdict, test.reason.as_deref(), beside) {
        (Verdict::Entered | Verdict::Best, ..) => {
            "t_in <= t_out, before the best hit so far: the ray looks inside".to_owned()
        }
        (Verdict::Rejected, Some("farther than the best"), _) => {
            format!("the box begins beyond the best hit so far: {of} is left out")
        }
        (Verdict::Rejected, _, Some(axis)) => {
            format!("the ray runs beside the box along {}: {of} is left out", ["x", "y", "z"][axis])
        }
        (Verdict::Rejected, ..) => format!("t_in > t_out, the ray passes the box: {of} is left out"),
    };
    let is_ok = test.verdict != Verdict::Rejected;
    // The box diagram shows slabs of boxes that are shapes; a bounding box has the section.
    Tested { arithmetic, finding: Finding::new(is_ok, words), is_exact: false, diagram: None }
}

fn of_shape(book: &mut Book<'_>, node: &RayNode, parent: Option<&RayNode>, test: &ShapeRecord) -> Tested {
    let setting = book.setting;
    let object = book.scene.objects.get(test.shape as usize);
    let shape = object.and_then(|object| Rounded::new(&object.shape, test.primitive, setting.rays));
    let is_ok = test.verdict != Verdict::Rejected;
    let mut finding = Finding::new(is_ok, words(test));
    let Some(shape) = shape.filter(|_| !test.values.0.is_empty()) else {
        return Tested { arithmetic: None, finding, is_exact: false, diagram: None };
    };
    let mut arithmetic = work(book, node, &shape, test);
    let stage = stage(setting, node, parent, &shape, test);
    let is_exact = stage.is_some_and(|stage| stage != Stage::Filter);
    if let Some(arithmetic) = &mut arithmetic {
        arithmetic.note = note(stage, test, &arithmetic.values);
    }
    if let Some(stage) = stage.filter(|_| is_exact) {
        finding.words.push_str("; decided exactly, ");
        finding.words.push_str(exact_words(stage));
    }
    let diagram = Some(match shape {
        Rounded::Sphere { .. } => "sphere",
        Rounded::Plane { .. } => "plane",
        Rounded::Box { .. } => "box",
        Rounded::Triangle { .. } => "triangle",
    });
    Tested { arithmetic, finding, is_exact, diagram }
}

/// How a stage behind the filter decides.
pub(super) fn exact_words(stage: Stage) -> &'static str {
    match stage {
        Stage::Filter => "by a filter",
        Stage::Integer => "with whole numbers",
        Stage::DoubleDouble => "with pairs of numbers",
        Stage::Expansion => "with exact sums",
    }
}

/// What the formula does not say.
fn note(stage: Option<Stage>, test: &ShapeRecord, values: &Values) -> Option<String> {
    let mut notes = Vec::new();
    if let Some(stage) = stage.filter(|stage| *stage != Stage::Filter) {
        notes.push(format!(
            "Rounding could turn this verdict: it was decided exactly, {}, and holds whatever the numbers here say.",
            exact_words(stage)
        ));
    }
    let is_shown = |t: f64| {
        let named = ["t", "t_in", "t_out"].into_iter().filter_map(|name| value_of(values, name));
        named.into_iter().any(|value| value == Value::Number(t))
    };
    if let Some(t) = test.t.filter(|t| !is_shown(*t)) {
        notes.push(format!("The kernel's own t is {t:?}: worked out by another way, it differs in the last digits."));
    }
    (!notes.is_empty()).then(|| notes.join(" "))
}

/// The formula of the kernel with the numbers of this test.
fn work(book: &mut Book<'_>, node: &RayNode, shape: &Rounded, test: &ShapeRecord) -> Option<Arithmetic> {
    use Value::{Number, Vector};
    let is_lecture = book.setting.numerics == Numerics::Lecture;
    let recorded = |name: &str| test.values.0.iter().find(|(key, _)| key == name).map(|(_, value)| *value);
    let is_zero = |name: &str| recorded(name).is_some_and(|value| value == Number(0.0));
    let ways = Way::of(node.direction);
    let (formula, inputs, last) = match shape {
        Rounded::Plane { normal, distance } => {
            let inputs = vec![("n", Vector(*normal)), ("D", Number(*distance))];
            (Formula::Plane, inputs, is_zero("n_dot_d").then_some("n_dot_d"))
        }
        Rounded::Triangle { vertices: [v0, v1, v2] } => {
            let inputs = vec![("v0", Vector(*v0)), ("v1", Vector(*v1)), ("v2", Vector(*v2))];
            match is_lecture {
                true => (Formula::TriangleByPlane, inputs, is_zero("n_dot_d").then_some("n_dot_d")),
                false => (Formula::TriangleByDeterminants, inputs, is_zero("det").then_some("det")),
            }
        }
        Rounded::Sphere { center, radius } => {
            let inputs = vec![("center", Vector(*center)), ("radius", Number(*radius))];
            // No roots are worked out where there are none; and at the very centre both are 0.
            let last = match recorded("t_in") {
                None => Some("disc"),
                Some(Number(0.0)) if is_zero("t_out") => Some("q"),
                Some(_) => None,
            };
            (if is_lecture { Formula::SphereNaive } else { Formula::SphereStable }, inputs, last)
        }
        Rounded::Box { min, max } => {
            let inputs = vec![("min", Vector(*min)), ("max", Vector(*max))];
            (if is_lecture { Formula::BoxLecture } else { Formula::Box(ways) }, inputs, None)
        }
    };
    let wanted = test.values.0.iter().filter_map(|(name, value)| {
        let name = match shape {
            Rounded::Box { .. } => box_line(name, is_lecture, ways)?,
            _ => name,
        };
        Some((name, *value))
    });
    book.work(formula, inputs, last, wanted)
}

/// The line of a box's formula that a value of its test belongs to.
fn box_line(name: &str, is_lecture: bool, ways: [Way; 3]) -> Option<&str> {
    let faces = ["t_-x", "t_+x", "t_-y", "t_+y", "t_-z", "t_+z"];
    let Some(face) = faces.iter().position(|face| *face == name) else { return Some(name) };
    let (axis, is_max) = (face / 2, face % 2 == 1);
    let names = slab_names(axis);
    Some(match (is_lecture, ways[axis]) {
        (true, _) => names.ends[usize::from(is_max)],
        (false, Way::Not) => return None,
        (false, way) if (way == Way::Up) == is_max => names.far,
        (false, _) => names.near,
    })
}

/// The stage that decides a test under certified numerics.
fn stage(
    setting: Setting,
    node: &RayNode,
    parent: Option<&RayNode>,
    shape: &Rounded,
    test: &ShapeRecord,
) -> Option<Stage> {
    if setting.numerics != Numerics::Certified {
        return None;
    }
    let hit = node.hit.as_ref().filter(|hit| hit.shape == test.shape && test.verdict == Verdict::Best);
    if let (Some(hit), Some(certificate)) = (hit, &node.certificate)
        && (test.primitive.is_none() || test.primitive == hit.primitive)
    {
        return Some(certificate.stage);
    }
    let ray = Ray::<f64> { origin: node.origin.into(), direction: node.direction.into() };
    if ray.check().is_err() {
        return None;
    }
    // A solid that the ray left and is tested all the same was left inward.
    let is_left =
        setting.by_identity && parent.and_then(|parent| parent.hit.as_ref()).is_some_and(|hit| hit.shape == test.shape);
    let start = if is_left { Start::OnSurfaceInward } else { Start::Anywhere };
    Some(match shape {
        Rounded::Sphere { center, radius } => {
            sphere_stage(&ray, &Sphere { center: (*center).into(), radius: *radius }, start)
        }
        Rounded::Plane { normal, distance } => {
            plane_stage(&ray, &Plane { normal: (*normal).into(), distance: *distance })
        }
        Rounded::Box { min, max } => box_stage(&ray, &Aabb { min: (*min).into(), max: (*max).into() }, start),
        Rounded::Triangle { vertices } => {
            let triangle = Triangle::<f64> { vertices: vertices.map(Into::into) };
            triangle_stage(&ray, &triangle, &TriangleFilter::of_triangle(&ray, &triangle))
        }
    })
}

/// What came of the test of a shape.
fn words(test: &ShapeRecord) -> String {
    let t = || test.t.map_or(String::new(), |t| format!("t = {}: ", six_digits(t)));
    match (test.verdict, test.reason.as_deref()) {
        (Verdict::Best | Verdict::Entered, _) => format!("{}the nearest hit so far", t()),
        (Verdict::Rejected, None) => "no hit".to_owned(),
        (Verdict::Rejected, Some(reason)) => match reason {
            "parallel" => "no hit: the ray is parallel".to_owned(),
            "behind" => "no hit: t < 0, behind the start of the ray".to_owned(),
            "a < 0" => "a < 0: no hit, outside the edge opposite v0".to_owned(),
            "b < 0" => "b < 0: no hit, outside the edge opposite v1".to_owned(),
            "a + b > 1" => "a + b > 1, so c < 0: no hit, outside the edge opposite v2".to_owned(),
            "t_in > t_out" => "t_in > t_out: no hit, the ray leaves a slab before it enters another".to_owned(),
            "discriminant negative" => "discriminant negative: no hit, the line passes the sphere".to_owned(),
            "farther than the best" => format!("{}not nearer than the best hit so far", t()),
            "not before the light" => format!("{}not before the light", t()),
            "the ray starts on it" => "not tested: the ray starts on it".to_owned(),
            other => format!("{}{other}", t()),
        },
    }
}

/// Whether two values are the same to the bit.
pub(super) fn is_same(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => a.to_bits() == b.to_bits(),
        (Value::Vector(a), Value::Vector(b)) => a.map(f64::to_bits) == b.map(f64::to_bits),
        _ => false,
    }
}
