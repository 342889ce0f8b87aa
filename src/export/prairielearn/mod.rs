//! `PrairieLearn`: for each form a folder of a question whose `server.py` holds the variants as data.

use std::io::Write;

use serde_json::Value;
use serde_json::json;
use sha2::Digest;
use sha2::Sha256;

use momentous_render::Markup;

use super::Export;
use super::NotWritten;
use super::band::bands;
use super::field::{Asked, Choice, Field};
use super::package::Package;
use super::printable;
use super::question::{Asking, Pictures, Question, TypedUnit, said};

/// The script that marks every question.
const SERVER: &str = include_str!("server.py");

/// The page of every question.
const PAGE: &str = include_str!("question.html");

/// A package that is being written. The variants of a form stand in one file, which has to wait until their pictures are written.
struct PrairieLearn<W: Write> {
    package: Package<W>,
    markup: Markup,
    form: Option<Form>,
}

/// The question that is being written.
struct Form {
    folder: String,
    about: Value,
    /// The variants, each as a string of Python that holds JSON.
    variants: String,
}

/// Begins a package.
pub(super) fn begin(out: Box<dyn Write + '_>, markup: Markup) -> Box<dyn Export + '_> {
    Box::new(PrairieLearn { package: Package::new(out), markup, form: None })
}

impl<W: Write> Export for PrairieLearn<W> {
    fn write(&mut self, question: &Question<'_>) -> Result<(), NotWritten> {
        let folder = question.name();
        if self.form.as_ref().is_none_or(|form| form.folder != folder) {
            self.end_form()?;
        }
        let mut pictures = Pictures::new(&question.item.code, |markup, picture| {
            let about = markup.attribute(&picture.drawing.description);
            let caption = markup.text(&picture.drawing.caption);
            format!(
                "<pl-figure file-name=\"{}\" alt=\"{about}\"></pl-figure>{}",
                picture.name,
                markup.paragraph(&caption)
            )
        });
        let variant = variant(question, self.markup, &mut pictures)?;
        self.package.pictures(&format!("{folder}/clientFilesQuestion/"), &pictures)?;
        let form = self.form.get_or_insert_with(|| Form { folder, about: about(question), variants: String::new() });
        // What JSON writes as a string is one of Python, too.
        form.variants.extend(["    ", &Value::from(variant.to_string()).to_string(), ",\n"]);
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), NotWritten> {
        self.end_form()?;
        self.package.finish()
    }
}

impl<W: Write> PrairieLearn<W> {
    fn end_form(&mut self) -> Result<(), NotWritten> {
        let Some(Form { folder, about, variants }) = self.form.take() else { return Ok(()) };
        let file = |name: &str| format!("{folder}/{name}");
        self.package.put(&file("info.json"), &format!("{about:#}\n"))?;
        self.package.put(&file("question.html"), PAGE)?;
        self.package.put(&file("server.py"), &format!("import json\n\nVARIANTS = [\n{variants}]\n\n\n{SERVER}"))
    }
}

fn about(question: &Question<'_>) -> Value {
    let identity = &question.item.identity;
    let topic = identity.problem.split('/').next().unwrap_or_default();
    let form = identity.form.as_ref().map(|form| format!(" ({form})")).unwrap_or_default();
    let key = format!("{}\0{}", question.name(), identity.digest.as_deref().unwrap_or_default());
    json!({
        "uuid": uuid(&key), "title": format!("{}{form}", question.item.sheet.title), "topic": topic,
        "tags": ["momentous"], "type": "v3", "partialCredit": true,
    })
}

/// A universally unique identifier of version 8 (RFC 9562) that is made from a text.
fn uuid(text: &str) -> String {
    let mut bytes = [0; 16];
    bytes.iter_mut().zip(Sha256::digest(text.as_bytes())).for_each(|(mixed, byte)| *mixed = byte);
    bytes[6] = bytes[6] & 0x0f | 0x80;
    bytes[8] = bytes[8] & 0x3f | 0x80;
    let digits = format!("{:032x}", u128::from_be_bytes(bytes));
    [&digits[..8], &digits[8..12], &digits[12..16], &digits[16..20], &digits[20..]].join("-")
}

fn variant(question: &Question<'_>, markup: Markup, pictures: &mut Pictures) -> Result<Value, NotWritten> {
    let labelled = question.asked.len() > 1;
    let statement = question.statement(markup, pictures)?;
    let writing = question.writing(markup, TypedUnit::Never);
    let statement = statement + &writing + &question.code(markup, None);
    let solution = question.solution(markup, pictures)?;
    let fields: Vec<Value> =
        question.fields().map(|(asking, field)| self::field(asking, field, markup, labelled)).collect();
    let hints: Vec<String> = question.hints(markup)?.iter().map(|hint| text(hint)).collect();
    Ok(json!({ "statement": text(&statement), "solution": text(&solution), "hints": hints, "fields": fields }))
}

fn field(asking: &Asking<'_>, field: &Field<'_>, markup: Markup, labelled: bool) -> Value {
    let is_first = asking.fields.first().is_some_and(|first| first.name == field.name);
    let asked = if is_first { markup.paragraph(&asking.question(markup, labelled)) } else { String::new() };
    let mut field_of_number = json!({
        "name": field.name, "weight": asking.weight, "before": text(&(asked + &markup.text(&field.caption))),
    });
    match &field.asked {
        Asked::Number(number) => {
            let windows = bands(number, asking.part.field.points);
            let windows =
                windows.iter().map(|band| json!([band.low, band.high, band.share, text(&said(markup, band.feedback))]));
            field_of_number["number"] = json!(true);
            field_of_number["right"] = json!(number.right);
            field_of_number["unit"] = json!(asking.unit(markup));
            field_of_number["windows"] = windows.collect();
        }
        Asked::Choice(options) => {
            let option = |choice: &Choice<'_>| {
                let feedback = text(&said(markup, std::slice::from_ref(&choice.feedback)));
                let right = if choice.right { "true" } else { "false" };
                json!({ "html": text(&choice.shown(markup)), "right": right, "feedback": feedback })
            };
            field_of_number["choice"] = json!(true);
            field_of_number["options"] = options.iter().map(option).collect();
        }
    }
    field_of_number
}

fn text(html: &str) -> String {
    printable(html).into_owned()
}
