//! The clear text encoding (ISO/IEC 8632-4).

pub mod decoder;
pub mod encoder;
mod token;
