//! Pictures at another size: the mean of what a pixel covers (box filter).

/// Makes pictures of one size from pictures of another.
pub struct Scaler {
    columns: Vec<Span>,
    rows: Vec<Span>,
    /// Whether nothing changes.
    same: bool,
}

/// The pixels of one dimension that a new pixel covers.
struct Span {
    first: usize,
    last: usize,
    /// The share of the first and of the last one, and of each between.
    shares: (f32, f32, f32),
}

impl Span {
    fn weights(&self) -> impl Iterator<Item = (usize, f32)> {
        let (first, last, between) = self.shares;
        (self.first..=self.last).map(move |at| match at {
            _ if at == self.first => (at, first),
            _ if at == self.last => (at, last),
            _ => (at, between),
        })
    }
}

/// For `count` new pixels the part of `from` pixels that each of them covers: a box as wide as a new pixel,
/// but not narrower than an old one, which smooths what is enlarged.
fn spans(from: u32, count: u32) -> Vec<Span> {
    let step = f64::from(from) / f64::from(count.max(1));
    let reach = step.max(1.0) / 2.0;
    let most = f64::from(from);
    let span = |at: u32| {
        let centre = (f64::from(at) + 0.5) * step;
        let (low, high) = ((centre - reach).max(0.0), (centre + reach).min(most));
        let first = low.floor().min(most - 1.0).max(0.0);
        let last = (high.ceil() - 1.0).clamp(first, (most - 1.0).max(first));
        let share = |length: f64| (length / (high - low)) as f32;
        let shares = if first == last {
            (1.0, 1.0, 1.0)
        } else {
            (share(first + 1.0 - low), share(high - last), share(1.0))
        };
        Span { first: first as usize, last: last as usize, shares }
    };
    (0..count).map(span).collect()
}

impl Scaler {
    /// For pictures of one size that become pictures of another.
    pub fn new(from: (u32, u32), to: (u32, u32)) -> Scaler {
        Scaler { columns: spans(from.0, to.0), rows: spans(from.1, to.1), same: from == to }
    }

    /// Red, green and blue of a new pixel, given those of the old ones by column and row.
    pub fn pixel(&self, column: usize, row: usize, old: impl Fn(usize, usize) -> [u8; 3]) -> [u8; 3] {
        if self.same {
            return old(column, row);
        }
        let mut sums = [0.5f32; 3];
        for (row, share) in self.rows[row].weights() {
            for (column, part) in self.columns[column].weights() {
                let weight = share * part;
                sums.iter_mut().zip(old(column, row)).for_each(|(sum, v)| *sum += weight * f32::from(v));
            }
        }
        sums.map(|sum| sum as u8)
    }
}

/// The size of a picture that fits into a room with its proportions, at least one pixel.
pub fn fit(picture: (u32, u32), room: (u32, u32)) -> (u32, u32) {
    let (w, h) = (f64::from(picture.0.max(1)), f64::from(picture.1.max(1)));
    let scale = (f64::from(room.0) / w).min(f64::from(room.1) / h);
    let side = |length: f64, most: u32| ((length * scale).round() as u32).clamp(1, most.max(1));
    (side(w, room.0), side(h, room.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scaled(from: (u32, u32), to: (u32, u32), old: impl Fn(usize, usize) -> u8) -> Vec<u8> {
        let scaler = Scaler::new(from, to);
        let pixel = |column, row| scaler.pixel(column, row, |c, r| [old(c, r); 3])[0];
        (0..to.1 as usize)
            .flat_map(|row| (0..to.0 as usize).map(move |c| (c, row)))
            .map(|(c, r)| pixel(c, r))
            .collect()
    }

    #[test]
    fn smaller_pictures_are_means() {
        assert_eq!(scaled((4, 2), (2, 1), |c, r| (c * 10 + r * 40) as u8), [25, 45]);
        assert_eq!(scaled((3, 1), (2, 1), |c, _| [0, 90, 240][c]), [30, 190]);
    }

    #[test]
    fn the_same_size_changes_nothing_and_an_even_picture_stays_even() {
        assert_eq!(scaled((3, 2), (3, 2), |c, r| (c + r * 3) as u8), [0, 1, 2, 3, 4, 5]);
        for to in [(1, 1), (7, 3), (100, 90), (5, 4)] {
            assert!(scaled((5, 4), to, |_, _| 255).iter().all(|&v| v == 255), "{to:?}");
        }
    }

    #[test]
    fn pictures_fit_with_their_proportions() {
        assert_eq!(fit((4, 2), (8, 8)), (8, 4));
        assert_eq!(fit((4, 2), (100, 10)), (20, 10));
        assert_eq!(fit((1000, 1), (10, 10)), (10, 1));
        assert_eq!(fit((4, 2), (0, 0)), (1, 1));
    }
}
