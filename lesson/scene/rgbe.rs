//! Radiance's pictures, `.hdr`: three mantissas and an exponent a texel, in runs (G. Ward, *Real pixels*, in *Graphics Gems II* (1991),
//! 80; *RADIANCE file formats*, "Picture file format").
//!
//! Read here, not by `zune-hdr` (0.5.2): that one takes what is cut off for zeros and loses its place in runs of the old kind. `image`
//! brings colour management with it, ten times the size of all this.

use super::images::sized;
use light::scene::Image;

/// The longest line of a header [byte].
const LONGEST: usize = 4096;

/// Reads a file. It takes three times the memory of its texels' bytes.
pub fn read(bytes: &[u8]) -> Result<Image, String> {
    let mut rest = bytes;
    let first = line(&mut rest)?;
    if !first.starts_with("#?") {
        return Err("is no picture of Radiance: its first line does not begin with #?".into());
    }
    // What was multiplied into the texels is taken out again.
    let mut exposure = 1.0_f64;
    loop {
        let line = line(&mut rest)?;
        match line.split_once('=').map(|(key, value)| (key.trim(), value.trim())) {
            _ if line.is_empty() => break,
            Some(("FORMAT", "32-bit_rle_rgbe")) => {}
            Some(("FORMAT", format)) => {
                let format = chapters::parameter::excerpt(format);
                return Err(format!("FORMAT is `{format}`; valid: 32-bit_rle_rgbe"));
            }
            Some(("EXPOSURE", value)) => {
                let factor = value.parse::<f64>().ok().filter(|factor| factor.is_finite() && *factor > 0.0);
                exposure *= factor.ok_or_else(|| {
                    format!("EXPOSURE is `{}`; valid: a number above 0", chapters::parameter::excerpt(value))
                })?;
            }
            _ => {}
        }
    }
    let resolution = line(&mut rest)?;
    let words: Vec<&str> = resolution.split_whitespace().collect();
    let refused = || {
        let found = chapters::parameter::excerpt(resolution);
        format!("its size is `{found}`; valid: -Y HEIGHT +X WIDTH, either sign")
    };
    let [down, height, across, width] = words[..] else { return Err(refused()) };
    let ("-Y" | "+Y", "+X" | "-X") = (down, across) else { return Err(refused()) };
    let number = |word: &str| word.parse::<u32>().map_err(|_| refused());
    let size @ [width, height] = [number(width)?, number(height)?];
    sized(size)?;
    let mut texels = Vec::new();
    let mut row = vec![[0; 4]; width as usize];
    for at in 0..height {
        scanline(&mut rest, &mut row).map_err(|why| format!("row {at} of {height}: {why}"))?;
        let colour = |texel: &[u8; 4]| colour(*texel, exposure);
        // The first row that is written is the top, unless it says otherwise.
        match across {
            "+X" => texels.extend(row.iter().map(colour)),
            _ => texels.extend(row.iter().rev().map(colour)),
        }
    }
    if down == "+Y" {
        let rows: Vec<&[[f32; 3]]> = texels.chunks(width as usize).rev().collect();
        texels = rows.concat();
    }
    Image::new(size, texels).ok_or_else(|| "has no texels".into())
}

/// The next line of a header.
fn line<'b>(rest: &mut &'b [u8]) -> Result<&'b str, String> {
    let end = rest.iter().take(LONGEST).position(|byte| *byte == b'\n').ok_or("its header has no end")?;
    let (line, left) = rest.split_at(end);
    *rest = &left[1..];
    std::str::from_utf8(line).map(|line| line.trim_end_matches('\r')).map_err(|_| "its header is no text".to_owned())
}

/// Without half a step more than is written, as most do: so 0 is black and 1 stays 1 (B. Walter, *rgbe.c*, 1995).
fn colour([red, green, blue, exponent]: [u8; 4], exposure: f64) -> [f32; 3] {
    let unit = 2f64.powi(i32::from(exponent) - 136) / exposure;
    [red, green, blue].map(|mantissa| (f64::from(mantissa) * unit) as f32)
}

fn take<const K: usize>(rest: &mut &[u8]) -> Result<[u8; K], String> {
    let (taken, left) = rest.split_first_chunk::<K>().ok_or("the file ends too early")?;
    *rest = left;
    Ok(*taken)
}

/// Reads a row: channel by channel in runs, or as texels that may be repeated.
fn scanline(rest: &mut &[u8], row: &mut [[u8; 4]]) -> Result<(), String> {
    let is_by_channel = matches!(**rest, [2, 2, high, low, ..]
        if high < 128 && (8..0x8000).contains(&row.len()) && usize::from(high) << 8 | usize::from(low) == row.len());
    if !is_by_channel {
        return texels(rest, row);
    }
    take::<4>(rest)?;
    for channel in 0..4 {
        let mut at = 0;
        while at < row.len() {
            let [count] = take(rest)?;
            let (is_run, count) = if count > 128 { (true, count - 128) } else { (false, count) };
            let end = at + usize::from(count);
            if count == 0 || end > row.len() {
                return Err(format!("a run of {count} at column {at} of {}", row.len()));
            }
            if is_run {
                let [value] = take(rest)?;
                row[at..end].iter_mut().for_each(|texel| texel[channel] = value);
            } else {
                for texel in &mut row[at..end] {
                    [texel[channel]] = take(rest)?;
                }
            }
            at = end;
        }
    }
    Ok(())
}

/// Texels one after the other; (1, 1, 1, n) stands for n more of the last, and right after another such for 256 times as many.
fn texels(rest: &mut &[u8], row: &mut [[u8; 4]]) -> Result<(), String> {
    let (mut at, mut shift) = (0, 0);
    while at < row.len() {
        let texel @ [red, green, blue, count] = take(rest)?;
        if [red, green, blue] != [1; 3] {
            row[at] = texel;
            (at, shift) = (at + 1, 0);
            continue;
        }
        let count = if shift < 32 { usize::from(count) << shift } else { usize::MAX };
        let end = at.checked_add(count).filter(|end| at > 0 && *end <= row.len());
        let end = end.ok_or_else(|| format!("a run of {count} at column {at} of {}", row.len()))?;
        let last = row[at - 1];
        row[at..end].fill(last);
        (at, shift) = (end, shift + 8);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n";

    fn file(header: &str, body: &[u8]) -> Result<Image, String> {
        read(&[header.as_bytes(), body].concat())
    }

    #[test]
    fn texels_are_read_in_each_of_the_three_ways() {
        // Plain, with a run of the old kind: 2⁻⁸ · 128 · 2 over the exposure of 2.
        let plain = [128, 0, 64, 129, 1, 1, 1, 1, 0, 0, 0, 0];
        let image = file(&format!("{HEADER}-Y 1 +X 3\n"), &plain).unwrap();
        assert_eq!((image.size(), image.texels()), ([3, 1], &[[0.5, 0.0, 0.25], [0.5, 0.0, 0.25], [0.0; 3]][..]));
        // By channel: eight columns as a run, as numbers, and as both.
        let mut rows = vec![2, 2, 0, 8, 136, 128, 8, 0, 1, 2, 3, 4, 5, 6, 7, 132, 1, 4, 2, 2, 2, 2, 136, 137];
        let image = file(&format!("{HEADER}-Y 1 +X 8\n"), &rows).unwrap();
        let expected = |k: u8| [128.0, f32::from(k), if k < 4 { 1.0 } else { 2.0 }];
        assert_eq!(image.texels(), (0..8).map(expected).collect::<Vec<_>>());
        // A run of the old kind after another counts 256 times as much: 1 + 43 + 256.
        let long = [[128, 0, 64, 129], [1, 1, 1, 43], [1, 1, 1, 1]].concat();
        let image = file(&format!("{HEADER}-Y 1 +X 300\n"), &long).unwrap();
        assert_eq!(image.texels(), [[0.5, 0.0, 0.25]; 300]);
        // Two rows, and each way of lying.
        rows.extend([[9, 0, 0, 137]; 8].concat());
        let of = |size: &str| file(&format!("{HEADER}{size}\n"), &rows).unwrap();
        let first = expected(0);
        assert_eq!(of("-Y 2 +X 8").texels()[..9].iter().filter(|texel| **texel == first).count(), 1);
        assert_eq!([of("-Y 2 +X 8").at([0, 0]), of("-Y 2 -X 8").at([7, 0])], [first.map(f64::from); 2]);
        assert_eq!([of("+Y 2 +X 8").at([0, 1]), of("+Y 2 -X 8").at([7, 1])], [first.map(f64::from); 2]);
        assert_eq!(of("+Y 2 +X 8").at([3, 0]), [9.0, 0.0, 0.0]);
    }

    #[test]
    fn what_is_wrong_is_refused() {
        let own = |size: &str| format!("{HEADER}{size}\n");
        for (header, body, why) in [
            ("P6\n".to_owned(), &[][..], "does not begin with #?"),
            ("#?RADIANCE".to_owned(), &[], "its header has no end"),
            ("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n".to_owned(), &[], "FORMAT is `32-bit_rle_xyze`"),
            ("#?RADIANCE\nEXPOSURE=0\n\n".to_owned(), &[], "EXPOSURE is `0`"),
            (own("-Y 1"), &[], "its size is `-Y 1`; valid: -Y HEIGHT +X WIDTH"),
            (own("+X 1 -Y 1"), &[], "valid: -Y HEIGHT"),
            (own("-Y 0 +X 1"), &[], "no texels"),
            (own("-Y 65536 +X 65536"), &[], "65536 × 65536 texels; valid"),
            (own("-Y 99999999999 +X 1"), &[], "its size is"),
            (own("-Y 2 +X 1"), &[1, 2, 3, 4, 5], "row 1 of 2: the file ends too early"),
            (own("-Y 1 +X 1"), &[1, 1, 1, 1], "row 0 of 1: a run of 1 at column 0 of 1"),
            (own("-Y 1 +X 2"), &[9, 9, 9, 9, 1, 1, 1, 2], "a run of 2 at column 1 of 2"),
            (own("-Y 1 +X 8"), &[2, 2, 0, 8, 137, 1], "a run of 9 at column 0 of 8"),
            (own("-Y 1 +X 8"), &[2, 2, 0, 8, 0, 1], "a run of 0 at column 0 of 8"),
            (own("-Y 1 +X 8"), &[2, 2, 0, 8, 3, 1], "the file ends too early"),
        ] {
            let refused = file(&header, body).unwrap_err();
            assert!(refused.contains(why), "{header}: {refused}");
        }
    }
}
