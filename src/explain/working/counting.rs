//! The first whole number for which a condition holds: the trials that show it.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_solve::Closed;
use momentous_solve::Relation;

use super::super::Block;
use super::super::Inline;
use super::super::terms::display::Display;
use super::super::terms::entry::Item;
use super::super::terms::ledger::Ledger;

/// The number, and what the condition says of it and of the one before; nothing for a value that is not counted.
pub(super) fn trials(display: Display<'_>, unknown: Symbol, closed: &Closed) -> Vec<Block> {
    let Some(trials) = tried(display, unknown, closed) else { return Vec::new() };
    let Some((last, _)) = trials.last() else { return Vec::new() };
    let answer = Math::relation(display.name(unknown), Operator::Equals, last.counted());
    let mut words = Vec::new();
    for (place, (trial, holds)) in trials.iter().enumerate() {
        words.extend((place > 0).then(|| Inline::Text("; ".into())));
        words.extend(trial.words(*holds));
    }
    words.push(Inline::Text(".".into()));
    vec![Block::Paragraph(words), Block::Equation { lines: vec![answer], number: None }]
}

/// Enters the trials into the ledger of a solution.
pub(crate) fn enter(display: Display<'_>, ledger: &mut Ledger, unknown: Symbol, closed: &Closed) {
    let Some(trials) = tried(display, unknown, closed) else { return };
    for (trial, holds) in trials {
        let items = [trial.enter(ledger, 0), trial.enter(ledger, 1)];
        let relation = if holds { trial.relation } else { trial.relation.opposite() };
        let [left, right] = items;
        match relation {
            Relation::Less => ledger.ordered([left, right], true),
            Relation::AtMost => ledger.ordered([left, right], false),
            Relation::Greater => ledger.ordered([right, left], true),
            Relation::AtLeast => ledger.ordered([right, left], false),
            Relation::Differs | Relation::Equals => {}
        }
    }
}

/// The number found and the one before it, each with whether the condition holds.
fn tried<'a>(display: Display<'a>, unknown: Symbol, closed: &'a Closed) -> Option<Vec<(Trial<'a>, bool)>> {
    let Closed::FirstInteger { from, left, relation, right } = closed else { return None };
    let solution = display.worked.variant.value(unknown)?.value.round();
    #[allow(clippy::cast_possible_truncation, reason = "counts are small")]
    let solution = solution as i64;
    let sides = [left, right];
    let trial = |number: i64| Trial { display, unknown, number, sides, relation: *relation };
    let before = (solution > *from).then(|| (trial(solution - 1), false));
    Some(before.into_iter().chain([(trial(solution), true)]).collect())
}

/// One whole number put into the condition.
struct Trial<'a> {
    display: Display<'a>,
    unknown: Symbol,
    number: i64,
    sides: [&'a Expr; 2],
    relation: Relation,
}

impl Trial<'_> {
    fn counted(&self) -> Math {
        Math::Number(self.number.to_string())
    }

    /// `n = 3 gives 0.0824 m < 0.2 m`.
    fn words(&self, holds: bool) -> Vec<Inline> {
        let (gives, relation) = if holds {
            (" gives ", self.relation.operator())
        } else {
            (" still gives ", self.relation.opposite().operator())
        };
        vec![
            Inline::Math(Math::relation(self.display.name(self.unknown), Operator::Equals, self.counted())),
            Inline::Text(gives.into()),
            Inline::Math(Math::relation(self.side(0), relation, self.side(1))),
        ]
    }

    /// A side with the number put in, and under which item its value stands.
    fn tried(&self, place: usize) -> (Expr, Item) {
        let side = self.sides[place];
        let number = Expr::integer(self.number);
        match side {
            Expr::Symbol(symbol) if *symbol != self.unknown => (side.clone(), Item::Quantity(*symbol)),
            _ => {
                let tried = side.substitute(&|symbol| (symbol == self.unknown).then(|| number.clone()));
                (tried, Item::Trial(self.unknown, self.number, place))
            }
        }
    }

    fn side(&self, place: usize) -> Math {
        let (side, item) = self.tried(place);
        self.display.evaluated(&side, &self.display.measure(&side).0, item)
    }

    fn enter(&self, ledger: &mut Ledger, place: usize) -> Item {
        let (side, item) = self.tried(place);
        match item {
            Item::Quantity(symbol) => self.display.enter(ledger, symbol),
            _ => self.display.enter_value(ledger, &side, self.display.size(&self.display.measure(&side).0), item),
        }
        item
    }
}
