//! Path data: the value of the attribute `d`, with relative coordinates.

use super::FINE;
use super::document::Document;
use crate::number::Decimal;
use glam::DVec2;
use std::io;

/// After as many relative steps comes an absolute one: viewers add up the steps in single precision.
const STRIDE: u32 = 256;

/// Writes path data point by point.
///
/// Every point is rounded once; the difference written is the one between rounded points, so that a long
/// path ends where it should.
pub(super) struct PathData<'d> {
    document: &'d mut Document,
    decimal: Decimal,
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

impl<'d> PathData<'d> {
    /// Starts path data with numbers written as `decimal` says.
    pub(super) fn new(document: &'d mut Document, decimal: Decimal) -> Self {
        PathData {
            document,
            decimal: decimal.bare(),
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

    #[inline]
    fn command(&mut self, command: u8) {
        if self.command != command {
            self.document.out.push(command);
            self.before = Before::Command;
            self.command = command;
        }
    }

    /// Writes a number, separated from the one before only where it must be: not before a sign, and not
    /// before a point if the number before has one already.
    #[inline]
    fn argument(&mut self, steps: i64) {
        self.argument_as(self.decimal, steps);
    }

    #[inline]
    fn argument_as(&mut self, decimal: Decimal, steps: i64) {
        let scale = decimal.scale() as i64;
        let starts_with_point = steps > 0 && steps < scale;
        let separated = match self.before {
            Before::Command => true,
            Before::Integer => steps < 0,
            Before::Fraction => steps < 0 || starts_with_point,
        };
        if !separated {
            self.document.out.push(b' ');
        }
        decimal.write_steps(&mut self.document.out, steps);
        self.before = if steps % scale == 0 { Before::Integer } else { Before::Fraction };
    }

    /// Writes the displacement from the current point to a point, and goes there in relative coordinates.
    #[inline]
    fn displacement(&mut self, to: [i64; 2]) {
        self.argument(to[0] - self.at[0]);
        self.argument(to[1] - self.at[1]);
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
        self.document.spill()?;
        let to = self.rounded(point);
        // The letter is always written: lines would follow without one.
        self.command = 0;
        if self.anchors() {
            self.command(b'M');
            self.argument(to[0]);
            self.argument(to[1]);
            self.command = b'L';
        } else {
            self.command(b'm');
            self.displacement(to);
            self.command = b'l';
        }
        self.at = to;
        self.start = to;
        Ok(())
    }

    /// A line to a point; nothing if it is the current point after rounding. Answers whether there is a line.
    #[inline]
    pub(super) fn line_to(&mut self, point: DVec2) -> io::Result<bool> {
        self.document.spill()?;
        let to = self.rounded(point);
        let [dx, dy] = [to[0] - self.at[0], to[1] - self.at[1]];
        if dx == 0 && dy == 0 {
            return Ok(false);
        }
        if self.anchors() {
            self.command(b'L');
            self.argument(to[0]);
            self.argument(to[1]);
        } else if dy == 0 {
            self.command(b'h');
            self.argument(dx);
        } else if dx == 0 {
            self.command(b'v');
            self.argument(dy);
        } else {
            self.command(b'l');
            self.argument(dx);
            self.argument(dy);
        }
        self.at = to;
        Ok(true)
    }

    /// A line of no length, which shows as the ends of lines show.
    pub(super) fn stay(&mut self) {
        self.command(b'h');
        self.argument(0);
    }

    /// A cubic Bezier curve.
    pub(super) fn curve_to(&mut self, control: [DVec2; 2], end: DVec2) -> io::Result<()> {
        self.document.spill()?;
        let to = self.rounded(end);
        let absolute = self.anchors();
        self.command(if absolute { b'C' } else { b'c' });
        let origin = if absolute { [0; 2] } else { self.at };
        for point in [self.rounded(control[0]), self.rounded(control[1]), to] {
            self.argument(point[0] - origin[0]);
            self.argument(point[1] - origin[1]);
        }
        self.at = to;
        Ok(())
    }

    /// An elliptic arc of less than half a turn: `radii`, `turn` of the axes in degrees, and whether the arc
    /// goes from the x axis to the y axis.
    pub(super) fn arc_to(&mut self, radii: [f64; 2], turn: f64, onwards: bool, end: DVec2) -> io::Result<()> {
        self.document.spill()?;
        let to = self.rounded(end);
        self.command(b'a');
        for radius in radii {
            self.argument(self.decimal.steps(radius));
        }
        self.argument_as(FINE, FINE.steps(turn));
        let one = self.decimal.scale() as i64;
        self.argument(0);
        self.argument(if onwards { one } else { 0 });
        self.displacement(to);
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
