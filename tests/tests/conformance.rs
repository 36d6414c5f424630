//! Every function of the kernel keeps to the table of functions: the operating states in which it may be called,
//! the errors it meets and the order in which it checks for them.

#[path = "../conformance/catalogue.rs"]
mod catalogue;
#[rustfmt::skip]
#[path = "../conformance/generated.rs"]
mod generated;
#[path = "../conformance/input.rs"]
mod input;
#[path = "../conformance/metafile.rs"]
mod metafile;
#[path = "../conformance/provocations.rs"]
mod provocations;
#[path = "../conformance/segment.rs"]
mod segment;
#[path = "../conformance/situation.rs"]
mod situation;

use catalogue::{BROKEN, CATEGORIES, Log, NULL, UNENCODABLE, UNHEARD, UNREADABLE};
use generated::SAMPLES;
use gks::{
    CoordinateSwitch, DataRecord, Detectability, Function, Gks, Highlighting, InputClass, InputStatus, Level,
    OperatingMode, OperatingState, RelativePriority, Result, ValueType, Visibility,
};
use gks_pipeline::description::{Category, DeferralMode, RegenerationMode};
use gks_pipeline::item::Cells;
use gks_pipeline::look::{AspectSourceFlags, Horizontal, InteriorStyle, Precision, TextPath, Vertical};
use provocations::{Provocation, SEVERAL};
use situation::{
    ACTIVE, CATEGORIES_OPEN, INACTIVE, STATES, UNUSED, all_categories, at, of_category, state_lists,
};
use std::collections::BTreeSet;

/// All provocations.
fn provocations() -> impl Iterator<Item = &'static Provocation> {
    let all =
        [provocations::PROVOCATIONS, segment::PROVOCATIONS, input::PROVOCATIONS, metafile::PROVOCATIONS];
    all.into_iter().flatten()
}

/// A function with a valid call.
struct Sample {
    function: Function,
    /// The workstation identifier or type of the valid call; 0 for functions that are about neither.
    subject: i32,
    /// The call, about another workstation or type where the function is about one.
    call: fn(&mut Gks, i32) -> Result<()>,
    /// The error of the call where none can succeed yet, else 0.
    error: i32,
    /// Errors of the table that no call can provoke, with the reasons.
    unreachable: &'static [(i32, &'static str)],
}

impl Sample {
    fn of(function: Function) -> &'static Sample {
        let found = SAMPLES.iter().find(|sample| sample.function == function);
        found.unwrap_or_else(|| panic!("{function:?} has no sample"))
    }

    fn is_excused(&self, error: i32) -> bool {
        self.unreachable.iter().any(|(number, _)| *number == error)
    }

    /// The errors that the workstation or the type is to blame for, each with identifiers or types that are wrong
    /// in the situation [`all_categories`].
    fn wrong_subjects(&self) -> Vec<(i32, i32)> {
        let categories = |errors: &[(i32, &[Category])], subject: fn(Category) -> i32| -> Vec<(i32, i32)> {
            errors.iter().flat_map(|(error, of)| of.iter().map(|c| (*error, subject(*c)))).collect()
        };
        use Category::{Input, MetafileInput, MetafileOutput, Wiss};
        let by_category: &[(i32, &[Category])] = &[
            (31, &[MetafileOutput]),
            (33, &[MetafileInput]),
            (35, &[Input]),
            (36, &[Wiss]),
            (37, &[Input, Wiss, MetafileOutput, MetafileInput]),
            (38, &[Wiss, MetafileOutput, MetafileInput]),
            (39, &[Input, Wiss, MetafileOutput, MetafileInput]),
        ];
        let errors = self.function.errors();
        let all: Vec<(i32, i32)> = if errors.contains(&20) {
            let identifiers = [
                (20, 0),
                (20, -1),
                (20, i32::MIN),
                (24, ACTIVE),
                (25, UNUSED),
                (25, i32::MAX),
                (29, ACTIVE),
                (30, INACTIVE),
                (30, UNUSED),
                (32, ACTIVE),
                (34, ACTIVE),
                (37, ACTIVE),
                (38, ACTIVE),
                (40, INACTIVE),
            ];
            categories(by_category, of_category).into_iter().chain(identifiers).collect()
        } else if errors.contains(&22) {
            let types = [(37, NULL), (38, NULL), (22, -1), (22, i32::MIN), (23, 12_345), (23, i32::MAX)];
            categories(by_category, |c| CATEGORIES + c as i32).into_iter().chain(types).collect()
        } else {
            Vec::new()
        };
        all.into_iter().filter(|(error, _)| errors.contains(error)).collect()
    }
}

/// The number of the error of a call, which has to name the function; 0 for success.
fn number(function: Function, result: &Result<()>) -> i32 {
    match result {
        Ok(()) => 0,
        Err(error) => {
            assert_eq!(error.function, function, "{error}");
            error.number
        }
    }
}

/// The number of the error of a call that has no effect unless it succeeds.
fn observed(function: Function, gks: &mut Gks, log: &Log, call: impl FnOnce(&mut Gks) -> Result<()>) -> i32 {
    let before = (state_lists(gks), log.entries());
    let error = number(function, &call(gks));
    if error != 0 {
        let mut entries = log.entries();
        // Whether a connection can be opened shows when it is tried.
        if matches!(error, 21 | 26) {
            entries.pop();
        }
        assert_eq!(
            (state_lists(gks), entries),
            before,
            "{function:?} has an effect in spite of error {error}"
        );
        let listed = function.errors().contains(&error) || error >= 300;
        assert!(listed, "{function:?} meets error {error}, which the table does not list");
    }
    error
}

/// The first of some errors in the order of the table; those it does not list come last.
fn first(function: Function, errors: &[i32]) -> i32 {
    let place = |error: &i32| function.errors().iter().position(|e| e == error).unwrap_or(usize::MAX);
    errors.iter().copied().min_by_key(place).unwrap_or(0)
}

#[test]
fn every_function_of_level_0a_has_a_sample() {
    /// What belongs to language bindings alone.
    const BINDINGS: [Function; 7] = [
        Function::ErrorHandling,
        Function::ErrorLogging,
        Function::PackDataRecord,
        Function::UnpackDataRecord,
        Function::CreateStore,
        Function::DeleteStore,
        Function::SetErrorHandler,
    ];
    let sampled: BTreeSet<Function> = SAMPLES.iter().map(|sample| sample.function).collect();
    let missing: Vec<Function> = Function::ALL
        .into_iter()
        .filter(|f| f.level() == Level::L0a && !BINDINGS.contains(f) && !sampled.contains(f))
        .collect();
    assert_eq!(missing, []);
    assert_eq!(sampled.len(), SAMPLES.len());
}

#[test]
fn a_call_in_a_wrong_state_meets_the_state_error_and_has_no_effect() {
    let fresh = state_lists(&at(OperatingState::Gkop).0);
    let mut refused = 0;
    for sample in SAMPLES {
        let function = sample.function;
        for state in STATES.into_iter().filter(|&state| !function.states().contains(state)) {
            let (mut gks, log) = at(state);
            let error = observed(function, &mut gks, &log, |gks| (sample.call)(gks, sample.subject));
            assert_eq!(error, function.state_error(), "{function:?} in {state:?}");
            assert!((1..=8).contains(&error), "{function:?} in {state:?}");
            refused += 1;
            if state == OperatingState::Gkcl {
                // What the call might have left behind would be there now.
                gks.open_gks().expect("GKS is closed");
                assert_eq!(state_lists(&gks), fresh, "{function:?} has an effect on closed GKS");
            }
        }
    }
    assert!(refused > 190, "{refused} calls");
}

/// The operating state after the sample call of a function.
fn state_after(function: Function, state: OperatingState) -> OperatingState {
    match function {
        Function::OpenGks => OperatingState::Gkop,
        Function::CloseGks | Function::EmergencyCloseGks => OperatingState::Gkcl,
        Function::OpenWorkstation if state == OperatingState::Gkop => OperatingState::Wsop,
        Function::ActivateWorkstation => OperatingState::Wsac,
        Function::DeactivateWorkstation => OperatingState::Wsop,
        Function::CreateSegment => OperatingState::Sgop,
        Function::CloseSegment => OperatingState::Wsac,
        _ => state,
    }
}

#[test]
fn a_valid_call_succeeds_in_every_allowed_state() {
    let mut done = 0;
    for sample in SAMPLES {
        let function = sample.function;
        for state in STATES.into_iter().filter(|&state| function.states().contains(state)) {
            let (mut gks, _) = at(state);
            let error = number(function, &(sample.call)(&mut gks, sample.subject));
            assert_eq!(error, sample.error, "{function:?} in {state:?}");
            let after = gks.inquire_operating_state_value();
            assert_eq!(after, state_after(function, state), "{function:?} in {state:?}");
            done += 1;
        }
    }
    assert!(done > 350, "{done} calls");
}

#[test]
fn inquiries_change_nothing() {
    let inquiry = |sample: &&Sample| sample.error == 0 && sample.function.name().starts_with("INQUIRE ");
    for sample in SAMPLES.iter().filter(inquiry) {
        let allowed = sample.function.states();
        let state = [OperatingState::Wsac, OperatingState::Sgop].into_iter().find(|&s| allowed.contains(s));
        let (mut gks, log) = at(state.expect("an inquiry while a workstation is active"));
        let before = (state_lists(&gks), log.entries());
        assert_eq!((sample.call)(&mut gks, sample.subject), Ok(()), "{:?}", sample.function);
        assert_eq!((state_lists(&gks), log.entries()), before, "{:?}", sample.function);
    }
}

/// Every error of the table is met by a call or excused, and none that is excused is ever met.
#[test]
fn every_error_is_provoked_or_excused() {
    let mut met: BTreeSet<(Function, i32)> = BTreeSet::new();
    for sample in SAMPLES {
        let function = sample.function;
        met.insert((function, function.state_error()));
        for (error, subject) in sample.wrong_subjects() {
            let (mut gks, log) = all_categories();
            let found = observed(function, &mut gks, &log, |gks| (sample.call)(gks, subject));
            met.insert((function, found));
            assert!(
                found == error || sample.is_excused(error),
                "{function:?} for {subject}: {found}, not {error}"
            );
        }
    }
    for provocation in provocations() {
        let sample = Sample::of(provocation.function);
        let subject = provocation.subject.unwrap_or(sample.subject);
        let (mut gks, log) = all_categories();
        (provocation.before)(&mut gks);
        let error = observed(sample.function, &mut gks, &log, |gks| (provocation.call)(gks, subject));
        assert_eq!(error, provocation.error, "{:?}", sample.function);
        met.insert((sample.function, error));
    }
    let mut faults = Vec::new();
    for sample in SAMPLES {
        for &error in sample.function.errors() {
            match (met.contains(&(sample.function, error)), sample.is_excused(error)) {
                (true, true) => faults.push(format!("{} meets error {error}", sample.function.name())),
                (false, false) => {
                    faults.push(format!("{} never meets error {error}", sample.function.name()));
                }
                _ => {}
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A workstation of a category that the table does not forbid is served.
#[test]
fn only_the_categories_of_the_table_are_refused() {
    for sample in SAMPLES.iter().filter(|sample| sample.error == 0) {
        let errors = sample.function.errors();
        let subject: fn(Category) -> i32 = match (errors.contains(&20), errors.contains(&22)) {
            // A workstation with the identifier must not be open.
            (true, true) => continue,
            (true, false) => of_category,
            (false, true) => |category| CATEGORIES + category as i32,
            (false, false) => continue,
        };
        for category in CATEGORIES_OPEN {
            let (mut gks, _) = all_categories();
            let error = number(sample.function, &(sample.call)(&mut gks, subject(category)));
            let refused = sample.wrong_subjects().iter().any(|&(_, wrong)| wrong == subject(category));
            // None of these workstations is active, and not all have a segment.
            let served = matches!(error, 0 | 30 | 123);
            assert_eq!(refused && error != 0, refused, "{:?} serves {category:?}", sample.function);
            assert!(refused || served, "{:?} meets error {error} for {category:?}", sample.function);
        }
    }
}

#[test]
fn the_first_error_of_the_table_is_reported() {
    for provocation in provocations() {
        let sample = Sample::of(provocation.function);
        let function = sample.function;
        let subject = provocation.subject.unwrap_or(sample.subject);
        for state in STATES.into_iter().filter(|&state| !function.states().contains(state)) {
            let (mut gks, log) = at(state);
            let error = observed(function, &mut gks, &log, |gks| (provocation.call)(gks, subject));
            assert_eq!(error, function.state_error(), "{function:?} in {state:?}");
        }
        for (wrong, subject) in sample.wrong_subjects() {
            let (mut gks, log) = all_categories();
            (provocation.before)(&mut gks);
            let error = observed(function, &mut gks, &log, |gks| (provocation.call)(gks, subject));
            let expected = first(function, &[wrong, provocation.error]);
            assert_eq!(error, expected, "{function:?} for {subject} and error {}", provocation.error);
        }
    }
    for several in SEVERAL {
        let (mut gks, _) = all_categories();
        let error = number(several.function, &(several.call)(&mut gks));
        assert_eq!(
            error,
            first(several.function, several.errors),
            "{:?} {:?}",
            several.function,
            several.errors
        );
    }
}

#[test]
fn a_device_that_fails_is_reported_and_the_others_go_on() {
    for (kind, error) in [(BROKEN, 303), (UNENCODABLE, 304)] {
        let (mut gks, log) = at(OperatingState::Wsac);
        gks.open_workstation(3, "", kind).expect("it opens");
        gks.activate_workstation(3).expect("it is open");
        gks.activate_workstation(INACTIVE).expect("it is open");
        let marks = || log.entries().iter().filter(|entry| entry.starts_with("draw ")).count();
        for function in [Function::Polyline, Function::FillArea, Function::Text, Function::CellArray] {
            let sample = Sample::of(function);
            let before = marks();
            assert_eq!(number(function, &(sample.call)(&mut gks, sample.subject)), error);
            assert!(
                marks() >= before + 2,
                "{function:?} does not reach workstations {ACTIVE} and {INACTIVE}"
            );
        }
        gks.deactivate_workstation(3).expect("it is active");
        assert_eq!(number(Function::ClearWorkstation, &gks.clear_workstation(3, true)), error);
        assert_eq!(number(Function::CloseWorkstation, &gks.close_workstation(3)), error);
        assert_eq!(gks.open_workstation(3, "", NULL), Ok(()), "the identifier is not free again");
    }
}

#[test]
fn an_operator_who_is_not_heard_is_reported() {
    let (mut gks, _) = at(OperatingState::Wsac);
    gks.open_workstation(3, "", UNHEARD).expect("it opens");
    gks.set_choice_mode(3, 2, OperatingMode::Sample, true).expect("the workstation has the device");
    let request = gks.request_choice(3, 1).map(drop);
    assert_eq!(number(Function::RequestChoice, &request), 305);
    let sample = gks.sample_choice(3, 2).map(drop);
    assert_eq!(number(Function::SampleChoice, &sample), 305);
    gks.set_choice_mode(3, 3, OperatingMode::Event, true).expect("the workstation has the device");
    assert_eq!(number(Function::AwaitEvent, &gks.await_event(0.0).map(drop)), 305);
    assert_eq!(gks.close_workstation(3), Ok(()));
}

#[test]
fn a_metafile_that_cannot_be_read_is_reported() {
    let (mut gks, _) = at(OperatingState::Wsac);
    gks.open_workstation(3, "", UNREADABLE).expect("it opens");
    let item = gks.get_item_type_from_gksm(3).map(drop);
    assert_eq!(number(Function::GetItemTypeFromGksm, &item), 302);
    assert_eq!(number(Function::ReadItemFromGksm, &gks.read_item_from_gksm(3, 80).map(drop)), 302);
    assert_eq!(gks.close_workstation(3), Ok(()));
}
