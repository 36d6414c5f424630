//! Bytes as printable characters: five for four (PostScript Language Reference, 3rd edition, 3.13.3).

/// The longest line of digits.
const COLUMNS: usize = 78;

/// Encodes a sequence of bytes that comes in pieces.
#[derive(Default)]
pub(crate) struct Ascii85 {
    group: [u8; 4],
    filled: usize,
    column: usize,
}

impl Ascii85 {
    /// Appends the digits of `bytes`.
    pub(crate) fn write(&mut self, bytes: &[u8], out: &mut Vec<u8>) {
        for &byte in bytes {
            self.group[self.filled] = byte;
            self.filled += 1;
            if self.filled == 4 {
                self.filled = 0;
                if self.group == [0; 4] {
                    self.put(b"z", out);
                } else {
                    self.put(&digits(self.group), out);
                }
            }
        }
    }

    /// Appends what remains, and the end mark on a line that the next character shares.
    pub(crate) fn finish(mut self, out: &mut Vec<u8>) {
        if self.filled > 0 {
            self.group[self.filled..].fill(0);
            let digits = digits(self.group);
            self.put(&digits[..=self.filled], out);
        }
        out.extend_from_slice(b"~>");
    }

    fn put(&mut self, digits: &[u8], out: &mut Vec<u8>) {
        // A line that began with a percent sign could be taken for a comment of the document's structure.
        if self.column + digits.len() > COLUMNS && digits.first() != Some(&b'%') {
            out.push(b'\n');
            self.column = 0;
        }
        out.extend_from_slice(digits);
        self.column += digits.len();
    }
}

fn digits(group: [u8; 4]) -> [u8; 5] {
    let mut value = u32::from_be_bytes(group);
    let mut digits = [0; 5];
    for digit in digits.iter_mut().rev() {
        *digit = b'!' + (value % 85) as u8;
        value /= 85;
    }
    digits
}

#[cfg(test)]
mod tests {
    use super::*;

    fn encoded(bytes: &[u8], piece: usize) -> String {
        let (mut encoder, mut out) = (Ascii85::default(), Vec::new());
        for part in bytes.chunks(piece) {
            encoder.write(part, &mut out);
        }
        encoder.finish(&mut out);
        String::from_utf8(out).unwrap()
    }

    /// The bytes again, by the rules of the decoding filter.
    fn decoded(text: &str) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut group = Vec::new();
        for byte in text.strip_suffix("~>").unwrap().bytes().filter(|byte| !byte.is_ascii_whitespace()) {
            match byte {
                b'z' => bytes.extend([0; 4]),
                _ => group.push(byte - b'!'),
            }
            if group.len() == 5 {
                let value = group.drain(..).fold(0_u32, |value, digit| value * 85 + u32::from(digit));
                bytes.extend(value.to_be_bytes());
            }
        }
        if !group.is_empty() {
            let rest = group.len() - 1;
            group.resize(5, 84);
            let value = group.iter().fold(0_u64, |value, &digit| value * 85 + u64::from(digit));
            bytes.extend(&(value as u32).to_be_bytes()[..rest]);
        }
        bytes
    }

    #[test]
    fn bytes_come_back_in_short_lines() {
        let noise: Vec<u8> = (0..10_007_u32).map(|i| (i.wrapping_mul(i) >> 3) as u8).collect();
        for length in [0, 1, 2, 3, 4, 5, 400, 10_007] {
            let text = encoded(&noise[..length], 7);
            assert_eq!(decoded(&text), &noise[..length]);
            assert!(text.lines().all(|line| line.len() < 255 && !line.starts_with('%')));
        }
        assert_eq!(encoded(b"\0\0\0\0Man ", 3), "z9jqo^~>");
    }
}
