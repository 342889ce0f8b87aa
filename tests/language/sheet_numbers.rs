//! The numbers of every sheet of the bank, as tables keep them, give the sheet again.

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Drawer, Exercise, SheetNumbers};
use momentous::problem::{Scheme, compile, load};
use serde_json::Value;

/// What is given and answered; the order of options follows from the secret.
fn told(exercise: &Exercise) -> (Value, Vec<Value>) {
    let record = exercise.record(None);
    let has_no_options = |part: &&Value| part["options"].is_null();
    (record["given"].clone(), record["ask"].as_array().unwrap().iter().filter(has_no_options).cloned().collect())
}

#[test]
fn every_sheet_is_drawn_again_from_its_numbers() {
    let mut differ = Vec::new();
    for source in Bank::built_in().sources() {
        // With a secret the same seed draws other numbers, so that the sheet follows from what stands on it alone.
        let [problem, other] = [None, Some(&b"course"[..])]
            .map(|secret| Arc::new(compile(load(source.clone()).unwrap(), secret).unwrap()));
        for form in 0..problem.forms().len() {
            let Ok(sheet) = Drawer::new(&problem, form).unwrap().draw(1) else { continue };
            let written = sheet.sheet_numbers().to_string();
            let read: SheetNumbers = written.parse().unwrap();
            let again = Drawer::new(&other, form).unwrap().issued(1, Scheme::default(), &read);
            let is_the_same = match &again {
                Ok(again) => told(again) == told(&sheet),
                // What is revealed does not decide a choice.
                Err(_) => !problem.forms()[form].reveal.is_empty(),
            };
            if !is_the_same {
                differ.push(format!(
                    "{} form {form}: {written}: {:?}",
                    problem.id(),
                    again.map(|again| again.record(None))
                ));
            }
        }
    }
    assert!(differ.is_empty(), "{}", differ.join("\n"));
}
