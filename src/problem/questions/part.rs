//! One part of a question, compiled: what is asked, how it is answered and judged.

use momentous_expr::Symbol;
use momentous_model::component_name;
use momentous_quantity::Tolerance;
use momentous_quantity::Unit;

use super::super::language::entries::Entries;
use super::choices::choice::ChoicePart;
use super::choices::claim::Claim;

/// One part of a question.
#[derive(Clone, Debug)]
pub struct Part {
    /// The name of the part in answers: the name that is asked, or `a`, `b`, ... for a question without one.
    pub id: String,
    /// The label of the part, as a noun phrase or a question.
    pub label: String,
    /// Its points.
    pub points: u32,
    /// The verdicts that marking must give on the sheet of seed 1: each answer with the code of one.
    pub expected: Entries<String>,
    /// How it is answered.
    pub kind: PartKind,
}

/// The letter of a part on its sheet, by its place: `a`, `b` and so on.
#[must_use]
pub fn part_letter(place: usize) -> String {
    ('a'..='z').cycle().nth(place).into_iter().collect()
}

/// How a part is answered.
#[derive(Clone, Debug)]
pub enum PartKind {
    /// By a number with a unit.
    Number(NumberPart),
    /// By a vector with a unit.
    Vector(VectorPart),
    /// By a formula in the symbols of what is given.
    Formula(FormulaPart),
    /// By an interval or a condition.
    Range(RangePart),
    /// By one of several phrases.
    Choice(ChoicePart),
}

/// A number that is asked.
#[derive(Clone, Debug)]
pub struct NumberPart {
    /// The quantity.
    pub symbol: Symbol,
    /// In which unit, or in terms of which quantity.
    pub unit: AskedUnit,
    /// The size of that unit, or of that of the multiple, in SI units; one, where there is none.
    pub size: f64,
    /// Significant figures of the printed answer.
    pub figures: usize,
    /// How far an answer may lie from the exact one.
    pub tolerance: Tolerance,
    /// Whether the answer is a whole number, found by counting.
    pub whole: bool,
    /// Whether every value is asked that the equations give, possible or not.
    pub every_root: bool,
}

/// The unit of an answer.
#[derive(Clone, Debug)]
pub enum AskedUnit {
    /// A unit.
    Unit(Unit),
    /// A quantity of the problem: the answer is a multiple of it. The unit is that of the multiple: none, where both measure the same.
    InTermsOf(Symbol, Unit),
}

/// A vector that is asked, by its components along the scene's axes.
#[derive(Clone, Debug)]
pub struct VectorPart {
    /// The components, in one unit and in the order of the axes.
    pub components: Vec<NumberPart>,
    /// The letters of the axes.
    pub axes: Vec<&'static str>,
}

/// A formula that is asked.
#[derive(Clone, Debug)]
pub struct FormulaPart {
    /// The quantity.
    pub symbol: Symbol,
    /// The quantity of which the answer is a multiple, where it is asked in terms of one.
    pub in_terms_of: Option<Symbol>,
}

/// The values of a quantity for which something holds are asked.
#[derive(Clone, Debug)]
pub struct RangePart {
    /// The quantity; the variant's value of it is the boundary, at which both sides of the claim are equal.
    pub number: NumberPart,
    /// The claim that is to hold.
    pub claim: Claim,
}

/// The label and the kind of a part.
pub(crate) type Question = (String, PartKind);

/// The name of a part in answers, its label and its kind.
pub(crate) type Named = (String, String, PartKind);

impl Part {
    /// The numbers in its answer, each with its name: one, the components of a vector, or none.
    pub fn numbers(&self) -> impl Iterator<Item = (String, &NumberPart)> {
        let names = match &self.kind {
            PartKind::Vector(vector) => vector.axes.iter().map(|axis| component_name(&self.id, axis)).collect(),
            _ => vec![self.id.clone()],
        };
        names.into_iter().zip(self.kind.numbers())
    }
}

impl PartKind {
    /// The numbers in the answer: one, the components of a vector, the boundary of an interval, or none.
    #[must_use]
    pub fn numbers(&self) -> &[NumberPart] {
        match self {
            Self::Number(number) => std::slice::from_ref(number),
            Self::Vector(vector) => &vector.components,
            Self::Range(range) => std::slice::from_ref(&range.number),
            Self::Formula(_) | Self::Choice(_) => &[],
        }
    }

    /// The quantities that have to be solved for it.
    #[must_use]
    pub fn wanted(&self) -> Vec<Symbol> {
        match self {
            Self::Number(_) | Self::Vector(_) | Self::Range(_) => {
                self.numbers().iter().map(|number| number.symbol).collect()
            }
            Self::Formula(formula) => vec![formula.symbol],
            Self::Choice(choice) => choice.symbols(),
        }
    }

    /// The quantity of which the answer is a multiple, where it has no unit of its own.
    #[must_use]
    pub fn in_terms_of(&self) -> Option<Symbol> {
        if let Self::Formula(formula) = self {
            return formula.in_terms_of;
        }
        self.numbers().iter().find_map(|number| match &number.unit {
            AskedUnit::InTermsOf(symbol, _) => Some(*symbol),
            AskedUnit::Unit(_) => None,
        })
    }
}

impl AskedUnit {
    /// The size in SI units of a unit; one, where there is none.
    pub(crate) fn size(&self) -> f64 {
        match self {
            Self::Unit(unit) | Self::InTermsOf(_, unit) => unit.factor().to_f64(),
        }
    }
}

impl VectorPart {
    /// The axes in words: `x and y`.
    #[must_use]
    pub fn axes_in_words(&self) -> String {
        match &self.axes[..] {
            [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
            axes => axes.join(", "),
        }
    }
}

impl NumberPart {
    /// The unit of the number: that of the multiple, where it is asked in terms of a quantity.
    #[must_use]
    pub fn plain_unit(&self) -> Unit {
        match &self.unit {
            AskedUnit::Unit(unit) | AskedUnit::InTermsOf(_, unit) => unit.clone(),
        }
    }
}
