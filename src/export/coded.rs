//! Codes of variants, and how the answers to their fields make those to their parts again.

use serde::Deserialize;
use serde::Serialize;

use momentous_exercise::ItemAnswers;
use momentous_exercise::ItemPart;
use momentous_render::SeedWord;

use super::question::{Asking, Question};
use super::target::Target;

/// The sign in place of the answer to a field.
const FIELD: &str = "{}";

/// A variant that was exported.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Coded {
    /// Its code.
    pub code: String,
    /// The problem's identity.
    pub problem: String,
    /// The digest of what the problem's numbers are drawn from.
    pub digest: Option<String>,
    /// How its numbers were drawn; earlier versions did not write it.
    #[serde(default)]
    pub scheme: Option<u32>,
    /// The numbers that it tells; earlier versions did not write them.
    #[serde(default)]
    pub given: Option<String>,
    /// The form.
    pub form: Option<String>,
    /// The seed, as it is printed on sheets.
    pub seed: String,
    /// The parts that have fields.
    pub parts: Vec<CodedPart>,
}

/// A part that was exported.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CodedPart {
    /// Its name in answers.
    pub id: String,
    /// Its answer, with `{}` for what is typed into each field.
    pub answer: String,
    /// Its fields.
    pub fields: Vec<String>,
}

impl Coded {
    /// The code of a question in a target. Where students type the unit there, it is not added to what they typed.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_bank::Bank;
    /// use momentous_exercise::Exercise;
    /// use momentous_export::{Coded, Question, TARGETS};
    /// use momentous_problem::{compile, load};
    ///
    /// let source = Bank::built_in().find("impact/two-carts")?.clone();
    /// let problem = Arc::new(compile(load(source)?, None)?);
    /// let item = Exercise::draw(&problem, 0, 7)?.item();
    /// let coded = Coded::of(&Question::new(&item), &TARGETS[0]);
    /// assert_eq!(coded.parts[0].answer, "{} m/s");
    /// assert_eq!(coded.answers(&[("a".into(), "3".into())]), [("v_A2".into(), "3 m/s".into())]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn of(question: &Question<'_>, target: &Target) -> Self {
        let identity = &question.item.identity;
        let mark = identity.secret.as_ref().map(|mark| format!("-{mark}")).unwrap_or_default();
        let part = |asking: &Asking<'_>| CodedPart {
            id: asking.part.field.id.clone(),
            answer: if target.types_unit(question) {
                FIELD.to_owned()
            } else {
                answer(asking.part, asking.fields.len())
            },
            fields: asking.fields.iter().map(|field| field.name.clone()).collect(),
        };
        Self {
            code: question.item.code.clone(),
            problem: identity.problem.clone(),
            digest: identity.digest.clone(),
            scheme: identity.scheme,
            given: Some(question.item.given.to_string()),
            form: identity.form.clone(),
            seed: identity.seed.map(|seed| format!("{}{mark}", SeedWord(seed))).unwrap_or_default(),
            parts: question.asked.iter().map(part).collect(),
        }
    }

    /// The fields in their order.
    pub fn fields(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().flat_map(|part| part.fields.iter().map(String::as_str))
    }

    /// The answers to parts, of what was typed into fields. A part with nothing in its fields has none.
    #[must_use]
    pub fn answers(&self, typed: &[(String, String)]) -> Vec<(String, String)> {
        let text = |field: &String| typed.iter().find(|(name, _)| name == field).map_or("", |(_, text)| text.trim());
        let answer = |part: &CodedPart| {
            let texts: Vec<&str> = part.fields.iter().map(text).collect();
            let written = match texts[..] {
                // Whoever typed more than a number typed the unit, too, or chose a phrase.
                [only] if !is_number(only) => only.to_owned(),
                _ => texts.iter().fold(part.answer.clone(), |answer, text| answer.replacen(FIELD, text, 1)),
            };
            texts.iter().any(|text| !text.is_empty()).then(|| (part.id.clone(), written))
        };
        self.parts.iter().filter_map(answer).collect()
    }
}

/// The answer to a part as it is printed, without its numbers.
fn answer(part: &ItemPart, fields: usize) -> String {
    if matches!(part.answers, ItemAnswers::Choice { .. } | ItemAnswers::Formula { .. }) {
        return FIELD.to_owned();
    }
    let words = part.printed.split(' ');
    let words =
        words.map(|word| number_in(word).map_or_else(|| word.to_owned(), |digits| word.replacen(digits, FIELD, 1)));
    let answer = words.collect::<Vec<_>>().join(" ");
    if answer.matches(FIELD).count() == fields { answer } else { vec![FIELD; fields].join("; ") }
}

/// The number in a word, between brackets and before a unit without a space: `(1.5,`, `30°`. What is divided is none: `1/s`.
fn number_in(word: &str) -> Option<&str> {
    let word = word.trim_start_matches(['(', '[']);
    let end =
        word.find(|letter: char| !letter.is_ascii_alphanumeric() && !"+-.".contains(letter)).unwrap_or(word.len());
    let (number, rest) = word.split_at_checked(end)?;
    (is_number(number) && !rest.starts_with('/')).then_some(number)
}

fn is_number(text: &str) -> bool {
    let plain: String = text.replace(',', ".").split_whitespace().collect();
    plain.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first)) && plain.parse::<f64>().is_ok()
}
