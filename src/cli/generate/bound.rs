//! Several problems of one student in one file: one sheet, numbered, under one head.

use crate::render::Heading;
use crate::render::Page;
use crate::render::Sheet;
use crate::render::SheetPlace;

/// The heading over them.
const TITLE: &str = "Problems";

/// Sheets in the order in which they come, until those of the next student.
#[derive(Debug, Default)]
pub(super) struct Bound(Vec<Sheet>);

impl Bound {
    /// Takes the pages of one sheet more; what is then complete comes out.
    pub(super) fn add(&mut self, pages: Vec<Page>) -> Vec<Page> {
        let mut complete = Vec::new();
        for page in pages {
            match page {
                Page::Sheet(sheet) => {
                    if self.0.last().is_some_and(|last| last.student != sheet.student) {
                        complete.extend(self.finish());
                    }
                    self.0.push(sheet);
                }
                other => complete.push(other),
            }
        }
        complete
    }

    /// The sheet of the last student.
    pub(super) fn finish(&mut self) -> Vec<Page> {
        let sheets = std::mem::take(&mut self.0);
        let points: f64 = sheets.iter().flat_map(|sheet| &sheet.parts).filter_map(|part| part.points).sum();
        let numbered = sheets.into_iter().zip(1..).map(|(sheet, number)| {
            let heading = (number == 1).then(|| Heading { title: TITLE.to_owned(), points, ..Heading::default() });
            let student = heading.as_ref().and_then(|_| sheet.student.clone());
            Page::Sheet(Sheet { place: Some(Box::new(SheetPlace { number, heading })), student, ..sheet })
        });
        numbered.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_student_has_one_sheet_with_numbered_problems() {
        let sheet = |student: &str| vec![Page::Sheet(Sheet { student: Some(student.to_owned()), ..Sheet::default() })];
        let mut bound = Bound::default();
        let mut pages: Vec<Page> =
            ["Ann", "Ann", "Ben", "Ben"].into_iter().flat_map(|name| bound.add(sheet(name))).collect();
        pages.extend(bound.finish());
        let shown = pages.iter().map(|page| match page {
            Page::Sheet(sheet) => {
                (sheet.place.as_ref().map(|place| (place.number, place.heading.is_some())), sheet.student.as_deref())
            }
            Page::Solution(_) | Page::Key(_) => (None, None),
        });
        let expected = [
            (Some((1, true)), Some("Ann")),
            (Some((2, false)), None),
            (Some((1, true)), Some("Ben")),
            (Some((2, false)), None),
        ];
        assert!(shown.eq(expected));
    }
}
