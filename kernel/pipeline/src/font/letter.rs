//! Characters that the Hershey repertoire lacks, composed of its figures and of strokes drawn for the purpose.
//!
//! Hand drawn strokes are in Hershey units, 21 to the character height, base line at 0.

use glam::DVec2;

use super::accent::{Mark, decompose};
use super::hershey::CAP;
use super::repertoire::{Family, Keys, Weight};
use super::sketch::Sketch;

type Strokes = &'static [&'static [(i8, i8)]];

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

/// Strokes and body width of a character that is drawn by hand; doubled for heavy weights.
fn hand_drawn(character: char) -> Option<(i8, Strokes)> {
    Some(match character {
        '[' => (14, &[&[(10, 25), (4, 25), (4, -7), (10, -7)]]),
        ']' => (14, &[&[(4, 25), (10, 25), (10, -7), (4, -7)]]),
        '{' => (
            14,
            &[&[
                (11, 25),
                (9, 24),
                (8, 22),
                (8, 12),
                (7, 10),
                (4, 9),
                (7, 8),
                (8, 6),
                (8, -4),
                (9, -6),
                (11, -7),
            ]],
        ),
        '}' => (
            14,
            &[&[
                (3, 25),
                (5, 24),
                (6, 22),
                (6, 12),
                (7, 10),
                (10, 9),
                (7, 8),
                (6, 6),
                (6, -4),
                (5, -6),
                (3, -7),
            ]],
        ),
        '\\' => (22, &[&[(2, 25), (20, -7)]]),
        '^' => (18, &[&[(3, 13), (9, 21), (15, 13)]]),
        '_' => (20, &[&[(0, -5), (20, -5)]]),
        '`' => (14, &[&[(4, 21), (9, 15)]]),
        '~' => (24, &[&[(3, 7), (4, 10), (6, 11), (9, 11), (15, 7), (18, 7), (20, 8), (21, 11)]]),
        '¦' => (8, &[&[(4, 25), (4, 12)], &[(4, 6), (4, -7)]]),
        '£' => (
            20,
            &[
                &[
                    (16, 17),
                    (15, 20),
                    (12, 21),
                    (10, 21),
                    (8, 20),
                    (7, 18),
                    (7, 5),
                    (6, 2),
                    (3, 0),
                    (16, 0),
                    (18, 3),
                ],
                &[(3, 11), (13, 11)],
            ],
        ),
        '¤' => (
            18,
            &[
                &[
                    (9, 15),
                    (6, 14),
                    (4, 11),
                    (4, 9),
                    (6, 6),
                    (9, 5),
                    (12, 6),
                    (14, 9),
                    (14, 11),
                    (12, 14),
                    (9, 15),
                ],
                &[(2, 17), (6, 14)],
                &[(16, 17), (12, 14)],
                &[(2, 3), (6, 6)],
                &[(16, 3), (12, 6)],
            ],
        ),
        '«' => (18, &[&[(9, 13), (3, 8), (9, 3)], &[(15, 13), (9, 8), (15, 3)]]),
        '»' => (18, &[&[(3, 13), (9, 8), (3, 3)], &[(9, 13), (15, 8), (9, 3)]]),
        '¬' => (24, &[&[(3, 11), (21, 11), (21, 5)]]),
        '¶' => (
            20,
            &[
                &[(17, 21), (7, 21), (4, 20), (2, 17), (2, 15), (4, 12), (7, 11), (12, 11)],
                &[(12, 21), (12, -7)],
                &[(16, 21), (16, -7)],
            ],
        ),
        'ß' => (
            19,
            &[&[
                (4, 0),
                (4, 16),
                (5, 19),
                (7, 21),
                (10, 21),
                (12, 20),
                (13, 18),
                (13, 16),
                (12, 14),
                (9, 12),
                (12, 11),
                (14, 9),
                (15, 6),
                (15, 4),
                (14, 2),
                (12, 0),
                (9, 0),
                (8, 1),
            ]],
        ),
        'ſ' => (11, &[&[(4, 0), (4, 17), (5, 20), (7, 21), (9, 21)]]),
        'Æ' => (
            26,
            &[
                &[(1, 0), (12, 21)],
                &[(13, 21), (13, 0)],
                &[(12, 21), (24, 21)],
                &[(13, 11), (21, 11)],
                &[(13, 0), (24, 0)],
                &[(5, 7), (13, 7)],
            ],
        ),
        '—' => (28, &[&[(2, 9), (26, 9)]]),
        '⟨' => (12, &[&[(8, 13), (3, 8), (8, 3)]]),
        '⟩' => (12, &[&[(4, 13), (9, 8), (4, 3)]]),
        '∅' => (
            22,
            &[
                &[
                    (11, 19),
                    (6, 17),
                    (3, 13),
                    (3, 7),
                    (6, 3),
                    (11, 1),
                    (16, 3),
                    (19, 7),
                    (19, 13),
                    (16, 17),
                    (11, 19),
                ],
                &[(4, 0), (18, 20)],
            ],
        ),
        '≈' => (
            24,
            &[
                &[(3, 9), (5, 12), (8, 13), (16, 9), (19, 10), (21, 13)],
                &[(3, 3), (5, 6), (8, 7), (16, 3), (19, 4), (21, 7)],
            ],
        ),
        '≪' => (28, &[&[(15, 18), (3, 9), (15, 0)], &[(25, 18), (13, 9), (25, 0)]]),
        '≫' => (28, &[&[(3, 18), (15, 9), (3, 0)], &[(13, 18), (25, 9), (13, 0)]]),
        '↔' => (32, &[&[(7, 13), (3, 9), (7, 5)], &[(3, 9), (29, 9)], &[(25, 13), (29, 9), (25, 5)]]),
        '⇒' => (32, &[&[(3, 11), (27, 11)], &[(3, 7), (27, 7)], &[(23, 15), (29, 9), (23, 3)]]),
        '⇐' => (32, &[&[(29, 11), (5, 11)], &[(29, 7), (5, 7)], &[(9, 15), (3, 9), (9, 3)]]),
        '∀' => (20, &[&[(2, 21), (10, 0), (18, 21)], &[(5, 14), (15, 14)]]),
        '∧' => (20, &[&[(3, 1), (10, 17), (17, 1)]]),
        '∨' => (20, &[&[(3, 17), (10, 1), (17, 17)]]),
        '✓' => (20, &[&[(3, 8), (8, 2), (17, 18)]]),
        _ => return None,
    })
}

/// Draws hand drawn strokes, twice for letters of double lines.
fn ink(sketch: &mut Sketch, strokes: &[&[(i8, i8)]], shift: DVec2, heavy: bool) {
    sketch.draw(strokes, CAP, shift);
    if heavy {
        sketch.draw(strokes, CAP, shift + DVec2::new(1.0, 0.0) / CAP);
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

    /// The drawing of a character in this family: a figure of the repertoire or a composition; none when the
    /// family has nothing to compose it of.
    pub(crate) fn sketch(&self, character: char) -> Option<Sketch> {
        if let Some(figure) = self.figure(character) {
            return super::hershey::figure(figure);
        }
        if matches!(character, ' '..='~') {
            return self.by_hand(character);
        }
        if let Some((base, mark)) = decompose(character) {
            let mut letter = self.letter(base)?;
            if mark.above() {
                letter = dotless(base, &letter);
            }
            mark.put_on(&mut letter, self.slant, self.heavy());
            return Some(letter);
        }
        if let Some(plain) = look_alike(character) {
            return self.sketch(plain);
        }
        self.alone(character).or_else(|| self.composed(character)).or_else(|| self.by_hand(character))
    }

    /// The drawing of a letter, unless it is a Latin letter in a family whose Latin keys show something else.
    fn letter(&self, base: char) -> Option<Sketch> {
        if base.is_ascii_alphabetic() && !matches!(self.keys, Keys::Latin(..)) {
            return None;
        }
        self.sketch(base)
    }

    fn by_hand(&self, character: char) -> Option<Sketch> {
        let (width, strokes) = hand_drawn(character)?;
        let mut sketch = Sketch::new(f64::from(width) / CAP);
        ink(&mut sketch, strokes, DVec2::ZERO, self.heavy());
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
        let get = |base: char| self.letter(base);
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
                let letter = self.sketch(if character == 'Є' { 'Э' } else { 'э' })?;
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
                let mut sketch = descender.clone();
                sketch.add(&ascender, |point| {
                    point + DVec2::new(descender.bounds()[0].x - ascender.bounds()[0].x, 0.0)
                });
                Some(sketch)
            }
            'æ' => Some(joined(&get('a')?, &get('e')?, if serif > 0.0 { -3.0 } else { 0.0 })),
            'œ' => Some(joined(&get('o')?, &get('e')?, if serif > 0.0 { -1.0 } else { 0.0 })),
            'Œ' => Some(joined(&get('O')?, &get('E')?, -4.0 - serif)),
            'Ĳ' => Some(joined(&get('I')?, &get('J')?, 3.0)),
            'ĳ' => Some(joined(&get('i')?, &get('j')?, 3.0)),
            'ŉ' => Some(joined(&self.sketch('’')?, &get('n')?, 3.0)),
            'Ŀ' | 'ŀ' => Some(joined(
                &get(if character == 'Ŀ' { 'L' } else { 'l' })?,
                &self.sketch('·')?,
                if character == 'Ŀ' { -3.0 } else { 2.0 },
            )),
            'ĸ' => get('K').map(|letter| {
                letter.mapped(letter.advance() * 0.8, |point| point * DVec2::new(0.8, 2.0 / 3.0))
            }),
            '¡' | '¿' => {
                let sign = self.sketch(if character == '¡' { '!' } else { '?' })?;
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
                Some(reduced(&self.sketch(digit)?, 0.6, 0.4))
            }
            '₀'..='₉' => {
                let digit = char::from_digit(u32::from(character) - u32::from('₀'), 10)?;
                Some(reduced(&self.sketch(digit)?, 0.6, -0.2))
            }
            '¼' | '½' | '¾' => {
                let (over, under) = match character {
                    '¼' => ('1', '4'),
                    '½' => ('1', '2'),
                    _ => ('3', '4'),
                };
                let over = reduced(&self.sketch(over)?, 0.55, 0.45);
                let under = reduced(&self.sketch(under)?, 0.55, 0.0);
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
                let single = self.sketch(match character {
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
            '•' => self.sketch('●'),
            '‰' => {
                let ring = reduced(&self.sketch('°')?, 1.0, 0.0);
                let drop = ring.bounds()[0].y;
                Some(joined(
                    &self.sketch('%')?,
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
