//! The named quantities of one problem.

use momentous_quantity::Dimension;

/// A quantity of one problem; an index into its [`SymbolTable`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(u32);

impl Symbol {
    /// The position of the symbol in its table.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The facts that a problem states of a symbol.
#[derive(Clone, Debug)]
pub struct SymbolEntry {
    /// The name in problem files and answers: `v_A1.x`, `J_A[hit]`.
    pub name: String,
    /// The dimension of its value.
    pub dimension: Dimension,
    /// Its meaning as a noun phrase: `the velocity of cart A just before the impact`.
    pub meaning: String,
}

/// The symbols of one problem, in the order in which they were made.
#[derive(Clone, Debug, Default)]
pub struct SymbolTable {
    entries: Vec<SymbolEntry>,
}

impl SymbolTable {
    /// Adds a symbol, or finds the one of that name.
    pub fn intern(&mut self, entry: SymbolEntry) -> Symbol {
        if let Some(symbol) = self.find(&entry.name) {
            return symbol;
        }
        let index = u32::try_from(self.entries.len()).unwrap_or(u32::MAX);
        self.entries.push(entry);
        Symbol(index)
    }

    /// Says what a symbol is.
    pub fn describe(&mut self, symbol: Symbol, meaning: String) {
        if let Some(entry) = self.entries.get_mut(symbol.index()) {
            entry.meaning = meaning;
        }
    }

    /// Says which dimension a symbol has.
    pub fn measure(&mut self, symbol: Symbol, dimension: Dimension) {
        if let Some(entry) = self.entries.get_mut(symbol.index()) {
            entry.dimension = dimension;
        }
    }

    /// Whether it is said what a symbol is.
    #[must_use]
    pub fn is_described(&self, symbol: Symbol) -> bool {
        !self.entry(symbol).meaning.is_empty()
    }

    /// The symbol of that exact name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<Symbol> {
        let index = self.entries.iter().position(|entry| entry.name == name)?;
        u32::try_from(index).ok().map(Symbol)
    }

    /// The entry of a symbol of this table.
    #[must_use]
    pub fn entry(&self, symbol: Symbol) -> &SymbolEntry {
        &self.entries[symbol.index()]
    }

    /// The same symbols under other names.
    #[must_use]
    pub fn renamed(&self, name: &dyn Fn(&str) -> String) -> Self {
        let entry = |entry: &SymbolEntry| SymbolEntry { name: name(&entry.name), ..entry.clone() };
        Self { entries: self.entries.iter().map(entry).collect() }
    }

    /// All symbols with their entries, in order.
    pub fn iter(&self) -> impl Iterator<Item = (Symbol, &SymbolEntry)> {
        (0..).map(Symbol).zip(&self.entries)
    }

    /// The number of symbols.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }
}
