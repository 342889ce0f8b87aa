//! Features of an item that not every target has a place for, and what can become of them.

/// Something that an item holds and not every target has a place for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Feature {
    /// Numbers, with how far they may be off.
    Numbers,
    /// Units, in a question of one field.
    Units,
    /// Units, in a question of several fields.
    UnitsOfSeveral,
    /// Usual mistakes and slips, with what is said of them.
    Mistakes,
    /// Only the power of ten is wrong, in a question of several fields.
    PowersOfTen,
    /// Points for slips.
    Credit,
    /// Choices.
    Choices,
    /// Choices between pictures.
    Pictures,
    /// Vectors.
    Vectors,
    /// Several values of one quantity.
    Roots,
    /// Intervals.
    Intervals,
    /// Formulas of which usual mistakes are known.
    Formulas,
    /// Formulas of which none is known.
    LoneFormulas,
    /// Marks for what follows from an answer before.
    FollowThrough,
    /// Marks for figures, and for how an answer is written.
    Writing,
    /// Hints.
    Hints,
    /// Figure, mathematics and worked solution.
    Documents,
}

/// The place of a feature in a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// All of it.
    Whole(&'static str),
    /// Something less.
    Instead(&'static str),
    /// Nothing, and what that means where it must be said.
    LeftOut(&'static str),
}
