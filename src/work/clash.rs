//! Dimensions that clash in a line.

use momentous_expr::SymbolTable;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;

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

/// The dimensions that clash in a line, in words.
fn clash(line: &Written, meanings: &Meanings, symbols: &SymbolTable) -> Option<String> {
    let unit = |dimension| coherent_unit(dimension, UnitSystem::Si).to_string();
    line.statements().find_map(|own| {
        let [left, right] = [&own.left, &own.right].map(|side| meanings.put_into(line, side));
        let found = left.common_dimension(&right, symbols).err()?;
        Some(found.sentence(symbols, &unit))
    })
}
