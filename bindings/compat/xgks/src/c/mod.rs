//! The binding to C of the draft of 1988, as XGKS has it.
//!
//! A function returns 0, or the number of its error; inquiries report nothing else. Any other error goes to
//! the error handling function `gerrorhand`, which a program may replace. Lists that inquiries return are
//! allocated with `malloc` and belong to the program.

mod argument;
mod attribute;
mod control;
mod description;
mod error;
mod fortran;
mod function;
mod input;
mod inquiry;
mod item;
mod metafile;
mod output;
mod representation;
mod segment;
mod transformation;
mod types;
