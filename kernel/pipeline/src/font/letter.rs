//! Characters that the Hershey repertoire lacks, composed of its figures and of strokes drawn for the purpose.

use glam::DVec2;

use super::accent::{Mark, decompose};
use super::hand_drawn::hand_drawn;
use super::hershey::CAP;
use super::repertoire::{Family, Keys, Weight};
use super::sketch::Sketch;

/// The plain character that looks like another one.
fn look_alike(character: char) -> Option<char> {
    Some(match character {
        '\u{ad}' | '‐' | '‑' | '⁃' => '-',
        '∆' => 'Δ',
        '\u{2126}' => 'Ω',
        '\u{212a}' => 'K',
        '\u{212b}' => 'Å',
        '∗' | '⁎' => '*',
        '∕' | '⁄' => '/',
        '∣' | 'ǀ' => '|',
        '′' | 'ʹ' => '\'',
        '″' | 'ʺ' => '"',
        '―' => '—',
        'ʼ' => '’',
        '∙' => '·',
        'Đ' | 'Ɖ' => 'Ð',
        '›' => '⟩',
        '‹' => '⟨',
        'І' => 'I',
        'і' => 'i',
        'Ј' => 'J',
        'ј' => 'j',
        'Ѕ' => 'S',
        'ѕ' => 's',
        other if other.is_whitespace() && other != ' ' => ' ',
        _ => return None,
    })
}

/// Draws hand drawn strokes, twice for letters of double lines.
fn ink(sketch: &mut Sketch, strokes: &[&[(i8, i8)]], heavy: bool) {
    sketch.draw(strokes, CAP, DVec2::ZERO);
    if heavy {
        sketch.draw(strokes, CAP, DVec2::X / CAP);
    }
}

/// A straight stroke between two places in Hershey units.
fn line(sketch: &mut Sketch, from: (f64, f64), to: (f64, f64)) {
    sketch.point(DVec2::from(from) / CAP);
    sketch.point(DVec2::from(to) / CAP);
    sketch.lift();
}

/// A sketch followed by another, their ink `gap` units apart.
fn joined(first: &Sketch, second: &Sketch, gap: f64) -> Sketch {
    let shift = first.bounds()[1].x - second.bounds()[0].x + gap / CAP;
    let mut sketch = first.clone();
    sketch.add(second, |point| point + DVec2::new(shift, 0.0));
    sketch.set_advance(shift + second.advance());
    sketch
}

/// A sketch reduced by a factor, its base line raised by a number of character heights.
fn reduced(sketch: &Sketch, factor: f64, raise: f64) -> Sketch {
    sketch.mapped(sketch.advance() * factor, |point| point * factor + DVec2::new(0.0, raise))
}

impl Family {
    fn heavy(&self) -> bool {
        !matches!(self.weight, Weight::Cartographic | Weight::Simplex)
    }

    /// Whether the letters are script or Gothic.
    fn is_ornate(&self) -> bool {
        self.weight == Weight::Gothic || self.descent > 7
    }

    /// The drawing of a character in this family: a figure of the repertoire or a composition; none when the
    /// family has nothing to compose it of.
    pub(crate) fn sketch(&self, character: char) -> Option<Sketch> {
        if let Some(figure) = self.figure(character) {
            return super::hershey::figure(figure);
        }
        if let Some(capital) = self.capital(character) {
            return self.sketch(capital);
        }
        if let Some((base, mark)) = decompose(character) {
            let mut letter = self.part(base)?;
            if mark.above() {
                letter = dotless(base, &letter);
            }
            mark.put_on(&mut letter, self.slant, self.heavy());
            return Some(letter);
        }
        if let Some(plain) = look_alike(character) {
            return self.part(plain);
        }
        self.alone(character).or_else(|| self.composed(character)).or_else(|| self.by_hand(character))
    }

    /// A character that another one is composed of, unless the keys of the family show something else for it.
    fn part(&self, base: char) -> Option<Sketch> {
        if base.is_ascii() && !matches!(self.keys, Keys::Latin(..)) {
            return None;
        }
        self.sketch(base)
    }

    /// The capital of a small letter in a family that has capitals only.
    fn capital(&self, character: char) -> Option<char> {
        let single = matches!(self.keys, Keys::Latin(upper, lower) if upper == lower);
        let mut capitals = character.to_uppercase();
        let capital =
            capitals.next().filter(|_| single && character.is_lowercase() && character < '\u{370}')?;
        (capitals.next().is_none() && capital != character).then_some(capital)
    }

    fn by_hand(&self, character: char) -> Option<Sketch> {
        let (width, strokes) = hand_drawn(character)?;
        let mut sketch = Sketch::new(f64::from(width) / CAP);
        ink(&mut sketch, strokes, self.heavy());
        if matches!(character, 'Æ' | 'ß' | 'ſ' | '£') {
            sketch = sketch
                .mapped(sketch.advance(), |point| point + DVec2::new(self.slant * (point.y - 0.4), 0.0));
        }
        Some(sketch)
    }

    /// A mark without a letter: a combining character on a body of no width, or a spacing one on its own body.
    fn alone(&self, character: char) -> Option<Sketch> {
        let mark = Mark::of(character)?;
        let combining = ('\u{300}'..='\u{36f}').contains(&character);
        let mut sketch = Sketch::new(if combining { 0.0 } else { 14.0 / CAP });
        let place = DVec2::new(sketch.advance() / 2.0, if mark.above() { 14.0 / CAP } else { 0.0 });
        mark.draw(&mut sketch, place, self.slant, self.heavy());
        Some(sketch)
    }

    /// Letters and signs that are a letter with a bar, two letters in one, or a letter reduced or turned.
    fn composed(&self, character: char) -> Option<Sketch> {
        let get = |base: char| self.part(base);
        // A letter with bars between places given relative to its ink: (left, right, centre, height).
        let barred = |base: char, bars: &[[Place; 2]]| {
            let mut sketch = get(base)?;
            let [low, high] = sketch.bounds().map(|corner| corner * CAP);
            for bar in bars {
                let [from, to] = bar.map(|place| place.resolve(low, high, self.slant));
                line(&mut sketch, from, to);
            }
            Some(sketch)
        };
        use Place::{Centre as C, Left as L, Right as R};
        let serif = if self.heavy() && self.weight != Weight::Duplex { 3.0 } else { 0.0 };
        match character {
            // Bowls of letters that are not upright do not fit other letters' stems.
            'Þ' | 'þ' | 'ð' if self.is_ornate() => None,
            'ı' => get('i').map(|letter| dotless('i', &letter)),
            'ȷ' => get('j').map(|letter| dotless('j', &letter)),
            'Ø' => barred('O', &[[L(0.0, -1.0), R(0.0, 22.0)]]),
            'ø' => barred('o', &[[L(-1.0, -1.0), R(1.0, 15.0)]]),
            'Ð' => barred('D', &[[L(-2.0, 11.0), L(8.0, 11.0)]]),
            'đ' => barred('d', &[[R(-7.0 - serif, 17.0), R(2.0 - serif / 2.0, 17.0)]]),
            'ð' => barred(
                'o',
                &[[R(0.0, 7.0), C(2.0, 16.0)], [C(2.0, 16.0), C(-3.0, 21.0)], [C(-3.0, 15.0), C(5.0, 20.0)]],
            ),
            'Ħ' => barred('H', &[[L(-2.0, 16.0), R(2.0, 16.0)]]),
            'ħ' => barred('h', &[[L(-2.0, 17.0), L(7.0, 17.0)]]),
            'Ł' => barred('L', &[[L(-2.0, 8.0), L(8.0, 14.0)]]),
            'ł' => barred('l', &[[C(-4.0, 8.0), C(4.0, 13.0)]]),
            'Ŧ' => barred('T', &[[C(-5.0, 11.0), C(5.0, 11.0)]]),
            'ŧ' => barred('t', &[[C(-4.0, 8.0), C(4.0, 8.0)]]),
            '¢' => barred('c', &[[C(0.0, -3.0), C(0.0, 17.0)]]),
            '€' => barred('C', &[[L(-2.0, 12.0), L(10.0, 12.0)], [L(-2.0, 9.0), L(10.0, 9.0)]]),
            '¥' => barred('Y', &[[C(-6.0, 8.0), C(6.0, 8.0)], [C(-6.0, 4.0), C(6.0, 4.0)]]),
            'Ŋ' | 'ŋ' => {
                let base = if character == 'Ŋ' { 'N' } else { 'n' };
                let edge = |x: f64, y: f64| R(x - serif, y);
                barred(
                    base,
                    &[
                        [edge(0.0, 0.0), edge(0.0, -3.0)],
                        [edge(0.0, -3.0), edge(-2.0, -6.0)],
                        [edge(-2.0, -6.0), edge(-5.0, -6.0)],
                    ],
                )
            }
            'Ґ' | 'ґ' => barred(
                if character == 'Ґ' { 'Г' } else { 'г' },
                &[[
                    R(0.0, if character == 'Ґ' { 21.0 } else { 14.0 }),
                    R(0.0, if character == 'Ґ' { 25.0 } else { 18.0 }),
                ]],
            ),
            'Є' | 'є' => {
                let letter = get(if character == 'Є' { 'Э' } else { 'э' })?;
                let width = letter.advance();
                Some(letter.mapped(width, |point| DVec2::new(width - point.x, point.y)))
            }
            'Þ' => {
                let (stem, bowl) = (get('I')?, get('P')?);
                let left = bowl.bounds()[0].x - stem.bounds()[0].x;
                let mut sketch =
                    bowl.mapped(bowl.advance(), |point| DVec2::new(point.x, (point.y - 5.0 / CAP).max(0.0)));
                sketch.add(&stem, |point| point + DVec2::new(left, 0.0));
                Some(sketch)
            }
            'þ' => {
                let (ascender, descender) = (get('b')?, get('p')?);
                let shift = descender.bounds()[1].x - ascender.bounds()[1].x;
                let mut sketch = descender.clone();
                sketch.add(&ascender, |point| point + DVec2::new(shift, 0.0));
                Some(sketch)
            }
            'æ' => Some(joined(&get('a')?, &get('e')?, if serif > 0.0 { -3.0 } else { 0.0 })),
            'œ' => Some(joined(&get('o')?, &get('e')?, if serif > 0.0 { -1.0 } else { 0.0 })),
            'Œ' => Some(joined(&get('O')?, &get('E')?, if serif > 0.0 { -2.0 } else { -1.0 })),
            'Ĳ' => Some(joined(&get('I')?, &get('J')?, 3.0)),
            'ĳ' => Some(joined(&get('i')?, &get('j')?, 3.0)),
            'ŉ' => Some(joined(&get('’')?, &get('n')?, 3.0)),
            'Ŀ' | 'ŀ' => Some(joined(
                &get(if character == 'Ŀ' { 'L' } else { 'l' })?,
                &get('·')?,
                if character == 'Ŀ' { -3.0 } else { 2.0 },
            )),
            'ĸ' => get('K').map(|letter| {
                letter.mapped(letter.advance() * 0.8, |point| point * DVec2::new(0.8, 2.0 / 3.0))
            }),
            '¡' | '¿' => {
                let sign = get(if character == '¡' { '!' } else { '?' })?;
                let width = sign.advance();
                Some(sign.mapped(width, |point| DVec2::new(width - point.x, 14.0 / CAP - point.y)))
            }
            'ª' | 'º' => {
                let mut sketch =
                    reduced(&get(if character == 'ª' { 'a' } else { 'o' })?, 0.65, 1.0 - 0.65 * 14.0 / CAP);
                let [low, high] = sketch.bounds().map(|corner| corner * CAP);
                line(&mut sketch, (low.x, 9.0), (high.x, 9.0));
                Some(sketch)
            }
            '¹' | '²' | '³' | '⁰' | '⁴'..='⁹' => {
                let digit = match character {
                    '¹' => '1',
                    '²' => '2',
                    '³' => '3',
                    other => char::from_digit(u32::from(other) - u32::from('⁰'), 10)?,
                };
                Some(reduced(&get(digit)?, 0.6, 0.4))
            }
            '₀'..='₉' => {
                let digit = char::from_digit(u32::from(character) - u32::from('₀'), 10)?;
                Some(reduced(&get(digit)?, 0.6, -0.2))
            }
            '¼' | '½' | '¾' => {
                let (over, under) = match character {
                    '¼' => ('1', '4'),
                    '½' => ('1', '2'),
                    _ => ('3', '4'),
                };
                let over = reduced(&get(over)?, 0.55, 0.45);
                let under = reduced(&get(under)?, 0.55, 0.0);
                let mut stroke = Sketch::default();
                line(&mut stroke, (0.0, 0.0), (14.0, 21.0));
                Some(joined(&joined(&over, &stroke, -4.0), &under, -4.0))
            }
            '©' | '®' => {
                let letter = get(if character == '©' { 'C' } else { 'R' })?;
                let [low, high] = letter.bounds();
                let centre = DVec2::new(12.5, 10.5) / CAP;
                let mut sketch = Sketch::new(25.0 / CAP);
                for step in 0..=24 {
                    let angle = f64::from(step) * std::f64::consts::TAU / 24.0;
                    sketch.point(centre + DVec2::from_angle(angle) * (10.5 / CAP));
                }
                sketch.lift();
                sketch.add(&letter, |point| centre + (point - (low + high) / 2.0) * 0.5);
                Some(sketch)
            }
            '™' => {
                let pair = joined(&get('T')?, &get('M')?, 3.0);
                Some(reduced(&pair, 0.5, 0.5))
            }
            '“' | '”' | '„' | '…' | '‚' => {
                let single = get(match character {
                    '“' => '‘',
                    '”' => '’',
                    '…' => '.',
                    _ => ',',
                })?;
                Some(match character {
                    '‚' => single,
                    '…' => joined(&joined(&single, &single, 5.0), &single, 5.0),
                    _ => joined(&single, &single, 4.0),
                })
            }
            '•' => get('●').map(|disc| {
                let shift = DVec2::new(7.0 / CAP - disc.advance() / 2.0, 0.0);
                disc.mapped(14.0 / CAP, |point| point + shift)
            }),
            '‰' => {
                let ring = reduced(&get('°')?, 1.0, 0.0);
                let drop = ring.bounds()[0].y;
                Some(joined(
                    &get('%')?,
                    &ring.mapped(ring.advance(), |point| point - DVec2::new(0.0, drop)),
                    2.0,
                ))
            }
            _ => None,
        }
    }
}

/// A place relative to the ink of a letter in Hershey units: sideways from an edge or the centre, and a height.
#[derive(Clone, Copy)]
enum Place {
    Left(f64, f64),
    Right(f64, f64),
    Centre(f64, f64),
}

impl Place {
    fn resolve(self, low: DVec2, high: DVec2, slant: f64) -> (f64, f64) {
        let middle = (low + high) / 2.0;
        match self {
            Self::Left(x, y) => (low.x + x + slant * (y - low.y.max(0.0)), y),
            Self::Right(x, y) => (high.x + x + slant * (y - high.y), y),
            Self::Centre(x, y) => (middle.x + x + slant * (y - middle.y), y),
        }
    }
}

/// A letter without the dot that i and j have above the x-height.
fn dotless(base: char, letter: &Sketch) -> Sketch {
    if !matches!(base, 'i' | 'j' | 'і' | 'ј') {
        return letter.clone();
    }
    letter.retaining(|stroke| stroke.iter().any(|point| point.y <= 14.5 / CAP))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::font::repertoire::FAMILIES;

    fn family(number: i32) -> &'static Family {
        FAMILIES.iter().find(|family| family.number == number).unwrap()
    }

    /// The character's drawing in the family or in the roman family that stands in for it.
    fn drawn(of: &Family, character: char) -> Option<Sketch> {
        of.sketch(character).or_else(|| family(of.weight.roman()).sketch(character))
    }

    #[test]
    fn every_family_draws_all_of_latin_1_and_latin_extended_a() {
        for family in &FAMILIES {
            for character in ('!'..='~').chain('\u{a1}'..='\u{17f}') {
                let sketch =
                    drawn(family, character).unwrap_or_else(|| panic!("{} {character}", family.name));
                let [low, high] = sketch.bounds();
                assert_ne!(low, high, "{} {character} is blank", family.name);
                let overlays = matches!(family.keys, Keys::Symbols(_));
                assert!(sketch.advance() > 0.0 || overlays, "{} {character}", family.name);
            }
        }
    }

    #[test]
    fn accented_letters_stay_within_the_character_body() {
        for family in FAMILIES.iter().filter(|family| matches!(family.keys, Keys::Latin(..))) {
            for character in ('À'..='ſ').filter(|&character| decompose(character).is_some()) {
                let (Some(sketch), Some((base, mark))) = (family.sketch(character), decompose(character))
                else {
                    panic!("{} {character}", family.name);
                };
                let plain = family.sketch(base).unwrap();
                let [low, high] = sketch.bounds();
                assert!(high.y < 28.0 / CAP + 1e-9, "{} {character} reaches {}", family.name, high.y);
                if mark.above() {
                    let top = if matches!(base, 'i' | 'j') { 14.0 / CAP } else { plain.bounds()[1].y };
                    assert!(high.y > top, "{} {character} has nothing above", family.name);
                } else if mark != Mark::SideCaron {
                    assert!(low.y < 0.0, "{} {character} has nothing below", family.name);
                }
            }
        }
    }

    #[test]
    fn i_loses_its_dot_below_an_accent() {
        let simplex = family(-4);
        let strokes = |character| simplex.sketch(character).unwrap().strokes().count();
        // Stem and dot; stem; stem and two strokes of dots; stem and accent.
        assert_eq!(['i', 'ı', 'ï', 'í'].map(strokes), [2, 1, 3, 2]);
        assert_eq!(strokes('į'), 3);
    }

    #[test]
    fn what_the_keys_hide_comes_from_the_roman_family() {
        for number in [-5, -8, -11, -18, -19, -20] {
            for character in "éñ¿½©\u{ad}…".chars() {
                assert!(family(number).sketch(character).is_none(), "{number} {character}");
            }
        }
        // But Greek and Russian letters with accents are composed of their own kind.
        assert!(family(-5).sketch('έ').is_some());
        assert!(family(-11).sketch('ё').is_some());
    }
}
