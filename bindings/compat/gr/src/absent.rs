//! What GR has and this library does not: functions that programs may call and that have no effect.
//!
//! Selections and bounding boxes serve GR's own editor, partial drawing its event loop, the functions `gks_ft_*` its
//! text in three dimensions; shadows and transformations of all coordinates have no counterpart in the standard.

use crate::argument::Address;
use std::ffi::{CStr, c_char, c_int, c_void};

unsafe extern "C" {
    fn malloc(size: usize) -> *mut c_void;
    fn realloc(address: *mut c_void, size: usize) -> *mut c_void;
    fn free(address: *mut c_void);
    fn strdup(text: *const c_char) -> *mut c_char;
    fn getenv(name: *const c_char) -> *mut c_char;
}

/// Functions without effect and result.
macro_rules! no_effect {
    ($($name:ident($($argument:ident: $type:ty),*);)+) => { $(
        /// Has no effect.
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name($($argument: $type),*) {
            $( let _ = $argument; )*
        }
    )+ };
}

no_effect! {
    gks_configure_ws(ws_id: c_int);
    gks_set_shadow(x: f64, y: f64, blur: f64);
    gks_set_coord_xform(matrix: *const f64);
    gks_begin_selection(index: c_int, kind: c_int);
    gks_end_selection();
    gks_move_selection(x: f64, y: f64);
    gks_resize_selection(kind: c_int, x: f64, y: f64);
    gks_set_bbox_callback(id: c_int, boxes: *const c_void, masks: *const c_void);
    gks_cancel_bbox_callback();
    gks_begin_partial(id: c_int, image: *const c_void);
    gks_end_partial(id: c_int);
    gks_set_background(xmin: f64, xmax: f64, ymin: f64, ymax: f64);
    gks_clear_background();
    gks_set_callback(callback: *const c_void);
    gks_ft_text3d(x: f64, y: f64, z: f64, text: *const c_char, axis: c_int, state: *const c_void);
    gks_ft_set_bearing_x_direction(direction: c_int);
    gks_escape(
        id: c_int, length: c_int, input: *const c_int, room: c_int, used: *const c_int, output: *const c_int
    );
}

/// Inquires the box of a selection, which is empty.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_bbox(
    error: Address<c_int>,
    xmin: Address<f64>,
    xmax: Address<f64>,
    ymin: Address<f64>,
    ymax: Address<f64>,
) {
    error.set(0);
    [xmin, xmax, ymin, ymax].into_iter().for_each(|limit| limit.set(0.0));
}

/// Loads a font, which fails.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_ft_load_user_font(_name: *const c_char, _ignore_errors: c_int) -> c_int {
    -1
}

/// Gives the direction of bearings of text in three dimensions.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_ft_inq_bearing_x_direction(direction: Address<c_int>) {
    direction.set(1);
}

/// Gives the extent of text in three dimensions, which is nothing.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_ft_inq_text3d_extent(
    _x: f64,
    _y: f64,
    _z: f64,
    _text: *const c_char,
    _axis: c_int,
    _state: *const c_void,
    corners_x: Address<f64>,
    corners_y: Address<f64>,
) {
    corners_x.set_all([0.0; 4]);
    corners_y.set_all([0.0; 4]);
}

/// Gives the distances of a pair of letters, which are none.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_ft_get_kerning() -> c_int {
    0
}

/// Gives the sizes of a letter, which are none.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_ft_get_metrics() -> c_int {
    0
}

/// Gives where a pointer is: nowhere, and no button is pressed.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_sample_locator(
    _ws_id: c_int,
    error: Address<c_int>,
    x: Address<f64>,
    y: Address<f64>,
    buttons: Address<c_int>,
) {
    error.set(0);
    x.set(0.0);
    y.set(0.0);
    buttons.set(0);
}

/// Gives the least difference of coordinates that is drawn.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_precision() -> f64 {
    f64::EPSILON
}

/// Gives the size up to which text is drawn from pictures of letters: any.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_text_maxsize() -> c_int {
    c_int::MAX
}

/// Gives the height of text on a workstation, which is the one set.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_ws_text_height(text_height: f64, _height: f64) -> f64 {
    text_height
}

/// Memory for what GR takes for its state.
#[repr(C, align(16))]
struct Block([u8; 16384]);

/// Gives the address of GR's state, which programs only hand back: memory of zeros.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_state() -> *const c_void {
    static STATE: Block = Block([0; 16384]);
    std::ptr::from_ref(&STATE.0).cast()
}

/// Allocates memory, filled with zeros.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_malloc(size: c_int) -> *mut c_void {
    let size = usize::try_from(size).unwrap_or(0);
    // SAFETY: any size may be asked for.
    let address = unsafe { malloc(size) };
    if !address.is_null() {
        // SAFETY: memory of this size.
        unsafe { address.cast::<u8>().write_bytes(0, size) }
    }
    address
}

/// Changes the size of allocated memory.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_realloc(address: *mut c_void, size: c_int) -> *mut c_void {
    // SAFETY: the contract of the crate; a null pointer is allowed.
    unsafe { realloc(address, usize::try_from(size).unwrap_or(0)) }
}

/// Frees memory.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_free(address: *mut c_void) {
    // SAFETY: the contract of the crate; a null pointer is allowed.
    unsafe { free(address) }
}

/// Copies text into memory of its own.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_strdup(text: *const c_char) -> *mut c_char {
    if text.is_null() {
        return std::ptr::null_mut();
    }
    // SAFETY: the contract of the crate.
    unsafe { strdup(text) }
}

/// Gives the value of a variable of the environment; a null pointer where it is not set.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_getenv(name: *const c_char) -> *mut c_char {
    if name.is_null() {
        return std::ptr::null_mut();
    }
    // SAFETY: the contract of the crate.
    unsafe { getenv(name) }
}

/// Writes a message to the standard error output. Its placeholders are left as they are.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_perror(format: *const c_char) {
    if !format.is_null() {
        // SAFETY: the contract of the crate.
        eprintln!("GKS: {}", unsafe { CStr::from_ptr(format) }.to_string_lossy());
    }
}
