//! What a fuzzer found once, so that it is tried at every change.

use super::targets::Target;

/// The target, what it was tried with, and the text.
const FOUND: [(&str, u8, &str); 0] = [];

#[test]
fn what_a_fuzzer_found_holds() {
    for (target, chosen, text) in FOUND {
        (Target::named(target).run)(chosen, text);
    }
}
