//! Displayed equations: where they align, and where long ones break.

use crate::expr::Math;
use crate::expr::Operator;

/// One row of a displayed equation; rows are aligned where the right side begins.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    items: Vec<Math>,
    /// How many of the items stand before the alignment.
    aligned: usize,
}

impl Row {
    /// What stands before the alignment; empty where the row continues the one above.
    pub fn left(&self) -> &[Math] {
        &self.items[..self.aligned]
    }

    /// A relation and what follows it, or a continuation.
    pub fn right(&self) -> &[Math] {
        &self.items[self.aligned..]
    }

    /// The whole row, where there is nothing to align it with.
    pub fn whole(&self) -> &[Math] {
        &self.items
    }
}

/// How much too wide the rows are where they could not be broken: 1 for those that fit.
pub(super) fn excess(rows: &[Row]) -> f64 {
    let widest = |side: fn(&Row) -> &[Math]| rows.iter().map(|row| width(side(row))).fold(0.0, f64::max);
    ((widest(Row::left) + widest(Row::right)) / WIDEST).max(1.0)
}

/// The widest row, in widths of a digit: what fits the text of a page at 11 pt and of a screen column.
const WIDEST: f64 = 62.0;

/// The rows of an equation of those lines, each aligned at its first relation and broken where it is too long.
pub(super) fn rows(lines: &[Math]) -> Vec<Row> {
    lines.iter().flat_map(|line| line_rows(flatten(line))).collect()
}

fn line_rows(mut items: Vec<Math>) -> Vec<Row> {
    let relation = items.iter().position(is_relation);
    let aligned = relation.filter(|at| width(&items[..*at]) <= WIDEST / 2.0).unwrap_or(0);
    let rest = items.split_off(aligned);
    let room = WIDEST - width(&items);
    let rest = rest.into_iter().flat_map(|item| unfolded(item, room)).collect();
    let mut left = Some(items);
    let row = |mut right: Vec<Math>| match left.take() {
        Some(mut items) => {
            items.append(&mut right);
            Row { items, aligned }
        }
        None if right.first().is_some_and(is_sum) => Row { items: [indent(), right].concat(), aligned: 0 },
        None => Row { items: right, aligned: 0 },
    };
    fill(rest, room).into_iter().map(row).collect()
}

/// A fraction that is too wide for a row, as one over its denominator times the sum above it, and a wide bracket opened: those can
/// be broken.
fn unfolded(item: Math, room: f64) -> Vec<Math> {
    let (before, inner, [open, close]) = match item {
        Math::Fraction(over, under) if item_width(&over) > room => {
            (Some(Math::Fraction(Box::new(Math::Number("1".to_owned())), under)), over, ["[", "]"])
        }
        Math::Bracketed(inner) if item_width(&inner) > room => (None, inner, ["(", ")"]),
        Math::Squared(inner) if item_width(&inner) > room => (None, inner, ["[", "]"]),
        other => return vec![other],
    };
    let bracket = |sign: &str| Math::Text(sign.to_owned());
    let mut items: Vec<Math> = before.into_iter().chain([bracket(open)]).collect();
    items.extend(flatten(&inner).into_iter().flat_map(|item| unfolded(item, room)));
    items.push(bracket(close));
    items
}

/// What a continued sum begins with: a gap, and an empty operand, so that its sign is spaced as one between two.
fn indent() -> Vec<Math> {
    vec![Math::Text("\u{2003}".to_owned()), Math::Identifier(String::new())]
}

/// Breaks before relations first, and before plus and minus only within a part that is still too long.
fn fill(items: Vec<Math>, room: f64) -> Vec<Vec<Math>> {
    let mut pieces = Vec::new();
    for part in split_before(items, is_relation) {
        if width(&part) <= room {
            pieces.push(part);
        } else {
            pieces.extend(split_before(part, is_sum));
        }
    }
    let mut rows: Vec<Vec<Math>> = Vec::new();
    for piece in pieces {
        match rows.last_mut() {
            Some(row) if width(row) + width(&piece) <= room => row.extend(piece),
            _ => rows.push(piece),
        }
    }
    rows
}

/// Splits before each marked item, but never right after the start or another operator: a sign is no place to break.
fn split_before(items: Vec<Math>, marked: fn(&Math) -> bool) -> Vec<Vec<Math>> {
    let mut parts: Vec<Vec<Math>> = vec![Vec::new()];
    for item in items {
        let after_operand =
            parts.last().and_then(|part| part.last()).is_some_and(|last| !matches!(last, Math::Operator(_)));
        match parts.last_mut() {
            Some(part) if !(marked(&item) && after_operand) => part.push(item),
            _ => parts.push(vec![item]),
        }
    }
    parts
}

fn is_relation(item: &Math) -> bool {
    use Operator::{Approximately, AtLeast, AtMost, Differs, Equals, Greater, Implies, Less};
    matches!(item, Math::Operator(Equals | Approximately | Less | AtMost | Greater | AtLeast | Differs | Implies))
}

fn is_sum(item: &Math) -> bool {
    matches!(item, Math::Operator(Operator::Plus | Operator::Minus | Operator::PlusMinus))
}

/// The items of a row, with rows inside rows opened.
fn flatten(math: &Math) -> Vec<Math> {
    match math {
        Math::Row(parts) => parts.iter().flat_map(flatten).collect(),
        other => vec![other.clone()],
    }
}

fn width(items: &[Math]) -> f64 {
    items.iter().map(item_width).sum()
}

/// A rough width, in widths of a digit.
fn item_width(math: &Math) -> f64 {
    const SCRIPT: f64 = 0.7;
    match math {
        Math::Row(parts) => width(parts),
        Math::Number(text) | Math::Identifier(text) | Math::Text(text) | Math::Function(text) | Math::Vector(text) => {
            text.chars().map(|_| 1.0).sum()
        }
        Math::Operator(Operator::Juxtapose) => 0.4,
        Math::Operator(Operator::Comma) => 1.0,
        Math::Operator(_) => 2.4,
        Math::Fraction(over, under) => item_width(over).max(item_width(under)) + 0.5,
        Math::Sub(base, script) | Math::Sup(base, script) => item_width(base) + SCRIPT * item_width(script),
        Math::SubSup(base, low, high) => item_width(base) + SCRIPT * item_width(low).max(item_width(high)),
        Math::Root(inner) | Math::Bracketed(inner) | Math::Squared(inner) | Math::Bars(inner) => {
            item_width(inner) + 1.5
        }
        Math::Cases(cases) => {
            cases.iter().map(|(when, value)| item_width(when) + item_width(value) + 3.0).fold(0.0, f64::max)
        }
        Math::Integral(low, high, inner, variable) => {
            2.0 + SCRIPT * item_width(low).max(item_width(high)) + item_width(inner) + item_width(variable)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn identifier(name: &str) -> Math {
        Math::Identifier(name.into())
    }

    #[test]
    fn a_short_chain_stays_on_one_row() {
        let line = Math::relation(identifier("p"), Operator::Equals, identifier("q"));
        let rows = rows(&[line]);
        assert_eq!(rows.len(), 1);
        assert_eq!(rows[0].left(), [identifier("p")]);
    }

    #[test]
    fn a_long_chain_breaks_before_relations_and_keeps_every_item() {
        let long = identifier(&"x".repeat(40));
        let line = Math::Row(vec![
            identifier("v"),
            Math::Operator(Operator::Equals),
            long.clone(),
            Math::Operator(Operator::Equals),
            long.clone(),
        ]);
        let rows = rows(std::slice::from_ref(&line));
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[1].left(), []);
        assert_eq!(rows[1].right(), [Math::Operator(Operator::Equals), long]);
        let again: Vec<Math> = rows.into_iter().flat_map(|row| row.items).collect();
        assert_eq!(again, flatten(&line));
    }

    #[test]
    fn a_wide_fraction_is_unfolded_and_broken() {
        let term = identifier(&"y".repeat(40));
        let sum = Math::Row(vec![term.clone(), Math::Operator(Operator::Plus), term.clone()]);
        let fraction = Math::Fraction(Box::new(sum), Box::new(identifier("m")));
        let line = Math::relation(identifier("v"), Operator::Equals, fraction);
        let rows = rows(&[line]);
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].right().last(), Some(&term));
        assert_eq!(rows[1].right().last(), Some(&Math::Text("]".into())));
        assert!(excess(&rows) <= 1.0);
    }

    #[test]
    fn a_long_sum_breaks_before_its_signs_but_not_at_a_leading_one() {
        let term = identifier(&"y".repeat(30));
        let minus = Math::Operator(Operator::Minus);
        let line = Math::Row(vec![
            identifier("v"),
            Math::Operator(Operator::Equals),
            minus.clone(),
            term.clone(),
            minus.clone(),
            term.clone(),
            Math::Operator(Operator::Plus),
            term.clone(),
        ]);
        let rows = rows(&[line]);
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0].right(), [Math::Operator(Operator::Equals), minus, term]);
    }
}
