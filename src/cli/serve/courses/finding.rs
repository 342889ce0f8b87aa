//! Findings of a check.

/// The finding of a check.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Finding {
    /// All is well: what.
    Fine(String),
    /// Something to know.
    Note(String),
    /// Something is wrong.
    Wrong {
        /// The subject of the finding.
        what: String,
        /// The way out.
        help: String,
    },
}

impl Finding {
    pub(super) fn fine(what: impl Into<String>) -> Self {
        Self::Fine(what.into())
    }

    pub(super) fn wrong(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Wrong { what: what.into(), help: help.into() }
    }

    /// Whether it keeps the server from working as it should.
    pub(super) fn is_wrong(&self) -> bool {
        matches!(self, Self::Wrong { .. })
    }
}
