//! Which names of the author's own a file gives a dimension, before the scene is read.

use std::collections::BTreeSet;

use crate::quantity::Dimension;
use crate::quantity::Unit;

use super::ask::Ask;
use super::given::Given;
use super::load::Loaded;

/// Every name whose dimension the file says, with its dimension.
pub(super) fn declared(loaded: &Loaded) -> Vec<(String, Dimension)> {
    loaded.given.iter().filter_map(of_given).chain(sought_in_relations(loaded)).collect()
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

/// Names that only the problem's own relations speak of, and that are asked: the unit in which they are asked says what
/// they are.
fn sought_in_relations(loaded: &Loaded) -> impl Iterator<Item = (String, Dimension)> {
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
    let spoken: BTreeSet<&str> =
        loaded.draft.relations.iter().flat_map(|relation| relation.equation.split(|letter| !is_part(letter))).collect();
    let asked = loaded.questions.iter().flat_map(|question| &question.ask);
    asked.filter_map(move |ask| match ask {
        Ask::Find(find) if spoken.contains(find.find.as_str()) && loaded.given.get(&find.find).is_none() => {
            let unit = Unit::parse(find.unit.as_deref().unwrap_or_default()).ok()?;
            Some((find.find.clone(), unit.dimension()))
        }
        _ => None,
    })
}
