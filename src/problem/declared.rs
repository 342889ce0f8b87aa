//! Which names of the author's own a file gives a dimension, before the scene is read.

use std::collections::BTreeSet;

use crate::quantity::Dimension;
use crate::quantity::Unit;

use super::ask::Ask;
use super::document::Kind;
use super::document::Node;
use super::given::Given;
use super::load::Loaded;
use super::text::is_name;

/// Every name whose dimension the file says, with its dimension.
pub(super) fn declared(loaded: &Loaded) -> Vec<(String, Dimension)> {
    loaded.given.iter().filter_map(of_given).chain(sought(loaded)).collect()
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
    let Spoken { within, alone } = &loaded.spoken;
    let asked = loaded.questions.iter().flat_map(|question| &question.ask);
    asked.filter_map(move |ask| match ask {
        Ask::Find(find)
            if within.contains(&find.find) && !alone.contains(&find.find) && loaded.given.get(&find.find).is_none() =>
        {
            let unit = Unit::parse(find.unit.as_deref().unwrap_or_default()).ok()?;
            Some((find.find.clone(), unit.dimension()))
        }
        _ => None,
    })
}

/// The words of a file's scene and relations: those within longer texts, and those that stand alone.
#[derive(Clone, Debug, Default)]
pub(super) struct Spoken {
    within: BTreeSet<String>,
    alone: BTreeSet<String>,
}

impl Spoken {
    pub(super) fn of(root: &Node) -> Self {
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
