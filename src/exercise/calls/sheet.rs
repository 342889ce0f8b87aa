//! The sheet of a variant, ready for a page.

use serde::Serialize;

use momentous_explain::Inline;
use momentous_figure::Drawing;
use momentous_render::Fragment;

use super::super::{Exercise, Field, FieldKind, StudentSheet};
use super::Engine;
use super::refused::Refused;
use super::variant::VariantRequest;

/// The level of the author's own headings on a page with one title.
const HEADINGS: usize = 2;

/// Asks for a sheet.
pub type SheetRequest = VariantRequest;

/// A sheet: [`StudentSheet`] as HTML.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SheetResponse {
    /// The problem's title.
    pub title: String,
    /// The statement.
    pub statement: Fragment,
    /// The figure.
    pub figure: Option<FigureResponse>,
    /// Room for each answer.
    pub fields: Vec<FieldResponse>,
    /// Constants and conventions to use; empty where there are none.
    pub note: Fragment,
    /// The number of hints that the author wrote.
    pub hints: usize,
}

/// A figure with what stands under it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FigureResponse {
    /// The figure as SVG.
    pub svg: Fragment,
    /// Its caption.
    pub caption: String,
}

impl FigureResponse {
    pub(super) fn of(drawing: &Drawing) -> Self {
        Self { svg: Fragment::figure(drawing), caption: drawing.caption.clone() }
    }

    /// Those among which somebody chooses.
    fn of_choice(drawings: &[Drawing]) -> Vec<Self> {
        let shown = Fragment::figures(drawings).into_iter().zip(drawings);
        shown.map(|(svg, drawing)| Self { svg, caption: drawing.caption.clone() }).collect()
    }
}

/// Room for an answer: [`Field`] as HTML.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FieldResponse {
    /// The name of the part in answers.
    pub id: String,
    /// Its label without brackets.
    pub label: String,
    /// The question.
    pub question: Fragment,
    /// How it is answered: `number`, `count`, `vector`, `formula`, `interval`, `choice`.
    pub kind: &'static str,
    /// The unit that the answer is to be given in.
    pub unit: Option<Fragment>,
    /// The options, as they are typed.
    pub options: Vec<String>,
    /// The same as it is shown, where that holds mathematics.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub shown: Vec<Fragment>,
    /// The pictures to choose from, in the order of `options`; empty where these say what can be chosen.
    pub pictures: Vec<FigureResponse>,
    /// The names that a formula may contain.
    pub symbols: Vec<String>,
    /// The number of components that a vector has.
    pub components: usize,
    /// Its points.
    pub points: u32,
}

impl From<Field> for FieldResponse {
    fn from(field: Field) -> Self {
        let kind = field.kind.name();
        let (options, components) = match field.kind {
            FieldKind::Choice { options } => (options, 0),
            FieldKind::Vector { components } => (Vec::new(), components),
            FieldKind::Number | FieldKind::Count | FieldKind::Formula | FieldKind::Interval => (Vec::new(), 0),
        };
        let lines: Vec<Vec<Inline>> = options.iter().map(|option| Inline::line(option)).collect();
        let has_mathematics = lines.iter().flatten().any(|part| matches!(part, Inline::Tex(_)));
        let shown = lines.iter().filter(|_| has_mathematics).map(|line| Fragment::inline(line)).collect();
        Self {
            id: field.id,
            label: field.label,
            shown,
            question: Fragment::inline(&field.question),
            kind,
            unit: field.unit.as_ref().map(Fragment::math),
            options,
            pictures: FigureResponse::of_choice(&field.pictures),
            symbols: field.symbols,
            components,
            points: field.points,
        }
    }
}

impl Engine<'_> {
    /// The sheet of a variant.
    ///
    /// # Errors
    /// Where there is no such problem or form, or the seed draws nothing.
    pub fn sheet(&self, request: &SheetRequest) -> Result<SheetResponse, Refused> {
        SheetResponse::of(&self.draw(request)?)
    }
}

impl SheetResponse {
    /// The sheet of a variant that was drawn.
    ///
    /// # Errors
    /// Where the author's text is not fit to print.
    pub fn of(exercise: &Exercise) -> Result<Self, Refused> {
        let StudentSheet { title, statement, figure, fields, note, hints } = exercise.student_sheet();
        let name = format!("{}: text", exercise.problem().id());
        Ok(Self {
            statement: Fragment::authored(&name, &statement, HEADINGS).map_err(|faults| Refused::fault(&faults))?,
            title,
            figure: figure.as_ref().map(FigureResponse::of),
            fields: fields.into_iter().map(FieldResponse::from).collect(),
            note: Fragment::inline(&note),
            hints: hints.len(),
        })
    }
}
