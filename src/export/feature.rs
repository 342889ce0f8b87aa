//! What an item holds, and what stands for it in each target.

/// The targets, in the order of the columns of [`FEATURES`].
pub const TARGETS: [&str; 1] = ["moodle"];

/// Something that an item holds and not every target has a place for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Feature {
    /// Numbers, with how far they may be off.
    Numbers,
    /// Units that are typed.
    Units,
    /// Units, in a question of several parts.
    UnitsOfSeveral,
    /// Usual mistakes and slips, with what is said of them.
    Mistakes,
    /// Points for slips.
    Credit,
    /// Choices.
    Choices,
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

/// A feature in words, then for each target what stands for it, and whether that is all of it.
pub type Row = (Feature, &'static str, [(&'static str, bool); TARGETS.len()]);

/// Every feature.
pub const FEATURES: [Row; 15] = [
    (Feature::Numbers, "numbers and their tolerance", [("a value and a tolerance for each window", true)]),
    (Feature::Units, "units", [("the unit asked and usual others; a wrong one costs what a missing one does", true)]),
    (
        Feature::UnitsOfSeveral,
        "units in a question of several fields",
        [("printed behind each field, not typed", false)],
    ),
    (Feature::Mistakes, "usual mistakes and slips", [("an answer of its own with its feedback", true)]),
    (Feature::Credit, "points for slips", [("the nearest fraction that Moodle knows", false)]),
    (Feature::Choices, "choices", [("multichoice", true)]),
    (Feature::Vectors, "vectors", [("a field for each component, marked by itself, without usual mistakes", false)]),
    (
        Feature::Roots,
        "several values of one quantity",
        [("a field for each, from the smallest, marked by itself, without usual mistakes", false)],
    ),
    (
        Feature::Intervals,
        "intervals",
        [("a field for each end; whether it belongs is not asked, and usual mistakes are not told", false)],
    ),
    (Feature::Formulas, "formulas", [("a choice among the right one and those of usual mistakes", false)]),
    (Feature::LoneFormulas, "formulas without a usual mistake", [("left out", false)]),
    (Feature::FollowThrough, "answers that follow from an earlier one", [("marked like any other", false)]),
    (Feature::Writing, "how an answer is written: figures, words of direction", [("not marked", false)]),
    (Feature::Hints, "hints", [("hints, in the interactive and adaptive behaviours", true)]),
    (Feature::Documents, "figure, mathematics, worked solution", [("attached SVG, MathML, general feedback", true)]),
];
