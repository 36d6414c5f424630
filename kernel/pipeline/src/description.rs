//! The workstation description table: what a type of workstation is able to do.

use crate::device::Surface;
use crate::generated::numbers;
use crate::look::enumeration;
use crate::workstation::Backend;

enumeration! {
    /// What a workstation is for.
    Category {
        /// Draws.
        Output = 0,
        /// Reads.
        Input = 1,
        /// Draws and reads.
        OutIn = 2,
        /// Workstation-independent segment storage.
        Wiss = 3,
        /// Metafile output.
        MetafileOutput = 4,
        /// Metafile input.
        MetafileInput = 5,
    }
}

enumeration! {
    /// How a display surface is made.
    Classification {
        /// By lines.
        Vector = 0,
        /// By pixels.
        Raster = 1,
        /// In another way.
        Other = 2,
    }
}

enumeration! {
    /// When output may be delayed.
    DeferralMode {
        /// As soon as possible.
        Asap = 0,
        /// Before the next interaction globally.
        Bnig = 1,
        /// Before the next interaction locally.
        Bnil = 2,
        /// At some time.
        Asti = 3,
    }
}

enumeration! {
    /// Whether a change that cannot be shown at once may redraw the picture unasked.
    RegenerationMode {
        /// Only on demand.
        Suppressed = 0,
        /// At once.
        Allowed = 1,
    }
}

enumeration! {
    /// How a change of a workstation attribute becomes visible.
    DynamicModification {
        /// By an implicit regeneration.
        Irg = 0,
        /// Immediately.
        Imm = 1,
    }
}

/// How what is drawn already comes to look different when a workstation attribute is changed, in the order of the inquiry.
/// What is drawn later has the new attributes in any case.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct DynamicModifications {
    /// Polyline bundles.
    pub line_bundles: DynamicModification,
    /// Polymarker bundles.
    pub marker_bundles: DynamicModification,
    /// Text bundles.
    pub text_bundles: DynamicModification,
    /// Fill area bundles.
    pub fill_bundles: DynamicModification,
    /// Patterns.
    pub patterns: DynamicModification,
    /// Colours.
    pub colours: DynamicModification,
    /// Workstation transformation.
    pub transformation: DynamicModification,
}

impl DynamicModifications {
    /// Of a device that cannot change what it has drawn.
    pub const REDRAWN: DynamicModifications = DynamicModifications {
        line_bundles: DynamicModification::Irg,
        marker_bundles: DynamicModification::Irg,
        text_bundles: DynamicModification::Irg,
        fill_bundles: DynamicModification::Irg,
        patterns: DynamicModification::Irg,
        colours: DynamicModification::Irg,
        transformation: DynamicModification::Irg,
    };
}

/// How changes of segments become visible, in the order of the inquiry.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct SegmentModifications {
    /// Segment transformation.
    pub transformation: DynamicModification,
    /// Visible segments that become invisible.
    pub disappearing: DynamicModification,
    /// Invisible segments that become visible.
    pub appearing: DynamicModification,
    /// Highlighting.
    pub highlighting: DynamicModification,
    /// Segment priority.
    pub priority: DynamicModification,
    /// Primitives added to the open segment where one of higher priority covers them.
    pub adding: DynamicModification,
    /// Deletion.
    pub deletion: DynamicModification,
}

impl SegmentModifications {
    /// Of a device that cannot take back what it has drawn: only what is added on top appears at once.
    pub const REDRAWN: SegmentModifications = SegmentModifications {
        transformation: DynamicModification::Irg,
        disappearing: DynamicModification::Irg,
        appearing: DynamicModification::Imm,
        highlighting: DynamicModification::Irg,
        priority: DynamicModification::Irg,
        adding: DynamicModification::Imm,
        deletion: DynamicModification::Irg,
    };
}

/// The description of one workstation type. What all types share (linetypes, markers, fonts, predefined
/// bundles) is in the generated numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// The workstation type.
    pub number: i32,
    /// The name by which a user chooses the type.
    pub name: &'static str,
    /// What the workstation is for.
    pub category: Category,
    /// How the surface is made.
    pub classification: Classification,
    /// The display surface, at the size that OPEN WORKSTATION gave it or the default one.
    pub surface: Surface,
    /// Number of columns and rows of addressable positions.
    pub raster: (u32, u32),
    /// Number of colours that can be shown at the same time; 0 for a continuous range.
    pub colours: u32,
    /// How changes become visible.
    pub dynamic: DynamicModifications,
    /// Deferral mode when opened.
    pub deferral: DeferralMode,
    /// Implicit regeneration mode when opened.
    pub regeneration: RegenerationMode,
    /// How changes of segments become visible.
    pub segments: SegmentModifications,
    /// Numbers of logical input devices: locators, strokes, valuators, choices, picks, strings.
    pub input: [u32; 6],
}

impl Description {
    /// The size of the display surface in metres.
    pub fn size(&self) -> (f64, f64) {
        (self.surface.width * self.surface.unit, self.surface.height * self.surface.unit)
    }

    /// The number of colour indices, which count from 0.
    pub fn colour_table_length(&self) -> u32 {
        match self.colours {
            0 => numbers::MAX_COLOURS,
            colours => colours,
        }
    }
}

/// Why a workstation could not be opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// The installation has no workstation type with this number.
    #[error("no workstation type {0}")]
    NoSuchType(i32),
    /// The connection identifier or one of its options makes no sense.
    #[error("connection \"{0}\": {1}")]
    Connection(String, String),
    /// The device or file could not be opened.
    #[error("{0}")]
    CannotOpen(String),
}

/// The workstation types of an installation. The kernel knows no driver: it opens workstations through
/// this interface.
pub trait Catalogue: Send {
    /// The numbers of all types, in increasing order.
    fn types(&self) -> Vec<i32>;

    /// The description of a type as it is before a workstation of it is opened, if there is such a type.
    fn describe(&self, number: i32) -> Option<Description>;

    /// Opens a workstation of a type. The description returned is that of the one opened.
    fn open(&mut self, number: i32, connection: &str) -> Result<(Backend, Description), OpenError>;
}
