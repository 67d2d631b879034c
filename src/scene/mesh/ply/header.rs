//! The header of a PLY file: its format, and the elements and properties that it declares.

use crate::scene::mesh::MeshError;
use crate::scene::mesh::text::{Lines, Word, quoted, utf8};

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Format {
    Ascii,
    LittleEndian,
    BigEndian,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Scalar {
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
    pub(super) fn named(name: &str) -> Option<Self> {
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

    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

pub(super) struct Property<'a> {
    pub(super) name: &'a str,
    pub(super) kind: Kind,
    /// Where the header declares it.
    pub(super) at: usize,
}

pub(super) struct Element<'a> {
    pub(super) name: &'a str,
    pub(super) count: u64,
    pub(super) properties: Vec<Property<'a>>,
    /// Where the header declares it.
    pub(super) at: usize,
}

pub(super) struct Header<'a> {
    /// The text up to and including `end_header`, for places.
    pub(super) text: &'a str,
    pub(super) format: Format,
    pub(super) elements: Vec<Element<'a>>,
    pub(super) vertex_count: u64,
    /// The offset of the first row.
    pub(super) body: usize,
}

pub(super) const HEADER_HELP: &str = "\"format\", \"element NAME COUNT\", \"property TYPE NAME\", \
     \"property list TYPE TYPE NAME\", \"comment\", \"obj_info\", \"end_header\"";
pub(super) const TYPE_HELP: &str = "char, uchar, short, ushort, int, uint, float, double, or int8 to float64";

pub(super) fn read_header(bytes: &[u8]) -> Result<Header<'_>, MeshError> {
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
pub(super) fn check_elements(header: &Header<'_>) -> Result<(), MeshError> {
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

pub(super) const VERTEX_PROPERTIES: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

pub(super) fn is_corner_list(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}
