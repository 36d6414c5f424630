//! Pictures that are kept to be written again, on workstations of other types; beyond the standard.

use crate::control::open_error;
use crate::gks::device_error;
use crate::{Function, Gks, Result};

impl Gks {
    /// Has a workstation keep what is drawn on it from now on, until it is cleared, for [`Gks::copy_picture`].
    ///
    /// Errors, as of UPDATE WORKSTATION: 7, 20, 25.
    pub fn keep_picture(&mut self, id: i32) -> Result<()> {
        const F: Function = Function::UpdateWorkstation;
        self.check_state(F)?;
        self.workstation_mut(F, id)?.workstation.keep();
        Ok(())
    }

    /// Writes what a workstation keeps and shows now as one picture: opens a workstation of the type `kind`
    /// with a connection, draws and closes it. The workstation itself remains as it is.
    ///
    /// Nothing of what was drawn before [`Gks::keep_picture`] is in the picture, and colours and bundles are
    /// those of now. Errors, as of UPDATE WORKSTATION: 7, 20, 25, 303; as of OPEN WORKSTATION: 21, 23, 26.
    pub fn copy_picture(&mut self, id: i32, connection: &str, kind: i32) -> Result<()> {
        const F: Function = Function::UpdateWorkstation;
        self.check_state(F)?;
        self.workstation(F, id)?;
        let (backend, description) = self.catalogue.open(kind, connection).map_err(|e| open_error(F, &e))?;
        let original = &self.workstation(F, id)?.workstation;
        original.copy_to(backend, description).map_err(|e| device_error(F, &e))
    }
}

#[cfg(test)]
mod tests {
    use crate::test_device::{PLAIN, active, number, open};

    const LINE: [(f64, f64); 2] = [(0.0, 0.0), (1.0, 1.0)];

    #[test]
    fn a_copy_shows_what_was_drawn_since_the_workstation_was_cleared() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.keep_picture(1).unwrap();
        gks.polyline(&LINE[..]).unwrap();
        gks.clear_workstation(1, true).unwrap();
        gks.polyline(&LINE[..]).unwrap();
        gks.polyline(&LINE[..]).unwrap();
        log.take();
        gks.copy_picture(1, "", PLAIN).unwrap();
        assert_eq!(log.marks().len(), 2);
        gks.copy_picture(1, "", PLAIN).unwrap();
        assert_eq!(log.marks().len(), 2, "the picture is still there");
    }

    #[test]
    fn a_copy_that_cannot_be_made_is_reported() {
        let (mut gks, _) = open(&[PLAIN]);
        assert_eq!(number(gks.keep_picture(7)), 25);
        assert_eq!(number(gks.copy_picture(7, "", PLAIN)), 25);
        gks.keep_picture(1).unwrap();
        assert_eq!(number(gks.copy_picture(1, "", 31_999)), 23);
        assert_eq!(number(gks.copy_picture(1, "nonsense", PLAIN)), 21);
        assert_eq!(number(gks.copy_picture(1, "unwritable", PLAIN)), 26);
    }
}
