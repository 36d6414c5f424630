//! The terminal workstations: pictures between the lines of text, and the keyboard while input is wanted.
//!
//! While a logical input device is started, the picture has the whole terminal; afterwards the text is back.

mod blocks;
mod capability;
mod keyboard;
mod kitty;
mod median_cut;
mod operator;
mod sixel;

use super::frame::{Area, Frame};
use super::presenter::{Ending, Screen};
use super::queue::Operator;
use super::scale::{Scaler, fit};
use crate::connection;
use capability::Graphics;
use gks_pipeline::device::Sink;
use gks_pipeline::generated::numbers::workstation_type as own;
use operator::{Keyboard, Nobody};
use rustix::termios::{isatty, tcgetwinsize};
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Columns and rows of cells where nothing is known of the terminal.
const CELLS: (u32, u32) = (100, 50);
/// Pixels of a cell where the terminal does not tell.
const CELL: (u32, u32) = (10, 20);

/// What the screen and the keyboard of a terminal share.
#[derive(Clone, Debug, Default)]
struct Attention(Arc<Mutex<Stand>>);

#[derive(Copy, Clone, Debug, Default)]
struct Stand {
    /// Whether the picture has the whole terminal.
    whole: bool,
    /// Pixels of the picture for each cell.
    cell: (f64, f64),
}

impl Attention {
    fn get(&self) -> Stand {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Stand)) {
        change(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner));
    }
}

/// Where a picture is written.
enum Output {
    /// To the standard output as it comes.
    Standard {
        /// Whether it is a terminal.
        terminal: bool,
    },
    /// To a file, which is complete in the end.
    File(Box<dyn Sink>),
}

/// The picture in a terminal.
pub(super) struct Terminal {
    output: Output,
    graphics: Graphics,
    attention: Attention,
    /// How many pictures have been shown.
    count: u32,
}

/// Opens a terminal workstation of a type; a name that is not a number is that of a file to write.
pub(super) fn open(kind: i32, name: &str) -> Result<(Terminal, Box<dyn Operator>), String> {
    let to_file = !name.is_empty() && name != "-" && !name.bytes().all(|byte| byte.is_ascii_digit());
    let wanted = match kind {
        own::SIXEL => Some(Graphics::Sixel),
        own::KITTY => Some(Graphics::Kitty),
        own::BLOCKS => Some(Graphics::Blocks),
        _ => None,
    };
    let attention = Attention::default();
    let nobody = || Box::new(Nobody) as Box<dyn Operator>;
    let terminal = |output, graphics| Terminal { output, graphics, attention: attention.clone(), count: 0 };
    if to_file {
        let failed = |error: io::Error| error.to_string();
        let mut sink = connection::open(name).map_err(failed)?;
        sink.open().map_err(failed)?;
        return Ok((terminal(Output::File(sink), wanted.unwrap_or(Graphics::Blocks)), nobody()));
    }
    let tty = if isatty(io::stdout()) {
        OpenOptions::new().read(true).write(true).open("/dev/tty").ok()
    } else {
        None
    };
    let Some(mut tty) = tty else {
        let output = Output::Standard { terminal: false };
        return Ok((terminal(output, wanted.unwrap_or(Graphics::Blocks)), nobody()));
    };
    let known = || capability::from_environment(|name| std::env::var(name).ok());
    let graphics = wanted.or_else(known).unwrap_or_else(|| capability::ask(&mut tty));
    let keyboard: Box<dyn Operator> = Box::new(Keyboard::new(tty, attention.clone()));
    Ok((terminal(Output::Standard { terminal: true }, graphics), keyboard))
}

/// The room in a terminal: cells, and pixels of a cell.
fn room() -> ((u32, u32), (u32, u32)) {
    let Ok(size) = tcgetwinsize(io::stdout()) else { return (CELLS, CELL) };
    let [columns, rows, width, height] =
        [size.ws_col, size.ws_row, size.ws_xpixel, size.ws_ypixel].map(u32::from);
    if columns == 0 || rows == 0 {
        return (CELLS, CELL);
    }
    let cell = if width >= columns && height >= rows { (width / columns, height / rows) } else { CELL };
    ((columns, rows), cell)
}

/// The picture at another size: red, green and blue of each pixel.
fn scaled(frame: &Frame, to: (u32, u32)) -> Vec<u8> {
    let scaler = Scaler::new(frame.size(), to);
    let (pixels, stride) = (frame.pixels(), frame.size().0 as usize);
    let old = |column: usize, row: usize| {
        let at = (row * stride + column) * 4;
        [pixels[at], pixels[at + 1], pixels[at + 2]]
    };
    let mut rgb = Vec::with_capacity(to.0 as usize * to.1 as usize * 3);
    for row in 0..to.1 as usize {
        (0..to.0 as usize).for_each(|column| rgb.extend(scaler.pixel(column, row, old)));
    }
    rgb
}

impl Terminal {
    /// The codes that show a picture where the cursor is, for a terminal or, full size, for a file.
    fn encode(&mut self, frame: &Frame, whole: bool) -> io::Result<Vec<u8>> {
        let terminal = matches!(self.output, Output::Standard { terminal: true });
        let ((columns, rows), cell) = if terminal { room() } else { (CELLS, CELL) };
        // Two lines are left for what comes before and after.
        let rows = if whole { rows } else { rows.saturating_sub(2).max(1) };
        let size = frame.size();
        let room = match self.graphics {
            Graphics::Blocks => (columns, rows * 2),
            _ if !terminal => size,
            _ => ((columns * cell.0).min(size.0), (rows * cell.1).min(size.1)),
        };
        let to = fit(size, room);
        let rgb = scaled(frame, to);
        let scale = (f64::from(size.0) / f64::from(to.0), f64::from(size.1) / f64::from(to.1));
        let cell = if self.graphics == Graphics::Blocks { (1, 2) } else { cell };
        let pixels = (scale.0 * f64::from(cell.0), scale.1 * f64::from(cell.1));
        self.attention.change(|stand| stand.cell = pixels);
        self.count = self.count.wrapping_add(1);
        Ok(match self.graphics {
            Graphics::Sixel => sixel::encode(&rgb, to.0 as usize),
            Graphics::Blocks => blocks::encode(&rgb, to.0 as usize, if whole { "\r\n" } else { "\n" }),
            Graphics::Kitty => {
                // While it has the whole terminal, a picture takes the place of the one before.
                let number = if whole { 1 } else { (std::process::id() % 60_000) * 60_000 + self.count + 1 };
                kitty::encode(&rgb, to.0, to.1, number)?
            }
        })
    }
}

impl Screen for Terminal {
    fn show(&mut self, frame: &Frame, _: Area) -> io::Result<()> {
        let whole = self.attention.get().whole;
        let mut codes = self.encode(frame, whole)?;
        if whole {
            codes.splice(..0, *b"\x1b[H");
            // The last line break would scroll the picture.
            if self.graphics == Graphics::Blocks {
                codes.truncate(codes.len() - 2);
            }
        } else if self.graphics != Graphics::Blocks {
            codes.push(b'\n');
        }
        match &mut self.output {
            Output::Standard { .. } => {
                let mut out = io::stdout().lock();
                out.write_all(&codes)?;
                out.flush()
            }
            Output::File(sink) => sink.write(&codes),
        }
    }

    fn close(&mut self, _: Ending) {
        if let Output::File(sink) = &mut self.output
            && let Err(error) = sink.finish()
        {
            eprintln!("gks: the picture for a terminal could not be written: {error}");
        }
    }

    fn pace(&self) -> Duration {
        Duration::from_millis(if self.attention.get().whole { 80 } else { 16 })
    }

    fn is_growing(&self) -> bool {
        false
    }
}

/// A terminal to talk to.
type Tty = File;
