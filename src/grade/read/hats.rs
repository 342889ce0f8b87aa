//! Unit vectors as they are typed without their hats, and brackets round the terms of a vector. Each text stays as long as it was.

use super::unit_vectors::unit_vectors;

/// The letters of the axes, and the two bytes that are read for each.
const LETTERS: [(char, &str); 6] = [('i', "î"), ('j', "ĵ"), ('k', "k "), ('x', "î"), ('y', "ĵ"), ('z', "k ")];
/// The texts typed for a hat, the longer first.
const HATS: [&str; 9] = ["_hat", "-hat", " hat", "hat", "-cap", " cap", "_cap", "cap", "^"];
/// The factor -1, as it stands before brackets.
const MINUS_ONE: [&str; 4] = ["(-1)", "[-1]", "(-1.0)", "-1"];
/// Unit vectors that are named by their axes.
const NAMED: [(&str, &str); 6] =
    [("e_{x}", "î"), ("e_{y}", "ĵ"), ("e_{z}", "k "), ("e_x", "î"), ("e_y", "ĵ"), ("e_z", "k ")];
/// Brackets that may stand round a term.
const BRACKETS: [(char, char); 2] = [('(', ')'), ('[', ']')];

/// The text with a hat where one is spelt: `ihat`, `x_hat`, `i^`.
pub(super) fn put_on(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(next) = rest.chars().next() {
        let before = plain.chars().next_back().unwrap_or(' ');
        let read =
            LETTERS.iter().find(|(letter, _)| *letter == next).filter(|_| !before.is_alphabetic() && before != '_');
        let hatted = read.and_then(|(_, vector)| Some((vector, hat(&rest[1..])?)));
        let named = NAMED.iter().find(|(name, _)| rest.starts_with(name) && !before.is_alphanumeric());
        let ends = |name: &str| !rest[name.len()..].starts_with(|next: char| next.is_alphanumeric());
        if let Some((name, vector)) = named.filter(|(name, _)| ends(name)) {
            plain.push_str(vector);
            plain.extend(std::iter::repeat_n(' ', name.len() - vector.len()));
            rest = &rest[name.len()..];
            continue;
        }
        let taken = match hatted {
            Some((vector, hat)) => {
                plain.push_str(vector);
                plain.extend(std::iter::repeat_n(' ', 1 + hat - vector.len()));
                1 + hat
            }
            None => {
                plain.push(next);
                next.len_utf8()
            }
        };
        rest = &rest[taken..];
    }
    plain
}

/// How long the hat is that is spelt here.
fn hat(rest: &str) -> Option<usize> {
    let hat = HATS.iter().find(|hat| rest.starts_with(**hat))?;
    let behind = rest[hat.len()..].chars().next();
    // `x^2` and `x^-1` are powers; behind `i^ + 8 j^` no number follows the sign but that of the next term.
    let is_power = || {
        let behind = rest[hat.len()..].trim_start_matches(['+', '-', '{', '(']);
        let digits = behind.trim_start_matches(|next: char| next.is_ascii_digit() || next == '.');
        digits.len() < behind.len()
            && !digits.trim_start().starts_with(|next| LETTERS.iter().any(|letter| letter.0 == next))
    };
    let ends = !behind.is_some_and(char::is_alphanumeric);
    (ends && (*hat != "^" || !is_power())).then_some(hat.len())
}

/// The text without brackets round its terms: `-i+(8j)`, `(-1i)+(8j)`, `-(i - 8j)`. Brackets round the whole stay, and so do those
/// round numbers and units.
pub(super) fn without_brackets(text: &str) -> String {
    let text = &with_sign_for_factor(text);
    let mut bytes = text.as_bytes().to_vec();
    let groups = groups(text);
    let is_whole = |from: usize, to: usize| {
        groups.len() == 1 && text[..from].trim().is_empty() && unit_vectors(&text[to + 1..]).is_empty()
    };
    for (from, to) in &groups {
        let inside = &text[from + 1..*to];
        let vectors = unit_vectors(inside).len();
        let is_negated = text[..*from].trim_end().ends_with('-');
        let unwraps = vectors == 1 && !is_whole(*from, *to) || vectors > 1 && is_negated;
        if !unwraps || inside.contains([',', ';', '(', '[']) {
            continue;
        }
        (bytes[*from], bytes[*to]) = (b' ', b' ');
        let lead = from + 1 + inside.len() - inside.trim_start().len();
        let sign = text[..*from].trim_end().len().checked_sub(1).filter(|at| b"+-".contains(&bytes[*at]));
        // Two signs are one.
        if let (Some(sign @ (b'+' | b'-')), Some(at)) = (bytes.get(lead).copied(), sign) {
            bytes[at] = if sign == bytes[at] { b'+' } else { b'-' };
            bytes[lead] = b' ';
        }
        if vectors > 1 {
            let later = inside.char_indices().filter(|(at, next)| *at > lead - from - 1 && "+-".contains(*next));
            for at in later.map(|(at, _)| from + 1 + at) {
                bytes[at] = if bytes[at] == b'-' { b'+' } else { b'-' };
            }
        }
    }
    String::from_utf8(bytes).unwrap_or_else(|_| text.to_owned())
}

/// A sign for the factor -1 before brackets: `(-1)(i - 8j)`.
fn with_sign_for_factor(text: &str) -> String {
    let group = groups(text).into_iter().find_map(|(from, to)| {
        let before = text[..from].trim_end_matches([' ', '*', '·', '×']);
        let rest = MINUS_ONE.iter().find_map(|factor| before.strip_suffix(factor))?;
        let is_factor = !rest.ends_with(|last: char| last.is_alphanumeric() || ".)".contains(last));
        (is_factor && unit_vectors(&text[from..=to]).len() > 1).then_some((rest.len(), from))
    });
    match group {
        Some((start, from)) => format!("{}-{}{}", &text[..start], " ".repeat(from - start - 1), &text[from..]),
        None => text.to_owned(),
    }
}

/// The brackets that stand in no others, where they open and close.
fn groups(text: &str) -> Vec<(usize, usize)> {
    let mut groups = Vec::new();
    let mut open: Option<(usize, char)> = None;
    for (at, next) in text.char_indices() {
        match open {
            None => open = BRACKETS.iter().find(|(first, _)| *first == next).map(|(_, last)| (at, *last)),
            Some((from, last)) if next == last => {
                groups.push((from, at));
                open = None;
            }
            Some(_) => {}
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hats_are_put_on_and_powers_stay() {
        for (typed, plain) in [
            ("-xhat+8yhat N s", "-î  +8ĵ   N s"),
            ("-1 i-hat + 8 j hat", "-1 î    + 8 ĵ   "),
            ("-i^+8j^ N s", "-î+8ĵ N s"),
            ("2 x^2", "2 x^2"),
            ("1.7 e_x - 1.4 e_y m/s", "1.7 î  - 1.4 ĵ  m/s"),
            ("that", "that"),
        ] {
            assert_eq!(put_on(typed), plain);
            assert_eq!(put_on(typed).len(), typed.len());
        }
    }

    #[test]
    fn brackets_round_terms_are_taken_off_with_their_signs() {
        for (typed, plain) in [
            ("-i+(8j) N s", "-i+ 8j  N s"),
            ("(-i)-(-8j)", " -i + 8j "),
            ("-(i-8j)", "- i+8j "),
            ("-(-i-8j)", "+  i+8j "),
            ("(-1)(i - 8j) N s", "-i+8j N s"),
            ("-1*(i - 8j) N s", "-i+8j N s"),
            ("(1.5i - 2j) m/s", "(1.5i - 2j) m/s"),
            ("(1.5 N s)i", "(1.5 N s)i"),
        ] {
            assert_eq!(
                without_brackets(typed).split_whitespace().collect::<String>(),
                plain.split_whitespace().collect::<String>()
            );
        }
    }
}
