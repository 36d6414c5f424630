//! Inquiries, by the state list or description table that they read.

mod description;
mod pixels;
mod representation;
mod state_list;
mod workstation;

use crate::types::{
    Gdouble, Gfill_bundle, Gint, Gline_bundle, Gmarker_bundle, Grgb, Gtext_align, Gtext_bundle,
    Gtext_font_prec,
};
use gks_pipeline::colour::Colour;
use gks_pipeline::look::{
    AspectSourceFlags, FillBundle, Horizontal, LineBundle, MarkerBundle, Precision, TextBundle, Vertical,
};

impl From<LineBundle> for Gline_bundle {
    fn from(b: LineBundle) -> Self {
        Gline_bundle { r#type: b.linetype, width: b.width, colr_ind: b.colour as Gint }
    }
}

impl From<MarkerBundle> for Gmarker_bundle {
    fn from(b: MarkerBundle) -> Self {
        Gmarker_bundle { r#type: b.kind, size: b.size, colr_ind: b.colour as Gint }
    }
}

impl From<TextBundle> for Gtext_bundle {
    fn from(b: TextBundle) -> Self {
        Gtext_bundle {
            text_font_prec: (b.font, b.precision).into(),
            char_expan: b.expansion,
            char_space: b.spacing,
            colr_ind: b.colour as Gint,
        }
    }
}

impl From<FillBundle> for Gfill_bundle {
    fn from(b: FillBundle) -> Self {
        Gfill_bundle { int_style: b.interior as Gint, style_ind: b.style, colr_ind: b.colour as Gint }
    }
}

impl From<(Gint, Precision)> for Gtext_font_prec {
    fn from((font, precision): (Gint, Precision)) -> Self {
        Gtext_font_prec { font, prec: precision as Gint }
    }
}

impl From<(Horizontal, Vertical)> for Gtext_align {
    fn from((horizontal, vertical): (Horizontal, Vertical)) -> Self {
        Gtext_align { hor: horizontal as Gint, vert: vertical as Gint }
    }
}

impl From<Colour> for Grgb {
    fn from(c: Colour) -> Self {
        Grgb { red: c.red, green: c.green, blue: c.blue }
    }
}

/// The aspect source flags as numbers.
fn asfs(flags: AspectSourceFlags) -> crate::types::Gasfs {
    flags.to_array().map(Gint::from)
}

/// The length of a vector, which is a size.
fn length<S: gks_geometry::Space>(vector: gks_geometry::Vector<S>) -> Gdouble {
    vector.length()
}
