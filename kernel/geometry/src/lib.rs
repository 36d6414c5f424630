//! Points, rectangles and maps, every coordinate typed by the space it lives in.
//!
//! A GKS or PHIGS coordinate passes through several spaces on its way to a device:
//! modelling ([`Mc`]), world ([`Wc`]), view reference ([`Vrc`]), normalized device
//! ([`Ndc`], which PHIGS calls normalized projection, [`Npc`]) and device ([`Dc`]) coordinates.
//! The space is a type parameter, so a world coordinate cannot be handed to a device by mistake;
//! a [`Map`] is the only way from one space to another. All arithmetic is `f64` on [`glam`].
//!
//! Conventions: *y* points up in every space, angles are radians and positive anticlockwise.

mod extremes;
mod long_line;
mod map;
mod map3;
mod paths;
mod point;
mod point3;
mod points;
mod rect;
mod space;

pub use long_line::{LongLine, Piece, Pieces};
pub use map::Map;
pub use map3::Map3;
pub use paths::{PathBuf, Paths};
pub use point::{Point, Vector};
pub use point3::{Point3, Vector3};
pub use points::Points;
pub use rect::Rect;
pub use space::{Dc, Du, Mc, Ndc, Npc, Space, Vrc, Wc};
