//! The command `gks`: demonstration pictures, the list of workstations, coverage of the standards, a
//! compiler driver for C and Fortran programs, and a way to run those that were built for another GKS.

pub mod bench;
pub mod binary;
pub mod commands;
pub mod demo;
pub mod generated;
pub mod libraries;
pub mod loading;
pub mod towers;
pub mod viewer;
