//! Products of vectors, `r × m v`, as their components.

use super::series::terms;

/// A side along an axis, where it is one vector.
type Part<'a> = dyn Fn(&str, usize) -> Option<String> + 'a;

/// Signs of the product.
const SIGNS: [&str; 2] = ["\\times", "×"];

/// A side with its products of two vectors along an axis, counted from the first; in a plane, across it. Nothing where it has none.
pub(crate) fn along(side: &str, part: &Part<'_>, axis: Option<usize>) -> Option<String> {
    let mut is_product = false;
    let parts: Vec<String> = terms(side)
        .iter()
        .map(|term| {
            let product = product(term, part, axis);
            is_product |= product.is_some();
            product.unwrap_or_else(|| term.clone())
        })
        .collect();
    is_product.then(|| parts.concat())
}

/// A term that is a product of two vectors.
fn product(term: &str, part: &Part<'_>, axis: Option<usize>) -> Option<String> {
    let (left, right) = SIGNS.iter().find_map(|sign| term.split_once(sign))?;
    let sign_end = left.len() - left.trim_start_matches(['+', '-', '−', ' ']).len();
    let (sign, left) = left.split_at(sign_end);
    let [one, other] = match axis {
        Some(axis) => [(axis + 1) % 3, (axis + 2) % 3],
        None => [0, 1],
    };
    let part = |side: &str, axis: usize| part(side, axis).map(|part| format!("({part})"));
    let (a, b, c, d) = (part(left, one)?, part(right, other)?, part(left, other)?, part(right, one)?);
    Some(format!("{sign}({a}*{b} - {c}*{d})"))
}
