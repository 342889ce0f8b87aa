//! Whether an author's texts can be printed, told at their places in the problem file.

use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Path;
use momentous_fault::Span;
use momentous_problem::PartKind;
use momentous_render::line_faults;
use momentous_render::text_faults;

use super::Exercise;

impl Exercise {
    /// Reads the text, the hints, and what is asked and offered, as every format does that prints them.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_bank::Bank;
    /// use momentous_exercise::Exercise;
    /// use momentous_fault::Source;
    /// use momentous_problem::{compile, load};
    ///
    /// let file = Bank::built_in().find("impact/two-carts")?.text.replace("They collide.", "They $\\collide$.");
    /// let problem = Arc::new(compile(load(Source::new("carts.yaml", &file))?, None)?);
    /// let faults = Exercise::draw(&problem, 0, 1)?.printable().unwrap_err();
    /// let place = faults.list[0].span.map(|span| &file[span.start..span.end]);
    /// assert_eq!(place, Some("\\collide"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Every fault of these texts, with its place in the file.
    pub fn printable(&self) -> Result<(), Faults> {
        let (problem, variant) = (&*self.problem, &self.variant);
        let mut faults: Vec<Fault> = Vec::new();
        let mut read = |text: &str, origin: &dyn Fn(Span) -> (Path, Span)| {
            for fault in text_faults(text) {
                let whole = Span { start: 0, end: text.len() };
                let (path, within) = origin(fault.span.unwrap_or(whole));
                faults.push(Fault { span: None, ..fault }.at_path(path).within(within));
            }
        };
        read(&variant.text(problem), &|place| variant.origin_in_text(problem, place));
        let hints = problem.forms().get(variant.form()).into_iter().flat_map(|form| &form.question.hints);
        for (hint, said) in hints.zip(variant.hints(problem)) {
            read(&said, &|place| variant.origin_in_hint(problem, hint, place));
        }
        let form = self.worked().form;
        for (index, part) in form.parts.iter().enumerate() {
            let options = match &part.kind {
                PartKind::Choice(choice) => choice.decided(&self.worked()).options,
                _ => Vec::new(),
            };
            let path = form.question.path.key("ask").index(index);
            let faults_of_lines = options.iter().chain([&part.label]).flat_map(|line| line_faults(line));
            faults.extend(faults_of_lines.map(|fault| fault.at_path(path.clone())));
        }
        if faults.is_empty() { Ok(()) } else { Err(problem.loaded().locate(faults)) }
    }
}
