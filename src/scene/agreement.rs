//! Agreement in number: which names are plurals, and sentences in which what they name is the subject.

use crate::{Scene, Stage};

/// Words in which a name goes on behind its noun: `the wheel with the vanes`.
const BEHIND_A_NOUN: &[&str] =
    &["of", "with", "in", "on", "at", "from", "to", "that", "which", "who", "under", "behind", "off", "without"];
/// Nouns that end as plurals do.
const SINGULARS: &[&str] = &["gas", "lens", "atlas", "canvas", "series", "species", "biceps", "cosmos", "news"];
/// Plurals that do not end in s.
const PLURALS: &[&str] = &[
    "men",
    "women",
    "children",
    "people",
    "police",
    "feet",
    "geese",
    "mice",
    "oxen",
    "horsemen",
    "firemen",
    "policemen",
];
/// Verbs whose forms have nothing in common.
const IRREGULAR: &[[&str; 2]] = &[["is", "are"], ["was", "were"], ["has", "have"], ["does", "do"], ["goes", "go"]];
/// The other verbs of which a body is the subject in sentences of the program, as they stand behind a plural.
const VERBS: &[&str] = &[
    "act", "arrive", "ask", "become", "begin", "bounce", "break", "bring", "carry", "catch", "change", "come", "cover",
    "drag", "drive", "end", "exert", "expel", "fall", "fly", "follow", "gain", "get", "give", "hang", "hit", "hold",
    "join", "keep", "leave", "let", "lie", "lift", "lose", "meet", "move", "need", "pass", "press", "pull", "push",
    "reach", "rebound", "receive", "remain", "rest", "return", "reverse", "rise", "roll", "rub", "run", "sit", "slide",
    "spread", "stand", "start", "stay", "stick", "stop", "strike", "swing", "take", "throw", "touch", "transfer",
    "travel", "turn", "walk", "weigh",
];
/// Words between a subject and its verb.
const ADVERBS: &[&str] =
    &["then", "still", "already", "also", "only", "never", "always", "alone", "together", "both", "first", "no"];
/// Words behind which the subject may have a further verb.
const FURTHER: &[&str] = &["and", "or", "nor", "but"];
/// Words behind which a name is no subject.
const GOVERNING: &[&str] = &[
    "of", "on", "to", "against", "by", "with", "from", "in", "into", "between", "at", "about", "for", "over", "under",
    "behind", "than", "towards", "along", "beside", "through", "off", "like", "past", "round",
];

/// Whether a name is a plural: `the vanes`, `the men in the boat`, `Ana and Ben`.
///
/// ```
/// use momentous_scene::is_plural;
/// assert!(["the vanes", "two men", "the wagons of the train", "Ana and Ben"].iter().all(|name| is_plural(name)));
/// assert!(!["the glass", "the bus", "James", "the wheel with the vanes"].iter().any(|name| is_plural(name)));
/// ```
#[must_use]
pub fn is_plural(name: &str) -> bool {
    let noun: Vec<&str> = name.split(' ').take_while(|word| !BEHIND_A_NOUN.contains(word)).collect();
    let Some(last) = noun.last() else { return false };
    let ends_as_plurals = last.ends_with('s') && !["ss", "us", "is", "'s"].iter().any(|end| last.ends_with(end));
    let is_common = noun.len() > 1 && last.chars().all(char::is_lowercase);
    noun.contains(&"and") || PLURALS.contains(last) || is_common && ends_as_plurals && !SINGULARS.contains(last)
}

impl Scene {
    /// A sentence whose verbs agree with what is their subject: `the vanes are smooth and turn the jet`.
    #[must_use]
    pub fn in_agreement(&self, sentence: &str) -> String {
        self.plurals().fold(sentence.to_owned(), |sentence, name| with_plural(&sentence, name))
    }

    /// Whether a body has a plural as its name.
    #[must_use]
    pub fn is_several(&self, body: &str) -> bool {
        self.bodies.get(body).is_some_and(|entry| is_plural(&entry.name))
    }

    /// Whether anything has a plural as its name.
    #[must_use]
    pub fn has_plurals(&self) -> bool {
        self.plurals().next().is_some()
    }

    /// The names of bodies, and of what streams meet, that are plurals.
    fn plurals(&self) -> impl Iterator<Item = &str> {
        let bodies = self.bodies.values().map(|body| body.name.as_str());
        let streams = self
            .stages
            .iter()
            .filter_map(|stage| if let Stage::Stream(stream) = stage { Some(stream.by.as_str()) } else { None });
        bodies.chain(streams).filter(|name| is_plural(name))
    }
}

/// The sentence with plurals of the verbs of which `name` is the subject.
fn with_plural(sentence: &str, name: &str) -> String {
    let mut letters = name.chars();
    let at_the_start: String = letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect();
    let next = |rest: &str| [name, &at_the_start].into_iter().filter_map(|spelt| rest.find(spelt)).min();
    let (mut said, mut rest) = (String::with_capacity(sentence.len()), sentence);
    while let Some(at) = next(rest) {
        let (before, behind) = rest.split_at(at + name.len());
        said.push_str(before);
        let word = said[..said.len() - name.len()].trim_end().rsplit([' ', '\n', '(']).next();
        let governs = |word: &str| GOVERNING.contains(&word) || plural(word).is_some() || VERBS.contains(&word);
        let governed = word.is_some_and(governs);
        let end = behind.find([',', ';', ':', '.', '(']).unwrap_or(behind.len());
        let (clause, further) = behind.split_at(end);
        if governed || !clause.starts_with(' ') {
            rest = behind;
            continue;
        }
        said.push_str(&predicate(clause));
        rest = further;
    }
    said + rest
}

/// What is said of a plural: its verb, and what is joined to it.
fn predicate(clause: &str) -> String {
    let (mut expected, mut told) = (true, false);
    let word = |word: &str| {
        let verb = plural(word).filter(|_| expected);
        let is_between = word.is_empty() || ADVERBS.contains(&word);
        told |= verb.is_some();
        expected = expected && verb.is_none() && is_between || told && FURTHER.contains(&word);
        verb.unwrap_or_else(|| word.to_owned())
    };
    clause.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// The plural of a verb that stands behind one body: `move` of `moves`.
fn plural(verb: &str) -> Option<String> {
    if let Some([_, plural]) = IRREGULAR.iter().find(|[singular, _]| *singular == verb) {
        return Some((*plural).to_owned());
    }
    VERBS.iter().find(|base| third_person(base) == verb).map(|base| (*base).to_owned())
}

fn third_person(base: &str) -> String {
    let before_y = base.strip_suffix('y').filter(|stem| !stem.ends_with(['a', 'e', 'o', 'u']));
    match before_y {
        Some(stem) => format!("{stem}ies"),
        None if ["s", "sh", "ch", "x"].iter().any(|end| base.ends_with(end)) => format!("{base}es"),
        None => format!("{base}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verbs_agree_with_their_subject_alone() {
        let said = |sentence| with_plural(sentence, "the vanes");
        assert_eq!(said("The vanes is smooth and turns the jet."), "The vanes are smooth and turn the jet.");
        assert_eq!(said("all of the jet reaches the vanes"), "all of the jet reaches the vanes");
        assert_eq!(said("the force on the vanes is opposite"), "the force on the vanes is opposite");
        assert_eq!(said("the mass that reaches the vanes is small"), "the mass that reaches the vanes is small");
        assert_eq!(said("so the vanes then carries it"), "so the vanes then carry it");
        assert_eq!(said("the vanes passes it, and the jet stays"), "the vanes pass it, and the jet stays");
    }
}
