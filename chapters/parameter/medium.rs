//! Media as parameters: an index, a conducting medium's three numbers, or a name.

use super::argument::{Argument, shortest};
use super::{Fault, excerpt};
use light::Complex64;
use light::media::{self, Medium, Substance};
use light::waves::{self, Wave};
use std::f64::consts::TAU;
use std::fmt;

/// Smallest real part of an index taken [1].
pub const INDEX_MIN: f64 = 1e-9;
/// Largest part of an index taken [1].
pub const INDEX_MAX: f64 = 1e9;
/// Relative permittivities and permeabilities taken [1].
pub const RELATIVE: (f64, f64) = (1e-9, 1e9);
/// Conductivities taken [S/m].
pub const CONDUCTIVITY: (f64, f64) = (0.0, 1e30);

pub(super) const CONDUCTOR_DOMAIN: &str =
    "valid: ε_r/μ_r/σ such as 80/1/4, with ε_r and μ_r from 1e-9 to 1e9 and σ from 0 to 1e30 S/m, or a medium by name";

/// What a wave of any frequency runs in.
#[derive(Clone, Copy, Debug)]
pub enum Conductor {
    /// The same at every frequency.
    Constant {
        /// ε_r [1].
        epsilon_r: f64,
        /// μ_r [1].
        mu_r: f64,
        /// σ [S/m].
        sigma: f64,
    },
    /// A measured one.
    Substance(&'static Substance),
}

impl Conductor {
    /// ε, μ and σ at a `frequency` [Hz].
    ///
    /// # Errors
    /// Where a substance was not measured, or is known by its refractive index instead.
    pub fn medium(&self, frequency: f64) -> Result<waves::Medium, String> {
        match *self {
            Self::Constant { epsilon_r, mu_r, sigma } => {
                waves::Medium::relative(epsilon_r, mu_r, sigma).map_err(|invalid| invalid.to_string())
            }
            Self::Substance(substance) => substance.medium(frequency).map_err(|out| out.to_string()),
        }
    }

    /// The wave of a `frequency` [Hz] in it.
    ///
    /// # Errors
    /// Where a substance was not measured.
    pub fn wave(&self, frequency: f64) -> Result<Wave, String> {
        match self {
            Self::Constant { .. } => {
                Wave::new(&self.medium(frequency)?, TAU * frequency).map_err(|invalid| invalid.to_string())
            }
            Self::Substance(substance) => substance.wave(frequency).map_err(|out| out.to_string()),
        }
    }

    /// σ/(ωε) [1] at a `frequency` [Hz]; `None` where a substance is known by its refractive index instead.
    pub fn loss_tangent(&self, frequency: f64) -> Option<f64> {
        Some(self.medium(frequency).ok()?.loss_tangent(TAU * frequency))
    }
}

impl PartialEq for Conductor {
    fn eq(&self, other: &Self) -> bool {
        match (*self, *other) {
            (
                Self::Constant { epsilon_r, mu_r, sigma },
                Self::Constant { epsilon_r: epsilon_2, mu_r: mu_2, sigma: sigma_2 },
            ) => (epsilon_r, mu_r, sigma) == (epsilon_2, mu_2, sigma_2),
            (Self::Substance(one), Self::Substance(other)) => one.name == other.name,
            _ => false,
        }
    }
}

/// As it would stand on a command line.
impl fmt::Display for Conductor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Constant { epsilon_r, mu_r, sigma } => {
                let [epsilon_r, mu_r, sigma] = [epsilon_r, mu_r, sigma].map(shortest);
                write!(f, "{epsilon_r}/{mu_r}/{sigma}")
            }
            Self::Substance(substance) => f.write_str(substance.name),
        }
    }
}

/// Which media are taken by their index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Taken {
    /// All.
    All,
    /// All, and zero, whose imaginary part stands apart.
    Parts,
    /// Those that do not absorb.
    Clear,
}

impl Taken {
    /// The valid values in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::All | Self::Parts => {
                "valid: 1e-9 to 1e9, n+ki with k from 0 to 1e9 (n = 0 where k is at least 1e-9), or a material by name"
            }
            Self::Clear => "valid: 1e-9 to 1e9, or a clear material by name",
        }
    }

    /// The materials that may be meant by name. Clear at every wavelength at which they were measured: both ends and
    /// the middle tell, since the sources give clear media no absorption at all. Empty space has no such ends.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        let is_clear = |known: &Substance| {
            known.optics.as_ref().is_some_and(|optics| {
                let (shortest, longest) = optics.range;
                let at = [shortest, (shortest * longest).sqrt(), longest];
                at.iter()
                    .filter(|wavelength| wavelength.is_normal())
                    .all(|wavelength| optics.index(*wavelength).is_some_and(|index| index.im == 0.0))
            })
        };
        media::optical().filter(move |known| self != Self::Clear || is_clear(known)).map(|known| known.name)
    }

    /// Reads an index (a number, a text, or the fields n and k) or a name. Whether a named medium absorbs is judged at
    /// a wavelength, later.
    pub fn read(self, argument: &Argument) -> Result<Medium, Fault> {
        match argument {
            Argument::Number(n) => self.constant(Complex64::new(*n, 0.0), &argument.excerpt()),
            Argument::Text(text) => self.parse(text),
            Argument::Record(fields) => {
                let [n, k] = numbers(fields, ["n", "k"], [None, Some(0.0)], self.words())?;
                self.constant(Complex64::new(n, k), &format!("n = {}, k = {}", shortest(n), shortest(k)))
            }
            _ => Err(Fault::new("", format!("must be a number or the name of a medium; {}", self.words()))),
        }
    }

    fn parse(self, text: &str) -> Result<Medium, Fault> {
        let text = text.trim();
        let known = media::named(text);
        if let Some(found) = known.filter(|known| known.optics.is_some()) {
            return Ok(Medium::Named(found));
        }
        let index = parse_index(text).ok_or_else(|| {
            let message = match known {
                Some(known) => format!("the refractive index of {} is not known here; {}", known.name, self.words()),
                None => format!("`{}` is neither an index nor a material; {}", excerpt(text), self.words()),
            };
            Fault::unknown("", text, message, self.names())
        })?;
        self.constant(index, text)
    }

    fn constant(self, index: Complex64, given: &str) -> Result<Medium, Fault> {
        if !(index.re.is_finite() && index.im.is_finite()) {
            return Err(Fault::new("", format!("`{}` is not a finite index; {}", excerpt(given), self.words())));
        }
        let is_part = |part: f64| (INDEX_MIN..=INDEX_MAX).contains(&part);
        // Without a real part: a metal without loss.
        let is_zero = index == Complex64::ZERO && self == Self::Parts;
        let is_n = is_part(index.re) || is_zero || self != Self::Clear && index.re == 0.0 && is_part(index.im);
        if !(is_n && (0.0..=INDEX_MAX).contains(&index.im)) {
            return Err(Fault::new("", format!("{} is out of range; {}", excerpt(given), self.words())));
        }
        Ok(Medium::Constant(index))
    }
}

/// A medium by ε_r, μ_r and σ: a text, or the fields eps_r, mu_r and sigma.
pub(super) fn read_conductor(argument: &Argument) -> Result<Conductor, Fault> {
    match argument {
        Argument::Text(text) => parse_conductor("", text),
        Argument::Record(fields) => {
            let defaults = [None, Some(1.0), Some(0.0)];
            let numbers = numbers(fields, ["eps_r", "mu_r", "sigma"], defaults, CONDUCTOR_DOMAIN)?;
            conductor(numbers, &numbers.map(shortest).join("/"))
        }
        _ => Err(Fault::new("", format!("must be a text or a record; {CONDUCTOR_DOMAIN}"))),
    }
}

/// The fields called `names`, all numbers; one left out has its default.
fn numbers<const N: usize>(
    fields: &[(String, Argument)],
    names: [&str; N],
    defaults: [Option<f64>; N],
    domain: &str,
) -> Result<[f64; N], Fault> {
    let mut found = [None; N];
    for (name, value) in fields {
        let Some(at) = names.iter().position(|known| known == name) else {
            return Err(Fault::unknown(excerpt(name), name, "no such field", names));
        };
        let Argument::Number(value) = value else {
            return Err(Fault::new(name, format!("must be a number; {domain}")));
        };
        if found[at].replace(*value).is_some() {
            return Err(Fault::new(name, "given twice"));
        }
    }
    let mut numbers = [0.0; N];
    for at in 0..N {
        numbers[at] =
            found[at].or(defaults[at]).ok_or_else(|| Fault::new("", format!("lacks {}; {domain}", names[at])))?;
    }
    Ok(numbers)
}

/// Reads `1.5`, `0.2+3.4i` or a material's name.
///
/// # Errors
/// A fault at `place`, which names the materials there are if `text` is neither an index nor one of them.
pub fn parse_medium(place: &str, text: &str) -> Result<Medium, Fault> {
    Taken::All.parse(text).map_err(|fault| fault.within(place))
}

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

/// A medium as it would stand on a command line, and as a number where it is one.
pub(super) fn write_medium(medium: Medium) -> Argument {
    match medium {
        Medium::Named(known) => known.name.into(),
        Medium::Constant(index) if index.im == 0.0 => index.re.into(),
        Medium::Constant(index) => format!("{}+{}i", shortest(index.re), shortest(index.im)).into(),
    }
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
    let mut parts = text.split('/').map(|part| part.trim().parse::<f64>().ok());
    let numbers = [parts.next().flatten(), parts.next().flatten(), parts.next().flatten()];
    let ([Some(epsilon_r), Some(mu_r), Some(sigma)], None) = (numbers, parts.next()) else {
        let names = media::electric().map(|known| known.name);
        let message = match known {
            Some(known) => format!("ε, μ, σ of {} are not known here", known.name),
            None => format!("`{}` is neither ε_r/μ_r/σ (80/1/4) nor a medium", excerpt(text)),
        };
        return Err(Fault::unknown(place, text, message, names));
    };
    conductor([epsilon_r, mu_r, sigma], text).map_err(|fault| fault.within(place))
}

fn conductor([epsilon_r, mu_r, sigma]: [f64; 3], given: &str) -> Result<Conductor, Fault> {
    let held = |value: f64, (min, max): (f64, f64)| (min..=max).contains(&value);
    if !(held(epsilon_r, RELATIVE) && held(mu_r, RELATIVE) && held(sigma, CONDUCTIVITY)) {
        return Err(Fault::new("", format!("{} is out of range; {CONDUCTOR_DOMAIN}", excerpt(given))));
    }
    Ok(Conductor::Constant { epsilon_r, mu_r, sigma })
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let sea = Conductor::Constant { epsilon_r: 80.0, mu_r: 1.0, sigma: 4.0 };
        assert_eq!(parse_conductor("medium", "80 / 1/4"), Ok(sea));
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
    fn media_outside_the_domain_are_refused() {
        for bad in ["-1.5", "0", "0+0i", "0+1e-10i", "1e-10+2i", "1-2i", "nan", "1e400", "unobtainium"] {
            assert!(parse_medium("n", bad).is_err(), "{bad}");
        }
        assert_eq!(parse_medium("n", "0+2i"), Ok(Medium::Constant(Complex64::new(0.0, 2.0))));
        assert!(Taken::Clear.read(&"0+2i".into()).is_err());
    }

    #[test]
    fn glass_is_clear_and_gold_is_not() {
        let names: Vec<_> = Taken::Clear.names().collect();
        assert!(names.contains(&"bk7") && names.contains(&"vacuum") && !names.contains(&"gold"));
    }
}
