//! Stores: memory for results of variable size.

use crate::argument::{BUFFER, In, Out, integer};
use crate::input::record::{self, Gchoice_data, Gloc_data, Gstroke_data, Nothing};
use crate::types::{Gint, Gint_list, Gint_size, Gpat_rep, Gpoint, Gpoint_list};
use gks::{DataRecord, Error, Function};
use gks_pipeline::item::Cells;
use std::collections::BTreeMap;
use std::ffi::{CString, c_char, c_void};
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
    /// What has been inquired of an input device.
    device: Device,
}

/// What has been inquired of an input device, with the memory that its parts point to.
pub(crate) struct Device {
    prompts: Vec<Gint>,
    prompt_list: Gint_list,
    points: Vec<Gpoint>,
    point_list: Gpoint_list,
    text: CString,
    integers: Vec<Gint>,
    strings: Vec<CString>,
    addresses: Vec<*mut c_char>,
    locator: Gloc_data,
    stroke: Gstroke_data,
    choice: Gchoice_data,
    nothing: Nothing,
}

impl Device {
    fn new() -> Self {
        let record = DataRecord::default();
        Device {
            prompts: Vec::new(),
            prompt_list: Gint_list { num_ints: 0, ints: null_mut() },
            points: Vec::new(),
            point_list: Gpoint_list { num_points: 0, points: null_mut() },
            text: CString::default(),
            integers: Vec::new(),
            strings: Vec::new(),
            addresses: Vec::new(),
            locator: record::of_locator(1, &record),
            stroke: record::of_stroke(1, &record),
            choice: record::of_choice(1, &mut [], &mut []),
            nothing: record::NONE,
        }
    }

    /// Keeps a list of prompt and echo types.
    pub(crate) fn prompts(&mut self, prompts: &[Gint]) -> *const Gint_list {
        self.prompts = prompts.to_vec();
        self.prompt_list =
            Gint_list { num_ints: integer(self.prompts.len()), ints: self.prompts.as_mut_ptr() };
        &raw const self.prompt_list
    }

    /// Keeps a list of points.
    pub(crate) fn points(&mut self, points: impl Iterator<Item = Gpoint>) -> *const Gpoint_list {
        self.points = points.collect();
        self.point_list =
            Gpoint_list { num_points: integer(self.points.len()), points: self.points.as_mut_ptr() };
        &raw const self.point_list
    }

    /// Keeps a string, down to the first zero byte in it.
    pub(crate) fn text(&mut self, text: &str) -> *const c_char {
        self.text = c_string(text);
        self.text.as_ptr()
    }

    /// Keeps the data record of a locator.
    pub(crate) fn locator(&mut self, pet: Gint, record: &DataRecord) -> *const Gloc_data {
        self.locator = record::of_locator(pet, record);
        &raw const self.locator
    }

    /// Keeps the data record of a stroke device.
    pub(crate) fn stroke(&mut self, pet: Gint, record: &DataRecord) -> *const Gstroke_data {
        self.stroke = record::of_stroke(pet, record);
        &raw const self.stroke
    }

    /// Keeps the data record of a choice device.
    pub(crate) fn choice(&mut self, pet: Gint, record: &DataRecord) -> *const Gchoice_data {
        self.integers.clone_from(&record.integers);
        self.strings = record.strings.iter().map(|string| c_string(string)).collect();
        self.addresses = self.strings.iter().map(|string| string.as_ptr().cast_mut()).collect();
        self.choice = record::of_choice(pet, &mut self.integers, &mut self.addresses);
        &raw const self.choice
    }

    /// The data record of a device of which none means anything.
    pub(crate) fn nothing(&mut self) -> *const Nothing {
        &raw const self.nothing
    }
}

/// Text as C has it, down to the first zero byte in it.
fn c_string(text: &str) -> CString {
    let end = text.find('\0').unwrap_or(text.len());
    CString::new(&text[..end]).unwrap_or_default()
}

/// Keeps in a store what has been inquired of an input device. Error: 2200 (no such store).
pub(crate) fn device<R>(
    function: Function,
    store: In<Gstore>,
    keep: impl FnOnce(&mut Device) -> R,
) -> gks::Result<R> {
    Ok(keep(&mut stores().find(function, store)?.device))
}

// SAFETY: the pointers of a store are to its own memory.
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
    stores.stores.insert(
        key,
        Box::new(Store { pattern, record: [0; 4], integers: Vec::new(), device: Device::new() }),
    );
    store.set(std::ptr::without_provenance_mut(key));
    err_ind.set(0);
}

/// DELETE STORE. What was put into it is gone.
#[unsafe(no_mangle)]
extern "C" fn gdel_store(store: Gstore) {
    stores().stores.remove(&store.addr());
}
