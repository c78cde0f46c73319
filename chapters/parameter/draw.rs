//! Values drawn at random from all that is taken: whatever a parameter admits, the curriculum must stand.

use super::medium::{CONDUCTIVITY, INDEX_MAX, INDEX_MIN, RELATIVE, Taken};
use super::{Argument, Kind, Parameter, Range, Setting};
use light::media;
use yardstick::random::{Stream, uniform};

/// Below this share of the largest value, numbers of a range that begins at zero are drawn no smaller.
const SMALLEST_SHARE: f64 = 1e-20;

impl Kind {
    /// Something that it takes, from anywhere in its domain: ends, neighbours of ends, every order of magnitude, every
    /// name, every way of writing it.
    pub fn draw(&self, dice: &mut Stream) -> Argument {
        match self {
            Self::Number(range) => range.draw(dice).into(),
            Self::Count { min, max } => Range::new(*min as f64, *max as f64, "1").draw(dice).round().into(),
            Self::Choice(words) => (*pick(dice, words)).into(),
            Self::Medium | Self::MediumInParts => medium(Taken::All, dice),
            Self::ClearMedium => medium(Taken::Clear, dice),
            Self::Conductor => conductor(dice),
            Self::Vector(range) => Argument::List((0..3).map(|_| range.draw(dice).into()).collect()),
            Self::List { of, most } => {
                let count = below(dice, most.min(&MANY) + 1);
                Argument::List((0..count).map(|_| of.draw(dice)).collect())
            }
            Self::Record(parameters) => {
                let fields = parameters.iter().filter_map(|field| {
                    let is_given = field.is_required() || below(dice, 2) == 0;
                    is_given.then(|| (field.name, field.kind.draw(dice)))
                });
                Argument::record(fields.collect::<Vec<_>>())
            }
        }
    }
}

/// Lists are drawn no longer than this.
const MANY: usize = 6;

impl Range {
    /// A number of it: even over the range, even over the orders of magnitude from zero or from either end, or an end.
    fn draw(&self, dice: &mut Stream) -> f64 {
        let Self { min, max, .. } = *self;
        if !self.is_bounded() {
            let size = 10_f64.powf(uniform(dice, -300.0, 300.0));
            return if below(dice, 2) == 0 { size } else { -size };
        }
        let value = match below(dice, 8) {
            0 => min,
            1 => max,
            2 | 3 => uniform(dice, min, max),
            4 => max - (max - min) * SMALLEST_SHARE.powf(uniform(dice, 0.0, 1.0)),
            5 => min + (max - min) * SMALLEST_SHARE.powf(uniform(dice, 0.0, 1.0)),
            _ => {
                let low = if min > 0.0 { min } else { max * SMALLEST_SHARE };
                low * (max / low).powf(uniform(dice, 0.0, 1.0))
            }
        };
        value.clamp(min, max)
    }
}

impl Setting {
    /// A setting of `parameters` drawn from all that are taken: each is set or left at its default, and what is refused
    /// beside the others is drawn again.
    ///
    /// # Panics
    /// If a thousand draws are refused: the domains then promise what the owner of the parameters does not keep.
    pub fn draw(parameters: &'static [Parameter], dice: &mut Stream) -> Self {
        let drawn = || {
            let is_set = |parameter: &&Parameter| parameter.default.is_none() || below(dice, 2) == 0;
            let set: Vec<&Parameter> = parameters.iter().filter(is_set).collect();
            let change = |parameter: &&Parameter| (parameter.name.to_owned(), parameter.kind.draw(dice).to_string());
            let changes: Vec<_> = set.iter().map(change).collect();
            Self::defaults(parameters).with(&changes).ok()
        };
        std::iter::repeat_with(drawn).take(1000).flatten().next().expect("domains that go together")
    }
}

/// An index in one of its ways to be written, or a name.
fn medium(taken: Taken, dice: &mut Stream) -> Argument {
    let index = Range::new(INDEX_MIN, INDEX_MAX, "1");
    let names: Vec<&'static str> = taken.names().collect();
    match (below(dice, 4), taken) {
        (0 | 1, _) => (*pick(dice, &names)).into(),
        (2, Taken::All) => {
            let (n, k) = match below(dice, 8) {
                0 => (0.0, index.draw(dice)),
                _ => (index.draw(dice), Range::new(0.0, INDEX_MAX, "1").draw(dice)),
            };
            match below(dice, 2) {
                0 => format!("{n:?}+{k:?}i").into(),
                _ => Argument::record([("n", n.into()), ("k", k.into())]),
            }
        }
        _ => index.draw(dice).into(),
    }
}

/// ε_r, μ_r and σ in one of their ways to be written, or a name.
fn conductor(dice: &mut Stream) -> Argument {
    let names: Vec<&'static str> = media::electric().map(|known| known.name).collect();
    let relative = Range::new(RELATIVE.0, RELATIVE.1, "1");
    let [epsilon_r, mu_r] = [(); 2].map(|()| relative.draw(dice));
    let sigma = Range::new(CONDUCTIVITY.0, CONDUCTIVITY.1, "S/m").draw(dice);
    match below(dice, 4) {
        0 | 1 => (*pick(dice, &names)).into(),
        2 => format!("{epsilon_r:?}/{mu_r:?}/{sigma:?}").into(),
        _ => Argument::record([("eps_r", epsilon_r.into()), ("mu_r", mu_r.into()), ("sigma", sigma.into())]),
    }
}

/// One of `0 .. count`.
fn below(dice: &mut Stream, count: usize) -> usize {
    (uniform(dice, 0.0, count as f64) as usize).min(count - 1)
}

fn pick<'a, T>(dice: &mut Stream, from: &'a [T]) -> &'a T {
    &from[below(dice, from.len())]
}
