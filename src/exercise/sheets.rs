//! The sheets of a class: whether a student was given the one that was answered.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::fmt;
use std::io::BufRead;
use std::sync::Arc;

use rustc_hash::FxHashMap;

use momentous_problem::Scheme;

use super::issued::{Derivation, SeedSource, VariantRef};
use super::sheet_numbers::SheetNumbers;
use super::sheet_seed::SheetSeed;
use super::spoilt_seed::SpoiltSeed;
use super::submission::excerpt;
use super::table::Table;
use super::together::hash;

/// Sheets and the students to whom they were given.
#[derive(Clone, Debug)]
pub enum Sheets {
    /// Sheets as the table of seeds lists them.
    Listed(Listed),
    /// Sheets as they follow from the students, the secret and the version of the derivation.
    Derived(Derived),
}

/// The content of a table of seeds.
#[derive(Clone, Debug, Default)]
pub struct Listed {
    /// Student, problem, form and seed of each sheet, as a hash: classes are large.
    sheets: FxHashMap<u64, HandedOut>,
    /// The same without the seed.
    asked: FxHashMap<u64, u64>,
    digests: BTreeMap<String, String>,
    /// The marks of the secrets with which they were drawn, empty for none; nothing where the table does not say it.
    secrets: BTreeSet<String>,
}

/// How a sheet was handed out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct HandedOut {
    /// How its numbers were drawn.
    pub scheme: Scheme,
    /// The numbers that stand on it, where that is known.
    pub given: Option<Arc<SheetNumbers>>,
}

/// The sources from which sheets are derived.
#[derive(Clone, Debug)]
pub struct Derived {
    /// The students of the roster.
    pub students: BTreeSet<String>,
    /// The version of the derivation.
    pub derivation: Derivation,
    /// The secret of the course.
    pub secret: Option<Vec<u8>>,
    /// How the numbers were drawn.
    pub scheme: Scheme,
}

/// Why a sheet is not the student's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotIssued {
    /// Nobody says whose answers they are.
    Nobody,
    /// The roster has no such student.
    Stranger,
    /// The student was given no sheet of this problem and form.
    NotAsked,
    /// The student was given other numbers.
    OtherSeed,
    /// The seed is the student's by another version of the derivation.
    OtherDerivation(Derivation),
}

impl Sheets {
    /// How a variant was handed out to a student; where its form `is_first`, a table may leave the form out.
    ///
    /// # Errors
    /// Why the student was not given it.
    pub fn handed_out(&self, student: &str, variant: VariantRef<'_>, is_first: bool) -> Result<HandedOut, NotIssued> {
        if student.is_empty() {
            return Err(NotIssued::Nobody);
        }
        match self {
            Self::Listed(listed) => {
                let unnamed = VariantRef { form: "", ..variant };
                let named = listed.handed_out(student, variant);
                if is_first && named.is_err() && listed.handed_out(student, unnamed) != Err(NotIssued::NotAsked) {
                    return listed.handed_out(student, unnamed);
                }
                named
            }
            Self::Derived(derived) => {
                let handed_out = HandedOut { scheme: derived.scheme, given: None };
                derived.check(student, variant).map(|()| handed_out)
            }
        }
    }

    /// The seed of a student's sheet, where there is one.
    #[must_use]
    pub fn seed(&self, student: &str, problem: &str, form: &str) -> Option<u64> {
        match self {
            Self::Listed(listed) => listed.asked.get(&hash((student, problem, form))).copied(),
            Self::Derived(derived) => {
                let seeds = SeedSource { derivation: derived.derivation, secret: derived.secret.as_deref() };
                derived.students.contains(student).then(|| seeds.seed(student, problem, form))
            }
        }
    }

    /// The digest of the problem's file when the sheets were made, where the table says it.
    #[must_use]
    pub fn digest(&self, problem: &str) -> Option<&str> {
        match self {
            Self::Listed(listed) => listed.digests.get(problem).map(String::as_str),
            Self::Derived(_) => None,
        }
    }
}

impl Listed {
    /// Reads a table of seeds, with the columns `student`, `problem`, `form`, `seed`, `scheme`, `given` and `digest`. Tables without
    /// a column `scheme` are older than its second version.
    ///
    /// # Errors
    /// What is wrong with the table, or with each of its rows.
    pub fn read(mut table: Table<impl BufRead>) -> Result<Self, Vec<String>> {
        let alone = |message: String| vec![message];
        let needed = |heading: &str| {
            let column = table.column(heading)?;
            column.ok_or_else(|| {
                format!(
                    "there is no column `{heading}`\nhelp: give the seeds.csv that `momentous generate --roster` wrote"
                )
            })
        };
        let (student, problem, seed) = (needed("student"), needed("problem"), needed("seed"));
        let (student, problem, seed) = (student.map_err(alone)?, problem.map_err(alone)?, seed.map_err(alone)?);
        let [form, digest, secret] = ["form", "digest", "secret"].map(|heading| table.column(heading));
        let (form, digest, secret) = (form.map_err(alone)?, digest.map_err(alone)?, secret.map_err(alone)?);
        let (scheme, given) = (table.column("scheme").map_err(alone)?, table.column("given").map_err(alone)?);
        let mut listed = Self::default();
        let mut faults = Vec::new();
        while let Some((line, row)) = table.next_row() {
            let read = row.and_then(|row| {
                let cell = |column: Option<usize>| column.map_or("", |column| row.cell(column));
                let seed = listed_seed(row.cell(seed))?;
                let variant = VariantRef { problem: row.cell(problem), form: cell(form), seed };
                let scheme = match cell(scheme) {
                    "" => Scheme::Solvable,
                    number => number.parse().map_err(|fault| format!("`{}` is no scheme: {fault}", excerpt(number)))?,
                };
                let given = match cell(given) {
                    "" => None,
                    text => Some(Arc::new(text.parse()?)),
                };
                listed.add(row.cell(student), variant, HandedOut { scheme, given });
                if secret.is_some() && !listed.secrets.contains(cell(secret)) {
                    listed.secrets.insert(cell(secret).to_owned());
                }
                if !listed.digests.contains_key(variant.problem) && !cell(digest).is_empty() {
                    listed.digests.insert(variant.problem.to_owned(), cell(digest).to_owned());
                }
                Ok(())
            });
            faults.extend(read.err().map(|message| format!("line {line}: {message}")));
        }
        if listed.sheets.is_empty() && faults.is_empty() {
            faults.push("it contains no sheet".to_owned());
        }
        if faults.is_empty() { Ok(listed) } else { Err(faults) }
    }

    /// Whether the sheets were drawn with the secret of that mark, or without one where there is none.
    ///
    /// # Errors
    /// Which secret it was; nothing can be marked with another.
    pub fn check_secret(&self, mark: Option<&str>) -> Result<(), String> {
        let Some(other) = self.secrets.iter().find(|secret| secret.as_str() != mark.unwrap_or_default()) else {
            return Ok(());
        };
        Err(match (other.as_str(), mark) {
            ("", _) => "its sheets were drawn without a secret\nhelp: leave --secret out".to_owned(),
            (mark_of_sheets, None) => {
                format!(
                    "its sheets were drawn with a secret, whose mark is `{mark_of_sheets}`\nhelp: give it with --secret"
                )
            }
            (mark_of_sheets, Some(mark)) => {
                format!(
                    "its sheets were drawn with the secret whose mark is `{mark_of_sheets}`; that of the secret given is `{mark}`"
                )
            }
        })
    }

    /// Adds the sheet of a student.
    pub fn add(&mut self, student: &str, variant: VariantRef<'_>, handed_out: HandedOut) {
        self.sheets.insert(hash((student, variant)), handed_out);
        self.asked.insert(hash((student, variant.problem, variant.form)), variant.seed);
    }

    fn handed_out(&self, student: &str, variant: VariantRef<'_>) -> Result<HandedOut, NotIssued> {
        if let Some(handed_out) = self.sheets.get(&hash((student, variant))) {
            Ok(handed_out.clone())
        } else if self.asked.contains_key(&hash((student, variant.problem, variant.form))) {
            Err(NotIssued::OtherSeed)
        } else {
            Err(NotIssued::NotAsked)
        }
    }
}

/// The seed in a cell of a table of seeds, with or without the mark of a secret.
fn listed_seed(cell: &str) -> Result<u64, String> {
    if SpoiltSeed::read(cell).is_some() {
        return Err(format!(
            "`{}` is what a spreadsheet leaves of a seed\n\
             help: make the table again with the roster: `momentous generate` writes it beside the sheets",
            excerpt(cell)
        ));
    }
    cell.parse::<SheetSeed>().map(|seed| seed.number).map_err(|_| format!("`{}` is not a seed", excerpt(cell)))
}

impl Derived {
    fn check(&self, student: &str, variant: VariantRef<'_>) -> Result<(), NotIssued> {
        if !self.students.contains(student) {
            return Err(NotIssued::Stranger);
        }
        let is_of = |derivation: &Derivation| {
            let seeds = SeedSource { derivation: *derivation, secret: self.secret.as_deref() };
            seeds.variant(student, variant.problem, variant.form) == variant
        };
        if is_of(&self.derivation) {
            return Ok(());
        }
        let other = Derivation::ALL.into_iter().find(is_of);
        Err(other.map_or(NotIssued::OtherSeed, NotIssued::OtherDerivation))
    }
}

/// A clause that follows a student and a problem.
impl fmt::Display for NotIssued {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nobody => out.write_str("the row names no student"),
            Self::Stranger => out.write_str("the roster has no such student"),
            Self::NotAsked => out.write_str("the student was given no sheet of this problem and form"),
            Self::OtherSeed => out.write_str("the student was given another seed"),
            Self::OtherDerivation(version) => {
                write!(
                    out,
                    "the seed is the student's in version {version} of the derivation\nhelp: give --derivation {version}"
                )
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn variant(form: &str, seed: u64) -> VariantRef<'_> {
        VariantRef { problem: "a/b", form, seed }
    }

    fn by(scheme: Scheme) -> HandedOut {
        HandedOut { scheme, given: None }
    }

    fn listed(text: &str) -> Result<Sheets, Vec<String>> {
        Listed::read(Table::read(text.as_bytes()).unwrap()).map(Sheets::Listed)
    }

    #[test]
    fn a_table_says_whose_sheet_it_is() {
        let sheets = listed("student,problem,form,seed,digest\ns1,a/b,f,07,abc\ns2,a/b,,8,\n").unwrap();
        assert_eq!(sheets.handed_out("s1", variant("f", 7), true), Ok(by(Scheme::Solvable)));
        assert_eq!(sheets.handed_out("s1", variant("f", 8), true), Err(NotIssued::OtherSeed));
        assert_eq!(sheets.handed_out("s1", variant("g", 7), false), Err(NotIssued::NotAsked));
        assert_eq!(
            sheets.handed_out("s2", variant("f", 8), true),
            Ok(by(Scheme::Solvable)),
            "a first form may be left out"
        );
        assert_eq!(sheets.handed_out("s2", variant("f", 7), true), Err(NotIssued::OtherSeed));
        assert_eq!(sheets.handed_out("s2", variant("f", 8), false), Err(NotIssued::NotAsked));
        assert_eq!(sheets.handed_out("", variant("f", 7), true), Err(NotIssued::Nobody));
        assert_eq!((sheets.digest("a/b"), sheets.digest("c/d")), (Some("abc"), None));
    }

    #[test]
    fn a_table_with_a_fault_is_no_table() {
        assert!(listed("student,problem\n").unwrap_err()[0].starts_with("there is no column `seed`"));
        assert_eq!(listed("student,problem,seed\n").unwrap_err(), ["it contains no sheet"]);
        let faults = listed("student,problem,seed\ns1,a/b,x\ns1,a/b\ns1,a/b,1\n").unwrap_err();
        assert_eq!(faults, ["line 2: `x` is not a seed", "line 3: the row has 2 cells, and the headings are 3"]);
    }

    #[test]
    fn sheets_follow_from_the_roster_and_the_secret() {
        let students = BTreeSet::from(["s1".to_owned()]);
        let secret = Some(b"course".to_vec());
        let seed = |derivation| SeedSource { derivation, secret: secret.as_deref() }.seed("s1", "a/b", "f");
        let [old, new] = Derivation::ALL.map(seed);
        let (derivation, scheme) = (Derivation::Question, Scheme::Markable);
        let sheets = Sheets::Derived(Derived { students, derivation, secret: secret.clone(), scheme });
        assert_eq!(sheets.handed_out("s1", variant("f", new), true), Ok(by(Scheme::Markable)));
        assert_eq!(sheets.handed_out("s1", variant("g", new), true), Err(NotIssued::OtherSeed));
        assert_eq!(
            sheets.handed_out("s1", variant("f", old), true),
            Err(NotIssued::OtherDerivation(Derivation::Student))
        );
        assert_eq!(sheets.handed_out("s2", variant("f", new), true), Err(NotIssued::Stranger));
    }
}
