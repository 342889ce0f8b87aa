//! The whole path of a problem as one type: a variant is drawn and solved, printed, explained and marked.

mod asked_back;
mod attempts;
pub mod calls;
mod changed;
mod diagnosis;
mod drawer;
mod echo;
mod follow_through;
mod followed;
mod forms;
mod formula;
mod issue;
mod issued;
mod item;
mod marker;
mod marking;
mod names;
mod note;
mod offered_formulas;
mod part_label;
mod printable;
mod record;
mod roots;
mod roster;
mod rules;
mod sheet_numbers;
mod sheet_seed;
mod sheets;
mod spoilt_seed;
mod student_sheet;
mod students;
mod submission;
mod table;
mod thumbnail;
mod together;
mod tried;
mod work;

pub use drawer::Drawer;

use std::sync::Arc;

use momentous_explain as explain;
use momentous_explain::Audience;
use momentous_explain::Detail;
use momentous_explain::Inline;
use momentous_explain::Outline;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_figure::Drawing;
use momentous_problem as problem;
use momentous_problem::AskedUnit;
use momentous_problem::ChoicePart;
use momentous_problem::End;
use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::Problem;
use momentous_problem::RangePart;
use momentous_problem::USUAL_FIGURES;
use momentous_problem::Variant;
use momentous_problem::Worked;
use momentous_problem::part_letter;
use momentous_quantity::Printed;
use momentous_render::Identity;
use momentous_render::KeyRow;
use momentous_render::Sheet;
use momentous_render::SheetPart;
use momentous_solve::Bounded;

pub use attempts::Try;
pub use forms::{FormLabel, titled};
pub use issue::{Issued, Remark};
pub use issued::{Derivation, SeedSource, VariantRef};
pub use item::{FormulaItem, Item, ItemAnswers, ItemPart, NumberItem, Window};
pub use marker::Marker;
pub use momentous_work::{JudgedLine, Letter, Verdict as WorkVerdict};
pub use part_label::PartLabel;
pub use roster::{KnownBy, Student};
pub use sheet_numbers::SheetNumbers;
pub use sheet_seed::SheetSeed;
pub use sheets::{Derived, HandedOut, Listed, NotIssued, Sheets};
pub use spoilt_seed::SpoiltSeed;
pub use student_sheet::{Field, FieldKind, StudentSheet};
pub use submission::{Column, Key, Place, Submission, excerpt, is_beside};
pub use table::{Line, Lines, Row, Rows, Table, defused};
pub use together::{MOST_ATTEMPTS, Standing, Together};
pub use work::WORK;

/// Options with more bytes than this are numbered on a sheet.
const LONG_OPTION: usize = 30;

/// The text between several roots of one part, printed or typed.
const ROOTS_JOINED: &str = " or ";

/// One variant of one form of a problem, solved.
#[derive(Clone, Debug)]
pub struct Exercise {
    problem: Arc<Problem>,
    variant: Variant,
}

impl Exercise {
    /// The problem.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The numbers.
    #[must_use]
    pub fn variant(&self) -> &Variant {
        &self.variant
    }

    /// The variant with its problem, for whoever explains or draws it.
    #[must_use]
    pub fn worked(&self) -> Worked<'_> {
        let form = &self.problem.forms()[self.variant.form()];
        Worked { problem: &self.problem, form, variant: &self.variant }
    }

    /// The identity: it makes the same numbers again.
    #[must_use]
    pub fn identity(&self) -> Identity {
        Identity {
            problem: self.problem.id().to_owned(),
            form: self.worked().form.question.name.clone(),
            seed: self.variant.seed(),
            secret: self.problem.secret_mark().filter(|_| self.variant.seed().is_some()).map(str::to_owned),
            digest: Some(self.problem.loaded().digests.draw.clone()),
            scheme: Some(self.variant.scheme().number()),
        }
    }

    /// Letters by which this variant is known where its seed must not be seen; none where its numbers were not drawn.
    #[must_use]
    pub fn code(&self) -> String {
        let code = |seed| self.problem.code(self.variant.form(), seed);
        self.variant.seed().map(code).unwrap_or_default()
    }

    /// The givens of the student.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        let worked = self.worked();
        Sheet {
            room: 0,
            title: self.problem.title().to_owned(),
            identity: self.identity(),
            place: None,
            student: None,
            statement: self.variant.text(&self.problem),
            parts: worked.form.parts.iter().enumerate().map(|(index, part)| self.sheet_part(index, part)).collect(),
            note: self.note(),
            figure: explain::situation(worked).map(Box::new),
            hints: self.variant.hints(&self.problem),
        }
    }

    fn sheet_part(&self, index: usize, part: &Part) -> SheetPart {
        let (text, unit) = match &part.kind {
            PartKind::Number(number) => {
                let unit = self.unit_on_sheet(number);
                let name = self.problem.math_of(number.symbol);
                let every =
                    if number.every_root { "every value, possible or not, that the equations give for " } else { "" };
                let figures = precision(number);
                let mut text = Inline::line(&format!("Find{figures} {every}{}, ", part.label));
                text.push(Inline::Math(name));
                if unit.is_none() {
                    text.push(Inline::Text(".".into()));
                }
                (text, unit)
            }
            PartKind::Vector(vector) => {
                let unit = vector.components.first().and_then(|first| self.unit_on_sheet(first));
                let along = format!(
                    ", by its components along {}{}",
                    vector.axes_in_words(),
                    if unit.is_none() { "." } else { "" }
                );
                let name = self.problem.math_of_vector(&part.id, vector);
                let figures = vector.components.first().map(precision).unwrap_or_default();
                let mut text = Inline::line(&format!("Find{figures} {}, ", part.label));
                text.extend([Inline::Math(name), Inline::Text(along)]);
                (text, unit)
            }
            PartKind::Formula(formula) => (self.formula_on_sheet(part, formula), None),
            PartKind::Range(_) | PartKind::Choice(ChoicePart::Offered(_) | ChoicePart::Pictured(_)) => {
                (Inline::line(&part.label), None)
            }
            PartKind::Choice(ChoicePart::Order(symbols)) => {
                let name = |symbol: Symbol| self.problem.math_of(symbol);
                let mut text = Inline::line(&format!("{} (", part.label));
                for (index, order) in problem::orders(symbols).into_iter().enumerate() {
                    text.extend((index > 0).then(|| Inline::Text(" / ".into())));
                    text.push(Inline::Math(Math::chain(order.into_iter().map(name), Operator::Less)));
                }
                text.push(Inline::Text(")".into()));
                (text, None)
            }
            PartKind::Choice(choice) => {
                let mut options = choice.decided(&self.worked()).options;
                // Long phrases are answered by their numbers.
                if options.iter().any(|option| option.len() > LONG_OPTION) {
                    options = options.iter().zip(1..).map(|(option, number)| format!("{number}. {option}")).collect();
                }
                (Inline::line(&format!("{} ({})", part.label, options.join(" / "))), None)
            }
        };
        let options = match &part.kind {
            PartKind::Choice(choice @ ChoicePart::Offered(_)) => choice.decided(&self.worked()).options,
            _ => Vec::new(),
        };
        SheetPart {
            label: part_letter(index),
            text,
            options,
            pictures: self.pictures(part),
            unit,
            points: Some(f64::from(part.points)),
        }
    }

    /// The pictures to choose from.
    fn pictures(&self, part: &Part) -> Vec<Drawing> {
        match &part.kind {
            PartKind::Choice(ChoicePart::Pictured(pictured)) => explain::offered_pictures(self.worked(), pictured),
            _ => Vec::new(),
        }
    }

    /// The unit beside the room for an answer; none for a pure number.
    fn unit_on_sheet(&self, number: &NumberPart) -> Option<Math> {
        match &number.unit {
            AskedUnit::Unit(unit) if unit.is_none() => None,
            AskedUnit::Unit(unit) if unit.is_attached() => Some(Math::Text(unit.spoken(true))),
            AskedUnit::Unit(unit) => Some(Math::Text(unit.unicode())),
            AskedUnit::InTermsOf(symbol, _) => Some(self.problem.math_of(*symbol)),
        }
    }

    /// The worked solution, with the sections that its readers see.
    #[must_use]
    pub fn outline(&self, audience: Audience, detail: Detail) -> Outline {
        explain::solution(self.worked(), audience, detail)
    }

    /// One row of an answer key for each part.
    #[must_use]
    pub fn key(&self) -> Vec<KeyRow> {
        let rows = self.worked().form.parts.iter().enumerate().map(|(index, part)| KeyRow {
            identity: self.identity(),
            student: None,
            part: part_letter(index),
            answer: match &part.kind {
                PartKind::Number(number) => roots_joined(explain::printed_answers(self.worked(), number)),
                PartKind::Vector(vector) => vec![Inline::Math(explain::printed_vector(self.worked(), vector))],
                PartKind::Formula(formula) => {
                    explain::printed_formula(self.worked(), formula).into_iter().map(Inline::Math).collect()
                }
                PartKind::Range(range) => {
                    explain::printed_range(self.worked(), range).into_iter().map(Inline::Math).collect()
                }
                PartKind::Choice(_) => Inline::line(&self.printed(part)),
            },
        });
        rows.collect()
    }

    /// A range as it is printed: `0.25 < e <= 1`.
    fn printed_range(&self, range: &RangePart) -> String {
        let name = &self.problem.name_of(range.number.symbol);
        let Some(interval) = self.worked().interval(range) else { return String::new() };
        let unit = self.problem.unit_name(&range.number);
        let shown = |end: &End| {
            let value = end.value.for_print();
            let printed = Printed::new(value, range.number.figures).filter(|_| !end.is_limit);
            let printed = printed.map_or_else(|| value.to_string(), |printed| printed.plain());
            format!("{printed} {unit}").trim_end().to_owned()
        };
        let sign = |end: &End, open, closed| if end.closed { closed } else { open };
        match (&interval.low, &interval.high) {
            (Some(low), None) => format!("{name} {} {}", sign(low, ">", ">="), shown(low)),
            (low, high) => {
                let low = low.map(|low| format!("{} {} ", shown(&low), sign(&low, "<", "<="))).unwrap_or_default();
                let high = high.map(|high| format!(" {} {}", sign(&high, "<", "<="), shown(&high))).unwrap_or_default();
                format!("{low}{name}{high}")
            }
        }
    }

    /// An answer as it is printed: `3.10 m/s`.
    #[must_use]
    pub fn printed(&self, part: &Part) -> String {
        match &part.kind {
            PartKind::Choice(choice) => {
                let decision = choice.decided(&self.worked());
                decision.options.get(decision.right).cloned().unwrap_or_default()
            }
            PartKind::Formula(formula) => self.printed_formula(formula),
            PartKind::Range(range) => self.printed_range(range),
            PartKind::Vector(vector) => {
                let shown = |number: &NumberPart| {
                    let printed = Printed::new(self.worked().answer(number).for_print(), number.figures);
                    printed.map_or_else(|| "not defined".into(), |printed| printed.plain())
                };
                let components: Vec<String> = vector.components.iter().map(shown).collect();
                let unit = vector.components.first().map(|number| self.problem.unit_name(number)).unwrap_or_default();
                format!("({}) {unit}", components.join(", ")).trim_end().to_owned()
            }
            PartKind::Number(number) => {
                let unit = match &number.unit {
                    AskedUnit::Unit(unit) if unit.is_attached() => unit.to_string(),
                    AskedUnit::Unit(unit) => format!(" {unit}"),
                    AskedUnit::InTermsOf(symbol, _) => format!(" {}", self.problem.name_of(*symbol)),
                };
                let shown = |answer: Bounded| {
                    let value = answer.for_print();
                    let shown = if number.whole {
                        format!("{value:.0}")
                    } else {
                        Printed::new(value, number.figures)
                            .map_or_else(|| "not defined".into(), |printed| printed.plain())
                    };
                    format!("{shown}{unit}").trim_end().to_owned()
                };
                self.worked().answers(number).into_iter().map(shown).collect::<Vec<_>>().join(ROOTS_JOINED)
            }
        }
    }
}

/// Every root of a part, in one line.
fn roots_joined(roots: Vec<Math>) -> Vec<Inline> {
    let mut joined = Vec::new();
    for root in roots {
        if !joined.is_empty() {
            joined.push(Inline::Text(ROOTS_JOINED.into()));
        }
        joined.push(Inline::Math(root));
    }
    joined
}

/// The figures that an answer needs, where they are more than usual.
fn precision(number: &NumberPart) -> String {
    if number.figures > USUAL_FIGURES && !number.whole {
        format!(", to {} significant figures,", number.figures)
    } else {
        String::new()
    }
}
