//! The types of the binding: layouts as in the header `xgks.h`.
#![allow(missing_docs, reason = "the types are those of the header, which explains them")]

use gks_geometry::{Point, Rect, Space, Vector};
use gks_pipeline::colour::Colour;
use gks_pipeline::look::{
    FillBundle, Horizontal, InteriorStyle, LineBundle, MarkerBundle, Precision, TextBundle, Vertical,
};
use std::ffi::{c_char, c_int};

pub(crate) type Gint = c_int;
pub(crate) type Glong = c_int;
pub(crate) type Gchar = c_char;
pub(crate) type Gfloat = f32;
/// A `Gfloat` that is an argument: XGKS has no prototypes, and without one C passes every real number as a double.
pub(crate) type Promoted = f64;
/// Thirteen flags, in the order of the standard.
pub(crate) type Gasfs = [Gint; 13];
/// A matrix of a segment transformation: two rows.
pub(crate) type Gmatrix = [[Gfloat; 3]; 2];

macro_rules! structures {
    ($($name:ident { $($member:ident: $type:ty),+ $(,)? })+) => { $(
        #[repr(C)]
        #[derive(Copy, Clone, Debug)]
        pub(crate) struct $name { $(pub(crate) $member: $type),+ }
    )+ };
}

structures! {
    Gintlist { number: Gint, integers: *mut Gint }
    Gstrlist { number: Gint, strings: *mut *const Gchar }
    Gpoint { x: Gfloat, y: Gfloat }
    Gipoint { x: Gint, y: Gint }
    Glimit { xmin: Gfloat, xmax: Gfloat, ymin: Gfloat, ymax: Gfloat }
    Grect { ll: Gpoint, ur: Gpoint }
    Gcliprec { ind: Gint, rec: Glimit }
    Gcobundl { red: Gfloat, green: Gfloat, blue: Gfloat }
    Gcofac { colours: Gint, coavail: Gint, predefined: Gint }
    Glnbundl { kind: Gint, width: Gfloat, colour: Gint }
    Gmkbundl { kind: Gint, size: Gfloat, colour: Gint }
    Gtxfp { font: Gint, prec: Gint }
    Gtxbundl { fp: Gtxfp, ch_exp: Gfloat, space: Gfloat, colour: Gint }
    Gflbundl { inter: Gint, style: Gint, colour: Gint }
    Gptbundl { size: Gipoint, array: *mut Gint }
    Gtxalign { hor: Gint, ver: Gint }
    Gextent { concat: Gpoint, ll: Gpoint, lr: Gpoint, ul: Gpoint, ur: Gpoint }
    Gdefer { defmode: Gint, irgmode: Gint }
    Gdspsize { units: Gint, device: Gpoint, raster: Gipoint }
    Glnfac { types: Gintlist, widths: Gint, nom: Gfloat, min: Gfloat, max: Gfloat, predefined: Gint }
    Gmkfac { types: Gintlist, sizes: Gint, nom: Gfloat, min: Gfloat, max: Gfloat, predefined: Gint }
    Gflfac { interiors: Gintlist, hatches: Gintlist, predefined: Gint }
    Gtxfac {
        fps: Gint, fp_list: *mut Gtxfp, heights: Gint, min_ht: Gfloat, max_ht: Gfloat,
        expansions: Gint, min_ex: Gfloat, max_ex: Gfloat, predefined: Gint,
    }
    Ggdpfac { number: Gint, attrs: *mut Gint }
    Gmodws { line: Gint, mark: Gint, text: Gint, fill: Gint, pat: Gint, colour: Gint, wstran: Gint }
    Gwsct { conn: *mut Gchar, kind: *mut Gchar }
    Gwsdus { defmode: Gint, dspsurf: Gint, irgmode: Gint, nframe: Gint }
    Gwsmax { open: Gint, active: Gint, assoc: Gint }
    Gwstables { line: Gint, mark: Gint, text: Gint, fill: Gint, pat: Gint, colour: Gint }
    Gwstran { w: Glimit, v: Glimit }
    Gwsti { wstus: Gint, request: Gwstran, current: Gwstran }
    Gpxarray { covalid: Gint, array: *mut Gint }
    Gloc { transform: Gint, position: Gpoint }
    Gstroke { transform: Gint, n_points: Gint, points: *mut Gpoint }
    Gchoice { status: Gint, choice: Gint }
    Gpick { status: Gint, seg: Gint, pickid: Gint }
    Gevent { ws: Gint, dev: Gint, class: Gint }
    Gqueue { class: Gint, devno: Gint }
    Gnumdev { locator: Gint, stroke: Gint, valuator: Gint, choice: Gint, pick: Gint, string: Gint }
    Ggksmit { kind: Gint, length: Gint }
    Gpriattr {
        plnindex: Gint, pmkindex: Gint, txindex: Gint, height: Gfloat, up: Gpoint, chwidth: Gfloat, base: Gpoint,
        path: Gint, align: Gtxalign, flindex: Gint, widthvec: Gpoint, heightvec: Gpoint, prp: Gpoint,
    }
    Gindattr {
        lntype: Gint, lnwidth: Gfloat, lncolour: Gint, mktype: Gint, mksize: Gfloat, mkcolour: Gint, fp: Gtxfp,
        chexp: Gfloat, chspace: Gfloat, txcolour: Gint, flstyle: Gint, flindex: Gint, flcolour: Gint, asflist: Gasfs,
    }
}

impl From<Gpoint> for (f64, f64) {
    fn from(p: Gpoint) -> Self {
        (p.x.into(), p.y.into())
    }
}

impl<S: Space> From<Gpoint> for Point<S> {
    fn from(p: Gpoint) -> Self {
        Point::new(p.x.into(), p.y.into())
    }
}

impl<S: Space> From<Gpoint> for Vector<S> {
    fn from(p: Gpoint) -> Self {
        Vector::new(p.x.into(), p.y.into())
    }
}

impl<S: Space> From<Point<S>> for Gpoint {
    fn from(p: Point<S>) -> Self {
        Gpoint { x: p.x() as Gfloat, y: p.y() as Gfloat }
    }
}

impl<S: Space> From<Vector<S>> for Gpoint {
    fn from(v: Vector<S>) -> Self {
        Gpoint { x: v.x() as Gfloat, y: v.y() as Gfloat }
    }
}

impl<S: Space> From<Glimit> for Rect<S> {
    fn from(l: Glimit) -> Self {
        Rect::new(l.xmin.into(), l.xmax.into(), l.ymin.into(), l.ymax.into())
    }
}

impl<S: Space> From<Rect<S>> for Glimit {
    fn from(r: Rect<S>) -> Self {
        let [xmin, xmax, ymin, ymax] = r.limits().map(|v| v as Gfloat);
        Glimit { xmin, xmax, ymin, ymax }
    }
}

impl From<Colour> for Gcobundl {
    fn from(c: Colour) -> Self {
        Gcobundl { red: c.red, green: c.green, blue: c.blue }
    }
}

impl From<LineBundle> for Glnbundl {
    fn from(b: LineBundle) -> Self {
        Glnbundl { kind: b.linetype, width: b.width as Gfloat, colour: b.colour as Gint }
    }
}

impl From<MarkerBundle> for Gmkbundl {
    fn from(b: MarkerBundle) -> Self {
        Gmkbundl { kind: b.kind, size: b.size as Gfloat, colour: b.colour as Gint }
    }
}

impl From<(i32, Precision)> for Gtxfp {
    fn from((font, precision): (i32, Precision)) -> Self {
        Gtxfp { font, prec: precision as Gint }
    }
}

impl From<TextBundle> for Gtxbundl {
    fn from(b: TextBundle) -> Self {
        let fp = (b.font, b.precision).into();
        Gtxbundl { fp, ch_exp: b.expansion as Gfloat, space: b.spacing as Gfloat, colour: b.colour as Gint }
    }
}

impl From<FillBundle> for Gflbundl {
    fn from(b: FillBundle) -> Self {
        Gflbundl { inter: b.interior as Gint, style: b.style, colour: b.colour as Gint }
    }
}

impl From<(Horizontal, Vertical)> for Gtxalign {
    fn from((horizontal, vertical): (Horizontal, Vertical)) -> Self {
        Gtxalign { hor: horizontal as Gint, ver: vertical as Gint }
    }
}

impl Gflbundl {
    /// The interior style, if it is one.
    pub(crate) fn interior(&self) -> Option<InteriorStyle> {
        InteriorStyle::from_number(self.inter)
    }
}
