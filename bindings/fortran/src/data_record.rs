//! Data records: PACK DATA RECORD and UNPACK DATA RECORD.

use crate::argument::{Character, Integer, Real, integer};
use gks::{DataRecord, Line};

/// The characters of a line of a data record.
pub(crate) const LINE: usize = size_of::<Line>();

/// The lines of a data record.
pub(crate) fn lines<'a>(count: Integer, record: Character) -> &'a [Line] {
    record.slice(0, count.count().saturating_mul(LINE)).as_chunks().0
}

/// GPREC: PACK DATA RECORD. A string of a negative length is empty, one that is longer than its variable ends
/// with it.
#[unsafe(no_mangle)]
extern "C" fn gprec_(
    il: Integer,
    ia: Integer,
    rl: Integer,
    ra: Real,
    sl: Integer,
    lstr: Integer,
    str: Character,
    mldr: Integer,
    errind: Integer,
    ldr: Integer,
    datrec: Character,
    str_length: usize,
    _datrec_length: usize,
) {
    let lengths = lstr.slice(0, sl.count()).iter().map(|&length| usize::try_from(length).unwrap_or(0));
    let strings = lengths.enumerate().map(|(i, length)| {
        // One character for each byte, whatever the character set, so that GUREC gives back the same bytes.
        let bytes = str.slice(i * str_length, length.min(str_length));
        bytes.iter().map(|&byte| char::from(byte)).collect()
    });
    let record = DataRecord {
        integers: ia.slice(0, il.count()).to_vec(),
        reals: ra.slice(0, rl.count()).iter().map(|&real| real.into()).collect(),
        strings: strings.collect(),
    };
    match record.pack(mldr.count()) {
        Ok(lines) => {
            errind.set(0);
            ldr.set(integer(lines.len()));
            datrec.set_from(0, lines.as_flattened().iter().copied());
        }
        Err(error) => {
            errind.set(error.number);
            ldr.set(0);
        }
    }
}

/// GUREC: UNPACK DATA RECORD. Where an array or a string is too small, the counts and the lengths are those of
/// the record, and the arrays hold what fits.
#[unsafe(no_mangle)]
extern "C" fn gurec_(
    ldr: Integer,
    datrec: Character,
    iil: Integer,
    irl: Integer,
    isl: Integer,
    errind: Integer,
    il: Integer,
    ia: Integer,
    rl: Integer,
    ra: Real,
    sl: Integer,
    lstr: Integer,
    str: Character,
    _datrec_length: usize,
    str_length: usize,
) {
    let (record, error) = match DataRecord::unpack(lines(ldr, datrec)) {
        Ok(record) => (record, 0),
        Err(error) => (DataRecord::default(), error.number),
    };
    let (most_integers, most_reals, most_strings) = (iil.count(), irl.count(), isl.count());
    let mut fits = record.integers.len() <= most_integers
        && record.reals.len() <= most_reals
        && record.strings.len() <= most_strings;
    il.set(integer(record.integers.len()));
    rl.set(integer(record.reals.len()));
    sl.set(integer(record.strings.len()));
    ia.set_from(0, record.integers.iter().copied().take(most_integers));
    ra.set_from(0, record.reals.iter().map(|&real| real as f32).take(most_reals));
    for (i, string) in record.strings.iter().take(most_strings).enumerate() {
        let bytes: Vec<u8> = string.chars().map(|c| u8::try_from(c).unwrap_or(b'?')).collect();
        lstr.set_from(i, [integer(bytes.len())]);
        fits &= str.from(i * str_length).set_text(str_length, &bytes);
    }
    errind.set(if error == 0 && !fits { 2001 } else { error });
}
