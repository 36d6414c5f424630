//! What a piece of work costs: processor time, and memory at its peak.

use rustix::time::{ClockId, clock_gettime};
use std::fs;

/// The processor time of this process until now, of all its threads, in seconds.
pub fn cpu_seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

/// The processor time of some work, in seconds.
pub fn timed<E>(work: impl FnOnce() -> Result<(), E>) -> Result<f64, E> {
    let start = cpu_seconds();
    work()?;
    Ok(cpu_seconds() - start)
}

/// How long a sample is at least, and how many samples there are.
#[derive(Copy, Clone, Debug)]
pub struct Sampling {
    /// The least processor time of a sample in seconds; shorter work is repeated within it.
    pub seconds: f64,
    /// The number of samples.
    pub samples: usize,
    /// Work that takes longer than this many seconds is done once.
    pub patience: f64,
}

impl Sampling {
    /// Medians of five samples of 0.3 s.
    pub const CAREFUL: Sampling = Sampling { seconds: 0.3, samples: 5, patience: 10.0 };
    /// Medians of three samples of 0.15 s, for other sizes than the nominal one.
    pub const GROWTH: Sampling = Sampling { seconds: 0.15, samples: 3, patience: 1.0 };
    /// One run, to see that it works.
    pub const ONCE: Sampling = Sampling { seconds: 0.0, samples: 1, patience: 0.0 };

    /// How often work is repeated that takes `seconds`.
    fn repetitions(&self, seconds: f64) -> u32 {
        (self.seconds / seconds.max(1e-7)).ceil().clamp(1.0, 1e6) as u32
    }
}

/// Work that is measured.
pub type Work<'a, E> = &'a mut dyn FnMut() -> Result<(), E>;

/// The median time of each piece of work, in seconds. Samples are taken in turn, so that what else the machine
/// does meets all of them alike.
pub fn medians<E, const N: usize>(sampling: Sampling, mut works: [Work<'_, E>; N]) -> Result<[f64; N], E> {
    let mut samples: [Vec<f64>; N] = std::array::from_fn(|_| Vec::new());
    let mut repetitions = [0; N];
    for ((samples, repetitions), work) in samples.iter_mut().zip(&mut repetitions).zip(&mut works) {
        // The first run finds everything cold, and says how long the work is.
        let first = timed(&mut **work)?;
        if sampling.samples == 1 || first > sampling.patience {
            samples.push(first);
        } else {
            *repetitions = sampling.repetitions(first);
        }
    }
    for _ in 0..sampling.samples {
        for ((samples, work), &repetitions) in samples.iter_mut().zip(&mut works).zip(&repetitions) {
            if repetitions > 0 {
                let time = timed(|| (0..repetitions).try_for_each(|_| work()))?;
                samples.push(time / f64::from(repetitions));
            }
        }
    }
    Ok(samples.map(median))
}

/// The middle one of some numbers, the mean of the two in the middle if there are two, 0 of none.
pub fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    match numbers.len() {
        0 => 0.0,
        count => (numbers[(count - 1) / 2] + numbers[count / 2]) * 0.5,
    }
}

/// The peak of the memory of this process from here on.
pub struct Peak {
    before: u64,
}

impl Peak {
    /// Starts to watch. What was in use for a while before does not count.
    pub fn watch() -> Peak {
        // "5" resets the peak; where that is not possible, an earlier peak may count.
        let _ = fs::write("/proc/self/clear_refs", "5");
        Peak { before: resident("VmRSS:") }
    }

    /// By how many KiB memory has been larger than at the start, at most; 0 where the system does not tell.
    pub fn kib(&self) -> u64 {
        resident("VmHWM:").saturating_sub(self.before)
    }

    /// The largest memory that this process has had, in KiB.
    pub fn of_process() -> u64 {
        resident("VmHWM:")
    }
}

fn resident(key: &str) -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(key));
    line.and_then(|rest| rest.trim().trim_end_matches("kB").trim().parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median(vec![3.0, 1.0, 9.0]), 3.0);
        assert_eq!(median(vec![4.0, 1.0, 9.0, 2.0]), 3.0);
        assert_eq!(median(Vec::new()), 0.0);
    }

    #[test]
    fn short_work_is_repeated() {
        let sampling = Sampling { seconds: 0.3, samples: 5, patience: 10.0 };
        let repetitions = [0.0, 0.0001, 0.07, 0.3, 9.0].map(|seconds| sampling.repetitions(seconds));
        assert_eq!(repetitions, [1_000_000, 3_000, 5, 1, 1]);
    }

    #[test]
    fn work_is_done_in_turn() {
        let order = std::cell::RefCell::new(Vec::new());
        let sampling = Sampling { seconds: 0.0, samples: 3, patience: 10.0 };
        let mut one = || -> Result<(), ()> {
            order.borrow_mut().push(1);
            Ok(())
        };
        let mut two = || {
            order.borrow_mut().push(2);
            Ok(())
        };
        let times = medians(sampling, [&mut one, &mut two]).unwrap();
        assert_eq!(*order.borrow(), [1, 2, 1, 2, 1, 2, 1, 2]);
        assert!(times.iter().all(|&time| time >= 0.0));
    }

    #[test]
    fn the_peak_counts_what_is_used_meanwhile() {
        let peak = Peak::watch();
        let bytes = std::hint::black_box(vec![1u8; 32 << 20]);
        drop(bytes);
        assert!(peak.kib() > 30 << 10, "{} KiB", peak.kib());
    }
}
