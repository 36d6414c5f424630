//! The answers of inquiries: an error indicator, and values in the variables of the program.

use crate::argument::{Argument, Enumeration, Integer, Real, integer};
use crate::call::check_state;
use gks::{Function, Gks};
use gks_geometry::{Point, Rect, Space, Vector};
use std::ffi::c_int;

/// The error of an array or a string that is too small.
pub(crate) const TOO_SMALL: c_int = 2001;
/// The error of an element of a list that is not there.
const NO_SUCH_ELEMENT: c_int = 2002;

/// Variables that take the value of an inquiry.
pub(crate) trait Output<V>: Clear {
    /// Sets the variables. Returns the error indicator: 0, or that a part of the value is not there or does
    /// not fit.
    fn put(self, value: V) -> c_int;
}

/// Variables that are set to zero when there is no value.
pub(crate) trait Clear: Copy {
    /// Sets the variables to zero.
    fn clear(self);
}

/// Answers an inquiry. Operating states are checked before arguments.
#[inline]
pub(crate) fn answer<V, O: Output<V>>(
    function: Function,
    errind: Integer,
    outputs: O,
    ask: impl FnOnce(&mut Gks) -> gks::Result<V>,
) {
    let asked = gks_instance::inquire(function, |gks| {
        check_state(gks, function)?;
        ask(gks)
    });
    errind.set(match asked {
        Ok(value) => outputs.put(value),
        Err(number) => {
            outputs.clear();
            number
        }
    });
}

/// An array of a fixed number of elements.
#[repr(transparent)]
#[derive(Copy, Clone)]
pub(crate) struct Array<T, const N: usize>(Argument<T>);

/// An element of a list that a program asks for by its number.
pub(crate) struct Element<T> {
    count: c_int,
    item: Option<T>,
    indicator: c_int,
}

/// Element `n` of a list, counted from 1, and the length of the list; 0 asks for the length alone.
pub(crate) fn element<T>(list: impl IntoIterator<Item = T>, n: Integer) -> Element<T> {
    let n = n.get();
    let mut count = 0;
    let mut item = None;
    for element in list {
        count += 1;
        if count == n {
            item = Some(element);
        }
    }
    let indicator = if n == 0 || item.is_some() { 0 } else { NO_SUCH_ELEMENT };
    Element { count, item, indicator }
}

impl<T, O: Output<T>> Output<Element<T>> for (Integer, O) {
    fn put(self, value: Element<T>) -> c_int {
        self.0.set(value.count);
        match value.item {
            Some(item) => self.1.put(item),
            None => {
                self.1.clear();
                value.indicator
            }
        }
    }
}

impl<T: Copy + Default> Clear for Argument<T> {
    #[inline]
    fn clear(self) {
        self.set(T::default());
    }
}

impl<T: Copy + Default, const N: usize> Clear for Array<T, N> {
    fn clear(self) {
        self.0.fill(N, T::default());
    }
}

macro_rules! numbers {
    ($($from:ty => $argument:ty, |$value:ident| $converted:expr;)+) => { $(
        impl Output<$from> for $argument {
            #[inline]
            fn put(self, $value: $from) -> c_int {
                self.set($converted);
                0
            }
        }
    )+ };
}

numbers! {
    c_int => Integer, |value| value;
    u32 => Integer, |value| integer(value);
    usize => Integer, |value| integer(value);
    f32 => Real, |value| value;
    f64 => Real, |value| value as f32;
}

impl<E: Enumeration> Output<E> for Integer {
    #[inline]
    fn put(self, value: E) -> c_int {
        self.set(value.number());
        0
    }
}

impl<S: Space> Output<Point<S>> for (Real, Real) {
    fn put(self, value: Point<S>) -> c_int {
        self.put((value.x(), value.y()))
    }
}

impl<S: Space> Output<Vector<S>> for (Real, Real) {
    fn put(self, value: Vector<S>) -> c_int {
        self.put((value.x(), value.y()))
    }
}

impl<S: Space> Output<Rect<S>> for Array<f32, 4> {
    #[inline]
    fn put(self, value: Rect<S>) -> c_int {
        self.0.set_from(0, value.limits().map(|limit| limit as f32));
        0
    }
}

impl<const N: usize> Output<[bool; N]> for Array<c_int, N> {
    fn put(self, value: [bool; N]) -> c_int {
        self.0.set_from(0, value.map(c_int::from));
        0
    }
}

/// The rows of a matrix, as an array M(2,3), whose columns follow one another.
impl Output<[[f64; 3]; 2]> for Array<f32, 6> {
    fn put(self, [first, second]: [[f64; 3]; 2]) -> c_int {
        self.0.set_from(0, first.into_iter().zip(second).flat_map(|(a, b)| [a as f32, b as f32]));
        0
    }
}

/// Abscissae and ordinates apart.
impl<S: Space, const N: usize> Output<[Point<S>; N]> for (Array<f32, N>, Array<f32, N>) {
    fn put(self, value: [Point<S>; N]) -> c_int {
        self.0.0.set_from(0, value.map(|p| p.x() as f32));
        self.1.0.set_from(0, value.map(|p| p.y() as f32));
        0
    }
}

/// A list of which the array holds the beginning, and its length.
impl<const N: usize> Output<Vec<c_int>> for (Integer, Array<c_int, N>) {
    fn put(self, value: Vec<c_int>) -> c_int {
        self.1.clear();
        self.0.set(integer(value.len()));
        let fits = value.len() <= N;
        self.1.0.set_from(0, value.into_iter().take(N));
        if fits { 0 } else { TOO_SMALL }
    }
}

macro_rules! tuples {
    ($(($($output:ident $value:ident $place:tt),+))+) => { $(
        impl<$($output: Clear),+> Clear for ($($output,)+) {
            fn clear(self) {
                $(self.$place.clear();)+
            }
        }

        impl<$($value, $output: Output<$value>),+> Output<($($value,)+)> for ($($output,)+) {
            #[inline]
            fn put(self, value: ($($value,)+)) -> c_int {
                [$(self.$place.put(value.$place)),+].into_iter().max().unwrap_or(0)
            }
        }
    )+ };
}

tuples! {
    (A U 0, B V 1)
    (A U 0, B V 1, C W 2)
    (A U 0, B V 1, C W 2, D X 3)
    (A U 0, B V 1, C W 2, D X 3, E Y 4)
    (A U 0, B V 1, C W 2, D X 3, E Y 4, F Z 5)
    (A U 0, B V 1, C W 2, D X 3, E Y 4, F Z 5, G T 6)
}

/// Defines inquiries: other arguments, variables for the values, function, and what is asked of the kernel.
/// ERRIND stands between the arguments and the variables. In the question, `F` is the function.
macro_rules! inquiries {
    ($($name:ident($($argument:ident: $type:ty),*) -> ($($output:ident: $kind:ty),+)
        $function:ident => $ask:expr;)+) => { $(
        #[unsafe(no_mangle)]
        extern "C" fn $name($($argument: $type,)* errind: $crate::argument::Integer, $($output: $kind),+) {
            const F: gks::Function = gks::Function::$function;
            $crate::answer::answer(F, errind, ($($output),+), $ask);
        }
    )+ };
}
pub(crate) use inquiries;

/// Defines inquiries of an element of a list: other arguments, function, and the list. The number of the
/// element follows the other arguments, ERRIND, the length of the list and the element come last.
macro_rules! lists {
    ($($name:ident($($argument:ident: $type:ty),*) $function:ident => |$gks:ident| $list:expr;)+) => { $(
        #[unsafe(no_mangle)]
        extern "C" fn $name(
            $($argument: $type,)*
            n: $crate::argument::Integer,
            errind: $crate::argument::Integer,
            count: $crate::argument::Integer,
            item: $crate::argument::Integer,
        ) {
            $crate::answer::answer(gks::Function::$function, errind, (count, item), |$gks: &mut gks::Gks| {
                Ok($crate::answer::element($list?, n))
            });
        }
    )+ };
}
pub(crate) use lists;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_counted_from_1_and_0_asks_for_the_length() {
        let ask = |n: c_int| {
            let (mut count, mut item) = ([-9], [-9]);
            let outputs = (Integer::of(&mut count), Integer::of(&mut item));
            let indicator = outputs.put(element([10, 20], Integer::of(&mut [n])));
            (indicator, count[0], item[0])
        };
        assert_eq!(ask(0), (0, 2, 0));
        assert_eq!(ask(1), (0, 2, 10));
        assert_eq!(ask(2), (0, 2, 20));
        assert_eq!([3, -1].map(ask), [(NO_SUCH_ELEMENT, 2, 0); 2]);
    }

    #[test]
    fn errors_set_everything_to_zero() {
        let (mut errind, mut ctnr) = ([-9], [-9]);
        let function = Function::InquireCurrentNormalizationTransformationNumber;
        answer(function, Integer::of(&mut errind), Integer::of(&mut ctnr), |gks| {
            gks.inquire_current_normalization_transformation_number()
        });
        assert_eq!((errind, ctnr), ([8], [0]));
    }

    #[test]
    fn lists_longer_than_their_array_are_cut() {
        let (mut count, mut array) = ([0], [0; 3]);
        let outputs = (Integer::of(&mut count), Array::<_, 3>(Integer::of(&mut array)));
        assert_eq!(outputs.put(vec![1, 2]), 0);
        assert_eq!((count, array), ([2], [1, 2, 0]));
        let outputs = (Integer::of(&mut count), Array::<_, 3>(Integer::of(&mut array)));
        assert_eq!(outputs.put(vec![5, 6, 7, 8]), TOO_SMALL);
        assert_eq!((count, array), ([4], [5, 6, 7]));
    }
}
