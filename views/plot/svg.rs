//! A sheet as an SVG, its text as text.

use super::png;
use super::sheet::{Image, Item, Sheet, Text};
use super::text;
use plotters_backend::BackendColor;
use std::fmt::Write;
use tiny_skia::{Path, PathSegment};

/// The sheet on white, named and described for readers who listen.
pub fn write(sheet: &Sheet, title: &str, description: &str) -> String {
    let (width, height) = (sheet.width.max(1), sheet.height.max(1));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n\
         <g font-family=\"{}\" font-stretch=\"condensed\" stroke-linejoin=\"round\">\n",
        escaped(title),
        escaped(description),
        text::FAMILIES,
    );
    for item in &sheet.items {
        match item {
            Item::Fill { path, colour } => {
                push(&mut svg, format_args!("<path d=\"{}\"{}/>", data(path), paint("fill", *colour)))
            }
            Item::Disc { centre, radius, colour } => {
                let ([x, y], r, paint) = (centre.map(short), short(*radius), paint("fill", *colour));
                push(&mut svg, format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{paint}/>"));
            }
            Item::Stroke { path, colour, width, dashes } => {
                let (data, paint) = (data(path), paint("stroke", *colour));
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

fn push(svg: &mut String, element: std::fmt::Arguments) {
    writeln!(svg, "{element}").expect("a string takes all that is written");
}

/// A length to a hundredth of a pixel.
fn short(length: f32) -> String {
    let text = format!("{length:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

fn paint(what: &str, colour: BackendColor) -> String {
    let (red, green, blue) = colour.rgb;
    let paint = format!(" {what}=\"#{red:02x}{green:02x}{blue:02x}\"");
    if colour.alpha < 1.0 { format!("{paint} {what}-opacity=\"{}\"", short(colour.alpha as f32)) } else { paint }
}

fn broken(dashes: &[f32]) -> String {
    if dashes.is_empty() {
        return " stroke-linecap=\"round\"".into();
    }
    let lengths: Vec<String> = dashes.iter().copied().map(short).collect();
    format!(" stroke-dasharray=\"{}\"", lengths.join(" "))
}

fn data(path: &Path) -> String {
    let mut data = String::new();
    for segment in path.segments() {
        let (letter, points): (char, &[tiny_skia::Point]) = match &segment {
            PathSegment::MoveTo(end) => ('M', &[*end]),
            PathSegment::LineTo(end) => ('L', &[*end]),
            PathSegment::QuadTo(control, end) => ('Q', &[*control, *end]),
            PathSegment::CubicTo(first, second, end) => ('C', &[*first, *second, *end]),
            PathSegment::Close => ('Z', &[]),
        };
        data.push(letter);
        let numbers: Vec<String> = points.iter().flat_map(|point| [short(point.x), short(point.y)]).collect();
        data.push_str(&numbers.join(" "));
    }
    data
}

/// Each run of one size stands where it was laid out and keeps its width, whichever of the families is found. (A width
/// for several runs at once is read differently by different programs.) Runs of one label form a group.
fn set(svg: &mut String, text: &Text) {
    let [x, y] = text.start;
    let runs = text::runs(&text.label);
    let [x0, y0] = text.start.map(short);
    let turn = if text.upwards { format!(" transform=\"rotate(-90 {x0} {y0})\"") } else { String::new() };
    let paint = paint("fill", text.colour);
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
    let [x, y, width, height] = [place.x(), place.y(), place.width(), place.height()].map(short);
    let png = png::encode(image.columns as u32, image.rows() as u32, image.cells.as_flattened());
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
