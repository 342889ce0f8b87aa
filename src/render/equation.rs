//! Displayed equations: where they align, and where long ones break.

use std::borrow::Cow;

use momentous_expr::Math;

use super::breaking::{Item, USUAL_LENGTH};
use super::breaking::{
    continues, fill, flattened, indent, is_relation, is_sum, opened, relates, split_before, unfolded, width,
};

/// The parts of a row one by one, for a writer that would put a row within it into an element of its own.
pub(super) fn spread(items: &[Math]) -> Vec<&Math> {
    let mut parts = Vec::with_capacity(USUAL_LENGTH);
    for item in items {
        item.spread(&mut |part| parts.push(part));
    }
    parts
}

/// One row of a displayed equation; rows are aligned where the right side begins.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row<'a> {
    /// Those of the line itself where it need not be broken.
    items: Cow<'a, [Math]>,
    /// The number of the items that stand before the alignment.
    aligned: usize,
    /// How wide they are before and behind it.
    widths: [f64; 2],
}

impl<'a> Row<'a> {
    fn new(left: Vec<Item<'a>>, right: Vec<Item<'a>>) -> Self {
        let (aligned, widths) = (left.len(), [width(&left), width(&right)]);
        Self { items: left.into_iter().chain(right).map(|item| item.math.into_owned()).collect(), aligned, widths }
    }

    /// The terms before the alignment; empty where the row continues the one above.
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

/// How many times too wide rows are that could not be broken, from which on each smaller size is needed.
const TOO_WIDE: [f64; 3] = [1.0, 1.15, 1.35];

/// The size of type for rows that could not be broken to that width, of three that grow smaller; none for those that fit.
pub(super) fn smaller<'s>(rows: &[Row<'_>], widest: f64, sizes: [&'s str; 3]) -> Option<&'s str> {
    let excess = table_width(rows) / widest;
    TOO_WIDE.iter().zip(sizes).rev().find(|(least, _)| excess > **least).map(|(_, size)| size)
}

/// The width of rows that are aligned with each other.
fn table_width(rows: &[Row<'_>]) -> f64 {
    let side = |side: usize| rows.iter().map(|row| row.widths[side]).fold(0.0, f64::max);
    side(0) + side(1)
}

/// The widest row on paper, in widths of a digit: what fits the text of a page at 11 pt.
pub(super) const PAPER: f64 = 62.0;

/// The widest row on a screen that may be that of a telephone, 390 pixels wide.
pub(super) const SCREEN: f64 = 39.0;

/// The room for the number beside an equation on such a screen.
pub(super) const NUMBER: f64 = 4.0;

/// The rows of an equation of those lines, each aligned at its first relation and broken where it is wider than that.
pub(super) fn rows(lines: &[Math], widest: f64) -> Vec<Row<'_>> {
    let whole = lines.iter().map(|line| unbroken(line, widest)).collect::<Option<Vec<Row>>>();
    if let Some(rows) = whole
        && (!scrolls(widest) || table_width(&rows) <= widest)
    {
        return rows;
    }
    let items: Vec<Vec<Item>> = lines.iter().map(flattened).collect();
    let aligned: Vec<usize> = items.iter().map(|items| alignment(items, widest)).collect();
    let lefts: Vec<f64> = items.iter().zip(&aligned).map(|(items, aligned)| width(&items[..*aligned])).collect();
    let common = lefts.iter().copied().fold(0.0, f64::max);
    let rows: Vec<Row> = lines
        .iter()
        .zip(&items)
        .zip(aligned.iter().zip(&lefts))
        .flat_map(|((line, items), (aligned, left))| {
            let room = widest - if scrolls(widest) { common } else { *left };
            unbroken(line, left + room).map_or_else(|| broken(items.clone(), *aligned, room, widest), |row| vec![row])
        })
        .collect();
    if common == 0.0 || !scrolls(widest) || table_width(&rows) <= widest {
        return rows;
    }
    // A left side on a row of its own leaves more room for the right one.
    let below: Vec<Row> = items.into_iter().flat_map(|items| broken(items, 0, widest, widest)).collect();
    if table_width(&below) < table_width(&rows) { below } else { rows }
}

/// How many items stand before the first relation; none where they leave too little room behind it.
fn alignment(items: &[Item<'_>], widest: f64) -> usize {
    let relation = items.iter().position(is_relation);
    relation.filter(|at| width(&items[..*at]) <= widest / 2.0).unwrap_or(0)
}

/// Mathematics within a line in pieces between which the line may be broken: before relations, where it is too wide.
pub(super) fn pieces(math: &Math, widest: f64) -> Vec<Cow<'_, Math>> {
    if math.width() <= widest / 2.0 {
        return vec![Cow::Borrowed(math)];
    }
    let piece =
        |items: Vec<Item<'_>>| Cow::Owned(Math::Row(items.into_iter().map(|item| item.math.into_owned()).collect()));
    split_before(flattened(math), is_relation).into_iter().map(piece).collect()
}

/// Whether what is too wide has to be scrolled, as on a telephone. Paper sets it in smaller type where it is a little too wide.
fn scrolls(widest: f64) -> bool {
    widest < PAPER
}

/// The rows of a line whose first items stand before the alignment, with that room behind it.
fn broken(mut items: Vec<Item<'_>>, aligned: usize, room: f64, widest: f64) -> Vec<Row<'_>> {
    let rest = items.split_off(aligned);
    let scrolls = scrolls(widest);
    let opens = |item: &Item<'_>| scrolls || !matches!(&*item.math, Math::Root(_));
    let rest = rest.into_iter().flat_map(|item| if opens(&item) { unfolded(item, room) } else { vec![item] }).collect();
    let rest = if scrolls {
        let pieces = split_before(rest, is_relation).into_iter().flat_map(|part| split_before(part, is_sum));
        pieces.flat_map(|piece| opened(piece, room)).collect()
    } else {
        rest
    };
    let mut left = Some(items);
    let row = |right: Vec<_>| match left.take() {
        Some(items) => Row::new(items, right),
        None if continues(&right) => Row::new(Vec::new(), [indent(), right].concat()),
        None => Row::new(Vec::new(), right),
    };
    fill(rest, room, scrolls).into_iter().map(row).collect()
}

/// The only row of a line that fits, rows within it left as they are; none where it must be broken, or where a row within
/// would look otherwise if its parts stood in the line themselves.
fn unbroken(line: &Math, widest: f64) -> Option<Row<'_>> {
    let parts = match line {
        Math::Row(parts) => parts.as_slice(),
        other => std::slice::from_ref(other),
    };
    if !stand_apart(parts) {
        return None;
    }
    let relation = parts.iter().position(relates);
    let aligned = relation.filter(|at| spread_width(&parts[..*at]) <= widest / 2.0).unwrap_or(0);
    let (left, right) = parts.split_at(aligned);
    let widths = [left, right].map(spread_width);
    let fits = widths[1] <= widest - widths[0];
    fits.then_some(Row { items: Cow::Borrowed(parts), aligned, widths })
}

/// Whether every row among the parts stands between signs, and relates nothing.
fn stand_apart(parts: &[Math]) -> bool {
    let is_sign = |part: Option<&Math>| part.is_none_or(|part| matches!(part, Math::Operator(_)));
    parts.iter().enumerate().all(|(place, part)| {
        let Math::Row(inner) = part else { return true };
        let before = place.checked_sub(1).and_then(|before| parts.get(before));
        is_sign(before) && is_sign(parts.get(place + 1)) && stand_apart(inner) && !inner.iter().any(relates)
    })
}

/// The width of parts when rows within them are opened.
fn spread_width(parts: &[Math]) -> f64 {
    Math::row_width(spread(parts))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use momentous_expr::Operator;

    use super::*;

    #[test]
    fn a_bracket_opens_where_the_row_has_no_other_place_to_break() {
        let term = || identifier(&"y".repeat(16));
        let sum = Math::Row(vec![term(), Math::Operator(Operator::Minus), term()]);
        let product = Math::Row(vec![identifier(&"m".repeat(8)), Math::Squared(Arc::new(sum))]);
        let lines = [Math::relation(identifier("v"), Operator::Equals, product)];
        let rows = rows(&lines, SCREEN);
        assert_eq!(rows.len(), 2);
        assert!(rows.iter().all(|row| row.widths[0] + row.widths[1] <= SCREEN), "{rows:?}");
    }

    #[test]
    fn a_fraction_that_paper_holds_is_broken_on_a_screen() {
        let term = || identifier(&"y".repeat(20));
        let sum = Math::Row(vec![term(), Math::Operator(Operator::Plus), term()]);
        let lines = [Math::relation(
            identifier("v"),
            Operator::Equals,
            Math::Fraction(Arc::new(sum), Arc::new(identifier("m"))),
        )];
        assert_eq!((rows(&lines, PAPER).len(), rows(&lines, SCREEN).len()), (1, 2));
    }

    fn identifier(name: &str) -> Math {
        Math::Identifier(name.into())
    }

    #[test]
    fn a_short_chain_stays_on_one_row() {
        let line = Math::relation(identifier("p"), Operator::Equals, identifier("q"));
        let lines = [line];
        let rows = rows(&lines, PAPER);
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
        let rows = rows(std::slice::from_ref(&line), PAPER);
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[1].left(), []);
        assert_eq!(rows[1].right(), [Math::Operator(Operator::Equals), long]);
        let again: Vec<Math> = rows.into_iter().flat_map(|row| row.items.into_owned()).collect();
        assert_eq!(again, flattened(&line).into_iter().map(|item| item.math.into_owned()).collect::<Vec<_>>());
    }

    #[test]
    fn a_wide_fraction_is_unfolded_and_broken() {
        let term = identifier(&"y".repeat(40));
        let sum = Math::Row(vec![term.clone(), Math::Operator(Operator::Plus), term.clone()]);
        let fraction = Math::Fraction(Arc::new(sum), Arc::new(identifier("m")));
        let line = Math::relation(identifier("v"), Operator::Equals, fraction);
        let lines = [line];
        let rows = rows(&lines, PAPER);
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].right().last(), Some(&term));
        assert_eq!(rows[1].right().last(), Some(&Math::Text("]".into())));
        assert!(smaller(&rows, PAPER, ["s", "m", "l"]).is_none());
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
        let lines = [line];
        let rows = rows(&lines, PAPER);
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0].right(), [Math::Operator(Operator::Equals), minus, term]);
    }
}
