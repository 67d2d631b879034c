//! Lesson 12, fast: the cases, the known mistakes, the hints.

use std::cell::RefCell;
use std::process::ExitCode;
use std::rc::Rc;
use std::sync::OnceLock;

use glam::{DVec2, DVec3, dvec2, dvec3};
use raytree::lessons::{
    Aabb, Answer, Build, Builder, Case, Fault, Hierarchy, Inside, Item, Lesson, MeshView, Nearest, Node, Random, Ray,
    Rendered, Task, Triangle, Value, Walk, hit, pictures, random_cases, shown,
};
use raytree::scene;

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) bounds: fn(&[Item]) -> Aabb,
    pub(crate) surface_area: fn(&Aabb) -> f64,
    pub(crate) cost: fn(&[Item], &[Item]) -> f64,
    pub(crate) split: fn(&[Item]) -> [Vec<Item>; 2],
    pub(crate) build: Build,
    pub(crate) nearest: Nearest,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    Lesson {
        number: 12,
        title: "fast",
        stages: vec![
            bounds().stage(move |items| corners((student.bounds)(items))),
            surface_area().stage(move |aabb| Answer::of("area", (student.surface_area)(aabb))),
            cost().stage(move |[left, right]| Answer::of("cost", (student.cost)(left, right))),
            split().stage(move |items| halves((student.split)(items))),
            build().stage(move |plan| plan.judge(student.build)),
            nearest().stage(move |way| way.sent(student.nearest)),
            picture().stage(move |scenery| scenery.judge(student.build, student.nearest)),
        ],
        notice: "Now see what the ray through the pixel \"facet\" hits: \
                 raytree diagram scenes/mesh.json facet --kind triangle -o facet.png",
    }
}

/// A leaf has at most so many triangles.
const LEAF: usize = 2;

fn numbered(triangles: impl IntoIterator<Item = Triangle>) -> Vec<Item> {
    triangles.into_iter().enumerate().map(|(number, triangle)| Item { number, triangle }).collect()
}

fn point(v: DVec3) -> String {
    format!("({})", v.to_array().map(shown).join(", "))
}

/// The triangles where they are few, else how many there are.
fn told(items: &[Item]) -> Vec<String> {
    if items.len() > 2 {
        return vec![format!("{} triangles", items.len())];
    }
    let corners = items.iter().flat_map(|item| item.triangle.vertices.map(point));
    corners.collect()
}

fn small(random: &mut Random) -> f64 {
    random.below(17) as f64 / 2.0 - 4.0
}

fn random_items(random: &mut Random, count: usize) -> Vec<Item> {
    let middle = random.vector(small);
    let corner = |random: &mut Random| middle + random.vector(small) / 2.0;
    numbered((0..count).map(|_| Triangle { vertices: [corner(random), corner(random), corner(random)] }))
}

/// The smallest box around all triangles.
fn true_bounds(items: &[Item]) -> Aabb {
    Aabb::of_points(&items.iter().flat_map(|item| item.triangle.vertices).collect::<Vec<_>>())
}

fn corners(aabb: Aabb) -> Answer {
    Answer::of("min", aabb.min).and("max", aabb.max)
}

fn bounds() -> Task<Vec<Item>> {
    const FAULTS: &[Fault<Vec<Item>>] = &[
        Fault {
            id: "bounds-from-origin",
            name: "the box begins as the point (0, 0, 0), so that the origin is always in it",
            why: "Begin with a corner of a triangle, or with the empty box: min at +infinity, max at -infinity.",
            answer: |items| {
                let Aabb { min, max } = true_bounds(items);
                corners(Aabb { min: min.min(DVec3::ZERO), max: max.max(DVec3::ZERO) })
            },
        },
        Fault {
            id: "bounds-max-from-zero",
            name: "max begins at 0, so that it is never negative",
            why: "The smallest f64 is f64::MIN; f64::MIN_POSITIVE is a tiny positive number. Or begin with a corner.",
            answer: |items| {
                let Aabb { min, max } = true_bounds(items);
                corners(Aabb { min, max: max.max(DVec3::ZERO) })
            },
        },
        Fault {
            id: "bounds-of-centers",
            name: "the box is that of the centers, not of the triangles",
            why: "The corners stick out of it: a ray that hits a triangle near a corner may miss the box.",
            answer: |items| {
                let centers: Vec<DVec3> = items.iter().map(Item::center).collect();
                corners(Aabb::of_points(&centers))
            },
        },
        Fault {
            id: "bounds-of-first-corners",
            name: "only the first corner of each triangle is looked at",
            why: "Every triangle has three: go through all of item.triangle.vertices.",
            answer: |items| {
                let first: Vec<DVec3> = items.iter().map(|item| item.triangle.vertices[0]).collect();
                corners(Aabb::of_points(&first))
            },
        },
        Fault {
            id: "bounds-of-one",
            name: "only the first triangle is looked at",
            why: "The box is around all of them.",
            answer: |items| corners(true_bounds(&items[..1])),
        },
        Fault {
            id: "bounds-exchanged",
            name: "min and max are exchanged",
            why: "min has the smallest coordinates, and grows smaller: min = min.min(v).",
            answer: |items| {
                let Aabb { min, max } = true_bounds(items);
                corners(Aabb { min: max, max: min })
            },
        },
    ];
    let triangle = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| Triangle { vertices: [a.into(), b.into(), c.into()] };
    let one = triangle([1.0, 1.0, 1.0], [3.0, 1.0, 2.0], [2.0, 3.0, 1.5]);
    let other = triangle([4.0, 0.5, 3.0], [5.0, 2.0, 1.0], [4.5, 1.0, 4.0]);
    let mirrored = |t: Triangle| Triangle { vertices: t.vertices.map(|v| -v) };
    let mut cases = vec![
        Case::new("one triangle", numbered([one])),
        Case::new("two triangles", numbered([one, other])),
        Case::new("two triangles, all coordinates negative", numbered([mirrored(one), mirrored(other)])),
        Case::new("a flat box", numbered([triangle([1.0, 2.0, 0.0], [3.0, 2.0, 1.0], [2.0, 2.0, 2.0])])),
    ];
    cases.extend(random_cases(1201, 40, |random| {
        let count = 1 + random.below(4);
        Some(random_items(random, count))
    }));
    Task {
        name: "the box around triangles",
        function: "bounds",
        points: 2,
        after: &[],
        cases,
        given: |items| told(items),
        truth: |items| corners(true_bounds(items)),
        faults: FAULTS,
        picture: |items, what, _| pictures::box_around(items, what),
        hints: &[
            "Begin with a box that holds one corner only: let first = items[0].triangle.vertices[0]; min and max are both first.",
            "Go through all items and all three vertices of each. min.min(v) has the smaller of both in each coordinate, \
             max.max(v) the larger.",
        ],
    }
}

fn true_area(aabb: &Aabb) -> f64 {
    let d = aabb.max - aabb.min;
    2.0 * (d.x * d.y + d.y * d.z + d.z * d.x)
}

fn surface_area() -> Task<Aabb> {
    fn area(x: f64) -> Answer {
        Answer::of("area", x)
    }
    const FAULTS: &[Fault<Aabb>] = &[
        Fault {
            id: "area-of-three-faces",
            name: "only three of the six faces are counted",
            why: "Each face has one across from it that is as large: twice the sum.",
            answer: |aabb| area(true_area(aabb) / 2.0),
        },
        Fault {
            id: "area-is-volume",
            name: "that is the volume",
            why: "How often rays meet a box goes by its surface: a flat box has no volume and is hit all the same.",
            answer: |aabb| area((aabb.max - aabb.min).element_product()),
        },
        Fault {
            id: "area-without-a-pair",
            name: "one pair of faces is missing",
            why: "Three different faces: x times y, y times z, and z times x.",
            answer: |aabb| {
                let d = aabb.max - aabb.min;
                area(2.0 * (d.x * d.y + d.y * d.z))
            },
        },
        Fault {
            id: "area-of-corner",
            name: "the sides are taken from max alone",
            why: "A side is max - min; they are the same only where the box begins at the origin.",
            answer: |aabb| area(true_area(&Aabb { min: DVec3::ZERO, max: aabb.max })),
        },
        Fault {
            id: "area-of-edges",
            name: "the edges are added up, not the faces",
            why: "A face is a product of two sides.",
            answer: |aabb| area(4.0 * (aabb.max - aabb.min).element_sum()),
        },
    ];
    let of = |min: DVec3, max: DVec3| Aabb { min, max };
    let mut cases = vec![
        Case::new("2 by 3 by 4", of(dvec3(1.0, 1.0, 1.0), dvec3(3.0, 4.0, 5.0))),
        Case::new("a cube", of(dvec3(-1.0, -1.0, -1.0), dvec3(1.0, 1.0, 1.0))),
        Case::new("a flat box", of(dvec3(0.0, 2.0, 0.0), dvec3(4.0, 2.0, 2.0))),
    ];
    cases.extend(random_cases(1202, 40, |random| {
        let min = random.vector(small);
        Some(of(min, min + random.vector(|random| random.below(9) as f64 / 2.0)))
    }));
    Task {
        name: "the area of a box",
        function: "surface_area",
        points: 1,
        after: &[],
        cases,
        given: |aabb| vec![format!("min = {}", point(aabb.min)), format!("max = {}", point(aabb.max))],
        truth: |aabb| area(true_area(aabb)),
        faults: FAULTS,
        picture: |aabb, what, _| pictures::box_area(aabb, what),
        hints: &[
            "let size = aabb.max - aabb.min; are the three sides. Which two of them make the face in front?",
            "x times y, y times z, z times x: three faces. And the three across from them.",
        ],
    }
}

/// A wall that stands on the line from `a` to `b`: as good as all of it is crossed by rays at the height 0. No two of 17 are
/// equally high, and they are not in order of height.
fn wall(number: usize, a: DVec2, b: DVec2) -> Item {
    let top = (0.5 * (a + b)).extend(31.0 + 0.125 * (5 * number % 17) as f64);
    Item { number, triangle: Triangle { vertices: [a.extend(-1.0), b.extend(-1.0), top] } }
}

fn walls(lines: &[[f64; 4]]) -> Vec<Item> {
    lines.iter().enumerate().map(|(i, [x, y, u, v])| wall(i, dvec2(*x, *y), dvec2(*u, *v))).collect()
}

/// Walls here and there, each about 1 long.
fn random_walls(random: &mut Random, count: usize) -> Vec<Item> {
    let items = (0..count).map(|number| {
        let a = dvec2(10.0 * random.unit(), 6.0 * random.unit());
        let way = random.direction().truncate() + dvec2(0.1, 0.1);
        wall(number, a, a + way)
    });
    items.collect()
}

/// A row of walls one behind the other along x.
fn row(count: usize) -> Vec<Item> {
    (0..count).map(|i| wall(i, dvec2(i as f64, -0.5), dvec2(i as f64 + 0.25, 0.5))).collect()
}

fn true_cost(left: &[Item], right: &[Item]) -> f64 {
    true_area(&true_bounds(left)) * left.len() as f64 + true_area(&true_bounds(right)) * right.len() as f64
}

fn cost() -> Task<[Vec<Item>; 2]> {
    fn cost(x: f64) -> Answer {
        Answer::of("cost", x)
    }
    fn areas([left, right]: &[Vec<Item>; 2]) -> [f64; 2] {
        [true_area(&true_bounds(left)), true_area(&true_bounds(right))]
    }
    const FAULTS: &[Fault<[Vec<Item>; 2]>] = &[
        Fault {
            id: "cost-without-counts",
            name: "the numbers of triangles are missing",
            why: "A ray that enters a box has to look at every triangle in it: area times number.",
            answer: |groups| cost(areas(groups).iter().sum()),
        },
        Fault {
            id: "cost-without-areas",
            name: "the areas are missing",
            why: "The number of triangles is the same for every cut. What differs is how often a ray enters: the area.",
            answer: |[left, right]| cost((left.len() + right.len()) as f64),
        },
        Fault {
            id: "cost-crossed",
            name: "each area is multiplied by the number of the other group",
            why: "The left area goes with the left number.",
            answer: |groups| {
                let [a, b] = areas(groups);
                cost(a * groups[1].len() as f64 + b * groups[0].len() as f64)
            },
        },
        Fault {
            id: "cost-of-one-box",
            name: "it is the box around both groups that is measured",
            why: "That is the same for every cut. Each group has a box of its own.",
            answer: |[left, right]| {
                let all = [left.as_slice(), right].concat();
                cost(true_area(&true_bounds(&all)) * all.len() as f64)
            },
        },
        Fault {
            id: "cost-of-the-dearer",
            name: "only the dearer group counts",
            why: "A ray may have to go through both: the sum.",
            answer: |groups| {
                let [a, b] = areas(groups);
                cost((a * groups[0].len() as f64).max(b * groups[1].len() as f64))
            },
        },
    ];
    let unit = |x: f64| Triangle { vertices: [dvec3(x, 0.0, 0.0), dvec3(x + 1.0, 1.0, 1.0), dvec3(x, 1.0, 0.0)] };
    let mut cases = vec![
        Case::new("one and two", [numbered([unit(0.0)]), numbered([unit(4.0), unit(5.0)])]),
        Case::new("three and one", [row(3), row(8)[7..].to_vec()]),
        Case::new("four and four", [row(4), row(8)[4..].to_vec()]),
    ];
    cases.extend(random_cases(1203, 40, |random| {
        let (all, left) = (3 + random.below(6), 1 + random.below(2));
        let items = random_walls(random, all);
        let (left, right) = items.split_at(left);
        Some([left.to_vec(), right.to_vec()])
    }));
    Task {
        name: "what two groups cost",
        function: "cost",
        points: 1,
        after: &["bounds", "surface_area"],
        cases,
        given: |[left, right]| {
            vec![format!("triangles on the left: {}", left.len()), format!("triangles on the right: {}", right.len())]
        },
        truth: |[left, right]| cost(true_cost(left, right)),
        faults: FAULTS,
        picture: |[left, right], what, _| pictures::two_groups(left, right, what),
        hints: &[
            "surface_area(&bounds(left)) is how large the left box is, left.len() as f64 how many triangles are in it.",
            "The product of the two for the left group, and the same for the right group: their sum.",
        ],
    }
}

fn halves([left, right]: [Vec<Item>; 2]) -> Answer {
    let set = |items: &[Item]| Value::set(items.iter().map(|item| item.number));
    Answer::of("left", set(&left)).and("right", set(&right))
}

/// The cheapest cut at some places along some axes, sorted by a key.
fn cut(
    items: &[Item],
    axes: &[usize],
    key: fn(&Item) -> DVec3,
    cost: fn(&[Item], &[Item]) -> f64,
    last: usize,
) -> [Vec<Item>; 2] {
    let mut best = (f64::INFINITY, [items.to_vec(), Vec::new()]);
    for &axis in axes {
        let mut sorted = items.to_vec();
        sorted.sort_by(|a, b| key(a)[axis].total_cmp(&key(b)[axis]));
        for place in 1..last {
            let (left, right) = sorted.split_at(place);
            let cost = cost(left, right);
            if cost < best.0 {
                best = (cost, [left.to_vec(), right.to_vec()]);
            }
        }
    }
    best.1
}

fn true_split(items: &[Item]) -> [Vec<Item>; 2] {
    cut(items, &[0, 1, 2], Item::center, true_cost, items.len())
}

/// Whether the cheapest cut is the same in whatever order the triangles come.
fn is_one_cut(items: &[Item]) -> bool {
    let reversed: Vec<Item> = items.iter().rev().copied().collect();
    items.len() < 2 || halves(true_split(items)) == halves(true_split(&reversed))
}

/// Half and half, along the longest side of the box.
fn in_the_middle(items: &[Item]) -> [Vec<Item>; 2] {
    let Aabb { min, max } = true_bounds(items);
    let axis = (max - min).max_position();
    let mut sorted = items.to_vec();
    sorted.sort_by(|a, b| a.center()[axis].total_cmp(&b.center()[axis]));
    let (left, right) = sorted.split_at(items.len() / 2);
    [left.to_vec(), right.to_vec()]
}

fn split() -> Task<Vec<Item>> {
    const FAULTS: &[Fault<Vec<Item>>] = &[
        Fault {
            id: "split-nothing",
            name: "both groups get all triangles",
            why: "The recursion below would never end. Each triangle belongs to one of the groups.",
            answer: |items| halves([items.clone(), items.clone()]),
        },
        Fault {
            id: "split-unsorted",
            name: "the triangles are not sorted before they are cut",
            why: "The order in a file says nothing about where they are. Sort by center()[axis].",
            answer: |items| halves(cut(items, &[0], |_| DVec3::ZERO, true_cost, items.len())),
        },
        Fault {
            id: "split-one-axis",
            name: "only cuts along x are tried",
            why: "Walls one above the other are best cut along y. Try all three axes.",
            answer: |items| halves(cut(items, &[0], Item::center, true_cost, items.len())),
        },
        Fault {
            id: "split-last-axis",
            name: "the best cut is forgotten when the next axis begins: only z is left",
            why: "Make `cheapest` once, before the loop over the axes.",
            answer: |items| halves(cut(items, &[2], Item::center, true_cost, items.len())),
        },
        Fault {
            id: "split-in-the-middle",
            name: "it is cut in the middle, whatever that costs",
            why: "A lone triangle far away then makes a large box around half of the others. Try all places.",
            answer: |items| halves(in_the_middle(items)),
        },
        Fault {
            id: "split-dearest",
            name: "the dearest cut is taken, not the cheapest",
            why: "A cut is better if its cost is smaller: if cost < cheapest.",
            answer: |items| halves(cut(items, &[0, 1, 2], Item::center, |a, b| -true_cost(a, b), items.len())),
        },
        Fault {
            id: "split-by-corner",
            name: "it is sorted by the first corner, not by the center",
            why: "Which corner comes first is chance. The center says where a triangle is.",
            answer: |items| halves(cut(items, &[0, 1, 2], |i| i.triangle.vertices[0], true_cost, items.len())),
        },
        Fault {
            id: "split-by-area-alone",
            name: "only the areas are compared, not how many triangles are in the boxes",
            why: "Then a single triangle is split off again and again. The cost is area times number.",
            answer: |items| {
                let areas = |a: &[Item], b: &[Item]| true_area(&true_bounds(a)) + true_area(&true_bounds(b));
                halves(cut(items, &[0, 1, 2], Item::center, areas, items.len()))
            },
        },
        Fault {
            id: "split-not-at-the-end",
            name: "the last place is not tried: one triangle alone on the right",
            why: "There are len - 1 places, after the first triangle up to before the last: 1..sorted.len().",
            answer: |items| halves(cut(items, &[0, 1, 2], Item::center, true_cost, items.len() - 1)),
        },
    ];
    let stairs = [[2.0, 0.0, 3.0, 0.5], [0.0, 0.0, 1.0, 0.5], [2.0, 4.0, 3.0, 4.5], [0.0, 4.0, 1.0, 4.5]];
    let mut cases = vec![
        Case::new("two walls", walls(&[[3.0, 0.0, 3.5, 1.0], [0.0, 0.0, 0.5, 1.0]])),
        Case::new("a row and one far away", {
            let mut items = row(5);
            items.push(wall(5, dvec2(14.0, -0.5), dvec2(14.25, 0.5)));
            items
        }),
        Case::new("two rows, one behind the other", walls(&stairs)),
    ];
    // In the first of them it matters by what is sorted.
    let mut told_apart = 5_usize;
    cases.extend(random_cases(1204, 40, |random| {
        let count = 4 + random.below(7);
        let items = random_walls(random, count);
        let by_corner = cut(&items, &[0, 1, 2], |item| item.triangle.vertices[0], true_cost, items.len());
        if !is_one_cut(&items) || (told_apart > 0 && halves(by_corner) == halves(true_split(&items))) {
            return None;
        }
        told_apart = told_apart.saturating_sub(1);
        Some(items)
    }));
    Task {
        name: "the cheapest cut",
        function: "split",
        points: 3,
        after: &["bounds", "surface_area", "cost"],
        cases,
        given: |items| vec![format!("{} triangles, numbered as in the picture", items.len())],
        truth: |items| halves(true_split(items)),
        faults: FAULTS,
        picture: |items, what, _| pictures::two_halves(items, what),
        hints: &[
            "For each axis 0, 1, 2: let mut sorted = items.to_vec(); then \
             sorted.sort_by(|a, b| a.center()[axis].total_cmp(&b.center()[axis])).",
            "Each cut from 1 to sorted.len() - 1 makes two groups: let (left, right) = sorted.split_at(cut).",
            "Keep the smallest cost so far, f64::INFINITY at first, and the two groups that gave it: left.to_vec().",
        ],
    }
}

/// Triangles to build a hierarchy of, and what was built last, for the picture.
#[derive(Clone, Debug)]
struct Plan {
    items: Vec<Item>,
    built: Rc<RefCell<Option<Hierarchy>>>,
}

/// Whether `outer` holds `inner`, but for rounding.
fn holds(outer: &Aabb, inner: &Aabb) -> bool {
    let slack = DVec3::splat(1e-9);
    (outer.min - slack).cmple(inner.min).all() && inner.max.cmple(outer.max + slack).all()
}

impl Plan {
    fn new(items: Vec<Item>) -> Self {
        Plan { items, built: Rc::default() }
    }

    /// What is wrong with the hierarchy that `build` makes.
    fn judge(&self, build: Build) -> Answer {
        let built = Hierarchy::of(build, &self.items);
        let answer = match &built {
            Some(hierarchy) => faults_of(hierarchy.root(), &self.items),
            None => Answer::of("ends", false),
        };
        self.built.replace(built);
        answer
    }
}

fn faults_of(root: &Node, items: &[Item]) -> Answer {
    let times = |item: &Item| root.items().filter(|other| *other == item).count();
    let having = |is: &dyn Fn(&Item) -> bool| Value::set(items.iter().filter(|item| is(item)).map(|item| item.number));
    let nodes = root.walk();
    let sticks_out = |item: &Item| {
        let own = true_bounds(&[*item]);
        nodes.iter().any(|(node, _)| node.items().any(|i| i == item) && !holds(&node.bounds, &own))
    };
    let is_loose = |node: &Node| {
        let inside: Vec<Item> = node.items().copied().collect();
        !inside.is_empty() && holds(&node.bounds, &true_bounds(&inside)) && !holds(&true_bounds(&inside), &node.bounds)
    };
    let leaf = |node: &Node| match &node.inside {
        Inside::Items(items) => items.len(),
        Inside::Children(_) => 0,
    };
    let largest = nodes.iter().map(|(node, _)| leaf(node)).max().unwrap_or_default();
    Answer::of("in no leaf", having(&|item| times(item) == 0))
        .and("in several", having(&|item| times(item) > 1))
        .and("sticking out", having(&sticks_out))
        .and("boxes too large", nodes.iter().filter(|(node, _)| is_loose(node)).count() as f64)
        .and("largest leaf", largest as f64)
}

/// The solution's `build`, and what may be wrong with it.
mod builds {
    use super::*;

    pub(super) fn right(items: &[Item], builder: &Builder) -> Node {
        divided(items, builder, true_split)
    }

    /// A hierarchy of groups that some `split` makes.
    pub(super) fn divided(items: &[Item], builder: &Builder, split: fn(&[Item]) -> [Vec<Item>; 2]) -> Node {
        if items.len() <= LEAF {
            return Node::leaf(true_bounds(items), items);
        }
        let [left, right] = split(items);
        Node::inner(true_bounds(items), builder.build(&left), builder.build(&right))
    }

    pub(super) fn all_twice(items: &[Item], builder: &Builder) -> Node {
        divided(items, builder, |items| [items.to_vec(), items.to_vec()])
    }

    pub(super) fn left_twice(items: &[Item], builder: &Builder) -> Node {
        divided(items, builder, |items| {
            let [left, _] = true_split(items);
            [left.clone(), left]
        })
    }

    pub(super) fn shared(items: &[Item], builder: &Builder) -> Node {
        divided(items, builder, |items| {
            let [left, mut right] = true_split(items);
            // One of both; of three triangles two would be both again.
            if right.len() + 1 < items.len() {
                right.extend(left.last());
            }
            [left, right]
        })
    }

    pub(super) fn forgotten(items: &[Item], builder: &Builder) -> Node {
        if items.len() <= LEAF {
            return Node::leaf(true_bounds(items), &items[..1]);
        }
        right(items, builder)
    }

    pub(super) fn undivided(items: &[Item], _: &Builder) -> Node {
        Node::leaf(true_bounds(items), items)
    }

    pub(super) fn once(items: &[Item], _: &Builder) -> Node {
        if items.len() <= LEAF {
            return Node::leaf(true_bounds(items), items);
        }
        let [left, right] = true_split(items);
        let leaf = |items: &[Item]| Node::leaf(true_bounds(items), items);
        Node::inner(true_bounds(items), leaf(&left), leaf(&right))
    }

    pub(super) fn around_centers(items: &[Item], builder: &Builder) -> Node {
        let centers: Vec<DVec3> = items.iter().map(Item::center).collect();
        let mut node = right(items, builder);
        node.bounds = Aabb::of_points(&centers);
        node
    }

    pub(super) fn around_left(items: &[Item], builder: &Builder) -> Node {
        let mut node = right(items, builder);
        if let Inside::Children(children) = &node.inside {
            node.bounds = children[0].bounds;
        }
        node
    }

    pub(super) fn as_they_come(items: &[Item], builder: &Builder) -> Node {
        divided(items, builder, |items| {
            let (left, right) = items.split_at(items.len() / 2);
            [left.to_vec(), right.to_vec()]
        })
    }

    pub(super) fn one_off(items: &[Item], builder: &Builder) -> Node {
        divided(items, builder, |items| [items[..1].to_vec(), items[1..].to_vec()])
    }
}

fn build() -> Task<Plan> {
    const FAULTS: &[Fault<Plan>] = &[
        Fault {
            id: "build-without-end",
            name: "a child has as many triangles as its parent: the recursion never ends",
            why: "Each child gets one of the two groups of split, and both are smaller than what was cut.",
            answer: |plan| plan.judge(builds::all_twice),
        },
        Fault {
            id: "build-left-twice",
            name: "both children get the same group",
            why: "The triangles of the other group are in no leaf: whatever they show is missing in the picture.",
            answer: |plan| plan.judge(builds::left_twice),
        },
        Fault {
            id: "build-shared",
            name: "the triangle at the cut is in both groups",
            why: "That gives the right picture and tests it twice. split_at(cut) leaves no triangle in both.",
            answer: |plan| plan.judge(builds::shared),
        },
        Fault {
            id: "build-forgotten",
            name: "a leaf keeps only the first of its triangles",
            why: "A leaf holds all of the triangles that it is made of: Node::leaf(bounds, items).",
            answer: |plan| plan.judge(builds::forgotten),
        },
        Fault {
            id: "build-undivided",
            name: "nothing is divided: one leaf holds everything",
            why: "That is brute force with a box around it. Divide while there are more than LEAF triangles.",
            answer: |plan| plan.judge(builds::undivided),
        },
        Fault {
            id: "build-divided-once",
            name: "it is divided once only: the children are leaves",
            why: "Each group is divided again, as long as it has more than LEAF triangles: builder.build(&left).",
            answer: |plan| plan.judge(builds::once),
        },
        Fault {
            id: "build-around-centers",
            name: "the boxes are those of the centers, not of the triangles",
            why: "Corners stick out, and rays that hit them pass the box by. Centers are for sorting only.",
            answer: |plan| plan.judge(builds::around_centers),
        },
        Fault {
            id: "build-around-left",
            name: "the box of an inner node is that of its left child alone",
            why: "It has to hold everything below, or rays are turned away that hit something on the right.",
            answer: |plan| plan.judge(builds::around_left),
        },
    ];
    let plan = |name: &str, items: Vec<Item>| Case::new(name, Plan::new(items));
    let mut cases = vec![
        plan("one triangle", row(1)),
        plan("two triangles", row(2)),
        plan("three in a row", row(3)),
        plan("eight in a row", row(8)),
        plan(
            "two rows",
            walls(&[
                [0.0, 0.0, 1.0, 0.5],
                [0.0, 4.0, 1.0, 4.5],
                [2.0, 0.0, 3.0, 0.5],
                [2.0, 4.0, 3.0, 4.5],
                [4.5, 0.0, 5.0, 0.5],
                [4.5, 4.0, 5.0, 4.5],
            ]),
        ),
    ];
    cases.extend(random_cases(1205, 40, |random| {
        let count = 3 + random.below(14);
        let items = random_walls(random, count);
        let is_clear = Hierarchy::of(builds::right, &items).is_some_and(|hierarchy| {
            hierarchy.root().walk().iter().all(|(node, _)| is_one_cut(&node.items().copied().collect::<Vec<_>>()))
        });
        is_clear.then(|| Plan::new(items))
    }));
    Task {
        name: "the hierarchy",
        function: "build",
        points: 3,
        after: &["bounds", "surface_area", "cost", "split"],
        cases,
        given: |plan| vec![format!("{} triangles, numbered as in the picture", plan.items.len())],
        truth: |_| {
            let none = Value::set([]);
            Answer::of("in no leaf", none)
                .and("in several", none)
                .and("sticking out", none)
                .and("boxes too large", 0.0)
                .and("largest leaf", Value::AtMost(LEAF as f64))
        },
        faults: FAULTS,
        picture: |plan, what, ask| {
            ask(plan);
            let built = plan.built.take().filter(|_| what.got.as_ref().is_some_and(|got| !got.agrees(&what.expected)));
            match Hierarchy::of(builds::right, &plan.items) {
                Some(right) => pictures::nested_boxes(&plan.items, &right, built.as_ref(), what),
                None => pictures::two_halves(&plan.items, what),
            }
        },
        hints: &[
            "Up to LEAF triangles: Node::leaf(bounds(items), items). That is where the recursion ends.",
            "More than that: let [left, right] = split(items); and builder.build(&left) is the node of the left group.",
            "Node::inner(bounds(items), builder.build(&left), builder.build(&right))",
        ],
    }
}

/// A ray between walls, and their hierarchy.
#[derive(Clone, Debug)]
struct Way {
    hierarchy: Rc<Hierarchy>,
    ray: Ray,
}

impl Way {
    fn new(items: &[Item], origin: DVec2, direction: DVec2) -> Option<Self> {
        let hierarchy = Rc::new(Hierarchy::of(builds::right, items)?);
        Some(Way { hierarchy, ray: Ray { origin: origin.extend(0.0), direction: direction.extend(0.0) } })
    }

    /// What comes of sending the ray through with some function.
    fn sent(&self, nearest: Nearest) -> Answer {
        let walked = self.hierarchy.walked(nearest, &self.ray);
        if !walked.ends {
            return Answer::of("ends", false);
        }
        // A box is opened by looking at what is inside.
        let is_opened = |node: &Node| match &node.inside {
            Inside::Items(items) => items.iter().any(|item| walked.tested.contains(&item.number)),
            Inside::Children(children) => {
                let is_seen =
                    |child: &Node| [&walked.asked, &walked.visited].iter().any(|seen| seen.contains(&child.number()));
                children.iter().any(is_seen)
            }
        };
        let nodes = self.hierarchy.root().walk();
        // Of two orders that look into the same boxes only this tells which it was.
        let is_first = |node: &Node| match &node.inside {
            Inside::Items(items) => items.iter().any(|item| walked.tested.first() == Some(&item.number)),
            Inside::Children(_) => false,
        };
        let first = nodes.iter().filter(|(node, _)| is_first(node)).map(|(node, _)| node.number());
        let opened = nodes.iter().filter(|(node, _)| is_opened(node)).map(|(node, _)| node.number());
        Answer::of("t", walked.t)
            .and("tested", Value::set(walked.tested.iter().copied()))
            .and("opened", Value::set(opened))
            .and("first leaf", Value::set(first))
    }

    /// Whether neither equal entries nor an entry at the very hit make a difference.
    fn is_clear(&self) -> bool {
        let right = self.sent(visits::right);
        right == self.sent(visits::right_of_equals_first) && right == self.sent(visits::up_to_the_hit)
    }

    /// The truth by brute force: the nearest of all triangles.
    fn nearest_of_all(&self) -> f64 {
        let hits = self.hierarchy.root().items().filter_map(|item| hit(&self.ray, &item.triangle));
        hits.fold(f64::INFINITY, f64::min)
    }
}

/// The solution's `nearest`, and what may be wrong with it.
mod visits {
    use super::*;

    /// The nearest of `best` and the triangles of a leaf, or nothing for an inner node with its children.
    fn leaf<'n>(node: &'n Node, walk: &Walk<'_>, best: f64) -> Result<f64, &'n [Node; 2]> {
        match &node.inside {
            Inside::Items(items) => Ok(items.iter().filter_map(|item| walk.hit(item)).fold(best, f64::min)),
            Inside::Children(children) => Err(children),
        }
    }

    /// Both children with where the ray enters them, infinite where it does not, the nearer first.
    fn in_order<'n>(children: &'n [Node; 2], walk: &Walk<'_>) -> [(f64, &'n Node); 2] {
        let [left, right] = children.each_ref().map(|child| (walk.enter(child).unwrap_or(f64::INFINITY), child));
        if left.0 <= right.0 { [left, right] } else { [right, left] }
    }

    fn one_by_one(children: [(f64, &Node); 2], walk: &Walk<'_>, best: f64) -> f64 {
        children.iter().fold(best, |best, (t, child)| if *t < best { walk.nearest(child, best) } else { best })
    }

    pub(super) fn right(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| one_by_one(in_order(children, walk), walk, best))
    }

    pub(super) fn right_of_equals_first(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let [left, right] = children.each_ref().map(|child| (walk.enter(child).unwrap_or(f64::INFINITY), child));
            one_by_one(if left.0 < right.0 { [left, right] } else { [right, left] }, walk, best)
        })
    }

    pub(super) fn up_to_the_hit(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let entered = in_order(children, walk).into_iter().filter(|(t, _)| t.is_finite());
            entered.fold(best, |best, (t, child)| if t <= best { walk.nearest(child, best) } else { best })
        })
    }

    pub(super) fn near_only(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let [near, _] = in_order(children, walk);
            if near.0 < best { walk.nearest(near.1, best) } else { best }
        })
    }

    pub(super) fn near_if_hit(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let [near, far] = in_order(children, walk);
            let found = if near.0 < best { walk.nearest(near.1, best) } else { best };
            if found == best && far.0 < best { walk.nearest(far.1, best) } else { found }
        })
    }

    pub(super) fn far_first(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let [near, far] = in_order(children, walk);
            one_by_one([far, near], walk, best)
        })
    }

    pub(super) fn left_first(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let entered = children.each_ref().map(|child| (walk.enter(child).unwrap_or(f64::INFINITY), child));
            one_by_one(entered, walk, best)
        })
    }

    pub(super) fn unpruned(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let entered = in_order(children, walk).into_iter().filter(|(t, _)| t.is_finite());
            entered.fold(best, |best, (_, child)| walk.nearest(child, best))
        })
    }

    pub(super) fn best_not_passed(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            in_order(children, walk).iter().fold(best, |best, (t, child)| {
                if *t < best { best.min(walk.nearest(child, f64::INFINITY)) } else { best }
            })
        })
    }

    pub(super) fn everything(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best)
            .unwrap_or_else(|children| children.iter().fold(best, |best, child| walk.nearest(child, best)))
    }

    pub(super) fn missed_is_zero(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|children| {
            let [left, right] = children.each_ref().map(|child| (walk.enter(child).unwrap_or(0.0), child));
            one_by_one(if left.0 <= right.0 { [left, right] } else { [right, left] }, walk, best)
        })
    }

    pub(super) fn last_hit(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        match &node.inside {
            Inside::Items(items) => items.iter().filter_map(|item| walk.hit(item)).last().unwrap_or(best),
            Inside::Children(children) => one_by_one(in_order(children, walk), walk, best),
        }
    }

    pub(super) fn first_of_leaf(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        match &node.inside {
            Inside::Items(items) => items.iter().find_map(|item| walk.hit(item)).map_or(best, |t| t.min(best)),
            Inside::Children(children) => one_by_one(in_order(children, walk), walk, best),
        }
    }

    pub(super) fn itself(node: &Node, walk: &Walk<'_>, best: f64) -> f64 {
        leaf(node, walk, best).unwrap_or_else(|_| walk.nearest(node, best))
    }
}

fn nearest() -> Task<Way> {
    const FAULTS: &[Fault<Way>] = &[
        Fault {
            id: "nearest-far-skipped",
            name: "the farther child is never looked at",
            why: "The ray may cross the nearer box without hitting anything in it.",
            answer: |way| way.sent(visits::near_only),
        },
        Fault {
            id: "nearest-near-is-enough",
            name: "the farther child is left out as soon as the nearer one has a hit",
            why: "Boxes overlap: a triangle of the farther box may lie in front. Leave it out only if it begins beyond the hit.",
            answer: |way| way.sent(visits::near_if_hit),
        },
        Fault {
            id: "nearest-far-first",
            name: "the farther child comes first",
            why: "The picture is right, but there is no hit yet that could save anything. The smaller entry comes first.",
            answer: |way| way.sent(visits::far_first),
        },
        Fault {
            id: "nearest-left-first",
            name: "the left child always comes first",
            why: "Which child is nearer depends on the ray. Compare where it enters the two boxes.",
            answer: |way| way.sent(visits::left_first),
        },
        Fault {
            id: "nearest-unpruned",
            name: "boxes are opened that begin beyond the best hit",
            why: "Nothing in them can be nearer. Go into a child only if the ray enters it before best.",
            answer: |way| way.sent(visits::unpruned),
        },
        Fault {
            id: "nearest-best-not-passed",
            name: "the best hit is not passed on to the children",
            why: "Below, nothing is known of it then, and boxes are opened that begin beyond it: walk.nearest(child, best).",
            answer: |way| way.sent(visits::best_not_passed),
        },
        Fault {
            id: "nearest-everything",
            name: "both children are always looked at, whether the ray enters their boxes or not",
            why: "Then no test is saved, and the boxes are tested in addition. walk.enter says None for a box that is missed.",
            answer: |way| way.sent(visits::everything),
        },
        Fault {
            id: "nearest-missed-is-zero",
            name: "a box that is missed counts as one that is entered at t = 0",
            why: "unwrap_or(0.0) makes it the nearest of all. A box that is missed is infinitely far: unwrap_or(f64::INFINITY).",
            answer: |way| way.sent(visits::missed_is_zero),
        },
        Fault {
            id: "nearest-last-hit",
            name: "a hit replaces the best one even where it is farther",
            why: "Of all hits the smallest t counts: best = best.min(t).",
            answer: |way| way.sent(visits::last_hit),
        },
        Fault {
            id: "nearest-first-of-leaf",
            name: "a leaf is left at its first hit",
            why: "The triangles of a leaf are in no order. The second may be nearer: test all.",
            answer: |way| way.sent(visits::first_of_leaf),
        },
        Fault {
            id: "nearest-itself",
            name: "the function calls itself on the same node: the recursion never ends",
            why: "It goes down: to the children of the node.",
            answer: |way| way.sent(visits::itself),
        },
    ];
    let x = |x: f64| dvec2(x, 0.0);
    let mut cases = Vec::new();
    let mut add = |name: &str, items: &[Item], origin: DVec2, direction: DVec2| {
        cases.extend(Way::new(items, origin, direction).map(|way| Case::new(name, way)));
    };
    add("eight walls in a row", &row(8), dvec2(-1.5, 0.125), x(1.0));
    add("the row from the other side", &row(8), dvec2(9.0, 0.125), x(-2.0));
    add("past all walls", &row(8), dvec2(-1.5, 2.0), x(1.0));
    add("a lone wall", &row(1), dvec2(-1.5, 0.125), x(1.0));
    add("it lies behind", &row(3), dvec2(4.0, 0.125), x(1.0));
    add("from between the walls", &row(6), dvec2(2.625, 0.125), dvec2(1.0, 0.03125));
    // A long slanted wall: its box is entered first, but a short wall stands before it.
    let slanted = [[0.0, 4.0, 6.0, 0.0], [0.5, 3.75, 6.0, 0.25], [1.5, 0.5, 1.5, 1.75], [1.75, 0.5, 1.75, 1.75]];
    add("two long walls around a short one", &walls(&slanted), dvec2(-1.5, 1.0), x(1.0));
    // In the first of them it matters what is known of the best hit deep below.
    let mut deep = 10_usize;
    cases.extend(random_cases(1206, 50, |random| {
        let count = 6 + random.below(11);
        let items = random_walls(random, count);
        let from = dvec2(13.0 * random.unit() - 1.5, 8.0 * random.unit() - 1.0);
        // Most of them aim at a wall.
        let aim = items[random.below(items.len())].center().truncate();
        let way = Way::new(&items, from, if random.one_in(6) { from - aim } else { (aim - from) / 4.0 })?;
        let is_deep = way.sent(visits::best_not_passed) != way.sent(visits::right);
        if !way.is_clear() || (deep > 0 && !is_deep) {
            return None;
        }
        deep = deep.saturating_sub(1);
        Some(way)
    }));
    Task {
        name: "through the hierarchy",
        function: "nearest",
        points: 4,
        after: &[],
        cases,
        given: |Way { hierarchy, ray }| {
            vec![
                format!("{} triangles in {} boxes", hierarchy.root().items().count(), hierarchy.nodes()),
                format!("o = {}", point(ray.origin)),
                format!("d = {}", point(ray.direction)),
            ]
        },
        truth: |way| {
            let right = way.sent(visits::right);
            let t = Answer::of("t", way.nearest_of_all());
            let and = |answer: Answer, name| answer.and(name, Value::set(right.set(name).unwrap_or_default()));
            ["tested", "opened", "first leaf"].into_iter().fold(t, and)
        },
        faults: FAULTS,
        picture: |way, what, _| pictures::visited_boxes(&way.hierarchy, &way.ray, what),
        hints: &[
            "match &node.inside { Inside::Items(items) => ..., Inside::Children(children) => ... }. For the triangles of a \
             leaf: if let Some(t) = walk.hit(item) { best = best.min(t); }",
            "For the children: let [left, right] = children.as_ref(); and \
             walk.enter(left).unwrap_or(f64::INFINITY) is where the ray enters the left box.",
            "The child with the smaller entry first. Go into a child only if its entry is below best at that moment: \
             best = walk.nearest(child, best).",
        ],
    }
}

/// A committed scene with a mesh, what hierarchies made of it, and the last of those, for the picture.
struct Scenery {
    file: &'static str,
    known: fn() -> &'static Known,
    tried: RefCell<Vec<Tried>>,
    last: RefCell<Option<Rc<Rendered>>>,
}

/// The addresses of `build` and `nearest`, and what came of them.
type Tried = ([usize; 2], Option<Rc<Rendered>>);

/// What is worked out once, however many students are checked.
struct Known {
    view: MeshView,
    /// What comes of the solution.
    right: Rendered,
}

impl Known {
    fn new(file: &str, text: &str, mesh: &'static [u8]) -> Self {
        let loaded = scene::load(file, text, &mut |_| Ok(mesh.to_vec()));
        let view = loaded.ok().and_then(|loaded| MeshView::new(&loaded.scene, 96, 72));
        let view = view.expect("a committed scene has a mesh");
        let right = view.render(builds::right, visits::right).expect("the solution ends");
        Known { view, right }
    }
}

impl Scenery {
    fn new(file: &'static str, known: fn() -> &'static Known) -> Rc<Self> {
        Rc::new(Scenery { file, known, tried: RefCell::default(), last: RefCell::default() })
    }

    /// What comes of sending all rays through; worked out once for each pair of functions.
    fn rendered(&self, build: Build, nearest: Nearest) -> Option<Rc<Rendered>> {
        let key = [build as usize, nearest as usize];
        let tried = self.tried.borrow().iter().find(|(other, _)| *other == key).map(|(_, rendered)| rendered.clone());
        tried.unwrap_or_else(|| {
            let rendered = (self.known)().view.render(build, nearest).map(Rc::new);
            self.tried.borrow_mut().push((key, rendered.clone()));
            rendered
        })
    }

    fn tests_a_ray(&self, rendered: &Rendered) -> f64 {
        rendered.total() as f64 / (self.known)().view.rays() as f64
    }

    fn judge(&self, build: Build, nearest: Nearest) -> Answer {
        let rendered = self.rendered(build, nearest);
        let answer = rendered.as_ref().map_or(Answer::of("ends", false), |rendered| {
            Answer::of("wrong pixels", rendered.wrong() as f64).and("tests a ray", self.tests_a_ray(rendered))
        });
        self.last.replace(rendered);
        answer
    }
}

/// How many times as many tests as the solution's a hierarchy may take.
const SLACK: f64 = 1.5;

fn picture() -> Task<Rc<Scenery>> {
    const FAULTS: &[Fault<Rc<Scenery>>] = &[
        Fault {
            id: "picture-as-they-come",
            name: "the groups are halves of the list as it comes, not sorted",
            why: "Each box then holds triangles from all over the mesh, and most rays enter most boxes. Use split.",
            answer: |scenery| scenery.judge(builds::as_they_come, visits::right),
        },
        Fault {
            id: "picture-one-off",
            name: "one triangle is split off at a time: the hierarchy is a long chain",
            why: "A ray has to go down the chain past every triangle. Cut where it is cheapest: use split.",
            answer: |scenery| scenery.judge(builds::one_off, visits::right),
        },
        Fault {
            id: "picture-unpruned",
            name: "boxes are opened that begin beyond the best hit",
            why: "The whole far side of the mesh is tested in vain. Go into a child only if the ray enters it before best.",
            answer: |scenery| scenery.judge(builds::right, visits::unpruned),
        },
        Fault {
            id: "picture-everything",
            name: "both children are always looked at, whether the ray enters their boxes or not",
            why: "That is brute force with the tests of the boxes on top.",
            answer: |scenery| scenery.judge(builds::right, visits::everything),
        },
    ];
    fn gem() -> &'static Known {
        static KNOWN: OnceLock<Known> = OnceLock::new();
        let (text, mesh) = (include_str!("../../scenes/gem.json"), include_bytes!("../../scenes/meshes/gem.obj"));
        KNOWN.get_or_init(|| Known::new("scenes/gem.json", text, mesh))
    }
    fn waves() -> &'static Known {
        static KNOWN: OnceLock<Known> = OnceLock::new();
        let text = include_str!("../../scenes/mesh.json");
        let mesh = include_bytes!("../../scenes/meshes/bumpy-sphere.ply");
        KNOWN.get_or_init(|| Known::new("scenes/mesh.json", text, mesh))
    }
    Task {
        name: "the picture",
        function: "build and nearest",
        points: 2,
        after: &["bounds", "surface_area", "cost", "split", "build", "nearest"],
        cases: vec![
            Case::new("the ball with waves", Scenery::new("scenes/mesh.json", waves)),
            Case::new("the cut stone", Scenery::new("scenes/gem.json", gem)),
        ],
        given: |scenery| {
            let view = &(scenery.known)().view;
            vec![
                format!("the mesh of {}, its triangles mixed", scenery.file),
                format!("{} triangles, {} rays", view.items.len(), view.rays()),
                format!("brute force: {} tests a ray", view.items.len()),
            ]
        },
        truth: |scenery| {
            let most = (SLACK * scenery.tests_a_ray(&(scenery.known)().right)).ceil();
            Answer::of("wrong pixels", 0.0).and("tests a ray", Value::AtMost(most))
        },
        faults: FAULTS,
        picture: |scenery, what, ask| {
            scenery.last.take();
            ask(scenery);
            let yours = scenery.last.take().filter(|_| what.got.is_some());
            let known = (scenery.known)();
            pictures::counted(&known.view, &known.right, yours.as_deref(), what)
        },
        hints: &[
            "Look at the lower right picture: where are the tests? Everywhere alike means that the boxes do not help.",
            "build has to call split for the two groups; nearest must not go into a box that begins beyond best.",
        ],
    }
}
