//! Parts as fields that any target has: a number, or one of several phrases.

use momentous_exercise::ItemAnswers;
use momentous_exercise::ItemPart;
use momentous_exercise::NumberItem;

/// Room for one answer of the simplest kinds.
#[derive(Clone, Debug)]
pub(super) struct Field<'i> {
    /// How it is called: the label of its part, and its place where the part has several.
    pub name: String,
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
    /// One of these, in this order.
    Choice(Vec<Choice<'i>>),
}

/// One of several phrases.
#[derive(Clone, Debug)]
pub(super) struct Choice<'i> {
    pub text: &'i str,
    pub right: bool,
    pub feedback: String,
}

/// The fields of a part, none where it has to be left out.
pub(super) fn fields(part: &ItemPart) -> Vec<Field<'_>> {
    let asked: Vec<(&'static str, Asked<'_>)> = match &part.answers {
        ItemAnswers::Number(item) => vec![("", Asked::Number(item))],
        ItemAnswers::Roots(all) | ItemAnswers::Vector(all) => {
            all.iter().map(|item| ("", Asked::Number(item))).collect()
        }
        ItemAnswers::Interval { low, high } => {
            let ends = [("from", low), ("to", high)];
            ends.into_iter().filter_map(|(caption, end)| Some((caption, Asked::Number(end.as_deref()?)))).collect()
        }
        ItemAnswers::Choice { options, right, because, wrong } => {
            let options = options.iter().enumerate().map(|(place, text)| {
                let right = place == *right;
                let wrong = wrong.get(place).map(|said| said.join(" ")).unwrap_or_default();
                Choice { text, right, feedback: if right { because.clone() } else { wrong } }
            });
            vec![("", Asked::Choice(options.collect()))]
        }
        ItemAnswers::Formula { mistaken } if mistaken.is_empty() => Vec::new(),
        ItemAnswers::Formula { mistaken } => {
            let right = Choice { text: &part.printed, right: true, feedback: String::new() };
            let wrong =
                mistaken.iter().map(|(text, feedback)| Choice { text, right: false, feedback: feedback.clone() });
            let mut options: Vec<Choice<'_>> = std::iter::once(right).chain(wrong).collect();
            // Their order must not tell which is right.
            options.sort_by_key(|own| own.text);
            vec![("", Asked::Choice(options))]
        }
    };
    let several = asked.len() > 1;
    let named = asked.into_iter().zip(1_usize..).map(|((caption, asked), place)| {
        let place = if several { place.to_string() } else { String::new() };
        Field { name: format!("{}{place}", part.field.label), caption, asked }
    });
    named.collect()
}
