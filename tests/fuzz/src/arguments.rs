//! Arguments of Fortran subroutines, drawn from the input of a fuzzer.

use arbitrary::Unstructured;

/// The number of elements of an array, and of the characters of all strings of an array together.
const ARRAY: usize = 8192;

/// The greatest number drawn where it may be a number of elements: products of two of them, or of one and the
/// length of a string, do not exceed an array.
const COUNT: i32 = 60;

/// The most variables and arrays of one type that a subroutine has.
const VARIABLES: usize = 32;

/// Room for the arguments of one call at a time; the addresses handed out hold until the next call.
pub struct Arguments<'a> {
    input: Unstructured<'a>,
    integers: Vec<i32>,
    reals: Vec<f32>,
    characters: Vec<u8>,
    used: [usize; 3],
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
        }
    }

    /// Whether nothing is left to draw from.
    pub fn is_exhausted(&self) -> bool {
        self.input.is_empty()
    }

    /// A number below `limit`, to choose among subroutines.
    pub fn choose(&mut self, limit: usize) -> usize {
        self.used = [0; 3];
        self.input.int_in_range(0..=limit - 1).unwrap_or(0)
    }

    /// The start of the next array of a type, as an index.
    fn next(&mut self, kind: usize) -> usize {
        let at = self.used[kind] % VARIABLES * ARRAY;
        self.used[kind] += 1;
        at
    }

    /// A variable that may be a number of elements.
    pub fn count(&mut self) -> *mut i32 {
        let at = self.next(0);
        let byte: i8 = self.input.arbitrary().unwrap_or(0);
        self.integers[at] = i32::from(byte) % (COUNT + 1);
        &raw mut self.integers[at]
    }

    /// A variable of any value, small ones above all.
    pub fn integer(&mut self) -> *mut i32 {
        let at = self.next(0);
        let byte: i8 = self.input.arbitrary().unwrap_or(0);
        self.integers[at] = match byte {
            -128 => i32::MIN,
            127 => i32::MAX,
            120..127 => self.input.arbitrary().unwrap_or(0),
            _ => byte.into(),
        };
        &raw mut self.integers[at]
    }

    /// An array of small integers.
    pub fn integers(&mut self) -> *mut i32 {
        let at = self.next(0);
        let (first, step): (i8, i8) = self.input.arbitrary().unwrap_or((0, 0));
        for (i, element) in self.integers[at..][..ARRAY].iter_mut().enumerate() {
            *element = (i32::from(first) + i32::from(step).wrapping_mul(i as i32)) % (COUNT + 1);
        }
        &raw mut self.integers[at]
    }

    /// A variable, mostly between -2 and 2.
    pub fn real(&mut self) -> *mut f32 {
        let at = self.next(1);
        self.reals[at] = self.draw();
        &raw mut self.reals[at]
    }

    /// An array.
    pub fn reals(&mut self) -> *mut f32 {
        let at = self.next(1);
        let (first, second, third) = (self.draw(), self.draw(), self.draw());
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

    fn draw(&mut self) -> f32 {
        let byte: u8 = self.input.arbitrary().unwrap_or(0);
        match byte {
            255 => f32::NAN,
            254 => f32::INFINITY,
            253 => f32::NEG_INFINITY,
            252 => f32::MAX,
            251 => f32::MIN_POSITIVE,
            240..251 => f32::from_bits(self.input.arbitrary().unwrap_or(0)),
            _ => (f32::from(byte) - 120.0) / 60.0,
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
}
