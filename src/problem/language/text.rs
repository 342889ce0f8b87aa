//! The author's text: words, and placeholders for quantities.

use std::collections::BTreeSet;

use serde::Deserialize;

use momentous_fault::{Code, Fault, Span, did_you_mean};

/// A text with its placeholders, read by a grammar of our own.
///
/// ```
/// use momentous_problem::Text;
/// let text = Text::read("Cart A ({{ m_A }}) moves {{ v_A1 | motion }}.").unwrap();
/// let filled = text.fill(&|placeholder| format!("<{}>", placeholder.name));
/// assert_eq!(filled, "Cart A (<m_A>) moves <v_A1>.");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Default, Deserialize)]
#[serde(try_from = "String")]
pub struct Text {
    pieces: Vec<Piece>,
}

/// A part of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Words, as they are.
    Text(String),
    /// A place for a quantity.
    Placeholder(Placeholder),
}

/// A place for a quantity: `{{ v_A1 | motion }}`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placeholder {
    /// The name of the quantity, without blanks: `v_A1.x`, `J_A[hit]`, `v_A@top`, `angle(v_A2,v_B2)`.
    pub name: String,
    /// How it is to be said.
    pub filter: Filter,
    /// The bytes of the name in the text, for faults.
    pub span: Span,
    /// The bytes of the whole in the text, braces included.
    pub whole: Span,
}

/// How a quantity is said in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// Value and unit: `2 m/s`. No filter is written.
    Quantity,
    /// How a body moves: "at 2 m/s to the left", "is at rest".
    Motion,
    /// The number only.
    Value,
    /// The unit only.
    Unit,
    /// The direction only: "to the left", "30° above the x axis".
    Direction,
    /// The magnitude with its unit.
    Magnitude,
    /// The symbol only, so that the sheet tells no number: `$m_A$`.
    Symbol,
    /// The symbol and its value: `$m_A$ = 2 kg`.
    Named,
}

impl Filter {
    /// Whether the reader learns what the quantity is called.
    #[must_use]
    pub fn names(self) -> bool {
        matches!(self, Self::Symbol | Self::Named)
    }

    /// Whether the reader learns how large the quantity is, without a word on its direction.
    #[must_use]
    pub(crate) fn tells_size(self) -> bool {
        matches!(self, Self::Quantity | Self::Value | Self::Magnitude | Self::Named)
    }

    /// Whether what it says follows from the value.
    pub(crate) fn needs_value(self) -> bool {
        !matches!(self, Self::Symbol | Self::Unit)
    }

    /// Whether a formula may stand in place of the value that it says.
    pub(crate) fn takes_formula(self) -> bool {
        matches!(self, Self::Quantity | Self::Named)
    }

    /// Whether the reader learns a number.
    #[must_use]
    pub fn tells(self) -> bool {
        self != Self::Symbol
    }
}

/// The filters by the names that authors write.
const FILTERS: &[(&str, Filter)] = &[
    ("motion", Filter::Motion),
    ("value", Filter::Value),
    ("unit", Filter::Unit),
    ("direction", Filter::Direction),
    ("magnitude", Filter::Magnitude),
    ("symbol", Filter::Symbol),
    ("named", Filter::Named),
];

/// What the loader has found no fault in is read as it is typed.
impl TryFrom<String> for Text {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let faults = |faults: Vec<Fault>| faults.into_iter().map(|fault| fault.message).collect::<Vec<_>>().join("; ");
        Self::read(&text).map_err(faults)
    }
}

impl Text {
    /// Reads a text.
    ///
    /// # Errors
    /// Every placeholder that is not closed, is empty, is no name, or has an unknown filter, the first 50 of them; each fault has its
    /// place within the text.
    pub fn read(text: &str) -> Result<Self, Vec<Fault>> {
        let mut pieces = Vec::new();
        let mut faults = Vec::new();
        let find = |what: &str, from: usize| text[from..].find(what).map(|place| from + place);
        let mut at = 0;
        // Where the next `}}` stands; looked for again only once it is passed, so that a text is read once however often it is opened.
        let mut close = find("}}", 0);
        while let Some(open) = find("{{", at) {
            if faults.len() == MOST_FAULTS {
                break;
            }
            if open > at {
                pieces.push(Piece::Text(text[at..open].to_owned()));
            }
            if close.is_some_and(|close| close < open + 2) {
                close = find("}}", open + 2);
            }
            let opened_again = find("{{", open + 2);
            let Some(end) = close.filter(|close| opened_again.is_none_or(|again| again > *close)) else {
                let fault = Fault::new(Code::Text, "a placeholder is opened with `{{` but not closed");
                faults.push(fault.help("close it: `{{ m_A }}`").within(Span { start: open, end: open + 2 }));
                at = open + 2;
                continue;
            };
            at = end + 2;
            match placeholder(&text[open + 2..end], open + 2) {
                Ok(placeholder) => pieces.push(Piece::Placeholder(placeholder)),
                Err((message, help, span)) => faults.push(Fault::new(Code::Text, message).help(help).within(span)),
            }
        }
        if at < text.len() {
            pieces.push(Piece::Text(text[at..].to_owned()));
        }
        if faults.is_empty() { Ok(Self { pieces }) } else { Err(faults) }
    }

    /// This text and another one behind it. The places of the other's placeholders are those of the other.
    #[must_use]
    pub(crate) fn followed_by(&self, mut other: Self) -> Self {
        let mut pieces = self.pieces.clone();
        pieces.append(&mut other.pieces);
        Self { pieces }
    }

    /// The parts in order.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The placeholders in order.
    pub fn placeholders(&self) -> impl Iterator<Item = &Placeholder> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Placeholder(placeholder) => Some(placeholder),
            Piece::Text(_) => None,
        })
    }

    /// The names whose values it prints.
    pub(crate) fn printed_names(&self) -> BTreeSet<String> {
        let told = self.placeholders().filter(|placeholder| placeholder.filter.tells());
        told.map(|placeholder| placeholder.name.clone()).collect()
    }

    /// The text with each placeholder replaced.
    #[must_use]
    pub fn fill(&self, say: &dyn Fn(&Placeholder) -> String) -> String {
        let mut filled = String::new();
        for piece in &self.pieces {
            match piece {
                Piece::Text(words) => filled.push_str(words),
                Piece::Placeholder(placeholder) => filled.push_str(&say(placeholder)),
            }
        }
        filled
    }
}

/// The most faults that are told of a text: nobody reads more at a time.
const MOST_FAULTS: usize = 50;

type Wrong = (String, String, Span);

/// Reads what stands between the braces; `offset` is where that begins in the text.
fn placeholder(inside: &str, offset: usize) -> Result<Placeholder, Wrong> {
    let (written, filter) = match inside.split_once('|') {
        None => (inside, None),
        Some((name, filter)) => (name, Some((filter, offset + name.len() + 1))),
    };
    let span = trimmed(written, offset);
    let name: String = written.chars().filter(|letter| !letter.is_whitespace()).collect();
    if name.is_empty() {
        let whole = Span { start: offset, end: offset + inside.len() };
        return Err(("a placeholder is empty".into(), "write the name of a quantity: `{{ m_A }}`".into(), whole));
    }
    if !is_name(written.trim()) {
        let help = "a placeholder contains one name, such as `m_A`, `v_A1.x`, `v_A@top` or `J_A[hit]`; give a computed value a name under `given`";
        return Err((format!("`{}` is not the name of a quantity", written.trim()), help.into(), span));
    }
    let filter = match filter {
        None => Filter::Quantity,
        Some((word, start)) => {
            find_filter(word.trim()).map_err(|(message, help)| (message, help, trimmed(word, start)))?
        }
    };
    let whole = Span { start: offset - 2, end: offset + inside.len() + 2 };
    Ok(Placeholder { name, filter, span, whole })
}

fn find_filter(word: &str) -> Result<Filter, (String, String)> {
    if let Some((_, filter)) = FILTERS.iter().find(|(known, _)| *known == word) {
        return Ok(*filter);
    }
    let names = FILTERS.iter().map(|(known, _)| *known);
    let help = match did_you_mean(word, names.clone()) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("the filters are {}", names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")),
    };
    Err((format!("`{word}` is not a filter"), help))
}

fn trimmed(text: &str, offset: usize) -> Span {
    let start = offset + text.len() - text.trim_start().len();
    Span { start, end: start + text.trim().len() }
}

/// Whether a text is a name: a word, then at most one each of `@instant`, `[stage]` and `.component`, the last two in either order; or
/// an angle between two names.
#[must_use]
pub fn is_name(text: &str) -> bool {
    if let Some(pair) = text.strip_prefix("angle(").and_then(|rest| rest.strip_suffix(')')) {
        return pair
            .split_once(',')
            .is_some_and(|(first, second)| is_plain_name(first.trim()) && is_plain_name(second.trim()));
    }
    is_plain_name(text)
}

fn is_plain_name(text: &str) -> bool {
    let take_stage = |text| match str::strip_suffix(text, ']').and_then(|inner| inner.split_once('[')) {
        Some((rest, stage)) => (rest, Some(stage)),
        None => (text, None),
    };
    let (text, last) = take_stage(text);
    let (text, component) = match text.rsplit_once('.') {
        Some((rest, component)) => (rest, Some(component)),
        None => (text, None),
    };
    let (text, stage) = if last.is_some() { (text, last) } else { take_stage(text) };
    let (base, instant) = match text.split_once('@') {
        Some((base, instant)) => (base, Some(instant)),
        None => (text, None),
    };
    let word =
        |text: &str| !text.is_empty() && text.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
    let label = |text: &str| !text.is_empty() && text.split('-').all(word);
    word(base)
        && base.starts_with(|first: char| first.is_ascii_alphabetic())
        && instant.is_none_or(label)
        && stage.is_none_or(label)
        && component.is_none_or(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(text: &str) -> Vec<(String, &str)> {
        let faults = Text::read(text).unwrap_err();
        faults
            .into_iter()
            .map(|fault| (fault.message, fault.within.map(|at| &text[at.start..at.end]).unwrap()))
            .collect()
    }

    #[test]
    fn names_and_filters_are_read() {
        let text =
            Text::read("{{v_A@top.x|motion}} $\\sqrt{\\frac{a}{b}}$ {{ J_A[hit-2] }}{{ J_A.x[hit] }}{{ angle(v_A2, v_B2) | value }}")
                .unwrap();
        let read: Vec<_> = text.placeholders().map(|found| (found.name.as_str(), found.filter)).collect();
        let expected = [
            ("v_A@top.x", Filter::Motion),
            ("J_A[hit-2]", Filter::Quantity),
            ("J_A.x[hit]", Filter::Quantity),
            ("angle(v_A2,v_B2)", Filter::Value),
        ];
        assert_eq!(read, expected);
        assert_eq!(text.fill(&|_| "!".into()), "! $\\sqrt{\\frac{a}{b}}$ !!!");
    }

    #[test]
    fn every_fault_of_a_text_is_found_in_its_place() {
        let found = faults("{{ a {{ m_A | motoin }}, {{ 2*m }} and {{ }} é {{ x | y | z }}, {{");
        let places: Vec<_> = found.iter().map(|(_, place)| *place).collect();
        assert_eq!(places, ["{{", "motoin", "2*m", " ", "y | z", "{{"]);
    }

    #[test]
    fn what_is_not_a_name_is_refused() {
        for text in [
            "",
            "2m",
            "v_A1.",
            "J[",
            "J[]",
            "J]x[",
            "a b",
            "v@",
            "angle(v_A2)",
            "J[a][b]",
            "J.x[a].y",
            "é",
            "v.x.y",
            "a@b@c",
        ] {
            assert!(!is_name(text), "{text}");
        }
    }
}
