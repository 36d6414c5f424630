//! Arguments of Fortran subroutines, drawn from the input of a fuzzer.
//!
//! Most arguments are drawn from the few values that mean something, so that most calls get past the checks of
//! their arguments; the others are anything.

use arbitrary::Unstructured;
use gks_pipeline::generated::numbers::{WORKSTATION_TYPES, workstation_type as own};

/// The number of elements of an array, and of the characters of all strings of an array together.
const ARRAY: usize = 8192;

/// The greatest number drawn where it may be a number of elements: products of two of them, or of one and the
/// length of a string, do not exceed an array.
const COUNT: i32 = 60;

/// The most variables and arrays of one type that a subroutine has.
const VARIABLES: usize = 32;

/// How many data records are kept from one call to the next.
const RECORDS: usize = 4;

/// Room for the arguments of one call at a time; the addresses handed out hold until the next call. Data records and
/// the types and lengths of items stay, so that what one subroutine has given another one can take.
pub struct Arguments<'a> {
    input: Unstructured<'a>,
    integers: Vec<i32>,
    reals: Vec<f32>,
    characters: Vec<u8>,
    used: [usize; 3],
    records: Vec<[u8; ARRAY]>,
    kept: [i32; 2],
    indicator: i32,
}

impl<'a> Arguments<'a> {
    /// The length of every character string, or of an element of an array of them.
    pub const LENGTH: usize = 80;

    /// Arguments drawn from `input`.
    pub fn new(input: &'a [u8]) -> Self {
        Arguments {
            input: Unstructured::new(input),
            integers: vec![0; ARRAY * VARIABLES],
            reals: vec![0.0; ARRAY * VARIABLES],
            characters: vec![b' '; ARRAY * VARIABLES],
            used: [0; 3],
            records: vec![[b' '; ARRAY]; RECORDS],
            kept: [0; 2],
            indicator: 0,
        }
    }

    /// Whether nothing is left to draw from.
    pub fn is_exhausted(&self) -> bool {
        self.input.is_empty()
    }

    /// A number below `limit`, to choose among subroutines.
    pub fn choose(&mut self, limit: usize) -> usize {
        self.used = [0; 3];
        self.indicator = 0;
        self.input.int_in_range(0..=limit - 1).unwrap_or(0)
    }

    /// The error indicator of the last call, if it has one.
    pub fn last_indicator(&self) -> i32 {
        self.indicator
    }

    fn byte(&mut self) -> u8 {
        self.input.arbitrary().unwrap_or(0)
    }

    /// The start of the next array of a type, as an index.
    fn next(&mut self, kind: usize) -> usize {
        let at = self.used[kind] % VARIABLES * ARRAY;
        self.used[kind] += 1;
        at
    }

    fn variable(&mut self, value: i32) -> *mut i32 {
        let at = self.next(0);
        self.integers[at] = value;
        &raw mut self.integers[at]
    }

    /// An error indicator.
    pub fn indicator(&mut self) -> *mut i32 {
        &raw mut self.indicator
    }

    /// A variable or an array that is set by the subroutine.
    pub fn output_integers(&mut self) -> *mut i32 {
        let at = self.next(0);
        &raw mut self.integers[at]
    }

    /// A variable or an array that is set by the subroutine.
    pub fn output_reals(&mut self) -> *mut f32 {
        let at = self.next(1);
        &raw mut self.reals[at]
    }

    /// Strings that are set by the subroutine.
    pub fn output_characters(&mut self) -> *mut u8 {
        let at = self.next(2);
        &raw mut self.characters[at]
    }

    /// A variable that may be a number of elements.
    pub fn count(&mut self) -> *mut i32 {
        let byte = self.byte();
        let value = match byte {
            0..200 => i32::from(byte % 7),
            _ => i32::from(byte.cast_signed().wrapping_mul(5)) % (COUNT + 1),
        };
        self.variable(value)
    }

    fn draw_integer(&mut self) -> i32 {
        let byte = self.byte();
        match byte {
            0..200 => i32::from(byte % 10),
            200..240 => i32::from(byte) - 250,
            240..250 => i32::from(byte) * 25,
            250 => i32::MIN,
            251 => i32::MAX,
            _ => self.input.arbitrary().unwrap_or(0),
        }
    }

    /// A variable of any value, small ones above all.
    pub fn integer(&mut self) -> *mut i32 {
        let value = self.draw_integer();
        self.variable(value)
    }

    /// A variable, mostly one of `number` values from `first`.
    pub fn among(&mut self, first: i32, number: u8) -> *mut i32 {
        let byte = self.byte();
        let value = if byte < 240 { first + i32::from(byte % number) } else { self.draw_integer() };
        self.variable(value)
    }

    /// A workstation type; none that waits for a person.
    pub fn workstation_type(&mut self) -> *mut i32 {
        let byte = usize::from(self.byte());
        let value = match WORKSTATION_TYPES.get(byte) {
            Some(kind) => kind.number,
            None => self.draw_integer(),
        };
        self.variable(if (own::WINDOW..own::SCRIPTED).contains(&value) { own::NULL } else { value })
    }

    /// What is kept from call to call: 0 for the type of an item, 1 for its length.
    pub fn kept(&mut self, which: usize) -> *mut i32 {
        let byte = self.byte();
        if byte >= 128 {
            self.kept[which] = byte.cast_signed().wrapping_add(127).into();
        }
        &raw mut self.kept[which]
    }

    /// A data record, as it is or with characters changed.
    pub fn record(&mut self) -> *mut u8 {
        let byte = usize::from(self.byte());
        let record = &mut self.records[byte % RECORDS];
        for _ in 0..byte / 64 {
            let (place, value): (u8, u8) = self.input.arbitrary().unwrap_or((0, 0));
            record[usize::from(place)] = value;
        }
        record.as_mut_ptr()
    }

    /// An array of small integers.
    pub fn integers(&mut self) -> *mut i32 {
        let first = self.draw_integer() % (COUNT + 1);
        let step = i32::from(self.byte().cast_signed()) / 16;
        let at = self.next(0);
        for (i, element) in self.integers[at..][..ARRAY].iter_mut().enumerate() {
            *element = (first + step.wrapping_mul(i as i32)) % (COUNT + 1);
        }
        &raw mut self.integers[at]
    }

    /// A variable, mostly between 0 and 1, often in metres on a small display surface.
    pub fn real(&mut self) -> *mut f32 {
        let value = self.draw_real();
        let at = self.next(1);
        self.reals[at] = value;
        &raw mut self.reals[at]
    }

    /// A time to wait, in seconds: short if it is one.
    pub fn timeout(&mut self) -> *mut f32 {
        let value = self.draw_real();
        let at = self.next(1);
        self.reals[at] = if value > 0.0 { (value * 1e-3).min(5e-3) } else { value };
        &raw mut self.reals[at]
    }

    /// An array.
    pub fn reals(&mut self) -> *mut f32 {
        let (first, second, third) = (self.draw_real(), self.draw_real(), self.draw_real());
        let at = self.next(1);
        for (i, element) in self.reals[at..][..ARRAY].iter_mut().enumerate() {
            *element = match i % 7 {
                0 => first,
                3 => second,
                5 => third,
                rest => first + (second - first) * (i % 16) as f32 / 16.0 + rest as f32 / 8.0,
            };
        }
        &raw mut self.reals[at]
    }

    fn draw_real(&mut self) -> f32 {
        let byte = self.byte();
        match byte {
            0..=100 => f32::from(byte) / 100.0,
            101..180 => f32::from(byte - 100) * 1.5e-4,
            180..240 => (f32::from(byte) - 210.0) / 10.0,
            255 => f32::NAN,
            254 => f32::INFINITY,
            253 => f32::NEG_INFINITY,
            252 => f32::MAX,
            251 => f32::MIN_POSITIVE,
            _ => f32::from_bits(self.input.arbitrary().unwrap_or(0)),
        }
    }

    /// Strings, one or an array of them.
    pub fn characters(&mut self) -> *mut u8 {
        let at = self.next(2);
        let (letter, length): (u8, u8) = self.input.arbitrary().unwrap_or((b'a', 1));
        let length = usize::from(length);
        for (i, element) in self.characters[at..][..ARRAY].iter_mut().enumerate() {
            *element = if i % 256 < length { letter.wrapping_add((i % 5) as u8) } else { b' ' };
        }
        &raw mut self.characters[at]
    }

    /// A script for an operator: steps for the first two input devices of each class.
    pub fn script(&mut self) -> String {
        let mut script = String::new();
        for _ in 0..self.byte() % 32 {
            let byte = self.byte();
            let (device, at) = (byte / 16 % 2 + 1, f32::from(byte / 32) / 8.0);
            let step = match byte % 16 {
                0 | 1 => format!("locator {device} {at} 0.5"),
                2 => format!("stroke {device} {at} {at} 0.3 0.7 0.5 {at}"),
                3 | 4 => format!("valuator {device} {at}"),
                5 | 6 => format!("choice {device} {}", byte / 32),
                7 => format!("choice {device} none"),
                8 | 9 => format!("pick {device} {at} {at}"),
                10 => format!("pick {device} none"),
                11 | 12 => format!("string {device} {}", "word ".repeat(usize::from(byte / 32))),
                13 => format!("together\nlocator {device} {at} {at}\nvaluator 1 {at}\nend"),
                14 => "wait 0.001".to_owned(),
                _ => "break".to_owned(),
            };
            script += &step;
            script.push('\n');
        }
        script
    }
}
