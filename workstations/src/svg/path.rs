//! Path data: the value of the attribute `d`, with relative coordinates.

use super::FINE;
use super::document::Document;
use crate::number::{Decimal, Word};
use glam::DVec2;
use std::io;

/// After as many relative steps comes an absolute one: viewers add up the steps in single precision.
const STRIDE: u32 = 256;

/// Writes path data point by point.
///
/// Every point is rounded once; the difference written is the one between rounded points, so that a long
/// path ends where it should.
pub(super) struct PathData<'d> {
    pub(super) document: &'d mut Document,
    decimal: Decimal,
    /// How many steps make a unit.
    one: i64,
    /// The current point in steps of the decimal.
    at: [i64; 2],
    /// Where the current subpath started.
    start: [i64; 2],
    /// The command that the next arguments belong to if no other one is written.
    command: u8,
    before: Before,
    relative: u32,
}

/// What the path data written so far end with.
#[derive(Copy, Clone)]
enum Before {
    Command,
    Integer,
    Fraction,
}

impl Before {
    #[inline]
    fn number(fraction: bool) -> Before {
        if fraction { Before::Fraction } else { Before::Integer }
    }

    /// Whether a number given in steps, of which `one` make a unit, can follow without a space.
    #[inline]
    fn is_separate(self, steps: i64, one: i64) -> bool {
        match self {
            Before::Command => true,
            Before::Integer => steps < 0,
            Before::Fraction => (steps < 0) | ((steps > 0) & (steps < one)),
        }
    }
}

impl<'d> PathData<'d> {
    /// Starts path data with numbers written as `decimal` says.
    pub(super) fn new(document: &'d mut Document, decimal: Decimal) -> Self {
        PathData {
            document,
            decimal: decimal.bare(),
            one: decimal.count(),
            at: [0; 2],
            start: [0; 2],
            command: 0,
            before: Before::Command,
            relative: 0,
        }
    }

    /// A point in the integers that become text.
    #[inline]
    fn rounded(&self, point: DVec2) -> [i64; 2] {
        [self.decimal.steps(point.x), self.decimal.steps(point.y)]
    }

    /// The letter of a command, if it must be written.
    #[inline]
    fn letter(&mut self, command: u8) -> Option<u8> {
        if self.command == command {
            return None;
        }
        self.before = Before::Command;
        self.command = command;
        Some(command)
    }

    /// [`PathData::letter`] as the begin of a word.
    #[inline]
    fn command(&mut self, command: u8) -> Word {
        self.letter(command).map_or(Word::EMPTY, |letter| Word::EMPTY.then(letter))
    }

    /// Writes a number after `word`, separated from the number before only where it must be: not before a sign,
    /// and not before a point if the number before has one already.
    #[inline]
    fn argument(&mut self, word: Word, steps: i64) {
        self.argument_as(word, self.decimal, steps);
    }

    /// The letter of a command, if there is one, and two numbers, as one word where they are short.
    #[inline]
    fn pair(&mut self, letter: Option<u8>, x: i64, y: i64) {
        let limit = if matches!(self.one, 1 | 100) { 1000 * self.one } else { 0 };
        if x.abs() < limit && y.abs() < limit {
            let space = |before: Before, steps: i64| (!before.is_separate(steps, self.one)).then_some(b' ');
            let one = Word::short(self.decimal, letter.or_else(|| space(self.before, x)), x);
            let two = Word::short(self.decimal, space(Before::number(one.has_fraction()), y), y);
            one.followed_by(two).write(&mut self.document.out);
            self.before = Before::number(two.has_fraction());
            return;
        }
        let word = letter.map_or(Word::EMPTY, |letter| Word::EMPTY.then(letter));
        self.argument(word, x);
        self.argument(Word::EMPTY, y);
    }

    /// With a space if a number needs one before it.
    #[inline]
    fn separated(&self, word: Word, one: i64, steps: i64) -> Word {
        word.then_if(!self.before.is_separate(steps, one), b' ')
    }

    #[inline]
    fn argument_as(&mut self, word: Word, decimal: Decimal, steps: i64) {
        let word = self.separated(word, decimal.count(), steps);
        let out = &mut self.document.out;
        let fraction = match word.number(decimal, steps) {
            Some(word) => {
                word.write(out);
                word.has_fraction()
            }
            None => {
                word.write(out);
                decimal.write_steps(out, steps);
                steps % decimal.count() != 0
            }
        };
        self.before = Before::number(fraction);
    }

    /// Writes the displacement from the current point to a point, and goes there in relative coordinates.
    #[inline]
    fn displacement(&mut self, letter: Option<u8>, to: [i64; 2]) {
        self.pair(letter, to[0] - self.at[0], to[1] - self.at[1]);
    }

    /// Whether the next step is to be an absolute one.
    #[inline]
    fn anchors(&mut self) -> bool {
        self.relative += 1;
        if self.relative < STRIDE {
            return false;
        }
        self.relative = 0;
        true
    }

    /// Starts a subpath.
    pub(super) fn move_to(&mut self, point: DVec2) -> io::Result<()> {
        self.start(self.rounded(point))
    }

    /// Starts a subpath at a point given in steps.
    pub(super) fn start(&mut self, to: [i64; 2]) -> io::Result<()> {
        self.document.spill()?;
        // The letter is always written: lines would follow without one.
        self.command = 0;
        if self.anchors() {
            let word = self.command(b'M');
            self.argument(word, to[0]);
            self.argument(Word::EMPTY, to[1]);
            self.command = b'L';
        } else {
            let letter = self.letter(b'm');
            self.displacement(letter, to);
            self.command = b'l';
        }
        self.at = to;
        self.start = to;
        Ok(())
    }

    /// A line to a point; nothing if it is the current point after rounding. Answers whether there is a line.
    pub(super) fn line_to(&mut self, point: DVec2) -> io::Result<bool> {
        let to = self.rounded(point);
        let moves = to != self.at;
        if moves {
            self.line(to)?;
        }
        Ok(moves)
    }

    /// A line to a point given in steps.
    #[inline]
    pub(super) fn line(&mut self, to: [i64; 2]) -> io::Result<()> {
        self.document.spill()?;
        let [dx, dy] = [to[0] - self.at[0], to[1] - self.at[1]];
        if self.anchors() {
            let word = self.command(b'L');
            self.argument(word, to[0]);
            self.argument(Word::EMPTY, to[1]);
        } else if dy == 0 {
            let word = self.command(b'h');
            self.argument(word, dx);
        } else if dx == 0 {
            let word = self.command(b'v');
            self.argument(word, dy);
        } else {
            let letter = self.letter(b'l');
            self.pair(letter, dx, dy);
        }
        self.at = to;
        Ok(())
    }

    /// A line of no length, which shows as the ends of lines show.
    pub(super) fn stay(&mut self) {
        let word = self.command(b'h');
        self.argument(word, 0);
    }

    /// A cubic Bezier curve.
    pub(super) fn curve_to(&mut self, control: [DVec2; 2], end: DVec2) -> io::Result<()> {
        self.document.spill()?;
        let to = self.rounded(end);
        let absolute = self.anchors();
        let mut word = self.command(if absolute { b'C' } else { b'c' });
        let origin = if absolute { [0; 2] } else { self.at };
        for point in [self.rounded(control[0]), self.rounded(control[1]), to] {
            self.argument(word, point[0] - origin[0]);
            self.argument(Word::EMPTY, point[1] - origin[1]);
            word = Word::EMPTY;
        }
        self.at = to;
        Ok(())
    }

    /// An elliptic arc of less than half a turn: `radii`, `turn` of the axes in degrees, and whether the arc
    /// goes from the x axis to the y axis.
    pub(super) fn arc_to(&mut self, radii: [f64; 2], turn: f64, onwards: bool, end: DVec2) -> io::Result<()> {
        self.document.spill()?;
        let to = self.rounded(end);
        let word = self.command(b'a');
        self.argument(word, self.decimal.steps(radii[0]));
        self.argument(Word::EMPTY, self.decimal.steps(radii[1]));
        self.argument_as(Word::EMPTY, FINE, FINE.steps(turn));
        self.argument(Word::EMPTY, 0);
        self.argument(Word::EMPTY, if onwards { self.one } else { 0 });
        self.displacement(None, to);
        self.at = to;
        Ok(())
    }

    /// Closes the subpath.
    pub(super) fn close(&mut self) {
        self.document.out.push(b'z');
        self.command = 0;
        self.before = Before::Command;
        self.at = self.start;
    }
}
