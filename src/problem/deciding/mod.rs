//! The right answer to what is asked, for a variant.

pub(super) mod choice;
pub(super) mod claim;
pub(super) mod closeness;
pub(super) mod formula;
pub(super) mod interval;
pub(super) mod judgement;
pub(super) mod offered;
pub(super) mod pictured;
pub(super) mod roots;
