//! The programs that items are written for.

use std::io::Write;

use momentous_render::Markup;

use super::Begun;
use super::Export;
use super::NotWritten;
use super::question::Question;
use super::{canvas, moodle, numbas, prairielearn, qti, rexams};

/// A program that items are written for.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Its name in commands.
    pub name: &'static str,
    /// The description of what is written.
    pub about: &'static str,
    /// How mathematics can stand there; the first is the usual way.
    pub markup: &'static [Markup],
    begin: for<'w> fn(Box<dyn Write + 'w>, Markup, &str) -> Begun<'w>,
    types_unit: fn(&Question<'_>) -> bool,
}

/// Units are printed behind fields.
const PRINTED: fn(&Question<'_>) -> bool = |_| false;

/// Every target, in the order of the columns of [`super::FEATURES`].
pub const TARGETS: [Target; 7] = [
    Target {
        name: "moodle",
        about: "Moodle XML, for the question bank",
        markup: &[Markup::Tex, Markup::MathMl],
        begin: |out, markup, _| moodle::begin(out, markup),
        types_unit: moodle::types_unit,
    },
    Target {
        name: "qti3",
        about: "a package of QTI 3.0",
        markup: &[Markup::MathMl],
        begin: |out, _, title| Ok(qti::begin_3(out, title)),
        types_unit: PRINTED,
    },
    Target {
        name: "qti21",
        about: "a package of QTI 2.1",
        markup: &[Markup::MathMl],
        begin: |out, _, title| Ok(qti::begin_2(out, title)),
        types_unit: PRINTED,
    },
    Target {
        name: "canvas",
        about: "a package of QTI 1.2, as Classic Quizzes of Canvas import it",
        markup: &[Markup::Pictures],
        begin: |out, _, title| Ok(canvas::begin(out, title)),
        types_unit: PRINTED,
    },
    Target {
        name: "numbas",
        about: "an exam of Numbas",
        markup: &[Markup::MathMl],
        begin: |out, _, title| numbas::begin(out, title),
        types_unit: PRINTED,
    },
    Target {
        name: "prairielearn",
        about: "a zip file with folders of PrairieLearn questions",
        markup: &[Markup::Tex, Markup::MathMl],
        begin: |out, markup, _| Ok(prairielearn::begin(out, markup)),
        types_unit: PRINTED,
    },
    Target {
        name: "rexams",
        about: "a zip file with Rmd files for R/exams",
        markup: &[Markup::Markdown],
        begin: |out, _, _| Ok(rexams::begin(out)),
        types_unit: PRINTED,
    },
];

impl Target {
    /// The target of that name.
    ///
    /// ```
    /// use momentous_export::Target;
    /// assert_eq!(Target::named("qti3").map(|own| own.about), Some("a package of QTI 3.0"));
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        TARGETS.iter().find(|target| target.name == name)
    }

    /// Whether students type the unit of a question.
    pub(super) fn types_unit(&self, question: &Question<'_>) -> bool {
        (self.types_unit)(question)
    }

    /// Begins an export; where it is a whole quiz, it has that title.
    ///
    /// # Errors
    /// Where the file takes nothing.
    pub fn begin<'w>(
        &self,
        out: Box<dyn Write + 'w>,
        markup: Markup,
        title: &str,
    ) -> Result<Box<dyn Export + 'w>, NotWritten> {
        (self.begin)(out, markup, title)
    }
}
