//! A sink that the test can look into, and one that fails.

use gks_pipeline::device::Sink;
use std::io;
use std::sync::{Arc, Mutex};

/// What a [`Receiver`] has received.
#[derive(Default)]
pub(crate) struct Received {
    /// The documents that are complete.
    pub(crate) documents: Vec<Vec<u8>>,
    /// The document that is not complete yet.
    pub(crate) current: Option<Vec<u8>>,
    /// How many bytes are taken before writing fails.
    pub(crate) room: Option<usize>,
}

/// A sink that keeps what it receives where the test sees it.
#[derive(Clone, Default)]
pub(crate) struct Receiver(pub(crate) Arc<Mutex<Received>>);

impl Receiver {
    /// A sink that fails after `room` bytes.
    pub(crate) fn with_room(room: usize) -> Self {
        Receiver(Arc::new(Mutex::new(Received { room: Some(room), ..Received::default() })))
    }

    /// The sink for a driver.
    pub(crate) fn sink(&self) -> Box<dyn Sink> {
        Box::new(self.clone())
    }

    /// The only document, which must be complete.
    pub(crate) fn document(&self) -> Vec<u8> {
        let received = self.0.lock().unwrap();
        assert_eq!(received.documents.len(), 1, "there should be one complete document");
        received.documents[0].clone()
    }

    /// How many bytes of the current document have come.
    pub(crate) fn so_far(&self) -> usize {
        self.0.lock().unwrap().current.as_ref().map_or(0, Vec::len)
    }
}

impl Sink for Receiver {
    fn open(&mut self) -> io::Result<()> {
        let mut received = self.0.lock().unwrap();
        assert!(received.current.is_none(), "a document is open already");
        received.current = Some(Vec::new());
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        let mut received = self.0.lock().unwrap();
        let room = received.room;
        let current = received.current.as_mut().expect("no document is open");
        if room.is_some_and(|room| current.len() + bytes.len() > room) {
            return Err(io::Error::new(io::ErrorKind::StorageFull, "no room"));
        }
        current.extend_from_slice(bytes);
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        let mut received = self.0.lock().unwrap();
        let document = received.current.take().expect("no document is open");
        received.documents.push(document);
        Ok(())
    }
}
