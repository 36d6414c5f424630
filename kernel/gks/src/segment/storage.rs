//! Workstation independent segment storage: segments taken from it to workstations and into other segments.

use super::named;
use crate::attributes::NOT_A_NUMBER;
use crate::gks::{Target, device_error};
use crate::{Error, Function, Gks, Result};
use gks_geometry::Map;
use gks_pipeline::record::Record;
use gks_pipeline::segment::Appearance;

impl Gks {
    /// ASSOCIATE SEGMENT WITH WORKSTATION: a segment of the segment storage is on the workstation too, as if
    /// the workstation had been active when it was created.
    ///
    /// Errors: 6, 20, 25, 27 (no segment storage is open), 33, 35, 120 (name not positive), 124 (not in the
    /// segment storage), 303.
    pub fn associate_segment_with_workstation(&mut self, id: i32, name: i32) -> Result<()> {
        const F: Function = Function::AssociateSegmentWithWorkstation;
        self.check_state(F)?;
        self.workstation(F, id)?;
        let storage = self.needed_storage(F)?;
        self.suitable_workstation(F, id)?;
        self.stored(F, storage, name)?;
        if !self.segments.associate(name, id) {
            return Ok(());
        }
        let recorded = self.record_whole(F, id, name);
        let shown = self.shown_on(name).into_iter().filter(|&on| on == id).collect::<Vec<_>>();
        self.appear(F, name, shown).and(recorded)
    }

    /// COPY SEGMENT TO WORKSTATION: draws the primitives of a segment of the segment storage, with its segment
    /// transformation and their own clipping rectangles and attributes, in no segment.
    ///
    /// The workstation need not be active; visibility and highlighting do not matter. Errors: 6, 20, 25, 27
    /// (no segment storage is open), 33, 35, 36, 120 (name not positive), 124 (not in the segment storage), 303.
    pub fn copy_segment_to_workstation(&mut self, id: i32, name: i32) -> Result<()> {
        const F: Function = Function::CopySegmentToWorkstation;
        self.check_state(F)?;
        self.workstation(F, id)?;
        let storage = self.needed_storage(F)?;
        self.suitable_workstation(F, id)?;
        self.stored(F, storage, name)?;
        let due = self.workstations.get(&id).is_some_and(|open| open.workstation.is_regeneration_due());
        let regenerated = if due { self.regenerate(F, id) } else { Ok(()) };
        let Some((segment, open)) = self.segments.get(name).zip(self.workstations.get_mut(&id)) else {
            return regenerated;
        };
        regenerated.and(open.workstation.copy_segment(segment).map_err(|e| device_error(F, &e)))
    }

    /// INSERT SEGMENT: draws the primitives of a segment of the segment storage on all active workstations and
    /// puts them into the open segment, if there is one.
    ///
    /// They are mapped by the segment transformation of the segment and then by `matrix`, in NDC, and keep
    /// their attributes and pick identifiers; they are clipped at the current clipping rectangle instead of
    /// their own. Errors: 5, 27 (no segment storage is open), 120 (name not positive), 124 (not in the segment
    /// storage), 125 (open), 303, 308 (a number is not finite).
    pub fn insert_segment(&mut self, name: i32, matrix: [[f64; 3]; 2]) -> Result<()> {
        const F: Function = Function::InsertSegment;
        self.check_state(F)?;
        let storage = self.needed_storage(F)?;
        self.stored(F, storage, name)?;
        self.check_closed(F, name)?;
        if !matrix.as_flattened().iter().all(|v| v.is_finite()) {
            return Err(Error::new(NOT_A_NUMBER, F));
        }
        let Some(segment) = self.segments.get(name) else { return Ok(()) };
        let map = segment.appearance.transformation.then(&Map::from_rows(matrix));
        let inserted = segment.recording.mapped(&map, self.normalization.clip, self.look.clip_sector);
        let mut done = Ok(());
        for item in &inserted {
            let target = Target {
                workstations: &mut self.workstations,
                segments: &mut self.segments,
                open_segment: self.open_segment,
            };
            // A device that fails does not keep the others from drawing.
            done = done.and(target.draw(F, &item));
        }
        done
    }

    /// The workstation that is segment storage. Error: 27.
    fn needed_storage(&self, function: Function) -> Result<i32> {
        self.storage().ok_or_else(|| Error::new(27, function))
    }

    /// Checks that a segment is in the segment storage. Errors: 120, 124.
    fn stored(&self, function: Function, storage: i32, name: i32) -> Result<()> {
        self.check_name(function, name)?;
        match self.segments.get(name) {
            Some(segment) if segment.workstations().contains(&storage) => Ok(()),
            _ => Err(named(function, 124, name)),
        }
    }

    /// Tells a workstation, if it is a metafile that is written, all about a segment.
    fn record_whole(&mut self, function: Function, id: i32, name: i32) -> Result<()> {
        let Some((segment, open)) = self.segments.get(name).zip(self.workstations.get_mut(&id)) else {
            return Ok(());
        };
        let workstation = &mut open.workstation;
        if !workstation.has_segments() {
            return Ok(());
        }
        let Appearance { transformation, highlighted } = segment.appearance;
        let mut write = || {
            workstation.control(&Record::CreateSegment(name))?;
            workstation.control(&Record::SegmentTransformation(name, transformation))?;
            workstation.control(&Record::Visibility(name, segment.visible))?;
            workstation.control(&Record::Highlighting(name, highlighted))?;
            workstation.control(&Record::SegmentPriority(name, segment.priority()))?;
            workstation.control(&Record::Detectability(name, segment.detectable))?;
            workstation.draw_segment(segment)?;
            workstation.control(&Record::CloseSegment)
        };
        write().map_err(|e| device_error(function, &e))
    }
}
