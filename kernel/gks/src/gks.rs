//! The kernel as a value.

use crate::attributes::Geometry;
use crate::input::{Devices, EventQueue};
use crate::metafile::Items;
use crate::normalization::Normalization;
use crate::{Error, Function, OperatingState, Result};
use gks_geometry::{Ndc, PathBuf, Rect, Wc};
use gks_pipeline::description::Catalogue;
use gks_pipeline::device::DeviceError;
use gks_pipeline::item::{Item, Shape};
use gks_pipeline::look::Look;
use gks_pipeline::segment::Segments;
use gks_pipeline::tables::Tables;
use gks_pipeline::workstation::Workstation;
use std::collections::BTreeMap;

/// A Graphical Kernel System: operating state, state lists and open workstations.
///
/// Every function of the standard is a method with the standard's name. Several kernels may live in one
/// process and on several threads; they share nothing.
pub struct Gks {
    pub(crate) state: OperatingState,
    pub(crate) catalogue: Box<dyn Catalogue>,
    pub(crate) defaults: Defaults,
    /// Individual attributes and bundle indices; geometric attributes in NDC, current where
    /// `geometry_stale` is not set.
    pub(crate) look: Look,
    /// Geometric attributes in world coordinates.
    pub(crate) geometry: Geometry,
    /// Whether the geometric attributes in `look` have to be mapped again before they are used.
    pub(crate) geometry_stale: bool,
    pub(crate) normalization: Normalization,
    /// The current pick identifier.
    pub(crate) pick: i32,
    /// Events that the application has not taken yet.
    pub(crate) events: EventQueue,
    /// Open workstations by workstation identifier.
    pub(crate) workstations: BTreeMap<i32, OpenWorkstation>,
    pub(crate) segments: Segments,
    /// The segment that primitives go to, in the state SGOP.
    pub(crate) open_segment: Option<OpenSegment>,
    pub(crate) paths: PathBuf<Ndc>,
    /// Scratch space for the bounds of the parts of a long polyline.
    pub(crate) parts: Vec<Option<Rect<Wc>>>,
    pub(crate) on_message: Option<MessageHandler>,
}

/// What is done with the text of MESSAGE: called with the workstation identifier and the text.
pub type MessageHandler = Box<dyn FnMut(i32, &str) + Send>;

/// An entry of the set of open workstations.
pub(crate) struct OpenWorkstation {
    pub(crate) workstation: Workstation,
    pub(crate) connection: String,
    pub(crate) kind: i32,
    pub(crate) active: bool,
    /// Whether something of its segments has changed since it was last updated for input.
    pub(crate) changed: bool,
    /// The logical input devices.
    pub(crate) input: Devices,
    /// The items of a metafile that is read.
    pub(crate) items: Items,
}

/// The open segment.
#[derive(Copy, Clone, Debug)]
pub(crate) struct OpenSegment {
    pub(crate) name: i32,
    /// Whether a workstation is associated that draws from the segments of the kernel, as metafiles do not.
    pub(crate) stored: bool,
}

/// The initial values that implementations and dialects choose differently.
#[derive(Clone, Debug, PartialEq)]
pub struct Defaults {
    /// The attributes that OPEN GKS sets.
    pub look: Look,
    /// The tables that OPEN WORKSTATION sets.
    pub tables: Tables,
    /// The least number that is the name of a segment.
    pub first_segment: i32,
    /// Whether INQUIRE TEXT EXTENT answers for metafiles too.
    pub text_extent_of_metafiles: bool,
    /// The colours of every workstation that are predefined in the place of the usual ones, from index 0 on: red, green and
    /// blue of 8 bits each, as in 0xff8000 for orange.
    pub colours: &'static [u32],
    /// Whether REQUEST and SAMPLE show changes of segments first, as UPDATE WORKSTATION does. Those of a pick device do not,
    /// since they need what is seen, nor does what only tables have changed.
    pub updates_before_input: bool,
}

impl Default for Defaults {
    /// The library's own choice: aspect source flags INDIVIDUAL, interior style HOLLOW.
    fn default() -> Self {
        Defaults {
            look: Look::default(),
            tables: Tables::predefined(),
            first_segment: 1,
            text_extent_of_metafiles: false,
            colours: &[],
            updates_before_input: false,
        }
    }
}

impl Gks {
    /// A closed kernel that opens workstations through `catalogue`.
    pub fn new(catalogue: Box<dyn Catalogue>) -> Self {
        Gks::with_defaults(catalogue, Defaults::default())
    }

    /// A closed kernel with initial values of a dialect.
    pub fn with_defaults(catalogue: Box<dyn Catalogue>, defaults: Defaults) -> Self {
        Gks {
            state: OperatingState::Gkcl,
            catalogue,
            look: defaults.look.clone(),
            defaults,
            geometry: Geometry::default(),
            geometry_stale: true,
            normalization: Normalization::default(),
            pick: 0,
            events: EventQueue::default(),
            workstations: BTreeMap::new(),
            segments: Segments::new(),
            open_segment: None,
            paths: PathBuf::new(),
            parts: Vec::new(),
            on_message: None,
        }
    }

    /// An open kernel: [`Gks::new`] and OPEN GKS.
    pub fn open(catalogue: Box<dyn Catalogue>) -> Self {
        let mut gks = Gks::new(catalogue);
        gks.reset();
        gks.state = OperatingState::Gkop;
        gks
    }

    /// Sets what is done with the text of MESSAGE.
    pub fn on_message(&mut self, handler: MessageHandler) {
        self.on_message = Some(handler);
    }

    /// Sets all state lists to their initial values.
    pub(crate) fn reset(&mut self) {
        self.look = self.defaults.look.clone();
        self.geometry = Geometry::default();
        self.geometry_stale = true;
        self.normalization = Normalization::default();
        self.pick = 0;
        self.segments = Segments::new();
        self.open_segment = None;
        self.events = EventQueue::default();
    }

    /// Checks that `function` may be called in the current operating state.
    #[inline]
    pub(crate) fn check_state(&self, function: Function) -> Result<()> {
        if function.states().contains(self.state) { Ok(()) } else { Err(wrong_state(function)) }
    }

    /// The open workstation with an identifier. Errors: 20, 25.
    pub(crate) fn workstation(&self, function: Function, id: i32) -> Result<&OpenWorkstation> {
        match self.workstations.get(&id) {
            Some(open) => Ok(open),
            None => Err(not_open(function, id)),
        }
    }

    /// The open workstation with an identifier, to be changed. Errors: 20, 25.
    pub(crate) fn workstation_mut(&mut self, function: Function, id: i32) -> Result<&mut OpenWorkstation> {
        match self.workstations.get_mut(&id) {
            Some(open) => Ok(open),
            None => Err(not_open(function, id)),
        }
    }

    /// Draws a primitive with the current attributes on every active workstation, and keeps it in the open
    /// segment.
    ///
    /// A device that fails does not keep the others from drawing; the first failure is reported.
    pub(crate) fn output(&mut self, function: Function, shape: Shape<'_>) -> Result<()> {
        let item = Item { shape, look: &self.look, clip: self.normalization.clip, pick: self.pick };
        let target = Target {
            workstations: &mut self.workstations,
            segments: &mut self.segments,
            open_segment: self.open_segment,
        };
        target.draw(function, &item)
    }
}

/// Where primitives go.
pub(crate) struct Target<'a> {
    pub(crate) workstations: &'a mut BTreeMap<i32, OpenWorkstation>,
    pub(crate) segments: &'a mut Segments,
    pub(crate) open_segment: Option<OpenSegment>,
}

impl Target<'_> {
    /// Draws a primitive on every active workstation, and keeps it in the open segment.
    pub(crate) fn draw(self, function: Function, item: &Item<'_>) -> Result<()> {
        let Target { workstations, segments, open_segment } = self;
        let mut failure = Ok(());
        let mut note = |done: std::result::Result<(), DeviceError>| {
            if let Err(error) = done
                && failure.is_ok()
            {
                failure = Err(device_error(function, &error));
            }
        };
        let active = workstations.iter_mut().filter(|(_, open)| open.active);
        let Some(OpenSegment { name, stored }) = open_segment else {
            for (&id, OpenWorkstation { workstation, .. }) in active {
                // What is deferred comes first.
                if workstation.is_regeneration_due() {
                    note(workstation.redraw(segments.on(id)));
                }
                note(workstation.draw(item));
            }
            return failure;
        };
        let Some(segment) = segments.get_mut(name) else { return Ok(()) };
        if stored {
            segment.recording.push(item);
        }
        let (visible, appearance) = (segment.visible, segment.appearance);
        for (&id, OpenWorkstation { workstation, .. }) in active {
            // What will be drawn with the whole picture need not be drawn now.
            if !(workstation.has_segments() || visible && !workstation.is_regeneration_due()) {
                continue;
            }
            note(workstation.draw_in_segment(item, &appearance));
            if !workstation.is_new_frame_necessary() && segments.is_covered(name, id) {
                workstation.invalidate();
            }
        }
        failure
    }
}

#[cold]
fn wrong_state(function: Function) -> Error {
    Error::new(function.state_error(), function)
}

#[cold]
fn not_open(function: Function, id: i32) -> Error {
    let number = if id < 1 { 20 } else { 25 };
    Error::new(number, function).because(format!("workstation identifier {id}"))
}

/// The error of the standard for a device that failed: 303 for bytes that could not be written, 304 else.
#[cold]
pub(crate) fn device_error(function: Function, error: &DeviceError) -> Error {
    let number = match error {
        DeviceError::Io(_) => 303,
        DeviceError::Encode(_) => 304,
    };
    Error::new(number, function).because(error.to_string())
}

/// The error of the standard for an operator whose entries could not be received: 305.
#[cold]
pub(crate) fn receiving_error(function: Function, error: &DeviceError) -> Error {
    Error::new(305, function).because(error.to_string())
}
