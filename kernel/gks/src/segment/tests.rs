use crate::test_device::{CATEGORIES, Drawing, Event, INDEXED, Log, PLAIN, active, number, open};
use crate::{Function, Gks, Highlighting, OperatingState, Visibility};
use gks_pipeline::description::{Category, DeferralMode, RegenerationMode};
use glam::dvec2;

const WISS: i32 = CATEGORIES + Category::Wiss as i32;
const LINE: [(f64, f64); 2] = [(0.1, 0.1), (0.2, 0.1)];
const OTHER: [(f64, f64); 2] = [(0.5, 0.5), (0.6, 0.5)];
/// Half the size, up and to the right.
const SHIFT: [[f64; 3]; 2] = [[0.5, 0.0, 0.5], [0.0, 0.5, 0.25]];

/// A closed segment of one line.
fn segment(gks: &mut Gks, name: i32, line: &[(f64, f64)]) {
    gks.create_segment(name).unwrap();
    gks.polyline(line).unwrap();
    gks.close_segment().unwrap();
}

/// The first points of lines drawn, in hundredths of the surface.
fn starts(log: &Log) -> Vec<(i32, i32)> {
    let hundredth = |v: f64| (v / 10.0).round() as i32;
    let first = |drawing: &Drawing| match drawing {
        Drawing::Lines(paths, _) => Some((hundredth(paths[0][0].x), hundredth(paths[0][0].y))),
        _ => None,
    };
    log.marks().iter().filter_map(|(drawing, _)| first(drawing)).collect()
}

fn states(gks: &Gks, id: i32) -> (bool, bool) {
    let states = gks.inquire_workstation_deferral_and_update_states(id).unwrap();
    (states.empty, states.new_frame_necessary)
}

#[test]
fn primitives_go_to_the_segment_and_to_active_workstations() {
    let (mut gks, log) = active(&[PLAIN, PLAIN]);
    gks.deactivate_workstation(2).unwrap();
    gks.create_segment(4).unwrap();
    assert_eq!(gks.inquire_operating_state_value(), OperatingState::Sgop);
    assert_eq!(gks.inquire_name_of_open_segment(), Ok(4));
    gks.polyline(&LINE).unwrap();
    assert_eq!(starts(&log), [(10, 10)]);
    gks.close_segment().unwrap();
    gks.polyline(&OTHER).unwrap();
    log.take();
    gks.redraw_all_segments_on_workstation(1).unwrap();
    assert_eq!(starts(&log), [(10, 10)]);
    gks.redraw_all_segments_on_workstation(2).unwrap();
    assert_eq!(starts(&log), []);
    let on: Vec<i32> = gks.inquire_set_of_associated_workstations(4).unwrap().collect();
    assert_eq!(on, [1]);
}

#[test]
fn redrawing_keeps_order_transformation_and_clipping() {
    let (mut gks, log) = active(&[PLAIN]);
    gks.set_viewport(1, (0.0, 0.15, 0.0, 1.0)).unwrap();
    gks.set_window(1, (0.0, 0.15, 0.0, 1.0)).unwrap();
    gks.select_normalization_transformation(1).unwrap();
    segment(&mut gks, 1, &LINE);
    gks.select_normalization_transformation(0).unwrap();
    segment(&mut gks, 2, &OTHER);
    gks.set_segment_priority(1, 0.5).unwrap();
    gks.set_segment_transformation(1, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.3]]).unwrap();
    log.take();
    gks.redraw_all_segments_on_workstation(1).unwrap();
    let marks = log.marks();
    let Drawing::Lines(below, _) = &marks[0].0 else { panic!("{marks:?}") };
    assert_eq!(below[0][0], dvec2(500.0, 500.0));
    // Moved up, but cut where it was.
    let Drawing::Lines(above, _) = &marks[1].0 else { panic!("{marks:?}") };
    assert!(above[0][0].distance(dvec2(100.0, 400.0)) < 1e-9);
    assert!(above[0][1].distance(dvec2(150.0, 400.0)) < 1e-9);
}

#[test]
fn a_change_is_necessary_due_or_made_as_the_modes_say() {
    let (mut gks, log) = active(&[PLAIN]);
    segment(&mut gks, 1, &LINE);
    assert_eq!(states(&gks, 1), (false, false));
    gks.set_visibility(1, Visibility::Invisible).unwrap();
    assert_eq!(states(&gks, 1), (false, true));
    log.take();
    gks.update_workstation(1, false).unwrap();
    assert_eq!(log.take(), []);
    gks.update_workstation(1, true).unwrap();
    assert_eq!(states(&gks, 1), (true, false));
    // On top of what is there, at once.
    gks.set_visibility(1, Visibility::Visible).unwrap();
    assert_eq!((starts(&log), states(&gks, 1)), (vec![(10, 10)], (false, false)));
    // Deferred until a primitive outside of segments is drawn.
    gks.set_deferral_state(1, DeferralMode::Asti, RegenerationMode::Allowed).unwrap();
    gks.set_segment_transformation(1, SHIFT).unwrap();
    gks.set_highlighting(1, Highlighting::Normal).unwrap();
    assert_eq!((starts(&log), states(&gks, 1)), (vec![], (false, true)));
    gks.polyline(&OTHER).unwrap();
    assert_eq!((starts(&log), states(&gks, 1)), (vec![(55, 30), (50, 50)], (false, false)));
    // At once; the other line is lost.
    gks.set_deferral_state(1, DeferralMode::Asap, RegenerationMode::Allowed).unwrap();
    gks.set_segment_transformation(1, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).unwrap();
    assert_eq!((starts(&log), states(&gks, 1)), (vec![(10, 10)], (false, false)));
    // Nothing different, nothing to do.
    gks.set_segment_transformation(1, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).unwrap();
    gks.set_visibility(1, Visibility::Visible).unwrap();
    assert_eq!(log.take(), []);
    gks.delete_segment(1).unwrap();
    assert_eq!((starts(&log), states(&gks, 1)), (vec![], (true, false)));
}

#[test]
fn what_was_due_is_done_when_it_is_forbidden_and_before_an_operator_acts() {
    let (mut gks, log) = active(&[PLAIN, PLAIN]);
    segment(&mut gks, 1, &LINE);
    for id in [1, 2] {
        gks.set_deferral_state(id, DeferralMode::Bnil, RegenerationMode::Allowed).unwrap();
    }
    gks.set_segment_transformation(1, SHIFT).unwrap();
    log.take();
    gks.set_deferral_state(1, DeferralMode::Bnil, RegenerationMode::Suppressed).unwrap();
    assert_eq!((starts(&log), states(&gks, 1).1, states(&gks, 2).1), (vec![(55, 30)], false, true));
    gks.before_interaction(Function::RequestLocator, 1).unwrap();
    assert_eq!(starts(&log), []);
    gks.set_deferral_state(2, DeferralMode::Bnig, RegenerationMode::Allowed).unwrap();
    gks.before_interaction(Function::RequestLocator, 1).unwrap();
    assert_eq!(starts(&log), [(55, 30)]);
}

#[test]
fn primitives_added_below_another_segment_make_a_new_frame_necessary() {
    let (mut gks, _) = active(&[PLAIN]);
    segment(&mut gks, 1, &LINE);
    segment(&mut gks, 2, &OTHER);
    assert!(!states(&gks, 1).1);
    gks.set_segment_priority(2, 1.0).unwrap();
    gks.update_workstation(1, true).unwrap();
    segment(&mut gks, 3, &LINE);
    assert!(states(&gks, 1).1);
    gks.update_workstation(1, true).unwrap();
    gks.set_visibility(1, Visibility::Invisible).unwrap();
    gks.update_workstation(1, true).unwrap();
    gks.set_visibility(1, Visibility::Visible).unwrap();
    assert!(states(&gks, 1).1, "it appears below others");
}

#[test]
fn frames_are_replaced_where_the_device_can_and_are_complete_elsewhere() {
    let pages = |log: &Log| log.take().iter().filter(|event| matches!(event, Event::Begin(_))).count();
    let (mut gks, log) = active(&[PLAIN]);
    segment(&mut gks, 1, &LINE);
    (0..3).for_each(|_| gks.redraw_all_segments_on_workstation(1).unwrap());
    gks.emergency_close_gks();
    assert_eq!(pages(&log), 4);
    let (mut gks, log) = active(&[INDEXED]);
    segment(&mut gks, 1, &LINE);
    (0..3).for_each(|_| gks.redraw_all_segments_on_workstation(1).unwrap());
    let events = log.take();
    assert_eq!(events.iter().filter(|event| matches!(event, Event::Erase(_))).count(), 3);
    assert_eq!(events.iter().filter(|event| matches!(event, Event::End)).count(), 0);
    // Nothing takes the place of primitives that are in no segment.
    gks.clear_workstation(1, true).unwrap();
    gks.polyline(&OTHER).unwrap();
    log.take();
    gks.redraw_all_segments_on_workstation(1).unwrap();
    assert_eq!(log.take(), [Event::End]);
}

#[test]
fn segments_are_deleted_with_their_last_workstation() {
    let names = |gks: &Gks| gks.inquire_set_of_segment_names_in_use().unwrap().collect::<Vec<_>>();
    let (mut gks, log) = active(&[PLAIN, PLAIN]);
    segment(&mut gks, 1, &LINE);
    gks.deactivate_workstation(2).unwrap();
    segment(&mut gks, 2, &OTHER);
    gks.delete_segment_from_workstation(1, 1).unwrap();
    assert_eq!(names(&gks), [1, 2]);
    gks.clear_workstation(1, true).unwrap();
    assert_eq!(names(&gks), [1]);
    log.take();
    gks.close_workstation(2).unwrap();
    assert_eq!(names(&gks), []);
    gks.create_segment(3).unwrap();
    gks.polyline(&LINE).unwrap();
    gks.emergency_close_gks();
    gks.open_gks().unwrap();
    assert_eq!(number(gks.inquire_set_of_segment_names_in_use().map(drop)), 7);
}

#[test]
fn closing_shows_what_segments_are_and_keeps_what_would_be_lost() {
    let (mut gks, log) = active(&[INDEXED]);
    segment(&mut gks, 1, &LINE);
    gks.set_segment_transformation(1, SHIFT).unwrap();
    gks.deactivate_workstation(1).unwrap();
    log.take();
    gks.close_workstation(1).unwrap();
    assert_eq!(log.marks().len(), 1);
    let (mut gks, log) = active(&[INDEXED]);
    segment(&mut gks, 1, &LINE);
    gks.polyline(&OTHER).unwrap();
    gks.set_segment_transformation(1, SHIFT).unwrap();
    gks.deactivate_workstation(1).unwrap();
    log.take();
    gks.close_workstation(1).unwrap();
    assert_eq!(log.marks().len(), 0);
}

#[test]
fn a_segment_of_the_storage_is_associated_copied_and_inserted() {
    let (mut gks, log) = open(&[PLAIN, WISS]);
    assert_eq!(number(gks.open_workstation(3, "", WISS)), 28);
    gks.activate_workstation(2).unwrap();
    gks.set_viewport(1, (0.0, 0.15, 0.0, 1.0)).unwrap();
    gks.set_window(1, (0.0, 0.15, 0.0, 1.0)).unwrap();
    gks.select_normalization_transformation(1).unwrap();
    segment(&mut gks, 1, &LINE);
    gks.select_normalization_transformation(0).unwrap();
    gks.set_segment_transformation(1, SHIFT).unwrap();
    assert_eq!(log.take(), []);
    // Transformed, but outside of its clipping rectangle.
    gks.copy_segment_to_workstation(1, 1).unwrap();
    assert_eq!(starts(&log), []);
    gks.set_segment_transformation(1, [[0.5, 0.0, 0.0], [0.0, 0.5, 0.25]]).unwrap();
    gks.copy_segment_to_workstation(1, 1).unwrap();
    assert_eq!(starts(&log), [(5, 30)]);
    gks.redraw_all_segments_on_workstation(1).unwrap();
    assert_eq!(starts(&log), [], "a copy is in no segment");
    // The rectangle is that of the moment; the transformations follow one another.
    gks.activate_workstation(1).unwrap();
    gks.create_segment(2).unwrap();
    gks.insert_segment(1, [[2.0, 0.0, 0.0], [0.0, 1.0, 0.5]]).unwrap();
    gks.close_segment().unwrap();
    assert_eq!(starts(&log), [(10, 80)]);
    gks.set_segment_transformation(2, [[1.0, 0.0, 0.2], [0.0, 1.0, 0.0]]).unwrap();
    log.take();
    gks.update_workstation(1, true).unwrap();
    assert_eq!(starts(&log), [(30, 80)]);
    gks.associate_segment_with_workstation(1, 1).unwrap();
    assert_eq!((starts(&log), states(&gks, 1).1), (vec![], true), "the younger segment is in front");
    gks.associate_segment_with_workstation(1, 1).unwrap();
    gks.update_workstation(1, true).unwrap();
    assert_eq!(starts(&log), [(5, 30), (30, 80)]);
}

#[test]
fn a_changed_table_makes_a_new_frame_necessary_where_segments_are_drawn() {
    let (mut gks, _) = active(&[PLAIN, INDEXED]);
    gks.polyline(&OTHER).unwrap();
    gks.set_polyline_representation(1, 1, 2, 1.0, 1).unwrap();
    assert!(!states(&gks, 1).1, "what is in no segment cannot be drawn again");
    segment(&mut gks, 1, &LINE);
    gks.set_colour_representation(1, 1, (1.0, 0.0, 0.0)).unwrap();
    assert!(states(&gks, 1).1);
    gks.set_colour_representation(2, 1, (1.0, 0.0, 0.0)).unwrap();
    assert!(!states(&gks, 2).1, "pixels that store indices change at once");
    gks.update_workstation(1, true).unwrap();
    gks.set_fill_area_representation(1, 1, gks_pipeline::look::InteriorStyle::Solid, 1, 1).unwrap();
    assert!(states(&gks, 1).1);
}

/// Redrawing a segment does the work of drawing its primitives, and no other.
#[test]
fn a_hundred_thousand_primitives_are_redrawn_as_they_were_drawn() {
    let (mut gks, log) = active(&[PLAIN]);
    gks.create_segment(1).unwrap();
    for i in 0..100_000 {
        let y = f64::from(i) * 1e-5;
        gks.polyline(&[(0.1, y), (0.2, y)]).unwrap();
    }
    gks.close_segment().unwrap();
    let drawn = log.marks();
    gks.redraw_all_segments_on_workstation(1).unwrap();
    assert!(log.marks() == drawn);
}

#[test]
fn a_device_that_fails_leaves_the_segment_whole() {
    let (mut gks, log) = active(&[crate::test_device::BROKEN, PLAIN]);
    gks.create_segment(1).unwrap();
    assert_eq!(number(gks.polyline(&LINE)), 303);
    gks.close_segment().unwrap();
    log.take();
    assert_eq!(number(gks.redraw_all_segments_on_workstation(1)), 303);
    gks.redraw_all_segments_on_workstation(2).unwrap();
    assert_eq!(starts(&log), [(10, 10)]);
}
