//! The command `gks`: demonstration pictures, the list of workstations, coverage of the standards, and a
//! compiler driver for C and Fortran programs.

pub mod commands;
pub mod demo;
pub mod generated;
pub mod towers;
