#![no_main]

#[path = "../soak.rs"]
mod soak;

libfuzzer_sys::fuzz_target!(init: soak::prepare("table"), |bytes: &[u8]| soak::run("table", bytes));
