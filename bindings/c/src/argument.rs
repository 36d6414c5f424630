//! Arguments of C functions: pointers to what they read and set, text, and the calls of the kernel.

use crate::error::report;
use crate::types::{Gint, Gint_list, Gpoint_list};
use gks::{Error, Function, Gks};
use std::borrow::Cow;
use std::ffi::{CStr, c_char};

/// The binding's error for a buffer that is too small, or not there at all.
pub(crate) const BUFFER: i32 = 2200;
/// The binding's error for a start position outside a list.
const START: i32 = 2201;
/// The binding's error for a value outside its enumeration.
const ENUMERATION: i32 = 2202;
/// The binding's error for a negative length of a list.
const LENGTH: i32 = 2203;

/// A pointer to what a function reads. Only C makes one.
#[repr(transparent)]
pub(crate) struct In<T>(*const T);

/// A pointer to what a function sets. Only C makes one.
#[repr(transparent)]
pub(crate) struct Out<T>(*mut T);

impl<T> Copy for In<T> {}
impl<T> Clone for In<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Out<T> {}
impl<T> Clone for Out<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> In<T> {
    /// The address, which may be null.
    pub(crate) fn address(self) -> *const T {
        self.0
    }

    /// The same address as one of a value of another type.
    pub(crate) fn cast<U>(self) -> In<U> {
        In(self.0.cast())
    }
}

impl<T: Copy> In<T> {
    /// The value; none at a null pointer.
    #[inline]
    pub(crate) fn get(self) -> Option<T> {
        // SAFETY: the contract of the crate.
        unsafe { self.0.as_ref() }.copied()
    }

    /// The value as one that a function cannot do without. Error: 2200 (null pointer).
    #[inline]
    pub(crate) fn needed(self, function: Function) -> gks::Result<T> {
        self.get().ok_or_else(|| null(function))
    }
}

#[cold]
fn null(function: Function) -> Error {
    Error::new(BUFFER, function).because("null pointer")
}

impl In<c_char> {
    /// The address of a string; null for none.
    pub(crate) fn of(string: Option<&CStr>) -> Self {
        In(string.map_or(std::ptr::null(), CStr::as_ptr))
    }

    /// Text that ends with a zero byte: UTF-8, or Latin-1 where it is not valid as that.
    pub(crate) fn text<'a>(self) -> Cow<'a, str> {
        if self.0.is_null() {
            return Cow::Borrowed("");
        }
        // SAFETY: the contract of the crate.
        gks_instance::from_utf8_or_latin1(unsafe { CStr::from_ptr(self.0) }.to_bytes())
    }
}

/// The values of an array; none at a null pointer or for a negative number.
#[inline]
pub(crate) fn array<'a, T>(first: *const T, count: Gint) -> &'a [T] {
    let count = usize::try_from(count).unwrap_or(0);
    if first.is_null() || count.checked_mul(size_of::<T>()).is_none_or(|bytes| bytes > isize::MAX as usize) {
        return &[];
    }
    // SAFETY: the contract of the crate; the size was checked.
    unsafe { std::slice::from_raw_parts(first, count) }
}

impl<T> Out<T> {
    /// Sets the value, unless the program does not want it.
    #[inline]
    pub(crate) fn set(self, value: T) {
        if !self.0.is_null() {
            // SAFETY: the contract of the crate.
            unsafe { self.0.write(value) }
        }
    }

    /// Sets values from the first on.
    pub(crate) fn set_all(self, values: impl IntoIterator<Item = T>) {
        if self.0.is_null() {
            return;
        }
        for (i, value) in values.into_iter().enumerate() {
            // SAFETY: the contract of the crate; the caller has checked how many values there is room for.
            unsafe { self.0.add(i).write(value) }
        }
    }

    /// The value that the program has set before the call.
    pub(crate) fn get(self) -> Option<T>
    where
        T: Copy,
    {
        // SAFETY: the contract of the crate.
        unsafe { self.0.as_ref() }.copied()
    }

    /// The same address as one of values of another type.
    pub(crate) fn cast<U>(self) -> Out<U> {
        Out(self.0.cast())
    }

    /// Whether the program wants the value.
    pub(crate) fn is_wanted(self) -> bool {
        !self.0.is_null()
    }

    /// A member of a structure to set.
    pub(crate) fn member<U>(self, project: impl FnOnce(*mut T) -> *mut U) -> Out<U> {
        if self.0.is_null() { Out(std::ptr::null_mut()) } else { Out(project(self.0)) }
    }
}

impl<T> Out<*mut T> {
    /// The array that a member of a structure of the program points to.
    pub(crate) fn target(self) -> Out<T> {
        Out(self.get().unwrap_or(std::ptr::null_mut()))
    }
}

impl Out<Gpoint_list> {
    /// The number of points of a list.
    pub(crate) fn count(self) -> Out<Gint> {
        // SAFETY: the address of a member of a structure that is there.
        self.member(|list| unsafe { &raw mut (*list).num_points })
    }
}

impl Out<Gint_list> {
    /// The number of integers of a list.
    pub(crate) fn count(self) -> Out<Gint> {
        // SAFETY: the address of a member of a structure that is there.
        self.member(|list| unsafe { &raw mut (*list).num_ints })
    }

    /// The array of a list.
    pub(crate) fn integers(self) -> Out<Gint> {
        // SAFETY: the address of a member of a structure that is there.
        self.member(|list| unsafe { &raw mut (*list).ints }).target()
    }
}

/// A value of an enumeration. Error: 2202.
#[inline]
pub(crate) fn choice<E>(
    function: Function,
    number: Gint,
    from_number: impl FnOnce(Gint) -> Option<E>,
) -> gks::Result<E> {
    from_number(number).ok_or_else(|| no_value(function, number))
}

/// A value of an enumeration with two values, the second of which is `true`. Error: 2202.
#[inline]
pub(crate) fn flag(function: Function, number: Gint) -> gks::Result<bool> {
    match number {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(no_value(function, number)),
    }
}

#[cold]
fn no_value(function: Function, number: Gint) -> Error {
    Error::new(ENUMERATION, function).because(format!("value {number}"))
}

/// A number of the kernel; what is too great becomes the greatest one.
pub(crate) fn integer(value: impl TryInto<Gint>) -> Gint {
    value.try_into().unwrap_or(Gint::MAX)
}

/// Runs a function that is not an inquiry; an error goes to the error handler. A wrong operating state is
/// found before a wrong argument.
#[inline]
pub(crate) fn call(function: Function, f: impl FnOnce(&mut Gks) -> gks::Result<()>) {
    gks_instance::call(function, report, |gks| {
        gks_instance::check_state(gks, function)?;
        f(gks)
    });
}

/// Runs an inquiry, which sets its results itself, and sets the error indicator.
#[inline]
pub(crate) fn inquire<R>(function: Function, err_ind: Out<Gint>, f: impl FnOnce(&mut Gks) -> gks::Result<R>) {
    err_ind.set(gks_instance::inquire(function, f).err().unwrap_or(0));
}

/// Where a list inquiry puts elements of its list, and which.
pub(crate) struct Part<T> {
    /// The number of elements that the program has room for.
    room: Gint,
    /// The position of the first element that it wants, from 0.
    start: Gint,
    elements: Out<T>,
    count: Out<Gint>,
    length: Out<Gint>,
}

impl<T> Part<T> {
    /// At most `room` elements from the position `start` on. The number of elements set and the length of the
    /// whole list are 0 until the list is known.
    pub(crate) fn new(
        (room, start): (Gint, Gint),
        elements: Out<T>,
        count: Out<Gint>,
        length: Out<Gint>,
    ) -> Self {
        count.set(0);
        length.set(0);
        Part { room, start, elements, count, length }
    }

    /// Sets the elements and returns their number. Errors: 2203 (negative room), 2201 (no element at the start
    /// position).
    pub(crate) fn set(
        &self,
        function: Function,
        list: impl IntoIterator<Item = T, IntoIter: Clone>,
    ) -> gks::Result<Gint> {
        let list = list.into_iter();
        let length = list.clone().count();
        let room = usize::try_from(self.room).map_err(|_| Error::new(LENGTH, function))?;
        let start = usize::try_from(self.start).ok().filter(|&start| start == 0 || start < length);
        let start = start.ok_or_else(|| Error::new(START, function))?;
        let count = if self.elements.is_wanted() { room.min(length - start) } else { 0 };
        self.elements.set_all(list.skip(start).take(count));
        self.count.set(integer(count));
        self.length.set(integer(length));
        Ok(integer(count))
    }

    /// The address of the room.
    pub(crate) fn address(&self) -> *mut T {
        self.elements.0
    }
}

impl Part<Gint> {
    /// Elements of a list of integers in the array of a list of the program.
    pub(crate) fn of(room: Gint, start: Gint, list: Out<Gint_list>, length: Out<Gint>) -> Self {
        Part::new((room, start), list.integers(), list.count(), length)
    }
}
