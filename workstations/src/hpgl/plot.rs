//! The text of a plot: what the plotter has been told, so that nothing is told twice.

use crate::number::Decimal;
use gks_pipeline::device::Sink;
use glam::DVec2;
use std::io;

/// Positions in one instruction: plotters with little memory must hold all of them.
const POSITIONS: u32 = 32;
/// Bytes collected before the sink gets them.
const COLLECTED: usize = 1 << 15;
/// Positions are whole plotter units.
const WHOLE: Decimal = Decimal::new(0);

type Position = (i64, i64);

/// A plot being written. Positions are rounded to plotter units.
#[derive(Debug, Default)]
pub(super) struct Plot {
    text: Vec<u8>,
    /// The pen held.
    pen: Option<u32>,
    /// Where the pen is.
    at: Option<Position>,
    /// Whether the pen is down.
    down: bool,
    /// Positions in the instruction being written; 0 between instructions.
    positions: u32,
}

impl Plot {
    /// Begins a sheet. P1 and P2 are set to its corners: readers without a plotter take its size from them.
    pub(super) fn start(&mut self, width: f64, height: f64) {
        *self = Plot::default();
        self.text.extend(b"IN;\nIP0,0");
        self.position((WHOLE.steps(width), WHOLE.steps(height)));
        self.text.extend(b";\n");
    }

    /// Takes a pen.
    pub(super) fn select(&mut self, pen: u32) {
        if self.pen == Some(pen) {
            return;
        }
        self.lift();
        self.text.extend(b"SP");
        WHOLE.write_steps(&mut self.text, i64::from(pen));
        self.text.extend(b";\n");
        self.pen = Some(pen);
        // The pen has been to its stall and back.
        self.at = None;
    }

    /// Draws a line, as the continuation of the last one if it starts where the pen is. What rounding leaves
    /// of a short line is a dot.
    pub(super) fn line(&mut self, points: &[DVec2]) {
        let mut positions = points.iter().map(|p| (WHOLE.steps(p.x), WHOLE.steps(p.y)));
        let Some(first) = positions.next() else { return };
        if !(self.down && self.at == Some(first)) {
            self.move_to(first);
        }
        for position in positions {
            if self.at != Some(position) {
                self.draw_to(position);
            }
        }
        if !self.down {
            self.text.extend(b"PD;\n");
            self.down = true;
        }
    }

    fn move_to(&mut self, to: Position) {
        self.end_instruction();
        self.text.extend(b"PU");
        self.number(to);
        self.text.push(b';');
        self.down = false;
        self.at = Some(to);
    }

    fn draw_to(&mut self, to: Position) {
        if self.positions == POSITIONS {
            self.end_instruction();
        }
        if self.positions == 0 {
            self.text.extend(b"PD");
            self.number(to);
        } else {
            self.position(to);
        }
        self.positions += 1;
        self.down = true;
        self.at = Some(to);
    }

    fn end_instruction(&mut self) {
        if self.positions > 0 {
            self.text.extend(b";\n");
            self.positions = 0;
        }
    }

    fn lift(&mut self) {
        self.end_instruction();
        if self.down {
            self.text.extend(b"PU;\n");
            self.down = false;
        }
    }

    fn number(&mut self, (x, y): Position) {
        WHOLE.write_steps(&mut self.text, x);
        self.text.push(b',');
        WHOLE.write_steps(&mut self.text, y);
    }

    fn position(&mut self, position: Position) {
        self.text.push(b',');
        self.number(position);
    }

    /// Ends the sheet: the pen is lifted at once, so that it does not blot, and put back.
    pub(super) fn finish(&mut self) {
        self.lift();
        self.text.extend(b"SP0;\n");
        self.pen = None;
        self.at = None;
    }

    /// Hands the text to the sink if there is enough of it or if `all` must go.
    pub(super) fn drain(&mut self, sink: &mut dyn Sink, all: bool) -> io::Result<()> {
        if all || self.text.len() >= COLLECTED {
            sink.write(&self.text)?;
            self.text.clear();
        }
        Ok(())
    }
}
