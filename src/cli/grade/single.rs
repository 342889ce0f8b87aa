//! One set of answers, from the arguments.

use std::path::Path;

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::cli::format::Listing;
use crate::cli::open;
use crate::cli::output::Output;
use crate::exercise::Drawer;
use crate::exercise::Exercise;
use crate::exercise::SheetSeed;
use crate::grade::Report;

use super::Grade;

impl Grade {
    /// Marks what `--answer` says.
    pub(super) fn single(&self, name: &str, seed: &SheetSeed) -> Result<Exit, Failure> {
        let secret = self.secret.read()?;
        let problem = open::problem(name, secret.as_deref())?;
        let form = open::form(&problem, self.form.as_deref())?;
        let seed = seed.of_a_sheet(&problem).map_err(|message| Failure::unusable(format!("--seed: {message}")))?;
        let exercise = Drawer::new(&problem, form).and_then(|mut drawer| drawer.draw_by(seed, self.scheme));
        let exercise = exercise.map_err(|reason| Failure::no_variant(problem.id(), seed, &reason))?;
        let typed = self.answer.iter().map(|(name, text)| (name.as_str(), text.as_str()));
        let answers = exercise.answers_by_part(typed);
        let answers = answers.map_err(|faults| Failure::all(faults.into_iter().map(Failure::unusable).collect()))?;
        let Some(work) = self.work.as_ref().map(|path| read(path)).transpose()? else {
            return self.answers(&exercise, &exercise.mark_or_ask(&answers, self.decimal.into(), self.sitting()));
        };
        let report = exercise.mark_with_work(&answers, &work, self.decimal.into(), self.sitting());
        self.worked(&exercise, &work, &report)
    }

    /// The answers alone.
    fn answers(&self, exercise: &Exercise, report: &Report) -> Result<Exit, Failure> {
        let text = match self.format {
            Listing::Text => report.to_string(),
            Listing::Json => format!("{}\n", exercise.mark_record(report)?),
        };
        Output::whole(None, &text)?;
        Ok(if report.is_unreadable() {
            Exit::Unusable
        } else if report.is_right() {
            Exit::Fine
        } else {
            Exit::NotRight
        })
    }

    /// The work, and then the answers where there are some.
    fn worked(&self, exercise: &Exercise, work: &str, report: &Report) -> Result<Exit, Failure> {
        let (judged, next) = exercise.judge_work(work, self.decimal.into());
        if self.format == Listing::Json {
            let mut record = exercise.mark_record(report)?;
            if let Some(object) = record.as_object_mut() {
                object.insert("work".to_owned(), serde_json::to_value(&judged)?);
            }
            Output::whole(None, &format!("{record}\n"))?;
        } else {
            let mut text = judged.to_string();
            if let Some(next) = next.filter(|_| self.hints > 0) {
                text = format!("{text}Next: {}\n", next.strength(self.hints));
            }
            if !self.answer.is_empty() {
                text = format!("{text}\n{report}");
            }
            Output::whole(None, &text)?;
        }
        let is_right = if self.answer.is_empty() { judged.is_right() } else { report.is_right() };
        Ok(if is_right { Exit::Fine } else { Exit::NotRight })
    }
}

/// The lines of a file, or of standard input.
fn read(path: &Path) -> Result<String, Failure> {
    let text =
        if path == Path::new("-") { std::io::read_to_string(std::io::stdin()) } else { std::fs::read_to_string(path) };
    text.map_err(|fault| Failure::unusable(format!("{}: {fault}", path.display())))
}
