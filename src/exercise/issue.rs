//! A variant as a person got it: enough to draw it again, and to tell whether a corrected problem still draws the same.

use std::sync::Arc;

use serde::Deserialize;
use serde::Serialize;

use momentous_grade::DecimalMark;
use momentous_problem::CourseSymbols;
use momentous_problem::NoVariant;
use momentous_problem::Problem;
use momentous_problem::Scheme;

use super::Drawer;
use super::Exercise;
use super::issued::Derivation;
use super::sheet_numbers::SheetNumbers;
use super::student_sheet::StudentSheet;

/// A variant as a person got it. It is written once, when the sheet is first seen, and never made anew.
///
/// ```
/// use std::sync::Arc;
/// use momentous_bank::Bank;
/// use momentous_exercise::{Exercise, Remark};
/// use momentous_fault::Source;
/// use momentous_grade::DecimalMark;
/// use momentous_problem::{compile, load};
///
/// let source = Bank::built_in().find("impact/two-carts")?.clone();
/// let problem = Arc::new(compile(load(source.clone())?, None)?);
/// let issued = Exercise::draw(&problem, 0, 7)?.issue(None, DecimalMark::Point);
/// let corrected = Source::new("two-carts.yaml", &source.text.replace("level track", "long level track"));
/// let corrected = Arc::new(compile(load(corrected)?, None)?);
/// assert_eq!(issued.remark(&corrected), Remark::Same);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct Issued {
    /// The problem's identity.
    pub problem: String,
    /// The digest of its file.
    pub digest: String,
    /// The scheme by which numbers are drawn.
    pub scheme: u32,
    /// The form's name, where it has one.
    pub form: Option<String>,
    /// The seed.
    pub seed: u64,
    /// The mark of the secret with which it was drawn.
    pub secret: Option<String>,
    /// The version by which the seed was derived from the person; nothing where it was chosen by hand.
    pub derivation: Option<usize>,
    /// The sign between whole and decimal digits in the person's answers.
    pub decimal: DecimalMark,
    /// The letters in which it was printed, and in which formulas are typed.
    pub letters: CourseSymbols,
    /// The text of the sheet as it was shown.
    pub statement: String,
    given: SheetNumbers,
    parts: Vec<IssuedPart>,
}

/// The questions.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
struct IssuedPart {
    id: String,
    kind: String,
    unit: Option<String>,
}

/// The treatment of a sheet when its problem was corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remark {
    /// The corrected problem can have the same givens and asks the same parts in the same units: old answers can be marked by it.
    Same,
    /// It does not: the sheet that was handed out is no longer its sheet.
    Differs,
}

impl Exercise {
    /// This variant as it is handed out.
    #[must_use]
    pub fn issue(&self, derivation: Option<Derivation>, decimal: DecimalMark) -> Issued {
        let identity = self.identity();
        let StudentSheet { statement, fields, .. } = self.student_sheet();
        Issued {
            problem: identity.problem,
            digest: self.problem.loaded().digest.clone(),
            scheme: identity.scheme.unwrap_or_default(),
            form: identity.form,
            seed: identity.seed.unwrap_or_default(),
            secret: identity.secret,
            derivation: derivation.map(Derivation::number),
            decimal,
            letters: self.problem.loaded().draft.symbols.clone(),
            statement,
            given: self.sheet_numbers(),
            parts: fields
                .into_iter()
                .map(|field| IssuedPart {
                    id: field.id,
                    kind: field.kind.name().to_owned(),
                    unit: field.unit.map(|unit| unit.latex()),
                })
                .collect(),
        }
    }
}

impl Issued {
    /// The same variant of a problem, which may have been corrected, with the numbers that were handed out.
    ///
    /// # Errors
    /// Where the problem has no such form any more, or tells other quantities, or this program does not know the scheme.
    pub fn draw(&self, problem: &Arc<Problem>) -> Result<Exercise, NoVariant> {
        let form = problem.form(self.form.as_deref()).ok_or(NoVariant::NoForm)?;
        let scheme = Scheme::numbered(self.scheme).ok_or(NoVariant::NoScheme(self.scheme))?;
        Drawer::new(problem, form)?.issued(self.seed, scheme, &self.given)
    }

    /// Whether answers to this sheet can be marked by a problem that may have been corrected.
    #[must_use]
    pub fn remark(&self, problem: &Arc<Problem>) -> Remark {
        let same = self.draw(problem).is_ok_and(|exercise| {
            let now = exercise.issue(None, self.decimal);
            let asks_the_same = now.letters == self.letters && now.parts == self.parts;
            now.secret == self.secret && asks_the_same
        });
        if same { Remark::Same } else { Remark::Differs }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use momentous_fault::Source;
    use momentous_problem::{compile, load};

    const FILE: &str = include_str!("../../problem_bank/impact/two-carts.yaml");

    fn problem(text: &str) -> Arc<Problem> {
        Arc::new(compile(load(Source::new("two-carts.yaml", text)).unwrap(), None).unwrap())
    }

    #[test]
    fn a_corrected_problem_marks_old_sheets_only_where_it_draws_and_asks_the_same() {
        let issued = Exercise::draw(&problem(FILE), 0, 7).unwrap().issue(None, DecimalMark::Point);
        let kept: Issued = serde_json::from_str(&serde_json::to_string(&issued).unwrap()).unwrap();
        assert_eq!(kept, issued);
        let cases = [
            ("They collide.", "Then they collide.", Remark::Same),
            ("v_A2, unit: m/s, points: 2", "v_A2, unit: m/s, points: 3", Remark::Same),
            ("v_A2, unit: m/s, points: 2", "v_A2, unit: km/h, points: 2", Remark::Differs),
            ("{ find: T_lost, unit: J, points: 1 }", "{ find: p_A2, unit: N s, points: 1 }", Remark::Differs),
            ("min: 1, max: 6, step: 0.5, unit: kg", "min: 11, max: 16, step: 0.5, unit: kg", Remark::Same),
            ("m_A: { min: 1, max: 6, step: 0.5, unit: kg }", "m_A: 7 kg", Remark::Differs),
            ("forward:", "onward:", Remark::Differs),
            ("scene:", "symbols: { momentum: L }\nscene:", Remark::Differs),
        ];
        for (old, new, expected) in cases {
            assert!(FILE.contains(old), "{old}");
            let corrected = problem(&FILE.replacen(old, new, 1));
            assert_eq!(kept.remark(&corrected), expected, "{new}");
        }
    }
}
