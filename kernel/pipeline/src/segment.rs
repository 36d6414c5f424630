//! Segments: primitives under a name, with attributes that change how all of them are shown.
//!
//! There is one store for all workstations. Each segment is kept once; for each workstation there is an
//! index of the segments associated with it, in the order in which they are drawn. So a segment is found,
//! renamed, moved in the order and deleted in logarithmic time, whatever it is associated with.

use crate::recording::Recording;
use gks_geometry::{Map, Ndc};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound::{Excluded, Unbounded};

/// How the primitives of a segment are shown.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Appearance {
    /// The segment transformation, which moves everything but clipping rectangles.
    pub transformation: Map<Ndc, Ndc>,
    /// Whether the segment is highlighted.
    pub highlighted: bool,
}

impl Appearance {
    /// Of primitives outside of segments.
    pub const PLAIN: Appearance = Appearance { transformation: Map::IDENTITY, highlighted: false };
}

/// A segment: its state list and its primitives.
#[derive(Clone, Debug)]
pub struct Segment {
    /// The segment transformation and whether the segment is highlighted.
    pub appearance: Appearance,
    /// Whether the segment is shown.
    pub visible: bool,
    /// Whether the segment can be picked.
    pub detectable: bool,
    /// The primitives.
    pub recording: Recording,
    name: i32,
    rank: Rank,
    workstations: BTreeSet<i32>,
}

impl Segment {
    /// The name.
    pub fn name(&self) -> i32 {
        self.name
    }

    /// The segment priority, from 0 to 1.
    pub fn priority(&self) -> f64 {
        self.rank.priority
    }

    /// The identifiers of the associated workstations, in increasing order.
    pub fn workstations(&self) -> &BTreeSet<i32> {
        &self.workstations
    }

    /// Whether there is something to be seen of the segment.
    pub fn is_shown(&self) -> bool {
        self.visible && !self.recording.is_empty()
    }
}

/// The place of a segment among those of a workstation: the priority, and among equal ones the order of
/// creation. The number also identifies the segment inside of the store.
#[derive(Copy, Clone, Debug)]
struct Rank {
    priority: f64,
    number: u64,
}

impl Ord for Rank {
    fn cmp(&self, other: &Self) -> Ordering {
        #[cfg(test)]
        tests::COMPARISONS.with(|count| count.set(count.get() + 1));
        self.priority.total_cmp(&other.priority).then(self.number.cmp(&other.number))
    }
}

impl PartialOrd for Rank {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Rank {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Rank {}

/// The segments of a kernel.
#[derive(Clone, Debug, Default)]
pub struct Segments {
    /// Segments by number, which counts creations.
    all: BTreeMap<u64, Segment>,
    names: BTreeMap<i32, u64>,
    /// The order of drawing on each workstation that has segments.
    orders: BTreeMap<i32, BTreeSet<Rank>>,
    created: u64,
}

impl Segments {
    /// A store without segments.
    pub fn new() -> Self {
        Segments::default()
    }

    /// Number of segments.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether there is no segment.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The names in use, in increasing order.
    pub fn names(&self) -> impl Iterator<Item = i32> + Clone + '_ {
        self.names.keys().copied()
    }

    /// The segment with a name.
    pub fn get(&self, name: i32) -> Option<&Segment> {
        self.all.get(self.names.get(&name)?)
    }

    /// The segment with a name, to be changed. The priority is changed by [`Segments::set_priority`].
    pub fn get_mut(&mut self, name: i32) -> Option<&mut Segment> {
        self.all.get_mut(self.names.get(&name)?)
    }

    /// The segments of a workstation in the order of drawing: the highest priority last, and among equal ones
    /// the youngest.
    pub fn on(&self, workstation: i32) -> impl DoubleEndedIterator<Item = &Segment> + Clone + '_ {
        let order = self.orders.get(&workstation);
        order.into_iter().flatten().filter_map(|rank| self.all.get(&rank.number))
    }

    /// Whether a workstation has segments.
    pub fn any_on(&self, workstation: i32) -> bool {
        self.orders.contains_key(&workstation)
    }

    /// Whether something is to be seen on a workstation of a segment that is drawn after the named one.
    pub fn is_covered(&self, name: i32, workstation: i32) -> bool {
        let Some((segment, order)) = self.get(name).zip(self.orders.get(&workstation)) else { return false };
        let mut above =
            order.range((Excluded(segment.rank), Unbounded)).filter_map(|rank| self.all.get(&rank.number));
        above.any(Segment::is_shown)
    }

    /// Creates a segment that is associated with workstations. Whether the name was free.
    pub fn create(&mut self, name: i32, workstations: impl IntoIterator<Item = i32>) -> bool {
        if self.names.contains_key(&name) {
            return false;
        }
        let number = self.created;
        self.created += 1;
        let segment = Segment {
            appearance: Appearance::PLAIN,
            visible: true,
            detectable: false,
            recording: Recording::new(),
            name,
            rank: Rank { priority: 0.0, number },
            workstations: BTreeSet::new(),
        };
        self.names.insert(name, number);
        self.all.insert(number, segment);
        for workstation in workstations {
            self.associate(name, workstation);
        }
        true
    }

    /// Associates a segment with a workstation. Whether it was not associated before.
    pub fn associate(&mut self, name: i32, workstation: i32) -> bool {
        let Some(segment) = self.get_mut(name) else { return false };
        let new = segment.workstations.insert(workstation);
        let rank = segment.rank;
        self.orders.entry(workstation).or_default().insert(rank);
        new
    }

    /// Gives a segment another name, which has to be free. Whether there was such a segment.
    pub fn rename(&mut self, old: i32, new: i32) -> bool {
        let Some(number) = self.names.remove(&old) else { return false };
        self.names.insert(new, number);
        if let Some(segment) = self.all.get_mut(&number) {
            segment.name = new;
        }
        true
    }

    /// Sets the priority of a segment, which has to be a finite number.
    pub fn set_priority(&mut self, name: i32, priority: f64) {
        let Some(segment) = self.names.get(&name).and_then(|number| self.all.get_mut(number)) else { return };
        let old = segment.rank;
        // Zero has one sign.
        segment.rank.priority = priority + 0.0;
        for workstation in &segment.workstations {
            if let Some(order) = self.orders.get_mut(workstation) {
                order.remove(&old);
                order.insert(segment.rank);
            }
        }
    }

    /// Deletes a segment everywhere and returns it.
    pub fn delete(&mut self, name: i32) -> Option<Segment> {
        let segment = self.all.remove(&self.names.remove(&name)?)?;
        for &workstation in &segment.workstations {
            remove_from(&mut self.orders, workstation, &segment.rank);
        }
        Some(segment)
    }

    /// Ends the association of a segment with a workstation; the segment is deleted with its last one.
    /// Whether there was such an association.
    pub fn dissociate(&mut self, name: i32, workstation: i32) -> bool {
        let Some(segment) = self.names.get(&name).and_then(|number| self.all.get_mut(number)) else {
            return false;
        };
        if !segment.workstations.remove(&workstation) {
            return false;
        }
        remove_from(&mut self.orders, workstation, &segment.rank);
        if segment.workstations.is_empty() {
            self.delete(name);
        }
        true
    }

    /// Ends the associations of all segments with a workstation, as if one by one.
    pub fn forget(&mut self, workstation: i32) {
        for rank in self.orders.remove(&workstation).into_iter().flatten() {
            let Some(segment) = self.all.get_mut(&rank.number) else { continue };
            segment.workstations.remove(&workstation);
            if segment.workstations.is_empty() {
                let name = segment.name;
                self.delete(name);
            }
        }
    }
}

fn remove_from(orders: &mut BTreeMap<i32, BTreeSet<Rank>>, workstation: i32, rank: &Rank) {
    if let Some(order) = orders.get_mut(&workstation) {
        order.remove(rank);
        if order.is_empty() {
            orders.remove(&workstation);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    thread_local! {
        /// How often the places of segments have been compared.
        pub(super) static COMPARISONS: Cell<usize> = const { Cell::new(0) };
    }

    fn names(segments: &Segments, workstation: i32) -> Vec<i32> {
        segments.on(workstation).map(Segment::name).collect()
    }

    #[test]
    fn segments_are_drawn_by_priority_and_then_by_age() {
        let mut segments = Segments::new();
        for name in [5, 3, 9] {
            assert!(segments.create(name, [1, 2]));
        }
        assert!(!segments.create(3, [1]));
        assert_eq!(names(&segments, 1), [5, 3, 9]);
        segments.set_priority(5, 0.5);
        segments.set_priority(9, 0.25);
        assert_eq!(names(&segments, 1), [3, 9, 5]);
        assert_eq!(names(&segments, 2), [3, 9, 5]);
        segments.set_priority(3, 0.5);
        // As old as before, and so below.
        assert_eq!(names(&segments, 1), [9, 5, 3]);
        assert!(segments.rename(9, 1));
        assert_eq!(names(&segments, 1), [1, 5, 3]);
        assert_eq!(segments.names().collect::<Vec<_>>(), [1, 3, 5]);
        segments.set_priority(5, -0.0);
        segments.set_priority(1, 0.0);
        assert_eq!(names(&segments, 1), [5, 1, 3]);
    }

    #[test]
    fn a_segment_ends_with_its_last_association() {
        let mut segments = Segments::new();
        segments.create(1, [1, 2]);
        segments.create(2, [1]);
        assert!(!segments.associate(1, 2));
        assert!(segments.associate(2, 3));
        assert!(!segments.dissociate(1, 3));
        assert!(segments.dissociate(1, 2));
        assert!(!segments.any_on(2));
        segments.forget(1);
        assert_eq!(segments.names().collect::<Vec<_>>(), [2]);
        assert!(!segments.any_on(1));
        assert_eq!(segments.delete(2).map(|s| s.workstations.into_iter().collect::<Vec<_>>()), Some(vec![3]));
        assert!(segments.is_empty() && !segments.any_on(3));
    }

    /// One of many segments is deleted or moved without a look at the others.
    #[test]
    fn deletion_takes_logarithmic_work() {
        let mut segments = Segments::new();
        for name in 1..=100_000 {
            segments.create(name, [1, 2]);
            segments.set_priority(name, f64::from(name % 100) / 100.0);
        }
        let work = |f: &mut dyn FnMut()| {
            let before = COMPARISONS.get();
            f();
            COMPARISONS.get() - before
        };
        // A search in a B-tree of this size compares with at most 11 entries in each of about 6 nodes.
        assert!((1..=2 * 66).contains(&work(&mut || assert!(segments.delete(54_321).is_some()))));
        assert!((1..=66).contains(&work(&mut || assert!(segments.dissociate(4_321, 2)))));
        assert!((1..=4 * 66).contains(&work(&mut || segments.set_priority(77_777, 0.123))));
        assert_eq!(segments.len(), 99_999);
        // Even all of them together stay far below one scan for each.
        assert!(work(&mut || segments.forget(1)) < 100_000 * 66);
    }
}
