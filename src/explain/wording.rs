//! Small matters of English.

use super::Inline;

/// The text with its first letter as a capital, and all others as they are.
#[must_use]
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str())
}

/// A list of runs of text and mathematics: `a`, `a and b`, `a, b and c`.
pub(super) fn join(items: Vec<Vec<Inline>>) -> Vec<Inline> {
    let count = items.len();
    let mut joined = Vec::new();
    for (index, item) in items.into_iter().enumerate() {
        if index > 0 {
            joined.push(Inline::Text(if index + 1 == count { " and ".into() } else { ", ".into() }));
        }
        joined.extend(item);
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_letter_is_a_capital() {
        assert_eq!(capitalised("éclair"), "Éclair");
    }
}
