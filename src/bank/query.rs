//! A search among problems: words with their relatives, however they are spelt.

use std::collections::BTreeSet;

use momentous_fault::did_you_mean;

use super::exhibit::Exhibit;
use super::relatives::RELATIVES;
use super::spelling::plain;

/// Words that say nothing of a problem.
const IDLE: [&str; 20] = [
    "a", "an", "the", "of", "in", "on", "at", "to", "for", "and", "or", "with", "about", "problem", "problems", "find",
    "what", "how", "is", "s",
];

/// Shorter words are not taken for others: `arc` may be meant.
const SHORTEST: usize = 4;

/// Queries: everything in one has to be found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Query {
    /// Each with those that may stand in its place.
    wanted: Vec<Vec<String>>,
    /// The words as they were taken, where that is not how they were typed.
    pub instead: Option<String>,
}

impl Query {
    /// Reads what was typed; a word that no problem has is taken for the nearest that one has.
    #[must_use]
    pub fn of(text: &str, exhibits: &[Exhibit]) -> Self {
        let typed = plain(text);
        let known: BTreeSet<&str> = exhibits
            .iter()
            .flat_map(|exhibit| exhibit.searched.split_whitespace())
            .chain(RELATIVES.iter().flat_map(|(phrases, _)| *phrases).flat_map(|phrase| phrase.split_whitespace()))
            .chain(IDLE)
            .collect();
        let is_known = |word: &str| known.range(word..).next().is_some_and(|range| range.starts_with(word));
        let meant = |word: &str| {
            let near = || did_you_mean(word, known.iter().copied().filter(|known| known.len() >= SHORTEST));
            let is_short = word.chars().count() < SHORTEST;
            if is_short || is_known(word) { word.to_owned() } else { near().unwrap_or(word).to_owned() }
        };
        let words: Vec<String> = typed.split_whitespace().map(meant).collect();
        let taken = words.join(" ");
        Self { wanted: wanted(&words), instead: (taken != typed).then_some(taken) }
    }

    /// Whether a problem is among those that are looked for.
    #[must_use]
    pub fn finds(&self, exhibit: &Exhibit) -> bool {
        let has = |phrase: &String| exhibit.searched.contains(&format!(" {phrase}"));
        self.wanted.iter().all(|relatives| relatives.iter().any(has))
    }
}

/// The phrases that the table knows, the longest first, and every other word by itself.
fn wanted(words: &[String]) -> Vec<Vec<String>> {
    let mut wanted = Vec::new();
    let mut at = 0;
    while let Some(word) = words.get(at) {
        let phrase = |(phrases, relatives): &(&'static [&'static str], &'static [&'static str])| {
            let length = |phrase: &&str| {
                let phrase: Vec<&str> = phrase.split_whitespace().collect();
                let is_here = phrase
                    .iter()
                    .enumerate()
                    .all(|(place, part)| words.get(at + place).is_some_and(|word| word == part));
                is_here.then_some(phrase.len())
            };
            phrases.iter().filter_map(length).max().map(|length| (length, *relatives))
        };
        match RELATIVES.iter().filter_map(phrase).max_by_key(|(length, _)| *length) {
            Some((length, relatives)) => {
                wanted.push(relatives.iter().map(|relative| (*relative).to_owned()).collect());
                at += length;
            }
            None => {
                wanted.extend((!IDLE.contains(&word.as_str())).then(|| vec![word.clone()]));
                at += 1;
            }
        }
    }
    wanted
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::{Bank, load_in_course};

    fn found(text: &str) -> (Vec<String>, Option<String>) {
        let exhibits: Vec<Exhibit> =
            Bank::built_in().sources().map(|source| Exhibit::of(&load_in_course(source.clone()).unwrap())).collect();
        let query = Query::of(text, &exhibits);
        let ids = exhibits.iter().filter(|exhibit| query.finds(exhibit)).map(|exhibit| exhibit.card.id.clone());
        (ids.collect(), query.instead)
    }

    #[test]
    fn problems_are_found_by_the_words_of_the_field_and_by_their_relatives() {
        for (text, one) in [
            ("coefficient of restitution", "impact/two-carts"),
            ("Elastic collision", "impact/three-gliders"),
            ("perfectly inelastic", "conservation/coupling-wagons"),
            ("inelastic", "impact/clay-on-trolley"),
            ("explosion", "conservation/firework-burst"),
            ("Center of mass", "mass-centre/three-boats"),
            ("newton's cradle", "impact/three-gliders"),
            ("variable mass", "streams/heavy-rocket"),
            ("torque", "angular-momentum/flywheel-run-up"),
            ("2D collision", "impact/hockey-pucks"),
        ] {
            let (ids, instead) = found(text);
            assert!(ids.iter().any(|id| id == one), "{text}: {ids:?}");
            assert_eq!(instead, None, "{text}");
            assert!(ids.len() < 80, "{text} finds {} problems", ids.len());
        }
    }

    #[test]
    fn a_word_that_no_problem_has_is_taken_for_the_nearest() {
        let (ids, instead) = found("resitution of two crats");
        assert!(ids.contains(&"impact/two-carts".to_owned()), "{ids:?}");
        assert_eq!(instead.as_deref(), Some("restitution of two carts"));
        assert_eq!(found("xylophone").0, Vec::<String>::new());
        assert_eq!(found("").0.len(), Bank::built_in().ids().count());
    }
}
