//! Wrong values behind which there is no mistake.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::grade::{DecimalMark, Verdict};
use momentous::problem::{PartKind, compile, load};

/// Values within a decade of the right one, to three figures, spread evenly over its digits; two in a hundred are named at most.
#[test]
fn values_without_a_reason_are_hardly_ever_named() {
    let (mut wrong, mut named) = (0_u32, 0_u32);
    let mut codes: BTreeMap<&str, u32> = BTreeMap::new();
    for source in Bank::built_in().sources().step_by(4) {
        let problem = Arc::new(compile(load(source.clone()).unwrap(), None).unwrap());
        let exercise = Exercise::draw(&problem, 0, 311).unwrap();
        let worked = exercise.worked();
        for part in &worked.form.parts {
            let PartKind::Number(number) = &part.kind else { continue };
            let right = worked.answer(number).value;
            for place in 0..40_i32 {
                // Steps of the golden section are spread evenly.
                let share = (f64::from(place) * 0.618_033_988_749_895).fract();
                let answer = format!("{:.2e}", right * 10_f64.powf(2.0 * share - 1.0));
                let report = exercise.grade(&BTreeMap::from([(part.id.clone(), answer)]), DecimalMark::Point);
                let own = report.parts.iter().find(|own| own.id == part.id).expect("the part");
                if matches!(own.verdict, Verdict::Wrong | Verdict::UnitMissing) {
                    wrong += 1;
                    named += u32::from(own.diagnosis.is_some());
                    let code = own.diagnosis.as_ref().and_then(|diagnosis| diagnosis.codes.first());
                    *codes.entry(code.copied().unwrap_or_default()).or_default() += 1;
                }
            }
        }
    }
    assert!(wrong > 1000 && 50 * named <= wrong, "{named} of {wrong}: {codes:?}");
}
