//! PHIGS, the Programmer's Hierarchical Interactive Graphics System (ISO 9592): a first slice.
//!
//! A [`Phigs`] keeps structures: lists of elements that draw, set attributes, transform, or execute other
//! structures. A structure that is posted to a workstation is traversed whenever the workstation is updated;
//! the primitives met on the way are taken through modelling transformation, view orientation and view
//! mapping to the waist that PHIGS shares with GKS, where normalized projection coordinates are GKS's
//! normalized device coordinates. Attributes, lowering and devices are the same from there on.
//!
//! What is here: structures with polylines, fill areas, colour and interior style elements, local modelling
//! transformations, execution of structures, view representations and posting. Everything else of the
//! standard is absent, not half present.

mod error;
mod phigs;
mod store;
mod transformation;
mod traversal;
mod view;

pub use error::{Error, Result};
pub use phigs::Phigs;
pub use store::{Composition, Element};
pub use transformation::{rotate_x, rotate_y, rotate_z, scale3, translate3};
pub use view::{Projection, ViewMapping, ViewRepresentation, view_mapping_matrix3, view_orientation_matrix3};
