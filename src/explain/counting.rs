//! The first whole number for which a condition holds: the trials that show it.

use crate::expr::Expr;
use crate::expr::Math;
use crate::expr::Operator;
use crate::expr::Symbol;
use crate::solve::Closed;
use crate::solve::Relation;

use super::Block;
use super::Inline;
use super::display::Display;
use super::display::number_math;
use super::display::printed;
use super::display::with_unit;
use super::script::operator;

/// Figures of the values tried.
const FIGURES: usize = 4;

/// The number, and what the condition says of it and of the one before; nothing for a value that is not counted.
pub(super) fn trials(display: Display<'_>, unknown: Symbol, closed: &Closed) -> Vec<Block> {
    let Closed::FirstInteger { from, left, relation, right } = closed else { return Vec::new() };
    let Some(found) = display.worked.variant.value(unknown).map(|value| value.value.round()) else {
        return Vec::new();
    };
    let try_out = |number: f64| Trial { display, unknown, number, left, relation: *relation, right };
    let mut words = Vec::new();
    #[allow(clippy::cast_precision_loss)] // counts are small
    if found > *from as f64 {
        words.extend(try_out(found - 1.0).words(false));
        words.push(Inline::Text("; ".into()));
    }
    words.extend(try_out(found).words(true));
    words.push(Inline::Text(".".into()));
    let answer = Math::relation(display.name(unknown), Operator::Equals, Math::Number(format!("{found:.0}")));
    vec![Block::Paragraph(words), Block::Equation { lines: vec![answer], number: None }]
}

/// One whole number put into the condition.
struct Trial<'a> {
    display: Display<'a>,
    unknown: Symbol,
    number: f64,
    left: &'a Expr,
    relation: Relation,
    right: &'a Expr,
}

impl Trial<'_> {
    /// `n = 3 gives 0.0824 m < 0.2 m`.
    fn words(&self, holds: bool) -> Vec<Inline> {
        let number = Math::Number(format!("{:.0}", self.number));
        let (gives, relation) = if holds {
            (" gives ", operator(self.relation))
        } else {
            (" still gives ", operator(self.relation.opposite()))
        };
        vec![
            Inline::Math(Math::relation(self.display.name(self.unknown), Operator::Equals, number)),
            Inline::Text(gives.into()),
            Inline::Math(Math::relation(self.side(self.left), relation, self.side(self.right))),
        ]
    }

    fn side(&self, side: &Expr) -> Math {
        if let Expr::Symbol(symbol) = side
            && *symbol != self.unknown
        {
            return self.display.quantity(*symbol);
        }
        let unit = self.display.unit_of(side);
        let value = side.evaluate(&|symbol| {
            let known = || self.display.worked.variant.value(symbol).map_or(f64::NAN, |value| value.value);
            if symbol == self.unknown { self.number } else { known() }
        });
        with_unit(number_math(printed(value / unit.factor().to_f64(), FIGURES)), &unit)
    }
}
