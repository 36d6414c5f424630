//! Prompts and echoes: what shows the operator the measures of the devices that are started.
//!
//! The prompt and echo types are those of ISO 7942: for locators 2 crosshair, 3 tracking cross, 4 rubber band
//! line, 5 rectangle, 6 digits; for strokes 2 digits, 3 markers, 4 lines; for valuators 2 dial, 3 digits; for
//! choices a menu of names or numbers, 5 a picture; for picks the aperture and what is in it, which the kernel finds
//! for each type; for strings the text.

use super::console::Console;
use super::interaction::{Interaction, State, enabled};
use super::panel::{Kind, Panel};
use super::sketch::{Ink, Sketch};
use gks_geometry::{Dc, Point, Rect};
use gks_pipeline::device::DeviceError;
use gks_pipeline::input::{Detail, LogicalDevice};
use gks_pipeline::look::Horizontal;

/// The most alternatives of a menu that are drawn.
const MOST_ITEMS: usize = 2000;
/// The most points of a stroke that are marked.
const MOST_MARKERS: usize = 20_000;

type Done = Result<(), DeviceError>;

/// Draws all prompts and echoes; the answer is whether there are any.
pub(super) fn draw(console: &Console, sketch: &mut Sketch) -> Result<bool, DeviceError> {
    let mut any = false;
    let visible = || console.started().iter().filter(|interaction| interaction.setting.echo);
    for interaction in visible() {
        if !any {
            sketch.begin()?;
            any = true;
        }
        over_picture(interaction, sketch)?;
    }
    for interaction in visible() {
        if let Some(panel) = &interaction.panel {
            self::panel(interaction, panel, console.focus(), sketch)?;
        }
    }
    Ok(any)
}

/// Draws what appears where the measure is.
fn over_picture(interaction: &Interaction, sketch: &mut Sketch) -> Done {
    let within = &interaction.setting.within;
    let prompt = interaction.setting.prompt;
    match (&interaction.state, &interaction.setting.detail) {
        (State::Locator { at, initial }, _) => locator(*at, *initial, prompt, within, sketch),
        (State::Stroke { points, at, .. }, _) => stroke(points, *at, prompt, sketch),
        (State::Pick { at: Some(at) }, &Detail::Pick { aperture }) => {
            sketch.trace(&interaction.picked)?;
            let side = if aperture.is_finite() { aperture.clamp(0.0, 1.0) } else { 0.0 };
            let side = side.max(sketch.pixel * 4.0);
            square(*at, side, sketch)?;
            let reach = side + sketch.pixel * 7.0;
            for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                let end = |by: f64| Point::new(at.x() + x * by, at.y() + y * by);
                sketch.visible_line(&[end(side), end(reach)])?;
            }
            Ok(())
        }
        _ => Ok(()),
    }
}

fn locator(at: Point<Dc>, initial: Point<Dc>, prompt: i32, within: &Rect<Dc>, sketch: &mut Sketch) -> Done {
    match prompt {
        2 => {
            sketch.visible_line(&[Point::new(within.min.x(), at.y()), Point::new(within.max.x(), at.y())])?;
            sketch.visible_line(&[Point::new(at.x(), within.min.y()), Point::new(at.x(), within.max.y())])
        }
        4 => {
            sketch.visible_line(&[initial, at])?;
            anchor(initial, sketch)?;
            cross(at, 9.0, sketch)
        }
        5 => {
            let corners =
                [initial, Point::new(at.x(), initial.y()), at, Point::new(initial.x(), at.y()), initial];
            sketch.visible_line(&corners)?;
            anchor(initial, sketch)?;
            cross(at, 9.0, sketch)
        }
        3 => cross(at, 9.0, sketch),
        _ => cross(at, 14.0, sketch),
    }
}

/// A cross with an opening at the position itself.
fn cross(at: Point<Dc>, reach: f64, sketch: &mut Sketch) -> Done {
    let (near, far) = (sketch.pixel * 2.5, sketch.pixel * reach);
    for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let end = |by: f64| Point::new(at.x() + x * by, at.y() + y * by);
        sketch.visible_line(&[end(near), end(far)])?;
    }
    Ok(())
}

fn anchor(at: Point<Dc>, sketch: &mut Sketch) -> Done {
    sketch.disc(at, sketch.pixel * 5.0, Ink::Halo)?;
    sketch.disc(at, sketch.pixel * 3.5, Ink::Accent)
}

fn square(at: Point<Dc>, side: f64, sketch: &mut Sketch) -> Done {
    let [a, b, c, d] = Rect::new(at.x() - side, at.x() + side, at.y() - side, at.y() + side).corners();
    sketch.visible_line(&[a, b, c, d, a])
}

fn stroke(points: &[Point<Dc>], at: Option<Point<Dc>>, prompt: i32, sketch: &mut Sketch) -> Done {
    if prompt != 3 && points.len() > 1 {
        sketch.line(points, 4.5, Ink::Halo)?;
        sketch.line(points, 2.0, Ink::Accent)?;
    }
    if prompt != 4 || points.len() == 1 {
        // Of a long stroke the end, which the operator sees growing.
        for &point in &points[points.len().saturating_sub(MOST_MARKERS)..] {
            sketch.disc(point, sketch.pixel * 3.5, Ink::Halo)?;
            sketch.disc(point, sketch.pixel * 2.5, Ink::Accent)?;
        }
    }
    if let (Some(&last), Some(at)) = (points.last(), at)
        && prompt != 3
    {
        sketch.line(&[last, at], 1.25, Ink::Accent)?;
    }
    at.map_or(Ok(()), |at| cross(at, 9.0, sketch))
}

fn panel(
    interaction: &Interaction,
    panel: &Panel,
    focus: Option<LogicalDevice>,
    sketch: &mut Sketch,
) -> Done {
    let focused = focus == Some(interaction.device);
    let radius = panel.letter * 0.7;
    let edge = if focused { Ink::Accent } else { Ink::Faint };
    sketch.rounded(&panel.frame, radius, edge)?;
    let rim = sketch.pixel * 1.5;
    let inner = panel.frame.grown(-rim.min(panel.frame.width() / 4.0).min(panel.frame.height() / 4.0));
    // The rim only: what lies under a panel shall not shine in the colour of its edge.
    sketch.rounded(&inner, radius - rim, Ink::Line)?;
    let ground = if panel.kind == Kind::Picture { Ink::Paper } else { Ink::Panel };
    sketch.rounded(&inner, radius - rim, ground)?;
    match (panel.kind, &interaction.state, &interaction.setting.detail) {
        (Kind::Slider, &State::Valuator { value, held }, &Detail::Valuator { low, high }) => {
            slider(panel, (low, high, value), held, sketch)
        }
        (Kind::Dial, &State::Valuator { value, .. }, &Detail::Valuator { low, high }) => {
            dial(panel, (low, high, value), sketch)
        }
        (Kind::Menu { .. }, State::Choice { marked, .. }, Detail::Choice { alternatives, names, .. }) => {
            let count = usize::try_from(*alternatives).unwrap_or(0).min(MOST_ITEMS);
            for number in 1..=count {
                menu_item(interaction, panel, number, *marked, names, sketch)?;
            }
            Ok(())
        }
        (Kind::Stepper, State::Choice { marked, .. }, &Detail::Choice { alternatives, .. }) => {
            stepper(panel, *marked, alternatives, sketch)
        }
        (Kind::Picture, State::Choice { marked, at, .. }, _) => {
            if let Some(picture) = &interaction.setting.picture {
                sketch.trace(picture)?;
            }
            sketch.trace(&interaction.picked)?;
            let Some(marked) = marked.filter(|_| at.is_none()) else { return Ok(()) };
            let corner = Point::new(inner.min.x() + panel.letter, inner.min.y() + panel.letter * 1.2);
            sketch.text(corner, &marked.to_string(), panel.letter, Horizontal::Left, Ink::Accent)
        }
        (Kind::Field, State::String { text, cursor }, _) => field(panel, text, *cursor, sketch),
        (Kind::Readout, state, _) => {
            let text = match state {
                State::Valuator { value, .. } => number(*value),
                State::Locator { at, .. } => millimetres(*at),
                State::Stroke { points, at, .. } => match points.last().or(at.as_ref()) {
                    Some(&last) => format!("{}: {}", points.len(), millimetres(last)),
                    None => "0".to_owned(),
                },
                _ => return Ok(()),
            };
            let centre = panel.frame.centre();
            sketch.text(centre, &text, panel.letter, Horizontal::Centre, Ink::Text)
        }
        _ => Ok(()),
    }
}

fn stepper(panel: &Panel, marked: Option<i32>, alternatives: i32, sketch: &mut Sketch) -> Done {
    let letter = panel.letter;
    let signs = panel.signs();
    for (place, is_plus) in signs.iter().zip([false, true]) {
        sketch.rounded(place, letter * 0.5, Ink::Marked)?;
        let (centre, reach) = (place.centre(), place.width() * 0.22);
        let at = |x: f64, y: f64| Point::new(centre.x() + x * reach, centre.y() + y * reach);
        sketch.line(&[at(-1.0, 0.0), at(1.0, 0.0)], 2.0, Ink::Text)?;
        if is_plus {
            sketch.line(&[at(0.0, -1.0), at(0.0, 1.0)], 2.0, Ink::Text)?;
        }
    }
    let centre = panel.frame.centre().x();
    let caption = Point::new(centre, panel.frame.min.y() + panel.frame.height() * 0.78);
    let range = format!("Choice 1 to {alternatives}");
    sketch.text(caption, &range, letter * 0.8, Horizontal::Centre, Ink::Dim)?;
    let number = marked.map_or_else(|| "\u{2013}".to_owned(), |marked| marked.to_string());
    let place = Point::new(centre, signs[0].centre().y());
    sketch.text(place, &number, letter * 1.3, Horizontal::Centre, Ink::Text)
}

/// A number with as many digits as an operator can set.
fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e6).contains(&size) {
        let digits = (3 - size.log10().floor() as i32).clamp(0, 6) as usize;
        format!("{value:.digits$}")
    } else {
        format!("{value:.3e}")
    }
}

fn millimetres(at: Point<Dc>) -> String {
    format!("{:.1}, {:.1} mm", at.x() * 1000.0, at.y() * 1000.0)
}

/// Where a value lies in its range, from 0 to 1.
fn part((low, high, value): (f64, f64, f64)) -> f64 {
    let part = (value / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0);
    if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.0 }
}

fn slider(panel: &Panel, range: (f64, f64, f64), held: bool, sketch: &mut Sketch) -> Done {
    let (start, end) = panel.track();
    let knob = Point::from_vec(start.0.lerp(end.0, part(range)));
    let thickness = (panel.letter * 0.45 / sketch.pixel).max(2.0);
    sketch.line(&[start, end], thickness, Ink::Faint)?;
    sketch.line(&[start, knob], thickness, Ink::Accent)?;
    sketch.disc(knob, panel.letter * 0.75, Ink::Text)?;
    sketch.disc(knob, panel.letter * if held { 0.62 } else { 0.4 }, Ink::Accent)?;
    let y = panel.frame.min.y() + panel.frame.height() * 0.72;
    let small = panel.letter * 0.8;
    sketch.text(Point::new(start.x(), y), &number(range.0), small, Horizontal::Left, Ink::Dim)?;
    sketch.text(Point::new(end.x(), y), &number(range.1), small, Horizontal::Right, Ink::Dim)?;
    let centre = Point::new(panel.frame.centre().x(), y);
    sketch.text(centre, &number(range.2), panel.letter, Horizontal::Centre, Ink::Text)
}

fn dial(panel: &Panel, range: (f64, f64, f64), sketch: &mut Sketch) -> Done {
    let (centre, radius) = panel.dial();
    let at = |part: f64, share: f64| Point::from_vec(centre.0 + Panel::needle(part) * radius * share);
    let arc = |to: f64| -> Vec<Point<Dc>> { (0..=60).map(|i| at(to * f64::from(i) / 60.0, 1.0)).collect() };
    let thickness = (panel.letter * 0.45 / sketch.pixel).max(2.0);
    sketch.line(&arc(1.0), thickness, Ink::Faint)?;
    sketch.line(&arc(part(range)), thickness, Ink::Accent)?;
    for tick in 0..=10 {
        let tick = f64::from(tick) / 10.0;
        sketch.line(&[at(tick, 0.8), at(tick, 0.88)], 1.5, Ink::Dim)?;
    }
    sketch.line(&[centre, at(part(range), 0.74)], 3.0, Ink::Text)?;
    sketch.disc(centre, panel.letter * 0.45, Ink::Text)?;
    let bottom = Point::new(centre.x(), panel.frame.min.y() + panel.letter * 1.3);
    sketch.text(bottom, &number(range.2), panel.letter, Horizontal::Centre, Ink::Text)
}

fn menu_item(
    interaction: &Interaction,
    panel: &Panel,
    at: usize,
    marked: Option<i32>,
    names: &[String],
    sketch: &mut Sketch,
) -> Done {
    let (Some(item), Ok(number)) = (panel.item(at), i32::try_from(at)) else { return Ok(()) };
    let offered = enabled(&interaction.setting, number);
    if marked == Some(number) {
        sketch.rounded(&item.grown(-sketch.pixel), panel.letter * 0.5, Ink::Marked)?;
    }
    let y = item.centre().y();
    let letter = panel.letter.min(item.height() * 0.5);
    let shift = (letter * 2.4).min(item.width() * 0.3);
    let left = Point::new(item.min.x() + shift, y);
    let ink = if offered { Ink::Accent } else { Ink::Dim };
    let ink = if marked == Some(number) { Ink::Text } else { ink };
    sketch.text(left, &number.to_string(), letter * 0.8, Horizontal::Right, ink)?;
    let name = names.get(at - 1).map(|name| name.trim()).filter(|name| !name.is_empty());
    let name = name.map_or_else(|| format!("Choice {number}"), str::to_owned);
    let ink = if offered { Ink::Text } else { Ink::Dim };
    let text = Point::new(left.x() + letter * 0.9, y);
    sketch.text(text, &name, letter, Horizontal::Left, ink)?;
    if !offered {
        let end = Point::new(item.max.x() - letter * 0.5, y);
        sketch.line(&[text, end], 1.0, Ink::Dim)?;
    }
    Ok(())
}

/// The text around the cursor, as much as there is room for, in letters of one width.
fn field(panel: &Panel, text: &[char], cursor: usize, sketch: &mut Sketch) -> Done {
    let letter = panel.letter;
    let step = letter * 0.85;
    let left = panel.frame.min.x() + letter;
    let room = (((panel.frame.width() - 2.0 * letter) / step).floor() as usize).clamp(1, 1000);
    let first = (cursor + 1).saturating_sub(room);
    let y = panel.frame.centre().y();
    for (at, character) in text.iter().skip(first).take(room).enumerate() {
        let x = left + step * (at as f64 + 0.5);
        let mut bytes = [0; 4];
        let shown = character.encode_utf8(&mut bytes);
        sketch.text(Point::new(x, y), shown, letter, Horizontal::Centre, Ink::Text)?;
    }
    let x = left + step * (cursor.min(text.len()) - first.min(cursor)) as f64;
    let reach = letter * 0.95;
    sketch.line(&[Point::new(x, y - reach), Point::new(x, y + reach)], 2.0, Ink::Accent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_matter() {
        let shown = [0.0, 1.0, -12.345_67, 0.001, 0.000_1, 99_999.4, 1e6, -1e300].map(number);
        assert_eq!(shown, ["0", "1.000", "-12.35", "0.001000", "1.000e-4", "99999", "1.000e6", "-1.000e300"]);
    }

    #[test]
    fn a_value_is_a_part_of_its_range() {
        assert_eq!(part((0.0, 10.0, 2.5)), 0.25);
        assert_eq!(part((f64::MIN, f64::MAX, 0.0)), 0.5);
        assert_eq!(part((1.0, 1.0, 1.0)), 0.0);
        assert_eq!(part((10.0, 0.0, 2.5)), 0.75);
    }
}
