//! From exercises to documents.

use std::path::PathBuf;

use clap::Args;

use crate::bank::course_folder;
use crate::exercise::Exercise;
use crate::explain::Audience;
use crate::explain::Detail;
use crate::render::Format;
use crate::render::Renderer;
use crate::render::Solution;

use super::failure::Failure;

/// The folder of a user's templates that take the place of the built-in ones.
const TEMPLATES: &str = "templates";

/// The parts of a solution that are shown.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(super) struct SolutionOptions {
    /// Show the first K steps of each solution only, and leave the rest to the student
    #[arg(long, value_name = "K")]
    faded: Option<usize>,
    /// Add information for instructors: the bounds on errors and the equations
    #[arg(long, conflicts_with = "faded")]
    instructor: bool,
    /// Show every step of the algebra in symbols, what acts and what is neglected, and all checks
    #[arg(long)]
    detailed: bool,
}

impl SolutionOptions {
    /// Whether anything but the usual solution for students is wanted.
    pub(super) fn is_said(self) -> bool {
        self.faded.is_some() || self.instructor || self.detailed
    }

    /// The worked solution of an exercise.
    pub(super) fn solution(self, exercise: &Exercise) -> Solution {
        let audience = if self.instructor { Audience::Instructor } else { Audience::Everyone };
        let detail = if self.detailed { Detail::Full } else { Detail::Short };
        Solution {
            outline: exercise.outline(audience, detail),
            identity: exercise.identity(),
            audience,
            faded: self.faded,
        }
    }

    /// The worked solution as Markdown, for JSON.
    pub(super) fn markdown(self, renderer: &Renderer, exercise: &Exercise) -> Result<String, Failure> {
        Ok(renderer.render_solution(&self.solution(exercise), Format::Markdown)?.text)
    }
}

/// Files that HTML holds beside its text.
#[derive(Args, Clone, Copy, Debug)]
pub(super) struct HtmlOptions {
    /// Leave the font of the mathematics out of HTML
    ///
    /// Each file is 66 kB smaller. Roots and brackets then grow only where the reader has a mathematics font.
    #[arg(long)]
    no_font: bool,
}

impl HtmlOptions {
    /// The renderer for documents that are handed out.
    pub(super) fn renderer(self) -> Result<Renderer, Failure> {
        let renderer = renderer()?;
        Ok(if self.no_font { renderer } else { renderer.with_font() })
    }
}

/// The folder with the course's own templates, where there is one.
pub(super) fn templates() -> Option<PathBuf> {
    Some(course_folder().join(TEMPLATES)).filter(|folder| folder.is_dir())
}

/// The renderer with the templates of the current folder, where there are some.
pub(super) fn renderer() -> Result<Renderer, Failure> {
    Ok(Renderer::new(templates().as_deref())?)
}
