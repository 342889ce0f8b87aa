//! Endings of plain numbers, read once: people write few units and directions, behind many numbers.

use momentous_quantity::Decimal;
use momentous_quantity::Unit;

use super::super::number::Number;
use super::answer::{Answer, NumberAnswer, Sense, Written, echo_number, join};
use super::numeral::DecimalMark;
use super::unreadable::{Unreadable, UnreadableKind};

/// The number of endings that are remembered before all are forgotten.
const MOST: usize = 32;
/// The longest plain number, in characters: its digits fit a machine word.
const LONGEST: usize = 15;
/// The longest ending that is remembered, in bytes.
const LONGEST_ENDING: usize = 60;

/// The endings that were read behind plain numbers as answers to one part. What an ending says does not depend on the number
/// before it, but for its sign: `-3 m/s to the left` says the direction twice.
#[derive(Clone, Debug, Default)]
pub(crate) struct Endings(Vec<Known>);

/// An ending, behind a number with that sign.
#[derive(Clone, Debug)]
struct Known {
    sign: Option<char>,
    written: String,
    ending: Result<Ending, Fault>,
}

/// The meaning of an ending.
#[derive(Clone, Debug)]
struct Ending {
    unit: Option<Unit>,
    pounds_as_mass: bool,
    sense: Option<Sense>,
    /// The same in words, behind a one and behind any other number.
    one: String,
    many: String,
}

/// Why an ending cannot be read, and at which of its characters.
#[derive(Clone, Debug)]
struct Fault {
    at: usize,
    kind: UnreadableKind,
}

/// An answer that is a plain number with something behind it, such as `-2.57 m/s`: digits, perhaps with one point among them.
struct Plain<'t> {
    sign: Option<char>,
    digits: &'t str,
    ending: &'t str,
}

impl<'t> Plain<'t> {
    /// The parts of such an answer; none where the number might go on behind its digits.
    fn of(text: &'t str, mark: DecimalMark) -> Option<Self> {
        let sign = text.chars().next().filter(|first| matches!(first, '+' | '-'));
        let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
        let length = unsigned.bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'.').count();
        let (digits, ending) = unsigned.split_at(length);
        let is_digit = |next: char| next.is_ascii_digit();
        let well = digits.starts_with(is_digit) && digits.ends_with(is_digit) && digits.len() <= LONGEST;
        let points = digits.bytes().filter(|byte| *byte == b'.').count();
        let decimal = points == 0 || points == 1 && mark != DecimalMark::Comma;
        let begins = |next: char| next.is_alphabetic() && !matches!(next, 'x' | 'X') || "°%/([".contains(next);
        let apart = ending.trim_start().chars().next().is_none_or(begins) && !ending.starts_with(['e', 'E']);
        // What stands behind an equals sign has to agree with the number before it.
        let is_alone = !ending.contains(['=', '≈']);
        (well && decimal && apart && is_alone && ending.len() <= LONGEST_ENDING).then_some(Self {
            sign,
            digits,
            ending,
        })
    }

    fn number(&self) -> Option<(Number, Written)> {
        let decimal = Decimal::parse(self.digits).ok()?;
        let number = Number::from(&decimal);
        let written = Written::Figures { least: decimal.least_figures(), most: decimal.figures() };
        Some((if self.sign == Some('-') { number.negated() } else { number }, written))
    }

    /// The number in words, with what follows it: most numbers stand as they would be printed.
    fn in_words(&self, number: &Number, written: Written, ending: &Ending) -> String {
        let mut told = String::with_capacity(self.digits.len() + ending.many.len() + 2);
        let (whole, decimals) = self.digits.split_once('.').unwrap_or((self.digits, ""));
        let is_printed = match whole.as_bytes() {
            [b'0'] => !decimals.is_empty() && !decimals.starts_with('0'),
            [b'0', ..] => false,
            // From a million on, numbers are printed with a power of ten.
            digits => digits.len() <= 6,
        };
        if is_printed {
            told.extend(self.sign.filter(|sign| *sign == '-'));
            told.push_str(self.digits);
        } else {
            told.push_str(&echo_number(number, written));
        }
        let words = if told.trim_start_matches('-') == "1" { &ending.one } else { &ending.many };
        if !words.is_empty() {
            told.push(' ');
            told.push_str(words);
        }
        told
    }

    /// How many characters stand before the ending.
    fn length(&self) -> usize {
        self.digits.len() + usize::from(self.sign.is_some())
    }
}

impl Endings {
    /// The answer, or why it cannot be read, and the one or the other in words, where the ending is known.
    pub(crate) fn read(&self, text: &str, mark: DecimalMark) -> Option<(Result<Answer, Unreadable>, String)> {
        let plain = Plain::of(text, mark)?;
        let known = self.0.iter().find(|known| known.sign == plain.sign && known.written == plain.ending)?;
        let ending = match &known.ending {
            Ok(ending) => ending,
            Err(fault) => {
                let unreadable = Unreadable { at: plain.length() + fault.at, kind: fault.kind.clone() };
                let told = unreadable.to_string();
                return Some((Err(unreadable), told));
            }
        };
        let (number, written) = plain.number()?;
        let in_words = plain.in_words(&number, written, ending);
        let answer = NumberAnswer {
            number,
            written,
            signed: plain.sign.is_some(),
            unit: ending.unit.clone(),
            pounds_as_mass: ending.pounds_as_mass,
            sense: ending.sense.clone(),
            heading: None,
            unjudged: None,
        };
        Some((Ok(Answer::Number(answer)), in_words))
    }

    /// Remembers the ending of an answer that was read, where it is one behind a plain number.
    pub(crate) fn learn(&mut self, text: &str, mark: DecimalMark, answer: &Result<Answer, Unreadable>) {
        let Some(plain) = Plain::of(text, mark) else { return };
        let ending = match answer {
            Ok(Answer::Number(answer)) => Ending::of(&plain, answer).map(Ok),
            Ok(_) => None,
            Err(fault) => fault.at.checked_sub(plain.length()).map(|at| Err(Fault { at, kind: fault.kind.clone() })),
        };
        if let Some(ending) = ending {
            if self.0.len() >= MOST {
                self.0.clear();
            }
            self.0.push(Known { sign: plain.sign, written: plain.ending.to_owned(), ending });
        }
    }
}

impl Ending {
    /// The ending of an answer, where it has nothing to do with the number.
    fn of(plain: &Plain<'_>, answer: &NumberAnswer) -> Option<Self> {
        let (number, written) = plain.number()?;
        // Of a zero nobody knows whether it was multiplied by something.
        let says_more = answer.heading.is_some() || answer.unjudged.is_some();
        if number.is_zero() || number != answer.number || written != answer.written || says_more {
            return None;
        }
        let words = |plural| {
            let unit = answer.unit.as_ref().map(|unit| unit.spoken(plural));
            join([unit, answer.sense.as_ref().map(|sense| sense.word.clone())].into_iter().flatten())
        };
        Some(Self {
            unit: answer.unit.clone(),
            pounds_as_mass: answer.pounds_as_mass,
            sense: answer.sense.clone(),
            one: words(false),
            many: words(true),
        })
    }
}
