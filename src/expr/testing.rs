//! Terms for tests, written as text; names become symbols of a table in order of appearance.

use momentous_quantity::Dimension;

use super::{Expr, Names, ParseFault, Symbol, SymbolEntry, SymbolTable, parse};

/// Knows every name but `unknown` and `angle` (which is one with names in brackets after it), and the units m, s, kg, m/s and kg m/s.
#[derive(Default)]
pub(super) struct AnyName(pub(super) SymbolTable);

impl AnyName {
    fn add(&mut self, name: &str) -> Symbol {
        let dimension = match name.split('_').next().unwrap_or_default() {
            "m" => Dimension::MASS,
            "v" | "u" => Dimension::VELOCITY,
            "t" => Dimension::TIME,
            "x" | "h" => Dimension::LENGTH,
            "F" => Dimension::FORCE,
            _ => Dimension::NONE,
        };
        self.0.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() })
    }

    /// The symbol of that name.
    pub(super) fn named(&mut self, name: &str) -> Symbol {
        self.add(name)
    }

    /// The term, or the fault.
    pub(super) fn read(&mut self, text: &str) -> Result<Expr, ParseFault> {
        parse(text, self)
    }

    /// The term; the number 404 where the text is not one, so that a test that hides a fault fails.
    pub(super) fn term(&mut self, text: &str) -> Expr {
        self.read(text).unwrap_or_else(|_| Expr::integer(404))
    }
}

impl Names for AnyName {
    fn symbol(&mut self, name: &str) -> Option<Symbol> {
        (!["unknown", "angle"].contains(&name)).then(|| self.add(name))
    }

    fn literal(&mut self, text: &str) -> Option<Symbol> {
        let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.' || c == ' ');
        ["m", "s", "kg", "m/s", "m/s^2", "kg m/s"].contains(&unit).then(|| self.add(text))
    }
}
