//! The picture while it is made: a bar, and on a terminal with colours enough the picture itself, two pixels a letter.

use super::pictures::Shown;
use console::Term;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use light::bsdf::Rgb;
use light::transport::estimate::colour;
use light::transport::film::Halves;
use std::fmt::Write;
use std::io::{IsTerminal, stderr};
use std::ops::Range;
use std::time::Duration;

/// How often a second all of it is drawn anew at most.
const RATE: u8 = 2;
/// Letters across below which a picture tells nothing.
const NARROW: u16 = 40;
/// Lines kept for the bar and for what was said before.
const KEPT: usize = 3;
/// How long nothing moves at most, as far as can be foreseen [s].
const MOMENT: f64 = 0.3;

/// What is shown on standard error while a picture is made; nothing if that is no terminal.
pub struct Preview {
    bar: ProgressBar,
    /// Letters across and down that a picture may have.
    room: Option<[usize; 2]>,
    shown: Shown,
}

/// Letters across and down that a terminal of this size has for a picture, if it has.
fn room(size: Option<(u16, u16)>, is_coloured: bool) -> Option<[usize; 2]> {
    let (lines, columns) = size?;
    let [across, down] = [usize::from(columns) - 1, usize::from(lines).saturating_sub(KEPT)];
    (is_coloured && columns >= NARROW && down > 0).then_some([across, down])
}

/// Whether a terminal says that it has colours of 24 bits, and nobody has declined them.
fn is_coloured(variable: impl Fn(&str) -> Option<String>) -> bool {
    let declined = variable("NO_COLOR").is_some_and(|value| !value.is_empty());
    let promised = variable("COLORTERM").is_some_and(|value| ["truecolor", "24bit"].contains(&value.as_str()));
    let named = variable("TERM").is_some_and(|name| name.ends_with("-direct") || name == "xterm-kitty");
    let is_dumb = variable("TERM").is_some_and(|name| name == "dumb");
    !declined && !is_dumb && (promised || named)
}

impl Preview {
    /// Up to so many steps.
    pub fn new(steps: u64, shown: Shown) -> Self {
        if !stderr().is_terminal() {
            return Self { bar: ProgressBar::hidden(), room: None, shown };
        }
        let room = room(Term::stderr().size_checked(), is_coloured(|name| std::env::var(name).ok()));
        let (picture, rate) = if room.is_some() { ("{msg}", RATE) } else { ("", 5) };
        let template = format!("{picture}{{bar:24}} {{percent}} % {{prefix}}");
        let style = ProgressStyle::with_template(&template).expect("a valid template");
        let target = ProgressDrawTarget::stderr_with_hz(rate);
        Self { bar: ProgressBar::with_draw_target(Some(steps), target).with_style(style), room, shown }
    }

    /// Whether nobody sees anything of it.
    pub fn is_hidden(&self) -> bool {
        self.bar.is_hidden()
    }

    /// How far it is, and what else there is to say.
    pub fn tell(&self, steps: u64, says: String) {
        self.bar.set_prefix(says);
        self.bar.set_position(steps);
    }

    /// What the picture looks like.
    pub fn show(&self, halves: &[Halves], width: u32) {
        if let Some(room) = self.room {
            self.bar.set_message(letters(halves, width as usize, room, &self.shown));
        }
    }

    /// Takes all of it off the screen.
    pub fn end(&self) {
        self.bar.finish_and_clear();
    }
}

/// The rows of a picture in bands, top to bottom, so that each takes a moment if `done` pairs took so long and `next` are to
/// come; all at once if nobody is there to see how far it is.
pub fn bands(
    height: u32,
    is_hidden: bool,
    elapsed: Duration,
    done: u32,
    next: u32,
) -> impl Iterator<Item = Range<u32>> {
    let expected = elapsed.as_secs_f64() / f64::from(done.max(1)) * f64::from(next);
    let rows = if is_hidden || expected <= MOMENT { height } else { (f64::from(height) * MOMENT / expected) as u32 };
    let rows = rows.clamp(1, height);
    (0..height.div_ceil(rows)).map(move |band| band * rows..((band + 1) * rows).min(height))
}

/// What is left of a work of which a share [1] is done, if it goes on as it went.
pub fn left(share: f64, elapsed: Duration) -> Option<Duration> {
    let left = elapsed.as_secs_f64() * (1.0 - share) / share;
    Duration::try_from_secs_f64(left).ok()
}

/// A time as people read it.
pub fn clock(time: Duration) -> String {
    match time.as_secs() {
        seconds @ 0..60 => format!("{seconds} s"),
        seconds @ 60..3600 => format!("{}:{:02} min", seconds / 60, seconds % 60),
        seconds => format!("{}:{:02} h", seconds / 3600, seconds / 60 % 60),
    }
}

/// A picture in letters, each the upper of two pixels on a ground that is the lower, line by line; each line ends. Pixels of
/// it are means of radiance.
fn letters(halves: &[Halves], width: usize, room: [usize; 2], shown: &Shown) -> String {
    let height = halves.len() / width;
    // At most a pixel a pixel; they are as high as wide.
    let shrink = (width as f64 / room[0] as f64).max(height as f64 / (2 * room[1]) as f64).max(1.0);
    let side = |of: usize| ((of as f64 / shrink).round() as usize).max(1);
    let [across, down] = [side(width).min(room[0]), side(height).min(2 * room[1])];
    let part = |at: usize, of: usize, all: usize| at * all / of..((at + 1) * all / of).max(at * all / of + 1);
    let pixel = |column: usize, row: usize| -> [u8; 3] {
        let (mut sum, mut count): (Rgb<f64>, f64) = ([0.0; 3], 0.0);
        for y in part(row, down, height) {
            for x in part(column, across, width) {
                let radiance = colour(&halves[y * width + x]);
                sum = std::array::from_fn(|c| sum[c] + radiance[c]);
                count += 1.0;
            }
        }
        shown.of(sum.map(|x| x / count)).map(|x| (255.0 * x).round() as u8)
    };
    let mut text = String::new();
    for row in (0..down).step_by(2) {
        for column in 0..across {
            let [r, g, b] = pixel(column, row);
            // Half a letter is left where the rows are odd.
            let ground = (row + 1 < down).then(|| pixel(column, row + 1));
            let ground = ground.map_or("49".to_owned(), |[r, g, b]| format!("48;2;{r};{g};{b}"));
            let _ = write!(text, "\x1b[38;2;{r};{g};{b};{ground}m▀");
        }
        text.push_str("\x1b[0m\n");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use light::tone::Curve;

    const PLAIN: Shown = Shown { curve: Curve::None, exposure: 0.0 };

    fn grey(x: f32) -> Halves {
        [[x; 3]; 2]
    }

    #[test]
    fn two_pixels_stand_in_a_letter_the_upper_on_top() {
        let text = letters(&[grey(1.0), grey(0.0), grey(f32::NAN)], 1, [80, 20], &PLAIN);
        assert_eq!(text, "\x1b[38;2;255;255;255;48;2;0;0;0m▀\x1b[0m\n\x1b[38;2;0;0;0;49m▀\x1b[0m\n");
    }

    #[test]
    fn a_large_picture_fits_and_its_pixels_are_means_of_radiance() {
        for (width, height, room) in
            [(256, 256, [79, 21]), (1920, 1080, [79, 21]), (10, 4000, [79, 21]), (4000, 1, [39, 1])]
        {
            // Columns that alternate between white and black: on average half of the light, which is not half of the steps.
            let halves: Vec<_> = (0..width * height).map(|at| grey((at % width % 2) as f32)).collect();
            let text = letters(&halves, width, room, &PLAIN);
            let lines: Vec<_> = text.lines().collect();
            let across = lines[0].matches('▀').count();
            assert!(across <= room[0] && lines.len() <= room[1], "{width} × {height}: {across} × {}", lines.len());
            // It fills the room in one of the two.
            assert!(across == room[0] || 2 * lines.len() + 1 >= 2 * room[1], "{width} × {height}: {across}");
        }
        let halves: Vec<_> = (0..400 * 48).map(|at| grey((at % 2) as f32)).collect();
        let text = letters(&halves, 400, [50, 20], &PLAIN);
        let half = (255.0 * light::tone::encoded(0.5)).round();
        let due = format!("\x1b[38;2;{half};{half};{half};48;2;{half};{half};{half}m▀");
        assert_eq!(text.matches(&due).count(), 50 * 3);
    }

    #[test]
    fn only_terminals_that_can_show_it_are_shown_it() {
        assert_eq!(room(Some((24, 80)), true), Some([79, 21]));
        assert_eq!(room(Some((24, 39)), true), None);
        assert_eq!(room(Some((3, 80)), true), None);
        assert_eq!(room(Some((24, 80)), false), None);
        assert_eq!(room(None, true), None);
        let of = |variables: &[(&str, &str)]| {
            is_coloured(|name| variables.iter().find(|(own, _)| *own == name).map(|(_, value)| (*value).to_owned()))
        };
        assert!(of(&[("COLORTERM", "truecolor"), ("TERM", "xterm-256color")]) && of(&[("TERM", "xterm-kitty")]));
        assert!(!of(&[("TERM", "xterm-256color")]) && !of(&[]));
        assert!(
            !of(&[("COLORTERM", "truecolor"), ("NO_COLOR", "1")]) && of(&[("COLORTERM", "24bit"), ("NO_COLOR", "")])
        );
        assert!(!of(&[("COLORTERM", "truecolor"), ("TERM", "dumb")]));
    }

    #[test]
    fn bands_are_all_rows_once_and_take_a_moment() {
        let all = |height, is_hidden, seconds, done, next| {
            let bands: Vec<_> = bands(height, is_hidden, Duration::from_secs_f64(seconds), done, next).collect();
            assert!(bands[0].start == 0 && bands.windows(2).all(|two| two[0].end == two[1].start));
            assert_eq!(bands[bands.len() - 1].end, height);
            bands.len()
        };
        assert_eq!(all(100, true, 1e6, 1, 1), 1);
        assert_eq!(all(100, false, 0.1, 4, 4), 1);
        // Twice what took 6 s, in moments of 0.3 s: 2 of 100 rows each.
        assert_eq!(all(100, false, 6.0, 4, 8), 50);
        assert_eq!(all(3, false, 1e9, 1, 1), 3);
        assert_eq!(all(7, false, 0.0, 0, 1), 1);
    }

    #[test]
    fn what_is_left_takes_as_long_as_what_was() {
        assert_eq!(left(0.25, Duration::from_secs(10)), Some(Duration::from_secs(30)));
        assert_eq!(left(0.0, Duration::from_secs(10)), None);
        let of = |seconds| clock(Duration::from_secs(seconds));
        assert_eq!([of(0), of(59), of(61), of(3600 + 125)], ["0 s", "59 s", "1:01 min", "1:02 h"]);
    }
}
