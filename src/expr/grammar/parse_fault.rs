//! Why a text is not a term, and which part of it is to blame.

/// Why a text is not a term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseFault {
    /// The first byte of what was not understood.
    pub start: usize,
    /// The byte after the last.
    pub end: usize,
    /// The fault, in a sentence without a full stop.
    pub message: String,
    /// The way out.
    pub help: Option<String>,
}
