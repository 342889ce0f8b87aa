//! From the text of `course.yaml` to the settings of a course, or to all its faults.

use momentous_fault::Faults;
use momentous_fault::Source;

use super::super::language::settings::Course;
use super::load::Loaded;
use super::position::Index;
use super::schema::COURSE_SHAPES;
use super::settings_file;

impl Course {
    /// Reads the settings of a course.
    ///
    /// # Errors
    /// Every fault of the file.
    ///
    /// ```
    /// use momentous_fault::Source;
    /// use momentous_problem::Course;
    /// let course = Course::read(&Source::new("course.yaml", "symbols: { momentum: L }")).unwrap();
    /// assert_eq!(course.symbols.momentum.as_deref(), Some("L"));
    /// let faults = Course::read(&Source::new("course.yaml", "symbol: { momentum: L }")).unwrap_err();
    /// assert_eq!(faults.list[0].help.as_deref(), Some("did you mean `symbols`?"));
    /// ```
    pub fn read(source: &Source) -> Result<Self, Faults> {
        let course: Self = settings_file::read(source, &COURSE_SHAPES)?;
        match course.symbols.notation() {
            Ok(_) => Ok(course),
            Err(faults) => Err(Index::of(source).locate_all(faults)),
        }
    }
}

impl Loaded {
    /// The problem with the settings of its course, where it says nothing else itself.
    #[must_use]
    pub fn in_course(mut self, course: &Course) -> Self {
        self.draft.symbols = self.draft.symbols.or(&course.symbols);
        self
    }
}
