//! The fields of a variant as questions of Canvas, each with the whole statement.

use momentous_fault::Faults;
use momentous_render::Markup;

use super::super::band::{Band, bands};
use super::super::element::{Element, element};
use super::super::field::{Asked, Choice, Field};
use super::super::question::{Asking, Pictures, Question, TypedUnit, said};

/// The folder of pictures in the package.
pub(super) const FOLDER: &str = "pictures/";

const MARKUP: Markup = Markup::Pictures;

/// The response of a question.
const RESPONSE: &str = "response1";

/// A question for a field: its name, its points, and how it is written.
pub(super) type FieldItem = (String, u32, Element);

/// A question for each field, with the name of the field and its points; and the pictures of all.
pub(super) fn items(question: &Question<'_>) -> Result<(Vec<FieldItem>, Pictures), Faults> {
    let mut pictures = Pictures::new(&question.item.code, |markup, picture| {
        markup.picture(&format!("%24IMS-CC-FILEBASE%24/{FOLDER}{}", picture.name), picture.drawing)
    });
    let statement = question.statement(MARKUP, &mut pictures)?;
    let writing = question.writing(MARKUP, TypedUnit::Never);
    let solution = question.solution(MARKUP, &mut pictures)?;
    let several = question.fields().count() > 1;
    let item = |(asking, field): (&Asking<'_>, &Field<'_>)| {
        let unit = asking.unit(MARKUP);
        let unit = if unit.is_empty() { unit } else { format!(" ({unit})") };
        let place = place(asking, field);
        let asked = MARKUP.paragraph(&format!("{}{place}{unit}", asking.question(MARKUP, several)));
        let item = element("item")
            .with("ident", format!("{}-{}", question.item.code, field.name))
            .with("title", format!("{} ({})", question.title(), field.name));
        let writing = if matches!(field.asked, Asked::Number(_)) { writing.as_str() } else { "" };
        let text = format!("{statement}{}{asked}{writing}", question.code(MARKUP, Some(field)));
        let item = match &field.asked {
            Asked::Number(number) => {
                let right = bands(number, asking.part.field.points);
                let right: Vec<Band<'_>> = right.into_iter().filter(Band::is_full).collect();
                number_item(item, question, field, asking, &right, &text)
            }
            Asked::Choice(options) => choice_item(item, question, field, asking, options, &text),
        };
        (field.name.clone(), asking.weight, item.holding(feedback("general_fb", &solution)))
    };
    let items = question.fields().map(item).collect();
    Ok((items, pictures))
}

/// Which of several fields of a part is meant.
fn place(asking: &Asking<'_>, field: &Field<'_>) -> String {
    let place = asking.fields.iter().position(|listed| listed.name == field.name).unwrap_or_default() + 1;
    match (asking.fields.len(), field.caption.trim_end_matches(':')) {
        (1, "") => String::new(),
        (count, "") => format!(" ({place} of {count})"),
        (_, caption) => format!(" \u{2013} {caption}"),
    }
}

fn number_item(
    item: Element,
    question: &Question<'_>,
    field: &Field<'_>,
    asking: &Asking<'_>,
    right: &[Band<'_>],
    text: &str,
) -> Element {
    let answers: Vec<String> = (1..=right.len()).map(|place| format!("{}-{place}", field.name)).collect();
    let fib =
        element("render_fib").with("fibtype", "Decimal").holding(element("response_label").with("ident", "answer1"));
    let response = element("response_str").with("ident", RESPONSE).with("rcardinality", "Single").holding(fib);
    let condition = |band: &Band<'_>| {
        let bound = |name, end: f64| element(name).with("respident", RESPONSE).text(end.to_string());
        let within = element("conditionvar").holding(bound("vargte", band.low)).holding(bound("varlte", band.high));
        element("respcondition").with("continue", "No").holding(within).holding(full())
    };
    item.holding(metadata("numerical_question", question, field, asking, &answers))
        .holding(presentation(text).holding(response))
        .holding(processing().holding_all(right.iter().map(condition)))
}

fn choice_item(
    item: Element,
    question: &Question<'_>,
    field: &Field<'_>,
    asking: &Asking<'_>,
    options: &[Choice<'_>],
    text: &str,
) -> Element {
    let name = |place: usize| format!("{}-{}", field.name, place + 1);
    let names: Vec<String> = (0..options.len()).map(name).collect();
    let label = |(option, name): (&Choice<'_>, &String)| {
        element("response_label").with("ident", name).holding(material(&option.shown(MARKUP)))
    };
    let choices = element("render_choice").holding_all(options.iter().zip(&names).map(label));
    let response = element("response_lid").with("ident", RESPONSE).with("rcardinality", "Single").holding(choices);
    let mut resolved = processing();
    let mut said_of = Vec::new();
    for (option, name) in options.iter().zip(&names) {
        let chosen = || element("conditionvar").holding(element("varequal").with("respident", RESPONSE).text(name));
        if !option.feedback.is_empty() {
            let about = format!("{name}_fb");
            resolved = resolved
                .holding(element("respcondition").with("continue", "Yes").holding(chosen()).holding(shown(&about)));
            said_of.push(feedback(&about, &said(MARKUP, std::slice::from_ref(&option.feedback))));
        }
        if option.right {
            let right = element("respcondition").with("continue", "No").holding(chosen()).holding(full());
            resolved = resolved.holding(right);
        }
    }
    item.holding(metadata("multiple_choice_question", question, field, asking, &names))
        .holding(presentation(text).holding(response))
        .holding(resolved)
        .holding_all(said_of)
}

fn metadata(
    kind: &str,
    question: &Question<'_>,
    field: &Field<'_>,
    asking: &Asking<'_>,
    answers: &[String],
) -> Element {
    let entry = |label: &str, entry: String| {
        element("qtimetadatafield")
            .holding(element("fieldlabel").text(label))
            .holding(element("fieldentry").text(entry))
    };
    let fields = element("qtimetadata")
        .holding(entry("question_type", kind.to_owned()))
        .holding(entry("points_possible", asking.weight.to_string()))
        .holding(entry("original_answer_ids", answers.join(",")))
        .holding(entry("assessment_question_identifierref", format!("question-{}-{}", question.item.code, field.name)));
    element("itemmetadata").holding(fields)
}

fn presentation(html: &str) -> Element {
    element("presentation").holding(material(html))
}

/// The first step: the worked solution, which is shown whatever was answered.
fn processing() -> Element {
    let score = element("decvar")
        .with("maxvalue", "100")
        .with("minvalue", "0")
        .with("varname", "SCORE")
        .with("vartype", "Decimal");
    let always = element("respcondition")
        .with("continue", "Yes")
        .holding(element("conditionvar").holding(element("other")))
        .holding(shown("general_fb"));
    element("resprocessing").holding(element("outcomes").holding(score)).holding(always)
}

fn full() -> Element {
    element("setvar").with("action", "Set").with("varname", "SCORE").text("100")
}

fn shown(name: &str) -> Element {
    element("displayfeedback").with("feedbacktype", "Response").with("linkrefid", name)
}

fn feedback(name: &str, html: &str) -> Element {
    element("itemfeedback").with("ident", name).holding(element("flow_mat").holding(material(html)))
}

/// HTML as Canvas reads it: as a text.
fn material(html: &str) -> Element {
    element("material").holding(element("mattext").with("texttype", "text/html").text(html))
}
