//! The phrases of a choice, and which of them is right.

use momentous_laws::wrong::Misconception;

/// The phrases of a choice, and the right one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decision {
    /// The phrases, in the order in which they are offered.
    pub options: Vec<String>,
    /// The position of the right one.
    pub right: usize,
    /// Why it is right, as a sentence without a full stop.
    pub because: String,
    /// The common mistake that leads to another phrase, where there is one.
    pub behind: Option<&'static Misconception>,
    /// The feedback to a student who chose an option wrongly, in the order of the options.
    pub feedback: Vec<OptionFeedback>,
}

/// The feedback on an option that is wrong.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum OptionFeedback {
    /// Nothing but what is said of the question.
    #[default]
    Nothing,
    /// The author's own words.
    Own(String),
    /// The explanation of the mistake that leads to it.
    Mistake(&'static Misconception),
    /// The mistake of whoever confuses it with the right one; a solution has no words for it.
    Confused(&'static Misconception),
}

impl Decision {
    /// A question that is answered by yes or no.
    #[must_use]
    pub fn yes_or_no(holds: bool, because: String) -> Self {
        Self {
            options: vec!["yes".into(), "no".into()],
            right: usize::from(!holds),
            because,
            behind: None,
            feedback: Vec::new(),
        }
    }
}
