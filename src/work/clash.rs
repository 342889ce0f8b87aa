//! Dimensions that clash in a line.

use momentous_expr::SymbolTable;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;

use super::meaning::Meanings;
use super::written::Written;

/// The sets of meanings in which no dimensions clash. Only in a line in symbols, whose numbers are not computed, is a bare number known to
/// have none.
///
/// # Errors
/// The clash, in words, where there is one whatever the numbers stand for.
pub(crate) fn without_clash(line: &Written, sets: &[Meanings]) -> Result<Vec<Meanings>, String> {
    let is_measured = |set: &Meanings| line.is_in_symbols() && set.is_general(line);
    let (mut kept, mut first) = (Vec::new(), None);
    for set in sets {
        match clash(line, set, &line.symbols).filter(|_| is_measured(set)) {
            Some(name) => _ = first.get_or_insert(name),
            None => kept.push(set.clone()),
        }
    }
    match first {
        Some(clash) if !kept.iter().any(is_measured) => Err(clash),
        _ => Ok(kept),
    }
}

/// The dimensions that clash in a line, in words.
fn clash(line: &Written, meanings: &Meanings, symbols: &SymbolTable) -> Option<String> {
    let unit = |dimension| coherent_unit(dimension, UnitSystem::Si).to_string();
    line.statements().find_map(|statement| {
        let [left, right] = [&statement.left, &statement.right].map(|side| meanings.put_into(line, side));
        let clash = left.common_dimension(&right, symbols).err()?;
        Some(clash.sentence(symbols, &unit))
    })
}
