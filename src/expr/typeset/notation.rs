//! The letters that a course writes for quantities: L for momentum, I for impulse.

use super::super::Math;
use super::super::SymbolTable;
use super::super::name_math;

/// Which letters stand for others at the beginning of a name. Problem files keep the usual ones; what is printed, and what a
/// student types, has the course's.
///
/// ```
/// use momentous_expr::Notation;
/// let course = Notation::new([("J", "I"), ("p", "L")]);
/// assert_eq!(course.name("J_A[hit]"), "I_A[hit]");
/// assert_eq!(course.math("p_A1.x").latex(), "(L_{A1})_{x}");
/// assert_eq!(course.name("v_A1"), "v_A1");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Notation {
    letters: Vec<(&'static str, String)>,
}

impl Notation {
    /// A notation with these letters, each beside the usual one for which it stands.
    #[must_use]
    pub fn new<'a>(letters: impl IntoIterator<Item = (&'static str, &'a str)>) -> Self {
        Self { letters: letters.into_iter().map(|(usual, letter)| (usual, letter.to_owned())).collect() }
    }

    /// Whether it is the usual one.
    #[must_use]
    pub fn is_usual(&self) -> bool {
        self.letters.is_empty()
    }

    /// The name as the course writes it: that of a quantity, or that of its direction (`angle_J_A`).
    #[must_use]
    pub fn name(&self, name: &str) -> String {
        let (front, rest) = name.strip_prefix("angle_").map_or(("", name), |rest| ("angle_", rest));
        let (base, behind) = rest.split_at(rest.find('_').unwrap_or(rest.len()));
        match self.letters.iter().find(|(usual, _)| *usual == base && !behind.is_empty()) {
            Some((_, letter)) => format!("{front}{letter}{behind}"),
            None => name.to_owned(),
        }
    }

    /// Finds the usual name that is meant by a typed text, in the usual letters or in the course's; returns the text
    /// itself where it is none of them.
    #[must_use]
    pub fn usual<'a>(&self, names: impl IntoIterator<Item = &'a str>, typed: &'a str) -> &'a str {
        let meant = |name: &&str| *name == typed || self.name(name) == typed;
        if self.is_usual() { typed } else { names.into_iter().find(meant).unwrap_or(typed) }
    }

    /// The name, typeset.
    #[must_use]
    pub fn math(&self, name: &str) -> Math {
        name_math(&self.name(name))
    }

    /// The symbols under the names that the course writes.
    #[must_use]
    pub fn table(&self, symbols: &SymbolTable) -> SymbolTable {
        symbols.renamed(&|name| self.name(name))
    }
}
