//! A choice that is settled by whether terms are equal: what is conserved, and of which kind an impact is.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;

use super::super::equality::Equality;

/// A choice between phrases, each right in one case.
#[derive(Clone, Debug)]
pub struct Judgement {
    pub(crate) options: Vec<String>,
    /// In order: the first of which all tests hold is right. The last has none.
    pub(crate) cases: Vec<Case>,
    pub(crate) behind: Option<Behind>,
    pub(crate) confusions: &'static [Confusion],
    /// Whether what changes on the way has its value again at the end.
    pub(crate) returns: Vec<Equality>,
}

/// A phrase that may be right.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    /// The position of the phrase.
    pub right: usize,
    /// The ways that the scene has to go: each a choice, counted from 0, and what happens there.
    pub ways: Vec<(usize, String)>,
    /// The conditions of this case.
    pub tests: Vec<Test>,
    /// Why it is right, as a sentence without a full stop; empty where that is what a test says that does not hold.
    pub because: String,
}

/// Two terms that have to be equal, and what to say where they are not.
#[derive(Clone, Debug)]
pub(crate) struct Test {
    pub equality: Equality,
    pub otherwise: String,
}

/// The mistake of whoever takes one phrase for another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Confusion {
    pub chosen: usize,
    pub right: usize,
    pub mistake: &'static Misconception,
}

/// The mistake behind a wrong phrase.
#[derive(Clone, Debug)]
pub(crate) struct Behind {
    pub mistake: &'static Misconception,
    /// The phrase that is right where it is made.
    pub right: usize,
    /// Nobody makes it where all of these hold.
    pub unless: Vec<Test>,
}

impl Case {
    pub(crate) fn new(right: usize, tests: Vec<Test>, because: impl Into<String>) -> Self {
        Self { right, ways: Vec::new(), tests, because: because.into() }
    }

    /// The same where the scene goes these ways only.
    pub(crate) fn only(self, ways: Vec<(usize, String)>) -> Self {
        Self { ways, ..self }
    }
}

impl Test {
    pub(crate) fn new(equality: Equality, otherwise: impl Into<String>) -> Self {
        Self { equality, otherwise: otherwise.into() }
    }
}

impl Judgement {
    pub(crate) fn new(options: &[&str], cases: Vec<Case>) -> Self {
        let options = options.iter().map(|option| (*option).to_owned()).collect();
        Self { options, cases, behind: None, confusions: &[], returns: Vec::new() }
    }

    pub(crate) fn confused(self, confusions: &'static [Confusion]) -> Self {
        Self { confusions, ..self }
    }

    pub(crate) fn with(self, behind: Option<Behind>, returns: Vec<Equality>) -> Self {
        Self { behind, returns, ..self }
    }

    /// The equalities that decide between the cases.
    pub(crate) fn equalities(&self) -> impl Iterator<Item = &Equality> {
        self.cases.iter().flat_map(|case| &case.tests).map(|test| &test.equality)
    }

    /// Everything on which the choice depends.
    pub(crate) fn symbols(&self) -> BTreeSet<Symbol> {
        self.equalities().flat_map(Equality::symbols).collect()
    }

    /// The quantities that have to be solved for it.
    pub(crate) fn quantities(&self) -> Vec<Symbol> {
        let mut quantities: Vec<Symbol> = Vec::new();
        for symbol in self.equalities().flat_map(Equality::quantities) {
            if !quantities.contains(symbol) {
                quantities.push(*symbol);
            }
        }
        quantities
    }
}
