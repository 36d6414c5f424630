//! Wrong calls of the functions about metafiles.

use super::provocations::{Provocation, meets};
use super::situation::of_category;
use gks::Function::{GetItemTypeFromGksm, InterpretItem, ReadItemFromGksm, WriteItemToGksm};
use gks::Gks;
use gks_pipeline::description::Category;

const MO: i32 = of_category(Category::MetafileOutput);
const MI: i32 = of_category(Category::MetafileInput);

fn activate(gks: &mut Gks) {
    gks.activate_workstation(MO).expect("it is open and not active");
}

/// Passes over the only item of the metafile that is read, which makes no sense.
fn pass(gks: &mut Gks) {
    assert_eq!(gks.read_item_from_gksm(MI, 80).map_err(|error| error.number), Err(163));
}

/// The same and END ITEM.
fn pass_all(gks: &mut Gks) {
    pass(gks);
    assert_eq!(gks.get_item_type_from_gksm(MI), Ok((0, 0)));
    assert_eq!(gks.read_item_from_gksm(MI, 80), Ok(Vec::new()));
}

/// Wrong arguments, and metafiles that make no sense.
pub(crate) static PROVOCATIONS: &[Provocation] = &[
    meets(160, WriteItemToGksm, |g, id| g.write_item_to_gksm(id, 100, b"data")).about(MO).after(activate),
    meets(160, WriteItemToGksm, |g, id| g.write_item_to_gksm(id, -1, b"")).about(MO).after(activate),
    meets(161, WriteItemToGksm, |g, id| g.write_item_to_gksm_of(id, 101, -1, b"")).about(MO).after(activate),
    meets(161, WriteItemToGksm, |g, id| g.write_item_to_gksm_of(id, 101, 5, b"data"))
        .about(MO)
        .after(activate),
    meets(162, GetItemTypeFromGksm, |g, id| g.get_item_type_from_gksm(id).map(drop))
        .about(MI)
        .after(pass_all),
    meets(163, GetItemTypeFromGksm, |g, id| g.get_item_type_from_gksm(id).map(drop)).about(MI),
    meets(162, ReadItemFromGksm, |g, id| g.read_item_from_gksm(id, 80).map(drop)).about(MI).after(pass_all),
    meets(163, ReadItemFromGksm, |g, id| g.read_item_from_gksm(id, 80).map(drop)).about(MI),
    meets(166, ReadItemFromGksm, |g, id| g.read_item_from_gksm(id, -1).map(drop)).about(MI).after(pass),
    meets(161, InterpretItem, |g, _| g.interpret_item_of(3, -1, &[1, 0, 0, 0])),
    meets(161, InterpretItem, |g, _| g.interpret_item_of(3, 5, &[1, 0, 0, 0])),
    meets(161, InterpretItem, |g, _| g.interpret_item(3, &[1, 0, 0])),
    meets(161, InterpretItem, |g, _| g.interpret_item(11, &[255, 255, 255, 127, 0, 0])),
    meets(164, InterpretItem, |g, _| g.interpret_item(7, &[])),
    meets(164, InterpretItem, |g, _| g.interpret_item(-1, &[])),
    meets(165, InterpretItem, |g, _| g.interpret_item(3, &[2, 0, 0, 0])),
    meets(165, InterpretItem, |g, _| g.interpret_item(21, &[0, 0, 0, 0])),
    meets(167, InterpretItem, |g, _| g.interpret_item(101, b"data")),
    meets(165, InterpretItem, |g, _| g.interpret_item(82, &[])),
];
