//! The bytes of a glTF file, and the numbers in them. Nothing is believed before it is there: what an accessor promises is held
//! against its buffer, so that no more memory is taken than the file's own size asks for.

use super::super::meshes::{Files, LARGEST};
use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions};
use gltf::{Accessor, Document, buffer};
use std::borrow::Cow;
use std::path::Path;

/// The most rows that an accessor may stand for without a view of its own: no bytes of the file are behind them.
const ZEROS: usize = 1 << 20;

/// What every `.glb` begins with.
const MAGIC: [u8; 4] = *b"glTF";

/// The two kinds of pieces that it has.
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BIN: u32 = u32::from_le_bytes(*b"BIN\0");

/// The text of a file, and the bytes that come with it.
pub fn pieces(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let Some(rest) = bytes.strip_prefix(&MAGIC) else { return Ok((bytes, None)) };
    let (head, mut rest) = rest.split_first_chunk::<8>().ok_or("ends within its header")?;
    let number = |bytes: &[u8]| bytes.iter().rev().fold(0_u32, |sum, byte| sum << 8 | u32::from(*byte));
    let (version, length) = (number(&head[..4]), number(&head[4..]));
    if version != 2 {
        return Err(format!("is of version {version}; valid: 2"));
    }
    if length as usize != bytes.len() {
        return Err(format!("says that it has {length} bytes, and has {}", bytes.len()));
    }
    let (mut text, mut data) = (None, None);
    while !rest.is_empty() {
        let (head, after) = rest.split_first_chunk::<8>().ok_or("ends within a piece's header")?;
        let (size, kind) = (number(&head[..4]) as usize, number(&head[4..]));
        if size > after.len() {
            return Err(format!("has a piece of {size} bytes, and {} are left", after.len()));
        }
        let (piece, left) = after.split_at(size);
        match kind {
            JSON if text.is_none() => text = Some(piece),
            BIN if data.is_none() && text.is_some() => data = Some(piece),
            // Others are for others.
            _ => {}
        }
        rest = left;
    }
    Ok((text.ok_or("has no piece with its text")?, data))
}

/// What a URI stands for.
pub fn fetched(uri: &str, folder: &Path, files: Files) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once(";base64,").ok_or("is a data URI without ;base64,")?;
        return base64(text);
    }
    if uri.contains("://") {
        return Err(format!("`{}` is not beside the file; valid: a file's name", chapters::parameter::excerpt(uri)));
    }
    let name = unescaped(uri);
    files(&folder.join(&name)).map_err(|why| format!("{} {why}", chapters::parameter::excerpt(&name)))
}

/// Text with its %20 and the like as they are meant.
fn unescaped(uri: &str) -> String {
    let bytes = uri.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while at < bytes.len() {
        let escaped = bytes.get(at + 1..at + 3).and_then(|two| std::str::from_utf8(two).ok());
        match escaped.filter(|_| bytes[at] == b'%').and_then(|two| u8::from_str_radix(two, 16).ok()) {
            Some(byte) => {
                out.push(byte);
                at += 3;
            }
            None => {
                out.push(bytes[at]);
                at += 1;
            }
        }
    }
    String::from_utf8(out).unwrap_or_else(|_| uri.to_owned())
}

/// RFC 4648, with or without its padding.
fn base64(text: &str) -> Result<Vec<u8>, String> {
    let text = text.trim_end_matches('=');
    let mut out = Vec::with_capacity(text.len() / 4 * 3 + 2);
    let (mut held, mut bits) = (0_u32, 0);
    for (at, sign) in text.bytes().enumerate() {
        let value = match sign {
            b'A'..=b'Z' => sign - b'A',
            b'a'..=b'z' => sign - b'a' + 26,
            b'0'..=b'9' => sign - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return Err(format!("is a data URI whose sign {at} is none of base64")),
        };
        held = held << 6 | u32::from(value);
        bits += 6;
        if bits >= 8 {
            bits -= 8;
            out.push((held >> bits) as u8);
            held &= (1 << bits) - 1;
        }
    }
    // One sign alone is no byte.
    if text.len() % 4 == 1 { Err("is a data URI that is cut off".into()) } else { Ok(out) }
}

/// What lets positions and the like be whole numbers, which nodes' matrices bring to their size.
pub const QUANTIZATION: &str = "KHR_mesh_quantization";

/// The buffers of a document.
pub struct Data {
    buffers: Vec<Vec<u8>>,
    is_quantized: bool,
}

impl Data {
    pub fn open(document: &Document, own: Option<&[u8]>, folder: &Path, files: Files) -> Result<Self, String> {
        let one = |buffer: buffer::Buffer| {
            let place = format!("buffers[{}]", buffer.index());
            let bytes = match buffer.source() {
                // A file carries one, its first.
                buffer::Source::Bin => own
                    .filter(|_| buffer.index() == 0)
                    .map(<[u8]>::to_vec)
                    .ok_or_else(|| format!("{place}: is not in the file; valid: a uri"))?,
                buffer::Source::Uri(uri) => fetched(uri, folder, files).map_err(|why| format!("{place}: {why}"))?,
            };
            match bytes.len() >= buffer.length() {
                true => Ok(bytes),
                false => Err(format!("{place}: has {} bytes, and promises {}", bytes.len(), buffer.length())),
            }
        };
        let (mut all, mut size) = (Vec::new(), 0);
        for buffer in document.buffers() {
            let bytes = one(buffer)?;
            // A file can name another, or itself, many times.
            size += bytes.len() as u64;
            if size > LARGEST {
                return Err(format!("its buffers are larger than {} MiB, the most that is read", LARGEST >> 20));
            }
            all.push(bytes);
        }
        let is_quantized = document.extensions_used().any(|name| name == QUANTIZATION);
        Ok(Self { buffers: all, is_quantized })
    }

    /// The bytes of a view.
    pub fn view(&self, view: &buffer::View) -> Result<&[u8], String> {
        let bytes = &self.buffers[view.buffer().index()];
        let end = view.offset().checked_add(view.length()).filter(|end| *end <= bytes.len());
        let end =
            end.ok_or_else(|| format!("bufferViews[{}]: is beyond its buffer's {} bytes", view.index(), bytes.len()))?;
        Ok(&bytes[view.offset()..end])
    }

    /// The numbers of an accessor, so many a row, each by its kind; those that it says otherwise of (sparse) put in.
    fn rows(&self, accessor: &Accessor, parts: usize) -> Result<Rows<'_>, String> {
        let place = format!("accessors[{}]", accessor.index());
        let (size, count) = (parts * width(accessor.data_type()), accessor.count());
        let own = accessor.view().map(|view| self.placed(&view, accessor.offset(), view.stride(), size, count));
        let own = own.transpose().map_err(|why| format!("{place}: {why}"))?;
        let Some(sparse) = accessor.sparse() else { return own.ok_or_else(|| format!("{place}: has no bufferView")) };
        let mut all = match own {
            Some(own) => own.iter().flatten().copied().collect(),
            None if count <= ZEROS => vec![0; size * count],
            None => return Err(format!("{place}: stands for {count} rows of zeros; valid: up to {ZEROS}")),
        };
        let (indices, values) = (sparse.indices(), sparse.values());
        let wide = match indices.index_type() {
            IndexType::U8 => 1,
            IndexType::U16 => 2,
            IndexType::U32 => 4,
        };
        let told = |of: &'static str| {
            let place = &place;
            move |why: String| format!("{place}.sparse.{of}: {why}")
        };
        let at = self.placed(&indices.view(), indices.offset(), None, wide, sparse.count()).map_err(told("indices"))?;
        let values = self.placed(&values.view(), values.offset(), None, size, sparse.count());
        let mut next = 0;
        for (at, value) in at.iter().zip(values.map_err(told("values"))?.iter()) {
            let row = whole(at) as usize;
            if !(next..count).contains(&row) {
                return Err(told("indices")(format!(
                    "row {row} of {count}; valid: each is there, and above the one before"
                )));
            }
            all[row * size..][..size].copy_from_slice(value);
            next = row + 1;
        }
        Ok(Rows { bytes: Cow::Owned(all), size, stride: size, count })
    }

    /// So many rows of `size` bytes in a view.
    fn placed(
        &self,
        view: &buffer::View,
        offset: usize,
        stride: Option<usize>,
        size: usize,
        count: usize,
    ) -> Result<Rows<'_>, String> {
        let bytes = self.view(view)?;
        let stride = stride.unwrap_or(size);
        if stride < size {
            return Err(format!("rows of {size} bytes, {stride} apart"));
        }
        let end = |last: usize| last.checked_mul(stride)?.checked_add(size)?.checked_add(offset);
        match count.checked_sub(1).and_then(end).filter(|end| *end <= bytes.len()) {
            Some(end) => Ok(Rows { bytes: Cow::Borrowed(&bytes[offset..end]), size, stride, count }),
            None => Err(format!(
                "{count} rows of {size} bytes from byte {offset} on are not in its view's {} bytes",
                bytes.len()
            )),
        }
    }

    /// Rows of single numbers; whole ones stand for shares if the accessor says so, or for themselves in a file that says so.
    pub fn numbers<const K: usize>(
        &self,
        accessor: &Accessor,
        dimensions: Dimensions,
    ) -> Result<Vec<[f32; K]>, String> {
        let place = format!("accessors[{}]", accessor.index());
        let (kind, is_share) = (accessor.data_type(), accessor.normalized());
        let is_known = match kind {
            DataType::F32 => true,
            DataType::U8 | DataType::U16 => is_share || self.is_quantized,
            DataType::I8 | DataType::I16 => self.is_quantized,
            DataType::U32 => false,
        };
        if accessor.dimensions() != dimensions || !is_known {
            let found = (accessor.dimensions(), kind);
            return Err(format!("{place}: is {found:?}; valid: ({dimensions:?}, F32)"));
        }
        let rows = self.rows(accessor, K)?;
        let wide = width(kind);
        let row = |bytes: &[u8]| -> [f32; K] {
            std::array::from_fn(|at| number(&bytes[wide * at..][..wide], kind, is_share))
        };
        let rows: Vec<[f32; K]> = rows.iter().map(row).collect();
        match rows.iter().flatten().all(|number| number.is_finite()) {
            true => Ok(rows),
            false => Err(format!("{place}: has what is no finite number")),
        }
    }

    /// Whole numbers of any kind.
    pub fn indices(&self, accessor: &Accessor) -> Result<Vec<u32>, String> {
        let kind = accessor.data_type();
        if accessor.dimensions() != Dimensions::Scalar || !matches!(kind, DataType::U8 | DataType::U16 | DataType::U32)
        {
            let found = (accessor.dimensions(), kind);
            return Err(format!("accessors[{}]: is {found:?}; valid: whole numbers from 0", accessor.index()));
        }
        Ok(self.rows(accessor, 1)?.iter().map(whole).collect())
    }
}

/// Rows of an accessor, each so far behind the one before.
struct Rows<'d> {
    bytes: Cow<'d, [u8]>,
    size: usize,
    stride: usize,
    count: usize,
}

impl Rows<'_> {
    fn iter(&self) -> impl Iterator<Item = &[u8]> {
        (0..self.count).map(|row| &self.bytes[row * self.stride..][..self.size])
    }
}

/// A whole number, little end first.
fn whole(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |sum, byte| sum << 8 | u32::from(*byte))
}

/// A number of a kind; a whole one perhaps as a share of the largest (glTF 2.0, §3.11, "Animations": f = c/255 and the like).
fn number(bytes: &[u8], kind: DataType, is_share: bool) -> f32 {
    let part = |number: f32, most: i16| if is_share { (number / f32::from(most)).max(-1.0) } else { number };
    match kind {
        DataType::I8 => part(f32::from(bytes[0] as i8), i8::MAX.into()),
        DataType::U8 => part(f32::from(bytes[0]), u8::MAX.into()),
        DataType::I16 => part(f32::from(whole(bytes) as u16 as i16), i16::MAX),
        DataType::U16 if is_share => whole(bytes) as f32 / f32::from(u16::MAX),
        DataType::U16 | DataType::U32 => whole(bytes) as f32,
        DataType::F32 => f32::from_bits(whole(bytes)),
    }
}

fn width(kind: DataType) -> usize {
    match kind {
        DataType::I8 | DataType::U8 => 1,
        DataType::I16 | DataType::U16 => 2,
        DataType::U32 | DataType::F32 => 4,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_shares_of_the_largest_of_their_kind() {
        // glTF 2.0, §3.6.2.2, "Accessor Data Types", and §3.11: f = c/255, max(c/127, −1), c/65535, max(c/32767, −1).
        let shares = [
            (DataType::U8, [255, 0], 1.0),
            (DataType::U8, [51, 0], 0.2),
            (DataType::I8, [127, 0], 1.0),
            (DataType::I8, [0x80, 0], -1.0),
            (DataType::U16, [0xFF, 0xFF], 1.0),
            (DataType::U16, [0x33, 0x33], 0.2),
            (DataType::I16, [0xFF, 0x7F], 1.0),
            (DataType::I16, [0x00, 0x80], -1.0),
        ];
        for (kind, bytes, share) in shares {
            assert!((number(&bytes, kind, true) - share).abs() < 1e-7, "{kind:?} {bytes:?}");
        }
        let plain = [(DataType::I8, [0x80, 0], -128.0), (DataType::I16, [0x00, 0x80], -32768.0)];
        plain.into_iter().for_each(|(kind, bytes, own)| assert_eq!(number(&bytes, kind, false), own));
    }

    #[test]
    fn bytes_are_written_as_text_and_read_again() {
        // RFC 4648, §10.
        for (text, bytes) in
            [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYg", "foob"), ("Zm9vYmFy", "foobar")]
        {
            assert_eq!(base64(text).unwrap(), bytes.as_bytes());
        }
        assert_eq!(base64("-_").unwrap(), base64("+/").unwrap());
        for text in ["Z", "Zm9vY", "Zm 9", "Zg==x", "é"] {
            assert!(base64(text).is_err(), "{text}");
        }
        assert_eq!([unescaped("a%20b.bin"), unescaped("100%"), unescaped("%zz%2")], ["a b.bin", "100%", "%zz%2"]);
    }
}
