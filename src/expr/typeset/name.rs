//! Names of quantities, typeset: `v_A1` as v with the subscript A1, `mu_s` with a Greek letter.

use std::sync::Arc;

use super::super::{Math, Operator};

/// Names that are typeset as letters of the Greek alphabet, or that the subject abbreviates.
const LETTERS: [(&str, &str); 28] = [
    ("alpha", "\u{3b1}"),
    ("beta", "\u{3b2}"),
    ("gamma", "\u{3b3}"),
    ("delta", "\u{3b4}"),
    ("epsilon", "\u{3b5}"),
    ("zeta", "\u{3b6}"),
    ("eta", "\u{3b7}"),
    ("theta", "\u{3b8}"),
    ("kappa", "\u{3ba}"),
    ("lambda", "\u{3bb}"),
    ("mu", "\u{3bc}"),
    ("nu", "\u{3bd}"),
    ("rho", "\u{3c1}"),
    ("sigma", "\u{3c3}"),
    ("tau", "\u{3c4}"),
    ("phi", "\u{3c6}"),
    ("psi", "\u{3c8}"),
    ("omega", "\u{3c9}"),
    ("Omega", "\u{3a9}"),
    ("pi", "\u{3c0}"),
    ("speed", "v"),
    ("angle", "\u{3b8}"),
    ("flow", "q"),
    ("ecc", "\u{3b5}"),
    ("period", "T"),
    ("work", "U"),
    ("range", "R"),
    ("path", "s"),
];

/// The typeset form of a quantity's name. A stage in square brackets is shown for durations and terminal velocities only.
///
/// ```
/// use momentous_expr::name_math;
/// assert_eq!(name_math("v_A1.x").latex(), "(v_{A1})_{x}");
/// assert_eq!(name_math("mu_s").latex(), r"\mu_{s}");
/// assert_eq!(name_math("F_avg_A[hit]").latex(), r"F_{\text{avg},A}");
/// ```
#[must_use]
pub fn name_math(name: &str) -> Math {
    if let Some(inside) = name.strip_prefix("magnitude(").and_then(|name| name.strip_suffix(')')) {
        return Math::Bars(Arc::new(name_math(inside)));
    }
    if let Some((function, inside)) = name.strip_suffix(')').and_then(|name| name.split_once('(')) {
        let parts = inside.split(',').flat_map(|part| [Math::Operator(Operator::Comma), name_math(part.trim())]);
        let inside = Math::Row(parts.skip(1).collect());
        return Math::Row(vec![Math::Function(function.to_owned()), Math::Bracketed(Arc::new(inside))]);
    }
    // A direction along an axis.
    for (mark, operator) in [('+', Operator::Plus), ('-', Operator::Minus)] {
        if let Some(axis) = name.strip_prefix(mark) {
            return Math::Row(vec![Math::Operator(operator), base_math(axis)]);
        }
    }
    // The variable of an integral: `v_` is written as v.
    let name = name.strip_suffix('_').unwrap_or(name);
    // Several of them in one solution are told apart by their stages.
    for base in ["dt", "w"] {
        if let Some((quantity, stage)) = name.strip_suffix(']').and_then(|rest| rest.split_once('['))
            && quantity == base
        {
            return with_subscript(base_math(base), stage);
        }
    }
    let name = without_stage(name);
    let (name, instant) = split_mark(&name, '@');
    let (name, component) = split_mark(&name, '.');
    let rate = |quantity: Math| {
        let differential = |quantity: Math| Arc::new(Math::Row(vec![Math::Identifier("d".into()), quantity]));
        Math::Fraction(differential(quantity), differential(Math::Identifier("t".into())))
    };
    if name == "areal_rate" {
        return rate(Math::Identifier("A".into()));
    }
    let of_rate =
        ["H", "p"].into_iter().find_map(|letter| Some((letter, name.strip_prefix(letter)?.strip_prefix("_rate_")?)));
    if let Some((letter, rest)) = of_rate {
        let rate = rate(name_math(&format!("{letter}_{rest}")));
        return if component.is_empty() {
            rate
        } else {
            Math::Sub(Arc::new(Math::Bracketed(Arc::new(rate))), Arc::new(base_math(&component)))
        };
    }
    // A letter of its own would be that of kinetic energy.
    let name = match name.strip_prefix("tension") {
        Some(rest) if rest.is_empty() || rest.starts_with('_') => format!("F_T{rest}"),
        _ => name,
    };
    let (base, subscript) = name.split_once('_').unwrap_or((&name, ""));
    let parts: Vec<&str> = subscript.split('_').chain([instant.as_str()]).filter(|part| !part.is_empty()).collect();
    let whole = with_subscript(base_math(base), &parts.join(","));
    if component.is_empty() {
        return whole;
    }
    let whole = if parts.is_empty() { whole } else { Math::Bracketed(Arc::new(whole)) };
    Math::Sub(Arc::new(whole), Arc::new(base_math(&component)))
}

/// `dt` is a difference; its subscript, if any, belongs to the whole of it.
fn base_math(base: &str) -> Math {
    if let Some((_, letter)) = LETTERS.iter().find(|(spelt, _)| *spelt == base) {
        return Math::Identifier((*letter).to_owned());
    }
    match base {
        "dt" => Math::Row(vec![Math::Identifier("\u{394}".into()), Math::Identifier("t".into())]),
        short if short.chars().count() <= 1 => Math::Identifier(short.to_owned()),
        long => Math::Text(long.to_owned()),
    }
}

fn with_subscript(base: Math, subscript: &str) -> Math {
    if subscript.is_empty() {
        return base;
    }
    let subscript = Arc::new(Math::Text(subscript.to_owned()));
    match base {
        Math::Row(mut parts) => {
            let last = parts.pop().map(|last| Math::Sub(Arc::new(last), subscript));
            Math::Row(parts.into_iter().chain(last).collect())
        }
        base => Math::Sub(Arc::new(base), subscript),
    }
}

fn without_stage(name: &str) -> String {
    let stage = name.split_once('[').and_then(|(before, rest)| Some((before, rest.split_once(']')?.1)));
    stage.map_or_else(|| name.to_owned(), |(before, after)| format!("{before}{after}"))
}

/// The name without `mark` and the word after it, and that word.
fn split_mark(name: &str, mark: char) -> (String, String) {
    let Some((before, after)) = name.split_once(mark) else { return (name.to_owned(), String::new()) };
    let end = after.find(['@', '.', '[']).unwrap_or(after.len());
    let (word, rest) = after.split_at(end);
    (format!("{before}{rest}"), word.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_typeset_as_the_subject_does() {
        for (name, plain, latex) in [
            ("v_A1", "v_A1", "v_{A1}"),
            ("v_A1.x", "(v_A1)_x", "(v_{A1})_{x}"),
            ("v_S2.theta", "(v_S2)_\u{3b8}", r"(v_{S2})_{\theta}"),
            ("m_A", "m_A", "m_{A}"),
            ("speed_A1", "v_A1", "v_{A1}"),
            ("angle_A1", "\u{3b8}_A1", r"\theta_{A1}"),
            ("T_lost[hit]", "T_lost", r"T_{\text{lost}}"),
            ("J_A[hit]", "J_A", "J_{A}"),
            ("F_avg_A", "F_avg,A", r"F_{\text{avg},A}"),
            ("dt[hit]", "\u{394}t_hit", r"\Delta t_{\text{hit}}"),
            ("mu_s", "\u{3bc}_s", r"\mu_{s}"),
            ("omega_1", "\u{3c9}_1", r"\omega_{1}"),
            ("t_2", "t_2", "t_{2}"),
            ("v_A@top", "v_A,top", r"v_{A,\text{top}}"),
            ("v_bullet1", "v_bullet1", r"v_{\text{bullet}1}"),
            ("e", "e", "e"),
            ("tension", "F_T", "F_{T}"),
            ("tension_A1[pull]", "F_T,A1", r"F_{T,A1}"),
            ("areal_rate", "dA/(dt)", r"\frac{dA}{dt}"),
            ("magnitude(H_O1)", "|H_O1|", r"\lvert H_{O1}\rvert"),
            ("H_rate_O1", "dH_O1/(dt)", r"\frac{dH_{O1}}{dt}"),
            ("p_rate_1.x", "(dp_1/(dt))_x", r"\left(\frac{dp_{1}}{dt}\right)_{x}"),
            ("angle(v_A2, v_B2)", "angle(v_A2, v_B2)", r"\operatorname{angle}(v_{A2},\; v_{B2})"),
        ] {
            let math = name_math(name);
            assert_eq!((math.plain().as_str(), math.latex().as_str()), (plain, latex), "{name}");
        }
    }
}
