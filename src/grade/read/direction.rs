//! Direction words: `to the left`, `downwards`, an arrow.

use super::answer::Sense;

/// Words and signs of one direction.
const DIRECTIONS: &[&[&str]] = &[
    &["left", "leftward", "leftwards", "←", "⟵", "⬅"],
    &["right", "rightward", "rightwards", "→", "⟶", "➡"],
    &["up", "upward", "upwards", "↑", "⬆"],
    &["down", "downward", "downwards", "↓", "⬇"],
    &["north", "northward", "northwards", "N", "due north"],
    &["south", "southward", "southwards", "S", "due south"],
    &["east", "eastward", "eastwards", "E", "due east"],
    &["west", "westward", "westwards", "W", "due west"],
    &["clockwise", "cw", "↻"],
    &["counter-clockwise", "counterclockwise", "anticlockwise", "anti-clockwise", "ccw", "↺"],
    &["forward", "forwards", "ahead"],
    &["backward", "backwards", "back", "rearward", "rearwards"],
];

/// Directions that are told by a motion, and whether they go along with it.
const ALONG_MOTION: [(&str, bool); 23] = [
    ("same", true),
    ("motion", true),
    ("its motion", true),
    ("same as before", true),
    ("forward", true),
    ("forwards", true),
    ("onward", true),
    ("onwards", true),
    ("opposite", false),
    ("opposite motion", false),
    ("opposite its motion", false),
    ("against motion", false),
    ("against its motion", false),
    ("against original", false),
    ("against its original", false),
    ("against its original motion", false),
    ("opposite its original", false),
    ("opposite original", false),
    ("reverse", false),
    ("reversed", false),
    ("back", false),
    ("backward", false),
    ("backwards", false),
];

/// Before what one goes away from: `from the wall` is away from it.
const FROM: &str = "from ";

/// Words that say nothing beside a direction, and so does `in` before `the` and `positive direction`; alone it is an inch.
const FILLERS: &[&str] = &[
    "to",
    "the",
    "toward",
    "towards",
    "direction",
    "axis",
    "along",
    "moving",
    "going",
    "directed",
    "pointing",
    "it",
    "moves",
    "goes",
    "is",
    "and",
    "with",
    "at",
    "a",
    "speed",
    "velocity",
    "of",
    "vertically",
    "horizontally",
    "straight",
    "side",
];

/// The meaning of a phrase about direction.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Phrase {
    /// Nothing: it is no direction.
    None,
    /// One of the two directions of the question.
    Declared(Sense),
    /// Another direction.
    Other,
}

impl Phrase {
    /// Whether it says the positive direction of the question, or the negative one.
    pub(super) fn declared(&self) -> Option<bool> {
        match self {
            Self::Declared(sense) => Some(sense.positive),
            Self::None | Self::Other => None,
        }
    }
}

/// Reads a phrase, in the directions that the question declares for a component along that axis.
pub(super) fn read(phrase: &str, senses: Option<&[String; 2]>, axis: Option<char>) -> Phrase {
    let bare = bare(phrase);
    if bare.is_empty() {
        return Phrase::None;
    }
    let along = along_axis(&bare, phrase);
    // Another axis is another direction.
    let along =
        along.map(|(positive, letter)| (positive, letter.zip(axis).is_none_or(|(letter, axis)| letter == axis)));
    if let Some([plus, minus]) = senses {
        let sense = |positive| Phrase::Declared(Sense { positive, word: if positive { plus } else { minus }.clone() });
        let away = format!("away {bare}");
        let is = |word: &str| same(&bare, word) || bare.starts_with(FROM) && away == *word;
        if is(&self::bare(plus)) || along == Some((true, true)) {
            return sense(true);
        }
        if is(&self::bare(minus)) || along == Some((false, true)) {
            return sense(false);
        }
    }
    if group(&bare).is_some() || along.is_some() || along_motion(phrase).is_some() {
        Phrase::Other
    } else {
        Phrase::None
    }
}

/// Whether a phrase says that something goes along with a motion rather than against it, and whether it names the motion.
pub(super) fn along_motion(phrase: &str) -> Option<(bool, bool)> {
    let bare = bare(phrase);
    ALONG_MOTION.iter().find(|(words, _)| *words == bare).map(|(words, along)| (*along, words.contains("motion")))
}

/// Directions that need no declaration: that in which a component is counted positive, and its opposite, with the letter of the
/// axis where one is told. The letter alone is one only where the phrase says so: `in the x-direction`.
fn along_axis(bare: &str, phrase: &str) -> Option<(bool, Option<char>)> {
    let (positive, rest) = match bare.split_once(' ').unwrap_or((bare, "")) {
        ("positive", rest) => (true, rest),
        ("negative", rest) => (false, rest),
        (signed, "") if signed.starts_with('+') => (true, &signed[1..]),
        (signed, "") if signed.starts_with('-') => (false, &signed[1..]),
        (letter, "") if phrase.contains("direction") || phrase.contains("axis") => (true, letter),
        _ => return None,
    };
    let mut letters = rest.chars();
    match (letters.next(), letters.next()) {
        (None, _) => ["positive", "negative"].contains(&bare).then_some((positive, None)),
        (Some(letter), None) if letter.is_alphabetic() => Some((positive, Some(letter))),
        _ => None,
    }
}

/// Whether a direction is that in which what moves ahead goes.
pub(super) fn is_ahead(direction: &str) -> bool {
    same(&bare(direction), "ahead")
}

/// Whether a phrase begins with a direction and goes on, perhaps with an axis: `back along the table`.
pub(super) fn begins(phrase: &str) -> bool {
    let bare = bare(phrase);
    bare.split_once(' ').is_some_and(|(first, _)| group(first).is_some() && !is_compass_letter(first))
}

/// Whether a phrase is a letter of the compass, which may also be a unit.
pub(super) fn is_compass_letter(phrase: &str) -> bool {
    ["N", "S", "E", "W"].contains(&phrase)
}

/// Whether the positive direction of two is counter-clockwise, about the axis of the unit vector k.
pub(super) fn turns_about_k([plus, _]: &[String; 2]) -> bool {
    same(&bare(plus), "counter-clockwise")
}

/// Whether a character is an arrow.
pub(super) fn is_arrow(character: char) -> bool {
    // Most characters are letters and digits, and no arrow.
    !character.is_ascii()
        && DIRECTIONS
            .iter()
            .any(|words| words.iter().any(|word| word.chars().eq([character]) && !character.is_alphabetic()))
}

fn same(left: &str, right: &str) -> bool {
    left == right || group(left).is_some() && group(left) == group(right)
}

fn group(bare: &str) -> Option<usize> {
    DIRECTIONS.iter().position(|words| words.contains(&bare))
}

/// The phrase in small letters, but for a letter of the compass, and without its filling.
fn bare(phrase: &str) -> String {
    if is_compass_letter(phrase) {
        return phrase.to_owned();
    }
    let lower = phrase.to_lowercase().replace("-direction", " direction").replace("-axis", " axis");
    let mut words = lower.split(' ').filter(|word| !word.is_empty()).peekable();
    let mut bare = String::with_capacity(lower.len());
    while let Some(word) = words.next() {
        let names_axis = |next: &str| ["positive", "negative"].contains(&next) || next.starts_with(['+', '-']);
        let signed = |next: &str| names_axis(next) && lower.contains("direction");
        let is_beside = |next: &&str| *next == "the" || signed(next);
        let filling = FILLERS.contains(&word) || word == "in" && words.peek().is_some_and(is_beside);
        if !filling {
            bare.push_str(if bare.is_empty() { "" } else { " " });
            bare.push_str(word);
        }
    }
    bare
}
