//! A cell array over the whole canvas.

use super::random::Random;
use super::scene::{Data, Figures, Scene};
use gks::Gks;

/// A square array of smooth waves with noise, 240 colours.
pub struct CellArray {
    indices: Vec<i32>,
    side: usize,
}

impl CellArray {
    /// W6: as many cells, the nearest square number of them.
    pub fn square(count: usize) -> Box<dyn Scene> {
        let side = (count as f64).sqrt().round() as usize;
        let mut random = Random::new(9);
        let mut indices = Vec::with_capacity(side * side);
        for row in 0..side {
            for column in 0..side {
                let (u, v) = (column as f64 / side as f64, row as f64 / side as f64);
                let wave = 100.0 * (1.0 + (12.0 * u + 3.0 * v).sin()) + 40.0 * random.unit();
                indices.push(8 + wave as i32 % 240);
            }
        }
        Box::new(CellArray { indices, side })
    }
}

impl Scene for CellArray {
    fn draw(&self, gks: &mut Gks) -> gks::Result<()> {
        gks.cell_array_of((0.0, 1.0), (1.0, 0.0), &self.indices, self.side, self.side, self.side)
    }

    fn data(&self) -> Data<'_> {
        Data::Cells(&self.indices, self.side)
    }

    fn figures(&self) -> Option<Figures<'_>> {
        Some(Box::new(|canvas| canvas.cells(&self.indices, self.side, self.side)))
    }
}
