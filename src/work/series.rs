//! Sums that go on for ever: `h + 2 e^2 h + 2 e^4 h + ...`, a geometric series from some term on.

use momentous_expr::Expr;

/// The sign that stands for the terms that are not written.
pub(crate) const DOTS: char = '…';
/// The number of terms needed to see how a series goes on.
const FEWEST_TERMS: usize = 3;

/// A series as it stands in a side: what stands before it, its written terms with their signs, and what stands behind it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct WrittenSeries {
    /// The text before it.
    pub(crate) before: String,
    /// Its terms, each with its sign.
    pub(crate) terms: Vec<String>,
    /// The text behind it.
    pub(crate) behind: String,
}

/// The first series of a side; nothing where no sum ends in dots.
pub(crate) fn first(side: &str) -> Option<WrittenSeries> {
    let dots = side.find(DOTS)?;
    let behind = side[dots + DOTS.len_utf8()..].trim_start();
    if !(behind.is_empty() || behind.starts_with([')', ']', '}'])) {
        return None;
    }
    let written = side[..dots].trim_end();
    let written = written.strip_suffix(['+', '-', '−'])?;
    // The sum begins behind the bracket that is still open.
    let mut depth = 0_usize;
    let open = written.char_indices().rev().find(|(_, sign)| match sign {
        ')' | ']' | '}' => {
            depth += 1;
            false
        }
        '(' | '[' | '{' if depth == 0 => true,
        '(' | '[' | '{' => {
            depth -= 1;
            false
        }
        _ => false,
    });
    let start = open.map_or(0, |(at, sign)| at + sign.len_utf8());
    let terms = terms(&written[start..]);
    (terms.len() >= FEWEST_TERMS).then(|| WrittenSeries {
        before: written[..start].to_owned(),
        terms,
        behind: behind.to_owned(),
    })
}

/// The terms of a sum, each with its sign.
pub(crate) fn terms(sum: &str) -> Vec<String> {
    let (mut terms, mut depth) = (vec![String::new()], 0_i32);
    for sign in sum.chars() {
        match sign {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            '+' | '-' | '−' if depth == 0 && terms.last().is_some_and(|so_far| !so_far.trim().is_empty()) => {
                terms.push(String::new());
            }
            _ => {}
        }
        if let Some(last) = terms.last_mut() {
            last.push(sign);
        }
    }
    terms
}

/// The value of a series whose terms have a constant ratio, where it has one. The first term may stand apart, as the first fall of a
/// bouncing ball does.
pub(crate) fn value(terms: &[Expr]) -> Option<Expr> {
    let [first, .., middle, last] = terms else { return None };
    let ratio = (last.clone() / middle.clone()).simplify();
    let regular = terms.get(1..)?;
    let is_regular = regular.windows(2).all(|pair| match pair {
        [one, next] => Expr::sum([next.clone(), -(one.clone() * ratio.clone())]).simplify().is_zero(),
        _ => false,
    });
    let rest = regular.first()?.clone() / Expr::sum([Expr::one(), -ratio]);
    is_regular.then(|| Expr::sum([first.clone(), rest]))
}

#[cfg(test)]
mod tests {
    use super::{WrittenSeries, first};

    #[test]
    fn a_series_is_taken_apart() {
        let series = |before: &str, terms: [&str; 3], behind: &str| WrittenSeries {
            before: before.to_owned(),
            terms: terms.map(str::to_owned).to_vec(),
            behind: behind.to_owned(),
        };
        assert_eq!(first("h + 2 e^2 h + 2 e^4 h + …"), Some(series("", ["h ", "+ 2 e^2 h ", "+ 2 e^4 h "], "")));
        assert_eq!(first("t_1 (1 + 2 e + 2 e^2 + …) "), Some(series("t_1 (", ["1 ", "+ 2 e ", "+ 2 e^2 "], ") ")));
        assert_eq!(first("h + 2 e^2 h"), None);
        assert_eq!(first("1 + e + … + e^n"), None);
    }
}
