//! An exam of Numbas: for each form a group that picks one of its variants. Text stands where Numbas substitutes nothing.

use std::io::Write;

use serde_json::Value;
use serde_json::json;

use momentous_fault::Faults;
use momentous_render::Markup;
use momentous_render::base64;

use super::Begun;
use super::Export;
use super::NotWritten;
use super::band::{Band, bands};
use super::field::{Asked, Choice, Field};
use super::printable;
use super::question::{Asking, Pictures, Question, TypedUnit, said};

const MARKUP: Markup = Markup::MathMl;

/// How students may write numbers: `1500`, `1 500`, `1.5e3`.
const NOTATIONS: [&str; 3] = ["plain", "si-en", "scientific"];

/// The beginning of a file; groups of questions follow.
const HEAD: &str = "// Numbas version: exam_results_page_options\n";

/// An exam on its way.
struct Numbas<W: Write> {
    out: W,
    group: String,
    /// The number of questions that the group has.
    count: usize,
}

/// Begins an exam.
pub(super) fn begin<'w>(mut out: Box<dyn Write + 'w>, title: &str) -> Begun<'w> {
    out.write_all(HEAD.as_bytes())?;
    let name = json!(plain_name(title));
    writeln!(out, "{{\"name\":{name},\"metadata\":{{\"description\":\"\",\"licence\":\"None specified\"}},")?;
    out.write_all(b"\"duration\":0,\"percentPass\":50,\"showQuestionGroupNames\":false,\n")?;
    out.write_all(b"\"shuffleQuestionGroups\":false,\"question_groups\":[\n")?;
    Ok(Box::new(Numbas { out, group: String::new(), count: 0 }))
}

impl<W: Write> Export for Numbas<W> {
    fn write(&mut self, question: &Question<'_>) -> Result<(), NotWritten> {
        let group = question.name();
        if group == self.group {
            self.out.write_all(b",\n")?;
        } else {
            self.end_group()?;
            let between = if self.group.is_empty() { "" } else { ",\n" };
            let name = json!(plain_name(&question.form_title()));
            write!(self.out, "{between}{{\"name\":{name},\"pickingStrategy\":\"random-subset\",\"pickQuestions\":1,")?;
            self.out.write_all(b"\"questions\":[\n")?;
            self.group = group;
        }
        self.count += 1;
        Ok(write!(self.out, "{}", self::question(question)?)?)
    }

    fn finish(mut self: Box<Self>) -> Result<(), NotWritten> {
        self.end_group()?;
        let rest = json!({
            "navigation": {
                "allowregen": true, "reverse": true, "browse": true, "allowsteps": true, "showfrontpage": false,
                "showresultspage": "oncompletion", "onleave": { "action": "none", "message": "" },
                "preventleave": false, "navigatemode": "sequence",
            },
            "timing": {
                "allowPause": true, "timeout": { "action": "none", "message": "" },
                "timedwarning": { "action": "none", "message": "" },
            },
            "feedback": {
                "allowrevealanswer": true, "showtotalmark": true, "showactualmark": true, "showanswerstate": true,
                "intro": "", "end_message": "", "advicethreshold": 0, "feedbackmessages": [],
            },
            "extensions": [], "resources": [], "custom_part_types": [], "showstudentname": false,
        });
        let rest = rest.to_string();
        write!(self.out, "],\n{}\n", rest.strip_prefix('{').unwrap_or_default())?;
        Ok(self.out.flush()?)
    }
}

impl<W: Write> Numbas<W> {
    fn end_group(&mut self) -> Result<(), NotWritten> {
        if self.count > 0 {
            write!(self.out, "],\"questionNames\":{}}}", json!(vec![""; self.count]))?;
        }
        self.count = 0;
        Ok(())
    }
}

fn question(question: &Question<'_>) -> Result<Value, Faults> {
    let mut pictures = Pictures::new("", |markup, picture| {
        markup.picture(&format!("data:image/svg+xml;base64,{}", base64(picture.svg.as_bytes())), picture.drawing)
    });
    let statement = question.statement(MARKUP, &mut pictures)?;
    let writing = question.writing(MARKUP, TypedUnit::Never);
    let statement = statement + &writing + &question.code(MARKUP, None);
    let advice = question.solution(MARKUP, &mut pictures)?;
    let labelled = question.asked.len() > 1;
    let mut parts: Vec<Value> = question.fields().map(|(asking, field)| part(asking, field, labelled)).collect();
    let hints = question.hints(MARKUP)?;
    if let Some(first) = parts.first_mut().filter(|_| !hints.is_empty()) {
        let step = |hint: &String| json!({ "type": "information", "marks": 0, "prompt": literal(hint) });
        first["steps"] = hints.iter().map(step).collect();
        first["stepsPenalty"] = json!(question.item.hint_penalty.to_f64().value() * f64::from(question.weight()));
    }
    let name = plain_name(&question.title());
    Ok(json!({
        "name": name,
        "tags": ["momentous"],
        "metadata": { "description": question.item.code, "licence": "None specified" },
        "statement": literal(&statement), "advice": literal(&advice),
        "rulesets": {}, "extensions": [], "variables": {}, "variablesTest": { "condition": "", "maxRuns": 100 },
        "ungrouped_variables": [], "variable_groups": [], "functions": {}, "preamble": { "js": "", "css": "" },
        "parts": parts,
    }))
}

fn part(asking: &Asking<'_>, field: &Field<'_>, labelled: bool) -> Value {
    let caption = if field.caption.is_empty() {
        String::new()
    } else {
        format!(" \u{2013} {}", field.caption.trim_end_matches(':'))
    };
    let asked = asking.question(MARKUP, labelled) + &MARKUP.text(&caption);
    let unit = asking.unit(MARKUP);
    let unit = if unit.is_empty() { unit } else { format!(" ({unit})") };
    let prompt = literal(&MARKUP.paragraph(&(asked + &unit)));
    let mut part = match &field.asked {
        Asked::Choice(options) => choice(options, asking.weight),
        Asked::Number(number) => {
            let bands = bands(number, asking.part.field.points);
            let (right, others) = bands.split_first().map_or((None, &[][..]), |(first, rest)| (Some(first), rest));
            let mut part = right.map_or_else(|| json!({}), |band| window(band, asking.weight));
            part["displayAnswer"] = json!(number.right.to_string());
            part["alternatives"] =
                others.iter().zip(1..).map(|(band, place)| alternative(band, place, asking)).collect();
            part
        }
    };
    part["prompt"] = json!(prompt);
    part["useCustomName"] = json!(true);
    part["customName"] = json!(field.name);
    part["showCorrectAnswer"] = json!(true);
    part["showFeedbackIcon"] = json!(true);
    part["variableReplacements"] = json!([]);
    part["variableReplacementStrategy"] = json!("originalfirst");
    part["adaptiveMarkingUseCondition"] = json!("");
    part
}

/// An interval with what it earns.
fn window(band: &Band<'_>, weight: u32) -> Value {
    json!({
        "type": "numberentry", "marks": band.share * f64::from(weight),
        "minValue": band.low.to_string(), "maxValue": band.high.to_string(),
        "allowFractions": true, "showFractionHint": false, "notationStyles": NOTATIONS,
    })
}

fn alternative(band: &Band<'_>, place: usize, asking: &Asking<'_>) -> Value {
    let mut part = window(band, asking.weight);
    part["useCustomName"] = json!(true);
    part["customName"] = json!(format!("answer {place}"));
    part["alternativeFeedbackMessage"] = json!(literal(&said(MARKUP, band.feedback)));
    part["useAlternativeFeedback"] = json!(false);
    part["variableReplacements"] = json!([]);
    part["variableReplacementStrategy"] = json!("originalfirst");
    part
}

fn choice(options: &[Choice<'_>], weight: u32) -> Value {
    let matrix = options.iter().map(|choice| if choice.right { weight } else { 0 });
    json!({
        "type": "1_n_2", "marks": 0, "minMarks": 0, "maxMarks": 0, "shuffleChoices": false,
        "displayType": "radiogroup", "displayColumns": 0, "showCellAnswerState": true,
        "choices": options.iter().map(|choice| literal(&choice.shown(MARKUP))).collect::<Vec<_>>(),
        "matrix": matrix.collect::<Vec<_>>(),
        "distractors": options.iter().map(|choice| literal(&said(MARKUP, std::slice::from_ref(&choice.feedback)))).collect::<Vec<_>>(),
    })
}

/// A name: in one, too, something would be substituted for what stands in braces.
fn plain_name(name: &str) -> String {
    printable(name).replace(['{', '}'], "")
}

/// HTML in which nothing is substituted.
fn literal(html: &str) -> String {
    if html.is_empty() { String::new() } else { format!("<div nosubvars>{}</div>", printable(html)) }
}
