//! A sheet as an SVG, its text as text.
//!
//! Colours stand there twice. Attributes (`fill="#3f4ccd"`) are for all readers. Where CSS variables are known, a style
//! of one class a role takes over (`fill:var(--lesson-s,#3f4ccd)`), so that a figure inlined in a page follows the
//! page's theme and otherwise looks the same. It stands behind `@supports`: readers that know no variables drop it
//! whole, where some would paint a `var()` that they cannot read black.

use super::palette::{Colour, Paint};
use super::sheet::{Image, Item, Path, Sheet, Text};
use super::{encode, text};
use std::fmt::Write;

/// What a class is called, by what it colours.
const FILL: Property = Property { name: "fill", class: "f" };
const STROKE: Property = Property { name: "stroke", class: "s" };

/// The sheet on its paper, named and described for readers who listen.
pub fn write(sheet: &Sheet, title: &str, description: &str) -> String {
    let (width, height) = (sheet.width.max(1), sheet.height.max(1));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"lesson-figure\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n{}\
         <rect width=\"{width}\" height=\"{height}\"{}/>\n\
         <g font-family=\"{}\" font-stretch=\"condensed\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
        escaped(title),
        escaped(description),
        style(sheet),
        FILL.of(Colour::Paper.into()),
        text::FAMILIES,
    );
    for item in &sheet.items {
        match item {
            Item::Fill { path, paint } => {
                push(&mut svg, format_args!("<path d=\"{}\"{}/>", data(path), FILL.of(*paint)))
            }
            Item::Disc { centre, radius, paint } => {
                let ([x, y], r, paint) = (centre.map(short), short(*radius), FILL.of(*paint));
                push(&mut svg, format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{paint}/>"));
            }
            Item::Stroke { path, paint, width, dashes } => {
                let (data, paint) = (data(path), STROKE.of(*paint));
                let (width, broken) = (short(*width), broken(dashes));
                push(
                    &mut svg,
                    format_args!("<path d=\"{data}\" fill=\"none\"{paint} stroke-width=\"{width}\"{broken}/>"),
                );
            }
            Item::Text(text) => set(&mut svg, text),
            Item::Image(image) => embed(&mut svg, image),
        }
    }
    svg.push_str("</g>\n</svg>\n");
    svg
}

/// The classes that a sheet uses.
fn style(sheet: &Sheet) -> String {
    let used = sheet.items.iter().filter_map(|item| match item {
        Item::Fill { paint, .. } | Item::Disc { paint, .. } => Some((FILL, paint.colour)),
        Item::Text(Text { paint, .. }) => Some((FILL, paint.colour)),
        Item::Stroke { paint, .. } => Some((STROKE, paint.colour)),
        Item::Image(_) => None,
    });
    let used: Vec<(Property, Colour)> = used.chain([(FILL, Colour::Paper)]).collect();
    let rules = Colour::ALL.into_iter().flat_map(|colour| [(FILL, colour), (STROKE, colour)]);
    let rules: String =
        rules.filter(|rule| used.contains(rule)).filter_map(|(what, colour)| what.rule(colour)).collect();
    format!("<style>@supports(color:var(--a)){{{rules}}}</style>\n")
}

/// What is coloured of a shape.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Property {
    name: &'static str,
    class: &'static str,
}

impl Property {
    /// The attributes of a shape.
    fn of(self, Paint { colour, alpha }: Paint) -> String {
        let Self { name, class } = self;
        let class = colour.role().map_or(String::new(), |role| format!(" class=\"{class}-{role}\""));
        let opacity = if alpha < 1.0 { format!(" {name}-opacity=\"{}\"", short(alpha as f32)) } else { String::new() };
        format!("{class} {name}=\"{}\"{opacity}", colour.hex())
    }

    /// The rule of a class. Styles of a page's figures hold in the whole page, hence the long selector.
    fn rule(self, colour: Colour) -> Option<String> {
        let (Self { name, class }, role, hex) = (self, colour.role()?, colour.hex());
        Some(format!(".lesson-figure .{class}-{role}{{{name}:var(--lesson-{role},{hex})}}"))
    }
}

fn push(svg: &mut String, element: std::fmt::Arguments) {
    writeln!(svg, "{element}").expect("a string takes all that is written");
}

/// A length to a hundredth of a pixel.
fn short(length: f32) -> String {
    let text = format!("{length:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

fn broken(dashes: &[f32]) -> String {
    if dashes.is_empty() {
        return String::new();
    }
    let lengths: Vec<String> = dashes.iter().copied().map(short).collect();
    format!(" stroke-dasharray=\"{}\" stroke-linecap=\"butt\"", lengths.join(" "))
}

fn data(path: &Path) -> String {
    let corners = path.points.iter().map(|[x, y]| format!("{} {}", short(*x), short(*y)));
    let end = if path.is_closed { "Z" } else { "" };
    format!("M{}{end}", corners.collect::<Vec<_>>().join("L"))
}

/// Each run of one size stands where it was laid out and keeps its width, whichever of the families is found. (A width
/// for several runs at once is read differently by different programs.) Runs of one label form a group.
fn set(svg: &mut String, text: &Text) {
    let [x, y] = text.start;
    let runs = text::runs(&text.label);
    let [x0, y0] = text.start.map(short);
    let turn = if text.upwards { format!(" transform=\"rotate(-90 {x0} {y0})\"") } else { String::new() };
    let paint = FILL.of(text.paint);
    let written = runs.iter().map(|run| {
        let [dx, dy, size] = [run.x, run.rise, run.size].map(|ems| ems as f32 * text.size);
        let width = short(text::width(&run.text, f64::from(size)) as f32);
        let (x, y, size, content) = (short(x + dx), short(y - dy), short(size), escaped(&run.text));
        format!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" textLength=\"{width}\" \
             lengthAdjust=\"spacingAndGlyphs\"{turn}{paint} xml:space=\"preserve\">{content}</text>"
        )
    });
    let written: String = written.collect();
    match runs.len() {
        1 => push(svg, format_args!("{written}")),
        _ => push(svg, format_args!("<g aria-label=\"{}\">{written}</g>", escaped(&text.label))),
    }
}

fn embed(svg: &mut String, image: &Image) {
    let place = image.place;
    let [x, y, width, height] =
        [place.left, place.top, place.width(), place.height()].map(|length| short(length as f32));
    let png = encode::png(image.columns as u32, image.rows() as u32, image.cells.as_flattened());
    let data = base64(&png);
    push(
        svg,
        format_args!(
            "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
         style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{data}\"/>"
        ),
    );
}

/// Base 64 (RFC 4648, section 4).
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let word = chunk.iter().enumerate().fold(0u32, |word, (k, byte)| word | u32::from(*byte) << (16 - 8 * k));
        for k in 0..4 {
            let letter = LETTERS[(word >> (18 - 6 * k)) as usize & 63];
            text.push(if k <= chunk.len() { letter as char } else { '=' });
        }
    }
    text
}

/// Text that may stand in XML 1.0: reserved characters as entities, forbidden ones left out.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\u{FFFE}' | '\u{FFFF}' => {}
            _ if character.is_control() && !matches!(character, '\t' | '\n' | '\r') => {}
            _ => safe.push(character),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The vectors of RFC 4648, section 10.
    #[test]
    fn base64_agrees_with_the_rfc() {
        let vectors =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (plain, coded) in vectors {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
    }

    #[test]
    fn lengths_are_written_short() {
        assert_eq!([1.0, 0.5, -0.001, 12.375].map(short), ["1", "0.5", "0", "12.38"]);
        assert_eq!(short(100.0), "100");
    }

    #[test]
    fn what_xml_forbids_is_left_out() {
        assert_eq!(escaped("a<b & c>\u{1}\u{FFFE}"), "a&lt;b &amp; c&gt;");
    }
}
