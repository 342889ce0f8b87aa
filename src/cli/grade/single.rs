//! One set of answers, from the arguments.

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::cli::format::Listing;
use crate::cli::open;
use crate::cli::output::Output;
use crate::exercise::Drawer;
use crate::exercise::SheetSeed;

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
        let report = exercise.mark(&answers, self.decimal.into(), self.sitting());
        let text = match self.format {
            Listing::Text => report.to_string(),
            Listing::Json => format!("{}\n", exercise.mark_record(&report)?),
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
}
