//! Workstation type numbers of other implementations of GKS, as their programs have them built in.

use gks_pipeline::description::Category;
use gks_pipeline::generated::numbers::workstation_type as own;

/// The implementation whose numbers a program uses.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// None: the numbers are our own.
    #[default]
    Iso,
    /// NCAR Graphics.
    Ncar,
    /// XGKS.
    Xgks,
    /// The GKS of the GR framework.
    Gr,
}

/// What a number of a dialect is here.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(crate) enum Meaning {
    /// The type that the user chose, else the default: windows, and metafiles of formats that nobody reads.
    Chosen,
    /// A type of our own, with options.
    Own(i32, &'static str),
    /// A picture that is kept until the program names the file that it is to be written to, whatever the user
    /// chose.
    Kept,
}

/// A range of numbers of a dialect with one meaning.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Foreign {
    pub(crate) first: i32,
    pub(crate) last: i32,
    /// The category that programs of the dialect expect.
    pub(crate) category: Category,
    pub(crate) meaning: Meaning,
}

const fn foreign(first: i32, last: i32, category: Category, meaning: Meaning) -> Foreign {
    Foreign { first, last, category, meaning }
}

const fn output(first: i32, last: i32, number: i32) -> Foreign {
    foreign(first, last, Category::Output, Meaning::Own(number, ""))
}

const fn landscape(first: i32, last: i32, number: i32) -> Foreign {
    foreign(first, last, Category::Output, Meaning::Own(number, "landscape=1"))
}

/// NCAR Graphics 6: 20 to 31 are PostScript, EPS and EPSI, in colour and monochrome, portrait first; from 40 on what it
/// draws with cairo, 44 and 46 in windows.
const NCAR: &[Foreign] = &[
    foreign(1, 1, Category::MetafileOutput, Meaning::Own(own::NCGM, "")),
    foreign(3, 3, Category::Wiss, Meaning::Own(own::WISS, "")),
    foreign(7, 8, Category::OutIn, Meaning::Chosen),
    foreign(10, 10, Category::Output, Meaning::Chosen),
    output(11, 11, own::PDF),
    landscape(12, 12, own::PDF),
    output(20, 20, own::PS),
    output(21, 22, own::EPS),
    output(23, 23, own::PS),
    output(24, 25, own::EPS),
    landscape(26, 26, own::PS),
    landscape(27, 28, own::EPS),
    landscape(29, 29, own::PS),
    landscape(30, 31, own::EPS),
    output(40, 40, own::PS),
    output(41, 41, own::PNG),
    output(42, 42, own::PDF),
    output(43, 43, own::TIFF),
    foreign(44, 44, Category::OutIn, Meaning::Chosen),
    output(45, 45, own::EPS),
    foreign(46, 46, Category::OutIn, Meaning::Chosen),
    output(47, 47, own::SVG),
];

/// XGKS: its types have names, which its Fortran binding numbers in this order: MI, MO, WISS and windows. MO writes
/// metafiles and pictures, as the name of the file says.
const XGKS: &[Foreign] = &[
    foreign(1, 1, Category::MetafileInput, Meaning::Own(own::MI, "")),
    foreign(2, 2, Category::MetafileOutput, Meaning::Kept),
    foreign(3, 3, Category::Wiss, Meaning::Own(own::WISS, "")),
    foreign(4, 4, Category::OutIn, Meaning::Chosen),
];

/// GR 0.73: 2, 7 and 8 are metafiles; 41, 141, 142, 211 to 213, 371 and from 380 on windows and viewers but for SVG; 120,
/// 121 and 160 to 162 films, 131 one of PNG; 150 to 152 pictures in terminals; 170, 214, 216, 314 and 390 formats that
/// nobody writes here.
const GR: &[Foreign] = &[
    foreign(2, 2, Category::MetafileOutput, Meaning::Chosen),
    foreign(3, 3, Category::MetafileInput, Meaning::Own(own::MI, "")),
    foreign(5, 5, Category::Wiss, Meaning::Own(own::WISS, "")),
    foreign(7, 8, Category::MetafileOutput, Meaning::Chosen),
    foreign(41, 41, Category::OutIn, Meaning::Chosen),
    foreign(51, 51, Category::OutIn, Meaning::Chosen),
    output(61, 62, own::PS),
    landscape(63, 64, own::PS),
    output(100, 100, own::NULL),
    output(101, 102, own::PDF),
    foreign(120, 121, Category::Output, Meaning::Chosen),
    output(130, 130, own::GIF),
    output(131, 131, own::PNG),
    output(140, 140, own::PNG),
    foreign(141, 142, Category::Output, Meaning::Chosen),
    output(143, 143, own::FRAMEBUFFER),
    output(144, 144, own::JPEG),
    output(145, 145, own::BMP),
    output(146, 146, own::TIFF),
    output(150, 150, own::SIXEL),
    output(151, 151, own::TERMINAL),
    output(152, 152, own::KITTY),
    foreign(160, 162, Category::Output, Meaning::Chosen),
    foreign(170, 170, Category::Output, Meaning::Chosen),
    output(171, 171, own::PNG),
    output(172, 172, own::JPEG),
    output(173, 173, own::FRAMEBUFFER),
    foreign(210, 210, Category::Output, Meaning::Chosen),
    foreign(211, 213, Category::OutIn, Meaning::Chosen),
    foreign(214, 214, Category::Output, Meaning::Chosen),
    output(215, 215, own::GIF),
    foreign(216, 216, Category::Output, Meaning::Chosen),
    output(217, 217, own::FRAMEBUFFER),
    output(218, 218, own::GIF),
    foreign(301, 301, Category::Output, Meaning::Chosen),
    foreign(314, 314, Category::Output, Meaning::Chosen),
    output(320, 320, own::BMP),
    output(321, 321, own::JPEG),
    output(322, 322, own::PNG),
    output(323, 323, own::TIFF),
    foreign(371, 371, Category::Output, Meaning::Chosen),
    foreign(380, 381, Category::Output, Meaning::Chosen),
    output(382, 382, own::SVG),
    foreign(390, 390, Category::Output, Meaning::Chosen),
    foreign(400, 400, Category::Output, Meaning::Chosen),
    foreign(410, 413, Category::Output, Meaning::Chosen),
    foreign(415, 415, Category::Output, Meaning::Chosen),
    foreign(420, 420, Category::Output, Meaning::Chosen),
];

/// The names that users of GR give to types, where ours are others. Who asks for a window by its name gets one.
const GR_NAMES: &[(&str, i32)] = &[
    ("apng", own::PNG),
    ("cairobmp", own::BMP),
    ("cairojpg", own::JPEG),
    ("cairopng", own::PNG),
    ("cairotif", own::TIFF),
    ("cairox11", own::WINDOW),
    ("gksqt", own::WINDOW),
    ("gl", own::WINDOW),
    ("gtk", own::WINDOW),
    ("iterm", own::TERMINAL),
    ("mo", own::GKSM),
    ("nul", own::NULL),
    ("opengl", own::WINDOW),
    ("qt", own::WINDOW),
    ("qtagg", own::WINDOW),
    ("qtcairo", own::WINDOW),
    ("quartz", own::WINDOW),
    ("six", own::SIXEL),
    ("sock", own::WINDOW),
    ("socket", own::WINDOW),
    ("win", own::WINDOW),
    ("wx", own::WINDOW),
    ("x11", own::WINDOW),
    ("zmq", own::WINDOW),
];

impl Dialect {
    /// The dialect with this name, in small or capital letters.
    pub fn from_name(name: &str) -> Option<Dialect> {
        match name.to_ascii_lowercase().as_str() {
            "iso" => Some(Dialect::Iso),
            "ncar" => Some(Dialect::Ncar),
            "xgks" => Some(Dialect::Xgks),
            "gr" => Some(Dialect::Gr),
            _ => None,
        }
    }

    /// The name of the dialect.
    pub fn name(self) -> &'static str {
        match self {
            Dialect::Iso => "iso",
            Dialect::Ncar => "ncar",
            Dialect::Xgks => "xgks",
            Dialect::Gr => "gr",
        }
    }

    /// The numbers of the dialect.
    pub(crate) fn table(self) -> &'static [Foreign] {
        match self {
            Dialect::Iso => &[],
            Dialect::Ncar => NCAR,
            Dialect::Xgks => XGKS,
            Dialect::Gr => GR,
        }
    }

    /// The type of the metafile that a program writes into a file of this name, where the dialect has one type for metafiles
    /// and pictures; none for a picture. XGKS calls its GKSM what Ferret does, `.plt`.
    pub fn metafile_of(self, name: &str) -> Option<i32> {
        let extension = crate::sink::extension(name)?.to_ascii_lowercase();
        match (self, extension.as_str()) {
            (Dialect::Xgks, "gksm" | "gkm" | "plt") => Some(own::GKSM),
            (Dialect::Xgks, "cgm") => Some(own::CGM),
            _ => None,
        }
    }

    /// The type of our own that a name of the dialect means.
    pub(crate) fn named(self, name: &str) -> Option<i32> {
        let names = if self == Dialect::Gr { GR_NAMES } else { &[] };
        names.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|&(_, number)| number)
    }

    /// What a number is in the dialect, if it is one of its numbers.
    pub(crate) fn find(self, number: i32) -> Option<&'static Foreign> {
        self.table().iter().find(|f| (f.first..=f.last).contains(&number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_in_order_and_do_not_overlap() {
        for dialect in [Dialect::Ncar, Dialect::Xgks, Dialect::Gr] {
            let table = dialect.table();
            assert!(table.iter().all(|f| 0 < f.first && f.first <= f.last), "{dialect:?}");
            assert!(table.windows(2).all(|w| w[0].last < w[1].first), "{dialect:?}");
        }
    }

    #[test]
    fn programs_of_xgks_name_their_metafiles() {
        let of = |name| Dialect::Xgks.metafile_of(name);
        assert_eq!(of("d.x/plot.GKSM"), Some(own::GKSM));
        assert_eq!(of("metafile.plt"), Some(own::GKSM));
        assert_eq!(of("a.cgm"), Some(own::CGM));
        assert_eq!((of("a.gif"), of("a.ps"), of("plot")), (None, None, None));
        assert_eq!(Dialect::Iso.metafile_of("a.gksm"), None);
    }

    #[test]
    fn dialects_are_found_by_their_names() {
        for dialect in [Dialect::Iso, Dialect::Ncar, Dialect::Xgks, Dialect::Gr] {
            assert_eq!(Dialect::from_name(dialect.name()), Some(dialect));
        }
    }

    #[test]
    fn gr_numbers_and_names_mean_what_its_programs_and_users_expect() {
        let meaning = |number| Dialect::Gr.find(number).map(|f| f.meaning);
        for (number, kind) in [
            (100, own::NULL),
            (102, own::PDF),
            (130, own::GIF),
            (140, own::PNG),
            (150, own::SIXEL),
            (152, own::KITTY),
            (172, own::JPEG),
            (173, own::FRAMEBUFFER),
            (382, own::SVG),
        ] {
            assert_eq!(meaning(number), Some(Meaning::Own(kind, "")), "{number}");
        }
        assert_eq!(meaning(64), Some(Meaning::Own(own::PS, "landscape=1")));
        // All types that GR 0.73 lists.
        let listed = [
            2, 3, 5, 41, 61, 62, 63, 64, 100, 101, 102, 120, 121, 130, 131, 140, 141, 142, 143, 144, 145,
            146, 150, 151, 152, 160, 161, 162, 170, 171, 172, 173, 210, 211, 212, 213, 214, 215, 216, 217,
            218, 301, 314, 320, 321, 322, 323, 371, 380, 381, 382, 390, 400, 410, 411, 412, 413, 415, 420,
        ];
        assert!(listed.into_iter().all(|number| meaning(number).is_some()));
        assert_eq!(Dialect::Gr.named("CairoPNG"), Some(own::PNG));
        assert_eq!(Dialect::Gr.named("x11"), Some(own::WINDOW));
        assert_eq!((Dialect::Gr.named("svg"), Dialect::Ncar.named("x11")), (None, None));
    }

    #[test]
    fn ncar_numbers_mean_what_its_programs_expect() {
        let meaning = |number| Dialect::Ncar.find(number).map(|f| f.meaning);
        assert_eq!(meaning(1), Some(Meaning::Own(own::NCGM, "")));
        assert_eq!(meaning(8), Some(Meaning::Chosen));
        assert_eq!(meaning(22), Some(Meaning::Own(own::EPS, "")));
        assert_eq!(meaning(26), Some(Meaning::Own(own::PS, "landscape=1")));
        assert_eq!(meaning(100), None);
        assert_eq!(Dialect::Ncar.find(8).map(|f| f.category), Some(Category::OutIn));
        assert!(Dialect::Iso.find(1).is_none());
    }
}
