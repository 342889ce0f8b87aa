//! Words that sentences about a scene share.

use std::borrow::Borrow;

/// The words for a list.
///
/// ```
/// use momentous_scene::list;
/// assert_eq!(list(&["the boat", "Ana", "Ben"]), "the boat, Ana and Ben");
/// assert_eq!(list(&["the boat"]), "the boat");
/// ```
#[must_use]
pub fn list<S: Borrow<str>>(items: &[S]) -> String {
    match items {
        [] => String::new(),
        [only] => only.borrow().to_owned(),
        [rest @ .., last] => format!("{} and {}", rest.join(", "), last.borrow()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_as_english() {
        let items = |count: usize| ["a", "b", "c"][..count].iter().map(|item| (*item).to_owned()).collect::<Vec<_>>();
        assert_eq!([1, 2, 3].map(|count| list(&items(count))), ["a", "a and b", "a, b and c"]);
    }
}
