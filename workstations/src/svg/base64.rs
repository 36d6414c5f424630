//! Base 64 (RFC 4648, section 4), for what is embedded in documents.

use super::document::Document;
use std::io::{self, Write};

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// A writer that appends what is written to a document in base 64.
pub(super) struct Base64<'d> {
    document: &'d mut Document,
    /// Bytes of a group of three that is not complete.
    pending: [u8; 3],
    count: usize,
}

impl<'d> Base64<'d> {
    pub(super) fn new(document: &'d mut Document) -> Self {
        Base64 { document, pending: [0; 3], count: 0 }
    }

    fn group(&mut self) {
        let [a, b, c] = self.pending.map(u32::from);
        let bits = a << 16 | b << 8 | c;
        for i in 0..4 {
            let digit = bits >> (18 - 6 * i) & 63;
            self.document.out.push(if i > self.count { b'=' } else { ALPHABET[digit as usize] });
        }
        self.pending = [0; 3];
        self.count = 0;
    }

    /// Completes the text.
    pub(super) fn finish(mut self) -> io::Result<()> {
        if self.count > 0 {
            self.group();
        }
        self.document.spill()
    }
}

impl Write for Base64<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for chunk in bytes.chunks(1 << 12) {
            for &byte in chunk {
                self.pending[self.count] = byte;
                self.count += 1;
                if self.count == 3 {
                    self.group();
                }
            }
            self.document.spill()?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::device::Sink;

    struct Nowhere;

    impl Sink for Nowhere {
        fn open(&mut self) -> io::Result<()> {
            Ok(())
        }
        fn write(&mut self, _: &[u8]) -> io::Result<()> {
            Ok(())
        }
        fn finish(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn test_vectors_of_the_rfc() {
        let cases = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, coded) in cases {
            let mut document = Document::new(Box::new(Nowhere));
            let mut writer = Base64::new(&mut document);
            for byte in plain.bytes() {
                writer.write_all(&[byte]).unwrap();
            }
            writer.finish().unwrap();
            assert_eq!(String::from_utf8(document.out).unwrap(), coded);
        }
    }
}
