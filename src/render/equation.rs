//! Displayed equations: where they align, and where long ones break.

use std::borrow::Cow;
use std::sync::Arc;

use momentous_expr::Math;
use momentous_expr::Operator;

/// The parts of a row one by one, for a writer that would put a row within it into an element of its own.
pub(super) fn spread(items: &[Math]) -> Vec<&Math> {
    let mut parts = Vec::with_capacity(USUAL_LENGTH);
    for item in items {
        item.spread(&mut |part| parts.push(part));
    }
    parts
}

/// A part of an equation as it was laid out, or one that breaking made.
#[derive(Clone, Debug, PartialEq)]
struct Item<'a> {
    math: Cow<'a, Math>,
    /// In widths of a digit, roughly.
    width: f64,
}

impl<'a> Item<'a> {
    fn new(math: Cow<'a, Math>) -> Self {
        let width = math.width();
        Self { math, width }
    }
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

/// The size of type for rows that could not be broken, of three that grow smaller; none for those that fit.
pub(super) fn smaller<'s>(rows: &[Row<'_>], sizes: [&'s str; 3]) -> Option<&'s str> {
    let [left, right] = [0, 1].map(|side| rows.iter().map(|row| row.widths[side]).fold(0.0, f64::max));
    let excess = (left + right) / PAPER;
    TOO_WIDE.iter().zip(sizes).rev().find(|(least, _)| excess > **least).map(|(_, size)| size)
}

/// The widest row on paper, in widths of a digit: what fits the text of a page at 11 pt.
pub(super) const PAPER: f64 = 62.0;

/// The widest row on a screen that may be that of a telephone, 390 pixels wide.
pub(super) const SCREEN: f64 = 40.0;

/// The room for the number beside an equation on such a screen.
pub(super) const NUMBER: f64 = 4.0;

/// How many items most lines have, or fewer.
const USUAL_LENGTH: usize = 16;

/// The rows of an equation of those lines, each aligned at its first relation and broken where it is wider than that.
pub(super) fn rows(lines: &[Math], widest: f64) -> Vec<Row<'_>> {
    lines.iter().flat_map(|line| line_rows(line, widest)).collect()
}

fn line_rows(line: &Math, widest: f64) -> Vec<Row<'_>> {
    if let Some(row) = unbroken(line, widest) {
        return vec![row];
    }
    let mut items = flattened(line);
    let relation = items.iter().position(is_relation);
    let aligned = relation.filter(|at| width(&items[..*at]) <= widest / 2.0).unwrap_or(0);
    let rest = items.split_off(aligned);
    let room = widest - width(&items);
    // Paper sets in smaller type what is a little too wide; a telephone would have to scroll.
    let scrolls = widest < PAPER;
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
        None if right.first().is_some_and(is_sum) => Row::new(Vec::new(), [indent(), right].concat()),
        None => Row::new(Vec::new(), right),
    };
    fill(rest, room).into_iter().map(row).collect()
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

/// The width of parts as it adds up when rows within them are opened.
fn spread_width(parts: &[Math]) -> f64 {
    fn add(math: &Math, total: &mut f64) {
        match math {
            Math::Row(parts) => parts.iter().for_each(|part| add(part, total)),
            other => *total += other.width(),
        }
    }
    let mut total = 0.0;
    for part in parts {
        add(part, &mut total);
    }
    total
}

/// What is too wide for a row in a form that can be broken: a fraction as one over its denominator times the sum above it, a root as
/// the power of a bracket, and brackets opened.
fn unfolded(item: Item<'_>, room: f64) -> Vec<Item<'_>> {
    if inside(&item.math).width() <= room { vec![item] } else { open(item, room) }
}

/// A piece that has no place to break and is too wide all the same: its widest part that can be opened is.
fn opened(piece: Vec<Item<'_>>, room: f64) -> Vec<Item<'_>> {
    let can_open = |item: &Item<'_>| {
        matches!(&*item.math, Math::Fraction(..) | Math::Root(_) | Math::Bracketed(_) | Math::Squared(_))
            && flattened(inside(&item.math)).iter().skip(1).any(is_sum)
    };
    let widest = piece.iter().filter(|item| can_open(item)).map(|item| item.width).fold(0.0, f64::max);
    if width(&piece) <= room || widest == 0.0 {
        return piece;
    }
    piece
        .into_iter()
        .flat_map(|item| if item.width >= widest && can_open(&item) { open(item, room) } else { vec![item] })
        .collect()
}

/// The sum or product that a fraction, a root or a bracket holds.
fn inside(math: &Math) -> &Math {
    match math {
        Math::Fraction(inner, _) | Math::Root(inner) | Math::Bracketed(inner) | Math::Squared(inner) => inner,
        other => other,
    }
}

/// The same, however wide it is; nothing else where it cannot be opened.
fn open(item: Item<'_>, room: f64) -> Vec<Item<'_>> {
    let one = || Arc::new(Math::Number("1".to_owned()));
    let sign = |text: &str| Math::Text(text.to_owned());
    let (before, inner, [open, close]) = match &*item.math {
        Math::Fraction(over, under) if under.width() <= room => {
            (Some(Math::Fraction(one(), under.clone())), over, [sign("["), sign("]")])
        }
        Math::Root(inner) => {
            let half = Math::Fraction(one(), Arc::new(Math::Number("2".to_owned())));
            (None, inner, [sign("["), Math::Sup(Arc::new(sign("]")), Arc::new(half))])
        }
        Math::Bracketed(inner) => (None, inner, [sign("("), sign(")")]),
        Math::Squared(inner) => (None, inner, [sign("["), sign("]")]),
        _ => return vec![item],
    };
    let new_item = |math: Math| Item::new(Cow::Owned(math));
    let mut items: Vec<Item> = before.into_iter().chain([open]).map(new_item).collect();
    for item in flattened(inner) {
        items.extend(unfolded(item, room).into_iter().map(|part| new_item(part.math.into_owned())));
    }
    items.push(new_item(close));
    items
}

/// The beginning of a continued sum: a gap, and an empty operand, so that its sign is spaced as one between two.
fn indent() -> Vec<Item<'static>> {
    [Math::Text("\u{2003}".to_owned()), Math::Identifier(String::new())]
        .map(|math| Item::new(Cow::Owned(math)))
        .to_vec()
}

/// Breaks before relations first, and before plus and minus only within a part that is still too long.
fn fill(items: Vec<Item<'_>>, room: f64) -> Vec<Vec<Item<'_>>> {
    if width(&items) <= room {
        return vec![items];
    }
    let mut pieces = Vec::new();
    for part in split_before(items, is_relation) {
        if width(&part) <= room {
            pieces.push(part);
        } else {
            pieces.extend(split_before(part, is_sum));
        }
    }
    let mut rows: Vec<Vec<Item>> = Vec::new();
    for piece in pieces {
        match rows.last_mut() {
            Some(row) if width(row) + width(&piece) <= room => row.extend(piece),
            _ => rows.push(piece),
        }
    }
    rows
}

/// Splits before each marked item, but never right after the start or another operator: a sign is no place to break.
fn split_before(items: Vec<Item<'_>>, marked: fn(&Item<'_>) -> bool) -> Vec<Vec<Item<'_>>> {
    let mut parts: Vec<Vec<Item>> = vec![Vec::new()];
    for item in items {
        let after_operand =
            parts.last().and_then(|part| part.last()).is_some_and(|last| !matches!(*last.math, Math::Operator(_)));
        match parts.last_mut() {
            Some(part) if !(marked(&item) && after_operand) => part.push(item),
            _ => parts.push(vec![item]),
        }
    }
    parts
}

fn is_relation(item: &Item<'_>) -> bool {
    relates(&item.math)
}

fn relates(math: &Math) -> bool {
    use Operator::{Approximately, AtLeast, AtMost, Differs, Equals, Greater, Implies, Less};
    matches!(math, Math::Operator(Equals | Approximately | Less | AtMost | Greater | AtLeast | Differs | Implies))
}

fn is_sum(item: &Item<'_>) -> bool {
    matches!(*item.math, Math::Operator(Operator::Plus | Operator::Minus | Operator::PlusMinus))
}

/// The items of a row, with rows inside rows opened.
fn flattened(math: &Math) -> Vec<Item<'_>> {
    let mut items = Vec::with_capacity(USUAL_LENGTH);
    math.spread(&mut |part| items.push(Item::new(Cow::Borrowed(part))));
    items
}

fn width(items: &[Item<'_>]) -> f64 {
    items.iter().map(|item| item.width).sum()
}

#[cfg(test)]
mod tests {
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
        assert!(smaller(&rows, ["s", "m", "l"]).is_none());
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
