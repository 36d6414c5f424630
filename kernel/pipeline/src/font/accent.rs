//! Accents drawn for the stroke faces, and the letters that carry them.
//!
//! The Hershey repertoire has no accented letters. A mark is drawn in Hershey units of 21 to the character height,
//! about x = 0; those above sit on y = 0, the line to which the letter reaches, those below hang from y = 0.

use glam::DVec2;

use super::hershey::CAP;
use super::sketch::Sketch;

/// A mark added to a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Grave,
    Acute,
    Circumflex,
    Tilde,
    Diaeresis,
    Ring,
    Caron,
    /// The caron of letters with ascenders, written as an apostrophe beside them.
    SideCaron,
    Breve,
    Macron,
    Dot,
    DoubleAcute,
    Cedilla,
    Ogonek,
    CommaBelow,
}

/// A letter, the letter it is composed of and the mark: triples of text for every mark.
const COMPOSED: [(Mark, &str); 15] = [
    (Mark::Grave, "ÀAÈEÌIÒOÙUàaèeìiòoùuǸNǹnẀWẁwỲYỳyЀЕѐеЍИѝи"),
    (Mark::Acute, "ÁAÉEÍIÓOÚUÝYáaéeíióoúuýyĆCćcĹLĺlŃNńnŔRŕrŚSśsŹZźzẂWẃwΆΑΈΕΉΗΊΙΌΟΎΥΏΩάαέεήηίιόούυώωЃГѓгЌКќк"),
    (Mark::Circumflex, "ÂAÊEÎIÔOÛUâaêeîiôoûuĈCĉcĜGĝgĤHĥhĴJĵjŜSŝsŴWŵwŶYŷy"),
    (Mark::Tilde, "ÃAÑNÕOãañnõoĨIĩiŨUũuẼEẽeỸYỹy"),
    (Mark::Diaeresis, "ÄAËEÏIÖOÜUäaëeïiöoüuÿyŸYΪΙΫΥϊιϋυЁЕёеЇІїі"),
    (Mark::Ring, "ÅAåaŮUůu"),
    (Mark::Caron, "ČCčcĎDĚEěeŇNňnŘRřrŠSšsŤTŽZžzǍAǎaǏIǐiǑOǒoǓUǔuǦGǧg"),
    (Mark::SideCaron, "ďdĽLľlťt"),
    (Mark::Breve, "ĂAăaĔEĕeĞGğgĬIĭiŎOŏoŬUŭuЎУўуЙИйи"),
    (Mark::Macron, "ĀAāaĒEēeĪIīiŌOōoŪUūuȲYȳy"),
    (Mark::Dot, "ĊCċcĖEėeĠGġgİIŻZżzȦAȧaȮOȯoḂBḃbḊDḋdḞFḟfṀMṁmṖPṗpṠSṡsṪTṫt"),
    (Mark::DoubleAcute, "ŐOőoŰUűu"),
    (Mark::Cedilla, "ÇCçcŞSşsŢTţtȨEȩe"),
    (Mark::Ogonek, "ĄAąaĘEęeĮIįiŲUųuǪOǫo"),
    (Mark::CommaBelow, "ĢGĶKķkĻLļlŅNņnŖRŗrȘSșsȚTțt"),
];

/// The letter and the mark that a character is composed of.
pub(crate) fn decompose(character: char) -> Option<(char, Mark)> {
    if character == 'ģ' {
        return Some(('g', Mark::SideCaron));
    }
    COMPOSED.iter().find_map(|&(mark, pairs)| {
        let mut letters = pairs.chars();
        while let (Some(composed), Some(base)) = (letters.next(), letters.next()) {
            if composed == character {
                return Some((base, mark));
            }
        }
        None
    })
}

impl Mark {
    /// The mark of a combining character, or of the spacing character that shows a mark alone.
    pub(crate) fn of(character: char) -> Option<Self> {
        Some(match character {
            '\u{300}' => Self::Grave,
            '\u{301}' | '´' | '΄' => Self::Acute,
            '\u{302}' | 'ˆ' => Self::Circumflex,
            '\u{303}' | '˜' => Self::Tilde,
            '\u{308}' | '¨' => Self::Diaeresis,
            '\u{30a}' | '˚' => Self::Ring,
            '\u{30c}' | 'ˇ' => Self::Caron,
            '\u{306}' | '˘' => Self::Breve,
            '\u{304}' | '\u{305}' | '¯' | 'ˉ' => Self::Macron,
            '\u{307}' | '˙' => Self::Dot,
            '\u{30b}' | '˝' => Self::DoubleAcute,
            '\u{327}' | '¸' => Self::Cedilla,
            '\u{328}' | '˛' => Self::Ogonek,
            '\u{326}' => Self::CommaBelow,
            _ => return None,
        })
    }

    /// Whether the mark stands above the letter.
    pub(crate) fn above(self) -> bool {
        !matches!(self, Self::SideCaron | Self::Cedilla | Self::Ogonek | Self::CommaBelow)
    }

    /// The strokes in half Hershey units.
    fn strokes(self) -> &'static [&'static [(i8, i8)]] {
        match self {
            Self::Grave => &[&[(-6, 13), (3, 5)]],
            Self::Acute => &[&[(6, 13), (-3, 5)]],
            Self::Circumflex => &[&[(-8, 5), (0, 12), (8, 5)]],
            Self::Caron => &[&[(-8, 12), (0, 5), (8, 12)]],
            Self::Tilde => &[&[(-10, 6), (-9, 9), (-6, 11), (-3, 11), (3, 7), (6, 7), (9, 9), (10, 12)]],
            Self::Diaeresis => &[
                &[(-7, 11), (-9, 9), (-7, 7), (-5, 9), (-7, 11)],
                &[(7, 11), (5, 9), (7, 7), (9, 9), (7, 11)],
            ],
            Self::Dot => &[&[(0, 11), (-2, 9), (0, 7), (2, 9), (0, 11)]],
            Self::Ring => &[&[
                (0, 13),
                (-3, 12),
                (-5, 10),
                (-5, 6),
                (-3, 4),
                (0, 3),
                (3, 4),
                (5, 6),
                (5, 10),
                (3, 12),
                (0, 13),
            ]],
            Self::SideCaron => &[&[(0, 4), (2, 2), (1, -3), (-2, -7)], &[(0, 4), (-1, 2), (2, 2)]],
            Self::Breve => &[&[(-8, 12), (-7, 8), (-4, 6), (0, 5), (4, 6), (7, 8), (8, 12)]],
            Self::Macron => &[&[(-9, 9), (9, 9)]],
            Self::DoubleAcute => &[&[(0, 13), (-7, 5)], &[(9, 13), (2, 5)]],
            Self::Cedilla => {
                &[&[(0, 0), (-2, -4), (1, -4), (4, -6), (4, -10), (1, -12), (-3, -12), (-5, -11)]]
            }
            Self::Ogonek => &[&[(0, 0), (-4, -4), (-5, -8), (-3, -11), (0, -12), (4, -10)]],
            Self::CommaBelow => &[&[(0, -3), (2, -5), (1, -9), (-2, -13)], &[(0, -3), (-1, -5), (2, -5)]],
        }
    }

    /// Draws the mark at a place, sheared by a slant; `heavy` doubles the lines to go with letters of double lines.
    pub(crate) fn draw(self, sketch: &mut Sketch, place: DVec2, slant: f64, heavy: bool) {
        let mut mark = Sketch::default();
        mark.draw(self.strokes(), 2.0 * CAP, DVec2::ZERO);
        let thickness = if self == Self::Macron { DVec2::new(0.0, -1.0) } else { DVec2::X } / CAP;
        for copy in 0..=i32::from(heavy) {
            let shift = place + (f64::from(copy) - if heavy { 0.5 } else { 0.0 }) * thickness;
            sketch.add(&mark, |point| DVec2::new(point.x + slant * point.y, point.y) + shift);
        }
    }

    /// Puts the mark on a letter. A letter with a dot has to come without it when the mark is above.
    pub(crate) fn put_on(self, letter: &mut Sketch, slant: f64, heavy: bool) {
        let [low, high] = letter.bounds();
        let middle = (low + high) / 2.0;
        let at = |y: f64| middle.x + slant * (y - middle.y);
        let place = match self {
            Self::SideCaron if high.y < 0.9 => DVec2::new(at(1.0), high.y + 6.5 / CAP),
            Self::SideCaron => {
                letter.set_advance(letter.advance() + 3.0 / CAP);
                DVec2::new((high.x + slant * (1.0 - high.y)).min(at(1.0) + 5.0 / CAP) + 3.0 / CAP, 19.0 / CAP)
            }
            Self::Cedilla | Self::CommaBelow => DVec2::new(at(0.0), low.y.clamp(-1.0 / CAP, 0.0)),
            Self::Ogonek => DVec2::new(high.x - slant * high.y - 2.0 / CAP, 0.0),
            _ => {
                let y = attachment(high.y);
                DVec2::new(at(y), y)
            }
        };
        self.draw(letter, place, slant, heavy);
    }
}

/// Height above the base line to which a letter of an ink height reaches for its accent.
pub(crate) fn attachment(top: f64) -> f64 {
    top.clamp(14.0 / CAP, 1.0)
}
