//! S. Gupta and R. F. Sproull, "Filtering edges for gray-scale displays", SIGGRAPH 1981: lines of one segment, with the
//! share of each pixel from a table of how steep the line is and how far its middle is away.
//!
//! Here the table has areas. A line that is alone does not meet itself, so that they need not be samples.

use super::bitmap::Bitmap;
use super::composite::{Ink, Pixel};
use super::ends::Ends;
use gks_algorithms::coverage::SAMPLES;
use gks_pipeline::look::Cap;
use glam::DVec2;
use prefetch_index::prefetch_index;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};
use std::ops::Range;

/// The greatest height of a line in one step along it, in pixels: so it touches no more than four pixels across it.
const HIGHEST: f64 = 3.0;
/// The slopes that are told apart, from 0 to 1.
const SLOPES: usize = 32;
/// The places of the middle of a line in a pixel that are told apart.
const PLACES: usize = 64;
/// The middle of a line lies this far below the first of its four pixels, at least.
const ABOVE: f64 = 1.5;

/// How far pixels that are touched lie from the line, at most.
const MARGIN: f64 = 3.0;

/// How many samples of the four pixels of a step are covered, for each place of the middle of the line.
type Profile = [[u8; 4]; PLACES];

/// Draws lines of one segment; owns the table for lines of the width drawn last.
pub(super) struct Lone {
    width: f64,
    profiles: Vec<Option<Profile>>,
}

/// A line along its main direction: `x` is the coordinate that grows faster.
struct Segment {
    from: DVec2,
    run: f64,
    slope: f64,
    direction: DVec2,
    /// By how much the caps make it longer.
    longer: f64,
    ends: Ends,
}

impl Segment {
    #[inline]
    fn new(from: DVec2, to: DVec2, width: f64, cap: Cap) -> Self {
        let (from, to) = if from.x <= to.x { (from, to) } else { (to, from) };
        let along = to - from;
        let length = along.length();
        // A half disc is as large as a rectangle that is a little shorter.
        let longer = match cap {
            Cap::Butt => 0.0,
            Cap::Round => 0.5 * width * FRAC_PI_4,
            Cap::Projecting => 0.5 * width,
        };
        let direction = along / length;
        let ends = Ends::new(from, direction, length, longer);
        Segment { from, run: along.x, slope: along.y / along.x, direction, longer, ends }
    }
}

/// The whole places in a fixed point number.
const FRACTION: u32 = 32;

/// The steps in which pixels of a line lie.
struct Steps {
    all: Range<i32>,
    /// Those at which no end is to be seen.
    inner: Range<i32>,
    /// Where the first of the four pixels of the first step lies, and by how much further that of the next.
    first: i64,
    slope: i64,
}

impl Steps {
    #[inline]
    fn new(line: &Segment, width: f64) -> Self {
        // How far the ends reach, and from where on they are not to be seen.
        let (cos, sin) = (line.direction.x, line.direction.y.abs());
        let reach = line.longer * cos + 0.5 * width * sin + 0.5;
        let inner = (0.5 - line.longer + (ABOVE + 1.0) * sin) * cos + 0.5;
        let (from, to) = (line.from.x, line.from.x + line.run);
        let start = (from - reach) as i32;
        let ahead = f64::from(start) + 0.5 - from;
        let fixed = |x: f64| (x * (1u64 << FRACTION) as f64) as i64;
        Steps {
            all: start..(to + reach) as i32 + 1,
            inner: (from + inner + 0.5) as i32..(to - inner + 0.5) as i32,
            first: fixed(line.from.y + ahead * line.slope - ABOVE),
            slope: fixed(line.slope),
        }
    }

    /// Asks for a pixel of each step, so that they come from memory all at once. Steps are `along` pixels apart, pixels across
    /// the line `across`; each `every`th step is enough.
    #[inline]
    fn fetch(&self, pixels: &[Pixel], (along, across): (usize, usize), every: usize) {
        let mut second = self.first + (1 << FRACTION);
        for step in self.all.clone().step_by(every) {
            let place = step as usize * along + (second >> FRACTION) as usize * across;
            prefetch_index(pixels, place);
            second += self.slope * every as i64;
        }
    }
}

/// Whether a line along a vector touches no more than four pixels across it.
#[inline]
fn is_thin(along: DVec2, width: f64) -> bool {
    // As it is for all slopes.
    if width <= (HIGHEST - 1.0) * FRAC_1_SQRT_2 {
        return true;
    }
    let slope = along.min_element() / along.max_element();
    width * (1.0 + slope * slope).sqrt() + slope <= HIGHEST
}

impl Lone {
    pub(super) fn new() -> Self {
        Lone { width: 0.0, profiles: Vec::new() }
    }

    /// Draws a line from one point to another, if it lies inside of the bitmap and is thin; `false` if that is not the
    /// way to draw it.
    pub(super) fn draw(
        &mut self,
        bitmap: &mut Bitmap,
        (a, b): (DVec2, DVec2),
        width: f64,
        cap: Cap,
        ink: &Ink,
    ) -> bool {
        let (columns, rows) = bitmap.size();
        let (low, high) = (a.min(b) - MARGIN, a.max(b) + MARGIN);
        let inside = low.min_element() >= 0.0 && high.x < f64::from(columns) && high.y < f64::from(rows);
        let along = (b - a).abs();
        if !inside || a == b || !is_thin(along, width) {
            return false;
        }
        let pixels = bitmap.pixels_mut();
        let columns = columns as usize;
        if along.y > along.x {
            let line = Segment::new(DVec2::new(a.y, a.x), DVec2::new(b.y, b.x), width, cap);
            let steps = Steps::new(&line, width);
            steps.fetch(pixels, (columns, 1), 1);
            self.draw_steps(&line, steps, width, |row, column, samples| {
                let start = row * columns + column;
                if let Some(below) = pixels.get_mut(start..).and_then(|rest| rest.first_chunk_mut()) {
                    *below = ink.over_four(*below, samples);
                }
            });
        } else {
            let line = Segment::new(a, b, width, cap);
            let steps = Steps::new(&line, width);
            steps.fetch(pixels, (1, columns), 4);
            self.draw_steps(&line, steps, width, |column, row, samples| {
                let start = row * columns + column;
                let Some(pixels) = pixels.get_mut(start..=start + 3 * columns) else { return };
                let four = [0, 1, 2, 3].map(|i| pixels[i * columns]);
                for (at, pixel) in (0..).step_by(columns).zip(ink.over_four(four, samples)) {
                    pixels[at] = pixel;
                }
            });
        }
        true
    }

    /// Gives every step along a line, the first of the four pixels across it, and how many samples of them are covered.
    #[inline]
    fn draw_steps(
        &mut self,
        line: &Segment,
        steps: Steps,
        width: f64,
        mut put: impl FnMut(usize, usize, [u8; 4]),
    ) {
        let profile = self.profile(width, line.slope.abs());
        let mut exact = steps.first;
        for step in steps.all {
            let first = exact >> FRACTION;
            let place = (exact >> (FRACTION - PLACES.trailing_zeros())) as usize % PLACES;
            let mut samples = profile[place];
            if !steps.inner.contains(&step) {
                samples = line.ends.leave(step, first as i32, samples);
            }
            put(step as usize, first as usize, samples);
            exact += steps.slope;
        }
    }

    fn profile(&mut self, width: f64, slope: f64) -> &Profile {
        if width != self.width {
            self.width = width;
            self.profiles.clear();
        }
        let level = (slope * SLOPES as f64 + 0.5) as usize;
        if self.profiles.len() <= level {
            self.profiles.resize(SLOPES + 1, None);
        }
        self.profiles[level].get_or_insert_with(|| profile(width, level as f64 / SLOPES as f64))
    }
}

/// The profile of a line of a width and a slope.
fn profile(width: f64, slope: f64) -> Profile {
    let half = 0.5 * width * (1.0 + slope * slope).sqrt();
    let lean = 0.5 * slope;
    // The area in a step that lies above an edge of the line whose middle is `v` below.
    let above_edge = |v: f64| {
        let t = v.clamp(-lean, lean) + lean;
        let wedge = if lean > 0.0 { t * t * 0.25 / lean } else { 0.0 };
        wedge + (v - lean).max(0.0)
    };
    let above = |v: f64| above_edge(v + half) - above_edge(v - half);
    std::array::from_fn(|place| {
        let middle = ABOVE + (place as f64 + 0.5) / PLACES as f64;
        std::array::from_fn(|row| {
            let area = above(row as f64 + 1.0 - middle) - above(row as f64 - middle);
            (area * f64::from(SAMPLES) + 0.5) as u8
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn profiles_hold_the_whole_line() {
        for width in [1.0, 1.2, 1.4] {
            for slope in [0.0, 0.3, 0.77, 1.0f64] {
                let expected = width * (1.0 + slope * slope).sqrt() * f64::from(SAMPLES);
                for samples in profile(width, slope) {
                    let sum: u32 = samples.iter().map(|&count| u32::from(count)).sum();
                    assert!(
                        (f64::from(sum) - expected).abs() <= 2.0,
                        "{width} {slope}: {samples:?} {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn wide_short_and_cut_lines_are_not_drawn() {
        let mut bitmap = Bitmap::new(40, 40);
        let ink = Ink::new([0, 0, 0, 255], 255);
        let line = |x0, y0, x1, y1| (DVec2::new(x0, y0), DVec2::new(x1, y1));
        for (line, width) in [
            (line(10.0, 10.0, 30.0, 20.0), 2.5),
            (line(10.0, 10.0, 10.0, 10.0), 1.0),
            (line(2.5, 10.0, 30.0, 20.0), 1.0),
            (line(10.0, 10.0, 30.0, 37.5), 1.0),
            (line(10.0, 10.0, f64::NAN, 20.0), 1.0),
        ] {
            assert!(!Lone::new().draw(&mut bitmap, line, width, Cap::Butt, &ink));
        }
        assert!(bitmap.pixels().iter().all(|pixel| *pixel == [0; 4]));
        assert!(Lone::new().draw(&mut bitmap, line(10.0, 10.0, 30.0, 20.0), 1.0, Cap::Butt, &ink));
    }
}
