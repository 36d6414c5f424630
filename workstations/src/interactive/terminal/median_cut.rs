//! A palette by P. Heckbert, "Color Image Quantization for Frame Buffer Display", SIGGRAPH 1982: the box of
//! colours with the most pixels is cut at its median until there are enough boxes.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Colours and the way to them.
pub(super) struct Palette {
    /// Red, green and blue.
    pub(super) colours: Vec<[u8; 3]>,
    index: Index,
}

enum Index {
    /// By the colour itself, where there are few.
    Exact(HashMap<[u8; 3], u8>),
    /// By the cell of 8 x 8 x 8 colours that it is in.
    Cells(Vec<u8>),
}

/// A cell of the histogram: its number, the number of its pixels, and the sums of their channels.
struct Cell {
    number: usize,
    count: u64,
    sums: [u64; 3],
}

fn cell([red, green, blue]: [u8; 3]) -> usize {
    usize::from(red >> 3) << 10 | usize::from(green >> 3) << 5 | usize::from(blue >> 3)
}

fn axis(number: usize, axis: usize) -> usize {
    number >> (10 - 5 * axis) & 31
}

impl Palette {
    /// At most `most` (up to 256) colours for pixels, all of them if there are no more.
    pub(super) fn new(pixels: impl Iterator<Item = [u8; 3]> + Clone, most: usize) -> Palette {
        let most = most.clamp(1, 256);
        let mut exact = HashMap::new();
        let mut colours = Vec::new();
        let mut last = None;
        for pixel in pixels.clone() {
            if last == Some(pixel) {
                continue;
            }
            last = Some(pixel);
            if let Entry::Vacant(place) = exact.entry(pixel) {
                if colours.len() == most {
                    return Palette::cut(pixels, most);
                }
                place.insert(colours.len() as u8);
                colours.push(pixel);
            }
        }
        Palette { colours, index: Index::Exact(exact) }
    }

    fn cut(pixels: impl Iterator<Item = [u8; 3]>, most: usize) -> Palette {
        let mut cells: Vec<Cell> =
            (0..1 << 15).map(|number| Cell { number, count: 0, sums: [0; 3] }).collect();
        for pixel in pixels {
            let cell = &mut cells[cell(pixel)];
            cell.count += 1;
            cell.sums.iter_mut().zip(pixel).for_each(|(sum, channel)| *sum += u64::from(channel));
        }
        cells.retain(|cell| cell.count > 0);
        let mut boxes = vec![cells];
        while boxes.len() < most {
            let weight = |of: &Vec<Cell>| if of.len() < 2 { 0 } else { of.iter().map(|c| c.count).sum() };
            let Some(largest) = (0..boxes.len()).max_by_key(|&i| weight(&boxes[i])) else { break };
            if weight(&boxes[largest]) == 0 {
                break;
            }
            let upper = halve(&mut boxes[largest]);
            boxes.push(upper);
        }
        let mut index = vec![0; 1 << 15];
        let mut colours = Vec::with_capacity(boxes.len());
        for (at, cells) in boxes.iter().enumerate() {
            let count: u64 = cells.iter().map(|cell| cell.count).sum();
            let mean = |axis: usize| cells.iter().map(|cell| cell.sums[axis]).sum::<u64>() / count.max(1);
            colours.push([mean(0) as u8, mean(1) as u8, mean(2) as u8]);
            cells.iter().for_each(|cell| index[cell.number] = at as u8);
        }
        Palette { colours, index: Index::Cells(index) }
    }

    /// The number of the colour for a pixel that the palette was made for.
    pub(super) fn index(&self, pixel: [u8; 3]) -> u8 {
        match &self.index {
            Index::Exact(map) => map.get(&pixel).copied().unwrap_or(0),
            Index::Cells(cells) => cells[cell(pixel)],
        }
    }
}

/// Cuts a box of at least two cells across its longest side so that both parts have about as many pixels,
/// and returns the upper part.
fn halve(cells: &mut Vec<Cell>) -> Vec<Cell> {
    let extent = |of: usize| {
        let values = cells.iter().map(|cell| axis(cell.number, of));
        values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
    };
    let longest = (0..3).max_by_key(|&of| extent(of)).unwrap_or(0);
    cells.sort_by_key(|cell| axis(cell.number, longest));
    let total: u64 = cells.iter().map(|cell| cell.count).sum();
    let mut below = 0;
    let middle = cells.iter().position(|cell| {
        below += cell.count;
        below * 2 >= total
    });
    let at = middle.map_or(1, |at| at + 1).clamp(1, cells.len() - 1);
    cells.split_off(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colours_are_kept_exactly() {
        let pixels: Vec<[u8; 3]> = (0..=255).map(|i| [i, 255 - i, i / 2]).collect();
        let palette = Palette::new(pixels.iter().copied(), 256);
        assert_eq!(palette.colours.len(), 256);
        assert!(pixels.iter().all(|&pixel| palette.colours[usize::from(palette.index(pixel))] == pixel));
    }

    #[test]
    fn many_colours_become_near_ones() {
        let pixels: Vec<[u8; 3]> = (0..=255)
            .flat_map(|x| (0..=255).map(move |y| [x, y, ((u16::from(x) + u16::from(y)) / 2) as u8]))
            .collect();
        let palette = Palette::new(pixels.iter().copied(), 256);
        assert_eq!(palette.colours.len(), 256);
        let error = |pixel: &[u8; 3]| {
            let near = palette.colours[usize::from(palette.index(*pixel))];
            pixel.iter().zip(near).map(|(&a, b)| f64::from(a.abs_diff(b))).sum::<f64>() / 3.0
        };
        let mean = pixels.iter().map(error).sum::<f64>() / pixels.len() as f64;
        assert!(mean < 6.0, "{mean}");
    }

    #[test]
    fn a_single_cell_is_not_cut() {
        let pixels: Vec<[u8; 3]> = (0..8).flat_map(|x| (0..8).map(move |y| [x, y, 0])).collect();
        let palette = Palette::new(pixels.iter().copied(), 4);
        assert_eq!(palette.colours, [[3, 3, 0]]);
    }
}
