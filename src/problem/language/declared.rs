//! Which names of the author's own a file gives a dimension, before the scene is read.

use std::collections::BTreeSet;

use crate::expr::Names;
use crate::expr::Symbol;
use crate::expr::SymbolEntry;
use crate::expr::SymbolTable;
use crate::expr::parse;
use crate::quantity::Dimension;
use crate::quantity::Quantity;
use crate::quantity::Unit;

use super::super::reading::document::Kind;
use super::super::reading::document::Node;
use super::super::reading::load::Loaded;
use super::ask::Ask;
use super::given::Given;
use super::text::is_name;

/// Every name whose dimension the file says, with its dimension.
pub(in crate::problem) fn declared(loaded: &Loaded) -> Vec<(String, Dimension)> {
    let mut known: Vec<(String, Dimension)> = loaded.given.iter().filter_map(of_given).chain(sought(loaded)).collect();
    // One may be given by another that is given by a third.
    loop {
        let is_new = |name: &str| is_within_only(loaded, name) && known.iter().all(|(own, _)| own != name);
        let found = loaded.given.iter().filter(|(name, _)| is_new(name));
        let found: Vec<_> = found.filter_map(|own| of_expression(own, &known)).collect();
        if found.is_empty() {
            return known;
        }
        known.extend(found);
    }
}

/// Whether the file refers to a name only within longer terms of its scene and its relations. One that stands alone is told by its
/// place.
fn is_within_only(loaded: &Loaded, name: &str) -> bool {
    loaded.spoken.within.contains(name) && !loaded.spoken.alone.contains(name)
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
        let (_, dimension) = self.known.iter().find(|(own, _)| own == name)?;
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

/// Names that are asked, and that the file refers to only within longer terms of its scene and its relations: the unit in
/// which they are asked says what they are. A name that stands alone is told by its place.
fn sought(loaded: &Loaded) -> impl Iterator<Item = (String, Dimension)> + '_ {
    let asked = loaded.questions.iter().flat_map(|question| &question.ask);
    asked.filter_map(|ask| match ask {
        Ask::Find(find) if is_within_only(loaded, &find.find) && loaded.given.get(&find.find).is_none() => {
            Some((find.find.clone(), Unit::parse(find.unit.as_deref()?).ok()?.dimension()))
        }
        _ => None,
    })
}

/// The same, where no unit says what they are: as their formulas are asked.
pub(in crate::problem) fn unmeasured(loaded: &Loaded) -> BTreeSet<String> {
    let asked = loaded.questions.iter().flat_map(|question| &question.ask);
    let names = asked.filter_map(|ask| match ask {
        Ask::Find(find) if find.unit.as_deref().is_none_or(|unit| Unit::parse(unit).is_err()) => Some(&find.find),
        _ => None,
    });
    names.filter(|name| is_within_only(loaded, name) && loaded.given.get(name).is_none()).cloned().collect()
}

/// The words of a file's scene and relations: those within longer texts, and those that stand alone.
#[derive(Clone, Debug, Default)]
pub(in crate::problem) struct Spoken {
    within: BTreeSet<String>,
    alone: BTreeSet<String>,
}

impl Spoken {
    pub(in crate::problem) fn of(root: &Node) -> Self {
        let mut spoken = Self::default();
        for entry in ["scene", "relations"].into_iter().filter_map(|key| root.entry(key)) {
            spoken.listen(&entry.value);
        }
        spoken
    }

    /// Documents are of bounded depth.
    fn listen(&mut self, node: &Node) {
        match &node.kind {
            Kind::Scalar(scalar) if is_name(scalar.text.trim()) => {
                self.alone.insert(scalar.text.trim().to_owned());
            }
            Kind::Scalar(scalar) => {
                let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
                self.within.extend(scalar.text.split(|letter| !is_part(letter)).map(str::to_owned));
            }
            Kind::List(items) => items.iter().for_each(|item| self.listen(item)),
            Kind::Mapping(entries) => entries.iter().for_each(|entry| self.listen(&entry.value)),
        }
    }
}
