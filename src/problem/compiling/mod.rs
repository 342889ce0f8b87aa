//! From a draft to a problem that can be drawn: symbols, plans, ways in which a scene can go, and what its texts tell.
mod graph_told;
mod idle;

pub(super) mod ad_hoc;
pub(super) mod any;
pub(super) mod compile;
mod consistent;
pub(super) mod form_cache;
pub(super) mod form_draft;
pub(super) mod input;
pub(super) mod inputs;
pub(super) mod lacking;
pub(super) mod on_demand;
pub(super) mod planned;
pub(super) mod regimes;
pub(super) mod told;
