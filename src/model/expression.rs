//! Expressions that questions ask for: each is a quantity of its own, with the equation that says what it is.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::geometry;
use momentous_quantity::Rational;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;

use super::Because;
use super::Builder;
use super::Name;
use super::QuantityKind;
use super::check;
use super::name::is_bare_name;

impl Builder<'_> {
    /// The quantity `id`, which is the value of an expression: the same one each time for the same expression. `path` is the
    /// question; faults are noted.
    pub fn expression(&mut self, id: &str, text: &str, meaning: Option<&str>, path: &Path) -> Option<Symbol> {
        let known = self.faults.len();
        let term = self.read_any(text, &path.key("find"));
        if self.faults.len() > known {
            return None;
        }
        let existing = self.resolve(id);
        if let Some(symbol) = existing.filter(|symbol| self.expressions.get(symbol) == Some(&term)) {
            return Some(symbol);
        }
        let dimension = if !is_bare_name(id) {
            let fault = Fault::new(Code::Value, format!("`{id}` is not a name"));
            Err(fault.help("write letters, digits and `_`, beginning with a letter: `gap`").at_path(path.key("id")))
        } else if existing.is_some() || check::is_structural(self.scene, id) {
            let fault = Fault::new(Code::Duplicate, format!("`{id}` stands for something else in this problem"));
            Err(fault.help("choose another name").at_path(path.key("id")))
        } else if term.symbols().iter().all(|symbol| self.is_literal(*symbol)) {
            let fault = Fault::new(Code::Value, format!("`{text}` contains no quantity"));
            Err(fault.help("write an expression of quantities: `v_B2 - v_A2`").at_path(path.key("find")))
        } else {
            term.dimension(&self.symbols).map_err(|clash| {
                let unit = |dimension| coherent_unit(dimension, UnitSystem::Si).to_string();
                let message = format!("`{text}` cannot be evaluated: {}", clash.sentence(&self.symbols, &unit));
                Fault::new(Code::Dimension, message).help("check its units").at_path(path.key("find"))
            })
        };
        match dimension {
            Ok(dimension) => {
                let name = Name::of(QuantityKind::Own(id.to_owned()), "");
                let meaning = meaning.map(str::to_owned).or_else(|| self.spoken(&term));
                let meaning = meaning.unwrap_or_else(|| format!("the value of {text}"));
                let symbol = self.symbol_of(name, dimension, &meaning);
                self.named_at(symbol, &path.key("id"));
                self.law(&geometry::ASKED, None, Because::Definition, (symbol.into(), term.clone()));
                self.expressions.insert(symbol, term);
                Some(symbol)
            }
            Err(fault) => {
                self.faults.push(fault);
                None
            }
        }
    }

    /// A name for the answer to a question for a term that the author gave none: by its last operation, and by a letter
    /// where another term has that name.
    pub fn name_for(&mut self, text: &str) -> String {
        let term = self.read_any(text, &Path::root());
        let kind = operation(&term);
        let letters = ('b'..='z').map(|letter| format!("{kind}_{letter}"));
        let mut names = std::iter::once(kind.to_owned()).chain(letters);
        let is_free = |name: &String| match self.resolve(name) {
            Some(symbol) => self.expressions.get(&symbol) == Some(&term),
            None => !check::is_structural(self.scene, name),
        };
        names.find(is_free).unwrap_or_else(|| kind.to_owned())
    }
}

/// The noun for the result of the last operation of a term.
fn operation(term: &Expr) -> &'static str {
    let is_negative = |part: &Expr| matches!(part, Expr::Product(factors) if matches!(factors[0], Expr::Number(ref number) if *number < Rational::ZERO));
    let is_divisor = |part: &Expr| matches!(part, Expr::Power(power) if matches!(power.1, Expr::Number(ref exponent) if *exponent < Rational::ZERO));
    match term {
        Expr::Sum(terms) if terms.iter().any(is_negative) => "difference",
        Expr::Sum(_) => "sum",
        Expr::Product(factors) if factors.iter().any(is_divisor) => "ratio",
        Expr::Product(_) => "product",
        Expr::Apply(Function::Abs, _) => "magnitude",
        _ => "value",
    }
}
