//! The library `libgks`: the bindings of ISO for C and Fortran, shared and static.

// The functions of the bindings are exported by their own names.
use gks_c as _;
