//! The place of each feature of an item in each target.

use super::feature::Feature;
use super::feature::Place;
use super::target::TARGETS;

use Place::{Instead, LeftOut, Whole};

/// A feature in words, then for each target what stands for it.
pub type Row = (Feature, &'static str, [Place; TARGETS.len()]);

const WINDOW: Place =
    Whole("the smallest and the largest value of what is right, of each slip and of each usual mistake");
const NOT_TYPED: Place = Instead("printed behind the field, not typed");
const COMPONENTS: Place = Instead("a field for each component, marked by itself");
const ROOTS: Place = Instead("a field for each, from the smallest as the fields say, marked by itself");
const ENDS: Place = Instead("a field for each end; whether the end belongs to it is not asked");
const CHOICE: Place = Instead("a choice among the right one and those of usual mistakes");
const PICTURES: Place = Instead("the pictures below the statement, a choice among their names");
const LEFT_OUT: Place = LeftOut("");
const ALONE: Place = LeftOut("each answer is marked by itself");
const FEEDBACK: Place = Whole("feedback of its own");
const EXACT: Place = Whole("their share of the points");

/// Every feature.
pub const FEATURES: [Row; 17] = [
    (
        Feature::Numbers,
        "numbers and their tolerance",
        [
            Whole("a value and a tolerance for what is right, for each slip and for each usual mistake"),
            WINDOW,
            WINDOW,
            Whole("the smallest and the largest value of what earns full marks"),
            WINDOW,
            Whole(
                "the smallest and the largest value of what is right, of each slip and of each usual mistake, compared in server.py",
            ),
            Instead("the right value as it is printed, and one tolerance"),
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
            LeftOut("Canvas would give full marks for them"),
            Whole("an alternative answer with its feedback"),
            FEEDBACK,
            LEFT_OUT,
        ],
    ),
    (
        Feature::PowersOfTen,
        "that only the power of ten is wrong, in a question of several fields",
        [Instead("marked wrong, without a word"), FEEDBACK, FEEDBACK, LEFT_OUT, FEEDBACK, FEEDBACK, LEFT_OUT],
    ),
    (
        Feature::Credit,
        "points for slips",
        [
            Instead("the nearest fraction that Moodle knows, in questions of one field"),
            EXACT,
            EXACT,
            LeftOut("a slip earns nothing"),
            EXACT,
            EXACT,
            LeftOut("a slip earns nothing"),
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
            Instead("the kind schoice, alone or within cloze, without feedback"),
        ],
    ),
    (Feature::Pictures, "choices between pictures", [PICTURES; 7]),
    (Feature::Vectors, "vectors", [COMPONENTS; 7]),
    (Feature::Roots, "several values of one quantity", [ROOTS; 7]),
    (Feature::Intervals, "intervals", [ENDS; 7]),
    (Feature::Formulas, "formulas", [CHOICE; 7]),
    (Feature::LoneFormulas, "formulas without a usual mistake", [LEFT_OUT; 7]),
    (
        Feature::FollowThrough,
        "marks for what follows from a wrong answer before it",
        [ALONE, ALONE, ALONE, LeftOut("each field is a question of its own, with other numbers"), ALONE, ALONE, ALONE],
    ),
    (Feature::Writing, "marks for significant figures and words of direction", [LEFT_OUT; 7]),
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
