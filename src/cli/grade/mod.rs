//! `momentous grade`

mod changes;
mod gradebook;
mod homework;
mod junit;
mod legibility;
mod marked;
mod order;
mod portion_marker;
mod problems;
mod reader;
mod readers;
mod register;
mod responses;
mod single;
mod sink;
mod source;
mod spool;
mod summary;
mod table;
mod worth;

use std::path::PathBuf;

use clap::Args;
use clap::ValueEnum;

use crate::exercise::Derivation;
use crate::exercise::SheetSeed;
use crate::grade::DecimalMark;
use crate::grade::Sitting;
use crate::problem::Scheme;

use super::exit::Exit;
use super::failure::Failure;
use super::format::Listing;
use super::open::Secret;
use super::solve::assignment;

use sink::MarksFormat;

const HELP: &str = "\
Examples:
  momentous grade --problem impact/two-carts --seed 1 --answer \"v_A2=-0.500 m/s\" --answer \"v_B2=4.00 m/s\"
  momentous grade --problem impact/two-carts --seed 7 --work lines.txt --hints 1
  momentous grade --problem impact/two-carts --seed 1 --decimal comma --answer \"v_A2=-0,500 m/s\" --format json
  momentous grade submissions.csv -o marks.csv
  momentous grade submissions.csv --sheets seeds.csv --secret secret.txt -o marks.csv
  momentous grade submissions.csv --problem my-carts.yaml --roster class.csv --secret secret.txt -o marks.csv
  momentous grade submissions.jsonl -o marks.jsonl --summary class --junit junit.xml
  momentous grade submissions.csv -o marks-2.csv --changes marks.csv --changes-table changed.csv
  momentous grade homework/week-3.yaml answers.csv --sheets seeds.csv -o marks.csv
  momentous grade responses.csv --codes codes.jsonl -o marks.csv --gradebook grades.csv

A table of submissions has the columns `problem` and `seed`, and may have `student`, `digest`, `form`, `scheme`, `given` and
`attempt`; every other column is a part, named as in the JSON of `momentous generate`:

  student,problem,seed,form,attempt,v_A2,v_B2,T_lost
  s17,impact/two-carts,7,forward,1,-0.4 m/s,3.1 m/s,7.65 J

A column `work` holds the lines of a student's work, one below the other: they give points for the method where an answer is missing or wrong.

The same keys may be used in JSON Lines, `{\"problem\": \"impact/two-carts\", \"seed\": 7, \"answers\": {\"v_A2\": \"-0.4 m/s\"}}`, or in a folder of YAML files, one per submission.

The answers to a homework stand in a table with the column `student`, and a column for each part: `2.v_A2`, or `2a` as on the sheet. Without --sheets or --roster the seeds.csv beside the table says whose sheet is whose.

The cell `problem` is an identity: of the bank, or of a file that --problem names. --sheets or --roster says who was given which seed; a row with another seed gets the verdict `not_issued` and no points. With --sheets, each sheet is marked by the numbers that stand on it, whatever the problem draws now.

The result has a row for each part. A row that cannot be used is reported with its line number, and the others are
marked; at the end it says how many rows were read, marked and refused. It exits with 0 if every answer is right, with 1 if one is not, and with 2 if an answer given by --answer cannot be read or a row cannot be used; with --changes, with 0 if no mark has changed and with 1 if one has.";

/// Mark answers, one set or a table of many
#[derive(Args, Debug)]
#[command(after_help = HELP, group = clap::ArgGroup::new("what").required(true).multiple(true).args(["submissions", "problem"]))]
pub(super) struct Grade {
    /// Submissions: a table, JSON Lines (.jsonl), or a folder of YAML files; or a homework and the table of answers to it
    #[arg(value_name = "SUBMISSIONS", num_args = 0..=2, conflicts_with_all = ["seed", "form", "answer", "format"])]
    submissions: Vec<PathBuf>,
    /// The problem's identity, or the path of its file; for submissions, files and folders of problems in addition to the bank
    #[arg(long, value_name = "PROBLEM|FILE")]
    problem: Vec<String>,
    /// The seed that is printed on the sheet
    #[arg(long, value_name = "S", allow_negative_numbers = true, required_unless_present = "submissions")]
    seed: Option<SheetSeed>,
    /// The form in which the problem was asked; the first if none is named
    #[arg(long, value_name = "FORM")]
    form: Option<String>,
    /// The mark between whole and decimal digits
    #[arg(long, value_name = "MARK", default_value = "point")]
    decimal: Mark,
    /// The answer to a part
    #[arg(long, value_name = "NAME=TEXT", value_parser = assignment, required_unless_present_any = ["submissions", "work"])]
    answer: Vec<(String, String)>,
    /// Judge the lines of this file as the work that led to the answers, and give points for the method; - for standard input
    #[arg(long, value_name = "FILE", conflicts_with = "submissions")]
    work: Option<PathBuf>,
    /// Show N further hints about wrong answers
    #[arg(long, value_name = "N", default_value_t = 0, conflicts_with = "submissions")]
    hints: usize,
    /// No attempts are left: show what would have followed from the student's own wrong answers
    #[arg(long, conflicts_with = "submissions")]
    closed: bool,
    /// The format for one set of answers: for people, or one JSON object
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Listing,
    /// Write the marks of submissions to this file instead of printing them
    #[arg(short, long, value_name = "OUT", requires = "submissions")]
    output: Option<PathBuf>,
    /// The format of the marks of submissions; by default from the name of the file, else a table
    #[arg(long, value_name = "FORMAT", requires = "submissions")]
    marks: Option<MarksFormat>,
    /// Write statistics of the parts and the wrong answers to PATH.json and PATH.html
    #[arg(long, value_name = "PATH", requires = "submissions")]
    summary: Option<PathBuf>,
    /// Write the marks as a test report in the form that CI services show (JUnit XML)
    #[arg(long, value_name = "FILE", requires = "submissions")]
    junit: Option<PathBuf>,
    /// Check whose sheet each row answers against this table, the seeds.csv that `momentous generate` wrote
    #[arg(long, value_name = "SEEDS.csv", requires = "submissions", conflicts_with = "roster")]
    sheets: Option<PathBuf>,
    /// The same for sheets that were made for this roster: the seeds follow from it and --secret
    #[arg(long, value_name = "CSV", requires = "submissions")]
    roster: Option<PathBuf>,
    /// How students' seeds were derived: 2, or 1 by an earlier version of the program
    #[arg(long, value_name = "VERSION", default_value_t, requires = "roster")]
    derivation: Derivation,
    /// How the numbers were drawn: 2, or 1 by an earlier version of the program; a table of seeds says it itself
    #[arg(long, value_name = "VERSION", default_value_t, conflicts_with = "sheets")]
    scheme: Scheme,
    /// Bring together attempts of one student at one sheet that are not in adjacent rows; the file is read twice
    #[arg(long, requires = "submissions")]
    any_order: bool,
    /// The submissions are responses that Moodle or Canvas downloaded, to questions whose codes are in this file, which `momentous export` wrote
    #[arg(long, value_name = "CODES", requires = "submissions", conflicts_with = "any_order")]
    codes: Option<PathBuf>,
    /// The column of responses by which students are known; by default the first usual one
    #[arg(long, value_name = "HEADING", requires = "codes")]
    student: Option<String>,
    /// Write the points of each student to this file, as the gradebooks of Moodle, Canvas and Brightspace import them
    #[arg(long, value_name = "FILE", requires = "submissions")]
    gradebook: Option<PathBuf>,
    /// The title above the points in the gradebook; by default that of the homework, or the name of the file of submissions
    #[arg(long, value_name = "TEXT", requires = "gradebook")]
    title: Option<String>,
    /// Which attempt counts in the gradebook, where the rows of responses are attempts
    #[arg(long, value_enum, default_value_t, requires = "codes")]
    attempts: gradebook::Attempts,
    /// Print every mark that differs from those in this file, which an earlier run wrote for the same submissions; exits with 0 if none does, and with 1 if one does
    #[arg(long, value_name = "OLD.csv", requires = "output")]
    changes: Option<PathBuf>,
    /// Write the marks that differ to this file, as a table
    #[arg(long, value_name = "FILE.csv", requires = "changes")]
    changes_table: Option<PathBuf>,
    #[command(flatten)]
    secret: Secret,
}

/// The mark between whole and decimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Mark {
    /// 3.14
    Point,
    /// 3,14
    Comma,
}

impl From<Mark> for DecimalMark {
    fn from(mark: Mark) -> Self {
        match mark {
            Mark::Point => Self::Point,
            Mark::Comma => Self::Comma,
        }
    }
}

impl Grade {
    fn sitting(&self) -> Sitting {
        Sitting { hints: self.hints, closed: self.closed }
    }

    pub(super) fn run(&self) -> Result<Exit, Failure> {
        match (self.submissions.as_slice(), self.problem.as_slice(), &self.seed) {
            ([homework, answers, ..], ..) => self.table(answers, Some(homework)),
            ([submissions], ..) => self.table(submissions, None),
            ([], [problem], Some(seed)) => self.single(problem, seed),
            ([], ..) => Err(Failure::unusable("name one problem with --problem, and a seed with --seed")),
        }
    }
}
