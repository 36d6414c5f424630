//! Inquiries, by the state list or description table that they read.

mod description;
mod facilities;
mod pattern;
mod pixels;
mod representation;
mod state_list;
mod workstation;
