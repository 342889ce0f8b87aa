//! The sheet of a student: no seed, no answer, no decision.

use momentous_explain::Inline;
use momentous_expr::Math;
use momentous_figure::Drawing;
use momentous_problem as problem;
use momentous_problem::ChoicePart;
use momentous_problem::FormulaPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_render::Sheet;
use momentous_render::SheetPart;

use super::Exercise;

/// A problem sheet as a student may have it. Nothing in it leads back to the numbers' seed or to an answer, so a response
/// that is made of it cannot give one away.
///
/// ```
/// use std::sync::Arc;
/// use momentous_bank::Bank;
/// use momentous_exercise::{Exercise, FieldKind};
/// use momentous_problem::{compile, load};
///
/// let problem = Arc::new(compile(load(Bank::built_in().find("impact/two-carts")?.clone())?, None)?);
/// let sheet = Exercise::draw(&problem, 0, 7)?.student_sheet();
/// assert_eq!(sheet.fields[0].id, "v_A2");
/// assert_eq!(sheet.fields[0].kind, FieldKind::Number);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StudentSheet {
    /// The problem's title.
    pub title: String,
    /// The author's Markdown with its placeholders filled in.
    pub statement: String,
    /// The figure, which shows only what is given.
    pub figure: Option<Drawing>,
    /// The questions, in order.
    pub fields: Vec<Field>,
    /// Constants and conventions to use, such as g.
    pub note: Vec<Inline>,
    /// Hints in Markdown, to be read one by one.
    pub hints: Vec<String>,
}

/// Room for one answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The name of the part in answers.
    pub id: String,
    /// Its label without brackets, `a`.
    pub label: String,
    /// The question.
    pub question: Vec<Inline>,
    /// How it is answered.
    pub kind: FieldKind,
    /// The pictures to choose from, in the order of their names.
    pub pictures: Vec<Drawing>,
    /// The unit that the answer is to be given in.
    pub unit: Option<Math>,
    /// The names that a formula may contain, as they are typed.
    pub symbols: Vec<String>,
    /// Its points.
    pub points: u32,
}

/// How a field is answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FieldKind {
    /// A number with its unit, where it has one.
    Number,
    /// A whole number.
    Count,
    /// Components along these axes.
    Vector {
        /// How many components.
        components: usize,
    },
    /// A formula in the field's symbols.
    Formula,
    /// An interval.
    Interval,
    /// One of these.
    Choice {
        /// The options, as they are typed.
        options: Vec<String>,
    },
}

impl FieldKind {
    /// Its stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::Count => "count",
            Self::Vector { .. } => "vector",
            Self::Formula => "formula",
            Self::Interval => "interval",
            Self::Choice { .. } => "choice",
        }
    }
}

impl Exercise {
    /// The sheet of this variant for a student.
    #[must_use]
    pub fn student_sheet(&self) -> StudentSheet {
        let Sheet { title, statement, parts, note, figure, hints, .. } = self.sheet();
        let fields = parts.into_iter().zip(&self.worked().form.parts).map(|(shown, part)| self.field(shown, part));
        StudentSheet { title, statement, figure: figure.map(|drawing| *drawing), fields: fields.collect(), note, hints }
    }

    fn field(&self, SheetPart { label, text, unit, pictures, .. }: SheetPart, part: &Part) -> Field {
        let (kind, question, symbols) = match &part.kind {
            PartKind::Number(number) if number.whole => (FieldKind::Count, text, Vec::new()),
            PartKind::Number(_) => (FieldKind::Number, text, Vec::new()),
            PartKind::Vector(vector) => (FieldKind::Vector { components: vector.components.len() }, text, Vec::new()),
            PartKind::Formula(formula) => (FieldKind::Formula, text, self.typed_letters(formula)),
            PartKind::Range(_) => (FieldKind::Interval, text, Vec::new()),
            PartKind::Choice(choice) => {
                let options = self.options(choice);
                (FieldKind::Choice { options }, Inline::line(&part.label), Vec::new())
            }
        };
        Field { id: part.id.clone(), label, question, kind, pictures, unit, symbols, points: part.points }
    }

    fn options(&self, choice: &ChoicePart) -> Vec<String> {
        let problem::Decision { options, .. } = choice.decided(&self.worked());
        options
    }

    fn typed_letters(&self, formula: &FormulaPart) -> Vec<String> {
        self.letters(formula).into_iter().map(|symbol| self.problem.name_of(symbol)).collect()
    }
}
