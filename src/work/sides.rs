//! A line taken apart: its sides, how they compare, and the words around them.

use super::setting::unset;

/// The comparison of two sides of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Compared {
    /// `=`.
    Equal,
    /// `<`.
    Less,
    /// `<=`.
    AtMost,
    /// `>`.
    Greater,
    /// `>=`.
    AtLeast,
}

use Compared::{AtLeast, AtMost, Equal, Greater, Less};

/// Every sign that compares two sides; of those that begin alike the longest stands first.
const SIGNS: [(&str, Compared); 20] = [
    ("\\approx", Equal),
    ("\\simeq", Equal),
    ("\\leq", AtMost),
    ("\\geq", AtLeast),
    ("\\le", AtMost),
    ("\\ge", AtLeast),
    ("\\lt", Less),
    ("\\gt", Greater),
    ("<=", AtMost),
    (">=", AtLeast),
    ("~=", Equal),
    ("==", Equal),
    ("≤", AtMost),
    ("≥", AtLeast),
    ("≈", Equal),
    ("≅", Equal),
    ("≃", Equal),
    ("=", Equal),
    ("<", Less),
    (">", Greater),
];

/// The arrows between two statements of one line: the second follows from the first.
const ARROWS: [&str; 10] = ["\\Longrightarrow", "\\Rightarrow", "\\implies", "\\to ", "=>", "->", "⇒", "⟹", "→", ";"];

/// Words between two statements of one line.
const JOINERS: [&str; 9] =
    [", so ", " so ", " with ", " where ", " therefore ", " hence ", " thus ", " then ", ", and "];

/// The words between two solutions, of which one holds.
const ALTERNATIVES: [&str; 3] = [" or ", "\\text{ or }", "\\text{or}"];

/// Signs of which one or the other holds.
const BOTH_SIGNS: [&str; 4] = ["±", "\\pm", "+/-", "+-"];
/// Beginnings of roots.
const ROOTS: [&str; 3] = ["sqrt", "\\sqrt", "√"];

/// Words that open a line and say nothing of their own.
const WORDS: [&str; 38] = [
    "so",
    "then",
    "thus",
    "hence",
    "therefore",
    "and",
    "also",
    "but",
    "now",
    "we",
    "have",
    "get",
    "obtain",
    "gives",
    "with",
    "where",
    "since",
    "because",
    "that",
    "is",
    "the",
    "it",
    "which",
    "means",
    "by",
    "from",
    "using",
    "no",
    "ok",
    "yes",
    "finally",
    "after",
    "before",
    "had",
    "has",
    "becomes",
    "starts",
    "when",
];
/// Words that make a line say the opposite.
const NEGATIONS: [&str; 3] = ["not", "never", "cannot"];
/// Verbs behind which the equation of a sentence begins.
const VERBS: [&str; 8] = ["is", "are", "was", "had", "has", "becomes", "equals", "gives"];
/// A sentence leads up to its equation by no more words.
const MOST_WORDS: usize = 8;
/// Words behind which the equation stands that follows from a reason.
const CONCLUSIONS: [&str; 6] = [" so ", " so that ", " therefore ", " hence ", " thus ", " then "];
/// Words behind which the reason of an equation stands.
const JOINTS: [&str; 7] = [" because ", " since ", " as the ", " from the ", " by the ", " according to ", " using "];
/// Directions that may stand in brackets behind a value.
const DIRECTIONS: [&str; 14] = [
    "up",
    "upwards",
    "down",
    "downwards",
    "left",
    "right",
    "east",
    "west",
    "north",
    "south",
    "forwards",
    "backwards",
    "clockwise",
    "outwards",
];
/// One statement: sides, each compared with the next one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Chain {
    /// The sides as they are written. The first is empty where the line goes on from the one before.
    pub(crate) sides: Vec<String>,
    /// How each compares with the next.
    pub(crate) signs: Vec<Compared>,
    /// Whether it is one of two that differ by the sign of a root.
    pub(crate) is_of_root: bool,
}

/// A line: statements one after another, of each of which one alternative holds.
pub(crate) type Sides = Vec<Vec<Chain>>;

/// The statements of a line, one after another.
pub(crate) fn statements(line: &str) -> Vec<String> {
    split(&unset(line), &ARROWS).iter().flat_map(|part| joined(part)).flat_map(|part| listed(&part)).collect()
}

/// Takes a line apart; nothing where no sides are compared in it.
pub(crate) fn sides(line: &str) -> Option<Sides> {
    let statements = statements(line);
    let sides: Sides = statements
        .iter()
        .map(|statement| {
            alternatives(statement)
                .iter()
                .flat_map(|text| {
                    let is_of_root = is_before_root(text);
                    both_signs(text).into_iter().filter_map(move |text| Some(Chain { is_of_root, ..chain(&text)? }))
                })
                .collect()
        })
        .filter(|alternatives: &Vec<Chain>| !alternatives.is_empty())
        .collect();
    (!sides.is_empty()).then_some(sides)
}

/// The alternatives of a statement; `v = 3 or 5` says of the same quantity that it is the one or the other.
fn alternatives(statement: &str) -> Vec<String> {
    let parts = split(statement, &ALTERNATIVES);
    let lead = parts.first().and_then(|first| first_sign(first).map(|behind| first[..behind].to_owned()));
    let is_value = |part: &str| {
        !compares(part)
            && part.trim_start().starts_with(|sign: char| sign.is_ascii_digit() || "+-−±√\\(".contains(sign))
    };
    let whole = |part: &String| match &lead {
        Some(lead) if is_value(part) => format!("{lead}{part}"),
        _ => part.clone(),
    };
    parts.iter().map(whole).collect()
}

/// The place behind the first sign that compares.
fn first_sign(text: &str) -> Option<usize> {
    let place = |(sign, _): &(&str, Compared)| text.find(sign).map(|at| (at, usize::MAX - sign.len()));
    SIGNS.iter().filter_map(place).min().map(|(at, left)| at + (usize::MAX - left))
}

/// A statement as what stands before its last side, with the sign, and that side.
pub(crate) fn last_side(statement: &str) -> Option<(&str, &str)> {
    let place = |(sign, _): &(&str, Compared)| statement.rfind(sign).map(|at| at + sign.len());
    SIGNS.iter().filter_map(place).max().map(|at| statement.split_at(at))
}

/// `f d = 4.3 so d = 0.5` as two statements: words part them where each part compares sides.
fn joined(statement: &str) -> Vec<String> {
    let (mut parts, mut rest, mut from) = (Vec::new(), statement, 0);
    let next = |rest: &str, from: usize| {
        let place = |word: &&str| rest[from..].find(*word).map(|at| (from + at, word.len()));
        JOINERS.iter().filter_map(place).min()
    };
    while let Some((at, length)) = next(rest, from) {
        let (before, behind) = (&rest[..at], &rest[at + length..]);
        if compares(before) && compares(behind) {
            parts.push(before.to_owned());
            (rest, from) = (behind, 0);
        } else {
            from = at + length;
        }
    }
    parts.push(rest.to_owned());
    parts
}

/// Whether sides are compared in a text.
fn compares(text: &str) -> bool {
    SIGNS.iter().any(|(sign, _)| text.contains(sign))
}

/// `a = 1, b = 2` as two statements: commas part them where each part compares sides.
fn listed(statement: &str) -> Vec<String> {
    let parts: Vec<&str> = statement.split(", ").collect();
    let parts = if parts.iter().all(|part| compares(part)) { parts } else { vec![statement] };
    parts.into_iter().map(str::to_owned).collect()
}

fn split(text: &str, marks: &[&str]) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        if let Some(mark) = marks.iter().find(|mark| rest.starts_with(**mark)) {
            parts.push(String::new());
            rest = &rest[mark.len()..];
            continue;
        }
        if let Some(last) = parts.last_mut() {
            last.push(first);
        }
        rest = &rest[first.len_utf8()..];
    }
    parts
}

/// `v = ± x` as two statements.
fn both_signs(text: &str) -> Vec<String> {
    match BOTH_SIGNS.iter().find(|mark| text.contains(**mark)) {
        Some(mark) => ["+", "-"].map(|sign| text.replace(mark, sign)).to_vec(),
        None => vec![text.to_owned()],
    }
}

/// Whether both signs stand before a root.
fn is_before_root(text: &str) -> bool {
    BOTH_SIGNS.iter().any(|mark| {
        text.split(mark).skip(1).any(|behind| ROOTS.iter().any(|root| behind.trim_start().starts_with(root)))
    })
}

fn chain(text: &str) -> Option<Chain> {
    let (mut sides, mut signs) = (vec![String::new()], Vec::new());
    let mut rest = without_words(text);
    while let Some(first) = rest.chars().next() {
        // `\left` is no sign of comparison.
        let sign = SIGNS.iter().find(|(sign, _)| {
            rest.strip_prefix(sign)
                .is_some_and(|behind| !sign.starts_with('\\') || !behind.starts_with(char::is_alphabetic))
        });
        if let Some((sign, compared)) = sign {
            sides.push(String::new());
            signs.push(*compared);
            rest = &rest[sign.len()..];
            continue;
        }
        if let Some(last) = sides.last_mut() {
            last.push(first);
        }
        rest = &rest[first.len_utf8()..];
    }
    let sides: Vec<String> = sides.iter().map(|side| without_remark(side).to_owned()).collect();
    (!signs.is_empty()).then_some(Chain { sides, signs, is_of_root: false })
}

/// A statement without the words before it: `momentum: `, `so `, `the mass is `. A negation stays, so that it is not read over.
fn without_words(text: &str) -> &str {
    let mut rest = text.trim().trim_end_matches(['.', ',']);
    if let Some((label, behind)) = rest.split_once(':')
        && !label.contains(|sign: char| "=<>+*/^≤≥≈".contains(sign))
    {
        rest = behind.trim_start();
    }
    if let Some((exclamation, behind)) = rest.split_once("! ")
        && exclamation.chars().all(|sign| sign.is_ascii_alphabetic() || sign == ' ')
    {
        rest = behind.trim_start();
    }
    if let Some(behind) = behind_reason(rest) {
        rest = behind;
    }
    loop {
        let word = rest.find([' ', ',']).map_or(rest, |end| &rest[..end]);
        let small = word.to_lowercase();
        let is_plain = word.len() > 1 && word.chars().all(|sign| sign.is_ascii_alphabetic());
        let is_word = is_plain && (WORDS.contains(&small.as_str()) || rest.len() > word.len() && is_before_verb(rest));
        if !is_word || NEGATIONS.contains(&small.as_str()) {
            return rest;
        }
        rest = rest[word.len()..].trim_start_matches([' ', ',']);
    }
}

/// The text behind a reason in words: `no friction, so T_2 = T_1`.
fn behind_reason(text: &str) -> Option<&str> {
    let compared = SIGNS.iter().filter_map(|(sign, _)| text.find(sign)).min()?;
    let (at, conclusion) = CONCLUSIONS
        .iter()
        .filter_map(|word| Some((text[..compared].rfind(word)?, *word)))
        .max_by_key(|place_and_word| place_and_word.0)?;
    let is_word = |sign: char| sign.is_alphabetic() || matches!(sign, ' ' | ',' | '-' | '\'');
    text[..at].chars().all(is_word).then(|| text[at + conclusion.len()..].trim_start())
}

/// Whether words of a sentence lead up to a verb before any sign or number: `the mass is m = ...`.
fn is_before_verb(text: &str) -> bool {
    let words =
        text.split(' ').take_while(|word| word.len() > 1 && word.chars().all(|sign| sign.is_ascii_alphabetic()));
    words.skip(1).take(MOST_WORDS).any(|word| VERBS.contains(&word))
}

/// A side without a remark behind it: `1.2 m/s (to the right)`, `h_0 because energy is conserved`.
fn without_remark(side: &str) -> &str {
    let side = without_bracket(side.trim().trim_end_matches([',', '.']).trim_end());
    let joint = JOINTS.iter().filter_map(|joint| side.find(joint)).min();
    joint.map_or(side, |at| side[..at].trim_end())
}

/// A side without words in brackets behind it.
fn without_bracket(side: &str) -> &str {
    let Some(open) = side.rfind('(').filter(|open| *open > 0 && side.ends_with(')')) else { return side };
    let inner = &side[open + 1..side.len() - 1];
    let is_remark =
        inner.split([' ', '-']).all(|word| word.len() > 1 && word.chars().all(|sign| sign.is_ascii_lowercase()));
    let words: Vec<&str> = inner.split([' ', '-']).collect();
    let is_words = words.iter().any(|word| DIRECTIONS.contains(word))
        || words.len() > 1 && words.iter().any(|word| word.len() > 3);
    if is_remark && is_words { side[..open].trim_end() } else { side }
}
