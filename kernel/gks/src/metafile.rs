//! Metafile items.
//!
//! No workstation of category MO or MI can be opened, so that no workstation identifier is one for these
//! functions, and no item can be interpreted.

use crate::{Error, Function, Gks, Result};

impl Gks {
    /// WRITE ITEM TO GKSM: writes an application's own item to a metafile.
    ///
    /// Errors: 5, 20, 30 (not active), 32 (not a metafile output workstation).
    pub fn write_item_to_gksm(&mut self, id: i32, _kind: i32, _data: &[u8]) -> Result<()> {
        const F: Function = Function::WriteItemToGksm;
        self.check_state(F)?;
        let identified = |number| Error::new(number, F).because(format!("workstation identifier {id}"));
        if id < 1 {
            return Err(identified(20));
        }
        if !self.workstations.get(&id).is_some_and(|open| open.active) {
            return Err(identified(30));
        }
        Err(identified(32))
    }

    /// GET ITEM TYPE FROM GKSM: type and length of the current item of a metafile.
    ///
    /// Errors: 7, 20, 25, 34 (not a metafile input workstation).
    pub fn get_item_type_from_gksm(&mut self, id: i32) -> Result<(i32, usize)> {
        Err(self.no_metafile_input(Function::GetItemTypeFromGksm, id))
    }

    /// READ ITEM FROM GKSM: the data of the current item of a metafile, at most `max_length` bytes of them.
    ///
    /// Errors: 7, 20, 25, 34 (not a metafile input workstation).
    pub fn read_item_from_gksm(&mut self, id: i32, _max_length: usize) -> Result<Vec<u8>> {
        Err(self.no_metafile_input(Function::ReadItemFromGksm, id))
    }

    /// INTERPRET ITEM: does what an item of a metafile stands for.
    ///
    /// Errors: 7, 164 (no item type of GKS), 167 (an application's own item, type above 100), 168 (any
    /// other).
    pub fn interpret_item(&mut self, kind: i32, _data: &[u8]) -> Result<()> {
        const F: Function = Function::InterpretItem;
        self.check_state(F)?;
        let number = match kind {
            ..0 => 164,
            0..=100 => 168,
            _ => 167,
        };
        Err(Error::new(number, F).because(format!("item type {kind}")))
    }

    fn no_metafile_input(&self, function: Function, id: i32) -> Error {
        let open = self.check_state(function).and_then(|()| self.workstation(function, id));
        match open {
            Ok(_) => Error::new(34, function).because(format!("workstation identifier {id}")),
            Err(error) => error,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::test_device::{PLAIN, active, closed, number, open};

    #[test]
    fn states_come_first() {
        let mut gks = closed();
        assert_eq!(number(gks.write_item_to_gksm(0, 0, b"")), 5);
        assert_eq!(number(gks.get_item_type_from_gksm(0)), 7);
        assert_eq!(number(gks.read_item_from_gksm(0, 80)), 7);
        assert_eq!(number(gks.interpret_item(-1, b"")), 7);
        assert_eq!(number(open(&[PLAIN]).0.write_item_to_gksm(0, 0, b"")), 5);
    }

    #[test]
    fn no_workstation_is_a_metafile() {
        let (mut gks, _) = active(&[PLAIN]);
        gks.open_workstation(2, "", PLAIN).unwrap();
        assert_eq!([0, 9, 2, 1].map(|id| number(gks.write_item_to_gksm(id, 101, b"data"))), [20, 30, 30, 32]);
        assert_eq!([0, 9, 1].map(|id| number(gks.get_item_type_from_gksm(id))), [20, 25, 34]);
        assert_eq!([0, 9, 1].map(|id| number(gks.read_item_from_gksm(id, 80))), [20, 25, 34]);
        assert_eq!([-1, 0, 11, 101].map(|kind| number(gks.interpret_item(kind, b""))), [164, 168, 168, 167]);
    }
}
