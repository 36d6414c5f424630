//! The fields of an item.

use super::formatted::{Layout, integer, token, whole};
use super::header::Header;
use gks_pipeline::record::item::{Get, Unreadable, finite};

/// The fields of an item, as far as they have not been read.
pub(super) struct Fields<'a> {
    header: &'a Header,
    layout: Layout,
    big_endian: bool,
    data: &'a [u8],
}

impl<'a> Fields<'a> {
    /// The fields in the data of an item.
    pub(super) fn new(header: &'a Header, layout: Layout, big_endian: bool, data: &'a [u8]) -> Self {
        Fields { header, layout, big_endian, data }
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], Unreadable> {
        let (first, rest) = self.data.split_at_checked(count).ok_or(Unreadable::Short)?;
        self.data = rest;
        Ok(first)
    }

    fn whole(&mut self, width: usize) -> Result<i64, Unreadable> {
        if self.layout == Layout::Scanned {
            return whole(&mut self.data).ok_or(Unreadable::Short);
        }
        let field = self.take(width)?;
        let number = if self.header.formatted { integer(field) } else { binary(field, self.big_endian) };
        number.ok_or_else(|| Unreadable::value("no integer:", String::from_utf8_lossy(field)))
    }
}

impl Get for Fields<'_> {
    fn integer(&mut self) -> Result<i32, Unreadable> {
        let number = self.whole(self.header.integer)?;
        i32::try_from(number).map_err(|_| Unreadable::value("an integer out of range:", number))
    }

    fn real(&mut self) -> Result<f64, Unreadable> {
        if let Some((zero, one)) = self.header.scale {
            let number = self.whole(self.header.real)? as f64;
            return finite((number - f64::from(zero)) / (f64::from(one) - f64::from(zero)));
        }
        if self.header.formatted {
            let field = match self.layout {
                Layout::Scanned => token(&mut self.data).ok_or(Unreadable::Short)?,
                _ => self.take(self.header.real)?,
            };
            let unreadable = || Unreadable::value("no real:", String::from_utf8_lossy(field));
            return finite(real(field, self.header.implies_point()).ok_or_else(unreadable)?);
        }
        let field = self.take(self.header.real)?;
        match (field, self.big_endian) {
            (&[a, b, c, d], false) | (&[d, c, b, a], true) => finite(f32::from_le_bytes([a, b, c, d]).into()),
            (&[a, b, c, d, e, f, g, h], false) | (&[h, g, f, e, d, c, b, a], true) => {
                finite(f64::from_le_bytes([a, b, c, d, e, f, g, h]))
            }
            _ => Err(Unreadable::value("a real of bytes:", field.len())),
        }
    }

    fn characters(&mut self, count: usize) -> Result<&[u8], Unreadable> {
        self.take(count)
    }

    fn rest(&mut self) -> &[u8] {
        std::mem::take(&mut self.data)
    }

    fn left(&self) -> usize {
        let least =
            if self.layout == Layout::Scanned { 2 } else { self.header.integer.min(self.header.real) };
        self.data.len().div_ceil(least)
    }
}

/// A real as text; one without a point may count ten-millionths.
fn real(field: &[u8], implies_point: bool) -> Option<f64> {
    let text = str::from_utf8(field).ok()?.trim();
    if implies_point && !text.contains(['.', 'E', 'e']) {
        return Some(text.parse::<i64>().ok()? as f64 / 1e7);
    }
    // Fortran writes exponents of double precision with a D.
    match text.contains(['D', 'd']) {
        true => text.replace(['D', 'd'], "E").parse().ok(),
        false => text.parse().ok(),
    }
}

/// An integer of 1, 2, 4 or 8 bytes.
pub(super) fn binary(field: &[u8], big_endian: bool) -> Option<i64> {
    if !matches!(field.len(), 1 | 2 | 4 | 8) {
        return None;
    }
    let add = |value: i64, &byte: &u8| value << 8 | i64::from(byte);
    let value = if big_endian { field.iter().fold(0, add) } else { field.iter().rev().fold(0, add) };
    let unused = 64 - 8 * field.len() as u32;
    Some(value << unused >> unused)
}
