//! Pictures by the pixels of a terminal that draws them: which can, and what to send to it.
//!
//! Each row of text is a picture of its own, so that pages scroll, and are cut, as text is.
//!
//! | protocol | its description |
//! |---|---|
//! | kitty's | <https://sw.kovidgoyal.net/kitty/graphics-protocol/> |
//! | iTerm2's | <https://iterm2.com/documentation-images.html> |
//! | sixels | DEC STD 070, chapter 9; VT330/VT340 Programmer Reference Manual, volume 2, chapter 14 |

use super::screen::nearest;
use crate::stop::Stop;
use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;
use chapters::figure::Plot;
use chapters::parameter::excerpt;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use views::block::{Picture, Strips};
use views::plot::{self, Pixels};

/// The variable by which the choice is made for us.
pub const CHOICE: &str = "LESSON_GRAPHICS";

/// How long a terminal has to answer [ms]; those that never do are waited for once, when the reader opens.
const PATIENCE: u16 = 150;

/// A cell [px] where nobody knows: of a common font.
const USUAL: [u32; 2] = [10, 20];

/// The largest cell [px] that is believed.
const LARGEST: u32 = 200;

/// What kitty takes of a picture at a time [B].
const CHUNK: usize = 4096;

/// How a terminal is told of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protocol {
    Kitty,
    ITerm2,
    Sixel,
}

/// What pictures are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// Cells of eight dots.
    Dots,
    /// Cells of two colours.
    Halves,
    /// Pixels, so many to a cell across and down.
    Pixels(Protocol, [u32; 2]),
}

impl Protocol {
    const ALL: [(&str, Self); 3] = [("kitty", Self::Kitty), ("iterm2", Self::ITerm2), ("sixel", Self::Sixel)];

    /// What a row of a picture is sent as.
    fn told(self, pixels: &Pixels, row: &[u8], cell: u32) -> String {
        let columns = pixels.width() / cell;
        match self {
            Self::Kitty => {
                let data = BASE64.encode(pixels.png(row));
                let chunks = data.as_bytes().chunks(CHUNK);
                let last = chunks.len().saturating_sub(1);
                let told = chunks.enumerate().map(|(at, chunk)| {
                    let more = u8::from(at < last);
                    let head = match at {
                        // The cursor stays, and nothing is answered.
                        0 => format!("a=T,f=100,c={columns},r=1,C=1,q=2,m={more}"),
                        _ => format!("m={more}"),
                    };
                    format!("\x1b_G{head};{}\x1b\\", String::from_utf8_lossy(chunk))
                });
                told.collect()
            }
            Self::ITerm2 => {
                let png = pixels.png(row);
                let how = format!("size={};inline=1;width={columns};height=1;preserveAspectRatio=0", png.len());
                format!("\x1b]1337;File={how}:{}\x07", BASE64.encode(png))
            }
            Self::Sixel => sixels(row, pixels.width() as usize, pixels.height() as usize),
        }
    }

    /// What takes the pictures from a row of the screen, 0 at its top, that clearing its text leaves there.
    pub fn erased(self, row: usize) -> String {
        match self {
            Self::Kitty => format!("\x1b_Ga=d,d=Y,y={},q=2\x1b\\", row + 1),
            Self::ITerm2 | Self::Sixel => String::new(),
        }
    }

    /// The same from all rows.
    pub fn all_erased(self) -> &'static str {
        match self {
            Self::Kitty => "\x1b_Ga=d,d=A,q=2\x1b\\",
            Self::ITerm2 | Self::Sixel => "",
        }
    }
}

/// Pixels as sixels: a palette, then bands of six rows, in each for every colour which of six pixels above each other it has.
fn sixels(rgb: &[u8], width: usize, height: usize) -> String {
    let colour = |at: usize| [rgb[3 * at], rgb[3 * at + 1], rgb[3 * at + 2]];
    let mut palette: BTreeMap<[u8; 3], usize> = (0..width * height).map(|at| (colour(at), 0)).collect();
    // Whoever has more than a terminal keeps takes those that every terminal has.
    let is_rich = palette.len() > 256;
    if is_rich {
        palette = palette.into_keys().map(|own| (nearest(own), 0)).collect();
    }
    palette.values_mut().enumerate().for_each(|(number, its)| *its = number);
    let numbers: Vec<usize> =
        (0..width * height).map(|at| palette[&if is_rich { nearest(colour(at)) } else { colour(at) }]).collect();
    let mut told = format!("\x1bP0;1;0q\"1;1;{width};{height}");
    for (own, number) in &palette {
        let [red, green, blue] = own.map(|part| (u32::from(part) * 100 + 127) / 255);
        told.push_str(&format!("#{number};2;{red};{green};{blue}"));
    }
    for (at, band) in numbers.chunks(6 * width).enumerate() {
        // None after the last one: there may be no line below.
        if at > 0 {
            told.push('-');
        }
        let here: BTreeSet<usize> = band.iter().copied().collect();
        for number in here {
            told.push_str(&format!("#{number}"));
            let sixel = |x: usize| {
                let bits = (x..band.len()).step_by(width).enumerate();
                bits.fold(0, |bits, (y, at)| bits | u8::from(band[at] == number) << y)
            };
            let sixels: Vec<u8> = (0..width).map(sixel).collect();
            for run in sixels.chunk_by(|one, other| one == other) {
                let letter = char::from(b'?' + run[0]);
                match run.len() {
                    length @ 4.. => told.push_str(&format!("!{length}{letter}")),
                    length => told.extend(std::iter::repeat_n(letter, length)),
                }
            }
            // Back to the band's beginning.
            told.push('$');
        }
    }
    told + "\x1b\\"
}

/// What the environment asks for: nothing, or one of the protocols, or none of them.
pub fn asked() -> Result<Option<Option<Protocol>>, Stop> {
    let Some(word) = std::env::var_os(CHOICE).filter(|word| !word.is_empty()) else { return Ok(None) };
    let known = Protocol::ALL.into_iter().find(|(name, _)| *name == word);
    match known {
        Some((_, protocol)) => Ok(Some(Some(protocol))),
        None if word == "none" => Ok(Some(None)),
        None => {
            let names = Protocol::ALL.map(|(name, _)| name).join(", ");
            Err(Stop::at(CHOICE, format!("found `{}`; valid: {names} or none", excerpt(&word.to_string_lossy()))))
        }
    }
}

impl Ground {
    /// Of the terminal, which must be in raw mode: it may be asked what it can, and nobody else may read what it answers.
    pub fn of_terminal(asked: Option<Option<Protocol>>, is_coloured: bool) -> Self {
        let known = |name: &str| std::env::var(name).ok();
        let protocol = match asked {
            _ if !is_coloured => return Self::Dots,
            Some(protocol) => protocol,
            None => match of_environment(&known) {
                Known::Protocol(protocol) => Some(protocol),
                Known::Nothing => answered("\x1b[c").is_some_and(|told| has_sixels(&told)).then_some(Protocol::Sixel),
                Known::None => None,
            },
        };
        protocol.map_or(Self::Halves, |protocol| {
            let cell = sized().or_else(|| cell_of(&answered("\x1b[16t")?));
            Self::Pixels(protocol, cell.unwrap_or(USUAL))
        })
    }

    /// After the terminal has changed its size, and perhaps that of its letters.
    pub fn resized(self) -> Self {
        match self {
            Self::Pixels(protocol, cell) => Self::Pixels(protocol, sized().unwrap_or(cell)),
            other => other,
        }
    }

    /// The protocol, if pictures have one.
    pub fn protocol(self) -> Option<Protocol> {
        if let Self::Pixels(protocol, _) = self { Some(protocol) } else { None }
    }

    /// A figure in at most so many columns, and rows to a panel.
    pub fn picture(self, plot: &Plot, columns: usize, rows: usize) -> Picture {
        match self {
            Self::Dots | Self::Halves => Picture::Cells(plot::cells(plot, columns, rows, self == Self::Halves)),
            Self::Pixels(protocol, cell) => {
                let pixels = plot::pixels(plot, columns, rows, cell);
                let told = |pixels: &Pixels| -> Vec<Arc<str>> {
                    pixels.rows().map(|row| protocol.told(pixels, row, cell[0]).into()).collect()
                };
                Picture::Strips(Strips { rows: told(&pixels), pale: told(&pixels.dimmed()) })
            }
        }
    }
}

/// What an environment says of its terminal.
#[derive(Debug, PartialEq, Eq)]
enum Known {
    Protocol(Protocol),
    /// That it shows none.
    None,
    Nothing,
}

fn of_environment(known: &dyn Fn(&str) -> Option<String>) -> Known {
    let is = |name: &str, words: &[&str]| {
        known(name).is_some_and(|value| words.iter().any(|word| value.to_lowercase().contains(word)))
    };
    // A multiplexer hands on what the terminal around it has left in the environment, but not its pictures.
    if known("TMUX").is_some() || is("TERM", &["tmux", "screen", "dumb", "linux"]) {
        Known::None
    } else if is("TERM", &["kitty", "ghostty"])
        || is("TERM_PROGRAM", &["ghostty"])
        || known("KITTY_WINDOW_ID").is_some()
    {
        Known::Protocol(Protocol::Kitty)
    } else if is("TERM_PROGRAM", &["iterm", "wezterm"]) || is("LC_TERMINAL", &["iterm"]) {
        Known::Protocol(Protocol::ITerm2)
    } else {
        Known::Nothing
    }
}

/// What the terminal answers.
fn answered(question: &str) -> Option<String> {
    xterm_query::query(question, PATIENCE).ok()
}

/// Whether sixels are among a terminal's attributes, of `ESC [ ? 62 ; 4 ; … c`.
fn has_sixels(attributes: &str) -> bool {
    let inner = attributes.split_once("\x1b[?").and_then(|(_, rest)| rest.split_once('c'));
    inner.is_some_and(|(numbers, _)| numbers.split(';').skip(1).any(|number| number == "4"))
}

/// A cell [px], of `ESC [ 6 ; height ; width t`.
fn cell_of(report: &str) -> Option<[u32; 2]> {
    let (_, rest) = report.split_once("\x1b[6;")?;
    let (height, rest) = rest.split_once(';')?;
    let (width, _) = rest.split_once('t')?;
    believed([width.parse().ok()?, height.parse().ok()?])
}

/// A cell [px], where the system knows it.
fn sized() -> Option<[u32; 2]> {
    let size = crossterm::terminal::window_size().ok()?;
    let part = |pixels: u16, cells: u16| u32::from(pixels).checked_div(cells.into());
    believed([part(size.width, size.columns)?, part(size.height, size.rows)?])
}

fn believed(cell: [u32; 2]) -> Option<[u32; 2]> {
    cell.iter().all(|part| (2..=LARGEST).contains(part)).then_some(cell)
}

#[cfg(test)]
mod tests {
    use super::*;
    use chapters::figure::{Axis, Chart, Hue};
    use icy_sixel::SixelImage;

    fn figure() -> Plot {
        let chart = Chart::new("", Axis::linear("x", "1"), Axis::linear("y", "1"));
        Plot::of("A line", chart.line(Hue::Ours, "y = x", vec![[0.0, 0.0], [1.0, 1.0]]))
    }

    /// The rows and what they were made from.
    fn shown(protocol: Protocol, cell: [u32; 2]) -> (Strips, Pixels) {
        let ground = Ground::Pixels(protocol, cell);
        let Picture::Strips(strips) = ground.picture(&figure(), 60, 20) else { panic!("no strips") };
        (strips, plot::pixels(&figure(), 60, 20, cell))
    }

    /// A PNG's pixels, and how many there are across and down.
    fn unpacked(bytes: &[u8]) -> (Vec<u8>, [u32; 2]) {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut pixels).unwrap();
        (pixels, [frame.width, frame.height])
    }

    /// What a picture in sixels holds, red, green, blue and opacity; of its last band nothing beyond its end is painted.
    fn unsixelled(told: &str, [width, height]: [usize; 2]) -> Vec<u8> {
        assert!(told.contains(&format!("\"1;1;{width};{height}#")));
        let mut image = SixelImage::decode(told.as_bytes()).unwrap();
        assert_eq!(image.dimensions(), (width, height.next_multiple_of(6)));
        let beyond = image.pixels.split_off(4 * width * height);
        assert!(
            beyond.chunks_exact(4).all(|pixel| pixel[3] == 0)
                && image.pixels.chunks_exact(4).all(|pixel| pixel[3] == 255)
        );
        image.pixels
    }

    #[test]
    fn rows_are_what_was_drawn() {
        for cell in [[8, 16], [9, 19], [20, 41]] {
            let (kitty, pixels) = shown(Protocol::Kitty, cell);
            assert_eq!(pixels.width() % cell[0], 0);
            assert!(pixels.width() / cell[0] <= 60 && kitty.rows.len() <= 24 && kitty.rows.len() > 12, "{cell:?}");
            // More than the white that it stands on.
            assert!(pixels.rows().any(|row| row.iter().any(|part| *part < 128)));
            let (iterm, _) = shown(Protocol::ITerm2, cell);
            let (sixel, _) = shown(Protocol::Sixel, cell);
            for (at, row) in pixels.rows().enumerate() {
                let size = [pixels.width(), cell[1]];
                let mut data = String::new();
                for (place, chunk) in kitty.rows[at].split("\x1b\\").filter(|chunk| !chunk.is_empty()).enumerate() {
                    let (head, part) = chunk.strip_prefix("\x1b_G").unwrap().split_once(';').unwrap();
                    assert!(
                        part.len() <= CHUNK && (place > 0 || head.contains(&format!("c={},r=1", size[0] / cell[0])))
                    );
                    data.push_str(part);
                }
                assert_eq!(unpacked(&BASE64.decode(data).unwrap()), (row.to_vec(), size));
                let data = iterm.rows[at].strip_suffix('\x07').unwrap().split_once(':').unwrap().1;
                assert_eq!(unpacked(&BASE64.decode(data).unwrap()), (row.to_vec(), size));
                // A palette of sixels has hundredths.
                let pixels = unsixelled(&sixel.rows[at], size.map(|part| part as usize));
                let off = pixels
                    .chunks_exact(4)
                    .zip(row.chunks_exact(3))
                    .map(|(one, other)| (0..3).map(|c| u32::from(one[c].abs_diff(other[c]))).max().unwrap_or(0));
                assert!(off.max().unwrap() < 3, "row {at}");
            }
            assert!(kitty.pale != kitty.rows && kitty.dimmed().rows == kitty.pale);
        }
    }

    #[test]
    fn more_colours_than_a_palette_has_become_near_ones() {
        let rgb: Vec<u8> =
            (0..40 * 20_u32).flat_map(|at| [at % 251, at * 7 % 256, at * at % 241].map(|x| x as u8)).collect();
        let pixels = unsixelled(&sixels(&rgb, 40, 20), [40, 20]);
        for (one, other) in pixels.chunks_exact(4).zip(rgb.chunks_exact(3)) {
            // Half of the widest step of xterm's cube along each side.
            let off: u32 = (0..3).map(|c| u32::from(one[c].abs_diff(other[c])).pow(2)).sum();
            assert!(f64::from(off).sqrt() <= 3_f64.sqrt() * (48.0 + 2.0), "{one:?} {other:?}");
        }
    }

    #[test]
    fn terminals_are_known_by_what_they_say() {
        let of = |variables: &[(&str, &str)]| {
            of_environment(&|name| Some((*variables.iter().find(|(its, _)| *its == name)?.1).to_owned()))
        };
        assert_eq!(of(&[("TERM", "xterm-kitty")]), Known::Protocol(Protocol::Kitty));
        assert_eq!(of(&[("TERM", "xterm-256color"), ("TERM_PROGRAM", "ghostty")]), Known::Protocol(Protocol::Kitty));
        assert_eq!(of(&[("TERM_PROGRAM", "WezTerm")]), Known::Protocol(Protocol::ITerm2));
        assert_eq!(of(&[("TERM_PROGRAM", "iTerm.app")]), Known::Protocol(Protocol::ITerm2));
        assert_eq!(of(&[("TERM", "tmux-256color"), ("KITTY_WINDOW_ID", "1")]), Known::None);
        assert_eq!(of(&[("TERM", "xterm-kitty"), ("TMUX", "/tmp/tmux")]), Known::None);
        assert_eq!(of(&[("TERM", "xterm-256color")]), Known::Nothing);
        for (told, has) in [
            ("\x1b[?62;4;22c", true),
            ("\x1b[?4;6c", false),
            ("\x1b[?64;1;2;6;9;15;18;21;22c", false),
            ("\x1b[?1;2;4c", true),
            ("", false),
            ("garbage;4;c", false),
        ] {
            assert_eq!(has_sixels(told), has, "{told:?}");
        }
        assert_eq!(cell_of("\x1b[6;41;20t"), Some([20, 41]));
        for told in ["", "\x1b[6;0;0t", "\x1b[6;41t", "\x1b[6;x;20t", "\x1b[6;4100;20t"] {
            assert_eq!(cell_of(told), None, "{told:?}");
        }
    }
}
