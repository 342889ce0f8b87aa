//! One set of answers, from the arguments.

use std::collections::BTreeMap;

use serde_json::json;

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
        let answers = self.answers(&exercise)?;
        let report = exercise.mark(&answers, self.decimal.into(), self.sitting());
        let text = match self.format {
            Listing::Text => report.to_string(),
            Listing::Json => format!("{}\n", record(&exercise, &report)?),
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

    /// The answers by part; a name that is no part, or that is answered twice, is told.
    fn answers(&self, exercise: &Exercise) -> Result<BTreeMap<String, String>, Failure> {
        let parts: Vec<&str> = exercise.worked().form.parts.iter().map(|part| part.id.as_str()).collect();
        let mut answers = BTreeMap::new();
        let mut failures = Vec::new();
        for (name, text) in &self.answer {
            let own = exercise.usual_name(name);
            if !parts.contains(&own) {
                failures.push(open::unknown(name, "part of this question", &parts));
            } else if answers.insert(own.to_owned(), text.clone()).is_some() {
                failures.push(Failure::unusable(format!("`{name}` is answered twice")));
            }
        }
        if failures.is_empty() { Ok(answers) } else { Err(Failure::all(failures)) }
    }
}

/// The report as JSON, with what makes the same variant again.
fn record(exercise: &Exercise, report: &Report) -> Result<serde_json::Value, Failure> {
    let identity = exercise.identity();
    let mut record = json!({
        "problem": identity.problem,
        "digest": identity.digest,
        "scheme": identity.scheme,
        "seed": identity.seed,
        "form": identity.form,
    });
    let report = serde_json::to_value(report)?;
    if let (Some(record), serde_json::Value::Object(report)) = (record.as_object_mut(), report) {
        record.extend(report);
    }
    Ok(record)
}
