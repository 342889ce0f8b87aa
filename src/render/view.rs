//! Values that a template sees: plain ones, whose marked-safe strings are already in the tongue of the format.

use std::borrow::Cow;

use tera::{Context, Map, Value};

use momentous_explain::Audience;
use momentous_explain::Block;
use momentous_explain::Inline;
use momentous_explain::Section;
use momentous_fault::Faults;
use momentous_figure as figure;
use momentous_figure::Drawing;

use super::authored::Authored;
use super::document::{BesideFile, Figures, Format};
use super::fade::fade;
use super::key_groups::{Group, groups};
use super::page::{Heading, Identity, Key, KeyRow, PageView, Sheet, SheetPart, Solution};
use super::seed_word::SeedWord;
use super::writer::Writer;
use super::writers::writer;

/// Makes the values of one document, and collects the files that go beside it.
pub(super) struct View<'a> {
    writer: &'static dyn Writer,
    format: Format,
    /// The prefix of the names of figures; only Markdown has the choice.
    beside_prefix: Option<&'a str>,
    /// Whether the page around the document has the rules of figures.
    unstyled: bool,
    /// The level of the headings of a page.
    level: usize,
    /// The files that go beside the document.
    pub beside: Vec<BesideFile>,
}

type Fields<const N: usize> = [(&'static str, Value); N];

fn map<const N: usize>(fields: Fields<N>) -> Value {
    Value::from(fields.into_iter().map(|(key, value)| (tera::value::Key::Str(key), value)).collect::<Map>())
}

fn ready(text: &str) -> Value {
    Value::safe_string(text)
}

fn optional<T>(value: Option<T>, make: impl FnOnce(T) -> Value) -> Value {
    value.map_or_else(Value::none, make)
}

impl<'a> View<'a> {
    /// A view for one document.
    pub fn new(format: Format, figures: &'a Figures, is_wide: bool) -> Self {
        let beside_prefix = match (format, figures) {
            (Format::Markdown, Figures::Beside(prefix)) => Some(prefix.as_str()),
            _ => None,
        };
        let unstyled = format == Format::Html && *figures == Figures::Unstyled;
        Self { writer: writer(format, is_wide), format, beside_prefix, unstyled, level: 1, beside: Vec::new() }
    }

    /// The values of the whole document: `title`, `level` and `pages`.
    pub fn document(&mut self, pages: &[PageView]) -> Result<Context, Faults> {
        // A document of several pages has a title of its own in HTML; where pages are paper, each has its title.
        self.level = if pages.len() > 1 && self.format != Format::Typst { 2 } else { 1 };
        let values = pages.iter().map(|page| self.page(*page)).collect::<Result<Vec<Value>, Faults>>()?;
        let mut context = Context::new();
        context.insert("title", document_title(pages));
        context.insert("level", &self.level);
        context.insert_value("pages", Value::from(values));
        Ok(context)
    }

    fn page(&mut self, page: PageView) -> Result<Value, Faults> {
        match page {
            PageView::Sheet(sheet) => self.sheet(sheet),
            PageView::Solution(solution) => self.solution(solution),
            PageView::Key(key) => Ok(self.key(key)),
        }
    }

    fn sheet(&mut self, sheet: &Sheet) -> Result<Value, Faults> {
        let id = &sheet.identity.problem;
        let statement = self.authored(&format!("{id}: text"), &sheet.statement)?;
        let mut hints = Vec::new();
        for (index, hint) in sheet.hints.iter().enumerate() {
            hints.push(self.authored(&format!("{id}: hint {}", index + 1), hint)?);
        }
        let figure = optional(sheet.figure.as_deref(), |figure| self.figure(figure));
        let parts: Vec<Value> = sheet.parts.iter().map(|part| self.part(part)).collect();
        let total: f64 = sheet.parts.iter().filter_map(|part| part.points).sum();
        Ok(map([
            ("kind", "sheet".into()),
            ("title", sheet.title.as_str().into()),
            ("number", sheet.place.as_ref().map(|place| place.number).into()),
            ("heading", optional(sheet.place.as_ref().and_then(|place| place.heading.as_ref()), heading)),
            // Where a sheet has several problems, each follows the one before it.
            ("continues", sheet.place.as_ref().is_some_and(|place| place.heading.is_none()).into()),
            ("identity", identity(&sheet.identity)),
            ("student", sheet.student.clone().into()),
            ("statement", statement),
            ("parts", Value::from(parts)),
            ("points", points(Some(total).filter(|total| *total > 0.0))),
            ("note", optional(Some(&sheet.note).filter(|note| !note.is_empty()), |note| self.inline(note))),
            ("figure", figure),
            ("hints", Value::from(hints)),
            ("room", sheet.room.into()),
            // A small figure stands beside the text on paper, unless pictures or room for answers need the whole width.
            ("aside", optional(sheet.figure.as_deref().and_then(width_aside), Value::from)),
            ("flows", (sheet.room == 0 && sheet.parts.iter().all(|part| part.pictures.is_empty())).into()),
        ]))
    }

    fn part(&mut self, part: &SheetPart) -> Value {
        let pictures: Vec<Value> = part.pictures.iter().map(|picture| self.figure(picture)).collect();
        let option = |(text, letter): (&String, char)| self.inline(&Inline::line(&format!("{letter}. {text}")));
        map([
            ("label", part.label.as_str().into()),
            ("text", self.inline(&part.text)),
            ("options", Value::from(part.options.iter().zip('A'..='Z').map(option).collect::<Vec<_>>())),
            ("pictures", Value::from(pictures)),
            ("unit", optional(part.unit.as_ref(), |unit| ready(&self.writer.math(unit)))),
            ("points", points(part.points)),
        ])
    }

    fn solution(&mut self, solution: &Solution) -> Result<Value, Faults> {
        let shown = match solution.faded {
            Some(steps) => Cow::Owned(fade(&solution.outline, steps)),
            None => Cow::Borrowed(&solution.outline),
        };
        let id = &solution.identity.problem;
        let reads =
            |section: &&Section| section.audience == Audience::Everyone || solution.audience == Audience::Instructor;
        let mut sections = Vec::new();
        for section in shown.sections.iter().filter(reads) {
            let blocks =
                section.blocks.iter().map(|block| self.block(id, block)).collect::<Result<Vec<Value>, Faults>>()?;
            sections.push(map([
                ("heading", section.heading.as_str().into()),
                ("instructor", (section.audience == Audience::Instructor).into()),
                ("blocks", Value::from(blocks)),
            ]));
        }
        Ok(map([
            ("kind", "solution".into()),
            ("title", shown.title.as_str().into()),
            ("identity", identity(&solution.identity)),
            ("faded", solution.faded.is_some().into()),
            ("sections", Value::from(sections)),
        ]))
    }

    fn key(&self, key: &Key) -> Value {
        let row = |row: &KeyRow| {
            map([
                ("identity", identity(&row.identity)),
                ("student", row.student.clone().into()),
                ("part", row.part.as_str().into()),
                ("answer", self.inline(&row.answer)),
            ])
        };
        map([
            ("kind", "key".into()),
            ("title", key.title.as_str().into()),
            ("has_students", key.rows.iter().any(|row| row.student.is_some()).into()),
            ("groups", Value::from(groups(key).iter().map(|group| self.group(group)).collect::<Vec<_>>())),
            ("rows", Value::from(key.rows.iter().map(row).collect::<Vec<_>>())),
        ])
    }

    /// The answers to one problem: a row for each sheet, a column for each part.
    fn group(&self, group: &Group<'_>) -> Value {
        let row = |row: &Vec<&KeyRow>| {
            let answer =
                |part: &&str| row.iter().find(|cell| cell.part == **part).map(|cell| self.inline(&cell.answer));
            let first = row.first();
            map([
                ("identity", optional(first, |first| identity(&first.identity))),
                ("student", first.and_then(|first| first.student.clone()).into()),
                (
                    "answers",
                    Value::from(
                        group.parts.iter().map(|part| optional(answer(part), |answer| answer)).collect::<Vec<_>>(),
                    ),
                ),
            ])
        };
        map([
            ("identity", identity(group.identity)),
            ("has_students", group.rows.iter().flatten().any(|row| row.student.is_some()).into()),
            ("parts", Value::from(group.parts.clone())),
            ("rows", Value::from(group.rows.iter().map(row).collect::<Vec<_>>())),
        ])
    }

    fn block(&mut self, id: &str, block: &Block) -> Result<Value, Faults> {
        Ok(match block {
            Block::Figure(drawing) => map([("kind", "figure".into()), ("figure", self.figure(drawing))]),
            Block::Authored(text) => {
                map([("kind", "authored".into()), ("text", self.authored(&format!("{id}: text"), text)?)])
            }
            _ => self.written(block),
        })
    }

    /// A block of which nothing goes beside the document and nothing can be at fault.
    fn written(&self, block: &Block) -> Value {
        let cells = |row: &[Vec<Inline>]| Value::from(row.iter().map(|cell| self.inline(cell)).collect::<Vec<_>>());
        match block {
            Block::Paragraph(run) => map([("kind", "paragraph".into()), ("text", self.inline(run))]),
            Block::Equation { lines, number } => {
                map([("kind", "equation".into()), ("text", ready(&self.writer.displayed(lines, *number)))])
            }
            Block::List(items) => map([("kind", "list".into()), ("items", cells(items))]),
            Block::Table { head, rows } => map([
                ("kind", "table".into()),
                ("head", cells(head)),
                ("rows", Value::from(rows.iter().map(|row| cells(row)).collect::<Vec<_>>())),
            ]),
            Block::Space { lines } => map([("kind", "space".into()), ("lines", (*lines).into())]),
            Block::Figure(_) | Block::Authored(_) => Value::none(),
        }
    }

    fn inline(&self, run: &[Inline]) -> Value {
        ready(&self.writer.inline(run))
    }

    fn authored(&self, name: &str, text: &str) -> Result<Value, Faults> {
        let checked = Authored::check(name, text)?;
        Ok(ready(&self.writer.authored(&checked, self.level + 1)))
    }

    fn figure(&mut self, drawing: &Drawing) -> Value {
        let file = self.beside_prefix.map(|prefix| format!("{prefix}-{}.svg", self.beside.len() + 1));
        if let Some(name) = &file {
            self.beside.push(BesideFile { name: name.clone(), text: figure::svg_file(drawing) });
        }
        let inline = match file {
            Some(_) => String::new(),
            None if self.unstyled => figure::svg_unstyled(drawing),
            None => self.writer.figure(drawing),
        };
        map([
            ("title", drawing.title.as_str().into()),
            ("description", drawing.description.as_str().into()),
            ("caption", drawing.caption.as_str().into()),
            ("file", file.map(|name| name.replace(' ', "%20")).into()),
            ("body", ready(&inline)),
        ])
    }
}

/// The widest figure beside a text, and the least room that its caption needs.
const ASIDE: std::ops::RangeInclusive<f64> = 120.0..=215.0;

/// How wide the column beside the text is, in points, for a figure that finds room there.
fn width_aside(drawing: &Drawing) -> Option<f64> {
    let width = drawing.high.x - drawing.low.x;
    (width <= *ASIDE.end()).then(|| width.max(*ASIDE.start()).ceil())
}

fn identity(identity: &Identity) -> Value {
    let mark = identity.secret.as_ref().map_or_else(String::new, |mark| format!("-{mark}"));
    map([
        ("problem", identity.problem.as_str().into()),
        ("form", identity.form.clone().into()),
        // A seed has 64 bits; as text it reaches every template whole.
        ("seed", identity.seed.map(|seed| format!("{}{mark}", SeedWord(seed))).into()),
        ("digest", identity.digest.clone().into()),
        ("scheme", identity.scheme.into()),
    ])
}

fn heading(heading: &Heading) -> Value {
    map([
        ("course", heading.course.clone().into()),
        ("title", heading.title.as_str().into()),
        ("date", heading.date.clone().into()),
        ("points", points(Some(heading.points))),
    ])
}

/// Points as they are written: 2, not 2.0; with at most two decimals.
fn points(points: Option<f64>) -> Value {
    points.map(|points| ((points * 100.0).round() / 100.0).to_string()).into()
}

fn document_title<'a>(pages: &[PageView<'a>]) -> &'a str {
    let mut titles: Vec<&str> = pages
        .iter()
        .filter_map(|page| match page {
            PageView::Sheet(sheet) => match &sheet.place {
                Some(place) => place.heading.as_ref().map(|heading| heading.title.as_str()),
                None => Some(sheet.title.as_str()),
            },
            PageView::Solution(solution) => Some(&solution.outline.title),
            PageView::Key(key) => Some(&key.title),
        })
        .collect();
    titles.dedup();
    match titles[..] {
        [only] => only,
        _ => "Problems",
    }
}
