//! Follow-through: a wrong answer that follows from an earlier wrong one.

use serde::Serialize;

/// From what a wrong answer follows.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Follows {
    /// The earlier parts whose answers, as the student gave them, lead to this one.
    pub from: Vec<String>,
    /// The laws that the answer satisfies with them.
    pub by: Vec<&'static str>,
    /// What is impossible about the earlier answers, as a clause: `cart A would pass through cart B`.
    pub unphysical: Option<String>,
}
