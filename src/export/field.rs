//! Parts as fields that any target has: a number, or one of several phrases.

use crate::exercise::ItemAnswers;
use crate::exercise::ItemPart;
use crate::exercise::NumberItem;

use super::feature::Feature;

/// Room for one answer of the simplest kinds.
#[derive(Clone, Debug)]
pub(super) struct Field<'i> {
    /// What stands before it, where its part has several.
    pub caption: &'static str,
    /// What is asked.
    pub asked: Asked<'i>,
}

/// What is asked.
#[derive(Clone, Debug)]
pub(super) enum Asked<'i> {
    /// A number.
    Number(&'i NumberItem),
    /// One of these.
    Choice {
        /// The phrases.
        options: Vec<Choice<'i>>,
        /// Whether their order may be changed.
        shuffled: bool,
    },
}

/// One of several phrases.
#[derive(Clone, Debug)]
pub(super) struct Choice<'i> {
    pub text: &'i str,
    pub right: bool,
    pub feedback: String,
}

/// The fields of a part, none where it has to be left out; and what does not stand in them as it is.
pub(super) fn fields<'i>(part: &'i ItemPart) -> (Vec<Field<'i>>, Option<Feature>) {
    let number = |caption, item| Field { caption, asked: Asked::Number(item) };
    match &part.answers {
        ItemAnswers::Number(item) => (vec![number("", item)], None),
        ItemAnswers::Roots(all) => (all.iter().map(|item| number("", item)).collect(), Some(Feature::Roots)),
        ItemAnswers::Vector(all) => (all.iter().map(|item| number("", item)).collect(), Some(Feature::Vectors)),
        ItemAnswers::Interval { low, high } => {
            let ends = [("from", low), ("to", high)];
            let ends = ends.into_iter().filter_map(|(caption, end)| Some(number(caption, end.as_deref()?)));
            (ends.collect(), Some(Feature::Intervals))
        }
        ItemAnswers::Choice { options, right, because, wrong } => {
            let option = |(place, text): (usize, &'i String)| {
                let right = place == *right;
                Choice { text, right, feedback: if right { because.clone() } else { wrong.join(" ") } }
            };
            let options = options.iter().enumerate().map(option);
            (vec![Field { caption: "", asked: Asked::Choice { options: options.collect(), shuffled: false } }], None)
        }
        ItemAnswers::Formula { mistaken } if mistaken.is_empty() => (Vec::new(), Some(Feature::LoneFormulas)),
        ItemAnswers::Formula { mistaken } => {
            let right = Choice { text: &part.printed, right: true, feedback: String::new() };
            let wrong =
                mistaken.iter().map(|(text, feedback)| Choice { text, right: false, feedback: feedback.clone() });
            let options = std::iter::once(right).chain(wrong).collect();
            (vec![Field { caption: "", asked: Asked::Choice { options, shuffled: true } }], Some(Feature::Formulas))
        }
    }
}
