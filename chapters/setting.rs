//! The parameters of a step and the values in force: what `--set name=value` changes.

use light::Complex64;
use light::media::{self, Medium, Substance};
use light::waves::{self, Wave};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt;

/// Why an input cannot be used: where, and what would be valid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The parameter, field or address.
    pub place: String,
    /// What is wrong with it and the valid range.
    pub message: String,
    /// Set if a name is not known.
    pub unknown: Option<Unknown>,
}

/// A name that is not known where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// The name as it was given.
    pub word: String,
    /// The names known there.
    pub names: Vec<&'static str>,
}

impl Fault {
    /// A fault at `place`.
    pub fn new(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self { place: place.into(), message: message.into(), unknown: None }
    }

    /// A fault at `place`: `word` is none of the `names` known there.
    pub fn unknown(
        place: impl Into<String>,
        word: impl Into<String>,
        message: impl Into<String>,
        names: Vec<&'static str>,
    ) -> Self {
        Self { unknown: Some(Unknown { word: excerpt(&word.into()), names }), ..Self::new(place, message) }
    }

    /// The end of the message: which names there are, if one was not known.
    pub fn choice(&self) -> String {
        match &self.unknown {
            None => String::new(),
            Some(unknown) if unknown.names.is_empty() => ". There are none".into(),
            Some(unknown) => format!(". Known: {}", unknown.names.join(", ")),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}{}", self.place, self.message, self.choice())
    }
}

impl std::error::Error for Fault {}

/// Something that `--set` may change.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The word before `=`.
    pub name: &'static str,
    /// Symbol, in the label markup of [`crate::figure`].
    pub symbol: &'static str,
    /// What it is.
    pub says: &'static str,
    /// Its value if nothing is set, written as on the command line.
    pub default: &'static str,
    /// What it may be.
    pub kind: Kind,
}

/// What a parameter may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A finite number within `min ..= max` (in `unit`, SI; suffixes such as `deg`, `nm`, `GHz` convert to it).
    Number {
        /// Smallest value.
        min: f64,
        /// Largest value.
        max: f64,
        /// SI unit: `rad`, `m`, `Hz`, `1`.
        unit: &'static str,
    },
    /// A whole number within `min ..= max` [1].
    Count {
        /// Smallest value.
        min: u32,
        /// Largest value.
        max: u32,
    },
    /// A refractive index: a number, `n+ki`, or a material by name, evaluated at the step's `wavelength`.
    Medium,
    /// A medium that does not absorb.
    ClearMedium,
    /// A medium that may conduct, at any frequency: `ε_r/μ_r/σ` with σ in S/m (`80/1/4`), or one by name.
    Conductor,
}

/// A value in force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// In SI.
    Number(f64),
    /// A medium.
    Medium(Medium),
    /// A medium that may conduct.
    Conductor(Conductor),
}

/// What a wave of any frequency runs in.
#[derive(Clone, Copy, Debug)]
pub enum Conductor {
    /// The same ε, μ and σ at every frequency.
    Constant(waves::Medium),
    /// A measured one.
    Substance(&'static Substance),
}

impl Conductor {
    /// The wave of a `frequency` [Hz] in it; refused where a substance was not measured.
    pub fn wave(&self, frequency: f64) -> Result<Wave, String> {
        match self {
            Self::Constant(medium) => Wave::new(medium, TAU * frequency).map_err(|invalid| invalid.to_string()),
            Self::Substance(substance) => substance.wave(frequency).map_err(|out| out.to_string()),
        }
    }

    /// σ/(ωε) [1] at a `frequency` [Hz]; `None` where a substance is known by its refractive index instead.
    pub fn loss_tangent(&self, frequency: f64) -> Option<f64> {
        let medium = match self {
            Self::Constant(medium) => *medium,
            Self::Substance(substance) => substance.medium(frequency).ok()?,
        };
        Some(medium.loss_tangent(TAU * frequency))
    }
}

impl PartialEq for Conductor {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Constant(one), Self::Constant(other)) => one == other,
            (Self::Substance(one), Self::Substance(other)) => one.name == other.name,
            _ => false,
        }
    }
}

/// The vacuum wavelength [m] used where a step names none: the middle of the visible.
pub const DEFAULT_WAVELENGTH: f64 = 550e-9;

/// The values in force for one step.
#[derive(Clone, Debug)]
pub struct Setting {
    entries: Vec<(Parameter, String, Value)>,
}

impl Setting {
    /// The defaults of `parameters`.
    ///
    /// # Panics
    /// If a default is not valid; the tests build every step's setting.
    pub fn defaults(parameters: &[Parameter]) -> Self {
        let entries = parameters.iter().map(|parameter| {
            let value = parameter.parse(parameter.default).unwrap_or_else(|fault| panic!("default {fault}"));
            (*parameter, parameter.default.to_owned(), value)
        });
        let setting = Self { entries: entries.collect() };
        setting.validate().unwrap_or_else(|fault| panic!("default {fault}"));
        setting
    }

    /// With every `(name, text)` applied; names that the step lacks are faults.
    pub fn with(mut self, changes: &[(String, String)]) -> Result<Self, Fault> {
        for (name, text) in changes {
            let known = self.entries.iter().map(|entry| entry.0.name).collect();
            let entry = self.entries.iter_mut().find(|entry| entry.0.name == name);
            let entry = entry.ok_or_else(|| Fault::unknown(name, name, "no such parameter here", known))?;
            (entry.1, entry.2) = (text.clone(), entry.0.parse(text)?);
        }
        self.validate()?;
        Ok(self)
    }

    /// Every medium must have an index at the wavelength or be known at the frequency, and be clear where it has to be;
    /// a time step that blows up must be asked for.
    fn validate(&self) -> Result<(), Fault> {
        let wavelength = self.wavelength();
        for (parameter, text, value) in &self.entries {
            if let Value::Conductor(conductor) = value {
                conductor.wave(self.frequency()).map_err(|out| Fault::new(parameter.name, out))?;
            }
            let Value::Medium(medium) = value else { continue };
            let index = medium.index(wavelength).map_err(|out| Fault::new(parameter.name, out.to_string()))?;
            if parameter.kind == Kind::ClearMedium && index.im != 0.0 {
                return Err(Fault::new(
                    parameter.name,
                    format!("{text} absorbs (k = {:.3}); this side needs a medium with k = 0", index.im),
                ));
            }
        }
        match (self.find("courant"), self.find("unstable")) {
            (Some(Value::Number(courant)), Some(Value::Number(0.0))) if courant > 1.0 => Err(Fault::new(
                "courant",
                format!(
                    "{courant} is beyond the Courant limit of 1 and would blow up; `--unstable` takes it all the same"
                ),
            )),
            _ => Ok(()),
        }
    }

    /// The vacuum wavelength [m]: the parameter `wavelength`, or the default.
    pub fn wavelength(&self) -> f64 {
        match self.find("wavelength") {
            Some(Value::Number(metres)) => metres,
            _ => DEFAULT_WAVELENGTH,
        }
    }

    /// The number named `name`, in SI.
    ///
    /// # Panics
    /// If the step has no such number: a mistake in the chapter, not in its use.
    pub fn number(&self, name: &str) -> f64 {
        match self.find(name) {
            Some(Value::Number(value)) => value,
            _ => panic!("the step declares no number `{name}`"),
        }
    }

    /// The medium named `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn medium(&self, name: &str) -> Medium {
        match self.find(name) {
            Some(Value::Medium(medium)) => medium,
            _ => panic!("the step declares no medium `{name}`"),
        }
    }

    /// The frequency [Hz]: the parameter `freq`, or a gigahertz.
    pub fn frequency(&self) -> f64 {
        match self.find(FREQUENCY.name) {
            Some(Value::Number(hertz)) => hertz,
            _ => 1e9,
        }
    }

    /// The medium named `name`, which may conduct.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn conductor(&self, name: &str) -> Conductor {
        match self.find(name) {
            Some(Value::Conductor(conductor)) => conductor,
            _ => panic!("the step declares no conductor `{name}`"),
        }
    }

    /// The text in force of the parameter `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn text(&self, name: &str) -> &str {
        let entry = self.entries.iter().find(|entry| entry.0.name == name);
        &entry.unwrap_or_else(|| panic!("the step declares no `{name}`")).1
    }

    /// The complex index [1] of the medium named `name` at the setting's wavelength.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn index(&self, name: &str) -> Complex64 {
        self.medium(name).index(self.wavelength()).expect("validated when it was set")
    }

    /// Parameters with the text and value in force, in the step's order.
    pub fn entries(&self) -> impl Iterator<Item = (&Parameter, &str, &Value)> {
        self.entries.iter().map(|(parameter, text, value)| (parameter, text.as_str(), value))
    }

    fn find(&self, name: &str) -> Option<Value> {
        self.entries.iter().find(|entry| entry.0.name == name).map(|entry| entry.2)
    }
}

impl Parameter {
    /// The value that `text` stands for.
    pub fn parse(&self, text: &str) -> Result<Value, Fault> {
        let fault = |message: String| Fault::new(self.name, message);
        match self.kind {
            Kind::Number { min, max, unit } => {
                let value =
                    parse_quantity(text, unit).map_err(|reason| fault(format!("{reason}; {}", self.domain())))?;
                if (min..=max).contains(&value) {
                    return Ok(Value::Number(value));
                }
                Err(fault(format!("{} is out of range; {}{}", excerpt(text), self.domain_for(text), self.meant(text))))
            }
            Kind::Count { min, max } => match text.trim().parse() {
                Ok(count) if (min..=max).contains(&count) => Ok(Value::Number(f64::from(count))),
                _ => Err(fault(format!("`{}` is not a whole number in range; {}", excerpt(text), self.domain()))),
            },
            Kind::Medium | Kind::ClearMedium => parse_medium(self.name, text).map(Value::Medium),
            Kind::Conductor => parse_conductor(self.name, text).map(Value::Conductor),
        }
    }

    /// A number out of range without a unit may lack the one that the default has.
    fn meant(&self, text: &str) -> String {
        let Kind::Number { unit, .. } = self.kind else { return String::new() };
        let (Some((suffix, _)), None) = (suffix(self.default, unit), suffix(text, unit)) else { return String::new() };
        let meant = format!("{}{suffix}", text.trim());
        self.parse(&meant).map_or(String::new(), |_| format!(" (did you mean `{meant}`?)"))
    }

    /// The valid values in words, in the unit of the default.
    pub fn domain(&self) -> String {
        self.domain_for(self.default)
    }

    /// The valid values in words, in the unit of `text` or else of the default.
    fn domain_for(&self, text: &str) -> String {
        match self.kind {
            Kind::Number { min, max, unit } => {
                range(min, max, unit, if suffix(text, unit).is_some() { text } else { self.default })
            }
            Kind::Count { min, max } => format!("valid: {min} to {max}"),
            Kind::Medium => "valid: an index such as 1.5 or 0.2+3.4i, or a material by name".into(),
            Kind::ClearMedium => "valid: a real index such as 1.5, or a clear material by name".into(),
            Kind::Conductor => CONDUCTOR_DOMAIN.into(),
        }
    }
}

/// The range `min ..= max` [`unit`] in words, in the unit that `text` carries, if any.
pub fn range(min: f64, max: f64, unit: &str, text: &str) -> String {
    let (suffix, factor) = suffix(text, unit).unwrap_or(("", 1.0));
    format!("valid: {}{suffix} to {}{suffix}", number(min / factor), number(max / factor))
}

/// `x` as one would type it, without the last digits that unit conversion leaves behind.
pub fn number(x: f64) -> String {
    let x: f64 = format!("{x:.9e}").parse().expect("a number just printed");
    if x == 0.0 || (1e-4..1e6).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}

/// The parameter every optics step shares: the vacuum wavelength.
pub const WAVELENGTH: Parameter = Parameter {
    name: "wavelength",
    symbol: "λ",
    says: "vacuum wavelength",
    default: "550nm",
    kind: Kind::Number { min: 1e-9, max: 1e-3, unit: "m" },
};

/// The medium of a wave of any frequency.
pub const MEDIUM: Parameter = Parameter {
    name: "medium",
    symbol: "ε_r/μ_r/σ",
    says: "the medium, by name or as ε_r/μ_r/σ with σ in S/m",
    default: "copper",
    kind: Kind::Conductor,
};

/// The frequency of a wave.
pub const FREQUENCY: Parameter = Parameter {
    name: "freq",
    symbol: "f",
    says: "frequency",
    default: "1GHz",
    kind: Kind::Number { min: 1e-3, max: 1e16, unit: "Hz" },
};

/// The angle of incidence, measured from the normal.
pub const THETA: Parameter = Parameter {
    name: "theta",
    symbol: "θ_1",
    says: "angle of incidence, from the normal",
    default: "45deg",
    kind: Kind::Number { min: 0.0, max: FRAC_PI_2, unit: "rad" },
};

/// Reads a finite number with an optional unit suffix, converted to `unit`.
pub fn parse_quantity(text: &str, unit: &str) -> Result<f64, String> {
    let text = text.trim();
    let (suffix, factor) = suffix(text, unit).unwrap_or(("", 1.0));
    let digits = &text[..text.len() - suffix.len()];
    let value: f64 = digits.trim_end().parse().map_err(|_| format!("`{}` is not a number", excerpt(text)))?;
    let value = if factor == DEGREE { value.to_radians() } else { value * factor };
    if !value.is_finite() {
        return Err(format!("`{}` is not a finite number", excerpt(text)));
    }
    Ok(value)
}

/// The suffix that a quantity in `unit` carries, with its size in it.
fn suffix(text: &str, unit: &str) -> Option<(&'static str, f64)> {
    let text = text.trim();
    let number =
        |suffix: &str| text.strip_suffix(suffix).is_some_and(|digits| digits.trim_end().parse::<f64>().is_ok());
    suffixes(unit).iter().copied().find(|(suffix, _)| number(suffix))
}

const DEGREE: f64 = PI / 180.0;

/// Suffixes that are understood for a unit, with their size in it.
fn suffixes(unit: &str) -> &'static [(&'static str, f64)] {
    match unit {
        "rad" => &[("deg", DEGREE), ("°", DEGREE), ("rad", 1.0)],
        "m" => &[("nm", 1e-9), ("um", 1e-6), ("µm", 1e-6), ("μm", 1e-6), ("mm", 1e-3), ("km", 1e3), ("m", 1.0)],
        "Hz" => &[("PHz", 1e15), ("THz", 1e12), ("GHz", 1e9), ("MHz", 1e6), ("kHz", 1e3), ("mHz", 1e-3), ("Hz", 1.0)],
        "Ω" => &[("kΩ", 1e3), ("mΩ", 1e-3), ("Ω", 1.0), ("kohm", 1e3), ("ohm", 1.0)],
        "s" => &[("fs", 1e-15), ("ps", 1e-12), ("ns", 1e-9), ("us", 1e-6), ("ms", 1e-3), ("s", 1.0)],
        _ => &[],
    }
}

/// Reads `1.5`, `0.2+3.4i` or a material's name.
///
/// # Errors
/// A fault at `place`, which names the materials there are if `text` is neither an index nor one of them.
pub fn parse_medium(place: &str, text: &str) -> Result<Medium, Fault> {
    let text = text.trim();
    let known = media::named(text);
    if let Some(found) = known.filter(|known| known.optics.is_some()) {
        return Ok(Medium::Named(found));
    }
    let index = parse_index(text).ok_or_else(|| {
        let names = media::optical().map(|known| known.name).collect();
        let message = match known {
            Some(known) => format!("the refractive index of {} is not known here", known.name),
            None => format!("`{}` is neither an index (1.5, 0.2+3.4i) nor a material", excerpt(text)),
        };
        Fault::unknown(place, text, message, names)
    })?;
    if !(index.re.is_finite() && index.im.is_finite()) {
        return Err(Fault::new(place, format!("`{}` is not a finite index; {INDEX_DOMAIN}", excerpt(text))));
    }
    if !(INDEX_MIN..=INDEX_MAX).contains(&index.re) || !(0.0..=INDEX_MAX).contains(&index.im) {
        return Err(Fault::new(place, format!("{} is out of range; {INDEX_DOMAIN}", excerpt(text))));
    }
    Ok(Medium::Constant(index))
}

/// Reads `ε_r/μ_r/σ` (σ in S/m) or a substance's name.
///
/// # Errors
/// A fault at `place`, which says what would be valid.
pub fn parse_conductor(place: &str, text: &str) -> Result<Conductor, Fault> {
    let text = text.trim();
    let known = media::named(text);
    if let Some(found) = known.filter(|known| known.electric.is_some()) {
        return Ok(Conductor::Substance(found));
    }
    let numbers: Option<Vec<f64>> = text.split('/').map(|part| part.trim().parse().ok()).collect();
    let Some(&[epsilon_r, mu_r, sigma]) = numbers.as_deref() else {
        let names = media::electric().map(|known| known.name).collect();
        let message = match known {
            Some(known) => format!("ε, μ, σ of {} are not known here", known.name),
            None => format!("`{}` is neither ε_r/μ_r/σ (80/1/4) nor a medium", excerpt(text)),
        };
        return Err(Fault::unknown(place, text, message, names));
    };
    let held = |value: f64, (min, max): (f64, f64)| (min..=max).contains(&value);
    if !(held(epsilon_r, RELATIVE) && held(mu_r, RELATIVE) && held(sigma, CONDUCTIVITY)) {
        return Err(Fault::new(place, format!("{} is out of range; {CONDUCTOR_DOMAIN}", excerpt(text))));
    }
    let medium = waves::Medium::relative(epsilon_r, mu_r, sigma);
    medium.map(Conductor::Constant).map_err(|invalid| Fault::new(place, invalid.to_string()))
}

/// Relative permittivities and permeabilities taken [1].
pub const RELATIVE: (f64, f64) = (1e-9, 1e9);
/// Conductivities taken [S/m].
pub const CONDUCTIVITY: (f64, f64) = (0.0, 1e30);
const CONDUCTOR_DOMAIN: &str =
    "valid: ε_r/μ_r/σ such as 80/1/4, with ε_r and μ_r from 1e-9 to 1e9 and σ from 0 to 1e30 S/m, or a medium by name";

/// Smallest real part of an index taken [1].
pub const INDEX_MIN: f64 = 1e-9;
/// Largest part of an index taken [1].
pub const INDEX_MAX: f64 = 1e9;
const INDEX_DOMAIN: &str = "valid: n from 1e-9 to 1e9, k from 0 to 1e9";

fn parse_index(text: &str) -> Option<Complex64> {
    if let Ok(n) = text.parse::<f64>() {
        return Some(Complex64::new(n, 0.0));
    }
    let body = text.strip_suffix('i')?;
    // The sign between the parts is the last one that does not belong to an exponent.
    let (split, _) = body
        .char_indices()
        .rev()
        .find(|&(at, sign)| at > 0 && matches!(sign, '+' | '-') && !body[..at].ends_with(['e', 'E']))?;
    let (re, im) = (body[..split].trim().parse().ok()?, body[split..].replace(' ', "").parse().ok()?);
    Some(Complex64::new(re, im))
}

/// At most 40 characters of `text`, so that no message repeats a megabyte.
pub fn excerpt(text: &str) -> String {
    let mut short: String = text.chars().take(40).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_take_suffixes_and_refuse_the_rest() {
        assert_eq!(parse_quantity("90deg", "rad"), Ok(FRAC_PI_2));
        assert_eq!(parse_quantity("0.5", "rad"), Ok(0.5));
        assert!((parse_quantity("550nm", "m").unwrap() - 550e-9).abs() < 1e-22);
        for bad in ["", "deg", "1e400", "nan", "inf", "5 furlongs", "550nm nm"] {
            assert!(parse_quantity(bad, "m").is_err(), "{bad}");
        }
    }

    #[test]
    fn ranges_are_told_in_the_unit_given() {
        let says = |parameter: Parameter, text: &str| parameter.parse(text).unwrap_err().message;
        assert_eq!(says(THETA, "95deg"), "95deg is out of range; valid: 0deg to 90deg");
        assert_eq!(says(WAVELENGTH, "550"), "550 is out of range; valid: 1nm to 1e6nm (did you mean `550nm`?)");
        assert_eq!(says(WAVELENGTH, "5mm"), "5mm is out of range; valid: 1e-6mm to 1mm");
        assert_eq!(range(1e-9, 1e9, "1", "x"), "valid: 1e-9 to 1e9");
    }

    #[test]
    fn counts_are_whole() {
        let pairs = Parameter { default: "3", kind: Kind::Count { min: 1, max: 9 }, ..THETA };
        assert_eq!(Setting::defaults(&[pairs]).number(pairs.name), 3.0);
        assert_eq!(pairs.parse("9"), Ok(Value::Number(9.0)));
        for bad in ["0", "10", "2.5", "-1", "1e400", "three", ""] {
            assert!(pairs.parse(bad).unwrap_err().message.ends_with("valid: 1 to 9"), "{bad}");
        }
    }

    #[test]
    fn indices_are_numbers_or_pairs() {
        assert_eq!(parse_index("1.5"), Some(Complex64::new(1.5, 0.0)));
        assert_eq!(parse_index("0.2+3.4i"), Some(Complex64::new(0.2, 3.4)));
        assert_eq!(parse_index("1e-3+2e-4i"), Some(Complex64::new(1e-3, 2e-4)));
        assert_eq!(parse_index("1-2i"), Some(Complex64::new(1.0, -2.0)));
        for bad in ["", "i", "+i", "1.5x", "1e-3i", "1+i+2"] {
            assert_eq!(parse_index(bad), None, "{bad}");
        }
    }

    #[test]
    fn conductors_are_numbers_or_names() {
        let sea = waves::Medium::relative(80.0, 1.0, 4.0).unwrap();
        assert_eq!(parse_conductor("medium", "80 / 1/4"), Ok(Conductor::Constant(sea)));
        let copper = parse_conductor("medium", "Copper").unwrap();
        assert!(copper.wave(1e9).unwrap().skin_depth < 3e-6 && copper.wave(1e13).is_err());
        let bad =
            ["", "80/1", "0/1/1", "-1/1/1", "1/0/1", "1/1/-1", "1/1/nan", "nan/1/0", "1/1/inf", "1/1/1/1", "cooper"];
        for bad in bad {
            let fault = parse_conductor("medium", bad).unwrap_err();
            assert!(fault.place == "medium" && !fault.message.is_empty(), "{bad}");
        }
        assert!(parse_conductor("medium", "1/1/-1").unwrap_err().message.contains("σ from 0"));
    }

    #[test]
    fn frequencies_take_their_units() {
        assert_eq!(parse_quantity("1GHz", "Hz"), Ok(1e9));
        assert_eq!(parse_quantity("50 Hz", "Hz"), Ok(50.0));
        assert_eq!(parse_quantity("2mHz", "Hz"), Ok(2e-3));
        assert_eq!(FREQUENCY.parse("0GHz").unwrap_err().message, "0GHz is out of range; valid: 1e-12GHz to 1e7GHz");
    }

    #[test]
    fn media_outside_the_domain_are_refused() {
        for bad in ["-1.5", "0", "1-2i", "nan", "1e400", "unobtainium"] {
            assert!(parse_medium("n", bad).is_err(), "{bad}");
        }
    }
}
