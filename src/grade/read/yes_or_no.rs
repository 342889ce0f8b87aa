//! Yes and no.

const YES: [&str; 4] = ["yes", "y", "true", "t"];
const NO: [&str; 4] = ["no", "n", "false", "f"];

/// Yes or no.
pub(super) fn answer_of(word: &str) -> Option<bool> {
    if YES.contains(&word) { Some(true) } else { NO.contains(&word).then_some(false) }
}

/// The letters and digits at the start.
pub(super) fn first_word(text: &str) -> &str {
    text.split(|next: char| !next.is_alphanumeric()).next().unwrap_or(text)
}
