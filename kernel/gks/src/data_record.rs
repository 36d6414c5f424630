//! Data records: values whose number and meaning depend on the function they are given to.

use crate::{Error, Function, Result};
use std::fmt::Write;

/// A data record: integers, reals and strings in order, as ESCAPE and GENERALIZED DRAWING PRIMITIVE take it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DataRecord {
    /// The integers.
    pub integers: Vec<i32>,
    /// The reals.
    pub reals: Vec<f64>,
    /// The strings.
    pub strings: Vec<String>,
}

/// A line of a packed data record: what Fortran calls CHARACTER*80.
pub type Line = [u8; LINE];

const LINE: usize = 80;

/// The first word of a packed record; the number is the version of the format.
const MAGIC: &str = "GKSDR1";

/// The mark after a real whose digits identify it among numbers of single precision only.
const SINGLE: char = 's';

impl DataRecord {
    /// The record with these values.
    pub fn new(integers: &[i32], reals: &[f64], strings: &[&str]) -> Self {
        DataRecord {
            integers: integers.to_vec(),
            reals: reals.to_vec(),
            strings: strings.iter().map(|&s| s.to_owned()).collect(),
        }
    }

    /// Whether there is no value in the record.
    pub fn is_empty(&self) -> bool {
        self.integers.is_empty() && self.reals.is_empty() && self.strings.is_empty()
    }

    /// PACK DATA RECORD: the record as lines of text, at most `max_lines` of them, the last one filled up
    /// with blanks.
    ///
    /// The text is one stream of words with a blank after each, cut every 80 bytes: a magic word, the numbers
    /// of integers, reals and strings, the integers, the reals, and each string as its length in bytes, a
    /// colon and its bytes. [`DataRecord::unpack`] gives back what was packed, bit by bit but for the payload
    /// of a NaN. Error: 2001 (too few lines).
    pub fn pack(&self, max_lines: usize) -> Result<Vec<Line>> {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = write!(text, "{MAGIC} ");
        for count in [self.integers.len(), self.reals.len(), self.strings.len()] {
            let _ = write!(text, "{count} ");
        }
        for integer in &self.integers {
            let _ = write!(text, "{integer} ");
        }
        for &real in &self.reals {
            // Fortran's reals have fewer digits, which keeps records in few lines.
            let single = real as f32;
            let _ = if f64::from(single) == real {
                write!(text, "{single:?}{SINGLE} ")
            } else {
                write!(text, "{real:?} ")
            };
        }
        for string in &self.strings {
            let _ = write!(text, "{}:{string} ", string.len());
        }
        let text = text.strip_suffix(' ').unwrap_or(&text).as_bytes();
        let lines = text.len().div_ceil(LINE);
        if lines > max_lines {
            let detail = format!("{lines} lines needed, {max_lines} given");
            return Err(Error::new(2001, Function::PackDataRecord).because(detail));
        }
        let filled = |chunk: &[u8]| {
            let mut line = [b' '; LINE];
            line[..chunk.len()].copy_from_slice(chunk);
            line
        };
        Ok(text.chunks(LINE).map(filled).collect())
    }

    /// UNPACK DATA RECORD: the record that [`DataRecord::pack`] wrote into lines.
    ///
    /// Lines that hold no packed record, a part of one, or anything behind it are refused. Error: 2003.
    pub fn unpack(lines: &[Line]) -> Result<Self> {
        DataRecord::unpack_bytes(lines.as_flattened())
    }

    /// The record that [`DataRecord::pack`] wrote, from its lines in one piece; the blanks at its end may be
    /// missing. Error: 2003.
    pub fn unpack_bytes(bytes: &[u8]) -> Result<Self> {
        let mut words = Words { rest: bytes };
        words.record().ok_or_else(|| Error::new(2003, Function::UnpackDataRecord))
    }
}

/// A data record as it is handed to a function: its values, or the lines of a packed record, which may turn out to hold
/// none when it is its turn to be checked.
#[derive(Clone, Copy, Debug)]
pub enum GivenRecord<'a> {
    /// The values.
    Values(&'a DataRecord),
    /// What PACK DATA RECORD wrote. Without a line, or with nothing in the lines, it is an empty record.
    Packed(&'a [Line]),
}

impl GivenRecord<'_> {
    /// The values; `None` if the lines hold no record.
    pub(crate) fn values(self) -> Option<DataRecord> {
        let is_nothing = |byte: &u8| matches!(byte, b' ' | 0);
        match self {
            GivenRecord::Values(record) => Some(record.clone()),
            GivenRecord::Packed(lines) if lines.as_flattened().iter().all(is_nothing) => {
                Some(DataRecord::default())
            }
            GivenRecord::Packed(lines) => DataRecord::unpack(lines).ok(),
        }
    }
}

impl<'a> From<&'a DataRecord> for GivenRecord<'a> {
    fn from(record: &'a DataRecord) -> Self {
        GivenRecord::Values(record)
    }
}

impl<'a> From<&'a [Line]> for GivenRecord<'a> {
    fn from(lines: &'a [Line]) -> Self {
        GivenRecord::Packed(lines)
    }
}

/// The bytes of a packed record that have not been read yet.
struct Words<'a> {
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    fn record(&mut self) -> Option<DataRecord> {
        if self.word()? != MAGIC {
            return None;
        }
        let [integers, reals, strings]: [usize; 3] = [self.number()?, self.number()?, self.number()?];
        // The counts are not trusted: memory grows only with values that are really there.
        let record = DataRecord {
            integers: (0..integers).map(|_| self.number()).collect::<Option<_>>()?,
            reals: (0..reals).map(|_| self.real()).collect::<Option<_>>()?,
            strings: (0..strings).map(|_| self.string()).collect::<Option<_>>()?,
        };
        self.rest.iter().all(|&b| b == b' ').then_some(record)
    }

    /// The bytes before the next `end`, which is left out.
    fn until(&mut self, end: u8) -> Option<&'a str> {
        let at = self.rest.iter().position(|&b| b == end).unwrap_or(self.rest.len());
        let (bytes, rest) = self.rest.split_at(at);
        self.rest = rest.get(1..).unwrap_or_default();
        str::from_utf8(bytes).ok().filter(|s| !s.is_empty())
    }

    fn word(&mut self) -> Option<&'a str> {
        self.until(b' ')
    }

    fn number<N: std::str::FromStr>(&mut self) -> Option<N> {
        self.word()?.parse().ok()
    }

    fn real(&mut self) -> Option<f64> {
        let word = self.word()?;
        match word.strip_suffix(SINGLE) {
            Some(single) => single.parse::<f32>().ok().map(f64::from),
            None => word.parse().ok(),
        }
    }

    fn string(&mut self) -> Option<String> {
        let length: usize = self.until(b':')?.parse().ok()?;
        // Blanks at the very end of a record are those that fill up its last line.
        let bytes = self.rest.get(..length)?;
        let rest = &self.rest[length..];
        if rest.first().is_some_and(|&b| b != b' ') {
            return None;
        }
        self.rest = rest.get(1..).unwrap_or_default();
        str::from_utf8(bytes).ok().map(str::to_owned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::number;

    fn lines(text: &str) -> Vec<Line> {
        let filled = |chunk: &[u8]| std::array::from_fn(|i| chunk.get(i).copied().unwrap_or(b' '));
        text.as_bytes().chunks(LINE).map(filled).collect()
    }

    fn there_and_back(record: &DataRecord) -> DataRecord {
        DataRecord::unpack(&record.pack(1000).unwrap()).unwrap()
    }

    #[test]
    fn a_record_is_one_line_of_readable_text() {
        let record = DataRecord::new(&[1, -70_000, 12_345], &[1.5, -0.25], &["ONE", "TWELVE CHARS"]);
        let text = "GKSDR1 3 2 2 1 -70000 12345 1.5s -0.25s 3:ONE 12:TWELVE CHARS";
        assert_eq!(record.pack(1).unwrap(), lines(text));
        assert_eq!(there_and_back(&record), record);
    }

    #[test]
    fn every_value_comes_back() {
        let reals = [0.1, f64::from(0.1_f32), 1e300, -5e-324, -0.0, f64::MAX, 1e-40, f64::NEG_INFINITY];
        let strings = ["", " ", "ends in blanks   ", "2:x", "größer als 80 Bytes, ".repeat(9).as_str()]
            .map(str::to_owned)
            .to_vec();
        let record = DataRecord { integers: vec![i32::MIN, 0, i32::MAX], reals: reals.to_vec(), strings };
        let back = there_and_back(&record);
        assert_eq!(back, record);
        assert!(back.reals[4].is_sign_negative());
        assert!(there_and_back(&DataRecord::new(&[], &[f64::NAN], &[])).reals[0].is_nan());
        for empty in ["", "    "] {
            let record = DataRecord::new(&[], &[], &[empty]);
            assert_eq!(there_and_back(&record), record);
        }
        // A string that reaches exactly to the end of a line, and one whose blanks begin there.
        for length in 60..90 {
            for record in [
                DataRecord::new(&[], &[], &["x".repeat(length).as_str()]),
                DataRecord::new(&[], &[], &[("x".repeat(length) + &" ".repeat(100)).as_str()]),
                DataRecord::new(&vec![7; length], &[], &["", ""]),
            ] {
                assert_eq!(there_and_back(&record), record);
            }
        }
    }

    #[test]
    fn a_record_that_is_too_long_is_refused() {
        let numbers: Vec<i32> = (1..=200).collect();
        let record = DataRecord::new(&numbers, &[], &[]);
        assert_eq!(number(record.pack(1)), 2001);
        let lines = record.pack(100).unwrap();
        assert_eq!(record.pack(lines.len()).unwrap(), lines);
        assert_eq!(number(record.pack(lines.len() - 1)), 2001);
        assert_eq!(number(DataRecord::default().pack(0)), 2001);
        assert!(there_and_back(&DataRecord::default()).is_empty());
    }

    #[test]
    fn what_was_not_packed_is_refused() {
        for text in [
            "",
            "     ",
            "anything",
            "GKSDR2 0 0 0",
            "GKSDR1 0 0",
            "GKSDR1 0 0 0 1",
            "GKSDR1 1 0 0",
            "GKSDR1 -1 0 0",
            "GKSDR1 1 0 0 1.5",
            "GKSDR1 1 0 0 3000000000",
            "GKSDR1 0 1 0 ss",
            "GKSDR1 0 0 1 3:ONE2",
            "GKSDR1 0 0 1 100:ONE",
            "GKSDR1 0 0 1 ONE",
            "GKSDR1 0 0 1 99999999999999999999:ONE",
            "GKSDR1 18446744073709551615 18446744073709551615 18446744073709551615 1",
        ] {
            assert_eq!(number(DataRecord::unpack(&lines(text))), 2003, "{text}");
        }
        assert_eq!(number(DataRecord::unpack(&[[0xff; LINE]])), 2003);
        let whole = DataRecord::new(&[123_456_789; 40], &[], &["string"]).pack(100).unwrap();
        assert_eq!(number(DataRecord::unpack(&whole[..whole.len() - 1])), 2003);
        assert_eq!(number(DataRecord::unpack(&whole[1..])), 2003);
    }
}
