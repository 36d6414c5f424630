//! Metafile items.

use crate::argument::{In, Out, array, call, integer};
use crate::types::{Gint, Gitem_data};
use gks::Function;

/// The bytes that an item has.
fn bytes<'a>(item: In<Gitem_data>) -> &'a [u8] {
    item.get().map_or(&[], |item| array(item.data.data.cast(), integer(item.data.size)))
}

/// WRITE ITEM TO GKSM.
#[unsafe(no_mangle)]
extern "C" fn gwrite_item(ws_id: Gint, item_type: Gint, item_data_length: Gint, item_data: In<Gitem_data>) {
    let data = bytes(item_data);
    call(Function::WriteItemToGksm, |gks| {
        gks.write_item_to_gksm_of(ws_id, item_type, item_data_length, data)
    });
}

/// GET ITEM TYPE FROM GKSM.
#[unsafe(no_mangle)]
extern "C" fn gget_item_type(ws_id: Gint, item_type: Out<Gint>, item_data_length: Out<Gint>) {
    call(Function::GetItemTypeFromGksm, |gks| {
        let (kind, length) = gks.get_item_type_from_gksm(ws_id)?;
        item_type.set(kind);
        item_data_length.set(integer(length));
        Ok(())
    });
}

/// READ ITEM FROM GKSM. The data go where the program's `impl_dep` points, as far as there is room.
#[unsafe(no_mangle)]
extern "C" fn gread_item(ws_id: Gint, max_item_data_length: Gint, item_data: Out<Gitem_data>) {
    // SAFETY: the addresses of members of a structure that is there.
    let (length, data) = unsafe {
        (item_data.member(|item| &raw mut (*item).length), item_data.member(|item| &raw mut (*item).data))
    };
    call(Function::ReadItemFromGksm, |gks| {
        let bytes = gks.read_item_from_gksm(ws_id, max_item_data_length)?;
        length.set(integer(bytes.len()));
        // SAFETY: as above.
        let (room, to) =
            unsafe { (data.member(|data| &raw mut (*data).size), data.member(|data| &raw mut (*data).data)) };
        let room = room.get().unwrap_or(0);
        to.target().cast::<u8>().set_all(bytes.into_iter().take(room));
        Ok(())
    });
}

/// INTERPRET ITEM.
#[unsafe(no_mangle)]
extern "C" fn ginterpret_item(r#type: Gint, item_data_length: Gint, item_data: In<Gitem_data>) {
    let data = bytes(item_data);
    call(Function::InterpretItem, |gks| gks.interpret_item_of(r#type, item_data_length, data));
}
