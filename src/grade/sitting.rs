//! In which position a student is who hands in an answer.

/// The further remarks of marking, besides the verdict on a part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sitting {
    /// How many further hints the student has asked for on a wrong answer.
    pub hints: usize,
    /// Whether no attempts are left: what follows from the student's own answers is then shown.
    pub closed: bool,
}
