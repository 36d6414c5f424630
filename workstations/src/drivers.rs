//! Which driver serves which workstation type.

use crate::options::{Options, SizeLimits};
use crate::{null, svg};
use gks_pipeline::description::Description;
use gks_pipeline::device::{Device, Sink};
use gks_pipeline::generated::numbers::{WorkstationType, workstation_type as own};

/// What sizes of display surfaces a type accepts, and in which unit.
pub(crate) fn limits(kind: &WorkstationType) -> &'static SizeLimits {
    match kind.number {
        own::SVG | own::SVG_OUTLINES | own::PDF | own::PS | own::EPS => &SizeLimits::POINTS,
        own::HPGL => &SizeLimits::MILLIMETRES,
        _ => &SizeLimits::PIXELS,
    }
}

/// The description of a type when it is opened with these options, or why it cannot be opened with them.
pub(crate) fn describe(kind: &WorkstationType, options: &Options) -> Result<Description, String> {
    let (number, name) = (kind.number, kind.name);
    match number {
        own::SVG | own::SVG_OUTLINES => Ok(svg::describe(number, name, options)),
        own::NULL => Ok(null::describe(number, name, options)),
        _ => Err(unavailable(kind)),
    }
}

/// A device of a type; `sink` is present for the types that write files.
pub(crate) fn open(
    kind: &WorkstationType,
    options: &Options,
    sink: Option<Box<dyn Sink>>,
) -> Result<Box<dyn Device>, String> {
    match (kind.number, sink) {
        (own::SVG | own::SVG_OUTLINES, Some(sink)) => Ok(Box::new(svg::Svg::new(sink, options))),
        (own::NULL, None) => Ok(Box::new(null::Null::new(options))),
        _ => Err(unavailable(kind)),
    }
}

fn unavailable(kind: &WorkstationType) -> String {
    format!("workstation type {} is not available", kind.name)
}
