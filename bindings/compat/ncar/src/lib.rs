//! `libNGgks`: the bindings of ISO for C and Fortran in the place of the GKS of NCAR Graphics.
//!
//! The utilities of NCAR Graphics, its library HLU and its language NCL are linked with a GKS of this name. Here it is
//! the same library as `libgks`, but for the dialect, which is that of NCAR Graphics unless `GKS_DIALECT` says
//! otherwise: workstation types, initial values, escapes and messages. `symbols.txt` lists what its clients need.
#![allow(unsafe_code, reason = "the dialect is chosen when the library is loaded")]
#![allow(non_snake_case, reason = "the name of the library of NCAR Graphics")]

use gks_c as _;
use gks_instance::{Dialect, preset_dialect};

extern "C" fn load() {
    preset_dialect(Dialect::Ncar);
}

/// Called by the dynamic linker before anything else of this library.
#[used]
// SAFETY: a function that takes nothing is what the section holds addresses of.
#[cfg_attr(not(target_os = "macos"), unsafe(link_section = ".init_array"))]
#[cfg_attr(target_os = "macos", unsafe(link_section = "__DATA,__mod_init_func"))]
static LOAD: extern "C" fn() = load;
