//! Moodle XML: a question for each item, in a category for each problem and digest.

mod answer;
mod cloze;
mod units;

use std::io;
use std::io::Write;

use quick_xml::Writer;
use quick_xml::events::{BytesCData, BytesDecl, BytesEnd, BytesStart, BytesText, Event};

use momentous_exercise::Item;
use momentous_exercise::ItemPart;
use momentous_exercise::NumberItem;
use momentous_quantity::Rational;
use momentous_render::Identity;
use momentous_render::Markup;
use momentous_render::base64;

use super::Begun;
use super::Export;
use super::NotWritten;
use super::field::{Asked, Choice, Field};
use super::printable;
use super::question::{Pictures, Question, TypedUnit, said};

/// The letters that an idnumber may have.
const LONGEST_ID: usize = 100;

/// A file on its way. Each item is written as it comes.
struct Moodle<W: Write> {
    xml: Writer<W>,
    markup: Markup,
    category: String,
}

/// Begins a file.
pub(super) fn begin(out: Box<dyn Write + '_>, markup: Markup) -> Begun<'_> {
    let mut xml = Writer::new(out);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    xml.get_mut().write_all(b"\n")?;
    xml.write_event(Event::Start(BytesStart::new("quiz")))?;
    Ok(Box::new(Moodle { xml, markup, category: String::new() }))
}

impl<W: Write> Export for Moodle<W> {
    fn write(&mut self, question: &Question<'_>) -> Result<(), NotWritten> {
        let texts = Texts::of(question, self.markup)?;
        self.category(question.item)?;
        texts.write(&mut self.xml, question, self.markup)?;
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), NotWritten> {
        self.xml.write_event(Event::End(BytesEnd::new("quiz")))?;
        self.xml.get_mut().write_all(b"\n")?;
        Ok(self.xml.get_mut().flush()?)
    }
}

impl<W: Write> Moodle<W> {
    /// Opens the category of an item, where it is not open.
    fn category(&mut self, item: &Item) -> io::Result<()> {
        let Identity { problem, .. } = &item.identity;
        let name = |text: &str| text.replace('/', "//");
        let path = format!("top/momentous/{}/{}", name(problem), item.version);
        if path == self.category {
            return Ok(());
        }
        let start = BytesStart::new("question").with_attributes([("type", "category")]);
        self.xml.write_event(Event::Start(start))?;
        self.xml.create_element("category").write_inner_content(|xml| text(xml, "text", &path))?;
        self.xml.write_event(Event::End(BytesEnd::new("question")))?;
        self.category = path;
        Ok(())
    }
}

/// The texts of a question, with the pictures in them.
struct Texts {
    text: String,
    shown: Pictures,
    solution: String,
    solution_shown: Pictures,
    hints: Vec<String>,
}

impl Texts {
    fn of(question: &Question<'_>, markup: Markup) -> Result<Self, NotWritten> {
        let pictures = |name| {
            Pictures::new(name, |markup, picture| {
                markup.picture(&format!("@@PLUGINFILE@@/{}", picture.name), picture.drawing)
            })
        };
        let (mut shown, mut solution_shown) = (pictures("figure"), pictures("solution"));
        let mut text = question.statement(markup, &mut shown)?;
        let unit = if types_unit(question) { TypedUnit::Behind } else { TypedUnit::Never };
        text += &(question.writing(markup, unit) + &question.code(markup, None));
        match only(question) {
            None => text = cloze::text(&text, question, markup),
            Some((part, _)) => {
                let unit = part.field.unit.as_ref().map(|unit| format!(" (in {}).", markup.math(unit)));
                let asked = question.asked.first().map(|asking| asking.question(markup, false)).unwrap_or_default();
                text.push_str(&markup.paragraph(&(asked + &unit.unwrap_or_default())));
            }
        }
        let solution = question.solution(markup, &mut solution_shown)?;
        Ok(Self { text, shown, solution, solution_shown, hints: question.hints(markup)? })
    }

    fn write<W: Write>(&self, xml: &mut Writer<W>, question: &Question<'_>, markup: Markup) -> io::Result<()> {
        let (only, item) = (only(question), question.item);
        let kind = match only {
            None => "cloze",
            Some((_, Field { asked: Asked::Number(_), .. })) => "numerical",
            Some(_) => "multichoice",
        };
        let start = BytesStart::new("question").with_attributes([("type", kind)]);
        xml.write_event(Event::Start(start))?;
        xml.create_element("name").write_inner_content(|xml| text(xml, "text", &title(item)))?;
        html(xml, "questiontext", &self.text, &self.shown.files)?;
        html(xml, "generalfeedback", &self.solution, &self.solution_shown.files)?;
        if let Some((part, _)) = only {
            text(xml, "defaultgrade", &part.field.points.to_string())?;
        }
        text(xml, "penalty", &item.penalty.to_f64().value().to_string())?;
        text(xml, "idnumber", &id_number(&item.identity))?;
        match only {
            Some((part, Field { asked: Asked::Number(number), .. })) => numerical(xml, part, number, markup)?,
            Some((_, Field { asked: Asked::Choice(options), .. })) => choice(xml, options, markup)?,
            None => {}
        }
        for hint in &self.hints {
            html(xml, "hint", hint, &[])?;
        }
        xml.create_element("tags").write_inner_content(|xml| {
            for tag in ["momentous", item.identity.problem.as_str()] {
                xml.create_element("tag").write_inner_content(|xml| text(xml, "text", tag))?;
            }
            Ok(())
        })?;
        xml.write_event(Event::End(BytesEnd::new("question")))?;
        xml.get_mut().write_all(b"\n")
    }
}

/// The field of a question that has one only.
fn only<'q, 'i>(question: &'q Question<'i>) -> Option<(&'i ItemPart, &'q Field<'i>)> {
    let mut fields = question.fields();
    let (asking, field) = fields.next()?;
    fields.next().is_none().then_some((asking.part, field))
}

/// Whether students type the unit of a question.
pub(super) fn types_unit(question: &Question<'_>) -> bool {
    let number = only(question)
        .and_then(|(_, field)| if let Asked::Number(number) = &field.asked { Some(number) } else { None });
    number.is_some_and(|number| !units::units(&number.unit).is_empty())
}

fn title(item: &Item) -> String {
    let Identity { form, seed, .. } = &item.identity;
    let form = form.as_ref().map(|form| format!(", {form}")).unwrap_or_default();
    let seed = seed.map(|seed| format!(", seed {seed}")).unwrap_or_default();
    let code = if item.code.is_empty() { String::new() } else { format!(", {}", item.code) };
    format!("{}{form}{seed}{code}", item.sheet.title)
}

/// The identity that makes the same numbers again; of one too long for Moodle, the end, which tells variants of a problem apart.
fn id_number(identity: &Identity) -> String {
    let Identity { problem, form, seed, digest, scheme, .. } = identity;
    let number = |number: Option<u64>| number.map_or_else(|| "-".to_owned(), |number| number.to_string());
    let [form, digest] = [form, digest].map(|text| text.as_deref().unwrap_or("-"));
    let (scheme, seed) = (number(scheme.map(u64::from)), number(*seed));
    let whole = format!("{problem}:{digest}:{scheme}:{form}:{seed}");
    whole.chars().skip(whole.chars().count().saturating_sub(LONGEST_ID)).collect()
}

fn numerical<W: Write>(xml: &mut Writer<W>, part: &ItemPart, number: &NumberItem, markup: Markup) -> io::Result<()> {
    for answer in answer::answers(number, part.field.points) {
        let fraction = answer.fraction.to_string();
        let start =
            BytesStart::new("answer").with_attributes([("fraction", &*fraction), ("format", "moodle_auto_format")]);
        xml.write_event(Event::Start(start))?;
        text(xml, "text", &answer.value)?;
        html(xml, "feedback", &said(markup, answer.feedback), &[])?;
        text(xml, "tolerance", &answer.tolerance.to_string())?;
        xml.write_event(Event::End(BytesEnd::new("answer")))?;
    }
    let units = units::units(&number.unit);
    if units.is_empty() {
        return text(xml, "showunits", "3");
    }
    let left = &number.without_unit.0 / Rational::from(part.field.points.max(1));
    let left = answer::nearest(left.to_f64().value());
    text(xml, "unitgradingtype", "1")?;
    text(xml, "unitpenalty", &((100.0 - left) / 100.0).to_string())?;
    text(xml, "showunits", "0")?;
    text(xml, "unitsleft", "0")?;
    xml.create_element("units").write_inner_content(|xml| {
        for (name, multiplier) in &units {
            xml.create_element("unit").write_inner_content(|xml| {
                text(xml, "multiplier", &multiplier.to_string())?;
                text(xml, "unit_name", name)
            })?;
        }
        Ok(())
    })?;
    Ok(())
}

fn choice<W: Write>(xml: &mut Writer<W>, options: &[Choice<'_>], markup: Markup) -> io::Result<()> {
    text(xml, "single", "true")?;
    text(xml, "shuffleanswers", "false")?;
    text(xml, "answernumbering", "abc")?;
    for option in options {
        let fraction = if option.right { "100" } else { "0" };
        let start = BytesStart::new("answer").with_attributes([("fraction", fraction), ("format", "html")]);
        xml.write_event(Event::Start(start))?;
        cdata(xml, &option.shown(markup))?;
        html(xml, "feedback", &said(markup, std::slice::from_ref(&option.feedback)), &[])?;
        xml.write_event(Event::End(BytesEnd::new("answer")))?;
    }
    Ok(())
}

/// An element that holds a text.
fn text<W: Write>(xml: &mut Writer<W>, name: &str, content: &str) -> io::Result<()> {
    xml.create_element(name).write_text_content(BytesText::new(&printable(content)))?;
    Ok(())
}

/// An element that holds HTML, with the pictures that it shows.
fn html<W: Write>(xml: &mut Writer<W>, name: &str, content: &str, files: &[(String, String)]) -> io::Result<()> {
    xml.write_event(Event::Start(BytesStart::new(name).with_attributes([("format", "html")])))?;
    cdata(xml, content)?;
    for (name, svg) in files {
        let file = [("name", name.as_str()), ("path", "/"), ("encoding", "base64")];
        let file = xml.create_element("file").with_attributes(file);
        file.write_text_content(BytesText::new(&base64(svg.as_bytes())))?;
    }
    xml.write_event(Event::End(BytesEnd::new(name)))
}

/// A text that no mark-up is read in.
fn cdata<W: Write>(xml: &mut Writer<W>, content: &str) -> io::Result<()> {
    xml.write_event(Event::Start(BytesStart::new("text")))?;
    for piece in BytesCData::escaped(&printable(content)) {
        xml.write_event(Event::CData(piece))?;
    }
    xml.write_event(Event::End(BytesEnd::new("text")))
}
