//! A workstation: a device with tables, a transformation and a picture of its own.

mod drawing;

pub use crate::backend::Backend;
use crate::colour::Colour;
use crate::description::{DeferralMode, Description, DynamicModification, RegenerationMode};
use crate::device::{Device, DeviceError, Drawn, FrameBuffer, Page};
use crate::input::Input;
use crate::painter::Painter;
use crate::record::{Record, Source};
use crate::recording::Recording;
use crate::segment::Segment;
use crate::tables::Tables;
use gks_geometry::{Dc, Du, Map, Ndc, Point, Rect};
use glam::{DAffine2, DMat2, DVec2};

/// The window and the viewport of a workstation transformation.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct WorkstationTransformation {
    /// The part of NDC space that is shown.
    pub window: Rect<Ndc>,
    /// Where on the display surface it is shown, in metres.
    pub viewport: Rect<Dc>,
}

/// Where on the display surface of a workstation items appear.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Place {
    /// From NDC to device units.
    map: Map<Ndc, Du>,
    /// The same for clipping rectangles.
    clip_map: Map<Ndc, Du>,
    /// The part of NDC space that is shown.
    window: Rect<Ndc>,
}

/// The pixels of a display surface and what is needed to understand them.
pub struct ReadBack<'a> {
    /// The pixels of the current page, or none where nothing has been drawn on it and all pixels show the
    /// background.
    pub buffer: Option<&'a dyn FrameBuffer>,
    /// The tables of the workstation.
    pub tables: &'a Tables,
    /// Numbers of columns and rows.
    pub size: (u32, u32),
}

/// The pixel for a position on a side of the display surface that has `count` of them.
fn pixel(at: f64, length: f64, count: u32) -> f64 {
    let count = f64::from(count);
    let at = at * (count / length);
    // The last digits of the maps shall not put an edge into the pixel before it.
    let at = if (at - at.round()).abs() < 1e-6 { at.round() } else { at };
    if at == count { count - 1.0 } else { at.floor() }
}

/// An open workstation.
pub struct Workstation {
    backend: Backend,
    description: Description,
    tables: Tables,
    requested: WorkstationTransformation,
    current: WorkstationTransformation,
    pending: bool,
    deferral: DeferralMode,
    regeneration: RegenerationMode,
    empty: bool,
    /// Whether primitives outside of segments have been drawn on the page.
    loose: bool,
    /// Whether primitives of segments have been drawn on the page.
    kept: bool,
    new_frame_necessary: bool,
    pages: u32,
    begun: bool,
    antialiasing: Option<bool>,
    map: Map<Ndc, Du>,
    painter: Painter,
    /// What has been drawn since the display surface was cleared, where it is kept.
    copied: Option<Recording>,
    /// Room for a primitive under a segment transformation.
    moved: Recording,
}

impl Workstation {
    /// A workstation on a device just opened, with the state that OPEN WORKSTATION sets.
    pub fn new(backend: Backend, description: Description, tables: Tables) -> Self {
        let (width, height) = description.size();
        let whole =
            WorkstationTransformation { window: Rect::UNIT, viewport: Rect::new(0.0, width, 0.0, height) };
        let mut workstation = Workstation {
            backend,
            deferral: description.deferral,
            regeneration: description.regeneration,
            description,
            tables,
            requested: whole,
            current: whole,
            pending: false,
            empty: true,
            loose: false,
            kept: false,
            new_frame_necessary: false,
            pages: 0,
            begun: false,
            antialiasing: None,
            map: Map::IDENTITY,
            painter: Painter::default(),
            copied: None,
            moved: Recording::new(),
        };
        workstation.adopt_requested();
        workstation
    }

    /// What this workstation is able to do.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// The bundle, pattern and colour tables.
    pub fn tables(&self) -> &Tables {
        &self.tables
    }

    /// The tables, to be set up for a workstation that has drawn nothing; what a program changes goes through
    /// [`Workstation::represent`].
    pub fn tables_mut(&mut self) -> &mut Tables {
        &mut self.tables
    }

    /// Changes an entry of a bundle, pattern or colour table: the record is one of the representations. A
    /// metafile is told.
    ///
    /// Pixels that store a colour index change at once, everything else shows the entry from now on; a changed
    /// background shows on the next page unless the current one is empty.
    pub fn represent(&mut self, record: &Record<'_>) -> Result<(), DeviceError> {
        let tables = &mut self.tables;
        let mut at_once = false;
        match *record {
            Record::LineRepresentation(index, bundle) => {
                tables.lines.insert(index, bundle);
            }
            Record::MarkerRepresentation(index, bundle) => {
                tables.markers.insert(index, bundle);
            }
            Record::TextRepresentation(index, bundle) => {
                tables.texts.insert(index, bundle);
            }
            Record::FillRepresentation(index, bundle) => {
                tables.fills.insert(index, bundle);
            }
            Record::PatternRepresentation(index, pattern) => {
                tables.patterns.insert(index, pattern.clone());
            }
            Record::ColourRepresentation(index, colour) => {
                tables.colours.set(index, colour);
                if self.begun
                    && let Some(buffer) = self.backend.device().and_then(|device| device.frame_buffer())
                {
                    at_once = buffer.set_colour(index, colour);
                }
            }
            _ => debug_assert!(false, "{record:?} changes no table"),
        }
        // Segments that are drawn already would look different.
        if self.kept && !at_once {
            self.invalidate();
        }
        match *record {
            Record::TextRepresentation(index, bundle) => {
                self.control(&Record::TextRepresentation(index, self.tables.portable_text(bundle)))
            }
            Record::LineRepresentation(index, bundle) => {
                self.control(&Record::LineRepresentation(index, self.tables.portable_line(bundle)))
            }
            Record::MarkerRepresentation(index, bundle) => {
                self.control(&Record::MarkerRepresentation(index, self.tables.portable_marker(bundle)))
            }
            _ => self.control(record),
        }
    }

    /// The transformation asked for.
    pub fn requested(&self) -> WorkstationTransformation {
        self.requested
    }

    /// The transformation in force.
    pub fn current(&self) -> WorkstationTransformation {
        self.current
    }

    /// Whether the transformation asked for is not yet in force.
    pub fn is_pending(&self) -> bool {
        self.pending
    }

    /// Whether nothing has been drawn since the display surface was cleared.
    pub fn is_empty(&self) -> bool {
        self.empty
    }

    /// Whether the next update has to start a new frame.
    pub fn is_new_frame_necessary(&self) -> bool {
        self.new_frame_necessary
    }

    /// Deferral mode and implicit regeneration mode.
    pub fn deferral(&self) -> (DeferralMode, RegenerationMode) {
        (self.deferral, self.regeneration)
    }

    /// The map from NDC to metres on the display surface that is in force.
    pub fn device_map(&self) -> Map<Ndc, Dc> {
        Map::window_into_viewport(&self.current.window, &self.current.viewport)
    }

    /// Whether the workstation is a metafile that is written and has segments, so that it is told what happens to
    /// them instead of drawing them.
    pub fn has_segments(&self) -> bool {
        matches!(self.backend, Backend::Recorder(_))
    }

    /// Clears the display surface if something is drawn on it, and lets the requested transformation take
    /// effect. What was drawn is complete: a file that holds one page is written.
    ///
    /// An empty page that was begun to be read is cleared too if `always` is set; one that was not begun is
    /// clear, and nothing is written for it.
    pub fn clear(&mut self, always: bool) -> Result<(), DeviceError> {
        let recorded = self.control(&Record::Clear { always });
        let done = if always || !self.empty { self.end_page() } else { Ok(()) };
        self.start_frame();
        recorded.and(done)
    }

    /// Draws the picture again: clears the display surface, lets the requested transformation take effect
    /// and draws the visible ones of `segments`, which are those of this workstation in the order of drawing.
    /// Primitives outside of segments are lost.
    ///
    /// The new picture takes the place of the old one where the device is able to start a page over
    /// ([`Device::erase`]); elsewhere the old one is complete and the new one is on the next page. A picture
    /// that consists of primitives outside of segments alone is never replaced by nothing: it is complete, too.
    pub fn redraw<'s>(
        &mut self,
        segments: impl Iterator<Item = &'s Segment> + Clone,
    ) -> Result<(), DeviceError> {
        if let Backend::Recorder(recorder) = &mut self.backend {
            recorder.control(&Record::RedrawAllSegments)?;
            self.start_frame();
            return Ok(());
        }
        let replaced = !self.loose || segments.clone().next().is_some();
        let mut done = if self.empty || (replaced && self.erase_page()?) {
            Ok(())
        } else {
            let recorded = self.control(&Record::Clear { always: true });
            recorded.and(self.end_page())
        };
        self.start_frame();
        for segment in segments.filter(|segment| segment.is_shown()) {
            // A segment that fails does not keep the others from being drawn.
            self.kept = true;
            done = done.and(self.paint_segment(segment, &segment.appearance));
        }
        done.and(self.present())
    }

    /// Makes all that was drawn visible; draws the picture again if that is necessary and `perform` is set,
    /// as [`Workstation::redraw`] does.
    pub fn update<'s>(
        &mut self,
        perform: bool,
        segments: impl Iterator<Item = &'s Segment> + Clone,
    ) -> Result<(), DeviceError> {
        self.control(&Record::Update { perform })?;
        if perform && self.new_frame_necessary { self.redraw(segments) } else { self.flush() }
    }

    /// Keeps what is drawn from now on until the display surface is cleared, for [`Workstation::copy_to`].
    pub fn keep(&mut self) {
        self.copied.get_or_insert_default();
    }

    /// Draws what is kept on another device, with the tables of this workstation as they are now, and closes
    /// that. The workstation window appears at the same place of its display surface.
    pub fn copy_to(&self, backend: Backend, description: Description) -> Result<(), DeviceError> {
        let (from, to) = (self.description.size(), description.size());
        let (across, up) = (to.0 / from.0, to.1 / from.1);
        let WorkstationTransformation { window, viewport } = self.current;
        let [left, right, bottom, top] = viewport.limits();
        let viewport = Rect::new(left * across, right * across, bottom * up, top * up);
        let mut copy = Workstation::new(backend, description, self.tables.clone());
        copy.requested = WorkstationTransformation { window, viewport };
        copy.adopt_requested();
        let drawn = self.copied.iter().flatten().try_for_each(|item| copy.draw(&item));
        drawn.and(copy.close())
    }

    /// The state of a display surface that was cleared.
    fn start_frame(&mut self) {
        self.empty = true;
        self.loose = false;
        self.kept = false;
        self.new_frame_necessary = false;
        self.copied.iter_mut().for_each(Recording::clear);
        self.adopt_requested();
    }

    /// Notes that what is drawn is no longer what the segments and the tables say. On an empty display
    /// surface there is nothing to note; else a new frame is necessary, which is due at once or at the next
    /// output where implicit regeneration is ALLOWED: see [`Workstation::is_regeneration_due`].
    pub fn invalidate(&mut self) {
        if !self.empty && !self.has_segments() {
            self.new_frame_necessary = true;
        }
    }

    /// Whether a necessary new frame is made unasked: before a primitive outside of segments is drawn at
    /// the latest, and at once where the deferral mode is ASAP.
    pub fn is_regeneration_due(&self) -> bool {
        self.new_frame_necessary && self.regeneration == RegenerationMode::Allowed
    }

    /// Whether output is to be visible at once.
    pub fn is_prompt(&self) -> bool {
        self.deferral == DeferralMode::Asap
    }

    /// Makes all that was drawn visible, where somebody looks at the page while it grows.
    pub fn flush(&mut self) -> Result<(), DeviceError> {
        if self.begun { self.backend.device().map_or(Ok(()), Device::flush) } else { Ok(()) }
    }

    /// Makes what was just drawn visible unless that is deferred.
    #[inline]
    fn present(&mut self) -> Result<(), DeviceError> {
        if self.is_prompt() { self.flush() } else { Ok(()) }
    }

    /// Whether [`Workstation::redraw`] at the end would show what is drawn and more, and lose nothing.
    pub fn is_worth_redrawing(&self) -> bool {
        self.new_frame_necessary && !self.loose
    }

    /// Sets deferral mode and implicit regeneration mode. A regeneration may become due.
    pub fn set_deferral(
        &mut self,
        deferral: DeferralMode,
        regeneration: RegenerationMode,
    ) -> Result<(), DeviceError> {
        self.deferral = deferral;
        self.regeneration = regeneration;
        let presented = self.present();
        self.control(&Record::Deferral(deferral, regeneration)).and(presented)
    }

    /// Asks for another workstation window. A regeneration may become due.
    pub fn set_window(&mut self, window: Rect<Ndc>) -> Result<(), DeviceError> {
        self.requested.window = window;
        self.transformation_changed();
        self.control(&Record::WorkstationWindow(window))
    }

    /// Asks for another workstation viewport, in metres. A regeneration may become due.
    pub fn set_viewport(&mut self, viewport: Rect<Dc>) -> Result<(), DeviceError> {
        self.requested.viewport = viewport;
        self.transformation_changed();
        self.control(&Record::WorkstationViewport(viewport))
    }

    fn transformation_changed(&mut self) {
        if self.empty || self.description.dynamic.transformation == DynamicModification::Imm {
            self.adopt_requested();
            return;
        }
        self.pending = true;
        self.new_frame_necessary = true;
    }

    fn adopt_requested(&mut self) {
        self.current = self.requested;
        self.pending = false;
        self.map = self.device_map().then(&self.to_units());
    }

    /// The map from metres on the display surface to device units.
    fn to_units(&self) -> Map<Dc, Du> {
        let surface = &self.description.surface;
        let per_metre = 1.0 / surface.unit;
        Map::from_affine(if surface.y_down {
            DAffine2::from_mat2_translation(
                DMat2::from_diagonal(DVec2::new(per_metre, -per_metre)),
                DVec2::new(0.0, surface.height),
            )
        } else {
            DAffine2::from_scale(DVec2::splat(per_metre))
        })
    }

    /// Sets the colour of an index, as [`Workstation::represent`] does.
    pub fn set_colour(&mut self, index: u32, colour: Colour) -> Result<(), DeviceError> {
        self.represent(&Record::ColourRepresentation(index, colour))
    }

    /// Turns antialiasing on or off for what is drawn from now on; without effect on a device that has no
    /// choice.
    pub fn set_antialiasing(&mut self, on: bool) {
        self.antialiasing = Some(on);
        self.apply_antialiasing();
    }

    /// Passes a control function on to a metafile.
    pub fn control(&mut self, record: &Record<'_>) -> Result<(), DeviceError> {
        self.backend.control(record)
    }

    /// The metafile that is read.
    pub fn source(&mut self) -> Option<&mut (dyn Source + 'static)> {
        match &mut self.backend {
            Backend::Source(source) => Some(&mut **source),
            _ => None,
        }
    }

    /// What an operator acts on, where there is an operator.
    pub fn input(&mut self) -> Option<&mut dyn Input> {
        self.backend.device()?.input()
    }

    fn apply_antialiasing(&mut self) {
        if let Some(on) = self.antialiasing
            && self.begun
            && let Some(buffer) = self.backend.device().and_then(|device| device.frame_buffer())
        {
            buffer.set_antialiasing(on);
        }
    }

    /// The pixels of the display surface, where they can be read back.
    pub fn frame_buffer(&mut self) -> Result<Option<&mut dyn FrameBuffer>, DeviceError> {
        self.begin_page()?;
        Ok(self.backend.device().and_then(|device| device.frame_buffer()))
    }

    /// What an inquiry reads pixels from, where they can be read back. Nothing is begun for it.
    pub fn read_back(&mut self) -> Option<ReadBack<'_>> {
        let (tables, size, begun) = (&self.tables, self.description.raster, self.begun);
        let buffer = &*self.backend.device()?.frame_buffer()?;
        Some(ReadBack { buffer: begun.then_some(buffer), tables, size })
    }

    /// The pixel (column, row) that contains a point given in NDC, columns from the left and rows from the
    /// top; it may lie outside of the display surface. A point on the right or the lower edge of the display
    /// surface is in the last pixel. Devices without pixels count addressable positions.
    pub fn pixel_at(&self, p: Point<Ndc>) -> (f64, f64) {
        let surface = &self.description.surface;
        let (columns, rows) = self.description.raster;
        let at = self.map.point(p);
        let down = if surface.y_down { at.y() } else { surface.height - at.y() };
        (pixel(at.x(), surface.width, columns), pixel(down, surface.height, rows))
    }

    /// Completes the picture and closes the device.
    pub fn close(mut self) -> Result<(), DeviceError> {
        // A program that draws nothing still finds the file it asked for.
        let begun = if self.pages == 0 { self.begin_page() } else { Ok(()) };
        let ended = self.end_page();
        begun.and(ended).and(self.backend.close())
    }

    fn begin_page(&mut self) -> Result<(), DeviceError> {
        if self.begun {
            return Ok(());
        }
        let page = self.page(self.pages + 1);
        if let Some(device) = self.backend.device() {
            device.begin(&page)?;
        }
        self.pages += 1;
        self.begun = true;
        self.apply_antialiasing();
        Ok(())
    }

    fn page(&self, number: u32) -> Page {
        Page { number, background: self.tables.background(), colours: self.tables.colours.iter().collect() }
    }

    /// Starts the page over where the device can. Whether it is empty now.
    fn erase_page(&mut self) -> Result<bool, DeviceError> {
        let page = self.page(self.pages);
        let erased = self.backend.erase(&page)? == Drawn::Yes;
        self.apply_antialiasing();
        Ok(erased)
    }

    fn end_page(&mut self) -> Result<(), DeviceError> {
        if !self.begun {
            return Ok(());
        }
        self.begun = false;
        self.backend.device().map_or(Ok(()), Device::end)
    }
}
