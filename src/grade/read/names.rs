//! The names of the sheet in whatever spelling: `m_A`, `mA`, `m_{A}`, `μ_k`; and several side by side: `m1v1`.

use crate::expr::Symbol;
use crate::fault::did_you_mean;

use super::super::expected::ExpectedFormula;
use super::formula::allowed;
use super::unreadable::UnreadableKind;

/// Greek letters and other signs, and how problem files spell them.
const SPELT: [(char, &str); 26] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('µ', "mu"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('τ', "tau"),
    ('φ', "phi"),
    ('ϕ', "phi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Δ', "Delta"),
    ('₀', "0"),
    ('₁', "1"),
    ('₂', "2"),
    ('₃', "3"),
    ('₄', "4"),
    ('₅', "5"),
    ('ₓ', "x"),
    ('ₙ', "n"),
    ('ₜ', "t"),
];

/// Signs within a name that say nothing.
const SILENT: [char; 7] = ['_', '{', '}', '.', '\\', '[', ']'];

/// The most bytes of names side by side: every split of them is tried, so that none is read in silence.
const MAX_RUN: usize = 64;

/// The names that a formula may contain.
pub(super) struct Names<'a> {
    /// Each with its letters alone: `mA`. `None` is pi.
    known: Vec<(String, Option<Symbol>)>,
    asked: String,
    printed: Vec<&'a str>,
}

/// A name within a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    /// What it names; `None` is pi.
    pub(super) symbol: Option<Symbol>,
    /// How many bytes it takes.
    pub(super) length: usize,
}

impl<'a> Names<'a> {
    pub(super) fn new(asked: &'a ExpectedFormula) -> Self {
        let name = |symbol: Symbol| asked.symbols.entry(symbol).name.as_str();
        let mut known: Vec<(String, Option<Symbol>)> =
            allowed(asked).map(|symbol| (letters(name(symbol)), Some(symbol))).collect();
        known.push(("pi".to_owned(), None));
        Self { known, asked: letters(name(asked.asked)), printed: allowed(asked).map(name).collect() }
    }

    /// Whether a text is the name of what is asked.
    pub(super) fn is_asked(&self, text: &str) -> bool {
        letters(text) == self.asked
    }

    /// Whether a name is known, by its letters.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.known.iter().any(|(known, _)| known == name)
    }

    /// The first name of a text, where the letters up to the next sign are names in one way only. `None` where no letter
    /// stands there.
    pub(super) fn first(&self, text: &str) -> Result<Option<Segment>, UnreadableKind> {
        let run = &text[..run_length(text)];
        if run.len() > MAX_RUN {
            return Err(UnreadableKind::TooManyParts);
        }
        if run.is_empty() {
            return Ok(None);
        }
        let whole = letters(run);
        if let Some((_, symbol)) = self.known.iter().find(|(name, _)| *name == whole) {
            return Ok(Some(Segment { symbol: *symbol, length: run.len() }));
        }
        if whole == self.asked {
            return Err(UnreadableKind::AskedName(run.to_owned()));
        }
        let ways = self.ways(run);
        match ways.first() {
            Some(1) => self
                .segments(run, 0)
                .find(|segment| ways.get(segment.length) == Some(&1))
                .map(Some)
                .ok_or_else(|| self.unknown(run)),
            Some(0) | None => Err(self.unknown(run)),
            Some(_) => Err(UnreadableKind::AmbiguousName(run.to_owned())),
        }
    }

    /// In how many ways the run from each byte to its end is a product of names; two stands for more.
    fn ways(&self, run: &str) -> Vec<u8> {
        let mut ways = vec![0_u8; run.len() + 1];
        ways[run.len()] = 1;
        for (at, _) in run.char_indices().rev() {
            let found = self.segments(run, at).map(|segment| ways.get(at + segment.length).copied().unwrap_or(0));
            ways[at] = found.fold(0, u8::saturating_add).min(2);
        }
        ways
    }

    /// The names that stand at a byte of a run.
    fn segments<'s>(&'s self, run: &'s str, at: usize) -> impl Iterator<Item = Segment> + 's {
        self.known.iter().filter_map(move |(name, symbol)| {
            let length = matched(name, &run[at..])?;
            Some(Segment { symbol: *symbol, length })
        })
    }

    fn unknown(&self, run: &str) -> UnreadableKind {
        if letters(run) == "e" {
            return UnreadableKind::NotEuler;
        }
        let near = did_you_mean(run, self.printed.iter().copied()).map(str::to_owned);
        UnreadableKind::UnknownName { name: run.to_owned(), near }
    }
}

/// How many bytes at the start of a text spell a name, with the signs that may close it.
fn matched(name: &str, text: &str) -> Option<usize> {
    let mut rest = name;
    let mut open = 0_i32;
    let mut length = 0;
    for next in text.chars() {
        let spelt = SPELT.iter().find(|(sign, _)| *sign == next).map(|(_, spelt)| *spelt);
        if rest.is_empty() {
            if next == '}' && open > 0 {
                open -= 1;
                length += 1;
                continue;
            }
            break;
        }
        if SILENT.contains(&next) {
            open += i32::from(next == '{') - i32::from(next == '}');
        } else if let Some(spelt) = spelt {
            rest = rest.strip_prefix(spelt)?;
        } else {
            rest = rest.strip_prefix(next)?;
        }
        length += next.len_utf8();
    }
    // A name does not begin with a sign that says nothing, and a digit behind it would belong to it.
    let behind = text[length..].chars().next();
    let begins = text.starts_with(|first: char| first.is_alphabetic() || first == '\\');
    (rest.is_empty() && open == 0 && begins && !behind.is_some_and(is_index)).then_some(length)
}

fn is_index(next: char) -> bool {
    next.is_ascii_digit() || next == '_' || ('₀'..='₉').contains(&next)
}

/// The letters and digits of a name, without what only sets them.
fn letters(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for next in text.chars().filter(|next| !SILENT.contains(next)) {
        match SPELT.iter().find(|(sign, _)| *sign == next) {
            Some((_, spelt)) => plain.push_str(spelt),
            None => plain.push(next),
        }
    }
    plain
}

/// How many bytes at the start are letters, digits and what sets them as names.
fn run_length(text: &str) -> usize {
    let mut before = ' ';
    for (at, next) in text.char_indices() {
        let letter = next.is_alphabetic() || next == '\\';
        let inside = at > 0
            && (is_index(next)
                || next == '{' && before == '_'
                || next == '}' && text[..at].matches('{').count() > text[..at].matches('}').count());
        let point = next == '.' && text[at + 1..].starts_with(char::is_alphabetic) && at > 0;
        if !(letter || inside || point) {
            return at;
        }
        before = next;
    }
    text.len()
}
