//! Metafile items: writing an application's own, reading any, and interpreting them.

mod current;
mod interpretation;

pub(crate) use current::Items;

use crate::gks::device_error;
use crate::{Error, Function, Gks, Result};
use gks_pipeline::description::Category;
use gks_pipeline::record::item::{Bytes, Decoder, Unreadable, kind};
use gks_pipeline::record::{Record, Source, SourceError};

impl Gks {
    /// WRITE ITEM TO GKSM: writes an application's own item to a metafile.
    ///
    /// Errors: 5, 20, 30 (not active), 32 (not a metafile output workstation), 160 (type not above 100), 303.
    pub fn write_item_to_gksm(&mut self, id: i32, kind: i32, data: &[u8]) -> Result<()> {
        self.write_item(id, kind, Some(data))
    }

    /// WRITE ITEM TO GKSM for data as bindings have them: the first `length` of some bytes.
    ///
    /// Errors: as [`Gks::write_item_to_gksm`], and 161 (a negative length, or one beyond the bytes).
    pub fn write_item_to_gksm_of(&mut self, id: i32, kind: i32, length: i32, bytes: &[u8]) -> Result<()> {
        self.write_item(id, kind, part(length, bytes))
    }

    fn write_item(&mut self, id: i32, kind: i32, data: Option<&[u8]>) -> Result<()> {
        const F: Function = Function::WriteItemToGksm;
        self.check_state(F)?;
        let identified = |number| Error::new(number, F).because(format!("workstation identifier {id}"));
        if id < 1 {
            return Err(identified(20));
        }
        let Some(open) = self.workstations.get_mut(&id).filter(|open| open.active) else {
            return Err(identified(30));
        };
        if open.workstation.description().category != Category::MetafileOutput {
            return Err(identified(32));
        }
        if kind <= kind::LAST {
            return Err(Error::new(160, F).because(format!("item type {kind}")));
        }
        let data = data.ok_or_else(|| Error::new(161, F))?;
        open.workstation.control(&Record::User(kind, data)).map_err(|e| device_error(F, &e))
    }

    /// GET ITEM TYPE FROM GKSM: type and length of the current item of a metafile.
    ///
    /// Items are coded as [`gks_pipeline::record::item`] says, whatever the format of the metafile is. After
    /// the last one comes an item of type 0, END ITEM. Errors: 7, 20, 25, 34 (not a metafile input
    /// workstation), 162 (no item is left), 163 (the item makes no sense), 302.
    pub fn get_item_type_from_gksm(&mut self, id: i32) -> Result<(i32, usize)> {
        const F: Function = Function::GetItemTypeFromGksm;
        let (items, source) = self.metafile_input(F, id)?;
        match items.current(source) {
            Some(Ok((kind, data))) => Ok((*kind, data.len())),
            Some(Err(error)) => Err(of_source(F, error)),
            None => Err(Error::new(162, F)),
        }
    }

    /// READ ITEM FROM GKSM: the data of the current item of a metafile, at most `max_length` bytes of them.
    /// The next item becomes the current one.
    ///
    /// Errors: 7, 20, 25, 34 (not a metafile input workstation), 162 (no item is left), 163 (the item makes no
    /// sense, and is passed over), 166 (a negative length), 302.
    pub fn read_item_from_gksm(&mut self, id: i32, max_length: i32) -> Result<Vec<u8>> {
        const F: Function = Function::ReadItemFromGksm;
        let (items, source) = self.metafile_input(F, id)?;
        match items.current(source) {
            None => return Err(Error::new(162, F)),
            Some(Err(error)) => {
                let error = of_source(F, error);
                items.pass();
                return Err(error);
            }
            Some(Ok(_)) => {}
        }
        let most = usize::try_from(max_length)
            .map_err(|_| Error::new(166, F).because(format!("length {max_length}")))?;
        let mut data = items.pass();
        data.truncate(most);
        Ok(data)
    }

    /// INTERPRET ITEM: does what an item of a metafile stands for, as [`Gks::interpret`] does. END ITEM stands
    /// for nothing.
    ///
    /// Errors: 7, 161 (too short for its type), 164 (no item type of GKS), 165 (a value that makes no sense),
    /// 167 (an application's own item, type above 100), 303, 304.
    pub fn interpret_item(&mut self, kind: i32, data: &[u8]) -> Result<()> {
        self.interpret_part(kind, Some(data))
    }

    /// INTERPRET ITEM for data as bindings have them: the first `length` of some bytes.
    ///
    /// Errors: as [`Gks::interpret_item`], and 161 (a negative length, or one beyond the bytes).
    pub fn interpret_item_of(&mut self, kind: i32, length: i32, bytes: &[u8]) -> Result<()> {
        self.interpret_part(kind, part(length, bytes))
    }

    fn interpret_part(&mut self, kind: i32, data: Option<&[u8]>) -> Result<()> {
        const F: Function = Function::InterpretItem;
        self.check_state(F)?;
        let data = data.ok_or_else(|| Error::new(161, F))?;
        let mut decoder = Decoder::default();
        let decoded = decoder.decode(kind, &mut Bytes::new(data)).map_err(|error| {
            let number = match error {
                Unreadable::Short => 161,
                Unreadable::Value(_) => 165,
                Unreadable::Kind(_) => 164,
            };
            Error::new(number, F).because(format!("item type {kind}: {error}"))
        })?;
        match decoded {
            Some(record) => self.interpret(&record),
            None => Ok(()),
        }
    }

    /// The items of a metafile that is read, and where more come from. Errors: 20, 25, 34.
    fn metafile_input(
        &mut self,
        function: Function,
        id: i32,
    ) -> Result<(&mut Items, Option<&mut (dyn Source + 'static)>)> {
        self.check_state(function)?;
        let open = self.workstation_mut(function, id)?;
        if open.workstation.description().category != Category::MetafileInput {
            return Err(Error::new(34, function).because(format!("workstation identifier {id}")));
        }
        Ok((&mut open.items, open.workstation.source()))
    }
}

/// The first `length` bytes, if there are as many.
fn part(length: i32, bytes: &[u8]) -> Option<&[u8]> {
    bytes.get(..usize::try_from(length).ok()?)
}

fn of_source(function: Function, error: &SourceError) -> Error {
    let number = match error {
        SourceError::Io(_) => 302,
        SourceError::Malformed { .. } => 163,
    };
    Error::new(number, function).because(error.to_string())
}

#[cfg(test)]
mod tests;
