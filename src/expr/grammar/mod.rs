//! Terms as text: how they are read and written.

pub(super) mod parse;
pub(super) mod parse_fault;
pub(super) mod text;
pub(super) mod token;
