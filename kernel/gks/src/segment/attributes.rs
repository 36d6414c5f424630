//! Segment attributes.

use crate::attributes::NOT_A_NUMBER;
use crate::{Error, Function, Gks, Result};
use gks_geometry::Map;
use gks_pipeline::record::Record;
use gks_pipeline::segment::Segment;

macro_rules! pair {
    ($(#[$doc:meta])* $name:ident { $(#[$first_doc:meta])* $first:ident, $(#[$second_doc:meta])* $second:ident }) => {
        $(#[$doc])*
        #[derive(Copy, Clone, Debug, PartialEq, Eq)]
        #[repr(i32)]
        pub enum $name {
            $(#[$first_doc])*
            $first = 0,
            $(#[$second_doc])*
            $second = 1,
        }

        impl $name {
            /// The value with the number that the language bindings use, or none for another number.
            pub const fn from_number(number: i32) -> Option<Self> {
                match number {
                    0 => Some($name::$first),
                    1 => Some($name::$second),
                    _ => None,
                }
            }
        }

        impl From<bool> for $name {
            fn from(second: bool) -> Self {
                if second { $name::$second } else { $name::$first }
            }
        }
    };
}

pair! {
    /// Whether a segment is shown.
    Visibility {
        /// It is not.
        Invisible,
        /// It is.
        Visible
    }
}

pair! {
    /// Whether a segment that is shown stands out.
    Highlighting {
        /// It does not.
        Normal,
        /// It does: in the highlighting colour, colour index 15, a band runs along all that is drawn.
        Highlighted
    }
}

pair! {
    /// Whether a segment that is shown can be picked.
    Detectability {
        /// It cannot.
        Undetectable,
        /// It can.
        Detectable
    }
}

/// The attributes of a segment.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct SegmentAttributes {
    /// Rows of the segment transformation, in NDC.
    pub transformation: [[f64; 3]; 2],
    /// Visibility.
    pub visibility: Visibility,
    /// Highlighting.
    pub highlighting: Highlighting,
    /// Priority, from 0 to 1: what has the higher one is in front.
    pub priority: f64,
    /// Detectability.
    pub detectability: Detectability,
}

impl Gks {
    /// SET SEGMENT TRANSFORMATION: maps all primitives of a segment, from NDC to NDC. It takes the place of the
    /// one before, and moves no clipping rectangle.
    ///
    /// Errors: 7, 120 (name not positive), 122 (no such segment), 303, 308 (a number is not finite).
    pub fn set_segment_transformation(&mut self, name: i32, matrix: [[f64; 3]; 2]) -> Result<()> {
        const F: Function = Function::SetSegmentTransformation;
        self.check_state(F)?;
        let old = self.segment(F, name)?.appearance.transformation;
        if !matrix.as_flattened().iter().all(|v| v.is_finite()) {
            return Err(Error::new(NOT_A_NUMBER, F));
        }
        let new = Map::from_rows(matrix);
        let seen = if old == new { Vec::new() } else { self.shown_on(name) };
        let record = Record::SegmentTransformation(name, new);
        let changed = self.change(F, name, &record, |segment| segment.appearance.transformation = new);
        self.show_change(F, seen, |how| how.transformation).and(changed)
    }

    /// SET VISIBILITY. Errors: 7, 120 (name not positive), 122 (no such segment), 303.
    pub fn set_visibility(&mut self, name: i32, visibility: Visibility) -> Result<()> {
        const F: Function = Function::SetVisibility;
        self.check_state(F)?;
        let old = self.segment(F, name)?.visible;
        let visible = visibility == Visibility::Visible;
        let before = self.shown_on(name);
        let changed =
            self.change(F, name, &Record::Visibility(name, visible), |segment| segment.visible = visible);
        match (old, visible) {
            (true, false) => self.show_change(F, before, |how| how.disappearing).and(changed),
            (false, true) => self.appear(F, name, self.shown_on(name)).and(changed),
            _ => changed,
        }
    }

    /// SET HIGHLIGHTING: it is seen while the segment is visible.
    ///
    /// Errors: 7, 120 (name not positive), 122 (no such segment), 303.
    pub fn set_highlighting(&mut self, name: i32, highlighting: Highlighting) -> Result<()> {
        const F: Function = Function::SetHighlighting;
        self.check_state(F)?;
        let new = highlighting == Highlighting::Highlighted;
        let old = self.segment(F, name)?.appearance.highlighted;
        let seen = if old == new { Vec::new() } else { self.shown_on(name) };
        let record = Record::Highlighting(name, new);
        let changed = self.change(F, name, &record, |segment| segment.appearance.highlighted = new);
        self.show_change(F, seen, |how| how.highlighting).and(changed)
    }

    /// SET SEGMENT PRIORITY: of segments that overlap, the one with the higher priority is in front; of equal
    /// ones that which was created later.
    ///
    /// Errors: 7, 120 (name not positive), 122 (no such segment), 126 (not from 0 to 1), 303.
    pub fn set_segment_priority(&mut self, name: i32, priority: f64) -> Result<()> {
        const F: Function = Function::SetSegmentPriority;
        self.check_state(F)?;
        let old = self.segment(F, name)?.priority();
        if !(0.0..=1.0).contains(&priority) {
            return Err(Error::new(126, F).because(format!("priority {priority}")));
        }
        let seen = if old == priority { Vec::new() } else { self.shown_on(name) };
        self.segments.set_priority(name, priority);
        let recorded = self.record(F, name, &Record::SegmentPriority(name, priority));
        self.show_change(F, seen, |how| how.priority).and(recorded)
    }

    /// SET DETECTABILITY: a segment that is detectable and visible can be picked.
    ///
    /// Errors: 7, 120 (name not positive), 122 (no such segment), 303.
    pub fn set_detectability(&mut self, name: i32, detectability: Detectability) -> Result<()> {
        const F: Function = Function::SetDetectability;
        self.check_state(F)?;
        self.segment(F, name)?;
        let new = detectability == Detectability::Detectable;
        self.change(F, name, &Record::Detectability(name, new), |segment| segment.detectable = new)
    }

    /// Changes a segment and tells its metafiles.
    fn change(
        &mut self,
        function: Function,
        name: i32,
        record: &Record<'_>,
        set: impl FnOnce(&mut Segment),
    ) -> Result<()> {
        if let Some(segment) = self.segments.get_mut(name) {
            set(segment);
        }
        self.record(function, name, record)
    }

    /// The workstations on which something is to be seen of a segment.
    pub(super) fn shown_on(&self, name: i32) -> Vec<i32> {
        let shown = self.segments.get(name).is_some_and(Segment::is_shown);
        if shown { self.of_segment(name) } else { Vec::new() }
    }
}
