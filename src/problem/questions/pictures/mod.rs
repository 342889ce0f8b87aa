//! Pictures to choose from: diagrams of an impact, and graphs against time.

pub(crate) mod curve;
pub(crate) mod diagram;
pub(crate) mod graph;
pub(crate) mod graph_mistakes;
pub(crate) mod graph_read;
pub(crate) mod pictured;
pub(crate) mod pictured_read;
