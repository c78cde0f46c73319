//! The picture while it is made: a bar, and on a terminal with colours enough the picture itself, two pixels a letter.

use super::pictures::Shown;
use console::{Term, truncate_str};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use light::bsdf::Rgb;
use light::transport::estimate::colour;
use light::transport::film::Halves;
use std::fmt::Write as _;
use std::io::{IsTerminal, Write as _, stderr};
use std::ops::Range;
use std::time::{Duration, Instant};

/// How often all of it is drawn anew at most.
const APART: Duration = Duration::from_millis(500);
/// Letters that the bar is long at most.
const BAR: usize = 24;
/// Letters that are left for what is said beside it, before the bar shrinks.
const SAID: usize = 50;
/// Letters across below which a picture tells nothing.
const NARROW: u16 = 40;
/// Lines kept for the bar and for what was said before.
const KEPT: usize = 3;
/// How long nothing moves at most, as far as can be foreseen [s].
const MOMENT: f64 = 0.3;
/// Pixels of the first band, of whose time nothing is known.
const FIRST: f64 = 262_144.0;

/// What is shown on standard error while a picture is made; nothing if that is no terminal.
pub struct Preview {
    /// Alone, where there is no picture.
    bar: ProgressBar,
    screen: Option<Screen>,
}

/// A part of a terminal that is drawn again and again.
struct Screen {
    /// Letters across and down that a picture may have.
    room: [usize; 2],
    shown: Shown,
    /// The picture, line by line.
    letters: String,
    /// Lines that were drawn above the last one.
    lines: usize,
    drawn: Option<Instant>,
}

/// Letters across and down that a terminal of this size has for a picture, if it has.
fn room(size: Option<(u16, u16)>, is_coloured: bool) -> Option<[usize; 2]> {
    let (lines, columns) = size?;
    let [across, down] = [usize::from(columns) - 1, usize::from(lines).saturating_sub(KEPT)];
    (is_coloured && columns >= NARROW && down > 0).then_some([across, down])
}

/// Letters that the bar is long in so many columns; none where what is said beside it needs all of them.
fn bar(columns: usize) -> usize {
    columns.saturating_sub(SAID).clamp(1, BAR)
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
            return Self { bar: ProgressBar::hidden(), screen: None };
        }
        let room = room(Term::stderr().size_checked(), is_coloured(|name| std::env::var(name).ok()));
        let screen = room.map(|room| Screen { room, shown, letters: String::new(), lines: 0, drawn: None });
        let target = if screen.is_some() { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let columns = Term::stderr().size_checked().map_or(usize::MAX, |(_, columns)| usize::from(columns));
        let style = ProgressStyle::with_template(&format!("{{bar:{}}} {{percent}} % {{wide_msg}}", bar(columns)));
        let bar = ProgressBar::with_draw_target(Some(steps), target).with_style(style.expect("a valid template"));
        Self { bar, screen }
    }

    /// The bar's end.
    pub fn whole(&self) -> u64 {
        self.bar.length().unwrap_or(1).max(1)
    }

    /// How far it is, and what else there is to say.
    pub fn tell(&mut self, steps: u64, says: &str) {
        let whole = self.whole();
        if let Some(screen) = self.screen.as_mut().filter(|screen| screen.is_due(Instant::now())) {
            let frame = screen.frame(steps as f64 / whole as f64, says);
            // Nobody may be looking.
            let _ = stderr().lock().write_all(frame.as_bytes());
        } else {
            self.bar.set_message(says.to_owned());
            self.bar.set_position(steps);
        }
    }

    /// What the picture looks like, from the next time on that something is told.
    pub fn show(&mut self, halves: &[Halves], width: u32) {
        if let Some(screen) = self.screen.as_mut().filter(|screen| screen.may_be_due(Instant::now())) {
            screen.letters = letters(halves, width as usize, screen.room, &screen.shown);
        }
    }

    /// Takes all of it off the screen.
    pub fn end(&mut self) {
        self.bar.finish_and_clear();
        if let Some(screen) = self.screen.take().filter(|screen| screen.drawn.is_some()) {
            let _ = stderr().lock().write_all(format!("{}\x1b[J", screen.to_its_top()).as_bytes());
        }
    }
}

impl Screen {
    fn is_due(&self, now: Instant) -> bool {
        !self.letters.is_empty() && self.may_be_due(now)
    }

    fn may_be_due(&self, now: Instant) -> bool {
        self.drawn.is_none_or(|drawn| now.duration_since(drawn) >= APART)
    }

    /// The way from the end of what was drawn to its beginning.
    fn to_its_top(&self) -> String {
        if self.lines > 0 { format!("\r\x1b[{}A", self.lines) } else { "\r".to_owned() }
    }

    /// All of it, over what was drawn before, and it is noted as drawn.
    fn frame(&mut self, share: f64, says: &str) -> String {
        let whole = bar(self.room[0]);
        let full = ((share * whole as f64) as usize).min(whole);
        let bar = format!("{}{} {:.0} % {says}", "█".repeat(full), "░".repeat(whole - full), 100.0 * share);
        let bar = truncate_str(&bar, self.room[0], "…").into_owned();
        // What stood there is taken away with the first letter of each line, and under the last one.
        let frame = format!("{}{}{bar}\x1b[K\x1b[J", self.to_its_top(), self.letters);
        self.lines = self.letters.matches('\n').count();
        self.drawn = Some(Instant::now());
        frame
    }
}

/// The rows of a picture in bands, top to bottom, so that each takes a moment if `done` pairs took so long and `next` are to
/// come: between two of them it can be told how far it is, and ended; no band is of fewer rows than `least`. Of the first pair so many pixels are taken for a moment.
pub fn bands(
    [width, height]: [u32; 2],
    least: u32,
    elapsed: Duration,
    done: u32,
    next: u32,
) -> impl Iterator<Item = Range<u32>> {
    let expected = match done {
        0 => MOMENT * f64::from(width) * f64::from(height) / FIRST,
        _ => elapsed.as_secs_f64() / f64::from(done) * f64::from(next),
    };
    let rows = if expected <= MOMENT { height } else { (f64::from(height) * MOMENT / expected) as u32 };
    let rows = rows.clamp(least, height);
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
        text.push_str("\x1b[0m\x1b[K\n");
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
        assert_eq!(text, "\x1b[38;2;255;255;255;48;2;0;0;0m▀\x1b[0m\x1b[K\n\x1b[38;2;0;0;0;49m▀\x1b[0m\x1b[K\n");
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
    fn a_frame_is_drawn_over_the_last_one_and_not_too_soon() {
        let mut screen = Screen { room: [40, 10], shown: PLAIN, letters: String::new(), lines: 0, drawn: None };
        let now = Instant::now();
        assert!(!screen.is_due(now), "without a picture");
        screen.letters = "a\nb\nc\n".to_owned();
        assert!(screen.is_due(now));
        let first = screen.frame(0.5, "1 spp");
        assert_eq!(first, "\ra\nb\nc\n░ 50 % 1 spp\x1b[K\x1b[J");
        assert_eq!([bar(10), bar(60), bar(80), bar(200)], [1, 10, 24, 24]);
        let drawn = screen.drawn.unwrap();
        assert!(!screen.is_due(drawn + APART / 2) && screen.is_due(drawn + APART));
        // Three lines up, and no line wider than there is room.
        let second = screen.frame(1.0, &"long ".repeat(20));
        assert!(second.starts_with("\r\x1b[3Aa\n") && second.contains("100 %"), "{second:?}");
        let last = second.lines().last().unwrap();
        assert_eq!(console::measure_text_width(last), 40, "{last:?}");
        assert_eq!(screen.to_its_top(), "\r\x1b[3A");
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
        let all = |height, seconds, done, next| {
            let bands: Vec<_> = bands([1024, height], 1, Duration::from_secs_f64(seconds), done, next).collect();
            assert!(bands[0].start == 0 && bands.windows(2).all(|two| two[0].end == two[1].start));
            assert_eq!(bands[bands.len() - 1].end, height);
            bands.len()
        };
        assert_eq!(all(100, 0.1, 4, 4), 1);
        // Twice what took 6 s, in moments of 0.3 s: 2 of 100 rows each.
        assert_eq!(all(100, 6.0, 4, 8), 50);
        // Seven rows each, and two at the end.
        assert_eq!(all(100, 4.0, 4, 4), 15);
        assert_eq!(all(3, 1e9, 1, 1), 3);
        // Nothing is known: 256 rows of 1024 pixels.
        assert_eq!((all(7, 0.0, 0, 1), all(1024, 9.0, 0, 1)), (1, 4));
    }

    #[test]
    fn what_is_left_takes_as_long_as_what_was() {
        assert_eq!(left(0.25, Duration::from_secs(10)), Some(Duration::from_secs(30)));
        assert_eq!(left(0.0, Duration::from_secs(10)), None);
        let of = |seconds| clock(Duration::from_secs(seconds));
        assert_eq!([of(0), of(59), of(61), of(3600 + 125)], ["0 s", "59 s", "1:01 min", "1:02 h"]);
    }
}
