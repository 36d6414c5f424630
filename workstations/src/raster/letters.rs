//! Characters of stroke fonts: stamped, since a text has the same ones again and again.

use super::bitmap::Bitmap;
use super::composite::{Ink, pixel};
use super::stamp::{Stamp, origin_of, place};
use super::stroke::Stroke;
use gks_algorithms::coverage::SampleMask;
use gks_pipeline::device::{StrokeCharacter, StrokeText};
use gks_pipeline::font::StrokeGlyph;
use glam::{DVec2, IVec2};
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// How far the strokes of a character reach from its origin at most, in pixels; larger ones are drawn as lines.
const LARGEST: f64 = 64.0;
/// Places of the origin of a character along one side of a pixel.
const PLACES: i32 = 4;
/// The most pairs of pixels that are kept.
const MOST_PAIRS: usize = 1 << 20;
/// The most sets of stamps that are kept.
const MOST_SETS: usize = 16;
/// In the place of the number of a stamp that is not made yet.
const NO_STAMP: u32 = u32::MAX;

/// Draws characters of stroke fonts; owns the stamps of those drawn before.
pub(super) struct Letters {
    mask: SampleMask,
    stroke: Stroke,
    sets: Vec<Set>,
    /// How many pairs of pixels the stamps have.
    size: usize,
    /// The numbers of the stamps of a text, and the pixels of their origins.
    placed: Vec<(u32, IVec2)>,
}

/// The stamps of characters of one size, direction and width of strokes.
struct Set {
    axes: [DVec2; 2],
    width: f64,
    /// The numbers of the glyphs by their addresses, which do not change.
    glyphs: HashMap<usize, u32, BuildHasherDefault<Spread>>,
    /// The numbers of the stamps for each place of each glyph.
    numbers: Vec<[u32; (PLACES * PLACES) as usize]>,
    stamps: Vec<Stamp>,
}

/// A hash of addresses.
#[derive(Default)]
struct Spread(u64);

impl Hasher for Spread {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_usize(byte.into()));
    }

    fn write_usize(&mut self, number: usize) {
        self.0 = (self.0 ^ number as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(26);
    }
}

impl Letters {
    pub(super) fn new() -> Self {
        Letters {
            mask: SampleMask::new(),
            stroke: Stroke::new(),
            sets: Vec::new(),
            size: 0,
            placed: Vec::new(),
        }
    }

    /// Whether a text is stamped. One that is translucent is not: where its characters overlap, they are seen once.
    pub(super) fn can(text: &StrokeText<'_>) -> bool {
        let ink = pixel(text.pen.paint.colour);
        let reach = Reach::of(text);
        ink[3] == 255
            && text.pen.dash.is_empty()
            && text.characters.iter().all(|character| reach.farthest(character.glyph) < LARGEST)
    }

    /// Draws the characters of a text.
    pub(super) fn draw(&mut self, bitmap: &mut Bitmap, text: &StrokeText<'_>) {
        let ink = Ink::new(pixel(text.pen.paint.colour), 255);
        let index = self.set(text);
        let width = bitmap.size().0 as i32;
        self.placed.clear();
        for &StrokeCharacter { glyph, origin } in text.characters {
            if let Some((at, place)) = place::<PLACES>(origin.0) {
                let number = self.stamp(index, glyph, place, text, width);
                self.placed.push((number, at));
            }
        }
        let stamps = &self.sets[index].stamps;
        for (i, &(number, at)) in self.placed.iter().enumerate() {
            if let Some(&(next, at)) = self.placed.get(i + 1) {
                stamps[next as usize].fetch(bitmap, at);
            }
            stamps[number as usize].put(bitmap, at, &ink);
        }
    }

    /// The set of stamps for a text.
    fn set(&mut self, text: &StrokeText<'_>) -> usize {
        let width = text.pen.width.max(1.0);
        let axes = [text.x.0, text.y.0];
        if self.size > MOST_PAIRS {
            self.sets.clear();
            self.size = 0;
        }
        let index = self.sets.iter().position(|set| set.axes == axes && set.width == width);
        index.unwrap_or_else(|| {
            if self.sets.len() == MOST_SETS {
                let oldest = self.sets.remove(0);
                self.size -= oldest.stamps.iter().map(Stamp::size).sum::<usize>();
            }
            let (glyphs, numbers, stamps) = (HashMap::default(), Vec::new(), Vec::new());
            self.sets.push(Set { axes, width, glyphs, numbers, stamps });
            self.sets.len() - 1
        })
    }

    /// The number of the stamp of a glyph, which is made if it is not there.
    #[inline]
    fn stamp(
        &mut self,
        index: usize,
        glyph: &'static StrokeGlyph,
        place: usize,
        text: &StrokeText<'_>,
        columns: i32,
    ) -> u32 {
        let Set { axes, width, glyphs, numbers, stamps } = &mut self.sets[index];
        let next = numbers.len() as u32;
        let of_glyph = *glyphs.entry(std::ptr::from_ref(glyph).addr()).or_insert(next);
        if of_glyph == next {
            numbers.push([NO_STAMP; (PLACES * PLACES) as usize]);
        }
        let number = &mut numbers[of_glyph as usize][place];
        if *number == NO_STAMP {
            *number = stamps.len() as u32;
            let Letters { mask, stroke, size, .. } = self;
            stroke.begin(*width, text.pen.cap, text.pen.join);
            let reach = Reach::of(text).farthest(glyph);
            let stamp =
                Stamp::new(origin_of::<PLACES>(place), columns, mask, reach, |origin, mut polygon| {
                    for path in glyph.strokes() {
                        path.iter()
                            .for_each(|p| stroke.to(origin + axes[0] * p.x + axes[1] * p.y, &mut polygon));
                        stroke.end(&mut polygon);
                    }
                });
            *size += stamp.size();
            stamps.push(stamp);
        }
        *number
    }
}

/// How far characters reach from their origin at most, for each of their own units.
struct Reach {
    x: f64,
    y: f64,
    width: f64,
}

impl Reach {
    fn of(text: &StrokeText<'_>) -> Self {
        Reach { x: text.x.length(), y: text.y.length(), width: text.pen.width.max(1.0) }
    }

    fn farthest(&self, glyph: &StrokeGlyph) -> f64 {
        let [low, high] = glyph.bounds;
        let far = low.abs().max(high.abs());
        far.x * self.x + far.y * self.y + self.width
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::lines::Lines;
    use gks_geometry::{PathBuf, Point, Vector};
    use gks_pipeline::colour::{Colour, Paint};
    use gks_pipeline::device::Pen;
    use gks_pipeline::font::{Face, face};
    use gks_pipeline::look::{Cap, Join};

    const PEN: Pen<'static> = Pen {
        paint: Paint { colour: Colour::BLACK, index: 1 },
        width: 1.0,
        dash: &[],
        cap: Cap::Round,
        join: Join::Round,
    };

    fn characters(text: &str, at: DVec2) -> Vec<StrokeCharacter> {
        let Some(Face::Stroke(face)) = face(-4) else { panic!("font -4 is strokes") };
        let glyphs = text.chars().map(|c| face.glyph(c).unwrap());
        let advance = |i: usize| Point::from_vec(at + DVec2::new(20.25 * i as f64, 0.0));
        glyphs.enumerate().map(|(i, glyph)| StrokeCharacter { glyph, origin: advance(i) }).collect()
    }

    fn text(characters: &[StrokeCharacter], height: f64) -> StrokeText<'_> {
        StrokeText { characters, x: Vector::new(height, 1.5), y: Vector::new(0.5, -height), pen: PEN }
    }

    fn white() -> Bitmap {
        let mut bitmap = Bitmap::new(80, 50);
        bitmap.fill([255; 4]);
        bitmap
    }

    #[test]
    fn stamped_characters_look_like_their_lines_also_where_they_are_cut() {
        let mut letters = Letters::new();
        for at in [(5.0, 30.5), (5.0, 30.5), (9.25, 24.75), (-8.0, 12.5), (41.5, 55.0), (900.0, 30.0)] {
            let characters = characters("Rag &", at.into());
            let text = text(&characters, 18.0);
            assert!(Letters::can(&text));
            let (mut stamped, mut lined, mut strokes) = (white(), white(), PathBuf::new());
            letters.draw(&mut stamped, &text);
            text.add_to(&mut strokes);
            Lines::new().draw(&mut lined, &strokes.as_paths(), &PEN);
            assert!(stamped.pixels() == lined.pixels(), "{at:?}");
        }
    }

    #[test]
    fn large_and_translucent_characters_are_not_stamped() {
        let characters = characters("x", DVec2::splat(20.0));
        assert!(!Letters::can(&text(&characters, 200.0)));
        let mut faint = text(&characters, 18.0);
        faint.pen.paint.colour.alpha = 0.5;
        assert!(!Letters::can(&faint));
    }

    #[test]
    fn stamps_of_sizes_long_not_used_are_given_up() {
        let characters = characters("abcdefgh", DVec2::splat(20.0));
        let (mut letters, mut bitmap) = (Letters::new(), white());
        for i in 0..100 {
            letters.draw(&mut bitmap, &text(&characters, 10.0 + f64::from(i) * 0.1));
            let sizes = letters.sets.iter().flat_map(|set| &set.stamps).map(Stamp::size);
            assert_eq!(letters.size, sizes.sum::<usize>());
            assert!(letters.sets.len() <= MOST_SETS);
        }
    }
}
