//! The current item of a metafile that is read.

use gks_pipeline::record::item::{Binary, encode, kind};
use gks_pipeline::record::{Source, SourceError};
use std::collections::VecDeque;

/// The items of the record that was read last, the current one first.
#[derive(Default)]
pub(crate) struct Items {
    queue: VecDeque<Result<(i32, Vec<u8>), SourceError>>,
    /// Whether END ITEM is in the queue, or has been.
    ended: bool,
}

impl Items {
    /// The current item, or why it cannot be read; none if there is none left.
    pub(crate) fn current(
        &mut self,
        source: Option<&mut (dyn Source + 'static)>,
    ) -> Option<Result<&(i32, Vec<u8>), &SourceError>> {
        if self.queue.is_empty() && !self.ended {
            match source.map_or(Ok(None), |source| source.next()) {
                Ok(Some(record)) => {
                    let mut items = Binary::default();
                    encode(&record, &mut items);
                    self.queue.extend(items.items.into_iter().map(Ok));
                }
                Ok(None) => {
                    self.queue.push_back(Ok((kind::END, Vec::new())));
                    self.ended = true;
                }
                Err(error) => self.queue.push_back(Err(error)),
            }
        }
        self.queue.front().map(Result::as_ref)
    }

    /// Passes over the current item and gives its data; the one after it becomes the current one.
    pub(crate) fn pass(&mut self) -> Vec<u8> {
        match self.queue.pop_front() {
            Some(Ok((_, data))) => data,
            _ => Vec::new(),
        }
    }
}
