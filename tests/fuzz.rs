//! Bytes of any kind, as problem files, answers, formulas, tables and rosters: nothing panics, nothing hangs, and what is refused is
//! refused with a reason. Each runs 10,000 times; `.ci/soak` runs the same under a fuzzer for as long as one likes.

#![allow(clippy::expect_used, reason = "a test says bluntly what it expects")]

use proptest::prelude::*;

#[path = "fuzz/targets.rs"]
mod targets;

fn few_bytes() -> impl Strategy<Value = Vec<u8>> {
    proptest::collection::vec(any::<u8>(), 0..24)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn problem_files(bytes in few_bytes()) {
        targets::problem_file(&bytes);
    }

    #[test]
    fn answers(bytes in few_bytes()) {
        targets::answer(&bytes);
    }

    #[test]
    fn formulas(bytes in few_bytes()) {
        targets::formula(&bytes);
    }

    #[test]
    fn tables(bytes in few_bytes()) {
        targets::table(&bytes);
    }

    #[test]
    fn rosters(bytes in few_bytes()) {
        targets::roster(&bytes);
    }
}
