//! Which phrase of a choice is right for a variant.

use std::cmp::Ordering;

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::super::questions::choices::choice::ChoicePart;
use super::super::questions::choices::choice::orders;
use super::super::questions::choices::decision::Decision;
use super::super::sampling::variant::Worked;
use super::claim::exactly_compared;
use super::claim::no_value;

impl ChoicePart {
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
    pub(crate) fn refused(&self, worked: &Worked<'_>) -> Option<String> {
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

/// Why some quantities cannot be put in order with the numbers of a variant: one has no value, or two are equal.
fn incomparable(symbols: &[Symbol], worked: &Worked<'_>) -> Option<String> {
    let name = |symbol: &Symbol| format!("`{}`", worked.problem.name_of(*symbol));
    let compared = |one: &Symbol, other: Expr| exactly_compared(worked, &(*one).into(), &other);
    if let Some(lost) = symbols.iter().find(|symbol| compared(symbol, Expr::zero()).is_none()) {
        return Some(no_value(&name(lost)));
    }
    let pairs = symbols
        .iter()
        .enumerate()
        .flat_map(|(place, one)| symbols[place + 1..].iter().map(move |symbol| (one, symbol)));
    let same = pairs.into_iter().find(|(one, other)| compared(one, (**other).into()) == Some(Ordering::Equal));
    same.map(|(one, other)| {
        format!("{} and {} are equal with these numbers, so that they have no order", name(one), name(other))
    })
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
