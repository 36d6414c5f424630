//! What the tests share that look at the system from outside.

pub mod program;
