//! Follow-through: a wrong answer that follows from an earlier wrong one.

use std::fmt;

use serde::Serialize;

/// From what a wrong answer follows.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Follows {
    /// The earlier parts whose answers, as the student gave them, lead to this one.
    pub from: Vec<String>,
    /// The laws that the answer satisfies with them.
    pub by: Vec<&'static str>,
    /// The impossibility in the earlier answers, as a clause: `cart A would pass through cart B`.
    pub unphysical: Option<String>,
}

/// The message to the student. It holds no value.
impl fmt::Display for Follows {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (from, by) = (self.from.join(" and "), self.by.join(" and "));
        write!(out, "This follows from your own {from} by {by}; the step itself is right.")?;
        match &self.unphysical {
            Some(reason) => write!(out, " But check your {from}: with it, {reason}."),
            None => write!(out, " Check {from}."),
        }
    }
}
