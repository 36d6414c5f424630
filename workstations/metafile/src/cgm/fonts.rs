//! Names of fonts in font lists, and our numbers for them.

/// The names under which our fonts are written, by number: those of the Hershey fonts as ISO registers them, of
/// outline fonts those that most readers know.
const NAMES: [(i32, &str); 34] = [
    (1, "HERSHEY:MONOSPACED_SIMPLEX"),
    (-2, "HERSHEY:CARTOGRAPHIC_ROMAN"),
    (-3, "HERSHEY:CARTOGRAPHIC_GREEK"),
    (-4, "HERSHEY:SIMPLEX_ROMAN"),
    (-5, "HERSHEY:SIMPLEX_GREEK"),
    (-6, "HERSHEY:SIMPLEX_SCRIPT"),
    (-7, "HERSHEY:COMPLEX_ROMAN"),
    (-8, "HERSHEY:COMPLEX_GREEK"),
    (-9, "HERSHEY:COMPLEX_SCRIPT"),
    (-10, "HERSHEY:COMPLEX_ITALIC"),
    (-11, "HERSHEY:COMPLEX_CYRILLIC"),
    (-12, "HERSHEY:DUPLEX_ROMAN"),
    (-13, "HERSHEY:TRIPLEX_ROMAN"),
    (-14, "HERSHEY:TRIPLEX_ITALIC"),
    (-15, "HERSHEY:GOTHIC_GERMAN"),
    (-16, "HERSHEY:GOTHIC_ENGLISH"),
    (-17, "HERSHEY:GOTHIC_ITALIAN"),
    (-18, "HERSHEY:MATHEMATICAL_SYMBOLS"),
    (-19, "HERSHEY:SYMBOL_SET_1"),
    (-20, "HERSHEY:SYMBOL_SET_2"),
    (-21, "Helvetica"),
    (-22, "Helvetica-Bold"),
    (-23, "Helvetica-Oblique"),
    (-24, "Helvetica-BoldOblique"),
    (-25, "Times-Roman"),
    (-26, "Times-Bold"),
    (-27, "Times-Italic"),
    (-28, "Times-BoldItalic"),
    (-29, "Courier"),
    (-30, "Courier-Bold"),
    (-31, "Courier-Oblique"),
    (-32, "Courier-BoldOblique"),
    (-33, "Mathematics"),
    (-34, "Symbols"),
];

/// The names of a font list with all our fonts.
pub fn names() -> impl Iterator<Item = &'static str> {
    NAMES.iter().map(|(_, name)| *name)
}

/// The index of one of our fonts in the list of [`names`]; that of font 1 for a number that is none.
pub fn index(number: i32) -> i32 {
    NAMES.iter().position(|(own, _)| *own == number).map_or(1, |place| place as i32 + 1)
}

/// The font of an index, with the fonts of a list; a list that is the beginning of ours goes on as ours does.
pub fn listed(list: &[i32], index: i32) -> i32 {
    let Some(place) = usize::try_from(index).ok().and_then(|index| index.checked_sub(1)) else { return 1 };
    let ours = || {
        NAMES.get(place).filter(|_| {
            list.len() > 1 && NAMES.iter().map(|own| own.0).zip(list).all(|(own, listed)| own == *listed)
        })
    };
    list.get(place).copied().or_else(|| ours().map(|own| own.0)).unwrap_or(1)
}

/// The font that comes nearest to a name.
pub fn number(name: &[u8]) -> i32 {
    let name = String::from_utf8_lossy(name);
    if let Some((number, _)) = NAMES.iter().find(|(_, own)| own.eq_ignore_ascii_case(name.trim())) {
        return *number;
    }
    let lower = name.to_ascii_lowercase();
    let has = |words: &[&str]| words.iter().any(|word| lower.contains(word));
    if lower.trim().is_empty() || has(&["hershey", "default", "simplex", "stroke"]) {
        return 1;
    }
    let bold = has(&["bold", "heavy", "black"]);
    let italic = has(&["italic", "oblique", "slant"]);
    let family = if has(&["courier", "mono", "typewriter", "fixed", "consol"]) {
        -29
    } else if has(&["times", "roman", "serif", "garamond", "palatino", "schoolbook", "bookman", "dutch"])
        && !has(&["sans"])
    {
        -25
    } else {
        -21
    };
    family - i32::from(bold) - 2 * i32::from(italic)
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::font;

    #[test]
    fn our_fonts_come_back_under_their_numbers() {
        for &own in font::numbers() {
            let place = index(own) as usize - 1;
            assert_eq!(number(names().nth(place).unwrap().as_bytes()), own);
        }
    }

    #[test]
    fn a_list_that_is_cut_off_goes_on() {
        assert_eq!((listed(&[1, -2, -3], 34), listed(&[1, -3], 34), listed(&[-25], 1)), (-34, 1, -25));
        assert_eq!((listed(&[], 3), listed(&[1, -2], -1)), (1, 1));
    }

    #[test]
    fn foreign_names_find_a_family_and_a_style() {
        assert_eq!(number(b"TIMES_ROMAN"), -25);
        assert_eq!(number(b"Arial-BoldMT"), -22);
        assert_eq!(number(b"CourierNew,BoldItalic"), -32);
        assert_eq!(number(b"DejaVu Sans Oblique"), -23);
        assert_eq!(number(b""), 1);
    }
}
