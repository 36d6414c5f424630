//! Segments, which versions of CGM before the second do not have: kept, and drawn when their picture ends.

use super::CgmRecorder;
use gks_geometry::{Map, Ndc};
use gks_pipeline::device::DeviceError;
use gks_pipeline::item::Item;
use gks_pipeline::record::Record;
use gks_pipeline::recording::Recording;
use std::collections::BTreeMap;

/// A segment.
#[derive(Clone, Debug)]
struct Segment {
    primitives: Recording,
    map: Map<Ndc, Ndc>,
    visible: bool,
    priority: f64,
}

/// The segments of the workstation.
#[derive(Debug, Default)]
pub(super) struct Segments {
    kept: BTreeMap<i32, Segment>,
    open: Option<i32>,
}

impl Segments {
    /// Keeps a primitive of the open segment; whether there is one.
    pub(super) fn keep(&mut self, item: &Item<'_>) -> bool {
        let segment = self.open.and_then(|name| self.kept.get_mut(&name));
        if let Some(segment) = segment {
            segment.primitives.push(item);
            return true;
        }
        false
    }

    /// Deletes all segments; one that is open goes on without primitives.
    pub(super) fn clear(&mut self) {
        self.kept.retain(|name, _| Some(*name) == self.open);
        for segment in self.kept.values_mut() {
            segment.primitives.clear();
        }
    }

    /// Does what a record about segments says.
    pub(super) fn control(&mut self, record: &Record<'_>) {
        match *record {
            Record::CreateSegment(name) => {
                let new = Segment {
                    primitives: Recording::new(),
                    map: Map::IDENTITY,
                    visible: true,
                    priority: 0.0,
                };
                self.kept.insert(name, new);
                self.open = Some(name);
            }
            Record::CloseSegment => self.open = None,
            Record::RenameSegment(old, new) => {
                if let Some(segment) = self.kept.remove(&old) {
                    self.kept.insert(new, segment);
                }
                if self.open == Some(old) {
                    self.open = Some(new);
                }
            }
            Record::DeleteSegment(name) => {
                self.kept.remove(&name);
            }
            Record::SegmentTransformation(name, map) => self.change(name, |segment| segment.map = map),
            Record::Visibility(name, visible) => self.change(name, |segment| segment.visible = visible),
            Record::SegmentPriority(name, priority) => {
                self.change(name, |segment| segment.priority = priority);
            }
            _ => {}
        }
    }

    fn change(&mut self, name: i32, change: impl FnOnce(&mut Segment)) {
        self.kept.get_mut(&name).map(change);
    }

    /// The primitives to be seen, transformed, segments of higher priority last.
    fn visible(&self) -> Recording {
        let mut shown: Vec<&Segment> = self.kept.values().filter(|segment| segment.visible).collect();
        shown.sort_by(|a, b| a.priority.total_cmp(&b.priority));
        let mut all = Recording::new();
        for segment in shown {
            for item in &segment.primitives {
                all.push_mapped(&item, &segment.map);
            }
        }
        all
    }
}

impl CgmRecorder {
    /// Draws the segments into the picture that ends.
    pub(super) fn draw_segments(&mut self) -> Result<(), DeviceError> {
        let visible = self.segments.visible();
        for item in &visible {
            self.write(&item)?;
        }
        Ok(())
    }
}
