//! Wavefront OBJ.
//!
//! The parser is our own because its errors have to carry the line and column of what is wrong, which the existing
//! crates drop, and because they skip what they do not know instead of refusing it.

use crate::scene::mesh::text::{Lines, Word, coordinate, finite, quoted, utf8};
use crate::scene::mesh::{MeshData, MeshError, face_normal, unit};

/// The mesh in a Wavefront OBJ file.
///
/// Read are `v`, `vn` and `f` (corners `a`, `a/b`, `a//c`, `a/b/c`; indices from 1, or negative, counted back from
/// the latest; also forward ones). Polygons become fans around their first corner, which is right for convex ones.
/// Vertex weights and colours, `vt`, `o`, `g`, `s`, `usemtl`, `mtllib` and comments are passed over: shading groups
/// and materials are the scene's. Normals are made unit; where only some faces have normals, the corners of the
/// others get the normal of their triangle. A backslash at the end of a line continues it.
///
/// # Errors
/// With line and column: bytes that are not UTF-8; any other statement (lines, points and free-form surfaces
/// included); a `v` or `vn` with the wrong number of numbers; a number that is not one, not finite or, in a `v`, not
/// a multiple of 2^-178 of magnitude at most 2^128; a face with fewer than three corners, or with normals at some
/// corners only; an index that is zero or out of range; a normal of length zero that a face uses. Without: no
/// vertices, or 2^32; no faces.
///
/// # Accuracy
/// Decimals are rounded to the nearest double. Memory is at most about 300 bytes for each corner in the file.
///
/// # Source
/// Wavefront, Advanced Visualizer manual, appendix B1, Object files.
///
/// # Example
/// ```
/// let mesh = raytree::scene::mesh::parse_obj(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4").unwrap();
/// assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3]]);
/// let error = raytree::scene::mesh::parse_obj(b"v 0 0 0\nf 1 1 7").unwrap_err();
/// assert_eq!((error.line, error.column), (Some(2), Some(7)));
/// assert_eq!(error.message, "vertex index 7 is out of range: the file has 1 of them");
/// ```
pub fn parse_obj(bytes: &[u8]) -> Result<MeshData, MeshError> {
    let text = utf8(bytes)?;
    let pool = read_pool(text)?;
    if pool.positions.is_empty() {
        return Err(MeshError::whole("the file has no vertices", "lines \"v x y z\""));
    }
    if u32::try_from(pool.positions.len()).is_err() {
        return Err(MeshError::whole("the file has 2^32 vertices or more", "a smaller mesh"));
    }
    let (faces, corner_normals) = read_faces(text, &pool)?;
    if faces.is_empty() {
        return Err(MeshError::whole("the file has no faces", "lines \"f a b c\" after the vertices"));
    }
    Ok(MeshData { positions: pool.positions, faces, corner_normals })
}

/// What faces point into.
#[derive(Default)]
struct Pool {
    positions: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    textures: usize,
}

/// All vertices and normals of the file; every statement but `f` is checked here.
fn read_pool(text: &str) -> Result<Pool, MeshError> {
    let mut pool = Pool::default();
    let (mut lines, mut words) = (Lines::new(text, 0), Vec::new());
    while lines.next_line(&mut words, Some(b'#'), true) {
        let (keyword, rest) = (words[0], &words[1..]);
        match keyword.text {
            "v" => {
                if !matches!(rest.len(), 3 | 4 | 6 | 7) {
                    let message = format!("a vertex of {} numbers", rest.len());
                    let help = "\"v x y z\", perhaps followed by a weight, a colour of three numbers, or both";
                    return Err(MeshError::in_text(text, keyword.at, message, help));
                }
                for &word in &rest[3..] {
                    finite(text, word, "a weight or colour")?;
                }
                let [x, y, z] = [rest[0], rest[1], rest[2]];
                pool.positions.push([coordinate(text, x, "x")?, coordinate(text, y, "y")?, coordinate(text, z, "z")?]);
            }
            "vn" => {
                let &[x, y, z] = rest else {
                    let message = format!("a normal of {} numbers", rest.len());
                    return Err(MeshError::in_text(text, keyword.at, message, "\"vn x y z\""));
                };
                pool.normals.push([finite(text, x, "x")?, finite(text, y, "y")?, finite(text, z, "z")?]);
            }
            "vt" => pool.textures += 1,
            "f" | "o" | "g" | "s" | "usemtl" | "mtllib" => {}
            _ => {
                let message = format!("the statement {} is unknown", quoted(keyword.text));
                let help = "v, vn, vt, f, o, g, s, usemtl, mtllib, or a comment after #";
                return Err(MeshError::in_text(text, keyword.at, message, help));
            }
        }
    }
    Ok(pool)
}

type Faces = (Vec<[u32; 3]>, Option<Vec<[[f64; 3]; 3]>>);

/// All faces of the file as triangles. Counted again beside them are the vertices so far, for negative indices.
fn read_faces(text: &str, pool: &Pool) -> Result<Faces, MeshError> {
    let mut faces = Vec::new();
    let mut normals: Vec<[[f64; 3]; 3]> = Vec::new();
    let mut has_normals = false;
    let mut so_far = SoFar::default();
    let mut corners: Vec<Corner> = Vec::new();
    let (mut lines, mut words) = (Lines::new(text, 0), Vec::new());
    while lines.next_line(&mut words, Some(b'#'), true) {
        let (keyword, rest) = (words[0], &words[1..]);
        match keyword.text {
            "v" => so_far.positions += 1,
            "vn" => so_far.normals += 1,
            "vt" => so_far.textures += 1,
            "f" => {
                if rest.len() < 3 {
                    let message = format!("a face with {} corners", rest.len());
                    return Err(MeshError::in_text(text, keyword.at, message, "three corners or more"));
                }
                corners.clear();
                for &word in rest {
                    let corner = parse_corner(text, word, pool, &so_far)?;
                    if corners.first().is_some_and(|first| first.normal.is_some() != corner.normal.is_some()) {
                        let message = "some corners of this face have a normal, others have none";
                        return Err(MeshError::in_text(text, word.at, message, "a normal at every corner, or at none"));
                    }
                    corners.push(corner);
                }
                for pair in corners[1..].windows(2) {
                    let triangle = [corners[0], pair[0], pair[1]];
                    faces.push(triangle.map(|corner| corner.position));
                    has_normals |= triangle[0].normal.is_some();
                    if pool.normals.is_empty() {
                        continue;
                    }
                    let flat = face_normal(triangle.map(|corner| pool.positions[corner.position as usize]));
                    normals.push(triangle.map(|corner| corner.normal.unwrap_or(flat)));
                }
            }
            _ => {}
        }
    }
    Ok((faces, has_normals.then_some(normals)))
}

/// How many of each kind stand above the current line.
#[derive(Default)]
struct SoFar {
    positions: usize,
    normals: usize,
    textures: usize,
}

#[derive(Clone, Copy)]
struct Corner {
    position: u32,
    normal: Option<[f64; 3]>,
}

fn parse_corner(text: &str, word: Word<'_>, pool: &Pool, so_far: &SoFar) -> Result<Corner, MeshError> {
    let mut parts = word.text.split('/');
    let (position, texture, normal) = (parts.next(), parts.next(), parts.next());
    if parts.next().is_some() {
        let message = format!("the corner {} has more than three parts", quoted(word.text));
        return Err(MeshError::in_text(text, word.at, message, "a, a/b, a//c or a/b/c"));
    }
    let resolve = |part: &str, what: &str, count: usize, so_far: usize| -> Result<usize, MeshError> {
        let error = |message: String, help: &str| Err(MeshError::in_text(text, word.at, message, help));
        let Ok(index) = part.parse::<i128>() else {
            let message = format!("{what} index {} is not a whole number", quoted(part));
            return error(message, "a, a/b, a//c or a/b/c, with whole numbers");
        };
        let from_zero = match index {
            1.. => index - 1,
            0 => return error(format!("{what} index 0"), "indices count from 1, or from -1 backwards"),
            _ => so_far as i128 + index,
        };
        match usize::try_from(from_zero) {
            Ok(from_zero) if from_zero < count => Ok(from_zero),
            _ if index < 0 => {
                let message = format!("{what} index {index} is out of range: {so_far} of them stand above this line");
                error(message, "a negative index counts back from the latest one, which is -1")
            }
            _ => {
                let message = format!("{what} index {index} is out of range: the file has {count} of them");
                error(message, "an index from 1 to that count")
            }
        }
    };
    let position = resolve(position.unwrap_or_default(), "vertex", pool.positions.len(), so_far.positions)?;
    let position = position as u32; // Their number was held against 2^32.
    match texture {
        // The empty middle of a//c.
        Some("") if normal.is_some() => {}
        Some(part) => {
            resolve(part, "texture", pool.textures, so_far.textures)?;
        }
        None => {}
    }
    let Some(part) = normal else { return Ok(Corner { position, normal: None }) };
    let index = resolve(part, "normal", pool.normals.len(), so_far.normals)?;
    let Some(normal) = unit(pool.normals[index]) else {
        let message = format!("the normal {} of this corner has length zero", quoted(part));
        return Err(MeshError::in_text(text, word.at, message, "a normal with a direction, or none"));
    };
    Ok(Corner { position, normal: Some(normal) })
}
