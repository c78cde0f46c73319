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

/// The English name of a Greek letter, as symbols bear it.
pub(crate) fn greek_name(letter: char) -> Option<&'static str> {
    GREEK.iter().find(|(_, known, _)| *known == letter).map(|(name, ..)| *name)
}

/// Whether `word` is the English name of a Greek letter.
pub(crate) fn is_greek(word: &str) -> bool {
    greek(word).is_some()
}

/// Whether `letters`, as neighbours in a product, would begin with a word that means something else: xi, ln.
pub(crate) fn spells(letters: &str) -> bool {
    GREEK.iter().map(|(name, ..)| *name).chain(WORDS).any(|word| letters.starts_with(word))
}

/// Whether they would end with one.
pub(super) fn ends_in_word(letters: &str) -> bool {
    GREEK.iter().map(|(name, ..)| *name).chain(WORDS).any(|word| letters.ends_with(word))
}

/// Words for functions.
const WORDS: [&str; 17] = [
    "sin", "cos", "tan", "exp", "sqrt", "conj", "abs", "Re", "Im", "cot", "sec", "csc", "cis", "ln", "log", "max",
    "min",
];

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
