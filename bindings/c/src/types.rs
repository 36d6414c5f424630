//! The types of `gks.h` that functions read or set.
#![allow(non_camel_case_types, reason = "the names of the binding")]

use gks_geometry::{Point, Rect, Space, Vector};
use std::ffi::{c_int, c_void};

/// An integer; an enumeration is passed as one.
pub(crate) type Gint = c_int;
/// A real number passed by itself.
pub(crate) type Gdouble = f64;
/// A coordinate, a matrix element, a colour component.
pub(crate) type Gfloat = f32;
/// A transformation matrix, row by row.
pub(crate) type Gtran_matrix = [[Gfloat; 3]; 2];

/// Declares structures, and in tests lists their layouts.
macro_rules! structures {
    ($($(#[$doc:meta])* $name:ident { $($field:ident: $type:ty),+ $(,)? })+) => {
        $(
            $(#[$doc])*
            #[repr(C)]
            #[derive(Copy, Clone, Debug)]
            pub(crate) struct $name { $(pub(crate) $field: $type),+ }
        )+

        /// The names and sizes of all structures, with the names and offsets of their members.
        #[cfg(test)]
        const LAYOUTS: &[(&str, usize, &[(&str, usize)])] = &[
            $((stringify!($name), size_of::<$name>(), &[
                $((stringify!($field), std::mem::offset_of!($name, $field))),+
            ])),+
        ];
    };
}

structures! {
    /// Data of which GKS knows only the size.
    Gdata { size: usize, data: *mut c_void }
    /// A point.
    Gpoint { x: Gfloat, y: Gfloat }
    /// A vector.
    Gvec { delta_x: Gfloat, delta_y: Gfloat }
    /// A list of points.
    Gpoint_list { num_points: Gint, points: *mut Gpoint }
    /// A list of integers.
    Gint_list { num_ints: Gint, ints: *mut Gint }
    /// A size in whole numbers.
    Gint_size { size_x: Gint, size_y: Gint }
    /// A size.
    Gfloat_size { size_x: Gfloat, size_y: Gfloat }
    /// The limits of a rectangle.
    Glimit { x_min: Gfloat, x_max: Gfloat, y_min: Gfloat, y_max: Gfloat }
    /// A rectangle by two opposite corners.
    Grect { p: Gpoint, q: Gpoint }
    /// A colour; the only member of the union `Gcolr_rep`.
    Grgb { red: Gfloat, green: Gfloat, blue: Gfloat }
    /// Text font and precision.
    Gtext_font_prec { font: Gint, prec: Gint }
    /// Text alignment.
    Gtext_align { hor: Gint, vert: Gint }
    /// A polyline representation.
    Gline_bundle { r#type: Gint, width: Gdouble, colr_ind: Gint }
    /// A polymarker representation.
    Gmarker_bundle { r#type: Gint, size: Gdouble, colr_ind: Gint }
    /// A text representation.
    Gtext_bundle { text_font_prec: Gtext_font_prec, char_expan: Gdouble, char_space: Gdouble, colr_ind: Gint }
    /// A fill area representation.
    Gfill_bundle { int_style: Gint, style_ind: Gint, colr_ind: Gint }
    /// A pattern or the colours of a cell array, row by row.
    Gpat_rep { dims: Gint_size, colr_array: *mut Gint }
    /// The individual attributes.
    Gindiv_attrs {
        linetype: Gint, linewidth: Gdouble, line_colr_ind: Gint,
        marker_type: Gint, marker_size: Gdouble, marker_colr_ind: Gint,
        text_font_prec: Gtext_font_prec, char_expan: Gdouble, char_space: Gdouble, text_colr_ind: Gint,
        fill_int_style: Gint, fill_style_ind: Gint, fill_colr_ind: Gint,
        asfs: Gasfs,
    }
    /// The primitive attributes.
    Gprim_attrs {
        line_ind: Gint, marker_ind: Gint, text_ind: Gint,
        char_ht: Gdouble, char_up_vec: Gvec, char_width: Gdouble, char_base_vec: Gvec,
        text_path: Gint, text_align: Gtext_align,
        fill_ind: Gint, pat_width_vec: Gvec, pat_ht_vec: Gvec, pat_ref_point: Gpoint,
    }
    /// Clipping indicator and clipping rectangle.
    Gclip { clip_ind: Gint, clip_rect: Glimit }
    /// Window and viewport of a transformation.
    Gtran { win: Glimit, vp: Glimit }
    /// Where text would lie.
    Gtext_extent { concat_point: Gpoint, paral: [Gpoint; 4] }
    /// The size of a display space.
    Gdisp_space_size { dc_units: Gint, size_dc: Gfloat_size, size_raster: Gint_size }
    /// How many workstations there may be.
    Gws_max_nums { simult_open: Gint, simult_active: Gint, assoc_seg: Gint }
    /// The lengths of the tables of a workstation.
    Gmax_ws_st_tables {
        line_bundles: Gint, marker_bundles: Gint, text_bundles: Gint,
        fill_bundles: Gint, pat_reps: Gint, colr_reps: Gint,
    }
    /// Polyline facilities.
    Gline_facs {
        types: Gint_list, num_widths: Gint,
        nom_width: Gdouble, min_width: Gdouble, max_width: Gdouble, num_pred_inds: Gint,
    }
    /// Polymarker facilities.
    Gmarker_facs {
        types: Gint_list, num_sizes: Gint,
        nom_size: Gdouble, min_size: Gdouble, max_size: Gdouble, num_pred_inds: Gint,
    }
    /// Text facilities.
    Gtext_facs {
        num_font_precs: Gint, font_precs: *mut Gtext_font_prec,
        num_char_hts: Gint, min_char_ht: Gdouble, max_char_ht: Gdouble,
        num_char_expans: Gint, min_char_expan: Gdouble, max_char_expan: Gdouble, num_pred_inds: Gint,
    }
    /// Fill area facilities.
    Gfill_facs { num_int_styles: Gint, int_style: [Gint; 4], hatch_styles: Gint_list, num_pred_inds: Gint }
    /// Colour facilities.
    Gcolr_facs { num_colrs: Gint, colr_avail: Gint, num_pred_inds: Gint }
    /// How changes of workstation attributes become visible.
    Gdyn_mod_ws_attrs {
        line_bundle: Gint, marker_bundle: Gint, text_bundle: Gint, fill_bundle: Gint,
        pat_rep: Gint, colr_rep: Gint, ws_tran: Gint,
    }
    /// A metafile item, whose data here are those of an application: GKS knows only their size.
    Gitem_data { r#type: Gint, length: Gint, data: Gdata }
    /// How changes of segments become visible.
    Gdyn_mod_seg_attrs {
        tran: Gint, vis_invis: Gint, invis_vis: Gint, highl: Gint, pri: Gint, add: Gint, del: Gint,
    }
    /// The attributes of a segment.
    Gseg_attrs { tran: Gtran_matrix, vis: Gint, highl: Gint, pri: Gdouble, det: Gint }
    /// What has been picked.
    Gpick { seg_name: Gint, pick_id: Gint }
    /// Numbers of input devices.
    Gnum_in { loc: Gint, stroke: Gint, val: Gint, choice: Gint, pick: Gint, string: Gint }
}

/// The aspect source flags in the order of the standard, which is that of the structure's members.
pub(crate) type Gasfs = [Gint; 13];

impl<S: Space> From<Gpoint> for Point<S> {
    fn from(p: Gpoint) -> Self {
        Point::new(p.x.into(), p.y.into())
    }
}

impl From<Gpoint> for (f64, f64) {
    fn from(p: Gpoint) -> Self {
        (p.x.into(), p.y.into())
    }
}

impl From<Gvec> for (f64, f64) {
    fn from(v: Gvec) -> Self {
        (v.delta_x.into(), v.delta_y.into())
    }
}

impl<S: Space> From<Point<S>> for Gpoint {
    fn from(p: Point<S>) -> Self {
        Gpoint { x: p.x() as Gfloat, y: p.y() as Gfloat }
    }
}

impl<S: Space> From<Gvec> for Vector<S> {
    fn from(v: Gvec) -> Self {
        Vector::new(v.delta_x.into(), v.delta_y.into())
    }
}

impl<S: Space> From<Vector<S>> for Gvec {
    fn from(v: Vector<S>) -> Self {
        Gvec { delta_x: v.x() as Gfloat, delta_y: v.y() as Gfloat }
    }
}

impl<S: Space> From<Glimit> for Rect<S> {
    fn from(l: Glimit) -> Self {
        Rect::new(l.x_min.into(), l.x_max.into(), l.y_min.into(), l.y_max.into())
    }
}

impl<S: Space> From<Rect<S>> for Glimit {
    fn from(r: Rect<S>) -> Self {
        let [x_min, x_max, y_min, y_max] = r.limits().map(|v| v as Gfloat);
        Glimit { x_min, x_max, y_min, y_max }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Write as _;
    use std::process::Command;

    /// A program that prints what `layouts` does, from the header.
    fn program() -> String {
        let mut out = String::from("#include <stdio.h>\n#include <gks.h>\nint main(void) {\n");
        for (name, _, members) in LAYOUTS {
            let _ = writeln!(out, "printf(\"{name} %zu\\n\", sizeof({name}));");
            for (member, _) in *members {
                let member = member.trim_start_matches("r#");
                let _ = writeln!(out, "printf(\"{name}.{member} %zu\\n\", offsetof({name}, {member}));");
            }
        }
        out + "printf(\"%zu %zu\\n\", sizeof(Gasfs), sizeof(Gcolr_rep));\nreturn 0;\n}\n"
    }

    fn layouts() -> String {
        let mut out = String::new();
        for (name, size, members) in LAYOUTS {
            let _ = writeln!(out, "{name} {size}");
            for (member, offset) in *members {
                let _ = writeln!(out, "{name}.{} {offset}", member.trim_start_matches("r#"));
            }
        }
        let _ = writeln!(out, "{} {}", size_of::<Gasfs>(), size_of::<Grgb>());
        out
    }

    #[test]
    fn structures_are_laid_out_as_in_the_header() {
        let folder = std::env::temp_dir().join(format!("gks-layouts-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder can be made");
        let (source, binary) = (folder.join("layouts.c"), folder.join("layouts"));
        std::fs::write(&source, program()).expect("the program can be written");
        let include = concat!(env!("CARGO_MANIFEST_DIR"), "/include");
        let compiled = Command::new("cc").arg("-I").arg(include).arg(&source).arg("-o").arg(&binary).output();
        let Ok(compiled) = compiled else {
            eprintln!("SKIPPED: there is no C compiler");
            return;
        };
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        let printed = Command::new(&binary).output().expect("the program runs").stdout;
        assert_eq!(String::from_utf8_lossy(&printed), layouts());
        std::fs::remove_dir_all(folder).expect("the folder can be removed");
    }
}
