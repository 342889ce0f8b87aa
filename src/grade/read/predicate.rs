//! Yes and no in the words of the question: `conserved`, `it is not impulsive`, `momentum is conserved`.

use super::answer::ChoiceAnswer;
use super::yes_or_no::{answer_of, first_word};

/// Predicates, each with the words of a question that asks about it.
const PREDICATES: [(&str, &[&str]); 5] = [
    ("conserved", &["conserved", "same"]),
    ("unchanged", &["conserved", "same"]),
    ("same", &["same"]),
    ("impulsive", &["impulsive"]),
    ("constant", &["constant"]),
];
/// Words that say nothing beside a predicate. Alone, a pronoun and a verb agree.
const PRONOUNS: [&str; 5] = ["it", "they", "this", "that", "the"];
const VERBS: [&str; 12] = ["is", "are", "was", "were", "does", "do", "did", "will", "can", "has", "stays", "remains"];
/// Words that deny.
const DENYING: [&str; 2] = ["not", "never"];
/// The end of a verb that denies: `isn't`.
const DENYING_END: &str = "n't";

/// Yes or no, where a question is answered in its own words. Any other word is asked back.
pub(super) fn in_its_words(written: &str, question: &str, options: &[String]) -> Option<ChoiceAnswer> {
    let asked: Vec<&str> = words(question).collect();
    // `No, it isn't` says it twice.
    let first = answer_of(first_word(written)).filter(|_| first_word(written).len() > 1);
    let written = if first.is_some() { &written[first_word(written).len()..] } else { written };
    let (mut denied, mut predicate, mut verb, mut other) = (0, false, false, false);
    for word in words(written) {
        let plain = word.strip_suffix(DENYING_END).unwrap_or(word);
        denied += usize::from(plain.len() < word.len() || DENYING.contains(&word));
        match word {
            _ if plain.len() < word.len() || VERBS.contains(&word) => verb = true,
            _ if DENYING.contains(&word) || PRONOUNS.contains(&word) => {}
            _ if PREDICATES.iter().any(|(said, by)| *said == word && by.iter().any(|by| asked.contains(by))) => {
                predicate = true;
            }
            _ if asked.contains(&word) => other = true,
            _ => return None,
        }
    }
    let begins_with_verb = asked.first().is_some_and(|first| VERBS.contains(first));
    let says = predicate || verb && !other && words(written).any(|word| PRONOUNS.contains(&word));
    let is_doubtful = denied > 1 || asked.iter().any(|word| DENYING.contains(word) || *word == "no");
    if !says || !begins_with_verb || is_doubtful || first.is_some_and(|first| first != (denied == 0)) {
        return None;
    }
    let holds = |option: &String| answer_of(first_word(&option.to_lowercase())) == Some(denied == 0);
    let mut matching = options.iter().enumerate().filter(|(_, option)| holds(option));
    match (matching.next(), matching.next()) {
        (Some((option, text)), None) => Some(ChoiceAnswer { option, text: text.clone() }),
        _ => None,
    }
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|next: char| !next.is_alphanumeric() && next != '\'').filter(|word| !word.is_empty())
}
