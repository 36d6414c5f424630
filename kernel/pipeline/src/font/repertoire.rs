//! Which character of which stroke family is which Hershey figure.
//!
//! Letters and digits follow the order of the repertoire. The keys of the Greek, Cyrillic and symbol families are
//! those of NCAR's font tables for the same font numbers, so that programs written for them show what they meant.

/// Line weight and design of a family: it selects digits, punctuation and the Greek and Cyrillic letters that go
/// with the family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Weight {
    Cartographic,
    Simplex,
    Duplex,
    Complex,
    Italic,
    Triplex,
    TriplexItalic,
    Gothic,
}

/// What the keys of a family stand for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Keys {
    /// Latin letters: the figures of `A` and `a`.
    Latin(u16, u16),
    /// Greek letters on Latin keys: the figures of Alpha and alpha.
    Greek(u16, u16),
    /// Cyrillic letters in alphabetical order on Latin keys.
    Cyrillic,
    /// A figure for every key from `!` on, 0 where the complex roman character is shown.
    Symbols(&'static [u16]),
}

/// The design of a stroke family.
#[derive(Debug)]
pub(crate) struct Family {
    pub(crate) number: i32,
    pub(crate) name: &'static str,
    pub(crate) weight: Weight,
    pub(crate) keys: Keys,
    /// Bottom line in Hershey units below the base line.
    pub(crate) descent: i8,
    /// Tangent of the slope of stems.
    pub(crate) slant: f64,
}

const fn family(number: i32, name: &'static str, weight: Weight, keys: Keys) -> Family {
    let slant = match weight {
        Weight::Italic | Weight::TriplexItalic => 0.3,
        _ => 0.0,
    };
    Family { number, name, weight, keys, descent: 7, slant }
}

const fn deep(mut family: Family, descent: i8, slant: f64) -> Family {
    family.descent = descent;
    family.slant = slant;
    family
}

/// The stroke families in the order of their font numbers: 1, -2, -3, ... -20.
pub(crate) static FAMILIES: [Family; 20] = [
    family(1, "Hershey Monospaced Simplex", Weight::Simplex, Keys::Latin(501, 601)),
    family(-2, "Hershey Cartographic Roman", Weight::Cartographic, Keys::Latin(1, 1)),
    family(-3, "Hershey Cartographic Greek", Weight::Cartographic, Keys::Greek(27, 27)),
    family(-4, "Hershey Simplex Roman", Weight::Simplex, Keys::Latin(501, 601)),
    family(-5, "Hershey Simplex Greek", Weight::Simplex, Keys::Greek(527, 627)),
    deep(family(-6, "Hershey Simplex Script", Weight::Simplex, Keys::Latin(551, 651)), 12, 0.4),
    family(-7, "Hershey Complex Roman", Weight::Complex, Keys::Latin(2001, 2101)),
    family(-8, "Hershey Complex Greek", Weight::Complex, Keys::Greek(2027, 2127)),
    deep(family(-9, "Hershey Complex Script", Weight::Italic, Keys::Latin(2551, 2651)), 12, 0.4),
    family(-10, "Hershey Complex Italic", Weight::Italic, Keys::Latin(2051, 2151)),
    family(-11, "Hershey Complex Cyrillic", Weight::Complex, Keys::Cyrillic),
    family(-12, "Hershey Duplex Roman", Weight::Duplex, Keys::Latin(2501, 2601)),
    family(-13, "Hershey Triplex Roman", Weight::Triplex, Keys::Latin(3001, 3101)),
    family(-14, "Hershey Triplex Italic", Weight::TriplexItalic, Keys::Latin(3051, 3151)),
    family(-15, "Hershey Gothic German", Weight::Gothic, Keys::Latin(3301, 3401)),
    family(-16, "Hershey Gothic English", Weight::Gothic, Keys::Latin(3501, 3601)),
    family(-17, "Hershey Gothic Italian", Weight::Gothic, Keys::Latin(3801, 3901)),
    deep(family(-18, "Hershey Mathematical Symbols", Weight::Complex, Keys::Symbols(&MATHEMATICS)), 11, 0.0),
    deep(family(-19, "Hershey Symbol Set 1", Weight::Complex, Keys::Symbols(&SYMBOLS_1)), 13, 0.0),
    deep(family(-20, "Hershey Symbol Set 2", Weight::Complex, Keys::Symbols(&SYMBOLS_2)), 13, 0.0),
];

#[rustfmt::skip]
const MATHEMATICS: [u16; 94] = [
    2214, 2217, 2275, 1402, 2271, 2272, 2216, 2221, 2222, 2219,  725, 2211,  724, 2210, 720,
     700,  701,  702,  703,  704,  705,  706,  707,  708,  709,  712, 2213, 2241, 726, 2242, 2215, 2273,
     738,  739,  740,  751,  798,  799,  847,  850,  718,  797, 2243, 2244, 2277,
    2278, 2227, 2228,  723, 2230, 2233, 2234,  727,  729, 2237, 2239, 2240, 2281,
    1405,  804, 1406, 2247, 2279, 2249,
    2245, 2246, 2248, 2250,  731,  730, 2253, 2254, 2255, 2256, 2257, 2258, 2259,
    2260, 2261, 2262, 2263, 2264, 2265, 2266, 2267, 1412, 2269, 2270, 1401, 2276,
    1407,  723, 1408,  765,
];

#[rustfmt::skip]
const SYMBOLS_1: [u16; 94] = [
    235, 583, 735, 741, 742, 743, 744, 745, 746, 753, 754, 755, 756, 757, 758,
    759, 760, 761, 762, 763, 764, 765, 767, 768, 796, 800, 801, 802, 803, 804, 805, 806,
    807, 808, 809, 810, 811, 812, 813, 814, 817, 818, 819, 820, 821,
    822, 823, 824, 825, 826, 827, 829, 830, 831, 833, 834, 840, 841,
    842, 843, 844, 851, 852, 853,
    854, 855, 856, 857, 860, 861, 862, 863, 864, 865, 866, 867, 868,
    869, 870, 871, 872, 873, 874, 899, 900, 901, 902, 903, 904, 905,
    906, 908, 909, 907,
];

#[rustfmt::skip]
const SYMBOLS_2: [u16; 94] = [
    2178, 2179, 2180, 2181, 2182, 2190, 2191, 2192, 2193, 2194, 2195, 2196, 2282, 2283, 2284,
    2285, 2286, 2287, 2288, 2289, 2290, 2291, 2292, 2293, 2294, 2295, 2301, 2302, 2303, 2304, 2305, 2306,
    2307, 2308, 2309, 2310, 2311, 2312, 2317, 2318, 2319, 2320, 2321, 2322, 2323,
    2324, 2325, 2326, 2327, 2328, 2329, 2330, 2331, 2332, 2367, 2368, 2369, 2370,
    2371, 2372, 2373, 2374, 2375, 2376,
    2377, 2382, 2379, 2381, 2378, 2401, 2402, 2716, 2717, 2729, 2380, 3266, 3267,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0,
];

/// Punctuation in the order space `!"#$%&'()*+,-./ :;<=>?@ [\]^_` {|}~`; 0 is drawn by hand in `letter`.
const PUNCTUATION: &str = " !\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~";

#[rustfmt::skip]
const fn punctuation(weight: Weight) -> &'static [u16; 33] {
    match weight {
        Weight::Cartographic => &[199, 214, 217, 233, 219, 1271, 234, 216, 221, 222, 228, 225, 211, 224, 210, 220,
            212, 213, 1241, 226, 1242, 215, 1273, 1223, 0, 1224, 0, 0, 0, 1225, 223, 1226, 1246],
        Weight::Simplex => &[699, 714, 717, 733, 719, 2271, 734, 716, 721, 722, 728, 725, 711, 724, 710, 720,
            712, 713, 2241, 726, 2242, 715, 2273, 0, 0, 0, 0, 0, 0, 0, 723, 0, 0],
        Weight::Duplex => &[699, 2714, 2728, 733, 2719, 2271, 2718, 2727, 2721, 2722, 2723, 2725, 2711, 2724, 2710,
            2720, 2712, 2713, 2241, 2726, 2242, 2715, 2273, 2223, 0, 2224, 0, 0, 0, 2225, 723, 2226, 2246],
        Weight::Complex => &[2199, 2214, 2217, 2275, 2274, 2271, 2272, 2216, 2221, 2222, 2219, 2232, 2211, 2231, 2210,
            2220, 2212, 2213, 2241, 2238, 2242, 2215, 2273, 2223, 0, 2224, 2247, 0, 0, 2225, 2229, 2226, 2246],
        Weight::Italic => &[2199, 2764, 2778, 2275, 2769, 2271, 2768, 2777, 2771, 2772, 2773, 2775, 2761, 2774, 2760,
            2770, 2762, 2763, 2241, 2776, 2242, 2765, 2273, 2223, 0, 2224, 2247, 0, 0, 2225, 2229, 2226, 2246],
        Weight::Triplex => &[2199, 3214, 3228, 2275, 3219, 2271, 3218, 3227, 3221, 3222, 3223, 3225, 3211, 3224, 3210,
            3220, 3212, 3213, 2241, 3226, 2242, 3215, 2273, 2223, 0, 2224, 2247, 0, 0, 2225, 2229, 2226, 2246],
        Weight::TriplexItalic => &[2199, 3264, 3278, 2275, 3269, 2271, 3268, 3277, 3271, 3272, 3273, 3275, 3261, 3274,
            3260, 3270, 3262, 3263, 2241, 3276, 2242, 3265, 2273, 2223, 0, 2224, 2247, 0, 0, 2225, 2229, 2226, 2246],
        Weight::Gothic => &[2199, 3714, 3728, 2275, 3719, 2271, 3718, 3727, 3721, 3722, 3723, 3725, 3711, 3724, 3710,
            3720, 3712, 3713, 2241, 3726, 2242, 3715, 2273, 2223, 0, 2224, 2247, 0, 0, 2225, 2229, 2226, 2246],
    }
}

impl Weight {
    /// The figure of the digit zero; the others follow it.
    const fn zero(self) -> u16 {
        match self {
            Self::Cartographic => 200,
            Self::Simplex => 700,
            Self::Duplex => 2700,
            Self::Complex => 2200,
            Self::Italic => 2750,
            Self::Triplex => 3200,
            Self::TriplexItalic => 3250,
            Self::Gothic => 3700,
        }
    }

    /// The figures of Alpha and alpha in the Greek that goes with the weight.
    const fn greek(self) -> (u16, u16) {
        match self {
            Self::Cartographic => (27, 27),
            Self::Simplex | Self::Duplex => (527, 627),
            _ => (2027, 2127),
        }
    }

    /// Whether figures of single lines go better with the weight than those with thick and thin lines.
    const fn light(self) -> bool {
        matches!(self, Self::Cartographic | Self::Simplex | Self::Duplex)
    }

    /// The number of the roman family of the same weight, which stands in for what a family lacks.
    pub(crate) const fn roman(self) -> i32 {
        match self {
            Self::Cartographic => -2,
            Self::Simplex => -4,
            Self::Duplex => -12,
            Self::Complex | Self::Italic => -7,
            Self::Triplex | Self::TriplexItalic | Self::Gothic => -13,
        }
    }
}

impl Family {
    /// The Hershey figure of a character in this family, if it is one figure of the repertoire.
    pub(crate) fn figure(&self, character: char) -> Option<u16> {
        let key = u16::try_from(u32::from(character)).ok()?;
        match (self.keys, character) {
            (Keys::Symbols(figures), '!'..='~') => match figures[usize::from(key) - 0x21] {
                0 => self.ascii(character, 2001, 2101),
                figure => Some(figure),
            },
            // The round s at all places: the long one is a character of its own.
            (Keys::Latin(3301, _), 's') => Some(3427),
            (Keys::Latin(..), 'ſ') if self.weight == Weight::Gothic => Some(3419),
            (Keys::Latin(..), 'ß') if self.weight == Weight::Gothic => Some(3428),
            (Keys::Latin(upper, lower), ' '..='~') => self.ascii(character, upper, lower),
            (Keys::Greek(upper, lower), 'A'..='Z' | 'a'..='z') => Some(greek_key(character, upper, lower)),
            (Keys::Cyrillic, '=' | '>' | '?' | '@' | 'A'..='^' | 'a'..='~') => {
                cyrillic(cyrillic_key(character))
            }
            (_, ' '..='~') => self.ascii(character, 2001, 2101),
            (_, '\u{370}'..='\u{3ff}') => {
                let (upper, lower) = match self.keys {
                    Keys::Greek(upper, lower) => (upper, lower),
                    _ => self.weight.greek(),
                };
                greek(character, upper, lower)
            }
            (_, '\u{400}'..='\u{45f}') => cyrillic(character),
            _ => symbol(character, self.weight),
        }
    }

    fn ascii(&self, character: char, upper: u16, lower: u16) -> Option<u16> {
        let offset = |first: char| u32::from(character) as u16 - first as u16;
        match character {
            'A'..='Z' => Some(upper + offset('A')),
            'a'..='z' => Some(lower + offset('a')),
            '0'..='9' => Some(self.weight.zero() + offset('0')),
            _ => {
                let place = PUNCTUATION.find(character)?;
                Some(punctuation(self.weight)[place]).filter(|&figure| figure != 0)
            }
        }
    }
}

/// Place in the Greek alphabet of the letter on each Latin key from A to Z; J is the open theta, V the final sigma.
const GREEK_KEYS: [u16; 26] =
    [0, 1, 21, 3, 4, 20, 2, 6, 8, 7, 9, 10, 11, 12, 14, 15, 7, 16, 17, 18, 19, 17, 23, 13, 22, 5];

fn greek_key(key: char, upper: u16, lower: u16) -> u16 {
    let place = GREEK_KEYS[(u32::from(key.to_ascii_uppercase()) - u32::from('A')) as usize];
    match key {
        _ if lower == upper => upper + place,
        'J' => lower + 7,
        'V' => lower + 60,
        'f' => lower + 59,
        'j' => lower + 20,
        'q' => lower + 58,
        'v' => lower + 57,
        'A'..='Z' => upper + place,
        _ => lower + place,
    }
}

/// The figure of a letter of the Greek block, given the figures of Alpha and alpha.
fn greek(character: char, upper: u16, lower: u16) -> Option<u16> {
    let single = lower == upper;
    let offset = |first: char| (u32::from(character) - u32::from(first)) as u16;
    Some(match character {
        'Α'..='Ρ' => upper + offset('Α'),
        'Σ'..='Ω' => upper + offset('Α') - 1,
        'ς' if single => upper + 17,
        'ς' => lower + 60,
        'θ' | 'ϑ' if single => upper + 7,
        'θ' => lower + 58,
        'ϑ' => lower + 7,
        'ϕ' if single => upper + 20,
        'ϕ' => lower + 59,
        'ϵ' if single => upper + 4,
        'ϵ' => lower + 57,
        'α'..='ρ' => lower + offset('α'),
        'σ'..='ω' => lower + offset('α') - 1,
        _ => return None,
    })
}

fn cyrillic_key(key: char) -> char {
    const UPPER: &str = "АБВГДЕЖЗИКЛМНОПРСТУФХЦЧШЩЫЬЭЮЯ";
    const LOWER: &str = "абвгдежзиклмнопрстуфхцчшщыьэюя";
    let from = |first: char, letters: &str| letters.chars().nth((u32::from(key) - u32::from(first)) as usize);
    match key {
        '=' => Some('Й'),
        '>' => Some('й'),
        '?' => Some('Ъ'),
        '@' => Some('ъ'),
        'A'..='^' => from('A', UPPER),
        _ => from('a', LOWER),
    }
    .unwrap_or(key)
}

/// The figure of a Russian letter; the repertoire has them in the complex weight only.
fn cyrillic(character: char) -> Option<u16> {
    let offset = |first: char| (u32::from(character) - u32::from(first)) as u16;
    match character {
        'А'..='Я' => Some(2801 + offset('А')),
        'а'..='я' => Some(2901 + offset('а')),
        _ => None,
    }
}

/// The figure of a character outside the alphabets: mathematics, arrows, astronomy, cards, music.
fn symbol(character: char, weight: Weight) -> Option<u16> {
    let (light, heavy) = match character {
        '°' => (718, 2218),
        '·' | '⋅' => (729, 2236),
        '×' => (727, 2235),
        '÷' => (2237, 2237),
        '§' => (2276, 2276),
        'µ' => (638, 2138),
        '−' | '–' => (724, 2231),
        '‘' => (730, 2252),
        '’' => (731, 2251),
        '†' => (2277, 2277),
        '‡' => (2278, 2278),
        '±' => (2233, 2233),
        '∓' => (2234, 2234),
        '≠' => (2239, 2239),
        '≡' => (2240, 2240),
        '≤' | '≦' => (2243, 2243),
        '≥' | '≧' => (2244, 2244),
        '∝' => (2245, 2245),
        '∼' => (2246, 2246),
        '√' => (2255, 2267),
        '⊂' => (2256, 2256),
        '∪' => (2257, 2257),
        '⊃' => (2258, 2258),
        '∩' => (2259, 2259),
        '∈' => (2260, 2260),
        '→' => (2261, 2261),
        '↑' => (2262, 2262),
        '←' => (2263, 2263),
        '↓' => (2264, 2264),
        '∂' => (683, 2265),
        '∇' => (583, 2266),
        '∫' => (2268, 2268),
        '∮' => (2269, 2269),
        '∞' => (766, 2270),
        '∃' => (2279, 2279),
        '∥' | '‖' => (737, 2230),
        '⊥' => (738, 738),
        '∠' => (739, 739),
        '∴' => (740, 740),
        '∏' => (2401, 2401),
        '∑' => (2402, 2402),
        'ℵ' => (2077, 2077),
        '℘' => (2190, 2190),
        'ℓ' => (677, 677),
        '⟨' | '〈' => (2227, 2227),
        '⟩' | '〉' => (2228, 2228),
        'ﬀ' => (2177, 2177),
        'ﬁ' => (2178, 2178),
        'ﬂ' => (2179, 2179),
        'ﬃ' => (2180, 2180),
        'ﬄ' => (2181, 2181),
        '☉' => (2281, 2281),
        '☿' => (2282, 2282),
        '♀' => (2283, 2283),
        '⊕' => (2284, 2284),
        '♂' => (2285, 2285),
        '♃' => (2286, 2286),
        '♄' => (2287, 2287),
        '♅' | '⛢' => (2288, 2288),
        '♆' => (2289, 2289),
        '♇' => (2290, 2290),
        '☽' | '☾' => (2291, 2291),
        '☄' => (2292, 2292),
        '✳' => (2293, 2293),
        '☊' => (2294, 2294),
        '☋' => (2295, 2295),
        '♈'..='♓' => {
            let figure = 2301 + (u32::from(character) - u32::from('♈')) as u16;
            (figure, figure)
        }
        '♠' => (741, 741),
        '♥' | '♡' => (742, 742),
        '♦' | '♢' => (743, 743),
        '♣' => (744, 744),
        '☘' => (745, 745),
        '⚜' => (746, 746),
        '♯' => (2323, 2323),
        '♮' => (2324, 2324),
        '♭' => (2325, 2325),
        '○' => (840, 840),
        '□' => (841, 841),
        '△' => (842, 842),
        '◇' => (843, 843),
        '☆' => (844, 844),
        '●' => (850, 850),
        '■' => (851, 851),
        '▲' => (852, 852),
        '◀' => (853, 853),
        '▼' => (854, 854),
        '▶' => (855, 855),
        '★' => (856, 856),
        '⚓' => (860, 860),
        '☪' => (867, 867),
        '✡' => (868, 868),
        _ => return None,
    };
    Some(if weight.light() { light } else { heavy })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::font::hershey;

    /// Every number in the tables has to exist in the data.
    #[test]
    fn every_key_of_every_family_names_a_figure() {
        for family in &FAMILIES {
            for key in ' '..='~' {
                if let Some(figure) = family.figure(key) {
                    assert!(hershey::figure(figure).is_some(), "{} {key:?} {figure}", family.name);
                } else {
                    assert!("[\\]^_`{}~".contains(key), "{} lacks {key:?}", family.name);
                }
            }
        }
    }

    /// The distribution of the data comes with character maps; our letters and digits are those of the maps.
    #[test]
    fn letters_and_digits_agree_with_the_maps_of_the_distribution() {
        let maps = [
            (-2, include_str!("../../data/hershey/maps/romanp.hmp")),
            (-4, include_str!("../../data/hershey/maps/romans.hmp")),
            (-6, include_str!("../../data/hershey/maps/scripts.hmp")),
            (-7, include_str!("../../data/hershey/maps/romanc.hmp")),
            (-9, include_str!("../../data/hershey/maps/scriptc.hmp")),
            (-10, include_str!("../../data/hershey/maps/italicc.hmp")),
            (-12, include_str!("../../data/hershey/maps/romand.hmp")),
            (-13, include_str!("../../data/hershey/maps/romant.hmp")),
            (-14, include_str!("../../data/hershey/maps/italict.hmp")),
            (-15, include_str!("../../data/hershey/maps/gothger.hmp")),
            (-16, include_str!("../../data/hershey/maps/gotheng.hmp")),
            (-17, include_str!("../../data/hershey/maps/gothita.hmp")),
        ];
        for (number, map) in maps {
            let family = FAMILIES.iter().find(|family| family.number == number).unwrap();
            let figures: Vec<u16> = map
                .lines()
                .filter_map(|line| {
                    let mut fields = line.split_whitespace().map(|field| field.parse::<u16>().unwrap());
                    Some((fields.next()?, fields.next()?))
                })
                .flat_map(|(first, last)| first..=last.max(first))
                .collect();
            for key in ('0'..='9').chain('A'..='Z').chain('a'..='z') {
                let expected = figures[key as usize - 0x20];
                let round_s = number == -15 && key == 's';
                let script_digit = number == -6 && key.is_ascii_digit();
                if !round_s && !script_digit {
                    assert_eq!(family.figure(key), Some(expected), "{} {key}", family.name);
                }
            }
        }
    }

    #[test]
    fn greek_letters_lie_on_their_keys_and_on_their_code_points() {
        let simplex = &FAMILIES[4];
        for (key, letter) in "ABCDEFGHIKLMNOPQRSTUWXYZ".chars().zip("ΑΒΧΔΕΦΓΗΙΚΛΜΝΟΠΘΡΣΤΥΩΞΨΖ".chars())
        {
            assert_eq!(simplex.figure(key), simplex.figure(letter), "{key} {letter}");
        }
        for (key, letter) in
            "abcdeghiklmnopqrstuwxyzVJjfv".chars().zip("αβχδεγηικλμνοπθρστυωξψζςϑφϕϵ".chars())
        {
            assert_eq!(simplex.figure(key), simplex.figure(letter), "{key} {letter}");
        }
        assert_eq!(simplex.figure('Σ'), Some(544));
        assert_eq!(simplex.figure('ω'), Some(650));
        // A roman family writes Greek in the weight that goes with it.
        assert_eq!(FAMILIES[6].figure('Ω'), Some(2050));
        assert_eq!(FAMILIES[3].figure('Ω'), Some(550));
    }

    #[test]
    fn cyrillic_letters_lie_on_their_keys_and_on_their_code_points() {
        let cyrillic = &FAMILIES[10];
        assert_eq!(cyrillic.number, -11);
        for (key, letter) in "ABCYZ^=?abz~>@".chars().zip("АБВЩЫЯЙЪабыяйъ".chars()) {
            assert_eq!(cyrillic.figure(key), cyrillic.figure(letter), "{key} {letter}");
        }
        assert_eq!(cyrillic.figure('Я'), Some(2832));
        assert_eq!(cyrillic.figure('ф'), Some(2921));
    }
}
