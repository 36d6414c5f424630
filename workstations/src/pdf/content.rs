//! Page descriptions: the operators that PDF and PostScript have in common.
//!
//! PDF's operators are those of PostScript under short names. The prolog of our PostScript gives them the
//! same names, so that one writer serves both. What differs is small: in PostScript positions are whole
//! numbers of hundredths of a point, lines are relative, there is one colour for lines and areas, and no
//! opacity.

use super::state::{State, Use};
use crate::arc;
use crate::number::{Decimal, Word};
use crate::route::{Route, Track};
use gks_geometry::{Du, Paths, Pieces, Rect};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::{DeviceError, Pen, Rule};
use gks_pipeline::item::{Closure, Curve, Ellipse, Parallelogram};
use gks_pipeline::look::Cap;
use glam::DVec2;
use std::collections::BTreeSet;

/// Positions are counted in hundredths of a point, whatever the language.
pub(crate) const STEPS: Decimal = Decimal::new(2);

/// Widths and lengths of dashes are counted in thousandths of a point.
pub(super) const LENGTHS: Decimal = Decimal::new(3);

/// The directions of a coordinate system are counted in ten-thousandths of a point, since they are multiplied.
const DIRECTIONS: Decimal = Decimal::new(4);

/// How far the Bezier curves of an ellipse may lie off, in points.
const ARC_TOLERANCE: f64 = 0.005;

/// The most lines that one operator of our PostScript draws; interpreters hold 500 operands at least.
const RUN: usize = 128;

/// How many displacements stand on a line of PostScript, which should have no more than 255 characters.
const ROW: usize = 8;

/// The language of a page description.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Language {
    /// PDF: points, two colours, opacity.
    Pdf,
    /// PostScript under our prolog: hundredths of a point, one colour.
    PostScript,
}

/// Where a page description goes when enough of it has been collected.
pub(crate) trait Drain {
    /// Takes over `text` and leaves it empty.
    fn drain(&mut self, text: &mut Vec<u8>) -> Result<(), DeviceError>;
}

/// The description of one page while it is being written.
pub(crate) struct Content {
    pub(super) language: Language,
    /// How positions, lengths and directions are written; their counts do not depend on the language.
    pub(super) formats: [Decimal; 3],
    pub(super) text: Vec<u8>,
    /// Displacements of lines that wait to be written together.
    run: Vec<[i64; 2]>,
    limit: usize,
    pub(super) state: State,
    /// The state outside of the clipping rectangle, which comes back with it.
    pub(super) outside: State,
    pub(super) clip: Option<[i64; 4]>,
    /// The ellipse that clips, and the state outside of it.
    pub(super) region: Option<Ellipse<Du>>,
    pub(super) around: State,
    pub(super) opacities: BTreeSet<u8>,
}

impl Content {
    /// An empty description that is drained whenever it is longer than `limit` bytes.
    pub(crate) fn new(language: Language, limit: usize) -> Self {
        let formats = match language {
            Language::Pdf => [STEPS.bare(), LENGTHS.bare(), DIRECTIONS.bare()],
            Language::PostScript => [Decimal::new(0), Decimal::new(1), Decimal::new(2)],
        };
        Content {
            language,
            formats,
            text: Vec::new(),
            run: Vec::new(),
            limit,
            state: State::new(),
            outside: State::new(),
            clip: None,
            region: None,
            around: State::new(),
            opacities: BTreeSet::new(),
        }
    }

    /// Starts a page.
    pub(crate) fn begin(&mut self) {
        self.text.clear();
        self.state = State::new();
        self.clip = None;
        self.region = None;
        self.opacities.clear();
    }

    /// Leaves what clips and hands over what remains of the page.
    pub(crate) fn end(&mut self, drain: &mut impl Drain) -> Result<(), DeviceError> {
        self.region(None, drain)?;
        self.clip(None);
        self.flush(drain)
    }

    /// Hands over what there is.
    pub(crate) fn flush(&mut self, drain: &mut impl Drain) -> Result<(), DeviceError> {
        if self.text.is_empty() { Ok(()) } else { drain.drain(&mut self.text) }
    }

    /// Hands over what there is if it is enough.
    #[inline]
    pub(crate) fn relieve(&mut self, drain: &mut impl Drain) -> Result<(), DeviceError> {
        if self.text.len() < self.limit { Ok(()) } else { drain.drain(&mut self.text) }
    }

    /// The text of the description, to which operators of one language are added.
    pub(crate) fn text(&mut self) -> &mut Vec<u8> {
        &mut self.text
    }

    /// Fills a rectangle.
    pub(crate) fn fill_rectangle(&mut self, rect: &Rect<Du>, colour: Colour) {
        self.colour(Use::Areas, colour);
        self.rectangle(rect.limits().map(|limit| STEPS.steps(limit)));
        self.text.extend_from_slice(b"f\n");
    }

    /// Draws lines along paths.
    pub(crate) fn lines(
        &mut self,
        paths: &impl Pieces,
        pen: &Pen<'_>,
        route: &mut Route,
        drain: &mut impl Drain,
    ) -> Result<(), DeviceError> {
        let mut strokes = Strokes { content: self, drain, pen: Some(pen), begun: false };
        route.lines(paths, &mut strokes)?;
        if strokes.begun {
            self.text.extend_from_slice(b"S\n");
        }
        if !route.dots.is_empty() {
            self.pen(&Pen { dash: &[], cap: Cap::Round, ..*pen });
            for dot in &route.dots {
                self.dot(*dot);
                self.relieve(drain)?;
            }
            self.text.extend_from_slice(b"S\n");
        }
        Ok(())
    }

    /// Fills the area inside of rings with one colour; filling closes them.
    pub(crate) fn area(
        &mut self,
        rings: Paths<'_, Du>,
        rule: Rule,
        colour: Colour,
        route: &mut Route,
        drain: &mut impl Drain,
    ) -> Result<(), DeviceError> {
        self.colour(Use::Areas, colour);
        let mut strokes = Strokes { content: self, drain, pen: None, begun: false };
        route.rings(rings.iter(), &mut strokes)?;
        if strokes.begun {
            self.fill(rule);
        }
        Ok(())
    }

    /// Draws a curve with a pen.
    pub(crate) fn stroke(
        &mut self,
        curve: &Curve<'_, Du>,
        pen: &Pen<'_>,
        drain: &mut impl Drain,
    ) -> Result<(), DeviceError> {
        self.pen(pen);
        let drawn = self.curve(curve, drain)?;
        if drawn {
            self.text.extend_from_slice(b"S\n");
        } else if let Some(at) = first(curve) {
            self.pen(&Pen { dash: &[], cap: Cap::Round, ..*pen });
            self.dot(steps(at));
            self.text.extend_from_slice(b"S\n");
        }
        Ok(())
    }

    /// Fills the area that a curve encloses, by the even-odd rule as all areas of the standard.
    pub(crate) fn filled(
        &mut self,
        curve: &Curve<'_, Du>,
        colour: Colour,
        drain: &mut impl Drain,
    ) -> Result<(), DeviceError> {
        self.colour(Use::Areas, colour);
        if self.curve(curve, drain)? {
            self.fill(Rule::EvenOdd);
        }
        Ok(())
    }

    /// Writes the coordinate system in which a parallelogram is the unit square, first row on top; nothing
    /// where it is flat.
    pub(crate) fn unit_square(&mut self, place: &Parallelogram<Du>) -> bool {
        self.system(place.columns.0, -place.rows.0, (place.origin + place.rows).0)
    }

    /// Writes the six numbers of a coordinate system followed by a blank; nothing where it is flat.
    pub(crate) fn system(&mut self, x: DVec2, y: DVec2, origin: DVec2) -> bool {
        let linear = [x.x, x.y, y.x, y.y].map(|component| DIRECTIONS.steps(component));
        let [a, b, c, d] = linear.map(i128::from);
        if a * d == b * c {
            return false;
        }
        for component in linear {
            self.number(2, component);
        }
        self.position(steps(origin));
        true
    }

    fn fill(&mut self, rule: Rule) {
        self.text.extend_from_slice(match rule {
            Rule::NonZero => b"f\n",
            Rule::EvenOdd => b"f*\n",
        });
    }

    pub(super) fn rectangle(&mut self, [left, right, bottom, top]: [i64; 4]) {
        self.position([left, bottom]);
        self.position([right - left, top - bottom]);
        self.text.extend_from_slice(b"re\n");
    }

    fn dot(&mut self, at: [i64; 2]) {
        self.point(at, b'm');
        self.line(at, at);
    }

    /// Appends a curve, or nothing where it shrinks to a point; whether there is one.
    pub(super) fn curve(
        &mut self,
        curve: &Curve<'_, Du>,
        drain: &mut impl Drain,
    ) -> Result<bool, DeviceError> {
        let Some(start) = first(curve) else { return Ok(false) };
        match curve {
            Curve::Bezier(points) => {
                let pieces = points[1..].chunks_exact(3).map(|p| [p[0], p[1], p[2]]);
                Ok(self.cubics(start, pieces, drain)?.is_some())
            }
            Curve::Ellipse(ellipse) => {
                let pieces = arc::cubics(ellipse, ARC_TOLERANCE);
                let Some(end) = self.cubics(start, pieces, drain)? else { return Ok(false) };
                if ellipse.closure == Closure::Pie {
                    self.line(end, steps(ellipse.centre.0));
                }
                if ellipse.closure != Closure::Open {
                    self.text.extend_from_slice(b"h\n");
                }
                Ok(true)
            }
        }
    }

    /// Appends cubics, or nothing where all of them are points; where they end.
    fn cubics(
        &mut self,
        start: DVec2,
        pieces: impl Iterator<Item = [DVec2; 3]>,
        drain: &mut impl Drain,
    ) -> Result<Option<[i64; 2]>, DeviceError> {
        let start = steps(start);
        let mut last = start;
        let mut drawn = false;
        for piece in pieces {
            let [a, b, c] = piece.map(steps);
            if a == last && b == last && c == last {
                continue;
            }
            if !drawn {
                self.point(start, b'm');
                drawn = true;
            }
            for point in [a, b, c] {
                self.position(point);
            }
            self.text.extend_from_slice(b"c\n");
            last = c;
            self.relieve(drain)?;
        }
        Ok(drawn.then_some(last))
    }

    #[inline]
    fn line(&mut self, from: [i64; 2], to: [i64; 2]) {
        match self.language {
            Language::Pdf => self.point(to, b'l'),
            Language::PostScript => self.point([to[0] - from[0], to[1] - from[1]], b'r'),
        }
    }

    /// A line as one of many: in PostScript it waits for those that follow.
    #[inline]
    fn next_line(&mut self, from: [i64; 2], to: [i64; 2]) {
        if self.language == Language::Pdf {
            return self.point(to, b'l');
        }
        self.run.push([to[0] - from[0], to[1] - from[1]]);
        if self.run.len() == RUN {
            self.end_run();
        }
    }

    /// Writes the lines that wait: the displacements from the last one to the first, so that the first one is on top of
    /// the stack, and their number.
    fn end_run(&mut self) {
        let run = std::mem::take(&mut self.run);
        match run[..] {
            [] => {}
            [only] => self.point(only, b'r'),
            _ => {
                for (i, &[x, y]) in run.iter().enumerate().rev() {
                    self.number(0, x);
                    self.ended(0, y, if i % ROW == 0 { b"\n" } else { b" " });
                }
                Decimal::new(0).write(&mut self.text, run.len() as f64);
                self.text.extend_from_slice(b" L\n");
            }
        }
        self.run = run;
        self.run.clear();
    }

    #[inline]
    fn position(&mut self, [x, y]: [i64; 2]) {
        self.number(0, x);
        self.number(0, y);
    }

    /// Writes a position and an operator of one letter.
    #[inline]
    fn point(&mut self, [x, y]: [i64; 2], operator: u8) {
        self.number(0, x);
        self.ended(0, y, &[b' ', operator, b'\n']);
    }

    #[inline]
    pub(super) fn number(&mut self, format: usize, count: i64) {
        self.ended(format, count, b" ");
    }

    /// Writes a number and a few characters.
    #[inline]
    fn ended<const N: usize>(&mut self, format: usize, count: i64, end: &[u8; N]) {
        match Word::EMPTY.number(self.formats[format], count) {
            Some(word) => {
                end.iter().fold(word, |word, &character| word.then(character)).write(&mut self.text);
            }
            None => {
                self.formats[format].write_steps(&mut self.text, count);
                self.text.extend_from_slice(end);
            }
        }
    }
}

/// Paths that are stroked or, without a pen, filled.
struct Strokes<'c, 'p, D> {
    content: &'c mut Content,
    drain: &'c mut D,
    pen: Option<&'c Pen<'p>>,
    begun: bool,
}

impl<D: Drain> Track for Strokes<'_, '_, D> {
    fn start(&mut self, at: [i64; 2]) -> Result<(), DeviceError> {
        if !self.begun {
            self.begun = true;
            if let Some(pen) = self.pen {
                self.content.pen(pen);
            }
        }
        self.content.point(at, b'm');
        Ok(())
    }

    #[inline]
    fn line(&mut self, from: [i64; 2], to: [i64; 2]) -> Result<(), DeviceError> {
        self.content.next_line(from, to);
        self.content.relieve(self.drain)
    }

    /// Filling closes paths by itself.
    fn finish(&mut self, closed: bool) -> Result<(), DeviceError> {
        self.content.end_run();
        if closed && self.pen.is_some() {
            self.content.text.extend_from_slice(b"h\n");
        }
        Ok(())
    }
}

/// The position in hundredths of a point.
#[inline]
fn steps(point: DVec2) -> [i64; 2] {
    [STEPS.steps(point.x), STEPS.steps(point.y)]
}

fn first(curve: &Curve<'_, Du>) -> Option<DVec2> {
    match curve {
        Curve::Bezier(points) => points.first().copied(),
        Curve::Ellipse(ellipse) => Some(ellipse.at(ellipse.start).0),
    }
}

#[cfg(test)]
mod tests;
