//! Plots of commands, of points along one or two axes: one page of panels, written as SVG, or as PNG through it.

mod axis;
mod marks;
mod page;
mod panel;
mod picture;
mod table;

pub(super) use axis::Axis;
pub(super) use marks::Mark;
pub(super) use page::{Page, Theme};
pub(super) use panel::{Curve, Panel, Spot};
pub(super) use picture::png;
pub(super) use table::Table;

/// Text for XML.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
