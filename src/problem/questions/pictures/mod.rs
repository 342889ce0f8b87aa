//! Pictures to choose from: diagrams of an impact, and graphs against time.

pub(in crate::problem) mod curve;
pub(in crate::problem) mod diagram;
pub(in crate::problem) mod graph;
pub(in crate::problem) mod graph_mistakes;
pub(in crate::problem) mod graph_read;
pub(in crate::problem) mod pictured;
pub(in crate::problem) mod pictured_read;
