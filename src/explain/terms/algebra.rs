//! Terms as a student writes them.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_quantity::Rational;

/// The sides of an equation, with all signs changed where both begin with a minus.
pub(crate) fn without_common_minus(left: &Expr, right: &Expr) -> [Expr; 2] {
    let both = left.begins_with_minus() && right.begins_with_minus();
    let turns = both && !matches!(right, Expr::Sum(_)) && !matches!(left, Expr::Sum(_));
    [left, right].map(|side| if turns { (-side.clone()).simplify() } else { side.clone() })
}

/// The term with every sum led by a positive part, where it has one: `b - a` for `-a + b`.
pub(crate) fn positive_first(expr: &Expr) -> Expr {
    match expr {
        Expr::Sum(_) => led_by_positive(expr),
        _ => without_outer_minus(led_by_positive(expr)),
    }
}

/// The same for a part of a sum, which keeps its sign: in `m v - e (a - b)` the difference is that of a law.
fn led_by_positive(expr: &Expr) -> Expr {
    let Expr::Sum(parts) = expr else { return expr.map_children(positive_first) };
    let mut parts: Vec<Expr> = parts.iter().map(led_by_positive).collect();
    let leads = parts.iter().position(|part| !part.begins_with_minus());
    if let Some(lead) = leads.filter(|lead| *lead > 0) {
        parts[..=lead].rotate_right(1);
    }
    Expr::sum(parts)
}

/// `(b - a)/c` for `-(a - b)/c`, and `c/(a + b)` for `-c/(-a - b)`.
fn without_outer_minus(expr: Expr) -> Expr {
    let Expr::Product(factors) = &expr else { return expr };
    let mut factors = factors.to_vec();
    let negative = factors.first().and_then(Expr::as_number).is_some_and(|number| *number < Rational::ZERO);
    let turns = factors.iter().enumerate().find_map(|(place, factor)| Some((place, turned(factor)?)));
    let (true, Some((place, turned))) = (negative, turns) else { return expr };
    factors[place] = turned;
    factors[0] = (-factors[0].clone()).simplify();
    Expr::product(factors)
}

/// A factor with the opposite sign, where it reads better so.
fn turned(factor: &Expr) -> Option<Expr> {
    let opposite = |parts: &[Expr]| positive_first(&Expr::sum(parts.iter().map(|part| -part.clone())));
    match factor {
        Expr::Sum(parts) => parts.iter().skip(1).any(Expr::begins_with_minus).then(|| opposite(parts)),
        Expr::Power(pair) => match (&pair.0, pair.1.as_number()) {
            (Expr::Sum(parts), Some(exponent)) if *exponent == Rational::NEG_ONE => {
                parts.iter().all(Expr::begins_with_minus).then(|| opposite(parts).power(pair.1.clone()))
            }
            _ => None,
        },
        _ => None,
    }
}

/// Whether a term holds the angle of a point.
pub(super) fn has_angle_of_point(expr: &Expr) -> bool {
    matches!(expr, Expr::Apply(Function::Atan2, _)) || expr.children().any(has_angle_of_point)
}

/// Whether a term holds the angle of a point on the second axis.
pub(crate) fn divides_by_zero(term: &Expr) -> bool {
    let is_on_axis =
        matches!(term, Expr::Apply(Function::Atan2, _)) && term.children().nth(1).is_some_and(Expr::is_zero);
    is_on_axis || term.children().any(divides_by_zero)
}
