//! Many markers in one polymarker.

use super::random::Random;
use super::scene::{Canvas, Data, Figures, Scene, StrokePen};
use gks::Gks;

/// Markers of nominal size, three pixels to each side, anywhere.
pub struct Markers {
    positions: Vec<(f64, f64)>,
    kind: i32,
}

impl Markers {
    /// Markers of one type.
    pub fn of(kind: i32, count: usize) -> Box<dyn Scene> {
        let mut random = Random::new(5);
        let mut positions = Vec::with_capacity(count);
        positions.extend((0..count).map(|_| (random.unit(), random.unit())));
        Box::new(Markers { positions, kind })
    }

    /// W3dot.
    pub fn dots(count: usize) -> Box<dyn Scene> {
        Markers::of(1, count)
    }

    /// W3plus.
    pub fn pluses(count: usize) -> Box<dyn Scene> {
        Markers::of(2, count)
    }

    /// W3circ.
    pub fn circles(count: usize) -> Box<dyn Scene> {
        Markers::of(4, count)
    }
}

impl Scene for Markers {
    fn draw(&self, gks: &mut Gks) -> gks::Result<()> {
        gks.set_marker_type(self.kind)?;
        gks.polymarker(&self.positions)
    }

    fn data(&self) -> Data<'_> {
        Data::Parts(&self.positions, &[])
    }

    fn figures(&self) -> Option<Figures<'_>> {
        let r = 0.003;
        let draw: fn(&mut dyn Canvas, (f64, f64), f64) = match self.kind {
            1 => |canvas, at, _| canvas.dot(at),
            2 => |canvas, (x, y), r| {
                canvas.stroke(&[(x - r, y), (x + r, y)], &StrokePen::THIN);
                canvas.stroke(&[(x, y - r), (x, y + r)], &StrokePen::THIN);
            },
            4 => |canvas, at, r| canvas.circle(at, r, false),
            -9 => |canvas, at, r| canvas.circle(at, r, true),
            _ => return None,
        };
        Some(Box::new(move |canvas| self.positions.iter().for_each(|&at| draw(canvas, at, r))))
    }
}
