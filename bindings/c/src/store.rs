//! Stores: memory for results of variable size.

use crate::argument::{BUFFER, In, Out, integer};
use crate::types::{Gint, Gint_size, Gpat_rep};
use gks::{DataRecord, Error, Function};
use gks_pipeline::item::Cells;
use std::collections::BTreeMap;
use std::ffi::c_void;
use std::ptr::null_mut;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A store as a program knows it: an address that nobody reads, different for each store ever made. What is
/// no store, or no longer one, is found out.
pub(crate) type Gstore = *mut c_void;

/// What the last inquiry put into a store.
struct Store {
    pattern: Gpat_rep,
    /// An output data record of an escape function, by its integers.
    record: [Gint; 4],
    /// What `pattern` points to.
    integers: Vec<Gint>,
}

// SAFETY: the pointer of a store is to its own memory.
unsafe impl Send for Store {}

struct Stores {
    last: usize,
    stores: BTreeMap<usize, Box<Store>>,
}

fn stores() -> MutexGuard<'static, Stores> {
    static STORES: Mutex<Stores> = Mutex::new(Stores { last: 0, stores: BTreeMap::new() });
    STORES.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Stores {
    /// The store for a result. Error: 2200 (there is none).
    fn find(&mut self, function: Function, store: In<Gstore>) -> gks::Result<&mut Store> {
        let store = store.get().and_then(|store| self.stores.get_mut(&store.addr()));
        store.map(Box::as_mut).ok_or_else(|| Error::new(BUFFER, function).because("no such store"))
    }
}

/// Puts a pattern into a store. Error: 2200 (no such store).
pub(crate) fn pattern(
    function: Function,
    store: In<Gstore>,
    cells: &Cells<'_>,
) -> gks::Result<*const Gpat_rep> {
    let mut stores = stores();
    let store = stores.find(function, store)?;
    store.integers.clear();
    (0..cells.rows).for_each(|row| store.integers.extend_from_slice(cells.row(row)));
    let dims = Gint_size { size_x: integer(cells.columns), size_y: integer(cells.rows) };
    store.pattern = Gpat_rep { dims, colr_array: store.integers.as_mut_ptr() };
    Ok(&raw const store.pattern)
}

/// Puts the integers of an output data record into a store. Error: 2200 (no such store).
pub(crate) fn record(function: Function, store: In<Gstore>, record: &DataRecord) -> gks::Result<*const Gint> {
    let mut stores = stores();
    let store = stores.find(function, store)?;
    store.record.iter_mut().zip(&record.integers).for_each(|(to, from)| *to = *from);
    Ok(store.record.as_ptr())
}

/// CREATE STORE.
#[unsafe(no_mangle)]
extern "C" fn gcreate_store(err_ind: Out<Gint>, store: Out<Gstore>) {
    let mut stores = stores();
    stores.last += 1;
    let key = stores.last;
    let pattern = Gpat_rep { dims: Gint_size { size_x: 0, size_y: 0 }, colr_array: null_mut() };
    stores.stores.insert(key, Box::new(Store { pattern, record: [0; 4], integers: Vec::new() }));
    store.set(std::ptr::without_provenance_mut(key));
    err_ind.set(0);
}

/// DELETE STORE. What was put into it is gone.
#[unsafe(no_mangle)]
extern "C" fn gdel_store(store: Gstore) {
    stores().stores.remove(&store.addr());
}
