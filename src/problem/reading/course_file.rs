//! From the text of `course.yaml` to the settings of a course, or to all its faults.

use momentous_fault::Faults;
use momentous_fault::Source;

use super::super::language::settings::Course;
use super::check::check;
use super::document::Document;
use super::load::Loaded;
use super::load::typed;
use super::position::Index;
use super::schema::COURSE_SHAPES;

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
        let Document { root, mut faults } = Document::read(source);
        let Some(root) = root else { return Err(Index::new(source, None).locate_all(faults)) };
        let (value, of_form) = check(&root, &COURSE_SHAPES);
        faults.extend(of_form);
        if faults.is_empty() {
            match typed::<Self>(value) {
                Ok(course) => match course.symbols.notation() {
                    Ok(_) => return Ok(course),
                    Err(of_letters) => faults.extend(of_letters),
                },
                Err(fault) => faults.push(fault),
            }
        }
        Err(Index::new(source, Some(root)).locate_all(faults))
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
