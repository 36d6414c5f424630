//! The picture as it should be: a workstation of 8 x 8 samples a pixel, and how near another picture comes.
//!
//! The workstation accepts solid lines, areas and cells alone, so the pipeline brings everything down to them.
//! A line is the union of the rectangles of its segments, its joins and its caps; each piece is filled by
//! itself, which gives the union because the colours are opaque. A sample takes the colour of the last
//! primitive that contains it, and a pixel is the mean of its samples. Nothing is shared with the raster
//! workstations but what the pipeline does before any device is asked.

use super::scene::{COLOURS, SIDE, colour};
use gks::Gks;
use gks_geometry::{Du, Paths};
use gks_pipeline::description::{Catalogue, Description, OpenError};
use gks_pipeline::device::{Device, DeviceError, Drawn, Fill, Form, Grid, Mark, Page, Pen, Rule, Surface};
use gks_pipeline::generated::numbers::workstation_type;
use gks_pipeline::item::Parallelogram;
use gks_pipeline::look::{Cap, Join};
use gks_pipeline::workstation::Backend;
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use glam::{DMat2, DVec2};
use std::sync::{Arc, Mutex, PoisonError};

/// Samples along each side of a pixel.
const SAMPLES: usize = 8;
/// Samples in a row.
const WIDTH: usize = SIDE as usize * SAMPLES;
/// The longest miter in linewidths, as [`Join::Miter`] says.
const MITER_LIMIT: f64 = 10.0;

/// The true picture of what `draw` draws: red, green and blue of each pixel, row by row from the top.
pub fn truth(draw: impl FnOnce(&mut Gks) -> gks::Result<()>) -> gks::Result<Vec<[f32; 3]>> {
    let samples = Arc::new(Mutex::new(Samples::new()));
    let shared = Arc::clone(&samples);
    draw_on(move |surface| Box::new(Supersampled { surface, samples: shared }), draw)?;
    let samples = samples.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(samples.pixels())
}

/// The points of a line, in the unit square, y up.
pub type Line = Vec<(f64, f64)>;

/// The lines that what `draw` draws consists of, on a device which accepts nothing else: in the unit square,
/// y up.
pub fn lines(draw: impl FnOnce(&mut Gks) -> gks::Result<()>) -> gks::Result<Vec<Line>> {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let shared = Arc::clone(&lines);
    draw_on(move |surface| Box::new(Collector { surface, lines: shared }), draw)?;
    let mut lines = lines.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(std::mem::take(&mut *lines))
}

/// How near a picture is to the truth.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Likeness {
    /// Peak signal to noise ratio in decibels, at most 99.
    pub psnr: f64,
    /// The mean darkness of the picture, from 0 for white to 255.
    pub ink: f64,
    /// The mean darkness of the truth.
    pub true_ink: f64,
}

/// Compares a picture, in bytes, with the truth.
pub fn compare(picture: &[[u8; 3]], truth: &[[f32; 3]]) -> Likeness {
    let pairs = || picture.as_flattened().iter().zip(truth.as_flattened());
    let count = pairs().count().max(1) as f64;
    let square: f64 = pairs().map(|(&a, &b)| (f64::from(a) - f64::from(b)).powi(2)).sum::<f64>() / count;
    let ink: f64 = pairs().map(|(&a, _)| 255.0 - f64::from(a)).sum::<f64>() / count;
    let true_ink: f64 = pairs().map(|(_, &b)| 255.0 - f64::from(b)).sum::<f64>() / count;
    let psnr = (10.0 * (255.0 * 255.0 / square).log10()).min(99.0);
    Likeness { psnr, ink, true_ink }
}

/// Opens a kernel on a device with the surface of the frame buffer, draws and closes.
fn draw_on(
    device: impl FnOnce(Surface) -> Box<dyn Device> + Send + 'static,
    draw: impl FnOnce(&mut Gks) -> gks::Result<()>,
) -> gks::Result<()> {
    let drivers = Drivers::new(Environment::default());
    let mut gks = Gks::open(Box::new(Handed { drivers, device: Some(device) }));
    gks.open_workstation(1, "", workstation_type::FRAMEBUFFER)?;
    gks.activate_workstation(1)?;
    set_colours(&mut gks, 1)?;
    draw(&mut gks)?;
    gks.deactivate_workstation(1)?;
    gks.close_workstation(1)?;
    gks.close_gks()
}

/// Sets the [`colour`]s of a workstation.
pub(super) fn set_colours(gks: &mut Gks, id: i32) -> gks::Result<()> {
    (0..COLOURS).try_for_each(|index| gks.set_colour_representation(id, index, colour(index)))
}

/// A catalogue of one workstation that can be opened once.
struct Handed<F> {
    drivers: Drivers,
    device: Option<F>,
}

impl<F: FnOnce(Surface) -> Box<dyn Device> + Send> Catalogue for Handed<F> {
    fn types(&self) -> Vec<i32> {
        vec![workstation_type::FRAMEBUFFER]
    }

    fn describe(&self, number: i32) -> Option<Description> {
        self.drivers.describe(number)
    }

    fn open(&mut self, number: i32, _: &str) -> Result<(Backend, Description), OpenError> {
        let (Some(description), Some(device)) = (self.describe(number), self.device.take()) else {
            return Err(OpenError::NoSuchType(number));
        };
        Ok((Backend::Device(device(description.surface.clone())), description))
    }
}

/// A device that collects lines.
struct Collector {
    surface: Surface,
    lines: Arc<Mutex<Vec<Line>>>,
}

impl Device for Collector {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, _: &Page) -> Result<(), DeviceError> {
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let (Form::Lines(paths, pen), None) = (&mark.form, mark.clip) else { return Ok(Drawn::No) };
        if !pen.dash.is_empty() {
            return Ok(Drawn::No);
        }
        let mut lines = self.lines.lock().unwrap_or_else(PoisonError::into_inner);
        let side = f64::from(SIDE);
        let unit = |p: &DVec2| (p.x / side, 1.0 - p.y / side);
        lines.extend(paths.iter().map(|path| path.iter().map(unit).collect::<Line>()));
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}

/// The device that draws the truth.
struct Supersampled {
    surface: Surface,
    samples: Arc<Mutex<Samples>>,
}

impl Device for Supersampled {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, _: &Page) -> Result<(), DeviceError> {
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let mut samples = self.samples.lock().unwrap_or_else(PoisonError::into_inner);
        match (&mark.form, mark.clip) {
            (Form::Lines(paths, pen), None) if pen.dash.is_empty() => {
                paths.iter().for_each(|path| samples.line(path, pen));
            }
            (Form::Area(rings, rule, Fill::Solid(paint)), None) => {
                samples.area(*rings, *rule, paint.index as u8);
            }
            (Form::Cells(frame, grid), None) => samples.cells(frame, grid),
            _ => return Ok(Drawn::No),
        }
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}

/// A colour index for each sample.
struct Samples {
    indices: Vec<u8>,
    /// The left and the right end of a convex shape in each row.
    spans: Vec<(f64, f64)>,
    /// Where the boundary of an area crosses the middles of rows: row, position, direction.
    crossings: Vec<(u32, f64, i8)>,
}

impl Samples {
    fn new() -> Samples {
        Samples { indices: vec![0; WIDTH * WIDTH], spans: Vec::new(), crossings: Vec::new() }
    }

    /// The mean colour of each pixel.
    fn pixels(&self) -> Vec<[f32; 3]> {
        let side = SIDE as usize;
        let colours: Vec<[f32; 3]> = (0..COLOURS)
            .map(|index| {
                let [red, green, blue, _] = colour(index).to_bytes();
                [red, green, blue].map(f32::from)
            })
            .collect();
        let mean = |column: usize, row: usize| {
            let mut sum = [0.0; 3];
            for line in 0..SAMPLES {
                let first = (row * SAMPLES + line) * WIDTH + column * SAMPLES;
                for &index in &self.indices[first..first + SAMPLES] {
                    sum.iter_mut().zip(colours[usize::from(index)]).for_each(|(sum, part)| *sum += part);
                }
            }
            sum.map(|part| part / (SAMPLES * SAMPLES) as f32)
        };
        (0..side).flat_map(|row| (0..side).map(move |column| mean(column, row))).collect()
    }

    /// A line: one rectangle for each segment, the joins between them, the caps at the ends.
    fn line(&mut self, path: &[DVec2], pen: &Pen<'_>) {
        let (half, index) = (pen.width * 0.5, pen.paint.index as u8);
        let mut points: Vec<DVec2> = path.to_vec();
        points.dedup();
        let [first, .., last] = *points else {
            return points.first().map_or((), |&dot| self.dot(dot, half, pen.cap, index));
        };
        let closed = first == last && points.len() > 3;
        for pair in points.windows(2) {
            let across = (pair[1] - pair[0]).normalize().perp() * half;
            let [a, b] = [pair[0], pair[1]];
            self.convex(&[a + across, b + across, b - across, a - across], index);
        }
        for corner in points.windows(3) {
            self.join(corner[0], corner[1], corner[2], half, pen.join, index);
        }
        if closed {
            return self.join(points[points.len() - 2], first, points[1], half, pen.join, index);
        }
        for (end, inner) in [(first, points[1]), (last, points[points.len() - 2])] {
            let along = (end - inner).normalize() * half;
            match pen.cap {
                Cap::Butt => {}
                Cap::Round => self.disc(end, half, index),
                Cap::Projecting => {
                    let across = along.perp();
                    let corners = [end + across, end + across + along, end - across + along, end - across];
                    self.convex(&corners, index);
                }
            }
        }
    }

    fn join(&mut self, before: DVec2, at: DVec2, after: DVec2, half: f64, join: Join, index: u8) {
        let (into, out) = ((at - before).normalize(), (after - at).normalize());
        let turn = into.perp_dot(out);
        // The corner lacks something on the outer side of the turn.
        let side = if turn > 0.0 { -half } else { half };
        let (a, b) = (into.perp() * side, out.perp() * side);
        let middle = a + b;
        // The miter is as many linewidths long as the sine of half the angle goes into 1.
        let sine = (a + b).length() * 0.5 / half;
        match join {
            Join::Round => self.disc(at, half, index),
            Join::Miter if sine * MITER_LIMIT >= 1.0 => {
                let tip = middle.normalize_or_zero() * (half / sine);
                self.convex(&[at, at + a, at + tip, at + b], index);
            }
            Join::Miter | Join::Bevel => self.convex(&[at, at + a, at + b], index),
        }
    }

    fn dot(&mut self, at: DVec2, half: f64, cap: Cap, index: u8) {
        // A dot of a linewidth of a pixel or two is a square on every raster.
        if cap == Cap::Round && half > 1.0 {
            return self.disc(at, half, index);
        }
        let (x, y) = (DVec2::new(half, 0.0), DVec2::new(0.0, half));
        self.convex(&[at - x - y, at + x - y, at + x + y, at - x + y], index);
    }

    fn disc(&mut self, centre: DVec2, radius: f64, index: u8) {
        for row in rows(centre.y - radius, centre.y + radius) {
            let reach = (radius * radius - (middle(row) - centre.y).powi(2)).max(0.0).sqrt();
            self.span(row, centre.x - reach, centre.x + reach, index);
        }
    }

    /// A convex polygon: in each row the samples between the outermost crossings of its boundary.
    fn convex(&mut self, corners: &[DVec2], index: u8) {
        let (low, high) = corners.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p.y), h.max(p.y)));
        let all = rows(low, high);
        let first = all.start;
        let mut spans = std::mem::take(&mut self.spans);
        spans.clear();
        spans.resize(all.len(), (f64::MAX, f64::MIN));
        for (i, &a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            let slope = (b.x - a.x) / (b.y - a.y);
            for row in rows(a.y.min(b.y), a.y.max(b.y)) {
                let x = a.x + (middle(row) - a.y) * slope;
                let (left, right) = &mut spans[row - first];
                *left = left.min(x);
                *right = right.max(x);
            }
        }
        for (row, &(left, right)) in all.zip(&spans) {
            self.span(row, left, right, index);
        }
        self.spans = spans;
    }

    /// An area: crossings of its boundary with each row in order, and the samples between them that are inside.
    fn area(&mut self, rings: Paths<'_, Du>, rule: Rule, index: u8) {
        let mut crossings = std::mem::take(&mut self.crossings);
        crossings.clear();
        for ring in rings.iter() {
            for (i, &a) in ring.iter().enumerate() {
                let b = ring[(i + 1) % ring.len()];
                let slope = (b.x - a.x) / (b.y - a.y);
                let direction = if b.y > a.y { 1 } else { -1 };
                for row in rows(a.y.min(b.y), a.y.max(b.y)) {
                    crossings.push((row as u32, a.x + (middle(row) - a.y) * slope, direction));
                }
            }
        }
        crossings.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let mut winding = 0;
        for pair in crossings.windows(2) {
            let (row, left, direction) = pair[0];
            winding += i32::from(direction);
            let inside = match rule {
                Rule::EvenOdd => winding & 1 == 1,
                Rule::NonZero => winding != 0,
            };
            // The winding number is 0 again behind the last crossing of a row.
            if inside && pair[1].0 == row {
                self.span(row as usize, left, pair[1].1, index);
            }
        }
        self.crossings = crossings;
    }

    /// Cells: a pixel takes the colour of the cell that contains its centre.
    fn cells(&mut self, frame: &Parallelogram<Du>, grid: &Grid<'_>) {
        let inverse = DMat2::from_cols(frame.columns.0, frame.rows.0).inverse();
        let (columns, rows) = (grid.columns as f64, grid.rows as f64);
        for row in 0..SIDE as usize {
            for column in 0..SIDE as usize {
                let centre = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                let at = inverse * (centre - frame.origin.0) * DVec2::new(columns, rows);
                if at.min_element() < 0.0 || at.x >= columns || at.y >= rows {
                    continue;
                }
                let index = grid.paints[at.y as usize * grid.columns + at.x as usize].index as u8;
                for line in row * SAMPLES..(row + 1) * SAMPLES {
                    self.span(line, column as f64, (column + 1) as f64, index);
                }
            }
        }
    }

    /// The samples of a row between two abscissae in pixels.
    fn span(&mut self, row: usize, left: f64, right: f64, index: u8) {
        let (first, last) = (sample(left), sample(right));
        if first < last {
            self.indices[row * WIDTH + first..row * WIDTH + last].fill(index);
        }
    }
}

/// The first sample whose middle is not before a coordinate in pixels.
fn sample(at: f64) -> usize {
    (at * SAMPLES as f64 - 0.5).ceil().clamp(0.0, WIDTH as f64) as usize
}

/// The rows of samples whose middles are between two ordinates in pixels.
fn rows(low: f64, high: f64) -> std::ops::Range<usize> {
    sample(low)..sample(high).max(sample(low))
}

/// The middle of a row of samples, in pixels.
fn middle(row: usize) -> f64 {
    (row as f64 + 0.5) / SAMPLES as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::look::InteriorStyle;

    /// The darkness of a pixel, from 0 to 1.
    fn dark(truth: &[[f32; 3]], column: usize, row: usize) -> f32 {
        1.0 - truth[row * SIDE as usize + column][1] / 255.0
    }

    #[test]
    fn coverage_is_counted_in_samples() {
        let truth = truth(|gks| {
            gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
            gks.fill_area(&[(0.1, 0.1), (0.2005, 0.1), (0.2005, 0.20025), (0.1, 0.20025)])
        })
        .unwrap();
        assert_eq!((dark(&truth, 150, 850), dark(&truth, 99, 850)), (1.0, 0.0));
        assert_eq!((dark(&truth, 200, 850), dark(&truth, 150, 799)), (0.5, 0.25));
    }

    #[test]
    fn a_line_that_meets_itself_is_a_union() {
        let truth = truth(|gks| {
            gks.set_linewidth_scale_factor(0.5)?;
            gks.polyline(&[(0.1, 0.5), (0.3, 0.5), (0.1, 0.5), (0.3, 0.5)])
        })
        .unwrap();
        assert_eq!((dark(&truth, 200, 499), dark(&truth, 200, 500)), (0.25, 0.25));
    }

    #[test]
    fn joins_and_caps_are_drawn() {
        let corner = |join, cap| {
            truth(|gks| {
                gks.set_linewidth_scale_factor(20.0)?;
                gks.set_line_join(join)?;
                gks.set_line_cap(cap)?;
                gks.polyline(&[(0.1, 0.5), (0.3, 0.5), (0.3, 0.3)])
            })
            .unwrap()
        };
        // The outer corner of the turn is at (310, 490), the line starts at 100.
        let (miter, bevel) = (corner(Join::Miter, Cap::Butt), corner(Join::Bevel, Cap::Projecting));
        let round = corner(Join::Round, Cap::Round);
        assert_eq!([&miter, &round, &bevel].map(|t| dark(t, 309, 490)), [1.0, 0.0, 0.0]);
        assert_eq!([&miter, &round, &bevel].map(|t| dark(t, 306, 493)), [1.0, 1.0, 0.0]);
        assert_eq!([&miter, &round, &bevel].map(|t| dark(t, 91, 491)), [0.0, 0.0, 1.0]);
        assert_eq!([&miter, &round, &bevel].map(|t| dark(t, 91, 500)), [0.0, 1.0, 1.0]);
    }

    #[test]
    fn likeness_is_measured_over_all_pixels() {
        let truth = vec![[0.0; 3], [255.0; 3]];
        assert_eq!(compare(&[[0; 3], [255; 3]], &truth).psnr, 99.0);
        let grey = compare(&[[51; 3], [255; 3]], &truth);
        assert!((grey.psnr - 16.99).abs() < 0.01, "{grey:?}");
        assert_eq!((grey.ink, grey.true_ink), (102.0, 127.5));
    }
}
