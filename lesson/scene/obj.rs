//! Wavefront OBJ: corners, normals and faces; what it says of materials is for its own renderers.
//!
//! Read here, not by `tobj` (4.0.5): that one panics on `f 1//-9223372036854775807` in a build that checks and reads
//! another normal in one that does not, cannot tell the line of a mistake, and keeps a hundred bytes for a face of four.

use super::meshes::{coordinate, split};
use light::scene::Mesh;
use std::collections::HashMap;

/// Statements that are no surface, or say how it looks.
const OTHERS: [&str; 16] = [
    "vp",
    "o",
    "g",
    "s",
    "mg",
    "l",
    "p",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "lod",
    "bevel",
    "c_interp",
    "d_interp",
    "shadow_obj",
];

/// Reads a file, and its places on an image if they are wanted. It takes at most sixty times its size in memory.
pub fn read(bytes: &[u8], is_patterned: bool) -> Result<Mesh, String> {
    let text =
        std::str::from_utf8(bytes).map_err(|error| format!("is no text from byte {} on", error.valid_up_to()))?;
    let mut reading = Reading { is_patterned, ..Reading::default() };
    let (mut statement, mut began) = (String::new(), 0);
    for (at, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim_end();
        if statement.is_empty() {
            began = at + 1;
        }
        // A backslash at the end goes on in the next line.
        match line.strip_suffix('\\') {
            Some(part) => statement.extend([part, " "]),
            None if statement.is_empty() => reading.take(line).map_err(|why| format!("line {began}: {why}"))?,
            None => {
                statement.push_str(line);
                reading.take(&statement).map_err(|why| format!("line {began}: {why}"))?;
                statement.clear();
            }
        }
    }
    reading.take(&statement).map_err(|why| format!("line {began}: {why}"))?;
    reading.finish()
}

#[derive(Default)]
struct Reading {
    positions: Vec<[f32; 3]>,
    directions: Vec<[f32; 3]>,
    /// Places on an image, if they are wanted.
    is_patterned: bool,
    places: Vec<[f32; 2]>,
    /// Corners of triangles: position and, if it is said, normal.
    triangles: Vec<[u32; 3]>,
    /// The normals of these corners, as long as all have one.
    normals: Option<Vec<[u32; 3]>>,
    /// Their places on an image, likewise.
    drawn: Option<Vec<[u32; 3]>>,
    /// What one face needs, kept for the next.
    corners: Vec<u32>,
    theirs: Vec<u32>,
    here: Vec<u32>,
}

impl Reading {
    /// Takes one statement.
    fn take(&mut self, statement: &str) -> Result<(), String> {
        let mut words = statement.split_whitespace();
        match words.next() {
            None => Ok(()),
            Some("v") => triple(words).map(|position| self.positions.push(position)),
            Some("vn") => triple(words).map(|direction| self.directions.push(direction)),
            Some("vt") if self.is_patterned => {
                let [s, t] = numbers(words, "needs two numbers")?;
                self.places.push([s, t]);
                Ok(())
            }
            Some("vt") => Ok(()),
            Some("f") => self.face(words),
            Some(word) if OTHERS.contains(&word) => Ok(()),
            Some(word) => {
                let word = chapters::parameter::excerpt(word);
                Err(format!(
                    "`{word}` cannot be read; valid: v, vn, vt, f, and what is no surface: {}",
                    OTHERS.join(", ")
                ))
            }
        }
    }

    fn face<'w>(&mut self, words: impl Iterator<Item = &'w str>) -> Result<(), String> {
        self.corners.clear();
        self.theirs.clear();
        self.here.clear();
        for word in words {
            let mut parts = word.split('/');
            let position = parts.next().unwrap_or_default();
            let place = parts.next().filter(|place| !place.is_empty());
            let normal = parts.next().filter(|normal| !normal.is_empty());
            self.corners.push(index(position, self.positions.len(), "corner")?);
            if let Some(place) = place.filter(|_| self.is_patterned) {
                self.here.push(index(place, self.places.len(), "place on an image")?);
            }
            if let Some(normal) = normal {
                self.theirs.push(index(normal, self.directions.len(), "normal")?);
            }
        }
        if self.corners.len() < 3 {
            return Err(format!("a face of {} corners; valid: at least 3", self.corners.len()));
        }
        if self.triangles.is_empty() {
            (self.normals, self.drawn) = (Some(Vec::new()), Some(Vec::new()));
        }
        split(&self.corners, &mut self.triangles);
        match &mut self.normals {
            Some(normals) if self.theirs.len() == self.corners.len() => split(&self.theirs, normals),
            _ => self.normals = None,
        }
        match &mut self.drawn {
            Some(drawn) if self.here.len() == self.corners.len() => split(&self.here, drawn),
            _ => self.drawn = None,
        }
        Ok(())
    }

    /// The mesh. A corner that has several normals, or lies at several places on an image, is several corners.
    fn finish(self) -> Result<Mesh, String> {
        let Self { positions, directions, places, triangles, normals, drawn, .. } = self;
        if triangles.is_empty() {
            return Err("has no faces".into());
        }
        if normals.is_none() && drawn.is_none() {
            return Ok(Mesh { positions, triangles, ..Mesh::default() });
        }
        let mut mesh = Mesh::default();
        let mut corners = HashMap::new();
        for (at, triangle) in triangles.iter().enumerate() {
            let corner = |k: usize| {
                let of = |all: &Option<Vec<[u32; 3]>>| all.as_ref().map(|all| all[at][k]);
                let (normal, place) = (of(&normals), of(&drawn));
                *corners.entry((triangle[k], normal, place)).or_insert_with(|| {
                    mesh.positions.push(positions[triangle[k] as usize]);
                    mesh.normals.extend(normal.map(|normal| directions[normal as usize]));
                    mesh.texture.extend(place.map(|place| places[place as usize]));
                    (mesh.positions.len() - 1) as u32
                })
            };
            let triangle = [0, 1, 2].map(corner);
            mesh.triangles.push(triangle);
        }
        Ok(mesh)
    }
}

/// The first three of some numbers; a weight or a colour may follow.
fn triple<'w>(words: impl Iterator<Item = &'w str>) -> Result<[f32; 3], String> {
    numbers(words, "needs three numbers")
}

fn numbers<'w, const K: usize>(mut words: impl Iterator<Item = &'w str>, needs: &str) -> Result<[f32; K], String> {
    let mut found = [0.0; K];
    for number in &mut found {
        let word = words.next().ok_or(needs)?;
        let read = word.parse().ok().and_then(coordinate);
        *number = read.ok_or_else(|| format!("`{}` is no number", chapters::parameter::excerpt(word)))?;
    }
    Ok(found)
}

/// What a face calls 1 is the first; −1 is the last so far.
fn index(word: &str, count: usize, what: &str) -> Result<u32, String> {
    let found = word.parse::<i64>().ok().and_then(|number| match number {
        1.. => usize::try_from(number - 1).ok(),
        _ => usize::try_from(number.checked_add_unsigned(count as u64)?).ok(),
    });
    // 0 is neither.
    let found = found.filter(|found| *found < count).and_then(|found| u32::try_from(found).ok());
    found
        .ok_or_else(|| format!("there is no {what} `{}`; there are {count} so far", chapters::parameter::excerpt(word)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SQUARE: &str = "v 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n";

    fn mesh(faces: &str) -> Mesh {
        read(format!("{SQUARE}{faces}").as_bytes(), false).unwrap()
    }

    #[test]
    fn faces_are_split_and_counted_from_either_end() {
        let split = [[0, 1, 2], [0, 2, 3]];
        for faces in ["f 1 2 3 4", "f -4 -3 -2 -1", "f 1/7 2/8/ 3// 4", "vt 0 0\r\nf 1 \\\r\n 2 3\\\n4 # all\r\n"] {
            assert_eq!(mesh(faces).triangles, split, "{faces}");
        }
        // Corners that come later are none yet.
        assert!(read(b"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0", false).is_err());
    }

    #[test]
    fn a_corner_with_two_normals_is_two() {
        let mesh = self::mesh("vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4/9/-1");
        assert_eq!((mesh.positions.len(), mesh.triangles), (5, vec![[0, 1, 2], [3, 2, 4]]));
        assert_eq!(mesh.normals[3], [0.0, 1.0, 0.0]);
        assert_eq!(mesh.positions[3], [0.0; 3]);
        // Unless all have one, none has.
        for faces in
            ["vn 0 0 1\nf 1//1 2 3", "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 2 4", "vn 0 0 1\nf 1 2 4\nf 1//1 2//1 3//1"]
        {
            assert_eq!(self::mesh(faces).normals.len(), 0, "{faces}");
        }
    }

    #[test]
    fn places_on_an_image_are_read_where_they_are_wanted() {
        let faces = "vt 0 0\nvt 1 0 0\nvt 0.5 1\nf 1/1 2/2 3/3\nf 1/-1 3/3 4/2\n";
        let read = |is_patterned| read(format!("{SQUARE}{faces}").as_bytes(), is_patterned).unwrap();
        assert_eq!((read(false).texture.len(), read(false).positions.len()), (0, 4));
        let mesh = read(true);
        assert_eq!(mesh.triangles, [[0, 1, 2], [3, 2, 4]]);
        assert_eq!(mesh.texture, [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0], [0.5, 1.0], [1.0, 0.0]]);
        assert_eq!(mesh.positions[3], mesh.positions[0]);
        // Unless all have one, none has; and none is there that was not said.
        let other = |faces: &str| self::read(format!("{SQUARE}{faces}").as_bytes(), true);
        assert!(other("vt 0 0\nf 1/1 2/1 3/1\nf 1 3 4").unwrap().texture.is_empty());
        assert!(other("vt 0 0\nf 1/2 2/1 3/1").unwrap_err().contains("line 6: there is no place on an image `2`"));
        assert!(other("vt 0\n").unwrap_err().contains("needs two numbers"));
    }

    #[test]
    fn what_is_wrong_is_refused_with_its_line() {
        for (faces, why) in [
            ("f 1 2 5", "line 5: there is no corner `5`; there are 4 so far"),
            ("f 1 2 0", "there is no corner `0`"),
            ("f 1 2 -5", "there is no corner `-5`"),
            ("f 1 2 x", "there is no corner `x`"),
            ("f 1//1 2//1 3//1", "there is no normal `1`; there are 0"),
            ("vn 0 0 1\nf 1//-9223372036854775808 2//1 3//1", "line 6: there is no normal"),
            ("f 1 2 99999999999999999999", "there is no corner"),
            ("f 1 2", "a face of 2 corners; valid: at least 3"),
            ("v 1 2", "needs three numbers"),
            ("v 1 2 nan", "`nan` is no number"),
            ("v 1 2 1e39", "`1e39` is no number"),
            ("\n\ncurv 0 1 1 2", "line 7: `curv` cannot be read"),
            ("", "has no faces"),
        ] {
            let refused = read(format!("{SQUARE}{faces}").as_bytes(), false).unwrap_err();
            assert!(refused.contains(why), "{faces} should say `{why}`: {refused}");
        }
        assert!(read(b"v \xff", false).unwrap_err().contains("byte 2"));
    }

    proptest! {
        /// Whatever stands in the file, it is a mesh whose corners are there, or a refusal.
        #[test]
        fn nothing_in_a_file_breaks_the_reader(text in "([vntf#\\\\ /\n0-9.e-]{0,8}|v 0 1 2\n|vn 0 0 1\n|vt 0 1\n|f 1/1 2/1 3/1\n|f 1//1 2//1 -1//1\n|f 1 2 3\n){0,24}") {
            if let Ok(mesh) = read(text.as_bytes(), true) {
                prop_assert!(mesh.triangles.iter().flatten().all(|corner| (*corner as usize) < mesh.positions.len()));
                prop_assert!(mesh.normals.is_empty() || mesh.normals.len() == mesh.positions.len());
                prop_assert!(mesh.texture.is_empty() || mesh.texture.len() == mesh.positions.len());
            }
        }

        /// What is written by others is what is read.
        #[test]
        fn numbers_and_faces_survive(positions in prop::collection::vec(prop::array::uniform3(-1e30f32..1e30), 3..20), picks in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 1..20)) {
            let triangles: Vec<[u32; 3]> = picks.iter().map(|pick| pick.map(|one| one.index(positions.len()) as u32)).collect();
            let mut text = String::new();
            positions.iter().for_each(|[x, y, z]| text += &format!("v {x:e} {y} {z:?}\n"));
            triangles.iter().for_each(|triangle| text += &format!("f {} {} {}\n", triangle[0] + 1, triangle[1] + 1, triangle[2] + 1));
            prop_assert_eq!(read(text.as_bytes(), true).unwrap(), Mesh { positions, triangles, ..Mesh::default() });
        }
    }
}
