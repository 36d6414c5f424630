//! Segments: creation, deletion and names.
//!
//! All segments are in one store ([`gks_pipeline::segment::Segments`]); workstations draw from it. A metafile
//! that is written keeps its segments itself, so that it is told what happens to them.

mod attributes;
mod storage;

pub use attributes::{Detectability, Highlighting, SegmentAttributes, Visibility};

use crate::gks::{OpenSegment, OpenWorkstation, device_error};
use crate::{Error, Function, Gks, OperatingState, Result};
use gks_pipeline::description::{Category, DynamicModification, SegmentModifications};
use gks_pipeline::record::Record;
use gks_pipeline::segment::Segment;

impl Gks {
    /// CREATE SEGMENT: primitives go to the segment from now on. It is associated with the workstations that
    /// are active.
    ///
    /// Errors: 3, 120 (name not positive), 121 (name in use), 303.
    pub fn create_segment(&mut self, name: i32) -> Result<()> {
        const F: Function = Function::CreateSegment;
        self.check_state(F)?;
        self.check_name(F, name)?;
        self.check_free(F, name)?;
        let active = self.workstations.iter().filter(|(_, open)| open.active);
        let stored = active.clone().any(|(_, open)| !open.workstation.has_segments());
        self.segments.create(name, active.map(|(&id, _)| id));
        self.open_segment = Some(OpenSegment { name, stored });
        self.state = OperatingState::Sgop;
        self.record(F, name, &Record::CreateSegment(name))
    }

    /// CLOSE SEGMENT: primitives go to no segment any more. Errors: 4, 303.
    pub fn close_segment(&mut self) -> Result<()> {
        const F: Function = Function::CloseSegment;
        self.check_state(F)?;
        self.end_segment(F)
    }

    pub(crate) fn end_segment(&mut self, function: Function) -> Result<()> {
        self.state = OperatingState::Wsac;
        let Some(OpenSegment { name, .. }) = self.open_segment.take() else { return Ok(()) };
        if let Some(segment) = self.segments.get_mut(name) {
            segment.recording.shrink();
        }
        let recorded = self.record(function, name, &Record::CloseSegment);
        self.of_segment(name).into_iter().fold(recorded, |done, id| done.and(self.settle(function, id)))
    }

    /// RENAME SEGMENT: gives a segment, which may be open, another name.
    ///
    /// Errors: 7, 120 (a name not positive), 121 (new name in use), 122 (no such segment), 303.
    pub fn rename_segment(&mut self, old: i32, new: i32) -> Result<()> {
        const F: Function = Function::RenameSegment;
        self.check_state(F)?;
        self.check_name(F, old)?;
        self.check_name(F, new)?;
        self.check_free(F, new)?;
        self.segment(F, old)?;
        self.segments.rename(old, new);
        if let Some(open) = self.open_segment.as_mut().filter(|open| open.name == old) {
            open.name = new;
        }
        self.record(F, new, &Record::RenameSegment(old, new))
    }

    /// DELETE SEGMENT: deletes a segment on all workstations.
    ///
    /// Errors: 7, 120 (name not positive), 122 (no such segment), 125 (open), 303.
    pub fn delete_segment(&mut self, name: i32) -> Result<()> {
        const F: Function = Function::DeleteSegment;
        self.check_state(F)?;
        self.segment(F, name)?;
        self.check_closed(F, name)?;
        let recorded = self.record(F, name, &Record::DeleteSegment(name));
        let Some(segment) = self.segments.delete(name) else { return recorded };
        let seen = segment.workstations().iter().copied().filter(|_| segment.is_shown());
        self.show_change(F, seen, |how| how.deletion).and(recorded)
    }

    /// DELETE SEGMENT FROM WORKSTATION: deletes a segment on one workstation, and altogether if it is
    /// associated with no other one.
    ///
    /// Errors: 7, 20, 25, 33, 35, 120 (name not positive), 123 (no such segment on the workstation), 125
    /// (open), 303.
    pub fn delete_segment_from_workstation(&mut self, id: i32, name: i32) -> Result<()> {
        const F: Function = Function::DeleteSegmentFromWorkstation;
        self.check_state(F)?;
        self.suitable_workstation(F, id)?;
        self.check_name(F, name)?;
        let associated = self.segments.get(name).filter(|segment| segment.workstations().contains(&id));
        let Some(segment) = associated else { return Err(named(F, 123, name)) };
        let seen = segment.is_shown().then_some(id);
        self.check_closed(F, name)?;
        self.segments.dissociate(name, id);
        let recorded = self.tell(F, id, &Record::DeleteSegment(name));
        self.show_change(F, seen, |how| how.deletion).and(recorded)
    }

    /// Lets workstations show that something of a segment is different or gone. IMM is shown at once, IRG by a
    /// regeneration: made now, deferred, or necessary when the program asks for it.
    fn show_change(
        &mut self,
        function: Function,
        on: impl IntoIterator<Item = i32>,
        how: fn(&SegmentModifications) -> DynamicModification,
    ) -> Result<()> {
        let mut done = Ok(());
        for id in on {
            let Some(OpenWorkstation { workstation, changed, .. }) = self.workstations.get_mut(&id) else {
                continue;
            };
            *changed = true;
            workstation.invalidate();
            let at_once = how(&workstation.description().segments) == DynamicModification::Imm
                && workstation.is_new_frame_necessary();
            let shown = if at_once { self.regenerate(function, id) } else { self.settle(function, id) };
            done = done.and(shown);
        }
        done
    }

    /// Draws a segment on workstations on which it is not drawn: over what is there, unless a segment in front
    /// of it makes that wrong.
    fn appear(
        &mut self,
        function: Function,
        name: i32,
        on: impl IntoIterator<Item = i32> + Clone,
    ) -> Result<()> {
        let mut done = Ok(());
        let mut covered = Vec::new();
        for id in on {
            let Some(OpenWorkstation { workstation, .. }) = self.workstations.get_mut(&id) else { continue };
            let Some(segment) = self.segments.get(name) else { continue };
            let imm = workstation.description().segments.appearing == DynamicModification::Imm;
            if workstation.is_regeneration_due() || workstation.has_segments() {
                continue;
            } else if imm && !self.segments.is_covered(name, id) || workstation.is_empty() {
                done = done.and(workstation.draw_segment(segment).map_err(|e| device_error(function, &e)));
            } else {
                covered.push(id);
            }
        }
        done.and(self.show_change(function, covered, |_| DynamicModification::Irg))
    }

    /// Tells the metafiles among the workstations of a segment.
    fn record(&mut self, function: Function, name: i32, record: &Record<'_>) -> Result<()> {
        let mut done = Ok(());
        for id in self.of_segment(name) {
            done = done.and(self.tell(function, id, record));
        }
        done
    }

    /// Tells a workstation, if it is a metafile that is written.
    fn tell(&mut self, function: Function, id: i32, record: &Record<'_>) -> Result<()> {
        let Some(open) = self.workstations.get_mut(&id) else { return Ok(()) };
        open.workstation.control(record).map_err(|e| device_error(function, &e))
    }

    /// The workstations that a segment is associated with.
    fn of_segment(&self, name: i32) -> Vec<i32> {
        self.segments
            .get(name)
            .map(|segment| segment.workstations().iter().copied().collect())
            .unwrap_or_default()
    }

    /// The segment with a name. Errors: 120, 122.
    pub(crate) fn segment(&self, function: Function, name: i32) -> Result<&Segment> {
        self.check_name(function, name)?;
        self.segments.get(name).ok_or_else(|| named(function, 122, name))
    }

    /// The workstation that is workstation independent segment storage.
    pub(crate) fn storage(&self) -> Option<i32> {
        let wiss = |category| category == Category::Wiss;
        let mut open = self.workstations.iter();
        open.find(|(_, open)| wiss(open.workstation.description().category)).map(|(&id, _)| id)
    }

    /// Checks that a name is one. Error: 120.
    fn check_name(&self, function: Function, name: i32) -> Result<()> {
        if name < self.defaults.first_segment { Err(named(function, 120, name)) } else { Ok(()) }
    }

    fn check_free(&self, function: Function, name: i32) -> Result<()> {
        if self.segments.get(name).is_some() { Err(named(function, 121, name)) } else { Ok(()) }
    }

    fn check_closed(&self, function: Function, name: i32) -> Result<()> {
        if self.open_segment.is_some_and(|open| open.name == name) {
            return Err(named(function, 125, name));
        }
        Ok(())
    }
}

#[cold]
fn named(function: Function, number: i32, name: i32) -> Error {
    Error::new(number, function).because(format!("segment name {name}"))
}

#[cfg(test)]
mod tests;
