//! Arguments of functions, and the calls of the kernel.

use super::error::report;
use super::types::{Gint, Gintlist};
use gks::{Error, Function, Gks};
use gks_instance::Instance;
use std::borrow::Cow;
use std::cell::Cell;
use std::ffi::{CStr, c_char, c_void};

/// The error of a parameter that makes no sense: a null pointer, a value outside of its enumeration. The
/// standard leaves the numbers from 2000 on to language bindings.
const PARAMETER: i32 = 2000;

unsafe extern "C" {
    fn malloc(size: usize) -> *mut c_void;
}

/// A pointer to what a function reads or sets. Only C makes one.
#[repr(transparent)]
pub(crate) struct Address<T>(*mut T);

impl<T> Copy for Address<T> {}
impl<T> Clone for Address<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Address<T> {
    /// The address that a pointer in a structure of the program holds.
    pub(crate) fn at(pointer: *mut T) -> Self {
        Address(pointer)
    }

    /// The address with a number that a structure of the program holds.
    pub(crate) fn to(number: usize) -> Self {
        Address(std::ptr::with_exposed_provenance_mut(number))
    }

    /// The number of the address that lies a number of bytes behind.
    pub(crate) fn after(self, bytes: usize) -> usize {
        self.0.wrapping_byte_add(bytes).expose_provenance()
    }

    /// The address of a member of a structure.
    pub(crate) fn member<U>(self, project: impl FnOnce(*mut T) -> *mut U) -> Address<U> {
        Address(if self.0.is_null() { std::ptr::null_mut() } else { project(self.0) })
    }

    /// Whether the program has given none.
    pub(crate) fn is_null(self) -> bool {
        self.0.is_null()
    }
}

impl<T: Copy> Address<T> {
    /// The value; none at a null pointer.
    pub(crate) fn value(self) -> Option<T> {
        // SAFETY: the contract of the crate.
        unsafe { self.0.as_ref() }.copied()
    }

    /// The value. Error: 2000 (null pointer).
    pub(crate) fn get(self, function: Function) -> gks::Result<T> {
        self.value().ok_or_else(|| Error::new(PARAMETER, function).because("null pointer"))
    }

    /// Sets the value, unless the program does not want it.
    pub(crate) fn set(self, value: T) {
        if !self.0.is_null() {
            // SAFETY: the contract of the crate.
            unsafe { self.0.write(value) }
        }
    }

    /// Sets values from the first on, unless the program does not want them. The caller has checked how many there is
    /// room for.
    pub(crate) fn set_all(self, values: impl IntoIterator<Item = T>) {
        if self.0.is_null() {
            return;
        }
        for (i, value) in values.into_iter().enumerate() {
            // SAFETY: the contract of the crate.
            unsafe { self.0.add(i).write(value) }
        }
    }

    /// The first `count` values of an array; none at a null pointer or for a negative number.
    pub(crate) fn array<'a>(self, count: Gint) -> &'a [T] {
        let count = usize::try_from(count).unwrap_or(0);
        if self.0.is_null() || count.checked_mul(size_of::<T>()).is_none_or(|n| n > isize::MAX as usize) {
            return &[];
        }
        // SAFETY: the contract of the crate; the size was checked.
        unsafe { std::slice::from_raw_parts(self.0, count) }
    }
}

impl Address<c_char> {
    /// Text that ends with a zero byte; none at a null pointer.
    pub(crate) fn text<'a>(self) -> Cow<'a, str> {
        if self.0.is_null() {
            return Cow::Borrowed("");
        }
        // SAFETY: the contract of the crate.
        gks_instance::from_utf8_or_latin1(unsafe { CStr::from_ptr(self.0) }.to_bytes())
    }
}

/// A list in memory that the program will free; a null pointer for an empty one and where there is no memory.
pub(crate) fn allocated<T>(values: &[T]) -> *mut T {
    if values.is_empty() {
        return std::ptr::null_mut();
    }
    // SAFETY: any size may be asked for.
    let address = unsafe { malloc(size_of_val(values)) }.cast::<T>();
    if !address.is_null() {
        // SAFETY: there is room for the values, which are not there.
        unsafe { std::ptr::copy_nonoverlapping(values.as_ptr(), address, values.len()) }
    }
    address
}

/// A text in memory that the program will free.
pub(crate) fn allocated_text(text: &str) -> *mut c_char {
    let bytes: Vec<c_char> = text.bytes().filter(|&byte| byte != 0).chain([0]).map(|b| b as c_char).collect();
    allocated(&bytes)
}

/// A list of integers for the program.
pub(crate) fn list(values: impl IntoIterator<Item = Gint>) -> Gintlist {
    let values: Vec<Gint> = values.into_iter().collect();
    let integers = allocated(&values);
    Gintlist { number: if integers.is_null() { 0 } else { integer(values.len()) }, integers }
}

/// A number of the kernel; what is too great becomes the greatest one.
pub(crate) fn integer(value: impl TryInto<Gint>) -> Gint {
    value.try_into().unwrap_or(Gint::MAX)
}

/// A value of an enumeration. Error: 2000.
pub(crate) fn choice<E>(value: Option<E>, function: Function) -> gks::Result<E> {
    value.ok_or_else(|| Error::new(PARAMETER, function).because("value outside of its enumeration"))
}

/// Runs a function that is not an inquiry. A wrong operating state is found before a wrong argument.
pub(crate) fn call(function: Function, f: impl FnOnce(&mut Gks) -> gks::Result<()>) -> Gint {
    call_instance(function, |instance| f(&mut instance.gks))
}

/// [`call`] for functions that need more than the kernel.
pub(crate) fn call_instance(function: Function, f: impl FnOnce(&mut Instance) -> gks::Result<()>) -> Gint {
    call_as(None, function, f)
}

/// [`call_instance`] for a function of XGKS that does what several of the standard do: all errors are reported as its own,
/// by its number.
pub(crate) fn call_as(
    as_function: Option<Gint>,
    function: Function,
    f: impl FnOnce(&mut Instance) -> gks::Result<()>,
) -> Gint {
    let number = Cell::new(0);
    let reported = |error: &Error, _: &gks_instance::ErrorFile| {
        number.set(error.number);
        report(error, as_function);
    };
    gks_instance::call_instance(function, reported, |instance| {
        gks_instance::check_state(&instance.gks, function)?;
        f(instance)
    });
    number.get()
}

/// Runs an inquiry, which sets its results itself.
pub(crate) fn inquire(function: Function, f: impl FnOnce(&mut Gks) -> gks::Result<()>) -> Gint {
    gks_instance::inquire(function, f).err().unwrap_or(0)
}
