//! What is asked, compiled: each kind of question, and how its right answer is settled.

pub(super) mod comparing;
pub(super) mod concept;
pub(super) mod conserved;
pub(super) mod counted;
pub(super) mod curve;
pub(super) mod decision;
pub(super) mod diagram;
pub(super) mod enough;
pub(super) mod equality;
pub(super) mod formula;
pub(super) mod graph;
pub(super) mod graph_mistakes;
pub(super) mod graph_read;
pub(super) mod impact_kind;
pub(super) mod judgement;
pub(super) mod lasting;
pub(super) mod offered;
pub(super) mod offered_read;
pub(super) mod part;
pub(super) mod parts;
pub(super) mod pictured;
pub(super) mod pictured_read;
pub(super) mod range;
pub(super) mod roots;
pub(super) mod sudden;
pub(super) mod vector;
