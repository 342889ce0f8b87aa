//! A line as equations in the quantities of a problem, with a symbol for each number that stands in it.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_expr::SymbolTable;
use momentous_grade::WrittenNumber;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::sides::Compared;
use super::vectors::Vectors;

/// Larger whole numbers are no constants of a formula.
const LARGEST_WHOLE: u32 = 100;
/// Larger numbers of quarters are no constants of a formula.
const LARGEST_QUARTERS: u32 = 3;

/// The letters that lines may hold, and what each stands for.
#[derive(Clone, Debug)]
pub(crate) struct Alphabet {
    /// The quantities of the problem, and behind them the short names.
    pub(crate) symbols: SymbolTable,
    /// The quantities and short names that a line may hold.
    pub(crate) names: Vec<Symbol>,
    /// What each short name stands for.
    pub(crate) short: Vec<(Symbol, Expr)>,
    /// Spellings that are no names, each with the short name in its place: `|H_O1|`.
    pub(crate) spelt: Vec<(String, String)>,
    /// Short names that the student has introduced.
    pub(crate) own: BTreeSet<String>,
    /// The vectors of the problem.
    pub(crate) vectors: Vectors,
    /// The only limits between which the problem integrates over a variable, by its name.
    pub(crate) limits: BTreeMap<String, [Expr; 2]>,
}

impl Alphabet {
    /// Adds a short name for a term, where the problem has no quantity of that name.
    pub(crate) fn shorten(&mut self, name: &str, term: Expr) {
        let Ok(dimension) = term.dimension(&self.symbols) else { return };
        if let Some(known) = self.symbols.find(name) {
            // A letter of the student's own may be given another meaning.
            self.short
                .iter_mut()
                .filter(|(short, _)| *short == known && self.own.contains(name))
                .for_each(|(_, own)| *own = term.clone());
        } else {
            let short = self.symbols.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() });
            self.names.push(short);
            self.short.push((short, term));
        }
    }

    /// A term with what short names stand for; the variable of an integral stands for nothing.
    pub(crate) fn meant(&self, term: &Expr, variable: Option<Symbol>) -> Expr {
        let short = |symbol: Symbol| self.short.iter().find(|(short, _)| *short == symbol && Some(*short) != variable);
        term.substitute(&|symbol| short(symbol).map(|(_, own)| own.clone()))
    }
}

/// Two sides of a line.
#[derive(Clone, Debug)]
pub(crate) struct Statement {
    /// The left side.
    pub(crate) left: Expr,
    /// How the sides compare.
    pub(crate) compared: Compared,
    /// The right side.
    pub(crate) right: Expr,
}

impl Statement {
    /// The difference of the sides.
    pub(crate) fn residual(&self) -> Expr {
        Expr::sum([self.left.clone(), -self.right.clone()])
    }
}

/// A line in one reading.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    /// What it states, one after another; of the alternatives of each one has to hold, with all its statements.
    pub(crate) stated: Vec<Vec<Vec<Statement>>>,
    /// The numbers.
    pub(crate) numbers: Vec<WrittenNumber>,
    /// The quantities, and behind them the numbers.
    pub(crate) symbols: SymbolTable,
    /// The last side, on which a line that begins with a sign goes on.
    pub(crate) last: Option<Expr>,
}

impl Written {
    pub(crate) fn blank(alphabet: &Alphabet, before: Option<&Self>) -> Self {
        let symbols = before.map_or_else(|| alphabet.symbols.clone(), |before| before.symbols.clone());
        let numbers = before.map_or_else(Vec::new, |before| before.numbers.clone());
        Self { stated: Vec::new(), numbers, symbols, last: None }
    }

    /// Whether a symbol stands for a number.
    pub(crate) fn number(&self, symbol: Symbol) -> Option<&WrittenNumber> {
        self.numbers.iter().find(|number| number.symbol == symbol)
    }

    /// The number that a side is, perhaps with a sign.
    pub(crate) fn number_alone(&self, side: &Expr) -> Option<&WrittenNumber> {
        match side {
            Expr::Symbol(symbol) => self.number(*symbol),
            Expr::Product(parts) => match parts.as_ref() {
                [Expr::Number(_), Expr::Symbol(symbol)] => self.number(*symbol),
                _ => None,
            },
            _ => None,
        }
    }

    /// The quantity that a side is.
    pub(crate) fn letter_alone(&self, side: &Expr) -> Option<Symbol> {
        match side {
            Expr::Symbol(symbol) if self.number(*symbol).is_none() => Some(*symbol),
            _ => None,
        }
    }

    /// Whether each term holds a quantity and each bare number may be a constant, so that bare numbers are pure.
    pub(crate) fn is_in_symbols(&self) -> bool {
        let is_measured =
            |own: &WrittenNumber| own.unit.as_ref().is_some_and(|unit| unit.dimension() != Dimension::NONE);
        self.is_made_of(
            |own| own.unit.is_some() || is_constant(&own.value),
            |own| is_measured(own) || own.value.is_zero(),
        )
    }

    /// Whether each term holds a letter or is zero, and each number is a constant of a formula: no value stands in it.
    pub(crate) fn is_in_letters(&self) -> bool {
        self.is_made_of(
            |own| own.unit.is_none() && is_constant(&own.value),
            |own| own.unit.is_none() && own.value.is_zero(),
        )
    }

    /// Whether its numbers are such, and each term holds a letter or a number that is as good as one.
    fn is_made_of(
        &self,
        is_such: impl Fn(&WrittenNumber) -> bool,
        is_as_letter: impl Fn(&WrittenNumber) -> bool,
    ) -> bool {
        let is_letter = |symbol: &Symbol| self.number(*symbol).is_none_or(&is_as_letter);
        let has_letter = |term: &Expr| term.is_zero() || term.symbols().iter().any(is_letter);
        let side = |side: &Expr| match side {
            Expr::Sum(terms) => terms.iter().all(has_letter),
            other => has_letter(other),
        };
        self.numbers.iter().all(is_such) && self.statements().all(|own| side(&own.left) && side(&own.right))
    }

    /// The quantities in it, without its numbers.
    pub(crate) fn quantities(&self) -> BTreeSet<Symbol> {
        let symbols = self.statements().flat_map(|own| own.left.symbols().into_iter().chain(own.right.symbols()));
        symbols.filter(|symbol| self.number(*symbol).is_none()).collect()
    }

    /// All statements.
    pub(crate) fn statements(&self) -> impl Iterator<Item = &Statement> {
        self.stated.iter().flatten().flatten()
    }
}

/// Whether a number is such as stands in formulas: `2`, `1/2`, `0.75`.
fn is_constant(value: &Rational) -> bool {
    let quarters = value * Rational::from(4);
    let largest = if value.is_int() { LARGEST_WHOLE } else { LARGEST_QUARTERS };
    quarters.is_int() && *value <= Rational::from(largest)
}
