//! The least and the greatest of many numbers, in one pass without a branch.

use std::ops::{Add, Mul};

/// As many numbers are compared side by side, so that none waits for the one before.
const LANES: usize = 8;

/// What can be said of numbers together.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(crate) struct Extremes {
    /// The least of those that are numbers; infinite if there is none.
    pub(crate) low: f64,
    /// The greatest of them, or minus infinity.
    pub(crate) high: f64,
    /// Whether all of them are finite.
    pub(crate) finite: bool,
}

/// Coordinates in single or double precision.
pub(crate) trait Number:
    Copy + Default + PartialOrd + Into<f64> + Add<Output = Self> + Mul<Output = Self>
{
    const INFINITY: Self;
    const NEG_INFINITY: Self;
}

impl Number for f32 {
    const INFINITY: f32 = f32::INFINITY;
    const NEG_INFINITY: f32 = f32::NEG_INFINITY;
}

impl Number for f64 {
    const INFINITY: f64 = f64::INFINITY;
    const NEG_INFINITY: f64 = f64::NEG_INFINITY;
}

impl Extremes {
    /// Those of numbers.
    pub(crate) fn of<T: Number>(numbers: &[T]) -> Extremes {
        let mut found = Lanes::new();
        let (groups, rest) = numbers.as_chunks();
        groups.iter().for_each(|&group| found.take(group));
        rest.iter().for_each(|&number| found.take([number; LANES]));
        let [all] = found.of_each();
        all
    }

    /// Those of the first and of the second numbers of pairs.
    #[inline(always)]
    pub(crate) fn of_pairs<P, T: Number>(pairs: &[P], pair: impl Fn(&P) -> [T; 2]) -> (Extremes, Extremes) {
        let flat = |four: [[T; 2]; LANES / 2]| std::array::from_fn(|i| four[i / 2][i % 2]);
        let mut found = Lanes::new();
        let (groups, rest) = pairs.as_chunks::<{ LANES / 2 }>();
        groups.iter().for_each(|group| found.take(flat(group.each_ref().map(&pair))));
        rest.iter().for_each(|one| found.take(flat([pair(one); LANES / 2])));
        let [first, second] = found.of_each();
        (first, second)
    }
}

/// The extremes of numbers that come many at a time, each in its place.
struct Lanes<T> {
    low: [T; LANES],
    high: [T; LANES],
    /// Zero as long as all numbers are finite.
    zero: [T; LANES],
}

impl<T: Number> Lanes<T> {
    fn new() -> Self {
        Lanes { low: [T::INFINITY; LANES], high: [T::NEG_INFINITY; LANES], zero: [T::default(); LANES] }
    }

    #[inline(always)]
    fn take(&mut self, numbers: [T; LANES]) {
        for (i, number) in numbers.into_iter().enumerate() {
            self.low[i] = if number < self.low[i] { number } else { self.low[i] };
            self.high[i] = if number > self.high[i] { number } else { self.high[i] };
            // Nothing but a finite number is zero times zero.
            self.zero[i] = self.zero[i] + number * T::default();
        }
    }

    /// The extremes of every `N`th number.
    #[inline(always)]
    fn of_each<const N: usize>(&self) -> [Extremes; N] {
        let none = Extremes { low: f64::INFINITY, high: f64::NEG_INFINITY, finite: true };
        let mut found = [none; N];
        for i in 0..LANES {
            let extremes = &mut found[i % N];
            extremes.low = extremes.low.min(self.low[i].into());
            extremes.high = extremes.high.max(self.high[i].into());
            extremes.finite &= self.zero[i].into() == 0.0;
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_count_of_numbers_and_pairs() {
        for count in 0..40 {
            let number = |i: usize| (i * 7 % 41) as f32 - 20.0;
            let numbers: Vec<f32> = (0..count).map(number).collect();
            let low = numbers.iter().fold(f64::INFINITY, |low, &n| low.min(n.into()));
            let high = numbers.iter().fold(f64::NEG_INFINITY, |high, &n| high.max(n.into()));
            let expected = Extremes { low, high, finite: true };
            assert_eq!(Extremes::of(&numbers), expected, "{count}");
            let (first, second) = Extremes::of_pairs(&numbers, |&n| [n, -n]);
            assert_eq!(first, expected, "{count}");
            assert_eq!(second, Extremes { low: -high, high: -low, finite: true }, "{count}");
        }
    }

    #[test]
    fn what_is_not_finite_is_told_and_what_is_no_number_is_left_out() {
        for count in 1..20 {
            for at in 0..count {
                let mut numbers = vec![1.0; count];
                numbers[at] = f64::NAN;
                let found = Extremes::of(&numbers);
                assert!(!found.finite && (count == 1 || (found.low, found.high) == (1.0, 1.0)), "{found:?}");
                numbers[at] = f64::INFINITY;
                let found = Extremes::of(&numbers);
                assert!(!found.finite && found.high == f64::INFINITY, "{found:?}");
            }
        }
    }
}
