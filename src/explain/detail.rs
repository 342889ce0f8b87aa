//! How much a worked solution says.

/// How much a worked solution says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// The detail of a textbook: the system, the laws with their reasons, numbers as soon as no symbol is asked, the answers.
    #[default]
    Short,
    /// Besides that what acts and what is neglected, the algebra in symbols, every check.
    Full,
}
