//! Phrases that name a direction: `to the left`, `upwards`.

/// Words that say a direction, without their endings: `leftwards` as `left`.
const DIRECTIONS: [&str; 16] = [
    "left", "right", "up", "down", "north", "south", "east", "west", "for", "back", "out", "in", "away", "to",
    "uphill", "downhill",
];
/// Those of them that say one only with the ending, or with a word behind them.
const WITH_ENDING: [&str; 4] = ["for", "out", "in", "to"];
/// Whether a phrase names a direction.
pub(crate) fn says_direction(phrase: &str) -> bool {
    phrase.to_lowercase().split([' ', ',', '-', '(', ')']).any(|word| {
        let word = word.trim_matches('.');
        let stem = word.trim_end_matches('s').trim_end_matches("ward");
        let is_ended = stem.len() < word.trim_end_matches('s').len();
        let is_direction = DIRECTIONS.contains(&stem) || DIRECTIONS.contains(&word);
        matches!(word, "positive" | "negative") || is_direction && (is_ended || !WITH_ENDING.contains(&stem))
    })
}
