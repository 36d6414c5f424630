use super::*;
use gks_geometry::Rect;
use gks_pipeline::input::Detail;

const AREA: Rect<Dc> = Rect::new(0.0, 0.2, 0.0, 0.2);

/// A surface of 1000 x 1000 pixels and 0.2 m square.
fn console() -> Console {
    let surface =
        Surface { width: 1000.0, height: 1000.0, unit: 0.0002, y_down: true, resolution: 1.0, pen: None };
    Console::new(&surface)
}

fn device(class: InputClass) -> LogicalDevice {
    LogicalDevice { class, number: 1 }
}

fn setting(initial: Measure, detail: Detail) -> Setting {
    Setting { echo: true, prompt: 1, area: AREA, within: AREA, initial, detail, picture: None }
}

fn locator() -> Setting {
    setting(Measure::Locator(Point::new(0.1, 0.1)), Detail::Locator)
}

fn stroke(buffer: usize, interval: f64) -> Setting {
    setting(Measure::Stroke(vec![]), Detail::Stroke { buffer, interval: (interval, interval) })
}

fn valuator() -> Setting {
    setting(Measure::Valuator(5.0), Detail::Valuator { low: 0.0, high: 10.0 })
}

fn choice(alternatives: i32, names: &[&str]) -> Setting {
    let names = names.iter().map(|&name| name.to_owned()).collect();
    setting(Measure::Choice(None), Detail::Choice { alternatives, enabled: Vec::new(), names })
}

fn string(text: &str) -> Setting {
    setting(Measure::String(text.to_owned()), Detail::String { buffer: 8, cursor: 1 })
}

fn started(settings: &[(InputClass, Setting)]) -> Console {
    let mut console = console();
    for (class, setting) in settings {
        console.start(device(*class), setting);
    }
    console
}

/// The only device's measure in the next report.
fn fired(console: &mut Console) -> Option<Measure> {
    match console.report() {
        Some(Report::Trigger(mut measures)) if measures.len() == 1 => Some(measures.remove(0).1),
        _ => None,
    }
}

fn act(console: &mut Console, events: &[Event]) {
    for &event in events {
        console.handle(event);
    }
}

fn click(x: f64, y: f64) -> [Event; 2] {
    let at = DVec2::new(x, y);
    [Event::Pressed(Button::Primary, at), Event::Released(Button::Primary, at)]
}

fn typed(text: &str) -> Vec<Event> {
    text.chars().map(Event::Character).collect()
}

/// The pixel that shows a position.
fn pixel(at: Point<Dc>) -> DVec2 {
    DVec2::new(at.x() / 0.0002, (0.2 - at.y()) / 0.0002)
}

fn near(measure: impl Into<Option<Measure>>, x: f64, y: f64) -> bool {
    let measure: Option<Measure> = measure.into();
    matches!(measure, Some(Measure::Locator(at)) if (at.0 - DVec2::new(x, y)).length() < 1e-9)
}

#[test]
fn a_click_reports_the_position_and_the_pointer_moves_it() {
    let mut console = started(&[(InputClass::Locator, locator())]);
    assert!(near(console.measure(device(InputClass::Locator)), 0.1, 0.1), "the initial position");
    act(&mut console, &[Event::Moved(DVec2::new(250.0, 250.0))]);
    assert!(near(console.measure(device(InputClass::Locator)), 0.05, 0.15));
    assert_eq!(console.report(), None);
    act(&mut console, &click(500.0, 750.0));
    assert!(near(fired(&mut console), 0.1, 0.05));
    assert_eq!(console.report(), None, "once");
    act(&mut console, &click(-500.0, 750.0));
    assert!(near(fired(&mut console), 0.0, 0.05), "inside of the viewport");
}

#[test]
fn arrow_keys_and_return_do_what_the_pointer_does() {
    let mut console = started(&[(InputClass::Locator, locator())]);
    let keys = [Key::Right, Key::Right, Key::Up, Key::Left, Key::Return];
    act(&mut console, &keys.map(Event::Key));
    assert!(near(fired(&mut console), 0.102, 0.102));
}

#[test]
fn one_click_is_the_trigger_of_locators_and_picks() {
    let pick = setting(Measure::Pick(None), Detail::Pick { aperture: 0.001 });
    let mut console = started(&[(InputClass::Locator, locator()), (InputClass::Pick, pick)]);
    act(&mut console, &click(500.0, 500.0));
    let at = Point::new(0.1, 0.1);
    let expected = vec![
        (device(InputClass::Locator), Measure::Locator(at)),
        (device(InputClass::Pick), Measure::Pick(Some(at))),
    ];
    assert_eq!(console.report(), Some(Report::Trigger(expected)));
    act(&mut console, &[Event::Key(Key::Return)]);
    assert!(matches!(console.report(), Some(Report::Trigger(both)) if both.len() == 2));
}

#[test]
fn strokes_take_clicks_and_drags_at_a_distance() {
    let mut console = started(&[(InputClass::Stroke, stroke(50, 0.01))]);
    act(&mut console, &click(100.0, 100.0));
    act(&mut console, &[Event::Pressed(Button::Primary, DVec2::new(200.0, 100.0))]);
    // A point each 50 pixels.
    act(
        &mut console,
        &(200..=400).map(|x| Event::Moved(DVec2::new(f64::from(x), 100.0))).collect::<Vec<_>>(),
    );
    act(&mut console, &[Event::Released(Button::Primary, DVec2::new(400.0, 100.0))]);
    act(&mut console, &[Event::Moved(DVec2::new(700.0, 700.0))]);
    act(&mut console, &click(900.0, 100.0));
    act(&mut console, &[Event::Key(Key::Backspace)]);
    let at = DVec2::new(800.0, 800.0);
    act(&mut console, &[Event::Pressed(Button::Secondary, at)]);
    let Some(Measure::Stroke(points)) = fired(&mut console) else { panic!() };
    let columns: Vec<f64> = points.iter().map(|p| pixel(*p).x.round()).collect();
    assert_eq!(columns, [100.0, 200.0, 250.0, 300.0, 350.0, 400.0]);
    assert_eq!(console.measure(device(InputClass::Stroke)), Some(Measure::Stroke(vec![])), "from the start");
}

#[test]
fn a_stroke_is_no_longer_than_its_buffer() {
    let mut console = started(&[(InputClass::Stroke, stroke(3, 0.0))]);
    for x in 0..10 {
        act(&mut console, &click(f64::from(x) * 50.0, 10.0));
    }
    act(&mut console, &[Event::Key(Key::Return)]);
    assert!(matches!(fired(&mut console), Some(Measure::Stroke(points)) if points.len() == 3));
}

#[test]
fn valuators_are_dragged_wheeled_and_typed() {
    let mut console = started(&[(InputClass::Valuator, valuator())]);
    let track = console.started()[0].panel.as_ref().unwrap().track();
    let (start, end) = (pixel(track.0), pixel(track.1));
    act(&mut console, &[Event::Pressed(Button::Primary, start), Event::Moved(start.lerp(end, 0.75))]);
    assert_eq!(console.report(), None);
    act(&mut console, &[Event::Released(Button::Primary, start.lerp(end, 0.75))]);
    assert!(matches!(fired(&mut console), Some(Measure::Valuator(v)) if (v - 7.5).abs() < 1e-9));
    act(&mut console, &[Event::Wheel(1.0), Event::Wheel(-2.0), Event::Key(Key::Up), Event::Key(Key::PageUp)]);
    act(&mut console, &[Event::Key(Key::Return)]);
    assert!(matches!(fired(&mut console), Some(Measure::Valuator(v)) if (v - 8.4).abs() < 1e-9));
    act(&mut console, &[Event::Key(Key::End), Event::Key(Key::Up), Event::Key(Key::Return)]);
    assert_eq!(fired(&mut console), Some(Measure::Valuator(10.0)));
}

#[test]
fn choices_are_clicked_typed_and_stepped_through() {
    let mut console = started(&[(InputClass::Choice, choice(3, &["Line", "Area", "Quit"]))]);
    let item = console.started()[0].panel.as_ref().unwrap().item(2).unwrap();
    let at = pixel(item.centre());
    act(&mut console, &click(at.x, at.y));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(2))));
    act(&mut console, &typed("3"));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(3))));
    act(&mut console, &[Event::Key(Key::Function(1))]);
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(1))));
    act(&mut console, &[Event::Key(Key::Down), Event::Key(Key::Return)]);
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(2))));
    act(&mut console, &typed("qu"));
    act(&mut console, &[Event::Key(Key::Return)]);
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(3))));
    act(&mut console, &typed("0"));
    assert_eq!(fired(&mut console), Some(Measure::Choice(None)));
    act(&mut console, &typed("9"));
    act(&mut console, &[Event::Key(Key::Function(9))]);
    assert_eq!(console.report(), None);
}

#[test]
fn numbers_of_many_alternatives_wait_for_their_last_digit() {
    let mut console = started(&[(InputClass::Choice, choice(25, &[]))]);
    act(&mut console, &typed("1"));
    assert_eq!(console.report(), None);
    act(&mut console, &typed("7"));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(17))));
    act(&mut console, &typed("2"));
    act(&mut console, &[Event::Key(Key::Return)]);
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(2))));
    act(&mut console, &typed("3"));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(3))));
}

#[test]
fn many_alternatives_are_stepped_through_and_leave_the_picture_to_others() {
    let mut console = started(&[(InputClass::Locator, locator()), (InputClass::Choice, choice(256, &[]))]);
    let panel = console.started()[1].panel.clone().unwrap();
    let press = |console: &mut Console, at: Point<Dc>| act(console, &click(pixel(at).x, pixel(at).y));
    let [minus, plus] = panel.signs();
    [plus, plus, plus, minus].into_iter().for_each(|sign| press(&mut console, sign.centre()));
    assert_eq!(console.report(), None);
    press(&mut console, panel.frame.centre());
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(2))));
    act(&mut console, &click(500.0, 500.0));
    assert!(near(fired(&mut console), 0.1, 0.1), "the picture belongs to the locator");
}

#[test]
fn pictures_are_chosen_from_by_position_or_by_number() {
    let mut pictured = choice(3, &[]);
    pictured.prompt = 5;
    pictured.area = Rect::new(0.1, 0.2, 0.1, 0.2);
    pictured.picture = Some(Trace::default());
    let mut console = started(&[(InputClass::Choice, pictured)]);
    let choice = device(InputClass::Choice);
    act(&mut console, &click(250.0, 250.0));
    assert_eq!(console.report(), None, "beside the picture");
    assert_eq!(console.question(), None);
    act(&mut console, &click(750.0, 250.0));
    let at = Point::new(750.0 * 0.0002, 0.2 - 250.0 * 0.0002);
    assert_eq!(fired(&mut console), Some(Measure::Pick(Some(at))));
    assert_eq!(console.question(), Some(Report::Pointed(choice, Some(at))));
    assert_eq!(console.question(), None, "once");
    act(&mut console, &typed("3"));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(3))));
    assert_eq!(console.question(), Some(Report::Pointed(choice, None)));
}

#[test]
fn what_would_be_picked_is_asked_for_once_at_each_position() {
    let pick = setting(Measure::Pick(None), Detail::Pick { aperture: 0.001 });
    let mut console = started(&[(InputClass::Pick, pick.clone())]);
    assert_eq!(console.question(), None, "nothing has been pointed at");
    act(&mut console, &[100.0, 200.0, 500.0].map(|x| Event::Moved(DVec2::new(x, 500.0))));
    let question = Report::Pointed(device(InputClass::Pick), Some(Point::new(0.1, 0.1)));
    assert_eq!(console.question(), Some(question));
    assert_eq!(console.question(), None);
    let mut silent = started(&[(InputClass::Pick, Setting { echo: false, ..pick })]);
    act(&mut silent, &[Event::Moved(DVec2::new(100.0, 500.0))]);
    assert_eq!(silent.question(), None, "without echo nobody looks");
}

#[test]
fn what_follows_the_pointer_knows_where_it_is() {
    let mut console = console();
    act(&mut console, &[Event::Moved(DVec2::new(500.0, 500.0))]);
    console.start(
        device(InputClass::Locator),
        &Setting { initial: Measure::Locator(Point::new(0.0, 0.0)), ..locator() },
    );
    console.start(device(InputClass::Stroke), &stroke(9, 0.01));
    console.start(device(InputClass::Pick), &setting(Measure::Pick(None), Detail::Pick { aperture: 0.001 }));
    assert!(near(console.measure(device(InputClass::Locator)), 0.0, 0.0), "its initial position");
    assert_eq!(console.measure(device(InputClass::Stroke)), Some(Measure::Stroke(vec![])), "no point yet");
    assert_eq!(console.measure(device(InputClass::Pick)), Some(Measure::Pick(Some(Point::new(0.1, 0.1)))));
}

#[test]
fn alternatives_that_are_not_offered_cannot_be_chosen() {
    let mut limited = choice(3, &["a", "b", "c"]);
    if let Detail::Choice { enabled, .. } = &mut limited.detail {
        *enabled = vec![true, false, true];
    }
    let mut console = started(&[(InputClass::Choice, limited)]);
    let at = pixel(console.started()[0].panel.as_ref().unwrap().item(2).unwrap().centre());
    act(&mut console, &click(at.x, at.y));
    act(&mut console, &typed("2b"));
    act(&mut console, &[Event::Key(Key::Function(2))]);
    assert_eq!(console.report(), None);
    act(&mut console, &[Event::Key(Key::Down), Event::Key(Key::Down), Event::Key(Key::Return)]);
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(3))));
}

#[test]
fn strings_are_edited_at_the_cursor() {
    let mut console = started(&[(InputClass::String, string("world"))]);
    act(&mut console, &typed("my "));
    act(&mut console, &[Event::Key(Key::End), Event::Key(Key::Backspace), Event::Character('k')]);
    act(&mut console, &typed("overflow"));
    act(&mut console, &[Event::Key(Key::Home), Event::Key(Key::Delete), Event::Key(Key::Delete)]);
    act(&mut console, &[Event::Key(Key::Right), Event::Character('\u{e4}')]);
    act(&mut console, &[Event::Character('\u{7}'), Event::Key(Key::Return)]);
    assert_eq!(fired(&mut console), Some(Measure::String(" \u{e4}world".replace("ld", "lk"))));
    assert_eq!(console.measure(device(InputClass::String)), Some(Measure::String("world".to_owned())));
}

#[test]
fn keys_belong_to_the_focus_and_then_to_whoever_has_a_use() {
    let mut console =
        started(&[(InputClass::Locator, locator()), (InputClass::Choice, choice(3, &["x", "y", "z"]))]);
    act(&mut console, &typed("2"));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(2))), "a locator has no use for digits");
    act(&mut console, &[Event::Key(Key::Up), Event::Key(Key::Return)]);
    assert!(near(fired(&mut console), 0.1, 0.102));
    act(&mut console, &[Event::Key(Key::Tab), Event::Key(Key::Down), Event::Key(Key::Return)]);
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(3))));
    // A click into the menu is none into the picture.
    let at = pixel(console.started()[1].panel.as_ref().unwrap().item(1).unwrap().centre());
    act(&mut console, &click(at.x, at.y));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(1))));
    assert_eq!(console.report(), None);
    console.stop(device(InputClass::Choice));
    act(&mut console, &typed("2"));
    assert_eq!(console.report(), None);
    act(&mut console, &click(at.x, at.y));
    assert!(matches!(fired(&mut console), Some(Measure::Locator(_))));
}

#[test]
fn escape_breaks_and_reports_keep_their_order() {
    let mut console = started(&[(InputClass::Choice, choice(3, &[]))]);
    act(&mut console, &typed("1"));
    act(&mut console, &[Event::Key(Key::Escape)]);
    act(&mut console, &typed("2"));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(1))));
    assert_eq!(console.report(), Some(Report::Break));
    assert_eq!(fired(&mut console), Some(Measure::Choice(Some(2))));
}

#[test]
fn nothing_is_reported_while_nothing_is_started() {
    let mut console = console();
    act(&mut console, &click(10.0, 10.0));
    act(&mut console, &typed("1"));
    act(&mut console, &[Event::Key(Key::Escape), Event::Key(Key::Tab), Event::Key(Key::Return)]);
    assert_eq!(console.report(), None);
    assert!(console.is_idle());
}

#[test]
fn settings_without_sense_do_no_harm() {
    let upside_down = Rect { min: Point::new(0.2, 0.2), max: Point::new(0.1, 0.1) };
    let nothing = Rect::new(0.1, 0.1, 0.1, 0.1);
    for area in [upside_down, nothing] {
        for (class, setting) in [
            (InputClass::Locator, locator()),
            (InputClass::Stroke, stroke(0, f64::NAN)),
            (InputClass::Valuator, setting(Measure::Choice(None), Detail::Valuator { low: 9.0, high: -9.0 })),
            (
                InputClass::Valuator,
                setting(Measure::Valuator(0.0), Detail::Valuator { low: f64::MIN, high: f64::MAX }),
            ),
            (InputClass::Choice, choice(i32::MAX, &["a"])),
            (InputClass::Choice, choice(i32::MIN, &[])),
            (InputClass::Pick, setting(Measure::Pick(None), Detail::Pick { aperture: -1.0 })),
            (InputClass::String, setting(Measure::Pick(None), Detail::String { buffer: 0, cursor: 99 })),
        ] {
            let mut console = console();
            console.start(device(class), &Setting { area, within: area, ..setting });
            act(&mut console, &click(500.0, 500.0));
            act(&mut console, &typed("12a b"));
            let keys = [Key::Left, Key::Up, Key::Down, Key::Home, Key::End, Key::Delete, Key::Backspace];
            act(&mut console, &keys.map(Event::Key));
            act(&mut console, &[Event::Wheel(3.0), Event::Key(Key::Return)]);
            assert!(console.measure(device(class)).is_some());
        }
    }
}
