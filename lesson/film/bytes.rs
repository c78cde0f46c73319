//! A film as bytes, and back.

use super::{Head, MAGIC, MOST_PAIRS, Reel, VERSION};
use crc32fast::Hasher;
use light::transport::film::{Film, Halves, Splats};
use std::io::{self, Read, Write};
use std::ops::Range;

/// The most bytes of what is told.
const MOST_TOLD: u32 = 1 << 16;

/// The most branches: each is held to all others.
const MOST_BRANCHES: u32 = 1 << 13;

/// Bytes of a branch before its sums.
const BRANCH: u64 = 8;

/// Bytes a pixel of the sums, and of what paths from lamps brought.
const SUMS: u64 = 6 * 4;
const SPLATS: u64 = 6 * 8;

/// Bytes of the checksum.
const SUM: u64 = 4;

/// Pixels that are read or written at once.
const TOGETHER: usize = 1024;

/// Writes a film that has samples.
///
/// # Errors
/// If it has none, or too many pieces; or what the writer says.
pub fn write(head: &Head, film: &Film, to: &mut dyn Write) -> io::Result<()> {
    let count = film.parts().count();
    if !(1..=MOST_BRANCHES as usize).contains(&count) {
        let why = format!("{count} separate pieces of samples; valid: 1 to {MOST_BRANCHES}");
        return Err(io::Error::new(io::ErrorKind::InvalidInput, why));
    }
    let mut out = Summed { inner: &mut *to, hasher: Hasher::new() };
    let Head { name, scene, manner, seconds } = head;
    let lines = manner.iter().map(|(key, value)| format!("{key}: {value}\n"));
    let told: String = std::iter::once(format!("{name}\n")).chain(lines).collect();
    let unit = film.parts().next().and_then(|(.., splats)| splats).map(|splats| splats.parts().0);
    out.put(&MAGIC)?;
    let [width, height] = film.size();
    for number in [VERSION, width, height] {
        out.put(&number.to_le_bytes())?;
    }
    out.put(scene)?;
    out.put(&seconds.to_le_bytes())?;
    out.put(&(told.len() as u32).to_le_bytes())?;
    out.put(told.as_bytes())?;
    out.put(&u32::from(unit.is_some()).to_le_bytes())?;
    out.put(&unit.unwrap_or(0).to_le_bytes())?;
    out.put(&(count as u32).to_le_bytes())?;
    for (pairs, sums, splats) in film.parts() {
        out.put(&pairs.start.to_le_bytes())?;
        out.put(&(pairs.end - pairs.start).to_le_bytes())?;
        out.put_all(sums, |halves| halves.map(|half| half.map(f32::to_le_bytes)))?;
        if let Some(splats) = splats {
            out.put_all(splats.parts().1, |halves| halves.map(|half| half.map(i64::to_le_bytes)))?;
        }
    }
    let sum = out.hasher.finalize();
    to.write_all(&sum.to_le_bytes())
}

/// A writer that sums up.
struct Summed<'w> {
    inner: &'w mut dyn Write,
    hasher: Hasher,
}

impl Summed<'_> {
    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.hasher.update(bytes);
        self.inner.write_all(bytes)
    }

    fn put_all<T, const N: usize>(&mut self, all: &[T], bytes: impl Fn(&T) -> [[[u8; N]; 3]; 2]) -> io::Result<()> {
        let mut buffer = Vec::with_capacity(6 * N * TOGETHER);
        for some in all.chunks(TOGETHER) {
            buffer.clear();
            some.iter().for_each(|one| buffer.extend_from_slice(bytes(one).as_flattened().as_flattened()));
            self.put(&buffer)?;
        }
        Ok(())
    }
}

/// Reads a film of a file so many bytes long.
///
/// # Errors
/// Why it is none, or damaged.
pub fn read(from: impl Read, length: u64) -> Result<Reel, String> {
    let mut source = Source { inner: from, hasher: Hasher::new(), left: length };
    let magic = source.take::<8>().ok();
    if magic != Some(MAGIC) {
        return Err("is no film".to_owned());
    }
    let version = source.number()?;
    if version != VERSION {
        return Err(format!("is a film of version {version}, which is not known; valid: {VERSION}"));
    }
    let (width, height) = (source.number()?, source.number()?);
    let pixels = u64::from(width) * u64::from(height);
    let scene = source.take::<32>()?;
    let seconds = f64::from_le_bytes(source.take()?);
    if pixels == 0 || !(0.0..f64::INFINITY).contains(&seconds) {
        return Err(damaged("a size or a time is absurd"));
    }
    let (name, manner) = told(&source.text()?).ok_or_else(|| damaged("what it tells cannot be read"))?;
    let is_lit = source.number()?;
    let unit = i32::from_le_bytes(source.take()?);
    let count = source.number()?;
    if is_lit > 1 || !(1..=MOST_BRANCHES).contains(&count) {
        return Err(damaged("a count is absurd"));
    }
    let is_lit = is_lit == 1;
    // Nothing is held before the file is known to be as long as all that takes.
    let of_pixel = SUMS + if is_lit { SPLATS } else { 0 };
    let of_branch = u128::from(pixels) * u128::from(of_pixel) + u128::from(BRANCH);
    let (expected, left) = (u128::from(count) * of_branch + u128::from(SUM), u128::from(source.left));
    if expected != left {
        let whole = expected + u128::from(length - source.left);
        return Err(damaged(&format!("it has {length} bytes, and {whole} are told")));
    }
    let mut film = Film::new(width, height);
    let mut end = 0;
    for _ in 0..count {
        let pairs = branch([source.number()?, source.number()?], end).ok_or_else(|| damaged("a range is absurd"))?;
        end = pairs.end;
        let sums: Vec<Halves> = source.all(pixels, |halves| halves.map(|half| half.map(f32::from_le_bytes)))?;
        let splats = match is_lit {
            true => {
                let sums = source.all(pixels, |halves| halves.map(|half| half.map(i64::from_le_bytes)))?;
                Some(Splats::of_parts(unit, sums))
            }
            false => None,
        };
        film.add_lit(pairs, sums, splats).map_err(|_| damaged("it has some samples twice"))?;
    }
    let sum = source.hasher.clone().finalize();
    if source.take()? != sum.to_le_bytes() {
        return Err(damaged("its checksum is not that of what it has"));
    }
    Ok(Reel { head: Head { name, scene, manner, seconds }, film })
}

fn damaged(why: &str) -> String {
    format!("is damaged: {why}")
}

/// A branch of the tree that begins at or after `end`.
fn branch([start, span]: [u32; 2], end: u32) -> Option<Range<u32>> {
    let is_branch = start >= end && span.is_power_of_two() && start.is_multiple_of(span);
    let last = start.checked_add(span).filter(|last| *last <= MOST_PAIRS)?;
    is_branch.then_some(start..last)
}

/// A name and the lines after it. Control characters would be the terminal's.
fn told(text: &str) -> Option<(String, Vec<(String, String)>)> {
    let is_plain = !text.chars().any(|c| c.is_control() && c != '\n');
    let mut lines = text.strip_suffix('\n').filter(|_| is_plain)?.split('\n');
    let name = lines.next()?.to_owned();
    let pair = |line: &str| line.split_once(": ").map(|(key, value)| (key.to_owned(), value.to_owned()));
    Some((name, lines.map(pair).collect::<Option<_>>()?))
}

/// A reader that sums up and knows how many bytes are left.
struct Source<R> {
    inner: R,
    hasher: Hasher,
    left: u64,
}

impl<R: Read> Source<R> {
    fn fill(&mut self, buffer: &mut [u8]) -> Result<(), String> {
        let short = || damaged("it ends too early");
        self.left = self.left.checked_sub(buffer.len() as u64).ok_or_else(short)?;
        self.inner.read_exact(buffer).map_err(|error| match error.kind() {
            io::ErrorKind::UnexpectedEof => short(),
            _ => format!("cannot be read: {error}"),
        })?;
        self.hasher.update(buffer);
        Ok(())
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let mut buffer = [0; N];
        self.fill(&mut buffer)?;
        Ok(buffer)
    }

    fn number(&mut self) -> Result<u32, String> {
        self.take().map(u32::from_le_bytes)
    }

    fn text(&mut self) -> Result<String, String> {
        let length = self.number()?;
        if length > MOST_TOLD {
            return Err(damaged("a text is absurdly long"));
        }
        let mut text = vec![0; length as usize];
        self.fill(&mut text)?;
        String::from_utf8(text).map_err(|_| damaged("a text is none"))
    }

    fn all<T, const N: usize>(&mut self, count: u64, of: impl Fn([[[u8; N]; 3]; 2]) -> T) -> Result<Vec<T>, String> {
        // The file is as long as that, so that no more is asked for than there is.
        let mut all = Vec::with_capacity(usize::try_from(count).map_err(|_| "is too large for this machine")?);
        let mut buffer = vec![0; 6 * N * TOGETHER];
        while (all.len() as u64) < count {
            let some = (count - all.len() as u64).min(TOGETHER as u64) as usize;
            let bytes = &mut buffer[..6 * N * some];
            self.fill(bytes)?;
            let (numbers, _) = bytes.as_chunks::<N>();
            all.extend(numbers.chunks_exact(6).map(|six| of([[six[0], six[1], six[2]], [six[3], six[4], six[5]]])));
        }
        Ok(all)
    }
}
