//! The way of an item to the device: resolve, map, clip, offer, lower.
//!
//! Order matters and is the same for every device. Attributes are resolved by the tables of the
//! workstation; the item is mapped to device units in one pass; what lies outside the clipping rectangle is
//! dropped, what crosses it is offered with the rectangle to a device that can clip by itself, and else
//! simplified until exact clipping is possible: a dashed line is cut into dashes before it is clipped, so
//! that the dashes keep their phase; text becomes outlines before it is clipped.

mod long_line;

use crate::colour::Paint;
use crate::device::{
    Device, DeviceError, Drawn, Fill, Form, Glyph, Mark, MarkerStyle, Palette, Pen, Rule, StrokeCharacter,
    Surface,
};
use crate::font::Layout;
use crate::item::{Cells, Curve, Item, Parallelogram, Role, Shape};
use crate::look::{Cap, InteriorStyle, Join, Look};
use crate::lower;
use crate::tables::Tables;
use gks_algorithms as algorithms;
use gks_algorithms::clip::sutherland_hodgman;
use gks_algorithms::fill::Hatch;
use gks_geometry::{Du, Map, Ndc, PathBuf, Paths, Point, Rect};
use glam::DVec2;
use std::ops::ControlFlow;

/// The most dashes that one polyline is cut into; beyond, it is drawn solid.
pub const MOST_DASHES: usize = 10_000_000;
/// As many markers are mapped and drawn at a time: their positions stay in the cache of the processor.
const MARKERS: usize = 1 << 14;

/// Paints items on one device; owns the scratch space that makes painting free of allocations.
#[derive(Default)]
pub struct Painter {
    mapped: PathBuf<Du>,
    clipped: PathBuf<Du>,
    pub(crate) lowered: PathBuf<Du>,
    pub(crate) strokes: PathBuf<Du>,
    pieces: PathBuf<Du>,
    outlines: PathBuf<Du>,
    dash: Dash,
    pub(crate) hatch: Hatch,
    paints: Vec<Paint>,
    pub(crate) layout: Layout,
    pub(crate) glyphs: Vec<Glyph>,
    pub(crate) characters: Vec<StrokeCharacter>,
}

/// Where an item is painted: a device with the transformation and the tables of its workstation.
pub struct Canvas<'a> {
    /// The device, with a page begun.
    pub device: &'a mut dyn Device,
    /// Its display surface.
    pub surface: &'a Surface,
    /// The tables of the workstation.
    pub tables: &'a Tables,
    /// The segment transformation and the current workstation transformation, down to device units.
    pub map: Map<Ndc, Du>,
    /// The current workstation transformation alone, which is the one for clipping rectangles.
    pub clip_map: Map<Ndc, Du>,
    /// Whether the band of highlighting is painted instead of the items themselves.
    pub glow: bool,
    /// The current workstation window, which always clips.
    pub window: Rect<Ndc>,
}

impl Canvas<'_> {
    /// Offers a mark to the device.
    pub(crate) fn offer(&mut self, form: Form<'_>, clip: Option<Rect<Du>>) -> Result<Drawn, DeviceError> {
        self.device.draw(&Mark { form, clip })
    }

    /// The largest deviation allowed when a curve becomes a polygon.
    pub(crate) fn tolerance(&self) -> f64 {
        self.surface.resolution * 0.1
    }
}

/// Puts the images of points that lie inside of a rectangle at the beginning of `images`, and answers how many there are.
fn map_within(map: &Map<Ndc, Du>, rect: &Rect<Du>, points: &[DVec2], images: &mut Vec<DVec2>) -> usize {
    if images.len() < points.len() {
        images.resize(points.len(), DVec2::ZERO);
    }
    let mut count = 0;
    for &p in points {
        let p = map.0.transform_point2(p);
        let is_inside =
            (p.x >= rect.min.x()) & (p.x <= rect.max.x()) & (p.y >= rect.min.y()) & (p.y <= rect.max.y());
        // The next one is put over it if it does not count.
        images[count] = p;
        count += usize::from(is_inside);
    }
    count
}

/// What is to be clipped away of a mark, given its bounds: everything, nothing, or what crosses.
enum Visibility {
    Hidden,
    Whole,
    Crossing,
}

fn visibility(bounds: &Rect<Du>, clip: &Rect<Du>) -> Visibility {
    if !bounds.meets(clip) {
        Visibility::Hidden
    } else if clip.contains_rect(bounds) {
        Visibility::Whole
    } else {
        Visibility::Crossing
    }
}

impl Painter {
    /// Paints an item.
    pub fn paint(&mut self, item: &Item<'_>, canvas: &mut Canvas<'_>) -> Result<(), DeviceError> {
        if let Some(sector) = item.look.clip_sector {
            return lower::sector::paint(self, item, sector, canvas);
        }
        let Some(clip) = item.clip.intersection(&canvas.window) else { return Ok(()) };
        let clip = canvas.clip_map.rect(&clip);
        if canvas.glow {
            return lower::glow::draw(self, item, &clip, canvas);
        }
        match item.shape {
            Shape::Polyline(paths) => self.polyline(paths, item.look, &clip, canvas),
            Shape::Polymarker(positions) => self.polymarker(positions, item.look, &clip, canvas),
            Shape::Text(position, text) => lower::text::draw(self, position, text, item.look, &clip, canvas),
            Shape::FillArea(rings) => self.fill_area(rings, item.look, &clip, canvas),
            Shape::CellArray(place, cells) => self.cell_array(&place, &cells, &clip, canvas),
            Shape::Generalized(curve, role) => self.generalized(&curve, role, item.look, &clip, canvas),
        }
    }

    fn polyline(
        &mut self,
        paths: Paths<'_, Ndc>,
        look: &Look,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        self.mapped.clear();
        self.mapped.add_mapped(paths, &canvas.map);
        let pen = resolve_pen(look, canvas, &mut self.dash);
        let crossing = match whole_lines(self.mapped.as_paths(), &pen, clip, canvas) {
            ControlFlow::Break(done) => return done,
            ControlFlow::Continue(crossing) => crossing,
        };
        let (mapped, mut dash) = (std::mem::take(&mut self.mapped), std::mem::take(&mut self.dash));
        let pen = resolve_pen(look, canvas, &mut dash);
        let done = self.cut_lines(mapped.as_paths(), &pen, (clip, crossing), canvas);
        self.mapped = mapped;
        self.dash = dash;
        done
    }

    /// Draws lines inside of `clip`.
    pub(crate) fn lines(
        &mut self,
        paths: Paths<'_, Du>,
        pen: &Pen<'_>,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        match whole_lines(paths, pen, clip, canvas) {
            ControlFlow::Break(done) => done,
            ControlFlow::Continue(crossing) => self.cut_lines(paths, pen, (clip, crossing), canvas),
        }
    }

    /// Draws lines that cross the edge of `clip`, or have dashes, or are too wide for a pen.
    fn cut_lines(
        &mut self,
        paths: Paths<'_, Du>,
        pen: &Pen<'_>,
        (clip, crossing): (&Rect<Du>, bool),
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        if !pen.dash.is_empty() {
            if canvas.offer(Form::Lines(paths, *pen), crossing.then_some(*clip))? == Drawn::Yes {
                return Ok(());
            }
            let mut pieces = std::mem::take(&mut self.pieces);
            pieces.clear();
            let around = clip.grown(pen.width);
            let rect = (around.min.0, around.max.0);
            for path in paths.iter() {
                let (points, ends) = (&mut pieces.points, &mut pieces.ends);
                algorithms::line::dash(rect, path, pen.dash, 0.0, MOST_DASHES, points, ends);
            }
            let done = self.lines(pieces.as_paths(), &Pen { dash: &[], ..*pen }, clip, canvas);
            self.pieces = pieces;
            return done;
        }
        if let Some(tip) = canvas.surface.pen.filter(|_| !is_one_stroke(pen, canvas)) {
            return lower::wide::draw(self, paths, pen, tip, clip, canvas);
        }
        let mut clipped = std::mem::take(&mut self.clipped);
        clipped.clear();
        for path in paths.iter() {
            let rect = (clip.min.0, clip.max.0);
            algorithms::clip::polyline(rect, path, &mut clipped.points, &mut clipped.ends);
        }
        let done = if clipped.ends.is_empty() {
            Ok(())
        } else {
            must(canvas.offer(Form::Lines(clipped.as_paths(), *pen), None))
        };
        self.clipped = clipped;
        done
    }

    /// Markers are drawn whole where their position is inside the clipping rectangle; only the workstation
    /// window cuts them.
    fn polymarker(
        &mut self,
        positions: &[DVec2],
        look: &Look,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let style = lower::marker::style(look, canvas);
        let window = canvas.clip_map.rect(&canvas.window);
        let mut mapped = std::mem::take(&mut self.mapped);
        let mut done = Ok(());
        for positions in positions.chunks(MARKERS) {
            let count = map_within(&canvas.map, clip, positions, &mut mapped.points);
            done = self.markers(&mut mapped.points[..count], &style, &window, canvas);
            if done.is_err() {
                break;
            }
        }
        self.mapped = mapped;
        done
    }

    /// Draws markers, cut at the window. A device that draws only whole ones gets those that are: the few that
    /// cross the edge are no reason to make lines of all of them. The order of the positions may change.
    fn markers(
        &mut self,
        positions: &mut [DVec2],
        style: &MarkerStyle,
        window: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let Some(bounds) = Paths::<Du>::new(positions, &[]).bounds() else { return Ok(()) };
        let whole = window.contains_rect(&bounds.grown(style.size * 0.5));
        if canvas.offer(Form::Markers(positions, *style), (!whole).then_some(*window))? == Drawn::Yes {
            return Ok(());
        }
        let inner = window.grown(-style.size * 0.5);
        let count = if whole { 0 } else { partition(positions, |p| inner.contains(Point::from_vec(p))) };
        let (within, crossing) = positions.split_at(count);
        if count > 0 && canvas.offer(Form::Markers(within, *style), None)? == Drawn::Yes {
            return lower::marker::draw(self, crossing, style, window, canvas);
        }
        lower::marker::draw(self, positions, style, window, canvas)
    }

    fn fill_area(
        &mut self,
        rings: Paths<'_, Ndc>,
        look: &Look,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let mut mapped = std::mem::take(&mut self.mapped);
        mapped.clear();
        mapped.add_mapped(rings, &canvas.map);
        let done = self.area(mapped.as_paths(), look, clip, canvas);
        self.mapped = mapped;
        done
    }

    /// Draws an area, by the even-odd rule, with the fill area attributes of `look`.
    pub(crate) fn area(
        &mut self,
        rings: Paths<'_, Du>,
        look: &Look,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let bundle = canvas.tables.fill(look);
        let paint = canvas.tables.translucent(bundle.colour, canvas.tables.opacity.areas);
        if bundle.interior == InteriorStyle::Solid {
            return self.solid(rings, Rule::EvenOdd, paint, clip, canvas);
        }
        let Some(bounds) = rings.bounds() else { return Ok(()) };
        let crossing = match visibility(&bounds, clip) {
            Visibility::Hidden => return Ok(()),
            Visibility::Whole => false,
            Visibility::Crossing => true,
        };
        match bundle.interior {
            InteriorStyle::Pattern => {
                let Some(place) = lower::pattern::place(look, bundle.style, canvas, &mut self.paints) else {
                    return self.hollow(rings, crossing, paint, clip, canvas);
                };
                let paints = std::mem::take(&mut self.paints);
                let (place, grid) = place.with(&paints);
                let offered = Form::Area(rings, Rule::EvenOdd, Fill::Pattern(place, grid));
                let done = match canvas.offer(offered, crossing.then_some(*clip)) {
                    Ok(Drawn::No) => lower::pattern::draw(self, rings, &place, &grid, clip, canvas),
                    Ok(Drawn::Yes) => Ok(()),
                    Err(error) => Err(error),
                };
                self.paints = paints;
                done
            }
            InteriorStyle::Hatch => {
                let Some(style) = lower::hatch::style(bundle.style) else {
                    return self.hollow(rings, crossing, paint, clip, canvas);
                };
                self.clipped_area(rings, crossing, clip, |painter, rings| {
                    lower::hatch::draw(painter, rings, style, paint, clip, canvas)
                })
            }
            // Solid ones are drawn by now.
            InteriorStyle::Hollow | InteriorStyle::Solid => self.hollow(rings, crossing, paint, clip, canvas),
        }
    }

    /// Calls `then` with the part of the area inside of `clip`.
    pub(crate) fn clipped_area(
        &mut self,
        rings: Paths<'_, Du>,
        crossing: bool,
        clip: &Rect<Du>,
        then: impl FnOnce(&mut Painter, Paths<'_, Du>) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        if !crossing {
            return then(self, rings);
        }
        let mut outlines = std::mem::take(&mut self.outlines);
        outlines.clear();
        for ring in rings.iter() {
            let rect = (clip.min.0, clip.max.0);
            sutherland_hodgman(rect, ring, &mut outlines.points, &mut outlines.ends);
        }
        let done = if outlines.ends.is_empty() { Ok(()) } else { then(self, outlines.as_paths()) };
        self.outlines = outlines;
        done
    }

    fn hollow(
        &mut self,
        rings: Paths<'_, Du>,
        crossing: bool,
        paint: Paint,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let pen = plain_pen(paint, canvas);
        self.clipped_area(rings, crossing, clip, |painter, rings| {
            let mut closed = std::mem::take(&mut painter.lowered);
            closed.clear();
            for ring in rings.iter() {
                closed.add(ring.iter().copied().chain(ring.first().copied()));
            }
            let done = painter.lines(closed.as_paths(), &pen, clip, canvas);
            painter.lowered = closed;
            done
        })
    }

    /// Fills an area with one colour inside of `clip`.
    pub(crate) fn solid(
        &mut self,
        rings: Paths<'_, Du>,
        rule: Rule,
        paint: Paint,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let Some(bounds) = rings.bounds() else { return Ok(()) };
        let crossing = match visibility(&bounds, clip) {
            Visibility::Hidden => return Ok(()),
            Visibility::Whole => false,
            Visibility::Crossing => true,
        };
        let fill = Fill::Solid(paint);
        if canvas.offer(Form::Area(rings, rule, fill), crossing.then_some(*clip))? == Drawn::Yes {
            return Ok(());
        }
        self.clipped_area(rings, crossing, clip, |painter, rings| {
            if crossing && canvas.offer(Form::Area(rings, rule, fill), None)? == Drawn::Yes {
                return Ok(());
            }
            lower::hatch::solid(painter, rings, rule, paint, clip, canvas)
        })
    }

    fn cell_array(
        &mut self,
        place: &Parallelogram<Ndc>,
        cells: &Cells<'_>,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let place = place.mapped(&canvas.map);
        let Some(bounds) = Rect::around(place.corners()) else { return Ok(()) };
        let clip_at = match visibility(&bounds, clip) {
            Visibility::Hidden => return Ok(()),
            Visibility::Whole => None,
            Visibility::Crossing => Some(*clip),
        };
        let palette = Palette::new(canvas.tables);
        if canvas.offer(Form::IndexedCells(place, *cells, palette), clip_at)? == Drawn::Yes {
            return Ok(());
        }
        let mut paints = std::mem::take(&mut self.paints);
        lower::cells::paints(cells, &palette, &mut paints);
        let grid = crate::device::Grid { paints: &paints, columns: cells.columns, rows: cells.rows };
        let done = match canvas.offer(Form::Cells(place, grid), clip_at) {
            Ok(Drawn::No) => lower::cells::draw(self, &place, &grid, clip, canvas),
            Ok(Drawn::Yes) => Ok(()),
            Err(error) => Err(error),
        };
        self.paints = paints;
        done
    }

    fn generalized(
        &mut self,
        curve: &Curve<'_, Ndc>,
        role: Role,
        look: &Look,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<(), DeviceError> {
        let mut mapped = std::mem::take(&mut self.mapped);
        mapped.clear();
        let curve = match *curve {
            Curve::Ellipse(ellipse) => Curve::Ellipse(ellipse.mapped(&canvas.map)),
            Curve::Bezier(points) => {
                mapped.add(points.iter().map(|&p| canvas.map.0.transform_point2(p)));
                Curve::Bezier(&mapped.points)
            }
        };
        let done = lower::curve::draw(self, &curve, role, look, clip, canvas);
        self.mapped = mapped;
        done
    }

    /// Takes the dash buffer for a pen of the polyline attributes.
    pub(crate) fn with_pen<R>(
        &mut self,
        look: &Look,
        canvas: &mut Canvas<'_>,
        then: impl FnOnce(&mut Painter, &Pen<'_>, &mut Canvas<'_>) -> R,
    ) -> R {
        let mut dash = std::mem::take(&mut self.dash);
        let pen = resolve_pen(look, canvas, &mut dash);
        let result = then(self, &pen, canvas);
        self.dash = dash;
        result
    }
}

/// Brings the points for which `is_first` holds before the others, and tells how many they are.
fn partition(points: &mut [DVec2], is_first: impl Fn(DVec2) -> bool) -> usize {
    let mut count = 0;
    for i in 0..points.len() {
        if is_first(points[i]) {
            points.swap(i, count);
            count += 1;
        }
    }
    count
}

/// Draws lines that are hidden, or solid and whole and drawn by one stroke of the pen; else tells whether they cross the edge
/// of `clip`.
fn whole_lines(
    paths: Paths<'_, Du>,
    pen: &Pen<'_>,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> ControlFlow<Result<(), DeviceError>, bool> {
    let Some(bounds) = paths.bounds() else { return ControlFlow::Break(Ok(())) };
    match visibility(&bounds, clip) {
        Visibility::Hidden => ControlFlow::Break(Ok(())),
        Visibility::Whole if pen.dash.is_empty() && is_one_stroke(pen, canvas) => {
            ControlFlow::Break(must(canvas.offer(Form::Lines(paths, *pen), None)))
        }
        Visibility::Whole => ControlFlow::Continue(false),
        Visibility::Crossing => ControlFlow::Continue(true),
    }
}

/// Whether a pen draws a line as wide as it is at once: not where it has to go to and fro with its tip.
fn is_one_stroke(pen: &Pen<'_>, canvas: &Canvas<'_>) -> bool {
    canvas.surface.pen.is_none_or(|tip| pen.width <= tip * lower::wide::SINGLE)
}

/// An unclipped solid polyline may not be refused.
fn must(drawn: Result<Drawn, DeviceError>) -> Result<(), DeviceError> {
    match drawn? {
        Drawn::Yes => Ok(()),
        Drawn::No => Err(DeviceError::Encode("the driver refuses solid lines".into())),
    }
}

/// The pen for the boundary of hollow areas and for hatches: solid, of nominal width.
pub(crate) fn plain_pen(paint: Paint, canvas: &Canvas<'_>) -> Pen<'static> {
    let width = lower::line::width(canvas.tables.nominal.linewidth, canvas.surface);
    Pen { paint, width, dash: &[], cap: Cap::Round, join: Join::Round }
}

/// Width and dashes of the last line, kept as long as lines look the same.
#[derive(Default)]
struct Dash {
    linetype: i32,
    /// The linewidth as a multiple of the nominal one of all devices, the shorter side of the surface and its resolution.
    factors: [f64; 3],
    width: f64,
    lengths: Vec<f64>,
}

/// The pen that the polyline attributes of `look` mean on this workstation; its dashes are put into `dash`.
fn resolve_pen<'d>(look: &Look, canvas: &Canvas<'_>, dash: &'d mut Dash) -> Pen<'d> {
    let bundle = canvas.tables.line(look);
    let surface = canvas.surface;
    let width = bundle.width * canvas.tables.nominal.linewidth;
    let factors = [width, surface.width.min(surface.height), surface.resolution];
    if dash.linetype != bundle.linetype || dash.factors != factors {
        (dash.linetype, dash.factors) = (bundle.linetype, factors);
        dash.width = lower::line::width(width, surface);
        // Dashes of wide lines grow with the width, or they would merge.
        let unit = surface.nominal_linewidth().max(dash.width * 0.5);
        dash.lengths.clear();
        dash.lengths.extend(lower::line::dashes(bundle.linetype).iter().map(|d| d * unit));
    }
    let paint = canvas.tables.translucent(bundle.colour, canvas.tables.opacity.lines);
    Pen { paint, width: dash.width, dash: &dash.lengths, cap: look.cap, join: look.join }
}
