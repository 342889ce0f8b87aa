//! Every answer of the bank has an independent simulation that would find out a wrong one.

#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use std::path::Path;

use momentous::bank::Audit;
use momentous::bank::Bank;
use momentous::bank::FormAudit;
use momentous::bank::Outcome;
use momentous::bank::Promise;
use momentous::bank::Seeds;
use momentous::bank::audit;
use momentous::bank::files_under;
use momentous::render::Renderer;

/// Seeds for each form; the first says whether wrong answers are found out, the others that right ones are not.
const SEEDS: u64 = 2;

/// So many seeds, all of them simulated.
fn first(seeds: u64) -> Seeds {
    Seeds { drawn: seeds, simulated: seeds }
}

fn audits() -> Vec<Audit> {
    let bank = Bank::in_folder(Path::new("problem_bank")).unwrap();
    let renderer = Renderer::new(None).unwrap();
    bank.select(&[]).unwrap().iter().map(|source| audit(source, first(SEEDS), &renderer)).collect()
}

/// Published problems, which were collected for their answers and not for what can be simulated.
#[test]
fn what_books_ask_is_not_contradicted() {
    let bank = Bank::in_folder(Path::new("problem_bank")).unwrap();
    let renderer = Renderer::new(None).unwrap();
    let (mut contradicted, mut witnessed, mut forms) = (Vec::new(), 0, 0);
    for path in files_under(Path::new("tests/reference")).unwrap() {
        let Ok(source) = bank.open(&path.to_string_lossy()) else { continue };
        for form in audit(&source, first(1), &renderer).forms {
            forms += 1;
            witnessed += usize::from(form.simulation.is_whole());
            if matches!(form.outcome(Promise::Simulation), Some(Outcome::Broken(_))) {
                contradicted.push(format!("{}: {:?}", path.display(), form.outcome(Promise::Simulation)));
            }
        }
    }
    assert_eq!(contradicted, Vec::<String>::new());
    assert!(4 * witnessed >= 3 * forms && forms > 100, "{witnessed} of {forms}");
}

#[test]
fn every_answer_of_the_bank_is_witnessed_and_a_wrong_one_found_out() {
    let audits = audits();
    let forms: Vec<(&Audit, &FormAudit)> =
        audits.iter().flat_map(|audit| audit.forms.iter().map(move |form| (audit, form))).collect();
    let named =
        |(audit, form): &(&Audit, &FormAudit)| format!("{:?} {:?}: {:?}", audit.problem, form.form, form.simulation);
    let broken = forms.iter().filter(|(_, form)| matches!(form.outcome(Promise::Simulation), Some(Outcome::Broken(_))));
    assert_eq!(broken.map(named).collect::<Vec<_>>(), Vec::<String>::new());
    // `unseen` are answers that were put wrong by 0.1 % without the simulation finding it out.
    let unseen: Vec<String> = forms.iter().filter(|(_, form)| !form.simulation.is_whole()).map(named).collect();
    assert!(forms.len() > 100 && unseen.is_empty(), "{unseen:#?}");
    // Bounds are small beside what they bound, or agreement would mean nothing.
    let loose: Vec<String> = forms.iter().filter(|(_, form)| form.simulation.bound > 1e-4).map(named).collect();
    assert_eq!(loose, Vec::<String>::new());
}
