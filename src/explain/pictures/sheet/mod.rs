//! The figure of the problem sheet, by what happens first.

pub(super) mod carried;
pub(super) mod central;
pub(super) mod contact;
pub(super) mod fall;
pub(super) mod flight;
pub(super) mod given;
pub(super) mod line;
pub(super) mod pulley;
pub(super) mod ramp;
pub(super) mod revolution;
pub(super) mod ride;
pub(super) mod stream;
pub(super) mod strung;
pub(super) mod swing;
