//! GKS, the Graphical Kernel System (ISO 7942).

pub mod generated;
