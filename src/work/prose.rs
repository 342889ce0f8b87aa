//! Equations within sentences: `hold on, I should have said s_P - s_B = 14 ft, which is more`.

/// Signs that compare two sides, as far as sentences hold them.
const SIGNS: [char; 6] = ['=', '<', '>', '≤', '≥', '≈'];
/// Words directly before an equation.
const LEADS: [&str; 40] = [
    "is",
    "are",
    "was",
    "were",
    "be",
    "by",
    "get",
    "gets",
    "got",
    "give",
    "gives",
    "gave",
    "have",
    "has",
    "had",
    "said",
    "say",
    "says",
    "obtain",
    "find",
    "finds",
    "found",
    "yield",
    "yields",
    "becomes",
    "means",
    "that",
    "so",
    "then",
    "thus",
    "hence",
    "therefore",
    "where",
    "with",
    "use",
    "using",
    "write",
    "equation",
    "i.e.",
    "namely",
];
/// Nouns that a letter may follow: `rebound height h`.
const NOUNS: [&str; 18] = [
    "height",
    "speed",
    "velocity",
    "mass",
    "force",
    "impulse",
    "time",
    "duration",
    "momentum",
    "energy",
    "distance",
    "displacement",
    "angle",
    "work",
    "tension",
    "acceleration",
    "weight",
    "position",
];
/// Words that compute: what stands behind them is a part of what is meant.
const COMPUTING: [&str; 25] = [
    "sum",
    "difference",
    "product",
    "ratio",
    "root",
    "square",
    "squared",
    "times",
    "plus",
    "minus",
    "twice",
    "half",
    "double",
    "third",
    "quarter",
    "change",
    "loss",
    "lost",
    "gain",
    "increase",
    "decrease",
    "multiplied",
    "divided",
    "per",
    "percent",
];
/// Words that make a sentence say something else than its equation.
const TURNING: [&str; 14] = [
    "not", "never", "cannot", "isn't", "if", "unless", "suppose", "assume", "assuming", "wrong", "instead", "no",
    "neither", "whether",
];
/// Words with which a remark behind an equation begins.
const BEHIND: [&str; 18] = [
    "in", "to", "towards", "toward", "away", "from", "along", "against", "for", "because", "since", "as", "on", "when",
    "after", "before", "which", "i.e.",
];

/// The equation in a sentence without the words before or behind it; nothing where there are none that can be left out.
pub(crate) fn equation(text: &str) -> Option<String> {
    let sign = text.find(SIGNS)?;
    if let Some((label, behind)) = text.rsplit_once(": ")
        && behind.contains(SIGNS)
        && !is_turned(label)
    {
        return Some(behind.trim().to_owned());
    }
    let start = before(&text[..sign]);
    let end = behind(text, sign);
    (start > 0 || end < text.len()).then(|| text[start..end].trim().to_owned()).filter(|words| !words.is_empty())
}

/// Whether a text is a sentence: two words follow each other in it.
pub(crate) fn is_sentence(text: &str) -> bool {
    let is_word = |(_, word): &(usize, &str)| word.len() > 1 && word.chars().all(char::is_alphabetic);
    words(text).windows(2).any(|pair| pair.iter().all(is_word))
}

/// The beginning of the equation, behind the last word that leads up to one.
fn before(text: &str) -> usize {
    let words = words(text);
    let leads = |word: &str| {
        [&LEADS[..], &NOUNS[..]].iter().any(|words| words.contains(&word.to_lowercase().trim_end_matches(',')))
    };
    let lead = words.iter().rposition(|(_, word)| leads(word));
    let Some((lead, (start, word))) = lead.and_then(|lead| Some((lead, *words.get(lead)?))) else { return 0 };
    let prose = &words[..=lead];
    let small = |word: &str| word.trim_matches([',', '.', ';', '(', ')']).to_lowercase();
    let is_prose = |(_, word): &(usize, &str)| {
        let is_number = word.starts_with(|sign: char| sign.is_ascii_digit());
        let is_word =
            word.chars().all(|sign| sign.is_alphabetic() || matches!(sign, ',' | '.' | ';' | '\'' | '’' | '-'));
        is_number || is_word && (word.len() > 1 || matches!(*word, "I" | "a"))
    };
    let computes = |(_, word): &(usize, &str)| COMPUTING.contains(&small(word).as_str());
    // What turns the meaning has to stand in the clause of the equation.
    let clause = prose.iter().rposition(|(_, word)| word.ends_with([',', '.', ';'])).map_or(0, |comma| comma + 1);
    let clause = &prose[clause.min(lead)..];
    let is_result = matches!(small(word).as_str(), "get" | "gets" | "gives" | "find" | "obtain" | "yields" | "have");
    let turns =
        clause.iter().any(|(_, word)| TURNING.contains(&small(word).as_str()) && !(is_result && small(word) == "if"));
    let is_left_out = prose.iter().all(is_prose) && !prose.iter().any(computes) && !turns;
    if is_left_out && lead + 1 < words.len() { start + word.len() } else { 0 }
}

/// The end of the equation, before a remark behind it.
fn behind(text: &str, sign: usize) -> usize {
    let words = words(&text[sign..]);
    let is_word = |word: &str| {
        word.chars().all(|sign| sign.is_ascii_alphabetic() || matches!(sign, ',' | '.' | '\'' | '-' | '!'))
            && (word.len() > 1 || word == "a")
    };
    let tail = words.iter().rposition(|(_, word)| !is_word(word)).map_or(0, |last| last + 1);
    let begins = |place: usize| {
        let follows_comma =
            place.checked_sub(1).and_then(|before| words.get(before)).is_some_and(|(_, word)| word.ends_with(','));
        follows_comma || words.get(place).is_some_and(|(_, word)| BEHIND.contains(&word.trim_end_matches(',')))
    };
    let Some(start) = (tail..words.len()).find(|place| *place > 0 && begins(*place)) else { return text.len() };
    if words[start..].iter().any(|(_, word)| is_turned(word)) {
        return text.len();
    }
    words.get(start).map_or(text.len(), |(at, _)| sign + at)
}

/// Whether a text makes its equation say something else.
fn is_turned(text: &str) -> bool {
    words(text).iter().any(|(_, word)| TURNING.contains(&word.trim_matches([',', '.', '!']).to_lowercase().as_str()))
}

/// The words of a text, each with its place.
fn words(text: &str) -> Vec<(usize, &str)> {
    let mut words = Vec::new();
    let mut at = 0;
    for word in text.split(' ') {
        if !word.is_empty() {
            words.push((at, word));
        }
        at += word.len() + 1;
    }
    words
}

#[cfg(test)]
mod tests {
    use super::equation;

    #[test]
    fn words_around_an_equation_are_left_out() {
        let cases = [
            (
                "Hold on, the 14 ft are not over the ground, so I should have said s_P - s_B = 14 ft",
                Some("s_P - s_B = 14 ft"),
            ),
            ("If I put this in I get 160*14 + 900 s_B = 0", Some("160*14 + 900 s_B = 0")),
            ("and the barge is displaced by s_B = -2.49 ft, i.e. away from the quay.", Some("s_B = -2.49 ft,")),
            ("at x = 0: -0.9*2.7*y = -5", Some("-0.9*2.7*y = -5")),
            ("J = 1.8 N s in the direction of motion", Some("J = 1.8 N s")),
            ("the sum of both is v_A + v_B = 3", None),
            ("if the ball is at rest then v_A = 0", None),
            ("it is not true that v_A = 0", None),
            ("the product m_A times v_A is p_A = 3", None),
            ("v_A = 3 m/s", None),
        ];
        for (text, expected) in cases {
            assert_eq!(equation(text).as_deref(), expected, "{text}");
        }
    }
}
