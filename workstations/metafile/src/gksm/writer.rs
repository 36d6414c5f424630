//! Writing a GKSM.

use super::formatted::{write_integer, write_real};
use super::header::Header;
use gks_pipeline::device::{DeviceError, Sink};
use gks_pipeline::item::Item;
use gks_pipeline::look_difference::{State, differences};
use gks_pipeline::record::item::{Put, encode, kind};
use gks_pipeline::record::{Attribute, Record, Recorder};
use std::time::{SystemTime, UNIX_EPOCH};

/// How numbers are coded.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum Coding {
    /// As the processor has them, the least significant byte first.
    #[default]
    Binary,
    /// As text, with all digits.
    Formatted,
}

/// A GKSM that is written. Reading it gives every number back to the last bit, in both codings.
pub struct Writer {
    sink: Box<dyn Sink>,
    /// The attributes in force for what was written last; none before the first primitive.
    known: Option<State>,
    begun: bool,
    items: Items,
}

impl Writer {
    /// The metafile that goes to a sink.
    pub fn new(sink: Box<dyn Sink>, coding: Coding) -> Writer {
        let header = Header::own(coding == Coding::Formatted);
        Writer { sink, known: None, begun: false, items: Items { header, out: Vec::new(), data: 0 } }
    }

    fn write(&mut self, record: &Record<'_>) -> Result<(), DeviceError> {
        encode(record, &mut self.items);
        self.flush()
    }

    fn flush(&mut self) -> Result<(), DeviceError> {
        if !self.begun {
            self.sink.open()?;
            self.begun = true;
            let mut text = self.items.header.text(&today());
            if self.items.header.formatted {
                text.push('\n');
            }
            self.sink.write(text.as_bytes())?;
        }
        let written = self.sink.write(&self.items.out);
        self.items.out.clear();
        Ok(written?)
    }
}

impl Recorder for Writer {
    fn draw(&mut self, item: &Item<'_>) -> Result<(), DeviceError> {
        let items = &mut self.items;
        match &mut self.known {
            Some(known) => differences(known, item, |value| encode(&Record::Attribute(value), items)),
            None => {
                // Readers start with attributes of their own.
                let state = State { look: item.look.clone(), clip: item.clip, pick: item.pick };
                for value in state.attributes() {
                    encode(&Record::Attribute(value), items);
                }
                self.known = Some(state);
            }
        }
        self.write(&Record::Primitive(item.shape))
    }

    fn control(&mut self, record: &Record<'_>) -> Result<(), DeviceError> {
        debug_assert!(!matches!(record, Record::Primitive(_) | Record::Attribute(Attribute::Cap(_))));
        self.write(record)?;
        if matches!(record, Record::Clear { .. }) {
            // A complete picture outlives the program.
            self.sink.flush()?;
        }
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        self.items.begin(kind::END);
        self.items.end();
        self.flush()?;
        Ok(self.sink.finish()?)
    }
}

/// Items as bytes.
struct Items {
    header: Header,
    out: Vec<u8>,
    /// Where the data of the item being written begin.
    data: usize,
}

impl Items {
    fn integer_of(&mut self, value: i32, width: usize) {
        if self.header.formatted {
            write_integer(&mut self.out, value.into(), width);
        } else {
            self.out.extend_from_slice(&value.to_le_bytes());
        }
    }
}

impl Put for Items {
    fn begin(&mut self, kind: i32) {
        self.out.extend_from_slice(&b"GKSM"[..self.header.mark]);
        self.integer_of(kind, self.header.kind);
        self.integer_of(0, self.header.length);
        self.data = self.out.len();
    }

    fn integer(&mut self, value: i32) {
        self.integer_of(value, self.header.integer);
    }

    fn real(&mut self, value: f64) {
        if self.header.formatted {
            write_real(&mut self.out, value, self.header.real);
        } else {
            self.out.extend_from_slice(&value.to_le_bytes());
        }
    }

    fn characters(&mut self, bytes: &[u8]) {
        self.out.extend_from_slice(bytes);
    }

    fn end(&mut self) {
        let length = self.out.len() - self.data;
        let mut field = Vec::new();
        if self.header.formatted {
            write_integer(&mut field, length as i64, self.header.length);
            self.out.push(b'\n');
        } else {
            field.extend_from_slice(&u32::try_from(length).unwrap_or(u32::MAX).to_le_bytes());
        }
        self.out[self.data - field.len()..self.data].copy_from_slice(&field);
    }
}

/// The date of today in UTC, yy/mm/dd.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (year, month, day) = date(seconds / 86_400);
    format!("{:02}/{month:02}/{day:02}", year % 100)
}

/// Year, month and day of a day counted from the first of January 1970 (Gregorian calendar).
fn date(days: u64) -> (u64, u64, u64) {
    // Years begin in March here, so that the day that is left out is the last one.
    let days = days + 719_468;
    let era = days / 146_097;
    let day = days % 146_097;
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let day_of_month = day - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    (era * 400 + year + u64::from(month <= 2), month, day_of_month)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_have_dates() {
        assert_eq!(date(0), (1970, 1, 1));
        assert_eq!(date(59), (1970, 3, 1));
        assert_eq!(date(11_016), (2000, 2, 29));
        assert_eq!(date(19_723), (2024, 1, 1));
        assert_eq!(date(20_454), (2026, 1, 1));
    }
}
