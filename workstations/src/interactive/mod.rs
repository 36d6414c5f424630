//! Interactive workstations: a window, a page in a browser, a terminal.
//!
//! All of them draw with the true-colour frame buffer and share the console, which turns what the operator
//! does into measures and triggers, and the prompts and echoes. They differ in the *screen* that shows the
//! picture and in where the operator's *events* come from.
//!
//! ```text
//!   picture -> TrueColour --+
//!                           +-> Presenter (a thread) -> Screen: window, page, terminal
//!   measures -> echoes -----+
//!   Console <- events <- Operator: window, page, keyboard
//! ```

pub mod console;
mod echo;
pub mod event;
pub mod frame;
mod interaction;
mod panel;
mod presenter;
pub mod protocol;
pub mod queue;
pub mod scale;
mod sketch;
mod terminal;
mod web;
mod window;
mod workstation;

pub use presenter::{Ending, Screen};

use crate::options::Options;
use crate::raster;
use gks_pipeline::description::{Category, DeferralMode, Description};
use gks_pipeline::device::Device;
use gks_pipeline::generated::numbers::{WorkstationType, workstation_type as own};
use workstation::Interactive;

/// Numbers of logical input devices: locators, strokes, valuators, choices, picks, strings.
const DEVICES: [u32; 6] = [2, 2, 4, 4, 2, 2];

/// Whether a type of workstation is an interactive one.
pub(crate) fn is_interactive(kind: &WorkstationType) -> bool {
    matches!(kind.number, own::WINDOW | own::WEB | own::TERMINAL | own::SIXEL | own::KITTY | own::BLOCKS)
}

/// The description of a type when it is opened with these options, or why it cannot be opened with them.
pub(crate) fn describe(kind: &WorkstationType, options: &Options) -> Result<Description, String> {
    let description =
        raster::true_colour(kind.number, kind.name, options).map_err(|error| error.to_string())?;
    Ok(Description {
        category: Category::OutIn,
        // Terminals show whole pictures.
        deferral: if matches!(kind.number, own::WINDOW | own::WEB) {
            DeferralMode::Asap
        } else {
            description.deferral
        },
        input: DEVICES,
        ..description
    })
}

/// A device of a type; `name` is the connection identifier without its options.
pub(crate) fn open(kind: &WorkstationType, options: &Options, name: &str) -> Result<Box<dyn Device>, String> {
    let layout = raster::Layout::new(options).map_err(|error| error.to_string())?;
    let size = (layout.width, layout.height);
    match kind.number {
        own::WINDOW => {
            let (screen, queue) = window::open(name, size)?;
            Ok(Box::new(Interactive::new(options, Box::new(screen), Some(Box::new(queue)))?))
        }
        own::WEB => {
            let (screen, queue) = web::open(name, size, options.port, options.open)?;
            Ok(Box::new(Interactive::new(options, Box::new(screen), Some(Box::new(queue)))?))
        }
        own::TERMINAL | own::SIXEL | own::KITTY | own::BLOCKS => {
            let (screen, operator) = terminal::open(kind.number, name)?;
            Ok(Box::new(Interactive::new(options, Box::new(screen), Some(operator))?))
        }
        _ => Err(format!("workstation type {} is not available", kind.name)),
    }
}
