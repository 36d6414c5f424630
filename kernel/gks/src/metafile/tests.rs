use crate::test_device::{CATEGORIES, PLAIN, active, closed, number, open};
use gks_pipeline::description::Category;

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
fn only_metafile_workstations_are_served() {
    let (mut gks, _) = active(&[PLAIN]);
    gks.open_workstation(2, "", CATEGORIES + Category::MetafileOutput as i32).unwrap();
    assert_eq!([0, 9, 2, 1].map(|id| number(gks.write_item_to_gksm(id, 101, b"data"))), [20, 30, 30, 32]);
    assert_eq!([0, 9, 1, 2].map(|id| number(gks.get_item_type_from_gksm(id))), [20, 25, 34, 34]);
    assert_eq!([0, 9, 1, 2].map(|id| number(gks.read_item_from_gksm(id, 80))), [20, 25, 34, 34]);
    gks.activate_workstation(2).unwrap();
    assert_eq!([-1, 0, 11, 100].map(|kind| number(gks.write_item_to_gksm(2, kind, b""))), [160; 4]);
    assert_eq!([-1, 5].map(|length| number(gks.write_item_to_gksm_of(2, 101, length, b"data"))), [161; 2]);
    assert_eq!(gks.write_item_to_gksm_of(2, 101, 4, b"data"), Ok(()));
}

#[test]
fn items_are_checked_before_they_are_interpreted() {
    let (mut gks, _) = active(&[PLAIN]);
    assert_eq!([-1, 7, 100].map(|kind| number(gks.interpret_item(kind, b""))), [164; 3]);
    assert_eq!([101, i32::MAX].map(|kind| number(gks.interpret_item(kind, b""))), [167; 2]);
    assert_eq!([1, 11, 56].map(|kind| number(gks.interpret_item(kind, b"abc"))), [161; 3]);
    assert_eq!(number(gks.interpret_item(1, &2_i32.to_le_bytes())), 165);
    assert_eq!(number(gks.interpret_item(21, &0_i32.to_le_bytes())), 165);
    assert_eq!(gks.interpret_item(21, &7_i32.to_le_bytes()), Ok(()));
    assert_eq!(gks.inquire_polyline_index(), Ok(7));
    assert_eq!(gks.interpret_item(0, b""), Ok(()));
}
