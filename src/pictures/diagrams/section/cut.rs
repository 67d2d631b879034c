//! What a plane cuts out of a shape, in the plane's coordinates.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use super::plane::Plane;
use crate::scene::Shape;

/// What is left of a shape in a section.
pub(super) enum Cut {
    /// Of a sphere.
    Circle { center: DVec2, radius: f64 },
    /// Of a box: its corners in order.
    Polygon(Vec<DVec2>),
    /// Of a mesh: chains, which are closed where the mesh is, matter on their left.
    Chains { chains: Vec<Vec<DVec2>>, closed: bool },
    /// Of a plane: all `p` with `p . normal = distance`, matter where it is less.
    Line { normal: DVec2, distance: f64 },
}

impl Cut {
    /// The cut through a shape, or nothing where the plane misses it.
    pub(super) fn of(shape: &Shape, plane: &Plane) -> Option<Self> {
        match shape {
            Shape::Sphere { center, radius } => {
                let height = plane.height(*center);
                let square = (radius - height.abs()) * (radius + height.abs());
                (square > 0.0).then(|| Cut::Circle { center: plane.at(*center), radius: square.sqrt() })
            }
            Shape::Plane { normal, distance } => {
                // A plane that is nearly that of the section would be a line far off.
                let along = plane.along(*normal);
                let length = along.length();
                let distance = distance - normal.dot(plane.origin);
                (length > 1e-6).then(|| Cut::Line { normal: along / length, distance: distance / length })
            }
            Shape::Box { min, max } => box_cut(*min, *max, plane),
            Shape::Triangle { vertices } => {
                let [a, b] = triangle_cut(vertices, plane)?;
                Some(Cut::Chains { chains: vec![vec![a.at, b.at]], closed: false })
            }
            Shape::Mesh(mesh) => {
                let pieces: Vec<[End; 2]> = mesh.triangles.iter().filter_map(|t| triangle_cut(t, plane)).collect();
                let chains = chains(&pieces);
                (!chains.is_empty()).then_some(Cut::Chains { chains, closed: mesh.closed })
            }
        }
    }

    /// Points that a window around the cut has to contain; none for a plane, which has no end.
    pub(super) fn extent(&self) -> Vec<DVec2> {
        match self {
            Cut::Circle { center, radius } => vec![center - DVec2::splat(*radius), center + DVec2::splat(*radius)],
            Cut::Polygon(corners) => corners.clone(),
            Cut::Chains { chains, .. } => chains.concat(),
            Cut::Line { .. } => Vec::new(),
        }
    }
}

/// The corners of a box that the plane cuts off, in order around their middle.
fn box_cut(min: DVec3, max: DVec3, plane: &Plane) -> Option<Cut> {
    let corner = |i: usize| {
        let pick = |axis: usize| if i >> axis & 1 == 1 { max[axis] } else { min[axis] };
        DVec3::new(pick(0), pick(1), pick(2))
    };
    let mut points: Vec<DVec2> = Vec::new();
    for i in 0..8 {
        for axis in (0..3).filter(|axis| i >> axis & 1 == 0) {
            points.extend(crossing(corner(i), corner(i | 1 << axis), plane));
        }
    }
    let middle = points.iter().sum::<DVec2>() / points.len().max(1) as f64;
    let angle = |p: &DVec2| libm::atan2(p.y - middle.y, p.x - middle.x);
    points.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    (points.len() >= 3).then_some(Cut::Polygon(points))
}

/// Where an edge passes through the plane. A corner in the plane counts as in front of it: then every edge passes through at
/// most once, and what is cut off closes.
fn crossing(a: DVec3, b: DVec3, plane: &Plane) -> Option<DVec2> {
    let (from, to) = (plane.height(a), plane.height(b));
    ((from >= 0.0) != (to >= 0.0)).then(|| plane.at(a.lerp(b, from / (from - to))))
}

/// An end of a cut through a triangle: where, and the edge that it lies on by the positions of its ends, in either order.
#[derive(Clone, Copy)]
struct End {
    at: DVec2,
    edge: [[u64; 3]; 2],
}

/// The cut through a triangle, matter on its left as its normal points to the other side.
fn triangle_cut(vertices: &[DVec3; 3], plane: &Plane) -> Option<[End; 2]> {
    let mut ends: Vec<End> = Vec::new();
    for k in 0..3 {
        let (a, b) = (vertices[k], vertices[(k + 1) % 3]);
        // The neighbour meets the edge the other way round; both have to find the same point.
        let key = |v: DVec3| v.to_array().map(|x| (x + 0.0).to_bits());
        let (a, b) = if key(a) <= key(b) { (a, b) } else { (b, a) };
        ends.extend(crossing(a, b, plane).map(|at| End { at, edge: [key(a), key(b)] }));
    }
    let [a, b] = *ends.as_slice() else { return None };
    let normal = plane.along((vertices[1] - vertices[0]).cross(vertices[2] - vertices[0]));
    // The normal points to the right of the way.
    let way = b.at - a.at;
    Some(if way.perp().dot(normal) <= 0.0 { [a, b] } else { [b, a] })
}

/// The pieces put together where they share an edge.
fn chains(pieces: &[[End; 2]]) -> Vec<Vec<DVec2>> {
    let mut starts: BTreeMap<[[u64; 3]; 2], Vec<usize>> = BTreeMap::new();
    for (i, [start, _]) in pieces.iter().enumerate() {
        starts.entry(start.edge).or_default().push(i);
    }
    let ends: std::collections::BTreeSet<_> = pieces.iter().map(|[_, end]| end.edge).collect();
    // Open chains begin where no piece ends; what is left then are rings.
    let heads = (0..pieces.len()).filter(|&i| !ends.contains(&pieces[i][0].edge));
    let mut used = vec![false; pieces.len()];
    let mut chains = Vec::new();
    for first in heads.chain(0..pieces.len()).collect::<Vec<_>>() {
        if used[first] {
            continue;
        }
        let mut chain = vec![pieces[first][0].at];
        let mut next = Some(first);
        while let Some(i) = next {
            used[i] = true;
            chain.push(pieces[i][1].at);
            let after = starts.get(&pieces[i][1].edge);
            next = after.and_then(|after| after.iter().copied().find(|&i| !used[i]));
        }
        chains.push(chain);
    }
    chains
}
