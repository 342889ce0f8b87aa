//! Questions of several fields: gaps in the text, in Moodle's cloze notation.

use std::fmt::Write;

use momentous_explain::Inline;
use momentous_render::Markup;

use super::super::field::{Asked, Choice, Field};
use super::super::question::{Asking, Question};
use super::answer::{Answer, answers};

/// The text of a question, with its gaps.
pub(super) fn text(before: &str, question: &Question<'_>, markup: Markup) -> String {
    let mut out = without_braces(before);
    for asking in &question.asked {
        let asked = without_braces(&asking.question(markup, question.asked.len() > 1));
        let gap =
            |field: &Field<'_>| format!("{} {}", without_braces(&markup.text(&field.caption)), gap(field, asking));
        let gaps: Vec<String> = asking.fields.iter().map(gap).collect();
        let unit = without_braces(&asking.unit(markup));
        let _ = writeln!(out, "<p>{asked}<br/>{} {unit}</p>", gaps.join(" "));
    }
    out
}

fn gap(field: &Field<'_>, asking: &Asking<'_>) -> String {
    let (kind, alternatives): (&str, Vec<String>) = match &field.asked {
        Asked::Number(number) => {
            let one = |answer: &Answer<'_>| {
                let said = escaped(&answer.feedback.join(" "));
                format!("{}{}:{}#{said}", share(answer.fraction), answer.value, answer.tolerance)
            };
            // A gap is as wide as its longest answer, and that of a thousand times as much would be the longest.
            let answers = answers(number, asking.part.field.points);
            ("NUMERICAL", answers.iter().filter(|answer| !answer.is_coarse).map(one).collect())
        }
        Asked::Choice(options) => {
            let one = |choice: &Choice<'_>| {
                let fraction = if choice.right { 100.0 } else { 0.0 };
                format!("{}{}#{}", share(fraction), escaped(&in_gap(choice)), escaped(&choice.feedback))
            };
            ("MULTICHOICE_V", options.iter().map(one).collect())
        }
    };
    format!("{{{}:{kind}:{}}}", asking.weight, alternatives.join("~"))
}

/// An option in a gap, which knows no elements: mathematics as TeX, for the page to typeset.
fn in_gap(option: &Choice<'_>) -> String {
    if let Some(math) = option.math {
        return Markup::Tex.math(math);
    }
    let parts = Inline::line(option.text).into_iter().map(|part| match part {
        Inline::Tex(tex) => format!("\\({tex}\\)"),
        Inline::Text(text) | Inline::Emphasis(text) | Inline::Strong(text) => text,
        Inline::Math(math) => math.plain(),
    });
    parts.collect()
}

fn share(fraction: f64) -> String {
    if fraction >= 100.0 { "=".to_owned() } else { format!("%{fraction}%") }
}

/// A text within a gap: whatever HTML or the notation would read is written by its number.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' | '<' | '>' | '"' | '\'' | '{' | '}' | '~' | '#' | '\\' | '=' | '%' => {
                let _ = write!(out, "&#{};", u32::from(character));
            }
            character if character.is_control() => out.push(' '),
            character => out.push(character),
        }
    }
    out
}

/// HTML in which no gap begins.
fn without_braces(html: &str) -> String {
    html.replace('{', "&#123;").replace('}', "&#125;")
}
