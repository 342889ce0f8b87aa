//! Questions that compare quantities: whether one is greater than another, and in which order several are.

use momentous_expr::Expr;
use momentous_expr::Leaf;
use momentous_expr::LeafKind;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::QuantityKind;
use momentous_model::Reason;
use momentous_quantity::dimension_name;
use momentous_solve::Relation;

use super::super::super::language::ask::Holds;
use super::super::super::language::ask::Order;
use super::super::super::language::comparison::split_relation;
use super::super::super::language::condition::condition;
use super::super::super::reading::load::Loaded;
use super::super::part::PartKind;
use super::super::part::Question;
use super::super::to_solve::to_solve;
use super::choice::ChoicePart;
use super::choice::MOST_ORDERED;
use super::claim::Claim;

/// Whether something holds of the numbers.
pub(crate) fn holds(loaded: &Loaded, ask: &Holds, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let (words, claim) = claim(loaded, &ask.holds, builder, &path.key("holds"))?;
    Some((format!("Is {words}?"), PartKind::Choice(ChoicePart::Holds(claim))))
}

/// A relation in words, as they stand behind `is`.
pub(crate) fn than(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "less than",
        Relation::AtMost => "at most",
        Relation::Greater => "greater than",
        Relation::AtLeast => "at least",
        Relation::Differs => "different from",
        Relation::Equals => "equal to",
    }
}

/// A comparison in words, and what it claims.
pub(crate) fn claim(loaded: &Loaded, text: &str, builder: &mut Builder<'_>, path: &Path) -> Option<(String, Claim)> {
    let condition = condition(builder, text, Reason::Asked, path)?;
    let (left, relation, right) = (condition.left, condition.relation, condition.right);
    let written = split_relation(text).map_or(["", ""], |(left, _, right)| [left, right]);
    let plain = |side: &Expr| match side {
        Expr::Symbol(symbol) => builder.symbols().entry(*symbol).name.clone(),
        other => laid_out(builder, other).plain(),
    };
    let words =
        [(&left, written[0]), (&right, written[1])].map(|(side, written)| in_words(builder, side, written, &plain));
    let said = format!("{} {} {}", words[0], than(relation), words[1]);
    let mut quantities = left.symbols();
    quantities.extend(right.symbols());
    let is_direction = |symbol: &Symbol| matches!(builder.name(*symbol).kind, QuantityKind::Direction(_));
    let is_of_directions =
        matches!(relation, Relation::Equals | Relation::Differs) && quantities.iter().any(is_direction);
    let quantities = to_solve(loaded, builder, quantities);
    Some((said, Claim { left, relation, right, words, is_of_directions, quantities }))
}

/// In which order some quantities are.
pub(crate) fn order(ask: &Order, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let path = path.key("order");
    if !(2..=MOST_ORDERED).contains(&ask.order.len()) {
        let fault = Fault::new(Code::Value, format!("{} quantities cannot be put in order", ask.order.len()));
        builder.fault(fault.help(format!("name two to {MOST_ORDERED} quantities")).at_path(path));
        return None;
    }
    let mut symbols: Vec<Symbol> = Vec::new();
    for (index, name) in ask.order.iter().enumerate() {
        let path = path.index(index);
        let Some(symbol) = builder.mention(name) else {
            let fault = builder.unknown(name).at_path(path);
            builder.fault(fault);
            return None;
        };
        if symbols.contains(&symbol) {
            let fault = Fault::new(Code::Duplicate, format!("`{name}` is listed twice"));
            builder.fault(fault.help("name each quantity once").at_path(path));
            return None;
        }
        let dimension = |symbol: Symbol| builder.symbols().entry(symbol).dimension;
        if let Some(first) = symbols.first().copied().filter(|first| dimension(*first) != dimension(symbol)) {
            let [one, other] = [first, symbol].map(|symbol| dimension_name(dimension(symbol)));
            let fault = Fault::new(Code::Dimension, format!("`{name}` is {other}, `{}` is {one}", ask.order[0]));
            builder.fault(fault.help("only quantities of the same kind can be put in order").at_path(path));
            return None;
        }
        symbols.push(symbol);
    }
    let label = "In which order are these, from the least to the greatest?".to_owned();
    Some((label, PartKind::Choice(ChoicePart::Order(symbols))))
}

/// A side of a comparison as a noun phrase: the meaning of a quantity, a value as the author wrote it, or a formula as it is set there.
pub(crate) fn in_words(builder: &Builder<'_>, side: &Expr, written: &str, set: &dyn Fn(&Expr) -> String) -> String {
    match side {
        Expr::Symbol(symbol) if !builder.symbols().entry(*symbol).meaning.is_empty() => {
            builder.symbols().entry(*symbol).meaning.clone()
        }
        _ if side.symbols().iter().any(|symbol| builder.is_literal(*symbol)) => written.trim().to_owned(),
        other => set(other),
    }
}

/// A formula in the names of its quantities.
pub(crate) fn laid_out(builder: &Builder<'_>, side: &Expr) -> Math {
    side.layout(&|symbol| Leaf { math: name_math(&builder.symbols().entry(symbol).name), kind: LeafKind::Name })
}
