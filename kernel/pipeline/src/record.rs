//! What recorders keep and sources give back: the stream of a metafile, at the waist.
//!
//! A recorder (metafile output) is no device: it takes primitives before anything is resolved, mapped or
//! clipped, and beside them the control functions and tables of its workstation. A source (metafile input)
//! gives the same stream back. [`Record`] names what GKSM items 1-6, 11-16, 21-44, 51-56, 61, 71-72, 81-95
//! and those above 100 hold; all coordinates are NDC unless said otherwise, whatever the file codes them as.

pub mod item;

use crate::colour::Colour;
use crate::description::{DeferralMode, RegenerationMode};
use crate::device::{DeviceError, Drawn};
use crate::item::{Item, Shape};
use crate::look::{
    AspectSourceFlags, Cap, ClipSector, FillBundle, Horizontal, InteriorStyle, Join, LineBundle,
    MarkerBundle, Precision, TextBundle, TextPath, Vertical,
};
use crate::tables::Pattern;
use gks_geometry::{Dc, Map, Ndc, Point, Rect, Vector};
use std::collections::BTreeMap;
use std::io;

/// A recorder: the output side of a metafile.
pub trait Recorder: Send {
    /// Records a primitive with the attributes, the clipping rectangle and the pick identifier it has.
    ///
    /// A format that keeps attributes as a state writes those that differ from what it wrote last; see
    /// [`crate::look_difference::differences`].
    fn draw(&mut self, item: &Item<'_>) -> Result<(), DeviceError>;

    /// Records anything but a primitive: never [`Record::Primitive`] nor [`Record::Attribute`].
    fn control(&mut self, record: &Record<'_>) -> Result<(), DeviceError>;

    /// Completes the metafile, which appears under its name now.
    fn close(&mut self) -> Result<(), DeviceError>;
}

/// A recorder of pictures: a metafile without segments, on which is drawn what is to be seen, as on a device.
pub trait PictureRecorder: Recorder {
    /// Starts the picture over where nothing of it has left the recorder yet; [`Drawn::No`] leaves it as it is.
    fn erase(&mut self) -> Result<Drawn, DeviceError>;
}

/// A source: the input side of a metafile.
pub trait Source: Send {
    /// The next record, or none after the last one. What is unknown is skipped inside; [`Source::skipped`] tells.
    ///
    /// Memory is bounded by the largest record; no count in the file is believed before the data is there.
    fn next(&mut self) -> Result<Option<Record<'_>>, SourceError>;

    /// What has been skipped so far.
    fn skipped(&self) -> Skipped {
        Skipped::default()
    }

    /// What has been met so far, in the terms of the format; nothing where records are the items of the format.
    fn contents(&self) -> Contents {
        Contents::default()
    }
}

/// What a metafile holds in the terms of its own format, where that is not the format of GKS.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// How many elements there are, by the names that their standard gives them.
    pub elements: BTreeMap<&'static str, u64>,
    /// The fonts that the metafile lists, by name.
    pub fonts: Vec<String>,
}

/// What a source has skipped: what it does not know, what makes no sense, and what says nothing that can be drawn here.
///
/// Names are counted; a file that invents them may have as many as [`Skipped::NAMES`], the others are one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Skipped {
    names: BTreeMap<String, u64>,
}

impl Skipped {
    /// The most names that are kept apart.
    pub const NAMES: usize = 64;

    /// Counts one that is skipped.
    pub fn add(&mut self, name: &str) {
        if let Some(count) = self.names.get_mut(name) {
            *count += 1;
        } else {
            let name = if self.names.len() < Self::NAMES { name } else { "others" };
            *self.names.entry(name.to_owned()).or_default() += 1;
        }
    }

    /// Counts what another one has counted.
    pub fn extend(&mut self, other: &Skipped) {
        for (name, count) in &other.names {
            *self.names.entry(name.clone()).or_default() += count;
        }
    }

    /// Whether nothing has been skipped.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// How many have been skipped.
    pub fn count(&self) -> u64 {
        self.names.values().sum()
    }

    /// The names in the order of the alphabet, and how many there were of each.
    pub fn iter(&self) -> impl Iterator<Item = (&str, u64)> {
        self.names.iter().map(|(name, count)| (name.as_str(), *count))
    }
}

/// Why a source could not give a record.
#[derive(Debug, thiserror::Error)]
pub enum SourceError {
    /// Bytes could not be read.
    #[error("reading the metafile failed: {0}")]
    Io(#[from] io::Error),
    /// What is in the file makes no sense; reading on may be tried.
    #[error("byte {offset} of the metafile: {what}")]
    Malformed {
        /// Where, in bytes from the start of the file.
        offset: u64,
        /// What is wrong.
        what: String,
    },
}

/// One entry of a metafile.
#[derive(Clone, Debug)]
pub enum Record<'a> {
    /// CLEAR WORKSTATION: always, or only if the display surface is not empty. Begins a new picture.
    Clear {
        /// Whether an empty surface is cleared too.
        always: bool,
    },
    /// REDRAW ALL SEGMENTS ON WORKSTATION.
    RedrawAllSegments,
    /// UPDATE WORKSTATION.
    Update {
        /// Whether a necessary new frame is started.
        perform: bool,
    },
    /// SET DEFERRAL STATE.
    Deferral(DeferralMode, RegenerationMode),
    /// MESSAGE.
    Message(&'a str),
    /// ESCAPE: the function identifier and the bytes of its data record.
    Escape(i32, &'a [u8]),
    /// A primitive, which looks as the attributes before it say. Only in sources.
    Primitive(Shape<'a>),
    /// A new value of an attribute of the primitives that follow. Only in sources.
    Attribute(Attribute),
    /// SET POLYLINE REPRESENTATION.
    LineRepresentation(u32, LineBundle),
    /// SET POLYMARKER REPRESENTATION.
    MarkerRepresentation(u32, MarkerBundle),
    /// SET TEXT REPRESENTATION.
    TextRepresentation(u32, TextBundle),
    /// SET FILL AREA REPRESENTATION.
    FillRepresentation(u32, FillBundle),
    /// SET PATTERN REPRESENTATION.
    PatternRepresentation(u32, &'a Pattern),
    /// SET COLOUR REPRESENTATION.
    ColourRepresentation(u32, Colour),
    /// SET WORKSTATION WINDOW.
    WorkstationWindow(Rect<Ndc>),
    /// SET WORKSTATION VIEWPORT, in metres on the display surface.
    WorkstationViewport(Rect<Dc>),
    /// CREATE SEGMENT.
    CreateSegment(i32),
    /// CLOSE SEGMENT.
    CloseSegment,
    /// RENAME SEGMENT: the old and the new name.
    RenameSegment(i32, i32),
    /// DELETE SEGMENT.
    DeleteSegment(i32),
    /// SET SEGMENT TRANSFORMATION.
    SegmentTransformation(i32, Map<Ndc, Ndc>),
    /// SET VISIBILITY.
    Visibility(i32, bool),
    /// SET HIGHLIGHTING.
    Highlighting(i32, bool),
    /// SET SEGMENT PRIORITY.
    SegmentPriority(i32, f64),
    /// SET DETECTABILITY.
    Detectability(i32, bool),
    /// An item of an application: its type, above 100, and its bytes.
    User(i32, &'a [u8]),
}

/// An attribute of primitives as metafiles keep it: one at a time, geometry in NDC.
#[derive(Copy, Clone, Debug, PartialEq)]
pub enum Attribute {
    /// Polyline index.
    LineIndex(u32),
    /// Linetype.
    Linetype(i32),
    /// Linewidth scale factor.
    LineWidth(f64),
    /// Polyline colour index.
    LineColour(u32),
    /// Polymarker index.
    MarkerIndex(u32),
    /// Marker type.
    MarkerType(i32),
    /// Marker size scale factor.
    MarkerSize(f64),
    /// Polymarker colour index.
    MarkerColour(u32),
    /// Text index.
    TextIndex(u32),
    /// Text font and precision.
    TextFont(i32, Precision),
    /// Character expansion factor.
    CharacterExpansion(f64),
    /// Character spacing.
    CharacterSpacing(f64),
    /// Text colour index.
    TextColour(u32),
    /// Character height vector and width vector.
    CharacterVectors(Vector<Ndc>, Vector<Ndc>),
    /// Text path.
    TextPath(TextPath),
    /// Text alignment.
    TextAlignment(Horizontal, Vertical),
    /// Fill area index.
    FillIndex(u32),
    /// Fill area interior style.
    InteriorStyle(InteriorStyle),
    /// Fill area style index.
    FillStyle(i32),
    /// Fill area colour index.
    FillColour(u32),
    /// Pattern width vector and height vector.
    PatternVectors(Vector<Ndc>, Vector<Ndc>),
    /// Pattern reference point.
    PatternReference(Point<Ndc>),
    /// Aspect source flags.
    AspectSourceFlags(AspectSourceFlags),
    /// Pick identifier.
    PickIdentifier(i32),
    /// Clipping rectangle.
    ClippingRectangle(Rect<Ndc>),
    /// Line ends; beyond the standard.
    Cap(Cap),
    /// Line corners; beyond the standard.
    Join(Join),
    /// The part of the clipping rectangle that clips; beyond the standard.
    ClipSector(Option<ClipSector>),
}
