//! Questions of several fields: gaps in the text, in Moodle's cloze notation.

use std::fmt::Write;

use crate::render::Fragment;

use super::super::field::{Asked, Field};
use super::Asking;
use super::answer::{Answer, answers};

/// The text of a question, with its gaps.
pub(super) fn text(before: &str, asked: &[Asking<'_>]) -> String {
    // Each gap weighs a whole number, and the gaps of a part together what it is worth.
    let shares = asked.iter().map(|(_, fields)| fields.len()).fold(1, least_common_multiple);
    let mut out = without_braces(before);
    for (part, fields) in asked {
        let weight = usize::try_from(part.field.points).unwrap_or(1) * (shares / fields.len());
        let label = escaped(&part.field.label);
        let question = without_braces(Fragment::inline(&part.field.question).as_str());
        let gap = |field: &Field<'_>| format!("{} {}", field.caption, gap(field, weight, part.field.points));
        let gaps: Vec<String> = fields.iter().map(gap).collect();
        let unit = part.field.unit.as_ref().map(|unit| without_braces(Fragment::math(unit).as_str()));
        let _ = write!(out, "\n<p>({label}) {question}<br/>{} {}</p>", gaps.join(" "), unit.unwrap_or_default());
    }
    out
}

fn gap(field: &Field<'_>, weight: usize, out_of: u32) -> String {
    let (kind, alternatives): (&str, Vec<String>) = match &field.asked {
        Asked::Number(number) => {
            let one = |Answer { value, tolerance, fraction, feedback }: &Answer<'_>| {
                let said = escaped(&feedback.join(" "));
                format!("{}{value}:{tolerance}#{said}", share(*fraction))
            };
            ("NUMERICAL", answers(number, out_of).0.iter().map(one).collect())
        }
        Asked::Choice { options, shuffled } => {
            let kind = if *shuffled { "MULTICHOICE_VS" } else { "MULTICHOICE_V" };
            let one = |own: &super::Choice<'_>| {
                let fraction = if own.right { 100.0 } else { 0.0 };
                format!("{}{}#{}", share(fraction), escaped(own.text), escaped(&own.feedback))
            };
            (kind, options.iter().map(one).collect())
        }
    };
    format!("{{{weight}:{kind}:{}}}", alternatives.join("~"))
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

fn least_common_multiple(left: usize, right: usize) -> usize {
    (1..=right).map(|times| left * times).find(|own| own % right == 0).unwrap_or(left)
}
