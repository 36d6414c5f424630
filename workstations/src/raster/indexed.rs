//! The indexed workstation: a frame buffer of colour indices with a colour look-up table, drawn by the classical
//! algorithms pixel by pixel, and image files with a palette.

use super::aliased::{Aliased, WIDE, rule};
use super::cells::{self, CellMap, Extent};
use super::clip::Window;
use super::describe::{Layout, SizeError};
use super::encode::{self, Care, Format, Samples};
use super::look_up_table::LookUpTable;
use crate::options::Options;
use gks_algorithms::rect::IRect;
use gks_algorithms::{circle, ellipse, path};
use gks_geometry::{Du, LongLine, Paths, Rect};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::{
    Device, DeviceError, Drawn, Fill, Form, FrameBuffer, Grid, Mark, Page, Pen, Sink, Surface,
};
use gks_pipeline::item::{Closure, Curve, Ellipse, Parallelogram};
use glam::IVec2;
use std::f64::consts::TAU;

/// A frame buffer of 8-bit colour indices, which may be written as an image file for each page.
///
/// It draws solid and long lines, areas, patterns, cells and thin ellipses without antialiasing; what is left to the
/// pipeline is text, markers, other dashes and curves, and the exact clipping of everything but cells and patterns.
pub struct Indexed {
    layout: Layout,
    surface: Surface,
    pixels: Vec<u8>,
    table: LookUpTable,
    background: Option<Colour>,
    care: Care,
    output: Option<(Box<dyn Sink>, Format)>,
    aliased: Aliased,
}

impl Indexed {
    /// A frame buffer of the size that options ask for, written to the sink at the end of each page if there
    /// is one.
    pub fn new(options: &Options, output: Option<(Box<dyn Sink>, Format)>) -> Result<Self, SizeError> {
        let longest = output.as_ref().map_or(u32::MAX, |(_, format)| format.longest_side());
        let layout = Layout::limited(options, longest)?;
        let clear = Colour { alpha: 0.0, ..Colour::BLACK };
        Ok(Indexed {
            layout,
            surface: layout.surface(),
            pixels: vec![0; layout.pixels()],
            table: LookUpTable::default(),
            background: if options.transparent { Some(clear) } else { options.background },
            care: Care::of(options),
            output,
            aliased: Aliased::new(),
        })
    }

    /// The colour index of every pixel, row by row from the top.
    pub fn indices(&self) -> &[u8] {
        &self.pixels
    }

    /// The colour that an index shows.
    pub fn colour_of(&self, index: u8) -> Colour {
        self.table.colour(index)
    }

    fn raster(&self) -> IRect {
        IRect::of_size(self.layout.width as i32, self.layout.height as i32)
    }

    /// Draws lines inside of the display surface.
    fn lines(&mut self, paths: Paths<'_, Du>, pen: &Pen<'_>) {
        let index = self.table.index(&pen.paint);
        let (pixels, width) = (&mut self.pixels, self.layout.width as usize);
        self.aliased.lines(paths, pen, &self.surface.extent(), |row, from, to| {
            pixels[row as usize * width..][from as usize..to as usize].fill(index);
        });
    }

    fn long_line(&mut self, line: &LongLine<'_, Du>, pen: &Pen<'_>) {
        let index = self.table.index(&pen.paint);
        let (pixels, width) = (&mut self.pixels, self.layout.width as usize);
        self.aliased.long_line(line, pen, &self.surface.extent(), |row, from, to| {
            pixels[row as usize * width..][from as usize..to as usize].fill(index);
        });
    }

    fn area(&mut self, rings: Paths<'_, Du>, rule: path::Rule, index: u8) {
        let (raster, width) = (self.raster(), self.layout.width as usize);
        let pixels = &mut self.pixels;
        self.aliased.area(rings, rule, raster, |row, from, to| {
            pixels[row as usize * width..][from as usize..to as usize].fill(index);
        });
    }

    fn pattern(
        &mut self,
        (rings, rule): (Paths<'_, Du>, path::Rule),
        clip: Option<Rect<Du>>,
        (frame, grid): (&Parallelogram<Du>, &Grid<'_>),
    ) {
        let Some(map) = CellMap::new(frame, grid) else { return };
        let (columns, rows) = self.window(clip).centred();
        let near = |at: u32| i32::try_from(at).unwrap_or(i32::MAX);
        let window = IRect::new(
            IVec2::new(near(columns.start), near(rows.start)),
            IVec2::new(near(columns.end), near(rows.end)),
        );
        let indices: Vec<u8> = grid.paints.iter().map(|paint| self.table.index(paint)).collect();
        let width = self.layout.width as usize;
        let pixels = &mut self.pixels;
        self.aliased.area(rings, rule, window, |row, from, to| {
            let line = &mut pixels[row as usize * width..][..width];
            for column in from..to {
                line[column as usize] = indices[map.tiled(column as u32, row as u32)];
            }
        });
    }

    fn cells(&mut self, frame: &Parallelogram<Du>, grid: &Grid<'_>, clip: Option<Rect<Du>>) {
        if grid.columns.checked_mul(grid.rows).is_none_or(|count| count > grid.paints.len()) {
            return;
        }
        let window = self.window(clip).centred();
        let width = self.layout.width as usize;
        let Indexed { table, pixels, .. } = self;
        let mut held = (usize::MAX, 0);
        let extent = Extent { columns: grid.columns, rows: grid.rows, stride: grid.columns };
        cells::lines(window, frame, extent, |line| {
            let at = line.pixels(width);
            if line.again {
                return pixels.copy_within(at.start - width..at.end - width, at.start);
            }
            for (pixel, place) in pixels[at].iter_mut().zip(line.places()) {
                if place != held.0 {
                    held = (place, table.index(&grid.paints[place]));
                }
                *pixel = held.1;
            }
        });
    }

    /// Draws a full ellipse one pixel wide.
    fn outline(&mut self, ellipse: &Ellipse<Du>, pen: &Pen<'_>) {
        let (centre, a, b) = (ellipse.centre.0, ellipse.a.0, ellipse.b.0);
        let radii = a.abs() + b.abs();
        let upright = (a.y == 0.0 && b.x == 0.0) || (a.x == 0.0 && b.y == 0.0);
        if !upright {
            let mut ring = Vec::new();
            ellipse::flatten(centre, a, b, ellipse.start, TAU, 0.1, &mut ring);
            ring.extend(ring.first().copied());
            return self.lines(Paths::new(&ring, &[ring.len() as u32]), pen);
        }
        let index = self.table.index(&pen.paint);
        let (raster, width) = (self.raster(), self.layout.width as usize);
        let (at, radii) = (centre.floor().as_ivec2(), radii.round().as_ivec2());
        let plot = |x: i32, y: i32| self.pixels[y as usize * width + x as usize] = index;
        if radii.x == radii.y {
            circle::midpoint(at, radii.x, raster, plot);
        } else {
            ellipse::midpoint(at, radii, raster, plot);
        }
    }

    fn window(&self, clip: Option<Rect<Du>>) -> Window {
        Window::new(clip, self.layout.width, self.layout.height, false)
    }
}

impl Device for Indexed {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.begin(page)?;
        Ok(Drawn::Yes)
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.table = LookUpTable::default();
        for &(index, colour) in &page.colours {
            if let Ok(index) = u8::try_from(index) {
                self.table.set(index, colour);
            }
        }
        self.table.set(0, self.background.unwrap_or(page.background));
        self.pixels.fill(0);
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        match (&mark.form, mark.clip) {
            (Form::Lines(paths, pen), None) if pen.dash.is_empty() => self.lines(*paths, pen),
            (Form::LongLine(line, pen), None) => self.long_line(line, pen),
            (Form::Area(rings, by, Fill::Solid(paint)), None) => {
                let index = self.table.index(paint);
                self.area(*rings, rule(*by), index);
            }
            (Form::Area(rings, by, Fill::Pattern(frame, grid)), clip) => {
                self.pattern((*rings, rule(*by)), clip, (frame, grid));
            }
            (Form::Cells(frame, grid), clip) => self.cells(frame, grid, clip),
            (Form::Stroke(Curve::Ellipse(ellipse), pen), None)
                if pen.width < WIDE && pen.dash.is_empty() && ellipse.closure == Closure::Full =>
            {
                self.outline(ellipse, pen);
            }
            _ => return Ok(Drawn::No),
        }
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        let Some((sink, format)) = &mut self.output else { return Ok(()) };
        let samples = Samples::Palette(&self.pixels, &self.table.to_bytes());
        encode::write(samples, self.layout, *format, self.care, sink.as_mut())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        Some(self)
    }
}

impl FrameBuffer for Indexed {
    fn size(&self) -> (u32, u32) {
        (self.layout.width, self.layout.height)
    }

    fn colour(&self, column: u32, row: u32) -> Option<Colour> {
        self.index(column, row).map(|index| self.table.colour(index as u8))
    }

    fn index(&self, column: u32, row: u32) -> Option<u32> {
        let inside = column < self.layout.width && row < self.layout.height;
        let at = row as usize * self.layout.width as usize + column as usize;
        inside.then(|| u32::from(self.pixels[at]))
    }

    fn set_colour(&mut self, index: u32, colour: Colour) -> bool {
        let Ok(index) = u8::try_from(index) else { return false };
        // A background that the user chose stays.
        if index > 0 || self.background.is_none() {
            self.table.set(index, colour);
        }
        true
    }

    fn set_antialiasing(&mut self, _: bool) -> bool {
        false
    }

    fn antialiasing(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::super::encode::tests::MemorySink;
    use super::*;
    use gks_algorithms::line::bresenham;
    use gks_geometry::{Point, Vector};
    use gks_pipeline::colour::Paint;
    use gks_pipeline::device::Rule;
    use gks_pipeline::look::{Cap, Join};
    use glam::DVec2;

    const COLOURS: [Colour; 5] = [
        Colour::WHITE,
        Colour::BLACK,
        Colour::rgb(1.0, 0.0, 0.0),
        Colour::rgb(0.0, 1.0, 0.0),
        Colour::rgb(0.0, 0.0, 1.0),
    ];

    fn device(options: &Options) -> Indexed {
        let mut device = Indexed::new(options, None).unwrap();
        let colours = (0..).zip(COLOURS).collect();
        device.begin(&Page { number: 1, background: COLOURS[0], colours }).unwrap();
        device
    }

    fn canvas(width: f64, height: f64) -> Indexed {
        device(&Options { size: Some((width, height)), ..Options::default() })
    }

    fn paint(index: u32) -> Paint {
        Paint { colour: COLOURS.get(index as usize).copied().unwrap_or(Colour::BLACK), index }
    }

    fn pen(index: u32, width: f64) -> Pen<'static> {
        Pen { paint: paint(index), width, dash: &[], cap: Cap::Butt, join: Join::Miter }
    }

    fn draw(device: &mut Indexed, form: Form<'_>, clip: Option<Rect<Du>>) {
        assert_eq!(device.draw(&Mark { form, clip }).unwrap(), Drawn::Yes);
    }

    fn line(device: &mut Indexed, points: &[(f64, f64)], pen: Pen<'_>) {
        let points: Vec<DVec2> = points.iter().map(|&p| p.into()).collect();
        draw(device, Form::Lines(Paths::new(&points, &[points.len() as u32]), pen), None);
    }

    fn picture(device: &Indexed) -> Vec<String> {
        let show = |&index: &u8| if index == 0 { '.' } else { char::from(b'0' + index) };
        device
            .indices()
            .chunks_exact(device.size().0 as usize)
            .map(|row| row.iter().map(show).collect())
            .collect()
    }

    fn ellipse(centre: (f64, f64), a: (f64, f64), b: (f64, f64)) -> Curve<'static, Du> {
        let (a, b, start, sweep, closure) = (a.into(), b.into(), 0.0, TAU, Closure::Full);
        Curve::Ellipse(Ellipse { centre: centre.into(), a, b, start, sweep, closure })
    }

    #[test]
    fn thin_and_wide_lines_and_dots() {
        let mut device = canvas(12.0, 7.0);
        line(&mut device, &[(0.0, 0.0), (12.0, 7.0)], pen(1, 1.0));
        line(&mut device, &[(8.0, 0.0), (8.0, 3.0), (12.0, 3.0)], pen(2, 2.0));
        line(&mut device, &[(2.5, 5.5)], pen(3, 1.0));
        line(&mut device, &[(5.0, 5.0)], Pen { cap: Cap::Projecting, ..pen(4, 3.9) });
        assert_eq!(
            picture(&device),
            [
                "1......22...",
                ".11....22...",
                "...11..22222",
                "...444422222",
                "...444411...",
                "..34444..11.",
                "...4444....1",
            ]
        );
    }

    #[test]
    fn dashes_take_as_many_pixels_as_they_are_long() {
        let mut device = canvas(16.0, 5.0);
        for (row, start) in [(0.5, 1.0), (1.5, 1.3), (2.5, 1.5), (3.5, 1.8)] {
            for (from, to) in [(0.0, 1.0), (3.0, 6.0), (9.0, 11.0)] {
                line(&mut device, &[(start + from, row), (start + to, row)], pen(1, 1.0));
            }
        }
        line(&mut device, &[(12.5, 4.5), (1.5, 4.5)], pen(2, 1.0));
        assert_eq!(
            picture(&device),
            [
                ".1..111...11....",
                ".1..111...11....",
                ".11.1111..111...",
                "..1..111...11...",
                ".222222222222...",
            ]
        );
    }

    #[test]
    fn vertices_left_out_make_no_difference() {
        let wave: Vec<DVec2> = (0..3000)
            .map(|i| DVec2::new(0.013 * f64::from(i), 10.0 + 9.5 * (f64::from(i * i % 977) * 0.7).sin()))
            .collect();
        let mut device = canvas(40.0, 20.0);
        let round = Pen { cap: Cap::Round, ..pen(1, 1.0) };
        draw(&mut device, Form::Lines(Paths::new(&wave, &[3000]), round), None);
        let mut expected = vec![0; 40 * 20];
        for pair in wave.windows(2) {
            let ends = [pair[0], pair[1]].map(|p| p.floor().as_ivec2());
            let mut plot = |x: i32, y: i32| expected[(y * 40 + x) as usize] = 1;
            bresenham(ends[0], ends[1], IRect::of_size(40, 20), &mut plot);
        }
        assert_eq!(device.indices(), expected);
        assert!(expected.contains(&0));
    }

    #[test]
    fn areas_patterns_and_cells_take_pixels_by_their_centre() {
        let mut device = canvas(12.0, 6.0);
        let square = [(0.4, 0.6), (4.4, 0.6), (4.4, 4.0), (0.4, 4.0)].map(DVec2::from);
        draw(&mut device, Form::Area(Paths::new(&square, &[4]), Rule::EvenOdd, Fill::Solid(paint(1))), None);
        let frame = |x, columns| Parallelogram {
            origin: Point::new(x, 1.0),
            columns: Vector::new(columns, 0.0),
            rows: Vector::new(0.0, 2.0),
        };
        let paints = [paint(2), paint(3), paint(4), paint(0)];
        let grid = Grid { paints: &paints, columns: 2, rows: 2 };
        let all = [(5.0, 0.0), (9.0, 0.0), (9.0, 6.0), (5.0, 6.0)].map(DVec2::from);
        let clip = Some(Rect::new(0.0, 12.0, 0.0, 4.5));
        let fill = Fill::Pattern(frame(5.0, 2.0), grid);
        draw(&mut device, Form::Area(Paths::new(&all, &[4]), Rule::EvenOdd, fill), clip);
        draw(&mut device, Form::Cells(frame(9.6, 2.0), grid), Some(Rect::new(0.0, 11.0, 0.0, 6.0)));
        assert_eq!(
            picture(&device),
            [".....4.4....", "1111.2323.2.", "1111.4.4..4.", "1111.2323...", "............", "............",]
        );
    }

    #[test]
    fn circles_and_ellipses_go_by_midpoints() {
        let mut device = canvas(21.0, 9.0);
        draw(&mut device, Form::Stroke(ellipse((4.5, 4.5), (0.0, 3.0), (-3.0, 0.0)), pen(1, 1.0)), None);
        draw(&mut device, Form::Stroke(ellipse((14.5, 4.5), (6.0, 0.0), (0.0, 2.0)), pen(2, 1.0)), None);
        assert_eq!(
            picture(&device),
            [
                ".....................",
                "...111...............",
                "..1...1....2222222...",
                ".1.....1.22.......22.",
                ".1.....12...........2",
                ".1.....1.22.......22.",
                "..1...1....2222222...",
                "...111...............",
                ".....................",
            ]
        );
        let mut device = canvas(9.0, 9.0);
        draw(&mut device, Form::Stroke(ellipse((4.5, 4.5), (3.0, 3.0), (-1.0, 1.0)), pen(1, 1.0)), None);
        assert_eq!((device.index(7, 7), device.index(4, 4), device.index(1, 1)), (Some(1), Some(0), Some(1)));
    }

    #[test]
    fn a_change_of_the_look_up_table_shows_at_once() {
        let mut device = canvas(4.0, 4.0);
        line(&mut device, &[(0.5, 0.5), (3.5, 0.5)], pen(2, 1.0));
        assert_eq!(device.colour(1, 0), Some(COLOURS[2]));
        assert!(device.set_colour(2, COLOURS[4]));
        assert_eq!((device.colour(1, 0), device.index(1, 0)), (Some(COLOURS[4]), Some(2)));
        assert!(device.set_colour(0, COLOURS[3]));
        assert_eq!(device.colour(1, 1), Some(COLOURS[3]));
        assert!(!device.set_colour(256, COLOURS[3]));
        assert_eq!((device.colour(4, 0), device.index(0, 4)), (None, None));
    }

    #[test]
    fn a_background_that_was_chosen_stays() {
        let blue = Some(COLOURS[4]);
        let mut device = device(&Options { background: blue, size: Some((2.0, 2.0)), ..Options::default() });
        assert_eq!(device.colour(0, 0), blue);
        assert!(device.set_colour(0, COLOURS[1]));
        assert_eq!(device.colour(0, 0), blue);
    }

    #[test]
    fn what_is_left_to_the_pipeline_is_refused_untouched() {
        let mut device = canvas(8.0, 8.0);
        let points = [DVec2::ZERO, DVec2::splat(8.0)];
        let paths = Paths::new(&points, &[2]);
        let clip = Some(Rect::new(0.0, 4.0, 0.0, 4.0));
        for (form, clip) in [
            (Form::Lines(paths, Pen { dash: &[2.0, 1.0], ..pen(1, 1.0) }), None),
            (Form::Lines(paths, pen(1, 1.0)), clip),
            (Form::Stroke(ellipse((4.0, 4.0), (3.0, 0.0), (0.0, 3.0)), pen(1, 4.0)), None),
            (Form::Filled(ellipse((4.0, 4.0), (3.0, 0.0), (0.0, 3.0)), paint(1)), None),
        ] {
            assert_eq!(device.draw(&Mark { form, clip }).unwrap(), Drawn::No);
        }
        assert!(device.indices().iter().all(|&index| index == 0));
    }

    #[test]
    fn far_and_bad_coordinates_neither_stop_nor_hang() {
        let mut device = canvas(20.0, 20.0);
        for far in [1e9, 1e40, 1e300, f64::INFINITY, f64::NAN] {
            let points = [(-far, 5.5), (far, 5.5), (5.5, far), (5.5, 5.5)].map(DVec2::from);
            for width in [0.0, 1.0, 7.0, 1e6] {
                draw(&mut device, Form::Lines(Paths::new(&points, &[1, 4]), pen(1, width)), None);
            }
            let fill = Fill::Solid(paint(2));
            draw(&mut device, Form::Area(Paths::new(&points, &[4]), Rule::NonZero, fill), None);
            for centre in [(far, 0.0), (5.0, 5.0)] {
                for (a, b) in [((far, 0.0), (0.0, far)), ((far, 0.0), (0.0, 2.0)), ((far, 1.0), (0.0, 2.0))] {
                    draw(&mut device, Form::Stroke(ellipse(centre, a, b), pen(3, 1.0)), None);
                }
            }
        }
    }

    #[test]
    fn a_page_becomes_a_file_with_its_palette() {
        let sink = MemorySink::default();
        let options = Options { size: Some((5.0, 3.0)), transparent: true, ..Options::default() };
        let mut device = Indexed::new(&options, Some((Box::new(sink.clone()), Format::Png))).unwrap();
        for number in 1..=2 {
            let colours = (0..).zip(COLOURS).collect();
            device.begin(&Page { number, background: COLOURS[0], colours }).unwrap();
            line(&mut device, &[(0.5, 1.5), (4.5, 1.5)], pen(number, 1.0));
            device.end().unwrap();
        }
        device.close().unwrap();
        let documents = sink.0.lock().unwrap();
        assert_eq!(documents.len(), 2);
        for (document, colour) in documents.iter().zip([[0, 0, 0, 255], [255, 0, 0, 255]]) {
            let picture = image::load_from_memory(document).unwrap().to_rgba8();
            assert_eq!((picture.get_pixel(4, 1).0, picture.get_pixel(4, 2).0), (colour, [0; 4]));
        }
    }
}
