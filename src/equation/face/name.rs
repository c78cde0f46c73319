//! Names of quantities, taken apart for typesetting.

/// A symbol's name: base, index and primes of `E_1'`.
pub(super) struct Name<'a> {
    pub base: &'a str,
    pub index: &'a str,
    pub primes: usize,
}

impl<'a> Name<'a> {
    pub fn parse(name: &'a str) -> Self {
        let bare = name.trim_end_matches('\'');
        let (base, index) = bare.split_once('_').unwrap_or((bare, ""));
        Self { base, index, primes: name.len() - bare.len() }
    }

    /// Whether it is shown as one bare letter.
    pub fn is_letter(&self) -> bool {
        self.index.is_empty() && self.primes == 0 && (self.base.chars().count() == 1 || greek(self.base).is_some())
    }
}

/// The letter and the LaTeX command of a Greek letter's English name.
pub(super) fn greek(name: &str) -> Option<(char, &'static str)> {
    GREEK.iter().find(|(known, ..)| *known == name).map(|(_, letter, command)| (*letter, *command))
}

const GREEK: [(&str, char, &str); 35] = [
    ("alpha", 'α', r"\alpha"),
    ("beta", 'β', r"\beta"),
    ("gamma", 'γ', r"\gamma"),
    ("delta", 'δ', r"\delta"),
    ("epsilon", 'ε', r"\varepsilon"),
    ("zeta", 'ζ', r"\zeta"),
    ("eta", 'η', r"\eta"),
    ("theta", 'θ', r"\theta"),
    ("iota", 'ι', r"\iota"),
    ("kappa", 'κ', r"\kappa"),
    ("lambda", 'λ', r"\lambda"),
    ("mu", 'μ', r"\mu"),
    ("nu", 'ν', r"\nu"),
    ("xi", 'ξ', r"\xi"),
    ("pi", 'π', r"\pi"),
    ("rho", 'ρ', r"\rho"),
    ("sigma", 'σ', r"\sigma"),
    ("tau", 'τ', r"\tau"),
    ("upsilon", 'υ', r"\upsilon"),
    ("phi", 'φ', r"\varphi"),
    ("chi", 'χ', r"\chi"),
    ("psi", 'ψ', r"\psi"),
    ("omega", 'ω', r"\omega"),
    ("Gamma", 'Γ', r"\Gamma"),
    ("Delta", 'Δ', r"\Delta"),
    ("Theta", 'Θ', r"\Theta"),
    ("Lambda", 'Λ', r"\Lambda"),
    ("Xi", 'Ξ', r"\Xi"),
    ("Pi", 'Π', r"\Pi"),
    ("Sigma", 'Σ', r"\Sigma"),
    ("Upsilon", 'Υ', r"\Upsilon"),
    ("Phi", 'Φ', r"\Phi"),
    ("Psi", 'Ψ', r"\Psi"),
    ("Omega", 'Ω', r"\Omega"),
    ("ell", 'ℓ', r"\ell"),
];
