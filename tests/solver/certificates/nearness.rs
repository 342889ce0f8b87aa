//! How near the certificates are to the errors: never below one, and never more than a thousand times their typical size.
//! `UPDATE_DOCS=1 cargo test --test solver near` writes the table behind the chart in `docs/methods.md`.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::looked::{Looked, Pair, whole_bank};

/// A certificate may be this many times the typical error of its quantity.
const FACTOR: f64 = 1000.0;

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

fn row(form: &Looked, quantity: &str, pairs: &[Pair]) -> Row {
    #[allow(clippy::cast_precision_loss, reason = "a count of seeds")]
    let typical = |part: fn(&Pair) -> f64| {
        let squares: f64 = pairs.iter().map(|pair| part(pair) * part(pair)).sum();
        (squares / pairs.len() as f64).sqrt()
    };
    let greatest = |part: fn(&Pair) -> f64| pairs.iter().map(part).fold(0.0, f64::max);
    Row {
        problem: form.problem.clone(),
        form: form.form,
        quantity: quantity.to_owned(),
        typical_error: typical(|pair| pair.0).max(ROUNDED_ONCE),
        greatest_error: greatest(|pair| pair.0),
        typical_certificate: typical(|pair| pair.1),
        greatest_certificate: greatest(|pair| pair.1),
    }
}

fn table() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/methods/certificates.csv")
}

#[test]
fn certificates_are_near_the_errors() {
    let rows = |form: &'static Looked| form.answers.iter().map(move |(quantity, pairs)| row(form, quantity, pairs));
    let all: Vec<Row> = whole_bank().iter().flat_map(rows).collect();
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
        if row.greatest_certificate > FACTOR * row.typical_error {
            wrong.push(format!("{name}: {:e} certified, {:e} typical", row.greatest_certificate, row.typical_error));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
