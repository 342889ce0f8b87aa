//! Lines that say which direction counts as positive.

use std::collections::BTreeSet;

use super::judge::Judge;
use super::phrases::says_direction;

/// Words that tell no direction.
const LITTLE_WORDS: [&str; 5] = ["from", "to", "the", "of", "a"];

/// Words that say where an axis goes.
const AXIS_WORDS: [&str; 5] = ["axis", "points", "pointing", "goes", "runs"];

impl Judge<'_> {
    /// Takes a line such as `take left as positive`; whether it was one.
    pub(crate) fn turn(&mut self, text: &str) -> bool {
        let line = words(text);
        let end = text.trim_end_matches([' ', '.', ')']);
        // `left = +` compares nothing.
        let sides = end.trim_end_matches(['+', '-', '−']).trim_end().trim_end_matches('=');
        let has = |signs: [&str; 2]| line.contains(signs[0]) || text.contains(signs[1]);
        let is_axis = line.contains("x") && AXIS_WORDS.iter().any(|word| line.contains(*word));
        let is_positive = has(["positive", "+ve"]) || end.ends_with('+');
        let is_negative = !is_positive && (has(["negative", "-ve"]) || end.ends_with(['-', '−']));
        if !is_positive && !is_negative && !is_axis || sides.contains(['=', '<', '>']) {
            return false;
        }
        let model = self.worked.problem.model();
        let (mut turned, mut is_said) = (Vec::new(), false);
        for (symbol, _) in model.symbols.iter() {
            let Some(senses) = self.worked.problem.turns_with(symbol) else { continue };
            if let Some(direction) = named(&line, &senses.positive, &senses.negative) {
                is_said = true;
                turned.extend(((direction == Named::Positive) == is_negative).then_some(symbol));
            }
        }
        if is_said {
            self.turned = turned;
        }
        is_said
    }

    /// The question about a line that takes a direction as positive that is none of the scene's axis; `None` where there is none.
    pub(crate) fn unclear_convention(&self, text: &str) -> Option<String> {
        let line = words(text);
        let is_convention =
            ["positive", "negative"].iter().any(|sign| line.contains(*sign)) && !text.contains(['=', '<', '>']);
        if !is_convention || !says_direction(text) {
            return None;
        }
        let model = self.worked.problem.model();
        let senses = model.symbols.iter().find_map(|(symbol, _)| self.worked.problem.turns_with(symbol))?;
        Some(format!("which way is that here: {} or {}?", senses.positive, senses.negative))
    }
}

/// The direction that a line takes as positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Named {
    /// That of the axis.
    Positive,
    /// The other one.
    Negative,
}

/// The words of a text, `leftwards` as `left`.
pub(crate) fn words(text: &str) -> BTreeSet<String> {
    let text = text.to_lowercase();
    let words = text.split(|letter: char| !letter.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(|word| word.trim_end_matches("wards").trim_end_matches("ward").to_owned()).collect()
}

/// Which of two directions a line names, by the words in which they differ: of `along the rail` and `back along the rail` the one or the
/// other, as `back` stands in it.
pub(crate) fn named(line: &BTreeSet<String>, positive: &str, negative: &str) -> Option<Named> {
    let phrases = [positive, negative].map(words);
    let names = |this: usize| {
        let differing: Vec<&String> = phrases[this].difference(&phrases[1 - this]).collect();
        let telling: Vec<&&String> = differing.iter().filter(|word| !LITTLE_WORDS.contains(&word.as_str())).collect();
        if telling.is_empty() {
            phrases[this].is_subset(line)
        } else {
            telling.iter().any(|word| line.contains(**word))
        }
    };
    let is_longer = phrases[0].is_subset(&phrases[1]);
    match (names(0), names(1)) {
        (true, false) => Some(Named::Positive),
        (false, true) => Some(Named::Negative),
        (true, true) => is_longer.then_some(Named::Negative),
        (false, false) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_told_apart_by_the_words_in_which_they_differ() {
        let cases = [
            ("take left as positive", "to the right", "to the left", Some(Named::Negative)),
            ("right is positive", "to the right", "to the left", Some(Named::Positive)),
            ("downwards positive", "upwards", "downwards", Some(Named::Negative)),
            ("positive away from the net", "towards the net", "away from the net", Some(Named::Negative)),
            ("positive towards the net", "towards the net", "away from the net", Some(Named::Positive)),
            ("take back along the rail as positive", "along the rail", "back along the rail", Some(Named::Negative)),
            ("take along the rail as positive", "along the rail", "back along the rail", Some(Named::Positive)),
            ("left and right are positive", "to the right", "to the left", None),
            ("north is positive", "to the right", "to the left", None),
        ];
        for (line, positive, negative, direction) in cases {
            assert_eq!(named(&words(line), positive, negative), direction, "{line}");
        }
    }
}
