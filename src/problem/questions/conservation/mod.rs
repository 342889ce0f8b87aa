//! What is conserved in a stage, and the mistake behind a wrong answer.

pub(in crate::problem) mod balance;
pub(in crate::problem) mod conserved;
pub(in crate::problem) mod lasting;
pub(in crate::problem) mod misjudged;
pub(in crate::problem) mod sudden;
pub(in crate::problem) mod verdict;
