//! Questions with several phrases to choose from, and which of them is right: settled by the scene, or by a variant's numbers.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::laws::wrong::Misconception;
use crate::quantity::coherent_unit;
use crate::solve::Bounded;
use crate::solve::Real;
use crate::solve::Relation;
use crate::solve::evaluate;

use super::super::sampling::variant::Worked;
use super::equality::in_unit;
use super::judgement::Judgement;
use super::offered::Offer;
use super::pictured::Pictured;

/// A choice between phrases.
#[derive(Clone, Debug)]
pub enum ChoicePart {
    /// The scene settles it, whatever the numbers.
    Settled(Decision),
    /// Whether quantities are equal settles it: what is conserved, and of which kind an impact is.
    Judged(Box<Judgement>),
    /// Whether something holds of the numbers: yes or no.
    Holds(Claim),
    /// In which order some quantities are, the least first.
    Order(Vec<Symbol>),
    /// Which of the roots for a quantity is possible.
    Physical(Symbol),
    /// Which of the author's own options is right.
    Offered(Box<Offer>),
    /// Which of several pictures is right.
    Pictured(Box<Pictured>),
}

/// The phrases of a choice, and the right one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decision {
    /// The phrases, in the order in which they are offered.
    pub options: Vec<String>,
    /// The position of the right one.
    pub right: usize,
    /// Why it is right, as a sentence without a full stop.
    pub because: String,
    /// The common mistake that leads to another phrase, where there is one.
    pub behind: Option<&'static Misconception>,
    /// What there is to say to a student who chose an option wrongly, in the order of the options.
    pub feedback: Vec<OptionFeedback>,
}

/// What there is to say of an option that is wrong.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum OptionFeedback {
    /// Nothing but what is said of the question.
    #[default]
    Nothing,
    /// The author's own words.
    Own(String),
    /// What the mistake that leads to it says.
    Mistake(&'static Misconception),
}

/// A claim about the numbers of a variant.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The left side.
    pub left: Expr,
    /// How the sides are said to compare.
    pub relation: Relation,
    /// The right side.
    pub right: Expr,
    /// The sides in words.
    pub words: [String; 2],
    /// The quantities that are compared, to be solved; numbers with units are none.
    pub quantities: Vec<Symbol>,
}

/// The most quantities that can be put in order: they have 24 orders.
pub(super) const MOST_ORDERED: usize = 4;

/// What has no value where two sides cannot be compared.
const SIDE: &str = "a side of a comparison";

/// The share of its terms below which a difference is zero.
const EQUAL: f64 = 1e-12;

impl Decision {
    /// A question that is answered by yes or no.
    #[must_use]
    pub fn yes_or_no(holds: bool, because: String) -> Self {
        Self {
            options: vec!["yes".into(), "no".into()],
            right: usize::from(!holds),
            because,
            behind: None,
            feedback: Vec::new(),
        }
    }
}

impl ChoicePart {
    /// Everything on which the choice depends, what is given included.
    #[must_use]
    pub fn depends_on(&self) -> BTreeSet<Symbol> {
        match self {
            Self::Settled(_) => BTreeSet::new(),
            Self::Judged(choice) => choice.symbols(),
            Self::Holds(claim) => claim.symbols(),
            Self::Order(symbols) => symbols.iter().copied().collect(),
            Self::Physical(symbol) => BTreeSet::from([*symbol]),
            Self::Offered(offer) => offer.symbols(),
            Self::Pictured(pictured) => pictured.subject.symbols(),
        }
    }

    /// Everything to which the choice refers.
    #[must_use]
    pub fn mentioned(&self) -> BTreeSet<Symbol> {
        if let Self::Offered(offer) = self { offer.mentioned() } else { self.depends_on() }
    }

    /// The quantities that have to be solved for the choice.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        match self {
            Self::Settled(_) => Vec::new(),
            Self::Judged(choice) => choice.quantities(),
            Self::Holds(claim) => claim.quantities.clone(),
            Self::Order(symbols) => symbols.clone(),
            Self::Physical(symbol) => vec![*symbol],
            Self::Offered(offer) => offer.quantities(),
            Self::Pictured(pictured) => pictured.quantities.clone(),
        }
    }

    /// Values on which the choice hangs and which are neither equal within the precision of the data nor clearly different.
    #[must_use]
    pub fn unclear(&self, worked: &Worked<'_>) -> Option<String> {
        if let Self::Judged(choice) = self { choice.unclear(worked) } else { None }
    }

    /// Whether values are taken as equal that are so only within the precision of the data.
    #[must_use]
    pub fn is_within_data(&self, worked: &Worked<'_>) -> bool {
        matches!(self, Self::Judged(choice) if choice.is_within_data(worked))
    }

    /// Why what is offered cannot be offered with the numbers of a variant.
    pub(in crate::problem) fn refused(&self, worked: &Worked<'_>) -> Option<String> {
        match self {
            Self::Holds(claim) => claim.refused(worked),
            Self::Order(symbols) => incomparable(symbols, worked),
            Self::Offered(offer) => offer.refused(worked),
            Self::Pictured(pictured) => pictured.refused(worked),
            Self::Settled(_) | Self::Judged(_) | Self::Physical(_) => None,
        }
    }

    /// The phrases, and which of them is right for a variant.
    #[must_use]
    pub fn decided(&self, worked: &Worked<'_>) -> Decision {
        match self {
            Self::Settled(decision) => decision.clone(),
            Self::Judged(choice) => choice.decided(worked),
            Self::Holds(claim) => claim.decided(worked),
            Self::Order(symbols) => ordered(symbols, worked),
            Self::Physical(symbol) => worked.possible_root(*symbol),
            Self::Offered(offer) => offer.decided(worked),
            Self::Pictured(pictured) => pictured.decided(worked),
        }
    }
}

/// How two numbers compare; `None` where one of them is none.
fn compared(left: f64, right: f64) -> Option<Ordering> {
    let is_near = (left - right).abs() <= EQUAL * left.abs().max(right.abs());
    if is_near { Some(Ordering::Equal) } else { left.partial_cmp(&right) }
}

/// How two terms compare with the numbers of a variant: equal where their difference is no more than its error bound, which is
/// so only where it is exactly zero. `None` where a side has no value, as where it is divided by zero.
fn exactly_compared(worked: &Worked<'_>, left: &Expr, right: &Expr) -> Option<Ordering> {
    let number = |symbol| worked.variant.value(symbol).unwrap_or_else(Bounded::not_real);
    let Bounded { value, error } = evaluate::<Bounded>(left, &number).sub(&evaluate(right, &number));
    if !error.is_finite() {
        return None;
    }
    if value.abs() <= error { Some(Ordering::Equal) } else { value.partial_cmp(&0.0) }
}

impl Claim {
    /// Everything that its sides contain.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        self.left.symbols().union(&self.right.symbols()).copied().collect()
    }

    /// Whether it holds where its sides have these values; `None` where one of them is no number.
    pub(super) fn holds_between(&self, left: f64, right: f64) -> Option<bool> {
        compared(left, right).map(|order| self.allows(order))
    }

    /// Whether it holds where its sides compare so.
    fn allows(&self, order: Ordering) -> bool {
        match self.relation {
            Relation::Less => order.is_lt(),
            Relation::AtMost => order.is_le(),
            Relation::Greater => order.is_gt(),
            Relation::AtLeast => order.is_ge(),
            Relation::Differs => order.is_ne(),
        }
    }

    /// Whether it holds of the numbers of a variant; `None` where a side has no value.
    pub(in crate::problem) fn holds(&self, worked: &Worked<'_>) -> Option<bool> {
        exactly_compared(worked, &self.left, &self.right).map(|order| self.allows(order))
    }

    /// Why it cannot be judged with the numbers of a variant.
    pub(super) fn refused(&self, worked: &Worked<'_>) -> Option<String> {
        self.holds(worked).is_none().then(|| no_value(SIDE))
    }

    pub(in crate::problem) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let Some(order) = exactly_compared(worked, &self.left, &self.right) else {
            return Decision::yes_or_no(false, no_value(SIDE));
        };
        let holds = self.allows(order);
        let is = match order {
            Ordering::Less => "less than",
            Ordering::Equal => "equal to",
            Ordering::Greater => "greater than",
        };
        let said = |words: &String, side: &Expr| {
            // A single quantity has its value where it is found, and what hangs on open letters has none.
            let is_single = matches!(side, Expr::Symbol(_) | Expr::Number(_)) || !worked.form.free.is_empty();
            let value = (!is_single).then(|| printed(worked, side)).flatten();
            value.map_or_else(|| words.clone(), |value| format!("{words} ({value})"))
        };
        let [left, right] = &self.words;
        Decision::yes_or_no(holds, format!("{} is {is} {}", said(left, &self.left), said(right, &self.right)))
    }
}

/// The value of a term in its usual unit.
fn printed(worked: &Worked<'_>, term: &Expr) -> Option<String> {
    let dimension = term.dimension(&worked.problem.model().symbols).ok()?;
    in_unit(worked, term, &coherent_unit(dimension, worked.problem.units()))
}

fn no_value(of: &str) -> String {
    format!("{of} has no value with these numbers, as where something is divided by zero")
}

/// Why some quantities cannot be put in order with the numbers of a variant: one has no value, or two are equal.
fn incomparable(symbols: &[Symbol], worked: &Worked<'_>) -> Option<String> {
    let name = |own: &Symbol| format!("`{}`", worked.problem.name_of(*own));
    let compared = |one: &Symbol, other: Expr| exactly_compared(worked, &(*one).into(), &other);
    if let Some(lost) = symbols.iter().find(|own| compared(own, Expr::zero()).is_none()) {
        return Some(no_value(&name(lost)));
    }
    let pairs =
        symbols.iter().enumerate().flat_map(|(place, one)| symbols[place + 1..].iter().map(move |own| (one, own)));
    let same = pairs.into_iter().find(|(one, other)| compared(one, (**other).into()) == Some(Ordering::Equal));
    same.map(|(one, other)| {
        format!("{} and {} are equal with these numbers, so that they have no order", name(one), name(other))
    })
}

/// Every order of some quantities.
#[must_use]
pub fn orders(symbols: &[Symbol]) -> Vec<Vec<Symbol>> {
    let mut orders = Vec::new();
    permute(symbols.to_vec(), 0, &mut orders);
    orders
}

fn ordered(symbols: &[Symbol], worked: &Worked<'_>) -> Decision {
    let name = |symbol: &Symbol| worked.problem.name_of(*symbol);
    let written = |symbols: &[Symbol]| symbols.iter().map(name).collect::<Vec<_>>().join(" < ");
    let options = orders(symbols);
    let mut sorted = symbols.to_vec();
    sorted.sort_by(|a, b| exactly_compared(worked, &(*a).into(), &(*b).into()).unwrap_or(Ordering::Equal));
    Decision {
        right: options.iter().take_while(|option| **option != sorted).count(),
        options: options.iter().map(|option| written(option)).collect(),
        because: "the values found above are in this order".into(),
        behind: None,
        feedback: Vec::new(),
    }
}

fn permute(symbols: Vec<Symbol>, from: usize, all: &mut Vec<Vec<Symbol>>) {
    if from + 1 >= symbols.len() {
        all.push(symbols);
        return;
    }
    for other in from..symbols.len() {
        let mut next = symbols.clone();
        // Turned rather than swapped, so that the orders come as in a dictionary.
        next[from..=other].rotate_right(1);
        permute(next, from + 1, all);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{SymbolEntry, SymbolTable};
    use crate::quantity::Dimension;

    #[test]
    fn every_order_comes_once_as_in_a_dictionary() {
        let mut table = SymbolTable::default();
        let entry = |name: &str| SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
        let symbols = ["a", "b", "c"].map(|name| table.intern(entry(name)));
        let places = |order: Vec<Symbol>| order.iter().map(|symbol| symbol.index()).collect::<Vec<_>>();
        let all: Vec<Vec<usize>> = orders(&symbols).into_iter().map(places).collect();
        assert_eq!(all, [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]]);
    }

    #[test]
    fn nearly_equal_is_equal() {
        assert_eq!(compared(1.0, 1.0 + 1e-15), Some(Ordering::Equal));
        assert_eq!(compared(1.0, 1.0 + 1e-9), Some(Ordering::Less));
        assert_eq!(compared(0.0, 0.0), Some(Ordering::Equal));
        assert_eq!(compared(f64::NAN, 0.0), None);
    }
}
