//! Moodle XML: a question for each item, in a category for each problem and digest.

mod answer;
mod cloze;

use std::io;
use std::io::Write;

use quick_xml::Writer;
use quick_xml::events::{BytesCData, BytesDecl, BytesEnd, BytesStart, BytesText, Event};

use crate::exercise::Item;
use crate::exercise::ItemPart;
use crate::exercise::NumberItem;
use crate::explain::Audience;
use crate::explain::Inline;
use crate::figure;
use crate::render::Fragment;
use crate::render::Identity;
use crate::render::Page;
use crate::render::Renderer;
use crate::render::Solution;
use crate::render::base64;

use super::NotWritten;
use super::feature::Feature;
use super::field::{Asked, Choice, Field, fields};
use super::printable;

/// What a try costs in behaviours with several tries: Moodle's own default.
const PENALTY: &str = "0.3333333";

/// The letters that an idnumber may have.
const LONGEST_ID: usize = 100;

/// The heading of the level at which a document's own begin.
const LEVEL: usize = 4;

/// A part with its fields.
type Asking<'i> = (&'i ItemPart, Vec<Field<'i>>);

/// A file on its way. Each item is written as it comes.
pub struct Moodle<W: Write> {
    xml: Writer<W>,
    renderer: Renderer,
    category: String,
}

impl<W: Write> Moodle<W> {
    /// Begins a file.
    ///
    /// # Errors
    /// Where the file takes nothing.
    pub fn new(out: W, renderer: Renderer) -> io::Result<Self> {
        let mut xml = Writer::new(out);
        xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
        xml.get_mut().write_all(b"\n")?;
        xml.write_event(Event::Start(BytesStart::new("quiz")))?;
        Ok(Self { xml, renderer, category: String::new() })
    }

    /// Writes an item. Gives what did not go along as it is.
    ///
    /// # Errors
    /// Where a text is not fit to print, or the file takes nothing.
    pub fn write(&mut self, item: &Item) -> Result<Vec<Feature>, NotWritten> {
        let mut lost = vec![Feature::Writing];
        let mut asked: Vec<Asking<'_>> = Vec::new();
        for part in &item.parts {
            let (fields, feature) = fields(part);
            lost.extend(feature);
            lost.extend(is_snapped(part, &fields).then_some(Feature::Credit));
            if !fields.is_empty() {
                asked.push((part, fields));
            }
        }
        let count: usize = asked.iter().map(|(_, fields)| fields.len()).sum();
        if count > 1 {
            let has_unit = |(part, _): &Asking<'_>| part.field.unit.is_some();
            lost.extend(asked.iter().any(has_unit).then_some(Feature::UnitsOfSeveral));
            lost.extend((asked.len() > 1).then_some(Feature::FollowThrough));
        }
        if count > 0 {
            let question = Question::of(item, &asked, &self.renderer)?;
            self.category(item)?;
            question.write(&mut self.xml, item, &asked)?;
        }
        lost.sort_unstable();
        lost.dedup();
        Ok(lost)
    }

    /// Ends the file.
    ///
    /// # Errors
    /// Where the file takes nothing.
    pub fn finish(mut self) -> io::Result<W> {
        self.xml.write_event(Event::End(BytesEnd::new("quiz")))?;
        self.xml.get_mut().write_all(b"\n")?;
        Ok(self.xml.into_inner())
    }

    /// Opens the category of an item, where it is not open.
    fn category(&mut self, item: &Item) -> io::Result<()> {
        let Identity { problem, digest, .. } = &item.identity;
        let name = |text: &str| text.replace('/', "//");
        let path = format!("top/momentous/{}/{}", name(problem), name(digest.as_deref().unwrap_or("no digest")));
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

/// Whether a fraction of a part is none of Moodle's.
fn is_snapped(part: &ItemPart, fields: &[Field<'_>]) -> bool {
    fields.iter().any(|field| match &field.asked {
        Asked::Number(number) => answer::answers(number, part.field.points).1,
        Asked::Choice { .. } => false,
    })
}

/// The texts of a question, as HTML.
struct Question {
    text: String,
    solution: String,
    hints: Vec<String>,
}

impl Question {
    fn of(item: &Item, asked: &[Asking<'_>], renderer: &Renderer) -> Result<Self, NotWritten> {
        let sheet = &item.sheet;
        let authored = |text: &str| Fragment::authored(&item.identity.problem, text, LEVEL);
        let mut text = authored(&sheet.statement)?.as_str().to_owned();
        if let Some(drawing) = &sheet.figure {
            let about = Fragment::inline(&[Inline::Text(drawing.description.clone())]);
            text = format!("{text}\n<p><img src=\"@@PLUGINFILE@@/figure.svg\" alt=\"{}\"/></p>", about.as_str());
        }
        if !sheet.note.is_empty() {
            text = format!("{text}\n<p>{}</p>", Fragment::inline(&sheet.note).as_str());
        }
        text = match asked {
            [(part, fields)] if fields.len() == 1 => text + "\n" + &question(part),
            _ => cloze::text(&text, asked),
        };
        let solution = Solution {
            outline: item.solution.clone(),
            identity: item.identity.clone(),
            audience: Audience::Everyone,
            faded: None,
        };
        let solution = Fragment::page(renderer, &Page::Solution(solution))?.as_str().to_owned();
        let hints = sheet.hints.iter().map(|hint| Ok(authored(hint)?.as_str().to_owned()));
        Ok(Self { text, solution, hints: hints.collect::<Result<_, NotWritten>>()? })
    }

    fn write<W: Write>(&self, xml: &mut Writer<W>, item: &Item, asked: &[Asking<'_>]) -> io::Result<()> {
        let only = match asked {
            [(part, fields)] => fields.first().filter(|_| fields.len() == 1).map(|field| (*part, field)),
            _ => None,
        };
        let kind = match only {
            None => "cloze",
            Some((_, Field { asked: Asked::Number(_), .. })) => "numerical",
            Some(_) => "multichoice",
        };
        let start = BytesStart::new("question").with_attributes([("type", kind)]);
        xml.write_event(Event::Start(start))?;
        xml.create_element("name").write_inner_content(|xml| text(xml, "text", &title(item)))?;
        let figure = item.sheet.figure.as_ref().map(figure::svg_file);
        html(xml, "questiontext", &self.text, figure.as_deref())?;
        html(xml, "generalfeedback", &self.solution, None)?;
        if let Some((part, _)) = only {
            text(xml, "defaultgrade", &part.field.points.to_string())?;
        }
        text(xml, "penalty", PENALTY)?;
        text(xml, "idnumber", &id_number(&item.identity))?;
        match only {
            Some((part, Field { asked: Asked::Number(number), .. })) => numerical(xml, part, number)?,
            Some((_, Field { asked: Asked::Choice { options, shuffled }, .. })) => choice(xml, options, *shuffled)?,
            None => {}
        }
        for hint in &self.hints {
            html(xml, "hint", hint, None)?;
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

/// What is asked, with its unit.
fn question(part: &ItemPart) -> String {
    let unit = part.field.unit.as_ref().map(|unit| format!(" (in {}).", Fragment::math(unit).as_str()));
    format!("<p>{}{}</p>", Fragment::inline(&part.field.question).as_str(), unit.unwrap_or_default())
}

fn title(item: &Item) -> String {
    let Identity { form, seed, .. } = &item.identity;
    let form = form.as_ref().map(|form| format!(", {form}")).unwrap_or_default();
    let seed = seed.map(|seed| format!(", seed {seed}")).unwrap_or_default();
    format!("{}{form}{seed}", item.sheet.title)
}

/// What makes the same numbers again; of what is too long for Moodle, the end, which tells variants of a problem apart.
fn id_number(identity: &Identity) -> String {
    let Identity { problem, form, seed, digest, scheme, .. } = identity;
    let number = |number: Option<u64>| number.map_or_else(|| "-".to_owned(), |number| number.to_string());
    let [form, digest] = [form, digest].map(|text| text.as_deref().unwrap_or("-"));
    let (scheme, seed) = (number(scheme.map(u64::from)), number(*seed));
    let whole = format!("{problem}:{digest}:{scheme}:{form}:{seed}");
    whole.chars().skip(whole.chars().count().saturating_sub(LONGEST_ID)).collect()
}

fn numerical<W: Write>(xml: &mut Writer<W>, part: &ItemPart, number: &NumberItem) -> io::Result<()> {
    for own in answer::answers(number, part.field.points).0 {
        let fraction = own.fraction.to_string();
        let start =
            BytesStart::new("answer").with_attributes([("fraction", &*fraction), ("format", "moodle_auto_format")]);
        xml.write_event(Event::Start(start))?;
        text(xml, "text", &own.value)?;
        html(xml, "feedback", &paragraphs(own.feedback), None)?;
        text(xml, "tolerance", &own.tolerance.to_string())?;
        xml.write_event(Event::End(BytesEnd::new("answer")))?;
    }
    let units = answer::units(&number.unit);
    if units.is_empty() {
        return text(xml, "showunits", "3");
    }
    let (left, _) = answer::fraction(&number.without_unit, part.field.points);
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

fn choice<W: Write>(xml: &mut Writer<W>, options: &[Choice<'_>], shuffled: bool) -> io::Result<()> {
    text(xml, "single", "true")?;
    text(xml, "shuffleanswers", if shuffled { "true" } else { "false" })?;
    text(xml, "answernumbering", "abc")?;
    for option in options {
        let fraction = if option.right { "100" } else { "0" };
        let start = BytesStart::new("answer").with_attributes([("fraction", fraction), ("format", "html")]);
        xml.write_event(Event::Start(start))?;
        cdata(xml, Fragment::inline(&[Inline::Text(option.text.to_owned())]).as_str())?;
        html(xml, "feedback", &paragraphs(std::slice::from_ref(&option.feedback)), None)?;
        xml.write_event(Event::End(BytesEnd::new("answer")))?;
    }
    Ok(())
}

/// Texts as paragraphs of HTML.
fn paragraphs(texts: &[String]) -> String {
    let said = texts.iter().filter(|text| !text.is_empty());
    let inline = |text: &String| Fragment::inline(&[Inline::Text(text.clone())]);
    said.flat_map(|text| ["<p>".to_owned(), inline(text).as_str().to_owned(), "</p>".to_owned()]).collect()
}

/// An element that holds a text.
fn text<W: Write>(xml: &mut Writer<W>, name: &str, content: &str) -> io::Result<()> {
    xml.create_element(name).write_text_content(BytesText::new(&printable(content)))?;
    Ok(())
}

/// An element that holds HTML, with the figure that it shows.
fn html<W: Write>(xml: &mut Writer<W>, name: &str, content: &str, figure: Option<&str>) -> io::Result<()> {
    xml.write_event(Event::Start(BytesStart::new(name).with_attributes([("format", "html")])))?;
    cdata(xml, content)?;
    if let Some(figure) = figure {
        let file = [("name", "figure.svg"), ("path", "/"), ("encoding", "base64")];
        let file = xml.create_element("file").with_attributes(file);
        file.write_text_content(BytesText::new(&base64(figure.as_bytes())))?;
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
