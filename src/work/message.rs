//! The words for what is found of a line.

use super::found::LineFinding;
use super::judge::Judge;
use super::verdict::{Verdict, list};

impl Judge<'_> {
    /// The message to the student about a line.
    pub(crate) fn message(&self, found: &LineFinding, laws: &[&str]) -> String {
        let by =
            |before: &str| if laws.is_empty() { before.to_owned() } else { format!("{before}, by {}", list(laws)) };
        match found.verdict {
            Verdict::Follows
            | Verdict::Definition
            | Verdict::Restates
            | Verdict::Coincidence
            | Verdict::DoesNotFollow
                if !found.detail.is_empty() =>
            {
                found.detail.clone()
            }
            Verdict::Follows if found.is_of_arrows => format!("{}.", by("Follows, if its letters are arrows")),
            Verdict::Follows => format!("{}.", by("Follows")),
            Verdict::Answer => "This is an answer, and it is right.".to_owned(),
            Verdict::AsFigures => format!("{}.", by("True as far as its figures show")),
            Verdict::Definition => "True: it says what a quantity is.".to_owned(),
            Verdict::OwnLetter => format!("{} is taken as a letter of your own.", found.detail),
            Verdict::Restates => "True: it says again what is given.".to_owned(),
            Verdict::Identity => "True of any values: it says nothing about this scene.".to_owned(),
            Verdict::Coincidence => {
                "True of these numbers only by chance: it does not follow from the scene.".to_owned()
            }
            Verdict::Convention => "The following lines are read with this direction as positive.".to_owned(),
            Verdict::Remark => "No equation: it is not judged.".to_owned(),
            Verdict::Mistake => self.mistaken(found),
            Verdict::OtherInstant => {
                format!("Not true of this instant. With {} it would be: which instant is meant?", found.detail)
            }
            Verdict::OtherBody => {
                format!("Not true of this body. With {} it would be: which body is meant?", found.detail)
            }
            Verdict::Dimensions => format!("The dimensions do not agree: {}.", found.detail),
            Verdict::DoesNotFollow => "Does not follow from what is given.".to_owned(),
            Verdict::Unreadable => format!("Cannot be read, and costs nothing: {}", ended(&found.detail)),
            Verdict::Undecided => format!("Cannot be decided, and costs nothing: {}", ended(&found.detail)),
        }
    }

    fn mistaken(&self, found: &LineFinding) -> String {
        let is_same = |id: &str| found.mistakes.iter().any(|mistake| mistake.of.id == id);
        let earlier = self.mistakes.iter().find(|(id, _)| is_same(id));
        if let Some((_, line)) = earlier {
            return format!("Follows from the mistake in line {line}.");
        }
        let asked: Vec<&str> = found.mistakes.iter().take(1).map(|mistake| mistake.of.ask).collect();
        format!("Does not follow. {}", asked.concat())
    }
}

/// A clause with the sign that ends a sentence.
fn ended(clause: &str) -> String {
    if clause.ends_with(['.', '?']) { clause.to_owned() } else { format!("{clause}.") }
}
