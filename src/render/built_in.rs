//! The templates that are built into the program.

macro_rules! built_in {
    ($($path:literal),* $(,)?) => { &[$(($path, include_str!(concat!("../../templates/", $path)))),*] };
}

/// Built-in files by their paths below `templates/`.
const EVERYWHERE: &[(&str, &str)] = built_in![
    "html/blocks.tera",
    "html/body.tera",
    "html/document.tera",
    "html/key.tera",
    "html/sheet.tera",
    "html/solution.tera",
    "html/statistics.tera",
    "html/style.css",
    "latex/blocks.tera",
    "latex/document.tera",
    "latex/key.tera",
    "latex/sheet.tera",
    "latex/solution.tera",
    "markdown/blocks.tera",
    "markdown/document.tera",
    "markdown/key.tera",
    "markdown/sheet.tera",
    "markdown/solution.tera",
    "page/page.tera",
    "typst/blocks.tera",
    "typst/document.tera",
    "typst/key.tera",
    "typst/sheet.tera",
    "typst/solution.tera",
    "web/collision.tera",
    "web/discs.tera",
    "web/field.tera",
    "web/layout.tera",
    "web/play.tera",
    "web/practice.tera",
    "web/refused.tera",
    "web/restitution.tera",
    "web/simulator.tera",
    "web/solution.tera",
    "web/solve.tera",
    "web/start.tera",
];

/// Those of the pages of courses.
#[cfg(feature = "courses")]
const COURSES: &[(&str, &str)] = built_in![
    "web/courses/assignment.tera",
    "web/courses/course.tera",
    "web/courses/courses.tera",
    "web/courses/entry.tera",
    "web/courses/grades/answers.tera",
    "web/courses/grades/course.tera",
    "web/courses/grades/gradebook.tera",
    "web/courses/grades/member.tera",
    "web/courses/grades/regrade.tera",
    "web/courses/grades/retention.tera",
    "web/courses/grades/statistics.tera",
    "web/courses/grades/trail.tera",
    "web/courses/item.tera",
    "web/courses/join.tera",
    "web/courses/link.tera",
    "web/courses/mailed.tera",
    "web/courses/sign-in.tera",
    "web/courses/solution.tera",
    "web/courses/staff/editor.tera",
    "web/courses/staff/extensions.tera",
    "web/courses/staff/link.tera",
    "web/courses/staff/look.tera",
    "web/courses/staff/new-course.tera",
    "web/courses/staff/people.tera",
    "web/courses/staff/preview.tera",
    "web/courses/staff/print.tera",
    "web/courses/staff/problem.tera",
    "web/courses/staff/problems.tera",
    "web/courses/staff/roster.tera",
    "web/courses/staff/settings.tera",
    "web/courses/staff/write.tera",
];
#[cfg(not(feature = "courses"))]
const COURSES: &[(&str, &str)] = &[];

/// The style sheet's path, which is not a template.
pub(super) const STYLE: &str = "html/style.css";

/// Every built-in template and style sheet, by its path below `templates/`.
pub fn built_in_templates() -> impl Iterator<Item = (&'static str, &'static str)> {
    EVERYWHERE.iter().chain(COURSES).copied()
}
