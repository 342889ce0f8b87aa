//! How an equation that is too wide is broken: before relations, plus and minus, and factors, with what holds them opened.

use std::borrow::Cow;
use std::sync::Arc;

use momentous_expr::Math;
use momentous_expr::Operator;

/// How many items most lines have, or fewer.
pub(super) const USUAL_LENGTH: usize = 16;

/// A part of an equation as it was laid out, or one that breaking made.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Item<'a> {
    pub math: Cow<'a, Math>,
    /// In widths of a digit, roughly.
    width: f64,
}

impl<'a> Item<'a> {
    fn new(math: Cow<'a, Math>) -> Self {
        let width = math.width();
        Self { math, width }
    }
}

/// What is too wide for a row in a form that can be broken: a fraction as one over its denominator times the sum above it, a root as
/// the power of a bracket, and brackets opened.
pub(super) fn unfolded(item: Item<'_>, room: f64) -> Vec<Item<'_>> {
    if inside(&item.math).width() <= room { vec![item] } else { open(item, room) }
}

/// A piece that has no place to break and is too wide all the same: its widest part that can be opened is.
pub(super) fn opened(piece: Vec<Item<'_>>, room: f64) -> Vec<Item<'_>> {
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

/// The beginning of a continued sum or product: a gap, and an empty operand, so that its sign is spaced as one between two.
pub(super) fn indent() -> Vec<Item<'static>> {
    [Math::Text("\u{2003}".to_owned()), Math::Identifier(String::new())]
        .map(|math| Item::new(Cow::Owned(math)))
        .to_vec()
}

/// Whether a row continues the sum or product of the one above.
pub(super) fn continues(row: &[Item<'_>]) -> bool {
    row.first().is_some_and(|first| is_sum(first) || is_product(first))
}

/// What a row takes with the gap at its beginning.
fn row_width(row: &[Item<'_>]) -> f64 {
    let gap = if continues(row) { indent() } else { Vec::new() };
    Math::row_width(gap.iter().chain(row).map(|item| &*item.math))
}

/// Breaks before relations first, before plus and minus only within a part that is still too long, and before the factors of
/// a product where that has to be.
pub(super) fn fill(items: Vec<Item<'_>>, room: f64, breaks_products: bool) -> Vec<Vec<Item<'_>>> {
    if width(&items) <= room {
        return vec![items];
    }
    let mut pieces = Vec::new();
    for part in split_before(items, is_relation) {
        if width(&part) <= room {
            pieces.push(part);
            continue;
        }
        for piece in split_before(part, is_sum) {
            if breaks_products && row_width(&piece) > room {
                pieces.extend(split_between_factors(piece, room));
            } else {
                pieces.push(piece);
            }
        }
    }
    let mut rows: Vec<Vec<Item>> = Vec::new();
    for piece in pieces {
        match rows.last_mut() {
            Some(row) if row_width(row) + width(&piece) <= room => row.extend(piece),
            _ => rows.push(piece),
        }
    }
    rows
}

/// A product that is too wide for a row, broken with a sign that says so.
fn split_between_factors(product: Vec<Item<'_>>, room: f64) -> Vec<Vec<Item<'_>>> {
    let mut factors: Vec<Vec<Item>> = vec![Vec::new()];
    for item in product {
        match factors.last_mut() {
            Some(factor) if !begins_factor(factor, &item) => factor.push(item),
            _ => factors.push(vec![item]),
        }
    }
    let mut rows: Vec<Vec<Item>> = Vec::new();
    for mut factor in factors {
        match rows.last_mut() {
            Some(row) if row_width(row) + width(&factor) <= room => row.extend(factor),
            None => rows.push(factor),
            Some(row) => {
                row.pop_if(|last| is_juxtaposed(last));
                factor.insert(0, Item::new(Cow::Owned(Math::Operator(Operator::Times))));
                rows.push(factor);
            }
        }
    }
    rows
}

/// Whether a product can be broken before an item: before a bracket, fraction or root that follows a whole factor.
fn begins_factor(before: &[Item<'_>], item: &Item<'_>) -> bool {
    let begins = match &*item.math {
        Math::Bracketed(_) | Math::Squared(_) | Math::Bars(_) | Math::Fraction(..) | Math::Root(_) => true,
        Math::Text(text) => text == "[" || text == "(",
        _ => false,
    };
    let last = before.iter().rev().find(|last| !is_juxtaposed(last));
    begins && last.is_some_and(|last| is_whole(&last.math))
}

/// Whether an item may end a factor: no sign, no bracket that opens, no function that waits for its argument.
fn is_whole(math: &Math) -> bool {
    match math {
        Math::Operator(_) | Math::Function(_) => false,
        Math::Text(text) => text != "[" && text != "(",
        Math::Sup(base, _) => is_whole(base),
        _ => true,
    }
}

/// Splits before each marked item, but never right after the start or another operator: a sign is no place to break.
pub(super) fn split_before(items: Vec<Item<'_>>, marked: fn(&Item<'_>) -> bool) -> Vec<Vec<Item<'_>>> {
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

pub(super) fn is_relation(item: &Item<'_>) -> bool {
    relates(&item.math)
}

fn is_juxtaposed(item: &Item<'_>) -> bool {
    matches!(*item.math, Math::Operator(Operator::Juxtapose))
}

fn is_product(item: &Item<'_>) -> bool {
    matches!(*item.math, Math::Operator(Operator::Times))
}

pub(super) fn relates(math: &Math) -> bool {
    use Operator::{Approximately, AtLeast, AtMost, Differs, Equals, Greater, Implies, Less};
    matches!(math, Math::Operator(Equals | Approximately | Less | AtMost | Greater | AtLeast | Differs | Implies))
}

pub(super) fn is_sum(item: &Item<'_>) -> bool {
    matches!(*item.math, Math::Operator(Operator::Plus | Operator::Minus | Operator::PlusMinus))
}

/// The items of a row, with rows inside rows opened.
pub(super) fn flattened(math: &Math) -> Vec<Item<'_>> {
    let mut items = Vec::with_capacity(USUAL_LENGTH);
    math.spread(&mut |part| items.push(Item::new(Cow::Borrowed(part))));
    items
}

pub(super) fn width(items: &[Item<'_>]) -> f64 {
    Math::row_width(items.iter().map(|item| &*item.math))
}
