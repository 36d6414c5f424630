//! Metafile items.

use crate::argument::{Character, Integer, integer};
use crate::call::{call, subroutines};
use crate::data_record::{LINE, lines};
use gks::Function;

subroutines! {
    gwitm_(wkid: Integer, type_: Integer, idrl: Integer, ldr: Integer, datrec: Character, _length: usize)
        WriteItemToGksm => |gks| {
            gks.write_item_to_gksm_of(wkid.get(), type_.get(), idrl.get(), data(ldr, datrec))
        };
    giitm_(type_: Integer, idrl: Integer, ldr: Integer, datrec: Character, _length: usize)
        InterpretItem => |gks| gks.interpret_item_of(type_.get(), idrl.get(), data(ldr, datrec));
}

/// The bytes of a data record.
fn data<'a>(ldr: Integer, datrec: Character) -> &'a [u8] {
    lines(ldr, datrec).as_flattened()
}

/// GGTITM: GET ITEM TYPE FROM GKSM.
#[unsafe(no_mangle)]
extern "C" fn ggtitm_(wkid: Integer, type_: Integer, idrl: Integer) {
    let item = call(Function::GetItemTypeFromGksm, |gks| gks.get_item_type_from_gksm(wkid.get()));
    let (kind, length) = item.unwrap_or_default();
    type_.set(kind);
    idrl.set(integer(length));
}

/// GRDITM: READ ITEM FROM GKSM.
#[unsafe(no_mangle)]
extern "C" fn grditm_(wkid: Integer, midrl: Integer, mldr: Integer, datrec: Character, _length: usize) {
    const F: Function = Function::ReadItemFromGksm;
    let room = mldr.count().saturating_mul(LINE);
    let item = call(F, |gks| gks.read_item_from_gksm(wkid.get(), midrl.get()));
    if let Some(data) = item {
        datrec.set_text(room, &data);
    }
}
