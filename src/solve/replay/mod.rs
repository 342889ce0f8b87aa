//! A plan as a program: compiled to a tape, and replayed for one variant or many.

pub(super) mod backward;
pub(super) mod batch;
pub(super) mod bracketing;
pub(super) mod counting;
pub(super) mod outcome;
pub(super) mod program;
pub(super) mod roots;
mod ruled_out;
pub(super) mod sensitivity;
pub(super) mod symbol_registers;
pub(super) mod tape;
pub(super) mod tree;
pub(super) mod workspace;
pub(super) mod writer;
