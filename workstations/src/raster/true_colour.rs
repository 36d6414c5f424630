//! The true-colour workstation: a frame buffer of colours, antialiased, and image files of it.

use super::aliased::{Aliased, rule};
use super::bitmap::Bitmap;
use super::cells::{self, Extent};
use super::clip::Window;
use super::composite::{Pixel, colour, over, over_run, pixel};
use super::describe::{Layout, SizeError};
use super::encode::{self, Care, Format, Samples};
use super::letters::Letters;
use super::lines::Lines;
use super::markers::Markers;
use super::pattern;
use crate::options::Options;
use gks_algorithms::coverage::AreaMask;
use gks_algorithms::path;
use gks_algorithms::rect::IRect;
use gks_geometry::{Du, LongLine, PathBuf, Paths, Rect};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::device::{
    Device, DeviceError, Drawn, Fill, Form, FrameBuffer, Grid, Mark, Page, Palette, Pen, Rule, Sink, Surface,
};
use gks_pipeline::item::{Cells, Parallelogram};
use glam::IVec2;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What the arithmetic of maps may lose, in pixels.
const LAST_DIGITS: f64 = 1e-6;

/// A frame buffer of colours, which may be written as an image file for each page.
///
/// It draws solid lines, markers, characters of stroke fonts, areas, patterns and cells; what is left to the pipeline are
/// other characters, dashes, curves, and the exact clipping of everything but cells and patterns.
pub struct TrueColour {
    layout: Layout,
    surface: Surface,
    canvas: Arc<Mutex<Bitmap>>,
    background: Option<Colour>,
    transparent: bool,
    /// Whether every pixel is opaque.
    opaque: bool,
    antialias: bool,
    care: Care,
    output: Option<(Box<dyn Sink>, Format)>,
    lines: Lines,
    markers: Markers,
    letters: Letters,
    areas: AreaMask,
    aliased: Aliased,
}

/// A handle to the pixels of a [`TrueColour`], by which a program reads what has been drawn so far, also
/// after the workstation is closed.
#[derive(Clone)]
pub struct SharedPixels {
    canvas: Arc<Mutex<Bitmap>>,
}

impl SharedPixels {
    /// Number of columns and rows.
    pub fn size(&self) -> (u32, u32) {
        lock(&self.canvas).size()
    }

    /// Calls `read` with the pixels: red, green, blue and opacity, one byte each, premultiplied by the opacity,
    /// row by row from the top. Nothing is drawn until it returns.
    pub fn read<R>(&self, read: impl FnOnce(&[u8]) -> R) -> R {
        read(lock(&self.canvas).bytes())
    }
}

fn lock(canvas: &Mutex<Bitmap>) -> MutexGuard<'_, Bitmap> {
    canvas.lock().unwrap_or_else(PoisonError::into_inner)
}

impl TrueColour {
    /// A frame buffer of the size that options ask for, written to the sink at the end of each page if there
    /// is one.
    pub fn new(options: &Options, output: Option<(Box<dyn Sink>, Format)>) -> Result<Self, SizeError> {
        let longest = output.as_ref().map_or(u32::MAX, |(_, format)| format.longest_side());
        let layout = Layout::limited(options, longest)?;
        Ok(TrueColour {
            layout,
            surface: layout.surface(),
            canvas: Arc::new(Mutex::new(Bitmap::new(layout.width, layout.height))),
            background: options.background,
            transparent: options.transparent,
            opaque: false,
            antialias: options.antialias.unwrap_or(true),
            care: Care::of(options),
            output,
            lines: Lines::new(),
            markers: Markers::new(),
            letters: Letters::new(),
            areas: AreaMask::new(),
            aliased: Aliased::new(),
        })
    }

    /// A handle to the pixels.
    pub fn shared(&self) -> SharedPixels {
        SharedPixels { canvas: Arc::clone(&self.canvas) }
    }

    /// Writes the picture as it is now as an image file.
    pub fn write(&self, sink: &mut dyn Sink, format: Format) -> Result<(), DeviceError> {
        let canvas = lock(&self.canvas);
        let samples =
            if self.opaque { Samples::Opaque(canvas.bytes()) } else { Samples::Rgba(canvas.demultiplied()) };
        encode::write(samples, self.layout, format, self.care, sink)
    }

    fn raster(&self) -> IRect {
        IRect::of_size(self.layout.width as i32, self.layout.height as i32)
    }

    /// Whether a clipping rectangle takes nothing away of the frame buffer.
    fn leaves_all(&self, clip: Option<Rect<Du>>) -> bool {
        // The maps that lead to device units leave their last digits in its edges.
        clip.is_none_or(|clip| clip.grown(LAST_DIGITS).contains_rect(&self.surface.extent()))
    }

    fn lines(&mut self, paths: Paths<'_, Du>, pen: &Pen<'_>) {
        let mut canvas = lock(&self.canvas);
        if self.antialias {
            return self.lines.draw(&mut canvas, paths, pen);
        }
        let above = pixel(pen.paint.colour);
        let surface = self.surface.extent();
        if above[3] == 255 {
            self.aliased.lines(paths, pen, &surface, |row, from, to| {
                canvas.span(row as usize, from as usize..to as usize).fill(above);
            });
        } else {
            let mut once = self.lines.once(self.raster());
            self.aliased.lines(paths, pen, &surface, |row, from, to| once.span(row, from, to));
            once.draw(&mut canvas, above);
        }
    }

    fn long_line(&mut self, line: &LongLine<'_, Du>, pen: &Pen<'_>) {
        if self.antialias {
            return self.lines.draw_long(&mut lock(&self.canvas), line, pen);
        }
        let mut paths = PathBuf::new();
        paths.add_pieces(line);
        self.lines(paths.as_paths(), pen);
    }

    /// Fills rings with one colour.
    ///
    /// Where two areas share a pixel, each covers a part of it, and what is below shows through both. So a pixel of an
    /// opaque fill area counts as covered twice as much as it is: one of two neighbours covers at least half of it and
    /// takes it whole, and no seam is left. The boundary stays antialiased, over half a pixel.
    fn area(&mut self, rings: Paths<'_, Du>, by: Rule, paint: &Paint) {
        let mut canvas = lock(&self.canvas);
        let above = pixel(paint.colour);
        let raster = self.raster();
        if !self.antialias {
            let put = |row: i32, from: i32, to: i32| {
                over_run(canvas.span(row as usize, from as usize..to as usize), above, 255);
            };
            return self.aliased.area(rings, rule(by), raster, put);
        }
        let Some(bounds) = rings.bounds() else { return };
        let (columns, rows) =
            Window::new(None, self.layout.width, self.layout.height, true).touched_by(&bounds);
        let corner = |column: u32, row: u32| IVec2::new(column as i32, row as i32);
        canvas.touch(columns.clone(), rows.clone());
        let window = IRect::new(corner(columns.start, rows.start), corner(columns.end, rows.end));
        let times = if by == Rule::EvenOdd && above[3] == 255 { 2 } else { 1 };
        self.areas.runs(rings.points, rings.ends, rule(by), window, |row, from, to, covered| {
            let run = canvas.span(row as usize, from as usize..to as usize);
            over_run(run, above, covered.saturating_mul(times));
        });
    }

    fn pattern(
        &mut self,
        (rings, rule): (Paths<'_, Du>, path::Rule),
        clip: Option<Rect<Du>>,
        (frame, grid): (&Parallelogram<Du>, &Grid<'_>),
    ) {
        let window = Window::new(clip, self.layout.width, self.layout.height, self.antialias);
        let mut canvas = lock(&self.canvas);
        if self.antialias {
            return pattern::fill(&mut canvas, &mut self.areas, (rings, rule), &window, (frame, grid));
        }
        pattern::fill_whole(&mut canvas, &mut self.aliased, (rings, rule), &window, (frame, grid));
    }

    fn cells(&self, frame: &Parallelogram<Du>, grid: &Grid<'_>, window: &Window) {
        if grid.columns.checked_mul(grid.rows).is_none_or(|count| count > grid.paints.len()) {
            return;
        }
        let opaque = grid.paints.iter().all(|paint| paint.colour.to_bytes()[3] == 255);
        let mut held = (usize::MAX, [0; 4]);
        let mut colour = |place: usize| {
            if place != held.0 {
                held = (place, pixel(grid.paints[place].colour));
            }
            held.1
        };
        let mut canvas = lock(&self.canvas);
        let width = canvas.size().0 as usize;
        let extent = Extent { columns: grid.columns, rows: grid.rows, stride: grid.columns };
        cells::lines(window.centred(), frame, extent, |line| {
            let pixels = line.pixels(width);
            if line.again && opaque {
                let above = pixels.start - width..pixels.end - width;
                return canvas.pixels_mut().copy_within(above, pixels.start);
            }
            let below = &mut canvas.pixels_mut()[pixels];
            below.iter_mut().zip(line.places()).for_each(|(below, place)| over(below, colour(place), 255));
        });
    }

    /// Draws cells of colour indices. Those from 0 to 255 are looked up in a table of pixels.
    fn indexed_cells(
        &self,
        frame: &Parallelogram<Du>,
        cells: &Cells<'_>,
        palette: &Palette<'_>,
        window: &Window,
    ) {
        let shown = |index: i32| pixel(palette.paint(index).colour);
        let table: [Pixel; 256] = std::array::from_fn(|index| shown(index as i32));
        let opaque = table.iter().all(|pixel| pixel[3] == 255);
        let (indices, stride) = cells.indices();
        let mut plain = false;
        let mut canvas = lock(&self.canvas);
        let width = canvas.size().0 as usize;
        let extent = Extent { columns: cells.columns, rows: cells.rows, stride };
        cells::lines(window.centred(), frame, extent, |line| {
            let pixels = line.pixels(width);
            if line.again && plain {
                let above = pixels.start - width..pixels.end - width;
                return canvas.pixels_mut().copy_within(above, pixels.start);
            }
            let below = &mut canvas.pixels_mut()[pixels];
            let row = &indices[line.base..];
            let is_known = |index: i32| index & 255 == index;
            if opaque && line.consecutive && !below.is_empty() {
                let row = &row[line.offsets[0]..][..below.len()];
                plain = is_known(row.iter().fold(0, |bits, index| bits | index));
                if plain {
                    let pairs = below.iter_mut().zip(row);
                    return pairs.for_each(|(below, &index)| *below = table[usize::from(index as u8)]);
                }
            }
            plain = opaque;
            for (below, &offset) in below.iter_mut().zip(line.offsets) {
                let index = row[offset];
                if is_known(index) {
                    over(below, table[usize::from(index as u8)], 255);
                } else {
                    plain = false;
                    over(below, shown(index), 255);
                }
            }
        });
    }
}

impl Device for TrueColour {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.begin(page)?;
        Ok(Drawn::Yes)
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        let background = match (self.transparent, self.background) {
            (true, _) => Colour { alpha: 0.0, ..Colour::BLACK },
            (false, Some(colour)) => colour,
            (false, None) => page.background,
        };
        self.opaque = background.to_bytes()[3] == 255;
        lock(&self.canvas).fill(pixel(background));
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let (width, height) = (self.layout.width, self.layout.height);
        match (&mark.form, mark.clip) {
            (Form::Lines(paths, pen), None) if pen.dash.is_empty() => self.lines(*paths, pen),
            (Form::LongLine(line, pen), None) if pen.dash.is_empty() => self.long_line(line, pen),
            (Form::Area(rings, by, Fill::Solid(paint)), None) => self.area(*rings, *by, paint),
            (Form::Area(rings, by, Fill::Pattern(frame, grid)), clip) => {
                self.pattern((*rings, rule(*by)), clip, (frame, grid));
            }
            (Form::Markers(positions, style), clip)
                if self.antialias && Markers::can(style) && self.leaves_all(clip) =>
            {
                self.markers.draw(&mut lock(&self.canvas), positions, style);
            }
            (Form::StrokeText(text), clip)
                if self.antialias && Letters::can(text) && self.leaves_all(clip) =>
            {
                self.letters.draw(&mut lock(&self.canvas), text);
            }
            (Form::Cells(frame, grid), clip) => {
                self.cells(frame, grid, &Window::new(clip, width, height, self.antialias));
            }
            (Form::IndexedCells(frame, cells, palette), clip) => {
                self.indexed_cells(frame, cells, palette, &Window::new(clip, width, height, self.antialias));
            }
            _ => return Ok(Drawn::No),
        }
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        let Some((mut sink, format)) = self.output.take() else { return Ok(()) };
        let written = self.write(sink.as_mut(), format);
        self.output = Some((sink, format));
        written
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        Some(self)
    }
}

impl FrameBuffer for TrueColour {
    fn size(&self) -> (u32, u32) {
        (self.layout.width, self.layout.height)
    }

    fn colour(&self, column: u32, row: u32) -> Option<Colour> {
        lock(&self.canvas).pixel(column, row).map(colour)
    }

    fn index(&self, _: u32, _: u32) -> Option<u32> {
        None
    }

    fn set_colour(&mut self, _: u32, _: Colour) -> bool {
        false
    }

    fn set_antialiasing(&mut self, on: bool) -> bool {
        self.antialias = on;
        true
    }

    fn antialiasing(&self) -> bool {
        self.antialias
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::{Point, Vector};
    use gks_pipeline::item::Curve;
    use gks_pipeline::look::{Cap, Join};
    use glam::DVec2;

    const BLACK: Paint = Paint { colour: Colour::BLACK, index: 1 };
    const RED: Paint = Paint { colour: Colour::rgb(1.0, 0.0, 0.0), index: 2 };
    const HALF: Paint = Paint { colour: Colour { alpha: 0.5, ..Colour::BLACK }, index: 3 };

    fn canvas(width: f64, height: f64) -> TrueColour {
        let options = Options { size: Some((width, height)), ..Options::default() };
        let mut device = TrueColour::new(&options, None).unwrap();
        device.begin(&Page { number: 1, background: Colour::WHITE, colours: vec![] }).unwrap();
        device
    }

    fn draw(device: &mut TrueColour, form: Form<'_>, clip: Option<Rect<Du>>) {
        assert_eq!(device.draw(&Mark { form, clip }).unwrap(), Drawn::Yes);
    }

    fn pen(paint: Paint, width: f64) -> Pen<'static> {
        Pen { paint, width, dash: &[], cap: Cap::Butt, join: Join::Miter }
    }

    fn points(of: &[(f64, f64)]) -> Vec<DVec2> {
        of.iter().map(|&p| p.into()).collect()
    }

    fn rectangle(x0: f64, x1: f64, y0: f64, y1: f64) -> Vec<DVec2> {
        points(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
    }

    /// The green component of every pixel, row by row: 0 where black or red was drawn, 255 on white.
    fn greens(device: &TrueColour) -> Vec<Vec<u8>> {
        let (width, _) = device.size();
        device.shared().read(|bytes| {
            let rows = bytes.chunks_exact(width as usize * 4);
            rows.map(|row| row.chunks_exact(4).map(|p| p[1]).collect()).collect()
        })
    }

    #[test]
    fn areas_follow_their_rule_and_cover_pixels_in_part() {
        for (rule, inner) in [(Rule::EvenOdd, 255), (Rule::NonZero, 0)] {
            let mut device = canvas(8.0, 8.0);
            let mut rings = rectangle(1.0, 7.0, 1.0, 6.5);
            rings.extend(rectangle(3.0, 5.0, 3.0, 5.0));
            draw(&mut device, Form::Area(Paths::new(&rings, &[4, 8]), rule, Fill::Solid(BLACK)), None);
            let g = greens(&device);
            assert_eq!((g[0][0], g[1][1], g[2][2], g[7][3]), (255, 0, 0, 255));
            assert_eq!(g[4][4], inner);
            // Opaque fill areas take pixels that they cover by half, so that neighbours leave no seam.
            let half = if rule == Rule::EvenOdd { 0..=2 } else { 120..=135 };
            assert!(half.contains(&g[6][3]), "{}", g[6][3]);
        }
    }

    #[test]
    fn areas_with_a_common_boundary_leave_no_seam() {
        let mut device = canvas(20.0, 20.0);
        let left = points(&[(2.0, 2.0), (9.3, 2.0), (12.8, 18.0), (2.0, 18.0)]);
        let right = points(&[(9.3, 2.0), (18.0, 2.0), (18.0, 18.0), (12.8, 18.0)]);
        for ring in [left, right] {
            draw(&mut device, Form::Area(Paths::new(&ring, &[4]), Rule::EvenOdd, Fill::Solid(BLACK)), None);
        }
        let g = greens(&device);
        assert!(g[3..17].iter().all(|row| row[3..17].iter().all(|&v| v <= 2)), "{g:?}");
    }

    #[test]
    fn without_antialiasing_there_are_only_two_colours() {
        let mut device = canvas(20.0, 20.0);
        assert!(device.set_antialiasing(false) && !device.antialiasing());
        let line = points(&[(1.0, 2.0), (18.0, 9.0), (3.0, 18.5)]);
        draw(&mut device, Form::Lines(Paths::new(&line, &[3]), pen(BLACK, 1.0)), None);
        draw(&mut device, Form::Lines(Paths::new(&line[1..2], &[1]), pen(BLACK, 3.0)), None);
        draw(&mut device, Form::Area(Paths::new(&line, &[3]), Rule::EvenOdd, Fill::Solid(BLACK)), None);
        let g = greens(&device).concat();
        assert!(g.iter().all(|&v| v == 0 || v == 255));
        assert!(g.iter().filter(|&&v| v == 0).count() > 100);
    }

    #[test]
    fn a_translucent_line_that_crosses_itself_has_one_opacity() {
        for width in [1.0, 4.0] {
            let mut device = canvas(40.0, 40.0);
            let cross = points(&[(2.5, 20.5), (37.5, 20.5), (20.5, 37.5), (20.5, 2.5)]);
            draw(&mut device, Form::Lines(Paths::new(&cross, &[4]), pen(HALF, width)), None);
            let g = greens(&device);
            assert!(g[20][10].abs_diff(127) <= 1, "{}", g[20][10]);
            assert_eq!(g[20][20], g[20][10], "at the crossing");
            assert!(g.concat().iter().all(|&v| v >= g[20][10]));
        }
    }

    #[test]
    fn a_long_wide_line_is_drawn_whole() {
        let mut device = canvas(600.0, 100.0);
        let wave: Vec<DVec2> = (0..4000)
            .map(|i| DVec2::new(20.0 + 0.14 * f64::from(i), 50.0 + 30.0 * (f64::from(i) * 0.01).sin()))
            .collect();
        let wide = Pen { cap: Cap::Projecting, ..pen(BLACK, 8.0) };
        draw(&mut device, Form::Lines(Paths::new(&wave, &[4000]), wide), None);
        let g = greens(&device);
        for p in &wave {
            assert_eq!(g[p.y as usize][p.x as usize], 0, "{p}");
        }
        assert_eq!(g[49][17], 0, "a projecting end");
        assert_eq!(g[49][14], 255);
    }

    #[test]
    fn dots_are_as_wide_as_the_pen() {
        let mut device = canvas(30.0, 10.0);
        let dots = points(&[(4.5, 4.5), (10.0, 5.0), (20.0, 5.0)]);
        draw(&mut device, Form::Lines(Paths::new(&dots[..1], &[1]), pen(BLACK, 1.0)), None);
        draw(&mut device, Form::Lines(Paths::new(&dots[1..2], &[1]), pen(BLACK, 4.0)), None);
        let round = Pen { cap: Cap::Round, ..pen(BLACK, 6.0) };
        draw(&mut device, Form::Lines(Paths::new(&dots[2..], &[1]), round), None);
        let g = greens(&device);
        let black = |columns: std::ops::Range<usize>| {
            g.iter().map(|row| row[columns.clone()].iter().filter(|&&v| v == 0).count()).sum::<usize>()
        };
        assert_eq!((black(0..7), g[4][4]), (1, 0));
        assert_eq!(black(7..14), 16);
        let ink: f64 = g.iter().flat_map(|row| &row[15..26]).map(|&v| 1.0 - f64::from(v) / 255.0).sum();
        assert!((ink - 9.0 * std::f64::consts::PI).abs() < 1.0, "{ink}");
    }

    #[test]
    fn a_cell_fills_the_pixels_whose_centre_it_contains() {
        let mut device = canvas(6.0, 4.0);
        let frame = Parallelogram {
            origin: Point::new(0.6, 0.4),
            columns: Vector::new(4.0, 0.0),
            rows: Vector::new(0.0, 2.2),
        };
        let grid = Grid { paints: &[BLACK, RED], columns: 2, rows: 1 };
        draw(&mut device, Form::Cells(frame, grid), Some(Rect::new(0.0, 6.0, 0.0, 1.8)));
        let colours =
            |row| -> Vec<[u8; 4]> { (0..6).map(|c| device.colour(c, row).unwrap().to_bytes()).collect() };
        let (w, b, r) = ([255; 4], [0, 0, 0, 255], [255, 0, 0, 255]);
        assert_eq!(colours(0), [w, b, b, r, r, w]);
        assert_eq!(colours(1), [w, b, b, r, r, w]);
        assert_eq!(colours(2), [w; 6], "clipped");
        assert_eq!(device.colour(6, 0), None);
    }

    #[test]
    fn a_pattern_is_tiled_and_its_area_clipped_at_parts_of_pixels() {
        let mut device = canvas(8.0, 6.0);
        let far = rectangle(-1e9, 1e9, -1e9, 1e9);
        let frame = Parallelogram {
            origin: Point::new(1.0, 1.0),
            columns: Vector::new(4.0, 0.0),
            rows: Vector::new(0.0, 2.0),
        };
        let white = Paint { colour: Colour::WHITE, index: 0 };
        let fill = Fill::Pattern(frame, Grid { paints: &[BLACK, white], columns: 2, rows: 1 });
        let clip = Some(Rect::new(1.5, 8.0, 0.0, 5.0));
        draw(&mut device, Form::Area(Paths::new(&far, &[4]), Rule::EvenOdd, fill), clip);
        let g = greens(&device);
        assert_eq!(g[0], [255, 127, 0, 255, 255, 0, 0, 255]);
        assert_eq!(g[4], g[0]);
        assert_eq!(g[5], [255; 8]);
    }

    #[test]
    fn what_is_left_to_the_pipeline_is_refused_untouched() {
        let mut device = canvas(10.0, 10.0);
        let line = points(&[(1.0, 1.0), (9.0, 9.0)]);
        let paths = Paths::new(&line, &[2]);
        let clip = Some(Rect::new(0.0, 5.0, 0.0, 5.0));
        for (form, clip) in [
            (Form::Lines(paths, Pen { dash: &[1.0, 1.0], ..pen(BLACK, 1.0) }), None),
            (Form::Lines(paths, pen(BLACK, 1.0)), clip),
            (Form::Area(paths, Rule::EvenOdd, Fill::Solid(BLACK)), clip),
            (Form::Filled(Curve::Bezier(&line), BLACK), None),
            (Form::Stroke(Curve::Bezier(&line), pen(BLACK, 1.0)), None),
        ] {
            assert_eq!(device.draw(&Mark { form, clip }).unwrap(), Drawn::No);
        }
        assert!(greens(&device).concat().iter().all(|&v| v == 255));
    }

    #[test]
    fn far_and_bad_coordinates_neither_stop_nor_hang() {
        let mut device = canvas(50.0, 50.0);
        for far in [1e9, 1e40, 1e300, f64::INFINITY, f64::NAN] {
            let path = points(&[(-far, 25.0), (far, 25.0), (25.0, far), (25.0, 25.0)]);
            for paint in [BLACK, HALF] {
                for width in [0.0, 1.0, 5.0, 1e6] {
                    for antialias in [true, false] {
                        device.set_antialiasing(antialias);
                        draw(&mut device, Form::Lines(Paths::new(&path, &[1, 4]), pen(paint, width)), None);
                    }
                }
                draw(
                    &mut device,
                    Form::Area(Paths::new(&path, &[4]), Rule::NonZero, Fill::Solid(paint)),
                    None,
                );
            }
        }
        let mut device = canvas(50.0, 50.0);
        let path = points(&[(-1e9, 25.5), (1e9, 25.5)]);
        draw(&mut device, Form::Lines(Paths::new(&path, &[2]), pen(BLACK, 1.0)), None);
        assert_eq!(greens(&device)[25], [0; 50]);
    }

    #[test]
    fn background_comes_from_the_page_or_the_options() {
        let page = Page { number: 1, background: Colour::rgb(0.0, 1.0, 0.0), colours: vec![] };
        let first = |options: Options| {
            let mut device = TrueColour::new(&options, None).unwrap();
            device.begin(&page).unwrap();
            device.colour(3, 3).unwrap().to_bytes()
        };
        assert_eq!(first(Options::default()), [0, 255, 0, 255]);
        let blue = Some(Colour::rgb(0.0, 0.0, 1.0));
        assert_eq!(first(Options { background: blue, ..Options::default() }), [0, 0, 255, 255]);
        assert_eq!(first(Options { transparent: true, ..Options::default() }), [0; 4]);
    }
}
