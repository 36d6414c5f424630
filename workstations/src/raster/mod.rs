//! Raster workstations: true-colour and indexed frame buffers, and image files made of them.
//!
//! One device unit is one pixel; columns count from the left and rows from the top, so that the centre of
//! pixel (c, r) is the point (c + 0.5, r + 0.5).

mod aliased;
mod bitmap;
mod cells;
mod clip;
mod coloured_cells;
mod composite;
mod dense;
mod describe;
mod encode;
mod ends;
mod four;
mod indexed;
mod letters;
mod lines;
mod lone;
mod look_up_table;
mod markers;
mod pattern;
mod stamp;
mod stroke;
mod true_colour;

pub use describe::{Layout, SizeError, indexed, true_colour};
pub use encode::Format;
pub use indexed::Indexed;
pub use true_colour::{SharedPixels, TrueColour};
