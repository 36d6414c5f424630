//! Where the prompts that need room lie: menus, sliders, dials, text fields and readouts, in metres.

use gks_geometry::{Dc, Point, Rect};
use gks_pipeline::input::{Detail, InputClass, Setting};

/// What a panel shows.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A slider with its limits and its value.
    Slider,
    /// A dial with a needle.
    Dial,
    /// A number.
    Readout,
    /// The alternatives of a choice in rows and columns.
    Menu { rows: usize, columns: usize },
    /// The number of an alternative between two signs that change it.
    Stepper,
    /// A picture whose parts are alternatives.
    Picture,
    /// A line of text.
    Field,
}

/// A panel of a prompt.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Panel {
    pub(super) kind: Kind,
    /// The whole panel.
    pub(super) frame: Rect<Dc>,
    /// The height of capital letters.
    pub(super) letter: f64,
}

/// The height of capital letters that suits a display surface with this shorter side and this pixel, in metres.
pub(super) fn letter(side: f64, pixel: f64) -> f64 {
    (side * 0.0115).max(pixel * 8.0)
}

/// The most alternatives without names that are shown as a menu: there are as many function keys.
const MOST_NUMBERS: i32 = 12;
/// The width that is reserved for a character, in heights of capital letters.
const ADVANCE: f64 = 0.85;
/// The height of a row of a menu, in heights of capital letters.
const ROW: f64 = 2.5;

/// The panel for a setting, or none where nothing needs room. `order` counts the panels of the same kind of
/// device before it, which shall not cover one another.
pub(super) fn panel(setting: &Setting, class: InputClass, letter: f64, order: usize) -> Option<Panel> {
    if !setting.echo {
        return None;
    }
    let area = &setting.area;
    let (kind, width, height) = match (&setting.detail, setting.prompt) {
        (Detail::Locator, 6) | (Detail::Stroke { .. }, 2) | (Detail::Valuator { .. }, 3) => {
            (Kind::Readout, 20.0, 2.8)
        }
        (Detail::Valuator { .. }, 2) => (Kind::Dial, 13.0, 13.0),
        (Detail::Valuator { .. }, _) => (Kind::Slider, 30.0, 5.4),
        (Detail::Choice { .. }, _) if setting.picture.is_some() => {
            return Some(Panel { kind: Kind::Picture, frame: *area, letter });
        }
        (Detail::Choice { alternatives, names, enabled }, _)
            if *alternatives > MOST_NUMBERS && names.is_empty() && enabled.is_empty() =>
        {
            (Kind::Stepper, 17.0, 5.4)
        }
        (Detail::Choice { alternatives, names, .. }, _) => {
            let count = usize::try_from(*alternatives).ok()?.max(1);
            let longest = names.iter().map(|name| name.chars().count()).max().unwrap_or(0).max(8);
            let width = 5.0 + ADVANCE * longest as f64;
            // As many rows as the area has room for, as few columns as hold all.
            let room = ((area.height() / letter - 1.0) / ROW).floor().clamp(1.0, 64.0) as usize;
            let fit = ((area.width() / letter) / width).floor().clamp(1.0, 16.0) as usize;
            let columns = count.div_ceil(room).clamp(1, fit);
            let rows = count.div_ceil(columns);
            (Kind::Menu { rows, columns }, width * columns as f64, ROW * rows as f64 + 1.0)
        }
        (Detail::String { buffer, .. }, _) => {
            (Kind::Field, (3.0 + ADVANCE * (*buffer).min(60) as f64).max(24.0), 3.4)
        }
        _ => return None,
    };
    let (width, height) = (width * letter, height * letter);
    // A panel that the area has no room for fills it.
    let shrink = (area.height() / height).min(area.width() / width).clamp(0.2, 1.0);
    let (width, height) = (width.min(area.width()), height.min(area.height()));
    let right = matches!(class, InputClass::Choice | InputClass::Locator | InputClass::Stroke);
    let top = matches!(class, InputClass::Choice | InputClass::String);
    let gap = letter * 0.6;
    let margin = |room: f64, length: f64| gap.min((room - length) / 2.0).max(0.0);
    let (mx, my) = (margin(area.width(), width), margin(area.height(), height));
    let x = if right { area.max.x() - mx - width } else { area.min.x() + mx };
    let shift = order as f64 * (height + gap);
    let y = if top { area.max.y() - my - height - shift } else { area.min.y() + my + shift };
    // What no longer fits lies over the first one.
    let y = if y < area.min.y() || y + height > area.max.y() + 1e-12 {
        if top { area.max.y() - my - height } else { area.min.y() + my }
    } else {
        y
    };
    Some(Panel { kind, frame: Rect::new(x, x + width, y, y + height), letter: letter * shrink })
}

impl Panel {
    /// The row of a menu in which alternative `number`, from 1, is shown.
    pub(super) fn item(&self, number: usize) -> Option<Rect<Dc>> {
        let Kind::Menu { rows, columns } = self.kind else { return None };
        let at = number.checked_sub(1)?;
        let (column, row) = (at / rows, at % rows);
        if column >= columns {
            return None;
        }
        let pad = (self.letter * 0.5).min(self.frame.height() / 4.0);
        let (w, h) = (self.frame.width() / columns as f64, (self.frame.height() - 2.0 * pad) / rows as f64);
        let (x, y) = (self.frame.min.x() + w * column as f64, self.frame.max.y() - pad - h * row as f64);
        Some(Rect::new(x + pad * 0.8, x + w - pad * 0.8, y - h, y))
    }

    /// The alternative at a position, from 1.
    pub(super) fn item_at(&self, at: Point<Dc>) -> Option<usize> {
        let Kind::Menu { rows, columns } = self.kind else { return None };
        let first = self.item(1)?;
        let (width, height) = (self.frame.width() / columns as f64, first.height());
        let column = ((at.x() - self.frame.min.x()) / width).floor();
        let row = ((first.max.y() - at.y()) / height).floor();
        if !(0.0..columns as f64).contains(&column) || !(0.0..rows as f64).contains(&row) {
            return None;
        }
        let number = column as usize * rows + row as usize + 1;
        self.item(number).filter(|item| item.contains(at)).map(|_| number)
    }

    /// The signs of a stepper: where minus and plus are.
    pub(super) fn signs(&self) -> [Rect<Dc>; 2] {
        let frame = &self.frame;
        let side = (self.letter * 2.4).min(frame.width() / 3.0).min(frame.height() * 0.6);
        let (pad, y) = (self.letter * 0.8, frame.min.y() + frame.height() * 0.34);
        [frame.min.x() + pad, frame.max.x() - pad - side]
            .map(|x| Rect::new(x, x + side, y - side / 2.0, y + side / 2.0))
    }

    /// By how much a click on a stepper changes the number.
    pub(super) fn step_at(&self, at: Point<Dc>) -> i32 {
        let [minus, plus] = self.signs();
        i32::from(plus.contains(at)) - i32::from(minus.contains(at))
    }

    /// The ends of the track of a slider.
    pub(super) fn track(&self) -> (Point<Dc>, Point<Dc>) {
        let pad = (self.letter * 1.6).min(self.frame.width() / 4.0);
        let y = self.frame.min.y() + self.frame.height() * 0.3;
        (Point::new(self.frame.min.x() + pad, y), Point::new(self.frame.max.x() - pad, y))
    }

    /// The centre and the radius of a dial.
    pub(super) fn dial(&self) -> (Point<Dc>, f64) {
        let radius = self.frame.width().min(self.frame.height()) * 0.36;
        (Point::new(self.frame.centre().x(), self.frame.min.y() + self.frame.height() * 0.54), radius)
    }

    /// The part of the range, from 0 to 1, that a position on a slider or a dial means.
    pub(super) fn part_at(&self, at: Point<Dc>) -> Option<f64> {
        let part = match self.kind {
            Kind::Slider => {
                let (start, end) = self.track();
                (at.x() - start.x()) / (end.x() - start.x())
            }
            Kind::Dial => {
                let (centre, _) = self.dial();
                let from = at.0 - centre.0;
                // Clockwise from straight down, and the range over three quarters of a turn.
                let turn = (-from.x).atan2(-from.y).rem_euclid(std::f64::consts::TAU) / std::f64::consts::TAU;
                (turn - 0.125) / 0.75
            }
            _ => return None,
        };
        part.is_finite().then(|| part.clamp(0.0, 1.0))
    }

    /// The direction of the needle of a dial for a part of the range.
    pub(super) fn needle(part: f64) -> glam::DVec2 {
        let turn = (0.125 + 0.75 * part) * std::f64::consts::TAU;
        glam::DVec2::new(-turn.sin(), -turn.cos())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::input::Measure;

    fn setting(detail: Detail, prompt: i32, area: Rect<Dc>) -> Setting {
        Setting {
            echo: true,
            prompt,
            area,
            within: area,
            initial: Measure::Valuator(0.0),
            detail,
            picture: None,
        }
    }

    fn menu(alternatives: i32, area: Rect<Dc>, name: &str) -> Panel {
        let names = vec![name.to_owned(); if name.is_empty() { 0 } else { alternatives as usize }];
        let detail = Detail::Choice { alternatives, enabled: Vec::new(), names };
        panel(&setting(detail, 1, area), InputClass::Choice, 0.0023, 0).unwrap()
    }

    #[test]
    fn every_item_of_a_menu_is_where_it_is_found() {
        for (count, area) in [
            (1, Rect::new(0.0, 0.2, 0.0, 0.2)),
            (7, Rect::new(0.0, 0.2, 0.0, 0.2)),
            (100, Rect::new(0.0, 0.2, 0.0, 0.2)),
            (5, Rect::new(0.15, 0.16, 0.1, 0.11)),
        ] {
            let panel = menu(count, area, "name");
            assert!(area.grown(1e-9).contains_rect(&panel.frame), "{panel:?}");
            for number in 1..=count as usize {
                let item = panel.item(number).unwrap();
                assert!(panel.frame.grown(1e-9).contains_rect(&item));
                assert_eq!(panel.item_at(item.centre()), Some(number));
            }
            assert_eq!(panel.item_at(Point::new(-1.0, 0.0)), None);
        }
    }

    #[test]
    fn many_numbers_are_stepped_through_in_a_small_panel() {
        let area = Rect::new(0.0, 0.2, 0.0, 0.2);
        assert!(matches!(menu(12, area, "").kind, Kind::Menu { .. }));
        let panel = menu(256, area, "");
        assert_eq!(panel.kind, Kind::Stepper);
        assert!(panel.frame.width() * panel.frame.height() < 0.05 * area.width() * area.height());
        let [minus, plus] = panel.signs();
        assert!(panel.frame.contains_rect(&minus) && panel.frame.contains_rect(&plus));
        let steps = [minus, panel.frame, plus].map(|part| panel.step_at(part.centre()));
        assert_eq!(steps, [-1, 0, 1]);
    }

    #[test]
    fn sliders_and_dials_know_their_range() {
        let area = Rect::new(0.0, 0.2, 0.0, 0.2);
        let slider = panel(
            &setting(Detail::Valuator { low: 0.0, high: 1.0 }, 1, area),
            InputClass::Valuator,
            0.0023,
            0,
        );
        let slider = slider.unwrap();
        let (start, end) = slider.track();
        assert_eq!((slider.part_at(start), slider.part_at(end)), (Some(0.0), Some(1.0)));
        assert_eq!(slider.part_at(Point::new(9.0, 0.0)), Some(1.0));
        let dial = panel(
            &setting(Detail::Valuator { low: 0.0, high: 1.0 }, 2, area),
            InputClass::Valuator,
            0.0023,
            0,
        );
        let dial = dial.unwrap();
        let (centre, radius) = dial.dial();
        for part in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let at = Point::from_vec(centre.0 + Panel::needle(part) * radius);
            assert!((dial.part_at(at).unwrap() - part).abs() < 1e-9, "{part}");
        }
    }

    #[test]
    fn panels_of_one_kind_do_not_cover_one_another() {
        let area = Rect::new(0.0, 0.2, 0.0, 0.2);
        let slider = |order| {
            let detail = Detail::Valuator { low: 0.0, high: 1.0 };
            panel(&setting(detail, 1, area), InputClass::Valuator, 0.0023, order).unwrap().frame
        };
        assert!(!slider(0).meets(&slider(1)) && !slider(1).meets(&slider(2)));
        assert!(area.contains_rect(&slider(500)));
    }

    #[test]
    fn nothing_needs_room_without_echo() {
        let mut silent = setting(Detail::Valuator { low: 0.0, high: 1.0 }, 1, Rect::new(0.0, 0.2, 0.0, 0.2));
        silent.echo = false;
        assert_eq!(panel(&silent, InputClass::Valuator, 0.0023, 0), None);
        assert_eq!(panel(&setting(Detail::Locator, 2, silent.area), InputClass::Locator, 0.0023, 0), None);
    }
}
