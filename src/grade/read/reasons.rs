//! A choice with its reason: `Yes - no external force`, `perfectly plastic (e = 0)`. The reason is made of words of a closed list, and
//! what would deny the choice is asked back.

use super::answer::ChoiceAnswer;
use super::yes_or_no::{answer_of, first_word};

/// Words of reasons.
const REASONS: [&str; 106] = [
    "a",
    "an",
    "the",
    "is",
    "are",
    "was",
    "it",
    "its",
    "there",
    "this",
    "that",
    "they",
    "so",
    "because",
    "since",
    "as",
    "by",
    "of",
    "on",
    "in",
    "to",
    "at",
    "from",
    "with",
    "and",
    "only",
    "all",
    "both",
    "very",
    "too",
    "much",
    "large",
    "small",
    "short",
    "big",
    "huge",
    "tiny",
    "external",
    "internal",
    "outer",
    "inner",
    "net",
    "resultant",
    "horizontal",
    "vertical",
    "horizontally",
    "vertically",
    "force",
    "forces",
    "impulse",
    "impulses",
    "impulsive",
    "momentum",
    "energy",
    "kinetic",
    "mechanical",
    "heat",
    "sound",
    "deformation",
    "friction",
    "gravity",
    "weight",
    "normal",
    "reaction",
    "tension",
    "moment",
    "torque",
    "some",
    "part",
    "becomes",
    "become",
    "goes",
    "into",
    "turns",
    "turned",
    "converted",
    "transformed",
    "lost",
    "loses",
    "dissipated",
    "absorbed",
    "gained",
    "conserved",
    "constant",
    "acts",
    "act",
    "acting",
    "pushes",
    "pulls",
    "push",
    "pull",
    "floor",
    "ground",
    "wall",
    "track",
    "table",
    "rail",
    "rails",
    "axle",
    "pivot",
    "support",
    "rope",
    "string",
    "system",
    "bodies",
    "time",
];
/// The word that denies; what there can be none of follows it.
const NO: &str = "no";
/// The things of which there can be none in a reason for yes.
const NONE_OF: [&str; 12] = [
    "external",
    "outer",
    "net",
    "resultant",
    "friction",
    "horizontal",
    "vertical",
    "force",
    "forces",
    "impulse",
    "impulses",
    "moment",
];
/// Coefficients of restitution in brackets, and the kind of impact that they say.
const COEFFICIENTS: [(&str, &str); 2] = [("e=0", "plastic"), ("e=1", "elastic")];

/// The option that is meant by an answer with its reason.
pub(super) fn with_reason(written: &str, options: &[String]) -> Option<ChoiceAnswer> {
    by_yes_or_no(written, options).or_else(|| with_coefficient(written, options))
}

fn by_yes_or_no(written: &str, options: &[String]) -> Option<ChoiceAnswer> {
    let first = first_word(written);
    let meant = answer_of(first).filter(|_| first.len() > 1)?;
    let words: Vec<&str> =
        written[first.len()..].split(|next: char| !next.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
    let is_reason = words.iter().enumerate().all(|(place, word)| {
        REASONS.contains(word) || *word == NO && words.get(place + 1).is_some_and(|next| NONE_OF.contains(next))
    });
    if words.is_empty() || !is_reason {
        return None;
    }
    only(options, |text| answer_of(first_word(text)) == Some(meant))
}

fn with_coefficient(written: &str, options: &[String]) -> Option<ChoiceAnswer> {
    let (kind, inside) = written.split_once('(')?;
    let inside: String = inside.chars().filter(|next| !next.is_whitespace() && *next != ')').collect();
    let (_, said) = COEFFICIENTS.iter().find(|(typed, _)| *typed == inside)?;
    let kind = kind.trim();
    (kind.split(' ').any(|word| word == *said)).then(|| only(options, |text| text == kind))?
}

/// The one option of which that holds.
fn only(options: &[String], holds: impl Fn(&str) -> bool) -> Option<ChoiceAnswer> {
    let mut matching = options.iter().enumerate().filter(|(_, text)| holds(&text.to_lowercase()));
    match (matching.next(), matching.next()) {
        (Some((option, text)), None) => Some(ChoiceAnswer { option, text: text.clone() }),
        _ => None,
    }
}
