//! Arguments of Fortran subroutines: addresses of variables, arrays and character strings.

use gks::{
    CoordinateSwitch, Detectability, Error, Function, Highlighting, RelativePriority, ValueType, Visibility,
};
use gks_pipeline::description::{
    Category, Classification, DeferralMode, DynamicModification, RegenerationMode,
};
use gks_pipeline::look::{Horizontal, InteriorStyle, Precision, TextPath, Vertical};
use std::ffi::c_int;

/// An argument of a call: the address of a variable or of the first element of an array.
///
/// Only Fortran makes one. Its target is there for the time of the call, as the crate's documentation says.
/// One variable may stand behind several arguments, so that no reference to it is kept across a write.
#[repr(transparent)]
#[derive(Copy, Clone)]
pub(crate) struct Argument<T>(*mut T);

/// An INTEGER, or an array of them.
pub(crate) type Integer = Argument<c_int>;
/// A REAL, or an array of them.
pub(crate) type Real = Argument<f32>;
/// A CHARACTER string, or an array of them; its length comes at the end of the argument list.
pub(crate) type Character = Argument<u8>;

impl<T: Copy> Argument<T> {
    /// The value of a variable.
    #[inline]
    pub(crate) fn get(self) -> T {
        // SAFETY: the address of a variable.
        unsafe { self.0.read() }
    }

    /// Sets a variable.
    #[inline]
    pub(crate) fn set(self, value: T) {
        // SAFETY: the address of a variable that the subroutine defines.
        unsafe { self.0.write(value) }
    }

    /// The `count` elements of an array from the element `first` on, to be read before anything is set.
    pub(crate) fn slice<'a>(self, first: usize, count: usize) -> &'a [T] {
        if count == 0 || !Self::may_have(first, count) {
            return &[];
        }
        // SAFETY: an array of at least `first + count` elements, which nobody changes while it is read.
        unsafe { std::slice::from_raw_parts(self.0.add(first), count) }
    }

    /// The same to be changed, while no other argument is used.
    #[allow(clippy::mut_from_ref, reason = "an address may be copied; the array behind it is the caller's")]
    pub(crate) fn slice_mut<'a>(self, first: usize, count: usize) -> &'a mut [T] {
        if count == 0 || !Self::may_have(first, count) {
            return &mut [];
        }
        // SAFETY: an array of at least `first + count` elements, which nobody else uses meanwhile.
        unsafe { std::slice::from_raw_parts_mut(self.0.add(first), count) }
    }

    /// Whether there can be an array of `first + count` elements at all.
    fn may_have(first: usize, count: usize) -> bool {
        first.checked_add(count).is_some_and(|n| n <= isize::MAX as usize / size_of::<T>())
    }

    /// The array from the element `first` on.
    pub(crate) fn from(self, first: usize) -> Self {
        Argument(self.0.wrapping_add(first))
    }

    /// Sets elements of an array from the element `first` on, as many as there are values.
    pub(crate) fn set_from(self, first: usize, values: impl IntoIterator<Item = T>) {
        for (i, value) in values.into_iter().enumerate() {
            // SAFETY: an element of the array that the subroutine defines.
            unsafe { self.0.add(first + i).write(value) }
        }
    }

    /// Sets the first `count` elements of an array to one value.
    pub(crate) fn fill(self, count: usize, value: T) {
        self.set_from(0, std::iter::repeat_n(value, count));
    }
}

#[cfg(test)]
impl<T> Argument<T> {
    /// The argument that a variable or an array makes.
    pub(crate) fn of(target: &mut [T]) -> Self {
        Argument(target.as_mut_ptr())
    }
}

impl Integer {
    /// A number of elements; a negative one counts as none.
    pub(crate) fn count(self) -> usize {
        usize::try_from(self.get()).unwrap_or(0)
    }

    /// A value of an enumeration. Error: 2000.
    pub(crate) fn choice<E: Enumeration>(self, function: Function) -> gks::Result<E> {
        choice(self.get(), function)
    }
}

/// The value of an enumeration with a number. Error: 2000.
pub(crate) fn choice<E: Enumeration>(number: c_int, function: Function) -> gks::Result<E> {
    E::from_number(number).ok_or_else(|| Error::new(2000, function).because(format!("value {number}")))
}

impl Real {
    /// The value in double precision.
    #[inline]
    pub(crate) fn real(self) -> f64 {
        self.get().into()
    }
}

impl Character {
    /// Sets a string to text, filled up with blanks. Whether the text fits.
    pub(crate) fn set_text(self, length: usize, text: &[u8]) -> bool {
        let used = text.len().min(length);
        self.set_from(0, text[..used].iter().copied());
        self.set_from(used, std::iter::repeat_n(b' ', length - used));
        used == text.len()
    }
}

/// Numbers of the kernel as INTEGERs; what is too great becomes the greatest one.
pub(crate) fn integer(value: impl TryInto<c_int>) -> c_int {
    value.try_into().unwrap_or(c_int::MAX)
}

/// An enumeration of the standard, numbered as in Fortran.
pub(crate) trait Enumeration: Copy {
    /// The value with a number.
    fn from_number(number: c_int) -> Option<Self>;
    /// The number of the value.
    fn number(self) -> c_int;
}

impl Enumeration for bool {
    fn from_number(number: c_int) -> Option<Self> {
        match number {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }

    fn number(self) -> c_int {
        self.into()
    }
}

macro_rules! enumerations {
    ($($name:ty),+ $(,)?) => { $(
        impl Enumeration for $name {
            fn from_number(number: c_int) -> Option<Self> {
                <$name>::from_number(number)
            }

            fn number(self) -> c_int {
                self as c_int
            }
        }
    )+ };
}

enumerations! {
    Category, Classification, DeferralMode, DynamicModification, RegenerationMode,
    Horizontal, InteriorStyle, Precision, TextPath, Vertical, ValueType,
    Visibility, Highlighting, Detectability,
}

macro_rules! pairs {
    ($($name:ident { $first:ident, $second:ident })+) => { $(
        impl Enumeration for $name {
            fn from_number(number: c_int) -> Option<Self> {
                [$name::$first, $name::$second].into_iter().find(|&value| value as c_int == number)
            }

            fn number(self) -> c_int {
                self as c_int
            }
        }
    )+ };
}

pairs! {
    RelativePriority { Higher, Lower }
    CoordinateSwitch { Wc, Ndc }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_filled_up_with_blanks_or_cut() {
        let mut string = *b"xxxxxx";
        assert!(Character::of(&mut string).set_text(5, b"abc"));
        assert_eq!(string, *b"abc  x");
        assert!(!Character::of(&mut string).set_text(2, b"def"));
        assert_eq!(string, *b"dec  x");
    }

    #[test]
    fn arrays_that_cannot_be_are_empty() {
        let mut array = [1, 2, 3];
        let argument = Integer::of(&mut array);
        assert_eq!(argument.slice(1, 2), [2, 3]);
        assert_eq!(argument.slice(0, usize::MAX / 4), [0; 0]);
        assert_eq!(argument.slice(usize::MAX, 2), [0; 0]);
        assert_eq!([-1, 0, 7].map(|n| Integer::of(&mut [n]).count()), [0, 0, 7]);
    }

    #[test]
    fn enumerations_are_numbered_as_in_fortran() {
        const F: Function = Function::SetTextPath;
        assert_eq!(choice::<TextPath>(3, F), Ok(TextPath::Down));
        assert_eq!(choice::<RelativePriority>(1, F), Ok(RelativePriority::Lower));
        assert_eq!(choice::<bool>(1, F), Ok(true));
        let error = choice::<CoordinateSwitch>(2, F).expect_err("there are two");
        assert_eq!((error.number, error.function), (2000, F));
    }
}
