//! Representations: bundle, pattern and colour tables of a workstation.

use crate::argument::{Integer, Real};
use crate::call::subroutines;
use crate::output::Part;

subroutines! {
    gsplr_(wkid: Integer, pli: Integer, ltype: Integer, lwidth: Real, coli: Integer)
        SetPolylineRepresentation => |gks| {
            gks.set_polyline_representation(wkid.get(), pli.get(), ltype.get(), lwidth.real(), coli.get())
        };
    gspmr_(wkid: Integer, pmi: Integer, mtype: Integer, mszsf: Real, coli: Integer)
        SetPolymarkerRepresentation => |gks| {
            gks.set_polymarker_representation(wkid.get(), pmi.get(), mtype.get(), mszsf.real(), coli.get())
        };
    gstxr_(wkid: Integer, txi: Integer, font: Integer, prec: Integer, chxp: Real, chsp: Real, coli: Integer)
        SetTextRepresentation => |gks| {
            let (wkid, txi, font, prec) = (wkid.get(), txi.get(), font.get(), prec.choice(F)?);
            gks.set_text_representation(wkid, txi, font, prec, chxp.real(), chsp.real(), coli.get())
        };
    gsfar_(wkid: Integer, fai: Integer, ints: Integer, styli: Integer, coli: Integer)
        SetFillAreaRepresentation => |gks| {
            let ints = ints.choice(F)?;
            gks.set_fill_area_representation(wkid.get(), fai.get(), ints, styli.get(), coli.get())
        };
    gspar_(
        wkid: Integer, pai: Integer,
        dimx: Integer, dimy: Integer, isc: Integer, isr: Integer, dx: Integer, dy: Integer, colia: Integer,
    ) SetPatternRepresentation => |gks| {
        let part = Part::new([dimx, dimy], [isc, isr], [dx, dy]);
        let (wkid, pai, cells) = (wkid.get(), pai.get(), part.cells(colia));
        gks.set_pattern_representation_of(wkid, pai, cells, part.columns, part.rows, part.stride)
    };
    gscr_(wkid: Integer, ci: Integer, cr: Real, cg: Real, cb: Real) SetColourRepresentation
        => |gks| gks.set_colour_representation(wkid.get(), ci.get(), (cr.real(), cg.real(), cb.real()));
}
