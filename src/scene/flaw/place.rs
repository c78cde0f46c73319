//! Where something stands in a scene.

use std::fmt;

/// The way to a key from the outside in; shown as `materials.white.reflectance[1]`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place(Vec<Part>);

/// One step of the way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// To what a key names.
    Key(String),
    /// To one of a list, the first being 0.
    At(usize),
}

impl Place {
    /// The steps from the outside in.
    pub fn parts(&self) -> &[Part] {
        &self.0
    }

    /// The same place as a part of something sees it.
    pub fn within(mut self, part: impl Into<Part>) -> Self {
        self.0.insert(0, part.into());
        self
    }

    /// A place inside this one.
    pub fn then(mut self, part: impl Into<Part>) -> Self {
        self.0.push(part.into());
        self
    }
}

impl From<&str> for Part {
    fn from(key: &str) -> Self {
        Self::Key(key.to_owned())
    }
}

impl From<usize> for Part {
    fn from(at: usize) -> Self {
        Self::At(at)
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (at, part) in self.0.iter().enumerate() {
            match part {
                Part::At(index) => write!(f, "[{index}]")?,
                Part::Key(key) => {
                    f.write_str(if at == 0 { "" } else { "." })?;
                    let is_bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
                    match !key.is_empty() && key.chars().all(is_bare) {
                        true => f.write_str(key)?,
                        false => write!(f, "{key:?}")?,
                    }
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_written_as_one_would_type_it() {
        let place = |parts: [Part; 3]| parts.into_iter().fold(Place::default(), Place::then).to_string();
        assert_eq!(place(["materials".into(), "white".into(), "ior".into()]), "materials.white.ior");
        assert_eq!(place(["shapes".into(), 3.into(), "radius".into()]), "shapes[3].radius");
        assert_eq!(place(["materials".into(), "a.b [1]".into(), 2.into()]), "materials.\"a.b [1]\"[2]");
        assert_eq!(Place::default().then(1).within("up").to_string(), "up[1]");
    }
}
