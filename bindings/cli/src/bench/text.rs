//! Strings of about twenty characters, in a stroke font or in an outline font.

use super::random::Random;
use super::reference::lines;
use super::scene::{Data, Figures, Scene, StrokePen};
use gks::Gks;
use gks_pipeline::look::Precision;

/// Letters, digits and blanks, 20 pixels high.
pub struct Strings {
    strings: Vec<((f64, f64), String)>,
    font: i32,
}

const LETTERS: &[u8; 63] = b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 ";

impl Strings {
    fn of(font: i32, count: usize) -> Box<dyn Scene> {
        let mut random = Random::new(8);
        let mut strings = Vec::with_capacity(count);
        for _ in 0..count {
            let at = (random.unit() * 0.9, random.unit() * 0.97);
            let length = 18 + random.below(5);
            let text = (0..length).map(|_| char::from(random.of(LETTERS))).collect();
            strings.push((at, text));
        }
        Box::new(Strings { strings, font })
    }

    /// W5: strokes.
    pub fn strokes(count: usize) -> Box<dyn Scene> {
        Strings::of(1, count)
    }

    /// Outlines.
    pub fn outlines(count: usize) -> Box<dyn Scene> {
        Strings::of(-21, count)
    }
}

impl Scene for Strings {
    fn draw(&self, gks: &mut Gks) -> gks::Result<()> {
        gks.set_text_font_and_precision(self.font, Precision::Stroke)?;
        gks.set_character_height(0.02)?;
        self.strings.iter().try_for_each(|(at, text)| gks.text(*at, text))
    }

    fn data(&self) -> Data<'_> {
        Data::Strings(&self.strings)
    }

    /// Strokes exactly the lines that the characters consist of, which are found before the clock runs.
    fn figures(&self) -> Option<Figures<'_>> {
        if self.font < 0 {
            return None;
        }
        let lines = lines(|gks| self.draw(gks)).ok()?;
        let pen = StrokePen::THIN;
        Some(Box::new(move |canvas| lines.iter().for_each(|line| canvas.stroke(line, &pen))))
    }
}
