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

/// The most fonts of a list that NCAR's readers take.
const MOST: usize = 20;

/// The metafile description of what we write.
pub const AUTHOR: &str = "written by GKS";

/// The fonts of a metafile that is written.
///
/// They are listed in the order in which they are used, as far as that is known when the list is written, and then
/// others until there are as many as all readers take. Those left out go on in the order of their numbers: our reader
/// knows, another one takes the first font of the list.
#[derive(Clone, Debug)]
pub struct FontList {
    fonts: Vec<i32>,
    /// How many of them the list names, once it is written.
    named: Option<usize>,
}

impl FontList {
    /// A list of the fonts that are going to be used.
    pub fn new() -> FontList {
        FontList { fonts: Vec::new(), named: None }
    }

    /// The list of NCAR, whose readers know fonts by their numbers.
    pub fn of_ncar() -> FontList {
        FontList { fonts: NAMES.iter().map(|(number, _)| *number).collect(), named: Some(MOST) }
    }

    /// The index of a font; that of font 1 for a number that is none of ours.
    pub fn index(&mut self, number: i32) -> i32 {
        let number = if NAMES.iter().any(|(own, _)| *own == number) { number } else { 1 };
        let place = self.fonts.iter().position(|font| *font == number).unwrap_or_else(|| {
            self.fonts.push(number);
            self.fonts.len() - 1
        });
        place as i32 + 1
    }

    /// Completes the list, which is going to be written.
    pub fn settle(&mut self) {
        if self.named.is_some() {
            return;
        }
        // The first font stands for those that a reader does not know; outline fonts are those that most readers have.
        let (strokes, outlines) = NAMES.split_at(MOST);
        let others = strokes[..1].iter().chain(outlines).chain(&strokes[1..]);
        for (number, _) in others {
            if self.fonts.len() < MOST && !self.fonts.contains(number) {
                self.fonts.push(*number);
            }
        }
        self.named = Some(self.fonts.len());
        let rest = continuation(&self.fonts);
        self.fonts.extend(rest);
    }

    /// The names of the list.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        let named = &self.fonts[..self.named.unwrap_or(self.fonts.len())];
        named.iter().filter_map(|font| NAMES.iter().find(|(number, _)| number == font)).map(|(_, name)| *name)
    }
}

impl Default for FontList {
    fn default() -> Self {
        FontList::new()
    }
}

/// Our fonts that a list lacks, in their order.
fn continuation(list: &[i32]) -> Vec<i32> {
    NAMES.iter().map(|(number, _)| *number).filter(|number| !list.contains(number)).collect()
}

/// The font of an index, with the fonts of a list; a list that is `ours` goes on.
pub fn listed(list: &[i32], ours: bool, index: i32) -> i32 {
    let Some(place) = usize::try_from(index).ok().and_then(|index| index.checked_sub(1)) else { return 1 };
    let beyond = || continuation(list).get(place - list.len()).copied().filter(|_| ours);
    list.get(place).copied().or_else(beyond).unwrap_or(1)
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
        for (mut list, named) in [(FontList::new(), 20), (FontList::of_ncar(), 20)] {
            let before = [-26, -3].map(|own| (own, list.index(own)));
            list.settle();
            let read: Vec<i32> = list.names().map(|name| number(name.as_bytes())).collect();
            assert_eq!(read.len(), named);
            for (own, index) in before {
                assert_eq!(listed(&read, true, index), own);
            }
            for &own in font::numbers() {
                assert_eq!(listed(&read, true, list.index(own)), own);
            }
        }
    }

    #[test]
    fn fonts_in_use_come_first_and_ncar_has_its_numbers() {
        let (mut used, mut ncar) = (FontList::new(), FontList::of_ncar());
        assert_eq!((used.index(-26), used.index(-26), used.index(77)), (1, 1, 2));
        assert_eq!((ncar.index(-3), ncar.index(-26), ncar.index(77)), (3, 26, 1));
    }

    #[test]
    fn a_foreign_list_does_not_go_on() {
        assert_eq!((listed(&[-25], false, 1), listed(&[-25], false, 2), listed(&[], false, 3)), (-25, 1, 1));
        assert_eq!((listed(&[-25], true, 2), listed(&[1, -2], true, -1)), (1, 1));
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
