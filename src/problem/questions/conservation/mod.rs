//! Questions of conservation in a stage, and the mistake behind a wrong answer.

pub(crate) mod balance;
pub(crate) mod conserved;
pub(crate) mod lasting;
pub(crate) mod misjudged;
pub(crate) mod sudden;
pub(crate) mod verdict;
