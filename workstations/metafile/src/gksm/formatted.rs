//! Numbers as text.

use super::header::Header;
use gks_pipeline::record::item::{Convention, kind};

/// Appends a real with all its digits, an exponent and a decimal point, right in a field.
pub(super) fn write_real(out: &mut Vec<u8>, value: f64, width: usize) {
    let digits = format!("{value:E}");
    let text = match digits.split_once('E') {
        Some((mantissa, exponent)) if !mantissa.contains('.') => format!("{mantissa}.0E{exponent}"),
        _ => digits,
    };
    write_field(out, &text, width);
}

/// Appends an integer right in a field.
pub(super) fn write_integer(out: &mut Vec<u8>, value: i64, width: usize) {
    write_field(out, &value.to_string(), width);
}

fn write_field(out: &mut Vec<u8>, text: &str, width: usize) {
    out.resize(out.len() + width.saturating_sub(text.len()), b' ');
    out.extend_from_slice(text.as_bytes());
}

/// Where the fields of formatted numbers begin and end.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    /// They have the widths that the header says, and nothing is between them. Binary numbers have this too.
    Exact,
    /// The same, but the file is cut into lines anywhere.
    Wrapped,
    /// They have other widths, with blanks between; every item is a line.
    Scanned,
}

impl Layout {
    /// The layout of a file whose items begin with these bytes.
    pub(super) fn of(header: &Header, first: &[u8]) -> Layout {
        if !header.formatted || header.convention() == Convention::Own {
            return Layout::Exact;
        }
        let mut lines = first.split(|&byte| byte == b'\n').filter(|line| !line.trim_ascii().is_empty());
        let mut line = lines.next().unwrap_or_default();
        let item = whole(&mut line).zip(whole(&mut line));
        let is_line = item.is_some_and(|(kind, length)| kind >= 0 && length >= 0);
        if is_line && !fits(header, first) { Layout::Scanned } else { Layout::Wrapped }
    }
}

/// Whether the first item has the widths that the header says: then the next one has its head where the first
/// one ends.
fn fits(header: &Header, first: &[u8]) -> bool {
    let stream: Vec<u8> = first.iter().copied().filter(|&byte| !newline(byte)).collect();
    let head = |from: usize| {
        let kind_at = from + header.mark;
        let length_at = kind_at + header.kind;
        let kind = integer(stream.get(kind_at..length_at)?)?;
        let length = usize::try_from(integer(stream.get(length_at..length_at + header.length)?)?).ok()?;
        let kind = i32::try_from(kind).ok().filter(|&k| kind::is_standard(k) || k > kind::LAST)?;
        Some((kind, length_at + header.length + length))
    };
    match head(0) {
        None => false,
        Some((kind::END, _)) => true,
        Some((_, end)) => end >= stream.len() || head(end).is_some(),
    }
}

/// Whether a byte ends a line, or is a part of what does.
pub(super) fn newline(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// An integer as text.
pub(super) fn integer(field: &[u8]) -> Option<i64> {
    str::from_utf8(field).ok()?.trim().parse().ok()
}

/// The next word, which is taken away.
pub(super) fn token<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let start = rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
    let text = &rest[start..];
    let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
    *rest = &text[end..];
    Some(&text[..end])
}

/// The next integer, which is taken away; characters may follow it at once.
pub(super) fn whole(rest: &mut &[u8]) -> Option<i64> {
    let start = rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
    let text = &rest[start..];
    let sign = usize::from(matches!(text[0], b'+' | b'-'));
    let digits = text[sign..].iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(text.len() - sign);
    let (number, after) = text.split_at(sign + digits);
    *rest = after;
    integer(number)
}
