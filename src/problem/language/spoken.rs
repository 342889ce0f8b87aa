//! The words of a file's scene and relations, as they stand before the scene is read.

use std::collections::BTreeSet;

use super::super::reading::document::Kind;
use super::super::reading::document::Node;
use super::text::is_name;

/// The words of a file's scene and relations: those within longer texts, and those that stand alone; and those of its givens.
#[derive(Clone, Debug, Default)]
pub(crate) struct Spoken {
    within: BTreeSet<String>,
    alone: BTreeSet<String>,
    /// Those within longer texts under `given`.
    given: BTreeSet<String>,
}

impl Spoken {
    /// Those of a file.
    pub(crate) fn of(root: &Node) -> Self {
        let mut spoken = Self::default();
        for entry in ["scene", "relations"].into_iter().filter_map(|key| root.entry(key)) {
            spoken.listen(&entry.value);
        }
        let mut given = Self::default();
        root.entry("given").into_iter().for_each(|entry| given.listen(&entry.value));
        spoken.given = given.within;
        spoken
    }

    /// Whether a name is spoken only within terms of other givens: the scene says nothing of it.
    fn is_of_givens_only(&self, name: &str) -> bool {
        self.given.contains(name) && !self.within.contains(name) && !self.alone.contains(name)
    }

    /// Whether a name is spoken only within longer terms of the scene, the relations or the givens.
    pub(super) fn is_within_terms_only(&self, name: &str) -> bool {
        self.is_within_only(name) || self.is_of_givens_only(name)
    }

    /// Whether a name is spoken only within longer terms of the scene and the relations. One that stands alone is told by its place.
    pub(super) fn is_within_only(&self, name: &str) -> bool {
        self.within.contains(name) && !self.alone.contains(name)
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
            Kind::Mapping(mapping) => mapping.entries().iter().for_each(|entry| self.listen(&entry.value)),
        }
    }
}
