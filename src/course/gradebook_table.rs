//! A gradebook as a table that spreadsheets open, written and read back.

use momentous_exercise::Table;
use momentous_exercise::defused;
use momentous_quantity::Rational;

use super::account::GradeMark;
use super::gradebook::Gradebook;

/// Points that are no decimal number of so few digits are rounded to them.
const DECIMALS: u32 = 6;

/// The columns before and after those of the items.
pub(super) const FRONT: [&str; 3] = ["login", "name", "section"];
const BACK: [&str; 2] = ["total", "out_of"];

/// A row of a table that was read back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadGrades {
    /// The name by which the student signs in.
    pub login: String,
    /// The points for each item; nothing where nothing was handed in.
    pub marks: Vec<Option<Rational>>,
    /// The sum.
    pub total: Rational,
}

impl Gradebook {
    /// The table, as comma-separated values. No cell is a formula to a spreadsheet.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let headings = self.columns.iter().map(|column| column.heading.as_str());
        let head = line(FRONT.into_iter().chain(headings).chain(BACK).map(str::to_owned));
        let rows = self.rows.iter().map(|row| {
            let front = [&row.login, &row.name, &row.section].map(Clone::clone);
            let marks = row.marks.iter().map(|mark| mark.points().map_or_else(String::new, decimal));
            let back = [decimal(&row.total), self.out_of.to_string()];
            line(front.into_iter().chain(marks).chain(back))
        });
        std::iter::once(head).chain(rows).collect()
    }

    /// Reads the points of a table that was written for these columns.
    ///
    /// # Errors
    /// Everything that is wrong, each with its line.
    pub fn read_csv(&self, text: &str) -> Result<Vec<ReadGrades>, Vec<String>> {
        let mut table = Table::read(text.as_bytes()).map_err(|message| vec![message])?;
        let column = |heading: &str| -> Result<usize, Vec<String>> {
            let column = table.column(heading).map_err(|message| vec![message])?;
            column.ok_or_else(|| vec![format!("there is no column `{heading}`")])
        };
        let [login, total] = [column("login")?, column("total")?];
        let places = self.columns.iter().map(|listed| column(&listed.heading)).collect::<Result<Vec<usize>, _>>()?;
        let (mut read, mut faults) = (Vec::new(), Vec::new());
        while let Some((line, row)) = table.next_row() {
            let grades = row.and_then(|row| {
                let points = |place: usize| match row.cell(place) {
                    "" => Ok(None),
                    cell => {
                        super::share::fraction(cell).map(Some).ok_or_else(|| format!("`{cell}` is no number of points"))
                    }
                };
                Ok(ReadGrades {
                    login: row.cell(login).to_owned(),
                    marks: places.iter().map(|place| points(*place)).collect::<Result<_, String>>()?,
                    total: points(total)?.ok_or("there is no total")?,
                })
            });
            match grades {
                Ok(grades) => read.push(grades),
                Err(message) => faults.push(format!("line {line}: {message}")),
            }
        }
        if faults.is_empty() { Ok(read) } else { Err(faults) }
    }

    /// The logins of students whose points in a table that was read back are not those of this gradebook, as the table writes them.
    #[must_use]
    pub fn differing(&self, read: &[ReadGrades]) -> Vec<String> {
        let written = |points: Option<&Rational>| points.map(decimal);
        let same = |grades: &ReadGrades| {
            self.rows.iter().find(|row| row.login == grades.login).is_some_and(|row| {
                let marks = row.marks.iter().map(|mark| written(GradeMark::points(mark)));
                marks.eq(grades.marks.iter().map(|points| written(points.as_ref())))
                    && decimal(&row.total) == decimal(&grades.total)
            })
        };
        read.iter().filter(|grades| !same(grades)).map(|grades| grades.login.clone()).collect()
    }
}

/// A line of such a table. No cell is a formula to a spreadsheet.
pub(super) fn line(cells: impl Iterator<Item = String>) -> String {
    cells.map(|cell| quoted(&defused(&cell))).collect::<Vec<_>>().join(",") + "\n"
}

/// A cell as it stands between commas.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\r', '\n']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.to_owned() }
}

/// A fraction as a decimal number, rounded where it is none of few digits.
pub(super) fn decimal(points: &Rational) -> String {
    let scale = 10_u32.pow(DECIMALS);
    let scaled = (points * Rational::from(scale)).round();
    let text = momentous_quantity::Decimal::from_scaled(scaled, DECIMALS).to_string();
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
