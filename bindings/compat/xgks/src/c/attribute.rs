//! Output attributes of all workstations.

use super::argument::{Address, call, choice};
use super::types::{Gasfs, Gint, Gpoint, Gtxalign, Gtxfp, Promoted};
use gks::Function;
use gks_pipeline::look::{AspectSourceFlags, Horizontal, InteriorStyle, Precision, TextPath, Vertical};

/// Functions that set one attribute to a number.
macro_rules! setters {
    ($($name:ident($type:ty) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(value: $type) -> Gint {
            call(Function::$function, |gks| gks.$method(value.into()))
        }
    )+ };
}

setters! {
    gsetlineind(Gint) SetPolylineIndex => set_polyline_index;
    gsetlinetype(Gint) SetLinetype => set_linetype;
    gsetlinewidth(Promoted) SetLinewidthScaleFactor => set_linewidth_scale_factor;
    gsetlinecolourind(Gint) SetPolylineColourIndex => set_polyline_colour_index;
    gsetmarkerind(Gint) SetPolymarkerIndex => set_polymarker_index;
    gsetmarkertype(Gint) SetMarkerType => set_marker_type;
    gsetmarkersize(Promoted) SetMarkerSizeScaleFactor => set_marker_size_scale_factor;
    gsetmarkercolourind(Gint) SetPolymarkerColourIndex => set_polymarker_colour_index;
    gsettextind(Gint) SetTextIndex => set_text_index;
    gsetcharexpan(Promoted) SetCharacterExpansionFactor => set_character_expansion_factor;
    gsetcharspace(Promoted) SetCharacterSpacing => set_character_spacing;
    gsettextcolourind(Gint) SetTextColourIndex => set_text_colour_index;
    gsetcharheight(Promoted) SetCharacterHeight => set_character_height;
    gsetfillind(Gint) SetFillAreaIndex => set_fill_area_index;
    gsetfillstyleind(Gint) SetFillAreaStyleIndex => set_fill_area_style_index;
    gsetfillcolourind(Gint) SetFillAreaColourIndex => set_fill_area_colour_index;
}

/// SET TEXT FONT AND PRECISION.
#[unsafe(no_mangle)]
extern "C" fn gsettextfontprec(value: Address<Gtxfp>) -> Gint {
    const F: Function = Function::SetTextFontAndPrecision;
    call(F, |gks| {
        let Gtxfp { font, prec } = value.get(F)?;
        gks.set_text_font_and_precision(font, choice(Precision::from_number(prec), F)?)
    })
}

/// SET CHARACTER UP VECTOR.
#[unsafe(no_mangle)]
extern "C" fn gsetcharup(up: Address<Gpoint>) -> Gint {
    const F: Function = Function::SetCharacterUpVector;
    call(F, |gks| gks.set_character_up_vector(up.get(F)?))
}

/// SET TEXT PATH.
#[unsafe(no_mangle)]
extern "C" fn gsettextpath(path: Gint) -> Gint {
    const F: Function = Function::SetTextPath;
    call(F, |gks| gks.set_text_path(choice(TextPath::from_number(path), F)?))
}

/// SET TEXT ALIGNMENT.
#[unsafe(no_mangle)]
extern "C" fn gsettextalign(value: Address<Gtxalign>) -> Gint {
    const F: Function = Function::SetTextAlignment;
    call(F, |gks| {
        let Gtxalign { hor, ver } = value.get(F)?;
        let horizontal = choice(Horizontal::from_number(hor), F)?;
        gks.set_text_alignment(horizontal, choice(Vertical::from_number(ver), F)?)
    })
}

/// SET FILL AREA INTERIOR STYLE.
#[unsafe(no_mangle)]
extern "C" fn gsetfillintstyle(style: Gint) -> Gint {
    const F: Function = Function::SetFillAreaInteriorStyle;
    call(F, |gks| gks.set_fill_area_interior_style(choice(InteriorStyle::from_number(style), F)?))
}

/// SET PATTERN SIZE.
#[unsafe(no_mangle)]
extern "C" fn gsetpatsize(size: Address<Gpoint>) -> Gint {
    const F: Function = Function::SetPatternSize;
    call(F, |gks| {
        let (width, height) = size.get(F)?.into();
        gks.set_pattern_size(width, height)
    })
}

/// SET PATTERN REFERENCE POINT.
#[unsafe(no_mangle)]
extern "C" fn gsetpatrefpt(point: Address<Gpoint>) -> Gint {
    const F: Function = Function::SetPatternReferencePoint;
    call(F, |gks| gks.set_pattern_reference_point(point.get(F)?))
}

/// SET ASPECT SOURCE FLAGS.
#[unsafe(no_mangle)]
extern "C" fn gsetasf(flags: Address<Gasfs>) -> Gint {
    const F: Function = Function::SetAspectSourceFlags;
    call(F, |gks| {
        let flags = flags.get(F)?.map(|flag| flag != 0);
        gks.set_aspect_source_flags(AspectSourceFlags::from_array(flags))
    })
}
