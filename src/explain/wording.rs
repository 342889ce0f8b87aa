//! Small matters of English.

use super::Inline;

/// The text with its first letter as a capital, and all others as they are.
#[must_use]
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str())
}

/// `a`, `a and b`, `a, b and c`.
pub(super) fn list(items: &[String]) -> String {
    match items {
        [] => String::new(),
        [only] => only.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// The same for runs of text and mathematics.
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
    fn lists_read_as_english() {
        let items = |count: usize| ["a", "b", "c"][..count].iter().map(|item| (*item).to_owned()).collect::<Vec<_>>();
        assert_eq!([1, 2, 3].map(|count| list(&items(count))), ["a", "a and b", "a, b and c"]);
        assert_eq!(capitalised("éclair"), "Éclair");
    }
}
