//! The Computer Graphics Metafile (ISO/IEC 8632) in its three encodings.

pub mod binary;
pub mod character;
pub mod coding;
pub mod decoder;
pub mod element;
pub mod encoder;
pub mod fonts;
pub mod interpreter;
pub mod ncgm;
pub mod parameter;
pub mod recorder;
pub mod text;
