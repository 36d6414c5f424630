//! How much memory is held while an input is tried.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The most that may be held at once for one input, beside what was held before.
pub const MOST: usize = 64 << 20;

thread_local! {
    /// The bytes that this thread holds, and the most that it has held.
    static HELD: Cell<(isize, isize)> = const { Cell::new((0, 0)) };
}

/// The allocator of the system, which counts for each thread.
struct Counting;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn count(change: isize) {
    // A thread that ends may free when there is nothing to count with any more.
    let _ = HELD.try_with(|held| {
        let (now, most) = held.get();
        held.set((now + change, most.max(now + change)));
    });
}

// SAFETY: every call goes to the allocator of the system as it is.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size as isize - layout.size() as isize);
        unsafe { System.realloc(pointer, layout, size) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        unsafe { System.dealloc(pointer, layout) }
    }
}

/// The most bytes that were held at once while something was done, beside those held before.
pub fn peak(work: impl FnOnce()) -> usize {
    let before = HELD.with(|held| {
        let (now, _) = held.get();
        held.set((now, now));
        now
    });
    work();
    let (_, most) = HELD.with(Cell::get);
    usize::try_from(most - before).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_at_once_is_counted() {
        let held = peak(|| {
            drop(vec![1_u8; 1 << 20]);
            let mut grown = vec![1_u8; 1 << 20];
            grown.reserve_exact(1 << 20);
            drop(vec![0_u8; 1 << 18]);
        });
        assert!((2 << 20..(2 << 20) + (1 << 19)).contains(&held), "{held}");
    }

    #[test]
    #[should_panic(expected = "it held 65 MiB")]
    fn an_input_that_holds_too_much_fails() {
        crate::attempt(|_| drop(vec![1_u8; 65 << 20]), &[]);
    }
}
