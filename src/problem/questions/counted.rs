//! Counting: the first or the last whole number for which a condition holds.

use momentous_expr::Expr;
use momentous_expr::name_math;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Because;
use momentous_model::Builder;
use momentous_quantity::Decimal;
use momentous_quantity::Tolerance;
use momentous_quantity::Unit;
use momentous_solve::Equation;
use momentous_solve::Relation;

use super::super::language::ask::Count;
use super::super::language::comparison::split_relation;
use super::super::language::condition::are_comparable;
use super::choices::comparing::in_words;
use super::choices::comparing::laid_out;
use super::choices::comparing::than;
use super::part::AskedUnit;
use super::part::Named;
use super::part::NumberPart;
use super::part::PartKind;

/// Which number is counted: the first for which a condition holds, or the last as long as it holds.
enum End {
    First,
    Last,
}

/// Reads `first n with h_n < h_min`, `last n with x_n < d`.
pub(crate) fn counted(
    count: &Count,
    builder: &mut Builder<'_>,
    path: &Path,
    counts: &mut Vec<Equation>,
) -> Option<Named> {
    let path = path.key("count");
    let text = count.count.trim();
    let ends = [("first ", End::First), ("last ", End::Last)];
    let end = ends.into_iter().find_map(|(word, end)| Some((end, text.strip_prefix(word)?.split_once(" with ")?)));
    let parts = end.and_then(|(end, (name, condition))| Some((end, name.trim(), split_relation(condition)?)));
    let parts = parts.filter(|(_, _, (_, relation, _))| *relation != Relation::Equals);
    let Some((end, name, (left, relation, right))) = parts else {
        let fault = Fault::new(Code::Syntax, format!("`{}` does not say what is counted", count.count));
        let help = "write it as `first n with h_n < h_min`, or `last n with x_n < d`";
        builder.fault(fault.help(help).at_path(path));
        return None;
    };
    let Some(symbol) = builder.mention(name).or_else(|| builder.number_counted(name)) else {
        let fault = builder.unknown(name).at_path(path);
        builder.fault(fault);
        return None;
    };
    let written = [left, right].map(str::trim);
    let [left, right] = written.map(|side| builder.term(side, &path));
    if !are_comparable(builder, text, [&left, &right], &path) {
        return None;
    }
    let set = |side: &Expr| format!("${}$", laid_out(builder, side).latex());
    let words =
        [(&left, written[0]), (&right, written[1])].map(|(side, written)| in_words(builder, side, written, &set));
    let condition = format!("{} is {} {}", words[0], than(relation), words[1]);
    let because = [&left, &right].into_iter().find_map(|side| builder.reason_of(side, symbol)).map(Because::to_string);
    let [left, right] = [left, right].map(|side| builder.written_out(&side, symbol));
    let meaning = builder.symbols().entry(symbol).meaning.clone();
    let [until, as_long_as] = if meaning.is_empty() {
        ["least", "greatest"].map(|which| format!("the {which} whole number ${}$ for which", name_math(name).latex()))
    } else {
        ["until", "as long as"].map(|when| format!("{meaning} {when}"))
    };
    let label = match end {
        End::First => {
            counts.push(builder.first_integer(because.as_deref(), symbol, 1, left, relation, right));
            format!("{until} {condition}")
        }
        End::Last => {
            let next = |side: &Expr| {
                exponents_simplified(
                    &side.substitute(&|written| (written == symbol).then(|| Expr::from(symbol) + Expr::one())),
                )
            };
            let over =
                "the number sought is the last for which the condition holds, so the next one is the first to break it";
            let because = because.map_or_else(|| over.to_owned(), |because| format!("{because}; {over}"));
            let (left, right) = (next(&left), next(&right));
            counts.push(builder.first_integer(Some(&because), symbol, 0, left, relation.opposite(), right));
            format!("{as_long_as} {condition}")
        }
    };
    let kind = NumberPart {
        symbol,
        unit: AskedUnit::Unit(Unit::none()),
        size: 1.0,
        figures: 12,
        tolerance: Tolerance::Absolute(Decimal::from_scaled(0, 0)),
        whole: true,
        every_root: false,
    };
    Some((name.to_owned(), label, PartKind::Number(kind)))
}

/// `e^n` for `e^(n + 1 - 1)`.
fn exponents_simplified(term: &Expr) -> Expr {
    match term {
        Expr::Power(pair) => pair.0.clone().power(pair.1.simplify()),
        other => other.map_children(exponents_simplified),
    }
}
