//! Choices between phrases: what is offered, and what settles which is right.

pub(in crate::problem) mod choice;
pub(in crate::problem) mod claim;
pub(in crate::problem) mod comparing;
pub(in crate::problem) mod decision;
pub(in crate::problem) mod impact_kind;
pub(in crate::problem) mod impulsive;
pub(in crate::problem) mod judgement;
pub(in crate::problem) mod offered;
pub(in crate::problem) mod offered_read;
pub(in crate::problem) mod roots;
pub(in crate::problem) mod settled;
