//! Primitives and segments on a workstation.

use super::{Backend, Place, Workstation};
use crate::band::Band;
use crate::device::{Device, DeviceError, Drawn};
use crate::item::Item;
use crate::look::Look;
use crate::painter::Canvas;
use crate::recording::Recording;
use crate::segment::{Appearance, Segment};
use gks_geometry::{Dc, LongLine, Map, Ndc, Rect};

impl Workstation {
    /// Draws a primitive that is in no segment.
    pub fn draw(&mut self, item: &Item<'_>) -> Result<(), DeviceError> {
        self.loose = true;
        self.paint(item, None, false)?;
        self.present()
    }

    /// Draws a long line that is in no segment, if it can be drawn without holding its points; else nothing
    /// is drawn, and it has to come as a polyline.
    pub fn draw_long_line(
        &mut self,
        line: &LongLine<'_, Ndc>,
        look: &Look,
        clip: &Rect<Ndc>,
    ) -> Result<Drawn, DeviceError> {
        if self.copied.is_some() || !matches!(self.backend, Backend::Device(_)) {
            return Ok(Drawn::No);
        }
        self.loose = true;
        self.begin_page()?;
        self.empty = false;
        let Workstation { backend, description, tables, painter, map, current, .. } = self;
        let Backend::Device(device) = backend else { return Ok(Drawn::No) };
        let mut canvas = Canvas {
            device: &mut **device,
            surface: &description.surface,
            tables,
            map: *map,
            clip_map: *map,
            glow: false,
            window: current.window,
        };
        let drawn = painter.long_line(line, look, clip, &mut canvas)?;
        self.present()?;
        Ok(drawn)
    }

    /// Draws a primitive of the open segment, over what is there.
    pub fn draw_in_segment(&mut self, item: &Item<'_>, appearance: &Appearance) -> Result<(), DeviceError> {
        if appearance.highlighted && !self.has_segments() {
            self.paint(item, Some(&appearance.transformation), true)?;
        }
        self.kept = true;
        self.paint(item, Some(&appearance.transformation), false)?;
        self.present()
    }

    /// Draws a segment, over what is there.
    pub fn draw_segment(&mut self, segment: &Segment) -> Result<(), DeviceError> {
        self.kept = true;
        let drawn = self.paint_segment(segment, &segment.appearance);
        drawn.and(self.present())
    }

    /// Draws the primitives of a segment so that they belong to none: COPY SEGMENT TO WORKSTATION.
    pub fn copy_segment(&mut self, segment: &Segment) -> Result<(), DeviceError> {
        self.loose = true;
        if self.has_segments() {
            let mut copy = Recording::new();
            for item in &segment.recording {
                copy.clear();
                copy.push_mapped(&item, &segment.appearance.transformation);
                copy.iter().try_for_each(|item| self.paint(&item, None, false))?;
            }
            return Ok(());
        }
        let appearance = Appearance { highlighted: false, ..segment.appearance };
        let drawn = self.paint_segment(segment, &appearance);
        drawn.and(self.present())
    }

    /// Paints an item, moved by a segment transformation if there is one.
    fn paint(
        &mut self,
        item: &Item<'_>,
        transformation: Option<&Map<Ndc, Ndc>>,
        glow: bool,
    ) -> Result<(), DeviceError> {
        self.begin_page()?;
        self.empty = false;
        if let Some(copied) = &mut self.copied {
            copied.push_mapped(item, transformation.unwrap_or(&Map::IDENTITY));
        }
        let portable = if matches!(self.backend, Backend::Recorder(_) | Backend::Pictures(_)) {
            self.tables.portable(item.look)
        } else {
            None
        };
        let changed = portable.as_ref().map(|look| Item { look, ..*item });
        let item = changed.as_ref().unwrap_or(item);
        let Workstation { backend, description, tables, painter, map, current, moved, .. } = self;
        let device = match backend {
            Backend::Device(device) => &mut **device,
            Backend::Recorder(recorder) => return recorder.draw(item),
            Backend::Pictures(_) if glow => {
                return self.record_band(item, transformation.unwrap_or(&Map::IDENTITY));
            }
            Backend::Pictures(recorder) => {
                let moves = transformation.filter(|transformation| **transformation != Map::IDENTITY);
                let Some(transformation) = moves else { return recorder.draw(item) };
                moved.clear();
                moved.push_mapped(item, transformation);
                return moved.iter().try_for_each(|item| recorder.draw(&item));
            }
            Backend::Source(_) | Backend::Storage => return Ok(()),
        };
        let mut canvas = Canvas {
            device,
            surface: &description.surface,
            tables,
            map: transformation.map_or(*map, |transformation| transformation.then(map)),
            clip_map: *map,
            glow,
            window: current.window,
        };
        painter.paint(item, &mut canvas)
    }

    /// Draws the band of highlighting of an item in a metafile of pictures.
    fn record_band(&mut self, item: &Item<'_>, transformation: &Map<Ndc, Ndc>) -> Result<(), DeviceError> {
        let mut band = Band::new(&self.description.surface, &self.map);
        self.paint_on(&mut band, item, &self.in_picture(transformation), true)?;
        let Backend::Pictures(recorder) = &mut self.backend else { return Ok(()) };
        band.items(self.current.window).try_for_each(|line| recorder.draw(&line))
    }

    /// Paints an item on another device as it would be drawn here at a place, or the band of its highlighting.
    pub(crate) fn paint_on(
        &mut self,
        device: &mut dyn Device,
        item: &Item<'_>,
        place: &Place,
        glow: bool,
    ) -> Result<(), DeviceError> {
        let Workstation { description, tables, painter, .. } = self;
        let Place { map, clip_map, window } = *place;
        let surface = &description.surface;
        painter.paint(item, &mut Canvas { device, surface, tables, map, clip_map, glow, window })
    }

    /// The place in the picture of what a segment transformation moves.
    pub fn in_picture(&self, transformation: &Map<Ndc, Ndc>) -> Place {
        Place { map: transformation.then(&self.map), clip_map: self.map, window: self.current.window }
    }

    /// The place of the unit square of NDC where it fills an area on the display surface, in metres.
    pub fn in_area(&self, area: &Rect<Dc>) -> Place {
        let map = Map::window_to_viewport(&Rect::UNIT, area).then(&self.to_units());
        Place { map, clip_map: map, window: Rect::UNIT }
    }

    /// Draws the primitives of a segment, over the band of its highlighting.
    pub(super) fn paint_segment(
        &mut self,
        segment: &Segment,
        appearance: &Appearance,
    ) -> Result<(), DeviceError> {
        let Appearance { transformation, highlighted } = appearance;
        let mut items = segment.recording.iter();
        if *highlighted && !self.has_segments() {
            items.clone().try_for_each(|item| self.paint(&item, Some(transformation), true))?;
        }
        items.try_for_each(|item| self.paint(&item, Some(transformation), false))
    }
}
