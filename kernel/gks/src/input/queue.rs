//! The input queue: reports of events in the order in which triggers fired.

use super::value::InputValue;
use gks_pipeline::generated::numbers;
use gks_pipeline::input::LogicalDevice;
use std::collections::VecDeque;

/// The most event reports that are kept.
const CAPACITY: usize = numbers::MAX_QUEUED_EVENTS as usize;

/// An event report.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Event {
    pub(crate) workstation: i32,
    pub(crate) device: LogicalDevice,
    pub(crate) value: InputValue,
    /// The same for all reports that one trigger made.
    group: u64,
}

/// The device whose report did not fit.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Overflow {
    pub(crate) workstation: i32,
    pub(crate) device: LogicalDevice,
    /// Whether the workstation has been closed since.
    pub(crate) closed: bool,
}

/// The input queue, the current event report, and what there is to say about lost reports.
#[derive(Debug, Default)]
pub(crate) struct EventQueue {
    queue: VecDeque<Event>,
    current: Option<Event>,
    groups: u64,
    /// Whether reports are lost until the queue has been emptied.
    full: bool,
    /// Whether an overflow has still to be reported as error 147.
    unreported: bool,
    /// The device that caused the last overflow, until it is inquired.
    overflow: Option<Overflow>,
}

impl EventQueue {
    /// Appends the reports of one trigger, all or none of them.
    pub(crate) fn push(&mut self, workstation: i32, values: Vec<(LogicalDevice, InputValue)>) {
        let Some(&(first, _)) = values.first() else { return };
        if self.full {
            return;
        }
        if values.len() > CAPACITY - self.queue.len() {
            self.full = true;
            self.unreported = true;
            self.overflow = Some(Overflow { workstation, device: first, closed: false });
            return;
        }
        self.groups += 1;
        let group = self.groups;
        let event = |(device, value)| Event { workstation, device, value, group };
        self.queue.extend(values.into_iter().map(event));
    }

    /// Whether there is no report. A queue found empty takes reports again after an overflow.
    pub(crate) fn begin_again_if_empty(&mut self) -> bool {
        let empty = self.queue.is_empty();
        if empty {
            self.full = false;
        }
        empty
    }

    /// Whether there is no report.
    pub(crate) fn is_empty(&self) -> bool {
        self.queue.is_empty()
    }

    /// Makes the oldest report the current one; if there is none, there is no current report.
    pub(crate) fn advance(&mut self) {
        self.current = self.queue.pop_front();
    }

    /// The current report.
    pub(crate) fn current(&self) -> Option<&Event> {
        self.current.as_ref()
    }

    /// Whether the oldest report was made by the trigger of the current one.
    pub(crate) fn more(&self) -> bool {
        match (&self.current, self.queue.front()) {
            (Some(current), Some(next)) => current.group == next.group,
            _ => false,
        }
    }

    /// Removes the reports of a device.
    pub(crate) fn flush(&mut self, workstation: i32, device: LogicalDevice) {
        self.queue.retain(|event| (event.workstation, event.device) != (workstation, device));
    }

    /// Removes all reports of a workstation that is closed.
    pub(crate) fn forget(&mut self, workstation: i32) {
        self.queue.retain(|event| event.workstation != workstation);
        self.current = self.current.take().filter(|event| event.workstation != workstation);
        if let Some(overflow) = self.overflow.as_mut().filter(|o| o.workstation == workstation) {
            overflow.closed = true;
        }
    }

    /// Whether an overflow has not been reported yet; it is now.
    pub(crate) fn take_unreported(&mut self) -> bool {
        std::mem::take(&mut self.unreported)
    }

    /// The device that caused the last overflow; it is forgotten.
    pub(crate) fn take_overflow(&mut self) -> Option<Overflow> {
        self.overflow.take()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::input::InputClass;

    const VALUATOR: LogicalDevice = LogicalDevice { class: InputClass::Valuator, number: 1 };
    const CHOICE: LogicalDevice = LogicalDevice { class: InputClass::Choice, number: 2 };

    fn both() -> Vec<(LogicalDevice, InputValue)> {
        vec![(VALUATOR, InputValue::Valuator(0.5)), (CHOICE, InputValue::Choice(None))]
    }

    fn one() -> Vec<(LogicalDevice, InputValue)> {
        both().split_off(1)
    }

    /// The workstation and the device of the next report.
    fn next(queue: &mut EventQueue) -> Option<(i32, LogicalDevice)> {
        queue.advance();
        queue.current().map(|event| (event.workstation, event.device))
    }

    #[test]
    fn reports_of_one_trigger_belong_together() {
        let mut queue = EventQueue::default();
        queue.push(1, both());
        queue.push(1, one());
        assert!(!queue.more());
        assert_eq!(next(&mut queue), Some((1, VALUATOR)));
        assert!(queue.more());
        assert_eq!(next(&mut queue), Some((1, CHOICE)));
        assert!(!queue.more());
        queue.flush(1, CHOICE);
        assert_eq!(next(&mut queue), None);
    }

    #[test]
    fn a_group_that_does_not_fit_is_lost_and_all_that_follows_until_the_queue_is_empty() {
        let mut queue = EventQueue::default();
        (1..CAPACITY).for_each(|_| queue.push(1, one()));
        assert!(!queue.take_unreported());
        queue.push(1, both());
        queue.push(1, one());
        assert!(queue.take_unreported() && !queue.take_unreported());
        let mut count = 0;
        while !queue.begin_again_if_empty() {
            queue.advance();
            count += 1;
        }
        assert_eq!(count, CAPACITY - 1);
        let expected = Overflow { workstation: 1, device: VALUATOR, closed: false };
        assert_eq!(queue.take_overflow(), Some(expected));
        assert_eq!(queue.take_overflow(), None);
        queue.push(1, one());
        assert!(next(&mut queue).is_some());
    }

    #[test]
    fn a_closed_workstation_takes_its_reports_with_it() {
        let mut queue = EventQueue::default();
        queue.push(1, one());
        queue.push(2, one());
        queue.push(1, one());
        queue.advance();
        queue.forget(1);
        assert_eq!(queue.current(), None);
        assert_eq!(next(&mut queue), Some((2, CHOICE)));
        assert_eq!(next(&mut queue), None);
    }
}
