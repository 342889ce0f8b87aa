#![no_main]

#[path = "../soak.rs"]
mod soak;

libfuzzer_sys::fuzz_target!(init: soak::prepare("problem_file"), |bytes: &[u8]| soak::run("problem_file", bytes));
