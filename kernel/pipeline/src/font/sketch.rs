//! A drawing of strokes under construction: what the stroke faces compose their glyphs of.

use glam::DVec2;

use super::outline::Verb;

/// A list of pen strokes in character heights with a body width, origin at the left edge on the base line, y up.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sketch {
    advance: f64,
    points: Vec<DVec2>,
    ends: Vec<u32>,
}

impl Sketch {
    /// A blank body of a width.
    pub(crate) fn new(advance: f64) -> Self {
        Self { advance, ..Self::default() }
    }

    /// Draws to a point, or moves to it after the pen was lifted.
    pub(crate) fn point(&mut self, point: DVec2) {
        self.points.push(point);
    }

    /// Ends a stroke; does nothing when no point was drawn since the last one.
    pub(crate) fn lift(&mut self) {
        let end = self.points.len() as u32;
        if end > self.ends.last().copied().unwrap_or(0) {
            self.ends.push(end);
        }
    }

    /// Adds whole strokes given in units of which `unit` make a character height, moved by `shift` heights.
    pub(crate) fn draw(&mut self, strokes: &[&[(i8, i8)]], unit: f64, shift: DVec2) {
        for stroke in strokes {
            for &(x, y) in *stroke {
                self.point(DVec2::new(f64::from(x), f64::from(y)) / unit + shift);
            }
            self.lift();
        }
    }

    /// Adds the strokes of another sketch, its points mapped; the body width stays.
    pub(crate) fn add(&mut self, other: &Self, map: impl Fn(DVec2) -> DVec2) {
        for stroke in other.strokes() {
            self.points.extend(stroke.iter().map(|&point| map(point)));
            self.lift();
        }
    }

    /// The same strokes mapped, with another body width.
    pub(crate) fn mapped(&self, advance: f64, map: impl Fn(DVec2) -> DVec2) -> Self {
        let mut sketch = Self::new(advance);
        sketch.add(self, map);
        sketch
    }

    /// The sketch without the strokes that fail a test.
    pub(crate) fn retaining(&self, keep: impl Fn(&[DVec2]) -> bool) -> Self {
        let mut sketch = Self::new(self.advance);
        for stroke in self.strokes().filter(|stroke| keep(stroke)) {
            sketch.points.extend_from_slice(stroke);
            sketch.lift();
        }
        sketch
    }

    /// Traces one step of an outline, curves as pieces of straight line; `em` is the em in character heights.
    pub(crate) fn trace(&mut self, verb: &Verb, em: f64) {
        const PIECES: u32 = 6;
        let start = self.points.last().copied().unwrap_or_default();
        let piece = |step: u32| f64::from(step) / f64::from(PIECES);
        match *verb {
            Verb::Move(to) => {
                self.lift();
                self.point(to * em);
            }
            Verb::Line(to) => self.point(to * em),
            Verb::Quad(control, to) => {
                for t in (1..=PIECES).map(piece) {
                    let (first, second) = (start.lerp(control * em, t), (control * em).lerp(to * em, t));
                    self.point(first.lerp(second, t));
                }
            }
            Verb::Cubic(a, b, to) => {
                let (a, b, to) = (a * em, b * em, to * em);
                for t in (1..=PIECES).map(piece) {
                    let (ab, bc, cd) = (start.lerp(a, t), a.lerp(b, t), b.lerp(to, t));
                    self.point(ab.lerp(bc, t).lerp(bc.lerp(cd, t), t));
                }
            }
            Verb::Close => {
                let contour = self.ends.last().map_or(0, |&end| end as usize);
                if let Some(&first) = self.points.get(contour) {
                    self.point(first);
                }
                self.lift();
            }
        }
    }

    /// Sets the body width in character heights.
    pub(crate) fn set_advance(&mut self, advance: f64) {
        self.advance = advance;
    }

    /// The body width in character heights.
    pub(crate) fn advance(&self) -> f64 {
        self.advance
    }

    /// Lower left and upper right corner of the strokes; both zero for a blank.
    pub(crate) fn bounds(&self) -> [DVec2; 2] {
        let Some(&first) = self.points.first() else {
            return [DVec2::ZERO; 2];
        };
        self.points.iter().fold([first, first], |[low, high], &point| [low.min(point), high.max(point)])
    }

    /// The strokes one by one.
    pub(crate) fn strokes(&self) -> impl Iterator<Item = &[DVec2]> {
        let mut start = 0;
        self.ends.iter().map(move |&end| {
            let stroke = &self.points[start..end as usize];
            start = end as usize;
            stroke
        })
    }

    /// Index one past the last point of every stroke.
    #[cfg(test)]
    pub(crate) fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// Gives up the points and ends.
    pub(crate) fn into_parts(self) -> (Vec<DVec2>, Vec<u32>) {
        (self.points, self.ends)
    }
}
