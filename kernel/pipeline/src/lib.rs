//! What GKS and PHIGS share, from the item to the device.
//!
//! An [`item::Item`] is the waist: a primitive with its unresolved look in normalized device coordinates.
//! A [`workstation::Workstation`] resolves the look by its own tables, maps the item to its display surface,
//! clips it, and offers what remains to its [`device::Device`]; what the device refuses is taken apart
//! ([`lower`]) until it is drawn.

mod backend;
mod band;
pub mod colour;
pub mod description;
pub mod device;
pub mod font;
pub mod generalized;
pub mod generated;
pub mod input;
pub mod item;
pub mod look;
pub mod look_difference;
pub mod lower;
pub mod painter;
pub mod pick;
mod realized;
pub mod record;
pub mod recording;
pub mod segment;
pub mod tables;
pub mod trace;
pub mod workstation;
