//! The Polygon File Format, PLY: a header in text, then rows in text or in binary of either byte order.

mod header;
mod rows;

use header::{Element, Format, Kind, VERTEX_PROPERTIES, is_corner_list, read_header};
use rows::{Rows, Value};

use crate::numbers::is_in_range;
use crate::scene::mesh::range::RANGE_HELP;
use crate::scene::mesh::text::{Lines, utf8};
use crate::scene::mesh::{MeshData, MeshError, unit};

/// The mesh in a PLY file, `ascii`, `binary_little_endian` or `binary_big_endian`, version 1.0.
///
/// Read are `x`, `y`, `z` and, where all three are there, `nx`, `ny`, `nz` of the element `vertex`, of any scalar
/// type, and the list `vertex_indices` or `vertex_index` of the element `face`, of any integer types; the two
/// elements may come in either order. Other properties and elements are passed over. Polygons become fans around
/// their first corner, which is right for convex ones. Normals are made unit. In text every row has a line of its
/// own, and decimals are rounded to the nearest double even where the header says `float`.
///
/// # Errors
/// In the header and in text with line and column, in binary with the byte offset: no `ply` in the first line; a
/// header without `end_header` or with a line that is not understood; an unknown format or type; an element or
/// property that is missing, of the wrong kind or there twice; a count that promises more rows than the file can
/// hold; a row cut short, or too long; a coordinate that is not finite or not a multiple of 2^-178 of magnitude at
/// most 2^128; a face with fewer than three corners; an index out of range; anything after the last row; text that is
/// not UTF-8. Without: no format; no vertices, or 2^32; no faces; a normal of length zero at a vertex that a face
/// uses (the message names the vertex).
///
/// # Accuracy
/// Exact in binary. Memory is at most about 200 bytes for each corner in the file; it never follows a count that the
/// file cannot hold.
///
/// # Source
/// Turk, The PLY polygon file format, 1994.
///
/// # Example
/// ```
/// let file = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z
/// element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
/// let mesh = raytree::scene::mesh::parse_ply(file).unwrap();
/// assert_eq!(mesh.faces, [[0, 1, 2]]);
/// ```
pub fn parse_ply(bytes: &[u8]) -> Result<MeshData, MeshError> {
    let header = read_header(bytes)?;
    let mut rows = match header.format {
        Format::Ascii => {
            let text = utf8(bytes)?;
            Rows::Text { text, lines: Lines::new(text, header.body), words: Vec::new(), next: 0 }
        }
        Format::LittleEndian => Rows::Binary { bytes, at: header.body, big_endian: false },
        Format::BigEndian => Rows::Binary { bytes, at: header.body, big_endian: true },
    };

    let mut vertices = Vertices::default();
    let mut polygons = Polygons::default();
    for element in &header.elements {
        rows.check_promise(element, bytes.len())?;
        match element.name {
            "vertex" => read_vertices(&mut rows, element, &mut vertices)?,
            "face" => read_polygons(&mut rows, element, header.vertex_count, &mut polygons)?,
            _ => skip_rows(&mut rows, element)?,
        }
    }
    rows.expect_end()?;
    if vertices.positions.is_empty() {
        return Err(MeshError::whole("the file has no vertices", "\"element vertex\" with a count above 0"));
    }
    if polygons.faces.is_empty() {
        return Err(MeshError::whole("the file has no faces", "\"element face\" with a count above 0"));
    }

    let corner_normals = if vertices.normals.is_empty() {
        None
    } else {
        let mut corner_normals = Vec::with_capacity(polygons.faces.len());
        for face in &polygons.faces {
            let mut corners = [[0.0; 3]; 3];
            for (corner, &index) in corners.iter_mut().zip(face) {
                let Some(normal) = unit(vertices.normals[index as usize]) else {
                    let message =
                        format!("the normal of vertex {index}, counted from 0, has length zero or is not finite");
                    return Err(MeshError::whole(message, "a normal with a direction, or no normals at all"));
                };
                *corner = normal;
            }
            corner_normals.push(corners);
        }
        Some(corner_normals)
    };
    Ok(MeshData { positions: vertices.positions, faces: polygons.faces, corner_normals })
}

#[derive(Default)]
struct Vertices {
    positions: Vec<[f64; 3]>,
    /// As long as `positions`, or empty.
    normals: Vec<[f64; 3]>,
}

fn read_vertices(rows: &mut Rows<'_>, element: &Element<'_>, vertices: &mut Vertices) -> Result<(), MeshError> {
    let slot = |name: &str| VERTEX_PROPERTIES.iter().position(|&known| known == name);
    let slots: Vec<Option<usize>> = element.properties.iter().map(|property| slot(property.name)).collect();
    let has_normals = (3..6).all(|slot| slots.contains(&Some(slot)));
    if u32::try_from(element.count).is_err() {
        return Err(MeshError::whole("the file has 2^32 vertices or more", "a smaller mesh"));
    }
    // The promise is checked: the rows fit into the file.
    vertices.positions.reserve_exact(element.count as usize);
    vertices.normals.reserve_exact(if has_normals { element.count as usize } else { 0 });
    for row in 0..element.count {
        rows.begin_row(element, row)?;
        let mut numbers = [0.0; 6];
        for (property, slot) in element.properties.iter().zip(&slots) {
            match (property.kind, slot) {
                (Kind::Scalar(scalar), &Some(slot)) => {
                    let Value { number, at } = rows.scalar(scalar)?;
                    let message = if !number.is_finite() {
                        "not a finite number"
                    } else if slot < 3 && !is_in_range(number) {
                        "out of range"
                    } else {
                        numbers[slot] = number;
                        continue;
                    };
                    let message = format!("{} of vertex {row}, counted from 0, is {message}", property.name);
                    return Err(rows.error(at, message, RANGE_HELP));
                }
                (kind, _) => rows.skip(kind)?,
            }
        }
        rows.end_row()?;
        let [x, y, z, nx, ny, nz] = numbers;
        vertices.positions.push([x, y, z]);
        if has_normals {
            vertices.normals.push([nx, ny, nz]);
        }
    }
    Ok(())
}

#[derive(Default)]
struct Polygons {
    faces: Vec<[u32; 3]>,
}

fn read_polygons(
    rows: &mut Rows<'_>,
    element: &Element<'_>,
    vertex_count: u64,
    polygons: &mut Polygons,
) -> Result<(), MeshError> {
    polygons.faces.reserve(element.count as usize);
    for row in 0..element.count {
        rows.begin_row(element, row)?;
        for property in &element.properties {
            let (Kind::List { count, item }, true) = (property.kind, is_corner_list(property.name)) else {
                rows.skip(property.kind)?;
                continue;
            };
            let (length, at) = rows.list_length(count)?;
            if length < 3 {
                let message = format!("face {row}, counted from 0, has {length} corners");
                return Err(rows.error(at, message, "three corners or more"));
            }
            let mut fan = [0; 2];
            for corner in 0..length {
                let Value { number, at } = rows.scalar(item)?;
                if !(0.0 <= number && number < vertex_count as f64 && number <= f64::from(u32::MAX)) {
                    let message = format!("vertex index {number} is out of range: the file has {vertex_count} of them");
                    return Err(rows.error(at, message, "an index from 0 to one less than that count"));
                }
                let index = number as u32;
                match corner {
                    0 | 1 => fan[corner as usize] = index,
                    _ => {
                        polygons.faces.push([fan[0], fan[1], index]);
                        fan[1] = index;
                    }
                }
            }
        }
        rows.end_row()?;
    }
    Ok(())
}

fn skip_rows(rows: &mut Rows<'_>, element: &Element<'_>) -> Result<(), MeshError> {
    // Rows of nothing take up nothing, however many there are.
    if element.properties.is_empty() {
        return Ok(());
    }
    for row in 0..element.count {
        rows.begin_row(element, row)?;
        for property in &element.properties {
            rows.skip(property.kind)?;
        }
        rows.end_row()?;
    }
    Ok(())
}
