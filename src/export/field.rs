//! Parts as fields that any target has: a number, or one of several phrases.

use momentous_exercise::FormulaItem;
use momentous_exercise::ItemAnswers;
use momentous_exercise::ItemPart;
use momentous_exercise::NumberItem;
use momentous_expr::Math;
use momentous_render::Markup;

/// Room for one answer of the simplest kinds.
#[derive(Clone, Debug)]
pub(super) struct Field<'i> {
    /// Its name: the label of its part, and its place where the part has several.
    pub name: String,
    /// The caption before it, where its part has several: the letter of an axis, `from`.
    pub caption: String,
    /// The quantity or choice asked.
    pub asked: Asked<'i>,
}

/// The quantity or choice that a field asks.
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
    /// The text as it is typed.
    pub text: &'i str,
    /// A formula as mathematics.
    pub math: Option<&'i Math>,
    pub right: bool,
    pub feedback: String,
}

/// The fields of a part, none where it has to be left out.
pub(super) fn fields(part: &ItemPart) -> Vec<Field<'_>> {
    let asked: Vec<(String, Asked<'_>)> = match &part.answers {
        ItemAnswers::Number(item) => vec![(String::new(), Asked::Number(item))],
        ItemAnswers::Roots(all) => {
            all.iter().zip(places(all.len())).map(|(number, place)| (place, Asked::Number(number))).collect()
        }
        ItemAnswers::Vector { axes, components } => {
            let named = axes.iter().map(|axis| format!("{axis}:"));
            named.zip(components).map(|(caption, number)| (caption, Asked::Number(number))).collect()
        }
        ItemAnswers::Interval { low, high } => {
            let ends = [("from", low), ("to", high)].into_iter();
            ends.filter_map(|(caption, end)| Some((caption.to_owned(), Asked::Number(end.as_deref()?)))).collect()
        }
        ItemAnswers::Choice { options, right, because, wrong } => {
            let options = options.iter().enumerate().map(|(place, text)| {
                let right = place == *right;
                let wrong = wrong.get(place).map(|said| said.join(" ")).unwrap_or_default();
                Choice { text, math: None, right, feedback: if right { because.clone() } else { wrong } }
            });
            vec![(String::new(), Asked::Choice(options.collect()))]
        }
        ItemAnswers::Formula { mistaken, .. } if mistaken.is_empty() => Vec::new(),
        ItemAnswers::Formula { right, mistaken } => {
            let wrong = mistaken.iter().map(|(item, feedback)| formula(item, false, feedback.clone()));
            let mut options: Vec<Choice<'_>> =
                std::iter::once(formula(right, true, String::new())).chain(wrong).collect();
            // Their order must not tell which is right.
            options.sort_by_key(|choice| choice.text);
            vec![(String::new(), Asked::Choice(options))]
        }
    };
    let several = asked.len() > 1;
    let named = asked.into_iter().zip(1_usize..).map(|((caption, asked), place)| {
        let place = if several { place.to_string() } else { String::new() };
        Field { name: format!("{}{place}", part.field.label), caption, asked }
    });
    named.collect()
}

fn formula(item: &FormulaItem, right: bool, feedback: String) -> Choice<'_> {
    Choice { text: &item.text, math: item.math.as_ref(), right, feedback }
}

/// The places of several values of one quantity, from the smallest.
fn places(count: usize) -> Vec<String> {
    let words: Vec<&str> = match count {
        2 => vec!["the smaller:", "the greater:"],
        3 => vec!["the smallest:", "the middle one:", "the greatest:"],
        _ => vec![""; count],
    };
    words.into_iter().map(str::to_owned).collect()
}

impl Choice<'_> {
    /// The text as it is printed.
    pub fn shown(&self, markup: Markup) -> String {
        self.math.map_or_else(|| markup.line(self.text), |math| markup.math(math))
    }
}
