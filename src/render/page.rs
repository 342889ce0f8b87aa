//! Pages before any format: sheets, solutions and keys.

use momentous_explain::Audience;
use momentous_explain::Inline;
use momentous_explain::Outline;
use momentous_expr::Math;
use momentous_figure::Drawing;

/// One page, or run of pages, of a document.
#[derive(Clone, Debug, PartialEq)]
pub enum Page {
    /// A problem sheet.
    Sheet(Sheet),
    /// A worked solution.
    Solution(Solution),
    /// An answer key.
    Key(Key),
}

/// A page that is looked at.
#[derive(Clone, Copy, Debug)]
pub(super) enum PageView<'a> {
    Sheet(&'a Sheet),
    Solution(&'a Solution),
    Key(&'a Key),
}

impl<'a> From<&'a Page> for PageView<'a> {
    fn from(page: &'a Page) -> Self {
        match page {
            Page::Sheet(sheet) => Self::Sheet(sheet),
            Page::Solution(solution) => Self::Solution(solution),
            Page::Key(key) => Self::Key(key),
        }
    }
}

/// The identity of a variant: what it is made from; printed small, so that the same numbers can be made again.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// The problem's id, `impact/two-carts`.
    pub problem: String,
    /// The form asked, where the problem has forms.
    pub form: Option<String>,
    /// The seed; none where the numbers are literal.
    pub seed: Option<u64>,
    /// The mark of the secret with which the numbers were drawn, printed behind the seed.
    pub secret: Option<String>,
    /// The digest of the problem's file, as it is to be printed.
    pub digest: Option<String>,
    /// The version of the scheme that draws numbers.
    pub scheme: Option<u32>,
}

/// A problem sheet: what a student is given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// The problem's title.
    pub title: String,
    /// Its place on a sheet with several problems; none where it is alone.
    pub place: Option<Box<SheetPlace>>,
    /// The identity of the variant.
    pub identity: Identity,
    /// The student's name, where the sheet is one student's.
    pub student: Option<String>,
    /// The author's Markdown with its placeholders filled in; it may hold `$`-mathematics.
    pub statement: String,
    /// The questions, in order.
    pub parts: Vec<SheetPart>,
    /// Constants and conventions to use, such as g.
    pub note: Vec<Inline>,
    /// The figure, which shows only what is given.
    pub figure: Option<Box<Drawing>>,
    /// Hints in Markdown, to be read one by one.
    pub hints: Vec<String>,
    /// The number of ruled lines for each answer.
    pub room: usize,
}

/// The place of a problem on a sheet with several.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SheetPlace {
    /// Its number, from 1.
    pub number: usize,
    /// The heading of the whole sheet, before its first problem.
    pub heading: Option<Heading>,
}

/// The heading of a sheet with several problems.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heading {
    /// The course.
    pub course: Option<String>,
    /// The title.
    pub title: String,
    /// The words about the date.
    pub date: Option<String>,
    /// The points of all problems together.
    pub points: f64,
}

/// One thing that is asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SheetPart {
    /// Its label without brackets, `a`.
    pub label: String,
    /// The text of the question; without its full stop where a unit follows, which is printed before it.
    pub text: Vec<Inline>,
    /// The options, each by its letter; none where nothing is chosen, or the text says it.
    pub options: Vec<String>,
    /// Pictures that can be chosen, each with its name as the caption.
    pub pictures: Vec<Drawing>,
    /// The unit the answer is to be given in.
    pub unit: Option<Math>,
    /// Its points.
    pub points: Option<f64>,
}

/// A worked solution and how much of it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The whole solution.
    pub outline: Outline,
    /// The identity of the variant.
    pub identity: Identity,
    /// Whether the instructor's sections are shown.
    pub audience: Audience,
    /// Only so many steps of the solving section; the rest is left to the student (see [`super::fade`]).
    pub faded: Option<usize>,
}

/// The answers of one or more variants.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Key {
    /// Its title.
    pub title: String,
    /// One row for each part of each variant.
    pub rows: Vec<KeyRow>,
}

/// One answer of a key.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KeyRow {
    /// The variant.
    pub identity: Identity,
    /// Whose variant it is, where it is one student's.
    pub student: Option<String>,
    /// The label of the part, without brackets.
    pub part: String,
    /// The answer with its unit.
    pub answer: Vec<Inline>,
}
