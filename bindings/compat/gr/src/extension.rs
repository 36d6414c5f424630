//! What GR has beyond the standard and keeps beside the state list: opacity, borders, the slant of text, nominal sizes,
//! what clips, and settings that have no effect here but are given back by inquiries.

use crate::argument::{Address, call};
use crate::resample::Methods;
use gks::{Function, Gks};
use gks_pipeline::look::ClipSector;
use gks_pipeline::tables::NominalSize;
use std::ffi::{c_int, c_uint};
use std::sync::{Mutex, PoisonError};

/// The interior style of areas that are filled and have a border.
pub(crate) const SOLID_WITH_BORDER: c_int = 4;

/// The clip region that is the ellipse in the clipping rectangle.
const ELLIPSE: c_int = 1;

/// The settings.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// The opacity of what is drawn from now on, from 0 to 1.
    pub(crate) opacity: f64,
    /// Whether the interior style is [`SOLID_WITH_BORDER`].
    pub(crate) bordered: bool,
    /// The colour index of borders.
    pub(crate) border_colour: c_int,
    /// The linewidth scale factor of borders.
    pub(crate) border_width: f64,
    /// By how many degrees characters lean to the right.
    pub(crate) slant: f64,
    clip_transformation: c_int,
    clip_region: c_int,
    clip_sector: (f64, f64),
    resample_method: c_uint,
    /// A factor for nominal sizes; 0 for those that all devices have.
    nominal_size: f64,
    encoding: c_int,
}

impl State {
    const INITIAL: State = State {
        opacity: 1.0,
        bordered: false,
        border_colour: 1,
        border_width: 1.0,
        slant: 0.0,
        clip_transformation: 0,
        clip_region: 0,
        clip_sector: (0.0, 360.0),
        resample_method: 0,
        nominal_size: 0.0,
        encoding: 301,
    };

    /// How images are resampled.
    pub(crate) fn resample_methods(&self) -> Methods {
        Methods(self.resample_method)
    }
}

static STATE: Mutex<State> = Mutex::new(State::INITIAL);

/// Runs `f` with the settings.
pub(crate) fn with<R>(f: impl FnOnce(&mut State) -> R) -> R {
    f(&mut STATE.lock().unwrap_or_else(PoisonError::into_inner))
}

/// Settings with a function that sets and one that inquires.
macro_rules! settings {
    ($($set:ident, $inquire:ident($type:ty) $member:ident: $what:literal;)+) => { $(
        #[doc = concat!("Sets ", $what, ".")]
        #[unsafe(no_mangle)]
        extern "C" fn $set(value: $type) {
            with(|state| state.$member = value);
        }

        #[doc = concat!("Inquires ", $what, ".")]
        #[unsafe(no_mangle)]
        extern "C" fn $inquire(error: Address<c_int>, value: Address<$type>) {
            error.set(0);
            value.set(with(|state| state.$member));
        }
    )+ };
}

settings! {
    gks_set_border_color_index, gks_inq_border_color_index(c_int) border_colour: "the colour index of borders";
    gks_set_border_width, gks_inq_border_width(f64) border_width: "the linewidth scale factor of borders";
    gks_set_text_slant, gks_inq_text_slant(f64) slant: "by how many degrees characters lean to the right";
}

/// Sets the opacity of what is drawn from now on, from 0 to 1.
#[unsafe(no_mangle)]
extern "C" fn gks_set_transparency(alpha: f64) {
    let alpha = if alpha.is_nan() { 1.0 } else { alpha.clamp(0.0, 1.0) };
    with(|state| state.opacity = alpha);
}

/// Inquires the opacity.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_transparency(error: Address<c_int>, alpha: Address<f64>) {
    error.set(0);
    alpha.set(with(|state| state.opacity));
}

/// Selects the normalization transformation whose viewport clips; 0 leaves it to the current one.
#[unsafe(no_mangle)]
extern "C" fn gks_select_clip_xform(number: c_int) {
    call(Function::Escape, |gks| {
        gks.select_clipping_transformation(number)?;
        with(|state| state.clip_transformation = number);
        Ok(())
    });
}

/// Inquires the normalization transformation whose viewport clips.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_clip_xform(error: Address<c_int>, number: Address<c_int>) {
    error.set(0);
    number.set(with(|state| state.clip_transformation));
}

/// Sets what clips: 0 the clipping rectangle, 1 the ellipse in it or a sector of that.
#[unsafe(no_mangle)]
extern "C" fn gks_set_clip_region(region: c_int) {
    call(Function::Escape, |gks| {
        with(|state| state.clip_region = region);
        set_clip_sector(gks)
    });
}

/// Inquires what clips.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_clip_region(error: Address<c_int>, region: Address<c_int>) {
    error.set(0);
    region.set(with(|state| state.clip_region));
}

/// Sets the sector of the ellipse that clips, in degrees.
#[unsafe(no_mangle)]
extern "C" fn gks_set_clip_sector(start: f64, end: f64) {
    call(Function::Escape, |gks| {
        with(|state| state.clip_sector = (start, end));
        set_clip_sector(gks)
    });
}

/// Tells the kernel what clips.
fn set_clip_sector(gks: &mut Gks) -> gks::Result<()> {
    let (region, (start, end)) = with(|state| (state.clip_region, state.clip_sector));
    gks.set_clip_sector((region == ELLIPSE).then_some(ClipSector { start, end }))
}

/// Tells a kernel that has been opened what clips.
pub(crate) fn set_clipping(gks: &mut Gks) -> gks::Result<()> {
    gks.select_clipping_transformation(with(|state| state.clip_transformation))?;
    set_clip_sector(gks)
}

/// Inquires the sector of the ellipse that clips.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_clip_sector(error: Address<c_int>, start: Address<f64>, end: Address<f64>) {
    error.set(0);
    let sector = with(|state| state.clip_sector);
    start.set(sector.0);
    end.set(sector.1);
}

/// Sets how images are resampled: methods for each axis and direction, 1 nearest, 2 linear, 3 Lanczos. 0 is the first, unless
/// the environment variable `GKS_DEFAULT_RESAMPLE_METHOD` says otherwise.
#[unsafe(no_mangle)]
extern "C" fn gks_set_resample_method(method: c_uint) {
    with(|state| state.resample_method = method);
}

/// Inquires how images are resampled.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_resample_method(method: Address<c_uint>) {
    method.set(with(|state| state.resample_method));
}

/// Sets a factor for the nominal linewidth and marker size of all workstations, those that are opened later too; 0 is none.
#[unsafe(no_mangle)]
extern "C" fn gks_set_nominal_size(factor: f64) {
    call(Function::Escape, |gks| {
        with(|state| state.nominal_size = factor);
        let open: Vec<c_int> = gks.inquire_set_of_open_workstations()?.collect();
        open.into_iter().try_for_each(|id| set_nominal_sizes(gks, id))
    });
}

/// Gives a workstation its nominal sizes, if it draws.
pub(crate) fn set_nominal_sizes(gks: &mut Gks, id: c_int) -> gks::Result<()> {
    let factor = with(|state| state.nominal_size);
    let factor = if factor > 0.0 { factor } else { 1.0 };
    for size in [NominalSize::Linewidth, NominalSize::MarkerSize] {
        match gks.set_nominal_size(id, size, factor) {
            // Metafile input, segment storage, input alone.
            Err(error) if matches!(error.number, 33 | 35 | 36) => {}
            done => done?,
        }
    }
    Ok(())
}

/// Inquires the factor of nominal sizes.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_nominal_size(factor: Address<f64>) {
    factor.set(with(|state| state.nominal_size));
}

/// Sets the encoding of text, which has no effect: it is UTF-8, or Latin-1 where it is not valid as that.
#[unsafe(no_mangle)]
extern "C" fn gks_set_encoding(encoding: c_int) {
    with(|state| state.encoding = encoding);
}

/// Inquires the encoding of text.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_encoding(encoding: Address<c_int>) {
    encoding.set(with(|state| state.encoding));
}
