//! The situations in which functions are called, and all that can be inquired of one.

use crate::catalogue::{CATEGORIES, DEVICES, FRAME_BUFFER, INDEXED, Log, NULL, OPERATED, Recording};
use gks::{Gks, OperatingMode, OperatingState, Result, ValueType};
use gks_pipeline::description::Category;

/// A workstation of type [`FRAME_BUFFER`], active where any is.
pub(crate) const ACTIVE: i32 = 1;
/// A workstation of type [`NULL`] that is not active.
pub(crate) const INACTIVE: i32 = 2;
/// A workstation of type [`INDEXED`] that is not active.
pub(crate) const COLOUR_TABLE: i32 = 4;
/// A workstation of type [`OPERATED`] that is not active, whose input devices 1 are in mode REQUEST, 2 in SAMPLE
/// and 3 in EVENT.
pub(crate) const WITH_OPERATOR: i32 = 5;
/// The workstation identifier of a category is this number plus the category. Those that can be active are so
/// where any is, but for INPUT and MI, which never can.
pub(crate) const OF_CATEGORY: i32 = 10;
/// An identifier that is never in use.
pub(crate) const UNUSED: i32 = 99;

/// The segment on the workstation [`ACTIVE`] and in segment storage, which is open wherever a workstation is.
pub(crate) const SEGMENT: i32 = 1;
/// The open segment.
pub(crate) const OPEN_SEGMENT: i32 = 9;

/// The categories that have a workstation in [`all_categories`].
pub(crate) const CATEGORIES_OPEN: [Category; 4] =
    [Category::Input, Category::Wiss, Category::MetafileOutput, Category::MetafileInput];

/// The operating states.
pub(crate) const STATES: [OperatingState; 5] = [
    OperatingState::Gkcl,
    OperatingState::Gkop,
    OperatingState::Wsop,
    OperatingState::Wsac,
    OperatingState::Sgop,
];

/// A kernel in an operating state, with the workstations that sample calls are about, and its log.
pub(crate) fn at(state: OperatingState) -> (Gks, Log) {
    let log = Log::default();
    let mut gks = Gks::new(Box::new(Recording::new(log.clone())));
    let messages = log.clone();
    gks.on_message(Box::new(move |id, text| messages.push(format!("message {id} \"{text}\""))));
    if state != OperatingState::Gkcl {
        gks.open_gks().expect("GKS is closed");
    }
    if matches!(state, OperatingState::Wsop | OperatingState::Wsac | OperatingState::Sgop) {
        open(&mut gks, ACTIVE, FRAME_BUFFER);
        open(&mut gks, INACTIVE, NULL);
        open(&mut gks, of_category(Category::Wiss), CATEGORIES + Category::Wiss as i32);
        store_segment(&mut gks).expect("the workstations have just been opened");
        open(&mut gks, WITH_OPERATOR, OPERATED);
        for set in OF_ALL.into_iter().chain([Gks::set_pick_mode as SetMode]) {
            operate(&mut gks, WITH_OPERATOR, set);
        }
    }
    if matches!(state, OperatingState::Wsac | OperatingState::Sgop) {
        gks.activate_workstation(ACTIVE).expect("the workstation has just been opened");
    }
    if state == OperatingState::Sgop {
        gks.create_segment(OPEN_SEGMENT).expect("a workstation is active, the name is free");
    }
    assert_eq!(gks.inquire_operating_state_value(), state);
    (gks, log)
}

/// Creates [`SEGMENT`].
fn store_segment(gks: &mut Gks) -> Result<()> {
    let wiss = of_category(Category::Wiss);
    gks.activate_workstation(ACTIVE)?;
    gks.activate_workstation(wiss)?;
    gks.create_segment(SEGMENT)?;
    gks.polyline(&[(0.1, 0.1), (0.2, 0.3)])?;
    gks.close_segment()?;
    gks.deactivate_workstation(wiss)?;
    gks.deactivate_workstation(ACTIVE)
}

/// As [`at`] for WSAC, with a workstation of every category and one with a colour table.
pub(crate) fn all_categories() -> (Gks, Log) {
    let (mut gks, log) = at(OperatingState::Wsac);
    open(&mut gks, COLOUR_TABLE, INDEXED);
    for category in CATEGORIES_OPEN.into_iter().filter(|&category| category != Category::Wiss) {
        open(&mut gks, of_category(category), CATEGORIES + category as i32);
    }
    OF_ALL.into_iter().for_each(|set| operate(&mut gks, of_category(Category::Input), set));
    (gks, log)
}

/// The workstation of a category.
pub(crate) const fn of_category(category: Category) -> i32 {
    OF_CATEGORY + category as i32
}

fn open(gks: &mut Gks, id: i32, kind: i32) {
    gks.open_workstation(id, "", kind).expect("the identifier is free, the type is known");
}

/// A function that sets the mode of an input device.
type SetMode = fn(&mut Gks, i32, i32, OperatingMode, bool) -> Result<()>;

/// Those of the classes that workstations without output have, too.
const OF_ALL: [SetMode; 5] = [
    Gks::set_locator_mode,
    Gks::set_stroke_mode,
    Gks::set_valuator_mode,
    Gks::set_choice_mode,
    Gks::set_string_mode,
];

/// Sets input device 2 to mode SAMPLE and 3 to EVENT.
fn operate(gks: &mut Gks, id: i32, set: SetMode) {
    for (number, mode) in [(2, OperatingMode::Sample), (3, OperatingMode::Event)] {
        set(gks, id, number, mode, false).expect("the workstation has the device");
    }
}

macro_rules! devices {
    ($lines:ident, $gks:ident, $id:ident, $number:ident: $($name:ident($($of:expr)?))+) => { $(
        let state = $gks.$name($id, $number, $($of)?);
        $lines.push(format!("{} {:?} {:?} {state:?}", stringify!($name), $id, $number));
    )+ };
}

macro_rules! lines {
    ($lines:ident, $gks:ident: $($name:ident)+) => {
        $($lines.push(format!("{} {:?}", stringify!($name), $gks.$name()));)+
    };
}

macro_rules! tables {
    ($lines:ident, $gks:ident, $id:ident: $($list:ident $entry:ident)+) => { $(
        let indices = $gks.$list($id).map(Iterator::collect::<Vec<_>>);
        $lines.push(format!("{} {:?} {indices:?}", stringify!($list), $id));
        for index in indices.unwrap_or_default() {
            let entry = $gks.$entry($id, index, ValueType::Set);
            $lines.push(format!("{} {:?} {index} {entry:?}", stringify!($entry), $id));
        }
    )+ };
}

/// All values of the state lists, one a line.
pub(crate) fn state_lists(gks: &Gks) -> Vec<String> {
    let mut lines = Vec::new();
    lines! { lines, gks:
        inquire_operating_state_value inquire_current_primitive_attribute_values
        inquire_current_individual_attribute_values inquire_current_normalization_transformation_number
        inquire_list_of_normalization_transformation_numbers inquire_clipping
        inquire_current_pick_identifier_value inquire_more_simultaneous_events current_event
    }
    for number in gks.inquire_list_of_normalization_transformation_numbers().unwrap_or_default() {
        let transformation = gks.inquire_normalization_transformation(*number);
        lines.push(format!("transformation {number} {transformation:?}"));
    }
    let open = gks.inquire_set_of_open_workstations().map(Iterator::collect::<Vec<_>>);
    let active = gks.inquire_set_of_active_workstations().map(Iterator::collect::<Vec<_>>);
    lines.push(format!("open {open:?} active {active:?}"));
    lines.push(format!("open segment {:?}", gks.inquire_name_of_open_segment()));
    for name in gks.inquire_set_of_segment_names_in_use().into_iter().flatten() {
        let workstations = gks.inquire_set_of_associated_workstations(name).map(Iterator::collect::<Vec<_>>);
        lines.push(format!("segment {name} {workstations:?} {:?}", gks.inquire_segment_attributes(name)));
    }
    for id in open.unwrap_or_default() {
        workstation(gks, id, &mut lines);
    }
    lines
}

fn workstation(gks: &Gks, id: i32, lines: &mut Vec<String>) {
    lines.push(format!("connection {id} {:?}", gks.inquire_workstation_connection_and_type(id)));
    lines.push(format!("state {id} {:?}", gks.inquire_workstation_state(id)));
    lines.push(format!("surface {id} {:?}", gks.inquire_workstation_deferral_and_update_states(id)));
    lines.push(format!("transformation {id} {:?}", gks.inquire_workstation_transformation(id)));
    let names = gks.inquire_set_of_segment_names_on_workstation(id).map(Iterator::collect::<Vec<_>>);
    lines.push(format!("segments {id} {names:?}"));
    for number in 1..=DEVICES as i32 {
        devices! { lines, gks, id, number:
            inquire_locator_device_state(ValueType::Set)
            inquire_stroke_device_state(ValueType::Set)
            inquire_valuator_device_state()
            inquire_choice_device_state()
            inquire_pick_device_state(ValueType::Set)
            inquire_string_device_state()
        }
    }
    tables! { lines, gks, id:
        inquire_list_of_polyline_indices inquire_polyline_representation
        inquire_list_of_polymarker_indices inquire_polymarker_representation
        inquire_list_of_text_indices inquire_text_representation
        inquire_list_of_fill_area_indices inquire_fill_area_representation
        inquire_list_of_pattern_indices inquire_pattern_representation
        inquire_list_of_colour_indices inquire_colour_representation
    }
}
