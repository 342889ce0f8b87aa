//! Dimensions that clash in a line.

use super::holds::clash;
use super::meaning::Meanings;
use super::written::Written;

/// The dimensions that clash in a line in symbols, whatever its numbers stand for.
pub(crate) fn clash_in_symbols(line: &Written, sets: &[Meanings]) -> Option<String> {
    if !line.is_in_symbols() {
        return None;
    }
    let clashes = sets.iter().filter(|set| set.is_general(line)).map(|set| clash(line, set, &line.symbols));
    clashes.collect::<Option<Vec<String>>>()?.into_iter().next()
}
