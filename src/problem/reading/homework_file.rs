//! From the text of a homework's file to what it says, or to all faults of its form.

use momentous_fault::Faults;
use momentous_fault::Source;

use super::super::language::homework::HomeworkDraft;
use super::schema::HOMEWORK_SHAPES;
use super::settings_file;

impl HomeworkDraft {
    /// Reads the file of a homework. Whether its problems are there is not known yet.
    ///
    /// # Errors
    /// Every fault of its form.
    ///
    /// ```
    /// use momentous_fault::Source;
    /// use momentous_problem::HomeworkDraft;
    /// let read = |text: &str| HomeworkDraft::read(&Source::new("week-3.yaml", text));
    /// let homework = read("title: Week 3\nproblems: [{ problem: impact/two-carts, points: 4 }]").unwrap();
    /// assert_eq!(homework.problems[0].points, Some(4));
    /// let faults = read("title: Week 3\nproblems: [{ problem: impact/two-carts, point: 4 }]").unwrap_err();
    /// assert!(faults.list[0].help.as_ref().is_some_and(|help| help.starts_with("did you mean `points`?")));
    /// ```
    pub fn read(source: &Source) -> Result<Self, Faults> {
        settings_file::read(source, &HOMEWORK_SHAPES)
    }
}
