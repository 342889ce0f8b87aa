//! What an item holds, and what stands for it in each target.

use super::target::TARGETS;

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

/// What stands for a feature in a target, and whether that is all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// All of it.
    Whole(&'static str),
    /// Something less.
    Instead(&'static str),
}

use Place::{Instead, Whole};

/// A feature in words, then for each target what stands for it.
pub type Row = (Feature, &'static str, [Place; TARGETS.len()]);

const WINDOW: Place = Whole("two comparisons for each window");
const NOT_TYPED: Place = Instead("printed behind the field, not typed");
const COMPONENTS: Place = Instead("a field for each component, marked by itself");
const ROOTS: Place = Instead("a field for each, from the smallest, marked by itself");
const ENDS: Place = Instead("a field for each end; whether it belongs is not asked");
const CHOICE: Place = Instead("a choice among the right one and those of usual mistakes");
const LEFT_OUT: Place = Instead("left out");
const NOT_MARKED: Place = Instead("not marked");
const ALONE: Place = Instead("marked like any other");
const FEEDBACK: Place = Whole("feedback of its own");
const EXACT: Place = Whole("their share of the points");

/// Every feature.
pub const FEATURES: [Row; 15] = [
    (
        Feature::Numbers,
        "numbers and their tolerance",
        [
            Whole("a value and a tolerance for each window"),
            WINDOW,
            WINDOW,
            Whole("a range for each window that earns everything"),
            Whole("an interval for each window"),
            Whole("a window each, compared in server.py"),
            Instead("the middle of the right window, and a tolerance"),
        ],
    ),
    (
        Feature::Units,
        "units",
        [
            Whole("the unit asked and usual others; a wrong one costs what a missing one does"),
            NOT_TYPED,
            NOT_TYPED,
            NOT_TYPED,
            NOT_TYPED,
            NOT_TYPED,
            NOT_TYPED,
        ],
    ),
    (Feature::UnitsOfSeveral, "units in a question of several fields", [NOT_TYPED; 7]),
    (
        Feature::Mistakes,
        "usual mistakes and slips",
        [
            Whole("an answer of its own with its feedback"),
            FEEDBACK,
            FEEDBACK,
            Instead("left out: every answer to a numerical question would earn everything"),
            Whole("an alternative answer with its feedback"),
            FEEDBACK,
            LEFT_OUT,
        ],
    ),
    (
        Feature::Credit,
        "points for slips",
        [
            Instead("the nearest fraction that Moodle knows, in questions of one field"),
            EXACT,
            EXACT,
            Instead("nothing is earned"),
            EXACT,
            EXACT,
            Instead("nothing is earned"),
        ],
    ),
    (
        Feature::Choices,
        "choices",
        [
            Whole("multichoice"),
            Whole("a choice interaction"),
            Whole("a choice interaction"),
            Whole("a multiple choice question"),
            Whole("a part of the kind \"choose one\""),
            Whole("pl-multiple-choice"),
            Instead("schoice, without feedback"),
        ],
    ),
    (Feature::Vectors, "vectors", [COMPONENTS; 7]),
    (Feature::Roots, "several values of one quantity", [ROOTS; 7]),
    (Feature::Intervals, "intervals", [ENDS; 7]),
    (Feature::Formulas, "formulas", [CHOICE; 7]),
    (Feature::LoneFormulas, "formulas without a usual mistake", [LEFT_OUT; 7]),
    (
        Feature::FollowThrough,
        "answers that follow from an earlier one",
        [
            ALONE,
            ALONE,
            ALONE,
            Instead("a question of its own for each field, with numbers drawn for itself"),
            ALONE,
            ALONE,
            ALONE,
        ],
    ),
    (Feature::Writing, "how an answer is written: figures, words of direction", [NOT_MARKED; 7]),
    (
        Feature::Hints,
        "hints",
        [
            Whole("hints, in the interactive and adaptive behaviours"),
            LEFT_OUT,
            LEFT_OUT,
            LEFT_OUT,
            Whole("steps of the first part"),
            Instead("below the statement, to be opened; they cost nothing"),
            LEFT_OUT,
        ],
    ),
    (
        Feature::Documents,
        "figure, mathematics, worked solution",
        [
            Whole("attached SVG, TeX or MathML, general feedback"),
            Whole("SVG files, MathML, feedback after an attempt"),
            Whole("SVG files, MathML, feedback after an attempt"),
            Whole("SVG files, pictures of equations, general comment"),
            Whole("SVG, MathML, advice"),
            Whole("SVG files, TeX or MathML, answer panel"),
            Whole("SVG files, TeX, solution"),
        ],
    ),
];
