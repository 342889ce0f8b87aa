//! Whether a problem file works: loaded, compiled, drawn, printed and marked.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::{Problem, compile, load};

/// Compiles a problem file and draws three seeds of each form; the printed answers must be right. Gives the problem.
pub fn works(name: &str, text: &str) -> Arc<Problem> {
    let problem = load(Source::new(name, text)).and_then(|loaded| compile(loaded, None));
    let problem = Arc::new(problem.unwrap_or_else(|faults| panic!("{name}\n{faults}")));
    for form in 0..problem.forms().len() {
        for seed in 1..=3 {
            let exercise = Exercise::draw(&problem, form, seed)
                .unwrap_or_else(|reason| panic!("{name}, form {form}, seed {seed}: {reason}"));
            let parts = &exercise.worked().form.parts;
            let answers: BTreeMap<String, String> =
                parts.iter().map(|part| (part.id.clone(), exercise.printed(part))).collect();
            let report = exercise.grade(&answers, DecimalMark::Point);
            assert!(report.is_right(), "{name}, form {form}, seed {seed}\n{report}");
            assert!(
                !exercise.sheet().statement.trim().is_empty()
                    && exercise.outline(Audience::Everyone, Detail::Short).sections.len() > 1,
                "{name}"
            );
        }
    }
    problem
}
