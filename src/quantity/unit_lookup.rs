//! From a written word to the unit that it names, or to the names nearest to it.

use super::Unit;
use super::prefix::{PREFIXES, Prefix};
use super::unit::Symbol;
use super::units_table::{SPELLINGS, UNITS, UnitRow};

impl Unit {
    /// Every unit of the table by itself, and those that take prefixes with each of them.
    pub fn all() -> impl Iterator<Item = Self> {
        let prefixed = |row: &'static UnitRow| PREFIXES.iter().filter(|_| row.prefixes).map(Some);
        let symbols = UNITS
            .iter()
            .flat_map(move |row| std::iter::once(None).chain(prefixed(row)).map(move |prefix| Symbol { prefix, row }));
        symbols.filter_map(|symbol| Self::from_powers([(symbol, 1)]))
    }
}

/// How many near names an unknown unit is answered with.
const MOST_NEAR: usize = 3;

/// The unit of that exact symbol, alias or name, prefixed or not. Whole words come first: `min` is a minute, not a milli-inch.
pub(super) fn find_symbol(word: &str) -> Option<Symbol> {
    let whole = UNITS.iter().find(|row| names(row).any(|name| name == word));
    whole.map(Symbol::plain).or_else(|| PREFIXES.iter().find_map(|prefix| find_prefixed(word, prefix)))
}

fn find_prefixed(word: &str, prefix: &'static Prefix) -> Option<Symbol> {
    let mut rows = UNITS.iter().filter(|row| row.prefixes);
    let short = |rest: &str| UNITS.iter().find(|row| row.prefixes && row.symbol == rest);
    let by_symbol = [prefix.symbol].iter().chain(prefix.aliases).find_map(|letter| short(word.strip_prefix(letter)?));
    let by_name = || {
        let rest = word.strip_prefix(prefix.name)?;
        let spoken = |row: &UnitRow| row.singular == rest || row.plural == rest;
        rows.find(|row| spoken(row) || row.aliases.contains(&rest) && rest != row.symbol)
    };
    Some(Symbol { prefix: Some(prefix), row: by_symbol.or_else(by_name)? })
}

/// How many bytes at the start are a name of several words, or one with a hyphen: `nautical miles`, `pound-mass`. Names such as
/// `miles per hour` are read word by word.
pub(super) fn long_name(text: &str) -> Option<usize> {
    let is_whole = |name: &str| !text[name.len()..].starts_with(char::is_alphabetic);
    let long = UNITS.iter().flat_map(names).filter(|name| name.contains([' ', '-']) && !name.contains(" per "));
    long.filter(|name| text.starts_with(name) && is_whole(name)).map(str::len).max()
}

/// Words that are told from others by their case alone, though not all of them stand in the table: a `Cal` is a thousand `cal`.
const CASE_MATTERS: [&str; 1] = ["Cal"];

/// The names that a word which is none would be in another case, one for each unit: `Newtons`, `KN`, `M`.
pub(super) fn in_other_case(word: &str) -> Vec<String> {
    if CASE_MATTERS.contains(&word) {
        return Vec::new();
    }
    let lower = word.to_lowercase();
    let is_same = |name: &str| name.to_lowercase() == lower;
    let whole = UNITS.iter().filter(|row| names(row).any(is_same)).map(Symbol::plain);
    let prefixed = PREFIXES.iter().flat_map(|prefix| {
        let named = |written: &str, name: &str| {
            lower.strip_prefix(&written.to_lowercase()).is_some_and(|rest| name.to_lowercase() == rest)
        };
        let is_meant = move |row: &&'static UnitRow| {
            let mut symbols = [prefix.symbol].into_iter().chain(prefix.aliases.iter().copied());
            let mut spoken = [row.singular, row.plural].into_iter();
            row.prefixes && (symbols.any(|text| named(text, row.symbol)) || spoken.any(|word| named(prefix.name, word)))
        };
        UNITS.iter().filter(is_meant).map(move |row| Symbol { prefix: Some(prefix), row })
    });
    let mut symbols: Vec<String> = whole.chain(prefixed).map(|symbol| symbol.to_string()).collect();
    let spelt = SPELLINGS.iter().filter(|(written, _)| is_same(written)).map(|(written, _)| (*written).to_owned());
    symbols.extend(spelt);
    // `kg` and the slip `Kg` of it are one.
    let mut meanings: Vec<Option<Unit>> = Vec::new();
    symbols.retain(|name| {
        let meaning = Unit::parse(name).ok();
        let is_new = !meanings.contains(&meaning);
        meanings.push(meaning);
        is_new
    });
    symbols
}

/// Finds the unit behind a word that is not a unit's own name.
pub(super) fn find_spelling(word: &str) -> Option<&'static str> {
    SPELLINGS.iter().find(|(written, _)| *written == word).map(|(_, meaning)| *meaning)
}

/// The names nearest to a word that is not known, the nearest first.
pub(super) fn near(word: &str) -> Vec<String> {
    let lower = word.to_lowercase();
    let length = word.chars().count();
    // Of a single letter only the case can be mistaken: every other single letter would be equally near.
    let allowed = if length < 2 { 0 } else { 1.max(length / 3) };
    let mut scored: Vec<(usize, String)> = Vec::new();
    for name in all_names() {
        let distance = strsim::damerau_levenshtein(&lower, &name.to_lowercase());
        if distance <= allowed {
            scored.push((distance, name));
        }
    }
    scored.sort_by_key(|(distance, _)| *distance);
    let mut nearest: Vec<String> = Vec::new();
    for (_, name) in scored {
        if nearest.len() < MOST_NEAR && nearest.iter().all(|known| find_symbol(known) != find_symbol(&name)) {
            nearest.push(name);
        }
    }
    nearest
}

/// Every name that is one word, the printed ones first.
fn all_names() -> impl Iterator<Item = String> {
    let with_prefix = |prefix: &'static Prefix| {
        UNITS.iter().filter(|row| row.prefixes).map(|row| Symbol { prefix: Some(prefix), row }.to_string())
    };
    let symbols = UNITS.iter().map(|row| row.symbol.to_owned());
    let others = UNITS.iter().flat_map(|row| names(row).map(str::to_owned));
    let all = symbols.chain(PREFIXES.iter().take(4).flat_map(with_prefix)).chain(others);
    all.filter(|name| !name.contains(' '))
}

fn names(row: &'static UnitRow) -> impl Iterator<Item = &'static str> {
    [row.symbol, row.singular, row.plural].into_iter().chain(row.aliases.iter().copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_one_meaning() {
        for row in UNITS {
            for name in names(row) {
                assert_eq!(find_symbol(name), Some(Symbol::plain(row)), "{name}");
            }
        }
        let whole: Vec<&str> = UNITS.iter().flat_map(names).collect();
        for prefix in PREFIXES {
            for row in UNITS.iter().filter(|row| row.prefixes) {
                let symbol = Symbol { prefix: Some(prefix), row };
                let written = symbol.to_string();
                assert!(!whole.contains(&written.as_str()), "{written} is also a whole word");
                assert_eq!(find_symbol(&written), Some(symbol), "{written}");
            }
        }
    }

    #[test]
    fn every_spelling_is_a_unit_and_hides_none() {
        for (written, meaning) in SPELLINGS {
            assert!(Unit::parse(meaning).is_ok(), "{meaning}");
            assert_eq!(find_spelling(meaning), None, "{meaning}");
            assert!(find_symbol(written).is_none(), "{written}");
        }
    }

    #[test]
    fn near_names_are_near() {
        let cases: [(&str, &[&str]); 6] = [
            ("kgg", &["kg", "kgf"]),
            ("n", &["N"]),
            ("hz", &["Hz"]),
            ("metrs", &["metre"]),
            ("q", &[]),
            ("furlong", &[]),
        ];
        for (word, expected) in cases {
            let found = near(word);
            assert!(expected.iter().all(|name| found.iter().any(|near| near == name)), "{word}: {found:?}");
            assert_eq!(found.is_empty(), expected.is_empty(), "{word}: {found:?}");
        }
    }
}
