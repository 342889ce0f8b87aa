//! Which names of the author's own a file gives a dimension, before the scene is read.

use std::collections::BTreeSet;

use momentous_expr::Names;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_expr::SymbolTable;
use momentous_expr::parse;
use momentous_quantity::Dimension;
use momentous_quantity::Quantity;
use momentous_quantity::Unit;

use super::super::reading::load::Loaded;
use super::ask::Ask;
use super::given::Given;

/// Every name whose dimension the file says, with its dimension.
pub(crate) fn declared(loaded: &Loaded) -> Vec<(String, Dimension)> {
    let mut known: Vec<(String, Dimension)> = loaded.given.iter().filter_map(of_given).chain(sought(loaded)).collect();
    // One may be given by another that is given by a third.
    loop {
        let is_new = |name: &str| loaded.spoken.is_within_only(name) && known.iter().all(|(known, _)| known != name);
        let expressions = loaded.given.iter().filter(|(name, _)| is_new(name));
        let expressions: Vec<_> = expressions.filter_map(|pair| of_expression(pair, &known)).collect();
        if expressions.is_empty() {
            return known;
        }
        known.extend(expressions);
    }
}

/// Name and dimension of a given that is an expression of names whose dimension is known.
fn of_expression((name, given): (&str, &Given), known: &[(String, Dimension)]) -> Option<(String, Dimension)> {
    let Given::Expression(text) = given else { return None };
    let mut names = Declared { known, table: SymbolTable::default() };
    let term = parse(text, &mut names).ok()?;
    Some((name.to_owned(), term.dimension(&names.table).ok()?))
}

/// The names whose dimension the file says.
struct Declared<'a> {
    known: &'a [(String, Dimension)],
    table: SymbolTable,
}

impl Declared<'_> {
    fn measured(&mut self, name: &str, dimension: Dimension) -> Symbol {
        self.table.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() })
    }
}

impl Names for Declared<'_> {
    fn symbol(&mut self, name: &str) -> Option<Symbol> {
        let (_, dimension) = self.known.iter().find(|(known, _)| known == name)?;
        Some(self.measured(name, *dimension))
    }

    fn literal(&mut self, text: &str) -> Option<Symbol> {
        let quantity = Quantity::parse(text).ok()?;
        Some(self.measured(text, quantity.unit.dimension()))
    }
}

/// Name and dimension of a given whose unit says it.
fn of_given((name, given): (&str, &Given)) -> Option<(String, Dimension)> {
    let unit = match given {
        Given::Literal(literal) => &literal.unit,
        Given::Drawn { unit, .. } | Given::Any(Some(unit)) => unit,
        Given::Any(None) | Given::Expression(_) => return None,
    };
    Some((name.to_owned(), unit.dimension()))
}

/// Names that are asked, and that the file refers to only within longer terms of its scene, its relations and its givens: the
/// unit in which they are asked says what they are. A name that stands alone is told by its place.
fn sought(loaded: &Loaded) -> impl Iterator<Item = (String, Dimension)> + '_ {
    let asked = loaded.questions.iter().flat_map(|question| &question.ask);
    asked.filter_map(|ask| match ask {
        Ask::Find(find) if loaded.spoken.is_within_terms_only(&find.find) && loaded.given.get(&find.find).is_none() => {
            Some((find.find.clone(), Unit::parse(find.unit.as_deref()?).ok()?.dimension()))
        }
        _ => None,
    })
}

/// The same, where no unit says what they are: as their formulas are asked, or as they may be anything.
pub(crate) fn unmeasured(loaded: &Loaded) -> BTreeSet<String> {
    let asked = loaded.questions.iter().flat_map(|question| &question.ask);
    let names = asked.filter_map(|ask| match ask {
        Ask::Find(find) if find.unit.as_deref().is_none_or(|unit| Unit::parse(unit).is_err()) => Some(&find.find),
        _ => None,
    });
    let asked = names.filter(|name| loaded.given.get(name).is_none()).map(String::as_str);
    let open = loaded.given.iter().filter(|(_, given)| matches!(given, Given::Any(None))).map(|(name, _)| name);
    let open = open.filter(|name| loaded.spoken.is_within_terms_only(name));
    asked.filter(|name| loaded.spoken.is_within_only(name)).chain(open).map(str::to_owned).collect()
}
