//! Terms as text: how they are read and written.

pub(super) mod parse;
pub(super) mod text;
pub(super) mod token;
