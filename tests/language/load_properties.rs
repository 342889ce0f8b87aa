//! Whatever the file, loading ends: with a problem, or with faults that lie within the file.

use momentous::fault::Source;
use momentous::problem::{Text, load};
use proptest::prelude::*;

const GOOD: &str = include_str!("../fixtures/problems/two_carts.yaml");

fn ends_well(text: &str) {
    if let Err(faults) = load(Source::new("a.yaml", text)) {
        assert!(!faults.list.is_empty());
        for fault in &faults.list {
            let span = fault.span.expect("every fault has a place");
            assert!(span.start <= span.end && span.end <= text.len(), "{fault:?}");
        }
        assert!(!faults.to_string().is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text(text in "\\PC{0,80}") {
        ends_well(&text);
        let _ = Text::read(&text);
    }

    #[test]
    fn a_good_file_with_a_part_cut_out_or_put_in(at in 0..GOOD.len(), length in 0..40_usize, put in "[-{}\\[\\]:,|>\"'&*#é0-9 \n\t(_.]{0,6}") {
        let end = (at + length).min(GOOD.len());
        ends_well(&format!("{}{put}{}", &GOOD[..at], &GOOD[end..]));
    }

    #[test]
    fn any_given(given in "[-+(0-9a-z_.,e *^/)µ°%]{0,16}") {
        ends_well(&GOOD.replace("{ min: 0.3, max: 0.9, step: 0.05 }", &format!("{given:?}")));
        let range = format!("{{ min: {given:?}, max: 0.9, step: 0.05, unit: {given:?} }}");
        ends_well(&GOOD.replace("{ min: 0.3, max: 0.9, step: 0.05 }", &range));
    }
}
