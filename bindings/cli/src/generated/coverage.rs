//! How many functions of the standards are there, in each language.
//!
//! Written by `gks-spec generate` from the tables in `spec` and the names that the sources define; do not edit.

use serde::Serialize;

/// The functions whose lowest level is a level of a standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Coverage {
    /// The standard.
    pub standard: &'static str,
    /// The level.
    pub level: &'static str,
    /// The number of functions.
    pub functions: usize,
    /// How many of them Rust has.
    pub rust: usize,
    /// How many of them C has.
    pub c: usize,
    /// How many of them Fortran has.
    pub fortran: usize,
    /// What a language has no name for, as "language: function"; it counts as there.
    pub na: &'static [&'static str],
}

/// The coverage of each level.
pub const COVERAGE: &[Coverage] = &[
    Coverage {
        standard: "gks",
        level: "0a",
        functions: 124,
        rust: 124,
        c: 124,
        fortran: 124,
        na: &[
            "rust: ERROR HANDLING",
            "rust: ERROR LOGGING",
            "rust: PACK DATA RECORD",
            "rust: UNPACK DATA RECORD",
            "rust: CREATE STORE",
            "rust: DELETE STORE",
            "rust: SET ERROR HANDLER",
            "c: PACK DATA RECORD",
            "c: UNPACK DATA RECORD",
            "fortran: CREATE STORE",
            "fortran: DELETE STORE",
            "fortran: SET ERROR HANDLER",
        ],
    },
    Coverage {
        standard: "gks",
        level: "0b",
        functions: 27,
        rust: 27,
        c: 27,
        fortran: 27,
        na: &[],
    },
    Coverage {
        standard: "gks",
        level: "0c",
        functions: 14,
        rust: 14,
        c: 14,
        fortran: 14,
        na: &[],
    },
    Coverage {
        standard: "gks",
        level: "1a",
        functions: 40,
        rust: 40,
        c: 40,
        fortran: 40,
        na: &[],
    },
    Coverage {
        standard: "gks",
        level: "1b",
        functions: 8,
        rust: 8,
        c: 8,
        fortran: 8,
        na: &[],
    },
    Coverage {
        standard: "gks",
        level: "1c",
        functions: 2,
        rust: 2,
        c: 2,
        fortran: 2,
        na: &[],
    },
    Coverage {
        standard: "gks",
        level: "2a",
        functions: 3,
        rust: 3,
        c: 3,
        fortran: 3,
        na: &[],
    },
    Coverage {
        standard: "gks",
        level: "2b",
        functions: 0,
        rust: 0,
        c: 0,
        fortran: 0,
        na: &[],
    },
    Coverage {
        standard: "gks",
        level: "2c",
        functions: 0,
        rust: 0,
        c: 0,
        fortran: 0,
        na: &[],
    },
];
