//! The binary encoding (ISO/IEC 8632-3).

pub mod decoder;
pub mod encoder;
pub mod octets;
pub mod parameters;
pub mod precision;
mod tile;
