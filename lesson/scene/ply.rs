//! PLY: corners, their normals if it has them, and faces, as text or binary; and the same written.
//!
//! Headers and elements are `ply-rs-bw`'s to read, one element at a time, so that no count is believed before its elements
//! are there. What a header promises is held against the size of the file first: elements that take no bytes would never
//! end, and of elements or properties of one name the last would stand for both.

use super::meshes::{coordinate, split};
use chapters::parameter::excerpt;
use light::scene::Mesh;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use std::collections::HashSet;

/// The longest line [byte].
const LONGEST: usize = 1 << 20;

/// Reads a file, and its places on an image if they are wanted. It takes at most forty times its size in memory.
pub fn read(bytes: &[u8], is_patterned: bool) -> Result<Mesh, String> {
    let parser = Parser::<Element>::new();
    let mut reader = Reader::new(bytes);
    let header = parser.read_header(&mut reader).map_err(|error| told(&error))?;
    let lines = reader.line() - 1;
    let payload = *reader.get_ref();
    distinct(&bytes[..bytes.len() - payload.len()])?;
    promised(&header, payload.len())?;
    let mut reading = Reading { mesh: Mesh::default(), has_normals: false, is_patterned, places: None };
    let rest = match header.encoding {
        Encoding::Ascii => {
            let mut lines = Lines { payload, number: lines };
            for element in header.elements.values() {
                reading.expect(element)?;
                for _ in 0..element.count {
                    let line = lines.next().ok_or_else(|| early(element))??;
                    let one = parser.read_ascii_element(line, element).map_err(|error| lines.told(&error))?;
                    reading.take(element, one).map_err(|why| format!("line {}: {why}", lines.number))?;
                }
            }
            lines.payload
        }
        _ => {
            let mut reader = reader.into_inner();
            for element in header.elements.values() {
                reading.expect(element)?;
                for at in 0..element.count {
                    let one = match header.encoding {
                        Encoding::BinaryBigEndian => parser.read_big_endian_element(&mut reader, element),
                        _ => parser.read_little_endian_element(&mut reader, element),
                    };
                    let place = || format!("{} {} of {}", excerpt(&element.name), at + 1, element.count);
                    let one = one.map_err(|error| match error.kind() {
                        std::io::ErrorKind::UnexpectedEof => format!("{}: the file ends too early", place()),
                        _ => format!("{}: {}", place(), told(&error)),
                    })?;
                    reading.take(element, one).map_err(|why| format!("{}: {why}", place()))?;
                }
            }
            reader
        }
    };
    match rest.iter().all(u8::is_ascii_whitespace) {
        true => reading.finish(),
        false => Err(format!("{} bytes are left over after the last element", rest.len())),
    }
}

/// An error of the parser in one line, with the line of the file if it knows that.
fn told(error: &ParseError) -> String {
    let text = error.to_string();
    let text = text.lines().next().unwrap_or_default().trim_end_matches('.');
    // Its "Line 3: Expected …" is our "line 3: expected …", and it repeats what it has read.
    let text: String = text.chars().take(160).collect();
    match text.strip_prefix("Line ") {
        Some(rest) => format!("line {rest}"),
        None => text,
    }
}

fn early(element: &ElementDef) -> String {
    format!("the file ends before the last of {} elements `{}`", element.count, excerpt(&element.name))
}

/// The lines of a text that are not blank.
struct Lines<'b> {
    payload: &'b [u8],
    number: usize,
}

impl<'b> Lines<'b> {
    fn next(&mut self) -> Option<Result<&'b str, String>> {
        loop {
            if self.payload.is_empty() {
                return None;
            }
            self.number += 1;
            let end = self.payload.iter().position(|byte| *byte == b'\n').map_or(self.payload.len(), |end| end + 1);
            let (line, rest) = self.payload.split_at(end);
            self.payload = rest;
            if line.len() > LONGEST {
                return Some(Err(format!("line {}: longer than {} MiB", self.number, LONGEST >> 20)));
            }
            if line.iter().any(|byte| !byte.is_ascii_whitespace()) {
                let line = std::str::from_utf8(line);
                return Some(line.map_err(|_| format!("line {}: is no text", self.number)));
            }
        }
    }

    fn told(&self, error: &ParseError) -> String {
        // Each layer of the parser's message says more; the last one is the cause.
        let text = error.to_string();
        let cause = text.lines().rev().find_map(|line| line.trim().strip_prefix("Error: ")).unwrap_or(&text);
        format!("line {}: {}", self.number, cause.chars().take(160).collect::<String>())
    }
}

/// Refuses a header in which two elements, or two properties of one, have the same name.
fn distinct(header: &[u8]) -> Result<(), String> {
    let (mut elements, mut properties) = (HashSet::new(), HashSet::new());
    for line in String::from_utf8_lossy(header).lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let (is_new, name) = match words[..] {
            ["element", name, ..] => {
                properties.clear();
                (elements.insert(name.to_owned()), name)
            }
            ["property", .., name] => (properties.insert(name.to_owned()), name),
            _ => continue,
        };
        if !is_new {
            return Err(format!("the header has `{}` twice", excerpt(name)));
        }
    }
    Ok(())
}

/// Refuses a header whose elements cannot be in `left` bytes.
fn promised(header: &Header, left: usize) -> Result<(), String> {
    let mut needed = 0_usize;
    for element in header.elements.values().filter(|element| element.count > 0) {
        let least: usize =
            element.properties.values().map(|property| least(&property.data_type, header.encoding)).sum();
        let name = excerpt(&element.name);
        if least == 0 {
            return Err(format!("the header promises {} elements `{name}` that have no properties", element.count));
        }
        needed = needed.saturating_add(element.count.saturating_mul(least));
        // The last line may end without a sign for it.
        if needed > left + 1 {
            let promises = format!("the header promises {} elements `{name}`", element.count);
            return Err(format!("{promises} of at least {least} bytes, the file has {left} bytes after it"));
        }
    }
    Ok(())
}

/// The least that a property takes [byte].
fn least(data: &PropertyType, encoding: Encoding) -> usize {
    let first = match data {
        PropertyType::Scalar(of) => of,
        PropertyType::List(count, _) => count,
    };
    match encoding {
        // A digit, and what parts it from the next.
        Encoding::Ascii => 2,
        _ => match first {
            ScalarType::Char | ScalarType::UChar => 1,
            ScalarType::Short | ScalarType::UShort => 2,
            ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
            ScalarType::Double => 8,
        },
    }
}

/// What of an element is of use: coordinates, normal and place on an image, or corners.
#[derive(Default)]
struct Element {
    numbers: [f32; 12],
    corners: Option<Vec<u32>>,
}

/// The names of [`Element::numbers`].
const NUMBERS: [&str; 12] = ["x", "y", "z", "nx", "ny", "nz", "s", "t", "u", "v", "texture_u", "texture_v"];
/// Where in them places on an image may be found: programs call these by different names.
const PLACES: [usize; 3] = [6, 8, 10];
/// The names of [`Element::corners`].
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if let Some(at) = NUMBERS.iter().position(|number| *number == name)
            && let Some(number) = property.to_f32_lossy()
        {
            self.numbers[at] = number;
        } else if CORNERS.contains(&name) {
            // None of one that is below 0.
            self.corners = property.to_u32_list();
        } else {
            return PropertyAccessResult::Ignored;
        }
        PropertyAccessResult::Set
    }
}

struct Reading {
    mesh: Mesh,
    has_normals: bool,
    is_patterned: bool,
    /// Where among the numbers places on an image are.
    places: Option<usize>,
}

impl Reading {
    /// Gets ready for elements, whose count is known to be possible.
    fn expect(&mut self, element: &ElementDef) -> Result<(), String> {
        let is_scalar = |name: &&str| {
            element.properties.get(*name).is_some_and(|property| matches!(property.data_type, PropertyType::Scalar(_)))
        };
        match element.name.as_str() {
            "vertex" => {
                if let Some(missing) = NUMBERS[..3].iter().find(|name| !is_scalar(name)) {
                    return Err(format!("its vertices have no number `{missing}`"));
                }
                self.has_normals = NUMBERS[3..6].iter().all(is_scalar);
                let has = |first: &usize| NUMBERS[*first..*first + 2].iter().all(is_scalar);
                self.places = PLACES.into_iter().find(has).filter(|_| self.is_patterned);
                self.mesh.positions.reserve_exact(element.count);
                self.mesh.normals.reserve_exact(if self.has_normals { element.count } else { 0 });
            }
            "face" => {
                let list = CORNERS.iter().find_map(|name| element.properties.get(*name)).map(|list| &list.data_type);
                let fraction = |of: &ScalarType| matches!(of, ScalarType::Float | ScalarType::Double);
                match list {
                    Some(PropertyType::List(count, of)) if !fraction(count) && !fraction(of) => {}
                    _ => return Err(format!("its faces have no list of whole numbers `{}`", CORNERS[0])),
                }
                // Most are triangles.
                self.mesh.triangles.reserve_exact(element.count);
            }
            _ => {}
        }
        Ok(())
    }

    fn take(&mut self, element: &ElementDef, one: Element) -> Result<(), String> {
        match element.name.as_str() {
            "vertex" => {
                let [x, y, z, nx, ny, nz, ..] = one.numbers;
                let used = if self.has_normals { 6 } else { 3 };
                let places = self.places.map_or(0..0, |first| first..first + 2);
                if let Some(at) = (0..used).chain(places).find(|at| coordinate(one.numbers[*at]).is_none()) {
                    return Err(format!("its {} is not finite, or too large for a single number", NUMBERS[at]));
                }
                self.mesh.positions.push([x, y, z]);
                if self.has_normals {
                    self.mesh.normals.push([nx, ny, nz]);
                }
                self.mesh.texture.extend(self.places.map(|first| [one.numbers[first], one.numbers[first + 1]]));
                Ok(())
            }
            "face" => {
                let corners = one.corners.ok_or("a corner below 0")?;
                if corners.len() < 3 {
                    return Err(format!("a face of {} corners; valid: at least 3", corners.len()));
                }
                split(&corners, &mut self.mesh.triangles);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn finish(self) -> Result<Mesh, String> {
        let mesh = self.mesh;
        let count = mesh.positions.len();
        let far =
            mesh.triangles.iter().enumerate().find(|(_, triangle)| triangle.iter().any(|at| *at as usize >= count));
        match far {
            Some((at, triangle)) => {
                let far = triangle.iter().max().expect("it has three");
                Err(format!("triangle {}: there is no corner {far}; there are {count}, the first being 0", at + 1))
            }
            None if mesh.triangles.is_empty() => Err("has no faces".into()),
            None => Ok(mesh),
        }
    }
}

/// A mesh as a file, binary, little end first: the very numbers.
pub fn write(mesh: &Mesh) -> Vec<u8> {
    let mut names = NUMBERS[..3].to_vec();
    names.extend(if mesh.normals.is_empty() { &[][..] } else { &NUMBERS[3..6] });
    names.extend(if mesh.texture.is_empty() { &[][..] } else { &NUMBERS[6..8] });
    let mut header = format!("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh.positions.len());
    names.iter().for_each(|name| header += &format!("property float {name}\n"));
    header += &format!("element face {}\nproperty list uchar uint {}\nend_header\n", mesh.triangles.len(), CORNERS[0]);
    let mut bytes = header.into_bytes();
    let mut put = |numbers: &[f32]| numbers.iter().for_each(|number| bytes.extend(number.to_le_bytes()));
    for (at, position) in mesh.positions.iter().enumerate() {
        put(position);
        mesh.normals.get(at).into_iter().for_each(|normal| put(normal));
        mesh.texture.get(at).into_iter().for_each(|place| put(place));
    }
    for triangle in &mesh.triangles {
        bytes.push(3);
        triangle.iter().for_each(|corner| bytes.extend(corner.to_le_bytes()));
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A header of so many vertices and faces, with these lines for the format and for what faces are.
    fn header(format: &str, vertices: &str, faces: &str) -> String {
        format!("ply\nformat {format} 1.0\ncomment by hand\n{vertices}{faces}end_header\n")
    }

    const FLOATS: &str = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    const FACES: &str = "element face 1\nproperty list uchar int vertex_indices\n";
    const CORNERS_OF_SQUARE: &str = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

    fn ascii(vertices: &str, faces: &str, body: &str) -> Result<Mesh, String> {
        read(format!("{}{body}", header("ascii", vertices, faces)).as_bytes(), false)
    }

    fn square() -> Mesh {
        Mesh {
            positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..Mesh::default()
        }
    }

    #[test]
    fn places_on_an_image_are_read_by_any_of_their_names() {
        let body = "0 0 0 0.5 1\n1 0 0 0.25 0\n1 1 0 0 0\n0 1 0 1 1\n4 0 1 2 3\n";
        for [s, t] in [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]] {
            let text = header("ascii", &format!("{FLOATS}property float {s}\nproperty float {t}\n"), FACES) + body;
            let texture = vec![[0.5, 1.0], [0.25, 0.0], [0.0, 0.0], [1.0, 1.0]];
            assert_eq!(read(text.as_bytes(), true), Ok(Mesh { texture, ..square() }), "{s}");
            assert_eq!(read(text.as_bytes(), false), Ok(square()), "{s}");
        }
    }

    #[test]
    fn text_is_read_with_whatever_else_it_has() {
        assert_eq!(ascii(FLOATS, FACES, &format!("{CORNERS_OF_SQUARE}4 0 1 2 3\n")), Ok(square()));
        // Returns, blank lines, no end of the last line.
        let text = header("ascii", FLOATS, FACES) + CORNERS_OF_SQUARE + "\n4 0 1 2 3";
        assert_eq!(read(text.replace('\n', "\r\n").as_bytes(), true), Ok(square()));
        // Colours before, an element between, properties behind; the other name, another type.
        let vertices = "element vertex 4\nproperty uchar red\nproperty double x\nproperty short y\nproperty float64 z\nelement edge 1\nproperty int vertex1\n";
        let faces = "element face 1\nproperty list uint ushort vertex_index\nproperty float quality\n";
        let body = "9 0 0 0\n9 1 0 0\n9 1 1 0\n9 0 1 0\n7\n4 0 1 2 3 0.5\n";
        assert_eq!(ascii(vertices, faces, body), Ok(square()));
        // Faces first.
        let text = format!("{}4 0 1 2 3\n{CORNERS_OF_SQUARE}", header("ascii", FACES, FLOATS));
        assert_eq!(read(text.as_bytes(), true), Ok(square()));
        let normals = FLOATS.to_owned() + "property float nx\nproperty float ny\nproperty float nz\n";
        let body = "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n";
        assert_eq!(ascii(&normals, FACES, body), Ok(Mesh { normals: vec![[0.0, 0.0, 1.0]; 4], ..square() }));
    }

    #[test]
    fn binary_is_read_from_either_end_with_indices_of_every_kind() {
        for (index, size) in [("char", 1), ("uchar", 1), ("short", 2), ("ushort", 2), ("int", 4), ("uint", 4)] {
            for (format, is_big) in [("binary_little_endian", false), ("binary_big_endian", true)] {
                let ordered = |mut bytes: Vec<u8>| {
                    if is_big {
                        bytes.reverse();
                    }
                    bytes
                };
                let vertices = FLOATS.replace("float", "double");
                let faces = format!("element face 1\nproperty list {index} {index} vertex_indices\n");
                let mut bytes = header(format, &vertices, &faces).into_bytes();
                for number in square().positions.iter().flatten() {
                    bytes.extend(ordered(f64::from(*number).to_le_bytes().to_vec()));
                }
                for number in [4_u32, 0, 1, 2, 3] {
                    bytes.extend(ordered(number.to_le_bytes()[..size].to_vec()));
                }
                assert_eq!(read(&bytes, true), Ok(square()), "{format} {index}");
            }
        }
    }

    #[test]
    fn what_is_wrong_is_refused_with_its_place() {
        let many = "element face 99999999999\nproperty list uchar int vertex_indices\n";
        let body = |faces: &str| format!("{CORNERS_OF_SQUARE}{faces}");
        for (vertices, faces, body, why) in [
            (FLOATS, FACES, body("4 0 1 2 4\n"), "there is no corner 4; there are 4"),
            (FLOATS, FACES, body("4 0 1 2 -1\n"), "line 15: a corner below 0"),
            (FLOATS, FACES, body("2 0 1\n"), "line 15: a face of 2 corners"),
            (FLOATS, FACES, body("4 0 1 2\n"), "line 15: Expected 4 list elements"),
            (FLOATS, FACES, body("9999999999 0 1 2\n"), "line 15: Expected 9999999999 list elements"),
            (FLOATS, FACES, body(""), "at least 2 bytes"),
            (FLOATS, FACES, "0 0 0\n1 0 0\n1 1 0 0 0 0 0 0 0\n".into(), "before the last of 4 elements `vertex`"),
            (FLOATS, FACES, body("3 0 1 2\n3 0 1 2\n"), "8 bytes are left over"),
            (FLOATS, many, body("3 0 1 2\n"), "the header promises 99999999999 elements `face` of at least 2 bytes"),
            (FLOATS, FACES, "0 0 x\n".repeat(5), "line 11"),
            (FLOATS, FACES, body("3 0 1 2\n").replace("1 1 0", "1 1e39 0"), "line 13: its y is not finite"),
            (FLOATS, "", CORNERS_OF_SQUARE.into(), "has no faces"),
            (
                FLOATS,
                "element face 0\nproperty list uchar int vertex_indices\n",
                CORNERS_OF_SQUARE.into(),
                "has no faces",
            ),
            ("", FACES, "3 0 1 2\n".into(), "there is no corner 2; there are 0"),
            (FLOATS, "element face 1\nproperty int vertex_indices\n", body("1\n"), "no list of whole numbers"),
            (
                FLOATS,
                "element face 1\nproperty list uchar float vertex_indices\n",
                body("1 1\n"),
                "no list of whole numbers",
            ),
            (&FLOATS.replace(" z", " w"), FACES, body("3 0 1 2\n"), "no number `z`"),
            (&FLOATS.replace(" z", " x"), FACES, body("3 0 1 2\n"), "`x` twice"),
            (FLOATS, &FACES.repeat(2), body("3 0 1 2\n"), "`face` twice"),
            (
                "element nothing 9999999999999\n",
                FACES,
                body("3 0 1 2\n"),
                "9999999999999 elements `nothing` that have no",
            ),
            ("element vertex -1\n", FACES, body("3 0 1 2\n"), "line 4"),
        ] {
            let refused = ascii(vertices, faces, &body).unwrap_err();
            assert!(refused.contains(why), "should say `{why}`: {refused}");
            assert_eq!(refused.lines().count(), 1, "{refused}");
        }
        for text in [
            "",
            "plx\n",
            "ply\n",
            "ply\nformat ascii 1.0\n",
            "ply\nend_header\n",
            "ply\nformat ascii 9.9.9\nend_header\n",
        ] {
            assert!(read(text.as_bytes(), false).is_err(), "{text:?}");
        }
        assert!(ascii(FLOATS, FACES, &body(&"1 ".repeat(LONGEST))).unwrap_err().contains("longer than 1 MiB"));
    }

    #[test]
    fn what_ends_early_is_refused_wherever_it_ends() {
        let whole = write(&square());
        assert_eq!(read(&whole, false), Ok(square()));
        for end in 0..whole.len() {
            assert!(read(&whole[..end], false).is_err(), "{end}");
        }
    }

    proptest! {
        #[test]
        fn what_is_written_is_read(
            positions in prop::collection::vec(prop::array::uniform3(prop::num::f32::NORMAL | prop::num::f32::SUBNORMAL | prop::num::f32::ZERO), 1..30),
            picks in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 1..30),
            has_normals: bool,
            has_places: bool,
        ) {
            let triangles = picks.iter().map(|pick| pick.map(|one| one.index(positions.len()) as u32)).collect();
            let normals = if has_normals { positions.iter().rev().copied().collect() } else { vec![] };
            let texture = if has_places { positions.iter().map(|[x, _, z]| [*z, *x]).collect() } else { vec![] };
            let mesh = Mesh { positions, normals, texture, triangles };
            prop_assert_eq!(read(&write(&mesh), true), Ok(mesh));
        }

        /// Whatever stands in the file, it is a mesh whose corners are there, or a refusal in one line.
        #[test]
        fn nothing_in_a_file_breaks_the_reader(
            is_text: bool,
            changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
            end in any::<prop::sample::Index>(),
        ) {
            let text = header("ascii", FLOATS, FACES) + CORNERS_OF_SQUARE + "4 0 1 2 3\n";
            let mut bytes = if is_text { text.into_bytes() } else { write(&square()) };
            for (at, byte) in changes {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            // Half of them whole.
            bytes.truncate(bytes.len().min(2 * end.index(bytes.len())));
            match read(&bytes, true) {
                Ok(mesh) => {
                    prop_assert!(mesh.triangles.iter().flatten().all(|corner| (*corner as usize) < mesh.positions.len()));
                    prop_assert!(mesh.normals.is_empty() || mesh.normals.len() == mesh.positions.len());
                    prop_assert!(mesh.texture.is_empty() || mesh.texture.len() == mesh.positions.len());
                }
                Err(why) => prop_assert_eq!(why.lines().count(), 1, "{}", why),
            }
        }
    }
}
