//! An item as a question of fields, and the texts around them.

use momentous_exercise::Item;
use momentous_exercise::ItemAnswers;
use momentous_exercise::ItemPart;
use momentous_explain::Inline;
use momentous_fault::Faults;
use momentous_figure as figure;
use momentous_figure::Drawing;
use momentous_render::Markup;

use super::band::bands;
use super::feature::Feature;
use super::field::{Asked, Field, fields};

/// The heading of the level at which the headings of authors and solutions begin.
const LEVEL: usize = 4;

/// An item as a question of fields.
#[derive(Debug)]
pub struct Question<'i> {
    pub(super) item: &'i Item,
    /// The parts that have fields.
    pub(super) asked: Vec<Asking<'i>>,
}

/// A part with its fields.
#[derive(Debug)]
pub(super) struct Asking<'i> {
    pub part: &'i ItemPart,
    pub fields: Vec<Field<'i>>,
    /// The weight of each of its fields.
    pub weight: u32,
}

impl<'i> Question<'i> {
    /// The fields of an item. A part of several fields shares its points equally among them; where that leaves fractions, the
    /// points of all parts are multiplied by the same number.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_bank::Bank;
    /// use momentous_exercise::Exercise;
    /// use momentous_export::{Feature, Question};
    /// use momentous_problem::{compile, load};
    ///
    /// let source = Bank::built_in().find("impact/two-carts")?.clone();
    /// let problem = Arc::new(compile(load(source)?, None)?);
    /// let item = Exercise::draw(&problem, 0, 7)?.item();
    /// assert!(Question::new(&item).features().contains(&Feature::FollowThrough));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn new(item: &'i Item) -> Self {
        let asked = item.parts.iter().map(|part| (part, fields(part))).filter(|(_, fields)| !fields.is_empty());
        let asked: Vec<_> = asked.collect();
        let count = |fields: &[Field<'_>]| u32::try_from(fields.len()).unwrap_or(1);
        let shares = asked.iter().map(|(_, fields)| count(fields)).fold(1, least_common_multiple);
        let asking = |(part, fields): (&'i ItemPart, Vec<Field<'i>>)| {
            let weight = part.field.points * (shares / count(&fields));
            Asking { part, fields, weight }
        };
        Self { item, asked: asked.into_iter().map(asking).collect() }
    }

    /// Whether nothing of it can be asked.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.asked.is_empty()
    }

    /// The features for which not every target has a place.
    #[must_use]
    pub fn features(&self) -> Vec<Feature> {
        let item = self.item;
        let mut held = vec![Feature::Writing, Feature::Documents];
        for part in &item.parts {
            held.extend(match &part.answers {
                ItemAnswers::Number(_) => None,
                ItemAnswers::Roots(_) => Some(Feature::Roots),
                ItemAnswers::Vector { .. } => Some(Feature::Vectors),
                ItemAnswers::Interval { .. } => Some(Feature::Intervals),
                ItemAnswers::Choice { .. } if part.field.pictures.is_empty() => Some(Feature::Choices),
                ItemAnswers::Choice { .. } => Some(Feature::Pictures),
                ItemAnswers::Formula { mistaken, .. } if mistaken.is_empty() => Some(Feature::LoneFormulas),
                ItemAnswers::Formula { .. } => Some(Feature::Formulas),
            });
        }
        let several = self.fields().count() > 1;
        for (asking, field) in self.fields() {
            let Asked::Number(number) = &field.asked else { continue };
            held.push(Feature::Numbers);
            let with_unit = if several { Feature::UnitsOfSeveral } else { Feature::Units };
            held.extend(asking.part.field.unit.is_some().then_some(with_unit));
            let bands = bands(number, asking.part.field.points);
            held.extend(bands.iter().any(|band| !band.feedback.is_empty()).then_some(Feature::Mistakes));
            held.extend(bands.iter().any(|band| band.share > 0.0 && !band.is_full()).then_some(Feature::Credit));
            held.extend((several && bands.iter().any(|band| band.is_coarse)).then_some(Feature::PowersOfTen));
        }
        held.extend((self.asked.len() > 1).then_some(Feature::FollowThrough));
        held.extend((!item.sheet.hints.is_empty()).then_some(Feature::Hints));
        held.sort_unstable();
        held.dedup();
        held
    }

    /// Every field with its part.
    pub(super) fn fields(&self) -> impl Iterator<Item = (&Asking<'i>, &Field<'i>)> {
        self.asked.iter().flat_map(|asking| asking.fields.iter().map(move |field| (asking, field)))
    }

    /// The weight of all fields together.
    pub(super) fn weight(&self) -> u32 {
        self.fields().map(|(asking, _)| asking.weight).sum()
    }

    /// The stem of names of files for variants of the same form: `impact-two-carts-forward`.
    #[must_use]
    pub fn name(&self) -> String {
        let identity = &self.item.identity;
        let name = [Some(&identity.problem), identity.form.as_ref()];
        let name = name.into_iter().flatten().map(String::as_str).collect::<Vec<_>>().join("-");
        let plain = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '-' };
        name.chars().map(plain).collect()
    }

    /// The name of the variant: by its title, its form and its code.
    pub(super) fn title(&self) -> String {
        let code = Some(&self.item.code).filter(|code| !code.is_empty());
        let words = [Some(&self.item.sheet.title), self.item.identity.form.as_ref(), code];
        words.into_iter().flatten().map(String::as_str).collect::<Vec<_>>().join(", ")
    }

    /// How all variants of the form are called.
    pub(super) fn form_title(&self) -> String {
        let words = [Some(&self.item.sheet.title), self.item.identity.form.as_ref()];
        words.into_iter().flatten().map(String::as_str).collect::<Vec<_>>().join(", ")
    }

    /// How numbers are written here; nothing where none is asked.
    pub(super) fn writing(&self, markup: Markup, unit: TypedUnit) -> String {
        let numbers = || self.fields().filter(|(_, field)| matches!(field.asked, Asked::Number(_)));
        if numbers().next().is_none() {
            return String::new();
        }
        let has_unit = numbers().any(|(asking, _)| asking.part.field.unit.is_some());
        let unit = match unit {
            TypedUnit::Behind if has_unit => ", and its unit behind it",
            TypedUnit::Never if has_unit => ", and no unit, which stands beside the field",
            TypedUnit::Behind | TypedUnit::Never => "",
        };
        let said =
            format!("Type a number with a point for the decimals (2.50), a hyphen for a minus sign (-2.50){unit}.");
        markup.paragraph(&markup.text(&said))
    }

    /// The statement with its figure, and what to take for constants.
    pub(super) fn statement(&self, markup: Markup, pictures: &mut Pictures) -> Result<String, Faults> {
        let (item, sheet) = (self.item, &self.item.sheet);
        let mut text = markup.authored(&self.item.identity.problem, &sheet.statement, LEVEL)?;
        text.push_str("\n\n");
        if let Some(drawing) = &sheet.figure {
            text.push_str(&pictures.show(markup, drawing));
        }
        let several = item.parts.len() > 1;
        for field in item.parts.iter().map(|part| &part.field) {
            for drawing in &field.pictures {
                let label = if several { format!("({}) ", field.label) } else { String::new() };
                text.push_str(&markup.paragraph(&markup.text(&format!("{label}{}:", drawing.title))));
                text.push_str(&pictures.show(markup, drawing));
            }
        }
        if !sheet.note.is_empty() {
            text.push_str(&markup.paragraph(&markup.inline(&sheet.note)));
        }
        Ok(text)
    }

    /// The code of the variant, and of a field, as it is printed: by it a response is found again.
    pub(super) fn code(&self, markup: Markup, field: Option<&Field<'_>>) -> String {
        let field = field.map(|field| format!("-{}", field.name)).unwrap_or_default();
        markup.paragraph(&markup.text(&format!("[{}{field}]", self.item.code)))
    }

    /// The worked solution.
    pub(super) fn solution(&self, markup: Markup, pictures: &mut Pictures) -> Result<String, Faults> {
        markup.outline(&self.item.solution, LEVEL, |drawing| pictures.show(markup, drawing))
    }

    /// The hints.
    pub(super) fn hints(&self, markup: Markup) -> Result<Vec<String>, Faults> {
        let hints = self.item.sheet.hints.iter();
        hints.map(|hint| markup.authored(&self.item.identity.problem, hint, LEVEL)).collect()
    }
}

/// Whether a unit is typed behind a number.
#[derive(Clone, Copy, Debug)]
pub(super) enum TypedUnit {
    /// It is.
    Behind,
    /// It is printed beside the field.
    Never,
}

impl Asking<'_> {
    /// The text of the question, with its label where the question has other parts, and with what a sign means.
    pub(super) fn question(&self, markup: Markup, labelled: bool) -> String {
        let label = if labelled { format!("({}) ", self.part.field.label) } else { String::new() };
        markup.text(&label) + &markup.inline(&self.part.field.question) + &markup.text(&self.signs())
    }

    /// The meaning of a positive and a negative value, of what has a direction.
    fn signs(&self) -> String {
        let number = |field: &Field<'_>| match &field.asked {
            Asked::Number(number) => number.senses.clone(),
            Asked::Choice(_) => None,
        };
        let said = |field: &Field<'_>| {
            let [plus, minus] = number(field)?;
            let subject =
                if self.fields.len() > 1 && !self.is_of_roots() { field.caption.trim_end_matches(':') } else { "" };
            Some(format!("{subject} positive {plus}, negative {minus}").trim_start().to_owned())
        };
        let mut all: Vec<String> = self.fields.iter().filter_map(said).collect();
        all.dedup();
        if all.is_empty() { String::new() } else { format!(" ({})", all.join("; ")) }
    }

    fn is_of_roots(&self) -> bool {
        matches!(self.part.answers, ItemAnswers::Roots(_))
    }

    /// The unit behind each of its fields.
    pub(super) fn unit(&self, markup: Markup) -> String {
        self.part.field.unit.as_ref().map(|unit| markup.math(unit)).unwrap_or_default()
    }
}

/// Texts one after the other.
pub(super) fn said(markup: Markup, texts: &[String]) -> String {
    let said = texts.iter().filter(|text| !text.is_empty());
    said.map(|text| markup.paragraph(&markup.inline(&[Inline::Text(text.clone())]))).collect()
}

/// The pictures of a text, each in a file of its own.
pub(super) struct Pictures {
    prefix: String,
    place: fn(Markup, &Picture<'_>) -> String,
    /// Their names and contents.
    pub files: Vec<(String, String)>,
    /// The same for LaTeX.
    pub tikz: Vec<String>,
}

/// A picture that is to be shown.
pub(super) struct Picture<'p> {
    pub drawing: &'p Drawing,
    pub name: &'p str,
    pub svg: &'p str,
}

impl Pictures {
    /// Pictures whose names begin so. `place` writes what shows one of them.
    pub fn new(prefix: impl Into<String>, place: fn(Markup, &Picture<'_>) -> String) -> Self {
        Self { prefix: prefix.into(), place, files: Vec::new(), tikz: Vec::new() }
    }

    /// Pictures that are addressed by their names.
    pub fn named(prefix: impl Into<String>) -> Self {
        Self::new(prefix, |markup, picture| markup.picture(picture.name, picture.drawing))
    }

    fn show(&mut self, markup: Markup, drawing: &Drawing) -> String {
        let name = format!("{}-{}.svg", self.prefix, self.files.len() + 1);
        let svg = figure::svg_file(drawing);
        let shown = (self.place)(markup, &Picture { drawing, name: &name, svg: &svg });
        self.files.push((name, svg));
        self.tikz.push(figure::tikz(drawing));
        shown
    }
}

/// The least number that both divide; the left one where there is none so small.
fn least_common_multiple(left: u32, right: u32) -> u32 {
    (1..=right).filter_map(|times| left.checked_mul(times)).find(|multiple| multiple % right == 0).unwrap_or(left)
}
