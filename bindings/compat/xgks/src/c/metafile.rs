//! Metafile items: writing the program's own, reading any, and interpreting them.
//!
//! A program gets items as structures of XGKS, and hands them back as such. The length of an item is that of its
//! structure with all that it points to.

use super::argument::{Address, call, integer};
use super::item;
use super::types::{Ggksmit, Gint};
use gks::{Error, Function};

/// WRITE ITEM TO GKSM.
#[unsafe(no_mangle)]
extern "C" fn gwritegksm(ws_id: Gint, kind: Gint, length: Gint, data: Address<u8>) -> Gint {
    let bytes = data.array(length);
    call(Function::WriteItemToGksm, |gks| gks.write_item_to_gksm_of(ws_id, kind, length, bytes))
}

/// GET ITEM TYPE FROM GKSM.
#[unsafe(no_mangle)]
extern "C" fn ggetgksm(ws_id: Gint, result: Address<Ggksmit>) -> Gint {
    call(Function::GetItemTypeFromGksm, |gks| {
        let (kind, length) = gks.get_item_type_from_gksm(ws_id)?;
        result.set(Ggksmit { kind, length: integer(item::length(kind, length)) });
        Ok(())
    })
}

/// READ ITEM FROM GKSM: at most a number of bytes of it.
#[unsafe(no_mangle)]
extern "C" fn greadgksm(ws_id: Gint, length: Gint, record: Address<u8>) -> Gint {
    const F: Function = Function::ReadItemFromGksm;
    call(F, |gks| {
        // Without an item the error is that there is none, whatever the length is.
        let kind = gks.get_item_type_from_gksm(ws_id).map(|(kind, _)| kind);
        let most = match usize::try_from(length) {
            Err(_) if kind.is_ok() => return Err(Error::new(166, F).because(format!("length {length}"))),
            most => most.unwrap_or(0),
        };
        let data = gks.read_item_from_gksm(ws_id, Gint::MAX)?;
        let unreadable =
            |error: gks_pipeline::record::item::Unreadable| Error::new(163, F).because(error.to_string());
        let bytes = item::structured(kind.unwrap_or(0), &data, record).map_err(unreadable)?;
        record.set_all(bytes.into_iter().take(most));
        Ok(())
    })
}

/// INTERPRET ITEM.
#[unsafe(no_mangle)]
extern "C" fn ginterpret(info: Address<Ggksmit>, data: Address<u8>) -> Gint {
    const F: Function = Function::InterpretItem;
    call(F, |gks| {
        let Ggksmit { kind, length } = info.get(F)?;
        gks.interpret_item(kind, &item::kernel_data(kind, length, data))
    })
}
