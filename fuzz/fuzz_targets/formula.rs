#![no_main]

#[path = "../soak.rs"]
mod soak;

libfuzzer_sys::fuzz_target!(init: soak::prepare("formula"), |bytes: &[u8]| soak::run("formula", bytes));
