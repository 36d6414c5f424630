//! Metafile items.

use crate::argument::{In, Out, array, call, integer};
use crate::types::{Gint, Gitem_data};
use gks::Function;

/// The last item type that is GKS's own.
const LAST_OF_GKS: Gint = 100;

/// The bytes of an application's own item, at most `length`; none of other items.
fn bytes<'a>(item: In<Gitem_data>, kind: Gint, length: Gint) -> &'a [u8] {
    match item.get() {
        Some(item) if kind > LAST_OF_GKS => array(item.data.data.cast(), length.min(integer(item.data.size))),
        _ => &[],
    }
}

/// WRITE ITEM TO GKSM.
#[unsafe(no_mangle)]
extern "C" fn gwrite_item(ws_id: Gint, item_type: Gint, item_data_length: Gint, item_data: In<Gitem_data>) {
    let data = bytes(item_data, item_type, item_data_length);
    call(Function::WriteItemToGksm, |gks| gks.write_item_to_gksm(ws_id, item_type, data));
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
        let most = usize::try_from(max_item_data_length).unwrap_or(0);
        let bytes = gks.read_item_from_gksm(ws_id, most)?;
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
    let data = bytes(item_data, r#type, item_data_length);
    call(Function::InterpretItem, |gks| gks.interpret_item(r#type, data));
}
