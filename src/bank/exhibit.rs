//! A problem as a gallery shows it: its section, what is asked, how it is answered, and the words by which it is found.

use serde::Serialize;

use momentous_explain::Inline;
use momentous_expr::name_math;
use momentous_problem::{Answered, Ask, Draft, Find, Loaded, Text};
use momentous_render::Fragment;

use super::entry::Card;
use super::sections::Section;
use super::spelling::plain;

/// A question of the text begins with one of these, where it does not end with a question mark.
const ASKING: [&str; 5] = ["Find ", "Decide ", "Answer ", "Say ", "Choose "];

/// How a part is answered, as a reader chooses among problems.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum AnswerKind {
    /// A number with its unit, or a vector.
    Number,
    /// A formula.
    Formula,
    /// One of several options or pictures.
    Choice,
    /// An interval.
    Interval,
}

/// A problem as a gallery shows it.
#[derive(Clone, Debug)]
pub struct Exhibit {
    /// The card of the problem in a list.
    pub card: Card,
    /// Its section.
    pub section: Section,
    /// The question of its first form; empty where its text does not say it by itself.
    pub asks: Fragment,
    /// How the parts of its forms are answered, each once.
    pub answers: Vec<AnswerKind>,
    /// Every word by which it is found.
    pub(super) searched: String,
}

impl AnswerKind {
    /// Every kind, with its name in addresses and what it is called.
    pub const ALL: [(Self, &'static str, &'static str); 4] = [
        (Self::Number, "number", "Number or vector"),
        (Self::Formula, "formula", "Formula"),
        (Self::Choice, "choice", "Choice"),
        (Self::Interval, "interval", "Interval"),
    ];

    fn of(ask: &Ask) -> Self {
        match ask {
            Ask::Find(Find { answered: Answered::Formula, .. }) => Self::Formula,
            Ask::Find(_) | Ask::Count(_) => Self::Number,
            Ask::Range(_) => Self::Interval,
            Ask::Conserved(_)
            | Ask::Classify(_)
            | Ask::Impulsive(_)
            | Ask::Holds(_)
            | Ask::Order(_)
            | Ask::Physical(_)
            | Ask::Choose(_)
            | Ask::Enough(_) => Self::Choice,
        }
    }
}

impl Exhibit {
    /// The exhibit of a problem that was loaded.
    #[must_use]
    pub fn of(loaded: &Loaded) -> Self {
        let draft = &loaded.draft;
        let card = Card::of(loaded);
        let section = Section::of(&card);
        let asked = draft.ask.iter().chain(draft.forms.iter().flat_map(|(_, form)| &form.ask));
        let mut answers: Vec<AnswerKind> = asked.map(AnswerKind::of).collect();
        answers.sort_unstable();
        answers.dedup();
        let texts = std::iter::once(&draft.text).chain(draft.forms.iter().filter_map(|(_, form)| form.text.as_ref()));
        let words: Vec<String> = texts.map(|text| text.fill(&|_| " ".to_owned())).collect();
        let searched =
            [&card.title, &card.id, &section.title, &card.tags.join(" "), &words.join(" ")].map(|text| plain(text));
        Self {
            asks: Fragment::inline(&asks(draft)),
            answers,
            searched: format!(" {} ", searched.join(" ")),
            section,
            card,
        }
    }
}

/// The question of the first form: the questions of its text, a quantity by its letter; else what it lets choose.
fn asks(draft: &Draft) -> Vec<Inline> {
    let first = draft.forms.iter().next().map(|(_, form)| form);
    let texts = [Some(&draft.text), first.and_then(|form| form.text.as_ref())];
    let in_letters = |text: &Text| text.fill(&|placeholder| format!("${}$", name_math(&placeholder.name).latex()));
    let text = texts.into_iter().flatten().map(in_letters).collect::<Vec<_>>().join(" ");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let questions: Vec<&str> = sentences(&text).filter(|sentence| is_question(sentence)).collect();
    if !questions.is_empty() {
        return Inline::line(&questions.join(" "));
    }
    let parts = first.map_or(&draft.ask, |form| &form.ask);
    // Other parts are named by the sheet, which is not drawn here.
    let chosen = parts.iter().filter_map(|ask| if let Ask::Choose(choice) = ask { Some(&choice.choose) } else { None });
    chosen.take(1).flat_map(|choice| Inline::line(choice)).collect()
}

fn is_question(sentence: &str) -> bool {
    sentence.ends_with('?') || ASKING.iter().any(|word| sentence.starts_with(word))
}

/// The sentences of a text: each ends before a space and a capital letter.
fn sentences(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let ends = rest.match_indices(['.', '?', '!']).map(|(place, _)| place + 1);
        let is_end = |place: &usize| {
            let mut behind = rest[*place..].chars();
            behind.next() == Some(' ') && behind.next().is_some_and(|letter| letter.is_uppercase() || letter == '$')
        };
        let (sentence, behind) = rest.split_at(ends.into_iter().find(is_end).unwrap_or(rest.len()));
        rest = behind.trim_start();
        (!sentence.is_empty()).then_some(sentence)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_questions_of_a_text_are_told_from_its_story() {
        let text = "Cart A ($m_{A}$) moves at 2.5 m/s. They collide. Find $e$. How far does A go?";
        let questions: Vec<&str> = sentences(text).filter(|sentence| is_question(sentence)).collect();
        assert_eq!(questions, ["Find $e$.", "How far does A go?"]);
    }
}
