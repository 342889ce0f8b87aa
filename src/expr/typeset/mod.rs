//! Terms typeset as a textbook prints them, and the writers of each format.

pub(super) mod arrangement;
pub(super) mod latex;
pub(super) mod layout;
pub(super) mod math;
pub(super) mod mathml;
pub(super) mod name;
pub(super) mod notation;
pub(super) mod plain;
pub(super) mod typst;
pub(super) mod width;
