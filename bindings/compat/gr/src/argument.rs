//! Arguments of functions, and the calls of the kernel.

use gks::{Error, Function, Gks};
use gks_instance::{ErrorFile, Instance};
use std::borrow::Cow;
use std::ffi::{CStr, c_char, c_int};
use std::sync::atomic::{AtomicI32, Ordering};

/// The error of a value outside of its enumeration.
const ENUMERATION: i32 = 2000;

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
    /// The address of a variable of ours.
    pub(crate) fn of(variable: &mut T) -> Self {
        Address(variable)
    }

    /// The address that a pointer in a structure of the program holds.
    pub(crate) fn at(pointer: *mut T) -> Self {
        Address(pointer)
    }
}

impl<T: Copy> Address<T> {
    /// The value. Error: 2000 (null pointer).
    pub(crate) fn get(self, function: Function) -> gks::Result<T> {
        let value = self.slice(1).first().copied();
        value.ok_or_else(|| Error::new(ENUMERATION, function).because("null pointer"))
    }

    /// Sets the value, unless the program does not want it.
    pub(crate) fn set(self, value: T) {
        self.set_all([value]);
    }

    /// Sets the first values of an array, unless the program does not want them.
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
    pub(crate) fn array<'a>(self, count: c_int) -> &'a [T] {
        self.slice(usize::try_from(count).unwrap_or(0))
    }

    /// The first `count` values of an array; none at a null pointer.
    pub(crate) fn slice<'a>(self, count: usize) -> &'a [T] {
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

/// A value of an enumeration. Error: 2000.
pub(crate) fn choice<E>(value: Option<E>, function: Function) -> gks::Result<E> {
    value.ok_or_else(|| Error::new(ENUMERATION, function).because("value outside of its enumeration"))
}

/// A number of the kernel; what is too great becomes the greatest one.
pub(crate) fn integer(value: impl TryInto<c_int>) -> c_int {
    value.try_into().unwrap_or(c_int::MAX)
}

/// The number of the last error, which programs may read.
#[unsafe(no_mangle)]
#[allow(non_upper_case_globals, reason = "the name that programs know")]
static gks_errno: AtomicI32 = AtomicI32::new(0);

/// Logs an error: there is no error handling function to replace.
fn report(error: &Error, file: &ErrorFile) {
    gks_errno.store(error.number, Ordering::Relaxed);
    file.write(&format!("{error}\n"));
}

/// Runs functions, and gives the number of the last error of theirs, or 0.
pub(crate) fn outcome(f: impl FnOnce()) -> c_int {
    gks_errno.store(0, Ordering::Relaxed);
    f();
    gks_errno.load(Ordering::Relaxed)
}

/// Runs a function that is not an inquiry. A wrong operating state is found before a wrong argument.
pub(crate) fn call(function: Function, f: impl FnOnce(&mut Gks) -> gks::Result<()>) {
    call_instance(function, |instance| f(&mut instance.gks));
}

/// [`call`] for functions that need more than the kernel.
pub(crate) fn call_instance(function: Function, f: impl FnOnce(&mut Instance) -> gks::Result<()>) {
    gks_instance::call_instance(function, report, |instance| {
        gks_instance::check_state(&instance.gks, function)?;
        f(instance)
    });
}

/// Runs an inquiry, which sets its results itself, and sets the error indicator.
pub(crate) fn inquire(
    function: Function,
    error: Address<c_int>,
    f: impl FnOnce(&mut Gks) -> gks::Result<()>,
) {
    error.set(gks_instance::inquire(function, f).err().unwrap_or(0));
}
