//! Choices between phrases: what is offered, and what settles which is right.

pub(crate) mod choice;
pub(crate) mod claim;
pub(crate) mod comparing;
pub(crate) mod decision;
pub(crate) mod impact_kind;
pub(crate) mod impulsive;
pub(crate) mod judgement;
pub(crate) mod offered;
pub(crate) mod offered_read;
pub(crate) mod roots;
pub(crate) mod settled;
