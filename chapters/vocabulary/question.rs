//! What a step asks before it shows its evidence. The right answer is computed by the program at the setting, never
//! typed; whoever answers wrongly is told which idea leads there.

use crate::parameter::{Fault, Setting, excerpt, parse_quantity};

/// A question.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// Last part of the address.
    pub id: &'static str,
    /// What is asked.
    pub asks: &'static str,
    /// What kind of answer it has, and the right one.
    pub answer: Answer,
    /// What the right answer shows.
    pub because: &'static str,
}

/// The kinds of answers. Beside each right answer stands a `slip`: the answer that a common mistake leads to, which must
/// be refused.
#[derive(Clone, Copy, Debug)]
pub enum Answer {
    /// One of several statements.
    Choice {
        /// The statements.
        options: &'static [Choice],
        /// Which of them holds at the setting, from 0.
        right: fn(&Setting) -> usize,
        /// Which of them the mistake leads to.
        slip: fn(&Setting) -> usize,
    },
    /// Negative, zero or positive.
    Sign {
        /// What each of the three says to whoever gives it wrongly, in this order.
        replies: [&'static str; 3],
        /// A number of that sign.
        right: fn(&Setting) -> f64,
        /// A number of the sign that the mistake leads to.
        slip: fn(&Setting) -> f64,
    },
    /// How a curve runs.
    Trend {
        /// What each of [`TRENDS`] says to whoever gives it wrongly.
        replies: [&'static str; 5],
        /// The curve, over 0 … 1.
        right: fn(&Setting, f64) -> f64,
        /// The curve that the mistake leads to.
        slip: fn(&Setting, f64) -> f64,
    },
    /// A number.
    Number {
        /// SI unit; `rad` is asked in degrees.
        unit: &'static str,
        /// How far off an answer may be, as a share of the right one.
        tolerance: f64,
        /// The right one, in SI.
        right: fn(&Setting) -> f64,
        /// Numbers that mistakes lead to; the first is the planted one.
        slips: &'static [Misled],
    },
}

/// A statement that may be chosen.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The statement.
    pub says: &'static str,
    /// What is said to whoever chooses it wrongly: which idea leads there.
    pub reply: &'static str,
}

/// A number that a mistake leads to.
#[derive(Clone, Copy, Debug)]
pub struct Misled {
    /// The number, in SI.
    pub value: fn(&Setting) -> f64,
    /// Which idea leads there.
    pub reply: &'static str,
}

/// The ways a curve may run.
pub const TRENDS: [&str; 5] =
    ["it falls", "it stays the same", "it rises", "it falls first and rises then", "it rises first and falls then"];

/// The signs there are.
pub const SIGNS: [&str; 3] = ["negative", "zero", "positive"];

/// An answer as it is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given {
    /// The option of this place, from 0: of the choices, of [`SIGNS`] or of [`TRENDS`].
    Option(usize),
    /// A number, in SI.
    Number(f64),
}

/// What is said to an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reply {
    /// Whether the answer is right at the setting.
    pub right: bool,
    /// What it shows, or which idea leads astray; empty where nothing is known of the idea.
    pub says: &'static str,
}

/// The question `id`: what it `asks`, and what the right answer shows.
pub const fn question(id: &'static str, asks: &'static str, answer: Answer, because: &'static str) -> Question {
    Question { id, asks, answer, because }
}

/// A statement that may be chosen, and what is said to whoever chooses it wrongly.
pub const fn choice(says: &'static str, reply: &'static str) -> Choice {
    Choice { says, reply }
}

impl Question {
    /// What can be chosen; empty if a number is asked for.
    pub fn options(&self) -> Vec<&'static str> {
        match self.answer {
            Answer::Choice { options, .. } => options.iter().map(|option| option.says).collect(),
            Answer::Sign { .. } => SIGNS.into(),
            Answer::Trend { .. } => TRENDS.into(),
            Answer::Number { .. } => Vec::new(),
        }
    }

    /// Reads an answer as it is typed: the letter of an option, its number from 1, or its words; or a number, which may
    /// carry a unit. A bare angle is one in degrees.
    ///
    /// # Errors
    /// What could be answered instead.
    pub fn read(&self, text: &str) -> Result<Given, Fault> {
        let text = text.trim();
        let fault = |valid: String| Fault::new(self.id, format!("`{}` is no answer; {valid}", excerpt(text)));
        if let Answer::Number { unit, .. } = self.answer {
            let in_degrees = unit == "rad" && text.parse::<f64>().is_ok();
            let quantity = if in_degrees { format!("{text}deg") } else { text.to_owned() };
            return parse_quantity(&quantity, unit).map(Given::Number).map_err(|reason| Fault::new(self.id, reason));
        }
        let options = self.options();
        let by_words = || options.iter().position(|option| option.eq_ignore_ascii_case(text));
        let by_number = || text.parse::<usize>().ok()?.checked_sub(1);
        let by_letter = || ('a'..='z').position(|letter| text.eq_ignore_ascii_case(letter.encode_utf8(&mut [0])));
        by_number()
            .or_else(by_letter)
            .filter(|at| *at < options.len())
            .or_else(by_words)
            .map(Given::Option)
            .ok_or_else(|| fault(format!("valid: 1 to {}", options.len())))
    }

    /// The right answer at the setting.
    pub fn right(&self, setting: &Setting) -> Given {
        match self.answer {
            Answer::Choice { right, .. } => Given::Option(right(setting)),
            Answer::Sign { right, .. } => Given::Option(sign(right(setting))),
            Answer::Trend { right, .. } => Given::Option(trend(|at| right(setting, at))),
            Answer::Number { right, .. } => Given::Number(right(setting)),
        }
    }

    /// The planted mistake's answer at the setting.
    pub fn slip(&self, setting: &Setting) -> Option<Given> {
        match self.answer {
            Answer::Choice { slip, .. } => Some(Given::Option(slip(setting))),
            Answer::Sign { slip, .. } => Some(Given::Option(sign(slip(setting)))),
            Answer::Trend { slip, .. } => Some(Given::Option(trend(|at| slip(setting, at)))),
            Answer::Number { slips, .. } => slips.first().map(|misled| Given::Number((misled.value)(setting))),
        }
    }

    /// What is said to an answer. NaN is never right.
    pub fn reply(&self, setting: &Setting, given: Given) -> Reply {
        let right = match (self.right(setting), given) {
            (Given::Option(right), Given::Option(given)) => right == given,
            (Given::Number(right), Given::Number(given)) => self.is_near(given, right),
            _ => false,
        };
        let says = if right { self.because } else { self.astray(setting, given) };
        Reply { right, says }
    }

    /// Which idea leads to a wrong answer.
    fn astray(&self, setting: &Setting, given: Given) -> &'static str {
        match (self.answer, given) {
            (Answer::Choice { options, .. }, Given::Option(at)) => options.get(at).map_or("", |option| option.reply),
            (Answer::Sign { replies, .. }, Given::Option(at)) => replies.get(at).copied().unwrap_or(""),
            (Answer::Trend { replies, .. }, Given::Option(at)) => replies.get(at).copied().unwrap_or(""),
            (Answer::Number { slips, .. }, Given::Number(given)) => slips
                .iter()
                .find(|misled| self.is_near(given, (misled.value)(setting)))
                .map_or("", |misled| misled.reply),
            _ => "",
        }
    }

    /// Whether a number is `of`, within the tolerance.
    fn is_near(&self, given: f64, of: f64) -> bool {
        match self.answer {
            Answer::Number { tolerance, .. } => (given - of).abs() <= tolerance * of.abs(),
            _ => false,
        }
    }
}

/// The place in [`SIGNS`] of a number's sign; past its end for NaN, which is no answer.
fn sign(x: f64) -> usize {
    match x {
        x if x < 0.0 => 0,
        0.0 => 1,
        x if x > 0.0 => 2,
        _ => SIGNS.len(),
    }
}

/// At how many places a curve is looked at evenly.
const EVENLY: u32 = 256;
/// Steps to a decade towards both ends, and how many: what happens at the very ends is looked at too.
const TOWARDS_THE_ENDS: (f64, u32) = (8.0, 128);
/// What counts as no change [1, of the value]: rounding.
const UNSEEN: f64 = 64.0 * f64::EPSILON;

/// The place in [`TRENDS`] of how a curve over 0 … 1 runs; past its end if it is none of them.
fn trend(curve: impl Fn(f64) -> f64) -> usize {
    let (per_decade, steps) = TOWARDS_THE_ENDS;
    let near = (1..=steps).map(|step| 10f64.powf(-f64::from(step) / per_decade));
    let mut places: Vec<f64> = (0..=EVENLY).map(|at| f64::from(at) / f64::from(EVENLY)).collect();
    places.extend(near.flat_map(|share| [share, 1.0 - share]));
    places.sort_by(f64::total_cmp);
    let values: Vec<f64> = places.into_iter().map(curve).collect();
    if !values.iter().all(|x| x.is_finite()) {
        return TRENDS.len();
    }
    let never_back = |way: f64, part: &[f64]| {
        let mut furthest = f64::NEG_INFINITY;
        part.iter().all(|x| {
            furthest = furthest.max(way * x);
            way * x >= furthest - UNSEEN * furthest.abs().max(x.abs())
        })
    };
    let (falls, rises) = (|part: &[f64]| never_back(-1.0, part), |part: &[f64]| never_back(1.0, part));
    let place_of = |extreme: f64| values.iter().position(|x| *x == extreme).unwrap_or(0);
    let bottom = place_of(values.iter().copied().fold(f64::INFINITY, f64::min));
    let top = place_of(values.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    match () {
        () if falls(&values) && rises(&values) => 1,
        () if falls(&values) => 0,
        () if rises(&values) => 2,
        () if falls(&values[..=bottom]) && rises(&values[bottom..]) => 3,
        () if rises(&values[..=top]) && falls(&values[top..]) => 4,
        () => TRENDS.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_told_by_how_they_run() {
        assert_eq!(trend(|x| -x), 0);
        assert_eq!(trend(|_| 0.3), 1);
        assert_eq!(trend(f64::exp), 2);
        assert_eq!(trend(|x| (x - 0.4) * (x - 0.4)), 3);
        assert_eq!(trend(|x| x * (1.0 - x)), 4);
        // A change that no eye sees in a plot is one all the same; what rounding leaves is none.
        assert_eq!(trend(|x| 1.0 + 1e-6 * (x - 0.5) * (x - 0.5)), 3);
        assert_eq!(trend(|x| 1.0 + 1e-15 * (9.0 * x).sin()), 1);
        assert_eq!(trend(|x| (9.0 * x).sin()), TRENDS.len());
        assert_eq!(trend(|x| if x > 0.5 { f64::NAN } else { x }), TRENDS.len());
    }

    #[test]
    fn signs_are_three() {
        assert_eq!([-2.0, -0.0, 0.0, 1e-300, f64::NAN].map(sign), [0, 1, 1, 2, 3]);
    }

    #[test]
    fn numbers_are_judged_by_their_share() {
        const SLIPS: &[Misled] = &[Misled { value: |_| 4.0, reply: "twice" }];
        let answer = Answer::Number { unit: "1", tolerance: 0.01, right: |_| 2.0, slips: SLIPS };
        let asked = question("two", "How many?", answer, "yes");
        let setting = Setting::defaults(&[]);
        let reply = |x: f64| asked.reply(&setting, Given::Number(x));
        assert_eq!(reply(2.019), Reply { right: true, says: "yes" });
        assert_eq!(reply(3.97), Reply { right: false, says: "twice" });
        assert_eq!(reply(f64::NAN), Reply { right: false, says: "" });
        assert!(!asked.reply(&setting, Given::Option(0)).right);
        assert_eq!(asked.read(" 2.5 "), Ok(Given::Number(2.5)));
        assert!(asked.read("two").is_err() && asked.read("nan").is_err());
    }

    #[test]
    fn answers_are_read_as_they_are_typed() {
        let sign = Answer::Sign { replies: ["", "", ""], right: |_| 1.0, slip: |_| -1.0 };
        let asked = question("sign", "Which sign?", sign, "so");
        assert_eq!(asked.read("3"), Ok(Given::Option(2)));
        assert_eq!([asked.read(" Zero"), asked.read("B")], [Ok(Given::Option(1)), Ok(Given::Option(1))]);
        for bad in ["0", "4", "d", "", "-1", "1.5", "99999999999999999999"] {
            assert!(asked.read(bad).unwrap_err().message.ends_with("valid: 1 to 3"), "{bad}");
        }
        let angle = Answer::Number { unit: "rad", tolerance: 0.0, right: |_| 1.0, slips: &[] };
        let asked = question("angle", "Which angle?", angle, "so");
        let half_turn = Ok(Given::Number(std::f64::consts::PI));
        assert_eq!(
            [asked.read("180"), asked.read("180deg"), asked.read("3.141592653589793rad")],
            [half_turn.clone(), half_turn.clone(), half_turn]
        );
    }
}
