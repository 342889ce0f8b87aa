//! A choice that is settled by whether terms are equal: what is conserved, and of which kind an impact is.

use std::collections::BTreeSet;

use crate::expr::Symbol;
use crate::laws::wrong::Misconception;

use super::super::sampling::variant::Worked;
use super::decision::ChoicePart;
use super::decision::Decision;
use super::equality::Closeness;
use super::equality::Equality;

/// A choice between phrases, each right in one case.
#[derive(Clone, Debug)]
pub struct Judgement {
    options: Vec<String>,
    /// In order: the first of which all tests hold is right. The last has none.
    cases: Vec<Case>,
    behind: Option<Behind>,
    /// Whether what changes on the way has its value again at the end.
    returns: Vec<Equality>,
}

/// A phrase that may be right.
#[derive(Clone, Debug)]
pub(super) struct Case {
    /// The position of the phrase.
    pub right: usize,
    /// The ways that the scene has to go: each a choice, counted from 0, and what happens there.
    pub ways: Vec<(usize, String)>,
    /// What has to hold.
    pub tests: Vec<Test>,
    /// Why it is right, as a sentence without a full stop; empty where that is what a test says that does not hold.
    pub because: String,
}

/// Two terms that have to be equal, and what to say where they are not.
#[derive(Clone, Debug)]
pub(in crate::problem) struct Test {
    pub equality: Equality,
    pub otherwise: String,
}

/// The mistake behind a wrong phrase.
#[derive(Clone, Debug)]
pub(in crate::problem) struct Behind {
    pub mistake: &'static Misconception,
    /// The phrase that is right where it is made.
    pub right: usize,
    /// Nobody makes it where all of these hold.
    pub unless: Vec<Test>,
}

impl Case {
    pub(in crate::problem) fn new(right: usize, tests: Vec<Test>, because: impl Into<String>) -> Self {
        Self { right, ways: Vec::new(), tests, because: because.into() }
    }

    /// The same where the scene goes these ways only.
    pub(in crate::problem) fn only(self, ways: Vec<(usize, String)>) -> Self {
        Self { ways, ..self }
    }

    fn is_open(&self, worked: &Worked<'_>) -> bool {
        self.ways.iter().all(|(choice, what)| worked.leaf().words.get(*choice) == Some(what))
    }
}

impl Test {
    pub(in crate::problem) fn new(equality: Equality, otherwise: impl Into<String>) -> Self {
        Self { equality, otherwise: otherwise.into() }
    }

    fn holds(&self, worked: &Worked<'_>) -> bool {
        self.equality.closeness(worked).is_equal()
    }
}

impl Judgement {
    pub(super) fn new(options: &[&str], cases: Vec<Case>) -> Self {
        let options = options.iter().map(|option| (*option).to_owned()).collect();
        Self { options, cases, behind: None, returns: Vec::new() }
    }

    pub(in crate::problem) fn with(self, behind: Option<Behind>, returns: Vec<Equality>) -> ChoicePart {
        ChoicePart::Judged(Box::new(Self { behind, returns, ..self }))
    }

    /// What decides between the cases.
    pub(super) fn equalities(&self) -> impl Iterator<Item = &Equality> {
        self.cases.iter().flat_map(|case| &case.tests).map(|test| &test.equality)
    }

    /// Everything on which the choice depends.
    pub(in crate::problem) fn symbols(&self) -> BTreeSet<Symbol> {
        self.equalities().flat_map(Equality::symbols).collect()
    }

    /// What has to be solved for it.
    pub(in crate::problem) fn quantities(&self) -> Vec<Symbol> {
        let mut quantities: Vec<Symbol> = Vec::new();
        for symbol in self.equalities().flat_map(Equality::quantities) {
            if !quantities.contains(symbol) {
                quantities.push(*symbol);
            }
        }
        quantities
    }

    /// Two values that are neither equal within the data nor clearly different, in words.
    pub(super) fn unclear(&self, worked: &Worked<'_>) -> Option<String> {
        let between = |own: &&Equality| own.closeness(worked) == Closeness::Between;
        let own = self.equalities().find(between)?;
        Some(own.in_words(worked).unwrap_or_else(|| "its two sides".to_owned()))
    }

    /// Whether values are taken as equal that are so only within the precision of the data.
    pub(super) fn is_within_data(&self, worked: &Worked<'_>) -> bool {
        self.equalities().any(|own| own.closeness(worked) == Closeness::WithinData)
    }

    pub(in crate::problem) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let mut passed: Vec<&Test> = Vec::new();
        for case in self.cases.iter().filter(|case| case.is_open(worked)) {
            let failing: Vec<&Test> = case.tests.iter().filter(|test| !test.holds(worked)).collect();
            if !failing.is_empty() {
                passed.extend(failing);
                continue;
            }
            let because = if case.because.is_empty() { self.refused(worked, &passed) } else { accepted(worked, case) };
            let applies = |own: &&Behind| {
                own.right == case.right && (own.unless.is_empty() || !own.unless.iter().all(|test| test.holds(worked)))
            };
            let behind = self.behind.as_ref().filter(applies).map(|own| own.mistake);
            return Decision {
                options: self.options.clone(),
                right: case.right,
                because,
                behind,
                feedback: Vec::new(),
            };
        }
        Decision { options: self.options.clone(), right: 0, because: String::new(), behind: None, feedback: Vec::new() }
    }

    /// Why a case does not hold: what its tests say, after what is the same nevertheless.
    fn refused(&self, worked: &Worked<'_>, failing: &[&Test]) -> String {
        let mut words: Vec<String> = Vec::new();
        for test in failing {
            let said = match test.equality.in_words(worked) {
                Some(values) => format!("{}: {values}", test.otherwise),
                None => test.otherwise.clone(),
            };
            if !words.contains(&said) {
                words.push(said);
            }
        }
        let words = words.join(", and ");
        let returns = !self.returns.is_empty() && self.returns.iter().all(|own| own.closeness(worked).is_equal());
        if returns { format!("its final value equals its initial value, but {words}") } else { words }
    }
}

/// Why a case holds, with the values that are equal within the precision of the data.
fn accepted(worked: &Worked<'_>, case: &Case) -> String {
    let nearly = case.tests.iter().find(|test| test.equality.closeness(worked) == Closeness::WithinData);
    match nearly.map(|test| test.equality.in_words(worked)) {
        None => case.because.clone(),
        Some(None) => format!("{}, within the precision of the data", case.because),
        Some(Some(values)) => format!("{}: {values} are equal within the precision of the data", case.because),
    }
}
