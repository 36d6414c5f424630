//! Character sets of the callers.

use std::borrow::Cow;

/// Text in Latin-1, as Fortran programs have it; a NUL ends it. Text that is valid UTF-8 with characters
/// beyond ASCII is taken as UTF-8: modern sources are written so.
pub fn from_latin1(bytes: &[u8]) -> Cow<'_, str> {
    let end = bytes.iter().position(|&b| b == 0).unwrap_or(bytes.len());
    from_utf8_or_latin1(&bytes[..end])
}

/// Text in UTF-8, or in Latin-1 if it is not valid UTF-8.
pub fn from_utf8_or_latin1(bytes: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|&b| char::from(b)).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latin1_and_utf8_are_told_apart() {
        assert_eq!(from_latin1(b"caf\xe9"), "café");
        assert_eq!(from_latin1("café".as_bytes()), "café");
        assert_eq!(from_latin1(b"cut\0off"), "cut");
    }
}
