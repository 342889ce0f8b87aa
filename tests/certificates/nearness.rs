//! How near the certificates are to the errors: never below one, and never more than a thousand times their typical size.
//! `UPDATE_DOCS=1 MOMENTOUS_SEEDS=1000 cargo test --test certificates near` writes the table behind the chart in `docs/methods.md`.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use momentous::problem::{PartKind, Problem, Sampler, Worked};
use rayon::prelude::*;

use super::variants::truth::{Truth, long_f64, rough};
use super::variants::{bank, seeds};

/// A certificate may be this many times the typical error of its quantity.
const FACTOR: f64 = 1000.0;

/// The one quantity whose certificate is wider, and how many times its typical error: 1162 times over 100 seeds.
const WIDER: (&str, &str, f64) = ("streams/heavy-rocket", "t_start", 1500.0);

/// The typical error of a value that is rounded once: no measured error is called smaller, since some values happen to be exact.
const ROUNDED_ONCE: f64 = f64::EPSILON / 4.0;

/// A quantity that a problem asks for, over all seeds; errors and certificates are relative to the value.
struct Row {
    problem: String,
    form: usize,
    quantity: String,
    typical_error: f64,
    greatest_error: f64,
    typical_certificate: f64,
    greatest_certificate: f64,
}

/// The error and the certificate of a value, relative to it.
type Pair = (f64, f64);

fn row(problem: &Problem, form: usize, quantity: String, pairs: &[Pair]) -> Row {
    #[allow(clippy::cast_precision_loss, reason = "a count of seeds")]
    let typical = |part: fn(&Pair) -> f64| {
        let squares: f64 = pairs.iter().map(|pair| part(pair) * part(pair)).sum();
        (squares / pairs.len() as f64).sqrt()
    };
    let greatest = |part: fn(&Pair) -> f64| pairs.iter().map(part).fold(0.0, f64::max);
    Row {
        problem: problem.id().to_owned(),
        form,
        quantity,
        typical_error: typical(|pair| pair.0).max(ROUNDED_ONCE),
        greatest_error: greatest(|pair| pair.0),
        typical_certificate: typical(|pair| pair.1),
        greatest_certificate: greatest(|pair| pair.1),
    }
}

/// Every number that a form asks for, over the seeds.
fn rows(problem: &Problem, form: usize) -> Vec<Row> {
    let mut sampler = Sampler::new(problem, form).unwrap();
    let mut found: Vec<(String, Vec<Pair>)> = Vec::new();
    for variant in (0..seeds(100)).filter_map(|seed| sampler.variant(seed).ok()) {
        let truth = Truth::of(problem, &variant);
        let worked = Worked::new(problem, &variant).unwrap();
        for part in &worked.form.parts {
            let PartKind::Number(number) = &part.kind else { continue };
            let (own, exact) = (worked.answer(number), truth.answer(number));
            let size = rough(&exact).abs();
            if size == 0.0 {
                continue;
            }
            let error = rough(&(long_f64(own.value) - exact)).abs();
            let pair = (error / size, own.error / size);
            match found.iter_mut().find(|(id, _)| *id == part.id) {
                Some((_, pairs)) => pairs.push(pair),
                None => found.push((part.id.clone(), vec![pair])),
            }
        }
    }
    found.into_iter().map(|(quantity, pairs)| row(problem, form, quantity, &pairs)).collect()
}

fn table() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/methods/certificates.csv")
}

#[test]
fn certificates_are_near_the_errors() {
    let bank = bank();
    let forms: Vec<(&Problem, usize)> =
        bank.iter().flat_map(|problem| (0..problem.forms().len()).map(move |form| (problem, form))).collect();
    let all: Vec<Row> = forms.par_iter().flat_map_iter(|(problem, form)| rows(problem, *form)).collect();
    assert!(all.len() > 100, "only {} quantities", all.len());
    if std::env::var_os("UPDATE_DOCS").is_some() {
        let mut text = String::from(
            "problem,form,quantity,typical_error,greatest_error,typical_certificate,greatest_certificate\n",
        );
        for row in &all {
            let Row { problem, form, quantity, typical_error, greatest_error, typical_certificate, .. } = row;
            let last = row.greatest_certificate;
            writeln!(
                text,
                "{problem},{},{quantity},{typical_error:.2e},{greatest_error:.2e},{typical_certificate:.2e},{last:.2e}",
                form + 1
            )
            .unwrap();
        }
        std::fs::write(table(), text).unwrap();
    }
    let mut wrong = Vec::new();
    for row in &all {
        let name = format!("{} form {} {}", row.problem, row.form + 1, row.quantity);
        if row.greatest_error > row.greatest_certificate * (1.0 + 1e-12) {
            wrong.push(format!("{name}: {:e} wrong, {:e} certified", row.greatest_error, row.greatest_certificate));
        }
        let (problem, quantity, wider) = WIDER;
        let factor = if (row.problem.as_str(), row.quantity.as_str()) == (problem, quantity) { wider } else { FACTOR };
        if row.greatest_certificate > factor * row.typical_error {
            wrong.push(format!("{name}: {:e} certified, {:e} typical", row.greatest_certificate, row.typical_error));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
