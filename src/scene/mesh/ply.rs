//! The Polygon File Format, PLY: a header in text, then rows in text or in binary of either byte order.

use crate::numbers::is_in_range;
use crate::scene::mesh::range::RANGE_HELP;
use crate::scene::mesh::text::{Lines, Word, quoted, utf8};
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

#[derive(Clone, Copy, PartialEq)]
enum Format {
    Ascii,
    LittleEndian,
    BigEndian,
}

#[derive(Clone, Copy, PartialEq)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

#[derive(Clone, Copy)]
enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

struct Property<'a> {
    name: &'a str,
    kind: Kind,
    /// Where the header declares it.
    at: usize,
}

struct Element<'a> {
    name: &'a str,
    count: u64,
    properties: Vec<Property<'a>>,
    /// Where the header declares it.
    at: usize,
}

struct Header<'a> {
    /// The text up to and including `end_header`, for places.
    text: &'a str,
    format: Format,
    elements: Vec<Element<'a>>,
    vertex_count: u64,
    /// The offset of the first row.
    body: usize,
}

const HEADER_HELP: &str = "\"format\", \"element NAME COUNT\", \"property TYPE NAME\", \
     \"property list TYPE TYPE NAME\", \"comment\", \"obj_info\", \"end_header\"";
const TYPE_HELP: &str = "char, uchar, short, ushort, int, uint, float, double, or int8 to float64";

fn read_header(bytes: &[u8]) -> Result<Header<'_>, MeshError> {
    let first = bytes.split(|&byte| byte == b'\n').next().unwrap_or_default();
    if first.trim_ascii_end() != b"ply" {
        let help = "the first line of a PLY file is \"ply\"";
        return Err(MeshError { line: Some(1), column: Some(1), ..MeshError::whole("this is not a PLY file", help) });
    }
    let mut body = 0;
    let ended = bytes.split_inclusive(|&byte| byte == b'\n').any(|line| {
        body += line.len();
        line.trim_ascii() == b"end_header"
    });
    if !ended {
        let help = "the header ends with a line \"end_header\"";
        return Err(MeshError::whole("the header has no end", help));
    }
    let text = utf8(&bytes[..body])?;

    let mut format = None;
    let mut elements: Vec<Element<'_>> = Vec::new();
    let (mut lines, mut words) = (Lines::new(text, first.len()), Vec::new());
    while lines.next_line(&mut words, None, false) {
        let at = words[0].at;
        let error = |at: usize, message: String, help: &str| Err(MeshError::in_text(text, at, message, help));
        let texts: Vec<&str> = words.iter().map(|word| word.text).collect();
        match texts[..] {
            ["comment" | "obj_info", ..] => {}
            ["end_header"] => break,
            ["format", name, version] => {
                if format.is_some() {
                    return error(at, "a second \"format\"".into(), "one format");
                }
                format = Some(match (name, version) {
                    ("ascii", "1.0") => Format::Ascii,
                    ("binary_little_endian", "1.0") => Format::LittleEndian,
                    ("binary_big_endian", "1.0") => Format::BigEndian,
                    _ => {
                        let message = format!("the format {} {} is unknown", quoted(name), quoted(version));
                        let help = "ascii 1.0, binary_little_endian 1.0 or binary_big_endian 1.0";
                        return error(words[1].at, message, help);
                    }
                });
            }
            ["element", name, count] => {
                let Ok(count) = count.parse::<u64>() else {
                    let message = format!("the count of {} is {}", quoted(name), quoted(count));
                    return error(words[2].at, message, "a whole number from 0 to 2^64 - 1");
                };
                if matches!(name, "vertex" | "face") && elements.iter().any(|element| element.name == name) {
                    return error(words[1].at, format!("a second element {}", quoted(name)), "one of them");
                }
                elements.push(Element { name, count, properties: Vec::new(), at });
            }
            ["property", ref kind @ .., name] if matches!(kind, [_] | ["list", _, _]) => {
                let scalar = |word: &Word<'_>| {
                    Scalar::named(word.text).ok_or_else(|| {
                        let message = format!("the type {} is unknown", quoted(word.text));
                        MeshError::in_text(text, word.at, message, TYPE_HELP)
                    })
                };
                let kind = if kind.len() == 1 {
                    Kind::Scalar(scalar(&words[1])?)
                } else {
                    Kind::List { count: scalar(&words[2])?, item: scalar(&words[3])? }
                };
                if let Kind::List { count, .. } = kind
                    && !count.is_integer()
                {
                    return error(
                        words[2].at,
                        "a list whose count is no integer".into(),
                        "uchar, or another integer type",
                    );
                }
                let Some(element) = elements.last_mut() else {
                    return error(at, "a property before any element".into(), "\"element NAME COUNT\" above it");
                };
                element.properties.push(Property { name, kind, at });
            }
            _ => {
                return error(
                    at,
                    format!("the header line {} is not understood", quoted(&texts.join(" "))),
                    HEADER_HELP,
                );
            }
        }
    }
    let Some(format) = format else {
        return Err(MeshError::whole("the header names no format", "\"format ascii 1.0\" below \"ply\""));
    };
    let vertex_count = elements.iter().find(|element| element.name == "vertex").map_or(0, |element| element.count);
    let header = Header { text, format, elements, vertex_count, body };
    check_elements(&header)?;
    Ok(header)
}

/// Holds the declared properties against what a mesh needs.
fn check_elements(header: &Header<'_>) -> Result<(), MeshError> {
    for element in &header.elements {
        let needed: &[&str] = match element.name {
            "vertex" => &["x", "y", "z"],
            "face" => &[],
            _ => continue,
        };
        let read = |property: &&Property<'_>| match element.name {
            "vertex" => VERTEX_PROPERTIES.contains(&property.name),
            _ => is_corner_list(property.name),
        };
        let properties: Vec<&Property<'_>> = element.properties.iter().filter(read).collect();
        let error = |at: usize, message: String, help: &str| Err(MeshError::in_text(header.text, at, message, help));
        for (index, property) in properties.iter().enumerate() {
            let twice = |earlier: &&Property<'_>| element.name == "face" || earlier.name == property.name;
            if properties[..index].iter().any(twice) {
                return error(
                    property.at,
                    format!("the property {} is there twice", quoted(property.name)),
                    "one of them",
                );
            }
            match (element.name, property.kind) {
                ("vertex", Kind::List { .. }) => {
                    return error(property.at, format!("{} is a list", quoted(property.name)), "a number");
                }
                ("face", Kind::Scalar(_)) => {
                    return error(property.at, format!("{} is a single number", quoted(property.name)), "a list");
                }
                ("face", Kind::List { item, .. }) if !item.is_integer() => {
                    return error(property.at, "indices that are no integers".into(), "int, or another integer type");
                }
                _ => {}
            }
        }
        for name in needed {
            if !properties.iter().any(|property| property.name == *name) {
                return error(element.at, format!("the vertices have no {}", quoted(name)), "properties x, y and z");
            }
        }
        if element.name == "face" && properties.is_empty() {
            let help = "\"property list uchar int vertex_indices\"";
            return error(element.at, "the faces have no list of corners".into(), help);
        }
    }
    Ok(())
}

const VERTEX_PROPERTIES: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

fn is_corner_list(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}

/// A number from a row, and where it stands.
struct Value {
    number: f64,
    at: usize,
}

/// The rows below the header.
enum Rows<'a> {
    Text { text: &'a str, lines: Lines<'a>, words: Vec<Word<'a>>, next: usize },
    Binary { bytes: &'a [u8], at: usize, big_endian: bool },
}

impl Rows<'_> {
    fn error(&self, at: usize, message: impl Into<String>, help: impl Into<String>) -> MeshError {
        match self {
            Self::Text { text, .. } => MeshError::in_text(text, at, message, help),
            Self::Binary { .. } => MeshError::in_binary(at, message, help),
        }
    }

    /// Refuses a count of rows that the rest of the file cannot hold, so that memory may follow it.
    fn check_promise(&self, element: &Element<'_>, end: usize) -> Result<(), MeshError> {
        let (at, least) = match self {
            // A digit and a blank or line end for every number; the last line may lack its end.
            Self::Text { lines, .. } => (lines.offset(), 2 * element.properties.len()),
            Self::Binary { at, .. } => {
                let sizes = element.properties.iter().map(|property| match property.kind {
                    Kind::Scalar(scalar) => scalar.size(),
                    Kind::List { count, .. } => count.size(),
                });
                (*at, sizes.sum())
            }
        };
        let wanted = u128::from(element.count) * least as u128;
        let had = end - at;
        let spare = usize::from(matches!(self, Self::Text { .. }));
        if wanted > (had + spare) as u128 {
            let message = format!(
                "the header promises {} rows of {}, at least {wanted} bytes, but {had} bytes are left",
                element.count,
                quoted(element.name),
            );
            return Err(self.error(at, message, "a complete file, or a smaller count"));
        }
        Ok(())
    }

    fn begin_row(&mut self, element: &Element<'_>, row: u64) -> Result<(), MeshError> {
        if let Self::Text { text, lines, words, next } = self {
            *next = 0;
            if !lines.next_line(words, None, false) {
                let message = format!(
                    "the file ends before row {row} of {} rows of {}, counted from 0",
                    element.count,
                    quoted(element.name)
                );
                return Err(MeshError::in_text(text, text.len(), message, "a complete file, or a smaller count"));
            }
        }
        Ok(())
    }

    fn end_row(&self) -> Result<(), MeshError> {
        if let Self::Text { text, words, next, .. } = self
            && let Some(word) = words.get(*next)
        {
            let message = format!("{} is more than this row holds by the header", quoted(word.text));
            return Err(MeshError::in_text(
                text,
                word.at,
                message,
                "one row a line, with the properties of the header",
            ));
        }
        Ok(())
    }

    fn expect_end(&mut self) -> Result<(), MeshError> {
        let at = match self {
            Self::Text { lines, words, .. } => {
                if !lines.next_line(words, None, false) {
                    return Ok(());
                }
                words[0].at
            }
            Self::Binary { bytes, at, .. } if *at < bytes.len() => *at,
            Self::Binary { .. } => return Ok(()),
        };
        Err(self.error(at, "there is more after the last row", "counts in the header that cover the whole file"))
    }

    fn scalar(&mut self, scalar: Scalar) -> Result<Value, MeshError> {
        match self {
            Self::Text { text, words, next, .. } => {
                let Some(&word) = words.get(*next) else {
                    let at = words.last().map_or(text.len(), |word| word.at + word.text.len());
                    let help = "one row a line, with the properties of the header";
                    return Err(MeshError::in_text(text, at, "the row ends too early", help));
                };
                *next += 1;
                // Integers go through f64 too: all of the types have at most 32 bits, and larger ones are out of range.
                match word.text.parse::<f64>() {
                    Ok(number) if !scalar.is_integer() || number.fract() == 0.0 => Ok(Value { number, at: word.at }),
                    _ => {
                        let what = if scalar.is_integer() { "a whole number" } else { "a number" };
                        let message = format!("{} is not {what}", quoted(word.text));
                        Err(MeshError::in_text(text, word.at, message, format!("{what}, as the header says")))
                    }
                }
            }
            Self::Binary { bytes, at, big_endian } => {
                let start = *at;
                let size = scalar.size();
                let mut raw = [0; 8];
                raw[..size].copy_from_slice(take(bytes, at, size as u64)?);
                if *big_endian {
                    raw[..size].reverse();
                }
                let [b0, b1, b2, b3, ..] = raw;
                let number = match scalar {
                    Scalar::I8 => f64::from(i8::from_le_bytes([b0])),
                    Scalar::U8 => f64::from(b0),
                    Scalar::I16 => f64::from(i16::from_le_bytes([b0, b1])),
                    Scalar::U16 => f64::from(u16::from_le_bytes([b0, b1])),
                    Scalar::I32 => f64::from(i32::from_le_bytes([b0, b1, b2, b3])),
                    Scalar::U32 => f64::from(u32::from_le_bytes([b0, b1, b2, b3])),
                    Scalar::F32 => f64::from(f32::from_le_bytes([b0, b1, b2, b3])),
                    Scalar::F64 => f64::from_le_bytes(raw),
                };
                Ok(Value { number, at: start })
            }
        }
    }

    /// The length of a list, and where it stands; the list itself may still be cut short.
    fn list_length(&mut self, count: Scalar) -> Result<(u64, usize), MeshError> {
        let Value { number, at } = self.scalar(count)?;
        if !(0.0..=f64::from(u32::MAX)).contains(&number) {
            return Err(self.error(at, format!("a list of {number} numbers"), "a count from 0 to 2^32 - 1"));
        }
        Ok((number as u64, at))
    }

    fn skip(&mut self, kind: Kind) -> Result<(), MeshError> {
        let (length, item) = match kind {
            Kind::Scalar(scalar) => (1, scalar),
            Kind::List { count, item } => (self.list_length(count)?.0, item),
        };
        match self {
            Self::Binary { bytes, at, .. } => take(bytes, at, length * item.size() as u64).map(|_| ()),
            // Ends at the end of the line, however long the list pretends to be.
            Self::Text { .. } => (0..length).try_for_each(|_| self.scalar(Scalar::F64).map(|_| ())),
        }
    }
}

/// The next `wanted` bytes.
fn take<'a>(bytes: &'a [u8], at: &mut usize, wanted: u64) -> Result<&'a [u8], MeshError> {
    let rest = &bytes[*at..];
    match usize::try_from(wanted).ok().and_then(|wanted| rest.get(..wanted)) {
        Some(taken) => {
            *at += taken.len();
            Ok(taken)
        }
        None => {
            let message = format!("the file is cut short: {wanted} bytes wanted here, {} had", rest.len());
            Err(MeshError::in_binary(*at, message, "a complete file"))
        }
    }
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
