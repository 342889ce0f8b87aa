//! An interval or a condition: `0 < e <= 0.5`, `(0, 0.5]`, `at most 0.5`, `between 0 and 0.5`.

use momentous_quantity::Unit;

use super::super::expected::ExpectedInterval;
use super::answer::{EndAnswer, IntervalAnswer, NumberAnswer};
use super::numeral::DecimalMark;
use super::plain::Plain;
use super::unit::unit;
use super::unreadable::{At, Unreadable, UnreadableKind};
use super::value::{self, Asked};

/// Signs that compare: the writing, whether the left side is the smaller, whether both may be equal. Longer ones first.
const SIGNS: [(&str, bool, bool); 8] = [
    ("<=", true, true),
    ("=<", true, true),
    (">=", false, true),
    ("=>", false, true),
    ("≤", true, true),
    ("≥", false, true),
    ("<", true, false),
    (">", false, false),
];

/// Words that compare: the words, whether the end behind them is the upper one, whether it belongs to the interval.
const WORDS: [(&str, bool, bool); 30] = [
    ("less than or equal to", true, true),
    ("smaller than or equal to", true, true),
    ("greater than or equal to", false, true),
    ("larger than or equal to", false, true),
    ("bigger than or equal to", false, true),
    ("at most", true, true),
    ("no more than", true, true),
    ("not more than", true, true),
    ("no greater than", true, true),
    ("not greater than", true, true),
    ("no larger than", true, true),
    ("not larger than", true, true),
    ("up to", true, true),
    ("less than", true, false),
    ("smaller than", true, false),
    ("lower than", true, false),
    ("below", true, false),
    ("under", true, false),
    ("at least", false, true),
    ("no less than", false, true),
    ("not less than", false, true),
    ("no smaller than", false, true),
    ("not smaller than", false, true),
    ("greater than", false, false),
    ("larger than", false, false),
    ("bigger than", false, false),
    ("higher than", false, false),
    ("more than", false, false),
    ("above", false, false),
    ("over", false, false),
];

/// Words before a condition that say nothing of it.
const BEFORE: [&str; 12] = [
    "only for ",
    "only if ",
    "for all ",
    "for every ",
    "for any ",
    "for ",
    "if ",
    "when ",
    "where ",
    "provided ",
    "iff ",
    "whenever ",
];
/// Words between the name and the condition.
const LINKS: [&str; 9] = ["in ", "is ", "∈", "lies ", "must be ", "has to be ", "should be ", "= ", ": "];

/// Ways to write what has no end, without its sign.
const INFINITE: [&str; 6] = ["∞", "inf", "infinity", "infty", "\\infty", "oo"];

/// An end: a value, or none on that side.
#[derive(Clone)]
enum Side {
    Value(Box<NumberAnswer>),
    /// Whether it is above everything.
    Infinite(bool),
}

/// An end that was read, with its unit.
type End = Option<Side>;

/// The lower and the upper end, each with whether it belongs to the interval.
type Ends = [Option<(End, bool)>; 2];

/// Reads an interval.
pub(super) fn read(answer: &str, asked: &ExpectedInterval, mark: DecimalMark) -> Result<IntervalAnswer, Unreadable> {
    let plain = Plain::new(answer)?;
    let reader = Reader { text: plain.text(), asked, mark };
    reader.interval().map_err(|(at, kind)| plain.fault(at, kind))
}

struct Reader<'a> {
    text: &'a str,
    asked: &'a ExpectedInterval,
    mark: DecimalMark,
}

/// A piece of the text with its first byte.
type Piece<'a> = (usize, &'a str);

impl<'a> Reader<'a> {
    fn interval(&self) -> At<IntervalAnswer> {
        let whole = Self::without_words(trimmed((0, self.text)));
        if let Some(interval) = self.signs(whole)? {
            return Ok(interval);
        }
        let (at, text) = self.without_name(whole);
        if let Some(interval) = self.brackets((at, text))? {
            return Ok(interval);
        }
        let word = |(word, upper, closed): &(&str, bool, bool)| {
            let rest = text.strip_prefix(word).filter(|rest| !rest.starts_with(char::is_alphabetic))?;
            Some((rest, *upper, *closed))
        };
        if let Some((rest, upper, closed)) = WORDS.iter().find_map(word) {
            let end = self.end(self.piece(rest))?;
            let closed = [Some(closed); 2];
            return if upper { self.made(None, end, closed) } else { self.made(end, None, closed) };
        }
        let between = text.strip_prefix("between ").and_then(|rest| rest.split_once(" and "));
        let from = text.strip_prefix("from ").unwrap_or(text).split_once(" to ");
        if let Some((low, high)) = between.or(from) {
            return self.made(self.end(self.piece(low))?, self.end(self.piece(high))?, [Some(true); 2]);
        }
        // The boundary alone, or an equation: both ends are this value.
        let end = self.end((at, text)).map_err(|_| (at, UnreadableKind::NotAnInterval))?;
        match &end {
            Some(Side::Value(value)) if value.sense.is_none() => self.made(end.clone(), end, [Some(true); 2]),
            _ => Err((at, UnreadableKind::NotAnInterval)),
        }
    }

    /// `0 < e <= 0.5`, `e > 0`, `e > 0 and e <= 0.5`.
    fn signs(&self, whole: Piece<'a>) -> At<Option<IntervalAnswer>> {
        let joined = [" and ", "&&", " & ", "∧", ", ", "; "].iter().find_map(|word| whole.1.split_once(word));
        let joined = joined.filter(|(first, second)| {
            [first, second].iter().all(|side| SIGNS.iter().any(|(sign, ..)| side.contains(sign)))
        });
        if let Some((first, second)) = joined {
            let read = |text| self.chain(trimmed(self.piece(text)));
            let (Some(first), Some(second)) = (read(first)?, read(second)?) else { return Ok(None) };
            return match (first, second) {
                ([None, high], [low, None]) | ([low, None], [None, high]) => self.of_ends(low, high).map(Some),
                _ => Err((whole.0, UnreadableKind::NotAnInterval)),
            };
        }
        match self.chain(whole)? {
            Some([low, high]) => self.of_ends(low, high).map(Some),
            None => Ok(None),
        }
    }

    /// The lower and the upper end of a chain of comparisons, each with whether it belongs to the interval.
    fn chain(&self, (start, text): Piece<'a>) -> At<Option<Ends>> {
        let mut pieces: Vec<Piece> = Vec::new();
        let mut signs = Vec::new();
        let (mut from, mut at) = (0, 0);
        while at < text.len() {
            let sign = SIGNS.iter().find(|(sign, ..)| text[at..].starts_with(sign));
            if let Some(sign @ (written, ..)) = sign {
                pieces.push(trimmed((start + from, &text[from..at])));
                signs.push(sign);
                at += written.len();
                from = at;
            } else {
                at += text[at..].chars().next().map_or(1, char::len_utf8);
            }
        }
        pieces.push(trimmed((start + from, &text[from..])));
        let ends = match (pieces.as_slice(), signs.as_slice()) {
            (_, []) => return Ok(None),
            ([left, right], [(_, smaller, closed)]) => {
                // `> 0.5` speaks of what is asked.
                let (end, upper) = if self.is_name(left.1) || left.1.is_empty() {
                    (self.end(*right)?, *smaller)
                } else {
                    self.named(*right)?;
                    (self.end(*left)?, !*smaller)
                };
                if upper { [None, Some((end, *closed))] } else { [Some((end, *closed)), None] }
            }
            ([left, name, right], [(_, first, left_closed), (_, second, right_closed)]) if first == second => {
                self.named(*name)?;
                let (left, right) = ((self.end(*left)?, *left_closed), (self.end(*right)?, *right_closed));
                if *first { [Some(left), Some(right)] } else { [Some(right), Some(left)] }
            }
            _ => return Err((start, UnreadableKind::NotAnInterval)),
        };
        Ok(Some(ends))
    }

    fn of_ends(&self, low: Option<(End, bool)>, high: Option<(End, bool)>) -> At<IntervalAnswer> {
        let closed = [low.as_ref().map(|end| end.1), high.as_ref().map(|end| end.1)];
        self.made(low.map(|end| end.0).unwrap_or_default(), high.map(|end| end.0).unwrap_or_default(), closed)
    }

    /// `(0, 0.5]`, `]0; 0.5]`, with the unit behind.
    fn brackets(&self, (at, text): Piece<'a>) -> At<Option<IntervalAnswer>> {
        let Some(open) = text.chars().next().filter(|open| ['(', '[', ']'].contains(open)) else { return Ok(None) };
        let Some(end) = text.rfind([')', ']', '[']).filter(|end| *end > 0) else { return Ok(None) };
        let inside = &text[1..end];
        let split = if self.mark == DecimalMark::Comma { inside.split_once(';') } else { None };
        let split = split.or_else(|| inside.split_once(';')).or_else(|| inside.split_once(", "));
        let split = split.or_else(|| inside.split_once(',').filter(|_| self.mark != DecimalMark::Comma));
        let Some((low, high)) = split else { return Err((at, UnreadableKind::NotAnInterval)) };
        let closed = [Some(open == '['), Some(text[end..].starts_with(']'))];
        let behind = &text[end + 1..];
        let start = self.piece(behind).0;
        let unit = unit(behind, 0, behind.len(), &self.asked.unit).map_err(|(shift, kind)| (start + shift, kind))?;
        let mut interval = self.made(self.end(self.piece(low))?, self.end(self.piece(high))?, closed)?;
        if unit.is_some() && interval.unit.is_some() {
            return Err((start, UnreadableKind::MixedUnits));
        }
        interval.unit = interval.unit.or(unit);
        Ok(Some(interval))
    }

    fn made(&self, low: End, high: End, closed: [Option<bool>; 2]) -> At<IntervalAnswer> {
        // Nothing lies above what is above everything.
        if matches!(low, Some(Side::Infinite(true))) || matches!(high, Some(Side::Infinite(false))) {
            return Err((0, UnreadableKind::EmptyInterval));
        }
        let value = |end: End| if let Some(Side::Value(value)) = end { Some(*value) } else { None };
        let (low, high) = (value(low), value(high));
        if low.is_none() && high.is_none() {
            return Err((0, UnreadableKind::NotAnInterval));
        }
        let unit = |end: &Option<NumberAnswer>| end.as_ref().and_then(|end| end.unit.clone());
        let unit: Option<Unit> = match (unit(&low), unit(&high)) {
            (Some(low), Some(high)) if low != high => return Err((0, UnreadableKind::MixedUnits)),
            (low, high) => high.or(low),
        };
        let above = |low: &NumberAnswer, high: &NumberAnswer| low.number.value() > high.number.value();
        if low.as_ref().zip(high.as_ref()).is_some_and(|(low, high)| above(low, high)) {
            return Err((0, UnreadableKind::EmptyInterval));
        }
        let end = |end: Option<NumberAnswer>, closed: Option<bool>| {
            end.map(|end| EndAnswer { number: end.number, written: end.written, closed: closed != Some(false) })
        };
        Ok(IntervalAnswer { name: self.asked.name.clone(), low: end(low, closed[0]), high: end(high, closed[1]), unit })
    }

    fn end(&self, piece: Piece<'a>) -> At<End> {
        let (at, text) = trimmed(piece);
        let (sign, size) = text.strip_prefix('-').map_or((true, text), |size| (false, size));
        if INFINITE.contains(&size.trim_start_matches(['+', ' '])) {
            return Ok(Some(Side::Infinite(sign)));
        }
        value::read(text, Asked::in_unit(&self.asked.unit), self.mark)
            .map(|end| Some(Side::Value(Box::new(end))))
            .map_err(|(shift, kind)| (at + shift, kind))
    }

    fn named(&self, (at, text): Piece<'a>) -> At<()> {
        if self.is_name(text) { Ok(()) } else { Err((at, UnreadableKind::OtherName(self.asked.name.clone()))) }
    }

    fn is_name(&self, text: &str) -> bool {
        // The letter alone is what is asked, too.
        let stem = self.asked.name.split('_').next().unwrap_or_default();
        let plain = |name: &str| name.replace(['_', '{', '}'], "");
        plain(text) == plain(&self.asked.name) || !text.is_empty() && text == stem
    }

    /// The text behind words that say nothing of the condition.
    fn without_words((at, text): Piece<'a>) -> Piece<'a> {
        let rest = BEFORE.iter().find_map(|word| text.strip_prefix(word)).unwrap_or(text);
        trimmed((at + text.len() - rest.len(), rest))
    }

    /// The text behind `e in`, `e is`, `e:`.
    fn without_name(&self, (at, text): Piece<'a>) -> Piece<'a> {
        let rest = text.split_once(' ').filter(|(name, _)| self.is_name(name)).map_or(text, |(_, rest)| rest);
        let rest = rest.trim_start();
        let rest = LINKS.iter().find_map(|word| rest.strip_prefix(word)).unwrap_or(rest);
        trimmed((at + text.len() - rest.len(), rest))
    }

    fn piece(&self, text: &'a str) -> Piece<'a> {
        (text.as_ptr() as usize - self.text.as_ptr() as usize, text)
    }
}

fn trimmed((at, text): Piece<'_>) -> Piece<'_> {
    (at + text.len() - text.trim_start().len(), text.trim().trim_end_matches('.'))
}
