//! A choice: by its letter, its number, its text, or yes and no.

use super::answer::ChoiceAnswer;
use super::plain::MAX_LENGTH;
use super::predicate;
use super::reasons;
use super::unreadable::{Unreadable, UnreadableKind};
use super::yes_or_no::{answer_of, first_word};

/// Words by which an option denies what stands behind them.
const DENYING: [&str; 5] = ["not", "no", "never", "neither", "without"];
/// The fewest letters of a word by which an option is known from its end.
const SHORTEST_ENDING: usize = 4;

/// The other names of something, and the word for it here. Of two the longer comes first.
const SAME: [(&str, &str); 13] = [
    ("the same as", "equal to"),
    ("smaller than", "less than"),
    ("larger", "greater"),
    ("bigger", "greater"),
    ("higher", "greater"),
    ("smaller", "lesser"),
    ("lower", "lesser"),
    ("er one", "er"),
    ("perfectly inelastic", "perfectly plastic"),
    ("completely inelastic", "perfectly plastic"),
    ("totally inelastic", "perfectly plastic"),
    ("perfectly elastic", "elastic"),
    ("torque", "moment"),
];

/// Reads which of the options is meant.
pub(super) fn read(answer: &str, question: &str, options: &[String]) -> Result<ChoiceAnswer, Unreadable> {
    if answer.chars().nth(MAX_LENGTH).is_some() {
        return Err(Unreadable { at: MAX_LENGTH, kind: UnreadableKind::TooLong(MAX_LENGTH) });
    }
    let same = |text: String| SAME.iter().fold(text, |text, (other, word)| text.replace(other, word));
    let by_text = meant(&normal(answer), options, &normal);
    by_text
        .or_else(|fault| match fault.kind {
            UnreadableKind::NoOption(_) => meant(&same(normal(answer)), options, &|option| same(normal(option))),
            _ => Err(fault),
        })
        .or_else(|fault| match fault.kind {
            UnreadableKind::NoOption(_) => in_letters(answer, options)
                .or_else(|| by_last_words(&normal(answer), options))
                .or_else(|| reasons::with_reason(&normal(answer), options))
                .or_else(|| predicate::in_its_words(&normal(answer), &normal(question), options))
                .ok_or(fault),
            _ => Err(fault),
        })
}

/// The option that ends with these words, where one alone does and they deny nothing there: `plastic` of `perfectly plastic`.
fn by_last_words(written: &str, options: &[String]) -> Option<ChoiceAnswer> {
    let ends = |text: &str| {
        let before = text.strip_suffix(written).filter(|before| before.ends_with(' '))?;
        (!before.split_whitespace().any(|word| DENYING.contains(&word))).then_some(())
    };
    let long =
        written.chars().count() >= SHORTEST_ENDING && written.chars().all(|next| next.is_alphabetic() || next == ' ');
    let mut matching = options.iter().enumerate().filter(|(_, text)| long && ends(&normal(text)).is_some());
    match (matching.next(), matching.next()) {
        (Some((option, text)), None) => Some(ChoiceAnswer { option, text: text.clone() }),
        _ => None,
    }
}

/// The option that has the same letters and signs, where one alone does: as it is printed, or with other spaces.
fn in_letters(answer: &str, options: &[String]) -> Option<ChoiceAnswer> {
    let written = letters(answer);
    let mut same = options.iter().enumerate().filter(|(_, text)| letters(text) == written);
    match (same.next(), same.next()) {
        (Some((option, text)), None) if !written.is_empty() => Some(ChoiceAnswer { option, text: text.clone() }),
        _ => None,
    }
}

/// The letters, digits and signs of a text, without the stages in brackets.
fn letters(text: &str) -> String {
    let mut depth = 0_usize;
    let mut all = String::new();
    for next in normal(text).chars() {
        match next {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ if depth == 0 && (next.is_alphanumeric() || "<>=+-*/".contains(next)) => all.push(next),
            _ => {}
        }
    }
    all
}

fn meant(written: &str, options: &[String], plain: &dyn Fn(&str) -> String) -> Result<ChoiceAnswer, Unreadable> {
    let fault = |kind| Unreadable { at: 0, kind };
    let chosen = |option: usize| options.get(option).map(|text| ChoiceAnswer { option, text: text.clone() });
    let texts: Vec<String> = options.iter().map(|option| plain(option)).collect();
    if let Some(exact) = texts.iter().position(|text| text == written) {
        // `2` may be the second option or the option `2`.
        let by_place = place(written, options.len()).filter(|place| *place != exact);
        return match by_place {
            Some(_) => Err(fault(UnreadableKind::SeveralOptions)),
            None => chosen(exact).ok_or(fault(UnreadableKind::NoOption(options.len()))),
        };
    }
    let is_beginning = |text: &&String| !written.is_empty() && begins(text, written);
    let meant: Vec<usize> = match answer_of(written) {
        Some(meant) => positions(&texts, |text| answer_of(first_word(text)) == Some(meant)),
        None => Vec::new(),
    };
    let meant = if meant.is_empty() { place(written, options.len()).into_iter().collect() } else { meant };
    let meant = if meant.is_empty() { positions(&texts, |text| is_beginning(&text)) } else { meant };
    match meant.as_slice() {
        [one] => chosen(*one).ok_or(fault(UnreadableKind::NoOption(options.len()))),
        [] => Err(fault(UnreadableKind::NoOption(options.len()))),
        _ => Err(fault(UnreadableKind::SeveralOptions)),
    }
}

fn positions(texts: &[String], is_meant: impl Fn(&String) -> bool) -> Vec<usize> {
    texts.iter().enumerate().filter(|(_, text)| is_meant(text)).map(|(position, _)| position).collect()
}

/// In small letters, with single spaces, and without the brackets and stops around it.
fn normal(text: &str) -> String {
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let bare = words.trim_matches(|edge: char| "()[].:;,\"'`“”‘’ ".contains(edge));
    bare.to_lowercase().replace('’', "'")
}

/// Whether a text begins with these whole words.
fn begins(text: &str, words: &str) -> bool {
    text.strip_prefix(words).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
}

/// The position of an option by its letter or number: `b` and `2` are the second.
fn place(written: &str, count: usize) -> Option<usize> {
    let mut letters = written.chars();
    let position = match (letters.next(), letters.next()) {
        (Some(letter @ 'a'..='z'), None) => (letter as usize).checked_sub('a' as usize),
        _ if written.bytes().all(|byte| byte.is_ascii_digit()) => written.parse::<usize>().ok()?.checked_sub(1),
        _ => None,
    };
    position.filter(|position| *position < count)
}
