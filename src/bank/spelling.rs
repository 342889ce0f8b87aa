//! Texts as plain words, so that a search compares them however they are spelt.

/// How words begin that the bank spells in another way.
const SPELLINGS: [(&str, &str); 4] =
    [("center", "centre"), ("meter", "metre"), ("gray", "grey"), ("practic", "practis")];

/// A text as its words, in small letters, without signs, spelt as the bank spells them: `Newton's cradle` as `newtons cradle`.
pub(super) fn plain(text: &str) -> String {
    let without: String = text
        .chars()
        .filter(|letter| !['\'', '\u{2019}'].contains(letter))
        .map(|letter| if letter.is_alphanumeric() { letter } else { ' ' })
        .flat_map(char::to_lowercase)
        .collect();
    let spelt = |word: &str| {
        let spelling = SPELLINGS
            .iter()
            .find_map(|(other, spelling)| word.strip_prefix(other).map(|ending| format!("{spelling}{ending}")));
        spelling.unwrap_or_else(|| word.to_owned())
    };
    without.split_whitespace().map(spelt).collect::<Vec<_>>().join(" ")
}
