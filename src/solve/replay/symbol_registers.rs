//! Which register holds which symbol.

use momentous_expr::Symbol;

use super::tape::Register;

/// The registers of symbols, by the position of each symbol in its table.
#[derive(Clone, Debug, Default)]
pub(crate) struct SymbolRegisters(Vec<Option<(Symbol, Register)>>);

impl SymbolRegisters {
    /// The register of a symbol, where it has one.
    #[inline]
    pub(crate) fn get(&self, symbol: Symbol) -> Option<Register> {
        self.0.get(symbol.index()).copied().flatten().map(|(_, register)| register)
    }

    /// Whether a symbol has a register.
    #[inline]
    pub(crate) fn holds(&self, symbol: Symbol) -> bool {
        self.get(symbol).is_some()
    }

    /// Gives a symbol its register, in place of any that it had.
    pub(crate) fn insert(&mut self, symbol: Symbol, register: Register) {
        let place = symbol.index();
        self.0.resize(self.0.len().max(place + 1), None);
        self.0[place] = Some((symbol, register));
    }

    /// The symbols with their registers, in the order of their table.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Symbol, Register)> {
        self.0.iter().flatten().copied()
    }
}

impl Extend<(Symbol, Register)> for SymbolRegisters {
    fn extend<T: IntoIterator<Item = (Symbol, Register)>>(&mut self, held: T) {
        for (symbol, register) in held {
            self.insert(symbol, register);
        }
    }
}
