//! Options of the author's own: their texts, and when each is right.

use std::collections::BTreeSet;

use momentous_expr::Symbol;

use super::super::super::language::text::Text;
use super::claim::Claim;

/// A choice between options that the author wrote.
#[derive(Clone, Debug)]
pub struct Offer {
    /// The name of the random stream from which their order comes.
    pub(crate) stream: String,
    /// The options in the order of the file; one that is right where no other is stands last.
    pub(crate) options: Vec<Offered>,
    /// The symbols that their texts print.
    pub(crate) printed: BTreeSet<Symbol>,
    /// The symbols that the options which may be right print and that have no value of their own.
    pub(crate) solved: Vec<Symbol>,
}

/// One option.
#[derive(Clone, Debug)]
pub(crate) struct Offered {
    pub text: Text,
    pub truth: Truth,
    /// Why it is right, where it is.
    pub because: Option<Text>,
    /// The feedback to a student who chose it and is wrong.
    pub feedback: Option<Text>,
}

/// When an option is right.
#[derive(Clone, Debug)]
pub(crate) enum Truth {
    Always,
    Never,
    /// Right where this holds.
    When(Claim),
    /// Right where no other option is.
    Otherwise,
}

impl Offer {
    /// Everything on which the choice depends; what an option prints, it tells.
    pub(crate) fn symbols(&self) -> BTreeSet<Symbol> {
        self.claims().flat_map(Claim::symbols).chain(self.solved.iter().copied()).collect()
    }

    /// Everything to which the options refer.
    pub(crate) fn mentioned(&self) -> BTreeSet<Symbol> {
        &self.symbols() | &self.printed
    }

    /// The quantities that have to be solved for it.
    pub(crate) fn quantities(&self) -> Vec<Symbol> {
        let claimed = self.claims().flat_map(|claim| claim.quantities.iter().copied());
        let all: BTreeSet<Symbol> = claimed.chain(self.solved.iter().copied()).collect();
        all.into_iter().collect()
    }

    /// Everything that it prints.
    pub(crate) fn texts(&self) -> impl Iterator<Item = &Text> {
        self.options
            .iter()
            .flat_map(|option| [Some(&option.text), option.because.as_ref(), option.feedback.as_ref()])
            .flatten()
    }

    pub(crate) fn claims(&self) -> impl Iterator<Item = &Claim> {
        self.options.iter().filter_map(|option| match &option.truth {
            Truth::When(claim) => Some(claim),
            _ => None,
        })
    }

    /// The symbols that the right option prints and that have no value of their own, where the author says which one is right.
    #[must_use]
    pub fn always_right(&self) -> Option<&[Symbol]> {
        self.claims().next().is_none().then_some(&self.solved)
    }
}
